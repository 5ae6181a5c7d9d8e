// The inspector and the sentences: the numbers of results.json and of the planes, and the right class of error.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { closePages, launch, linkOf, makeReport, openReport, press, screenshotPath } from "./support.mjs";

let browser;

before(async () => {
  browser = await launch();
});
afterEach(() => closePages(browser));
after(() => browser.close());

const hex = (bits) => `0x${bits.toString(16).padStart(8, "0")}`;

function floatOf(bits) {
  const view = new DataView(new ArrayBuffer(4));
  view.setUint32(0, bits);
  return view.getFloat32(0);
}

const field = (page, name) => page.textContent(`#inspector dd[data-field="${name}"]`);

test("values, bits, exact value and tolerance are those of the JSON", async () => {
  const report = makeReport("inspector", "depth_constant", ["depth/linear_although_perspective"]);
  const page = await openReport(browser, report);
  const failed = report.results.cases.find((one) => one.status === "failed");
  const { worst } = failed.planes.depth;
  const link = await linkOf(page);
  assert.equal(link.plane, "depth");
  assert.equal(link.px, `${worst.x},${worst.y}`);
  const { truth } = report;
  const index = worst.y * truth.width + worst.x;
  for (const party of ["candidate", "reference"]) {
    const bits = truth[party].depth[index];
    const text = await field(page, party);
    assert.ok(text.endsWith(hex(bits)), text);
    assert.equal(Math.fround(Number(text.slice(0, -10))), floatOf(bits));
  }
  const near = (text, value) => assert.ok(Math.abs(Number(text.split(" ")[0]) - value) <= 1e-3 * Math.abs(value), `${text}, ${value}`);
  near(await field(page, "exact"), worst.expected);
  near(await field(page, "tolerance"), worst.tolerance);
  assert.match(await field(page, "tolerance"), /snapping .* \+ rounding/);
  near(await field(page, "candidate's error"), worst.candidate - worst.expected);
  const inspector = await page.textContent("#inspector");
  assert.match(inspector, /Barycentric coordinates/);
  assert.match(inspector, /edge v0-v1/);
  assert.match(inspector, /Fragments that landed: candidate 1, reference 1/);
  await page.locator("#inspector").screenshot({ path: screenshotPath("inspector") });
});

test("the planes of the inspector are those of the pictures, wherever one looks", async () => {
  const report = makeReport("planes", "shifted", ["interpolation/vertex_order"]);
  const page = await openReport(browser, report);
  const { truth } = report;
  for (let i = 0; i < 12; ++i) {
    await press(page, i % 3 ? "ArrowRight" : "ArrowUp");
    const [x, y] = (await linkOf(page)).px.split(",").map(Number);
    const index = y * truth.width + x;
    const cells = await page.$$eval(".planes tbody tr", (all) => Object.fromEntries(all.map((one) => {
      const [name, candidate, reference] = [...one.cells].map((cell) => cell.textContent);
      return [name, { candidate, reference }];
    })));
    for (const party of ["candidate", "reference"]) {
      assert.equal(cells.hits[party], String(truth[party].hits[index]));
      const owner = truth[party].owner[index];
      assert.equal(cells.owner[party], owner === 0xffffffff ? "none" : String(owner));
      assert.equal(Math.fround(Number(cells.depth[party])), floatOf(truth[party].depth[index]));
    }
  }
});

test("the worst samples are in a table that leads to them", async () => {
  const report = makeReport("worst", "varyings_swapped", ["interpolation/eight_varyings"]);
  const page = await openReport(browser, report);
  const rows = await page.$$eval(".worst tbody tr", (all) => all.map((one) => one.cells[1].textContent));
  assert.ok(rows.length > 10 && rows.length <= 64);
  await page.click(".worst tbody tr:nth-child(5) button");
  assert.equal((await linkOf(page)).px, rows[4].replace(" ", ""));
  assert.match(await page.textContent("#rank"), /^5 of /);
});

// The fault, a case that shows it, and what the first view has to say.
const SENTENCES = [
  ["culling_inverted", "culling/closed_mesh", /shows the wrong primitive/, /culling the wrong way round/],
  ["depth_compare_flipped", "depth/interpenetrating", /wrong primitive/, /depth test/],
  ["affine_varyings", "interpolation/w_ratio", /wrong value to the varying/, /without perspective correction/],
  ["scissor_ignored", "clipping/scissor", /must not be covered/, /scissor/],
  ["no_depth_clip", "clipping/near_plane_perspective", /must not be covered/, /near plane/],
  ["samples_at_corners", "coverage/rotated_quad", /must (not )?be covered/, /edge|shifted/],
  ["top_right_rule", "coverage/vertex_on_pixel_centre", /must (not )?be covered/, /exactly on an edge, where the top-left rule decides/],
  ["shifted", "coverage/rotated_quad", /must (not )?be covered/, /shifted by a pixel to the right/],
  ["varyings_swapped", "interpolation/eight_varyings", /wrong value to the varying/, /what .* should hold/],
  ["nan", "interpolation/vertex_order", /wrong value to the varying/, /not a finite number/],
  ["depth_constant", "depth/linear_although_perspective", /wrong depth/, /0.3125/],
  ["facing_flipped", "culling/both_faces", /front for back/, /front|back/],
  ["blank", "coverage/rotated_quad", /must be covered/, /draws nothing/],
  ["lands_twice", "coverage/rotated_quad", /wrong number of fragments/, /more than are right/],
];

for (const [fault, name, wrong, why] of SENTENCES) {
  test(`the first view names the class of ${fault}`, async () => {
    const report = makeReport(`fault-${fault}`, fault, [name]);
    assert.ok(report.results.summary.failed > 0);
    const page = await openReport(browser, report);
    const sentence = await page.textContent("#sentence");
    const reason = await page.textContent("#reason");
    console.log(`${fault}: ${sentence}\n  ${reason}`);
    assert.match(sentence, wrong);
    assert.match(`${sentence} ${reason}`, why);
    await page.screenshot({ path: screenshotPath(`fault-${fault}`) });
    assert.deepEqual(page.errors, []);
  });
}
