"""Joints of standing sheets with the base: tabs in slots, and screws from below."""

from collections.abc import Callable, Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
import shapely

from cadgen.car.assembly.frame.frame_ground import NUT_PLAY, FrameGround
from cadgen.car.assembly.frame.frame_sizes import STEP
from cadgen.car.assembly.panels import SheetHole

FIT = 0.1  # mm by which a slot is longer and wider than the tab in it
# mm by which the sizes of tab and slot, and the distance of two of either, may be off: then they go together.
SHARE = FIT / 4
SHEET_SHARE = FIT / 2  # mm by which the thickness of a sheet in slots may be off: it has no distance of its own
_TAB, _SHORT_TAB = 10.0, 7.0  # mm, lengths of tabs
_LONG = 45.0  # mm, from which a foot has four joints in place of three

# Strip of the base that a length of a foot needs: by its start and end, and a margin along it, mm.
Strip = Callable[[float, float, float], shapely.Polygon]


class FootJoint(NamedTuple):
    """Joint of a standing sheet with the base.

    Attributes:
        at: place along the foot in the sheet's own frame, mm.
        width: length of the tab, mm; 0 for a screw.
    """

    at: float
    width: float


def foot_joints(
    ground: FrameGround,
    span: tuple[float, float],
    holes: Sequence[SheetHole],
    strip: Strip,
) -> list[FootJoint]:
    """Joints along a foot, as far apart as may be: two tabs between screws, on a short foot one screw between tabs.

    Args:
        ground: places that the frame goes by.
        span: ends of the foot, mm.
        holes: holes of the sheet.
        strip: function that gives the strip of the base under a length of the foot, with a margin along it.
    """
    sizes, wall = ground.sizes, ground.sizes.wall
    foot, deep, reach = -ground.top, ground.screw_depth, max(sizes.screw.head_diameter / 2, sizes.screw.hole / 2 + wall)
    long = span[1] - span[0] >= _LONG
    tab = _TAB if long else _SHORT_TAB
    free = shapely.union_all(ground.openings)
    seats = shapely.union_all([shapely.Point(hole.u, hole.v).buffer(hole.diameter / 2 + wall, 64) for hole in holes])
    wide = ground.nut_half + wall
    # A mill opens the corners beside a tab along the foot.
    opened = sqrt(2.0) * sizes.corner
    end = max(wall, opened + STEP) if opened else wall

    def takes(at: float, width: float) -> bool:
        half, own = width / 2, width / 2 + end if width else wide
        if at - own < span[0] or at + own > span[1]:
            return False
        if strip(at - half, at + half, wall + FIT if width else reach).intersects(free):
            return False
        return bool(width or not shapely.box(at - wide, foot, at + wide, foot + deep).intersects(seats))

    places = np.arange(span[0], span[1] + 1e-9, STEP).tolist()
    screws, tabs = ([at for at in places if takes(at, width)] for width in (0.0, tab))
    between = tab / 2 + max(max(wide, reach) + 0.5 * wall, wide + opened)
    if not screws or not tabs:
        return []
    if long:
        first, last = screws[0], screws[-1]
        inside = [at for at in tabs if first + between <= at <= last - between]
        if inside and inside[-1] - inside[0] >= tab + opened + end:
            return [
                FootJoint(first, 0.0),
                FootJoint(inside[0], tab),
                FootJoint(inside[-1], tab),
                FootJoint(last, 0.0),
            ]
        return []
    # Beside an opened corner a shoulder as wide as a wall stands on the base, if the screw between leaves it room.
    for shoulder in (opened + wall, end):
        own = tab / 2 + shoulder
        seated = [at for at in tabs if at - own >= span[0] and at + own <= span[1]]
        inside = [at for at in screws if seated and seated[0] + between <= at <= seated[-1] - between]
        if inside:
            first, last = seated[0], seated[-1]
            middle = min(inside, key=lambda at: abs(at - (first + last) / 2))
            return [FootJoint(first, tab), FootJoint(middle, 0.0), FootJoint(last, tab)]
    return []


def tab_corners(ground: FrameGround, joint: FootJoint) -> list[tuple[float, float]]:
    """Corners of a tab in the outline of its sheet, mm."""
    half, foot, low = joint.width / 2, -ground.top, -ground.top - ground.sizes.base
    left, right = joint.at - half, joint.at + half
    return [(left, foot), (left, low), (right, low), (right, foot)]


def nut_slot_corners(ground: FrameGround, at: float) -> list[tuple[float, float]]:
    """Corners of a slot for a screw and a nut across it, open at the foot, mm.

    Args:
        ground: places that the frame goes by.
        at: place along the foot, mm.
    """
    screw, foot = ground.sizes.screw, -ground.top
    half, wide = screw.hole / 2, ground.nut_half
    start = foot + ground.sizes.wall
    end, deep = start + screw.nut_height + NUT_PLAY, foot + ground.screw_length - ground.sizes.base + 2.0
    left = [(at - half, foot), (at - half, start), (at - wide, start), (at - wide, end), (at - half, end)]
    left.append((at - half, deep))
    return left + [(2 * at - u, v) for u, v in reversed(left)]


def screw_room(ground: FrameGround, at: float) -> shapely.Polygon:
    """Area of a standing sheet that a screw from below takes: its thread, or the slot for screw and nut.

    Args:
        ground: places that the frame goes by.
        at: place along the foot, mm.
    """
    if not ground.sizes.tapped:
        return shapely.Polygon(nut_slot_corners(ground, at))
    foot, half = -ground.top, ground.nut_half
    return shapely.box(at - half, foot, at + half, foot + ground.screw_depth - ground.sizes.wall)


def strip_along(ground: FrameGround, low: float, flush: float | None) -> Strip:
    """Function of two places along a foot across the car's axes: the strip of the base that they need.

    Args:
        ground: places that the frame goes by.
        low: height of the sheet's right face, mm.
        flush: height of the face that ends with the base, mm; None for neither.
    """
    thick, wall = ground.site.plate, ground.sizes.wall

    def strip(start: float, end: float, along: float) -> shapely.Polygon:
        below = low if flush == low else low - wall
        above = low + thick if flush == low + thick else low + thick + wall
        if along > wall:  # a screw's head, which the sheet itself is wide enough for
            below, above = low, low + thick
        return shapely.box(start - along, -above, end + along, -below)

    return strip


def slots_along(ground: FrameGround, low: float) -> Callable[[FootJoint], shapely.Polygon]:
    """Function of a joint with a tab that gives its slot in the base, for a sheet across the car's axes.

    Args:
        ground: places that the frame goes by.
        low: height of the sheet's right face, mm.
    """
    half = FIT / 2

    def cut(joint: FootJoint) -> shapely.Polygon:
        reach = joint.width / 2 + half
        return shapely.box(joint.at - reach, -low - ground.site.plate - half, joint.at + reach, -low + half)

    return cut
