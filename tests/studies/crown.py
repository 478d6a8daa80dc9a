"""A crowned rim, cut with a form cutter, against edges that are broken: `python -m tests.studies.crown`.

The rim's section is a circular arc of radius rho about the middle plane, along the outline's normal. Such a rim is a
tube of radius rho about a centre curve in the middle plane, so a rod of radius r rests on it as one of radius r + rho
rests on that curve there: exact as long as it touches the arc. Held below against the rod laid on slices of the crown.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize_scalar

from cadgen.cam.contact import roll
from cadgen.cam.cutter import largest_cutter
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import LeaningRod
from cadgen.curves.chamfer import chamfer_strips, inner_curve
from cadgen.curves.closed import ClosedCurve, left_normal
from tests.conftest import Built, build

STEP = 0.03  # mm between points of an outline
COUNT = 1740  # stations of a run, 0.2 degrees apart


@dataclass(frozen=True)
class Crowned:
    """A cam with a crowned rim: the crown's radius, its centre curve, and the rod that rolls on that instead."""

    rho: float
    centre: ClosedCurve
    rod: LeaningRod
    half_width: float


def crowned(car: Built, rho: float) -> Crowned:
    """The cam for the car's lift."""
    rod = car.follower
    middle = (rod.inner + rod.outer) / 2
    on_centre = replace(rod, inner=middle, outer=middle, radius=rod.radius + rho)
    return Crowned(rho, actual_profile(car.lift, on_centre).curve, on_centre, rod.land / 2)


def laid_on_slices(cam: Crowned, theta: np.ndarray, edge_break: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """tan(beta) of the rod on 61 slices of the crown, and how far from the middle plane it touches, mm.

    Args:
        cam: the crowned cam.
        theta: cam angles, rad.
        edge_break: leg of 45 degree chamfers where the crown meets the faces, mm.
    """
    jets = [piece.jet(t) for piece, t in zip(cam.centre.pieces, cam.centre.parameters(0.01), strict=True)]
    points = np.concatenate([jet.point for jet in jets])
    out = -np.concatenate([left_normal(jet.velocity) for jet in jets])
    polar = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    polar = np.concatenate([polar - 2 * np.pi, polar, polar + 2 * np.pi])
    reach = np.arcsin(cam.rod.radius / np.linalg.norm(points, axis=1).min()) + 0.01
    z = np.linspace(-cam.half_width, cam.half_width, 61)
    height = np.sqrt(cam.rho**2 - z**2)
    if edge_break:
        height = np.minimum(height, height[0] - edge_break + cam.half_width - np.abs(z))
    best = np.full((2, len(theta)), -np.inf)
    for k, angle in enumerate(theta):
        near = np.arange(*np.searchsorted(polar, [angle - reach, angle + reach])) % len(points)
        for off, high in zip(z, height, strict=True):
            at, w = points[near] + high * out[near], cam.rod.inner + off
            y = at @ [-np.sin(angle), np.cos(angle)]
            under = np.abs(y) < cam.rod.radius - cam.rho
            u = (at @ [np.cos(angle), np.sin(angle)])[under] - cam.rod.base_radius
            h = np.sqrt((cam.rod.radius - cam.rho) ** 2 - y[under] ** 2)
            beta = float((np.arccos(-h / np.hypot(u, w)) - np.arctan2(w, u)).max())
            if beta > best[0, k]:
                best[:, k] = beta, off
    return np.tan(best[0]), best[1]


class _Runs:
    """Ends of runs without play, by the midpoint rule."""

    def __init__(self, car: Built) -> None:
        self.car = car
        self.stop = car.lift.blend_start
        self.theta = (np.arange(COUNT) + 0.5) / COUNT * self.stop
        self.planned = self._end(car.lift.q(self.theta), 0.0)

    def off(self, curve: ClosedCurve, rod: LeaningRod) -> tuple[float, float]:
        """How far off the run ends, mm, as it is and with the best constant added to the steering."""
        T = roll(curve.outline(STEP), rod, self.theta).q
        trimmed = minimize_scalar(
            lambda trim: abs(self._end(T, trim) - self.planned), bounds=(-0.02, 0.02), options={"xatol": 1e-9}
        )
        return abs(self._end(T, 0.0) - self.planned), float(trimmed.fun)

    def _end(self, tan_beta: np.ndarray, trim: float) -> complex:
        steering, car = np.tan(np.arctan(tan_beta) + trim), self.car
        step = car.track.length / (2 * np.pi) * self.stop / COUNT
        turned = -steering / (car.car.wheelbase + car.car.drive_wheel_offset * steering) * step
        return complex(np.sum(np.exp(1j * (np.cumsum(turned) - turned / 2))) * step)


def results() -> Iterator[str]:
    """Every figure of the decision, a line each."""
    car = build("carbon_free_car")
    sharp, runs = car.follower, _Runs(car)
    lean = np.arctan(np.abs(car.lift.q(np.linspace(0, 2 * np.pi, 20_000))).max())
    most = sharp.land / 2 / np.sin(lean)
    yield f"greatest lean {np.degrees(lean):.2f} deg; the rod stays on the crown up to rho = {most:.2f} mm"
    for rho in (2.0, 3.0, 4.0, 5.0, 6.0):
        cam = crowned(car, rho)
        got = roll(cam.centre.outline(STEP), cam.rod, runs.theta).q
        error = np.abs(cam.rod.lift(got) - cam.rod.lift(car.lift.q(runs.theta))).max() * 1e3
        drop = rho - np.sqrt(rho**2 - cam.half_width**2)
        yield (
            f"rho {rho:g}: lift within {error:.5f} um, {len(cam.centre.corners())} corners, largest cutter on the rim "
            f"{largest_cutter(cam.centre).radius - rho:.2f} mm, touches within {rho * np.sin(lean):.2f} mm of the "
            f"middle, faces {drop:.2f} mm lower"
        )
    cam = crowned(car, 4.0)
    few = runs.theta[::58]
    laid, place = laid_on_slices(cam, few)
    tube = roll(cam.centre.outline(STEP), cam.rod, few).q
    apart, out = np.abs(laid - tube).max() * 25e3, np.abs(place).max()
    yield f"rho 4, tube against slices: {apart:.3f} um; touches {out:.2f} mm out"
    for leg in (0.1, 0.2, 0.4):
        moved = np.abs(laid_on_slices(cam, few, leg)[0] - laid).max() * 25e3
        yield f"rho 4, edges broken {leg} mm: {moved:.3f} um of lift"
    rows = {}
    for d in (0.02, 0.05, 0.1):
        rows[f"rho 4, cutter set {d} mm off along the axis"] = (
            cam.centre,
            replace(cam.rod, inner=cam.rod.inner + d, outer=cam.rod.outer + d),
        )
        rows[f"rho 4, crown's radius {d} mm larger"] = (
            inner_curve(chamfer_strips(cam.centre, d)),
            replace(cam.rod, radius=cam.rod.radius + d),
        )
        rows[f"sharp edges broken {d} mm"] = (
            car.actual.curve,
            replace(sharp, inner=sharp.inner + d, outer=sharp.outer - d),
        )
    for d in (0.0026, 0.01):
        rows[f"rho 4, cut or worn {d} mm too deep"] = inner_curve(chamfer_strips(cam.centre, d)), cam.rod
        rows[f"sharp edges, cut {d} mm too deep"] = inner_curve(chamfer_strips(car.actual.curve, d)), sharp
    for name, (curve, rod) in rows.items():
        plain, trimmed = runs.off(curve, rod)
        yield f"{name}: {plain:.1f} mm at the end, {trimmed:.1f} mm trimmed"


if __name__ == "__main__":
    for line in results():
        print(line)
