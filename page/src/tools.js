// What can be done with the assembly: views, parts, section, measuring between two points, and keys.
import { BufferGeometry, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, Raycaster, SphereGeometry, Vector2, Vector3 } from "three";
import { both, element, pick, translated } from "./words.js";

const SNAP = 9; // px: a corner of the mesh so near to the place is meant
const CLICK = 5; // px

/** Makes the tools; returns a function that fits them to another model. */
export function tools(assembly) {
  const { box, canvas } = assembly;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "img");
  const words = both("The assembly in 3D. Arrow keys turn it, plus and minus bring it nearer, 0 shows all.");
  translated(() => canvas.setAttribute("aria-label", pick(words)));
  canvas.addEventListener("keydown", (event) => key(event, assembly));

  const bar = element("div", { class: "bar3d" });
  const [left, right] = assembly.motion.scene.car ? [both("Left"), both("Right")] : [both("Face"), both("Back")];
  const views = [["start", both("All")], ["left", left], ["right", right], ["front", both("Front")], ["top", both("Top")]];
  for (const [name, text] of views) {
    const button = element("button", { type: "button", text });
    button.addEventListener("click", () => assembly.view(name));
    bar.append(button);
  }
  const [list, picks] = [parts(assembly), measure(assembly)];
  const apart = explode(assembly);
  bar.append(section(assembly), apart.group, list.menu, picks.button);
  box.after(bar);
  hover(assembly, picks);
  return () => {
    list.fill();
    apart.fit();
    picks.clear();
  };
}

/** Slider that draws the parts of a car apart; hidden for a model whose parts have no ways. */
function explode(assembly) {
  const slider = element("input", { type: "range", min: 0, max: 1, step: 0.01, value: 0, label: both("Draw the parts apart") });
  const group = element("label", { class: "group" }, element("span", { text: both("Apart") }), slider);
  slider.addEventListener("input", () => assembly.explode(Number(slider.value)));
  const fit = () => {
    group.hidden = !assembly.motion.scene.parts.some((part) => part.branch);
  };
  fit();
  return { group, fit };
}

/** Says of the part under the pointer what it is, and what lies nearest to it. */
function hover(assembly, picks) {
  const { canvas, box } = assembly;
  const said = element("output", { class: "hovered", "aria-live": "off" });
  box.append(said);
  let waiting = null;
  const show = (event) => {
    waiting = null;
    const part = picks.on() ? null : struck(assembly, event)?.mesh.userData.part;
    said.hidden = !part;
    if (part) said.replaceChildren(element("b", { text: part.label }), ...(part.near ? [element("span", { text: part.near })] : []));
  };
  said.hidden = true;
  const ask = (event) => {
    if (event.buttons) return;
    if (!waiting) requestAnimationFrame(() => show(waiting));
    waiting = event;
  };
  canvas.addEventListener("pointermove", ask);
  canvas.addEventListener("pointerup", (event) => event.pointerType === "touch" && show(event));
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch") said.hidden = true;
  });
}

function key(event, assembly) {
  const step = 0.12;
  const act = {
    ArrowLeft: () => assembly.orbit(-step, 0),
    ArrowRight: () => assembly.orbit(step, 0),
    ArrowUp: () => assembly.orbit(0, -step),
    ArrowDown: () => assembly.orbit(0, step),
    "+": () => assembly.orbit(0, 0, 0.9),
    "=": () => assembly.orbit(0, 0, 0.9),
    "-": () => assembly.orbit(0, 0, 1.1),
    0: () => assembly.view("start"),
  }[event.key];
  if (!act) return;
  event.preventDefault();
  act();
}

function section(assembly) {
  const select = element("select", { label: both("Section") });
  const choices = [
    ["", both("No section")],
    ["z", both("Across shafts")],
    ["x", assembly.motion.scene.car ? both("Across the car") : both("Upright")],
    ["y", both("Level")],
  ];
  for (const [value, text] of choices) select.append(element("option", { value, text }));
  const slider = element("input", { type: "range", min: 0, max: 1, step: 0.002, value: 0.5, hidden: true, label: both("Place of the section") });
  const update = () => {
    slider.hidden = !select.value;
    assembly.section(select.value || null, Number(slider.value));
  };
  select.addEventListener("change", update);
  slider.addEventListener("input", update);
  return element("span", { class: "group" }, select, slider);
}

function parts(assembly) {
  const menu = element("div", { class: "menu" });
  const fill = () => {
    const list = new Map(assembly.motion.scene.parts.map((part) => [part.code, part]));
    for (const [code, label] of [["shafts", both("shafts")], ["follower", assembly.motion.scene.rod ? both("rod and fork") : both("follower")], ["wheel", both("drive wheel")]]) {
      if (assembly.groups.has(code)) list.set(code, { code, label });
    }
    const branches = new Map(); // by the label of the branch; parts without one stand by themselves
    const boxes = [];
    for (const { code, label, branch } of list.values()) {
      const box = element("input", { type: "checkbox", checked: !assembly.hidden.has(code) });
      box.addEventListener("change", () => assembly.visible(code, box.checked));
      const line = element("label", {}, box, element("span", { text: label }));
      if (!branch) {
        boxes.push(line);
        continue;
      }
      const name = [branch].flat()[0];
      if (!branches.has(name)) {
        const whole = element("input", { type: "checkbox", checked: true });
        const own = [];
        whole.addEventListener("change", () => {
          for (const one of own) {
            one.checked = whole.checked;
            one.dispatchEvent(new Event("change"));
          }
        });
        const node = element("fieldset", {}, element("legend", {}, element("label", {}, whole, element("b", { text: branch }))));
        branches.set(name, { node, own, whole });
        boxes.push(node);
      }
      const { node, own, whole } = branches.get(name);
      own.push(box);
      node.append(line);
      whole.checked = own.some((one) => one.checked);
    }
    menu.replaceChildren(...boxes);
  };
  fill();
  return { fill, menu: element("details", {}, element("summary", { text: both("Parts shown") }), menu) };
}

function measure(assembly) {
  const { canvas, box } = assembly;
  const button = element("button", { type: "button", "aria-pressed": "false", text: both("Measure") });
  const result = element("output", { class: "measured", "aria-live": "polite" });
  box.append(result);
  const colour = new MeshBasicMaterial({ color: 0xe4572e, depthTest: false });
  const line = new Line(new BufferGeometry(), new LineBasicMaterial({ color: 0xe4572e, depthTest: false }));
  const balls = [0, 1].map(() => new Mesh(new SphereGeometry(1, 16, 12), colour));
  for (const drawn of [line, ...balls]) {
    drawn.renderOrder = 9;
    drawn.visible = false;
    drawn.raycast = () => {};
    assembly.scene.add(drawn);
  }
  let on = false;
  let picks = [];

  const say = () => {
    if (!on) result.textContent = "";
    else if (picks.length < 2) {
      result.textContent = pick(picks.length ? both("Pick the second point") : both("Pick a point on a part"));
    } else {
      const [a, b] = picks.map(({ mesh, point }) => mesh.localToWorld(point.clone()));
      const off = b.clone().sub(a);
      const [ahead, up, left] = [off.x, off.y, -off.z].map((v) => v.toFixed(2));
      const length = off.length().toFixed(2);
      const [y, z] = [(-off.y).toFixed(2), left];
      const said = assembly.motion.scene.car
        ? both("{length} mm (ahead {ahead}, up {up}, left {left})", { length, ahead, up, left })
        : both("{length} mm (x {ahead}, y {y}, z {z})", { length, ahead, y, z });
      result.textContent = pick(said);
    }
  };

  /** The marks move with the parts that they are on. */
  const place = () => {
    const points = picks.map(({ mesh, point }) => mesh.localToWorld(point.clone()));
    balls.forEach((ball, i) => {
      ball.visible = i < points.length;
      if (ball.visible) {
        ball.position.copy(points[i]);
        ball.scale.setScalar(assembly.camera.position.distanceTo(points[i]) * 0.006);
      }
    });
    line.visible = points.length === 2;
    if (line.visible) line.geometry.setFromPoints(points);
  };
  assembly.before = () => {
    if (picks.length) place();
  };
  assembly.moved = () => {
    if (picks.length === 2) say();
  };
  translated(say);

  const clear = () => {
    picks = [];
    place();
    say();
    assembly.ask();
  };
  button.addEventListener("click", () => {
    on = !on;
    button.setAttribute("aria-pressed", String(on));
    canvas.classList.toggle("picking", on);
    clear();
  });
  let down = null;
  canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
  canvas.addEventListener("pointerup", (event) => {
    if (!on || !down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > CLICK) return;
    const hit = struck(assembly, event);
    if (!hit) return;
    if (picks.length === 2) picks = [];
    picks.push(hit);
    place();
    say();
    assembly.ask();
  });
  return { button, clear, on: () => on };
}

/** The nearest corner of the mesh under the pointer, or the place on its face. */
function struck(assembly, event) {
  const { camera, canvas, root, renderer } = assembly;
  const frame = canvas.getBoundingClientRect();
  const at = new Vector2(((event.clientX - frame.left) / frame.width) * 2 - 1, 1 - ((event.clientY - frame.top) / frame.height) * 2);
  const ray = new Raycaster();
  ray.setFromCamera(at, camera);
  const seen = ({ object, point }) => object.visible && renderer.clippingPlanes.every((plane) => plane.distanceToPoint(point) >= 0);
  const hit = ray.intersectObject(root, true).find(seen);
  if (!hit) return null;
  const { object: mesh, face, point } = hit;
  const places = mesh.geometry.getAttribute("position");
  let best = mesh.worldToLocal(point.clone());
  let near = SNAP;
  for (const index of [face.a, face.b, face.c]) {
    const corner = new Vector3().fromBufferAttribute(places, index);
    const shown = mesh.localToWorld(corner.clone()).project(camera);
    const off = Math.hypot(((shown.x - at.x) * frame.width) / 2, ((shown.y - at.y) * frame.height) / 2);
    if (off < near) [near, best] = [off, corner];
  }
  return { mesh, point: best };
}
