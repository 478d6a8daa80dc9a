"""Roller on an arm that swings about a pivot.

At cam angle theta the pivot stands on the ray, at c from the camshaft. The arm, of length l, has the angle
delta = delta_0 + q to the line from the pivot to the camshaft; g = 1 where it lifts against the sense of the cam, -1
where it lifts with it.

**Envelope.** In the frame of the ray the centre stands at z = c - l cos(delta) - i g l sin(delta). At swing 0 it is
cos(delta_0) = (c^2 + l^2 - R_p^2) / (2 c l). The profile is the parallel of its path at the roller's radius r.

**Rolling.** A point at the distance R and the angle phi, at the pivot, is cleared from
delta = phi + arccos((l^2 + R^2 - r^2) / (2 l R)) on.

**Pressure angle.** tan(alpha) = (l (1 + g q') - c cos(delta)) / (c sin(delta)); at rest c and l alone set it.
"""

from dataclasses import dataclass, replace
from math import ceil, cos, hypot, inf, sqrt
from typing import Self

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import FollowerDimension, LossRemedy, RolledCam, SizedByAnother, SizeThatFits
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.pivot import ArmFollower, pivot_checks, seen_from_pivot
from cadgen.cam.limits import CheckLimits
from cadgen.cam.round_follower import Complex, RoundFollower
from cadgen.cam.sizing import ArmSizes, rounded_up
from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message, joined

_SECTOR = 65  # distances of the centre at which its angle is looked at
_ROLLED = 1e-5  # rad; what the pressure angle of a rolled contact may err by
_STEEPEST = np.radians(60.0)  # pressure angle at rest beyond which an arm jams in any position


@dataclass(frozen=True, kw_only=True)
class SwingingRoller(ArmFollower, RoundFollower):
    """Roller on an arm.

    Attributes:
        base: radius of the base circle, mm.
        radius: radius of the roller, mm; zero stands for its centre.
        arm: distance of the roller's centre from the pivot, mm.
        centre_distance: distance of the pivot from the camshaft, mm.
        lifts: sense in which the arm lifts.
    """

    base: float
    radius: float
    arm: float
    centre_distance: float
    lifts: Lifts

    noun = Message("roller")
    base_key = "cam.base_circle_radius_mm"
    milder = Message("lower follower.radius_mm or raise cam.base_circle_radius_mm")
    elsewhere = Message("change follower.centre_distance_mm or follower.arm_mm")

    @property
    def base_radius(self) -> float:  # type: ignore[override]
        """Distance of the centre from the camshaft where the swing is 0, mm: the prime radius."""
        return self.base + self.radius

    @property
    def rest(self) -> float:
        """Angle delta_0 of the arm where the swing is 0, rad."""
        c, l = self.centre_distance, self.arm  # noqa: E741
        return float(np.arccos(np.clip((c**2 + l**2 - self.base_radius**2) / (2 * c * l), -1.0, 1.0)))

    @property
    def lever(self) -> float:
        """Length of the arm, mm."""
        return self.arm

    @property
    def azimuth(self) -> float:
        """Angle from the ray, on which the pivot stands, to the centre where the swing is 0, rad."""
        return float(np.angle(self._on_ray(np.array([self.rest])))[0])

    @property
    def reach(self) -> float:
        """Width that carries it at any one cam angle, mm; where that lies, `sector` says."""
        return 2 * self.radius

    def _on_ray(self, delta: Array) -> Complex:
        """Centre in the frame of the ray, mm, by angles of the arm, rad."""
        return np.asarray(self.centre_distance - self.arm * np.exp(1j * self.lifts.side * delta))

    def sector(self, least: float, greatest: float) -> tuple[float, float]:
        """Polar angles from its line between which the roller touches a disc, rad.

        Args:
            least: least radius of the disc, mm.
            greatest: greatest radius of the disc, mm.
        """
        aside = self.standing(np.linspace(least, greatest, _SECTOR) + self.radius)[1]
        half = float(np.arcsin(self.radius / (least + self.radius)))
        room = float(np.abs(np.diff(aside)).max())
        return float(aside.min()) - half - room, float(aside.max()) + half + room

    def centre(self, q: Array, q1: Array, q2: Array) -> tuple[Complex, Complex, Complex]:
        """Centre in the frame of the follower's line, mm, with its first two derivatives by the cam angle.

        Args:
            q: swing, rad, shape (n,).
            q1: its first derivative by the cam angle, rad/rad.
            q2: its second derivative, rad/rad².
        """
        turn = 1j * self.lifts.side
        back = np.exp(-1j * self.azimuth)
        arm = self.arm * np.exp(turn * (self.rest + q)) * back
        return self.centre_distance * back - arm, -turn * q1 * arm, (q1**2 - turn * q2) * arm

    def _beyond(self, motion: Motion) -> int | None:
        """Number of the station at which the arm stands farthest beyond what it can do; None if it does nowhere.

        At rest |alpha| <= 60 degrees where 2 c cos(delta + 60°) <= l <= 2 c cos(delta - 60°).
        """
        swing = motion.stations[1]
        half = float(np.arccos(np.clip(self.arm / (2 * self.centre_distance), -1.0, 1.0)))
        low, high = abs(half - _STEEPEST), half + _STEEPEST
        beyond = np.maximum(low - self.rest - swing, self.rest + swing - high)
        worst = int(np.argmax(beyond))
        return worst if beyond[worst] > 0 else None

    def keeps(self, motion: Motion) -> bool:
        """Whether a motion is not refused.

        Args:
            motion: swing wanted.
        """
        try:
            super().refuse(motion)
        except DesignError:
            return False
        return self._beyond(motion) is None and bool(self.reach_of(motion)[1].max() < self.centre_distance)

    def reach_of(self, motion: Motion) -> tuple[Array, Array]:
        """Cam angles, rad, and distance of the contact from the camshaft there, mm.

        Args:
            motion: swing wanted.
        """
        theta = np.unique(np.concatenate([motion.stations[0], np.linspace(0.0, TURN, 3601)]))
        q, q1 = motion.q(theta), motion.q(theta, nu=1)
        return theta, np.abs(self.at(q) + self.rim * self.normal(q, q1))

    def farther(self, share: float) -> tuple[Self, str]:
        """Roller whose pivot stands farther from the camshaft on an arm that is longer by as much, with the changes.

        Args:
            share: distance of that pivot by the present one, dimensionless.
        """
        c = ceil(share * self.centre_distance)
        made = replace(self, centre_distance=c, arm=round(self.arm + c - self.centre_distance, 6))
        names = {"follower.centre_distance_mm": made.centre_distance, "follower.arm_mm": made.arm}
        changes = (Message("{key} to {value:g}", key=key, value=value) for key, value in names.items())
        return made, joined(changes, Message(" and "))

    def refuse(self, motion: Motion) -> None:
        """Refuse a swing beyond what an arm in this place can do, or as any round follower's."""
        worst = self._beyond(motion)
        if worst is None:
            super().refuse(motion)
            self.refuse_cover(motion)
            return
        angles, swing = motion.stations
        smaller = self.smaller_swing(motion)
        cures = [smaller] if smaller else []
        # With the arm square to the line from camshaft to roller there is no pressure angle at rest.
        square = replace(self, centre_distance=ceil(10 * hypot(self.arm, self.base_radius)) / 10)
        if not self.opposite and square.keeps(motion):
            cures.append(Message("set follower.centre_distance_mm to {c:g}", c=square.centre_distance))
        raise DesignError(
            "at cam angle {angle:.1f} degrees the arm of the {noun} stands at {swung:.2f} degrees from the line of its "
            "pivot and the camshaft, where its pressure angle would be beyond {steepest:.0f} degrees even at rest: "
            "{cures}",
            noun=Message(self.noun),
            angle=np.degrees(angles[worst]) % 360,
            swung=np.degrees(self.rest + swing[worst]),
            steepest=np.degrees(_STEEPEST),
            cures=joined(cures, Message(", or ")) or self.elsewhere,
            base_key=self.base_key if self.opposite or not cures else None,
        )

    def point(self) -> "SwingingRoller":
        """The roller's centre."""
        return replace(self, base=self.base + self.radius, radius=0.0)

    def remedies(self) -> tuple[LossRemedy, ...]:
        """A smaller roller and a larger base circle."""
        return (
            LossRemedy("follower.radius_mm", self.radius, False, lambda value: replace(self, radius=value)),
            LossRemedy(self.base_key, self.base, True, lambda value: replace(self, base=value)),
        )

    def least_base(self, motion: Motion, rise: float, fall: float) -> float:
        """Least base circle that keeps limits of the pressure angle, mm; infinite if none does.

        Args:
            motion: swing wanted.
            rise: limit while the follower rises or stands, rad.
            fall: limit while it returns, rad.
        """
        c, l = self.centre_distance, self.arm  # noqa: E741
        low, high = ArmSizes(motion, c, self.lifts.side, rise, fall).of_roller(l)
        if low > high or low >= np.pi:
            return inf
        return sqrt(c**2 + l**2 - 2 * c * l * cos(max(low, 0.0))) - self.radius

    def sizes(self, motion: Motion, limits: CheckLimits) -> tuple[SizeThatFits, ...]:
        """Least base circle for the limits of the pressure angle.

        Args:
            motion: swing wanted.
            limits: limits of the checks, mm and rad.
        """
        base = self.least_base(motion, limits.pressure_angle.rise - _ROLLED, limits.pressure_angle.fall - _ROLLED)
        return (SizeThatFits(self.base_key, self.base, rounded_up(base)),) if 0 < base < inf else ()

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Swing from which on the roller clears points, rad (see the module's equation).

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        distance, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        within = np.abs(distance - self.arm) < self.radius
        return (np.where(within, angle + self._opening(distance) - self.rest, -np.inf),)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        distance, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        within = np.abs(distance - self.arm) < self.radius + off
        # The angle between arm and point is greatest where the line from the pivot touches the roller.
        tangent = np.sqrt(max(self.arm**2 - self.radius**2, 0.0))
        best = np.clip(tangent, distance - off, distance + off)
        aside = np.arcsin(np.clip(off / np.maximum(distance, off), 0.0, 1.0))
        return (np.where(within, angle + aside + self._opening(best) - self.rest, -np.inf),)

    def _opening(self, distance: Array) -> Array:
        """Angle at the pivot between the arm and a point that the roller touches, rad, by the point's distance, mm."""
        cosine = (self.arm**2 + distance**2 - self.radius**2) / (2 * self.arm * distance)
        return np.asarray(np.arccos(np.clip(cosine, -1.0, 1.0)))

    def pressed(self, q: Array, normal: Array) -> Array:
        """Pressure angle, rad: of the outline's normal against the way of the centre, which is square to the arm.

        Args:
            q: swing, rad, shape (n,).
            normal: angles of the normal from the follower's line, rad, shape (n,).
        """
        across = np.pi / 2 - self.rest - q
        return np.asarray(-self.lifts.side * (normal + self.azimuth) - across)

    def standing(self, distance: Array) -> tuple[Array, Array]:
        """Lift of the centre, mm, and its polar angle from the follower's line, rad, by its distance from the camshaft.

        Args:
            distance: distances of the point from the camshaft, mm, shape (n,).
        """
        c, l = self.centre_distance, self.arm  # noqa: E741
        delta = np.arccos(np.clip((c**2 + l**2 - distance**2) / (2 * c * l), -1.0, 1.0))
        return l * (delta - self.rest), np.asarray(np.angle(self._on_ray(delta)) - self.azimuth)

    def dimensions(self) -> tuple[FollowerDimension, ...]:
        """Disc, roller, length of the arm, and distance of the pivot from the camshaft."""
        back = np.exp(-1j * self.azimuth)
        turn = 1j * self.lifts.side
        return (
            *super().dimensions(),
            self.moved("arm", lambda q: np.asarray(-np.exp(turn * (self.rest + q)) * back)),
            self.moved("centre_distance", lambda q: np.full(len(q), back)),
        )

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """Room between disc and pivot."""
        return pivot_checks(cam, self.centre_distance)


@dataclass(frozen=True, kw_only=True)
class SecondSwingingRoller(SizedByAnother, SwingingRoller):
    """Second roller of a conjugate pair: on a second arm of the same lever, on the other side of the camshaft."""

    noun = Message("second roller")
    base_key = "follower.second.angle_deg"
    milder = Message("lower follower.second.radius_mm or raise follower.second.angle_deg")
    elsewhere = Message("change follower.second.angle_deg or follower.second.arm_mm")
    opposite = True

    @classmethod
    def beside(cls, first: SwingingRoller, radius: float, arm: float, angle: float) -> Self:
        """Second roller of a lever: its arm goes in as the first one's goes out, on the other side.

        Args:
            first: first roller.
            radius: radius of the second one, mm.
            arm: length of its arm, mm.
            angle: angle between both arms, which have the camshaft between them, rad.
        """
        c = first.centre_distance
        prime = float(np.sqrt(c**2 + arm**2 - 2 * c * arm * np.cos(angle - first.rest)))
        other = Lifts.WITH if first.lifts == Lifts.AGAINST else Lifts.AGAINST
        return cls(base=prime - radius, radius=radius, arm=arm, centre_distance=c, lifts=other)
