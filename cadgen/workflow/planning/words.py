"""The result of a plan, or why there is none, as sentences and as plain values."""

from math import degrees
from typing import Any

from cadgen.report import settings
from cadgen.report.reasons import cure, fault, narrow_field
from cadgen.version import __version__
from cadgen.workflow.planning.plan import PlannedPath


def sentences(planned: PlannedPath) -> list[str]:
    """The result in words, the most important first."""
    if planned.reasons or planned.cam is None:
        return _refusal(planned)
    plan, cam = planned.plan, planned.cam
    lines = []
    if cam.comparison is not None:
        band = cam.comparison.chosen.band
        low, high = (degrees(end) for end in cam.comparison.band.ends)
        lines.append(
            f"with play from {low:.3f} to {high:.3f} degrees the run ends at most {band.worst_distance:.0f} mm and "
            f"{degrees(band.worst_heading):.2f} degrees off ({cam.comparison.chosen.profile} profile, "
            "by the exact chain)"
        )
    length = plan.path.cost.line.length
    lines.append(
        f"the drive wheel's track is {length:.0f} mm long; the path has {len(plan.path.points)} control points"
    )
    if (radius := planned.wheel_radius) is not None:
        lines.append(
            f"the plan is for a drive wheel of {radius:.2f} mm radius: the whole path before the closing blend"
        )
    if cam.laps is not None:
        said = [cam.wheel.sentence()]
        if cam.comparison is not None:
            said += cam.laps.sentences(cam.comparison.run, cam.comparison.before, cam.comparison.chosen)
        lines += [sentence.removesuffix(".") for sentence in said]
    if planned.drawn:
        lines += [*settings.sentences(planned.drawn, None), "cadgen card has the settings for every spacing"]
    if not planned.passed:
        lines.append("a check still fails, so nothing is written: see the table")
    return lines


def _refusal(planned: PlannedPath) -> list[str]:
    if planned.failed:
        return [f"the path can be driven, but not with the limits of [optimize]: {planned.failed}"]
    if not planned.reasons:
        names = ", ".join(planned.plan.missed)
        return [f"no path was found that keeps all limits; the best one violates {names}: try --seeds 5"]
    first, *rest = planned.reasons
    if narrow := narrow_field(first, planned.task):
        return [f"the course cannot be driven: {narrow}"]
    lines = [f"the course cannot be driven: {fault(first, planned.task)}"]
    if first.enough:
        lines[0] += f"; least change that does: {cure(first, planned.task, planned.design)}"
        lines += [f"or {cure(reason, planned.task, planned.design)}" for reason in rest if reason.enough]
    else:
        lines[0] += "; and no single limit that gives way is enough"
    return lines


def facts(planned: PlannedPath) -> dict[str, Any]:
    """The result in the units of its names."""
    design, plan, cam = planned.design, planned.plan, planned.cam
    comparison = None if cam is None else cam.comparison
    return {
        "design": design.name,
        "design_sha256": design.content_hash,
        "overrides": list(design.overrides),
        "cadgen": __version__,
        "passed": planned.passed,
        "control_points": len(plan.path.points),
        "track_mm": plan.path.cost.line.length,
        "drive_wheel_radius_mm": planned.wheel_radius,
        "first_order_mm": plan.path.cost.distance,
        "worst_end_position_mm": None if comparison is None else comparison.chosen.band.worst_distance,
        "worst_end_heading_deg": None if comparison is None else degrees(comparison.chosen.band.worst_heading),
        "return_error_deg": None if comparison is None else [degrees(end) for end in comparison.band.ends],
        "failed": [] if cam is None else [check.code for check in cam.failed],
        "settings": settings.rows(design, planned.drawn),
        "said": sentences(planned),
        "reasons": [
            {"limit": each.limit, "amount": each.amount, "near_mm": list(each.place), "enough": each.enough}
            for each in planned.reasons
        ],
    }
