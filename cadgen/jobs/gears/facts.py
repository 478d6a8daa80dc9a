"""A planned gear train as plain values for the manifest, the table of parts and machines: µm, mm and degrees."""

from collections.abc import Iterable
from dataclasses import asdict
from math import degrees
from typing import Any

from cadgen.check import Check
from cadgen.gears.distribution import quantiles
from cadgen.gears.layout import TrainLayout
from cadgen.gears.train import TrainPlay, WholePlay, teeth_of
from cadgen.jobs.gears.plan import GearsPlan


def plan_facts(plan: GearsPlan) -> dict[str, Any]:
    """Facts on a train before its files."""
    return {
        "design": plan.design.name,
        "source": plan.design.source,
        "overrides": list(plan.design.overrides),
        "design_sha256": plan.design.content_hash,
        "order": plan.order,
        "passed": plan.passed,
        "ratio": str(plan.play.train.ratio),
        "return_error_deg": {
            **return_error(plan.play),
            **quantiles(plan.play.return_error_distribution(), degrees(1)),
        },
        **_joint_facts(plan),
        "return_error_as_given_deg": return_error(plan.designed),
        "return_error_as_given_by_the_standard_deg": _maybe(plan.designed_standard),
        "return_error_by_the_standard_deg": _maybe(plan.standard),
        "notes": list(plan.notes),
        "stages": stages_facts(plan.layout),
        "ranked": [
            {
                "teeth": teeth_of(play),
                "modules_mm": [stage.module for stage in play.train.stages],
                "widths_mm": [[wheel.width for wheel in stage.wheels] for stage in play.train.stages],
                **return_error(play),
            }
            for play in plan.ranked
        ],
        "skipped": [
            {
                "teeth": teeth_of(skipped.play),
                "greatest": degrees(skipped.play.return_error_max),
                "reason": skipped.reason,
            }
            for skipped in plan.skipped
        ],
        "overridden_tolerances": [
            {
                "where": departure.where,
                "symbol": departure.symbol,
                "used_um": departure.used * 1e3,
                "standard_um": None if departure.standard is None else departure.standard * 1e3,
            }
            for departure in plan.departures
        ],
        "checks": checks_facts(plan.checks),
        "parts": parts_facts(plan.layout),
    }


def stages_facts(layout: TrainLayout) -> list[dict[str, Any]]:
    """Every stage as it is cut, with its play."""
    return [stage.facts() for stage in layout.train.stages]


def checks_facts(checks: Iterable[Check]) -> list[dict[str, Any]]:
    """Every check with its verdict."""
    return [{**asdict(check), "passed": check.passed} for check in checks]


def parts_facts(layout: TrainLayout) -> list[dict[str, Any]]:
    """Every part at its place, with what the shop is told of its wheels.

    A stage's driver sits on the shaft of its number, the driven wheel on the next.
    """
    wheels = [stage.wheel_facts() for stage in layout.train.stages]
    return [
        {
            "name": part.name,
            "shaft": part.shaft,
            "axis_mm": [part.axis.real, part.axis.imag],
            "height_mm": part.height,
            "angle_deg": degrees(part.angle),
            "turned_over": part.flipped,
            "bore_mm": part.blank.bore_diameter,
            "volume_mm3": part.volume,
            "gears": [{"stage": stage, **wheels[stage - 1][part.shaft > stage]} for stage in part.stages],
        }
        for part in layout.parts
    ]


def _joint_facts(plan: GearsPlan) -> dict[str, Any]:
    """Facts on joints and bearings, and the return error with them; empty if the design has none."""
    whole = plan.whole
    if not whole.loose:
        return {}
    return {
        "return_error_with_joints_deg": return_error(whole),
        "joints_deg": [
            {"name": joint.name, "least": degrees(joint.least), "greatest": degrees(joint.greatest)}
            for joint in whole.loose
        ],
    }


def return_error(play: TrainPlay | WholePlay) -> dict[str, float]:
    """Least, mean and greatest return error of a train and its standard deviation, in degrees."""
    spread = play.return_error_distribution()
    return {
        "least": degrees(play.return_error_min),
        "mean": degrees(spread.mean),
        "greatest": degrees(play.return_error_max),
        "std": degrees(spread.std),
    }


def _maybe(play: TrainPlay | None) -> dict[str, float] | None:
    return None if play is None else return_error(play)
