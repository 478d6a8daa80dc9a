"""Run of the contact on a straight face, and the ends of the face beyond it."""

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.checks import cam_place
from cadgen.check import Bound, Check, CheckCode
from cadgen.messages import Message


def contact_run(along: Array, cam_angle: Array) -> tuple[Check, ...]:
    """Figures of the run of the contact: its ends, and the width between them, mm.

    Args:
        along: places of the contact on the face, mm, shape (n,).
        cam_angle: cam angles, rad, shape (n,).
    """
    low, high = int(np.argmin(along)), int(np.argmax(along))
    return (
        Check(
            CheckCode.CONTACT_FROM,
            Message("contact on the face, from"),
            float(along[low]),
            "mm",
            place=cam_place(cam_angle[low]),
        ),
        Check(
            CheckCode.CONTACT_TO,
            Message("contact on the face, to"),
            float(along[high]),
            "mm",
            place=cam_place(cam_angle[high]),
        ),
        Check(CheckCode.FACE_WIDTH, Message("width of the face used"), float(np.ptp(along)), "mm"),
    )


def face_end(room: Array, cam_angle: Array, advice: str) -> Check:
    """Check that the face reaches beyond the contact.

    Args:
        room: distances from the contact to the nearer end of the face, mm, shape (n,).
        cam_angle: cam angles, rad, shape (n,).
        advice: change that makes room, in words.
    """
    worst = int(np.argmin(room))
    return Check(
        CheckCode.FACE_END,
        Message("face beyond the contact"),
        float(room[worst]),
        "mm",
        0.0,
        Bound.MIN,
        cam_place(cam_angle[worst]),
        advice,
    )
