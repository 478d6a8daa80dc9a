"""Worn cams of known motions, as a measuring machine or a dial reads them: what `tests.studies.worn_cams` is judged by.

No line of cadgen is used. A cam turns counter-clockwise about the origin, seen on its outer face, so that a point X
of the fixed frame is X e^(-i theta) in the cam's; translating followers move along +y. Laws are integrals of their
accelerations, or written out; envelopes come from the path of the follower's centre or from the support of its face.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import cumulative_simpson
from scipy.interpolate import CubicHermiteSpline, CubicSpline

TURN = 2 * np.pi
_GRID = np.linspace(0.0, 1.0, 24_001)

Law = Callable[[np.ndarray], np.ndarray]


def _integrated(acceleration: np.ndarray) -> Law:
    """Law with an acceleration on the grid, scaled to a rise of 1."""
    v = cumulative_simpson(acceleration, x=_GRID, initial=0.0)
    s = cumulative_simpson(v, x=_GRID, initial=0.0)
    return CubicHermiteSpline(_GRID, s / s[-1], v / s[-1])


def _mirrored(first: Callable[[np.ndarray], np.ndarray]) -> Law:
    """Law whose acceleration is the opposite in its second half."""
    return _integrated(np.where(_GRID <= 0.5, first(np.minimum(_GRID, 0.5)), -first(1 - np.maximum(_GRID, 0.5))))


def _ramped(sine: float, level: float, straight: float = 0.0) -> Law:
    """Law with a quarter of a sine, a constant, a quarter of a cosine and a straight line in the middle."""
    up, flat = sine / 2 * (1 - straight), level / 2 * (1 - straight)
    down = (0.5 - straight / 2) - up - flat

    def first(u: np.ndarray) -> np.ndarray:
        rising = np.sin(np.pi / 2 * u / up) if up else np.ones_like(u)
        falling = np.cos(np.pi / 2 * np.clip((u - up - flat) / down, 0, 1)) if down else np.zeros_like(u)
        return np.where(u < up, rising, np.where(u < up + flat, 1.0, falling))

    return _mirrored(first)


def _trapezoid(u: np.ndarray) -> np.ndarray:
    return np.clip(np.minimum(8 * u, 8 * (0.5 - u)), 0, 1)


LAWS: dict[str, Law] = {
    "polynomial_2_3": lambda u: u**2 * (3 - 2 * u),
    "polynomial_3_4_5": lambda u: u**3 * (10 - 15 * u + 6 * u**2),
    "polynomial_4_5_6_7": lambda u: u**4 * (35 - 84 * u + 70 * u**2 - 20 * u**3),
    "polynomial_5_6_7_8_9": lambda u: u**5 * (126 - 420 * u + 540 * u**2 - 315 * u**3 + 70 * u**4),
    "constant_acceleration": lambda u: np.where(u < 0.5, 2 * u**2, 1 - 2 * (1 - u) ** 2),
    "simple_harmonic": lambda u: (1 - np.cos(np.pi * u)) / 2,
    "cycloidal": lambda u: u - np.sin(TURN * u) / TURN,
    "trapezoid": _mirrored(_trapezoid),
    "modified_trapezoid": _ramped(0.25, 0.5),
    "modified_sine": _ramped(0.25, 0.0),
    "modified_sine_20": _ramped(0.25, 0.0, 0.2),
    "modified_sine_33": _ramped(0.25, 0.0, 1 / 3),
    "modified_sine_50": _ramped(0.25, 0.0, 0.5),
    "modified_sine_66": _ramped(0.25, 0.0, 2 / 3),
    "gutman_1_3": lambda u: u - 15 / 32 / np.pi * np.sin(TURN * u) - np.sin(3 * TURN * u) / (96 * np.pi),
    "freudenstein_1_3": lambda u: u - (27 / 28 * np.sin(TURN * u) + np.sin(3 * TURN * u) / 84) / TURN,
    "freudenstein_1_3_5": lambda u: (
        u - 1125 / 1192 / TURN * (np.sin(TURN * u) + np.sin(3 * TURN * u) / 54 + np.sin(5 * TURN * u) / 1250)
    ),
    "cycloid_line_50": lambda u: np.interp(u, _GRID, _LINE),
}


def _line() -> np.ndarray:
    half = np.minimum(_GRID, 0.25) * 2  # share of the half cycloid
    blend = half - np.sin(TURN * half) / TURN
    rise = np.where(_GRID <= 0.25, blend, 0)
    middle = 0.5 + 2 * 2 * (_GRID - 0.25)
    end = 0.5 + 2.0
    tail = end + 0.5 - np.interp(1 - _GRID, _GRID, blend)
    s = np.where(_GRID <= 0.25, rise, np.where(_GRID <= 0.75, middle, tail))
    return s / s[-1]


_LINE = _line()
# Laws that no table has: what must be said not to be one of it.
STRANGE: dict[str, Law] = {
    "logistic in powers": lambda u: u**2.6 / (u**2.6 + (1 - u) ** 2.6),
    "tangent": lambda u: (np.tanh(4.2 * (u - 0.5)) / np.tanh(2.1) + 1) / 2,
    "modified sine with 42 %": _ramped(0.25, 0.0, 0.42),
    "polynomial 3-5-7": lambda u: u**3 * (35 - 42 * u**2 + 15 * u**4) / 8,
    "SCCA of 0.4, 0.2, 0.4": _ramped(0.4, 0.2),
}


@dataclass(frozen=True)
class Flank:
    """Rise or return: cam angles at its ends, degrees, heights, its law, and the wear of its surface."""

    start: float
    stop: float
    before: float
    after: float
    law: str
    wear: Callable[[np.ndarray], np.ndarray] | None = None

    def share(self, theta: np.ndarray) -> np.ndarray:
        """Share of the angle, not clipped."""
        return (np.degrees(theta) - self.start) / (self.stop - self.start)


@dataclass(frozen=True)
class Worn:
    """Cam with its motion, by cam angle."""

    flanks: tuple[Flank, ...]
    strange: dict[str, Law] = field(default_factory=dict)

    def lift(self, theta: np.ndarray) -> np.ndarray:
        """Lift as designed, in mm or rad."""
        theta = np.mod(theta, TURN)
        q = np.full_like(theta, self.flanks[0].before)
        for flank in self.flanks:
            u = np.clip(flank.share(theta), 0, 1)
            law = self.strange.get(flank.law) or LAWS[flank.law]
            q = np.where(flank.share(theta) > 0, flank.before + (flank.after - flank.before) * law(u), q)
        return q

    def wear(self, theta: np.ndarray) -> np.ndarray:
        """Depth of wear along the normal, mm."""
        depth = np.zeros_like(theta)
        for flank in self.flanks:
            if flank.wear is not None:
                u = flank.share(np.mod(theta, TURN))
                depth += np.where((u > -0.2) & (u < 1.2), flank.wear(u), 0.0)
        return depth


@dataclass(frozen=True)
class Follower:
    """Follower of a kind, by the keys of a design file."""

    kind: str
    keys: dict[str, object]
    base: float

    def contact(self, lift: Callable[[np.ndarray], np.ndarray], theta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Points of the disc and outward normals in the cam's frame, as complex numbers."""
        k, step = self.keys, 1e-5
        q = lift(theta)
        slope = (lift(theta + step) - lift(theta - step)) / (2 * step)
        turn = np.exp(-1j * theta)
        if self.kind in ("roller", "swinging_roller"):
            r = float(k["radius_mm"])  # type: ignore[arg-type]
            z, dz = self._centre(q, slope)
            path = (dz - 1j * z) * turn
            normal = 1j * path / np.abs(path)  # the path runs clockwise
            return z * turn - r * normal, normal
        if self.kind == "flat":
            tilt = np.radians(float(k.get("tilt_deg", 0.0)))  # type: ignore[arg-type]
            support, by_psi = self.base + q * np.cos(tilt), -slope * np.cos(tilt)
            normal = np.exp(1j * (np.pi / 2 + tilt - theta))
            return (support + 1j * by_psi) * normal, normal
        c, f, side = float(k["centre_distance_mm"]), float(k["face_offset_mm"]), self._side  # type: ignore[arg-type]
        delta = np.arcsin((self.base + f) / c) + q
        # Normal of the face in the fixed frame: the pivot lies at (c, 0).
        psi = np.where(side > 0, np.pi / 2 - delta, delta - np.pi / 2)
        rate = -side * slope - 1
        support, d = c * np.sin(delta) - f, c * np.cos(delta) * slope
        normal = np.exp(1j * (psi - theta))
        return (support + 1j * d / rate) * normal, normal

    @property
    def _side(self) -> float:
        return 1.0 if self.keys["lifts"] == "against" else -1.0

    def _centre(self, q: np.ndarray, slope: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        k, prime = self.keys, self.base + float(self.keys["radius_mm"])  # type: ignore[arg-type]
        if self.kind == "roller":
            e = float(k.get("offset_mm", 0.0))  # type: ignore[arg-type]
            return e + 1j * (np.sqrt(prime**2 - e**2) + q), 1j * slope
        c, l, g = float(k["centre_distance_mm"]), float(k["arm_mm"]), self._side  # type: ignore[arg-type]  # noqa: E741
        delta = np.arccos((c**2 + l**2 - prime**2) / (2 * c * l)) + q
        z = c - l * np.cos(delta) + 1j * g * l * np.sin(delta)
        return z, (l * np.sin(delta) + 1j * g * l * np.cos(delta)) * slope


def outline(
    cam: Worn,
    follower: Follower,
    count: int,
    noise: float,
    rng: np.random.Generator,
    *,
    centre: complex = 0j,
    start: float = 0.0,
    backwards: bool = False,
    larger: float = 0.0,
) -> np.ndarray:
    """Measured points seen on the outer face, shape (n, 2), mm, evenly spaced along the outline.

    Args:
        cam: motion and wear.
        follower: follower.
        count: number of points.
        noise: standard deviation of each coordinate, mm.
        rng: random numbers.
        centre: place of the camshaft in the machine's frame.
        start: angle by which the disc is turned in it, rad.
        backwards: whether the points run the other way round.
        larger: distance along the normal by which the disc is larger, mm.
    """
    theta = np.linspace(0.0, TURN, 40_001)
    point, normal = follower.contact(cam.lift, theta)
    point = point + (larger - cam.wear(theta)) * normal
    along = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(point)))])
    where = (np.arange(count) + rng.uniform()) / count * along[-1]
    keep = np.concatenate([[True], np.diff(along) > 1e-9])
    each = CubicSpline(along[keep], np.stack([point.real[keep], point.imag[keep]], axis=1))(where)
    points = (each[:, 0] + 1j * each[:, 1]) * np.exp(1j * start) + centre
    points = np.roll(points, rng.integers(count))
    points = points[::-1] if backwards else points
    return np.stack([points.real, points.imag], axis=1) + noise * rng.standard_normal((count, 2))


def lifts(
    cam: Worn, follower: Follower, count: int, noise: float, rng: np.random.Generator, start: float = 0.0
) -> np.ndarray:
    """Measured lift by the angle of a dividing head, degrees and mm (or degrees), shape (n, 2)."""
    theta = np.arange(count) * TURN / count
    return np.stack([theta, rolled(cam, follower, theta - start) + noise * rng.standard_normal(count)], axis=1)


def rolled(cam: Worn, follower: Follower, theta: np.ndarray) -> np.ndarray:
    """Lift of the worn disc: that designed less the wear by the cosine of the pressure angle, to first order."""
    step = 1e-5
    _, normal = follower.contact(cam.lift, theta)
    fixed = normal * np.exp(1j * theta)
    slope = (cam.lift(theta + step) - cam.lift(theta - step)) / (2 * step)
    if follower.kind == "swinging_roller":
        _, way = follower._centre(cam.lift(theta), np.ones_like(theta))
        push = (fixed.conj() * way).real
    elif follower.kind == "swinging_flat":
        c, f = float(follower.keys["centre_distance_mm"]), float(follower.keys["face_offset_mm"])  # type: ignore[arg-type]
        delta = np.arcsin((follower.base + f) / c) + cam.lift(theta)
        push = c * np.cos(delta) / (1 + follower._side * slope)
    else:
        push = fixed.imag
    return cam.lift(theta) - cam.wear(theta) / push


def dropped(
    disc: np.ndarray, follower: Follower, theta: np.ndarray, *, mirrored: bool = False, shift: complex = 0j
) -> np.ndarray:
    """Place of a follower that is let down on a disc: along its slide, mm, or the angle of its arm, rad.

    Args:
        disc: dense points of the outline in the cam's frame, as complex numbers.
        follower: follower.
        theta: cam angles, rad.
        mirrored: whether the disc is put on with its other face outwards.
        shift: displacement of the disc on its shaft, in its own frame, mm.
    """
    points = (disc.conj() if mirrored else disc) + shift
    k, places = follower.keys, []
    for angle in theta:
        p = points * np.exp(1j * angle)
        if follower.kind == "roller":
            r, e = float(k["radius_mm"]), float(k.get("offset_mm", 0.0))  # type: ignore[arg-type]
            if r:
                near = (np.abs(p.real - e) < r) & (p.imag > 0)
                places.append(float((p.imag[near] + np.sqrt(r**2 - (p.real[near] - e) ** 2)).max()))
                continue
            # An edge without a radius: the outermost crossing of its line.
            after = np.roll(p, -1)
            crossing = ((p.real - e) * (after.real - e) <= 0) & (p.real != after.real) & (p.imag > 0)
            one, two = p[crossing], after[crossing]
            share = (e - one.real) / (two.real - one.real)
            places.append(float((one.imag + share * (two.imag - one.imag)).max()))
        elif follower.kind == "flat":
            tilt = np.radians(float(k.get("tilt_deg", 0.0)))  # type: ignore[arg-type]
            places.append(float((p * np.exp(-1j * (np.pi / 2 + tilt))).real.max() / np.cos(tilt)))
        else:
            c = float(k["centre_distance_mm"])  # type: ignore[arg-type]
            away = c - p if follower._side > 0 else c - p.conj()
            distance, phi = np.abs(away), -np.angle(away)
            if follower.kind == "swinging_flat":
                f = float(k["face_offset_mm"])  # type: ignore[arg-type]
                places.append(float((phi + np.arcsin(f / distance)).max()))
                continue
            r, l = float(k["radius_mm"]), float(k["arm_mm"])  # type: ignore[arg-type]  # noqa: E741
            near = np.abs(distance - l) < r
            opening = np.arccos((l**2 + distance[near] ** 2 - r**2) / (2 * l * distance[near]))
            places.append(float((phi[near] + opening).max()))
    return np.array(places)


def dense(cam: Worn, follower: Follower, count: int = 40_001) -> np.ndarray:
    """Dense points of a disc, in the cam's frame."""
    return follower.contact(cam.lift, np.linspace(0, TURN, count))[0]
