"""Every program for a mill that a disc needs, written and read back: the outline, and one for each drill."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cadgen.cam.cutter import CutterLimit
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.design.machining import Machining
from cadgen.output.files.drill_reader import read_drilling
from cadgen.output.files.drilling import drills_of, write_drilling
from cadgen.output.files.gcode import cutter_path, write_gcode
from cadgen.output.files.gcode_reader import read_gcode
from cadgen.output.files.gcode_words import Hub
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face


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
    def above(self) -> Hub | None:
        """Hub on the outer face, over which rapid moves pass."""
        hub = self.blank.hub
        return Hub(hub.diameter / 2, hub.length) if hub and hub.side == Face.OUTER else None


@dataclass(frozen=True, eq=False)
class Program:
    """A program that was written and read back.

    Attributes:
        name: name of the file.
        outline: outline of the part that it leaves; None for a program that drills.
        facts: further facts for the manifest.
    """

    name: str
    outline: Outline | None
    facts: dict[str, Any]


def programs(disc: Disc, machining: Machining, folder: Path, arc_tolerance: float, step: float) -> Iterator[Program]:
    """Write and read back the program of the outline and those of the drills.

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
    yield Program(outline.name, milled.outline, facts)
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
        yield Program(path.name, None, facts)
