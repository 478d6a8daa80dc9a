"""A planned cam as plain values, for the manifest and for machines: each value in the unit that its key names."""

from math import degrees, isfinite
from typing import Any

from cadgen.check import Check
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.cures import Cures


def cam_facts(plan: CamPlan, cures: Cures) -> dict[str, Any]:
    """Facts on a cam before its files."""
    return {
        **plan.origin.facts(),
        "profile": plan.kind.code,
        "passed": plan.passed,
        "checks": [_check_facts(check) for check in plan.figures],
        "cures": [
            {"override": cure.override, "now": cure.now, "then_fails": [check.name for check in cure.failing]}
            for cure in cures.proved
        ],
        "edge_break_mm": plan.blank.edge_break,
        "carrying_planes_mm": list(plan.follower_as_built.planes),
        "lift_extrema": _extrema_facts(plan),
        "profile_area_mm2": plan.area,
        **plan.application.facts(plan),
    }


def _check_facts(check: Check) -> dict[str, Any]:
    return {
        "code": check.code.value,
        "name": check.name,
        "value": _finite(check.value),
        "unit": check.unit,
        "bound": check.bound,
        "limit": _finite(check.limit),
        "place": check.place,
        "passed": check.passed,
        "advice": "" if check.passed else check.advice,
    }


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None


def _extrema_facts(plan: CamPlan) -> list[dict[str, Any]]:
    peaks, valleys = plan.motion.extrema()
    return [
        {
            "kind": kind,
            "cam_angle_deg": degrees(angle),
            "lift_mm": float(plan.follower_as_built.lift(plan.motion.q(angle))),
        }
        for kind, angles in (("peak", peaks), ("valley", valleys))
        for angle in angles
    ]
