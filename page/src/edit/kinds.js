// Buttons that add a post, a wall, a zone, a gate, and that remove the chosen one or move a gate in the order.
const { both, element, pick, translated } = globalThis.cadgenPage;

/** The row of what can be added, and the buttons of the chosen item beside its point. */
export function kindsBar({ add, remove, exchange }) {
  const node = element("div", { class: "layers", id: "kinds", role: "group", label: both("Add to the course") });
  const make = (id, text, label, run) => {
    const button = element("button", { type: "button", id, text, label });
    button.addEventListener("click", run);
    return button;
  };
  let all = [];
  let layer = "path";
  let one = null; // the chosen point
  const number = () => Number(one.item.split(".")[2]);
  const gate = (n) => `course.gates.${n}`;
  const drop = make("remove-item", both("Remove"), undefined, () => remove(one.item));
  const earlier = make("earlier", both("Earlier"), both("Earlier in the order of the gates"), () =>
    exchange(gate(number() - 1), gate(number() - 1)),
  );
  const later = make("later", both("Later"), both("Later in the order of the gates"), () => exchange(gate(number()), gate(number() + 1)));

  function build() {
    const here = all.filter((kind) => kind.layer === layer);
    node.hidden = !here.length;
    const focused = node.contains(document.activeElement) && document.activeElement.dataset.kind;
    node.replaceChildren(
      ...here.map((kind) => {
        const there = kind.alone && kind.count;
        const what = kind.label;
        const text = there ? both("Remove the {what}", { what }) : both("Add a {what}", { what });
        const button = element("button", { type: "button", "data-kind": kind.key, text });
        button.addEventListener("click", () => (there ? remove(kind.key) : add(kind)));
        return button;
      }),
    );
    if (focused) node.querySelector(`[data-kind="${focused}"]`)?.focus();
  }

  function choose(point) {
    one = point;
    const kind = of(one);
    const isGate = one.item.startsWith("course.gates.");
    drop.hidden = !one.item;
    earlier.hidden = later.hidden = !isGate;
    if (!kind) return;
    const text = kind.alone ? kind.label : kind.label.map((word) => `${word} ${number()}`);
    drop.textContent = pick(both("Remove the {what}", { what: kind.label }));
    drop.setAttribute("aria-label", pick(both("Remove {what} ({key})", { what: text, key: one.spare ? "Shift+Delete" : "Delete" })));
    if (isGate) [earlier.disabled, later.disabled] = [number() === 1, number() === kind.count];
  }

  const of = (point) => all.find(({ key }) => point.item === key || point.item.startsWith(`${key}.`));
  translated(() => one && choose(one));

  return {
    node,
    ofItem: [earlier, later, drop],
    of,
    choose,
    layer: (code) => {
      layer = code;
      build();
    },
    show: (kinds) => {
      const same = JSON.stringify(kinds) === JSON.stringify(all);
      all = kinds;
      if (!same) build();
    },
  };
}
