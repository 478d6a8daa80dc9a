"""The report page as a file, published with its figures."""

from pathlib import Path
from typing import Any

from cadgen.jobs.cam.manifest import cam_facts, design_facts, remedy_facts
from cadgen.jobs.gears.facts import plan_facts
from cadgen.jobs.runs.manifest import simulation_facts, tolerance_facts
from cadgen.output.files.folder import publishing
from cadgen.output.files.manifest import Written, file_facts, versions, write_manifest
from cadgen.progress import Progress, silent
from cadgen.viewer.page.content.page import page_of
from cadgen.viewer.page.content.plan import PagePlan
from cadgen.viewer.page.html import html_of


def page_facts(plan: PagePlan) -> dict[str, Any]:
    """Every figure of the page as plain values, as the other commands give them."""
    return {
        **design_facts(plan.design),
        "profile": plan.cam.profile.code,
        "passed": plan.passed,
        "refused": [{"part": refusal.part, "reason": refusal.reason} for refusal in plan.refusals],
        "cam": cam_facts(plan.cam, plan.cures),
        "gears": None if plan.gears is None else plan_facts(plan.gears),
        "simulation": None if plan.simulation is None else simulation_facts(plan.simulation),
        "remedies": [remedy_facts(remedy) for remedy in plan.remedies],
        "tolerance": None if plan.tolerance is None else tolerance_facts(plan.tolerance),
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
    stem = f"{plan.design.name}_report"
    with publishing(out) as staging:
        progress("writing the page")
        name = f"{stem}.html"
        (staging / name).write_text(html_of(page_of(plan)), encoding="utf-8", newline="")
        entry = {**page_facts(plan), "versions": versions(), "files": {name: file_facts(staging / name)}}
        write_manifest(staging, stem, entry)
    return Written(stem, entry)
