"""Where a follower rests on a disc, and what the checks of its own kind go by."""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.cam.lift import LiftCurve
from cadgen.cam.limits import CheckLimits
from cadgen.parts.blank import Blank


@dataclass(frozen=True)
class Contact:
    """Contact of the follower with the disc at each cam angle; all arrays have shape (n,).

    Attributes:
        cam_angle: cam angle, rad.
        tan_beta: tangent of the steering angle that results.
        lift: lift s, mm.
        face: lateral distance of the plane that carries the follower, mm.
        margin: lift by which that plane lifts the follower further than the other one alone would, mm; where it is no
            more than `ROLLING_TOLERANCE` either may be the one that carries. Infinite if there is no other.
        across: coordinate y of the contact point, mm, ahead in the sense of growing polar angle.
        pressure_angle: angle between the force on the follower and the velocity of its reference point, rad; positive
            where the outline rises under it. The rod's axis moves horizontally and the force is square to it, so
            sin(pressure angle) = across / r; for a point on its own curve tan = (dR/dphi) / R.
    """

    cam_angle: Array
    tan_beta: Array
    lift: Array
    face: Array
    margin: Array
    across: Array
    pressure_angle: Array

    def at(self, rows: NDArray[np.intp]) -> "Contact":
        """Contact at some of the cam angles, by their indices."""
        return Contact(*(getattr(self, field.name)[rows] for field in fields(self)))


@dataclass(frozen=True, kw_only=True)
class RolledCam:
    """A cam with its follower rolled on it.

    Attributes:
        lift: lift wanted, as tan(beta) by cam angle.
        contact: contact of the follower with the profile, at n cam angles.
        trimmed: whether the closing blend steers or the envelope is trimmed there, shape (n,).
        steering: tan(beta) wanted and, where the blend does not give it, had; shape (2, n).
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
    """

    lift: LiftCurve
    contact: Contact
    trimmed: NDArray[np.bool_]
    steering: Array
    blank: Blank
    limits: CheckLimits
