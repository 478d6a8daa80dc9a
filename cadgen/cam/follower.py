"""Interface of every follower of a disc cam, of any shape and motion.

The follower is let down on the disc by its spring. At cam angle theta a point of the disc lies x ahead of the camshaft,
along the ray of that angle, and y across it. (The line that a follower counts from may stand at an azimuth to the ray.)
The follower moves by q, in its own coordinate: the greater that is, the further out it stands.

Two derivations that share nothing meet in it. `piece` and `section` are its envelope in closed form, of which
`cadgen.cam.envelope` makes the profile; `least` is the place at which it clears a point, by which `cadgen.cam.contact`
rolls it on any outline. The one is tested by the other.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from itertools import pairwise
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.limits import CheckLimits
from cadgen.check import Check
from cadgen.curves.closed import ClosedCurve, Jet, cross
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import MM, TAN, Unit
from cadgen.messages import Message
from cadgen.parts.blank import Blank

_SHORTEST = 1e-6  # rad; shorter parts of a curve are no edge of a solid, and hardly any of its area
OUTLINE_POINTS = 97  # of a follower in a picture: a circle of 10 mm radius errs by 5 um


@dataclass(frozen=True, kw_only=True)
class Branch(ABC):
    """A part of the envelope in one carrying plane, by a parameter that runs forward round the camshaft.

    Attributes:
        face: lateral distance of the plane, mm.
        start: parameter at which it begins, rad.
        stop: parameter at which it ends, rad.
    """

    face: float
    start: float
    stop: float

    @abstractmethod
    def jet(self, t: Array) -> Jet:
        """Point, velocity by the parameter, and curvature (positive where the disc is convex) at n parameters.

        Args:
            t: parameters, shape (n,).
        """

    @abstractmethod
    def cam_angle(self, t: float) -> float:
        """Cam angle, rad, at which the follower touches the point of a parameter.

        Args:
            t: parameter of the point.
        """

    def smooth_parts(self) -> tuple[Branch, ...]:
        """The branch in parts over which its curvature is continuous; as a rule the branch itself."""
        return (self,)


@dataclass(frozen=True, kw_only=True)
class Swept(Branch):
    """Curve that the moving follower sweeps, by cam angle, over a span without kinks.

    Attributes:
        motion: motion wanted.
    """

    motion: Motion

    def cam_angle(self, t: float) -> float:
        """Return the parameter itself, rad.

        Args:
            t: parameter of the point, which is its cam angle, rad.
        """
        return t

    def smooth_parts(self) -> tuple[Branch, ...]:
        """The branch cut where the acceleration of the motion jumps, for its curvature jumps there."""
        bends = (self.motion.bends[:, None] + TURN * np.arange(2)).ravel()
        inside = np.sort(bends[(bends > self.start + _SHORTEST) & (bends < self.stop - _SHORTEST)])
        return tuple(replace(self, start=a, stop=b) for a, b in pairwise([self.start, *inside.tolist(), self.stop]))

    def advance(self, theta: Array) -> Array:
        """Rate of the tangential travel along the envelope, mm/rad; negative on a swallowtail.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        jet = self.jet(theta)
        return np.asarray(cross(jet.point, jet.velocity) / np.linalg.norm(jet.point, axis=1))


@dataclass(frozen=True, kw_only=True)
class OwnSection(Branch):
    """The follower's own section, where it stands at a hollow kink of the lift.

    Attributes:
        theta: cam angle of the kink, rad.
    """

    theta: float

    def cam_angle(self, t: float) -> float:
        """Cam angle of the kink, rad.

        Args:
            t: parameter of the point.
        """
        return self.theta


def span_jets(motion: Motion, theta: Array, start: float, stop: float) -> tuple[Array, Array, Array]:
    """Motion and two derivatives inside [start, stop], one-sided at the ends (a kink may stand there).

    Args:
        motion: motion wanted.
        theta: cam angles, rad, shape (n,).
        start: end of the span, rad.
        stop: other end of the span, rad.
    """
    inside = np.clip(theta, start, stop - 1e-13 * (1.0 + abs(stop)))
    return motion.q(inside), motion.q(inside, nu=1), motion.q(inside, nu=2)


def turned(radial: Array, around: Array, ray: tuple[Array, Array]) -> Array:
    """Turn components along and across rays into points of the cam frame, shape (n, 2), mm.

    Args:
        radial: components along the rays, shape (n,), mm.
        around: components across them, shape (n,), mm.
        ray: cosine and sine of the rays' angles, each of shape (n,).
    """
    c, s = ray
    return np.stack([radial * c - around * s, radial * s + around * c], axis=1)


@dataclass(frozen=True)
class Contact:
    """Contact of the follower with the disc at each cam angle; all arrays have shape (n,).

    Attributes:
        cam_angle: cam angle, rad.
        q: motion that results, in the unit of the follower.
        lift: lift s, mm.
        face: lateral distance of the plane that carries the follower, mm.
        margin: lift by which that plane lifts the follower further than the other one alone would, mm; where it is no
            more than `ROLLING_TOLERANCE` either may be the one that carries. Infinite if there is no other.
        across: coordinate y of the contact point from the follower's line, mm, ahead in the sense of growing polar
            angle.
        pressure_angle: angle between the force on the follower and the velocity of the point where it acts, rad, with
            the sign of the follower's kind; on a slide positive where the outline rises under it.
    """

    cam_angle: Array
    q: Array
    lift: Array
    face: Array
    margin: Array
    across: Array
    pressure_angle: Array

    def at(self, rows: NDArray[np.intp]) -> Contact:
        """Contact at some of the cam angles, by their indices."""
        return Contact(*(getattr(self, field.name)[rows] for field in fields(self)))

    def joined(self, other: Contact) -> Contact:
        """Contact at these cam angles and at those of another one."""
        return Contact(
            *(np.concatenate([getattr(each, field.name) for each in (self, other)]) for field in fields(self))
        )


class TrimKind(StrEnum):
    """Kind of a trim.

    Both faces' envelopes meet; a kink, or a convex radius smaller than the follower's, lies between; or two distant
    parts cut each other off.
    """

    FACE_CHANGE = "face change"
    LOCAL = "local"
    GLOBAL = "global"


@dataclass(frozen=True)
class Trim:
    """A place where two branches cross: between the two cam angles the lift wanted cannot be had in full.

    Attributes:
        point: shape (2,), mm.
        before: cam angle whose section last touches before the crossing, rad.
        after: cam angle whose section first touches after it, rad.
        kind: what was trimmed.
    """

    point: Array
    before: float
    after: float
    kind: TrimKind


@dataclass(frozen=True)
class Loss:
    """Lift that the profile cannot give near a trim.

    Attributes:
        trim: place where the envelope was trimmed.
        lift: lift lost at the worst cam angle, mm.
        cam_angle: worst cam angle, rad.
        driven: whether the motion counts there (see `Motion.idle`).
    """

    trim: Trim
    lift: float
    cam_angle: float
    driven: bool


@dataclass(frozen=True, kw_only=True)
class RolledCam:
    """A cam with its follower rolled on it.

    Attributes:
        motion: motion wanted.
        follower: follower that is rolled.
        contact: contact of the follower with the profile, at n cam angles.
        error: lift that the profile gives more than is wanted, mm, shape (n,).
        losses: lift lost at each trim of the envelope.
        trimmed: whether the envelope is trimmed there, or nothing depends on the motion, shape (n,).
        positions: motion wanted and, where nothing depends on it, had; in the motion's unit, shape (2, n).
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
    """

    motion: Motion
    follower: Follower
    contact: Contact
    error: Array
    losses: tuple[Loss, ...]
    trimmed: NDArray[np.bool_]
    positions: Array
    blank: Blank
    limits: CheckLimits


@dataclass(frozen=True)
class LossRemedy:
    """A dimension whose change lessens lost lift.

    Attributes:
        key: key in the design file.
        now: present value of the key, mm.
        rises: whether a greater value lessens the loss.
        follower: function that makes the follower for a value of the key, mm.
    """

    key: str
    now: float
    rises: bool
    follower: Callable[[float], Follower]

    def value(self, factor: float) -> float:
        """The dimension, mm, changed by a factor >= 1.

        Args:
            factor: ratio of the new dimension to the present one, 1 or more.
        """
        return self.now * factor if self.rises else self.now / factor


@dataclass(frozen=True)
class SizeThatFits:
    """Value of one dimension with which a cam keeps a limit, rounded to the safe side.

    Attributes:
        key: key in the design file.
        now: present value of the key, mm.
        value: value that keeps the limit, mm.
    """

    key: str
    now: float
    value: float


@dataclass(frozen=True)
class FollowerDimension:
    """Dimension of a follower or its place that may be off, while the disc stays as it is.

    Attributes:
        code: code of the dimension; `base_circle` stands for a disc that is larger all round.
        outwards: function of the motion and its first derivative by the cam angle, shape (n,) each. It returns the
            displacement of the follower's curve along the outward normal at the contact, while the follower does not
            move, by a unit more of the dimension: mm by mm or by rad.
    """

    code: str
    outwards: Callable[[Array, Array], Array]


class Follower(ABC):
    """A curve that rides on the disc; a kind is a frozen dataclass with the properties and methods below.

    A follower in one plane whose motion is its lift, such as a slide, has `planes`, `lift` and `of_lift` already.

    Attributes:
        noun: name of the follower in messages.
        base_key: key of the design file that makes the cam larger.
        milder: advice where the follower is too large for the cam, in words.
        flatter: advice where an outline overhangs, in words.
        unit: unit of its motion q: lift in mm, swing in rad, or the tangent of a car's steering angle.
        base_radius: distance of its reference point from the camshaft along the ray where q is 0, mm.
        encloses: whether the disc lies on the far side of it from the camshaft, as the outer flank of a groove does.
        leans: whether it leans on an edge of the rim, as an `EdgeFollower` does; play and friction go by that.
        radius: least radius of curvature of the curve that touches the disc, mm; infinite for a straight one. Zero
            stands for a point, which `standing` lets down on an outline.
    """

    noun: str = "follower"
    base_key: str = "cam.base_radius_mm"
    milder: str = Message("raise cam.base_radius_mm")
    flatter: str = Message("make the cam larger, or the motion milder there")
    unit: Unit = MM
    encloses: bool = False
    leans: bool = False
    base_radius: float
    radius: float

    @property
    def azimuth(self) -> float:
        """Angle from the ray of the cam angle to the follower's line, rad: coordinates x and y are those of the line.

        It is other than 0 where a follower does not stand near the ray, as a roller whose pivot lies on it.
        """
        return 0.0

    @property
    def on_ray(self) -> str:
        """Part of the follower that stands on the ray of the cam angle, in words."""
        return self.noun

    @property
    def planes(self) -> tuple[float, ...]:
        """Distances from the reference of the follower's faces of the planes that carry it, mm, ascending."""
        return (0.0,)

    @property
    @abstractmethod
    def reach(self) -> float:
        """How far across its line the points lie, at most, that may carry it, mm; infinite without a bound."""

    def sector(self, least: float, greatest: float) -> tuple[float, float]:
        """Polar angles from its line, rad, between which it touches a disc; the second is the greater one.

        Args:
            least: least radius of the disc, mm.
            greatest: greatest radius of the disc, mm.
        """
        half = float(np.arcsin(min(1.0, self.reach / least)))
        return -half, half

    def lift(self, q: Array) -> Array:
        """Lift s of its reference point, mm.

        Args:
            q: motion, in its unit, shape (n,).
        """
        return np.asarray(q)

    def of_lift(self, lift: Array) -> tuple[Array, Array, Array]:
        """Motion q by lift, mm, with the plane that then carries it, mm, and the margin of `Contact`, mm.

        Args:
            lift: lifts, mm, shape (n,).
        """
        return lift, np.full_like(lift, self.planes[0]), np.full_like(lift, np.inf)

    def touching(self, points: Array, normals: Array) -> tuple[Array, Array]:
        """Cam angles at which it touches points of an outline, rad, and the motion there, in its unit, shape (n,) each.

        Args:
            points: points of the outline in the cam's frame, mm, shape (n, 2).
            normals: unit normals there, away from the camshaft, shape (n, 2).

        Raises:
            DesignError: it touches with more than one curve, so that a point does not tell its cam angle.
        """
        raise DesignError(
            "points of an outline do not tell where a {follower} touches them: measure the lift", follower=self.noun
        )

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Dimensions that may be off, each with what it does; none for a kind that does not say."""
        return ()

    def normal(self, q: Array, q1: Array) -> NDArray[np.complexfloating[Any, Any]]:
        """Outward normal at the contact in the frame of the follower's line, as complex numbers, shape (n,).

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.

        Raises:
            DesignError: the kind does not say.
        """
        raise DesignError("errors of the lift are not worked out for a {follower}", follower=self.noun)

    def dwelling(self, q: float) -> float:
        """Radius of the disc on which it stands still, mm.

        Args:
            q: motion, in its unit.
        """
        raise DesignError("a {follower} has no circle on which it stands still: measure the lift", follower=self.noun)

    # The envelope.

    @abstractmethod
    def refuse(self, motion: Motion) -> None:
        """Refuse a motion with which nothing is left of the disc.

        Raises:
            DesignError: it is so.
        """

    @abstractmethod
    def piece(self, motion: Motion, face: float, start: float, stop: float) -> Swept:
        """The envelope in a plane between two cam angles, rad, without a kink between them.

        Args:
            motion: motion wanted.
            face: distance of the plane that carries it, as in `planes`, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """

    @abstractmethod
    def section(self, before: Swept, after: Swept) -> Branch | None:
        """Section of the follower itself that joins two pieces at a hollow kink; None where they meet or cross."""

    @abstractmethod
    def pitch_curve(self, motion: Motion) -> ClosedCurve | None:
        """The curve of its reference point in the cam's frame; None for a follower that has no such point."""

    @abstractmethod
    def point(self) -> Follower:
        """Follower that rolls on the pitch curve: its reference point, of radius zero."""

    def remedies(self) -> tuple[LossRemedy, ...]:
        """Dimensions whose change, one at a time, lessens lost lift."""
        return ()

    def sizes(self, motion: Motion, limits: CheckLimits) -> tuple[SizeThatFits, ...]:
        """Dimensions that keep limits of the pressure angle or of the radius of curvature, each alone.

        Args:
            motion: motion wanted.
            limits: limits of the checks, mm and rad.
        """
        return ()

    # Rolling.

    @abstractmethod
    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """The least q at which it clears points, in each plane; minus infinity for those beside it.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """

    @abstractmethod
    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """

    @abstractmethod
    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad, where it touches the disc at y across, mm.

        Args:
            q: motion, in its unit, shape (n,).
            across: distances of the contact from its line, mm, shape (n,).
        """

    def pressed(self, q: Array, normal: Array) -> Array:
        """Pressure angle, rad, by the direction of the outline's normal at the contact.

        Unless a kind says otherwise, the follower moves along its line.

        Args:
            q: motion, in its unit, shape (n,).
            normal: angles of the normal from its line, rad, shape (n,).
        """
        return -normal

    def normal_share(self, contact: Contact) -> Array:
        """Displacement of the outline along its normal that changes the lift by 1, shape (n,).

        Args:
            contact: contact of the follower with a disc.
        """
        return np.asarray(np.cos(contact.pressure_angle))

    def push(self, q: Array, q1: Array) -> Array:
        """Displacement along the outline's normal at the contact by the motion, mm by the motion's unit, shape (n,).

        It is the cosine of the pressure angle times the lever of the motion: 1 on a slide, else the follower's arm.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.

        Raises:
            DesignError: it is not worked out for this kind of follower.
        """
        raise DesignError(
            "forces are not worked out for the {follower}: take a roller or a flat face, or remove [dynamics]",
            follower=Message(self.noun),
        )

    def profile_radius(self, q: Array, q1: Array, q2: Array) -> Array:
        """Radius of curvature of the profile at the contact, positive where convex, shape (n,), mm.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².

        Raises:
            DesignError: it is not worked out for this kind of follower.
        """
        raise DesignError(
            "forces are not worked out for the {follower}: take a roller or a flat face, or remove [dynamics]",
            follower=Message(self.noun),
        )

    def standing(self, distance: Array) -> tuple[Array, Array]:
        """Lift of a point, mm, and its polar angle from the line, rad, where it stands so far from the camshaft.

        Only a follower of radius zero is asked. Unless a kind says otherwise, it moves along its line.

        Args:
            distance: distances of the point from the camshaft, mm, shape (n,).
        """
        return distance - self.base_radius, np.zeros_like(distance)

    @abstractmethod
    def distance(self, q: Array, face: Array) -> Array:
        """How far ahead of the camshaft its reference point stands in a plane, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: distance of the plane that carries it, as in `planes`, mm.
        """

    @abstractmethod
    def ahead(self, q: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft it touches the disc at y across, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: distance of the plane that carries it, as in `planes`, mm.
            across: distances of the contact from its line, mm, shape (n,).
        """

    def place(self, contact: Contact) -> Array:
        """Polar angles of contacts in the cam's frame, rad, shape (n,).

        Args:
            contact: contact of the follower with a disc.
        """
        ahead = self.ahead(contact.q, contact.face, contact.across)
        return np.asarray(contact.cam_angle + np.arctan2(contact.across, ahead) + self.azimuth)

    def outline(self, q: float, face: float) -> Array:
        """Section of the follower as pictures show it: points (x, y) in the frame of its line, shape (n, 2), mm.

        Unless a kind gives its whole section, it is the side that touches the disc.

        Args:
            q: motion, in its unit.
            face: distance of the plane that carries it, as in `planes`, mm.
        """
        across = np.linspace(-self.reach, self.reach, OUTLINE_POINTS)
        return np.column_stack([self.ahead(np.full_like(across, q), np.full_like(across, face), across), across])

    def margin(self, apart: Array, face: Array) -> Array:
        """Lift, mm, that belongs to a difference of q between two planes; infinite if there is but one.

        Args:
            apart: differences of q between two planes, shape (n,).
            face: distance of the plane that carries it, as in `planes`, mm.
        """
        return np.full_like(apart, np.inf)

    # Checks.

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """The checks of its own kind."""
        return ()


@dataclass(frozen=True)
class FirstOrder:
    """Derivatives of T = tan(beta) at n cam angles.

    Attributes:
        height: h, half the follower's height at the contact, shape (n,), mm.
        root: sqrt(1 + T^2), shape (n,).
        lean: sqrt(1 + T^2) y / h, shape (n,).
        divisor: D, shape (n,), mm.
        face: dT/dw, shape (n,), 1/mm.
        thicker: dT/dr, shape (n,), 1/mm.
    """

    height: Array
    root: Array
    lean: Array
    divisor: Array
    face: Array
    thicker: Array

    def displaced(self, along: Array, across: Array) -> Array:
        """Change of T with a displacement of the point along the ray and across it, both in mm, shape (n,).

        Args:
            along: displacements outwards along the ray, mm, shape (n,).
            across: displacements across it, mm, shape (n,).
        """
        return np.asarray((along - self.lean * across) / self.divisor)


@dataclass(frozen=True, kw_only=True)
class EdgeFollower(Follower):
    """Follower on a car's fork that leans with the steering, so that it rides on an edge of the rim.

    That is an edge of a face or, where the edges are broken by chamfers, of the land between them
    (`cadgen.parts.blank.Blank.carrying`). Its motion is T = tan(beta).

    Attributes:
        base_radius: a, distance of the camshaft from the fork axis, mm.
        inner: lateral distance from A of the carrying plane nearer to it, mm.
        outer: lateral distance of the farther carrying plane, mm.
        radius: half its thickness, mm; zero stands for its axis (a knife edge).
        length: from the fork axis to its end, mm.
    """

    unit = TAN
    leans = True

    base_radius: float
    inner: float
    outer: float
    radius: float
    length: float = inf

    @property
    def land(self) -> float:
        """Width of the rim between the carrying planes, mm."""
        return self.outer - self.inner

    def contact_face(self, q: Array) -> Array:
        """Lateral distance of the plane that carries it, mm: inner for beta >= 0, outer below (eq. 15).

        Args:
            q: tangents of the steering angle, shape (n,).
        """
        return np.where(np.asarray(q) >= 0, self.inner, self.outer)

    def lift(self, q: Array) -> Array:
        """Lift s = w_contact tan(beta), mm (eq. 16).

        Args:
            q: tangents of the steering angle, shape (n,).
        """
        return self.contact_face(q) * q

    @property
    def planes(self) -> tuple[float, float]:
        """The inner and the outer carrying plane, mm from the fork axis."""
        return self.inner, self.outer

    def of_lift(self, lift: Array) -> tuple[Array, Array, Array]:
        """tan(beta), the carrying face and the margin by lift of the axis, mm.

        Args:
            lift: lifts of the axis, mm, shape (n,).
        """
        face = self.contact_face(lift)
        q = lift / face
        return q, face, self.land * np.abs(q)

    def distance(self, q: Array, face: Array) -> Array:
        """Distance of the axis from the camshaft in a plane, mm.

        Args:
            q: tangents of the steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """
        return np.asarray(self.base_radius + face * q)

    def margin(self, apart: Array, face: Array) -> Array:
        """Lift of a difference of tan(beta), mm.

        Args:
            apart: differences of tan(beta) between two planes, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """
        return face * apart

    @abstractmethod
    def point(self) -> EdgeFollower:
        """Follower of radius zero at the axis, or at another point."""

    @abstractmethod
    def first_order(self, contact: Contact) -> FirstOrder:
        """Derivatives of T at the contacts with a disc, or at those of a point at the axis."""


def edge_follower(follower: Follower, job: str, instead: str = "") -> EdgeFollower:
    """The follower as one that rides on an edge of the rim, for a job that is worked out for those alone.

    Args:
        follower: follower of any kind.
        job: name of the job, as it begins a sentence.
        instead: alternative for a design with this follower, as it ends a sentence.

    Raises:
        DesignError: the follower does not lean.
    """
    if isinstance(follower, EdgeFollower):
        return follower
    if instead and follower.unit != TAN:
        raise DesignError(
            "follower.kind names a {follower}, and {job} is worked out for the leaning rod of a car alone: {instead}",
            follower=follower.noun,
            job=job,
            instead=Message(instead),
        )
    way_out = Message(", or {instead}", instead=Message(instead)) if instead else ""
    raise DesignError(
        "follower.kind names a {follower}, and {job} is worked out for the leaning rod alone: "
        'set follower.kind = "rod" with its keys{way_out}',
        follower=Message(follower.noun),
        job=Message(job),
        way_out=way_out,
    )


class SizedByAnother(Follower):
    """Base of a follower whose sizes another one sets, so that none of them is tried alone."""

    remedies = Follower.remedies
    sizes = Follower.sizes


def gives_nothing(follower: Follower, member: str) -> DesignError:
    """Refusal of a follower one of whose members returns None where it must return a value.

    Args:
        follower: follower, as a rule of a plug-in.
        member: name of the member.
    """
    return DesignError(
        "{member} of the {follower} ({name}) returns None, where its value is needed: correct this member of its kind",
        member=member,
        follower=follower.noun,
        name=type(follower).__name__,
    )
