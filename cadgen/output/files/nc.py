"""Programs for a mill (G-code) that a cam needs: the outline, and one for each drill; and the time that they take."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.arrays import TURN
from cadgen.cam.cutter import CutterLimit, largest_cutter
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.design.machining import Machining
from cadgen.output.files.drilling import drill_feed, drills_of, pecks, point_length, write_drilling
from cadgen.output.files.dxf import edges_note
from cadgen.output.files.gcode import RaisedHub, cutter_path, levels_of, write_gcode
from cadgen.output.files.gcode_reader import read_drilling, read_gcode
from cadgen.output.files.publisher import Artifact
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face

if TYPE_CHECKING:
    from cadgen.output.files.exports import CamExport

# Greatest error of the lift due to a program, µm.
LIFT_LIMIT_UM = 1.0


def cam_programs(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """Programs of a cam; the outline that the cutter leaves is judged."""
    edges = edges_note(cam.blank.edge_break, cam.follower.noun)
    disc = Disc(
        name=cam.stem,
        curve=cam.curve,
        limit=largest_cutter(cam.curve),
        blank=cam.blank,
        thickness=cam.thickness,
        material=cam.material,
        notes=(*cam.notes, *([edges] if edges else [])),
    )
    for program, outline in programs(disc, cam.machining, folder, cam.export.arc_tolerance_um * 1e-3, cam.step):
        yield program if outline is None else cam.judged(program.name, outline, LIFT_LIMIT_UM, program.facts)


@dataclass(frozen=True, kw_only=True, eq=False)
class Disc:
    """A disc that is milled.

    Attributes:
        name: stem of the programs' names.
        curve: profile, counterclockwise, mm.
        limit: largest cutter for the profile.
        blank: bore, hub, holes and mark.
        thickness: between its faces, mm.
        material: its material; None if none is given.
        notes: comments for the shop on the outline.
    """

    name: str
    curve: ClosedCurve
    limit: CutterLimit
    blank: Blank
    thickness: float
    material: DiscMaterial | None
    notes: Sequence[str]

    @property
    def above(self) -> RaisedHub | None:
        """Hub on the outer face, over which rapid moves pass."""
        hub = self.blank.hub
        return RaisedHub(hub.diameter / 2, hub.length) if hub and hub.side == Face.OUTER else None


def programs(
    disc: Disc, machining: Machining, folder: Path, arc_tolerance: float, step: float
) -> Iterator[tuple[Artifact, Outline | None]]:
    """Write and read back the program of the outline, with the outline that it leaves, and those of the drills.

    Args:
        disc: disc to make.
        machining: cutter, speeds, tabs, drills.
        folder: folder for the programs.
        arc_tolerance: greatest distance of the arcs from the exact path of the cutter, mm.
        step: distance of the points of the outline that is read back, mm.

    Raises:
        CheckError: the cutter does not reach the whole profile.
        DesignError: the tabs have no room.
        FileError: a program, read back, does something else.
    """
    drilling, above = machining.drilling, disc.above
    drills = drills_of(disc.blank, disc.thickness, drilling) if drilling else ()
    centre = cutter_path(disc.curve, machining.cutter_diameter_mm / 2, disc.limit, arc_tolerance)
    outline = folder / f"{disc.name}.nc"
    write_gcode(
        outline,
        centre,
        machining,
        disc.thickness,
        name=disc.name,
        material=disc.material,
        hub=above,
        drilled=[drill.file_name(disc.name) for drill in drills],
        notes=disc.notes,
    )
    height = above.height if above else 0.0
    milled = read_gcode(outline, machining, disc.thickness, step, material=disc.material, hub_height=height)
    facts: dict[str, Any] = {"arcs": len(centre.bulges), "cutter_diameter_mm": machining.cutter_diameter_mm}
    if milled.tabs:
        facts["tabs"] = [
            {"x_mm": tab.place[0], "y_mm": tab.place[1], "width_mm": tab.width, "height_mm": tab.height}
            for tab in milled.tabs
        ]
    yield Artifact(outline.name, facts), milled.outline
    for drill in drills:
        assert drilling is not None
        path = folder / drill.file_name(disc.name)
        write_drilling(path, drill, machining, drilling, name=disc.name, material=disc.material)
        off = read_drilling(
            path,
            machining,
            drilling,
            diameter=drill.diameter,
            bore=drills[0].diameter,
            holes=disc.blank.holes(),
            thickness=disc.thickness,
            hub=disc.blank.hub,
        )
        facts = {"drill_diameter_mm": drill.diameter, "holes": len(drill.holes), "place_error_um": off * 1e3}
        yield Artifact(path.name, facts), None


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
    """Time at the feeds of the programs that drill a disc, min; 0 without [machining.drilling].

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
        below = point_length(drill.diameter, drilling) + machining.break_through_mm
        peck = drilling.peck_mm or drill.diameter
        feed = drill_feed(drill.diameter, drilling, material)[1]
        for hole in drill.holes:
            floors = pecks(hole.top, hole.bottom - below, peck)
            # Each peck begins above the floor of the one before, to which the drill comes back at rapid speed.
            minutes += (hole.top - floors[-1] + len(floors) * machining.approach_mm) / feed
    return minutes
