"""STEP files of a gear train: written, read back and measured, the assembly and each part by itself."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.errors import FileError
from cadgen.gears.layout import TrainLayout
from cadgen.gears.stage import LEAST_OVERLAP, PLAY_LIMIT_UM, cycle
from cadgen.geometry.meshes.made_train import meshes, play_error_um, return_error_um
from cadgen.geometry.meshes.teeth import MeasuredPair, ToothSection
from cadgen.processes import beside

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import AssembledPart
    from cadgen.geometry.solids.kernel import SolidPart
    from cadgen.geometry.solids.step_text import GearContent

# Greatest distance of flanks and roots in a file from the exact curves, µm.
FLANK_LIMIT_UM = 0.001
ROOT_LIMIT_UM = 0.01
# Relative error of a solid's volume against the exact areas times widths.
VOLUME_LIMIT = 1e-6
# Greatest error of a part's place in the assembly: mm, and the sines and cosines of its turning.
PLACE_LIMIT = 1e-9
# Greatest error of a colour's components: the kernel keeps them in single precision.
COLOUR_LIMIT = 1e-6

# Name and facts of a file.
Result = tuple[str, dict[str, Any]]


def step_files(layout: TrainLayout, stem: str, description: str, passed: bool, staging: Path) -> list[Result]:
    """The assembly through the kernel, each part through its own text, which must be that of the assembly's solid.

    The parts are written and read beside the kernel's reading of the assembly, and half of its solids beside the other
    half. With these processes and that of the other formats `cadgen gears carbon_free_car` takes 8.6 s, and 12.1 s by
    one process: 1.4 times as long.

    Args:
        layout: train with its parts at their places.
        stem: start of the names of the files.
        description: one line for the files.
        passed: whether the train keeps every check, so that its play must be the same over a pitch.
        staging: folder for the files.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    from cadgen.geometry.solids.gear_solids import assembly_bytes, read_assembly, train_parts

    assembly = staging / f"{stem}_train.step"
    parts = train_parts(layout, stem, description)
    files = [staging / f"{part.name}.step" for part in parts]
    assembly.write_bytes(assembly_bytes(parts, layout, assembly.stem, description))
    with beside(partial(_part_files, parts, layout, passed, assembly, files)) as texts:
        whole = assembly_facts(layout, assembly.name, read_assembly(assembly), parts)
        in_mesh, *of_parts = texts()
    return [
        (assembly.name, {**whole, **in_mesh}),
        *((file.name, facts) for file, facts in zip(files, of_parts, strict=True)),
    ]


def _part_files(
    parts: Sequence[SolidPart], layout: TrainLayout, passed: bool, assembly: Path, files: Sequence[Path]
) -> list[dict[str, Any]]:
    """Write each part; facts of the assembly and of all parts by their texts, whose solids must be the same."""
    from cadgen.geometry.solids.step import step_bytes
    from cadgen.geometry.solids.step_text import read_gear, solids_in

    for part, file in zip(parts, files, strict=True):
        file.write_bytes(step_bytes(part))
    contents = [read_gear(file, part.gears, part.starts) for file, part in zip(files, layout.parts, strict=True)]
    in_assembly = solids_in(assembly.read_text(encoding="ascii"))
    for file, content, solid in zip(files, contents, in_assembly, strict=True):
        require(content.solid == solid, file.name, "is not the solid of the assembly")
    in_mesh = play_facts(layout, passed, assembly.name, [content.sections for content in contents])
    return [in_mesh, *(tooth_errors(file.name, content) for file, content in zip(files, contents, strict=True))]


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
            require(error * 1e3 <= limit, name, f"has {curve}s {error * 1e3:.2g} µm off")
    return facts


def assembly_facts(
    layout: TrainLayout, file: str, read: Sequence[AssembledPart], parts: Sequence[SolidPart]
) -> dict[str, Any]:
    """Require of every part read back that it is valid, with its name, colour, place and exact volume."""
    require(len(read) == len(parts), file, "has lost a part")
    worst = 0.0
    for part, placed, wanted in zip(read, layout.parts, parts, strict=True):
        name = wanted.name
        require(part.valid and part.bodies == 1, file, f"has no valid solid for {name}")
        require(part.name == name, file, f"has lost the name of {name}")
        coloured = part.colour is not None and np.allclose(part.colour, wanted.colour, rtol=0, atol=COLOUR_LIMIT)
        require(coloured, file, f"has lost the colour of {name}")
        off = float(np.abs(part.transform - placed.transform).max())
        require(off <= PLACE_LIMIT, file, f"has {name} {off:.2g} mm off its place")
        worst = max(worst, abs(part.volume / placed.volume - 1))
    require(worst <= VOLUME_LIMIT, file, f"misses the exact volume by {worst:.1e}")
    return {"bodies": len(read), "volume_error_relative": worst}


def play_facts(
    layout: TrainLayout, passed: bool, name: str, sections: Sequence[tuple[ToothSection, ...]]
) -> dict[str, Any]:
    """Play of every stage, and return error of the train, measured on the sections in the files.

    Over a pitch the sections do not overlap just within the computed play, and do just past it. Teeth that jam, do
    not hold each other, or at times are not in mesh, have no play to measure; nor have stages without teeth.
    """
    cut = layout.train.stages
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
    require(worst <= PLAY_LIMIT_UM, name, f"has a play {worst:.2g} µm off the computed one")
    for number, (stage, found) in enumerate(zip(cut, measured, strict=True), 1):
        if not stage.toothed:
            continue
        within, past = cycle(found, stage.free_angle(), found.driver.teeth, stage.driven_pitch_radius)
        held = within <= LEAST_OVERLAP <= past
        require(held or not passed, name, f"has teeth in stage {number} whose play is not the same over a pitch")
    return {
        "play_um": [
            None if error is None else stage.free_angle() * stage.driven_pitch_radius * 1e3 + error
            for stage, error in zip(cut, errors, strict=True)
        ],
        "play_error_um": errors,
        "return_error_error_um": total,
    }


def require(holds: bool, name: str, fault: str) -> None:
    """Require something of a file that was read back.

    Args:
        holds: whether it is so.
        name: name of the file.
        fault: what is wrong otherwise, after the file's name.

    Raises:
        FileError: it is not so.
    """
    if not holds:
        raise FileError(f"{name}, read back, {fault}: report this design")
