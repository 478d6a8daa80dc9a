"""Programs for a mill (G-code) that a cam needs, of outline, holes and drills, and the time that they take."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING

from cadgen.arrays import TURN
from cadgen.cam.cutter import largest_cutter
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.closed import Outline
from cadgen.design.machining import Machining
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.drilling import drill_assumption, drill_feed, drills_of, pecks, point_length, write_drilling
from cadgen.output.files.dxf import edges_note
from cadgen.output.files.gcode import RaisedHub, cutter_path, levels_of, write_gcode
from cadgen.output.files.gcode_reader import RoundHole, read_drilling, read_gcode, read_hole_milling
from cadgen.output.files.hole_milling import hole_minutes, is_milled, write_hole_milling
from cadgen.output.files.publisher import Artifact
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face

if TYPE_CHECKING:
    from cadgen.output.files.exports import CamExport

# Greatest error of the lift due to a program, µm.
LIFT_LIMIT_UM = 1.0


def cam_programs(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """Programs of a cam; the outline that the cutter leaves is judged."""
    for program, outline in programs(cam, folder, cam.step):
        yield program if outline is None else cam.judged(program.name, outline, LIFT_LIMIT_UM, program.facts)


def programs(cam: CamExport, folder: Path, step: float) -> Iterator[tuple[Artifact, Outline | None]]:
    """Write and read back the program of the outline, with the outline that it leaves, and those of the holes.

    Args:
        cam: cam to make.
        folder: folder for the programs.
        step: distance of the points of the outline that is read back, mm.

    Raises:
        CheckError: the cutter does not reach the whole profile.
        DesignError: the tabs have no room.
        FileError: a program, read back, does something else.
    """
    machining, blank, hub = cam.machining, cam.blank, cam.blank.hub
    drilling = machining.drilling
    # Rapid moves pass over a hub on the outer face.
    above = RaisedHub(hub.diameter / 2, hub.length) if hub and hub.side == Face.OUTER else None
    every = drills_of(blank, cam.thickness, drilling) if drilling else ()
    wide = [size for size in every if is_milled(size, machining)]
    drills = [size for size in every if size not in wide]
    holes = folder / f"{cam.stem}_holes.nc"
    tolerance = cam.export.arc_tolerance_um * 1e-3
    centre = cutter_path(cam.curve, machining.cutter_diameter_mm / 2, largest_cutter(cam.curve), tolerance)
    outline = folder / f"{cam.stem}.nc"
    edges = edges_note(blank.edge_break, cam.follower.noun)
    write_gcode(
        outline,
        centre,
        machining,
        cam.thickness,
        name=cam.stem,
        material=cam.material,
        hub=above,
        drilled=[drill.file_name(cam.stem) for drill in drills] + [holes.name] * bool(wide),
        notes=(*cam.notes, *filter(None, [edges])),
        face=cam.seen,
    )
    height = above.height if above else 0.0
    milled = read_gcode(outline, machining, cam.thickness, step, material=cam.material, hub_height=height)
    assumed = assumed_in(machining.assumptions(cam.material))
    facts = Facts(arcs=len(centre.bulges), cutter_diameter_mm=machining.cutter_diameter_mm) | assumed
    if milled.tabs:
        facts |= Facts(
            tabs=[
                Facts(x_mm=tab.place[0], y_mm=tab.place[1], width_mm=tab.width, height_mm=tab.height)
                for tab in milled.tabs
            ]
        )
    yield Artifact(outline.name, facts), milled.outline
    if wide:
        write_hole_milling(holes, wide, machining, name=cam.stem, material=cam.material, face=cam.seen)
        expected = [RoundHole(hole.place, size.diameter, hole.top, hole.bottom) for size in wide for hole in size.holes]
        off, wrong = read_hole_milling(holes, machining, expected, material=cam.material, hub=hub)
        said = Facts(
            cutter_diameter_mm=machining.cutter_diameter_mm,
            holes=len(expected),
            place_error_um=off * 1e3,
            diameter_error_um=wrong * 1e3,
        )
        yield Artifact(holes.name, said | assumed), None
    for drill in drills:
        assert drilling is not None
        path = folder / drill.file_name(cam.stem)
        write_drilling(path, drill, machining, drilling, name=cam.stem, material=cam.material, face=cam.seen)
        off = read_drilling(
            path,
            machining,
            drilling,
            diameter=drill.diameter,
            bore=every[0].diameter,
            holes=blank.holes(),
            thickness=cam.thickness,
            hub=hub,
        )
        facts = Facts(drill_diameter_mm=drill.diameter, holes=len(drill.holes), place_error_um=off * 1e3)
        assumed = assumed_in(drill_assumption(drill.diameter, drilling, cam.material))
        yield Artifact(path.name, facts | assumed), None


def assumed_in(sentence: Message | None) -> Facts:
    """Assumption of a program on the material, for its entry in the manifest; nothing where the design states it.

    Args:
        sentence: assumption, in words.
    """
    return Facts() if sentence is None else Facts(assumed=sentence)


def milling_minutes(length: float, machining: Machining, thickness: float, material: DiscMaterial | None) -> float:
    """Time at the feeds of the program that mills an outline, min.

    Rapid moves and changes of tool take what the machine takes, which no program says; they are apart.

    The cutter's centre goes round on the parallel at its radius r, which is longer than the outline by 2 pi r
    (Steiner), with a quarter of a circle before and after.

    Args:
        length: of the outline, mm.
        machining: cutter, feeds, passes, tabs.
        thickness: of the disc, mm.
        material: of the disc, for the feed; None if none is given.
    """
    tabs, levels = machining.tabs, levels_of(machining, thickness)
    round_length = length + TURN * machining.cutter_diameter_mm / 2 + pi * machining.lead_radius_mm
    plunged = len(levels) * machining.approach_mm - levels[-1]
    cut = len(levels) * round_length
    if tabs is not None:
        top = tabs.height_mm - thickness
        below = [level for level in levels if level < top]
        # Over each tab in a round, and down to it in the slot when it is taken off.
        plunged += tabs.count * sum(2 * (top - level) + machining.approach_mm - level for level in below)
        apart = tabs.width_mm + machining.cutter_diameter_mm + 2 * machining.lead_radius_mm
        cut += tabs.count * len(below) * apart
    return cut / machining.feed(material) + plunged / machining.plunge_feed_mm_per_min


def drilling_minutes(blank: Blank, machining: Machining, thickness: float, material: DiscMaterial | None) -> float:
    """Time at the feeds of the programs that make a disc's holes, min; 0 without [machining.drilling].

    Args:
        blank: bore, hub, holes and mark.
        machining: approach, break through, drilling.
        thickness: of the disc, mm.
        material: of the disc, for the speed; None if none is given.
    """
    drilling = machining.drilling
    if drilling is None:
        return 0.0
    minutes = 0.0
    for drill in drills_of(blank, thickness, drilling):
        if is_milled(drill, machining):
            minutes += sum(hole_minutes(hole, drill.diameter, machining, material) for hole in drill.holes)
            continue
        below = point_length(drill.diameter, drilling) + machining.break_through_mm
        peck = drilling.peck_mm or drill.diameter
        feed = drill_feed(drill.diameter, drilling, material)[1]
        for hole in drill.holes:
            floors = pecks(hole.top, hole.bottom - below, peck)
            # Each peck begins above the floor of the one before, to which the drill comes back at rapid speed.
            minutes += (hole.top - floors[-1] + len(floors) * machining.approach_mm) / feed
    return minutes
