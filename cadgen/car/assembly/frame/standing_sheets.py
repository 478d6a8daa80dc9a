"""Sheets that stand on the base: bearing plates, and brackets at the idle wheel and the micrometer."""

from collections.abc import Callable, Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
import shapely

from cadgen.car.assembly.frame.foot_joints import (
    FIT,
    FootJoint,
    Strip,
    foot_joints,
    nut_slot_corners,
    screw_room,
    slots_along,
    strip_along,
    tab_corners,
)
from cadgen.car.assembly.frame.frame_ground import FrameGround
from cadgen.car.assembly.frame.frame_sizes import ROUNDING
from cadgen.car.assembly.panels import (
    ACROSS,
    STANDING,
    THREAD_END,
    EdgeHole,
    Feature,
    Panel,
    PartPlace,
    SheetHole,
    rounded_corners,
)
from cadgen.messages import Message

BEFORE = 6.0  # mm between platform and micrometer bracket
_HALF_FOOT = 18.0  # mm, half of the foot of a bracket
_BEYOND = 12.0  # mm of a bearing plate's foot beyond the outermost axes


class StandingSheet(NamedTuple):
    """Sheet that stands on the base, with what it needs there.

    Attributes:
        panel: sheet.
        found: joints that find room.
        wanted: joints that there should be.
        slots: slots for its tabs, in the base's own frame.
        screws: places x and z of its screws from below, mm.
    """

    panel: Panel
    found: int
    wanted: int
    slots: tuple[shapely.Polygon, ...]
    screws: tuple[tuple[float, float], ...]

    @classmethod
    def of(
        cls,
        panel: Panel,
        joints: Sequence[FootJoint],
        wanted: int,
        below: Callable[[float], tuple[float, float]],
        cut: Callable[[FootJoint], shapely.Polygon],
    ) -> "StandingSheet":
        """Sheet with slots and screws of its joints.

        Args:
            panel: sheet.
            joints: joints that find room.
            wanted: joints that there should be.
            below: function of a place along the foot that gives x and z of the screw there.
            cut: function of a joint with a tab that gives its slot.
        """
        slots = tuple(cut(joint) for joint in joints if joint.width)
        screws = tuple(below(joint.at) for joint in joints if not joint.width)
        return cls(panel, len(joints), wanted, slots, screws)


def bearing_plate(ground: FrameGround, code: str, name: str, low: float, platform: Panel) -> StandingSheet:
    """Bearing plate: seats of the shafts, and a foot with four joints.

    Args:
        ground: places that the frame goes by.
        code: code of the sheet.
        name: name for people.
        low: height of its right face, mm.
        platform: platform of the fork, up to which the foot may reach.
    """
    site, thick = ground.site, ground.site.plate
    holes = []
    for number, (axis, diameter, ends_here) in enumerate(
        zip(ground.found.axes, site.bearings, site.ending, strict=True), 1
    ):
        if not diameter or ends_here:
            continue
        hole = SheetHole(
            Message("seat of shaft {shaft}", shaft=number),
            -axis.real,
            -axis.imag,
            diameter,
            ground.sizes.seat,
            number,
        )
        if number == 1 and abs(low + thick / 2 - ground.open_plate) < ROUNDING:
            free = Message("passage of the rear axle")
            hole = hole._replace(name=free, diameter=ground.bores[0] + 2 * site.clearance, fit="")
        holes.append(hole)
    ends = [-axis.real for axis in ground.found.axes]
    span = (min(ends) - _BEYOND, max(ends) + _BEYOND)
    # Ahead, which is to the left, the foot may be as long as the platform leaves room.
    ahead = float(platform.outline.vertices[:, 0].max()) + ground.sizes.travel / 2 + site.clearance
    outer = max(ground.low) == low if ground.found.place.towards < 0 else min(ground.low) == low
    flush = (low + thick if ground.found.place.towards < 0 else low) if outer else None
    joints: list[FootJoint] = []
    printed, strip = ground.sizes.bed is not None, strip_along(ground, low, flush)
    while True:
        joints = [] if printed else foot_joints(ground, span, holes, strip)
        stands = stands_at_its_ends(ground, span, strip) if printed else len(joints) == 4
        if stands or (span[0] <= ahead and span[1] >= max(ends) + 40):
            break
        span = (max(span[0] - 5.0, min(ahead, span[0])), span[1] if span[0] > ahead else span[1] + 5.0)
    panel = _standing(ground, code, name, holes, span, joints, PartPlace(STANDING, np.array([0.0, 0.0, low])))
    wanted = 0 if printed else 4
    return StandingSheet.of(panel, joints, wanted, lambda at: (-at, low + thick / 2), slots_along(ground, low))


def idle_bracket(ground: FrameGround) -> StandingSheet:
    """Bracket beside the idle wheel, with the second seat of the rear axle."""
    site, thick = ground.site, ground.site.plate
    inwards = 1.0 if site.idle_wheel < site.fork else -1.0
    face = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance)
    low = face if inwards > 0 else face - thick
    middle = -ground.axle.real
    seat = ground.site.bearings[0] if not ground.site.ending[0] else 0.0
    name, size = Message("seat of shaft {shaft}", shaft=1), seat or ground.bores[0]
    holes = [SheetHole(name, middle, -ground.axle.imag, size, ground.sizes.seat, 1)]
    span = (middle - _HALF_FOOT, middle + _HALF_FOOT)
    printed = ground.sizes.bed is not None
    joints = [] if printed else foot_joints(ground, span, holes, strip_along(ground, low, face))
    code, name = "bracket_idle", Message("bracket beside the idle wheel")
    if printed:
        code, name = "wall_idle", Message("wall beside the idle wheel")
    place = PartPlace(STANDING, np.array([0.0, 0.0, low]))
    panel = _standing(ground, code, name, holes, span, joints, place)
    wanted = 0 if printed else 3
    return StandingSheet.of(panel, joints, wanted, lambda at: (-at, low + thick / 2), slots_along(ground, low))


def micrometer_bracket(ground: FrameGround, platform: Panel) -> StandingSheet:
    """Bracket of the micrometer head, before the platform."""
    site, sizes, thick = ground.site, ground.sizes, ground.site.plate
    low = -float(platform.outline.vertices[:, 0].min()) + sizes.travel / 2 + BEFORE
    height = -(ground.top - ground.spacer - sizes.base / 2)
    holes = [SheetHole(Message("hole for the micrometer head"), site.fork, height, sizes.stem, sizes.seat)]
    span = (site.fork - _HALF_FOOT, site.fork + _HALF_FOOT)

    def strip(start: float, end: float, along: float) -> shapely.Polygon:
        return shapely.box(-low - thick, -end - along, -low + sizes.wall, -start + along)

    printed = sizes.bed is not None
    joints = [] if printed else foot_joints(ground, span, holes, strip)
    half = FIT / 2

    def cut(joint: FootJoint) -> shapely.Polygon:
        reach = joint.width / 2 + half
        return shapely.box(-low - thick - half, -joint.at - reach, -low + half, -joint.at + reach)

    panel = _standing(
        ground,
        "wall_micrometer" if printed else "bracket_micrometer",
        Message("wall of the micrometer head") if printed else Message("bracket of the micrometer head"),
        holes,
        span,
        joints,
        PartPlace(ACROSS, np.array([low, 0.0, 0.0])),
    )
    return StandingSheet.of(panel, joints, 0 if printed else 3, lambda at: (low + thick / 2, at), cut)


def stands_at_its_ends(ground: FrameGround, span: tuple[float, float], strip: Strip) -> bool:
    """Whether a foot has no opening of the base under its ends.

    Args:
        ground: places that the frame goes by.
        span: ends of the foot, mm.
        strip: function that gives the strip of the base under a length of the foot.
    """
    long, free = 2 * ground.sizes.wall, shapely.union_all(ground.openings)
    ends = (strip(span[0], span[0] + long, 0.0), strip(span[1] - long, span[1], 0.0))
    return not any(end.intersects(free) for end in ends)


def _standing(
    ground: FrameGround,
    code: str,
    name: str,
    holes: Sequence[SheetHole],
    span: tuple[float, float],
    joints: Sequence[FootJoint],
    place: PartPlace,
) -> Panel:
    """Sheet that stands on the base: the hull of its seats' rims and its foot."""
    sizes, foot = ground.sizes, -ground.top
    points = [(span[0], foot), (span[1], foot)]
    for hole in holes:
        reach = hole.diameter / 2 + ground.rim
        nick = reach * (sqrt(2.0) - 1.0)
        points += [
            (hole.u + s * a, hole.v + t * b)
            for a, b in ((reach, nick), (nick, reach))
            for s in (-1, 1)
            for t in (-1, 1)
        ]
    screws = [joint.at for joint in joints if not joint.width]
    # Material beside and behind what a screw takes, however steep the sides.
    wide = ground.nut_half + sizes.wall
    points += [(at + s * wide, foot + ground.screw_depth) for at in screws for s in (-1, 1)]
    hull = np.asarray(shapely.MultiPoint(np.round(points, 2)).convex_hull.exterior.coords)[:-1]
    if not shapely.LinearRing(hull).is_ccw:
        hull = hull[::-1]
    start = int(np.argmin(np.abs(hull - np.round([span[1], foot], 2)).sum(axis=1)))
    upper = np.roll(hull, -start, axis=0)
    # Seats below the foot, as of a base that is set too high, are in the hull, and the check of walls says so.
    upper = upper[[0, *(number for number in range(1, len(upper)) if upper[number][1] > foot + 1e-6), -1]]
    upper[0], upper[-1] = (span[1], foot), (span[0], foot)
    lower: list[tuple[float, float]] = []
    for joint in sorted(joints):
        lower += (
            tab_corners(ground, joint) if joint.width else [] if sizes.tapped else nut_slot_corners(ground, joint.at)
        )
    corners = np.array([*upper, *lower])
    drilled = screws if sizes.tapped else []
    return Panel(
        code=code,
        name=name,
        outline=rounded_corners(corners, sizes.corner, inside=False),
        cuts=(),
        holes=tuple(holes),
        edge_holes=tuple(
            EdgeHole(at, foot, sizes.screw.tap_drill, ground.screw_length - sizes.base + THREAD_END) for at in drilled
        ),
        features=tuple(
            Feature(Message("tab"), joint.at, foot - sizes.base / 2, joint.width, sizes.base, code, (True, False))
            if joint.width
            else Feature(
                Message("slot for screw and nut"),
                joint.at,
                foot + (ground.screw_length - sizes.base + 2.0) / 2,
                0.0,
                0.0,
            )
            for joint in joints
            if joint.width or not sizes.tapped
        ),
        thickness=ground.site.plate,
        place=place,
        rooms=tuple(screw_room(ground, at) for at in screws),
    )
