// What the page holds: the run with all its cases, and the cases that come with planes.
import { Reader, inflate, inflateJson } from "./codec.js";
import { kClassImprecise } from "./classes.js";
import { floatOfBits, numberOf } from "./numbers.js";

const kIntegerChannels = ["hits", "owner", "front_facing"];
const kReferenceAlone = 0x10;

function parse(id) {
  const element = document.getElementById(id);
  return element ? JSON.parse(element.textContent) : null;
}

// {candidate, reference, cases: [{index, name, status, ...}], ...}: the columns of the cases by name.
export function loadRun() {
  const run = parse("run");
  run.cases = run.cases.map((row, index) => {
    const one = { index, hasPlanes: document.getElementById(`case-${index}`) !== null };
    run.columns.forEach((column, i) => (one[column] = row[i]));
    return one;
  });
  return run;
}

// One case, unpacked.
export class CaseData {
  constructor(index, details, bytes) {
    Object.assign(this, details);
    this.index = index;
    this.size = this.width * this.height * this.samples;
    this.read(new Reader(bytes));
    this.planeKeys = ["picture", "coverage", ...this.channels];
    this.explained = new Map(this.explanations.map((one) => [this.indexOf(one.x, one.y, one.sample), one]));
    this.worst = this.worst.map((one) => ({ ...one, index: this.indexOf(one.x, one.y, one.sample) }));
    this.differing = this.findDiffering();
  }

  read(reader) {
    this.words = { candidate: {}, reference: this.has_reference ? {} : null };
    for (const channel of this.channels) {
      const reference = this.has_reference ? reader.words(this.size) : undefined;
      if (reference) this.words.reference[channel] = reference;
      this.words.candidate[channel] = reader.words(this.size, reference);
    }
    this.verdicts = {};
    for (const plane of this.planes) this.verdicts[plane.name] = reader.take(this.size);
    const marks = reader.take(this.size);
    this.classes = marks.map((mark) => mark & 0xf);
    this.referenceAlone = marks.map((mark) => mark & kReferenceAlone);
    this.oracle = reader.take(this.size);
    this.oracleOwners = reader.words(this.size);
  }

  // Samples that are wrong or imprecise: the worst ones that are listed, then the others by class.
  findDiffering() {
    const listed = this.worst.map((one) => one.index);
    const known = new Set(listed);
    const others = [];
    for (let i = 0; i < this.size; ++i) {
      if (this.classes[i] >= kClassImprecise && !known.has(i)) others.push(i);
    }
    return listed.concat(others.sort((a, b) => this.classes[b] - this.classes[a] || a - b));
  }

  indexOf(x, y, sample) {
    return (y * this.width + x) * this.samples + sample;
  }

  placeOf(index) {
    const pixel = Math.floor(index / this.samples);
    return { x: pixel % this.width, y: Math.floor(pixel / this.width), sample: index % this.samples };
  }

  isInteger(key) {
    return key === "coverage" || kIntegerChannels.includes(key);
  }

  // The party's bits of a plane; coverage is 0 or 1. Null where there is no such party.
  bitsOf(party, key, index) {
    const channels = this.words[party];
    if (!channels) return null;
    return key === "coverage" ? Math.min(channels.hits[index], 1) : channels[key][index];
  }

  valueOf(party, key, index) {
    const bits = this.bitsOf(party, key, index);
    if (bits === null) return null;
    return this.isInteger(key) ? bits : floatOfBits(bits);
  }

  // The plane of verdicts that a plane key belongs to: uv.x to uv.
  verdictPlane(key) {
    return key in this.verdicts ? key : key.replace(/\.[xyzw]$/, "");
  }

  // The gravest over all planes for the picture as a whole.
  verdictOf(key, index) {
    if (key !== "picture") return this.verdicts[this.verdictPlane(key)][index];
    let gravest = 0;
    for (const plane of this.planes) gravest = Math.max(gravest, this.verdicts[plane.name][index]);
    return gravest;
  }

  // The value that the oracle expects there, where it is told: {expected, tolerance, ...} for one of the parties.
  expectationOf(role, key, index) {
    const party = this.explained.get(index)?.parties.find((one) => one.role === role);
    const value = party?.values[key];
    if (!value) return null;
    const number = (name) => (value[name] === undefined ? undefined : numberOf(value[name]));
    return {
      expected: number("expected"),
      tolerance: number("tolerance"),
      snapping: number("snapping"),
      rounding: number("rounding"),
      severity: number("severity"),
      ulps: number("ulps"),
      level: value.level,
      leftOpen: value.left_open,
      place: value.place,
    };
  }

  // The plane key that a worst sample is about.
  keyOf(worst) {
    const plane = this.planes.find((one) => one.name === worst.plane);
    return plane && plane.components > 1 ? `${plane.name}.${"xyzw"[worst.component]}` : worst.plane;
  }
}

const loaded = new Map();

// Null where the page has statistics only.
export async function loadCase(index) {
  if (!loaded.has(index)) {
    const packed = parse(`case-${index}`);
    if (!packed) return null;
    const [details, bytes] = await Promise.all([inflateJson(packed.details), inflate(packed.planes)]);
    loaded.set(index, new CaseData(index, details, bytes));
  }
  return loaded.get(index);
}
