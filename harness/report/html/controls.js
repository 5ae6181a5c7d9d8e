// Buttons, the list of planes, the help and the keys: all from the table of actions.
import { ACTIONS, GROUPS, actionOf, keyName } from "./actions.js";
import { byId, fill, h } from "./dom.js";

function button(app, action) {
  const keys = action.keys.map(keyName).join(" or ");
  return h(
    "button",
    { title: `${action.help} (${keys})`, "data-key": action.keys[0], "aria-label": action.label.length < 3 ? action.help : undefined, onclick: () => action.run(app) },
    action.label,
  );
}

function helpTable() {
  return GROUPS.map(([group, title]) =>
    h(
      "section",
      {},
      h("h3", {}, title),
      h(
        "table",
        {},
        h("tbody", {}, ACTIONS.filter((action) => action.group === group).map((action) =>
          h("tr", {}, h("td", {}, action.keys.map((key) => h("kbd", {}, keyName(key)))), h("td", {}, action.help)))),
      ),
    ),
  );
}

export class Controls {
  constructor(app) {
    this.app = app;
    this.buttons = [];
    for (const [group] of GROUPS) {
      const place = document.querySelector(`[data-actions="${group}"]`);
      for (const action of ACTIONS.filter((one) => one.group === group && one.label)) {
        const element = button(app, action);
        this.buttons.push({ action, element });
        place.append(element);
      }
    }
    fill(byId("help-table"), helpTable());
    this.planes = byId("plane");
    this.planes.addEventListener("change", () => app.set({ plane: this.planes.value }));
    document.addEventListener("keydown", (event) => this.key(event, true));
    document.addEventListener("keyup", (event) => this.key(event, false));
    window.addEventListener("blur", () => app.hold(false));
  }

  key(event, down) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const typing = event.target.matches?.("input[type=search], select, textarea");
    if (typing) {
      if (down && event.key === "Escape") event.target.blur();
      return;
    }
    const action = actionOf(event.key);
    if (!action || byId("help").open) return;
    if (!this.app.data && !["case", "copy"].includes(action.group)) return;
    if (event.key.startsWith("Arrow") && event.target.matches?.("input")) return;
    if (action.hold) {
      if (!event.repeat) action.run(this.app, down);
    } else if (down) {
      action.run(this.app);
    }
    event.preventDefault();
  }

  // The list of planes, anew for each case.
  setPlanes(keys) {
    fill(this.planes, keys.map((key) => h("option", { value: key }, key === "picture" ? "picture (all planes)" : key)));
  }

  draw() {
    const { app } = this;
    for (const { action, element } of this.buttons) {
      if (action.pressed) element.setAttribute("aria-pressed", String(action.pressed(app)));
    }
    this.planes.value = app.state.plane;
    byId("zoom").textContent = `${app.view.zoom}x`;
    const rank = app.data.differing.indexOf(app.selectedIndex());
    const total = app.data.differing.length.toLocaleString("en");
    byId("rank").textContent = rank < 0 ? `– of ${total}` : `${(rank + 1).toLocaleString("en")} of ${total}`;
  }
}
