"""From a design with play to the profile that is best against it, with the reasons."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import degrees, inf, radians
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.build import cam_model, variation
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.check import Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.design.schema import Design
from cadgen.errors import CheckError, DesignError
from cadgen.motion.drive import Run, start_pose
from cadgen.motion.errors import run_error
from cadgen.motion.play import LEAST_SWING, Following, falls
from cadgen.optimize.band import Bound, PlayBand, over_band
from cadgen.optimize.choice import Candidate, Limit, choose
from cadgen.optimize.judge import PROFILES, Judged, Task, bound, judge, judge_measured
from cadgen.optimize.remedies import trims
from cadgen.path.track import Track
from cadgen.workflow.cam.mechanics import border_sentences, joint_sentences, mechanics_facts, rubbing_sentence

# What `--profile` may say about play: one method by name, or the best of all.
PLAY_PROFILES = (*PROFILES[1:], "optimized")
PAPER_PERCENT = 45.31  # what the paper's two methods together take off its sum of deflection errors
_ALWAYS, _SMOOTHED = ("actual", "compensated"), ("smoothed", "smoothed+compensated")
# An error before that is no greater than this is what rolling errs by: no share of it can be taken off. mm and rad.
_NO_DISTANCE, _NO_HEADING = 1.0, radians(0.01)
_LOSS = 0.01  # share of the error before that a file may give away
_LEAST_LOSS = 10.0  # mm; less is within what a start by hand is off

Checker = Callable[[Judged], Sequence[Check]]


@dataclass(frozen=True, kw_only=True)
class MeasuredCam:
    """The cam that was on the car when it was measured: its profile's name, its lift, and the curve it was cut to."""

    profile: str
    lift: LiftCurve
    curve: ClosedCurve


@dataclass(frozen=True, kw_only=True)
class Against:
    """A profile against play, beside the plain one.

    Attributes:
        task: what is wanted.
        band: return error of the design's train.
        before: the actual profile with the train as given; of a design as built, the cam as it was measured.
        chosen: the profile to be cut.
        judged: all that were compared, `before` and `chosen` among them.
        reasons: a sentence on each, if there was a choice.
        bound: what no fixed profile with the same peaks and valleys betters over the band, to first order, if the
            rod slides without friction.
        rubbing: what a rod that rubs would make of the profile, if the design says nothing of friction; a sentence.
    """

    task: Task
    band: PlayBand
    before: Judged
    chosen: Judged
    judged: tuple[Judged, ...]
    reasons: tuple[str, ...]
    bound: Bound
    rubbing: str

    def gain(self, one: Judged) -> tuple[float | None, float | None]:
        """Shares of heading and position error at the end that a profile takes off; None where there is hardly any.

        Both cars have the same play, that of `one`: what a train with less play saves is told by `worst_gain`.
        """
        error = run_error(self.run(self.before, one.play), self.task.planned())
        return (
            _off(one.error.end_heading, error.end_heading, _NO_HEADING),
            _off(one.error.end_distance, error.end_distance, _NO_DISTANCE),
        )

    def worst_gain(self, distance: float) -> float | None:
        """Share of the first profile's worst end position over its band that is off at a given one, mm."""
        return _off(distance, self.before.band.worst_distance, _NO_DISTANCE)

    def sum_gain(self, one: Judged) -> float | None:
        """Share of the first profile's sum of deflection errors that another takes off, on its own train."""
        return _off(one.deflection_sum, self.before.deflection_sum, _NO_HEADING)

    def loses(self, end_distance: float) -> bool:
        """Whether a file whose run ends so far off, mm, gives away what the profile is for.

        It does if it ends further off than the profile itself by more than 10 mm and one percent of the error before.
        """
        error = run_error(self.run(self.before, self.chosen.play), self.task.planned())
        return end_distance - self.chosen.error.end_distance > max(_LOSS * error.end_distance, _LEAST_LOSS)

    def run(self, one: Judged, play: float) -> Run:
        """The run on a profile with any play."""
        return self.task.run(one.rolled, play, least=one.least, cut=one.lift)

    def following(self, one: Judged, play: float) -> Following:
        """How the cam with a profile follows the motor with any play."""
        return self.task.following(one.rolled, play, least=one.least, cut=one.lift)

    def end_of(self, lift: LiftCurve, least: float = LEAST_SWING) -> tuple[float, float]:
        """Heading (rad) and position error (mm) at the end with the play it is cut for, of what a file gives."""
        run = self.task.run(lift, self.chosen.play, least=least, cut=self.chosen.lift)
        error = run_error(run, self.task.planned())
        return error.end_heading, error.end_distance

    def facts(self) -> dict[str, Any]:
        """Figures for the manifest and for machines."""
        low, high = self.band.ends
        return {
            "return_error_deg": {
                "least": degrees(low),
                "greatest": degrees(high),
                "measured": None if self.band.measured is None else degrees(self.band.measured),
                "cut_for": degrees(self.chosen.made_for),
            },
            "mechanics": mechanics_facts(self.task.mechanics, self.chosen.lift),
            "friction_note": self.rubbing,
            "before": _figures(self, self.before),
            "after": _figures(self, self.chosen),
            "compared": [_figures(self, one) for one in self.judged],
            "reasons": list(self.reasons),
            # For a rod that slides without friction.
            "bound_with_same_peaks_and_valleys": None
            if self.task.mechanics
            else {
                "worst_end_heading_deg": degrees(self.bound.heading),
                "worst_end_position_mm": self.bound.distance,
                "worst_position_percent_off": _percent(self.worst_gain(self.bound.distance)),
            },
            "paper_percent_off": PAPER_PERCENT,
        }


def _figures(against: Against, one: Judged) -> dict[str, Any]:
    heading, distance = against.gain(one)
    return {
        "profile": one.profile,
        "as_measured": one.measured,
        "train": one.train,
        "return_error_deg": degrees(one.play),
        "deflection_sum_deg": degrees(one.deflection_sum),
        "end_heading_deg": degrees(one.error.end_heading),
        "end_position_mm": one.error.end_distance,
        "heading_percent_off": _percent(heading),
        "position_percent_off": _percent(distance),
        "worst_end_heading_deg": degrees(one.band.worst_heading),
        "worst_end_position_mm": one.band.worst_distance,
        "worst_position_percent_off": _percent(against.worst_gain(one.band.worst_distance)),
        "greatest_position_on_run_mm": float(one.error.distance.max()),
        "end_position_without_play_mm": one.deviation.end_distance,
        "greatest_position_without_play_mm": float(one.deviation.distance.max()),
        "lift_error_um": one.worst_lift_error * 1e3,
    }


def _off(error: float, before: float, least: float) -> float | None:
    return 1 - abs(error / before) if abs(before) > least else None


def _percent(share: float | None) -> float | None:
    return None if share is None else 100 * share


def task_of(design: Design, track: Track, lift: LiftCurve, rod: Follower) -> Task:
    """What the methods against play work on."""
    return Task(
        lift=lift,
        follower=rod,
        car=cam_model.car(design),
        length=cam_model.travel(design, track),
        aim=design.optimize.smoothing_percent / 100,
        start=start_pose(track),
        as_built=cam_model.as_built(design),
        mechanics=variation.mechanics(design, rod, lift),
    )


def known_trains(design: Design) -> dict[str, PlayBand]:
    """The return errors of the design's train as given and, if its gears are known, reordered.

    Raises:
        DesignError: the design says nothing about play.
    """
    bands = variation.play_bands(design)
    if not bands:
        raise DesignError(
            "the design says nothing of the gears' play, which this needs: add [train] with the gears, or [play] with "
            "measured_deg or least_deg and greatest_deg; --profile actual makes the cam without"
        )
    return bands


def against_play(
    design: Design,
    profile: str,
    task: Task,
    check: Checker,
    *,
    all_trains: bool = False,
    measured: MeasuredCam | None = None,
) -> Against:
    """One method, or with `optimized` the best of all that keep the design's limits and the cam's checks.

    If none passes the checks, `optimized` is what it would be without them, for its own checks to tell. Limits and
    choice go by the worst end over the band, or, if the play was measured, by the end with that play.

    Args:
        design: a loaded design.
        profile: `actual` or one of `PLAY_PROFILES`.
        task: what is wanted.
        check: the checks of a profile.
        all_trains: compare the methods on the trains that the design does not use, too.
        measured: the cam to compare with on a car as built; the actual profile if left out.

    Raises:
        DesignError: no play is known.
        CheckError: no profile keeps the limits of [optimize]; says whether one would with the stages in another order.
    """
    bands = known_trains(design)
    own = design.optimize.order
    first = next(iter(bands))
    found: dict[str, tuple[Judged, ...]] = {}
    reasons: list[str] = []
    for name, band in bands.items():
        if name == own or all_trains:
            found[name] = _judged(task, profile, name, band, reasons)
        elif name == first and measured is None:
            found[name] = judge(task, name, band, PROFILES[:1])
    chosen = found[own][-1]
    if profile == "optimized":
        try:
            chosen, choice = _best(design, task, found[own], bands[own], check)
        except CheckError as error:
            others = {name: band for name, band in bands.items() if name != own}
            other = _other_order(design, task, others, check)
            raise CheckError(f"{error}{other}{_with_friction(design, task)}") from error
        reasons += choice
    reasons += _lost_sentences(task, chosen)
    reasons += joint_sentences(design)
    reasons += border_sentences(design, task, chosen, bands[own])
    judged = tuple(one for several in found.values() for one in several)
    before = judged[0]
    if measured is not None:
        before = judge_measured(task, measured.profile, own, bands[own], measured.lift, measured.curve)
        judged = (before, *judged)
    return Against(
        task=task,
        band=bands[own],
        before=before,
        chosen=chosen,
        judged=judged,
        reasons=tuple(reasons),
        bound=bound(task, bands[own]),
        rubbing="" if task.mechanics else rubbing_sentence(task, bands[own], chosen, before),
    )


def _judged(task: Task, profile: str, train: str, band: PlayBand, reasons: list[str]) -> tuple[Judged, ...]:
    """The actual profile and one other, or with `optimized` all that can be made; tells why another cannot."""
    blend = task.lift.blend_start
    if profile == "optimized" and not (falls(task.lift) % TURN < blend).any():
        reasons.append(
            f"the lift has no peak and no valley before its closing blend at {degrees(blend):.1f}°, so play changes "
            f"nothing: the actual profile is made"
        )
        return judge(task, train, band, PROFILES[:1])
    if profile != "optimized":
        return judge(task, train, band, tuple(dict.fromkeys((PROFILES[0], profile))))
    judged = judge(task, train, band, _ALWAYS)
    try:
        return (*judged, *judge(task, train, band, _SMOOTHED, made_for=judged[0].made_for))
    except DesignError as error:
        reasons.append(f"smoothed refused: {error}")
        return judged


def _lost_sentences(task: Task, one: Judged) -> list[str]:
    """What a profile cannot give back because events are closer together than the play, in words."""
    if not one.lost:
        return []
    worst = max(one.lost, key=lambda dip: dip.tan_beta)
    missed = worst.tan_beta * task.follower.outer
    return [
        f"{len(one.lost)} of the lift's dips {'is' if len(one.lost) == 1 else 'are'} narrower than the return error of "
        f"{degrees(one.made_for):.3f}° and cannot be driven: the rod misses at most {missed:.3g} mm of "
        f"lift there, at cam angle {degrees(worst.cam_angle):.2f}°"
    ]


def _with_friction(design: Design, task: Task) -> str:
    """What helps where friction keeps every profile from its limit, in words."""
    known = task.mechanics
    if known is None or known.friction[1] == 0 or "drag" in (design.optimize.hardware or ()):
        return ""
    return (
        "; with friction no profile gives the lift wanted on each fall, but a brake on the disc does: --set "
        "'optimize.hardware=[\"drag\"]', or remove optimize.max_lift_error_um to see what else helps in cadgen optimize"
    )


def _other_order(design: Design, task: Task, bands: dict[str, PlayBand], check: Checker) -> str:
    """What another order of the train's stages would do, in words, if it keeps the limits and the checks."""
    for name, band in bands.items():
        try:
            best, _ = _best(design, task, _judged(task, "optimized", name, band, []), band, check)
        except (DesignError, CheckError):
            continue
        if all(one.passed for one in check(best)):
            return (
                f", or set the stages in the order {name}, with which {best.profile} keeps them all: "
                f"--set optimize.order={name}"
            )
    return ""


def decides(band: PlayBand) -> str:
    """Name of the figure that the choice goes by: with a measured play other cars do not matter."""
    return "worst end position error" if band.measured is None else "position error at the end with the measured play"


def limits(design: Design, band: PlayBand) -> tuple[Limit, ...]:
    """What [optimize] allows."""
    given = design.optimize
    found = (
        (decides(band), given.max_end_position_mm, "mm"),
        (_heading(band), given.max_end_heading_deg, "degrees"),
        ("position error on the run", given.max_run_position_mm, "mm"),
        ("lift error with play", given.max_lift_error_um, "µm"),
    )
    return tuple(Limit(figure=name, most=most, unit=unit) for name, most, unit in found if most is not None)


def _heading(band: PlayBand) -> str:
    return decides(band).replace("position", "heading")


def lift_check(design: Design, one: Judged) -> Check:
    """The lift that the rod gets with play against the lift wanted, as a check of the cam."""
    most = design.optimize.max_lift_error_um
    where = float(one.run.motor[np.argmax(np.abs(one.lift_error))])
    return Check(
        CheckCode.LIFT_ERROR_WITH_PLAY,
        "lift error with play",
        one.worst_lift_error * 1e3,
        "µm",
        inf if most is None else most,
        "max",
        f"motor {degrees(where):.2f}° (play {degrees(one.play):.3f}°)",
        "the profile leaves the planned path: use --profile compensated, or raise optimize.max_lift_error_um",
    )


def _best(
    design: Design, task: Task, judged: Sequence[Judged], band: PlayBand, check: Checker
) -> tuple[Judged, tuple[str, ...]]:
    """The best that also passes its checks; profiles are checked in order of merit, for checks take time."""
    allowed, least = limits(design, band), decides(band)
    remaining = {one.profile: one for one in judged}
    candidates = {one.profile: Candidate(name=one.profile, figures=_limited(design, task, one, band)) for one in judged}
    refused: list[str] = []
    first = choose(list(candidates.values()), allowed, least=least).best.name
    while remaining:
        try:
            choice = choose([candidates[name] for name in remaining], allowed, least=least)
        except CheckError as error:  # those left were never allowed
            refused.append(f"of the others, {error}")
            break
        best = remaining.pop(choice.best.name)
        failed = [one.name for one in check(best) if not one.passed]
        if not failed:
            return best, (*refused, *choice.reasons)
        refused.append(f"{best.profile} refused: it fails {', '.join(failed)}")
    return next(one for one in judged if one.profile == first), tuple(refused)


def _limited(design: Design, task: Task, one: Judged, band: PlayBand) -> dict[str, float]:
    """Errors of a profile by the names of their limits in [optimize]; after the trim, if the design allows one."""
    heading, distance = one.band.worst_heading, one.band.worst_distance
    if band.measured is not None and task.mechanics is None:
        heading, distance = abs(one.error.end_heading), one.error.end_distance
    elif band.measured is not None and task.mechanics is not None:
        at_play = over_band(
            one.rolled,
            task.lift,
            task.car,
            task.length,
            np.array([band.measured]),
            least=one.least,
            mechanics=task.mechanics.cases,
            cut=one.lift,
        )
        heading, distance = at_play.worst_heading, at_play.worst_distance
    if task.mechanics and "trim" in (design.optimize.hardware or ()):
        plays = band.ends if band.measured is None else (band.measured,)
        trimmed = [trim.error for trim in trims(task, one.rolled, one.lift, plays, task.mechanics.cases)]
        heading = max(abs(error.end_heading) for error in trimmed)
        distance = max(error.end_distance for error in trimmed)
    return {
        decides(band): distance,
        _heading(band): degrees(heading),
        "position error on the run": float(one.error.distance.max()),
        "lift error with play": one.worst_lift_error * 1e3,
    }
