// How large a report with many failures is, and how long it takes to open: alone on the machine, as what runs beside it
// would count too.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import { launch, makeReport, openReport } from "./support.mjs";

const kMostBytes = 20_000_000;
const kMostOpening = 2_000; // milliseconds
let browser;

before(async () => {
  browser = await launch();
});
after(() => browser.close());

test("500 failures stay below the limit and open quickly", async () => {
  const report = makeReport("many", "shifted", ["coverage/*", "depth/*"], { reference: "none" });
  const { failed } = report.results.summary;
  assert.ok(failed >= 500, `${failed} failures`);
  const { size } = statSync(report.html);
  assert.ok(size < kMostBytes * 1.1, `${size} bytes`);
  const times = [];
  for (let i = 0; i < 3; ++i) {
    const page = await openReport(browser, report);
    times.push(await page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
    assert.deepEqual(page.errors, []);
    await page.close();
  }
  console.log(`${failed} failures: ${(size / 1e6).toFixed(1)} MB, opened in ${times.map(Math.round).join(", ")} ms`);
  assert.ok(Math.min(...times) < kMostOpening, `${times} ms`);
});
