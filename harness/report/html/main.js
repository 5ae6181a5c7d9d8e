// The page: what is shown, and everything that changes it.
import { contentOf } from "./contents.js";
import { Controls } from "./controls.js";
import { byId, fill, h } from "./dom.js";
import { drawCaseHead, drawRunHead } from "./heads.js";
import { drawInspector } from "./inspector.js";
import { linkText, parseLink } from "./link.js";
import { counted } from "./numbers.js";
import { Panes } from "./panes.js";
import { cellsOf } from "./pictures.js";
import { loadCase, loadRun } from "./store.js";
import { CaseList, drawFaults, drawWorst } from "./tables.js";
import { View, ZOOMS } from "./view.js";

const kBlinkMilliseconds = 250; // each side: both of them twice a second
const kLeastOpenZoom = 4;
const VIEWS = ["side", "swipe", "blink", "difference", "ulps", "class"];

class App {
  constructor() {
    this.run = loadRun();
    this.data = null;
    this.view = new View();
    this.state = {
      index: -1, plane: "picture", view: "side", x: 0, y: 0, sample: 0, held: false, blinked: false,
      shown: { grid: true, edges: true, numbers: true, rings: true },
    };
    this.zoomIsChosen = false;
    drawRunHead(this.run);
    this.panes = new Panes(this);
    this.controls = new Controls(this);
    this.list = new CaseList(this);
    drawFaults(this.run.faults, byId("faults"));
    this.atFault = this.run.cases.filter((one) => one.hasPlanes).sort((a, b) => this.rankOf(a) - this.rankOf(b));
    setInterval(() => this.blink(), kBlinkMilliseconds);
    window.addEventListener("hashchange", () => this.follow(location.hash));
  }

  // Failed cases, then those in which the reference alone is at fault: new faults first.
  rankOf(one) {
    return one.status === "failed" ? 0 : one.new_faults > 0 ? 1 : 2;
  }

  async start() {
    if (await this.follow(location.hash)) return;
    if (this.atFault.length > 0) await this.open(this.atFault[0].index);
    else byId("viewer").hidden = true;
  }

  // Shows what a deep link names. False if there is no such case.
  async follow(hash) {
    if (hash === this.written) return true;
    const link = parseLink(hash);
    const one = this.run.cases.find((candidate) => candidate.name === link.name && candidate.hasPlanes);
    if (!one) return false;
    await this.open(one.index, link);
    return true;
  }

  async open(index, link = {}) {
    const data = await loadCase(index);
    if (!data) return;
    this.data = data;
    byId("viewer").hidden = false;
    this.controls.setPlanes(data.planeKeys);
    const worst = data.worst[0];
    const place = data.differing.length > 0 ? data.placeOf(data.differing[0]) : { x: 0, y: 0, sample: 0 };
    const plane = [link.plane, worst && data.keyOf(worst), "picture"].find((key) => data.planeKeys.includes(key));
    Object.assign(this.state, place, { index, plane });
    if (VIEWS.includes(link.view)) this.state.view = link.view;
    if (link.x < data.width && link.y < data.height) {
      Object.assign(this.state, { x: link.x, y: link.y, sample: link.sample < data.samples ? link.sample : 0 });
    }
    if (link.zoom >= ZOOMS[0]) {
      this.zoomIsChosen = true;
      this.view.zoom = Math.min(link.zoom, ZOOMS[ZOOMS.length - 1]);
    }
    drawCaseHead(this, byId("case-head"));
    this.list.draw();
    this.relayout();
  }

  openNext(direction) {
    const at = this.atFault.findIndex((one) => one.index === this.state.index);
    const next = this.atFault[at + direction];
    if (next) this.open(next.index);
  }

  set(changes) {
    Object.assign(this.state, changes);
    if (changes.view) this.relayout();
    this.draw();
    this.drawTexts();
  }

  // For another number of panes, or another case: all of the picture is in sight, unless a zoom was chosen.
  relayout() {
    this.state.blinked = false;
    this.panes.build();
    this.panes.measure();
    if (!this.zoomIsChosen) this.view.zoom = Math.max(this.view.fit(this.data), kLeastOpenZoom);
    this.centre();
  }

  selectedIndex() {
    return this.data.indexOf(this.state.x, this.state.y, this.state.sample);
  }

  // The sample whose cell is there; `x` and `y` are parts of a pixel.
  sampleAt(x, y) {
    const { columns, rows } = cellsOf(this.data.samples);
    return Math.floor(y * rows) * columns + Math.floor(x * columns);
  }

  select(place, plane = this.state.plane) {
    if (!place) return;
    this.set({ x: place.x, y: place.y, sample: place.sample, plane });
    this.showSelected();
  }

  // Moves the view if the selected pixel is out of sight.
  showSelected() {
    const { x, y } = this.state;
    const { view } = this;
    const seen = Math.abs(x + 0.5 - view.x) * view.zoom < view.width / 2 && Math.abs(y + 0.5 - view.y) * view.zoom < view.height / 2;
    if (!seen) this.centre();
  }

  moveBy(dx, dy) {
    const clamp = (value, size) => Math.min(Math.max(value, 0), size - 1);
    this.select({ x: clamp(this.state.x + dx, this.data.width), y: clamp(this.state.y + dy, this.data.height), sample: this.state.sample });
  }

  nextSample() {
    this.set({ sample: (this.state.sample + 1) % this.data.samples });
  }

  nextDifference(direction) {
    const { differing } = this.data;
    if (differing.length === 0) return;
    const rank = differing.indexOf(this.selectedIndex());
    const next = rank < 0 ? 0 : (rank + direction + differing.length) % differing.length;
    this.select(this.data.placeOf(differing[next]));
  }

  nextPlane(direction) {
    const keys = this.data.planeKeys;
    this.set({ plane: keys[(keys.indexOf(this.state.plane) + direction + keys.length) % keys.length] });
  }

  // Primitives whose outlines stand out: those at the selected pixel.
  highlighted() {
    const index = this.selectedIndex();
    const owners = ["candidate", "reference"].map((party) => this.data.bitsOf(party, "owner", index));
    return new Set([...owners, this.data.oracleOwners[index]]);
  }

  panTo(x, y) {
    Object.assign(this.view, { x, y });
    this.view.clampTo(this.data);
    this.draw();
  }

  zoomAt(zoom, paneX, paneY) {
    this.view.zoomAt(zoom, paneX, paneY);
    this.zoomIsChosen = true;
    this.panTo(this.view.x, this.view.y);
  }

  zoomTo(zoom) {
    this.view.zoom = zoom;
    this.zoomIsChosen = true;
    this.centre();
  }

  fit() {
    this.view.zoom = this.view.fit(this.data);
    this.zoomIsChosen = false;
    this.panTo(this.data.width / 2, this.data.height / 2);
  }

  centre() {
    this.view.x = this.state.x + 0.5;
    this.view.y = this.state.y + 0.5;
    this.view.clampTo(this.data);
    this.draw();
    this.drawTexts();
  }

  hold(held) {
    if (!this.data || this.state.held === held) return;
    this.state.held = held;
    this.draw();
  }

  blink() {
    if (!this.data || this.state.view !== "blink") return;
    if (window.matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    this.state.blinked = !this.state.blinked;
    this.draw();
  }

  hover(place) {
    const { data } = this;
    const { plane } = this.state;
    if (!place) {
      byId("hover").textContent = "";
      return;
    }
    const index = data.indexOf(place.x, place.y, place.sample);
    const content = (kind) => contentOf(data, kind, plane).textOf(index) || "none";
    const parties = data.has_reference ? ["candidate", "reference"] : ["candidate"];
    const values = parties.map((party) => `${party} ${content(party)}`).join(", ");
    byId("hover").textContent = `${place.x}, ${place.y}${data.samples > 1 ? ` · ${place.sample}` : ""}: ${values}`;
  }

  // The pictures; many times a second while the mouse drags them.
  draw() {
    if (!this.data || this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => {
      this.drawing = false;
      this.panes.build();
      this.panes.measure();
      this.panes.draw();
      this.controls.draw();
      this.drawLegend();
      this.writeLink();
    });
  }

  drawLegend() {
    const kind = this.panes.kindOf(this.panes.panes[this.panes.panes.length - 1].slot);
    const name = `${this.state.index} ${kind} ${this.state.plane}`;
    if (this.legend === name) return;
    this.legend = name;
    fill(byId("legend"), contentOf(this.data, kind, this.state.plane).legend());
  }

  drawTexts() {
    drawInspector(this, byId("inspector"));
    drawWorst(this, byId("worst"));
  }

  // Browsers limit how often the address may change. A write that waits is not put off by further frames: while pictures
  // blink on a slow machine there is always another one.
  writeLink() {
    if (this.linkTimer) return;
    this.linkTimer = setTimeout(() => {
      this.linkTimer = 0;
      this.written = linkText({ ...this.state, name: this.data.name, samples: this.data.samples, zoom: this.view.zoom });
      history.replaceState(null, "", this.written);
    }, 100);
  }

  async copy(what, text) {
    try {
      await navigator.clipboard.writeText(text);
      this.tell(`The ${what} is in the clipboard.`);
    } catch {
      // No clipboard here, as on some pages from file://: the text can be taken by hand.
      this.tell(h("textarea", { readonly: true, rows: "2", "aria-label": what }, text));
    }
    byId("told").dataset.text = text;
  }

  tell(content) {
    fill(byId("told"), content);
    byId("told").querySelector("textarea")?.select();
    clearTimeout(this.toldTimer);
    if (typeof content === "string") this.toldTimer = setTimeout(() => fill(byId("told")), 4000);
  }

  help() {
    byId("help").showModal();
  }

  search() {
    byId("search").focus();
  }
}

byId("static").remove();
byId("page").hidden = false;
const app = new App();
await app.start();
performance.mark("ready");
document.body.dataset.ready = counted(app.run.cases.length, "case");
