"""Gear trains that are laid out and checked, from a design or from numbers: their figures and files.

Lengths are mm and angles rad; plain values are in the unit that their key names.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import degrees, prod
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from cadgen.check import Check, failing
from cadgen.errors import CheckError
from cadgen.figures import Facts, Figures, JobResult
from cadgen.gears.layout import TrainLayout
from cadgen.gears.stage import Wheel
from cadgen.gears.train import Train, TrainPlay, WholePlay
from cadgen.messages import Message, joined
from cadgen.output.files.exports import GearExport, RackExport, TrainExport
from cadgen.output.files.publisher import Artifact, Written, folder_of, publish, refusal
from cadgen.output.report.gear_pictures import gears_picture
from cadgen.output.report.notebook import Pictured, Viewed
from cadgen.output.report.style import Drawing
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Flats
from cadgen.parts.print_compensation import PrintCompensation
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import Compound
    from cadgen.geometry.solids.kernel import Solid
    from cadgen.output.files.formats import Format, Offer, P

# Steel, g/mm³: the mass is for orientation, and the volume stands beside it.
STEEL = 7.85e-3

_TRAIN_FRAME = (
    "mm; the drive's axis is z at x = y = 0, and the first stage's driven gear begins at z = 0; every part's own file "
    "has its axis on z, a tooth on x and its lowest gear at z = 0; in the train it is turned over about x if so "
    "marked, turned by its angle about z and shifted to its axis and height"
)
_RACK_FRAME = "mm; the reference line is x at z = 0, the teeth point to y, and the width runs upwards along z"
_GEAR_FRAME = "mm; the gear's axis is z, a tooth stands on x, and its lower face lies at z = 0"


@dataclass(frozen=True)
class ReturnError:
    """Free angle of the output while the drive stands still.

    Attributes:
        least: least return error within the tolerances, rad; below 0 the teeth may jam.
        as_cut: return error with every size in the middle, as drawn and as built in CAD, rad.
        greatest: greatest return error within the tolerances, rad.
    """

    least: float
    as_cut: float
    greatest: float


class LaidOutTrain(Protocol):
    """A train that has been laid out and measured in mesh."""

    @property
    def play(self) -> TrainPlay:
        """Play and return error of the train."""

    @property
    def layout(self) -> TrainLayout:
        """Parts at their places."""

    @property
    def checks(self) -> tuple[Check, ...]:
        """The teeth in mesh, measured on their sections, and the parts: every figure with its verdict."""


class Assembly(Pictured, Viewed, ABC):
    """A planned pair or train of gears, from a design or from numbers."""

    @property
    @abstractmethod
    def computed(self) -> LaidOutTrain:
        """The train, laid out and measured in mesh."""

    @property
    @abstractmethod
    def stem(self) -> str:
        """Start of the names of its files."""

    @property
    @abstractmethod
    def description(self) -> str:
        """Description of the train for STEP files, one line."""

    @abstractmethod
    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm.

        Args:
            gears: gears of the part.
        """

    @property
    def frame(self) -> str:
        """Frames of the files, in words."""
        return _TRAIN_FRAME

    @property
    def picture(self) -> Drawing:
        """Sections of the gears in mesh."""
        return gears_picture(self.description, self.computed.layout.parts)

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not self.failed

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.computed.checks)

    @property
    def ratio(self) -> Fraction:
        """Turns of the drive per turn of the output."""
        return self.computed.play.train.ratio

    @cached_property
    def return_error(self) -> ReturnError:
        """Free angle of the output while the drive stands still, rad: of the teeth alone."""
        play, cut = self.computed.play, self.computed.layout.train
        free = [stage.free_angle() / float(ratio) for stage, ratio in zip(cut.stages, cut.output_ratios, strict=True)]
        return ReturnError(float(play.return_error_min), sum(free), float(play.return_error_max))

    @property
    def printing(self) -> PrintCompensation | None:
        """Compensation of the files for printing; None for none."""
        return None

    @property
    def export(self) -> TrainExport:
        """Train as the writers of all formats take it."""
        layout = self.computed.layout.pieces
        return TrainExport(
            stem=self.stem,
            description=self.description,
            layout=layout,
            passed=self.passed,
            chords=[self.chord(part.gears) for part in layout.parts],
            table=table_of(layout),
            printing=self.printing,
        )

    def build123d(self) -> Compound:
        """The parts in mesh as one build123d compound, a labelled and coloured solid for each, mm.

        Raises:
            FileError: the CAD kernel cannot drill a set screw.
        """
        from cadgen.geometry.solids.gear_solids import train_compound, train_parts

        layout = self.computed.layout.pieces
        return train_compound(train_parts(layout, self.stem, self.description), layout, f"{self.stem}_train")

    def write(
        self,
        folder: str | PathLike[str],
        formats: str | Iterable[str] | None = None,
        *,
        force: bool = False,
        printing: PrintCompensation | None = None,
        progress: Progress = silent,
    ) -> Written:
        """Write files, measure the play on the teeth read back, and publish all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            formats: some of step (the assembly and each part), stl, 3mf, dxf (outlines) and csv (the table of parts);
                step, stl and csv if left out.
            force: whether files are written even if a check fails; the manifest then says so.
            printing: what STL and 3MF take back for a printer; None for what the design says.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: a check fails.
            DesignError: a format is unknown.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.output.files.formats import TRAIN
        from cadgen.output.files.step import require_few_teeth

        place = folder_of(folder)
        if not (self.passed or force):
            raise CheckError(refusal(self.failed))
        wanted, train = TRAIN.chosen(formats), replace(self.export, printing=printing or self.printing)
        if any(each.code == "step" for each in wanted):
            require_few_teeth(train, (code for code in TRAIN.codes if code != "step"))
        return _published(f"{self.stem}_train", TRAIN, train, wanted, self.entry(), self.frame, place, progress)


class OnePart(JobResult, Viewed):
    """Base of a gear or a rack that is written by itself."""

    @abstractmethod
    def _export(self) -> GearExport | RackExport:
        """The part as its files need it."""

    def build123d(self) -> Solid:
        """The part as a build123d solid with label and colour, mm; its lower face lies at z = 0.

        Raises:
            FileError: the CAD kernel cannot drill the set screw.
        """
        return self._export().solid().build123d()

    def write(
        self,
        folder: str | PathLike[str],
        formats: str | Iterable[str] | None = None,
        *,
        printing: PrintCompensation | None = None,
        progress: Progress = silent,
    ) -> Written:
        """Write files and compare every tooth read back with the exact one; all are published together or none.

        Args:
            folder: folder for the files; it is made if need be.
            formats: some of step, stl, 3mf and dxf; all if left out.
            printing: what STL and 3MF take back for a printer; None for nothing.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: a format is unknown.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.output.files.formats import GEAR, RACK

        part = replace(self._export(), printing=printing)
        offer: Offer[Any] = GEAR if isinstance(part, GearExport) else RACK
        stem, wanted = f"{part.name}_{offer.part}", offer.chosen(formats)
        frame = _GEAR_FRAME if isinstance(part, GearExport) else _RACK_FRAME
        return _published(stem, offer, part, wanted, self.entry(), frame, folder_of(folder), progress)


def _published(
    stem: str,
    offer: Offer[P],
    part: P,
    wanted: Sequence[Format],
    facts: Facts,
    frame: str,
    out: Path,
    progress: Progress,
) -> Written:
    def files(folder: Path) -> Iterator[Artifact]:
        progress(Message("writing and reading back {formats}", formats=joined(each.label for each in wanted)))
        for _, made in offer.made(part, folder, wanted):
            if isinstance(made, CheckError):
                raise made
            yield from made

    entry, chosen = offer.entry(stem, wanted)
    return publish(entry, out, files, facts | chosen | Facts(frame=frame), lambda _: Facts(omitted={}))


def table_of(layout: TrainLayout) -> list[dict[str, str | float | None]]:
    """The table of parts with what the shop measures, one row per gear; volume and mass are the whole part's."""
    return [
        {
            "part": part.name,
            "shaft": None if part.beside else part.shaft,
            "stage": stage,
            **gear.facts(),
            "bore_mm": part.blank.bore_diameter,
            "part_volume_mm3": part.volume,
            "part_mass_steel_g": part.volume * STEEL,
        }
        for part, gears in zip(layout.parts, gear_figures(layout), strict=True)
        for stage, gear in gears.items()
    ]


def stages_facts(layout: TrainLayout) -> list[Facts]:
    """Every stage as it is cut, with its play."""
    return [stage.entry() for stage in layout.train.stages]


def checks_facts(checks: Iterable[Check]) -> list[Facts]:
    """Every check with its verdict."""
    return [Facts(**asdict(check), passed=check.passed) for check in checks]


def gear_figures(layout: TrainLayout) -> list[dict[int, Figures]]:
    """Figures of the gears of each part by the number of their stage, to make and to measure them by.

    A stage's driver sits on the shaft of its number, the driven wheel on the next.
    """
    wheels = [stage.wheel_figures() for stage in layout.train.stages]
    return [{stage: wheels[stage - 1][part.wheel_of(stage)] for stage in part.stages} for part in layout.parts]


def parts_facts(layout: TrainLayout) -> list[Facts]:
    """Every part at its place, with what the shop is told of its wheels."""
    return [
        Facts(
            name=part.name,
            shaft=None if part.beside else part.shaft,
            axis_mm=(part.axis.real, part.axis.imag),
            height_mm=part.height,
            angle_deg=degrees(part.angle),
            turned_over=part.flipped,
            bore_mm=part.blank.bore_diameter,
            **flats_of(part.blank),
            volume_mm3=part.volume,
            gears=[Facts(stage=stage) | gear for stage, gear in gears.items()],
        )
        for part, gears in zip(layout.parts, gear_figures(layout), strict=True)
    ]


METHOD = Message("Niemann/Ohlendorf: constant friction, load shared equally by the teeth in contact; teeth alone")


def losses(train: Train, friction: float, source: str) -> Facts:
    """Losses of the teeth of a train, as cut, with their method.

    Args:
        train: train with its teeth as cut.
        friction: friction coefficient of the flanks.
        source: where that is from.
    """
    each = [stage.efficiency(friction) for stage in train.stages]
    known = [one for one in each if one is not None]
    whole = prod(known) if len(known) == len(each) else None
    return Facts(method=METHOD, friction_coefficient=friction, friction_source=source, stages=each, efficiency=whole)


def losses_note(train: Train, friction: float, source: str) -> Message:
    """Sentence on the losses of the teeth of a train; as `losses`.

    Args:
        train: train with its teeth as cut.
        friction: friction coefficient of the flanks.
        source: where that is from.
    """
    each = [stage.efficiency(friction) for stage in train.stages]
    if None in each:
        return Message("the losses of this train are not known, for a stage is of another kind than gears")
    return Message(
        "the teeth pass on {percent:.2f} % of the power with a friction coefficient of {friction:g} ({source}), by "
        "Niemann and Ohlendorf; bearings are not counted",
        percent=100 * prod(one for one in each if one is not None),
        friction=friction,
        source=source,
    )


def flats_of(blank: Blank) -> dict[str, float]:
    """Flats of a bore, for the manifest; nothing of a round one.

    Args:
        blank: blank of the part.
    """
    match blank.key:
        case DFlat(depth=depth):
            return {"bore_across_flat_mm": blank.bore_diameter - depth}
        case Flats(count=count):
            return {"bore_flats": count}
    return {}


def return_error(play: TrainPlay | WholePlay) -> dict[str, float]:
    """Least, mean and greatest return error of a train and its standard deviation, in degrees."""
    spread = play.return_error_distribution()
    return {
        "least": degrees(play.return_error_min),
        "mean": degrees(spread.mean),
        "greatest": degrees(play.return_error_max),
        "std": degrees(spread.std),
    }
