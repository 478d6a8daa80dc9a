// The numbers of the design: a field with the range of the schema and a slider with a range about the number.
const { both, element, say } = globalThis.cadgenPage;

const OPEN = matchMedia("(max-width: 1080px)").matches ? 0 : 2; // groups that are open at first

/** Fills a box with groups of controls; returns a function that shows a state. */
export function controls(box, change) {
  const list = element("div", { id: "controls" });
  box.append(element("h2", { text: both("Change the design") }), list);
  let keys = "";
  let made = new Map();

  function build(groups) {
    const open = new Map([...list.children].map((group) => [group.dataset.code, group.open]));
    made = new Map();
    list.replaceChildren(
      ...groups.map(({ code, label, controls: inside }, i) =>
        element(
          "details",
          { "data-code": code, open: open.get(code) ?? i < OPEN },
          element("summary", { text: label }),
          ...inside.map((control) => {
            const one = new Control(control, change);
            made.set(control.key, one);
            return one.node;
          }),
        ),
      ),
    );
  }

  return {
    show({ groups }) {
      const now = groups.flatMap(({ controls: inside }) => inside.map(({ key }) => key)).join();
      if (now !== keys) build(groups);
      keys = now;
      for (const group of groups) for (const control of group.controls) made.get(control.key).show(control);
    },
  };
}

let gestures = 0;

class Control {
  constructor(control, change) {
    const { key, label, unit, meaning, whole } = control;
    const id = `control-${key.replaceAll(".", "-")}`;
    this.key = key;
    this.change = change;
    this.gesture = "";
    this.held = false;
    const named = label.map((name) => (unit ? `${name}, ${unit}` : name));
    this.number = element("input", { type: "number", id, step: whole ? 1 : "any", inputmode: "decimal" });
    this.slider = element("input", { type: "range", label: named });
    this.fault = element("p", { class: "fault", role: "alert" });
    this.node = element(
      "div",
      { class: "control", "data-key": key },
      element("label", { for: id, title: meaning }, element("span", { text: label }), " ", element("small", {}, unit === "degrees" ? "°" : unit)),
      this.number,
      this.slider,
      this.fault,
    );
    this.slider.addEventListener("input", () => {
      if (!this.held) this.gesture = `${key} ${(gestures += 1)}`;
      this.held = true;
      this.number.value = this.slider.value;
      this.send(this.slider.value, false);
    });
    this.slider.addEventListener("change", () => {
      this.held = false;
      this.send(this.slider.value, true);
    });
    // What is being typed stays, whatever arrives meanwhile.
    this.typing = false;
    this.number.addEventListener("input", () => (this.typing = true));
    this.number.addEventListener("change", () => {
      this.typing = false;
      this.gesture = `${key} ${(gestures += 1)}`;
      if (this.number.value !== "") this.send(this.number.value, true);
      else this.show(this.control);
    });
  }

  send(text, settled) {
    this.change({
      changes: { [this.key]: Number(text) },
      gesture: this.gesture,
      settled,
      where: (sentence) => {
        say(this.fault, sentence);
        this.node.closest("details").open = true;
        return () => say(this.fault);
      },
    });
  }

  show(control) {
    this.control = control;
    if (this.held) return;
    const { value, low, high, step, least, most } = control;
    for (const [name, bound] of [["min", least], ["max", most]]) {
      if (bound === null) this.number.removeAttribute(name);
      else this.number[name] = bound;
    }
    Object.assign(this.slider, { min: low, max: high, step });
    this.slider.value = value;
    if (!this.typing && this.number.value !== String(value)) this.number.value = value;
  }
}
