// What the browser tests share: reports of renderers that are broken on purpose, a browser, and the pixels of its canvases.
//
// FILLRULE_NODE_FOLDER: where the packages are installed. FILLRULE_BROKEN_REPORT: the program that writes reports.
// FILLRULE_BROWSER_FOLDER: where reports and screenshots go.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(`${process.env.FILLRULE_NODE_FOLDER}/`);
const { chromium } = require("playwright-core");

export const folder = process.env.FILLRULE_BROWSER_FOLDER;
const kReady = 60_000; // milliseconds; a loaded machine is slow
const FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];

export function screenshotPath(name) {
  mkdirSync(join(folder, "screenshots"), { recursive: true });
  return join(folder, "screenshots", `${name}.png`);
}

// A report of the fault on the cases, written anew. `files`: written into its folder before.
export function makeReport(name, fault, cases, { reference = "lavapipe", files = {} } = {}) {
  const path = join(folder, "reports", name);
  rmSync(path, { recursive: true, force: true });
  mkdirSync(path, { recursive: true });
  for (const [file, text] of Object.entries(files)) writeFileSync(join(path, file), text);
  execFileSync(process.env.FILLRULE_BROKEN_REPORT, [path, fault, reference, ...cases], { stdio: "pipe" });
  const json = (file) => JSON.parse(readFileSync(join(path, file), "utf8"));
  return { path, html: join(path, "report.html"), results: json("results.json"), truth: json("truth.json") };
}

export async function launch() {
  return chromium.launch({ executablePath: "/usr/bin/chromium", args: FLAGS, headless: true });
}

// What a test has opened would go on drawing beside those that follow.
export async function closePages(browser) {
  for (const context of browser.contexts()) await context.close();
}

// The page, once it shows something. Errors of the console are kept in page.errors.
export async function openReport(browser, report, { hash = "", ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.errors = [];
  page.on("console", (message) => message.type() === "error" && page.errors.push(message.text()));
  page.on("pageerror", (error) => page.errors.push(String(error)));
  page.on("request", (request) => !/^(file|data|blob):/.test(request.url()) && page.errors.push(`asks for ${request.url()}`));
  await page.goto(pathToFileURL(report.html).href + hash);
  if (options.javaScriptEnabled !== false) await ready(page);
  return page;
}

export async function ready(page) {
  await page.waitForFunction(() => document.body.dataset.ready !== undefined, null, { timeout: kReady });
  await settled(page);
}

// Until what was asked for is drawn.
export async function settled(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

export async function press(page, key) {
  await page.keyboard.press(key);
  await settled(page);
}

// What the address says, once it does: {case, plane, px, zoom, view}.
// The page writes its address 100 ms after a frame at the latest; a timer of the page's own that starts behind that frame
// and is longer runs out later, however slow the machine is.
export async function linkOf(page) {
  await settled(page);
  const hash = await page.evaluate(() => new Promise((done) => setTimeout(() => done(location.hash.slice(1)), 110)));
  return Object.fromEntries(hash.split("&").map((part) => /^(.*?)=(.*)$/.exec(part).slice(1).map(decodeURIComponent)));
}

// The colours of the cells of a pane, index of the sample => [r, g, b], of those in sight; taken from the middle of the
// cells, or `at` another part of them. Cells are as in the page's help: samples in reading order.
export async function coloursOf(page, slot, { width, height, samples }, at = 0.5) {
  const columns = { 1: 1, 2: 2, 4: 2, 8: 4, 16: 4 }[samples];
  const rows = samples / columns;
  const places = Array.from({ length: width * height * samples }, (_, index) => {
    const sample = index % samples;
    const pixel = Math.floor(index / samples);
    return {
      index,
      x: (pixel % width) + ((sample % columns) + at) / columns,
      y: Math.floor(pixel / width) + (Math.floor(sample / columns) + at) / rows,
    };
  });
  // In the page, since a canvas has a million numbers, which take longer to hand over than to look up.
  const colours = await page.evaluate(([name, wanted]) => {
    const canvas = document.querySelector(`canvas[data-slot=${name}]`);
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const [left, top, scale] = [canvas.dataset.left, canvas.dataset.top, canvas.dataset.scale].map(Number);
    const found = [];
    for (const { index, x, y } of wanted) {
      const canvasX = Math.floor((x - left) * scale);
      const canvasY = Math.floor((y - top) * scale);
      if (canvasX < 0 || canvasY < 0 || canvasX >= canvas.width || canvasY >= canvas.height) continue;
      const offset = (canvasY * canvas.width + canvasX) * 4;
      found.push([index, Array.from(data.subarray(offset, offset + 3))]);
    }
    return found;
  }, [slot, places]);
  return new Map(colours);
}

// Nothing but the pictures: no grid, outlines, numbers, rings.
export async function bare(page) {
  for (const key of ["g", "e", "v", "r"]) {
    if ((await page.getAttribute(`button[data-key=${key}]`, "aria-pressed")) === "true") await press(page, key);
  }
}
