// Elements of the page. Text from outside only ever becomes text, never markup.

// Children that are left out by a condition.
function isThere(child) {
  return child !== null && child !== undefined && child !== false && child !== "";
}

// h("td", {class: "x", title: "y", onclick: f}, "text", element, ...)
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else element.setAttribute(name, value);
  }
  element.append(...children.flat().filter(isThere));
  return element;
}

export function byId(id) {
  return document.getElementById(id);
}

export function fill(element, ...children) {
  element.replaceChildren(...children.flat().filter(isThere));
}

// A square in a colour, with a letter in it.
export function swatch(background, ink, letter = "") {
  return h("span", { class: "swatch", style: `background:${background};color:${ink}`, "aria-hidden": "true" }, letter);
}
