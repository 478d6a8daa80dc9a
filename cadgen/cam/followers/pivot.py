"""Followers on an arm, what they share: pivot, lever, swing; points as seen from there, and the room of the disc."""

from abc import abstractmethod
from dataclasses import replace
from math import ceil, floor
from typing import Self

import numpy as np
from scipy.interpolate import PPoly

from cadgen.arrays import Array
from cadgen.cam.follower import Follower, RolledCam
from cadgen.cam.followers.lifts import Lifts
from cadgen.check import Bound, Check, CheckCode
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import RAD
from cadgen.messages import Message, joined

_HALVINGS = 12  # of the share of a swing that is sought: to 0.02 % of it
_LEAST_SHARE = 1 / 64  # of a swing; a smaller one is no cure
_SHARES = (1.1, 1.2, 1.35, 1.5, 2.0, 3.0)  # of the pivot's distance, tried in turn where the disc would cover it
_HUNDREDTHS = 100.0  # of a degree, to which the ends of a swing are rounded, to the safe side


class ArmFollower(Follower):
    """Follower on an arm that swings about a pivot on the ray; its lift is the swing times a lever.

    Attributes:
        centre_distance: distance of the pivot from the camshaft, mm.
        lifts: sense in which the arm lifts.
        opposite: whether its motion is the opposite of the one in the design, as of a second arm.
    """

    unit = RAD
    opposite: bool = False
    centre_distance: float
    lifts: Lifts

    @property
    @abstractmethod
    def rest(self) -> float:
        """Angle of the arm to the line from the pivot to the camshaft where the swing is 0, rad."""

    @property
    @abstractmethod
    def lever(self) -> float:
        """Lift by the swing, mm."""

    @abstractmethod
    def reach_of(self, motion: Motion) -> tuple[Array, Array]:
        """Cam angles, rad, and distance of the contact from the camshaft there, mm.

        Args:
            motion: swing wanted.
        """

    @abstractmethod
    def farther(self, share: float) -> tuple[Self, str]:
        """Follower whose pivot stands farther from the camshaft, and the changes that make it.

        Args:
            share: distance of that pivot by the present one, dimensionless.
        """

    @abstractmethod
    def keeps(self, motion: Motion) -> bool:
        """Whether a motion is not refused.

        Args:
            motion: swing wanted.
        """

    @property
    def on_ray(self) -> str:
        """The pivot, in words."""
        return Message("pivot of the {follower}", follower=Message(self.noun))

    @property
    def pivot(self) -> complex:
        """Pivot in the frame of the follower's line, mm."""
        return complex(self.centre_distance * np.exp(-1j * self.azimuth))

    def lift(self, q: Array) -> Array:
        """Way of the contact at rest, or of the roller's centre, along its arc, mm.

        Args:
            q: swing, rad, shape (n,).
        """
        return np.asarray(self.lever * q)

    def of_lift(self, lift: Array) -> tuple[Array, Array, Array]:
        """Swing by lift, mm, with plane and margin.

        Args:
            lift: lifts, mm, shape (n,).
        """
        return lift / self.lever, np.full_like(lift, self.planes[0]), np.full_like(lift, np.inf)

    def refuse_cover(self, motion: Motion) -> None:
        """Refuse a motion with which the disc reaches out to the pivot.

        Args:
            motion: swing wanted.

        Raises:
            DesignError: it is so.
        """
        theta, reach = self.reach_of(motion)
        farthest = int(np.argmax(reach))
        if reach[farthest] < self.centre_distance:
            return
        tried = () if self.opposite else (self.farther(share) for share in _SHARES)
        fits = next((changes for other, changes in tried if other.keeps(motion)), "")
        ways = (Message("set {changes}", changes=fits) if fits else None, self.smaller_swing(motion))
        raise DesignError(
            "at cam angle {angle:.1f} degrees the disc reaches out to {reach:.4g} mm, and would cover the pivot of "
            "the {noun}, {c:g} mm from the camshaft: {cure}",
            angle=np.degrees(theta[farthest]) % 360,
            reach=float(reach[farthest]),
            noun=Message(self.noun),
            c=self.centre_distance,
            cure=joined(filter(None, ways), Message(", or "))
            or Message("lead it less far, or lower cam.base_circle_radius_mm"),
        )

    def smaller_swing(self, motion: Motion) -> Message | None:
        """Advice to lead the arm less far, by the greatest share of a motion that is not refused; None if none is.

        Args:
            motion: swing that is refused.
        """
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            share = (low + high) / 2
            curve = PPoly(motion.q.c * share, motion.q.x, extrapolate="periodic")
            low, high = (share, high) if self.keeps(replace(motion, q=curve)) else (low, share)
        if low < _LEAST_SHARE:
            return None
        swing = np.degrees(low * motion.stations[1]) * (-1.0 if self.opposite else 1.0)
        least, most = (ceil(swing.min() * _HUNDREDTHS), floor(swing.max() * _HUNDREDTHS))
        return Message("lead it by {least:g} to {most:g} degrees", least=least / _HUNDREDTHS, most=most / _HUNDREDTHS)


def seen_from_pivot(pivot: complex, side: int, x: Array, y: Array) -> tuple[Array, Array]:
    """Distances of points from a pivot, mm, and the angles of an arm that points at them, rad.

    Args:
        pivot: pivot in the frame of the follower's line, mm, the camshaft at 0.
        side: 1 for an arm that lifts against the sense of the cam, -1 for one that lifts with it.
        x: coordinates along the follower's line from the camshaft, mm, shape (n,).
        y: coordinates across it, mm, shape (n,).
    """
    c, s = pivot.real / abs(pivot), pivot.imag / abs(pivot)
    along, across = abs(pivot) - (x * c + y * s), x * s - y * c
    return np.hypot(along, across), np.arctan2(side * across, along)


def pivot_checks(cam: RolledCam, centre_distance: float) -> tuple[Check, ...]:
    """Room between the disc as it turns and the pivot.

    Args:
        cam: cam that is rolled.
        centre_distance: distance of the pivot from the camshaft, mm.
    """
    follower, contact = cam.follower, cam.contact
    radius = np.hypot(follower.ahead(contact.q, contact.face, contact.across), contact.across)
    worst = int(np.argmax(radius))
    return (
        Check(
            CheckCode.DISC_TO_PIVOT,
            Message("disc to the pivot"),
            centre_distance - float(radius[worst]),
            "mm",
            cam.limits.wall,
            Bound.MIN,
            Message("cam angle {angle:.2f}°", angle=np.degrees(contact.cam_angle[worst])),
            Message("raise follower.centre_distance_mm, lower cam.base_circle_radius_mm, or make the arm overhang"),
        ),
    )
