"""Pivots of followers on an arm: points as they are seen from there, and the room that the disc leaves."""

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import RolledCam
from cadgen.check import Bound, Check, CheckCode
from cadgen.messages import Message


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
