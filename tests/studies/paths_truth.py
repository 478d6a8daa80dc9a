"""Properties of a cam for a path, by brute force: no line of cadgen is used here.

The path's curvature from scipy's spline, the lift by its definition, derivatives by differences, and the disc as the
nearest crossing of each ray with any of thousands of ellipses.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline, make_interp_spline

TURN = 2 * np.pi
PER_SPAN = 64
LEAST_SAMPLES = 12_000


@dataclass(frozen=True)
class Truth:
    """A path on a car, as numbers; mm and rad."""

    waypoints: np.ndarray
    kind: str
    offset: float
    wheelbase: float
    wheel: float
    base: float
    faces: tuple[float, float]
    rod: float
    blend: float

    @cached_property
    def _spline(self) -> tuple[object, np.ndarray]:
        """The spline through the waypoints, and the parameters of these."""
        points = self.waypoints
        if self.kind == "quintic":
            u = np.concatenate([[0.0], np.cumsum(np.sqrt(np.linalg.norm(np.diff(points, axis=0), axis=1)))])
            ends = [(3, np.zeros(2)), (4, np.zeros(2))]
            return make_interp_spline(u, points, k=5, bc_type=(ends, ends)), u
        u = np.arange(len(points), dtype=float)
        first = (-11 * points[0] + 18 * points[1] - 9 * points[2] + 2 * points[3]) / 6
        return CubicSpline(u, points, bc_type=((1, first), (2, np.zeros(2)))), u

    def _along(self, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Travel of the drive wheel by parameter, mm, and tan(beta), at parameters."""
        spline, _ = self._spline
        d1, d2 = spline(at, 1), spline(at, 2)
        speed = np.hypot(*d1.T)
        bend = (d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]) / speed**3
        shrink = 1 - self.offset * bend
        right = -bend / shrink
        return speed * shrink, self.wheelbase * right / (1 - self.wheel * right)

    @cached_property
    def _samples(self) -> tuple[np.ndarray, np.ndarray]:
        """Cam angle and tan(beta) along the whole path, dense; a span's two ends lie a little inside it."""
        _, u = self._spline
        spans = len(self.waypoints) - 1
        each = PER_SPAN * max(1, round(LEAST_SAMPLES / PER_SPAN / spans))
        share = (np.arange(each) + 0.5) / each
        travel, tangent = self._along((u[:-1, None] + np.diff(u)[:, None] * share).ravel())
        length = np.concatenate([[0.0], np.cumsum(travel * np.repeat(np.diff(u) / each, each))])
        return TURN * (length[:-1] + length[1:]) / 2 / length[-1], tangent

    def _first(self) -> tuple[np.ndarray, np.ndarray]:
        """Cam angle and tan(beta) close by the start, where a cubic may bend within a thousandth of its first span."""
        theta, _ = self._samples
        _, u = self._spline
        step = (u[1] - u[0]) * 1e-5
        travel, tangent = self._along(u[0] + step * (np.arange(9) + 0.5))
        whole = len(theta) // (len(self.waypoints) - 1)
        first_span = np.sum(self._along(u[0] + np.diff(u[:2]) * (np.arange(whole) + 0.5) / whole)[0])
        # The first span's share of the turn is known from the samples.
        span_angle = (theta[whole - 1] + theta[whole]) / 2
        angle = np.cumsum(travel) - travel / 2
        return angle * step * span_angle / (first_span * (u[1] - u[0]) / whole), tangent

    def nodes_angle(self) -> np.ndarray:
        """Cam angles at every 64th of a span, where the track's nodes stand, rad."""
        theta, _ = self._samples
        each = len(theta) // (len(self.waypoints) - 1) // PER_SPAN
        edges = np.concatenate([[0.0], (theta[:-1] + theta[1:]) / 2, [TURN]])
        return np.asarray(edges[::each])

    @cached_property
    def steering(self) -> tuple[np.ndarray, np.ndarray]:
        """Cam angle and tan(beta) over one turn, closed by a quintic blend."""
        theta, tangent = self._samples
        start = TURN - self.blend
        jets = []
        last = np.flatnonzero(theta < start)[-9:]
        for place, (x, y) in ((start, (theta[last], tangent[last])), (0.0, self._first())):
            fit = np.polynomial.Polynomial.fit(x - place, y, 4)
            jets.append([fit.deriv(order)(0.0) if order else fit(0.0) for order in range(3)])
        h = self.blend
        rows, wanted = [], []
        for x, jet in zip((0.0, 1.0), jets, strict=True):
            rows += [[x**k for k in range(6)], [k * x ** max(k - 1, 0) for k in range(6)]]
            rows += [[k * (k - 1) * x ** max(k - 2, 0) for k in range(6)]]
            wanted += [jet[0], h * jet[1], h**2 * jet[2]]
        blend = np.linalg.solve(np.array(rows, dtype=float), np.array(wanted))
        driven = theta < start
        share = (np.arange(600) + 0.5) / 600
        closed = np.concatenate([theta[driven], start + h * share])
        return closed, np.concatenate([tangent[driven], np.polynomial.Polynomial(blend)(share)])

    @cached_property
    def _slopes(self) -> tuple[np.ndarray, np.ndarray]:
        theta, tangent = self.steering
        slope = np.gradient(tangent, theta)
        return slope, np.gradient(slope, theta)

    def hollow_corner(self) -> float:
        """Greatest angle by which the pitch curve's direction jumps outwards at a waypoint, rad; 0 for none."""
        theta, tangent = self._samples
        each = len(theta) // (len(self.waypoints) - 1)
        slopes = np.gradient(tangent, theta)
        # One-sided slopes in the middle of a span's last and first two steps, carried on to its ends.
        last, first = np.arange(each, len(theta), each) - 2, np.arange(each, len(theta), each) + 1
        ends = (1.5 * slopes[last] - 0.5 * slopes[last - 1], 1.5 * slopes[first] - 0.5 * slopes[first + 1])
        jump = self.faces[1] * (ends[1] - ends[0]) / self.base
        return max(float(jump.max(initial=0.0)), 0.0)

    def pressure_angle(self, *, driven: bool) -> float:
        """Greatest angle of the pitch curve against the ray, rad."""
        theta, tangent = self.steering
        face = np.where(tangent >= 0, *self.faces)
        angle = np.arctan2(np.abs(face * self._slopes[0]), self.base + face * tangent)
        mine = (theta < TURN - self.blend) == driven
        return float(angle[mine].max())

    @cached_property
    def radii(self) -> tuple[float, float]:
        """Least convex and least hollow radius of the pitch curve, either face, mm."""
        _, tangent = self.steering
        bends = []
        for face in self.faces:
            r, r1, r2 = self.base + face * tangent, face * self._slopes[0], face * self._slopes[1]
            bends.append((r**2 + 2 * r1**2 - r * r2) / (r**2 + r1**2) ** 1.5)
        bend = np.concatenate(bends)
        return 1 / float(bend.max()), (1 / -float(bend.min()) if bend.min() < 0 else np.inf)

    def room(self) -> float:
        """Least distance of the camshaft from the rod's surface anywhere in the turn, mm; negative if they overlap."""
        _, T = self.steering
        face = np.where(T >= 0, *self.faces)
        return float((self.base + face * T - self.rod * np.sqrt(1 + T**2)).min())

    def greatest_steering(self) -> float:
        """Greatest steering angle on the path, rad."""
        return float(np.arctan(np.abs(self._samples[1])).max())

    def lost_lift(self) -> float:
        """Greatest lift that the disc cannot give where the path steers, mm, by cutting and rolling with ellipses."""
        theta, tangent = self.steering
        grid = np.linspace(0, TURN, 24_000, endpoint=False)
        T = np.interp(grid, theta, tangent, period=TURN)
        window = int(np.ceil((self.rod / (self.base / 2) + 0.02) / (grid[1] - grid[0])))
        disc = np.full(len(grid), np.inf)
        root = np.sqrt(1 + T**2)
        for shift in range(-window, window + 1):
            c, s = np.cos(shift * grid[1]), np.sin(shift * grid[1])
            A, r = np.roll(self.rod * root, -shift), self.rod
            for face in self.faces:
                d = np.roll(self.base + face * T, -shift)
                qa, qb, qc = (c / A) ** 2 + (s / r) ** 2, -2 * c * d / A**2, (d / A) ** 2 - 1
                inside = qb**2 - 4 * qa * qc
                hit = inside >= 0
                near = np.where(hit, (-qb - np.sqrt(np.where(hit, inside, 0.0))) / (2 * qa), np.inf)
                disc = np.minimum(disc, near)
        real = np.full(len(grid), -np.inf)
        for shift in range(-window, window + 1):
            c, s = np.cos(shift * grid[1]), np.sin(shift * grid[1])
            radius = np.roll(disc, -shift)
            x, y = radius * c, radius * s
            h2 = self.rod**2 - y**2
            under = h2 > 0
            h = np.sqrt(np.where(under, h2, 0.0))
            for face in self.faces:
                u = x - self.base
                needed = (face * u + h * np.sqrt(u * u + face**2 - h * h)) / (face**2 - h * h)
                real = np.maximum(real, np.where(under, needed, -np.inf))
        lost = np.where(T >= 0, *self.faces) * (T - real)
        return float(lost[grid < TURN - self.blend].max())
