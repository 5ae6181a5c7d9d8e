// The one table that keys, buttons and the help are made from.
import { explainCommand } from "./inspector.js";
import { nextZoom } from "./view.js";

const view = (id, key, label, help) => ({
  group: "view", keys: [key], label, help,
  run: (app) => app.set({ view: id }),
  pressed: (app) => app.state.view === id,
});

const toggle = (id, key, label, help) => ({
  group: "show", keys: [key], label, help,
  run: (app) => app.set({ shown: { ...app.state.shown, [id]: !app.state.shown[id] } }),
  pressed: (app) => app.state.shown[id],
});

const move = (key, dx, dy, help) => ({ group: "pixel", keys: [key], help, run: (app) => app.moveBy(dx, dy) });

export const ACTIONS = [
  view("side", "1", "Side by side", "candidate, reference and verdict side by side"),
  view("swipe", "2", "Swipe", "candidate and reference with a divider to move"),
  view("blink", "3", "Blink", "candidate and reference in turn, twice a second; with reduced motion only while B is held"),
  view("difference", "4", "Difference", "the verdict of each sample"),
  view("ulps", "5", "ULPs", "how far apart the values are, in steps of the logarithm"),
  view("class", "6", "Classes", "what is wrong at each sample, by colour and letter"),

  { group: "case", keys: ["P", "["], label: "◀ Case", help: "the failing case before", run: (app) => app.openNext(-1) },
  { group: "case", keys: ["N", "]"], label: "Case ▶", help: "the next failing case", run: (app) => app.openNext(1) },
  { group: "case", keys: ["/"], help: "find a case", run: (app) => app.search() },

  { group: "difference", keys: ["p"], label: "◀", help: "the difference before, by size", run: (app) => app.nextDifference(-1) },
  { group: "difference", keys: ["n"], label: "▶", help: "the next difference, by size", run: (app) => app.nextDifference(1) },

  { group: "plane", keys: [","], help: "the plane before", run: (app) => app.nextPlane(-1) },
  { group: "plane", keys: ["."], help: "the next plane", run: (app) => app.nextPlane(1) },

  { group: "zoom", keys: ["-"], label: "−", help: "zoom out", run: (app) => app.zoomTo(nextZoom(app.view.zoom, -1)) },
  { group: "zoom", keys: ["+", "="], label: "+", help: "zoom in (Ctrl + wheel: at the cursor)", run: (app) => app.zoomTo(nextZoom(app.view.zoom, 1)) },
  { group: "zoom", keys: ["0"], label: "Fit", help: "all of the picture", run: (app) => app.fit() },
  { group: "zoom", keys: ["c"], label: "Centre", help: "the selected pixel in the middle", run: (app) => app.centre() },

  toggle("grid", "g", "Grid", "the grid of pixels, from 4x"),
  toggle("edges", "e", "Edges", "outlines of primitives and sample locations, from 8x"),
  toggle("numbers", "v", "Values", "numbers in the cells, where they fit"),
  toggle("rings", "r", "Rings", "rings round lone differing pixels, where there are fewer than 100"),

  move("ArrowLeft", -1, 0, "the pixel to the left"),
  move("ArrowRight", 1, 0, "the pixel to the right"),
  move("ArrowUp", 0, -1, "the pixel above"),
  move("ArrowDown", 0, 1, "the pixel below"),
  { group: "pixel", keys: ["s"], help: "the pixel's next sample", run: (app) => app.nextSample() },
  { group: "pixel", keys: ["b"], hold: true, help: "hold: the reference in the candidate's place", run: (app, down) => app.hold(down) },

  { group: "copy", keys: ["l"], label: "Copy link", help: "copy a link to what is shown", run: (app) => app.copy("link", location.href) },
  { group: "copy", keys: ["x"], label: "Copy command", help: "copy the command that explains the pixel", run: (app) => {
    const { x, y, sample } = app.state;
    app.copy("command", explainCommand(app.data, x, y, sample));
  } },
  { group: "copy", keys: ["?"], label: "?", help: "this help", run: (app) => app.help() },
];

export const GROUPS = [
  ["view", "Views"],
  ["difference", "Differences"],
  ["case", "Cases"],
  ["plane", "Planes"],
  ["zoom", "Zoom"],
  ["show", "Show"],
  ["pixel", "Pixel"],
  ["copy", "Copy and help"],
];

const KEY_NAMES = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓" };

export function keyName(key) {
  return KEY_NAMES[key] ?? (/^[A-Z]$/.test(key) ? `Shift + ${key}` : key.toUpperCase());
}

export function actionOf(key) {
  return ACTIONS.find((action) => action.keys.includes(key));
}
