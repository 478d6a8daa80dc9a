"""Motions and followers of the study `motions` by their definitions: laws, places of followers, what they touch.

Nothing here comes from cadgen. A law is its acceleration, of constants and sines, integrated piece by piece. A follower
is a circle or a line with a place at each cam angle, in the frame of the cam, whose ray turns on. A disc is right where
each point of its outline is touched at some cam angle and never lies within the follower: the least distance over the
turn is 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import cos, pi, radians, sin

import numpy as np

TURN = 2 * pi
COARSE, ZOOM, ZOOMS = 14_400, 41, 5


def polynomial(*shares: float) -> Callable:
    """Law of a polynomial by the coefficients of the powers from 0 on: lift, velocity, acceleration by the share."""
    series = [
        np.polynomial.Polynomial(shares).deriv(order) if order else np.polynomial.Polynomial(shares)
        for order in range(3)
    ]
    return lambda u: np.stack([each(u) for each in series])


def waves(*pieces: tuple[float, float, float, float, float]) -> Callable:
    """Law by its acceleration A + B sin(w (u - begin) + p) in pieces (width, A, B, w, p), from rest to rest at 1."""
    starts, speed, place = [], 0.0, 0.0
    begin = 0.0
    for width, a, b, w, p in pieces:
        starts.append((begin, speed, place, a, b, w, p))
        place += speed * width + a * width**2 / 2
        speed += a * width
        if b:
            place += b * cos(p) / w * width - b * (sin(w * width + p) - sin(p)) / w**2
            speed += b * (cos(p) - cos(w * width + p)) / w
        begin += width

    def law(u: np.ndarray) -> np.ndarray:
        found = np.empty((3, len(u)))
        number = np.clip(np.searchsorted([each[0] for each in starts], u, side="right") - 1, 0, len(starts) - 1)
        for at, (start, v, s, a, b, w, p) in enumerate(starts):
            x = u[number == at] - start
            jets = np.stack([s + v * x + a * x**2 / 2, v + a * x, a + 0 * x])
            if b:
                jets += np.stack(
                    [
                        b * cos(p) / w * x - b * (np.sin(w * x + p) - sin(p)) / w**2,
                        b * (cos(p) - np.cos(w * x + p)) / w,
                        b * np.sin(w * x + p),
                    ]
                )
            found[:, number == at] = jets
        return found / place

    return law


def _modified_sine(straight: float) -> Callable:
    """Modified sine with a share of constant velocity in its middle."""
    bend = (1 - straight) / 2
    quarter, rest = bend / 4, bend * 3 / 4
    rising = ((quarter, 0, 1, pi / 2 / quarter, 0), (rest, 0, 1, pi / 2 / rest, pi / 2))
    falling = ((rest, 0, -1, pi / 2 / rest, 0), (quarter, 0, -1, pi / 2 / quarter, pi / 2))
    middle = ((straight, 0, 0, 0, 0),) if straight else ()
    return waves(*rising, *middle, *falling)


LAWS = {
    "constant_velocity": polynomial(0, 1),
    "polynomial_2_3": polynomial(0, 0, 3, -2),
    "polynomial_3_4_5": polynomial(0, 0, 0, 10, -15, 6),
    "polynomial_4_5_6_7": polynomial(0, 0, 0, 0, 35, -84, 70, -20),
    "constant_acceleration": waves((0.5, 1, 0, 0, 0), (0.5, -1, 0, 0, 0)),
    "cycloidal": waves((1, 0, 1, TURN, 0)),
    "simple_harmonic": waves((1, 0, 1, pi, pi / 2)),
    "cycloid_line_50": waves((0.25, 0, 1, 4 * pi, 0), (0.5, 0, 0, 0, 0), (0.25, 0, -1, 4 * pi, 0)),
    "modified_trapezoid": waves(
        (1 / 8, 0, 1, 4 * pi, 0),
        (1 / 4, 1, 0, 0, 0),
        (1 / 8, 0, 1, 4 * pi, pi / 2),
        (1 / 8, 0, -1, 4 * pi, 0),
        (1 / 4, -1, 0, 0, 0),
        (1 / 8, 0, -1, 4 * pi, pi / 2),
    ),
    "modified_sine": _modified_sine(0.0),
    "modified_sine_50": _modified_sine(0.5),
    "half_cycloid_1": waves((1, 0, 1, pi, 0)),
    "half_harmonic_2": lambda u: np.stack(
        [np.sin(pi * u / 2), pi / 2 * np.cos(pi * u / 2), -((pi / 2) ** 2) * np.sin(pi * u / 2)]
    ),
}


@dataclass(frozen=True)
class Span:
    """Rise or dwell: angle, rad, height at its end, mm or rad, and law; None for a dwell."""

    width: float
    to: float
    law: str | None


def motion_by_laws(spans: Sequence[Span], repeat: int = 1) -> Callable:
    """Lift and two derivatives by the cam angle, shape (3, n), of spans that are repeated over the turn."""
    edges = np.cumsum([0.0, *(span.width for span in spans)])
    befores = [0.0, *(span.to for span in spans)]

    def q(theta: np.ndarray) -> np.ndarray:
        theta = np.mod(theta, TURN / repeat)
        found = np.zeros((3, len(theta)))
        number = np.clip(np.searchsorted(edges, theta, side="right") - 1, 0, len(spans) - 1)
        for at, span in enumerate(spans):
            here = number == at
            if span.law is None:
                found[0, here] = befores[at]
                continue
            jets = LAWS[span.law](np.clip((theta[here] - edges[at]) / span.width, 0, 1)) * (span.to - befores[at])
            found[:, here] = jets / span.width ** np.arange(3)[:, None]
            found[0, here] += befores[at]
        return found

    return q


def jumps(spans: Sequence[Span]) -> tuple[float, float]:
    """Greatest jump of the velocity and of the acceleration at the ends of spans that are run round and round."""
    ends = []
    for at, span in enumerate(spans):
        before = spans[at - 1].to if at else 0.0
        if span.law is None:
            ends.append(np.zeros((2, 2)))
            continue
        jets = LAWS[span.law](np.array([0.0, 1.0])) * (span.to - before) / span.width ** np.arange(3)[:, None]
        ends.append(jets[1:])
    apart = [np.abs(ends[at][:, 0] - ends[at - 1][:, 1]) for at in range(len(spans))]
    return tuple(np.max(apart, axis=0).tolist())  # type: ignore[return-value]


@dataclass(frozen=True)
class Truth:
    """A follower by its definition.

    Attributes:
        keys: keys of [follower].
        base: radius of the base circle, mm.
    """

    keys: dict
    base: float

    @property
    def radius(self) -> float:
        return self.keys.get("radius_mm", 0.0)

    @property
    def side(self) -> int:
        return 1 if self.keys.get("lifts") == "against" else -1

    @property
    def swings(self) -> bool:
        return self.keys["kind"].startswith("swinging")

    @property
    def rest(self) -> float:
        """Angle at the pivot where the swing is 0, rad."""
        c = self.keys["centre_distance_mm"]
        if self.keys["kind"] == "swinging_flat":
            return float(np.arcsin((self.base + self.keys.get("face_offset_mm", 0.0)) / c))
        arm, prime = self.keys["arm_mm"], self.base + self.radius
        return float(np.arccos((c**2 + arm**2 - prime**2) / (2 * c * arm)))

    def centre(self, q: np.ndarray) -> np.ndarray:
        """Centre of a roller in the frame of the ray, mm."""
        if self.swings:
            return self.keys["centre_distance_mm"] - self.keys["arm_mm"] * np.exp(1j * self.side * (self.rest + q))
        offset = self.keys.get("offset_mm", 0.0)
        return np.sqrt((self.base + self.radius) ** 2 - offset**2) + q + 1j * offset

    def line(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Normal of a face, and its distance from the camshaft, mm, in the frame of the ray."""
        if self.keys["kind"] == "flat":
            tilt = radians(self.keys.get("tilt_deg", 0.0))
            return np.exp(-1j * tilt) + 0 * q, self.base + q * cos(tilt)
        c, off = self.keys["centre_distance_mm"], self.keys.get("face_offset_mm", 0.0)
        delta = self.rest + q
        # The arm points from the pivot at -exp(i g delta); the face lies beside it on the side away from the camshaft.
        return np.exp(1j * self.side * (delta - pi / 2)), c * np.sin(delta) - off

    @property
    def flat(self) -> bool:
        return self.keys["kind"].endswith("flat")

    def gaps(self, points: np.ndarray, theta: np.ndarray, q: np.ndarray, *, shift: float = 0.0) -> np.ndarray:
        """Distance of points from the follower, mm: of circle or line, positive outside of it, shape as of theta."""
        p = points * np.exp(-1j * theta)
        if self.flat:
            normal, distance = self.line(q)
            return distance - (p * normal.conj()).real
        return np.abs(p - self.centre(q)) - (self.radius + shift)

    def angle(self, jets: np.ndarray) -> np.ndarray:
        """Size of the pressure angle, rad: normal of the outline against the way of what is driven."""
        q, v, _ = jets
        step = 1e-6
        if self.flat:
            if self.keys["kind"] == "flat":
                return np.full(len(q), abs(radians(self.keys.get("tilt_deg", 0.0))))
            width = self.keys["centre_distance_mm"] * np.cos(self.rest + q) / (1 + self.side * v)
            return np.abs(np.arctan2(self.keys.get("face_offset_mm", 0.0), width))
        z = self.centre(q)
        way = (self.centre(q + step) - self.centre(q - step)) / (2 * step)
        path = way * v + 1j * z  # of the centre over the disc
        along = path.conj() * way
        return np.arctan2(np.abs(along.real), np.abs(along.imag))

    def radii(self, jets: np.ndarray) -> np.ndarray:
        """Radius of curvature of the profile, mm, positive where convex, by differences of the exact places."""
        q, v, a = jets
        step = 1e-4
        if self.flat:
            (n0, h0), (n1, h1), (n2, h2) = (self.line(q + v * t + a * t * t / 2) for t in (-step, 0.0, step))
            turn = [np.angle(n / n1) + t for n, t in ((n0, -step), (n1, 0.0), (n2, step))]
            slope, other = (h1 - h0) / (turn[1] - turn[0]), (h2 - h1) / (turn[2] - turn[1])
            return h1 + (other - slope) / ((turn[2] - turn[0]) / 2)
        z0, z1, z2 = (self.centre(q + v * t + a * t * t / 2) * np.exp(1j * t) for t in (-step, 0.0, step))
        first, second = (z2 - z0) / (2 * step), (z2 - 2 * z1 + z0) / step**2
        with np.errstate(divide="ignore"):
            return np.abs(first) ** 3 / (first.conj() * second).imag - self.radius


def worst_gap(truth: Truth, points: np.ndarray, q: Callable, *, shift: float = 0.0) -> tuple[float, float]:
    """Least and greatest over points of the least distance from the follower over the turn, mm.

    Args:
        points: points of the outline as complex numbers, mm.
        q: motion, lift and two derivatives.
        shift: what is added to the radius, as half the clearance of a groove, mm.
    """
    theta = np.linspace(0.0, TURN, COARSE, endpoint=False)
    lift = q(theta)[0]
    least = np.empty(len(points))
    centre = None if truth.flat else truth.centre(lift) * np.exp(1j * theta)
    normal, distance = (lambda n, h: (n * np.exp(1j * theta), h))(*truth.line(lift)) if truth.flat else (None, None)
    for number, point in enumerate(points):
        gap = distance - (point * normal.conj()).real if truth.flat else np.abs(point - centre)
        # Two touching places may lie apart: look at every valley near the least.
        low = np.flatnonzero((gap <= np.roll(gap, 1)) & (gap <= np.roll(gap, -1)) & (gap < gap.min() + 0.05))
        best = np.inf
        for at in low[:12]:
            near = theta[at] + np.array([-1.0, 1.0]) * TURN / COARSE
            for _ in range(ZOOMS):
                angles = np.linspace(near[0], near[1], ZOOM)
                values = truth.gaps(point, angles, q(angles)[0], shift=shift)
                mid = int(np.argmin(values))
                near = angles[max(mid - 1, 0)], angles[min(mid + 1, ZOOM - 1)]
            best = min(best, float(values.min()))
        least[number] = best
    return float(least.min()), float(least.max())


def lift_on(truth: Truth, outline: np.ndarray, theta: float) -> float:
    """Motion at which the follower just clears a disc given by dense points, by the definition of its contact."""
    p = outline * np.exp(-1j * theta)
    if truth.keys["kind"] == "flat":
        normal, _ = truth.line(np.zeros(1))
        tilt = radians(truth.keys.get("tilt_deg", 0.0))
        return float(((p * normal[0].conj()).real.max() - truth.base) / cos(tilt))
    if truth.swings:
        c = truth.keys["centre_distance_mm"]
        seen = c - p  # from the pivot
        far, turned = np.abs(seen), truth.side * np.angle(seen)
        if truth.flat:
            off = truth.keys.get("face_offset_mm", 0.0)
            return float((turned + np.arcsin(np.clip(off / far, -1, 1))).max() - truth.rest)
        arm, r = truth.keys["arm_mm"], truth.radius
        near = np.abs(far - arm) < r
        opening = np.arccos((arm**2 + far[near] ** 2 - r**2) / (2 * arm * far[near]))
        return float((turned[near] + opening).max() - truth.rest)
    offset, r = truth.keys.get("offset_mm", 0.0), truth.radius
    across = p.imag - offset
    base = np.sqrt((truth.base + r) ** 2 - offset**2)
    if r == 0:
        cut = np.flatnonzero((across[:-1] < 0) & (across[1:] >= 0))
        share = across[cut] / (across[cut] - across[cut + 1])
        return float((p[cut] + share * (p[cut + 1] - p[cut])).real.max() - base)
    near = np.abs(across) < r
    return float((p[near].real + np.sqrt(r**2 - across[near] ** 2)).max() - base)
