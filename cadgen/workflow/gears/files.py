"""From a checked gear train to files on disk, each read back and measured before it is published."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from cadgen.aside import Aside
from cadgen.errors import DesignError, FileError
from cadgen.export.folder import publishing
from cadgen.export.formats import TRAIN_FORMATS, Format, chosen_formats, entry_formats, entry_name
from cadgen.export.manifest import Written, file_facts, versions, write_manifest
from cadgen.gears.engaged import LEAST_OVERLAP, PLAY_LIMIT_UM, cycle
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.stage import Wheel
from cadgen.gears.train import TrainPlay
from cadgen.meshes.mesh import Mesh
from cadgen.meshes.prisms import body_mesh
from cadgen.meshes.teeth import MeasuredPair, Section
from cadgen.meshes.train_checks import meshes, play_error_um, return_error_um
from cadgen.progress import Progress, silent
from cadgen.workflow.gears.facts import parts_facts, plan_facts
from cadgen.workflow.gears.plan import GearsPlan

if TYPE_CHECKING:
    from cadgen.solids.gear_text import GearContent
    from cadgen.solids.kernel import Part
    from cadgen.solids.train import AssembledPart

# Greatest distance of flanks and roots in a file from the exact curves, µm.
FLANK_LIMIT_UM = 0.001
ROOT_LIMIT_UM = 0.01
# Relative error of a solid's volume against the exact areas times widths.
VOLUME_LIMIT = 1e-6
# Greatest error of a part's place in the assembly: mm, and the sines and cosines of its turning.
PLACE_LIMIT = 1e-9
# Greatest error of a colour's components: the kernel keeps them in single precision.
COLOUR_LIMIT = 1e-6
# Greatest number of teeth of a train: the kernel writes and reads each tooth twice, in some 0.05 s of processor time.
MOST_STEP_TEETH = 1200
# Steel, g/mm³: the mass is for orientation, and the volume stands beside it.
STEEL = 7.85e-3

FRAME = (
    "mm; the drive's axis is z at x = y = 0, and the first stage's driven gear begins at z = 0; every part's own file "
    "has its axis on z, a tooth on x and its lowest gear at z = 0; in the train it is turned over about x if so "
    "marked, turned by its angle about z and shifted to its axis and height"
)


class PlannedTrain(Protocol):
    """A gear train that has been computed and checked, from a design or from numbers."""

    @property
    def stem(self) -> str:
        """Start of the names of its files."""

    @property
    def description(self) -> str:
        """One line for STEP files."""

    @property
    def layout(self) -> TrainLayout:
        """Parts at their places."""

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""

    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm."""

    @property
    def play(self) -> TrainPlay:
        """Play and return error of the train."""


def write_gears(
    plan: GearsPlan, out: Path, progress: Progress = silent, formats: str | Iterable[str] | None = None
) -> Written:
    """Write the files of a design's train; arguments and errors as of `write_train`."""
    return write_train(plan, plan_facts(plan), out, progress, formats)


def write_train(
    plan: PlannedTrain,
    facts: dict[str, Any],
    out: Path,
    progress: Progress = silent,
    formats: str | Iterable[str] | None = None,
) -> Written:
    """Write, read back, judge and publish the files of a train.

    Args:
        plan: computed train, normally with all checks passed.
        facts: facts on the train, as plain values.
        out: folder for the files; it is made if need be. Nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.
        formats: some of `TRAIN_FORMATS`; all of them if left out.

    Raises:
        DesignError: a format is unknown, or the gears have too many teeth for STEP.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    makers = {ending: (label, partial(make, plan, plan.stem)) for ending, (label, make) in _MAKERS.items()}
    wanted = chosen_formats(formats, TRAIN_FORMATS)
    teeth = sum(gear.outline.repeats for part in plan.layout.parts for gear in part.gears)
    if Format.STEP in wanted and teeth > MOST_STEP_TEETH:
        others = ",".join(ending for ending in TRAIN_FORMATS if ending != Format.STEP)
        raise DesignError(
            f"the gears of train.stages have {teeth} teeth together, too many for STEP, which takes at most "
            f"{MOST_STEP_TEETH}: give them fewer teeth, or write the formats {others}"
        )
    return publish(f"{plan.stem}_train", facts, FRAME, makers, wanted, out, progress)


def publish(
    part: str,
    facts: dict[str, Any],
    frame: str,
    makers: Mapping[Format, tuple[str, Callable[[Path], Iterator[Result]]]],
    wanted: Sequence[Format],
    out: Path,
    progress: Progress,
) -> Written:
    """Make the wanted files of a gear or a train, and publish them with their entry in the manifest.

    Args:
        part: name of the entry of all formats.
        facts: facts on the part, as plain values.
        frame: position of the part in its files, a sentence.
        makers: label and function for each format; the function writes files into a folder, reads them back and yields
            their facts.
        wanted: formats to write, some of those of `makers`.
        out: folder for the files; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    with publishing(out) as staging:
        progress(f"writing and reading back {', '.join(makers[ending][0] for ending in wanted)}")
        # The first is STEP, if that is wanted: the kernel takes far longer than all else.
        with Aside(partial(_made, makers, wanted[1:], staging)) as rest:
            made = [*_made(makers, wanted[:1], staging), *rest.result()]
        files = {name: {**file_facts(staging / name), **of_file} for name, of_file in made}
        entry = {
            **facts,
            **entry_formats(tuple(wanted), tuple(makers)),
            "frame": frame,
            "versions": versions(),
            "omitted": {},
            "files": files,
        }
        entry_of = entry_name(part, tuple(wanted), tuple(makers))
        write_manifest(staging, entry_of, entry)
    return Written(entry_of, entry)


Result = tuple[str, dict[str, Any]]


def _made(
    makers: Mapping[Format, tuple[str, Callable[[Path], Iterator[Result]]]], endings: Sequence[Format], staging: Path
) -> list[Result]:
    return [result for ending in endings for result in makers[ending][1](staging)]


def _step_files(plan: PlannedTrain, stem: str, staging: Path) -> Iterator[Result]:
    """The assembly through the kernel, each part through its own text, which must be that of the assembly's solid."""
    from cadgen.solids.gear_text import solids_in
    from cadgen.solids.train import assembly_bytes, read_assembly, train_parts

    name = f"{stem}_train.step"
    parts = train_parts(plan.layout, stem, plan.description)
    with Aside(partial(_part_files, plan, staging, parts)) as aside:
        (staging / name).write_bytes(assembly_bytes(parts, plan.layout, f"{stem}_train", plan.description))
        whole = _assembly(plan, name, read_assembly(staging / name), parts)
        contents = aside.result()
    in_assembly = solids_in((staging / name).read_text(encoding="ascii"))
    for part, content, solid in zip(parts, contents, in_assembly, strict=True):
        _require(content.solid == solid, f"{part.name}.step", "is not the solid of the assembly")
    yield name, {**whole, **_in_mesh(plan, name, [content.sections for content in contents])}
    for part, content in zip(parts, contents, strict=True):
        yield f"{part.name}.step", tooth_errors(f"{part.name}.step", content)


def _part_files(plan: PlannedTrain, staging: Path, parts: Sequence[Part]) -> list[GearContent]:
    from cadgen.solids.gear_text import read_gear
    from cadgen.solids.step import step_bytes

    contents = []
    for part, placed in zip(parts, plan.layout.parts, strict=True):
        file = staging / f"{part.name}.step"
        file.write_bytes(step_bytes(part))
        contents.append(read_gear(file, placed.gears, placed.starts))
    return contents


def tooth_errors(name: str, content: GearContent) -> dict[str, Any]:
    """Greatest distances of flanks and roots in a file from the exact curves, µm, by key.

    Raises:
        FileError: a distance is beyond its limit.
    """
    facts: dict[str, Any] = {}
    for curve, error, limit in (
        ("flank", content.flank_error, FLANK_LIMIT_UM),
        ("root", content.root_error, ROOT_LIMIT_UM),
        ("rim", content.rim_error, FLANK_LIMIT_UM),
    ):
        if error is not None:
            facts[f"{curve}_error_um"] = error * 1e3
            _require(error * 1e3 <= limit, name, f"has {curve}s {error * 1e3:.2g} µm off")
    return facts


def _assembly(plan: PlannedTrain, file: str, read: Sequence[AssembledPart], parts: Sequence[Part]) -> dict[str, Any]:
    """Require of every part read back that it is valid, with its name, colour, place and exact volume."""
    _require(len(read) == len(parts), file, "has lost a part")
    worst = 0.0
    for part, placed, wanted in zip(read, plan.layout.parts, parts, strict=True):
        name = wanted.name
        _require(part.valid and part.bodies == 1, file, f"has no valid solid for {name}")
        _require(part.name == name, file, f"has lost the name of {name}")
        coloured = part.colour is not None and np.allclose(part.colour, wanted.colour, rtol=0, atol=COLOUR_LIMIT)
        _require(coloured, file, f"has lost the colour of {name}")
        off = float(np.abs(part.transform - placed.transform).max())
        _require(off <= PLACE_LIMIT, file, f"has {name} {off:.2g} mm off its place")
        worst = max(worst, abs(part.volume / placed.volume - 1))
    _require(worst <= VOLUME_LIMIT, file, f"misses the exact volume by {worst:.1e}")
    return {"bodies": len(read), "volume_error_relative": worst}


def _in_mesh(plan: PlannedTrain, name: str, sections: list[tuple[Section, ...]]) -> dict[str, Any]:
    """Play of every stage, and return error of the train, measured on the sections in the files.

    Over a pitch the sections do not overlap just within the computed play, and do just past it. Teeth that jam, do
    not hold each other, or at times are not in mesh, have no play to measure; nor have stages without teeth.
    """
    cut = plan.layout.train.stages
    toothed = [stage for stage in cut if stage.toothed]
    if not (toothed and meshes(toothed)):
        return {"play_um": None, "play_error_um": None, "return_error_error_um": None}
    measured = [
        MeasuredPair(before[-1], after[0], stage.centre_distance)
        for before, after, stage in zip(sections, sections[1:], cut, strict=False)
    ]
    errors = [
        play_error_um(stage, found) if stage.toothed else None for stage, found in zip(cut, measured, strict=True)
    ]
    total = return_error_um(cut, measured) if None not in errors else None
    worst = max((abs(error) for error in (*errors, total) if error is not None), default=0.0)
    _require(worst <= PLAY_LIMIT_UM, name, f"has a play {worst:.2g} µm off the computed one")
    for number, (stage, found) in enumerate(zip(cut, measured, strict=True), 1):
        if not stage.toothed:
            continue
        within, past = cycle(found, stage.free_angle(), found.driver.teeth, stage.driven_pitch_radius)
        held = within <= LEAST_OVERLAP <= past
        _require(held or not plan.passed, name, f"has teeth in stage {number} whose play is not the same over a pitch")
    return {
        "play_um": [
            None if error is None else stage.free_angle() * stage.driven_pitch_radius * 1e3 + error
            for stage, error in zip(cut, errors, strict=True)
        ],
        "play_error_um": errors,
        "return_error_error_um": total,
    }


def _stl_files(plan: PlannedTrain, stem: str, staging: Path) -> Iterator[Result]:
    for part in plan.layout.parts:
        yield write_stl(part, staging, f"{stem}_{part.name}", plan.chord(part.gears))


def write_stl(part: TrainPart, staging: Path, stem: str, chord: float) -> Result:
    """Write and read back the mesh of a part in its own frame; `chord` is its greatest chord error, mm.

    Args:
        part: part of the train.
        staging: folder for the file.
        stem: name of the file without its ending.
        chord: greatest chord error, mm.

    Raises:
        FileError: the file holds something else when it is read back.
    """
    from cadgen.export.mesh import read_stl, stl_bytes

    name = f"{stem}.stl"
    (staging / name).write_bytes(stl_bytes(body_mesh(part.body, chord), stem))
    return name, _stl_facts(name, read_stl(staging / name), part, chord)


def _stl_facts(name: str, again: Mesh, part: TrainPart, chord: float) -> dict[str, Any]:
    """Require of a mesh read back that it is closed, one body, and of the exact volume within chord times wall area."""
    solid = again.solid()
    _require(len(solid.decompose()) == 1, name, "is not one body")
    corners = again.vertices[again.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(across, axis=1) / 2
    walls = float(area[np.abs(across[:, 2]) < area].sum())
    error = abs(solid.volume() - part.volume)
    _require(error <= chord * walls, name, f"misses the exact volume by {error:.3g} mm³")
    return {
        "triangles": len(again.triangles),
        "watertight": True,
        "chord_um": chord * 1e3,
        "volume_error_relative": error / part.volume,
    }


def _tables(plan: PlannedTrain, stem: str, staging: Path) -> Iterator[Result]:
    rows = table_of(plan)
    name = f"{stem}_parts.csv"
    text = io.StringIO(newline="")
    columns = dict.fromkeys(key for row in rows for key in row)
    writer = csv.DictWriter(text, list(columns), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: _cell(value) for key, value in row.items()} for row in rows)
    (staging / name).write_text(text.getvalue(), encoding="ascii", newline="\n")
    again = list(csv.DictReader((staging / name).read_text(encoding="ascii").splitlines()))
    same = len(again) == len(rows) and all(
        read[key] == _cell(value) for read, row in zip(again, rows, strict=True) for key, value in row.items()
    )
    _require(same, name, "has other values")
    yield name, {"rows": len(rows)}


def table_of(plan: PlannedTrain) -> list[dict[str, Any]]:
    """The table of parts with what the shop measures, one row per gear; volume and mass are the whole part's."""
    rows = []
    for part in parts_facts(plan.layout):
        whole = {"part": part["name"], "shaft": part["shaft"]}
        body = {
            "bore_mm": part["bore_mm"],
            "part_volume_mm3": part["volume_mm3"],
            "part_mass_steel_g": part["volume_mm3"] * STEEL,
        }
        rows += [{**whole, **gear, **body} for gear in part["gears"]]
    return rows


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.4f}" if isinstance(value, float) else str(value)


def _require(holds: bool, name: str, fault: str) -> None:
    if not holds:
        raise FileError(f"{name}, read back, {fault}: report this design")


# For each ending of files, a label for the progress and the function that makes the files.
_MAKERS: dict[Format, tuple[str, Callable[[PlannedTrain, str, Path], Iterator[Result]]]] = {
    Format.STEP: ("STEP", _step_files),
    Format.STL: ("STL", _stl_files),
    Format.CSV: ("tables", _tables),
}
