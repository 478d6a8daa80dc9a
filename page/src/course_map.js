// The course map: which part of the floor it shows, by wheel, drag on empty ground, touch, keys and buttons.
import { both, element, pick, translated } from "./words.js";
import { shapeStages } from "./views.js";

const MOST = 40; // times as near as the whole course
const STEP = 1.4; // nearer or farther, of a button or a key
const SLACK = 3; // px that a pointer moves before it drags the map
const SHARE = 0.1; // of the picture, that an arrow key moves it
const WHEEL = 0.0016; // of the logarithm of the distance, by px of the wheel
const LINE = 30; // px of a line of the wheel

/** The map; null on a page without a course. Frames are left, top, width, height on the floor, mm, y upwards. */
export function courseMap() {
  const box = document.getElementById("course-box");
  if (!box) return null;
  const listeners = new Map();
  const pointers = new Map(); // on the ground, by their numbers
  let stage = null;
  let whole = null; // frame of all
  let view = null; // middle and width of what is shown, mm; null shows all
  let printing = false;
  let dragging = false;

  /** Width and height within the border, px. */
  const inside = () => {
    const { width, height } = box.getBoundingClientRect();
    return [Math.max(width - 2 * box.clientLeft, 1), Math.max(height - 2 * box.clientTop, 1)];
  };
  const ratio = () => inside()[0] / inside()[1];
  const widest = () => Math.max(whole.width, whole.height * ratio());

  function frame() {
    if (!whole || !view || printing) return whole;
    const height = view.width / ratio();
    return { left: view.x - view.width / 2, top: view.y + height / 2, width: view.width, height };
  }

  /** Keeps the view on the course, and shows all where that is as near. */
  function limit() {
    if (!view) return;
    if (view.width > 0.999 * widest()) view = null;
    if (!view) return;
    const [high, across, up] = [view.width / ratio(), whole.left + whole.width / 2, whole.top - whole.height / 2];
    const within = (value, middle, room) => (room > 0 ? Math.min(Math.max(value, middle - room), middle + room) : middle);
    view.x = within(view.x, across, (whole.width - view.width) / 2);
    view.y = within(view.y, up, (whole.height - high) / 2);
  }

  function apply() {
    if (!stage || !whole) return;
    limit();
    const { left, top, width, height } = frame();
    stage.querySelector("svg").setAttribute("viewBox", `${left} ${-top} ${width} ${height}`);
    stage.dataset.aspect = String(width / height);
    box.classList.toggle("zoomed", Boolean(view));
    for (const listener of listeners.values()) listener();
    shapeStages();
  }

  /** Place on the floor under a place on the screen, mm. */
  function at(clientX, clientY) {
    const { left, top, width, height } = stage.getBoundingClientRect();
    const shown = frame();
    return [shown.left + ((clientX - left) / width) * shown.width, shown.top - ((clientY - top) / height) * shown.height];
  }

  /** Brings the map nearer by a factor; the place on the screen stays where it is on the floor. */
  function zoom(factor, clientX, clientY) {
    if (!stage || !whole) return;
    const rect = box.getBoundingClientRect();
    const [midX, midY] = [rect.left + rect.width / 2, rect.top + rect.height / 2];
    const [x, y] = at(clientX ?? midX, clientY ?? midY);
    const width = Math.min(Math.max((view?.width ?? widest()) / factor, widest() / MOST), widest());
    const scale = width / inside()[0]; // mm by px
    view = { x: x - ((clientX ?? midX) - midX) * scale, y: y + ((clientY ?? midY) - midY) * scale, width };
    apply();
  }

  /** Moves the map with the pointer, px. */
  function pan(right, down) {
    if (!view) return;
    const scale = view.width / inside()[0];
    view = { ...view, x: view.x - right * scale, y: view.y + down * scale };
    apply();
  }

  function fit() {
    view = null;
    apply();
  }

  const ground = (event) => !event.target.closest?.("button");

  box.addEventListener("wheel", (event) => {
    if (!view && event.deltaY > 0) return; // all is shown: the page scrolls on
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 0 ? 1 : LINE);
    zoom(Math.exp(-WHEEL * pixels * (event.ctrlKey ? 5 : 1)), event.clientX, event.clientY);
  }, { passive: false });

  box.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !ground(event)) return;
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    dragging = pointers.size > 1;
  });
  box.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
    if (pointers.size === 1 && !dragging) {
      if (!view || Math.hypot(right, down) < SLACK) return;
      dragging = true;
      box.setPointerCapture(event.pointerId);
    }
    const old = [...pointers.values()];
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (pointers.size === 1) return void pan(right, down);
    const now = [...pointers.values()];
    const middle = (places) => [0, 1].map((i) => (places[0][i] + places[1][i]) / 2);
    const apart = (places) => Math.max(Math.hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]), 1);
    const [[x0, y0], [x1, y1]] = [middle(old), middle(now)];
    zoom(apart(now) / apart(old), x0, y0);
    pan(x1 - x0, y1 - y0);
  });
  for (const name of ["pointerup", "pointercancel"]) box.addEventListener(name, (event) => pointers.delete(event.pointerId));
  // Two fingers are for the map, and not for the page.
  box.addEventListener("touchstart", (event) => event.touches.length > 1 && event.preventDefault(), { passive: false });

  box.tabIndex = 0;
  box.setAttribute("role", "group");
  const words = both("The course from above. Plus and minus bring it nearer or farther, arrow keys move it, 0 shows all.");
  translated(() => box.setAttribute("aria-label", pick(words)));
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [right, down] = inside().map((length) => SHARE * length);
    const zooming = { "+": () => zoom(STEP), "=": () => zoom(STEP), "-": () => zoom(1 / STEP), 0: fit };
    const moving = {
      ArrowLeft: () => pan(right, 0),
      ArrowRight: () => pan(-right, 0),
      ArrowUp: () => pan(0, down),
      ArrowDown: () => pan(0, -down),
    };
    const act = zooming[event.key] ?? (event.target === box && view ? moving[event.key] : undefined);
    if (!act) return;
    event.preventDefault();
    act();
  });

  const button = (id, text, label, act) => {
    const made = element("button", { type: "button", id, label }, text);
    made.title = pick(label);
    made.addEventListener("click", act);
    return made;
  };
  box.before(
    element(
      "div",
      { class: "map-tools", role: "group", label: both("Part of the course that is shown") },
      button("map-nearer", "+", both("Nearer (+)"), () => zoom(STEP)),
      button("map-farther", "−", both("Farther (−)"), () => zoom(1 / STEP)),
      button("map-fit", "⤢", both("Show all (0)"), fit),
    ),
  );
  new ResizeObserver(apply).observe(box);

  return {
    get frame() {
      return frame();
    },
    at,
    /** Calls a function after each change of the frame; another one of the same name takes its place. */
    listen(name, listener) {
      listeners.set(name, listener);
      if (whole) listener();
    },
    /** Takes a drawing of the floor; what is shown stays, also of the whole where that is held. */
    take(drawn, held = false) {
      stage = drawn;
      const { left, top, width, height } = Object.fromEntries(Object.entries(drawn.dataset).map(([key, value]) => [key, Number(value)]));
      if (!held || !whole) whole = { left, top, width, height };
      apply();
    },
    /** Brings a place into the picture, mm. */
    reveal(x, y) {
      if (!view) return;
      const { left, top, width, height } = frame();
      const [across, down] = [(x - left) / width, (top - y) / height];
      if (Math.min(across, down) > 0.03 && Math.max(across, down) < 0.97) return;
      view = { ...view, x, y };
      apply();
    },
    print(on) {
      printing = on;
      apply();
    },
  };
}
