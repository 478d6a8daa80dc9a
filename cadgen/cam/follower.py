"""Interface of every follower of a disc cam, of any shape and motion.

The follower is let down on the disc by its spring. At cam angle theta a point of the disc lies x ahead of the camshaft,
along the ray of that angle, and y across it. The follower moves by tan(beta), the steering that it gives: the greater
that is, the further out it stands.

Two derivations that share nothing meet in it. `piece` and `section` are its envelope in closed form, of which
`cadgen.cam.envelope` makes the profile; `least` is the place at which it clears a point, by which `cadgen.cam.contact`
rolls it on any outline. The one is tested by the other.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.branch import Branch, Swept
from cadgen.cam.lift import LiftCurve
from cadgen.cam.rolled import RolledCam
from cadgen.check import Check
from cadgen.curves.closed import ClosedCurve


@dataclass(frozen=True)
class Remedy:
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


class Follower(ABC):
    """A curve that rides on the disc; a kind is a frozen dataclass with the properties and methods below.

    Attributes:
        noun: name of the follower in messages.
        milder: advice where the follower is too large for the cam, in words.
        base_radius: distance of its reference point from the camshaft at steering angle 0, mm.
        radius: least radius of curvature of the curve that touches the disc, mm; infinite for a straight one. Zero
            stands for a point that moves along the ray.
    """

    noun: str = "follower"
    milder: str = "raise cam.base_radius_mm"
    base_radius: float
    radius: float

    @property
    @abstractmethod
    def planes(self) -> tuple[float, ...]:
        """Lateral distances from the fork axis of the planes in which the disc carries it, mm, ascending."""

    @property
    @abstractmethod
    def reach(self) -> float:
        """How far across the ray the points lie, at most, that may carry it, mm."""

    @abstractmethod
    def lift(self, tan_beta: Array) -> Array:
        """Lift s of its reference point, mm.

        Args:
            tan_beta: tangents of the rod's steering angle, shape (n,).
        """

    @abstractmethod
    def of_lift(self, lift: Array) -> tuple[Array, Array, Array]:
        """tan(beta) by lift, mm, with the plane that then carries it, mm, and the margin of `Contact`, mm.

        Args:
            lift: lifts, mm, shape (n,).
        """

    # The envelope.

    @abstractmethod
    def refuse(self, lift: LiftCurve) -> None:
        """Refuse a lift with which nothing is left of the disc.

        Raises:
            DesignError: it is so.
        """

    @abstractmethod
    def piece(self, lift: LiftCurve, face: float, start: float, stop: float) -> Swept:
        """The envelope in a plane between two cam angles, rad, without a kink between them.

        Args:
            lift: lift of the cam.
            face: distance of the plane from the fork axis, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """

    @abstractmethod
    def section(self, before: Swept, after: Swept) -> Branch | None:
        """Its own section that joins two pieces at a hollow kink; None where they meet or cross."""

    @abstractmethod
    def pitch_curve(self, lift: LiftCurve) -> ClosedCurve | None:
        """The curve of its reference point in the cam's frame; None for a follower that has no such point."""

    @abstractmethod
    def point(self) -> Follower:
        """Follower that rolls on the pitch curve: its reference point, of radius zero."""

    def remedies(self) -> tuple[Remedy, ...]:
        """Dimensions whose change, one at a time, lessens lost lift."""
        return ()

    # Rolling.

    @abstractmethod
    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """The least tan(beta) at which it clears points, in each plane; minus infinity for those beside it.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """

    @abstractmethod
    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """As `least`, no less than the greatest of it among all points within a distance `off`, mm, of each.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """

    @abstractmethod
    def pressure_angle(self, tan_beta: Array, across: Array) -> Array:
        """Pressure angle, rad, where it touches the disc at y across, mm.

        Args:
            tan_beta: tangents of the rod's steering angle, shape (n,).
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """

    @abstractmethod
    def distance(self, tan_beta: Array, face: Array) -> Array:
        """How far ahead of the camshaft its reference point stands in a plane, mm.

        Args:
            tan_beta: tangents of the rod's steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """

    @abstractmethod
    def ahead(self, tan_beta: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft it touches the disc at y across, mm.

        Args:
            tan_beta: tangents of the rod's steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """

    def margin(self, apart: Array, face: Array) -> Array:
        """Lift, mm, that belongs to a difference of tan(beta) between two planes; infinite if there is but one.

        Args:
            apart: differences of tan(beta) between two planes, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """
        return np.full_like(apart, np.inf)

    # Checks.

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """The checks of its own kind."""
        return ()
