"""Errors of the lift by what is off in a cam and its follower, to first order; and of a disc that is put on wrong.

Let the follower's curve be moved along its outward normal by u while the disc stays: the follower goes by -u / p. Here
p (`push`) is the displacement along the normal by the motion. A disc turned ahead by phi gives q' phi. One whose bore
is off by a vector D, which turns with the disc, gives n D / p, with the outward normal n in the disc's frame. Of all
errors the value at the cam angle at which the follower is set is taken off, for setting it takes that out.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll, rolling_step
from cadgen.cam.follower import Follower
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.laws.motion import Motion

PHASE = "phase"
ECCENTRICITY = "eccentricity"
_STATIONS = 1440


@dataclass(frozen=True, eq=False)
class LiftError:
    """Error of the lift by a unit of a deviation.

    Attributes:
        code: code of the deviation.
        of_unit: lift by mm, or by rad of an angle, at the stations, mm, shape (n, 1); of a deviation with a direction
            along x and y of the disc, shape (n, 2).
    """

    code: str
    of_unit: Array

    @property
    def greatest(self) -> Array:
        """Greatest size of the error at each station by a unit in any direction, mm, shape (n,)."""
        return np.asarray(np.linalg.norm(self.of_unit, axis=1))


@dataclass(frozen=True, eq=False)
class LiftErrors:
    """Errors of the lift of a cam by everything that may be off.

    Attributes:
        cam_angle: stations, rad, shape (n,).
        errors: errors by a unit of each deviation.
    """

    cam_angle: Array
    errors: tuple[LiftError, ...]

    @classmethod
    def of(cls, motion: Motion, follower: Follower, set_at: float | None) -> "LiftErrors":
        """Errors of a cam.

        Args:
            motion: motion wanted.
            follower: follower.
            set_at: cam angle at which the follower is set, rad; None if it is not.

        Raises:
            DesignError: the kind of follower does not say what its dimensions do.
        """
        theta = np.arange(_STATIONS) * TURN / _STATIONS
        places = theta if set_at is None else np.append(theta, set_at % TURN)
        jets = motion.jets(places)
        push = follower.push(jets[:, 0], jets[:, 1])
        way = follower.lift(np.array([1.0])) - follower.lift(np.array([0.0]))
        errors = []
        for each in displacements(motion, follower, places):
            lift = each.of_unit / push[:, None] * way
            errors.append(LiftError(each.code, lift if set_at is None else lift[:-1] - lift[-1]))
        return cls(theta, tuple(errors))


def displacements(motion: Motion, follower: Follower, cam_angle: Array) -> tuple[LiftError, ...]:
    """Errors along the outward normal at the contact: the error of the lift times `push`, mm by unit.

    Args:
        motion: motion wanted.
        follower: follower.
        cam_angle: cam angles, rad, shape (n,).

    Raises:
        DesignError: the kind of follower does not say what its dimensions do.
    """
    jets = motion.jets(cam_angle)
    q, q1 = jets[:, 0], jets[:, 1]
    normal = follower.normal(q, q1) * np.exp(1j * (cam_angle + follower.azimuth))
    found = [LiftError(each.code, -each.outwards(q, q1)[:, None]) for each in follower.dimensions()]
    found.append(LiftError(PHASE, (q1 * follower.push(q, q1))[:, None]))
    found.append(LiftError(ECCENTRICITY, np.stack([normal.real, normal.imag], axis=1)))
    return tuple(found)


def wrong_side_up(curve: ClosedCurve, motion: Motion, follower: Follower) -> float:
    """Greatest error of the lift of a disc put on with its other face outwards, turned to where it does best, mm.

    The mirrored outline is rolled: an offset or an arm is then on the wrong side of it.

    Args:
        curve: outline, mm.
        motion: motion wanted.
        follower: follower.

    Raises:
        DesignError: the follower cannot run on the mirrored disc.
    """
    outline = curve.outline(rolling_step(curve, follower))
    turned = Outline(outline.points[::-1] * [1.0, -1.0], outline.piece.max() - outline.piece[::-1])
    theta = np.arange(_STATIONS // 2) * TURN / (_STATIONS // 2)
    had = roll(turned, follower, theta).lift
    wanted = follower.lift(motion.q(theta))
    return min(float(np.abs(np.roll(had, shift) - wanted).max()) for shift in range(len(theta)))
