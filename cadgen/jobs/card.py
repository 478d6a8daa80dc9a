"""Card of settings: one cam, and what to set on the car for every spacing that can be drawn."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import degrees
from os import PathLike
from pathlib import Path
from typing import Any, Generic, Self

import numpy as np

from cadgen.car.course.layout import Draw
from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.design import cam_model, draw_model
from cadgen.design.schema import Design
from cadgen.errors import CheckError
from cadgen.figures import Facts, Sheet
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import CarUse
from cadgen.jobs.settings_maker import TRIES, Maker
from cadgen.jobs.simulation import C
from cadgen.messages import Message, joined
from cadgen.output.files.publisher import Artifact, Written, folder_of, publish, text_file
from cadgen.output.report import settings_card
from cadgen.output.report.notebook import Pictured, lines_picture
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict
from cadgen.version import __version__


def drawn_verdict(cam: CamPlan, drawn: Sequence[DrawnSpacing]) -> PartVerdict:
    """Verdict on a cam, with the checks that fail at spacings of a draw.

    Args:
        cam: cam that was computed.
        drawn: settings of the spacings, with their checks.
    """
    of_cam = cam.verdict
    lost = (check for each in drawn for check in each.failed)
    return PartVerdict((*of_cam.checks, *lost), of_cam.reservations)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Card(Pictured, Generic[C]):
    """Result of `Design.card`: one cam, and what to set on the car for every spacing that can be drawn.

    Lengths are mm and angles rad.

    Attributes:
        cam: cam, with its checks at the spacing that the course is stated at.
        draw: spacings that can be drawn.
        drawn: settings, in the order of the spacings.
        rows: facts on the settings of each spacing.
        legend: meaning of the columns of the printed card.
        sheet: the printed card's table; a spacing that is not kept is marked.
        start_of: point of the car that the start is the place of, in words.
    """

    cam: C
    draw: Draw
    drawn: tuple[DrawnSpacing, ...]
    rows: list[Facts]
    legend: list[str]
    sheet: Sheet
    start_of: str

    def __repr__(self) -> str:
        state = "passed" if self.passed else "failed"
        return f"<Card of {self.cam.origin.name}: {len(self.drawn)} spacings, {state}>"

    @property
    def computed(self) -> Self:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @property
    def use(self) -> CarUse:
        """Car that the cam steers."""
        return CarUse.of(self.cam)

    @property
    def picture(self) -> Drawing:
        """Distance of the car from the path at every spacing, as set by the card."""
        spacing = np.array([each.spacing for each in self.drawn])
        errors = {
            "anywhere on the run": np.array([each.error for each in self.drawn]),
            "at the end": np.array([each.end for each in self.drawn]),
        }
        return lines_picture(f"{self.cam.origin.name}: off the path", "spacing (mm)", "mm", spacing, errors)

    @cached_property
    def verdict(self) -> PartVerdict:
        """Verdict on the cam, with what fails at the spacings."""
        return drawn_verdict(self.cam, self.drawn)

    @property
    def passed(self) -> bool:
        """Whether the cam may be cut, and the settings keep the course at every spacing."""
        return self.verdict.passed

    @property
    def worst(self) -> DrawnSpacing:
        """Spacing with the greatest remaining error."""
        return max(self.drawn, key=lambda each: each.error)

    @property
    def sentences(self) -> tuple[str, ...]:
        """The result in words, the most important first."""
        comparison, laps = self.use.comparison, self.use.laps
        lines = settings_card.sentences(
            self.drawn,
            None if comparison is None else comparison.band.ends,
            None if laps is None else laps.in_run,
        )
        lines += self.use.before_each_run
        if self.cam.passed:
            return tuple(lines)
        names = joined(Message(check.name) for check in self.cam.failed)
        return (Message("the cam itself is not ready, for it fails {names}: see cadgen check", names=names), *lines)

    @property
    def settings(self) -> list[dict[str, Any]]:
        """The settings of each spacing with error and room, as in the table; the unit stands in each name."""
        return [row.json() for row in self.rows]

    def table(self) -> tuple[list[str], list[list[str]]]:
        """The printed card's table as texts: headings, and the cells of each row."""
        return list(self.sheet.heads), [[cell.text for cell in row] for row in self.sheet.cells]

    def entry(self) -> Facts:
        """The result, as in the manifest."""
        origin, comparison = self.cam.origin, self.use.comparison
        return Facts(
            design=origin.name,
            design_sha256=origin.content_hash,
            overrides=origin.overrides,
            cadgen=__version__,
            profile=self.cam.kind.code,
            drive_wheel=self.use.drive_wheel.entry(),
            passed=self.passed,
            failed=[check.code for check in self.cam.failed],
            verdict=self.verdict.entry(),
            stated_spacing_mm=self.draw.stated,
            start_of=self.start_of,
            worst_error_mm=self.worst.error,
            worst_error_at_mm=self.worst.spacing,
            return_error_deg=None if comparison is None else [degrees(end) for end in comparison.band.ends],
            said=self.sentences,
            settings=self.rows,
        )

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the card, `NAME_card.html` to print and `NAME_card.csv`; spacings that are not kept are marked.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: the cam itself fails its checks.
            FileError: a file cannot be written.
        """
        if not self.cam.sound:
            raise CheckError(self.sentences[0])
        name = self.cam.origin.name
        html = settings_card.printed_card(
            Message("{name}: settings for the spacing that is drawn", name=name),
            (
                Message("the cam with its settings is {state}", state=self.verdict.readiness.words),
                *self.sentences,
                *(Message("reservation: {said}", said=each.sentence) for each in self.verdict.reservations),
            ),
            self.sheet,
            [settings_card.fault(each) for each in self.drawn],
            self.legend,
        )
        progress("writing")

        def files(staging: Path) -> Iterator[Artifact]:
            yield text_file(staging / f"{name}_card.csv", settings_card.csv_text(self.rows))
            yield text_file(staging / f"{name}_card.html", html)

        return publish(f"{name}_card", folder_of(folder), files, self.entry())


def draw_of(design: Design) -> Draw:
    """Spacings that can be drawn, for which something can be set.

    Args:
        design: loaded design.

    Raises:
        DesignError: the course has no range of spacing, the design does not say what can be set, or the settings
            cannot reach the range.
    """
    draw = draw_model.draw(design)
    draw_model.settings(design)
    rod = cam_model.leaning(design, "a card of settings")
    draw_model.refuse_range(design, draw, cam_model.track(design), rod)
    return draw


def card_of(design: Design, cam: C, draw: Draw, progress: Progress = silent, *, tries: int = TRIES) -> Card[C]:
    """Settings for every spacing with a cam that is planned.

    Args:
        design: loaded design.
        cam: plan of its cam.
        draw: the spacings.
        progress: function that is called with a few words on each step.
        tries: settings that are sought for a spacing at which the course is not kept.
    """
    maker = Maker(design, cam, draw, tries)
    rows = []
    for spacing in draw.spacings:
        progress(Message("settings for posts {spacing:g} mm apart", spacing=spacing))
        rows.append(maker.drawn(spacing))
    return Card(
        cam=cam,
        draw=draw,
        drawn=tuple(rows),
        rows=settings_card.rows(design, rows),
        legend=settings_card.legend(design, rows, draw.stated),
        sheet=settings_card.sheet(design, rows),
        start_of=settings_card.planned_point(design),
    )
