"""Flat face on an arm that swings about a pivot.

At cam angle theta the pivot stands on the ray, at c from the camshaft. The face runs parallel to a line through the
pivot, at the distance f from it, positive with the pivot on the far side of the face. That line has the angle
delta = delta_0 + q to the one from the pivot to the camshaft; g = 1 where the arm lifts against the sense of the cam,
-1 where it lifts with it.

**Envelope.** The face has the distance h = c sin(delta) - f from the camshaft, where sin(delta_0) = (R_b + f) / c. Its
normal has the angle g (delta - 90 degrees) from the ray (see `cadgen.cam.straight_follower`).

**Rolling.** A point at the distance R and the angle phi, at the pivot, is cleared from delta = phi + arcsin(f / R) on.

**Pressure angle.** The contact lies w = c cos(delta) / (1 + g q') from the foot of the pivot's perpendicular on the
face, and tan(alpha) = f / w.
"""

from dataclasses import dataclass, replace
from math import ceil, inf

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Contact, FollowerDimension, LossRemedy, RolledCam, SizeThatFits
from cadgen.cam.followers.face_run import contact_run, face_end
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.pivot import ArmFollower, pivot_checks, seen_from_pivot
from cadgen.cam.limits import CheckLimits
from cadgen.cam.sizing import ArmSizes, rounded_up
from cadgen.cam.straight_follower import FaceJet, StraightFollower
from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message, joined

_ROLLED = 1e-5  # rad; what the pressure angle of a rolled contact may err by
_SURE = 1e-4  # mm; what a radius of curvature may err by
_FARTHER = np.radians(20.0)  # of the face at rest with a pivot that stands farther away
_PICTURED = (0.6, 1.4)  # ends of a face without a length in pictures, by the contact's distance at rest


@dataclass(frozen=True, kw_only=True)
class SwingingFace(ArmFollower, StraightFollower):
    """Flat face on an arm.

    Attributes:
        base: radius of the base circle, mm.
        face_offset: distance f of the face from the pivot, mm, positive with the pivot on the far side of it.
        centre_distance: distance of the pivot from the camshaft, mm.
        lifts: sense in which the arm lifts.
        length: length of the face from the foot of the pivot's perpendicular, mm; None for as long as it must be.
    """

    base: float
    face_offset: float
    centre_distance: float
    lifts: Lifts
    length: float | None = None

    noun = Message("flat face")
    base_key = "cam.base_circle_radius_mm"
    milder = Message("raise cam.base_circle_radius_mm")

    @property
    def base_radius(self) -> float:  # type: ignore[override]
        """Distance of the face from the camshaft where the swing is 0, mm."""
        return self.base

    @property
    def rest(self) -> float:
        """Angle delta_0 of the face where the swing is 0, rad."""
        return float(np.arcsin(min((self.base + self.face_offset) / self.centre_distance, 1.0)))

    @property
    def lever(self) -> float:
        """Distance of the contact from the foot of the pivot's perpendicular at rest at swing 0, mm."""
        return float(self.centre_distance * np.cos(self.rest))

    @property
    def azimuth(self) -> float:
        """Angle from the ray, on which the pivot stands, to the face's normal where the swing is 0, rad."""
        return self.lifts.side * (self.rest - np.pi / 2)

    def of_support(self, support: Array) -> Array:
        """Swing by the distance of the face from the camshaft, rad.

        Args:
            support: distances, mm, shape (n,).
        """
        sine = (support + self.face_offset) / self.centre_distance
        return np.asarray(np.arcsin(np.clip(sine, -1.0, 1.0)) - self.rest)

    def leaning(self, least: float, greatest: float) -> tuple[float, float]:
        """Least and greatest angle of its normal from its line while its distance is between two, rad.

        Args:
            least: least distance of the face from the camshaft, mm.
            greatest: greatest distance, mm.
        """
        sines = (np.array([least, greatest]) + self.face_offset) / self.centre_distance
        turns = self.lifts.side * (np.arcsin(np.clip(sines, -1.0, 1.0)) - self.rest)
        return float(turns.min()), float(turns.max())

    def face_jet(self, q: Array, q1: Array, q2: Array) -> FaceJet:
        """Face by the cam angle.

        Args:
            q: swing, rad, shape (n,).
            q1: its first derivative by the cam angle, rad/rad.
            q2: its second derivative, rad/rad².
        """
        sine, cosine = self.centre_distance * np.sin(self.rest + q), self.centre_distance * np.cos(self.rest + q)
        return FaceJet(
            np.array([sine - self.face_offset, cosine * q1, cosine * q2 - sine * q1**2]),
            self.lifts.side * np.array([q, q1, q2]),
        )

    def _at_camshaft(self, swing: float) -> bool:
        """Whether the face reaches the camshaft at a swing, rad, so that nothing is left of the disc."""
        return self.centre_distance * np.sin(self.rest + swing) <= self.face_offset or self.rest + swing <= 0

    def keeps(self, motion: Motion) -> bool:
        """Whether a motion is not refused.

        Args:
            motion: swing wanted.
        """
        swing = motion.stations[1]
        if self.rest + swing.max() >= np.pi / 2 or self._at_camshaft(float(swing.min())):
            return False
        return bool(self._rate(motion)[1].min() > 0 and self.reach_of(motion)[1].max() < self.centre_distance)

    def reach_of(self, motion: Motion) -> tuple[Array, Array]:
        """Cam angles, rad, and distance of the contact from the camshaft there, mm.

        Args:
            motion: swing wanted.
        """
        theta, rate = self._rate(motion)
        support, slope, _ = self.face_jet(motion.q(theta), motion.q(theta, nu=1), np.zeros_like(theta)).support
        return theta, np.asarray(np.hypot(support, slope / rate))

    def farther(self, share: float) -> tuple["SwingingFace", str]:
        """Face whose pivot stands farther from the camshaft, and the change that makes it.

        Args:
            share: distance of that pivot by the present one, dimensionless.
        """
        made = replace(self, centre_distance=ceil(share * self.centre_distance))
        return made, Message("{key} to {value:g}", key="follower.centre_distance_mm", value=made.centre_distance)

    def _rate(self, motion: Motion) -> tuple[Array, Array]:
        """Cam angles, rad, and how fast the cam turns past the face there, as a share of its speed."""
        theta = np.unique(np.concatenate([motion.stations[0], np.linspace(0.0, 2 * np.pi, 3601)]))
        return theta, np.asarray(1 + self.lifts.side * motion.q(theta, nu=1))

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Disc, distance of the pivot from the camshaft, and of the face from the pivot."""
        return (
            *super().dimensions(),
            FollowerDimension("centre_distance", lambda q, q1: np.asarray(np.sin(self.rest + q))),
            FollowerDimension("face_offset", lambda q, q1: -np.ones_like(q)),
        )

    def refuse(self, motion: Motion) -> None:
        """Refuse a swing that ends beyond the square position, or turns the face as fast as the cam turns."""
        angles, swing = motion.stations
        high, low = int(np.argmax(swing)), int(np.argmin(swing))
        if self.rest + swing[high] >= np.pi / 2:
            touching = self.base + self.face_offset
            farther = replace(self, centre_distance=ceil(10 * touching / np.sin(_FARTHER)) / 10)
            cures = [self.smaller_swing(motion)]
            if farther.keeps(motion):
                cures.append(Message("set follower.centre_distance_mm to {c:g}", c=farther.centre_distance))
            raise DesignError(
                "at cam angle {angle:.1f} degrees the face has swung to {swung:.2f} degrees from the line of its pivot "
                "and the camshaft, where no contact is left to lift it: {cures}",
                angle=np.degrees(angles[high]) % 360,
                swung=np.degrees(self.rest + swing[high]),
                cures=joined([cure for cure in cures if cure], Message(", or "))
                or Message("lead it less far, and raise follower.centre_distance_mm"),
            )
        if self._at_camshaft(float(swing[low])):
            raise DesignError(
                "the {noun} comes to the camshaft at cam angle {angle:.1f} degrees, so nothing is left of the disc: "
                "raise {base_key}, or {higher}",
                noun=self.noun,
                angle=np.degrees(angles[low]) % 360,
                base_key=self.base_key,
                higher=motion.higher(float(angles[low])),
            )
        theta, rate = self._rate(motion)
        slowest = int(np.argmin(rate))
        if rate[slowest] <= 0:
            raise DesignError(
                "at cam angle {angle:.1f} degrees the face swings as fast as the cam turns, by {rate:.3g} degrees in a "
                "degree, so no contact travels along it: {softer}",
                angle=np.degrees(theta[slowest]) % 360,
                rate=abs(float(motion.q(theta[slowest], nu=1))),
                softer=joined(
                    filter(None, (motion.softer(float(theta[slowest])), self.smaller_swing(motion))), Message(", or ")
                ),
            )
        self.refuse_cover(motion)

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Swing from which on the face clears points, rad (see the module's equation).

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        distance, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        return (angle + np.arcsin(np.clip(self.face_offset / distance, -1.0, 1.0)) - self.rest,)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        distance, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        near = np.maximum(distance - off, 1e-9) if self.face_offset > 0 else distance + off
        aside = np.arcsin(np.clip(off / np.maximum(distance, off), 0.0, 1.0))
        return (angle + aside + np.arcsin(np.clip(self.face_offset / near, -1.0, 1.0)) - self.rest,)

    def from_foot(self, q: Array, across: Array) -> Array:
        """Distance w of the contact from the foot of the pivot's perpendicular on the face, mm.

        Args:
            q: swing, rad, shape (n,).
            across: distances of the contact from the follower's line, mm, shape (n,).
        """
        foot = self.centre_distance * np.cos(self.rest + q)
        return np.asarray(foot - self.lifts.side * self.along(q, across))

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: its tangent is f / w.

        Args:
            q: swing, rad, shape (n,).
            across: distances of the contact from the follower's line, mm, shape (n,).
        """
        return np.arctan2(self.face_offset, self.from_foot(q, across))

    def normal_share(self, contact: Contact) -> Array:
        """Displacement of the outline along its normal that changes the lift by 1: the lever there by that at rest.

        Args:
            contact: contact of the follower with a disc.
        """
        return self.from_foot(contact.q, contact.across) / self.lever

    def outline(self, q: float, face: float) -> Array:
        """The face, by points in the frame of the follower's line, shape (n, 2), mm.

        Args:
            q: swing, rad.
            face: the follower's plane, as in `planes`, mm.
        """
        first, last = (share * self.lever for share in _PICTURED) if self.length is None else (0.0, self.length)
        support, turn = self.at(np.array([q]))
        along = self.lifts.side * (self.centre_distance * np.cos(self.rest + q) - np.linspace(first, last, 3))
        points = (support + 1j * along) * np.exp(1j * turn)
        return np.stack([points.real, points.imag], axis=1)

    def remedies(self) -> tuple[LossRemedy, ...]:
        """A larger base circle."""
        return (LossRemedy(self.base_key, self.base, True, lambda value: replace(self, base=value)),)

    def least_base(self, motion: Motion, rise: float, fall: float, convex: float) -> float:
        """Least base circle that keeps limits of the pressure angle and of the radius, mm; infinite if none does.

        Args:
            motion: swing wanted.
            rise: limit while the follower rises or stands, rad.
            fall: limit while it returns, rad.
            convex: least radius of curvature of the profile, mm.
        """
        sizes = ArmSizes(motion, self.centre_distance, self.lifts.side, rise, fall)
        low, high = sizes.of_face(self.face_offset, convex)
        base = float(self.centre_distance * np.sin(low) - self.face_offset)
        return base if low <= high and replace(self, base=max(base, _SURE)).keeps(motion) else inf

    def sizes(self, motion: Motion, limits: CheckLimits) -> tuple[SizeThatFits, ...]:
        """Least base circle with which neither the pressure angle nor the radius of curvature is beyond its limit.

        Args:
            motion: swing wanted.
            limits: limits of the checks, mm and rad.
        """
        angle = limits.pressure_angle
        base = self.least_base(motion, angle.rise - _ROLLED, angle.fall - _ROLLED, limits.min_convex_radius + _SURE)
        return (SizeThatFits(self.base_key, self.base, rounded_up(base)),) if 0 < base < inf else ()

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """Run of the contact on the face, its end where it has a length, and room between disc and pivot."""
        theta = cam.contact.cam_angle
        along = self.from_foot(cam.contact.q, cam.contact.across)
        ends = tuple[Check, ...]()
        if self.length is not None:
            advice = Message("set follower.length_mm to {long:g}", long=ceil(10 * float(along.max())) / 10)
            ends = (face_end(self.length - along, theta, advice),)
        return (*contact_run(along, theta), *ends, *pivot_checks(cam, self.centre_distance))
