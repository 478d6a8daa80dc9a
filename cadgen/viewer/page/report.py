"""The report page of a plan: what is at the top, what moves, curves and tables; and the page as a file."""

from math import degrees
from pathlib import Path
from typing import Any

from cadgen.figures import Cell, State, number
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.car_facts import remedy_facts
from cadgen.messages import Message
from cadgen.output.files.publisher import Written, publish, text_file
from cadgen.progress import Progress, silent
from cadgen.version import __version__
from cadgen.viewer.page.charts import charts_of
from cadgen.viewer.page.check_words import check_name
from cadgen.viewer.page.document import Failure, Page, Section
from cadgen.viewer.page.html import html_of
from cadgen.viewer.page.page_plan import PagePlan, Scope, Topic
from cadgen.viewer.page.scene import scene_of, still_scene
from cadgen.viewer.page.sections import (
    calibration_section,
    checks_section,
    inspection_section,
    parts_section,
    play_section,
    tolerance_section,
)
from cadgen.viewer.page.sentences import generated


def page_of(plan: PagePlan) -> Page:
    """The page of a plan."""
    charted, origin = charts_of(plan.cam, plan.simulation), plan.cam.origin
    if plan.of_car:
        scene, notes = scene_of(plan.cam, plan.gears)
        missing = plan.design.train is None
        alone = Message("The design has no gear train: the cam is shown alone.")
        notes = (*([alone] if missing else []), generated(plan.cam.drive_wheel.sentence()), *notes)
    else:
        scene, notes = still_scene(plan.cam), plan.cam.application.notes(plan.cam)
    return Page(
        name=origin.name,
        subtitle=plan.cam.kind.code,
        passed=plan.passed,
        failures=_failures(plan),
        summary=_summary(plan),
        scene=scene,
        charts=charted.charts,
        marks=charted.marks,
        sections=() if plan.scope == Scope.PREVIEW else _sections(plan),
        notes=notes,
        origin=(
            (Message("file of the design"), origin.source),
            (Message("hash"), origin.content_hash),
            (Message("made with"), f"cadgen {__version__}"),
        ),
    )


def _sections(plan: PagePlan) -> tuple[Section, ...]:
    if not plan.of_car:
        return checks_section(plan), inspection_section(plan), parts_section(plan)
    reasons = {refusal.part: refusal.reason for refusal in plan.refusals}
    without = Message("Without play there are no runs to vary: add [train] or [play] to the design.")
    if plan.scope == Scope.EDITED:
        without = Message(
            "Random cars are left out while the design is edited: `cadgen tolerance` and `cadgen report` run them."
        )
    return (
        checks_section(plan),
        play_section(plan),
        tolerance_section(
            plan.tolerance, generated(reasons[Topic.TOLERANCE]) if Topic.TOLERANCE in reasons else without
        ),
        calibration_section(plan, reasons.get(Topic.CALIBRATION, "")),
        inspection_section(plan),
        parts_section(plan),
    )


def _failures(plan: PagePlan) -> tuple[Failure, ...]:
    """Failures, each with advice, and the changes that are proved to bring lost lift within its limit."""
    refused = [Failure(generated(refusal.reason)) for refusal in plan.refusals if refusal.fails]
    failing = [check for check in plan.checks if not check.passed]
    cures = [
        Failure(
            Message("Proved cure: --set {override}", override=cure.override), Message("now {value}", value=cure.now)
        )
        for cure in plan.cures.proved
        if not cure.failing
    ]
    return (*refused, *(Failure(check_name(check), generated(check.advice)) for check in failing), *cures)


def _summary(plan: PagePlan) -> tuple[tuple[str, Cell], ...]:
    """The figures at the top."""
    checks = plan.checks
    passing = sum(check.passed for check in checks)
    rows: list[tuple[str, Cell]] = [
        (
            Message("checks that pass"),
            Cell(f"{passing} / {len(checks)}", state=State.BAD if passing < len(checks) else State.GOOD),
        ),
    ]
    if plan.simulation is not None:
        rows.append(
            (Message("end of the run, with play"), number(plan.simulation.after_error.end_distance, "mm", digits=1))
        )
        rows.append((Message("return error"), number(degrees(plan.simulation.play), "°")))
    if plan.tolerance is not None:
        rows.append((Message("cars that pass"), number(100 * plan.tolerance.passed, "%", digits=2)))
    if plan.gears is not None:
        rows.append((Message("ratio of the train"), Cell(str(plan.gears.play.train.ratio))))
    if not plan.of_car:
        return tuple(rows)
    rows.append((Message("travel in a turn of the cam"), number(plan.cam.drive_wheel.turn, "mm", digits=0)))
    if plan.cam.drive_wheel.radius is not None:
        rows.append((Message("drive wheel radius"), number(plan.cam.drive_wheel.radius, "mm")))
    return tuple(rows)


def page_facts(plan: PagePlan) -> dict[str, Any]:
    """Every figure of the page as plain values, as the other commands give them."""
    return {
        **plan.cam.origin.facts(),
        "profile": plan.cam.kind.code,
        "passed": plan.passed,
        "refused": [{"part": refusal.part, "reason": refusal.reason} for refusal in plan.refusals],
        "cam": cam_facts(plan.cam, plan.cures),
        "gears": None if plan.gears is None else plan.gears.facts(),
        "simulation": None if plan.simulation is None else plan.simulation.facts(),
        "remedies": [remedy_facts(remedy) for remedy in plan.remedies],
        "tolerance": None if plan.tolerance is None else plan.tolerance.facts(),
        "calibration": _calibration(plan),
    }


def _calibration(plan: PagePlan) -> dict[str, Any] | None:
    if plan.calibration is None:
        return None
    from cadgen.jobs.calibration.files import document

    return document(plan.calibration)


def write_page(plan: PagePlan, out: Path, progress: Progress = silent) -> Written:
    """Write the page and publish it with its figures; also if a check fails, for then it says so first.

    Args:
        plan: what the page shows.
        out: folder for the file; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: the file cannot be written.
    """
    stem = f"{plan.cam.origin.name}_report"
    progress("writing the page")
    html = html_of(page_of(plan))
    return publish(stem, out, lambda folder: [text_file(folder / f"{stem}.html", html)], page_facts(plan))
