// Points on the course that can be dragged: buttons above the drawing, each at its place.
import { kindsBar } from "./kinds.js";
import { nearest, ordered, roomiest } from "./lines.js";

const { both, courseMap: map, element, pick, say, translated } = globalThis.cadgenPage;

const FARTHEST = 1e6; // mm, as of the schema
const [ARROW, FINE] = [10, 1]; // mm, of an arrow key
const REST = 350; // ms after the last key until the whole is computed
const NEAR = 12; // px, from a line within which a double click adds a point to it
const LAYERS = { path: both("Path"), gates: both("Gates"), posts: both("Posts, walls, zones, field") };

export function handles(figure, change, step) {
  const box = figure.querySelector("#course-box");
  const overlay = element("div", { class: "stage", id: "handles", role: "group", label: both("Points that can be moved") });
  box.append(overlay);
  const layers = element("div", { class: "layers", role: "group", label: both("Points to move") });
  const fields = ["x", "y"].map((axis) => {
    const input = element("input", { type: "number", step: "any", "data-axis": axis, label: both("{axis}, mm", { axis }) });
    input.addEventListener("change", () => typed());
    return input;
  });
  const name = element("b", { id: "point-name" });
  const fault = element("p", { class: "fault", role: "alert" });
  const [add, drop] = [
    element("button", { type: "button", id: "add-point", text: both("Add a point"), label: both("Add a point after this one (Insert)") }),
    element("button", { type: "button", id: "remove-point", text: both("Remove the point"), label: both("Remove the point (Delete)") }),
  ];
  add.addEventListener("click", () => addAfter(point(chosen)));
  drop.addEventListener("click", () => removePoint(point(chosen)));
  const place = element("div", { class: "place" }, name, " x ", fields[0], " y ", fields[1], element("small", {}, "mm"));
  const kinds = kindsBar({ add: addItem, remove: removeItem, exchange });
  const bar = element("div", { id: "point-bar" }, place, add, drop, ...kinds.ofItem);
  const help = element("p", {
    class: "hint",
    text: both("Drag a point, or move it by the arrow keys (10 mm, with Shift 1 mm); Page Up and Page Down choose another. A double click adds a point to the path or to the wall beside it, else a gate or a post; Insert adds one more like the chosen one, Delete removes it."),
  });
  box.after(layers, kinds.node, bar, fault, help);

  let points = [];
  let layer = "path";
  let chosen = null; // key
  let drag = null;
  let gestures = 0;
  const buttons = new Map();

  const where = (sentence) => {
    say(fault, sentence);
    return () => say(fault);
  };
  const short = (value) => Number(value.toFixed(1));
  const point = (key) => points.find((one) => one.key === key);
  /** A point by its key, or the first of an item, on the layer that is shown. */
  const shownOf = (key) => points.find((one) => one.layer === layer && (one.key === key || one.item === key));
  const move = (one, x, y, gesture, settled) => {
    one.x = Math.max(-FARTHEST, Math.min(FARTHEST, short(x)));
    one.y = Math.max(-FARTHEST, Math.min(FARTHEST, short(y)));
    set(one);
    name_();
    change({ changes: { [one.key]: [one.x, one.y] }, gesture, settled, where });
  };

  function set(one) {
    const button = buttons.get(one.key);
    const { frame } = map;
    if (!button || !frame) return;
    button.style.left = `${(100 * (one.x - frame.left)) / frame.width}%`;
    button.style.top = `${(100 * (frame.top - one.y)) / frame.height}%`;
    button.setAttribute("aria-label", `${pick(one.label)}: x ${one.x}, y ${one.y} mm`);
  }

  function name_() {
    const one = point(chosen);
    bar.hidden = !one;
    if (!one) return;
    name.textContent = pick(one.label);
    add.hidden = !one.listed;
    drop.hidden = !one.spare;
    kinds.choose(one);
    fields.forEach((field, i) => {
      if (document.activeElement !== field) field.value = i ? one.y : one.x;
    });
  }

  function choose(key) {
    chosen = key;
    for (const [other, button] of buttons) {
      button.tabIndex = other === key ? 0 : -1;
      button.classList.toggle("chosen", other === key);
    }
    name_();
  }

  const numbered = (one, number) => `${one.listed}.${number}`;
  const number = (one) => Number(one.key.slice(one.listed.length + 1));

  /** Puts a point into a list of points, and chooses it. */
  async function insert(like, at, [x, y]) {
    const key = numbered(like, at);
    await choosing(key, step("insert", { key, at: [short(x), short(y)] }, where));
  }

  /** Chooses what a step makes, a point or an item by its key: again once it is there, for other results may come before. */
  async function choosing(key, made) {
    const before = chosen;
    chosen = key;
    const done = await made;
    choose(done ? (shownOf(key)?.key ?? chosen) : before);
    return done;
  }

  /** Adds a point halfway to the next one; behind the last as far again as it is from the one before. */
  function addAfter(one) {
    if (!one?.listed) return;
    const at = number(one);
    const next = point(numbered(one, at + 1)) ?? (one.closed ? point(numbered(one, 1)) : null);
    const last = point(numbered(one, at - 1));
    const middle = next ? [(one.x + next.x) / 2, (one.y + next.y) / 2] : [2 * one.x - last.x, 2 * one.y - last.y];
    insert(one, at + 1, middle);
  }

  function removePoint(one) {
    if (one?.spare) step("remove", { key: one.key }, where);
  }

  /** Puts an item onto the course, and chooses it: its first point has the focus, so that keys can move it. */
  async function insertItem(key, [x, y]) {
    if (await choosing(key, step("insert", { key, at: [short(x), short(y)] }, where))) buttons.get(chosen)?.focus();
  }

  /** Adds an item of a kind: a gate halfway to the next one, start and finish on the path, others where there is room. */
  function addItem({ key, count, alone }) {
    const path = points.filter((one) => one.layer === "path");
    const end = { "course.start": path[0], "course.finish": path[0]?.closed ? path[0] : path.at(-1) }[key];
    if (alone) return insertItem(key, end ? [end.x, end.y] : [0, 0]);
    const [gates, of] = [ordered(points, key), point(chosen)?.item];
    if (key !== "course.gates" || !count) return insertItem(`${key}.${count + 1}`, roomiest(points, map.frame));
    const here = of?.startsWith(`${key}.`) ? Number(of.slice(key.length + 1)) : count;
    const [one, next, last] = [gates[here - 1], gates[here], gates[here - 2]];
    const aside = [map.frame.width / 20, 0];
    const at = one.map((value, i) => (next ? (value + next[i]) / 2 : last ? 2 * value - last[i] : value + aside[i]));
    return insertItem(`${key}.${here + 1}`, at);
  }

  async function removeItem(key) {
    const before = chosen;
    if (point(chosen)?.item === key) chosen = key;
    if (!(await step("remove", { key }, where))) choose(before);
  }

  /** Exchanges a gate with the next one; the chosen one stays the same gate. */
  async function exchange(key, chosenIs) {
    await choosing(chosenIs, step("exchange", { key }, where));
  }

  /** Adds a point, a gate or a post where the floor is clicked twice: to the line that is nearest, in its order. */
  box.addEventListener("dblclick", (event) => {
    if (!map.frame || event.target.closest("button")) return;
    const [x, y] = map.at(event.clientX, event.clientY);
    const near = NEAR * Math.abs(map.at(event.clientX + 1, event.clientY)[0] - x);
    const line = (name, places, closed = false) => ({ name, places, closed });
    const here = points.filter((one) => one.layer === layer && one.listed);
    const lists = [...new Set(here.map(({ listed }) => listed))].map((listed) => {
      const mine = here.filter((one) => one.listed === listed);
      return line(listed, mine.map((one) => [one.x, one.y]), mine[0].closed);
    });
    const found = nearest(layer === "gates" ? [line("course.gates", ordered(points, "course.gates"))] : lists, [x, y]);
    if (layer === "gates") insertItem(`course.gates.${found?.at ?? 1}`, [x, y]);
    else if (layer === "path" || found?.away < near) insert({ listed: found.name }, found.at, [x, y]);
    else insertItem(`course.posts.${ordered(points, "course.posts").length + 1}`, [x, y]);
  });

  function typed() {
    const one = point(chosen);
    const [x, y] = fields.map((field) => (field.value === "" ? NaN : Number(field.value)));
    if (!one || !Number.isFinite(x) || !Number.isFinite(y)) return name_();
    return move(one, x, y, `typed ${(gestures += 1)}`, true);
  }

  function begin(event, one) {
    if (event.button !== 0) return;
    const button = event.currentTarget;
    button.setPointerCapture(event.pointerId);
    choose(one.key);
    const [x, y] = map.at(event.clientX, event.clientY);
    drag = { key: one.key, gesture: `drag ${(gestures += 1)}`, from: [event.clientX, event.clientY], off: [one.x - x, one.y - y], moved: false };
  }

  function on(event) {
    const one = drag && point(drag.key);
    if (!one) return;
    const [right, down] = [event.clientX - drag.from[0], event.clientY - drag.from[1]];
    if (!drag.moved && Math.hypot(right, down) < 2) return;
    drag.moved = true;
    const [x, y] = map.at(event.clientX, event.clientY);
    move(one, x + drag.off[0], y + drag.off[1], drag.gesture, false);
  }

  function end() {
    if (!drag) return;
    const { key, gesture, moved } = drag;
    drag = null;
    const one = point(key);
    if (moved && one) move(one, one.x, one.y, gesture, true);
  }

  const addLike = (one) => (one.listed ? addAfter(one) : addItem(kinds.of(one)));
  const removeWhole = (one) => one.item && removeItem(one.item);
  const removeOne = (one) => (one.spare ? removePoint(one) : removeWhole(one));

  let rest = 0;
  let run = "";
  function keyed(event, one) {
    const length = event.shiftKey ? FINE : ARROW;
    const by = { ArrowLeft: [-length, 0], ArrowRight: [length, 0], ArrowUp: [0, length], ArrowDown: [0, -length] }[event.key];
    const to = { PageUp: -1, PageDown: 1 }[event.key];
    const edit = { Insert: addLike, Delete: event.shiftKey ? removeWhole : removeOne }[event.key];
    if (!by && !to && !edit) return;
    event.preventDefault();
    if (edit) return edit(one);
    if (to) {
      const keys = [...buttons.keys()];
      const next = keys[(keys.indexOf(one.key) + to + keys.length) % keys.length];
      choose(next);
      return buttons.get(next).focus();
    }
    if (!rest) run = `keys ${(gestures += 1)}`;
    clearTimeout(rest);
    move(one, one.x + by[0], one.y + by[1], run, false);
    map.reveal(one.x, one.y);
    rest = setTimeout(() => {
      rest = 0;
      change({ changes: {}, gesture: run, settled: true, where });
    }, REST);
  }

  function build() {
    const here = points.filter((one) => one.layer === layer);
    const focused = overlay.contains(document.activeElement);
    buttons.clear();
    for (const { key, item } of here) {
      const number = item.startsWith("course.gates.") && item.slice("course.gates.".length);
      const button = element("button", { type: "button", class: `handle ${layer}`, "data-key": key, "data-number": number });
      button.addEventListener("pointerdown", (event) => begin(event, point(key)));
      button.addEventListener("pointermove", on);
      button.addEventListener("pointerup", end);
      button.addEventListener("pointercancel", end);
      button.addEventListener("focus", () => {
        if (chosen !== key) choose(key);
        if (!drag) map.reveal(point(key).x, point(key).y);
      });
      button.addEventListener("keydown", (event) => keyed(event, point(key)));
      buttons.set(key, button);
    }
    overlay.replaceChildren(...buttons.values());
    // Of a point or an item that was the last of its list and was removed, the one before.
    const beside = chosen?.replace(/\d+$/, (digits) => digits - 1);
    choose((shownOf(chosen) ?? shownOf(beside) ?? here[0])?.key ?? null);
    if (focused) buttons.get(chosen)?.focus();
    here.forEach(set);
  }

  function layered() {
    kinds.layer(layer);
    layers.replaceChildren(
      ...Object.keys(LAYERS).map((code) => {
        const button = element("button", { type: "button", "aria-pressed": String(code === layer), text: LAYERS[code] });
        button.addEventListener("click", () => {
          layer = code;
          layered();
          build();
        });
        return button;
      }),
    );
  }

  translated(() => {
    points.forEach(set);
    name_();
  });

  map.listen("handles", () => {
    overlay.dataset.aspect = String(map.frame.width / map.frame.height);
    points.forEach(set);
  });

  return {
    show(state) {
      const keys = (list) => list.map(({ key }) => key).join();
      const same = keys(points) === keys(state.points);
      const dragged = drag && point(drag.key);
      points = state.points.map((one) => (dragged && one.key === drag.key ? { ...one, x: dragged.x, y: dragged.y } : one));
      kinds.show(state.kinds);
      if (!layers.children.length) layered();
      if (!same || !buttons.has(chosen)) build();
      points.forEach(set);
      name_();
    },
    /** Takes another drawing of the floor; amid a move it keeps the frame of the one before. */
    ground(stage) {
      const old = box.querySelector("#course-view");
      if (old) old.replaceWith(stage);
      else box.prepend(stage);
      map.take(stage, Boolean(drag));
    },
  };
}
