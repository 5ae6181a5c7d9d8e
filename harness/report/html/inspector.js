// Everything about the selected sample: the reason, the chosen plane's values and tolerance, all planes, the primitives
// near it, and the command that tells the same.
import { ORACLE, VERDICTS, css, inkOn } from "./classes.js";
import { fill, h, swatch } from "./dom.js";
import { counted, doubleText, floatText, hex, numberOf, ownerText, shortText, ulpsBetween } from "./numbers.js";
import { classAt } from "./pictures.js";

function exactText(data, party, key, index) {
  const value = data.valueOf(party, key, index);
  if (key === "owner") return ownerText(value);
  return data.isInteger(key) ? String(value) : floatText(value);
}

function rows(pairs) {
  return h(
    "dl",
    {},
    pairs.filter(Boolean).flatMap(([name, ...values]) => [h("dt", {}, name), h("dd", { "data-field": name }, ...values)]),
  );
}

// Of a sample that is not explained: what its class alone says.
function reasonOf(data, index) {
  const explained = data.explained.get(index);
  if (explained) return explained.reason;
  const verdict = data.verdictOf("picture", index);
  const which = classAt(data, index);
  if (verdict < 2) return which.letter === "?" ? "The oracle leaves open whether this sample is covered." : "Nothing is wrong here.";
  return `${VERDICTS[verdict].name}: ${which.name}. Not among the ${data.explanations.length} samples that are explained here; the command below tells all of it.`;
}

function toleranceText(expectation) {
  const { tolerance, snapping, rounding, leftOpen } = expectation;
  if (snapping === undefined) return doubleText(tolerance, 4);
  const open = leftOpen ? ` + what ${leftOpen} leaves open` : "";
  return `${doubleText(tolerance, 4)} = snapping ${shortText(snapping)} + rounding ${shortText(rounding)}${open}`;
}

function integerRows(data, key, index) {
  const expected = { coverage: ORACLE[data.oracle[index]], owner: ownerText(data.oracleOwners[index]) }[key];
  return [
    ["candidate", exactText(data, "candidate", key, index)],
    data.has_reference && ["reference", exactText(data, "reference", key, index)],
    expected !== undefined && ["oracle", expected],
  ];
}

function errorText(expectation, value) {
  const severity = Number.isFinite(expectation.severity) ? `${shortText(expectation.severity)} tolerances, ` : "";
  return `${shortText(value - expectation.expected)} (${severity}${shortText(expectation.ulps)} ULP)`;
}

function floatRows(data, key, index) {
  const bits = (party) => data.bitsOf(party, key, index);
  const shown = (party) => [h("span", {}, exactText(data, party, key, index)), h("code", {}, hex(bits(party)))];
  const list = [["candidate", ...shown("candidate")]];
  if (data.has_reference) {
    list.push(["reference", ...shown("reference")]);
    const difference = data.valueOf("candidate", key, index) - data.valueOf("reference", key, index);
    list.push(["difference", `${shortText(difference)}, ${shortText(ulpsBetween(bits("candidate"), bits("reference")))} ULP`]);
  }
  for (const role of ["candidate", "reference"]) {
    const expectation = data.expectationOf(role, key, index);
    if (!expectation) continue;
    if (role === "candidate") {
      const known = !Number.isNaN(expectation.expected);
      list.push(["exact", known ? doubleText(expectation.expected) : "several answers, or none, are right"]);
      list.push(["tolerance", Number.isFinite(expectation.tolerance) ? toleranceText(expectation) : "not judged here"]);
      if (expectation.place) list.push(["evaluated", expectation.place]);
    }
    if (Number.isNaN(expectation.expected)) continue;
    list.push([`${role}'s error`, errorText(expectation, data.valueOf(role, key, index))]);
  }
  return list;
}

function planesTable(app, index) {
  const { data } = app;
  const head = h("tr", {}, h("th", {}, "plane"), h("th", {}, "candidate"), data.has_reference && h("th", {}, "reference"), h("th", {}, "verdict"));
  const body = data.planeKeys.filter((key) => key !== "picture").map((key) => {
    const verdict = VERDICTS[data.verdictOf(key, index)];
    const cells = ["candidate", data.has_reference && "reference"].filter(Boolean);
    return h(
      "tr",
      { class: key === app.state.plane ? "chosen" : undefined },
      h("td", {}, h("button", { class: "link", onclick: () => app.set({ plane: key }) }, key)),
      cells.map((party) => h("td", { class: "number" }, exactText(data, party, key, index))),
      h("td", { title: verdict.name }, swatch(css(verdict.colour), inkOn(verdict.colour)), verdict.short),
    );
  });
  return h("table", { class: "planes" }, h("thead", {}, head), h("tbody", {}, body));
}

function boundaryRow(boundary) {
  const distance = numberOf(boundary.distance);
  const value = numberOf(boundary.value);
  const kind = [boundary.top && "top", boundary.left && "left"].filter(Boolean).join(", ");
  return h(
    "tr",
    { class: value === 0 ? "zero" : undefined, title: `${doubleText(numberOf(boundary.form[0]), 6)} dx + ${doubleText(numberOf(boundary.form[1]), 6)} dy + ${doubleText(numberOf(boundary.form[2]), 6)}, from the viewport's centre` },
    h("td", {}, boundary.name, kind && h("em", {}, ` ${kind}`)),
    h("td", { class: "number" }, value === 0 ? "0: exactly on it" : shortText(value)),
    h("td", { class: "number" }, shortText(distance)),
    h("td", {}, boundary.answer),
  );
}

function cornersText(data, number) {
  const outline = data.outlines.find((one) => one.primitive === number);
  if (!outline) return null;
  const cut = outline.corners.filter(([, , maker]) => !/^v\d$/.test(maker));
  if (cut.length === 0) return null;
  return h("p", {}, "Clipped: ", outline.corners.map(([x, y, maker]) => `${maker} (${shortText(x)}, ${shortText(y)})`).join(", "), ".");
}

function bresenhamText({ x_major: xMajor, width, distance, diamond_exit: exits }) {
  const rule = exits === undefined ? "" : `; the diamond-exit rule makes ${exits ? "a" : "no"} fragment here`;
  return `${xMajor ? "x" : "y"}-major, ${counted(width, "fragment")} wide, ${shortText(numberOf(distance))} pixels from the line${rule}.`;
}

function primitiveBlock(data, primitive) {
  const turn = primitive.orientation > 0 ? "clockwise" : "counter-clockwise";
  const shape = primitive.kind !== "triangle" ? primitive.kind : primitive.orientation === 0 ? "without area" : turn;
  const facing = `${shape}, ${primitive.front ? "front" : "back"}-facing`;
  const barycentric = primitive.barycentric?.map((value) => shortText(numberOf(value))).join(", ");
  return h(
    "details",
    { open: true },
    h("summary", {}, `Primitive ${primitive.number}: ${primitive.answer} cover`),
    primitive.bresenham && h("p", {}, bresenhamText(primitive.bresenham)),
    h("p", {}, [`draw ${primitive.draw}, vertices ${primitive.vertices.join(" ")}`, facing, ...primitive.notes].join("; "), "."),
    barycentric && h("p", {}, `Barycentric coordinates: ${barycentric}.`),
    cornersText(data, primitive.number),
    primitive.boundaries.length > 0 &&
      h(
        "table",
        { class: "boundaries" },
        h("thead", {}, h("tr", {}, h("th", {}, "boundary"), h("th", {}, "E"), h("th", {}, "subpixels"), h("th", {}, "covers"))),
        h("tbody", {}, primitive.boundaries.map(boundaryRow)),
      ),
  );
}

function fragmentsText(data, view, index) {
  const [least, most] = view.hits;
  const right = least === most ? `${least} right` : `${least} to ${most} right`;
  const landed = ["candidate", data.has_reference && "reference"].filter(Boolean).map((party) => `${party} ${data.valueOf(party, "hits", index)}`);
  const owners = view.outcomes.map((one) => ownerText(one.owner));
  const covering = view.primitives.filter((one) => one.answer !== "must not");
  const order = covering.map((one) => `primitive ${one.number} ${one.answer}`).join(", then ");
  return [
    h("p", {}, `Fragments that landed: ${landed.join(", ")}; ${right}, the last of them ${owners.join(" or ")}.`),
    order && h("p", {}, `In the order of submission: ${order} cover.`),
  ];
}

function viewBlock(data, view, index) {
  return h(
    "section",
    {},
    h("h3", {}, `The oracle, for ${counted(view.bits, "subpixel bit")}`),
    fragmentsText(data, view, index),
    view.primitives.map((primitive) => primitiveBlock(data, primitive)),
    view.primitives.length === 0 && h("p", {}, "No primitive comes within a pixel."),
  );
}

export function explainCommand(data, x, y, sample) {
  if (!data.explain) return data.show;
  const place = `--pixel ${x},${y}${data.samples > 1 ? ` --sample ${sample}` : ""}`;
  return data.explain.replace(/--pixel \d+,\d+(?: --sample \d+)?/, place);
}

export function drawInspector(app, element) {
  const { data } = app;
  const { x, y, sample, plane } = app.state;
  const index = data.indexOf(x, y, sample);
  const which = classAt(data, index);
  const key = plane === "picture" ? "owner" : plane;
  const [dx, dy] = data.locations[sample];
  const explained = data.explained.get(index);
  const command = explainCommand(data, x, y, sample);
  fill(
    element,
    h("h2", {}, `Pixel ${x}, ${y}${data.samples > 1 ? `, sample ${sample}` : ""}`),
    h("p", { class: "where" }, `at (${x + dx}, ${y + dy})`, h("span", { class: "badge" }, swatch(css(which.colour), inkOn(which.colour), which.letter), which.name)),
    h("p", { class: "reason", id: "reason" }, reasonOf(data, index)),
    h("h3", {}, key),
    rows(data.isInteger(key) ? integerRows(data, key, index) : floatRows(data, key, index)),
    planesTable(app, index),
    explained && explained.views.map((view) => viewBlock(data, view, index)),
    command && h("section", { class: "command" }, h("h3", {}, "The same on the command line"), h("pre", {}, command)),
  );
}
