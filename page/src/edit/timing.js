// The timing diagram of a cam by its motion: ends of segments and heights are dragged, laws chosen from a list, segments
// put in, taken out and moved in their order.
const { both, element, pick, say, translated } = globalThis.cadgenPage;

const [ANGLE, FINE_ANGLE] = [1, 0.1]; // degrees, of an arrow key
const [HEIGHT, FINE_HEIGHT] = [1, 0.1]; // mm or degrees
const RISE = 0.1; // of the greatest height: so far a rise leads that is put in
const LEAST = 0.5; // degrees that a segment keeps
const REST = 350; // ms after the last key until the whole is computed
const ROOM = 0.18; // of the range, above the greatest height: so far it can be dragged at once
const DIGITS = 9; // of what is sent: sums of decimals show no rounding

const round = (value, step) => Number((Math.round(value / step) * step).toFixed(DIGITS));
const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

export function timing(figure, change, step) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 360 100");
  svg.setAttribute("preserveAspectRatio", "none");
  svg.setAttribute("aria-hidden", "true");
  const plot = element("div", { id: "timing-plot", role: "group", label: both("Ends of segments that can be moved") }, svg);
  const table = element("div", { id: "timing-rows" });
  const fault = element("p", { class: "fault", role: "alert" });
  const help = element("p", { class: "hint" });
  figure.append(element("div", { id: "timing-box", class: "view" }, plot), table, fault, help);

  let now = null; // timing of the state
  let values = null; // of the curve, over a turn of the cam
  let range = [0, 1];
  let drag = null;
  let gestures = 0;
  let rest = 0;
  let rows = "";
  const buttons = new Map(); // by the number of the segment that ends there
  const where = (sentence) => {
    say(fault, sentence);
    return () => say(fault);
  };

  const x = (angle) => (100 * angle) / now.turn;
  const y = (height) => (100 * (range[1] - height)) / (range[1] - range[0]);

  /** Moves the end of a segment by an angle and a height from where a gesture began, and sends it. */
  function move(begun, angle, height, settled) {
    const { segment, next, gesture } = begun;
    const low = segment.start + LEAST - segment.stop;
    const high = next.stop - LEAST - segment.stop;
    const along = segment.along.length ? round(clamp(angle, Math.min(low, 0), Math.max(high, 0)), FINE_ANGLE) : 0;
    const up = segment.up.length ? round(height, begun.step) : 0;
    begun.moved = [begun.moved[0] || along !== 0, begun.moved[1] || up !== 0];
    const changes = {};
    if (begun.moved[0]) for (const { key, value, sign } of segment.along) changes[key] = Number((value + sign * along).toFixed(DIGITS));
    if (begun.moved[1]) for (const { key, value, sign } of segment.up) changes[key] = Number((value + sign * up).toFixed(DIGITS));
    place(segment.number, segment.stop + along, segment.after + up);
    if (begun.moved[0] || begun.moved[1]) change({ changes, gesture, settled, where });
  }

  /** What a gesture begins with: the numbers as they are then. */
  function begin(number) {
    const segment = now.segments[number - 1];
    const size = Math.max(range[1] - range[0], 1e-9);
    // A hundredth of what is seen, in a round step: 0.1 of 10 mm.
    const step = 10 ** Math.floor(Math.log10(size / 50));
    return { segment, next: now.segments[number], gesture: `timing ${number} ${(gestures += 1)}`, step, moved: [false, false] };
  }

  function place(number, angle, height) {
    const button = buttons.get(number);
    if (!button) return;
    button.style.left = `${x(angle)}%`;
    button.style.top = `${clamp(y(height), -6, 106)}%`;
    const said = both("end of segment {number}: {angle}°, {height} {unit}", { number, angle: round(angle, 1e-3), height: round(height, 1e-3), unit: now.unit });
    button.dataset.said = JSON.stringify(said);
    button.setAttribute("aria-label", pick(said));
  }

  function handle(number) {
    const button = element("button", { type: "button", class: "handle timing", "data-number": number });
    button.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      event.preventDefault();
      button.focus();
      button.setPointerCapture(event.pointerId);
      drag = { ...begin(number), from: [event.clientX, event.clientY], last: [0, 0] };
    });
    button.addEventListener("pointermove", (event) => {
      if (!drag) return;
      const box = plot.getBoundingClientRect();
      const angle = ((event.clientX - drag.from[0]) / box.width) * now.turn;
      const height = ((drag.from[1] - event.clientY) / box.height) * (range[1] - range[0]);
      drag.last = [angle, height];
      move(drag, angle, height, false);
    });
    const end = () => {
      const done = drag;
      drag = null;
      if (done && (done.moved[0] || done.moved[1])) move(done, ...done.last, true);
      else if (done) draw();
    };
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
    let held = null;
    button.addEventListener("keydown", (event) => {
      const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [];
      if (dx === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      held ??= { ...begin(number), step: FINE_HEIGHT, sum: [0, 0] };
      held.sum[0] += dx * (event.shiftKey ? FINE_ANGLE : ANGLE);
      held.sum[1] += dy * (event.shiftKey ? FINE_HEIGHT : HEIGHT);
      move(held, ...held.sum, false);
      clearTimeout(rest);
      rest = setTimeout(() => {
        const done = held;
        held = null;
        if (done) move(done, ...done.sum, true);
      }, REST);
    });
    return button;
  }

  /** Buttons of a segment: a dwell or a rise behind it, which takes half of its angle, its place in the order, its end. */
  function deeds(number) {
    const key = (n) => `motion.segments.${n}`;
    const button = (act, text, label, run) => {
      const made = element("button", { type: "button", [`data-${act}`]: number, text, label });
      made.addEventListener("click", async () => {
        if (await run()) table.querySelector(`[data-width="${Math.min(number, now.segments.length)}"]`)?.focus();
      });
      return made;
    };
    const put = (share) => {
      const { start, stop, after } = now.segments[number - 1];
      const size = Math.max(...now.segments.map((each) => each.after)) - Math.min(0, ...now.segments.map((each) => each.after));
      return step("insert", { key: key(number + 1), at: [round((stop - start) / 2, FINE_ANGLE), round(after + share * size, 10 ** -DIGITS)] }, where);
    };
    const rise = button("rise", both("+ rise"), both("segment {number}: put a rise behind it", { number }), () => put(RISE));
    rise.disabled = !now.segments.slice(number).some(({ law }) => law); // the motion closes before
    const later = button("later", both("later"), both("segment {number}: exchange it with the next one", { number }), () => step("exchange", { key: key(number) }, where));
    later.disabled = number === now.segments.length;
    return element(
      "span",
      { class: "deeds" },
      button("dwell", both("+ dwell"), both("segment {number}: put a dwell behind it", { number }), () => put(0)),
      rise,
      later,
      button("remove", both("remove"), both("segment {number}: take it out", { number }), () => step("remove", { key: key(number) }, where)),
    );
  }

  /** A row for each segment: its law, the angle that it takes, and the height at its end. */
  function build() {
    buttons.clear();
    plot.querySelectorAll(".handle").forEach((node) => node.remove());
    const last = now.segments.length;
    for (const { number } of now.segments.slice(0, -1)) {
      buttons.set(number, handle(number));
      plot.append(buttons.get(number));
    }
    table.replaceChildren(
      ...now.segments.map((segment) => {
        const { number, law, law_key: key } = segment;
        const named = both("segment {number}", { number });
        const width = element("input", { type: "number", step: "any", "data-width": number, label: both("segment {number}: angle, °", { number }) });
        width.addEventListener("change", () => {
          const { start, stop } = now.segments[number - 1];
          const wider = Number(width.value) - (stop - start);
          // The last one begins later, the others end later.
          if (width.value !== "" && last > 1) move(begin(Math.min(number, last - 1)), number === last ? -wider : wider, 0, true);
          else draw();
        });
        const height = element("input", { type: "number", step: "any", "data-height": number, label: both("segment {number}: height at its end, {unit}", { number, unit: now.unit }) });
        height.disabled = !law || !segment.up.length;
        height.addEventListener("change", () => {
          const by = Number(height.value) - now.segments[number - 1].after;
          if (height.value !== "") move({ ...begin(number), next: now.segments[number] ?? segment, step: 10 ** -DIGITS }, 0, by, true);
          else draw();
        });
        let choice = element("span", { text: both("dwell") });
        if (law) {
          choice = element("select", { "data-law": number, label: both("segment {number}: law", { number }) }, ...now.laws.map((code) => new Option(code, code)));
          choice.addEventListener("change", () =>
            change({ changes: { [key]: choice.value }, gesture: `law ${(gestures += 1)}`, settled: true, where }),
          );
        }
        return element("div", { class: "row" }, element("b", { text: named }), choice, element("label", {}, width, "°"), element("label", {}, height, now.unit), deeds(number));
      }),
    );
    say(help, now.segments.length
      ? both("Drag the end of a segment, or move it by the arrow keys (1° or 1 {unit}, with Shift 0.1): the next segment takes up the angle. A height that closes the motion stays. A new segment takes half of the angle of the one before it.", { unit: now.unit })
      : both("This motion is given by points, harmonics or a table: change them in a text editor, and open the design again."));
  }

  function draw() {
    if (!now) return;
    const heights = [0, ...now.segments.map(({ after }) => after), ...(values ?? [])];
    const [low, high] = [Math.min(...heights), Math.max(...heights)];
    const size = high - low || 1;
    if (!drag) range = [low - 0.06 * size, high + ROOM * size];
    const lines = now.segments.slice(0, -1).map(({ stop }) => `<line x1="${(3.6 * x(stop)).toFixed(3)}" y1="0" x2="${(3.6 * x(stop)).toFixed(3)}" y2="100" class="seam"/>`);
    const curve = (values ?? []).map((value, i, all) => `${((360 * i) / (all.length - 1)).toFixed(2)},${y(value).toFixed(3)}`).join(" ");
    svg.innerHTML = `<line x1="0" y1="${y(0)}" x2="360" y2="${y(0)}" class="zero-line"/>${lines.join("")}<polyline points="${curve}" class="lift"/>`;
    const ticks = [0, 60, 120, 180, 240, 300, 360].map((angle) => {
      const tick = element("span", { class: "tick" });
      tick.textContent = `${round((angle / 360) * now.turn, 1e-3)}°`;
      tick.style.left = `${angle / 3.6}%`;
      return tick;
    });
    const levels = [...new Set([0, ...now.segments.map(({ after }) => round(after, 1e-3))])].map((height) => {
      const level = element("span", { class: "level" });
      level.textContent = `${height}`;
      level.style.top = `${y(height)}%`;
      return level;
    });
    plot.querySelectorAll(".tick, .level").forEach((node) => node.remove());
    plot.append(...ticks, ...levels);
    for (const { number, stop, after } of now.segments) {
      if (!(drag && drag.segment.number === number)) place(number, stop, after);
    }
    for (const { number, start, stop, after, law } of now.segments) {
      const [width, height, choice] = [`[data-width="${number}"]`, `[data-height="${number}"]`, `[data-law="${number}"]`].map((one) => table.querySelector(one));
      if (document.activeElement !== width) width.value = round(stop - start, 1e-9);
      if (document.activeElement !== height) height.value = round(after, 1e-9);
      if (choice) choice.value = law;
    }
  }

  translated(() => {
    for (const button of buttons.values()) if (button.dataset.said) button.setAttribute("aria-label", pick(JSON.parse(button.dataset.said)));
  });

  return {
    show(state) {
      now = state.timing;
      const layout = JSON.stringify([now.unit, now.segments.map(({ law, up }) => [Boolean(law), up.length])]);
      if (layout !== rows) build();
      rows = layout;
      draw();
    },
    /** The motion of a result over the turn. */
    curve({ lift, unit }) {
      const shown = { mm: (q) => q, rad: (q) => (q * 180) / Math.PI, tan: (q) => (Math.atan(q) * 180) / Math.PI }[unit];
      const every = Math.max(1, Math.floor(lift.tan.length / 720));
      values = Array.from(lift.tan).filter((_, i) => i % every === 0).map(shown);
      draw();
    },
  };
}
