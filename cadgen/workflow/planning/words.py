"""The result of a plan, or why there is none, as sentences and as plain values."""

from math import atan, degrees, tan
from typing import Any

from cadgen.planner.reasons import Reason
from cadgen.version import __version__
from cadgen.workflow.planning.plan import PlannedPath


def sentences(planned: PlannedPath) -> list[str]:
    """The result in words, the most important first."""
    if planned.reasons or planned.cam is None:
        return _refusal(planned)
    plan, cam = planned.plan, planned.cam
    lines = []
    if cam.against is not None:
        band = cam.against.chosen.band
        low, high = (degrees(end) for end in cam.against.band.ends)
        lines.append(
            f"with play from {low:.3f} to {high:.3f} degrees the run ends at most {band.worst_distance:.0f} mm and "
            f"{degrees(band.worst_heading):.2f} degrees off ({cam.against.chosen.profile} profile, by the exact chain)"
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
        if cam.against is not None:
            said += cam.laps.sentences(cam.against.run, cam.against.before, cam.against.chosen)
        lines += [sentence.removesuffix(".") for sentence in said]
    if not cam.passed:
        lines.append("a check still fails, so nothing is written: see the table")
    return lines


def _refusal(planned: PlannedPath) -> list[str]:
    if planned.failed:
        return [f"the path can be driven, but not with the limits of [optimize]: {planned.failed}"]
    if not planned.reasons:
        names = ", ".join(planned.plan.missed)
        return [f"no path was found that keeps all limits; the best one violates {names}: try --seeds 5"]
    first, *rest = planned.reasons
    lines = [f"the course cannot be driven: {_what(planned, first)}"]
    if first.enough:
        lines[0] += f"; least change that does: {_cure(planned, first)}"
        lines += [f"or {_cure(planned, reason)}" for reason in rest if reason.enough]
    else:
        lines[0] += "; and no single limit that gives way is enough"
    return lines


def _what(planned: PlannedPath, reason: Reason) -> str:
    """The fault, and its amount."""
    x, y = reason.place
    where = f"near ({x:.0f}, {y:.0f}) mm"
    limits, name, amount = planned.task.limits, reason.limit, reason.amount
    if name == "turn":
        held = 1 / min(limits.left, limits.right)
        return (
            f"it needs a turn {where} that is {100 * amount:.0f} % tighter than the {held:.0f} mm that the fork holds"
        )
    if name == "pressure angle":
        steep = degrees(atan((1 + amount) * tan(limits.rise)))
        most = degrees(limits.rise)
        return f"it needs a pressure angle of {steep:.1f} degrees {where}, and {most:.1f} are planned for"
    if name in ("convex radius", "valley"):
        return f"the lift must turn {100 * amount:.0f} % more sharply {where} than the outline can follow"
    if name in ("slope", "bend"):
        return f"the curvature must change {100 * amount:.0f} % faster {where} than the path it is compared with"
    if name == "length":
        return f"the path is {amount:.0f} mm longer than wheel and train drive before the closing blend"
    if name == "near":
        return f"the path must leave the given one by {amount:.1f} mm more than it may, {where}"
    if name.endswith(" heading"):
        return f"{name.removesuffix(' heading')} cannot be passed in its direction, by {degrees(amount):.1f} degrees"
    if name.startswith(("course.gates", "course.finish", "course.start", "path")):
        return f"{name} is missed by {amount:.1f} mm"
    return f"the car comes {amount:.1f} mm too near to {name} {where}"


def _cure(planned: PlannedPath, reason: Reason) -> str:
    """The change that would do."""
    name, amount, design = reason.limit, reason.amount, planned.design
    if name == "turn":
        steering = degrees(atan((1 + amount) * tan(planned.task.vehicle.car.max_steering_angle)))
        return f"raise car.max_steering_angle_deg to {steering + 0.5:.0f}"
    if name == "pressure angle":
        return f"raise cam.base_radius_mm to {(1 + amount) * design.cam.base_radius_mm + 0.5:.0f}"
    if name == "convex radius":
        return (
            f"raise cam.base_radius_mm to {(1 + amount) * design.cam.base_radius_mm + 0.5:.0f}, or take a thinner rod"
        )
    if name == "valley":
        most = (1 + amount) * (design.optimize.max_lift_error_um or 0.0)
        return f"raise optimize.max_lift_error_um to {most + 1:.0f}"
    if name in ("slope", "bend"):
        return f"allow the curvature to change {100 * amount + 1:.0f} % faster"
    if name == "length":
        radius = design.car.drive_wheel_radius_mm or 0.0
        wheel = radius * (1 + amount / planned.task.vehicle.most_length)
        return f"raise car.drive_wheel_radius_mm to {wheel + 0.01:.2f}"
    if name == "near":
        return f"allow {planned.task.within + amount + 0.1:.1f} mm"
    if name.endswith(" heading"):
        key = name.removesuffix(" heading")
        return f"raise {key}.heading_tolerance_deg by {degrees(amount) + 0.1:.1f}"
    if name.startswith(("course.gates", "course.finish", "course.start")):
        return f"make {name} {amount + 0.1:.1f} mm wider to either side, or move it by that"
    if name == "course.field":
        return f"make the field {amount + 0.1:.1f} mm larger there, or lower course.margin_mm by that"
    return f"move {name} by {amount + 0.1:.1f} mm, or lower course.margin_mm by that"


def facts(planned: PlannedPath) -> dict[str, Any]:
    """The result in the units of its names."""
    design, plan, cam = planned.design, planned.plan, planned.cam
    against = None if cam is None else cam.against
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
        "worst_end_position_mm": None if against is None else against.chosen.band.worst_distance,
        "worst_end_heading_deg": None if against is None else degrees(against.chosen.band.worst_heading),
        "return_error_deg": None if against is None else [degrees(end) for end in against.band.ends],
        "failed": [] if cam is None else [check.code for check in cam.failed],
        "said": sentences(planned),
        "reasons": [
            {"limit": each.limit, "amount": each.amount, "near_mm": list(each.place), "enough": each.enough}
            for each in planned.reasons
        ],
    }
