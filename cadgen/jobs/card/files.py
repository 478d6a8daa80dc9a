"""A card of settings as sentences, as plain values, and as files: a table and a page to print."""

from collections.abc import Iterator
from math import degrees
from pathlib import Path
from typing import Any

from cadgen.errors import CheckError
from cadgen.jobs.card.plan import CardPlan
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report import settings_card as settings
from cadgen.progress import Progress, silent
from cadgen.version import __version__


def sentences(card: CardPlan) -> list[str]:
    """The result in words, the most important first."""
    comparison, laps = card.cam.comparison, card.cam.laps
    lines = settings.sentences(
        card.drawn,
        None if comparison is None else comparison.band.ends,
        None if laps is None else laps.in_run,
    )
    if card.cam.passed:
        return lines
    names = ", ".join(check.name for check in card.cam.failed)
    return [f"the cam itself fails its checks ({names}): see cadgen check", *lines]


def facts(card: CardPlan) -> dict[str, Any]:
    """The result in the units of its names."""
    design, comparison = card.design, card.cam.comparison
    return {
        "design": design.name,
        "design_sha256": design.content_hash,
        "overrides": list(design.overrides),
        "cadgen": __version__,
        "profile": card.cam.kind.code,
        "drive_wheel": card.cam.drive_wheel.facts(),
        "passed": card.passed,
        "failed": [check.code for check in card.cam.failed],
        "stated_spacing_mm": card.draw.stated,
        "start_of": settings.planned_point(design),
        "worst_error_mm": card.worst.error,
        "worst_error_at_mm": card.worst.spacing,
        "return_error_deg": None if comparison is None else [degrees(end) for end in comparison.band.ends],
        "said": sentences(card),
        "settings": settings.rows(design, card.drawn),
    }


def write_card(card: CardPlan, out: Path, progress: Progress = silent) -> Written:
    """Publish the card as CSV and as a page to print.

    Args:
        card: a card; where it does not keep the course the page and the table say so.
        out: folder, which is made if need be.
        progress: function that is called with a few words on each step.

    Raises:
        CheckError: the cam itself fails its checks.
        FileError: a file cannot be written, or read back is not what was written.
    """
    if not card.cam.passed:
        raise CheckError(sentences(card)[0])
    stem, known = f"{card.design.name}_card", facts(card)
    rows, legend = known["settings"], settings.legend(card.design, card.drawn, card.draw.stated)
    sheet, faults = settings.sheet(card.design, card.drawn), [row["fault"] for row in rows]
    title = f"{card.design.name}: settings for the spacing that is drawn"
    html = settings.printed_card(title, known["said"], sheet, faults, legend)
    progress("writing")

    def files(folder: Path) -> Iterator[Artifact]:
        yield text_file(folder / f"{stem}.csv", settings.csv_text(rows))
        yield text_file(folder / f"{stem}.html", html)

    return publish(stem, out, files, known)
