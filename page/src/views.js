// The two plan views: the page's SVG, moved by attributes alone.
const degrees = (rad) => (rad * 180) / Math.PI;
const short = (value) => Math.round(value * 1000) / 1000;

export function planViews(motion) {
  const find = (id) => document.getElementById(id);
  const [disc, inner, outer, point] = ["disc", "rod-inner", "rod-outer", "rod-point"].map(find);
  const [car, ghost] = [find("car"), find("car-planned")];
  const { rod, base, car: shape } = motion.scene;
  let carrying = "inner";

  function stand(group, pose, tan) {
    group.setAttribute("transform", `translate(${short(pose.x)} ${short(pose.y)}) rotate(${short(degrees(pose.heading))})`);
    const turned = -shape.steering * degrees(Math.atan(tan));
    group.querySelector(".front").setAttribute("transform", `rotate(${short(turned)})`);
  }

  return (state) => {
    disc.setAttribute("transform", `rotate(${short(-degrees(state.theta))})`);
    if (rod) {
      const stretch = Math.hypot(1, state.tan);
      for (const [ellipse, face] of [[inner, rod.faces[0]], [outer, rod.faces[1]]]) {
        ellipse.setAttribute("cx", short(base + face * state.tan));
        ellipse.setAttribute("rx", short(rod.radius * stretch));
      }
      const carries = state.tan >= 0 ? "inner" : "outer";
      if (carries !== carrying) {
        carrying = carries;
        inner.classList.toggle("far", carries === "outer");
        outer.classList.toggle("far", carries === "inner");
      }
    } else {
      point.setAttribute("cx", short(base + state.lift));
    }
    stand(car, state, state.tan);
    const apart = motion.planned !== state.going;
    ghost.style.display = apart ? "" : "none";
    if (apart) stand(ghost, state.planned, state.plannedTan);
    for (const code of ["played", "free"]) {
      find(`track-${code}`)?.classList.toggle("now", state.going.code === code);
    }
  };
}
