// Words, letters and colours of verdicts and classes: one table each for pictures, legends and tables. The colours are
// Okabe and Ito's, which every kind of colour vision tells apart, on a dark ground.

export const kGround = [24, 26, 31];
export const kNotFinite = [255, 0, 255];
export const kInfinite = [0, 230, 230];

// In the order of the judge's verdicts; in short: who is at fault.
export const VERDICTS = [
  { name: "identical", short: "identical", colour: kGround },
  { name: "permitted", short: "permitted", colour: [0, 90, 150] },
  { name: "imprecise", short: "imprecise", colour: [240, 228, 66] },
  { name: "reference fault", short: "reference", colour: [204, 121, 167] },
  { name: "candidate fault", short: "candidate", colour: [230, 97, 0] },
  { name: "both at fault", short: "both", colour: [255, 255, 255] },
];
export const kImprecise = 2;

// In the order of the report's sample classes.
export const CLASSES = [
  { letter: "", name: "right", colour: kGround },
  { letter: "~", name: "permitted", colour: [0, 70, 115] },
  { letter: "I", name: "imprecise", colour: [240, 228, 66] },
  { letter: "V", name: "varying", colour: [0, 158, 115] },
  { letter: "D", name: "depth", colour: [86, 180, 233] },
  { letter: "F", name: "facing", colour: [180, 180, 180] },
  { letter: "O", name: "wrong owner", colour: [204, 121, 167] },
  { letter: "H", name: "hits", colour: [150, 110, 220] },
  { letter: "E", name: "extra", colour: [230, 97, 0] },
  { letter: "M", name: "missing", colour: [255, 255, 255] },
];
export const kClassImprecise = 2;
// Not a class of difference: the oracle leaves the coverage open.
export const MAY = { letter: "?", name: "may be covered or not", colour: [58, 66, 84] };

// In the order of the oracle's answers.
export const ORACLE = ["must not be covered", "may be covered", "must be covered", "may be covered (undefined)"];
export const kMustNot = 0;
export const kMust = 2;

// By the number of ULPs: up to and including `most`.
export const ULP_STEPS = [
  { most: 0, name: "equal bits", colour: kGround },
  { most: 1, name: "1 ULP", colour: [40, 30, 90] },
  { most: 3, name: "to 3", colour: [86, 40, 120] },
  { most: 15, name: "to 15", colour: [140, 45, 115] },
  { most: 255, name: "to 255", colour: [195, 60, 80] },
  { most: 65535, name: "to 65,535", colour: [235, 110, 40] },
  { most: 2 ** 24, name: "to 2^24", colour: [250, 180, 30] },
  { most: 2 ** 33, name: "more", colour: [252, 250, 160] },
  { most: Infinity, name: "NaN or infinity", colour: kNotFinite },
];
export const kUnknown = [70, 70, 70];

export function ulpStep(ulps) {
  return ULP_STEPS.findIndex((step) => ulps <= step.most);
}

export function css([r, g, b]) {
  return `rgb(${r} ${g} ${b})`;
}

// Black or white, whichever stands out.
export function inkOn([r, g, b]) {
  return 0.3 * r + 0.6 * g + 0.1 * b > 110 ? "#000" : "#fff";
}
