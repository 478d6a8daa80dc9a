// The two plan views: drawings one above the other, each painted once and then moved as a whole.
import { swung } from "./motion.js";

const degrees = (rad) => (rad * 180) / Math.PI;
const short = (value) => Math.round(value * 1000) / 1000;

/** Gives each drawing its shape: places in shares of a drawing hold only where it fills its stage. */
export function shapeStages() {
  for (const stage of document.querySelectorAll(".stage")) stage.style.setProperty("--aspect", stage.dataset.aspect);
}

export function planViews(motion, map) {
  const views = [motion.scene.wheels.length ? trainView(motion) : camView(motion)];
  if (motion.scene.car) views.push(courseView(motion, map));
  shapeStages();
  return (state) => views.forEach((show) => show(state));
}

const find = (id) => document.getElementById(id);

/** The disc and its follower, from the side. */
function camView(motion) {
  const [disc, inner, outer] = ["disc-layer", "rod-inner", "rod-outer"].map(find);
  const { rod, base, travel, arm, second } = motion.scene;
  const rider = rod ? null : riderView("follower", travel, arm);
  const secondRider = second && riderView("second", second.travel, second.arm);
  let carrying = "inner";
  disc.style.transformOrigin = `${disc.dataset.origin} 50%`;

  return (state) => {
    disc.style.transform = `rotate(${short(degrees(state.theta))}deg)`;
    if (!rod) {
      rider(state.way);
      secondRider?.(state.secondWay);
      return;
    }
    const stretch = Math.hypot(1, state.tan);
    for (const [ellipse, face] of [[inner, rod.faces[0]], [outer, rod.faces[1]]]) {
      ellipse.setAttribute("cx", short(base + face * state.tan));
      ellipse.setAttribute("rx", short(rod.radius * stretch));
    }
    const carries = state.tan >= 0 ? "inner" : "outer";
    if (carries === carrying) return;
    carrying = carries;
    inner.classList.toggle("far", carries === "outer");
    outer.classList.toggle("far", carries === "inner");
  };
}

/** Gears without a cam, along their shafts. */
function trainView(motion) {
  const wheels = motion.scene.wheels.map((shaft) => [shaft, find(`wheel-${shaft}`)]);
  return (state) => {
    for (const [shaft, wheel] of wheels) {
      const place = motion.place(shaft, state).map(short).join(" ");
      wheel.setAttribute("transform", `translate(${place}) rotate(${short(degrees(motion.shaft(shaft, state)))})`);
    }
  };
}

/** A follower that moves as a whole, with its arm. */
function riderView(name, travel, arm) {
  const [section, line] = [`${name}-section`, `${name}-arm`].map(find);
  const [x, y] = travel.centre;
  return (way) => {
    section.setAttribute("transform", `translate(${short(way.ahead)} ${short(way.across)}) rotate(${short(degrees(way.turned))} ${short(x)} ${short(y)})`);
    if (arm) line?.setAttribute("transform", `rotate(${short(degrees(swung(arm.pivot, travel.centre, way)))} ${arm.pivot.map(short).join(" ")})`);
  };
}

/** The car on its course, from above. */
function courseView(motion, map) {
  const [car, ghost, floor] = ["car", "car-planned", "course-view"].map(find);
  const shape = motion.scene.car;
  const size = Number(floor.dataset.size);
  let ran = null;
  let last = null;
  for (const drawn of [car, ghost]) {
    drawn.style.height = "auto";
    drawn.style.visibility = "visible";
  }

  function stand(drawn, pose, tan) {
    const { left, top } = map.frame;
    const [x, y] = [(pose.x - left) / size - 0.5, (top - pose.y) / size - 0.5];
    drawn.style.transform = `translate(${short(100 * x)}%, ${short(100 * y)}%) rotate(${short(-degrees(pose.heading))}deg)`;
    const turned = `rotate(${Math.round(-shape.steering * degrees(Math.atan(tan)) * 2) / 2})`;
    const front = drawn.querySelector(".front");
    if (front.getAttribute("transform") !== turned) front.setAttribute("transform", turned);
  }

  function show(state) {
    last = state;
    stand(car, state, state.tan);
    const apart = motion.planned !== state.going;
    ghost.style.display = apart ? "" : "none";
    if (apart) stand(ghost, state.planned, state.plannedTan);
    if (ran !== state.going.code) {
      ran = state.going.code;
      for (const code of ["played", "free"]) find(`track-${code}`)?.classList.toggle("now", ran === code);
    }
  }

  map.listen("cars", () => {
    for (const drawn of [car, ghost]) drawn.style.width = `${(100 * size) / map.frame.width}%`;
    if (last) show(last);
  });
  return show;
}
