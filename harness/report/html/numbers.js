// Numbers as text, and float32 as bits.

const scratch = new DataView(new ArrayBuffer(4));

export const kNoOwner = 0xffffffff;
export const kSeveralOwners = 0xfffffffe;

export function floatOfBits(bits) {
  scratch.setUint32(0, bits);
  return scratch.getFloat32(0);
}

export function hex(bits) {
  return "0x" + (bits >>> 0).toString(16).padStart(8, "0");
}

// The fewest digits that give the same float32.
export function floatText(value) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (Object.is(value, -0)) return "-0";
  for (let digits = 1; digits < 9; ++digits) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === value) return tidy(text);
  }
  return tidy(value.toPrecision(9));
}

// 1.500e+0 is 1.5.
function tidy(text) {
  return String(Number(text));
}

// A number of the report's JSON, where NaN and infinity are text.
export function numberOf(json) {
  if (typeof json === "number") return json;
  return { nan: NaN, inf: Infinity, "-inf": -Infinity }[json] ?? NaN;
}

export function doubleText(value, digits = 12) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  return tidy(value.toPrecision(digits));
}

// Three digits.
export function shortText(value) {
  if (Math.abs(value) >= 1e6 && Number.isFinite(value)) return value.toExponential(2).replace("e+", "e");
  return doubleText(value, 3);
}

// How many float32 numbers lie between two, by their bits; infinite where just one is NaN or infinite.
export function ulpsBetween(a, b) {
  if (a === b) return 0;
  const finite = (bits) => (bits & 0x7f800000) !== 0x7f800000;
  if (!finite(a) || !finite(b)) return Infinity;
  const ordered = (bits) => (bits & 0x80000000 ? -(bits & 0x7fffffff) : bits);
  return Math.abs(ordered(a) - ordered(b));
}

export function counted(count, thing) {
  return `${count.toLocaleString("en")} ${thing}${count === 1 ? "" : "s"}`;
}

export function ownerText(owner) {
  if (owner === null || owner === kNoOwner) return "none";
  return owner === kSeveralOwners ? "several" : String(owner);
}
