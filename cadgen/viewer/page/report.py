"""The report page of a plan: what is at the top, what moves, curves and tables; and the page as a file."""

from pathlib import Path

from cadgen.messages import Message
from cadgen.output.files.manifest import NAME as MANIFEST
from cadgen.output.files.manifest import sound_parts, unchanged
from cadgen.output.files.publisher import Written, publish, text_file
from cadgen.progress import Progress, silent
from cadgen.version import __version__
from cadgen.viewer.page.document import Failure, Page
from cadgen.viewer.page.html import html_of
from cadgen.viewer.page.page_plan import PagePlan, Scope
from cadgen.viewer.page.train_page import TrainPage


def page_of(plan: PagePlan | TrainPage, files: tuple[tuple[str, tuple[str, ...]], ...] = ()) -> Page:
    """The page of a plan.

    Args:
        plan: what the page shows.
        files: files of the design in the page's folder, by the names of what they are of.
    """
    origin, (scene, notes) = plan.origin, plan.drawn()
    return Page(
        name=origin.name,
        subtitle=plan.subtitle,
        readiness=plan.readiness,
        failures=_failures(plan),
        reservations=tuple(Failure(each.text, each.cure) for each in plan.reservations),
        summary=plan.summary(),
        scene=scene,
        charts=plan.charts(),
        marks=plan.marks(),
        sections=() if plan.scope == Scope.PREVIEW else plan.sections(),
        notes=notes,
        origin=(
            (Message("file of the design"), origin.source),
            (Message("hash"), origin.content_hash),
            (Message("made with"), f"cadgen {__version__}"),
        ),
        files=files,
    )


def _failures(plan: PagePlan | TrainPage) -> tuple[Failure, ...]:
    """Failures, each with advice, and the changes that are proved to bring lost lift within its limit."""
    refused = [Failure(refusal.reason) for refusal in plan.refusals if refusal.fails]
    failing = [check for check in plan.checks if not check.passed]
    cures = [
        Failure(
            Message("Proved cure: --set {override}", override=cure.override), Message("now {value}", value=cure.now)
        )
        for cure in plan.cures.proved
        if not cure.failing
    ]
    return (*refused, *(Failure(check.name, check.advice) for check in failing), *cures)


def _beside(plan: PagePlan | TrainPage, out: Path, stem: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Files in a folder that were made of the same design, by their parts; those that are still there."""
    entries = {part: entry for part, entry in sound_parts(out / MANIFEST).items() if part != stem}
    there = {
        part: tuple(name for name, digest in entry.hashes.items() if unchanged(out / name, digest))
        for part, entry in sorted(entries.items())
        if entry.design_sha256 == plan.origin.content_hash
    }
    return tuple((part, names) for part, names in there.items() if names)


def write_page(plan: PagePlan | TrainPage, out: Path, progress: Progress = silent) -> Written:
    """Write the page and publish it with its figures; also if a check fails, for then it says so first.

    Args:
        plan: what the page shows.
        out: folder for the file; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: the file cannot be written.
    """
    stem = f"{plan.origin.name}_report"
    progress("writing the page")
    html = html_of(page_of(plan, _beside(plan, out, stem)))
    return publish(stem, out, lambda folder: [text_file(folder / f"{stem}.html", html)], plan.figures())
