"""The leaning rod: a straight round rod that leans with the steering, on the two edges of a disc's rim.

The rod's axis lies in the horizontal plane of the camshaft and turns about the fork axis. In the plane at lateral
distance w from that its section at cam angle theta is the ellipse

    X(theta, eta) = (d - A cos eta) e_r(theta) - r sin eta e_t(theta),
    d = a + w T(theta),  A = r sqrt(1 + T^2),  T = tan(beta).

**Envelope.** The ellipse touches its neighbours where dX/dtheta is parallel to dX/deta (Litvin, Gear Geometry and
Applied Theory, sec. 6.1):

    (d' - A' cos eta + r sin eta) r cos eta + (d - A cos eta) A sin eta = 0.

**Rolling.** In the plane w the rod clears a point x ahead of the camshaft and y across when

    x <= a + w T - h sqrt(1 + T^2),  h^2 = r^2 - y^2,

so the least T that clears it is the greater root of a quadratic,

    T = (w u + h sqrt(u^2 + w^2 - h^2)) / (w^2 - h^2),  u = x - a.

Between the faces the bound is linear in w, so the faces decide.

**First order.** The rod, at T, rests on a point at x = a + w T - h sqrt(1 + T^2). No point asks for more, so to first
order the point stays the same one, and with D = w - h T / sqrt(1 + T^2)

    dT = (dx - sqrt(1 + T^2) (y / h) dy - da - T dw + sqrt(1 + T^2) (r / h) dr) / D,

where dx, dy and dw are how far the point itself is displaced.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import cam_place
from cadgen.cam.contact import ROLLING_TOLERANCE
from cadgen.cam.follower import (
    OUTLINE_POINTS,
    Branch,
    Contact,
    EdgeFollower,
    FirstOrder,
    LossRemedy,
    OwnSection,
    RolledCam,
    Swept,
    span_jets,
    turned,
)
from cadgen.cam.lower_hull import SAME
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Jet, Piece
from cadgen.curves.piecewise import zeros
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message
from cadgen.parts.blank import Blank


def rod_half_width(radius: float, T: Array, T1: Array, T2: Array) -> tuple[Array, Array, Array]:
    """The section's semi-axis r / cos(beta) = r sqrt(1 + T^2), mm, with two derivatives.

    Args:
        radius: radius r of the rod, mm.
        T: tan(beta), shape (n,).
        T1: its first derivative by the cam angle, 1/rad.
        T2: its second derivative, 1/rad².
    """
    root = np.sqrt(1.0 + T**2)
    return radius * root, radius * T * T1 / root, radius * (T1**2 / root**3 + T * T2 / root)


@dataclass(frozen=True)
class PolarPiece:
    """R(phi) = a + w T(phi) - r sqrt(1 + T(phi)^2), with T = tan(beta), over a span without kinks.

    With r = 0 this is the theoretical profile in the face plane w; with the rod's radius, the formula of the
    paper's appendix, which subtracts the rod's half-width along the cam's radius.
    """

    motion: Motion
    base_radius: float
    face: float
    rod_radius: float
    start: float
    stop: float

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the polar angle t (rad), and curvature.

        Args:
            t: polar angles, rad, shape (n,).
        """
        T, T1, T2 = span_jets(self.motion, t, self.start, self.stop)
        A, A1, A2 = rod_half_width(self.rod_radius, T, T1, T2)
        R = self.base_radius + self.face * T - A
        R1, R2 = self.face * T1 - A1, self.face * T2 - A2
        radial = np.stack([np.cos(t), np.sin(t)], axis=1)
        around = np.stack([-np.sin(t), np.cos(t)], axis=1)
        speed2 = R**2 + R1**2
        return Jet(
            R[:, None] * radial,
            R1[:, None] * radial + R[:, None] * around,
            (R**2 + 2 * R1**2 - R * R2) / speed2**1.5,
        )


def theoretical_profile(motion: Motion, follower: EdgeFollower) -> ClosedCurve:
    """R = a + s: where the rod's axis crosses the plane of the face it rests on (paper, section 2.5)."""
    return _polar_profile(motion, follower, rod_radius=0.0)


def published_profile(motion: Motion, follower: EdgeFollower) -> ClosedCurve:
    """The profile by the formula of the paper's appendix.

    It is not the envelope: the rod touches beside the ray, not on it, so it rides up to 0.30 mm too high on the
    paper's car (0.27 mm at the inner face). It is offered for comparison.
    """
    return _polar_profile(motion, follower, rod_radius=follower.radius)


def _polar_profile(motion: Motion, follower: EdgeFollower, *, rod_radius: float) -> ClosedCurve:
    inside = _face_changes(motion, follower)
    joints = np.unique(
        np.concatenate([[0.0], motion.kinks, motion.bends, inside[(inside > 0) & (inside < TURN)], [TURN]])
    )
    nodes, _ = motion.stations
    pieces: list[Piece] = []
    for start, stop in pairwise(joints):
        theta = np.append(nodes[(nodes > start) & (nodes < stop)], (start + stop) / 2)
        q = motion.q(theta)
        face = float(follower.contact_face(q[np.argmax(np.abs(q))]))
        pieces.append(PolarPiece(motion, follower.base_radius, face, rod_radius, float(start), float(stop)))
    return ClosedCurve(tuple(pieces))


def _face_changes(motion: Motion, follower: EdgeFollower) -> Array:
    """Cam angles at which the rod goes over to the other face, rad.

    Where the steering is straight over a stretch tan(beta) changes its sign by rounding: a change counts if between
    it and the next one the two faces' radii differ by more than `SAME`.
    """
    roots = zeros(motion.q, jumps=True)
    roots = np.unique(roots[np.isfinite(roots)])
    nodes, T = motion.stations
    clear = np.flatnonzero(np.abs(T) * follower.land > SAME)
    changed = np.flatnonzero(np.diff(np.sign(T[clear])) != 0)
    before, after = nodes[clear[changed]], nodes[clear[changed + 1]]
    # Of several roots in a row the last one before the steering is clear again.
    last = np.searchsorted(roots, after) - 1
    return roots[last[(last >= 0) & (roots[last] > before)]]


_NEWTON_STEPS = 20
_CONVERGED = 1e-13  # rad; Newton's method has doubled its digits past rounding
_JOINT = 1e-9  # rad; two pieces that touch the rod this close together meet
_SAMPLES = 3600  # of a turn


@dataclass(frozen=True, kw_only=True)
class EnvelopePiece(Swept):
    """The envelope in one face plane, by cam angle, over a span without kinks.

    Attributes:
        follower: the rod.
    """

    follower: "LeaningRod"

    def touch(self, theta: Array) -> Array:
        """The section's parameter eta at which it touches the envelope, rad.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        return self._touch(self._section(theta))

    def _touch(self, section: tuple[Array, Array, Array, Array, Array, Array]) -> Array:
        d, d1, _, A, A1, _ = section
        r, square = self.follower.radius, A**2
        eta = np.arctan2(-r * (d1 - A1), A * (d - A) + r**2)
        for _ in range(_NEWTON_STEPS):
            c, s = np.cos(eta), np.sin(eta)
            rc = r * c
            across, along = (d1 - A1 * c + r * s) * r, (d - A * c) * A
            f = across * c + along * s
            f_eta = (A1 * s + rc) * r * c - across * s + square * s**2 + along * c
            step = f / f_eta
            eta = eta - step
            if np.abs(step).max() < _CONVERGED:
                break
        return eta

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature; on a swallowtail the velocity points backwards.

        Args:
            t: cam angles, rad, shape (n,).
        """
        d, d1, d2, A, A1, A2 = section = self._section(t)
        r = self.follower.radius
        eta = self._touch(section)
        c, s = np.cos(eta), np.sin(eta)
        p, q = d - A * c, -r * s
        p1 = d1 - A1 * c
        f_eta = (A1 * s + r * c) * r * c - (p1 - q) * r * s + A**2 * s**2 + p * A * c
        f_theta = (d2 - A2 * c) * r * c + p1 * A * s + p * A1 * s
        eta1 = -f_theta / f_eta
        # Derivative along the envelope in the turning frame, and the angle of the tangent (A sin, -r cos) in it.
        As, rc = A * s, r * c
        ahead, aside = p1 - q + As * eta1, p - rc * eta1
        size2 = As**2 + rc**2
        turn = 1.0 + (As * r * s * eta1 + rc * (A * c * eta1 + A1 * s)) / size2
        speed = (ahead * -As + aside * rc) / np.sqrt(size2)
        with np.errstate(divide="ignore"):
            curvature = turn / speed
        ray = np.cos(t), np.sin(t)
        return Jet(turned(p, q, ray), turned(ahead, aside, ray), curvature)

    def _section(self, theta: Array) -> tuple[Array, Array, Array, Array, Array, Array]:
        T, T1, T2 = span_jets(self.motion, theta, self.start, self.stop)
        d = self.follower.base_radius + self.face * T
        return d, self.face * T1, self.face * T2, *rod_half_width(self.follower.radius, T, T1, T2)


@dataclass(frozen=True, kw_only=True)
class RodArc(OwnSection):
    """The rod's own section at a hollow kink of the lift, by t = -eta.

    Attributes:
        distance: distance of the rod's axis from the camshaft, mm.
        half_width: semi-axis along that distance, mm.
        follower: the rod.
    """

    distance: float
    half_width: float
    follower: "LeaningRod"

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the parameter t, and curvature (negative: the disc is hollow here).

        Args:
            t: parameters of the points, shape (n,).
        """
        A, r = self.half_width, self.follower.radius
        c, s = np.cos(t), np.sin(t)
        ray = np.cos(self.theta), np.sin(self.theta)
        return Jet(
            turned(self.distance - A * c, r * s, ray),
            turned(A * s, r * c, ray),
            -A * r / (A**2 * s**2 + r**2 * c**2) ** 1.5,
        )


def rod_arc(before: EnvelopePiece, after: EnvelopePiece) -> RodArc | None:
    """The rod's own section between two pieces at a kink of the lift; None unless that is hollow."""
    follower, face = after.follower, after.face
    eta_before, eta_after = before.touch(np.array([before.stop]))[0], after.touch(np.array([after.start]))[0]
    if eta_after >= eta_before - _JOINT:
        return None
    T = float(after.motion.q(after.start))
    distance, half = follower.base_radius + face * T, follower.radius * float(np.sqrt(1 + T**2))
    return RodArc(
        distance=distance,
        half_width=half,
        follower=follower,
        face=face,
        theta=after.start,
        start=-eta_before,
        stop=-eta_after,
    )


def refuse_thick_rod(motion: Motion, follower: "LeaningRod") -> None:
    """Refuse a rod too thick for the cam's smallest radius.

    Raises:
        DesignError: it is so, and no disc remains.
    """
    theta = np.linspace(0, TURN, _SAMPLES, endpoint=False)
    T = motion.q(theta)
    room = follower.base_radius + follower.lift(T) - follower.radius * np.sqrt(1 + T**2)
    worst = int(np.argmin(room))
    if room[worst] <= 0:
        reach = follower.base_radius + follower.lift(T)[worst]
        raise DesignError(
            "at cam angle {angle:.1f} degrees the rod's axis is {reach:.2f} mm {side} the "
            "camshaft, but the rod's radius is {radius:g} mm, so nothing is left of the disc: lower "
            "follower.radius_mm or raise cam.base_radius_mm",
            angle=np.degrees(theta[worst]),
            reach=abs(reach),
            side=Message("from") if reach >= 0 else Message("beyond"),
            radius=follower.radius,
        )


# The chamfers recede at 45 degrees along the rim's normal; the rod, which leans along the radius, recedes by no more.
CHAMFER_LEAN = 45.0


def rod_checks(rod: "LeaningRod", cam: RolledCam) -> tuple[Check, ...]:
    """The checks of a rod on its cam.

    Args:
        rod: rod that is rolled.
        cam: on which.
    """
    theta = cam.contact.cam_angle
    return (
        _carrying_face(rod, cam),
        _reach(rod, theta, cam.positions, cam.blank),
        *_lean(theta, cam.positions, cam.blank, cam.limits.motion_key),
        *_hub(rod, theta, cam.positions, cam.blank),
    )


def _carrying_face(rod: "LeaningRod", cam: RolledCam) -> Check:
    """Check that the rod rests on the face of eq. 15, wherever the profile is its envelope."""
    contact = cam.contact
    due = rod.contact_face(cam.motion.q(contact.cam_angle))
    wrong = (contact.face != due) & (contact.margin > ROLLING_TOLERANCE) & ~cam.trimmed
    inner = float(np.mean(contact.face == rod.inner)) * 100
    return Check(
        CheckCode.WRONG_FACE,
        Message("wrong face carries"),
        float(np.sum(wrong)),
        "stations",
        0.0,
        Bound.MAX,
        Message("inner {inner:.0f} %, outer {outer:.0f} %", inner=inner, outer=100 - inner),
        Message("the rod rests on the other face than eq. 15 says: use --profile actual"),
    )


def _reach(rod: "LeaningRod", theta: Array, steering: Array, blank: Blank) -> Check:
    """The rod must cross the whole rim: its end lies beyond the outer face at every steering, shape (2, n)."""
    T = np.abs(steering).max(axis=0)
    # Of the end's rim, the point nearest to the fork lies r sin(beta) nearer than its centre.
    beyond = rod.length / np.sqrt(1 + T**2) - rod.radius * T / np.sqrt(1 + T**2)
    worst = int(np.argmin(beyond))
    return Check(
        CheckCode.ROD_PAST_RIM,
        Message("rod end beyond the rim"),
        float(beyond[worst] - blank.faces(rod.inner, rod.outer)[1]),
        "mm",
        0.0,
        Bound.MIN,
        cam_place(theta[worst]),
        Message("the rod slips off the disc's rim: raise follower.length_mm"),
    )


def _lean(theta: Array, steering: Array, blank: Blank, motion_key: str) -> list[Check]:
    """The rod rides on the land as long as it leans less than the chamfers do, at every steering, shape (2, n)."""
    if blank.edge_break == 0:
        return []
    T = np.abs(steering).max(axis=0)
    worst = int(np.argmax(T))
    return [
        Check(
            CheckCode.LEAN_OVER_CHAMFERS,
            Message("lean over the chamfers"),
            float(np.degrees(np.arctan(T[worst]))),
            "°",
            CHAMFER_LEAN,
            Bound.MAX,
            cam_place(theta[worst]),
            Message(
                "the rod leans so far that it rides on the broken edge: leave the edges sharp "
                "(blank.edge_break_mm) or widen the turn there ({key})",
                key=motion_key,
            ),
        )
    ]


def _hub(rod: "LeaningRod", theta: Array, steering: Array, blank: Blank) -> list[Check]:
    """The rod passes above the hub as well as above the disc, at every steering, shape (2, n)."""
    if blank.hub is None:
        return []
    inner, outer = blank.faces(rod.inner, rod.outer)
    ends = {
        "outer": (outer, outer + blank.hub.length),
        "inner": (inner - blank.hub.length, inner),
    }[blank.hub.side]
    nearest = np.min([rod.base_radius + w * steering for w in ends], axis=0)
    nearest = (nearest - rod.radius * np.sqrt(1 + steering**2)).min(axis=0)
    worst = int(np.argmin(nearest))
    return [
        Check(
            CheckCode.ROD_ABOVE_HUB,
            Message("rod above the hub"),
            float(nearest[worst]) - blank.hub.diameter / 2,
            "mm",
            0.0,
            Bound.MIN,
            cam_place(theta[worst]),
            Message("the rod meets the hub: lower blank.hub.diameter_mm or blank.hub.length_mm"),
        )
    ]


@dataclass(frozen=True, kw_only=True)
class LeaningRod(EdgeFollower):
    """The rod and the two planes in which the disc carries it.

    The rod leans, so it rides on an edge of the rim: on that of a face or, where the edges are broken by chamfers, on
    that of the land between them (`cadgen.parts.blank.Blank.carrying`).
    """

    noun = Message("rod")
    flatter = Message(
        "raise cam.base_radius_mm, widen the turn there, or raise cam.blend_deg if the closing blend steers there"
    )
    milder = Message("lower follower.radius_mm or raise cam.base_radius_mm")

    @property
    def reach(self) -> float:
        """The rod's radius, mm."""
        return self.radius

    def refuse(self, motion: Motion) -> None:
        """Refuse a lift for which the rod is too thick."""
        refuse_thick_rod(motion, self)

    def piece(self, motion: Motion, face: float, start: float, stop: float) -> EnvelopePiece:
        """The envelope of the rod's ellipse in a plane between two cam angles, rad.

        Args:
            motion: motion wanted.
            face: distance of the plane from the fork axis, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """
        return EnvelopePiece(motion=motion, follower=self, face=face, start=start, stop=stop)

    def section(self, before: Swept, after: Swept) -> Branch | None:
        """The rod's ellipse at a hollow kink."""
        assert isinstance(before, EnvelopePiece)
        assert isinstance(after, EnvelopePiece)
        return rod_arc(before, after)

    def pitch_curve(self, motion: Motion) -> ClosedCurve:
        """The curve of the rod's axis: the theoretical profile."""
        return theoretical_profile(motion, self)

    def point(self) -> "LeaningRod":
        """The rod's axis."""
        return replace(self, radius=0.0)

    def remedies(self) -> tuple[LossRemedy, ...]:
        """A thinner rod and a larger base circle."""
        return (
            LossRemedy("follower.radius_mm", self.radius, False, lambda value: replace(self, radius=value)),
            LossRemedy("cam.base_radius_mm", self.base_radius, True, lambda value: replace(self, base_radius=value)),
        )

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """The least tan(beta) at which the rod clears points, in each face plane (see the module's equation).

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        u = x - self.base_radius
        under, h = _under(y, self.radius)
        return tuple(np.where(under, _clearing(u, h, face), -np.inf) for face in self.planes)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Bound over all points within `off` (mm), from a point at x + off and |y| - off (mm).

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        near, h = _under(np.maximum(np.abs(y) - off, 0.0), self.radius)
        u = x - self.base_radius + off
        return tuple(np.where(near, _clearing(u, h, face), -np.inf) for face in self.planes)

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: the axis moves horizontally and the force is square to it, so its sine is y / r.

        Args:
            q: tangents of the rod's steering angle, shape (n,).
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """
        return np.asarray(np.arcsin(np.clip(across / self.radius, -1.0, 1.0)))

    def ahead(self, q: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft the rod touches, mm.

        Args:
            q: tangents of the rod's steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """
        half = np.sqrt(np.maximum(self.radius**2 - across**2, 0.0) * (1 + q**2))
        return np.asarray(self.base_radius + face * q - half)

    def outline(self, q: float, face: float) -> Array:
        """The rod's whole ellipse in a plane, by points in the frame of the ray, shape (n, 2), mm.

        Args:
            q: tangent of the rod's steering angle.
            face: distance of the plane from the fork axis, mm.
        """
        eta = np.linspace(0.0, TURN, OUTLINE_POINTS)
        half = self.radius * np.hypot(1.0, q)
        return np.column_stack([self.base_radius + face * q - half * np.cos(eta), -self.radius * np.sin(eta)])

    def first_order(self, contact: Contact) -> FirstOrder:
        """Derivatives of T at the contacts of the rod, or of a point at its axis, with a disc (see the module)."""
        T, w, y = contact.q, contact.face, contact.across
        root, height = np.sqrt(1 + T**2), np.sqrt(self.radius**2 - y**2)
        thick = self.radius > 0
        stretch = self.radius / height if thick else np.ones_like(T)
        lean = root * y / height if thick else np.zeros_like(T)
        divisor = w - height * T / root
        return FirstOrder(height, root, lean, divisor, -T / divisor, root * stretch / divisor)

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """Carrying face, rim, chamfers and hub."""
        return rod_checks(self, cam)


def _clearing(u: Array, h: Array, face: float) -> Array:
    """The least tan(beta) at which the rod clears a point in a face plane (see the module's equation)."""
    square = h * h
    return np.asarray((face * u + h * np.sqrt(u * u + (face**2 - square))) / (face**2 - square))


def _under(y: Array, radius: float) -> tuple[NDArray[np.bool_], Array]:
    """Whether points lie under the rod, and the rod's half-height h there, mm; 0 beside it."""
    under = np.abs(y) < radius
    return under, np.sqrt(np.where(under, radius**2 - y**2, 0.0))
