// The page as its reader meets it: where it opens, keys, links, lists, names that might break it.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { closePages, launch, linkOf, makeReport, openReport, press, ready, screenshotPath, settled } from "./support.mjs";

const CASES = ["interpolation/modes_side_by_side", "interpolation/vertex_order", "culling/strip_parity"];
const FAULTS = JSON.stringify({ faults: [{ name: "affine_varyings", what: "ignores w", caught_by: 7, cases: ["a/b", "c/d"], planes: ["uv"] }] });
let browser;
let shifted;

before(async () => {
  browser = await launch();
  shifted = makeReport("shifted", "shifted", CASES, { files: { "faults.json": FAULTS } });
});
afterEach(() => closePages(browser));
after(() => browser.close());

const firstFailed = (report) => report.results.cases.find((one) => one.status === "failed");

test("opens on the worst pixel of the first failing case, on the difference", async () => {
  const page = await openReport(browser, shifted);
  const failed = firstFailed(shifted);
  const link = await linkOf(page);
  assert.equal(link.case, failed.name);
  const { worst } = failed.planes.coverage;
  assert.equal(link.px, `${worst.x},${worst.y}`);
  assert.equal(link.plane, "coverage");
  assert.equal(await page.textContent("#case-name"), failed.name);
  assert.deepEqual(await page.$$eval("#panes canvas", (all) => all.map((one) => one.dataset.kind)), ["candidate", "reference", "difference"]);
  assert.match(await page.textContent("#sentence"), /shifted by a pixel to the right/);
  assert.deepEqual(page.errors, []);
  await page.screenshot({ path: screenshotPath("opens"), fullPage: true });
});

test("every key of the help does what it says, and each button has a key", async () => {
  const page = await openReport(browser, shifted);
  for (const [key, view] of [["2", "swipe"], ["3", "blink"], ["4", "difference"], ["5", "ulps"], ["6", "class"], ["1", "side"]]) {
    await press(page, key);
    assert.equal((await linkOf(page)).view, view);
    assert.equal(await page.getAttribute(`button[data-key="${key}"]`, "aria-pressed"), "true");
  }
  const [x, y] = (await linkOf(page)).px.split(",").map(Number);
  await press(page, "ArrowRight");
  await press(page, "ArrowDown");
  assert.equal((await linkOf(page)).px, `${x + 1},${y + 1}`);
  await press(page, "ArrowLeft");
  await press(page, "ArrowUp");
  assert.equal((await linkOf(page)).px, `${x},${y}`);
  await press(page, "n");
  const second = (await linkOf(page)).px;
  assert.notEqual(second, `${x},${y}`);
  assert.match(await page.textContent("#rank"), /^2 of /);
  await press(page, "p");
  assert.equal((await linkOf(page)).px, `${x},${y}`);
  await press(page, "+");
  const zoom = Number((await linkOf(page)).zoom);
  await press(page, "-");
  assert.ok(Number((await linkOf(page)).zoom) < zoom);
  await press(page, ".");
  assert.equal((await linkOf(page)).plane, "hits");
  await press(page, ",");
  assert.equal((await linkOf(page)).plane, "coverage");
  await press(page, "Shift+N");
  await page.waitForFunction((name) => document.getElementById("case-name").textContent !== name, firstFailed(shifted).name);
  await press(page, "Shift+P");
  await page.waitForFunction((name) => document.getElementById("case-name").textContent === name, firstFailed(shifted).name);
  await press(page, "?");
  const rows = await page.$$eval("#help-table tr", (all) => all.map((one) => one.textContent));
  const buttons = await page.$$eval("[data-actions] button", (all) => all.length);
  assert.ok(rows.length >= buttons && buttons > 15);
  await page.screenshot({ path: screenshotPath("help") });
  assert.deepEqual(page.errors, []);
});

test("the link is written while pictures blink, on a slow machine too", async () => {
  const page = await openReport(browser, shifted);
  await press(page, "2");
  // Frames without end, as blinking gives where each takes longer than the link's timer.
  await page.evaluate(() => {
    const again = () => {
      document.querySelector('button[data-key="3"]').click();
      setTimeout(again, 20);
    };
    again();
  });
  await page.waitForTimeout(1000);
  assert.equal((await linkOf(page)).view, "blink");
});

test("view, plane and zoom stay from case to case", async () => {
  const page = await openReport(browser, shifted);
  await press(page, "6");
  await press(page, "+");
  const before = await linkOf(page);
  await press(page, "Shift+N");
  await page.waitForFunction((name) => document.getElementById("case-name").textContent !== name, before.case);
  const next = await linkOf(page);
  assert.equal(next.view, "class");
  assert.equal(next.zoom, before.zoom);
});

test("a deep link shows what it names, and the copied one is the page's", async () => {
  const name = shifted.results.cases.filter((one) => one.status === "failed").at(-1).name;
  const hash = `#case=${encodeURIComponent(name)}&plane=owner&px=3,4&zoom=32&view=blink`;
  const page = await openReport(browser, shifted, { hash, reducedMotion: "reduce" });
  const link = await linkOf(page);
  assert.deepEqual([link.case, link.plane, link.px, link.zoom, link.view], [name, "owner", "3,4", "32", "blink"]);
  assert.equal(await page.textContent("#inspector h2"), "Pixel 3, 4");
  await press(page, "l");
  await page.waitForFunction(() => document.getElementById("told").dataset.text);
  assert.equal(await page.getAttribute("#told", "data-text"), page.url());
  await press(page, "x");
  await page.waitForFunction(() => document.getElementById("told").dataset.text.startsWith("fillrule"));
  assert.equal(await page.getAttribute("#told", "data-text"), `fillrule explain '${name}' --pixel 3,4`);
  // The same page follows another link.
  await page.evaluate((first) => { location.hash = `#case=${encodeURIComponent(first)}&px=1,2&view=ulps`; }, firstFailed(shifted).name);
  await page.waitForFunction((first) => document.getElementById("case-name").textContent === first, firstFailed(shifted).name);
  assert.equal((await linkOf(page)).px, "1,2");
  assert.deepEqual(page.errors, []);
});

test("a broken link opens the first case all the same", async () => {
  const page = await openReport(browser, shifted, { hash: "#case=no/such&px=9999999,1&zoom=zz&view=%zz" });
  assert.equal((await linkOf(page)).case, firstFailed(shifted).name);
  assert.deepEqual(page.errors, []);
});

test("the list filters and sorts all cases", async () => {
  const page = await openReport(browser, shifted);
  const names = () => page.$$eval(".list tbody tr", (all) => all.map((one) => one.dataset.name));
  const { cases } = shifted.results;
  await page.click('[data-filter="all"]');
  assert.deepEqual(await names(), cases.map((one) => one.name));
  await page.click('[data-filter="failed"]');
  assert.deepEqual(await names(), cases.filter((one) => one.status === "failed").map((one) => one.name));
  await page.fill("#search", "strip parity");
  assert.ok((await names()).length > 0);
  assert.ok((await names()).every((name) => name.includes("strip_parity")));
  await page.fill("#search", "");
  await page.click('[data-column="candidate_faults"] button');
  const faults = await page.$$eval(".list tbody tr td:nth-child(3)", (all) => all.map((one) => Number(one.textContent.replaceAll(",", ""))));
  assert.deepEqual(faults, [...faults].sort((a, b) => b - a));
  const last = (await names()).at(-1);
  await page.click(".list tbody tr:last-child button.name");
  await page.waitForFunction((name) => document.getElementById("case-name").textContent === name, last);
  assert.match(await page.textContent(".faults"), /affine_varyings.*ignores w.*7.*a\/b, c\/d.*uv/);
  await page.locator("#cases").screenshot({ path: screenshotPath("list") });
});

test("the plain wheel scrolls the page, Ctrl and wheel zoom at the cursor", async () => {
  const page = await openReport(browser, shifted);
  const box = await page.locator("canvas[data-slot=candidate]").boundingBox();
  const cursor = { x: box.x + box.width / 4, y: box.y + box.height / 4 };
  await page.mouse.move(cursor.x, cursor.y);
  await settled(page);
  const zoom = (await linkOf(page)).zoom;
  const under = () => page.textContent("#hover").then((text) => text.split(":")[0]);
  await page.mouse.wheel(0, 120);
  await page.waitForFunction(() => window.scrollY > 0);
  assert.equal((await linkOf(page)).zoom, zoom);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.mouse.move(cursor.x + 1, cursor.y);
  const pixel = await under();
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -240);
  await page.keyboard.up("Control");
  await settled(page);
  assert.ok(Number((await linkOf(page)).zoom) > Number(zoom));
  await page.mouse.move(cursor.x, cursor.y);
  assert.equal(await under(), pixel);
  assert.equal(await page.evaluate(() => window.scrollY), 0);
});

test("names that might break the page are text", async () => {
  const report = makeReport("hostile", "hostile", ["interpolation/vertex_order"], { reference: "none" });
  const page = await openReport(browser, report);
  await page.click('[data-filter="all"]');
  const shown = await page.$$eval(".list tbody tr", (all) => all.map((one) => one.dataset.name));
  assert.deepEqual(shown, report.results.cases.map((one) => one.name));
  for (let i = 0; i < report.results.cases.length - 1; ++i) {
    const name = await page.textContent("#case-name");
    await press(page, "Shift+N");
    await page.waitForFunction((from) => document.getElementById("case-name").textContent !== from, name, { timeout: 3000 }).catch(() => {});
  }
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth <= window.innerWidth));
  assert.deepEqual(page.errors, []);
  await page.reload();
  await ready(page);
  await page.screenshot({ path: screenshotPath("hostile"), fullPage: true });
  const plain = await openReport(browser, report, { javaScriptEnabled: false });
  assert.match(await plain.textContent("#static"), /<\/script><script>/);
});

test("without JavaScript there is the summary", async () => {
  const page = await openReport(browser, shifted, { javaScriptEnabled: false });
  const text = await page.textContent("#static");
  assert.match(text, new RegExp(`failed\\s*${shifted.results.summary.failed}`));
  assert.ok(text.includes(firstFailed(shifted).name));
  assert.match(text, /shifted by a pixel/);
  await page.screenshot({ path: screenshotPath("without-javascript"), fullPage: true });
});

test("it fits light and dark, wide and narrow windows", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [1280, 420]) {
      const page = await openReport(browser, shifted, { colorScheme, viewport: { width, height: 900 } });
      assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth <= window.innerWidth), `${width} px`);
      await page.screenshot({ path: screenshotPath(`${colorScheme}-${width}`), fullPage: true });
    }
  }
});
