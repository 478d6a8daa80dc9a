"""STEP files of cams, gears and trains, read back by the kernel and by their own text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cadgen.errors import DesignError, FileError
from cadgen.figures import Facts
from cadgen.gears.layout import TrainLayout
from cadgen.gears.stage import LEAST_OVERLAP, PLAY_LIMIT_UM, cycle
from cadgen.geometry.meshes.made_train import meshes, play_error_um, return_error_um
from cadgen.geometry.meshes.teeth import MeasuredMesh, ToothSection, sections_in_mesh
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, require
from cadgen.processes import in_second_process

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import AssembledPart
    from cadgen.geometry.solids.kernel import SolidPart
    from cadgen.geometry.solids.step import PartContent
    from cadgen.geometry.solids.step_text import GearContent
    from cadgen.output.files.exports import CamExport, GearExport, GrooveExport, RackExport, TrainExport

# Greatest error of the lift due to a file, µm.
LIFT_LIMIT_UM = 0.5
# Greatest distance of flanks and roots in a file from the exact curves, µm.
FLANK_LIMIT_UM = 0.001
ROOT_LIMIT_UM = 0.01
# Greatest difference of a helical flank's distance from the exact one between two heights, µm.
LEAD_LIMIT_UM = 0.01
# Relative error of a solid's volume against the exact areas times widths.
VOLUME_LIMIT = 1e-6
# Greatest error of a part's place in the assembly: mm, and the sines and cosines of its turning.
PLACE_LIMIT = 1e-9
# Greatest error of a colour's components: the kernel keeps them in single precision.
COLOUR_LIMIT = 1e-6
# Greatest number of teeth of a train: the kernel writes and reads each tooth twice, in some 0.05 s of processor time.
MOST_TEETH = 1200


def cam_step(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """STEP file of a cam, which must be one valid solid with its name and the exact volume."""
    from cadgen.geometry.solids.step import read_step, step_bytes

    name = f"{cam.stem}.step"
    (folder / name).write_bytes(step_bytes(cam.part))
    content = read_step(folder / name, cam.step, cam.land)
    yield cam.judged(name, content.rim, LIFT_LIMIT_UM, whole_part(name, content, cam))


def whole_part(name: str, content: PartContent, cam: CamExport | GrooveExport) -> Facts:
    """Facts on a part read back, which must be one valid solid with its name and the exact volume.

    Args:
        name: name of the file.
        content: part that was read.
        cam: cam that was written.

    Raises:
        FileError: it is something else.
    """
    whole = content.valid and content.bodies == 1
    named = (content.name, content.description) == (cam.stem, cam.description)
    require(whole and named, name, Message("is not one valid solid with its name"))
    error = abs(content.volume / cam.volume - 1)
    require(error <= VOLUME_LIMIT, name, Message("misses the exact volume by {error:.1e}", error=error))
    return Facts(volume_mm3=content.volume, volume_error_relative=error)


def gear_step(gear: GearExport, folder: Path) -> list[Artifact]:
    """STEP file of a gear, which must be one valid solid with name and exact volume; its text has the exact teeth."""
    from cadgen.geometry.solids.step_text import read_gear

    file = folder / f"{gear.name}.step"
    whole = one_solid(file, gear.solid(), gear.part.volume)
    teeth = tooth_artifact(file.name, read_gear(file, gear.part.gears, gear.part.starts))
    return [replace(teeth, facts=teeth.facts | whole)]


def rack_step(rack: RackExport, folder: Path) -> list[Artifact]:
    """STEP file of a rack, which must be one valid solid with name and exact volume."""
    file = folder / f"{rack.name}.step"
    whole = one_solid(file, rack.solid(), rack.form.area * rack.form.width)
    return [Artifact(file.name, whole, (Message("one valid solid of the exact volume"),))]


def one_solid(file: Path, solid: SolidPart, exact: float) -> Facts:
    """Write a solid, and require of it read back that it is one, valid, with its name and the exact volume.

    Args:
        file: file to write.
        solid: solid with its name.
        exact: exact volume, mm³.

    Raises:
        FileError: it is something else.
    """
    from cadgen.geometry.solids.step import read_part, step_bytes

    file.write_bytes(step_bytes(solid))
    again = read_part(file)
    named = (again.name, again.description) == (solid.name, solid.description)
    if not (again.valid and again.bodies == 1 and named):
        raise FileError(
            "{file}, read back, is not one valid solid with its name: report this part",
            file=file.name,
        )
    error = abs(again.volume / exact - 1)
    if not error <= VOLUME_LIMIT:
        raise FileError(
            "{file}, read back, misses the exact volume by {error:.1e}: report this part", file=file.name, error=error
        )
    return Facts(volume_mm3=again.volume, volume_error_relative=error)


def require_few_teeth(train: TrainExport, others: Iterable[str]) -> None:
    """Refuse a train with more teeth than STEP files take.

    The parts are written and read beside the kernel's reading of the assembly, and half of its solids beside the other
    half. With these processes and that of the other formats `cadgen gears carbon_free_car` takes 8.6 s, and 12.1 s by
    one process: 1.4 times as long.

    Args:
        train: train that is to be written.
        others: codes of the formats that it can be written in all the same.

    Raises:
        DesignError: the gears have too many teeth.
    """
    teeth = sum(gear.outline.repeats for part in train.layout.parts for gear in part.gears)
    if teeth > MOST_TEETH:
        raise DesignError(
            "the gears of train.stages have {teeth} teeth together, too many for STEP, which takes at most {most}: "
            "give them fewer teeth, or write the formats {others}",
            teeth=teeth,
            most=MOST_TEETH,
            others=",".join(others),
        )


def train_step(train: TrainExport, folder: Path) -> list[Artifact]:
    """STEP files of a train: the assembly through the kernel, each part through its own text.

    The text of a part must be that of the assembly's solid.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    from cadgen.geometry.solids.gear_solids import assembly_bytes, read_assembly, train_parts

    layout, assembly = train.layout, folder / f"{train.stem}_train.step"
    parts = train_parts(layout, train.stem, train.description)
    files = [folder / f"{part.name}.step" for part in parts]
    assembly.write_bytes(assembly_bytes(parts, layout, assembly.stem, train.description))
    with in_second_process(partial(_part_files, parts, layout, train.passed, assembly, files)) as texts:
        whole = assembly_facts(layout, assembly.name, read_assembly(assembly), parts)
        in_mesh, of_parts = texts()
    off = [abs(error) for error in in_mesh.errors if error is not None]
    reading = Message("no play to measure: see the checks")
    if off:
        reading = Message("play {off:.3f} µm from the computed", off=max(off))
    return [Artifact(assembly.name, whole | in_mesh.entry(), (reading,)), *of_parts]


def _part_files(
    parts: Sequence[SolidPart], layout: TrainLayout, passed: bool, assembly: Path, files: Sequence[Path]
) -> tuple[MeasuredPlay, list[Artifact]]:
    """Write each part; play in the assembly and the parts' files by their texts, whose solids must be the same."""
    from cadgen.geometry.solids.step import step_bytes
    from cadgen.geometry.solids.step_text import read_gear, solids_in

    for part, file in zip(parts, files, strict=True):
        file.write_bytes(step_bytes(part))
    contents = [read_gear(file, part.gears, part.starts) for file, part in zip(files, layout.parts, strict=True)]
    in_assembly = solids_in(assembly.read_text(encoding="ascii"))
    for file, content, solid in zip(files, contents, in_assembly, strict=True):
        require(content.solid == solid, file.name, Message("is not the solid of the assembly"))
    play = measured_play(layout, passed, assembly.name, [content.slices for content in contents])
    return play, [tooth_artifact(file.name, content) for file, content in zip(files, contents, strict=True)]


def tooth_artifact(name: str, content: GearContent) -> Artifact:
    """File with the greatest distances of its flanks, roots and rims from the exact curves.

    Raises:
        FileError: a distance is beyond its limit.
    """
    off: dict[str, float] = {}
    for curve, error, limit in (
        ("flank", content.flank_error, FLANK_LIMIT_UM),
        ("root", content.root_error, ROOT_LIMIT_UM),
        ("rim", content.rim_error, FLANK_LIMIT_UM),
        ("lead", content.lead_error, LEAD_LIMIT_UM),
    ):
        if error is not None:
            off[curve] = error * 1e3
            fault = Message("has {curve}s {error:.2g} µm off", curve=curve, error=off[curve])
            require(off[curve] <= limit, name, fault)
    words = "flank off {flank:.5f}, root {root:.4f} µm" if "flank" in off else "rim off {rim:.5f} µm"
    reading = Message(words, **off) if off else ""
    return Artifact(name, Facts(**{f"{curve}_error_um": error for curve, error in off.items()}), (reading,))


def assembly_facts(layout: TrainLayout, file: str, read: Sequence[AssembledPart], parts: Sequence[SolidPart]) -> Facts:
    """Require of every part read back that it is valid, with its name, colour, place and exact volume."""
    require(len(read) == len(parts), file, Message("has lost a part"))
    worst = 0.0
    for part, placed, wanted in zip(read, layout.parts, parts, strict=True):
        name = wanted.name
        require(part.valid and part.bodies == 1, file, Message("has no valid solid for {part}", part=name))
        require(part.name == name, file, Message("has lost the name of {part}", part=name))
        coloured = part.colour is not None and np.allclose(part.colour, wanted.colour, rtol=0, atol=COLOUR_LIMIT)
        require(coloured, file, Message("has lost the colour of {part}", part=name))
        off = float(np.abs(part.transform - placed.transform).max())
        require(off <= PLACE_LIMIT, file, Message("has {part} {off:.2g} mm off its place", part=name, off=off))
        worst = max(worst, abs(part.volume / placed.volume - 1))
    require(worst <= VOLUME_LIMIT, file, Message("misses the exact volume by {error:.1e}", error=worst))
    return Facts(bodies=len(read), volume_error_relative=worst)


@dataclass(frozen=True)
class MeasuredPlay:
    """Play measured on the sections in files.

    Attributes:
        plays: play of each stage on the driven wheel's pitch circle, µm; None for a stage without teeth.
        errors: its difference from the computed play, µm.
        total: difference of the train's return error from the computed one, µm at the output; None where a stage has no
            play to measure.
    """

    plays: tuple[float | None, ...] = ()
    errors: tuple[float | None, ...] = ()
    total: float | None = None

    def entry(self) -> Facts:
        """Play and errors for the manifest; null where there is nothing to measure."""
        return Facts(play_um=self.plays or None, play_error_um=self.errors or None, return_error_error_um=self.total)


def measured_play(
    layout: TrainLayout, passed: bool, name: str, slices: Sequence[tuple[tuple[ToothSection, ...], ...]]
) -> MeasuredPlay:
    """Play of every stage, and return error of the train, measured on the sections in the files.

    Over a pitch the sections do not overlap just within the computed play, and do just past it. Helical teeth are
    measured so at their lower end, midway and at their upper end, and of each stage the play that is furthest off
    counts. Teeth that jam, do not hold each other, or at times are not in mesh, have no play to measure; nor have
    stages without teeth.
    """
    cut = layout.train.stages
    toothed = [stage for stage in cut if stage.toothed]
    if not (toothed and meshes(toothed)):
        return MeasuredPlay()
    errors: list[float | None] = [0.0 if stage.toothed else None for stage in cut]
    total: float | None = None
    for level in range(max(len(gear) for part in slices for gear in part)):
        measured: list[list[MeasuredMesh]] = []
        for number, stage in enumerate(cut, 1):
            places, pairs = layout.places(number), []
            for mating in stage.matings:
                ends = []
                for wheel in (mating.driver, mating.driven):
                    read = slices[places[wheel]][layout.wheel_in(places[wheel], number)]
                    ends.append(read[level % len(read)])
                driver, driven = ends
                pairs.append(sections_in_mesh(mating.pair, driver, driven))
            measured.append(pairs)
        for place, (stage, found) in enumerate(zip(cut, measured, strict=True)):
            if found:
                off = play_error_um(stage, found)
                errors[place] = max((errors[place] or 0.0, off), key=abs)
        if None not in errors:
            total = max((total or 0.0, return_error_um(cut, measured)), key=abs)
        worst = max((abs(error) for error in (*errors, total) if error is not None), default=0.0)
        require(worst <= PLAY_LIMIT_UM, name, Message("has a play {worst:.2g} µm off the computed one", worst=worst))
        for number, (stage, found) in enumerate(zip(cut, measured, strict=True), 1):
            for mating, pair in zip(stage.matings, found, strict=True):
                inner = mating.pair
                within, past = cycle(pair, inner.free_angle(), pair.driver.teeth, inner.driven_pitch_radius)
                held = within <= LEAST_OVERLAP <= past
                fault = Message("has teeth in stage {number} whose play is not the same over a pitch", number=number)
                require(held or not passed, name, fault)
    plays = tuple(
        None if error is None else stage.free_angle() * stage.driven_pitch_radius * 1e3 + error
        for stage, error in zip(cut, errors, strict=True)
    )
    return MeasuredPlay(plays, tuple(errors), total)
