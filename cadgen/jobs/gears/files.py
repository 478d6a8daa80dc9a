"""From a checked gear train to files on disk, each read back and measured before it is published."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.stage import Wheel
from cadgen.gears.train import TrainPlay
from cadgen.geometry.meshes.mesh import Mesh, body_mesh
from cadgen.jobs.gears.facts import parts_facts, plan_facts
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.jobs.gears.step_files import Result, require, step_files
from cadgen.output.files.folder import publishing
from cadgen.output.files.formats import TRAIN_FORMATS, Format, chosen_formats, entry_formats, entry_name
from cadgen.output.files.manifest import Written, file_facts, versions, write_manifest
from cadgen.processes import beside
from cadgen.progress import Progress, silent

# Greatest number of teeth of a train: the kernel writes and reads each tooth twice, in some 0.05 s of processor time.
MOST_STEP_TEETH = 1200
# Steel, g/mm³: the mass is for orientation, and the volume stands beside it.
STEEL = 7.85e-3

FRAME = (
    "mm; the drive's axis is z at x = y = 0, and the first stage's driven gear begins at z = 0; every part's own file "
    "has its axis on z, a tooth on x and its lowest gear at z = 0; in the train it is turned over about x if so "
    "marked, turned by its angle about z and shifted to its axis and height"
)


# Label for the progress, and a function that writes files into a folder, reads them back and gives their facts. That of
# STEP, and what it gives, must be such as can be pickled.
Maker = tuple[str, Callable[[Path], Iterable[Result]]]


class PlannedTrain(Protocol):
    """A gear train that has been computed and checked, from a design or from numbers."""

    @property
    def stem(self) -> str:
        """Start of the names of its files."""

    @property
    def description(self) -> str:
        """Description of the train for STEP files, one line."""

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
    makers: Mapping[Format, Maker] = {
        Format.STEP: ("STEP", partial(step_files, plan.layout, plan.stem, plan.description, plan.passed)),
        Format.STL: ("STL", partial(_stl_files, plan)),
        Format.CSV: ("tables", partial(_tables, plan)),
    }
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
    makers: Mapping[Format, Maker],
    wanted: Sequence[Format],
    out: Path,
    progress: Progress,
) -> Written:
    """Make the wanted files of a gear or a train, and publish them with their entry in the manifest.

    Args:
        part: name of the entry of all formats.
        facts: facts on the part, as plain values.
        frame: position of the part in its files, a sentence.
        makers: maker for each format.
        wanted: formats to write, some of those of `makers`.
        out: folder for the files; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    with publishing(out) as staging:
        progress(f"writing and reading back {', '.join(makers[ending][0] for ending in wanted)}")
        made = _made(makers, wanted, staging)
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


def _made(makers: Mapping[Format, Maker], wanted: Sequence[Format], staging: Path) -> list[Result]:
    """Files of every format with their facts; all but STEP are made beside it, see `step_files`."""
    others = [makers[ending][1] for ending in wanted if ending != Format.STEP]
    if Format.STEP not in wanted:
        return _results(others, staging)
    with beside(partial(_results, others, staging)) as rest:
        return [*makers[Format.STEP][1](staging), *rest()]


def _results(makers: Iterable[Callable[[Path], Iterable[Result]]], staging: Path) -> list[Result]:
    return [result for make in makers for result in make(staging)]


def _stl_files(plan: PlannedTrain, staging: Path) -> Iterator[Result]:
    for part in plan.layout.parts:
        yield write_stl(part, staging, f"{plan.stem}_{part.name}", plan.chord(part.gears))


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
    from cadgen.output.files.mesh import read_stl, stl_bytes

    name = f"{stem}.stl"
    (staging / name).write_bytes(stl_bytes(body_mesh(part.body, chord), stem))
    return name, _stl_facts(name, read_stl(staging / name), part, chord)


def _stl_facts(name: str, again: Mesh, part: TrainPart, chord: float) -> dict[str, Any]:
    """Require of a mesh read back that it is closed, one body, and of the exact volume within chord times wall area."""
    solid = again.solid()
    require(len(solid.decompose()) == 1, name, "is not one body")
    corners = again.vertices[again.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(across, axis=1) / 2
    walls = float(area[np.abs(across[:, 2]) < area].sum())
    error = abs(solid.volume() - part.volume)
    require(error <= chord * walls, name, f"misses the exact volume by {error:.3g} mm³")
    return {
        "triangles": len(again.triangles),
        "watertight": True,
        "chord_um": chord * 1e3,
        "volume_error_relative": error / part.volume,
    }


def _tables(plan: PlannedTrain, staging: Path) -> Iterator[Result]:
    rows = table_of(plan)
    name = f"{plan.stem}_parts.csv"
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
    require(same, name, "has other values")
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
