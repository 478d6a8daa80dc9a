// Points on the course that can be dragged: buttons above the drawing, each at its place.
const { element, pick, shapeStages, translated } = globalThis.cadgenPage;

const FARTHEST = 1e6; // mm, as of the schema
const [ARROW, FINE] = [10, 1]; // mm, of an arrow key
const REST = 350; // ms after the last key until the whole is computed
const LAYERS = { path: ["Path", "路径"], gates: ["Gates", "赛道门"], posts: ["Posts, walls, zones, field", "立柱、墙、禁区、场地"] };

export function handles(figure, change, step) {
  const box = figure.querySelector("#course-box");
  const overlay = element("div", { class: "stage", id: "handles", role: "group", label: ["Points that can be moved", "可移动的点"] });
  box.append(overlay);
  const layers = element("div", { class: "layers", role: "group", label: ["Points to move", "要移动的点"] });
  const fields = ["x", "y"].map((axis) => {
    const input = element("input", { type: "number", step: "any", "data-axis": axis, label: [`${axis}, mm`, `${axis}，mm`] });
    input.addEventListener("change", () => typed());
    return input;
  });
  const name = element("b", { id: "point-name" });
  const fault = element("p", { class: "fault", role: "alert" });
  const [add, drop] = [
    element("button", { type: "button", id: "add-point", text: ["Add a point", "添加点"], label: ["Add a point after this one (Insert)", "在此点后添加点（Insert）"] }),
    element("button", { type: "button", id: "remove-point", text: ["Remove", "删除"], label: ["Remove this point (Delete)", "删除此点（Delete）"] }),
  ];
  add.addEventListener("click", () => addAfter(point(chosen)));
  drop.addEventListener("click", () => remove(point(chosen)));
  const bar = element("div", { id: "point-bar" }, name, " x ", fields[0], " y ", fields[1], element("small", {}, "mm"), add, drop);
  const help = element("p", {
    class: "hint",
    text: [
      "Drag a point, or move it by the arrow keys (10 mm, with Shift 1 mm); Page Up and Page Down choose another. A double click beside the points of the path adds one, Delete removes the chosen one.",
      "拖动点，或用方向键移动（10 mm，按住 Shift 为 1 mm）；Page Up 和 Page Down 切换点。在路径点旁双击可添加点，按 Delete 删除所选的点。",
    ],
  });
  box.after(layers, bar, fault, help);

  let points = [];
  let layer = "path";
  let chosen = null; // key
  let drag = null;
  let frame = null;
  let gestures = 0;
  const buttons = new Map();

  const where = (sentence) => {
    fault.textContent = sentence;
    return () => (fault.textContent = "");
  };
  const short = (value) => Number(value.toFixed(1));
  const point = (key) => points.find((one) => one.key === key);
  const move = (one, x, y, gesture, settled) => {
    one.x = Math.max(-FARTHEST, Math.min(FARTHEST, short(x)));
    one.y = Math.max(-FARTHEST, Math.min(FARTHEST, short(y)));
    set(one);
    name_();
    change({ changes: { [one.key]: [one.x, one.y] }, gesture, settled, where });
  };

  function set(one) {
    const button = buttons.get(one.key);
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
    add.hidden = drop.hidden = !one.listed;
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
    const [before, key] = [chosen, numbered(like, at)];
    chosen = key;
    if (!(await step("insert", { key, at: [short(x), short(y)] }, where))) choose(before);
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

  function remove(one) {
    if (one?.listed) step("remove", { key: one.key }, where);
  }

  /** Adds a point where the floor is clicked twice: between the two points of its list whose line is nearest. */
  box.addEventListener("dblclick", (event) => {
    if (!frame || event.target.closest(".handle")) return;
    const { left, top, width, height } = overlay.getBoundingClientRect();
    const x = frame.left + ((event.clientX - left) / width) * frame.width;
    const y = frame.top - ((event.clientY - top) / height) * frame.height;
    let nearest = null;
    for (const one of points.filter((each) => each.layer === layer && each.listed)) {
      const next = point(numbered(one, number(one) + 1)) ?? (one.closed ? point(numbered(one, 1)) : null);
      if (!next) continue;
      const [dx, dy] = [next.x - one.x, next.y - one.y];
      const along = ((x - one.x) * dx + (y - one.y) * dy) / (dx * dx + dy * dy || 1);
      const t = Math.max(0, Math.min(1, along));
      const away = Math.hypot(x - one.x - t * dx, y - one.y - t * dy);
      if (nearest && away >= nearest.away) continue;
      const [first, last] = [number(one) === 1 && !one.closed && along < 0, !one.closed && along > 1 && !point(numbered(one, number(one) + 2))];
      nearest = { one, away, at: number(one) + (first ? 0 : last ? 2 : 1) };
    }
    if (nearest) insert(nearest.one, nearest.at, [x, y]);
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
    const { width, height } = overlay.getBoundingClientRect();
    drag = { key: one.key, gesture: `drag ${(gestures += 1)}`, from: [event.clientX, event.clientY], at: [one.x, one.y], scale: [frame.width / width, frame.height / height], moved: false };
  }

  function on(event) {
    const one = drag && point(drag.key);
    if (!one) return;
    const [right, down] = [event.clientX - drag.from[0], event.clientY - drag.from[1]];
    if (!drag.moved && Math.hypot(right, down) < 2) return;
    drag.moved = true;
    move(one, drag.at[0] + right * drag.scale[0], drag.at[1] - down * drag.scale[1], drag.gesture, false);
  }

  function end() {
    if (!drag) return;
    const { key, gesture, moved } = drag;
    drag = null;
    const one = point(key);
    if (moved && one) move(one, one.x, one.y, gesture, true);
  }

  let rest = 0;
  let run = "";
  function keyed(event, one) {
    const length = event.shiftKey ? FINE : ARROW;
    const by = { ArrowLeft: [-length, 0], ArrowRight: [length, 0], ArrowUp: [0, length], ArrowDown: [0, -length] }[event.key];
    const to = { PageUp: -1, PageDown: 1 }[event.key];
    const edit = { Insert: addAfter, Delete: remove }[event.key];
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
    rest = setTimeout(() => {
      rest = 0;
      change({ changes: {}, gesture: run, settled: true, where });
    }, REST);
  }

  function build() {
    const here = points.filter((one) => one.layer === layer);
    const focused = overlay.contains(document.activeElement);
    buttons.clear();
    for (const { key } of here) {
      const button = element("button", { type: "button", class: `handle ${layer}`, "data-key": key });
      button.addEventListener("pointerdown", (event) => begin(event, point(key)));
      button.addEventListener("pointermove", on);
      button.addEventListener("pointerup", end);
      button.addEventListener("pointercancel", end);
      button.addEventListener("focus", () => chosen !== key && choose(key));
      button.addEventListener("keydown", (event) => keyed(event, point(key)));
      buttons.set(key, button);
    }
    overlay.replaceChildren(...buttons.values());
    // Of a point that was the last of its list and was removed, the one before.
    const beside = chosen?.replace(/\d+$/, (digits) => digits - 1);
    choose([chosen, beside].find((key) => buttons.has(key)) ?? here[0]?.key ?? null);
    if (focused) buttons.get(chosen)?.focus();
    here.forEach(set);
  }

  function layered() {
    const known = Object.keys(LAYERS).filter((code) => points.some((one) => one.layer === code));
    if (!known.includes(layer)) [layer] = known;
    layers.replaceChildren(
      ...known.map((code) => {
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

  return {
    show(state) {
      const keys = (list) => list.map(({ key }) => key).join();
      const same = keys(points) === keys(state.points);
      const dragged = drag && point(drag.key);
      points = state.points.map((one) => (dragged && one.key === drag.key ? { ...one, x: dragged.x, y: dragged.y } : one));
      if (!same) {
        layered();
        build();
      }
      points.forEach(set);
      name_();
    },
    /** Takes another drawing of the floor; amid a move it keeps the frame of the one before. */
    ground(stage) {
      const old = box.querySelector("#course-view");
      if (old && drag) {
        Object.assign(stage.dataset, { left: old.dataset.left, top: old.dataset.top, width: old.dataset.width, height: old.dataset.height, aspect: old.dataset.aspect });
        stage.querySelector("svg").setAttribute("viewBox", old.querySelector("svg").getAttribute("viewBox"));
      }
      if (old) old.replaceWith(stage);
      else box.prepend(stage);
    },
    /** Sets every point where the drawing has it. */
    place() {
      const stage = box.querySelector("#course-view");
      if (!stage) return;
      const { left, top, width, height, aspect } = stage.dataset;
      frame = { left: Number(left), top: Number(top), width: Number(width), height: Number(height) };
      overlay.dataset.aspect = aspect;
      shapeStages();
      points.forEach(set);
    },
  };
}
