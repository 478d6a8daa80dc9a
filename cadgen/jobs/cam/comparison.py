"""Profiles against play, compared, checked and chosen by the limits of [optimize], with the reasons."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import ceil, degrees, inf, isfinite, radians

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import check_cam
from cadgen.cam.follower import Follower, edge_follower
from cadgen.car.against_play.band import EndBound, PlayBand, over_band
from cadgen.car.against_play.evaluate import (
    Evaluation,
    FigureLimit,
    ProfileCandidate,
    choose,
    evaluate,
    evaluate_measured,
    nearest,
)
from cadgen.car.against_play.play_task import PlayTask, TrainTask
from cadgen.car.against_play.profile_kinds import ACTUAL, ProfileKind, compared
from cadgen.car.against_play.remedies import trims
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.drive import Run, start_pose
from cadgen.car.running.play import LEAST_SWING, Following, falls
from cadgen.car.running.run_errors import RunError, run_error
from cadgen.check import Bound, Check, CheckCode, failing
from cadgen.curves.closed import ClosedCurve
from cadgen.design import cam_model, variation
from cadgen.design.play import Hardware
from cadgen.design.schema import Design
from cadgen.errors import CheckError, DesignError
from cadgen.figures import Figure, Figures
from cadgen.gears.choices import StageOrder
from cadgen.jobs.cam.mechanics import border_sentences, joint_sentences, mechanics_checks, rubbing
from cadgen.jobs.cam.path_check import lost_lift_check
from cadgen.messages import Message, joined
from cadgen.progress import Progress, silent

PAPER_PERCENT = 45.31  # reduction of the sum of deflection errors by the paper's two methods together
# An error before that is no greater than this is within the error of rolling: no share of it can be taken off; mm, rad.
_NO_DISTANCE, _NO_HEADING = 1.0, radians(0.01)
_LOSS = 0.01  # share of the error before that a file may give away
_LEAST_LOSS = 10.0  # mm; less is within what a start by hand is off
NEARER = 0.5  # share of the end error with a profile below which one that was refused would serve where it does not


@dataclass(frozen=True)
class Refused:
    """Profile that is refused for checks of the cam, though it ends much nearer than the one that keeps them all.

    Attributes:
        evaluation: the profile.
        failed: checks that it fails.
    """

    evaluation: Evaluation
    failed: tuple[Check, ...]

    @property
    def names(self) -> Message:
        """Names of the checks that it fails."""
        return joined(Message(check.name) for check in self.failed)


@dataclass(frozen=True, kw_only=True)
class MeasuredCam:
    """Cam that was on the car when the car was measured: its profile, its lift, and the curve that was cut, mm."""

    profile: ProfileKind
    lift: PathMotion
    curve: ClosedCurve


@dataclass(frozen=True, kw_only=True)
class PlayComparison:
    """A profile against play, beside the plain profile.

    Attributes:
        task: lift wanted, car and follower.
        band: return error of the design's train, rad.
        before: the actual profile with the train as given; of a design as built, the cam as it was measured.
        chosen: the profile to be cut.
        evaluations: all profiles that were compared, `before` and `chosen` among them.
        reasons: sentences on the choice, one for each profile.
        bound: lower bound of the worst end over the band, to first order, for profiles with the same peaks and valleys
            if the rod slides without friction.
        rubbing: effect of friction on the run, a sentence; empty if the design has friction or it changes nothing.
        rubs: worst end of the run with that friction, mm.
        beyond: failed checks of the limits of [optimize], where no profile keeps them all.
        nearer: profile that was refused though it ends much nearer than `chosen`; None if there is none.
        taken_for: advice on checks that `chosen` fails, where it was taken for a profile that keeps them and loses the
            car; empty if it was not.
    """

    task: PlayTask
    band: PlayBand
    before: Evaluation
    chosen: Evaluation
    evaluations: tuple[Evaluation, ...]
    reasons: tuple[str, ...]
    bound: EndBound
    rubbing: str
    rubs: float = 0.0
    beyond: tuple[Check, ...] = ()
    nearer: Refused | None = None
    taken_for: str = ""

    def checked(self, checks: Sequence[Check]) -> tuple[Check, ...]:
        """Checks of the chosen profile, with the limits of [optimize] that it exceeds as the nearest of all.

        Args:
            checks: checks of the profile itself.
        """
        codes = [check.code for check in self.beyond]
        kept = [check for check in checks if check.code not in codes]
        if self.taken_for:
            failed = failing(kept)
            kept = [
                replace(check, advice=joined((check.advice, self.taken_for), "; ")) if check in failed else check
                for check in kept
            ]
        return (*kept, *self.beyond)

    def with_nearer(self, failed: Sequence[Check]) -> "PlayComparison":
        """Comparison with the profile that was refused though it ends nearer, because the one chosen loses the car.

        Args:
            failed: checks that the car fails with the profile chosen.
        """
        assert self.nearer is not None
        nearer, kept = self.nearer.evaluation, self.chosen
        names = joined(dict.fromkeys(check.name for check in failed))
        reason = Message(
            "{nearest} taken in the end, though it fails {refused}: with {kept} the car fails {failed}",
            nearest=Message(str(nearer.profile)),
            refused=self.nearer.names,
            kept=Message(str(kept.profile)),
            failed=names,
        )
        other = Message(
            "the {kept} keeps that, but ends {off:.0f} mm off at most, and fails {failed}",
            kept=kept.title,
            off=kept.band.worst_distance,
            failed=names,
        )
        return replace(self, chosen=nearer, nearer=None, taken_for=other, reasons=(*self.reasons, reason))

    def gain(self, evaluation: Evaluation) -> tuple[float | None, float | None]:
        """Shares of heading and position error at the end that a profile takes off; None where there is hardly any.

        Both cars have the same play, that of `evaluation`; `worst_gain` is for a train with less play.
        """
        error = run_error(self.run(self.before, evaluation.play), self.task.planned())
        return (
            _off(evaluation.error.end_heading, error.end_heading, _NO_HEADING),
            _off(evaluation.error.end_distance, error.end_distance, _NO_DISTANCE),
        )

    def worst_gain(self, distance: float) -> float | None:
        """Share by which a worst end position error `distance` (mm) is below that of `before` over its band.

        Args:
            distance: distance, mm.
        """
        return _off(distance, self.before.band.worst_distance, _NO_DISTANCE)

    def sum_gain(self, evaluation: Evaluation) -> float | None:
        """Share by which a profile's sum of deflection errors, on its own train, is below that of `before`."""
        return _off(evaluation.deflection_sum, self.before.deflection_sum, _NO_HEADING)

    def figures(self, evaluation: Evaluation) -> Figures:
        """Errors of a profile and what it takes off, as they are shown.

        Args:
            evaluation: profile that was compared.
        """
        e, band, at = evaluation, evaluation.band, evaluation.error.judged_at
        heading, distance = self.gain(e)
        return Figures(
            Figure("return_error", Message("return error"), degrees(e.play), "°"),
            Figure("deflection_sum", Message("sum of deflection errors"), degrees(e.deflection_sum), "°"),
            e.error.figures["end_heading"],
            *e.error.end_figures.values(),
            Figure("heading_percent_off", Message("heading taken off"), _percent(heading), "%"),
            Figure("position_percent_off", Message("taken off"), _percent(distance), "%"),
            Figure("worst_end_heading", Message("worst heading over the band"), degrees(band.worst_heading), "°"),
            Figure(f"worst_{at}_position", Message("worst position over the band"), band.worst_distance, "mm"),
            Figure(
                "worst_position_percent_off",
                Message("worst position taken off"),
                _percent(self.worst_gain(band.worst_distance)),
                "%",
            ),
            Figure("greatest_position_on_run", Message("greatest on the run"), float(e.error.distance.max()), "mm"),
            Figure(f"{at}_position_without_play", Message("position without play"), e.deviation.end_distance, "mm"),
            Figure(
                "greatest_position_without_play",
                Message("greatest without play"),
                float(e.deviation.distance.max()),
                "mm",
            ),
            Figure("lift_error", Message("lift error with play"), e.worst_lift_error * 1e3, "µm"),
        )

    def loses(self, end_distance: float) -> bool:
        """Whether a file whose run ends `end_distance` (mm) off gives away the gain of the profile.

        It does if its run ends further off than the profile's by more than 10 mm and one percent of the error before.

        Args:
            end_distance: distance of the end of the run from the planned one, mm.
        """
        error = run_error(self.run(self.before, self.chosen.play), self.task.planned())
        return end_distance - self.chosen.error.end_distance > max(_LOSS * error.end_distance, _LEAST_LOSS)

    def run(self, evaluation: Evaluation, play: float) -> Run:
        """Run on a profile with any play, rad.

        Args:
            evaluation: profile that was compared.
            play: return error, rad.
        """
        return self.task.run(evaluation.rolled, play, least_swing=evaluation.least_swing, cut=evaluation.lift)

    def following(self, evaluation: Evaluation, play: float) -> Following:
        """Motion of the cam with a profile that follows the motor with any play, rad.

        Args:
            evaluation: profile that was compared.
            play: return error, rad.
        """
        return self.task.following(evaluation.rolled, play, least_swing=evaluation.least_swing, cut=evaluation.lift)

    def error_of(self, lift: PathMotion, least_swing: float = LEAST_SWING) -> RunError:
        """Errors of the run with the play of `chosen` on the lift of a file.

        Args:
            lift: lift that the follower gets.
            least_swing: smallest rise or fall of tan(beta) that counts as an event.
        """
        run = self.task.run(lift, self.chosen.play, least_swing=least_swing, cut=self.chosen.lift)
        return run_error(run, self.task.planned())


def _percent(share: float | None) -> float | None:
    return None if share is None else 100 * share


def _off(error: float, before: float, smallest: float) -> float | None:
    return 1 - abs(error / before) if abs(before) > smallest else None


def task_of(design: Design, track: Track, lift: PathMotion, follower: Follower) -> PlayTask:
    """Task of a profile against play, for a design and its track.

    Raises:
        DesignError: the follower is not the leaning rod.
    """
    rod = edge_follower(follower, Message("what the play of the gears does to a cam"), Message("take --profile actual"))
    return PlayTask(
        lift=lift,
        follower=rod,
        car=cam_model.car(design),
        length=cam_model.travel(design, track),
        aim=design.optimize.smoothing_percent / 100,
        start=start_pose(track),
        as_built=cam_model.as_built(design),
        mechanics=variation.mechanics(design, rod, lift),
        trimmed=variation.trimmed(design),
    )


def known_trains(design: Design) -> dict[StageOrder, PlayBand]:
    """Return errors of the design's train as given and, if its gears are known, reordered.

    Raises:
        DesignError: the design has no play.
    """
    bands = variation.play_bands(design)
    if not bands:
        raise DesignError(
            "the design says nothing of the gears' play, which this needs: add [train] with the gears, or [play] with "
            "measured_deg or least_deg and greatest_deg; --profile actual makes the cam without"
        )
    return bands


@dataclass(frozen=True)
class ProfileChecks:
    """Checks of the profiles of one design; they take time, so they are computed once for a profile on a train.

    Attributes:
        design: loaded design.
        task: lift wanted, car and follower of the design.
    """

    design: Design
    task: PlayTask
    _computed: dict[str, tuple[Check, ...]] = field(default_factory=dict, repr=False)
    _allowed: list[float] = field(default_factory=list, repr=False)

    def allow_lift_error(self, most: float) -> None:
        """Let profiles miss the lift with play by so much, instead of by what the design says.

        Args:
            most: greatest lift error, um.
        """
        self._allowed[:] = [most]
        self._computed.clear()

    def of(self, evaluation: Evaluation) -> tuple[Check, ...]:
        """Every check of a profile."""
        if evaluation.name not in self._computed:
            self._computed[evaluation.name] = self._compute(evaluation)
        return self._computed[evaluation.name]

    def _compute(self, evaluation: Evaluation) -> tuple[Check, ...]:
        design, wanted = self.design, evaluation.wanted
        rod, blank, limits = cam_model.follower(design), cam_model.blank(design), cam_model.check_limits(design)
        return (
            *check_cam(
                evaluation.lift,
                rod,
                wanted.curve,
                wanted.trims,
                blank,
                limits,
                cut=evaluation.cut,
                application=blend_checks,
            ),
            lost_lift_check(design, evaluation.run_without_loss(self.task), evaluation.run),
            _lift_check(evaluation, (*self._allowed, design.optimize.max_lift_error_um)[0]),
            *mechanics_checks(design, rod, evaluation.lift, self.task.mechanics),
        )


def _lift_check(evaluation: Evaluation, most: float | None) -> Check:
    """Check of the lift that the follower gets with play against the lift wanted; `most` in um, None for any."""
    where = float(evaluation.run.motor[np.argmax(np.abs(evaluation.lift_error))])
    return Check(
        CheckCode.LIFT_ERROR_WITH_PLAY,
        LIFT_ERROR,
        evaluation.worst_lift_error * 1e3,
        "µm",
        inf if most is None else most,
        Bound.MAX,
        Message("motor {motor:.2f}° (play {play:.3f}°)", motor=degrees(where), play=degrees(evaluation.play)),
        Message("the profile leaves the planned path: use --profile compensated, or raise optimize.max_lift_error_um"),
    )


LIFT_ERROR = Message("lift error with play")
_RUN_ERROR = Message("position error on the run")


@dataclass(frozen=True)
class Best:
    """Profile chosen on a train, and a sentence on each profile compared.

    Attributes:
        evaluation: profile that is chosen.
        reasons: sentences.
        beyond: failed checks of the limits of [optimize], where no profile keeps them all.
        nearer: profile that was refused though it ends much nearer; None if there is none.
    """

    evaluation: Evaluation
    reasons: tuple[str, ...]
    beyond: tuple[Check, ...] = ()
    nearer: Refused | None = None


def best_of(
    evaluations: Sequence[Evaluation], band: PlayBand, checks: ProfileChecks, old: Evaluation | None = None
) -> Best:
    """Best profile that keeps the limits and passes its checks; profiles are checked in order of merit.

    Args:
        evaluations: profiles evaluated on one train, at least one.
        band: return error of that train, rad.
        checks: checks of the design's profiles.
        old: cam that the car has, on the same train: where that misses the lift by more than is allowed, no new one is
            refused for missing it by less. None without.

    Returns:
        If no profile passes its checks, the best without them, so that its own checks show what fails. If none keeps
        the limits of [optimize], the nearest, with a failed check for each limit that it exceeds.
    """
    trimmed = checks.task.trimmed and checks.task.mechanics is not None
    allowed, deciding = _limits(checks.design, band, trimmed=trimmed), _deciding(band, trimmed=trimmed)
    missed: tuple[str, ...] = ()
    if old is not None:
        allowed, missed = _lifted(allowed, old, evaluations)
        for limit in allowed if missed else ():
            if limit.figure == LIFT_ERROR:
                checks.allow_lift_error(limit.most)
    remaining = {str(evaluation.profile): evaluation for evaluation in evaluations}
    candidates = {
        name: ProfileCandidate(name=name, figures=_figures(checks, evaluation, band))
        for name, evaluation in remaining.items()
    }
    try:
        first = remaining[choose(list(candidates.values()), allowed, objective=deciding, unit="mm").best.name]
    except CheckError as error:
        near, _ = nearest(list(candidates.values()), allowed)
        beyond = tuple(_exceeded(limit, near) for limit in allowed if not limit.kept_by(near))
        return Best(remaining[near.name], (error.message, *missed), beyond)
    refused: list[str] = []
    nearer: Refused | None = None
    while remaining:
        try:
            choice = choose([candidates[name] for name in remaining], allowed, objective=deciding, unit="mm")
        except CheckError as error:  # those left were never allowed
            refused.append(Message("of the others, {reason}", reason=error.message))
            break
        best = remaining.pop(choice.best.name)
        failed = failing(checks.of(best))
        if not failed:
            least, off = (candidates[str(each.profile)].figures[deciding] for each in (first, best))
            much = off - least > _LEAST_LOSS and least < NEARER * off
            return Best(best, (*refused, *choice.reasons, *missed), nearer=nearer if much else None)
        nearer = nearer or Refused(best, failed)
        refused.append(
            Message(
                "{profile} refused: it fails {failed}",
                profile=Message(str(best.profile)),
                failed=Refused(best, failed).names,
            )
        )
    return Best(first, (*refused, *missed))


def _exceeded(limit: FigureLimit, near: ProfileCandidate) -> Check:
    """Failed check of a limit of [optimize] that no profile keeps, with a value of its key that the nearest keeps."""
    value = near.figures[limit.figure]
    return Check(
        limit.code,
        limit.figure,
        value,
        "°" if limit.unit == "degrees" else limit.unit,
        limit.most,
        Bound.MAX,
        Message("{profile}, the nearest of the profiles compared", profile=Message(near.name)),
        Message(
            "no profile compared keeps this: raise {key} to {value:g}, or take a train with less backlash",
            key=limit.key,
            value=ceil(value * 100) / 100,
        )
        if isfinite(value)
        else Message("no profile compared keeps this: remove {key}, or take a train with less backlash", key=limit.key),
    )


def _deciding(band: PlayBand, *, trimmed: bool) -> str:
    """Name of the figure that decides the choice: with a measured play other cars do not matter."""
    if trimmed:
        return Message("worst end position error after the trim")
    if band.measured is None:
        return Message("worst end position error")
    return Message("position error at the end with the measured play")


def _heading(band: PlayBand, *, trimmed: bool) -> str:
    if trimmed:
        return Message("worst end heading error after the trim")
    if band.measured is None:
        return Message("worst end heading error")
    return Message("heading error at the end with the measured play")


def _limits(design: Design, band: PlayBand, *, trimmed: bool) -> tuple[FigureLimit, ...]:
    """Limits of [optimize]."""
    keys = design.optimize
    limits = (
        (_deciding(band, trimmed=trimmed), "max_end_position_mm", "mm", CheckCode.END_POSITION_WITH_PLAY),
        (_heading(band, trimmed=trimmed), "max_end_heading_deg", "degrees", CheckCode.END_HEADING_WITH_PLAY),
        (_RUN_ERROR, "max_run_position_mm", "mm", CheckCode.RUN_POSITION_WITH_PLAY),
        (LIFT_ERROR, "max_lift_error_um", "µm", CheckCode.LIFT_ERROR_WITH_PLAY),
    )
    return tuple(
        FigureLimit(figure=name, most=most, unit=unit, code=code, key=f"optimize.{key}")
        for name, key, unit, code in limits
        if (most := getattr(keys, key)) is not None
    )


def _lifted(
    limits: tuple[FigureLimit, ...], old: Evaluation, evaluations: Sequence[Evaluation]
) -> tuple[tuple[FigureLimit, ...], tuple[str, ...]]:
    """Limits of a comparison, the lift error's raised to the old cam's if no profile keeps it, with a sentence."""
    least, had = (1e3 * error for error in (min(e.worst_lift_error for e in evaluations), old.worst_lift_error))
    raised = [limit for limit in limits if limit.figure == LIFT_ERROR and limit.most < least < had]
    if not raised:
        return limits, ()
    words = Message(
        "no profile keeps the lift error with play within the {most:g} µm of optimize.max_lift_error_um: {least:.0f} "
        "µm at least, but the cam that was measured has {had:.0f} µm on this car",
        most=raised[0].most,
        least=least,
        had=had,
    )
    return tuple(replace(limit, most=had) if limit in raised else limit for limit in limits), (words,)


def _figures(checks: ProfileChecks, evaluation: Evaluation, band: PlayBand) -> dict[str, float]:
    """Errors of a profile by the names of their limits in [optimize]; after the trim, if the design allows a trim."""
    task = checks.task
    trimmed = task.trimmed and task.mechanics is not None
    heading, distance = evaluation.band.worst_heading, evaluation.band.worst_distance
    if band.measured is not None and task.mechanics is None:
        heading, distance = abs(evaluation.error.end_heading), evaluation.error.end_distance
    elif band.measured is not None and task.mechanics is not None:
        at_play = over_band(
            evaluation.rolled,
            task.lift,
            task.car,
            task.length,
            np.array([band.measured]),
            least_swing=evaluation.least_swing,
            mechanics=task.mechanics.cases,
            cut=evaluation.lift,
        )
        heading, distance = at_play.worst_heading, at_play.worst_distance
    if task.trimmed and task.mechanics is not None:
        plays = band.ends if band.measured is None else (band.measured,)
        # As the sheet of remedies has it.
        settings = trims(task, evaluation.rolled, evaluation.lift, plays, task.mechanics.fine_cases)
        heading = max(abs(trim.error.end_heading) for trim in settings)
        distance = max(trim.error.end_distance for trim in settings)
    return {
        _deciding(band, trimmed=trimmed): distance,
        _heading(band, trimmed=trimmed): degrees(heading),
        _RUN_ERROR: float(evaluation.error.distance.max()),
        LIFT_ERROR: evaluation.worst_lift_error * 1e3,
    }


_LEAST_MISSED = 1e-4  # mm of lift; less is below what can be cut


def against_play(
    profile: ProfileKind,
    checks: ProfileChecks,
    *,
    all_trains: bool = False,
    measured: MeasuredCam | None = None,
    progress: Progress = silent,
) -> PlayComparison:
    """Compare a profile, or the best of all that keep the design's limits and the cam's checks, with the plain one.

    If no profile passes the checks, the best is chosen without them, so that its own checks show what fails. If none
    keeps the limits, the nearest is chosen, and a check of each limit that it exceeds fails. Limits and choice go by
    the worst end over the band, or, if the play was measured, by the end with that play.

    Args:
        profile: the actual profile or one for play.
        checks: checks of the design's profiles.
        all_trains: whether the profiles are compared on the trains that the design does not use, too.
        measured: cam to compare with on a car as built; the actual profile if left out.
        progress: function that is called with a few words before each profile.

    Raises:
        DesignError: the design has no play.
    """
    design, task = checks.design, checks.task
    works = {name: TrainTask(task, name, band) for name, band in known_trains(design).items()}
    order, first = design.optimize.order, next(iter(works))
    work = works[order]
    old = None if measured is None else evaluate_measured(work, measured.profile, measured.lift, measured.curve)
    compared_on: dict[StageOrder, tuple[Evaluation, ...]] = {}
    reasons: list[str] = []
    beyond: tuple[Check, ...] = ()
    nearer: Refused | None = None
    for name, on_train in works.items():
        if name == order or all_trains:
            compared_on[name], refusals = _evaluations(on_train, profile, progress)
            reasons += refusals
        elif name == first and measured is None:
            compared_on[name] = (evaluate(on_train, ACTUAL),)
    chosen = compared_on[order][-1]
    if profile.best_of:
        progress("choosing the profile")
        best = best_of(compared_on[order], work.band, checks, old)
        if best.beyond:
            others = {name: other_work for name, other_work in works.items() if name != order}
            more = (_other_order(others, profile, checks), _with_friction(design, task))
            beyond = tuple(replace(check, advice=joined((check.advice, *more), "")) for check in best.beyond)
        chosen, nearer = best.evaluation, best.nearer
        reasons += best.reasons
    reasons += _lost_sentences(task, chosen)
    reasons += joint_sentences(design)
    reasons += border_sentences(design, task, chosen, work.band)
    evaluations = tuple(evaluation for several in compared_on.values() for evaluation in several)
    before = evaluations[0]
    if old is not None:
        before = old
        evaluations = (before, *evaluations)
    worst, said = (0.0, "") if task.mechanics else rubbing(task, work.band, chosen, before)
    return PlayComparison(
        task=task,
        band=work.band,
        before=before,
        chosen=chosen,
        evaluations=evaluations,
        reasons=tuple(reasons),
        bound=work.bound(),
        rubbing=said,
        rubs=worst,
        beyond=beyond,
        nearer=nearer,
    )


def _evaluations(
    work: TrainTask, profile: ProfileKind, progress: Progress
) -> tuple[tuple[Evaluation, ...], tuple[str, ...]]:
    """Evaluations of the actual and another profile, or of all that can be made; and why others cannot, in words."""
    if not profile.best_of:
        return tuple(evaluate(work, kind) for kind in ((ACTUAL,) if profile is ACTUAL else (ACTUAL, profile))), ()
    blend = work.task.lift.blend_start
    if not (falls(work.task.lift) % TURN < blend).any():
        where: str = ""
        if work.task.lift.blended:
            where = Message(" before its closing blend at {blend:.1f}°", blend=degrees(blend))
        reason = Message(
            "the lift has no peak and no valley{where}, so play changes nothing: the actual profile is made",
            where=where,
        )
        return (evaluate(work, ACTUAL),), (reason,)
    work.prepare()  # what it refuses, no profile can have
    evaluations, refusals = [evaluate(work, ACTUAL)], dict[str, str]()
    for kind in compared()[1:]:
        progress(Message("computing the {profile} profile", profile=Message(str(kind))))
        try:
            evaluations.append(evaluate(work, kind))
        except DesignError as error:  # several may be refused for the same reason
            refusals.setdefault(
                str(error), Message("{profile} refused: {reason}", profile=Message(str(kind)), reason=error.message)
            )
    return tuple(evaluations), tuple(refusals.values())


def _lost_sentences(task: PlayTask, chosen: Evaluation) -> list[str]:
    """Lift that a profile cannot give back because events are closer together than the play, in words."""
    if not chosen.lost:
        return []
    worst = max(chosen.lost, key=lambda dip: dip.tan_beta)
    missed = worst.tan_beta * task.follower.outer
    if missed < _LEAST_MISSED:
        return []
    play, cam_angle = degrees(chosen.made_for), degrees(worst.cam_angle)
    if len(chosen.lost) == 1:
        return [
            Message(
                "1 of the lift's dips is narrower than the return error of {play:.3f}° and cannot be driven: the rod "
                "misses at most {missed:.3g} mm of lift there, at cam angle {cam_angle:.2f}°",
                play=play,
                missed=missed,
                cam_angle=cam_angle,
            )
        ]
    return [
        Message(
            "{count} of the lift's dips are narrower than the return error of {play:.3f}° and cannot be driven: the "
            "rod misses at most {missed:.3g} mm of lift there, at cam angle {cam_angle:.2f}°",
            count=len(chosen.lost),
            play=play,
            missed=missed,
            cam_angle=cam_angle,
        )
    ]


def _with_friction(design: Design, task: PlayTask) -> str:
    """Advice where friction keeps every profile from its limit; empty if it does not apply."""
    known = task.mechanics
    if known is None or known.friction[1] == 0 or Hardware.DRAG in (design.optimize.hardware or ()):
        return ""
    return Message(
        "; with friction no profile gives the lift wanted on each fall, but a brake on the disc does: set "
        'optimize.hardware = ["drag"]; cadgen optimize shows what else helps'
    )


def _other_order(works: Mapping[StageOrder, TrainTask], profile: ProfileKind, checks: ProfileChecks) -> str:
    """Advice on another order of the train's stages that keeps the limits and the checks; empty if there is none."""
    for name, work in works.items():
        try:
            best = best_of(_evaluations(work, profile, silent)[0], work.band, checks)
        except DesignError:
            continue
        if not best.beyond and not failing(checks.of(best.evaluation)):
            return Message(
                ", or set optimize.order to {order}: with the stages in that order {profile} keeps them all",
                order=name,
                profile=Message(str(best.evaluation.profile)),
            )
    return ""
