"""A planned cam as facts, for the manifest and for machines: each value in the unit that its key names."""

from math import degrees

from cadgen.check import Check
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.cures import Cures


def cam_facts(plan: CamPlan, cures: Cures) -> Facts:
    """Facts on a cam before its files."""
    peaks, valleys = plan.motion.extrema()
    facts = Facts(
        profile=plan.kind.code,
        passed=plan.passed,
        verdict=plan.verdict.entry(),
        checks=[_check_facts(check) for check in plan.figures],
        cures=[
            Facts(override=cure.override, now=cure.now, then_fails=[check.name for check in cure.failing])
            for cure in cures.proved
        ],
        edge_break_mm=plan.blank.edge_break,
        carrying_planes_mm=plan.follower_as_built.planes,
        lift_extrema=[
            Facts(kind=kind, cam_angle_deg=degrees(angle), lift_mm=plan.follower_as_built.lift(plan.motion.q(angle)))
            for kind, angles in (("peak", peaks), ("valley", valleys))
            for angle in angles
        ],
        profile_area_mm2=plan.area,
    )
    if plan.second is not None:
        facts |= Facts(second_disc=Facts(stem=plan.second.stem, profile_area_mm2=plan.second.area))
    if plan.groove is not None:
        facts |= Facts(
            groove=Facts(
                width_mm=2 * plan.follower_as_built.radius,
                depth_mm=plan.groove.depth,
                outside_diameter_mm=2 * plan.groove.outside_radius,
                outer_flank_area_mm2=plan.groove.outer.area,
            )
        )
    return plan.origin.entry() | facts | plan.application.entry(plan)


def _check_facts(check: Check) -> Facts:
    return Facts(
        code=check.code.value,
        name=check.name,
        value=check.value,
        unit=check.unit,
        bound=check.bound,
        limit=check.limit,
        place=check.place,
        passed=check.passed,
        advice="" if check.passed else check.advice,
    )
