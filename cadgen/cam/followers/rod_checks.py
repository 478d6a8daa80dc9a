"""The checks of the leaning rod's own: the face that carries it, and its room at the rim, the chamfers and the hub."""

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.contact import ROLLING_TOLERANCE
from cadgen.cam.follower import RolledCam
from cadgen.cam.followers.rod_geometry import RodGeometry
from cadgen.cam.place import cam_place
from cadgen.check import Bound, Check, CheckCode
from cadgen.parts.blank import Blank

# The chamfers recede at 45 degrees along the rim's normal; the rod, which leans along the radius, recedes by no more.
CHAMFER_LEAN = 45.0


def rod_checks(rod: RodGeometry, cam: RolledCam) -> tuple[Check, ...]:
    """The checks of a rod on its cam.

    Args:
        rod: rod that is rolled.
        cam: on which.
    """
    theta = cam.contact.cam_angle
    return (
        _carrying_face(rod, cam),
        _reach(rod, theta, cam.positions, cam.blank),
        *_lean(theta, cam.positions, cam.blank, cam.limits.motion_key),
        *_hub(rod, theta, cam.positions, cam.blank),
    )


def _carrying_face(rod: RodGeometry, cam: RolledCam) -> Check:
    """Check that the rod rests on the face of eq. 15, wherever the profile is its envelope."""
    contact = cam.contact
    due = rod.contact_face(cam.motion.q(contact.cam_angle))
    wrong = (contact.face != due) & (contact.margin > ROLLING_TOLERANCE) & ~cam.trimmed
    inner = float(np.mean(contact.face == rod.inner)) * 100
    return Check(
        CheckCode.WRONG_FACE,
        "wrong face carries",
        float(np.sum(wrong)),
        "stations",
        0.0,
        Bound.MAX,
        f"inner {inner:.0f} %, outer {100 - inner:.0f} %",
        "the rod rests on the other face than eq. 15 says: use --profile actual",
    )


def _reach(rod: RodGeometry, theta: Array, steering: Array, blank: Blank) -> Check:
    """The rod must cross the whole rim: its end lies beyond the outer face at every steering, shape (2, n)."""
    T = np.abs(steering).max(axis=0)
    # Of the end's rim, the point nearest to the fork lies r sin(beta) nearer than its centre.
    beyond = rod.length / np.sqrt(1 + T**2) - rod.radius * T / np.sqrt(1 + T**2)
    worst = int(np.argmin(beyond))
    return Check(
        CheckCode.ROD_PAST_RIM,
        "rod past the rim",
        float(beyond[worst] - blank.faces(rod.inner, rod.outer)[1]),
        "mm",
        0.0,
        Bound.MIN,
        cam_place(theta[worst]),
        "the rod slips off the disc's rim: raise follower.length_mm",
    )


def _lean(theta: Array, steering: Array, blank: Blank, motion_key: str) -> list[Check]:
    """The rod rides on the land as long as it leans less than the chamfers do, at every steering, shape (2, n)."""
    if blank.edge_break == 0:
        return []
    T = np.abs(steering).max(axis=0)
    worst = int(np.argmax(T))
    return [
        Check(
            CheckCode.LEAN_OVER_CHAMFERS,
            "lean over the chamfers",
            float(np.degrees(np.arctan(T[worst]))),
            "°",
            CHAMFER_LEAN,
            Bound.MAX,
            cam_place(theta[worst]),
            "the rod leans so far that it rides on the broken edge: leave the edges sharp (blank.edge_break_mm) or "
            f"widen the turn there ({motion_key})",
        )
    ]


def _hub(rod: RodGeometry, theta: Array, steering: Array, blank: Blank) -> list[Check]:
    """The rod passes above the hub as well as above the disc, at every steering, shape (2, n)."""
    if blank.hub is None:
        return []
    inner, outer = blank.faces(rod.inner, rod.outer)
    ends = {
        "outer": (outer, outer + blank.hub.length),
        "inner": (inner - blank.hub.length, inner),
    }[blank.hub.side]
    nearest = np.min([rod.base_radius + w * steering for w in ends], axis=0)
    nearest = (nearest - rod.radius * np.sqrt(1 + steering**2)).min(axis=0)
    worst = int(np.argmin(nearest))
    return [
        Check(
            CheckCode.ROD_ABOVE_HUB,
            "rod above the hub",
            float(nearest[worst]) - blank.hub.diameter / 2,
            "mm",
            0.0,
            Bound.MIN,
            cam_place(theta[worst]),
            "the rod meets the hub: lower blank.hub.diameter_mm or blank.hub.length_mm",
        )
    ]
