"""From a checked gear train to files on disk, each read back and measured before it is published."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Protocol

from cadgen.errors import CheckError
from cadgen.gears.layout import TrainLayout
from cadgen.gears.stage import Wheel
from cadgen.gears.train import TrainPlay
from cadgen.jobs.gears.facts import parts_facts, plan_facts
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.output.files.exports import GearExport, TrainExport
from cadgen.output.files.formats import GEAR, TRAIN, Format, Offer, P
from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.output.files.step import require_few_teeth
from cadgen.progress import Progress, silent

# Steel, g/mm³: the mass is for orientation, and the volume stands beside it.
STEEL = 7.85e-3

_TRAIN_FRAME = (
    "mm; the drive's axis is z at x = y = 0, and the first stage's driven gear begins at z = 0; every part's own file "
    "has its axis on z, a tooth on x and its lowest gear at z = 0; in the train it is turned over about x if so "
    "marked, turned by its angle about z and shifted to its axis and height"
)
_GEAR_FRAME = "mm; the gear's axis is z, a tooth stands on x, and its lower face lies at z = 0"


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
        formats: endings of the formats, some of those of `TRAIN`; all of them if left out.

    Raises:
        DesignError: a format is unknown, or the gears have too many teeth for STEP.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    wanted, train = TRAIN.chosen(formats), train_export(plan)
    if any(each.code == "step" for each in wanted):
        require_few_teeth(train, (code for code in TRAIN.codes if code != "step"))
    return _published(f"{plan.stem}_train", TRAIN, train, wanted, facts, _TRAIN_FRAME, out, progress)


def write_gear(
    gear: GearExport,
    facts: dict[str, Any],
    out: Path,
    progress: Progress = silent,
    formats: str | Iterable[str] | None = None,
) -> Written:
    """Write, read back, judge and publish the files of one gear.

    Args:
        gear: gear that is to be written.
        facts: facts on the gear, as plain values.
        out: folder for the files; it is made if need be. Nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.
        formats: endings of the formats, some of those of `GEAR`; all of them if left out.

    Raises:
        DesignError: a format is unknown.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    wanted = GEAR.chosen(formats)
    return _published(f"{gear.name}_gear", GEAR, gear, wanted, facts, _GEAR_FRAME, out, progress)


def _published(
    stem: str,
    offer: Offer[P],
    part: P,
    wanted: Sequence[Format],
    facts: dict[str, Any],
    frame: str,
    out: Path,
    progress: Progress,
) -> Written:
    def files(folder: Path) -> Iterator[Artifact]:
        progress(f"writing and reading back {', '.join(each.label for each in wanted)}")
        for _, made in offer.made(part, folder, wanted):
            if isinstance(made, CheckError):
                raise made
            yield from made

    entry, chosen = offer.entry(stem, wanted)
    return publish(entry, out, files, {**facts, **chosen, "frame": frame}, lambda _: {"omitted": {}})


def train_export(plan: PlannedTrain) -> TrainExport:
    """Train as the writers of all formats take it."""
    return TrainExport(
        stem=plan.stem,
        description=plan.description,
        layout=plan.layout,
        passed=plan.passed,
        chords=[plan.chord(part.gears) for part in plan.layout.parts],
        table=table_of(plan),
    )


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
