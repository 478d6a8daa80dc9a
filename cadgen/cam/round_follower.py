"""Followers that touch the disc with a circle: their envelope in closed form, whatever moves the circle's centre.

Let z(theta) be the centre in the frame of the follower's line, x along it and y across. The path of the centre in the
frame of the cam is, but for the azimuth of the line,

    p = z e^(i theta),  p' = (z' + i z) e^(i theta),  p'' = (z'' + 2 i z' - z) e^(i theta),

and the profile is its parallel at the circle's radius, on the side of the camshaft.
"""

from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import (
    OUTLINE_POINTS,
    Branch,
    Follower,
    FollowerDimension,
    OwnSection,
    Swept,
    gives_nothing,
    span_jets,
)
from cadgen.curves.closed import ClosedCurve, Jet, cross
from cadgen.curves.derived import OffsetPiece
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion

Complex = NDArray[np.complexfloating[Any, Any]]
_JOINT = 1e-9  # rad; two pieces that touch the circle this close together meet
_STATIONS = 3600  # of a turn, at which the outline must not overhang


class RoundFollower(Follower):
    """Follower with one circle in one plane, such as a roller; a kind gives the path of its centre, and rolls."""

    @abstractmethod
    def centre(self, q: Array, q1: Array, q2: Array) -> tuple[Complex, Complex, Complex]:
        """Centre z in the frame of the follower's line, mm, and its first two derivatives by the cam angle.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """

    @property
    def rim(self) -> float:
        """Distance of the profile from the centre's path, mm: the radius, negative towards the camshaft."""
        return self.radius if self.encloses else -self.radius

    def at(self, q: Array) -> Complex:
        """Centre in the frame of the follower's line, mm.

        Args:
            q: motion, in its unit, shape (n,).
        """
        q = np.asarray(q, dtype=float)
        return self.centre(q, np.zeros_like(q), np.zeros_like(q))[0]

    def touching(self, points: Array, normals: Array) -> tuple[Array, Array]:
        """Cam angles and motion at which the circle touches points of an outline: its centre lies on their normals.

        Args:
            points: points of the outline in the cam's frame, mm, shape (n, 2).
            normals: unit normals there, away from the camshaft, shape (n, 2).
        """
        centres = points - self.rim * normals
        lift, aside = self.standing(np.linalg.norm(centres, axis=1))
        polar = np.arctan2(centres[:, 1], centres[:, 0])
        return polar - aside - self.azimuth, self.of_lift(lift)[0]

    def dwelling(self, q: float) -> float:
        """Radius of the disc on which the circle stands still, mm.

        Args:
            q: motion, in its unit.
        """
        return float(np.abs(self.at(np.array([q])))[0] + self.rim)

    def refuse(self, motion: Motion) -> None:
        """Refuse a motion that brings the camshaft within the circle, or makes the outline overhang."""
        angles, stations = motion.stations
        distance = np.abs(self.at(stations))
        nearest = int(np.argmin(distance))
        if distance[nearest] <= self.radius:
            raise DesignError(
                "the {noun} of {radius:g} mm comes within {distance:.4g} mm of the camshaft at cam angle {angle:.1f} "
                "degrees, so nothing is left of the disc: raise {base_key}, or {higher}",
                noun=self.noun,
                radius=self.radius,
                distance=float(distance[nearest]),
                angle=np.degrees(angles[nearest]),
                base_key=self.base_key,
                higher=motion.higher(float(angles[np.argmin(stations)])),
            )
        pitch: ClosedCurve | None = self.pitch_curve(motion)  # of a plug-in it may give nothing
        if pitch is None:
            raise gives_nothing(self, "pitch_curve")
        for path in pitch.pieces:
            assert isinstance(path, Centre)
            theta = np.linspace(path.start, path.stop, max(9, int(_STATIONS * (path.stop - path.start) / TURN)))
            jet = path.jet(theta)
            velocity = jet.velocity / np.linalg.norm(jet.velocity, axis=1)[:, None]
            # Where the outline is not undercut and turns its outer side to the camshaft.
            over = (cross(jet.point, velocity) <= -self.rim) & (-self.rim * jet.curvature < 1.0)
            if over.any():
                worst = float(theta[np.argmin(np.where(over, cross(jet.point, velocity), np.inf))])
                raise DesignError(
                    "the outline overhangs, seen from the camshaft, where the {noun} touches it at cam angle "
                    "{angle:.1f} degrees, which is not made: {softer}, or raise {base_key}",
                    noun=self.noun,
                    angle=np.degrees(worst),
                    softer=motion.softer(worst),
                    base_key=self.base_key,
                )

    def piece(self, motion: Motion, face: float, start: float, stop: float) -> "Rim":
        """The envelope of the circle between two cam angles, rad.

        Args:
            motion: motion wanted.
            face: the follower's plane, as in `planes`, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """
        return Rim(motion=motion, face=face, start=start, stop=stop, follower=self)

    def section(self, before: Swept, after: Swept) -> Branch | None:
        """The part of the circle that rests in a hollow kink."""
        assert isinstance(before, Centre)
        assert isinstance(after, Centre)
        start, stop = before.tilt(before.stop), after.tilt(after.start)
        if self.radius == 0 or stop <= start + _JOINT or self.encloses:
            return None
        z = complex(self.at(after.motion.q(np.array([after.start])))[0])
        return CircleArc(
            face=after.face,
            theta=after.start,
            start=start,
            stop=stop,
            centre=z * np.exp(1j * (after.start + self.azimuth)),
            follower=self,
        )

    def pitch_curve(self, motion: Motion) -> ClosedCurve:
        """The path of the circle's centre."""
        joints = np.unique(np.concatenate([[0.0], motion.kinks, motion.bends, [TURN]])).tolist()
        spans = pairwise(joints)
        return ClosedCurve(tuple(Centre(motion=motion, face=0.0, start=a, stop=b, follower=self) for a, b in spans))

    def push(self, q: Array, q1: Array) -> Array:
        """Displacement of the centre along the outline's normal by the motion, mm by the motion's unit.

        With the tangent t = z' + i z of the centre's path and z_q, the derivative of the centre by the motion, it is
        -Im(conj(t) z_q) / |t|.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
        """
        z, by_motion, _ = self.centre(q, np.ones_like(q), np.zeros_like(q))
        tangent = by_motion * q1 + 1j * z
        return np.asarray(-(tangent.conj() * by_motion).imag / np.abs(tangent))

    def normal(self, q: Array, q1: Array) -> Complex:
        """Outward normal at the contact in the frame of the follower's line: -i t / |t|, with the tangent of `push`.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
        """
        z, z1, _ = self.centre(q, q1, np.zeros_like(q))
        tangent = z1 + 1j * z
        return np.asarray(-1j * tangent / np.abs(tangent))

    def moved(self, code: str, way: Callable[[Array], Complex]) -> FollowerDimension:
        """Dimension that moves the circle's centre.

        Args:
            code: code of the dimension.
            way: function of the motion that returns the way of the centre by a unit of the dimension, mm by mm or rad.
        """
        return FollowerDimension(code, lambda q, q1: np.asarray((self.normal(q, q1).conj() * way(q)).real))

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Disc and circle: both lift the follower by as much."""
        larger = [FollowerDimension(code, lambda q, q1: -np.ones_like(q)) for code in ("base_circle", "roller_radius")]
        return tuple(larger) if self.radius else (larger[0],)

    def profile_radius(self, q: Array, q1: Array, q2: Array) -> Array:
        """Radius of curvature of the profile at the contact, positive where convex, shape (n,), mm.

        The path p = z e^(i theta) of the centre has the radius |p'|^3 / Im(conj(p') p''), and the profile that less
        the circle's, or more by it on an outer flank.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """
        z, z1, z2 = self.centre(q, q1, q2)
        first, second = z1 + 1j * z, z2 + 2j * z1 - z
        with np.errstate(divide="ignore"):
            return np.asarray(np.abs(first) ** 3 / (first.conj() * second).imag + self.rim)

    def distance(self, q: Array, face: Array) -> Array:
        """How far ahead of the camshaft the centre stands, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: the follower's plane, as in `planes`, mm.
        """
        return np.asarray(self.at(q).real)

    def ahead(self, q: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft the circle touches the disc at y across, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: the follower's plane, as in `planes`, mm.
            across: distances of the contact from the line, mm, shape (n,).
        """
        z = self.at(q)
        half = np.sqrt(np.maximum(self.radius**2 - (across - z.imag) ** 2, 0.0))
        return np.asarray(z.real + half if self.encloses else z.real - half)

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: the contact lies against the normal, by the radius from the centre.

        Args:
            q: motion, in its unit, shape (n,).
            across: distances of the contact from the line, mm, shape (n,).
        """
        return self.pressed(q, np.arcsin(np.clip((across - self.at(q).imag) / self.rim, -1.0, 1.0)))

    def outline(self, q: float, face: float) -> Array:
        """The whole circle, by points in the frame of the follower's line, shape (n, 2), mm.

        Args:
            q: motion, in its unit.
            face: the follower's plane, as in `planes`, mm.
        """
        return _flat(self.at(np.array([q])) + self.radius * np.exp(1j * np.linspace(0.0, TURN, OUTLINE_POINTS)))


class RoundSlide(RoundFollower):
    """Round follower on a slide that moves along the ray, beside it by its offset; a kind gives `centre` and `least`.

    Of points ahead of it equally far, `least` must be greater the nearer they lie to the centre's line.

    Attributes:
        offset: distance of the centre from the ray, mm, positive in the sense of growing polar angle.
    """

    offset: float

    @property
    def reach(self) -> float:
        """Greatest distance of a point of the circle from the ray, mm."""
        return self.radius + abs(self.offset)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        return self.least(x + off, self.offset + np.maximum(np.abs(y - self.offset) - off, 0.0))

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Disc, circle, and the distance of the slide's line from the camshaft."""
        return (*super().dimensions(), self.moved("offset", lambda q: np.full(len(q), 1j)))

    def standing(self, distance: Array) -> tuple[Array, Array]:
        """Lift of a point beside the line, mm, and its polar angle from the line, rad.

        Args:
            distance: distances of the point from the camshaft, mm, shape (n,).
        """
        ahead = np.sqrt(np.maximum(distance**2 - self.offset**2, 0.0))
        return ahead - self.base_radius, np.arctan2(self.offset, ahead)


@dataclass(frozen=True, kw_only=True)
class Centre(Swept):
    """Path of the circle's centre in the cam's frame, by cam angle.

    Attributes:
        follower: follower whose centre it is.
    """

    follower: RoundFollower

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature.

        Args:
            t: cam angles, rad, shape (n,).
        """
        z, z1, z2 = self.follower.centre(*span_jets(self.motion, t, self.start, self.stop))
        turn = np.exp(1j * (np.asarray(t) + self.follower.azimuth))
        p1, p2 = (z1 + 1j * z) * turn, (z2 + 2j * z1 - z) * turn
        return Jet(_flat(z * turn), _flat(p1), np.asarray((p1.conj() * p2).imag / np.abs(p1) ** 3))

    def tilt(self, t: float) -> float:
        """Angle from the outline's normal to the follower's line, rad.

        Args:
            t: cam angle, rad.
        """
        z, z1, _ = self.follower.centre(*span_jets(self.motion, np.array([t]), self.start, self.stop))
        return float(-np.angle(z - 1j * z1)[0])


@dataclass(frozen=True, kw_only=True)
class Rim(Centre):
    """Parallel of the centre's path at the circle's radius, as a rule on the side of the camshaft."""

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature; on a swallowtail the velocity points backwards.

        Args:
            t: cam angles, rad, shape (n,).
        """
        path = Centre(motion=self.motion, face=self.face, start=self.start, stop=self.stop, follower=self.follower)
        with np.errstate(divide="ignore"):  # at a cusp the curvature is infinite
            return OffsetPiece(path, self.follower.rim).jet(t)


@dataclass(frozen=True, kw_only=True)
class CircleArc(OwnSection):
    """Part of the circle that rests in a hollow kink of the motion, by its own angle.

    Attributes:
        centre: centre in the cam's frame, mm.
        follower: follower whose circle it is.
    """

    centre: complex
    follower: RoundFollower

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the angle t (rad), and curvature (negative: the disc is hollow here).

        Args:
            t: angles from the outline's normal to the follower's line, rad, shape (n,).
        """
        arm = self.follower.radius * np.exp(1j * (self.theta + self.follower.azimuth - np.asarray(t)))
        return Jet(_flat(self.centre - arm), _flat(1j * arm), np.full(len(t), -1 / self.follower.radius))


def _flat(points: Complex) -> Array:
    """Complex numbers as points, shape (n, 2)."""
    return np.stack([points.real, points.imag], axis=1)
