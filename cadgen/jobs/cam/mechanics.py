"""Effect of friction and drag on a cam, in checks and in words."""

from math import degrees, inf

import numpy as np

from cadgen.cam.follower import Follower, edge_follower
from cadgen.car.against_play.band import PlayBand, over_band
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.against_play.remedies import holding, touched_width
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.friction import USUAL
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.car.running.run_errors import run_error
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import variation
from cadgen.design.play import Hardware
from cadgen.design.schema import Design
from cadgen.design.section import listed

_FRICTION_STEP = 0.01
_STEEP = 20.0  # mm at the end of the run for that step: friction decides more than anything that is cut
_SHOWN = 1.0  # mm; less at the end is not worth a sentence


def rubbing_sentence(task: PlayTask, band: PlayBand, chosen: Evaluation, plain: Evaluation) -> str:
    """Effect of friction on a cam that was computed without it, in words; empty if friction changes nothing."""
    usual = MechanicsBand(follower=task.follower, friction=USUAL).cases
    plays = np.array(band.ends if band.measured is None else [band.measured])
    worst = [
        over_band(
            evaluation.rolled,
            task.lift,
            task.car,
            task.length,
            plays,
            least_swing=evaluation.least_swing,
            mechanics=usual,
            cut=evaluation.lift,
        ).worst_distance
        for evaluation in (chosen, plain)
    ]
    if max(worst) < _SHOWN:
        return ""
    low, high = USUAL
    beside = "" if chosen.profile == plain.profile else f"; the {plain.title} would end up to {worst[1]:.0f} mm off"
    return (
        f"Reckoned as if the rod slid without friction, which only a ball bearing does. With a rod that rubs (friction "
        f"{low:g} to {high:g}) and these plays the car would end up to {worst[0]:.0f} mm off{beside}. Say in "
        f"[mechanics] what the car has, and cadgen optimize compares what helps."
    )


def mechanics_checks(
    design: Design, follower: Follower, lift: PathMotion, band: MechanicsBand | None
) -> tuple[Check, ...]:
    """Checks of the torque by which the cam runs ahead, of the drag that holds it, and of a bearing's width.

    Args:
        design: loaded design.
        follower: follower of the design.
        lift: lift that the cam is cut for.
        band: range of friction and drag; None if the design has no [mechanics].
    """
    checks: list[Check] = []
    if band is not None:
        need = holding(lift, band)
        ahead = max(need.with_friction - band.drag[0], 0.0)
        place = f"cam angle {degrees(need.cam_angle):.1f}°"
        checks.append(Check(CheckCode.CAM_RUNS_AHEAD, "cam runs ahead", ahead, "N·mm", inf, Bound.MAX, place))
        if band.drag[1] > 0 and need.torque > 0:
            # A figure, not a verdict: 1 and more holds.
            margin = 0.0 if band.behind > 0 else band.drag[0] / need.torque
            where = f"times what is needed, {need.torque:.3g} N·mm without friction"
            if band.behind > 0:
                where = f"nothing holds the disc's {degrees(band.behind):.3f}° of play on its shaft"
            checks.append(Check(CheckCode.CAM_HOLDS, "cam holds", margin, "", -inf, Bound.MIN, where))
    width = design.follower.bearing_width
    if width is not None:
        checks.append(
            Check(
                CheckCode.BEARING_WIDTH,
                "bearing width",
                touched_width(lift, edge_follower(follower, "the width of a bearing")),
                "mm",
                width,
                Bound.MAX,
                "length that touches the disc in a turn",
                "the bearing leaves the disc: take a wider one, or two side by side, and set follower.width_mm",
            )
        )
    return tuple(checks)


def joint_sentences(design: Design) -> list[str]:
    """Return error that joints and bearings add to that of the teeth, and the cheapest cure, in words."""
    whole = variation.whole_play(design)
    if whole is None or not whole.loose or design.play is not None:
        return []
    added = sum(joint.greatest for joint in whole.loose)
    parts = listed([f"{joint.name} {degrees(joint.greatest):.3f}°" for joint in whole.loose], "and")
    teeth = "" if whole.teeth is None else f" to the teeth's {degrees(whole.teeth.return_error_max):.3f}°"
    return [
        f"Joints and bearings add up to {degrees(added):.3f}°{teeth}: {parts}.",
        f"Cheapest cure: {whole.sentence()}.",
    ]


def border_sentences(design: Design, task: PlayTask, chosen: Evaluation, band: PlayBand) -> list[str]:
    """Advice besides the cam, and warnings where the cam may be held in one run and lead in the next, in words."""
    known, keys = task.mechanics, design.mechanics
    if known is None:
        return []
    lines = []
    need = holding(chosen.lift, known)
    if known.drag[0] > (0.0 if keys is None else keys.drag_Nmm[0]):
        lines.append(
            f"Build: a brake on the disc itself with a drag of {known.drag[0]:.3g} N·mm, a quarter more than the cam's "
            f"{need.torque:.3g} N·mm at {degrees(need.cam_angle):.1f}°, for a rod force of {known.rod_force:g} N; it "
            f"takes {need.energy:.2g} J a turn. The cam is made for that."
        )
    if Hardware.TRIM in (design.optimize.hardware or ()):
        lines.append(
            "Do: after a trial run set the micrometer of the base radius so that the end is met; the choice goes by "
            "the ends after that trim, the figures in the table are before it."
        )
    weak, strong = known.at(known.friction[0], known.drag[0]), known.at(known.friction[1], known.drag[1])
    held = [not len(case.leads(chosen.lift).intervals) for case in (weak, strong)]
    if held == [False, True]:
        lines.append(
            "Warning: the cam leads its gears at the least friction and drag and is held at the greatest, which is the "
            "worst place to be: it may do either from run to run."
        )
    if held == [True, True] and known.drag[0] < need.torque:
        lines.append(
            "Warning: friction alone holds the cam on its gears, and oil or shaking undoes that: only drag is to be "
            "counted on."
        )
    if known.drag[0] > 0 and known.drag[0] < need.torque:
        lines.append(
            f"Warning: the drag of {known.drag[0]:.3g} N·mm does not hold the cam, which needs {need.torque:.3g} N·mm "
            f"at {degrees(need.cam_angle):.1f}°, and less is no half cure."
        )
    if known.behind > 0 and known.drag[1] > 0:
        lines.append(
            f"Warning: the drag acts on the shaft, and the disc has {degrees(known.behind):.3f}° of play on it that no "
            f"drag holds: brake the disc itself, or take that play out."
        )
    play = sum(band.ends) / 2 if band.measured is None else band.measured
    frictions = np.arange(known.friction[0], known.friction[1] + _FRICTION_STEP, _FRICTION_STEP)
    if len(frictions) > 2:
        planned = task.planned()
        ends = []
        for friction in frictions.tolist():
            case = known.at(friction, sum(known.drag) / 2)
            run = task.run(chosen.rolled, play, least_swing=chosen.least_swing, cut=chosen.lift, mechanics=case)
            error = run_error(run, planned)
            ends.append(complex(error.along[-1], error.across[-1]))
        moved = np.abs(np.diff(ends))
        steep = int(np.argmax(moved))
        if moved[steep] > _STEEP:
            lines.append(
                f"Warning: near a friction of {frictions[steep]:.2f} a change by {_FRICTION_STEP:g} moves the end of "
                f"the run by {moved[steep]:.0f} mm."
            )
    return lines
