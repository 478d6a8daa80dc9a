"""Reasons why a course cannot be driven, in words, each with the least change that would do."""

from math import atan, degrees, radians, tan

from cadgen.car.course.refuse import largest_circle, least_steering, turning_circle
from cadgen.car.planner.constraints import LimitKind
from cadgen.car.planner.path_plan import Reason
from cadgen.car.planner.path_task import PathTask
from cadgen.design.schema import Design

_STEEPEST = radians(75)
# Limits that a field brings about in which the car cannot turn round.
_OF_TURNS = (LimitKind.TURN, LimitKind.PRESSURE_ANGLE, LimitKind.CONVEX_RADIUS, LimitKind.FIELD)


def narrow_field(reason: Reason, task: PathTask) -> str:
    """Sentence on a field in which the car cannot turn round, where that may be why; empty if it can."""
    field, vehicle, kind = task.course.edge, task.vehicle, reason.limit.kind
    if field is None or kind not in _OF_TURNS or (reason.enough and kind != LimitKind.FIELD):
        return ""
    car, body = vehicle.car, vehicle.body
    taken, room = turning_circle(body, car, car.max_steering_angle) + task.course.margin, largest_circle(field)
    if taken <= room:
        return ""
    steering = least_steering(body, car, room - task.course.margin, _STEEPEST)
    more = "" if steering is None else f", or raise car.max_steering_angle_deg to {degrees(steering) + 0.5:.0f}"
    return (
        f"course.field is too small for the car to turn round in: with {degrees(car.max_steering_angle):.0f} degrees "
        f"of steering that takes a circle of {taken:.0f} mm radius, and the field holds one of {room:.0f} mm: make the "
        f"field {2 * (taken - room) + 1:.0f} mm wider{more}"
    )


def fault(reason: Reason, task: PathTask) -> str:
    """The fault, and its amount, as the end of a sentence."""
    x, y = reason.place
    where = f"near ({x:.0f}, {y:.0f}) mm"
    limits, kind, key, amount = task.limits, reason.limit.kind, reason.limit.key, reason.amount
    if kind == LimitKind.TURN:
        held = 1 / min(limits.left, limits.right)
        return (
            f"it needs a turn {where} that is {100 * amount:.0f} % tighter than the {held:.0f} mm that the fork holds"
        )
    if kind == LimitKind.PRESSURE_ANGLE:
        steep = degrees(atan((1 + amount) * tan(limits.rise)))
        most = degrees(limits.rise)
        return f"it needs a pressure angle of {steep:.1f} degrees {where}, and {most:.1f} are planned for"
    if kind == LimitKind.BLEND:
        return f"the closing blend must come over {100 * amount:.0f} % more lift than the rod can follow"
    if kind in (LimitKind.CONVEX_RADIUS, LimitKind.VALLEY):
        return f"the lift must turn {100 * amount:.0f} % more sharply {where} than the outline can follow"
    if kind in (LimitKind.SLOPE, LimitKind.BEND):
        return f"the curvature must change {100 * amount:.0f} % faster {where} than the path it is compared with"
    if kind == LimitKind.LENGTH:
        return f"the path is {amount:.0f} mm longer than wheel and train drive before the closing blend"
    if kind == LimitKind.CORRIDOR:
        return f"the path must leave the given one by {amount:.1f} mm more than it may, {where}"
    if kind == LimitKind.HEADING:
        return f"{key} cannot be passed in its direction, by {degrees(amount):.1f} degrees"
    if kind == LimitKind.GATE:
        return f"{key} is missed by {amount:.1f} mm"
    return f"the car comes {amount:.1f} mm too near to {key} {where}"


def cure(reason: Reason, task: PathTask, design: Design) -> str:
    """The change that would do, as the end of a sentence."""
    kind, key, amount = reason.limit.kind, reason.limit.key, reason.amount
    if kind == LimitKind.TURN:
        steering = degrees(atan((1 + amount) * tan(task.vehicle.car.max_steering_angle)))
        return f"raise car.max_steering_angle_deg to {steering + 0.5:.0f}"
    if kind == LimitKind.PRESSURE_ANGLE:
        return f"raise cam.base_radius_mm to {(1 + amount) * design.cam.base_radius_mm + 0.5:.0f}"
    if kind == LimitKind.CONVEX_RADIUS:
        return (
            f"raise cam.base_radius_mm to {(1 + amount) * design.cam.base_radius_mm + 0.5:.0f}, or take a thinner rod"
        )
    if kind == LimitKind.BLEND:
        return f"raise cam.blend_deg to {(1 + amount) * design.cam.blend_deg + 0.5:.0f}"
    if kind == LimitKind.VALLEY:
        most = (1 + amount) * (design.optimize.max_lift_error_um or 0.0)
        return f"raise optimize.max_lift_error_um to {most + 1:.0f}"
    if kind in (LimitKind.SLOPE, LimitKind.BEND):
        return f"allow the curvature to change {100 * amount + 1:.0f} % faster"
    if kind == LimitKind.LENGTH:
        radius = design.car.drive_wheel_radius_mm or 0.0
        wheel = radius * (1 + amount / task.vehicle.most_length)
        return f"raise car.drive_wheel_radius_mm to {wheel + 0.01:.2f}"
    if kind == LimitKind.CORRIDOR:
        return f"allow {task.within + amount + 0.1:.1f} mm"
    if kind == LimitKind.HEADING:
        return f"raise {key}.heading_tolerance_deg by {degrees(amount) + 0.1:.1f}"
    if kind == LimitKind.GATE:
        return f"make {key} {amount + 0.1:.1f} mm wider to either side, or move it by that"
    if kind == LimitKind.FIELD:
        return f"make the field {amount + 0.1:.1f} mm larger there, or lower course.margin_mm by that"
    return f"move {key} by {amount + 0.1:.1f} mm, or lower course.margin_mm by that"
