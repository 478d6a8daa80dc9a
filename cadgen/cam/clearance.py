"""Checks of the room that the disc's walls and the cutter need."""

from cadgen.cam.cutter import largest_cutter
from cadgen.cam.place import polar_place
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.parts.blank import Blank


def thinnest_wall(blank: Blank, outline: Outline, limit: float) -> Check:
    """The thinnest wall between the profile and the holes, or between two holes, against its limit, mm.

    Args:
        blank: blank of the disc.
        outline: points of the disc's outline.
        limit: least wall allowed, mm.
    """
    wall = min(blank.walls(outline), key=lambda wall: wall.thickness)
    return Check(
        CheckCode.THINNEST_WALL,
        "thinnest wall",
        wall.thickness,
        "mm",
        limit,
        Bound.MIN,
        f"{wall.between}, {polar_place(wall.place)}",
        "make the hole smaller or move it (the design's [blank]), or lower checks.min_wall_mm",
    )


def cutter_room(curve: ClosedCurve, cutter_radius: float) -> Check:
    """Diameter of the largest cutter that can mill the whole profile, mm; the limit is the design's own cutter.

    Args:
        curve: profile, mm.
        cutter_radius: radius of the cutter, mm.
    """
    cutter = largest_cutter(curve)
    return Check(
        CheckCode.CUTTER_RADIUS,
        "largest cutter radius",
        cutter.radius,
        "mm",
        cutter_radius,
        Bound.MIN,
        "no concave part" if cutter.point is None else f"{polar_place(cutter.point)} ({cutter.kind})",
        "choose a smaller machining.cutter_diameter_mm",
    )
