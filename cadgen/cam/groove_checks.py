"""Checks of a groove: play of the roller between its flanks, wall beyond it, and hollows of its outer flank."""

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.checks import cam_place, polar_place
from cadgen.cam.contact import roll_curve
from cadgen.cam.followers.groove import GrooveRollers
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.messages import Message

_STEP = 0.05  # mm between points of the outer flank


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


_ROLLED = 1e-4  # mm; what rolling errs by, on either flank
