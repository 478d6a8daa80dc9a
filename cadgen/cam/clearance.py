"""Checks of the room that rod and cutter need: the rim, its chamfers, the hub, the walls and the concave parts."""

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.cutter import largest_cutter
from cadgen.cam.follower import Follower
from cadgen.cam.place import cam_place, polar_place
from cadgen.check import Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.parts.blank import Blank

# The chamfers recede at 45 degrees along the rim's normal; the rod, which leans along the radius, recedes by no more.
CHAMFER_LEAN = 45.0


def rod_reach(follower: Follower, theta: Array, steering: Array, blank: Blank, rod_length: float) -> Check:
    """The rod must cross the whole rim: its end lies beyond the outer face at every steering, shape (2, n)."""
    T = np.abs(steering).max(axis=0)
    # Of the end's rim, the point nearest to the fork lies r sin(beta) nearer than its centre.
    beyond = rod_length / np.sqrt(1 + T**2) - follower.radius * T / np.sqrt(1 + T**2)
    worst = int(np.argmin(beyond))
    return Check(
        CheckCode.ROD_PAST_RIM,
        "rod past the rim",
        float(beyond[worst] - blank.faces(follower.inner, follower.outer)[1]),
        "mm",
        0.0,
        "min",
        cam_place(theta[worst]),
        "the rod slips off the disc's rim: raise follower.length_mm",
    )


def chamfer_clearance(theta: Array, steering: Array, blank: Blank) -> list[Check]:
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
            "max",
            cam_place(theta[worst]),
            "the rod leans so far that it rides on the broken edge: leave the edges sharp (blank.edge_break_mm) or "
            "widen the turn there (path.waypoints_mm)",
        )
    ]


def hub_clearance(follower: Follower, theta: Array, steering: Array, blank: Blank) -> list[Check]:
    """The rod passes above the hub as well as above the disc, at every steering, shape (2, n)."""
    if blank.hub is None:
        return []
    inner, outer = blank.faces(follower.inner, follower.outer)
    ends = {
        "outer": (outer, outer + blank.hub.length),
        "inner": (inner - blank.hub.length, inner),
    }[blank.hub.side]
    nearest = np.min([follower.base_radius + w * steering for w in ends], axis=0)
    nearest = (nearest - follower.radius * np.sqrt(1 + steering**2)).min(axis=0)
    worst = int(np.argmin(nearest))
    return [
        Check(
            CheckCode.ROD_ABOVE_HUB,
            "rod above the hub",
            float(nearest[worst]) - blank.hub.diameter / 2,
            "mm",
            0.0,
            "min",
            cam_place(theta[worst]),
            "the rod meets the hub: lower blank.hub.diameter_mm or blank.hub.length_mm",
        )
    ]


def thinnest_wall(blank: Blank, outline: Outline, limit: float) -> Check:
    """The thinnest wall between the profile and the holes, or between two holes, against its limit, mm."""
    wall = min(blank.walls(outline), key=lambda wall: wall.thickness)
    return Check(
        CheckCode.THINNEST_WALL,
        "thinnest wall",
        wall.thickness,
        "mm",
        limit,
        "min",
        f"{wall.between}, {polar_place(wall.place)}",
        "make the hole smaller or move it (the design's [blank]), or lower checks.min_wall_mm",
    )


def cutter_room(curve: ClosedCurve, cutter_radius: float) -> Check:
    """Diameter of the largest cutter that can mill the whole profile, mm; the limit is the design's own cutter."""
    cutter = largest_cutter(curve)
    return Check(
        CheckCode.CUTTER_RADIUS,
        "largest cutter radius",
        cutter.radius,
        "mm",
        cutter_radius,
        "min",
        "no concave part" if cutter.point is None else f"{polar_place(cutter.point)} ({cutter.kind})",
        "choose a smaller machining.cutter_diameter_mm",
    )
