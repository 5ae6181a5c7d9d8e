// What stands at the top: the run in numbers, and the open case with the sentence that says what is wrong.
import { CLASSES, css, inkOn } from "./classes.js";
import { byId, fill, h, swatch } from "./dom.js";
import { counted } from "./numbers.js";

function chip(count, name, kind) {
  return h("li", { class: count > 0 ? kind : "none" }, h("b", {}, count.toLocaleString("en")), ` ${name}`);
}

export function drawRunHead(run) {
  const count = (holds) => run.cases.filter(holds).length;
  const { candidate, reference } = run;
  const isAlone = reference.driver === "none";
  fill(
    byId("chips"),
    chip(count((one) => one.status === "failed"), "failed", "bad"),
    chip(count((one) => one.new_faults > 0), "with new reference faults", "warn"),
    chip(count((one) => one.reference_faults > 0 && !one.new_faults), "with known reference faults", "plain"),
    chip(count((one) => one.status === "skipped"), "skipped", "plain"),
    chip(count((one) => one.status === "passed"), "passed", "good"),
  );
  byId("parties").textContent =
    `${candidate.name} (${candidate.subpixel_bits} subpixel bits) ` +
    (isAlone ? "held against the oracle alone" : `held against ${reference.driver}, ${reference.name}, ${reference.version}, and the oracle`);
  if (run.without_planes.length > 0) {
    const megabytes = run.most_bytes / 1e6;
    byId("cut").hidden = false;
    byId("cut").textContent = `${counted(run.without_planes.length, "case")} at fault ${run.without_planes.length === 1 ? "is" : "are"} here as statistics only: this page holds planes of at most ${megabytes} MB.`;
  }
}

export function drawCaseHead(app, element) {
  const { data } = app;
  const which = CLASSES.find((one) => one.name === data.class) ?? CLASSES[0];
  const order = app.atFault.findIndex((one) => one.index === data.index);
  const sentence = data.sentence || data.message;
  const checks = data.checks.map((check) => `The check ${check.name} failed: ${check.message}`);
  fill(
    element,
    h("p", { class: "order" }, `Case ${order + 1} of ${app.atFault.length} at fault`),
    h("h1", { id: "case-name" }, data.name),
    h(
      "p",
      { class: "sentence", id: "sentence" },
      h("span", { class: `status ${data.status}` }, data.status),
      data.sentence && h("span", { class: "badge" }, swatch(css(which.colour), inkOn(which.colour), which.letter), which.name),
      [sentence, ...checks].filter(Boolean).join(" "),
    ),
    h(
      "details",
      { class: "about" },
      h("summary", {}, data.title || "About this case"),
      h("p", {}, data.why),
      h("p", {}, `Specification: ${data.spec}`),
      h("p", {}, `File: ${data.file}`),
      data.show && h("pre", {}, data.show),
    ),
  );
}
