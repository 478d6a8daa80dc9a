"""A report page from its plans: what is at the top, what moves, curves, and tables in their order."""

from math import degrees

from cadgen.version import __version__
from cadgen.viewer.page.check_words import check_name
from cadgen.viewer.page.content.charts import charts_of
from cadgen.viewer.page.content.parts_sections import calibration_section, inspection_section, parts_section
from cadgen.viewer.page.content.plan import PagePlan, Scope, Topic
from cadgen.viewer.page.content.scene import scene_of
from cadgen.viewer.page.content.sections import cam_notes, checks_section, play_section, tolerance_section
from cadgen.viewer.page.document import Cell, Failure, Page, Section, Text, Words, number
from cadgen.viewer.page.names import State
from cadgen.viewer.page.sentences import generated
from cadgen.viewer.page.words import named, say


def page_of(plan: PagePlan) -> Page:
    """The page of a plan."""
    scene, notes = scene_of(plan.cam, plan.gears)
    charted = charts_of(plan.cam, plan.simulation)
    design = plan.design
    missing = () if design.train is not None else (say("no-gears"),)
    return Page(
        name=design.name,
        subtitle=named(plan.cam.profile.code),
        passed=plan.passed,
        failures=_failures(plan),
        summary=_summary(plan),
        scene=scene,
        charts=charted.charts,
        marks=charted.marks,
        sections=() if plan.scope == Scope.PREVIEW else _sections(plan),
        notes=(*missing, *cam_notes(plan.cam), *notes),
        origin=(
            (say("file of the design"), design.source),
            (say("hash"), design.content_hash),
            (say("made with"), f"cadgen {__version__}"),
        ),
    )


def _sections(plan: PagePlan) -> tuple[Section, ...]:
    reasons = {refusal.part: refusal.reason for refusal in plan.refusals}
    without = say("not-while-edited" if plan.scope == Scope.EDITED else "no-tolerance")
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
            Words(f"Proved cure: --set {cure.override}", f"已验证的修改：--set {cure.override}"),
            Words(f"now {cure.now}", f"现为 {cure.now}"),
        )
        for cure in plan.cures.proved
        if not cure.failing
    ]
    return (*refused, *(Failure(check_name(check), generated(check.advice)) for check in failing), *cures)


def _summary(plan: PagePlan) -> tuple[tuple[Text, Cell], ...]:
    """The figures at the top."""
    checks = plan.checks
    passing = sum(check.passed for check in checks)
    rows: list[tuple[Text, Cell]] = [
        (
            say("checks that pass"),
            Cell(f"{passing} / {len(checks)}", state=State.BAD if passing < len(checks) else State.GOOD),
        ),
    ]
    if plan.simulation is not None:
        rows.append(
            (say("end of the run, with play"), number(plan.simulation.after_error.end_distance, "mm", digits=1))
        )
        rows.append((say("return error"), number(degrees(plan.simulation.play), "°")))
    if plan.tolerance is not None:
        rows.append((say("cars that pass"), number(100 * plan.tolerance.passed, "%", digits=2)))
    if plan.gears is not None:
        rows.append((say("ratio of the train"), Cell(str(plan.gears.play.train.ratio))))
    rows.append((say("travel in a turn of the cam"), number(plan.cam.wheel.turn, "mm", digits=0)))
    if plan.cam.wheel.radius is not None:
        rows.append((say("drive wheel radius"), number(plan.cam.wheel.radius, "mm")))
    return tuple(rows)
