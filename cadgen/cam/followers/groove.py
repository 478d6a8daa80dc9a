"""Roller in a groove: the rollers of its two flanks, the play between them, and its checks.

The flanks are the two parallels of the path of the roller's centre at half the width of the groove, which is the
diameter of the roller and the clearance. So a roller as wide as the groove runs on the inner flank as on a disc. On the
outer flank it is pressed outwards: its motion is -q, and it clears a point from -q = y0 - x + sqrt(R^2 - (y - e)^2) on.
"""

from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.checks import cam_place, polar_place
from cadgen.cam.contact import roll_curve
from cadgen.cam.follower import Follower, SizedByAnother
from cadgen.cam.followers.pivot import seen_from_pivot
from cadgen.cam.followers.roller import Roller
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.cam.round_follower import Complex, RoundFollower
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.laws.motion import Motion
from cadgen.messages import Message

_STEP = 0.05  # mm between points of the outer flank
_ROLLED = 1e-4  # mm; what rolling errs by, on either flank


class OnOuterFlank(SizedByAnother, RoundFollower):
    """Roller that is pressed outwards, with -q as its motion; a kind gives how it rolls."""

    encloses = True
    noun = Message("roller on the outer flank")

    def centre(self, q: Array, q1: Array, q2: Array) -> tuple[Complex, Complex, Complex]:
        """Centre of the roller in the frame of its line, mm, with its first two derivatives by the cam angle.

        Args:
            q: opposite motion, in its unit, shape (n,).
            q1: its first derivative by the cam angle, 1/rad.
            q2: its second derivative, 1/rad².
        """
        return super().centre(-q, -q1, -q2)  # type: ignore[safe-super]

    def pressed(self, q: Array, normal: Array) -> Array:
        """Pressure angle, rad, as of the roller on the inner flank.

        Args:
            q: opposite motion, in its unit, shape (n,).
            normal: angles of the outline's normal from its line, rad, shape (n,).
        """
        return super().pressed(-q, normal)

    def standing(self, distance: Array) -> tuple[Array, Array]:
        """Opposite lift of the centre, mm, and its polar angle from the line, rad, by its distance from the camshaft.

        Args:
            distance: distances of the centre from the camshaft, mm, shape (n,).
        """
        lift, aside = super().standing(distance)
        return -lift, aside


@dataclass(frozen=True, kw_only=True)
class OuterRoller(OnOuterFlank, Roller):
    """Roller on a slide, pressed outwards."""

    noun = OnOuterFlank.noun

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Opposite motion from which on the roller clears points beyond it, mm.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        across = y - self.offset
        half = np.sqrt(np.maximum(self.radius**2 - across**2, 0.0))
        return (np.where(np.abs(across) < self.radius, self.base_radius - x + half, -np.inf),)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        return super().most(x - 2 * off, y, off)


@dataclass(frozen=True, kw_only=True)
class OuterSwingingRoller(OnOuterFlank, SwingingRoller):
    """Roller on an arm, pressed outwards."""

    noun = OnOuterFlank.noun

    def refuse(self, motion: Motion) -> None:
        """Refuse as any round follower; what the arm cannot do is refused to the roller on the inner flank.

        Args:
            motion: opposite motion.
        """
        RoundFollower.refuse(self, motion)

    def sector(self, least: float, greatest: float) -> tuple[float, float]:
        """Polar angles from its line between which the roller touches the flank, rad.

        Args:
            least: least radius of the flank, mm.
            greatest: greatest radius of the flank, mm.
        """
        return super().sector(max(least - 2 * self.radius, self.radius), greatest - 2 * self.radius)

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Opposite motion from which on the roller clears points beyond it, rad.

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        distance, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        within = np.abs(distance - self.arm) < self.radius
        return (np.where(within, self.rest + self._opening(distance) - angle, -np.inf),)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Upper bound of `least` over all points within `off` mm of each point.

        Args:
            x: coordinates along the follower's line from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        _, angle = seen_from_pivot(self.pivot, self.lifts.side, x, y)
        (bound,) = super().most(x, y, off)
        # That bound is of angle + opening - rest; here the angle counts the other way.
        return (np.where(np.isneginf(bound), bound, bound - 2 * angle + 2 * self.rest),)


@dataclass(frozen=True)
class GrooveRollers:
    """Rollers of a groove: as wide as it for its flanks, and the roller itself for its play.

    Attributes:
        inner: roller as wide as the groove on the inner flank.
        outer: the same on the outer flank, with the opposite motion.
        loose: roller itself on either flank.
        clearance: width of the groove less the diameter of the roller, mm.
        depth: depth of the groove, mm.
    """

    inner: Follower
    outer: Follower
    loose: tuple[Follower, Follower]
    clearance: float
    depth: float

    @classmethod
    def of(cls, roller: Roller | SwingingRoller, clearance: float, depth: float) -> "GrooveRollers":
        """Rollers of a groove for a roller.

        Args:
            roller: roller that runs in it.
            clearance: width of the groove less the diameter of the roller, mm.
            depth: depth of the groove, mm.
        """
        wide = replace(roller, base=roller.base - clearance / 2, radius=roller.radius + clearance / 2)
        return cls(wide, pressed_outwards(wide), (roller, pressed_outwards(roller)), clearance, depth)

    @property
    def half_width(self) -> float:
        """Half the width of the groove, mm."""
        return self.inner.radius


def pressed_outwards(roller: Roller | SwingingRoller) -> OnOuterFlank:
    """The roller on the outer flank.

    Args:
        roller: roller of either kind.
    """
    if isinstance(roller, SwingingRoller):
        return OuterSwingingRoller(
            base=roller.base,
            radius=roller.radius,
            arm=roller.arm,
            centre_distance=roller.centre_distance,
            lifts=roller.lifts,
        )
    return OuterRoller(base=roller.base, radius=roller.radius, offset=roller.offset)


def groove_checks(
    rollers: GrooveRollers, inner: ClosedCurve, outer: ClosedCurve, cam_angle: Array, outside: float, wall: float
) -> tuple[Check, ...]:
    """Play of the roller along its motion, and the wall beyond the groove.

    The play is what lies between the places at which the roller itself rests on either flank; to first order the
    clearance by the cosine of the pressure angle.

    Args:
        rollers: rollers of the groove.
        inner: inner flank, mm.
        outer: outer flank, mm.
        cam_angle: cam angles, rad, shape (n,).
        outside: radius of the disc, mm.
        wall: least wall allowed, mm.
    """
    inwards, outwards = rollers.loose
    (low, _), (high, _) = roll_curve(inner, inwards, cam_angle), roll_curve(outer, outwards, cam_angle)
    play = -high.lift - low.lift
    most, least = int(np.argmax(play)), int(np.argmin(play))
    rim = outer.outline(_STEP).points
    farthest = int(np.argmax(np.linalg.norm(rim, axis=1)))
    hollow = [piece.jet(t) for piece, t in zip(outer.pieces, outer.parameters(_STEP), strict=True)]
    sharpest = max(float(jet.curvature.max()) for jet in hollow)
    return (
        Check(
            CheckCode.GROOVE_PLAY_GREATEST,
            Message("play in the groove, greatest"),
            float(play[most]),
            "mm",
            place=cam_place(cam_angle[most]),
        ),
        Check(
            CheckCode.GROOVE_PLAY_LEAST,
            Message("play in the groove, least"),
            float(play[least]),
            "mm",
            -_ROLLED,
            Bound.MIN,
            cam_place(cam_angle[least]),
            Message("raise follower.clearance_mm"),
        ),
        Check(
            CheckCode.GROOVE_HOLLOW,
            Message("least radius of the outer flank"),
            1 / sharpest if sharpest > 0 else np.inf,
            "mm",
        ),
        Check(
            CheckCode.GROOVE_WALL,
            Message("wall beyond the groove"),
            outside - float(np.linalg.norm(rim[farthest])),
            "mm",
            wall,
            Bound.MIN,
            polar_place(rim[farthest]),
            Message("raise cam.outside_diameter_mm"),
        ),
    )
