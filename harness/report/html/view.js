// Where in the picture the panes look, and the steps of the zoom. One for all panes, so that they move together.
// Framebuffer coordinates are pixels of the target; pane coordinates are CSS pixels from a pane's top left.

export const ZOOMS = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];

export function nearestZoom(zoom) {
  return Math.min(Math.max(Math.round(zoom), ZOOMS[0]), ZOOMS[ZOOMS.length - 1]);
}

export function nextZoom(zoom, direction) {
  const larger = ZOOMS.find((step) => step > zoom) ?? zoom;
  const smaller = ZOOMS.findLast((step) => step < zoom) ?? zoom;
  return direction > 0 ? larger : smaller;
}

export class View {
  constructor() {
    this.zoom = 8; // CSS pixels for each pixel of the target
    this.x = 0; // what is in the middle of a pane
    this.y = 0;
    this.width = 1; // of a pane
    this.height = 1;
  }

  left() {
    return this.x - this.width / 2 / this.zoom;
  }

  top() {
    return this.y - this.height / 2 / this.zoom;
  }

  toTarget(paneX, paneY) {
    return { x: this.left() + paneX / this.zoom, y: this.top() + paneY / this.zoom };
  }

  // The largest step at which all of the target is seen; at least the smallest one.
  fit(target) {
    const most = Math.min(this.width / target.width, this.height / target.height);
    return ZOOMS.findLast((step) => step <= most) ?? ZOOMS[0];
  }

  // Zooms so that the point under the cursor stays there.
  zoomAt(zoom, paneX, paneY) {
    const before = this.toTarget(paneX, paneY);
    this.zoom = zoom;
    const after = this.toTarget(paneX, paneY);
    this.x += before.x - after.x;
    this.y += before.y - after.y;
  }

  // Keeps as much of the target in sight as there is; what is smaller than the pane is in its middle.
  clampTo(target) {
    const clamp = (at, size, seen) => (size <= seen ? size / 2 : Math.min(Math.max(at, seen / 2), size - seen / 2));
    this.x = clamp(this.x, target.width, this.width / this.zoom);
    this.y = clamp(this.y, target.height, this.height / this.zoom);
  }
}
