// The colour of each sample in each kind of picture, and pictures with one cell for each sample.
import {
  CLASSES,
  MAY,
  ULP_STEPS,
  VERDICTS,
  kClassImprecise,
  kGround,
  kInfinite,
  kMust,
  kMustNot,
  kNotFinite,
  kUnknown,
  ulpStep,
} from "./classes.js";
import { kNoOwner, kSeveralOwners, ulpsBetween } from "./numbers.js";

// How the samples of a pixel are laid out as cells, in reading order.
export function cellsOf(samples) {
  const columns = { 1: 1, 2: 2, 4: 2, 8: 4, 16: 4 }[samples];
  return { columns, rows: samples / columns };
}

// Dark blue over green to yellow: brightness grows with the value, whatever the colour vision.
const RAMP = [
  [52, 20, 96],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];

function ramp(unit) {
  const at = Math.min(Math.max(unit, 0), 1) * (RAMP.length - 1);
  const low = Math.min(Math.floor(at), RAMP.length - 2);
  return RAMP[low].map((from, i) => Math.round(from + (at - low) * (RAMP[low + 1][i] - from)));
}

// Neighbouring numbers get hues far apart: each is turned by the golden angle.
function ownerColour(owner) {
  if (owner === kNoOwner) return kGround;
  if (owner === kSeveralOwners) return MAY.colour;
  const hue = ((owner * 0.618033988749895) % 1) * 6;
  const channel = (shift) => {
    const value = Math.min(Math.max(Math.abs(((hue + shift) % 6) - 3) - 1, 0), 1);
    return Math.round(80 + 150 * value);
  };
  return [channel(0), channel(4), channel(2)];
}

function floatColour(value, range) {
  if (Number.isNaN(value)) return kNotFinite;
  if (!Number.isFinite(value)) return kInfinite;
  return ramp(range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5);
}

// Of the finite values that both parties have where something landed.
function rangeOf(data, key) {
  const range = { low: Infinity, high: -Infinity };
  for (const party of ["candidate", "reference"]) {
    if (!data.words[party]) continue;
    for (let i = 0; i < data.size; ++i) {
      const value = data.valueOf(party, key, i);
      if (!Number.isFinite(value) || data.words[party].hits[i] === 0) continue;
      range.low = Math.min(range.low, value);
      range.high = Math.max(range.high, value);
    }
  }
  return range;
}

// The first varying's components as red, green and blue where there are two or more; else its values, or the owners.
function pictureKeys(data) {
  const floats = data.channels.filter((key) => !data.isInteger(key) && key !== "depth");
  if (floats.length === 0) return ["owner"];
  const name = data.verdictPlane(floats[0]);
  return floats.filter((key) => data.verdictPlane(key) === name).slice(0, 3);
}

function rgbColour(data, party, keys, ranges, index) {
  const values = keys.map((key) => data.valueOf(party, key, index));
  if (values.some(Number.isNaN)) return kNotFinite;
  if (!values.every(Number.isFinite)) return kInfinite;
  const channel = (i) => {
    if (i >= keys.length) return 48;
    const { low, high } = ranges[i];
    return Math.round(48 + 207 * Math.min(Math.max(high > low ? (values[i] - low) / (high - low) : 0.5, 0), 1));
  };
  return [channel(0), channel(1), channel(2)];
}

// index => colour of a party's plane.
export function partyColours(data, party, key) {
  const covered = (index) => data.words[party].hits[index] !== 0;
  if (key === "picture") {
    const keys = pictureKeys(data);
    if (keys.length === 1) return partyColours(data, party, keys[0]);
    const ranges = keys.map((one) => rangeOf(data, one));
    return (index) => (covered(index) ? rgbColour(data, party, keys, ranges, index) : kGround);
  }
  const value = (index) => data.bitsOf(party, key, index);
  if (key === "coverage") return (index) => (covered(index) ? [235, 235, 235] : kGround);
  if (key === "owner") return (index) => ownerColour(value(index));
  if (key === "front_facing") {
    return (index) => (!covered(index) ? kGround : value(index) ? [86, 180, 233] : [230, 159, 0]);
  }
  const range = rangeOf(data, key);
  if (key === "hits") return (index) => (covered(index) ? ramp(value(index) / Math.max(range.high, 1)) : kGround);
  const shown = (index) => covered(index) || key === "depth";
  return (index) => (shown(index) ? floatColour(data.valueOf(party, key, index), range) : kGround);
}

// The oracle's coverage, or the owner that it expects.
export function oracleColours(data, key) {
  if (key === "owner" || key === "picture") return (index) => ownerColour(data.oracleOwners[index]);
  return (index) => {
    const answer = data.oracle[index];
    return answer === kMust ? [235, 235, 235] : answer === kMustNot ? kGround : MAY.colour;
  };
}

export function differenceColours(data, key) {
  return (index) => VERDICTS[data.verdictOf(key, index)].colour;
}

// How many ULPs the candidate is from the reference, or without one from the exact value; null where that is not told.
export function ulpsAt(data, key, index) {
  if (key === "picture") {
    const all = data.channels.map((channel) => ulpsAt(data, channel, index));
    return all.includes(null) ? null : Math.max(...all);
  }
  const candidate = data.bitsOf("candidate", key, index);
  if (data.has_reference) {
    const reference = data.bitsOf("reference", key, index);
    return data.isInteger(key) ? (candidate === reference ? 0 : 2 ** 33) : ulpsBetween(candidate, reference);
  }
  if (data.verdictOf(key, index) === 0) return 0;
  return data.expectationOf("candidate", key, index)?.ulps ?? null;
}

export function ulpColours(data, key) {
  return (index) => {
    const ulps = ulpsAt(data, key, index);
    return ulps === null ? kUnknown : ULP_STEPS[ulpStep(ulps)].colour;
  };
}

export function classAt(data, index) {
  const open = data.oracle[index] !== kMust && data.oracle[index] !== kMustNot;
  return open && data.classes[index] < kClassImprecise ? MAY : CLASSES[data.classes[index]];
}

export function classColours(data) {
  return (index) => classAt(data, index).colour;
}

// A canvas with one pixel for each sample.
export function paint(data, colourOf) {
  const { columns, rows } = cellsOf(data.samples);
  const canvas = document.createElement("canvas");
  canvas.width = data.width * columns;
  canvas.height = data.height * rows;
  const context = canvas.getContext("2d");
  const image = context.createImageData(canvas.width, canvas.height);
  for (let index = 0; index < data.size; ++index) {
    const { x, y, sample } = data.placeOf(index);
    const column = x * columns + (sample % columns);
    const row = y * rows + Math.floor(sample / columns);
    image.data.set([...colourOf(index), 255], (row * canvas.width + column) * 4);
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
