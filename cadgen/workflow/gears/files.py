"""From a checked gear train to files on disk, each read back and measured before it is published."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.build.gear_model import mesh_chord
from cadgen.errors import FileError
from cadgen.export.folder import publishing
from cadgen.export.manifest import Written, file_facts, versions, write_manifest
from cadgen.gears.layout import TrainPart
from cadgen.meshes.mesh import Mesh
from cadgen.meshes.prisms import body_mesh
from cadgen.meshes.teeth import LEAST_OVERLAP, MeasuredPair, Section
from cadgen.meshes.train_checks import PLAY_LIMIT_UM, cycle, exact_play, meshes, play_error_um, return_error_um
from cadgen.workflow.gears.facts import plan_facts
from cadgen.workflow.gears.plan import GearsPlan, Step

if TYPE_CHECKING:
    from cadgen.solids.gear_text import GearContent
    from cadgen.solids.kernel import Part
    from cadgen.solids.train import AssembledPart

# What flanks and roots in a file may stray from the exact ones, µm.
FLANK_LIMIT_UM = 0.001
ROOT_LIMIT_UM = 0.01
# Relative error of a solid's volume against the exact areas times widths.
VOLUME_LIMIT = 1e-6
# What a part's place in the assembly may be off: mm, and the sines and cosines of its turning.
PLACE_LIMIT = 1e-9
# Of a colour's parts: the kernel keeps them in single precision.
COLOUR_LIMIT = 1e-6
# Steel, g/mm³: the mass is for orientation, and the volume stands beside it.
STEEL = 7.85e-3

FRAME = (
    "mm; the drive's axis is z at x = y = 0, and the first stage's driven gear begins at z = 0; every part's own file "
    "has its axis on z, a tooth on x and its lowest gear at z = 0; in the train it is turned over about x if so "
    "marked, turned by its angle about z and shifted to its axis and height"
)


def write_gears(plan: GearsPlan, out: Path, step: Step = lambda text: None) -> Written:
    """Write, read back, judge and publish every file of a train.

    Args:
        plan: a computed train, normally one whose checks passed.
        out: the folder; it is made if need be. Nothing appears in it unless everything succeeded.
        step: told what is being done.

    Raises:
        FileError: a file cannot be written, or what was read back is not what was meant.
    """
    stem = f"{plan.design.name}_{plan.order}"
    with publishing(out) as staging:
        files: dict[str, dict[str, Any]] = {}
        for label, make in (("STEP", _step_files), ("STL", _stl_files), ("tables", _tables)):
            step(f"writing and reading back {label}")
            for name, facts in make(plan, staging, stem):
                files[name] = {**file_facts(staging / name), **facts}
        entry = {**plan_facts(plan), "frame": FRAME, "versions": versions(), "omitted": {}, "files": files}
        write_manifest(staging, f"{stem}_train", entry)
    return Written(f"{stem}_train", entry)


Result = tuple[str, dict[str, Any]]


def _step_files(plan: GearsPlan, staging: Path, stem: str) -> Iterator[Result]:
    """The assembly through the kernel, each part through its own text, which must be that of the assembly's solid."""
    from cadgen.solids.train import assembly_bytes, read_assembly, train_parts

    name = f"{stem}_train.step"
    description = f"gear train, {plan.order}, design {plan.design.content_hash[:12]}"
    parts = train_parts(plan.layout, stem, description)
    (staging / name).write_bytes(assembly_bytes(parts, plan.layout, f"{stem}_train", description))
    whole = _assembly(plan, name, read_assembly(staging / name), parts)
    contents, results = _part_files(plan, staging, parts, name)
    yield name, {**whole, **_in_mesh(plan, name, [content.sections for content in contents])}
    yield from results


def _part_files(
    plan: GearsPlan, staging: Path, parts: Sequence[Part], assembly: str
) -> tuple[list[GearContent], list[Result]]:
    from cadgen.solids.gear_text import read_gear, solids_in
    from cadgen.solids.step import step_bytes

    in_assembly = solids_in((staging / assembly).read_text(encoding="ascii"))
    contents: list[GearContent] = []
    results: list[Result] = []
    for part, placed, solid in zip(parts, plan.layout.parts, in_assembly, strict=True):
        file = staging / f"{part.name}.step"
        file.write_bytes(step_bytes(part))
        content = read_gear(file, placed.gears, placed.starts)
        if content.solid != solid:
            raise FileError(f"{file.name}, read back, is not the solid of the assembly: report this design")
        flank, root = content.flank_error * 1e3, content.root_error * 1e3
        _require(flank <= FLANK_LIMIT_UM, file.name, f"has flanks {flank:.2g} µm off")
        _require(root <= ROOT_LIMIT_UM, file.name, f"has roots {root:.2g} µm off")
        contents.append(content)
        results.append((file.name, {"flank_error_um": flank, "root_error_um": root}))
    return contents, results


def _assembly(plan: GearsPlan, file: str, found: Sequence[AssembledPart], parts: Sequence[Part]) -> dict[str, Any]:
    """Every part valid, with its name and colour, at its place, of the exact volume."""
    _require(len(found) == len(parts), file, "has lost a part")
    worst = 0.0
    for part, placed, wanted in zip(found, plan.layout.parts, parts, strict=True):
        name = wanted.name
        _require(part.valid and part.bodies == 1, file, f"has no valid solid for {name}")
        _require(part.name == name, file, f"has lost the name of {name}")
        coloured = part.colour is not None and np.allclose(part.colour, wanted.colour, rtol=0, atol=COLOUR_LIMIT)
        _require(coloured, file, f"has lost the colour of {name}")
        off = float(np.abs(part.transform - placed.transform).max())
        _require(off <= PLACE_LIMIT, file, f"has {name} {off:.2g} mm off its place")
        worst = max(worst, abs(part.volume / placed.volume - 1))
    _require(worst <= VOLUME_LIMIT, file, f"misses the exact volume by {worst:.1e}")
    return {"bodies": len(found), "volume_error_relative": worst}


def _in_mesh(plan: GearsPlan, name: str, sections: list[tuple[Section, ...]]) -> dict[str, Any]:
    """Play of every stage, and return error of the train, measured on the sections in the files.

    Over a pitch the sections do not overlap just within the computed play, and do just past it. Teeth that jam, do
    not hold each other, or at times are not in mesh, have no play to measure.
    """
    cut = plan.layout.train.stages
    if not meshes(cut):
        return {"play_um": None, "play_error_um": None, "return_error_error_um": None}
    measured = [
        MeasuredPair(before[-1], after[0], pair.centre_distance)
        for before, after, pair in zip(sections, sections[1:], cut, strict=False)
    ]
    errors = [play_error_um(pair, found) for pair, found in zip(cut, measured, strict=True)]
    total = return_error_um(cut, measured)
    worst = max(map(abs, [*errors, total]))
    _require(worst <= PLAY_LIMIT_UM, name, f"has a play {worst:.2g} µm off the computed one")
    for number, (pair, found) in enumerate(zip(cut, measured, strict=True), 1):
        within, past = cycle(pair, found)
        held = within <= LEAST_OVERLAP <= past
        _require(held or not plan.passed, name, f"has teeth in stage {number} whose play is not the same over a pitch")
    return {
        "play_um": [
            exact_play(pair) * pair.driven_pitch_radius * 1e3 + error for pair, error in zip(cut, errors, strict=True)
        ],
        "play_error_um": errors,
        "return_error_error_um": total,
    }


def _stl_files(plan: GearsPlan, staging: Path, stem: str) -> Iterator[Result]:
    from cadgen.export.mesh import read_stl, stl_bytes

    for part in plan.layout.parts:
        chord = mesh_chord(plan.design, part.gears)
        name = f"{stem}_{part.name}.stl"
        (staging / name).write_bytes(stl_bytes(body_mesh(part.body, chord), f"{stem}_{part.name}"))
        yield name, _stl_facts(name, read_stl(staging / name), part, chord)


def _stl_facts(name: str, again: Mesh, part: TrainPart, chord: float) -> dict[str, Any]:
    """Closed, one body, and no further from the exact volume than the chords and the wall's area allow."""
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


def _tables(plan: GearsPlan, staging: Path, stem: str) -> Iterator[Result]:
    rows = table_of(plan)
    name = f"{stem}_parts.csv"
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: _cell(value) for key, value in row.items()} for row in rows)
    (staging / name).write_text(text.getvalue(), encoding="ascii", newline="\n")
    again = list(csv.DictReader((staging / name).read_text(encoding="ascii").splitlines()))
    same = len(again) == len(rows) and all(
        read[key] == _cell(value) for read, row in zip(again, rows, strict=True) for key, value in row.items()
    )
    _require(same, name, "has other values")
    yield name, {"rows": len(rows)}


def table_of(plan: GearsPlan) -> list[dict[str, Any]]:
    """The table of parts with what the shop measures, one row per gear; volume and mass are the whole part's."""
    rows = []
    for part in plan_facts(plan)["parts"]:
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


def _require(holds: bool, name: str, what: str) -> None:
    if not holds:
        raise FileError(f"{name}, read back, {what}: report this design")
