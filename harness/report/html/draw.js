// Draws one pane: the picture, and on top of it grid, outlines, sample locations, numbers, letters, rings and the
// selected pixel.
import { inkOn } from "./classes.js";
import { cellsOf } from "./pictures.js";

export const kGridZoom = 4;
export const kEdgeZoom = 8;
const kRingsBelow = 100; // differing pixels
const kRingRadius = 9;
const kSmallestFont = 7.5;
const kLargestFont = 13;

class Pen {
  constructor(canvas, view, data) {
    const scale = window.devicePixelRatio || 1;
    canvas.width = Math.round(view.width * scale);
    canvas.height = Math.round(view.height * scale);
    this.context = canvas.getContext("2d");
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
    this.view = view;
    this.data = data;
    // Whole device pixels, so that every pixel of the target is as large as the next.
    this.left = Math.round(view.left() * view.zoom * scale) / scale;
    this.top = Math.round(view.top() * view.zoom * scale) / scale;
    Object.assign(canvas.dataset, { left: this.left / view.zoom, top: this.top / view.zoom, scale: view.zoom * scale });
  }

  x(target) {
    return target * this.view.zoom - this.left;
  }

  y(target) {
    return target * this.view.zoom - this.top;
  }

  // Calls back for each pixel of the target that is in sight.
  forEachPixel(visit) {
    const { zoom, width, height } = this.view;
    const end = (size, from, seen) => Math.min(size, Math.ceil((from + seen) / zoom));
    for (let y = Math.max(0, Math.floor(this.top / zoom)); y < end(this.data.height, this.top, height); ++y) {
      for (let x = Math.max(0, Math.floor(this.left / zoom)); x < end(this.data.width, this.left, width); ++x) {
        visit(x, y);
      }
    }
  }

  forEachCell(visit) {
    const { columns, rows } = cellsOf(this.data.samples);
    const width = this.view.zoom / columns;
    const height = this.view.zoom / rows;
    this.forEachPixel((x, y) => {
      for (let sample = 0; sample < this.data.samples; ++sample) {
        const column = sample % columns;
        const row = Math.floor(sample / columns);
        visit(this.data.indexOf(x, y, sample), this.x(x) + column * width, this.y(y) + row * height, width, height);
      }
    });
  }
}

function drawPicture(pen, picture) {
  const { context, data, view } = pen;
  context.fillStyle = "#0d0e11";
  context.fillRect(0, 0, view.width, view.height);
  context.imageSmoothingEnabled = false;
  context.drawImage(picture, pen.x(0), pen.y(0), data.width * view.zoom, data.height * view.zoom);
}

function drawGrid(pen) {
  const { context, data } = pen;
  context.beginPath();
  pen.forEachPixel((x, y) => {
    context.moveTo(pen.x(x), pen.y(y + 1));
    context.lineTo(pen.x(x), pen.y(y));
    context.lineTo(pen.x(x + 1), pen.y(y));
  });
  context.rect(pen.x(0), pen.y(0), data.width * pen.view.zoom, data.height * pen.view.zoom);
  context.strokeStyle = "rgb(128 128 128 / 35%)";
  context.lineWidth = 1;
  context.stroke();
}

function strokeTwice(context, colour, width) {
  context.lineJoin = "round";
  context.lineWidth = width + 2;
  context.strokeStyle = "rgb(0 0 0 / 70%)";
  context.stroke();
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}

function traceOutline(pen, outline) {
  const { context } = pen;
  context.beginPath();
  if (outline.kind === "point") {
    const [x, y] = outline.corners[0];
    const half = outline.size / 2;
    context.rect(pen.x(x - half), pen.y(y - half), outline.size * pen.view.zoom, outline.size * pen.view.zoom);
    return;
  }
  outline.corners.forEach(([x, y], i) => (i === 0 ? context.moveTo(pen.x(x), pen.y(y)) : context.lineTo(pen.x(x), pen.y(y))));
  if (outline.kind === "triangle") context.closePath();
}

function drawOutlines(pen, highlighted) {
  const others = pen.data.outlines.filter((one) => !highlighted.has(one.primitive));
  for (const outline of others) {
    traceOutline(pen, outline);
    strokeTwice(pen.context, "rgb(190 205 225)", 1);
  }
  for (const outline of pen.data.outlines) {
    if (!highlighted.has(outline.primitive)) continue;
    traceOutline(pen, outline);
    strokeTwice(pen.context, "rgb(255 220 80)", 1.5);
  }
}

function drawLocations(pen) {
  const { context, data, view } = pen;
  const radius = Math.min(Math.max(view.zoom / 20, 0.7), 3);
  context.fillStyle = "rgb(255 255 255 / 75%)";
  context.strokeStyle = "rgb(0 0 0 / 75%)";
  context.lineWidth = 1;
  pen.forEachPixel((x, y) => {
    for (const [dx, dy] of data.locations) {
      context.beginPath();
      context.arc(pen.x(x + dx), pen.y(y + dy), radius, 0, 2 * Math.PI);
      if (view.zoom >= 16) context.stroke();
      context.fill();
    }
  });
}

// Text in the cells, left out where it does not fit. `middle`: where in the cell; numbers stand above the sample's location.
function drawTexts(pen, textOf, colourOf, middle) {
  const { context } = pen;
  context.textAlign = "center";
  context.textBaseline = "middle";
  pen.forEachCell((index, x, y, width, height) => {
    const text = textOf(index);
    if (!text) return;
    const size = Math.min(kLargestFont, (width - (text.length > 1 ? 6 : 2)) / (text.length * 0.6), height * (middle < 0.5 ? 0.42 : 0.9));
    if (size < kSmallestFont) return;
    context.font = `${size}px ui-monospace, "DejaVu Sans Mono", monospace`;
    context.fillStyle = inkOn(colourOf(index));
    context.fillText(text, x + width / 2, y + height * middle);
  });
}

// Pixels that differ while none of their neighbours does.
function lonePixels(data) {
  const width = data.width;
  const pixels = new Set();
  for (const index of data.differing) {
    pixels.add(Math.floor(index / data.samples));
    if (pixels.size >= kRingsBelow) return [];
  }
  const has = (x, y) => x >= 0 && x < width && pixels.has(y * width + x);
  return [...pixels]
    .map((pixel) => ({ x: pixel % width, y: Math.floor(pixel / width) }))
    .filter(({ x, y }) => {
      for (let dy = -1; dy <= 1; ++dy) {
        for (let dx = -1; dx <= 1; ++dx) if ((dx || dy) && has(x + dx, y + dy)) return false;
      }
      return true;
    });
}

function drawRings(pen, pixels) {
  const radius = Math.max(kRingRadius, pen.view.zoom * 0.9);
  for (const { x, y } of pixels) {
    pen.context.beginPath();
    pen.context.arc(pen.x(x + 0.5), pen.y(y + 0.5), radius, 0, 2 * Math.PI);
    strokeTwice(pen.context, "#ffd84d", 1.5);
  }
}

function drawSelection(pen, selected) {
  const { context, data, view } = pen;
  const { columns, rows } = cellsOf(data.samples);
  if (data.samples > 1) {
    const column = selected.sample % columns;
    const row = Math.floor(selected.sample / columns);
    context.beginPath();
    context.rect(
      pen.x(selected.x + column / columns),
      pen.y(selected.y + row / rows),
      view.zoom / columns,
      view.zoom / rows,
    );
    strokeTwice(context, "#ffd84d", 1);
  }
  const margin = view.zoom < 4 ? 3 : 0;
  context.beginPath();
  context.rect(
    pen.x(selected.x) - margin,
    pen.y(selected.y) - margin,
    view.zoom + 2 * margin,
    view.zoom + 2 * margin,
  );
  strokeTwice(context, "#fff", 1.5);
}

// `pane`: {picture, colourOf, textOf, letters}; `shown`: {grid, edges, numbers, rings}.
export function drawPane(canvas, view, data, pane, shown, selected, highlighted) {
  const pen = new Pen(canvas, view, data);
  drawPicture(pen, pane.picture);
  if (shown.grid && view.zoom >= kGridZoom) drawGrid(pen);
  if (shown.edges && view.zoom >= kEdgeZoom) {
    if (!pane.letters) drawLocations(pen);
    drawOutlines(pen, highlighted);
  }
  if (pane.letters) drawTexts(pen, pane.textOf, pane.colourOf, 0.54);
  else if (shown.numbers) drawTexts(pen, pane.textOf, pane.colourOf, data.samples === 1 ? 0.26 : 0.5);
  if (shown.rings) drawRings(pen, (data.lonePixels ??= lonePixels(data)));
  drawSelection(pen, selected);
}
