// Slider, button and keys that set the cam angle; one state for everything that moves.
import { both, element, pick, translated } from "./words.js";

const TURN = 360;
const SECONDS = 24; // of a turn at speed 1
const QUIET = 700; // ms without a change until a screen reader is told

export const MANY = 16; // peaks and valleys, whose triangles would stand in one another

const plain = (value, digits) => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");

/** The bar; `use` gives it a model to move, and later another one at the same angle. */
export function transport() {
  const bar = document.getElementById("transport");
  const [slider, shown, now, live, button, options] = ["angle", "angle-now", "now", "live", "go", "options"].map((id) =>
    document.getElementById(id),
  );
  const state = { angle: 0, playing: false, play: true, speed: 1 };
  const listeners = new Map();
  let motion = null;
  let alone = false; // gears without a cam
  let fields = [];
  let values = [];

  const speed = element("select", { label: both("Speed") });
  for (const value of [0.1, 0.25, 0.5, 1, 2, 4]) speed.append(element("option", { value, selected: value === 1 }, `${value}×`));
  speed.addEventListener("change", () => (state.speed = Number(speed.value)));
  const box = element("input", { type: "checkbox", checked: true, id: "with-play" });
  box.addEventListener("change", () => {
    state.play = box.checked;
    changed();
  });
  const withPlay = element("label", { class: "switch" }, box, element("span", { text: both("with play") }));
  options.append(speed);

  const strip = document.getElementById("marks");
  const names = { peak: both("peak"), valley: both("valley"), blend: both("blend") };
  let titles = [];
  translated(() => titles.forEach(([mark, kind, degrees]) => (mark.title = `${pick(names[kind])} ${degrees.toFixed(1)}°`)));

  function use(model, marks) {
    motion = model;
    bar.hidden = false;
    if (motion.withPlay) options.prepend(withPlay);
    else withPlay.remove();
    titles = marks.map(({ kind, angle }) => {
      const degrees = (angle * 180) / Math.PI;
      const mark = element("i", { class: kind });
      mark.style.left = `${(degrees / TURN) * 100}%`;
      if (kind === "blend") mark.style.width = `${100 - (degrees / TURN) * 100}%`;
      mark.title = `${pick(names[kind])} ${degrees.toFixed(1)}°`;
      return [mark, kind, degrees];
    });
    strip.replaceChildren(...titles.map(([mark]) => mark));
    strip.classList.toggle("many", marks.length > MANY);
    const { car, unit, drive, shafts, wheels } = motion.scene;
    alone = wheels.length > 0;
    const degrees = (rad) => `${plain((rad * 180) / Math.PI, 2)}°`;
    fields = [
      ["lift", both("lift"), (s) => `${plain(s.lift, 3)} mm`, unit !== "rad" && !alone],
      ["swing", both("swing"), (s) => degrees(s.tan), unit === "rad"],
      ["steer", both("steering"), (s) => degrees(car.steering * Math.atan(s.tan)), car],
      ["pressure", both("pressure angle"), (s) => `${plain(s.pressure, 1)}°`, motion.pressure],
      ["drive", both("turn of the drive"), (s) => degrees(-shafts[drive].rate * s.phi), alone],
      ["run", both("distance run"), (s) => `${(s.run / 1000).toFixed(2)} m`, car],
      ["off", both("off the plan"), (s) => `${s.off.toFixed(1)} mm`, motion.goings.planned],
    ].filter(([, , , shown]) => shown);
    now.replaceChildren();
    values = fields.map(([code, label]) => {
      const value = element("b");
      now.append(element("span", { class: code }, element("small", { text: label }), value));
      return value;
    });
  }

  let quiet = 0;
  function changed() {
    if (!motion) return;
    const current = motion.state((state.angle * Math.PI) / 180, state.play);
    const text = `${state.angle.toFixed(1)}°`;
    if (shown.value !== text) shown.value = text;
    if (Number(slider.value) !== state.angle) slider.value = state.angle;
    slider.setAttribute("aria-valuetext", text);
    fields.forEach(([, , format], i) => {
      const value = format(current);
      if (values[i].textContent !== value) values[i].textContent = value;
    });
    for (const listener of listeners.values()) listener(current);
    clearTimeout(quiet);
    if (!state.playing) quiet = setTimeout(() => tell(current), QUIET);
  }

  function tell(current) {
    const words = [`${pick(alone ? both("angle of the output") : both("cam angle"))} ${shown.value}`];
    for (const [i, [, label]] of fields.entries()) words.push(`${pick(label)} ${fields[i][2](current)}`);
    live.textContent = words.join(pick(both(", ")));
  }

  function set(angle) {
    state.angle = Math.min(Math.max(angle, 0), TURN);
    changed();
  }

  function playing(on) {
    state.playing = on;
    button.setAttribute("aria-pressed", String(on));
    button.querySelector("path").setAttribute("d", on ? "M6 4h4v16H6zM14 4h4v16h-4z" : "M7 4l13 8-13 8z");
    if (on && state.angle >= TURN) state.angle = 0;
    api.wake?.();
    changed();
  }

  slider.addEventListener("input", () => {
    if (state.playing) playing(false);
    set(Number(slider.value));
  });
  button.addEventListener("click", () => playing(!state.playing));
  document.addEventListener("keydown", (event) => {
    const { target } = event;
    const busy = target.closest?.("button, select, summary, a, [type=checkbox]");
    if (event.key === " " && !busy && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      playing(!state.playing);
    }
  });

  const api = {
    state,
    use,
    set,
    changed,
    /** Calls a function with each state; another one of the same name takes its place. */
    listen: (name, listener) => listeners.set(name, listener),
    /** Moves on by so many milliseconds; true as long as it plays. */
    step(milliseconds) {
      if (!state.playing) return false;
      const next = state.angle + (state.speed * TURN * milliseconds) / (SECONDS * 1000);
      if (next >= TURN) {
        state.angle = TURN;
        playing(false);
        return false;
      }
      set(next);
      return true;
    },
  };
  return api;
}
