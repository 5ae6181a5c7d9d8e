// The pictures: every view mode, read back from the canvas and held against the planes that the program wrote apart.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { bare, closePages, coloursOf, launch, linkOf, makeReport, openReport, press, screenshotPath, settled } from "./support.mjs";

const GROUND = [24, 26, 31];
const COVERED = [235, 235, 235];
const NAN = [255, 0, 255];
const VERDICTS = [GROUND, [0, 90, 150], [240, 228, 66], [204, 121, 167], [230, 97, 0], [255, 255, 255]];
const EXTRA = [230, 97, 0];
const MISSING = [255, 255, 255];
let browser;
let shifted;
let samples;
let nan;

before(async () => {
  browser = await launch();
  shifted = makeReport("views", "shifted", ["interpolation/vertex_order"]);
  samples = makeReport("samples", "shifted", ["multisample/*"]);
  nan = makeReport("nan", "nan", ["interpolation/vertex_order"]);
});
afterEach(() => closePages(browser));
after(() => browser.close());

async function openBare(report, plane, view = "side") {
  const hash = `#case=${encodeURIComponent(report.truth.name)}&plane=${plane}&view=${view}`;
  const page = await openReport(browser, report, { hash, reducedMotion: "reduce" });
  await bare(page);
  await press(page, "0");
  return page;
}

// Compares all samples in sight but those of the selected pixel, which has a frame.
async function expectColours(page, truth, slot, expected) {
  const selected = (await linkOf(page)).px.split(",").map(Number);
  const frame = (selected[1] * truth.width + selected[0]) * truth.samples;
  const colours = await coloursOf(page, slot, truth);
  let compared = 0;
  for (const [index, colour] of colours) {
    if (index >= frame && index < frame + truth.samples) continue;
    assert.deepEqual(colour, expected(index), `${slot}, sample ${index}`);
    ++compared;
  }
  assert.ok(compared > 100, `${compared} samples compared`);
}

const coverageOf = (planes) => (index) => (planes.hits[index] ? COVERED : GROUND);
const verdictOf = (truth, plane) => (index) => VERDICTS[truth.verdicts[plane][index]];

for (const which of ["one sample", "several samples"]) {
  test(`side by side: candidate, reference and verdict, ${which}`, async () => {
    const report = which === "one sample" ? shifted : samples;
    const { truth } = report;
    const page = await openBare(report, "coverage");
    await expectColours(page, truth, "candidate", coverageOf(truth.candidate));
    if (truth.reference) await expectColours(page, truth, "other", coverageOf(truth.reference));
    await expectColours(page, truth, "difference", verdictOf(truth, "coverage"));
    assert.deepEqual(page.errors, []);
  });
}

test("swipe: the candidate to the left of the divider, the reference to the right", async () => {
  const { truth } = shifted;
  const page = await openBare(shifted, "coverage", "swipe");
  const divider = await page.$eval("canvas", (one) => Number(one.dataset.left) + one.width / 2 / Number(one.dataset.scale));
  const x = (index) => (index % truth.width) + 0.5;
  await expectColours(page, truth, "swipe", (index) => coverageOf(x(index) < divider ? truth.candidate : truth.reference)(index));
  await page.screenshot({ path: screenshotPath("swipe") });
  await page.fill(".slider", "0");
  await settled(page);
  const right = await coloursOf(page, "swipe", truth);
  const different = [...right].find(([index]) => index % truth.width > 2 && !truth.candidate.hits[index] !== !truth.reference.hits[index]);
  assert.deepEqual(different[1], coverageOf(truth.reference)(different[0]));
});

test("blink: in turn, or while the key is held", async () => {
  const { truth } = shifted;
  const page = await openBare(shifted, "coverage", "blink");
  await expectColours(page, truth, "blink", coverageOf(truth.candidate));
  await page.keyboard.down("b");
  await settled(page);
  await expectColours(page, truth, "blink", coverageOf(truth.reference));
  await page.keyboard.up("b");
  await settled(page);
  await expectColours(page, truth, "blink", coverageOf(truth.candidate));
  // With reduced motion nothing moves by itself; without it does.
  await page.waitForTimeout(700);
  assert.equal(await page.getAttribute("canvas", "data-kind"), "candidate");
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.waitForSelector('canvas[data-kind="reference"]');
  await page.waitForSelector('canvas[data-kind="candidate"]');
});

test("difference: the verdict of the plane, or the gravest of all", async () => {
  const { truth } = shifted;
  const page = await openBare(shifted, "depth", "difference");
  await expectColours(page, truth, "difference", verdictOf(truth, "depth"));
  await page.selectOption("#plane", "picture");
  await settled(page);
  const gravest = (index) => Math.max(...Object.values(truth.verdicts).map((map) => map[index]));
  await expectColours(page, truth, "difference", (index) => VERDICTS[gravest(index)]);
});

test("classes: missing and extra by colour and letter", async () => {
  const { truth } = shifted;
  const page = await openBare(shifted, "picture", "class");
  // Beside the letters, which stand in the middle.
  const colours = await coloursOf(page, "class", truth, 0.15);
  const faulty = [...colours.keys()].filter((index) => truth.verdicts.coverage[index] === 4);
  assert.ok(faulty.length > 4);
  const selected = (await linkOf(page)).px.split(",").map(Number);
  for (const index of faulty) {
    if (index === selected[1] * truth.width + selected[0]) continue;
    assert.deepEqual(colours.get(index), truth.candidate.hits[index] ? EXTRA : MISSING, `sample ${index}`);
  }
  const letters = await coloursOf(page, "class", truth, 0.5);
  assert.ok(faulty.some((index) => letters.get(index).join() !== colours.get(index).join()), "there are letters");
  const legend = await page.$$eval("#legend li", (all) => all.map((one) => one.textContent));
  const count = (covered) => faulty.filter((index) => !truth.candidate.hits[index] !== covered).length;
  assert.ok(legend.includes(`Eextra ${count(true)}`), legend.join(" | "));
  assert.ok(legend.includes(`Mmissing ${count(false)}`), legend.join(" | "));
  await page.screenshot({ path: screenshotPath("classes") });
});

test("ULPs: equal bits are dark, NaN has a colour of its own", async () => {
  const { truth } = nan;
  const page = await openBare(nan, "depth", "ulps");
  const depth = (index) => truth.candidate.depth[index] === truth.reference.depth[index];
  const colours = await coloursOf(page, "ulps", truth);
  for (const [index, colour] of colours) if (depth(index)) assert.deepEqual(colour, GROUND, `sample ${index}`);
  const keys = await page.$$eval("#plane option", (all) => all.map((one) => one.value));
  await page.selectOption("#plane", keys.at(-1));
  await settled(page);
  await expectColours(page, truth, "ulps", (index) => (truth.candidate.hits[index] ? NAN : GROUND));
  await press(page, "1");
  await expectColours(page, truth, "candidate", (index) => (truth.candidate.hits[index] ? NAN : GROUND));
  assert.match(await page.textContent("#sentence"), /not a finite number/);
  await page.screenshot({ path: screenshotPath("nan") });
});

test("zooms to 128x with grid, outlines, sample locations and numbers", async () => {
  const hash = `#case=${encodeURIComponent(shifted.truth.name)}&plane=depth&zoom=128&view=side`;
  const page = await openReport(browser, shifted, { hash });
  assert.equal(await page.textContent("#zoom"), "128x");
  assert.equal((await linkOf(page)).zoom, "128");
  await page.screenshot({ path: screenshotPath("zoom-128") });
  const pixels = () => page.$eval("canvas", (one) => Array.from(one.getContext("2d").getImageData(0, 0, one.width, one.height).data).join());
  for (const key of ["g", "e", "v"]) {
    const before = await pixels();
    await press(page, key);
    assert.notEqual(await pixels(), before, `key ${key}`);
  }
});

test("rings mark a lone pixel", async () => {
  const report = makeReport("lone", "one_depth", ["interpolation/vertex_order"]);
  const page = await openReport(browser, report, { hash: "#view=difference" });
  await press(page, "0");
  const pixels = () => page.$eval("canvas", (one) => Array.from(one.getContext("2d").getImageData(0, 0, one.width, one.height).data).join());
  const ringed = await pixels();
  await page.screenshot({ path: screenshotPath("lone") });
  await press(page, "r");
  assert.notEqual(await pixels(), ringed);
});
