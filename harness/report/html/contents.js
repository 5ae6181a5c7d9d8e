// What each kind of pane shows: its picture, the text in its cells, its legend.
import {
  CLASSES,
  MAY,
  ULP_STEPS,
  VERDICTS,
  css,
  inkOn,
  kInfinite,
  kNotFinite,
  kUnknown,
} from "./classes.js";
import { h, swatch } from "./dom.js";
import { counted, floatText, kNoOwner, shortText } from "./numbers.js";
import {
  classAt,
  classColours,
  differenceColours,
  oracleColours,
  paint,
  partyColours,
  ulpColours,
  ulpsAt,
} from "./pictures.js";

function cellText(data, party, key, index) {
  const channel = key === "picture" ? "owner" : key;
  const value = data.valueOf(party, channel, index);
  if (data.isInteger(channel)) return value === kNoOwner ? "" : String(value);
  if (data.words[party].hits[index] === 0 && channel !== "depth") return "";
  return Number.isFinite(value) ? shortText(value) : floatText(value);
}

function differenceText(data, key, index) {
  if (key === "picture" || !data.has_reference) return "";
  const difference = data.valueOf("candidate", key, index) - data.valueOf("reference", key, index);
  return difference === 0 ? "" : shortText(difference);
}

function ulpsText(data, key, index) {
  const ulps = ulpsAt(data, key, index);
  if (ulps === null) return "";
  return ulps === 0 || !Number.isFinite(ulps) ? "" : shortText(ulps);
}

function item(colour, letter, text) {
  return h("li", {}, swatch(css(colour), inkOn(colour), letter), text);
}

function countedItems(names, count, only) {
  return names.flatMap((one, i) => (only(i) && count(i) > 0 ? [item(one.colour, one.letter, `${one.name} ${count(i).toLocaleString("en")}`)] : []));
}

function verdictLegend(data, key) {
  const counts = new Array(VERDICTS.length).fill(0);
  for (let i = 0; i < data.size; ++i) ++counts[data.verdictOf(key, i)];
  return countedItems(VERDICTS, (i) => counts[i], () => true);
}

function classLegend(data) {
  const counts = new Array(CLASSES.length).fill(0);
  let open = 0;
  for (let i = 0; i < data.size; ++i) {
    if (classAt(data, i) === MAY) ++open;
    else ++counts[data.classes[i]];
  }
  const items = countedItems(CLASSES, (i) => counts[i], () => true);
  return open > 0 ? [...items, item(MAY.colour, MAY.letter, `${MAY.name} ${open.toLocaleString("en")}`)] : items;
}

function ulpLegend(data) {
  const steps = ULP_STEPS.map((step) => item(step.colour, "", step.name));
  return data.has_reference ? steps : [...steps, item(kUnknown, "", "not told")];
}

function partyLegend(data, key) {
  if (data.isInteger(key)) return [];
  return [item(kNotFinite, "", "NaN"), item(kInfinite, "", "infinity")];
}

const KINDS = {
  candidate: (data, key) => ({
    colourOf: partyColours(data, "candidate", key),
    textOf: (index) => cellText(data, "candidate", key, index),
    legend: () => partyLegend(data, key),
  }),
  reference: (data, key) => ({
    colourOf: partyColours(data, "reference", key),
    textOf: (index) => cellText(data, "reference", key, index),
    legend: () => partyLegend(data, key),
  }),
  oracle: (data, key) => ({
    colourOf: oracleColours(data, key),
    textOf: () => "",
    legend: () => [],
  }),
  difference: (data, key) => ({
    colourOf: differenceColours(data, key),
    textOf: (index) => differenceText(data, key, index),
    legend: () => verdictLegend(data, key),
  }),
  ulps: (data, key) => ({
    colourOf: ulpColours(data, key),
    textOf: (index) => ulpsText(data, key, index),
    legend: () => ulpLegend(data),
  }),
  class: (data) => ({
    colourOf: classColours(data),
    textOf: (index) => classAt(data, index).letter,
    letters: true,
    legend: () => classLegend(data),
  }),
};

const made = new WeakMap();

// Made once for each case, kind and plane.
export function contentOf(data, kind, key) {
  if (!made.has(data)) made.set(data, new Map());
  const contents = made.get(data);
  const name = `${kind} ${key}`;
  if (!contents.has(name)) {
    const content = KINDS[kind](data, key);
    contents.set(name, { ...content, picture: paint(data, content.colourOf) });
  }
  return contents.get(name);
}

// What stands above a pane.
export function titleOf(data, kind, key, run) {
  const plane = key === "picture" ? "" : ` · ${key}`;
  switch (kind) {
    case "candidate":
      return `Candidate (${run.candidate.name})${plane}`;
    case "reference":
      return `Reference (${run.reference.driver})${plane}`;
    case "oracle":
      return key === "owner" || key === "picture" ? "Oracle · owner" : "Oracle · coverage";
    case "difference":
      return `Verdict${key === "picture" ? " over all planes" : plane}`;
    case "ulps":
      return `ULPs from the ${data.has_reference ? "reference" : "exact value"}${plane}`;
    default:
      return `Class of each sample: ${counted(data.differing.length, "difference")}`;
  }
}
