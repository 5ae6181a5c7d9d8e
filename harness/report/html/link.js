// Deep links: what is shown, as the part of the address behind the #.
//
//   #case=depth/less[z=1]&plane=depth&px=17,5&sample=0&zoom=32&view=blink

export function parseLink(hash) {
  const link = {};
  for (const part of hash.replace(/^#/, "").split("&")) {
    const equals = part.indexOf("=");
    if (equals < 0) continue;
    try {
      link[part.slice(0, equals)] = decodeURIComponent(part.slice(equals + 1));
    } catch {
      // A damaged address: the other parts may be good.
    }
  }
  const pixel = /^(\d+),(\d+)$/.exec(link.px ?? "");
  return {
    name: link.case,
    plane: link.plane,
    view: link.view,
    x: pixel ? Number(pixel[1]) : undefined,
    y: pixel ? Number(pixel[2]) : undefined,
    sample: /^\d+$/.test(link.sample ?? "") ? Number(link.sample) : undefined,
    zoom: /^\d+$/.test(link.zoom ?? "") ? Number(link.zoom) : undefined,
  };
}

// Slashes, brackets and the like stay legible.
function encode(text) {
  return encodeURIComponent(text).replace(/%(2F|2C|5B|5D|3D|3A)/g, (code) => decodeURIComponent(code));
}

export function linkText({ name, plane, x, y, sample, samples, zoom, view }) {
  const parts = [`case=${encode(name)}`, `plane=${encode(plane)}`, `px=${x},${y}`];
  if (samples > 1) parts.push(`sample=${sample}`);
  parts.push(`zoom=${zoom}`, `view=${view}`);
  return `#${parts.join("&")}`;
}
