"""Followers that touch the disc with a straight face: their envelope in closed form, whatever moves the face.

The face has the distance h(theta) from the camshaft, and its normal, which points away from the camshaft, has the angle
psi(theta) in the frame of the cam. The disc has the support h by the angle of its normal, so with derivatives by psi

    contact = (h + i h_psi) e^(i psi),  radius of curvature = h + h_psi_psi,
    h_psi = h' / psi',  h_psi_psi = (h'' psi' - h' psi'') / psi'^3,

where a dash is the derivative by the cam angle. The disc is undercut where the radius is negative.
"""

from abc import abstractmethod
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Branch, Follower, FollowerDimension, OwnSection, Swept, span_jets
from cadgen.cam.round_follower import Complex
from cadgen.curves.closed import Jet
from cadgen.laws.motion import Motion

_CUSP = 1e-15  # mm; in place of a radius of 0 at a cusp, at which the outline would have no direction
_JOINT = 1e-9  # mm; two pieces that touch the face this close together meet


class FaceJet(NamedTuple):
    """Face by the cam angle, each value with its first two derivatives, shape (3, n).

    Attributes:
        support: distances from the camshaft, mm.
        turn: angles of the normal from the follower's line, rad.
    """

    support: Array
    turn: Array


class StraightFollower(Follower):
    """Follower with one straight face in one plane; a kind gives how the face moves, and rolls."""

    radius: float = inf

    @abstractmethod
    def face_jet(self, q: Array, q1: Array, q2: Array) -> FaceJet:
        """Face by the cam angle.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """

    def at(self, q: Array) -> tuple[Array, Array]:
        """Distance of the face from the camshaft, mm, and angle of its normal from the follower's line, rad.

        Args:
            q: motion, in its unit, shape (n,).
        """
        q = np.asarray(q, dtype=float)
        face = self.face_jet(q, np.zeros_like(q), np.zeros_like(q))
        return face.support[0], face.turn[0]

    @abstractmethod
    def of_support(self, support: Array) -> Array:
        """Motion by the distance of the face from the camshaft, in its unit, shape (n,).

        Args:
            support: distances, mm, shape (n,).
        """

    def touching(self, points: Array, normals: Array) -> tuple[Array, Array]:
        """Cam angles and motion at which the face touches points of an outline: it is their tangent.

        Args:
            points: points of the outline in the cam's frame, mm, shape (n, 2).
            normals: unit normals there, away from the camshaft, shape (n, 2).
        """
        q = self.of_support(np.sum(points * normals, axis=1))
        return np.arctan2(normals[:, 1], normals[:, 0]) - self.at(q)[1] - self.azimuth, q

    def dwelling(self, q: float) -> float:
        """Radius of the disc on which the face stands still, mm.

        Args:
            q: motion, in its unit.
        """
        return float(self.at(np.array([q]))[0][0])

    @property
    def reach(self) -> float:
        """Without a bound: the face is as long as it must be."""
        return inf

    def sector(self, least: float, greatest: float) -> tuple[float, float]:
        """Polar angles from its line between which it touches a disc: within arccos(least / greatest) of the normal.

        Args:
            least: least radius of the disc, mm.
            greatest: greatest radius of the disc, mm.
        """
        half = float(np.arccos(np.clip(least / greatest, -1.0, 1.0)))
        first, last = self.leaning(least, greatest)
        return first - half, last + half

    @abstractmethod
    def leaning(self, least: float, greatest: float) -> tuple[float, float]:
        """Least and greatest angle of its normal from its line while its distance is between two, rad.

        Args:
            least: least distance of the face from the camshaft, mm.
            greatest: greatest distance, mm.
        """

    def piece(self, motion: Motion, face: float, start: float, stop: float) -> "FacePiece":
        """The envelope of the face between two cam angles, rad.

        Args:
            motion: motion wanted.
            face: the follower's plane, as in `planes`, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """
        return FacePiece(motion=motion, face=face, start=start, stop=stop, follower=self)

    def section(self, before: Swept, after: Swept) -> Branch | None:
        """The part of the face that rests on a hollow kink."""
        assert isinstance(before, FacePiece)
        assert isinstance(after, FacePiece)
        start, stop = before.along(before.stop), after.along(after.start)
        if stop <= start + _JOINT:
            return None
        support, turn = self.at(after.motion.q(np.array([after.start])))
        normal = float(after.start + self.azimuth + turn[0])
        return FaceSpan(
            face=after.face, theta=after.start, start=start, stop=stop, support=float(support[0]), normal=normal
        )

    def pitch_curve(self, motion: Motion) -> None:
        """A face has no reference point."""

    def point(self) -> Follower:
        """A face has no reference point: the follower itself."""
        return self

    def push(self, q: Array, q1: Array) -> Array:
        """Displacement of the face along its normal at the contact by the motion, mm by the motion's unit.

        A contact h_psi along the face from the camshaft's foot moves by the change of h less h_psi times that of psi.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
        """
        moved = self.face_jet(q, np.ones_like(q), np.zeros_like(q))
        along = moved.support[1] * q1 / (1.0 + moved.turn[1] * q1)
        return np.asarray(moved.support[1] - along * moved.turn[1])

    def normal(self, q: Array, q1: Array) -> Complex:
        """Outward normal of the face at the contact, in the frame of the follower's line.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
        """
        return np.asarray(np.exp(1j * self.at(q)[1]))

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """The disc, larger all round."""
        return (FollowerDimension("base_circle", lambda q, q1: -np.ones_like(q)),)

    def profile_radius(self, q: Array, q1: Array, q2: Array) -> Array:
        """Radius of curvature h + h_psi_psi of the profile at the contact, positive where convex, shape (n,), mm.

        Args:
            q: motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """
        (h, h1, h2), (_, turn1, turn2) = self.face_jet(q, q1, q2)
        psi1 = 1.0 + turn1
        return np.asarray(h + (h2 * psi1 - h1 * turn2) / psi1**3)

    def distance(self, q: Array, face: Array) -> Array:
        """Distance of the face from the camshaft, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: the follower's plane, as in `planes`, mm.
        """
        return self.at(q)[0]

    def ahead(self, q: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft the face lies at y across, mm.

        Args:
            q: motion, in its unit, shape (n,).
            face: the follower's plane, as in `planes`, mm.
            across: distances of the contact from the line, mm, shape (n,).
        """
        support, turn = self.at(q)
        return np.asarray((support - across * np.sin(turn)) / np.cos(turn))

    def along(self, q: Array, across: Array) -> Array:
        """Place of the contact on the face, from the foot of the camshaft's perpendicular, mm.

        Args:
            q: motion, in its unit, shape (n,).
            across: distances of the contact from the line, mm, shape (n,).
        """
        support, turn = self.at(q)
        return np.asarray((across - support * np.sin(turn)) / np.cos(turn))


@dataclass(frozen=True, kw_only=True)
class FacePiece(Swept):
    """Envelope of the face, by cam angle.

    Attributes:
        follower: follower whose face it is.
    """

    follower: StraightFollower

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature; where undercut the velocity points backwards.

        Args:
            t: cam angles, rad, shape (n,).
        """
        (h, h1, h2), (turn, turn1, turn2) = self.follower.face_jet(*span_jets(self.motion, t, self.start, self.stop))
        rate = 1 + turn1
        slope, radius = h1 / rate, h + (h2 * rate - h1 * turn2) / rate**3
        radius = np.where(radius == 0, _CUSP, radius)
        normal = np.exp(1j * (np.asarray(t) + self.follower.azimuth + turn))
        point, velocity = (h + 1j * slope) * normal, 1j * radius * rate * normal
        with np.errstate(divide="ignore"):  # at a cusp the curvature is infinite
            return Jet(_flat(point), _flat(velocity), 1 / radius)

    def along(self, t: float) -> float:
        """Place of the contact on the face, from the foot of the camshaft's perpendicular, mm.

        Args:
            t: cam angle, rad.
        """
        face = self.follower.face_jet(*span_jets(self.motion, np.array([t]), self.start, self.stop))
        return float(face.support[1][0] / (1 + face.turn[1][0]))


@dataclass(frozen=True, kw_only=True)
class FaceSpan(OwnSection):
    """Part of the face that rests on a hollow kink of the motion, by the way along it.

    Attributes:
        support: distance of the face from the camshaft, mm.
        normal: angle of its normal in the frame of the cam, rad.
    """

    support: float
    normal: float

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the way t along the face (mm), and curvature, which is 0.

        Args:
            t: ways from the foot of the camshaft's perpendicular, mm, shape (n,).
        """
        normal = np.exp(1j * self.normal)
        points = (self.support + 1j * np.asarray(t)) * normal
        return Jet(_flat(points), _flat(np.full(len(t), 1j * normal)), np.zeros(len(t)))


def _flat(points: Complex) -> Array:
    """Complex numbers as points, shape (n, 2)."""
    return np.stack([points.real, points.imag], axis=1)
