"""Base plate: openings, slots for tabs, holes for screws, and what it carries."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from cadgen.arrays import Array
from cadgen.car.assembly.carried import Carried, CarriedBody, carried_at, places, taken_by
from cadgen.car.assembly.fork_sizes import CLAMP
from cadgen.car.assembly.frame.fork_block import SPACERS_APART
from cadgen.car.assembly.frame.frame_ground import FrameGround
from cadgen.car.assembly.frame.standing_sheets import StandingSheet
from cadgen.car.assembly.panels import (
    ACROSS,
    LYING,
    STANDING,
    Feature,
    Panel,
    PartPlace,
    SheetHole,
    rectangle,
    rounded_corners,
)
from cadgen.messages import Message


class BasePlate(NamedTuple):
    """Base plate with what it carries.

    Attributes:
        panel: sheet.
        pieces: pieces into which openings cut it.
        screws: places x and z of the screws from below, mm.
        carried: weight or motor at its place; None without one, or where it finds no place.
    """

    panel: Panel
    pieces: int
    screws: tuple[tuple[float, float], ...]
    carried: Carried | None


def base_plate(
    ground: FrameGround, platform: Panel, spacers: Sequence[tuple[float, float]], standing: Sequence[StandingSheet]
) -> BasePlate:
    """Base plate under all that stands on it.

    Args:
        ground: places that the frame goes by.
        platform: platform of the fork.
        spacers: places x and z of its spacers, mm.
        standing: sheets that stand on the base.
    """
    site, sizes, thick = ground.site, ground.sizes, ground.site.plate
    sheets = [each.panel for each in standing]
    slots = [(each.panel.code, slot) for each in standing for slot in each.slots]
    screws = [place for each in standing for place in each.screws]
    back = max(float(panel.outline.vertices[:, 0].max()) for panel in sheets if panel.place.turn is STANDING)
    front = float(platform.outline.vertices[:, 0].min())
    across = [
        -z
        for panel in sheets
        if panel.place.turn is STANDING
        for z in (float(panel.place.shift[2]), float(panel.place.shift[2]) + thick)
    ]
    reach = SPACERS_APART / 2 + sizes.screw.hole / 2 + sizes.wall
    across += [-site.fork - reach, -site.fork + reach]
    if sizes.stem:
        (bracket,) = (panel for panel in sheets if panel.place.turn is ACROSS)
        front = -float(bracket.place.shift[0]) - thick
    whole = shapely.box(front, min(across), back + sizes.wall, max(across))
    left = whole.difference(shapely.union_all([*ground.openings, *(slot for _, slot in slots)]))
    parts = sorted(shapely.get_parts(left), key=lambda part: -part.area)
    outer = parts[0].simplify(0.0)
    holes = [SheetHole(Message("screw from below"), -x, -z, sizes.screw.hole) for x, z in screws]
    holes += [SheetHole(Message("screw of a spacer"), -x, -z, sizes.screw.hole) for x, z in spacers]
    carried = None if sizes.carried is None else _carried(ground, outer, screws, sizes.carried)
    if sizes.carried is None:
        holes += _drive_holes(ground, outer, screws)
    elif carried is not None:
        name = Message("rod of the guide") if sizes.carried.fall else Message("motor")
        holes += [SheetHole(name, -x, -z, sizes.screw.hole) for x, z in carried.corners(sizes.drive)]
    cuts = [rounded_corners(_corners(ring), sizes.corner, inside=True) for ring in outer.interiors]
    outline = rounded_corners(_corners(outer.exterior), sizes.corner, inside=False)
    base = Panel(
        code="base",
        name=Message("base plate") if sizes.bed is None else Message("base of the frame"),
        outline=outline,
        cuts=tuple(cuts),
        holes=tuple(holes),
        edge_holes=(),
        features=tuple(_features(ground, slots, whole)),
        thickness=sizes.base,
        place=PartPlace(LYING, np.array([0.0, ground.top + sizes.base, 0.0])),
    )
    return BasePlate(base, len(parts), tuple(screws), carried)


def _features(
    ground: FrameGround, slots: Sequence[tuple[str, shapely.Polygon]], whole: shapely.Polygon
) -> Iterator[Feature]:
    """Slots, each with the code of the sheet in it, and openings of the base."""
    named = [(Message("slot for a tab"), code, area) for code, area in slots]
    named += [(Message("opening"), "", area) for area in ground.openings if area.intersects(whole)]
    for name, code, area in named:
        left, low, right, high = area.intersection(whole).bounds
        before, below, behind, above = area.bounds
        # A slot that is open at an edge of the base is as long or wide as the edge leaves it.
        closed = (right - left == behind - before, high - low == above - below)
        fitted = closed if code else (False, False)
        yield Feature(name, (left + right) / 2, (low + high) / 2, right - left, high - low, code, fitted)


def beside(ground: FrameGround) -> tuple[float, float]:
    """Heights of the faces between which weight or motor stands: of train or fork, and of the idle bracket."""
    site, half = ground.site, ground.site.plate / 2
    inwards = 1.0 if site.idle_wheel < site.fork else -1.0
    bracket = site.idle_wheel + inwards * (site.wheel_width / 2 + 2 * site.clearance + site.plate)
    fork = max(ground.swept[1], SPACERS_APART / 2 + ground.sizes.screw.head_diameter)
    faces = [z + s * half for z in (ground.found.place.near, ground.found.place.far) for s in (-1, 1)]
    faces += [z for part in site.disc for z in (part.low - CLAMP, part.high + CLAMP)]
    faces += [site.fork - fork, site.fork + fork]
    nearest = min(faces, key=lambda z: z * inwards)
    return (bracket, nearest) if inwards > 0 else (nearest, bracket)


def _carried(
    ground: FrameGround, base: shapely.Polygon, screws: list[tuple[float, float]], body: CarriedBody
) -> Carried | None:
    """Weight or motor at its place on the base; None where it finds none."""
    site, sizes = ground.site, ground.sizes
    found = next(
        places(
            body,
            base,
            taken_by(screws, sizes.screw.head_diameter),
            beside(ground),
            ground.axle.real,
            body.reach if body.fall else ground.bores[0] / 2,
            body.holes(sizes.drive),
            sizes.screw.hole / 2 + sizes.wall,
            site.clearance,
        ),
        None,
    )
    if found is None or (body.drum and ground.top - ground.axle.imag < body.reach + site.clearance):
        return None
    return carried_at(
        body,
        found,
        axle=ground.axle,
        floor=ground.found.height,
        base_top=ground.top,
        clearance=site.clearance,
        screw=sizes.screw,
        thickness=sizes.base,
        wall=sizes.wall,
    )


def _drive_holes(ground: FrameGround, base: shapely.Polygon, screws: list[tuple[float, float]]) -> list[SheetHole]:
    """Four holes for motor or weight between the train and the idle wheel, as near to the axle as there is room."""
    site, sizes = ground.site, ground.sizes
    ends = sorted((ground.found.place.far, site.idle_wheel))
    middle = -sum(ends) / 2
    reach = sizes.screw.hole / 2 + sizes.wall
    room = ends[1] - ends[0] - 2 * site.plate - 2 * site.wheel_width
    taken = taken_by(screws, sizes.screw.head_diameter)
    for along, wide in (sizes.drive, sizes.drive[::-1]):
        if wide + 2 * reach > room:
            continue
        for step in np.arange(0.0, site.behind + site.base_radius, 1.0).tolist():
            at = -ground.axle.real - step
            area = shapely.box(
                at - along / 2 - reach, middle - wide / 2 - reach, at + along / 2 + reach, middle + wide / 2 + reach
            )
            if base.covers(area) and not area.intersects(taken):
                name = Message("motor or weight")
                corners = rectangle(at - along / 2, middle - wide / 2, at + along / 2, middle + wide / 2)
                return [SheetHole(name, u, v, sizes.screw.hole) for u, v in corners.tolist()]
    return []


def _corners(ring: shapely.LinearRing) -> Array:
    """Corners of a ring, counterclockwise."""
    points = np.asarray(ring.coords)[:-1]
    return points if shapely.LinearRing(points).is_ccw else points[::-1]
