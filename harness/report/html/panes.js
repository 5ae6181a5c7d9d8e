// The panes of a view, and what mouse and finger do in them.
import { contentOf, titleOf } from "./contents.js";
import { byId, fill, h } from "./dom.js";
import { drawPane } from "./draw.js";
import { nearestZoom, nextZoom } from "./view.js";

const kClickDistance = 4; // CSS pixels
const kLeastHeight = 180;

// The kinds of panes in each view; `other` is the reference, or the oracle where there is none.
const LAYOUTS = {
  side: ["candidate", "other", "difference"],
  swipe: ["swipe"],
  blink: ["blink"],
  difference: ["difference"],
  ulps: ["ulps"],
  class: ["class"],
};

export class Panes {
  constructor(app) {
    this.app = app;
    this.container = byId("panes");
    this.swipe = 0.5;
    this.layout = null;
    this.panes = [];
    new ResizeObserver(() => app.draw()).observe(this.container);
  }

  other() {
    return this.app.data.has_reference ? "reference" : "oracle";
  }

  // Whom a pane shows right now.
  kindOf(slot) {
    const { held, blinked } = this.app.state;
    if (slot === "other") return this.other();
    if (slot === "blink") return held || blinked ? this.other() : "candidate";
    if (slot === "candidate" && held) return this.other();
    return slot === "swipe" ? "candidate" : slot;
  }

  build() {
    if (this.layout === this.app.state.view) return;
    this.layout = this.app.state.view;
    this.panes = LAYOUTS[this.layout].map((slot) => this.makePane(slot));
    this.container.className = this.panes.length > 1 ? "side" : "single";
    fill(this.container, this.panes.map((pane) => pane.element));
  }

  makePane(slot) {
    const canvas = h("canvas", { tabindex: "0", role: "img", "data-slot": slot });
    const title = h("figcaption", {});
    const slider = slot !== "swipe" ? null : h("input", {
      type: "range", min: "0", max: "1", step: "0.01", value: String(this.swipe), class: "slider",
      "aria-label": "where the candidate ends and the other begins",
      oninput: (event) => this.setSwipe(Number(event.target.value)),
    });
    this.listen(canvas, slot);
    return { slot, canvas, title, slider, element: h("figure", {}, title, canvas, slider) };
  }

  setSwipe(share) {
    this.swipe = Math.min(Math.max(share, 0), 1);
    for (const pane of this.panes) if (pane.slider) pane.slider.value = String(this.swipe);
    this.app.draw();
  }

  // All panes are as large as the first.
  measure() {
    const { view, data } = this.app;
    view.width = Math.max(this.panes[0].element.clientWidth, 1);
    const most = Math.max(kLeastHeight, Math.min(window.innerHeight * 0.62, 640));
    const wanted = Math.round((view.width * data.height) / data.width);
    view.height = Math.min(Math.max(wanted, kLeastHeight), most);
  }

  draw() {
    const { app } = this;
    for (const pane of this.panes) {
      const kind = this.kindOf(pane.slot);
      const { plane, shown, x, y, sample } = app.state;
      const content = contentOf(app.data, kind, plane);
      pane.canvas.style.height = `${app.view.height}px`;
      drawPane(pane.canvas, app.view, app.data, content, shown, { x, y, sample }, app.highlighted());
      pane.title.textContent = titleOf(app.data, kind, plane, app.run);
      pane.canvas.dataset.kind = kind;
      pane.canvas.setAttribute("aria-label", `${pane.title.textContent}, pixel ${x},${y} selected`);
      if (pane.slot === "swipe") this.drawOtherHalf(pane);
    }
  }

  drawOtherHalf(pane) {
    const { app } = this;
    const { plane, shown, x, y, sample } = app.state;
    const over = document.createElement("canvas");
    const content = contentOf(app.data, this.other(), plane);
    drawPane(over, app.view, app.data, content, shown, { x, y, sample }, app.highlighted());
    const context = pane.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    const from = Math.round(this.swipe * over.width);
    if (from < over.width) context.drawImage(over, from, 0, over.width - from, over.height, from, 0, over.width - from, over.height);
    context.fillStyle = "#ffd84d";
    context.fillRect(from - 1, 0, 2, over.height);
    pane.title.textContent = `${titleOf(app.data, "candidate", plane, app.run)} | ${titleOf(app.data, this.other(), plane, app.run)}`;
  }

  listen(canvas, slot) {
    let start = null;
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      const { view } = this.app;
      const near = slot === "swipe" && Math.abs(event.offsetX - this.swipe * view.width) < 12;
      start = { x: event.offsetX, y: event.offsetY, viewX: view.x, viewY: view.y, moved: false, divides: near };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      this.app.hover(this.pixelAt(event));
      if (!start) return;
      const dx = event.offsetX - start.x;
      const dy = event.offsetY - start.y;
      start.moved = start.moved || Math.hypot(dx, dy) > kClickDistance;
      if (start.divides) this.setSwipe(event.offsetX / this.app.view.width);
      else if (start.moved) this.app.panTo(start.viewX - dx / this.app.view.zoom, start.viewY - dy / this.app.view.zoom);
    });
    canvas.addEventListener("pointerup", (event) => {
      if (start && !start.moved && !start.divides) this.app.select(this.pixelAt(event));
      start = null;
    });
    canvas.addEventListener("pointercancel", () => (start = null));
    canvas.addEventListener("pointerleave", () => this.app.hover(null));
    canvas.addEventListener("dblclick", (event) => {
      this.app.zoomAt(nextZoom(this.app.view.zoom, event.shiftKey ? -1 : 1), event.offsetX, event.offsetY);
    });
    // The plain wheel is the page's.
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
  }

  wheel(event) {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const { view } = this.app;
    const wanted = nearestZoom(view.zoom * 2 ** (-event.deltaY / 200));
    const zoom = wanted === view.zoom ? nearestZoom(view.zoom - Math.sign(event.deltaY)) : wanted;
    this.app.zoomAt(zoom, event.offsetX, event.offsetY);
  }

  // The sample under the cursor; null outside of the target.
  pixelAt(event) {
    const { data, view } = this.app;
    const at = view.toTarget(event.offsetX, event.offsetY);
    const x = Math.floor(at.x);
    const y = Math.floor(at.y);
    if (x < 0 || y < 0 || x >= data.width || y >= data.height) return null;
    return { x, y, sample: this.app.sampleAt(at.x - x, at.y - y) };
  }
}
