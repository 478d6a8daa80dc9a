"""Gaps of each part of a car to the parts nearest to it, by the bodies of the checks of its layout and its frame."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np

from cadgen.car.assembly.bodies import SolidCylinder, gap
from cadgen.car.assembly.panels import STANDING, cylinder_box, least_gap, parallel_gap, pieces
from cadgen.car.assembly.site import STEERING_STEPS, shaft_bodies
from cadgen.design import gear_model
from cadgen.gears.layout import gears_and_hubs
from cadgen.gears.train import thinned
from cadgen.jobs.car_assembly import CarAssembly
from cadgen.jobs.car_frame import frame_in

MOST = 3  # of the nearest parts of each


class PartGap(NamedTuple):
    """Gap of a part to another.

    Attributes:
        size: gap, mm; that of rod and front wheel is the least over all places of the fork.
        other: code of the other part.
    """

    size: float
    other: str


class _Round(NamedTuple):
    """Round body of a part; `group` is the shaft that it is on, 0 for the fork; `touches` a part that it rides on."""

    code: str
    group: int
    stage: int | None
    body: SolidCylinder
    touches: str = ""


def part_gaps(assembly: CarAssembly) -> Mapping[str, tuple[PartGap, ...]]:
    """Gaps of each part to the nearest others, the least first; parts on one shaft, and gears in mesh, are left out.

    Args:
        assembly: car put together.
    """
    found: dict[str, dict[str, float]] = {}

    def note(one: str, other: str, size: float) -> None:
        for code, beside in ((one, other), (other, one)):
            known = found.setdefault(code, {})
            known[beside] = min(size, known.get(beside, np.inf))

    on_shafts = list(_on_shafts(assembly))
    for one, other in combinations(on_shafts, 2):
        if one.group != other.group and (one.stage is None or one.stage != other.stage):
            note(one.code, other.code, gap(one.body, other.body))
    of_fork = list(_of_fork(assembly))
    for moved in of_fork:
        for fixed in on_shafts:
            if fixed.code != moved.touches:
                note(moved.code, fixed.code, gap(moved.body, fixed.body))
    for panel, moved, size in _to_panels(assembly, [*on_shafts, *of_fork]):
        note(panel, moved.code, size)
    return {
        code: tuple(sorted(PartGap(size, other) for other, size in beside.items())[:MOST])
        for code, beside in found.items()
    }


def _on_shafts(assembly: CarAssembly) -> Iterator[_Round]:
    layout, train = assembly.layout, assembly.train
    site, found = layout.site, layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    parts = train.layout.on_shafts
    blanks, bores = [part.blank for part in parts], [part.blank.shaft_diameter for part in parts]
    gears = gears_and_hubs(thinned(train.play.train), blanks, gear_model.train_keys(layout.design).clearance_mm)
    named = {"the disc": "cam-disc", "the hub of the disc": "cam-disc"}
    named |= {"the drive wheel": "drive-wheel", "the idle wheel": "idle-wheel"}
    bearings = [part.code for part in assembly.parts if part.code.startswith("bearing")]
    for number, (axis, bodies) in enumerate(
        zip(found.axes, shaft_bodies(site, gears, bores, found.place), strict=True)
    ):
        for place, (disc, of_train) in enumerate(bodies):
            code = named.get(disc.name)
            if place < len(gears[number]):
                own = parts[number].pieces
                # Of gears that are cut apart the upper one follows the lower, and the collar of this comes last.
                code = f"gear-{own[place if place < len(own) else 0].name}".replace("_", "-")
            elif of_train:
                code = f"shaft-{number + 1}"
            elif code is None:
                code = bearings[0] if bearings else "bearings"
            middle, half = (disc.low + disc.high) / 2, (disc.high - disc.low) / 2
            body = SolidCylinder(name=disc.name, centre=(axis.real, axis.imag, middle), radius=disc.radius, half=half)
            yield _Round(code, number + 1, disc.stage, body)


def _to_panels(assembly: CarAssembly, bodies: Sequence[_Round]) -> Iterator[tuple[str, _Round, float]]:
    """Gaps of the frame's sheets to what moves: code of the sheet, body and gap, mm; shafts pass their own seats."""
    if assembly.layout.design.frame is None:
        return
    frame = frame_in(assembly.layout).frame
    for panel in frame.panels:
        borne = {hole.shaft for hole in panel.holes}
        code, standing = panel.code.replace("_", "-"), panel.place.turn is STANDING
        if panel not in frame.sheets:
            code = "printed-frame"
        near: dict[str, list[_Round]] = {}
        for each in bodies:
            if each.group in borne and each.code.startswith(("shaft-", "bearing")):
                continue
            if standing and each.group:
                yield code, each, parallel_gap(panel, each.body)
            else:
                near.setdefault(each.code, []).append(each)
        sheets = [(0, piece, piece.box) for piece in pieces(panel)] if near else []
        for alike in near.values():
            found = least_gap(sheets, [(0, each.body, cylinder_box(each.body)) for each in alike], ())
            if found is not None:
                yield code, alike[0], found.size


def _of_fork(assembly: CarAssembly) -> Iterator[_Round]:
    site, found = assembly.layout.site, assembly.layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    for share in np.linspace(0.0, 1.0, STEERING_STEPS + 1).tolist():
        named = (("rod", "cam-disc"), ("front-wheel", ""))
        for (code, touches), body in zip(named, site.fork_bodies(share, found.height), strict=False):
            yield _Round(code, 0, None, body, touches)
