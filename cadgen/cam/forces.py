"""Forces between cam and follower: what presses the follower on the disc, and what the camshaft has to turn.

The follower is rigid, and the camshaft turns at a constant speed w. Along its motion q the follower needs the force

    F = m w^2 q'' + c w q' + k q + P + L(theta) - m g cos(gamma),

with the mass m, damping c, rate k and preload P of a spring, a load L, and the angle gamma between motion and weight.
At 180 degrees the weight presses the follower on the disc. On an arm these are a moment, with the moment of inertia,
and rad. Its weight, at a distance d from the pivot, has the moment -m g d cos(gamma - q). The force along the normal
and the camshaft's torque are

    N = F / a,  T = F q',

where a is the displacement along the normal by the motion, cos(alpha) on a slide: what the follower is asked for. A
guide has the length B, the overhang A and the friction mu. It takes mu (2 A + B) / B |sin(alpha)| off a while the
follower moves outwards, and adds it while it moves inwards; then T = N a q'. Springs, inertia and weight do no work in
a turn.

On the outer flank of a groove, and on the second disc of a conjugate pair, F is negative and presses with its size.

Lines of contact press by Hertz's p = sqrt(N E* / (pi b rho*)) with 1/rho* = 1/rho + 1/r. The radius rho of the profile
is negative where it is hollow, and 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 (Johnson, Contact Mechanics, ch. 4).
"""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import inf, pi

import numpy as np
from scipy.optimize import brentq

from cadgen.arrays import TURN, Array, gauss_nodes
from cadgen.cam.follower import Follower
from cadgen.laws.motion import Motion, Peak

GRAVITY = 9.80665  # m/s², of a mass in kg in N
_NODES = 12  # of a quadrature, on each of so many parts of a stretch between two seams
_PARTS = 32
_MOST_SEAMS = 500
_STATIONS = 7200  # of a turn, between which the force changes its sign once at most
_ROUNDING = 1e-12  # of the greatest force, or of all work: what is smaller is none
_PROOF = 1e-9  # of the greatest force; a proposal that leaves less is proved


@dataclass(frozen=True, kw_only=True)
class Load:
    """Load on the follower by the cam angle, straight from row to row and round the turn.

    Attributes:
        cam_angle: cam angles that grow, rad, shape (n,).
        value: load at them, N or N mm, shape (n,).
    """

    cam_angle: Array
    value: Array

    def at(self, cam_angle: Array) -> Array:
        """Load at cam angles, N or N mm, shape (n,).

        Args:
            cam_angle: cam angles, rad.
        """
        return np.interp(cam_angle % TURN, self.cam_angle, self.value, period=TURN)


@dataclass(frozen=True, kw_only=True)
class Guide:
    """Guide of a slide.

    Attributes:
        friction: coefficient of friction, dimensionless.
        length: length of the guide, mm.
        overhang: distance of the contact's side of the guide from the contact, mm.
    """

    friction: float
    length: float
    overhang: float

    @property
    def share(self) -> float:
        """Force along the motion that friction takes, by the force across it: mu (2 A + B) / B."""
        return self.friction * (2 * self.overhang + self.length) / self.length


@dataclass(frozen=True, kw_only=True)
class Line:
    """Line of contact between two materials.

    Attributes:
        width: length of the line, mm.
        modulus: modulus E* of both together, MPa.
        radius: radius of the follower, mm; infinite for a flat face.
        other_radius: radius of the follower on the second disc, or of the same one on the outer flank of a groove, mm.
    """

    width: float
    modulus: float
    radius: float
    other_radius: float = inf


def joint_modulus(one: tuple[float, float], other: tuple[float, float]) -> float:
    """Modulus E* of two bodies in contact, MPa.

    Args:
        one, other: modulus of elasticity, MPa, and Poisson's ratio of each.
    """
    return 1 / sum((1 - ratio**2) / modulus for modulus, ratio in (one, other))


@dataclass(frozen=True, kw_only=True)
class Dynamics:
    """Mass, spring, damping and load of a follower.

    Attributes:
        inertia: mass, N s²/mm, that is 1000 kg; or moment of inertia, N mm s².
        rate: rate of the spring, N/mm or N mm/rad.
        preload: force of the spring at q = 0, N or N mm.
        damping: N s/mm or N mm s/rad.
        load: load by the cam angle; a number if it is the same everywhere, N or N mm.
        weight: weight of the follower, N; on an arm its greatest moment about the pivot, N mm; 0 where none counts.
        downhill: angle from the motion outwards at q = 0 to the weight, rad; on an arm in the sense in which it lifts.
        swings: whether the motion turns against the weight, as that of an arm does.
        guide: guide with friction; None without.
        line: line of contact; None where nothing is said of it, or the contact is a point.
    """

    inertia: float = 0.0
    rate: float = 0.0
    preload: float = 0.0
    damping: float = 0.0
    load: float | Load = 0.0
    weight: float = 0.0
    downhill: float = pi
    swings: bool = False
    guide: Guide | None = None
    line: Line | None = None


@dataclass(frozen=True)
class CamForces:
    """Forces on a follower and its camshaft at a speed.

    Attributes:
        motion: motion of the follower.
        follower: follower.
        dynamics: mass, spring, damping and load.
        speed: speed of the camshaft, rad/s; 0 for a standing one.
        closed: whether a groove or a second disc holds the follower, so that it does not leave where the force is
            negative, but changes its flank.
        second: follower on the second disc of a conjugate pair, which then carries; None without one.
    """

    motion: Motion
    follower: Follower
    dynamics: Dynamics
    speed: float
    closed: bool = False
    second: Follower | None = None

    def resting(self, jets: Array, cam_angle: Array) -> Array:
        """Force along the motion at rest: spring, load and weight, N or N mm, shape (n,).

        Args:
            jets: motion with three derivatives, as of `Motion.jets`, shape (n, 4).
            cam_angle: cam angles, rad, shape (n,).
        """
        body = self.dynamics
        load = body.load.at(cam_angle) if isinstance(body.load, Load) else body.load
        heavy = body.weight * np.cos(body.downhill - (jets[:, 0] if body.swings else 0.0))
        return np.asarray(body.rate * jets[:, 0] + body.preload + load - heavy)

    def along(self, jets: Array, cam_angle: Array) -> Array:
        """Force along the motion, N or N mm, shape (n,); negative where the follower would leave the disc.

        Args:
            jets: motion with three derivatives, in its unit by rad^k, shape (n, 4).
            cam_angle: cam angles, rad, shape (n,).
        """
        moving = self.dynamics.inertia * self.speed**2 * jets[:, 2] + self.dynamics.damping * self.speed * jets[:, 1]
        return np.asarray(self.resting(jets, cam_angle) + moving)

    def normal(self, jets: Array, cam_angle: Array) -> Array:
        """Force along the outline's normal, N, shape (n,); infinite where the guide jams.

        It is negative where the follower would leave, or the other flank or the second disc carries.

        Args:
            jets: motion with three derivatives, in its unit by rad^k, shape (n, 4).
            cam_angle: cam angles, rad, shape (n,).
        """
        along, push = self.along(jets, cam_angle), self.follower.push(jets[:, 0], jets[:, 1])
        if self.second is not None:
            push = np.where(along < 0, self.second.push(-jets[:, 0], -jets[:, 1]), push)
        # Friction acts against the motion, on whichever flank the follower is.
        free = push - np.sign(jets[:, 1] * np.where(along < 0, -1.0, 1.0)) * self._held(push)
        with np.errstate(divide="ignore"):
            return np.where(free > 0, along / free, inf)

    def torque(self, jets: Array, cam_angle: Array) -> Array:
        """Torque on the camshaft, N mm, shape (n,); positive where the camshaft drives the follower.

        Args:
            jets: motion with three derivatives, in its unit by rad^k, shape (n, 4).
            cam_angle: cam angles, rad, shape (n,).
        """
        if self.dynamics.guide is None:
            return np.asarray(self.along(jets, cam_angle) * jets[:, 1])
        along, push = self.along(jets, cam_angle), self.follower.push(jets[:, 0], jets[:, 1])
        if self.second is not None:
            push = np.where(along < 0, self.second.push(-jets[:, 0], -jets[:, 1]), push)
        return np.asarray(self.normal(jets, cam_angle) * push * jets[:, 1])

    def pressure(self, jets: Array, cam_angle: Array) -> Array:
        """Greatest pressure in the line of contact, MPa, shape (n,); 0 where nothing presses or there is no line.

        Args:
            jets: motion with three derivatives, in its unit by rad^k, shape (n, 4).
            cam_angle: cam angles, rad, shape (n,).
        """
        line = self.dynamics.line
        if line is None:
            return np.zeros(len(jets))
        q, q1, q2 = jets[:, :3].T
        normal, rho = self.normal(jets, cam_angle), self.follower.profile_radius(q, q1, q2)
        radius = np.full_like(q, line.radius)
        if self.closed:
            # The other flank of a groove lies across its width from the first one, and its metal on the other side.
            other = (
                -(rho + 2 * self.follower.radius) if self.second is None else self.second.profile_radius(-q, -q1, -q2)
            )
            rho = np.where(normal < 0, other, rho)
            radius = np.where(normal < 0, line.other_radius, radius)
            normal = np.abs(normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            curvature = 1 / rho + 1 / radius
        pressed = np.maximum(normal, 0.0)
        return np.asarray(np.sqrt(pressed * line.modulus * np.maximum(curvature, 0.0) / (pi * line.width)))

    def _held(self, push: Array) -> Array:
        """Displacement along the normal whose force the friction of the guide takes, dimensionless, shape (n,)."""
        guide = self.dynamics.guide
        return np.zeros_like(push) if guide is None else guide.share * np.sqrt(np.maximum(1 - push**2, 0.0))

    @cached_property
    def jams(self) -> Peak:
        """Least displacement along the normal that guide friction leaves while the follower moves outwards.

        It is 0 or less where the guide jams, at tan(alpha) = B / (mu (2 A + B)).
        """

        def left(jets: Array, cam_angle: Array) -> Array:
            push = self.follower.push(jets[:, 0], jets[:, 1])
            return np.asarray(push - np.where(jets[:, 1] > 0, self._held(push), 0.0))

        return self.motion.extremes_of(left)[1]

    @cached_property
    def lift_off(self) -> Peak:
        """Least speed at which the force along the motion is 0 anywhere, rad/s, with its place; infinite if none is.

        At each cam angle it is the least positive root of m q'' w^2 + c q' w + F_0 = 0.
        """

        def slowness(jets: Array, cam_angle: Array) -> Array:
            still = self.resting(jets, cam_angle)
            square, linear = self.dynamics.inertia * jets[:, 2], self.dynamics.damping * jets[:, 1]
            inside = linear**2 - 4 * square * still
            with np.errstate(divide="ignore", invalid="ignore"):
                found = (-linear + np.sqrt(np.maximum(inside, 0.0))) / (2 * still)
            # Without a positive root, or at rest beyond it already.
            found = np.where((inside < 0) | ((square >= 0) & (linear >= 0)), 0.0, found)
            return np.where(still <= 0, inf, np.maximum(found, 0.0))

        most = self.motion.extremes_of(lambda jets, theta: np.minimum(slowness(jets, theta), 1e9))[0]
        return Peak(inf if most.value <= 0 else 0.0 if most.value >= 1e9 else 1 / most.value, most.cam_angle)

    @cached_property
    def leaves(self) -> tuple[tuple[float, float], ...]:
        """Cam angles from which and to which the force along the motion is negative, rad; the last may pass a turn."""
        theta = np.unique(np.append(np.linspace(0.0, TURN, _STATIONS + 1)[:-1], self.motion.breaks[:-1]))

        def force(angle: float, before: bool = False) -> float:
            at = np.array([angle])
            return float(self.along(self.motion.jets(at, before=before), at)[0]) + rounding

        start = self.along(self.motion.jets(theta), theta)
        closed = np.append(theta[1:], TURN)
        stop = self.along(self.motion.jets(closed, before=True), closed)
        rounding = _ROUNDING * float(np.abs(start).max())
        start, stop = start + rounding, stop + rounding
        changes: list[tuple[float, bool]] = []
        for number, angle in enumerate(theta):
            if (stop[number - 1] < 0) != (start[number] < 0):
                changes.append((float(angle), bool(start[number] < 0)))
            if (start[number] < 0) != (stop[number] < 0):
                end = float(closed[number])
                place = brentq(lambda at, end=end: force(at, before=at == end), angle, end, xtol=1e-13)
                changes.append((float(place), bool(stop[number] < 0)))
        begins = [angle for angle, leaving in changes if leaving]
        ends = [angle for angle, leaving in changes if not leaving]
        if not begins:
            return ((0.0, TURN),) if start[0] < 0 else ()
        return tuple((begin, next((end for end in ends if end > begin), ends[0] + TURN)) for begin in begins)

    def least_rate(self) -> float | None:
        """Least rate of the spring that holds the follower with its preload, N/mm or N mm/rad; None if no rate does."""

        def needed(jets: Array, cam_angle: Array) -> Array:
            rest = self.along(jets, cam_angle) - self.dynamics.rate * jets[:, 0]
            with np.errstate(divide="ignore", invalid="ignore"):
                rate = np.where(jets[:, 0] > 0, -rest / jets[:, 0], np.where(rest < 0, inf, -inf))
            return np.clip(rate, -1e12, 1e12)

        most = max(self.motion.extremes_of(needed)[0].value, 0.0)  # where the lift is below 0 a weaker one may hold
        return most if most < 1e12 and self._holds(replace(self.dynamics, rate=most)) else None

    def least_preload(self) -> float | None:
        """Least preload that holds the follower with the spring's rate, N or N mm; None if it is not proved."""
        most = self.dynamics.preload - self.motion.extremes_of(self.along)[1].value
        return most if self._holds(replace(self.dynamics, preload=most)) else None

    def _holds(self, dynamics: Dynamics) -> bool:
        high, low = self.motion.extremes_of(replace(self, dynamics=dynamics).along)
        return low.value >= -_PROOF * max(abs(high.value), abs(low.value), 1e-9)

    @cached_property
    def work(self) -> float:
        """Work of the camshaft in a turn, N mm: that of damping and friction; 0 where it is but rounding."""
        seams = self.motion.breaks
        if isinstance(self.dynamics.load, Load):
            seams = np.unique(np.concatenate([seams, self.dynamics.load.cam_angle % TURN]))
        if len(seams) > _MOST_SEAMS:  # a table, without jumps of what is integrated
            seams = np.array([0.0, TURN])
        edges = np.unique(np.concatenate([np.linspace(a, b, _PARTS + 1) for a, b in pairwise(seams)]))
        nodes, weights = gauss_nodes(_NODES)
        width = np.diff(edges)[:, None]
        theta = (edges[:-1, None] + width * (nodes + 1) / 2).ravel()
        parts = self.torque(self.motion.jets(theta), theta) * (width * weights / 2).ravel()
        work = float(parts.sum())
        return 0.0 if abs(work) < _ROUNDING * float(np.abs(parts).sum()) else work

    @property
    def mean_torque(self) -> float:
        """Mean torque of the camshaft, N mm."""
        return self.work / TURN
