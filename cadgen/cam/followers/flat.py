"""Flat face on a slide, square to it or tilted.

**Envelope.** At cam angle theta the face has the distance h = R_b + s cos(tau) from the camshaft, and its normal the
angle -tau from the ray (see `cadgen.cam.straight_follower`).

**Rolling.** With the normal n = (cos(tau), -sin(tau)) the face clears a point p from s = (n p - R_b) / cos(tau) on.

The slide's axis lies beside the camshaft by an offset, which moves the face along itself and leaves the profile alone.
From there the contact lies w = s' cos(tau) - e cos(tau) - ((R_b + e sin(tau)) / cos(tau) + s) sin(tau) along the face.
"""

from dataclasses import dataclass, replace
from math import ceil

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import FollowerDimension, LossRemedy, RolledCam, SizeThatFits
from cadgen.cam.followers.face_run import contact_run, face_end
from cadgen.cam.limits import CheckLimits
from cadgen.cam.sizing import least_base_of_face, rounded_up
from cadgen.cam.straight_follower import FaceJet, StraightFollower
from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class FlatFace(StraightFollower):
    """Flat face on a slide.

    Attributes:
        base: radius of the base circle, mm.
        tilt: angle of the normal from the slide's axis, rad, positive towards smaller polar angles.
        offset: distance of the slide's axis from the camshaft, mm, positive in the sense of growing polar angle.
        width: width of the face, centred on the slide's axis, mm; None for a face as wide as it must be.
    """

    base: float
    tilt: float = 0.0
    offset: float = 0.0
    width: float | None = None

    noun = Message("flat face")
    base_key = "cam.base_circle_radius_mm"
    milder = Message("raise cam.base_circle_radius_mm")

    @property
    def base_radius(self) -> float:  # type: ignore[override]
        """Distance of the face ahead of the camshaft, along the ray, where the lift is 0, mm."""
        return float(self.base / np.cos(self.tilt))

    def face_jet(self, q: Array, q1: Array, q2: Array) -> FaceJet:
        """Face by the cam angle.

        Args:
            q: lift, mm, shape (n,).
            q1: its first derivative by the cam angle, mm/rad.
            q2: its second derivative, mm/rad².
        """
        share, none = np.cos(self.tilt), np.zeros_like(q)
        return FaceJet(
            np.array([self.base + q * share, q1 * share, q2 * share]), np.array([none - self.tilt, none, none])
        )

    def of_support(self, support: Array) -> Array:
        """Lift by the distance of the face from the camshaft, mm.

        Args:
            support: distances, mm, shape (n,).
        """
        return np.asarray((support - self.base) / np.cos(self.tilt))

    def leaning(self, least: float, greatest: float) -> tuple[float, float]:
        """The angle of its normal, which does not change, rad.

        Args:
            least: least distance of the face from the camshaft, mm.
            greatest: greatest distance, mm.
        """
        return -self.tilt, -self.tilt

    def refuse(self, motion: Motion) -> None:
        """Refuse a motion that brings the face to the camshaft."""
        angles, lift = motion.stations
        lowest = int(np.argmin(lift))
        if self.base + lift[lowest] * np.cos(self.tilt) <= 0:
            raise DesignError(
                "the {noun} comes to the camshaft at cam angle {angle:.1f} degrees, so nothing is left of the disc: "
                "raise {base_key}, or {higher}",
                noun=self.noun,
                angle=np.degrees(angles[lowest]) % 360,
                base_key=self.base_key,
                higher=motion.higher(float(angles[lowest])),
            )

    def sizes(self, motion: Motion, limits: CheckLimits) -> tuple[SizeThatFits, ...]:
        """Least base circle with which the profile is nowhere sharper than is allowed, and so not undercut.

        Args:
            motion: motion wanted.
            limits: limits of the checks, mm and rad.
        """
        base = rounded_up(least_base_of_face(motion, self.tilt, limits.min_convex_radius))
        return (SizeThatFits(self.base_key, self.base, base),) if base > 0 else ()

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Disc, and the tilt of the face, about the point where the slide's axis meets it."""

        def leaning(q: Array, q1: Array) -> Array:
            # Both from the foot of the camshaft's perpendicular, along the face: the contact, and the slide's axis.
            support = self.base + q * np.cos(self.tilt)
            axis = support * np.tan(self.tilt) + self.offset / np.cos(self.tilt)
            return np.asarray(q1 * np.cos(self.tilt) - axis)

        return (*super().dimensions(), FollowerDimension("tilt", leaning))

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Lift from which on the face clears points, mm.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        return ((x * np.cos(self.tilt) - y * np.sin(self.tilt) - self.base) / np.cos(self.tilt),)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        (asked,) = self.least(x, y)
        return (asked + off / np.cos(self.tilt),)

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: minus the tilt.

        Args:
            q: lift, mm, shape (n,).
            across: distances of the contact from the ray, mm, shape (n,).
        """
        return np.full_like(np.asarray(across, dtype=float), 0.0 - self.tilt)  # and not -0

    def outline(self, q: float, face: float) -> Array:
        """The face, by its ends in the frame of the ray, shape (n, 2), mm.

        Args:
            q: lift, mm.
            face: the follower's plane, as in `planes`, mm.
        """
        half = (self.base if self.width is None else self.width / 2) * np.cos(self.tilt)
        across = self.offset + np.linspace(-half, half, 3)
        return np.column_stack([self.ahead(np.full(3, q), np.zeros(3), across), across])

    def from_axis(self, q: Array, across: Array) -> Array:
        """Place of the contact on the face, from where the slide's axis cuts it, mm.

        Args:
            q: lift, mm, shape (n,).
            across: distances of the contact from the ray, mm, shape (n,).
        """
        return np.asarray((across - self.offset) / np.cos(self.tilt))

    def remedies(self) -> tuple[LossRemedy, ...]:
        """A larger base circle."""
        return (LossRemedy(self.base_key, self.base, True, lambda value: replace(self, base=value)),)

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """Run of the contact on the face, and its ends where it has a width."""
        theta = cam.contact.cam_angle
        along = self.from_axis(cam.contact.q, cam.contact.across)
        if self.width is None:
            return contact_run(along, theta)
        middle = float(along.max() + along.min()) / 2
        wide, least = (ceil(20 * width) / 10 for width in (np.abs(along).max(), np.ptp(along) / 2))
        offset = round(self.offset + middle * float(np.cos(self.tilt)), 2) + 0.0  # no -0
        # The offset is rounded to 5 um, which the width makes up for.
        central = {"offset": offset, "least": least + 0.1}
        if central["least"] <= self.width:
            advice = Message(
                "set follower.face_offset_mm to {offset:g}, or follower.width_mm to {wide:g}", wide=wide, **central
            )
        else:
            advice = Message(
                "set follower.width_mm to {wide:g}, or to {least:g} with follower.face_offset_mm = {offset:g}",
                wide=wide,
                **central,
            )
        return (*contact_run(along, theta), face_end(self.width / 2 - np.abs(along), theta, advice))
