// The tables: worst samples of a case, all cases of the run, the faults that the suite was tried on.
import { css, inkOn } from "./classes.js";
import { byId, fill, h, swatch } from "./dom.js";
import { counted, doubleText, numberOf, ownerText, shortText } from "./numbers.js";
import { classAt } from "./pictures.js";

const kFirstRows = 200;

function worstValue(plane, value) {
  if (value === undefined) return "";
  const number = numberOf(value);
  return plane === "owner" ? ownerText(number) : doubleText(number, 9);
}

// Pixels at fault, the worst first. A click selects one.
export function drawWorst(app, element) {
  const { data } = app;
  if (data.worst.length === 0) {
    fill(element, h("p", {}, "No sample is imprecise or at fault."));
    return;
  }
  const head = ["#", "pixel", "class", "plane", "candidate", data.has_reference && "reference", "expected", "off by", "verdict"];
  const body = data.worst.map((one, i) => {
    const which = classAt(data, one.index);
    const severity = numberOf(one.severity);
    return h(
      "tr",
      {
        class: one.index === app.selectedIndex() ? "chosen" : undefined,
        "data-index": String(one.index),
        onclick: () => app.select(one, data.keyOf(one)),
      },
      h("td", { class: "number" }, String(i + 1)),
      h("td", {}, h("button", { class: "link" }, `${one.x}, ${one.y}${data.samples > 1 ? ` · ${one.sample}` : ""}`)),
      h("td", {}, swatch(css(which.colour), inkOn(which.colour), which.letter), which.name),
      h("td", {}, data.keyOf(one)),
      h("td", { class: "number" }, worstValue(one.plane, one.candidate)),
      data.has_reference && h("td", { class: "number" }, worstValue(one.plane, one.reference)),
      h("td", { class: "number" }, worstValue(one.plane, one.expected)),
      h("td", { class: "number" }, Number.isFinite(severity) ? `${shortText(severity)} tol` : "wrong"),
      h("td", {}, one.verdict),
    );
  });
  const more = data.differing.length - data.worst.length;
  fill(
    element,
    h("table", { class: "worst" }, h("thead", {}, h("tr", {}, head.filter(Boolean).map((text) => h("th", {}, text)))), h("tbody", {}, body)),
    more > 0 && h("p", { class: "note" }, `And ${counted(more, "sample")} more: N goes on to them.`),
  );
}

const FILTERS = [
  { id: "fault", name: "at fault", holds: (one) => one.status === "failed" || one.reference_faults > 0 },
  { id: "failed", name: "failed", holds: (one) => one.status === "failed" },
  { id: "known", name: "known reference faults", holds: (one) => one.reference_faults > 0 && !one.new_faults },
  { id: "new", name: "new reference faults", holds: (one) => one.new_faults > 0 },
  { id: "imprecise", name: "imprecise", holds: (one) => one.imprecise > 0 },
  { id: "skipped", name: "skipped", holds: (one) => one.status === "skipped" },
  { id: "all", name: "all", holds: () => true },
];

const COLUMNS = [
  { key: "name", name: "case" },
  { key: "status", name: "status" },
  { key: "candidate_faults", name: "candidate faults", number: true },
  { key: "reference_faults", name: "reference faults", number: true },
  { key: "imprecise", name: "imprecise", number: true },
  { key: "permitted", name: "permitted", number: true },
  { key: "seconds", name: "ms", number: true, text: (value) => (value * 1000).toFixed(1) },
  { key: "why", name: "why" },
];

// The list of all cases: filtered by a button and by words, sorted by any column.
export class CaseList {
  constructor(app) {
    this.app = app;
    this.filter = app.run.cases.some(FILTERS[0].holds) ? "fault" : "all";
    this.words = "";
    this.sort = { key: null, descending: false };
    this.all = false;
    this.build();
  }

  build() {
    const search = h("input", {
      type: "search", id: "search", placeholder: "words in the name or reason", "aria-label": "filter the cases",
      oninput: (event) => this.set({ words: event.target.value }),
    });
    this.buttons = FILTERS.map((filter) => {
      const count = this.app.run.cases.filter(filter.holds).length;
      return h("button", { "data-filter": filter.id, onclick: () => this.set({ filter: filter.id }) }, `${filter.name} ${count.toLocaleString("en")}`);
    });
    this.headers = COLUMNS.map((column) => h("th", { "data-column": column.key }, h("button", { class: "link", onclick: () => this.sortBy(column) }, column.name)));
    this.body = h("tbody", {});
    this.foot = h("p", { class: "note" });
    fill(
      byId("cases"),
      h("div", { class: "filters" }, this.buttons, search),
      h("div", { class: "scroll" }, h("table", { class: "list" }, h("thead", {}, h("tr", {}, this.headers)), this.body)),
      this.foot,
    );
    this.draw();
  }

  set(changes) {
    Object.assign(this, { all: false }, changes);
    this.draw();
  }

  sortBy(column) {
    const descending = this.sort.key === column.key ? !this.sort.descending : column.number === true;
    this.set({ sort: { key: column.key, descending } });
  }

  chosen() {
    const { holds } = FILTERS.find((filter) => filter.id === this.filter);
    const words = this.words.toLowerCase().split(/\s+/).filter(Boolean);
    const cases = this.app.run.cases.filter((one) => {
      const text = `${one.name} ${one.why}`.toLowerCase();
      return holds(one) && words.every((word) => text.includes(word));
    });
    const { key, descending } = this.sort;
    if (!key) return cases;
    const order = (a, b) => (a[key] < b[key] ? -1 : a[key] > b[key] ? 1 : a.index - b.index);
    return cases.sort((a, b) => (descending ? order(b, a) : order(a, b)));
  }

  row(one) {
    const open = one.hasPlanes && h("button", { class: "link name", onclick: () => this.app.open(one.index) }, one.name);
    const cells = COLUMNS.slice(1).map((column) => {
      const value = one[column.key];
      const text = column.text ? column.text(value) : column.number ? value.toLocaleString("en") : value;
      return h("td", { class: column.number ? "number" : column.key }, text);
    });
    const known = one.reference_faults > 0 ? (one.new_faults ? "new" : "known") : undefined;
    return h("tr", { "data-name": one.name, class: one.index === this.app.state.index ? "chosen" : undefined, "data-status": one.status, "data-known": known }, h("td", {}, open || h("span", { class: "name" }, one.name)), cells);
  }

  draw() {
    for (const button of this.buttons) button.setAttribute("aria-pressed", String(button.dataset.filter === this.filter));
    this.headers.forEach((header) => {
      const sorted = header.dataset.column === this.sort.key;
      header.setAttribute("aria-sort", sorted ? (this.sort.descending ? "descending" : "ascending") : "none");
    });
    const cases = this.chosen();
    const shown = this.all ? cases : cases.slice(0, kFirstRows);
    fill(this.body, shown.map((one) => this.row(one)));
    const rest = cases.length - shown.length;
    fill(
      this.foot,
      `${counted(cases.length, "case")}. `,
      rest > 0 && h("button", { onclick: () => this.set({ all: true }) }, `Show ${rest.toLocaleString("en")} more`),
    );
  }
}

// The table of `fillrule faults`, where one was run.
export function drawFaults(faults, element) {
  if (!faults) return;
  element.hidden = false;
  const row = (fault) => {
    const list = (value) => (Array.isArray(value) ? value.join(", ") : String(value ?? ""));
    return h(
      "tr",
      { class: fault.caught_by > 0 ? undefined : "uncaught" },
      h("td", {}, list(fault.name)), h("td", {}, list(fault.what)), h("td", { class: "number" }, list(fault.caught_by)),
      h("td", {}, list(fault.cases)), h("td", {}, list(fault.planes)),
    );
  };
  const head = ["fault", "what it does", "caught by", "for instance", "planes"].map((text) => h("th", {}, text));
  element.append(h("div", { class: "scroll" }, h("table", { class: "faults" }, h("thead", {}, h("tr", {}, head)), h("tbody", {}, faults.map(row)))));
}
