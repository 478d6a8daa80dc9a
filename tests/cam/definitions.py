"""Figures of a cam by the definitions of its motion and its follower, for comparison; nothing here comes from cadgen.

The frame is that of books: the cam turns counter-clockwise by theta, a point X of the fixed frame is X exp(-i theta) in
the cam's. A round follower has a centre z, whose path is p = z exp(-i theta); a face has a normal and a distance. The
laws are those of `tests.studies.motions_truth` and some more, each by its acceleration or its series.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import cos, pi, radians, sin, sqrt

import numpy as np

from tests.studies.motions_truth import LAWS, TURN, polynomial, waves

PIECE, ZOOM, ZOOMS = 161, 33, 5  # points of a piece between seams, and of each closer look at a peak
HALF_STEEL = 206_000.0 / (2 * (1 - 0.3**2))  # MPa, E* of two parts of steel


def _sines(line: float, *terms: tuple[float, float]) -> Callable:
    """Law s = line u + sum of a sin(w u)."""
    return lambda u: np.stack(
        [
            line * u + sum(a * np.sin(w * u) for a, w in terms),
            line + sum(a * w * np.cos(w * u) for a, w in terms),
            sum(-a * w * w * np.sin(w * u) for a, w in terms) + 0 * u,
        ]
    )


def _straight_sine(straight: float) -> Callable:
    """Modified sine with a share of constant velocity in its middle."""
    quarter, rest = (1 - straight) / 8, (1 - straight) * 3 / 8
    rising = ((quarter, 0, 1, pi / 2 / quarter, 0), (rest, 0, 1, pi / 2 / rest, pi / 2))
    falling = ((rest, 0, -1, pi / 2 / rest, 0), (quarter, 0, -1, pi / 2 / quarter, pi / 2))
    return waves(*rising, (straight, 0, 0, 0, 0), *falling)


def valve_lobe(*powers: int) -> Callable:
    """Lobe 1 + C2 x^2 + Cp x^p + ... from the nose at x = 0, with value and four derivatives 0 at x = 1; u = 1 - x."""
    each = np.array([2, *powers])
    rows = np.array([np.prod([each - below for below in range(order)], axis=0) * np.ones(5) for order in range(5)])
    values = np.linalg.solve(rows, [-1.0, 0, 0, 0, 0])

    def law(u: np.ndarray) -> np.ndarray:
        x = (1 - u)[:, None]
        return np.stack(
            [
                1 + (values * x**each).sum(axis=1),
                -(values * each * x ** (each - 1)).sum(axis=1),
                (values * each * (each - 1) * x ** (each - 2)).sum(axis=1),
            ]
        )

    return law


LAWS = {
    **LAWS,
    "polynomial_5_6_7_8_9": polynomial(0, 0, 0, 0, 0, 126, -420, 540, -315, 70),
    "gutman_1_3": _sines(1.0, (-15 / 32 / pi, TURN), (-1 / 96 / pi, 3 * TURN)),
    "freudenstein_1_3": _sines(1.0, (-27 / 28 / TURN, TURN), (-1 / 84 / TURN, 3 * TURN)),
    "double_harmonic": lambda u: np.stack(
        [
            ((1 - np.cos(pi * u)) - (1 - np.cos(2 * pi * u)) / 4) / 2,
            (pi * np.sin(pi * u) - pi / 2 * np.sin(2 * pi * u)) / 2,
            (pi**2 * np.cos(pi * u) - pi**2 * np.cos(2 * pi * u)) / 2,
        ]
    ),
    "unequal_parabola": waves((0.25, 3.0, 0, 0, 0), (0.75, -1.0, 0, 0, 0)),  # a_1 : a_2 = 3 : 1
    "half_cycloid_2": _sines(1.0, (1 / pi, pi)),
    "modified_sine_20": _straight_sine(0.2),
    "valve_lobe": valve_lobe(10, 18, 26, 34),
    "dwell": lambda u: np.zeros((3, len(u))),
}
# Shares of a law at which its acceleration bends or jumps.
_INNER = {"unequal_parabola": (0.25,), "constant_acceleration": (0.5,)}


@dataclass(frozen=True)
class Peak:
    """Extreme of a figure and its cam angle, degrees."""

    value: float
    at: float


@dataclass(frozen=True)
class Moved:
    """Motion in pieces: each has its two ends, rad, and its jets (lift and two derivatives, shape (3, n))."""

    pieces: tuple[tuple[float, float, Callable], ...]

    @classmethod
    def of_spans(cls, spans: Sequence[tuple[float, float, str]], repeat: int = 1) -> Moved:
        """Motion of spans (width in degrees, height at the end, law) that are repeated over the turn."""
        pieces, at, before = [], 0.0, 0.0
        for _ in range(repeat):
            for width, to, law in spans:
                span = radians(width)
                cuts = sorted({0.0, *_INNER.get(law, (1 / 8, 1 / 4, 3 / 4, 7 / 8, 0.1, 0.4, 0.6, 0.9)), 1.0})
                for low, high in pairwise(cuts):
                    pieces.append((at + low * span, at + high * span, _span(at, span, before, to, law)))
                at, before = at + span, to
        return cls(tuple(pieces))

    @classmethod
    def of_whole(cls, jets: Callable, parts: int = 72) -> Moved:
        """Smooth motion over the whole turn."""
        edges = np.linspace(0.0, TURN, parts + 1)
        return cls(tuple((low, high, jets) for low, high in pairwise(edges)))

    def at(self, theta: float) -> np.ndarray:
        """Lift and two derivatives at a cam angle."""
        theta %= TURN
        return next(jets for low, high, jets in self.pieces if low <= theta <= high + 1e-12)(np.array([theta]))

    def jets(self, theta: np.ndarray) -> np.ndarray:
        """Lift and two derivatives at cam angles, shape (3, n)."""
        theta = np.mod(theta, TURN)
        number = np.clip(np.searchsorted([piece[1] for piece in self.pieces], theta), 0, len(self.pieces) - 1)
        found = np.empty((3, len(theta)))
        for at in np.unique(number):
            found[:, number == at] = self.pieces[at][2](theta[number == at])
        return found

    def extremes(self, figure: Callable) -> tuple[Peak, Peak]:
        """Greatest and least of a figure, a function of jets and cam angles, over all pieces with their own ends."""
        best = [Peak(-np.inf, 0.0), Peak(np.inf, 0.0)]
        for low, high, jets in self.pieces:
            first = np.linspace(low, high, PIECE)
            for number, sign in enumerate((1.0, -1.0)):
                theta = first
                for _ in range(ZOOMS):
                    values = sign * figure(jets(theta), theta)
                    worst = int(np.nanargmax(values))
                    if values[worst] > sign * best[number].value:
                        best[number] = Peak(float(sign * values[worst]), float(np.degrees(theta[worst])))
                    theta = np.linspace(theta[max(worst - 1, 0)], theta[min(worst + 1, len(theta) - 1)], ZOOM)
        return best[0], best[1]

    def mean(self, figure: Callable) -> float:
        """Mean of a figure over the turn, by Gauss's points in every piece."""
        node, weight = np.polynomial.legendre.leggauss(60)
        total = 0.0
        for low, high, jets in self.pieces:
            theta = low + (high - low) * (node + 1) / 2
            total += float((figure(jets(theta), theta) * weight).sum() * (high - low) / 2)
        return total / TURN


def _span(at: float, width: float, before: float, to: float, law: str) -> Callable:
    def jets(theta: np.ndarray) -> np.ndarray:
        u = np.clip((theta - at) / width, 0.0, 1.0)
        shares = LAWS[law](u)
        if to < before and law in ("valve_lobe", "double_harmonic"):  # laws that lead to a top are run backwards
            shares = np.array([[1], [0], [0]]) + np.array([[-1], [1], [-1]]) * LAWS[law](1 - u)
        found = shares * (to - before) / width ** np.arange(3)[:, None]
        found[0] += before
        return found

    return jets


@dataclass(frozen=True)
class Round:
    """Roller or knife edge: base circle and radius; on a slide its offset, on an arm its length, distance and side."""

    base: float
    radius: float
    offset: float = 0.0
    arm: float = 0.0
    distance: float = 0.0
    side: int = 1

    @cached_property
    def rest(self) -> float:
        prime = self.base + self.radius
        if self.arm:
            return float(np.arccos((self.distance**2 + self.arm**2 - prime**2) / (2 * self.distance * self.arm)))
        return sqrt(prime**2 - self.offset**2)

    def _path(self, jets: np.ndarray) -> tuple[np.ndarray, ...]:
        """Centre, its two derivatives by the cam angle, and the unit way of the centre, all in the fixed frame."""
        q, v, a = jets
        if not self.arm:
            return self.offset + 1j * (self.rest + q), 1j * v, 1j * a, np.full(len(q), 1j)
        # From the pivot the arm points along -exp(-i side delta).
        turned = -1j * self.side
        arm = -self.arm * np.exp(turned * (self.rest + q))
        return self.distance + arm, turned * v * arm, (turned * a + (turned * v) ** 2) * arm, turned * arm / self.arm

    def _normal(self, jets: np.ndarray) -> np.ndarray:
        z, z1, _, _ = self._path(jets)
        along = z1 - 1j * z
        return 1j * along / np.abs(along)

    def angle(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Signed pressure angle, degrees."""
        return (self.side if self.arm else 1) * np.degrees(np.angle(self._normal(jets) / self._path(jets)[3]))

    def pitch_radius(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Radius of curvature of the path of the centre, mm, positive where convex."""
        z, z1, z2, _ = self._path(jets)
        first, second = z1 - 1j * z, z2 - 2j * z1 - z
        with np.errstate(divide="ignore"):
            return -(np.abs(first) ** 3) / (first.conj() * second).imag

    def profile_radius(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return self.pitch_radius(jets, theta) - self.radius

    def contact(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Contact in the cam's frame, mm."""
        return (self._path(jets)[0] - self.radius * self._normal(jets)) * np.exp(-1j * theta)

    def gap(self, points: np.ndarray, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Distance of points of the cam from the follower, mm."""
        return np.abs(points * np.exp(1j * theta) - self._path(jets)[0]) - self.radius

    def need(self, points: np.ndarray, theta: float) -> float:
        """Least motion that clears points of the cam."""
        at = points * np.exp(1j * theta)
        if self.arm:
            seen = self.distance - at
            far, turned = np.abs(seen), -self.side * np.angle(seen)
            near = np.abs(far - self.arm) < self.radius
            cosine = (self.arm**2 + far[near] ** 2 - self.radius**2) / (2 * self.arm * far[near])
            return float((turned[near] + np.arccos(cosine)).max() - self.rest)
        across = at.real - self.offset
        near = np.abs(across) < self.radius
        return float((at[near].imag + np.sqrt(self.radius**2 - across[near] ** 2)).max() - self.rest)

    def share(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Force along the motion by the normal force: cos alpha, or the arm's lever, mm."""
        return np.cos(np.radians(self.angle(jets, theta))) * (self.arm or 1.0)


@dataclass(frozen=True)
class OuterFlank(Round):
    """Outer flank of a groove, which the roller touches on its far side."""

    def contact(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return (self._path(jets)[0] + self.radius * self._normal(jets)) * np.exp(-1j * theta)

    def need(self, points: np.ndarray, theta: float) -> float:
        """Greatest motion that stays within the flank."""
        at = points * np.exp(1j * theta)
        if self.arm:
            seen = self.distance - at
            far, turned = np.abs(seen), -self.side * np.angle(seen)
            near = (np.abs(far - self.arm) < self.radius) & (turned > 0)
            cosine = (self.arm**2 + far[near] ** 2 - self.radius**2) / (2 * self.arm * far[near])
            return float((turned[near] - np.arccos(cosine)).min() - self.rest)
        across = at.real - self.offset
        near = (np.abs(across) < self.radius) & (at.imag > 0)
        return float((at[near].imag - np.sqrt(self.radius**2 - across[near] ** 2)).min() - self.rest)


@dataclass(frozen=True)
class Face:
    """Flat face: base circle; on a slide tilt and offset, on an arm distance of the pivot, of the face, and side."""

    base: float
    tilt: float = 0.0
    offset: float = 0.0
    distance: float = 0.0
    off: float = 0.0
    side: int = 1
    radius: float = np.inf

    @cached_property
    def rest(self) -> float:
        return float(np.arcsin((self.base + self.off) / self.distance)) if self.distance else 0.0

    def _line(self, jets: np.ndarray) -> tuple[np.ndarray, ...]:
        """Normal; its distance h with dh/dpsi and the radius h + d2h/dpsi2."""
        q, v, a = jets
        if not self.distance:
            t = radians(self.tilt)
            return (
                np.full(len(q), 1j * np.exp(1j * t)),
                self.base + q * cos(t),
                -v * cos(t),
                self.base + (q + a) * cos(t),
            )
        delta, c = self.rest + q, self.distance
        h, h1 = c * np.sin(delta) - self.off, c * np.cos(delta) * v
        h2 = c * np.cos(delta) * a - c * np.sin(delta) * v**2
        turn, turn1 = -(1 + self.side * v), -self.side * a
        slope = h1 / turn
        bend = (h2 * turn - h1 * turn1) / turn**2 / turn
        return np.sin(delta) + 1j * self.side * np.cos(delta), h, slope, h + bend

    def contact(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        normal, h, slope, _ = self._line(jets)
        return (h + 1j * slope) * normal * np.exp(-1j * theta)

    def along(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Place of the contact on the face, mm: from where the slide's axis cuts it, or from the pivot's foot."""
        touch, t = self.contact(jets, theta) * np.exp(1j * theta), radians(self.tilt)
        if self.distance:
            way = -np.cos(self.rest + jets[0]) + 1j * self.side * np.sin(self.rest + jets[0])
            return ((touch - self.distance) * way.conj()).real
        h = self._line(jets)[1]
        axis = self.offset + 1j * (h + self.offset * sin(t)) / cos(t)
        return ((touch - axis) * np.exp(-1j * t)).real

    def angle(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        if self.distance:
            return np.degrees(np.arctan2(self.off, self.along(jets, theta)))
        return np.full(len(theta), -self.tilt)

    def profile_radius(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return self._line(jets)[3]

    def gap(self, points: np.ndarray, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        normal, h, _, _ = self._line(jets)
        return h - (points * np.exp(1j * theta) * normal.conj()).real

    def need(self, points: np.ndarray, theta: float) -> float:
        at = points * np.exp(1j * theta)
        if self.distance:
            seen = self.distance - at
            return float((-self.side * np.angle(seen) + np.arcsin(self.off / np.abs(seen))).max() - self.rest)
        normal = 1j * np.exp(1j * radians(self.tilt))
        return float(((at * normal.conj()).real.max() - self.base) / cos(radians(self.tilt)))

    def share(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return self.along(jets, theta) if self.distance else np.cos(np.radians(self.angle(jets, theta)))


@dataclass(frozen=True)
class Body:
    """Body that a follower carries: mass or inertia, damping, spring, preload and load, in N, mm and s."""

    inertia: float = 0.0
    damping: float = 0.0
    rate: float = 0.0
    preload: float = 0.0
    load: float = 0.0
    speed: float = 0.0
    width: float = 10.0

    def along(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        q, v, a = jets
        moved = self.inertia * self.speed**2 * a + self.damping * self.speed * v
        return moved + self.rate * q + self.preload + self.load

    def torque(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        return self.along(jets, theta) * jets[1]

    def lift_off(self, jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        """Least positive speed, rad/s, at which the force along the motion is 0; infinite where there is none."""
        a, b = self.inertia * jets[2], self.damping * jets[1]
        c = self.rate * jets[0] + self.preload + self.load
        with np.errstate(all="ignore"):
            root = np.sqrt(b * b - 4 * a * c)
            both = np.stack([2 * c / (-b - root), 2 * c / (-b + root)])
        return np.where(both > 0, both, np.inf).min(axis=0)


def pressure(follower: Round | Face, body: Body) -> Callable:
    """Hertz's pressure of two parts of steel, MPa, as a figure."""

    def figure(jets: np.ndarray, theta: np.ndarray) -> np.ndarray:
        normal = body.along(jets, theta) / follower.share(jets, theta)
        bend = 1 / follower.profile_radius(jets, theta) + 1 / follower.radius
        return np.sqrt(np.maximum(normal * HALF_STEEL * bend / pi / body.width, 0.0))

    return figure


def lost_lift(motion: Moved, follower: Round | Face) -> Peak:
    """Greatest lift that is lost on the trimmed envelope: no point of it may lie within the follower at any angle.

    On an outer flank it is the lift by which the roller is led too far.
    """
    theta = np.linspace(0.0, TURN, 3601)[:-1]
    touch, other = follower.contact(motion.jets(theta), theta), theta
    jets = motion.jets(other)
    deep = np.array([follower.gap(np.array([point]), jets, other).min() for point in touch])
    kept = deep > -5e-5

    def inside(at: float) -> bool:
        point = follower.contact(motion.at(at), np.array([at]))
        gap = follower.gap(point, jets, other)
        for low in np.argsort(gap)[:3]:
            near = np.linspace(other[low] - 0.004, other[low] + 0.004, 81)
            if follower.gap(point, motion.jets(near), near).min() < -1e-7:
                return True
        return False

    points, gone = [touch[kept]], []
    for number in np.flatnonzero(kept & ~np.roll(kept, -1)):
        stop = number + 1
        while not kept[stop % len(theta)]:
            stop += 1
        for good, bad in (
            (theta[number], theta[(number + 1) % len(theta)]),
            (theta[stop % len(theta)], theta[stop - 1]),
        ):
            for _ in range(36):
                middle = (good + bad) / 2
                good, bad = (good, middle) if inside(middle) else (middle, bad)
            points.append(follower.contact(motion.at(good), np.array([good])))
        gone.append((theta[number], theta[number] + (stop - number) * TURN / len(theta)))
    outline = np.concatenate(points)
    best = Peak(0.0, 0.0)
    for low, high in gone:
        at = np.linspace(low, high, 61)
        for _ in range(4):
            lost = [abs(float(motion.at(one)[0, 0]) - follower.need(outline, one)) for one in at]
            worst = int(np.argmax(lost))
            if lost[worst] > best.value:
                best = Peak(lost[worst], float(np.degrees(at[worst]) % 360))
            at = np.linspace(at[max(worst - 1, 0)], at[min(worst + 1, len(at) - 1)], 21)
    return best
