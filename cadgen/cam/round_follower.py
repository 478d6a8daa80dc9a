"""Followers that touch the disc with a circle: their envelope in closed form, whatever moves the circle's centre.

With z(theta) the centre in the frame of the ray, x along it and y across, the centre's path in the cam's frame is

    p = z e^(i theta),  p' = (z' + i z) e^(i theta),  p'' = (z'' + 2 i z' - z) e^(i theta),

and the profile is its parallel at the circle's radius, on the side of the camshaft.
"""

from abc import abstractmethod
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import OUTLINE_POINTS, Branch, Follower, OwnSection, Swept, span_jets
from cadgen.curves.closed import ClosedCurve, Jet
from cadgen.curves.derived import OffsetPiece
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion

Complex = NDArray[np.complexfloating[Any, Any]]
_JOINT = 1e-9  # rad; two pieces that touch the circle this close together meet


class RoundFollower(Follower):
    """Follower with one circle in one plane, such as a roller; a kind gives the path of its centre, and rolls."""

    @abstractmethod
    def centre(self, q: Array, q1: Array, q2: Array) -> tuple[Complex, Complex, Complex]:
        """Centre z in the frame of the ray, mm, and its first two derivatives by the cam angle.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """

    def at(self, q: Array) -> Complex:
        """Centre in the frame of the ray, mm.

        Args:
            q: motion, in its unit, shape (n,).
        """
        q = np.asarray(q, dtype=float)
        return self.centre(q, np.zeros_like(q), np.zeros_like(q))[0]

    def refuse(self, motion: Motion) -> None:
        """Refuse a motion that brings the camshaft within the circle."""
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
        if stop <= start + _JOINT:
            return None
        z = complex(self.at(after.motion.q(np.array([after.start])))[0])
        return CircleArc(
            face=after.face,
            theta=after.start,
            start=start,
            stop=stop,
            centre=z * np.exp(1j * after.start),
            follower=self,
        )

    def pitch_curve(self, motion: Motion) -> ClosedCurve:
        """The path of the circle's centre."""
        joints = np.unique(np.concatenate([[0.0], motion.kinks, [TURN]])).tolist()
        spans = pairwise(joints)
        return ClosedCurve(tuple(Centre(motion=motion, face=0.0, start=a, stop=b, follower=self) for a, b in spans))

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
            across: distances of the contact from the ray, mm, shape (n,).
        """
        z = self.at(q)
        return np.asarray(z.real - np.sqrt(np.maximum(self.radius**2 - (across - z.imag) ** 2, 0.0)))

    def outline(self, q: float, face: float) -> Array:
        """The whole circle, by points in the frame of the ray, shape (n, 2), mm.

        Args:
            q: motion, in its unit.
            face: the follower's plane, as in `planes`, mm.
        """
        return _flat(self.at(np.array([q])) + self.radius * np.exp(1j * np.linspace(0.0, TURN, OUTLINE_POINTS)))


class RoundSlide(RoundFollower):
    """Round follower on a slide that moves along the ray, beside it by its offset; a kind gives `centre` and `least`.

    Of points ahead of it equally far, `least` must be greater the nearer they lie to the centre's line.
    """

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

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: its sine is the contact's distance from the centre's line by the radius.

        Args:
            q: motion, in its unit, shape (n,).
            across: distances of the contact from the ray, mm, shape (n,).
        """
        return np.asarray(np.arcsin(np.clip((across - self.offset) / self.radius, -1.0, 1.0)))


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
        turn = np.exp(1j * np.asarray(t))
        p1, p2 = (z1 + 1j * z) * turn, (z2 + 2j * z1 - z) * turn
        return Jet(_flat(z * turn), _flat(p1), np.asarray((p1.conj() * p2).imag / np.abs(p1) ** 3))

    def tilt(self, t: float) -> float:
        """Angle between the ray and the line from the contact to the centre, rad, positive where the outline rises.

        Args:
            t: cam angle, rad.
        """
        z, z1, _ = self.follower.centre(*span_jets(self.motion, np.array([t]), self.start, self.stop))
        return float(-np.angle(z - 1j * z1)[0])


@dataclass(frozen=True, kw_only=True)
class Rim(Centre):
    """Parallel of the centre's path, nearer to the camshaft by the circle's radius."""

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature; on a swallowtail the velocity points backwards.

        Args:
            t: cam angles, rad, shape (n,).
        """
        path = Centre(motion=self.motion, face=self.face, start=self.start, stop=self.stop, follower=self.follower)
        with np.errstate(divide="ignore"):  # at a cusp the curvature is infinite
            return OffsetPiece(path, -self.follower.radius).jet(t)


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
            t: angles between the ray and the line from the contact to the centre, rad, shape (n,).
        """
        arm = self.follower.radius * np.exp(1j * (self.theta - np.asarray(t)))
        return Jet(_flat(self.centre - arm), _flat(1j * arm), np.full(len(t), -1 / self.follower.radius))


def _flat(points: Complex) -> Array:
    """Complex numbers as points, shape (n, 2)."""
    return np.stack([points.real, points.imag], axis=1)
