"""From a design with play to the profile that is best against it, with the reasons."""

from collections.abc import Mapping
from math import degrees

from cadgen.arrays import TURN
from cadgen.car.against_play.evaluate import Evaluation, evaluate, evaluate_measured
from cadgen.car.against_play.play_task import PlayTask, TrainTask
from cadgen.car.against_play.profile_kinds import ACTUAL, ProfileKind, compared
from cadgen.car.running.play import falls
from cadgen.check import failing
from cadgen.design.play import Hardware
from cadgen.design.schema import Design
from cadgen.errors import CheckError, DesignError
from cadgen.gears.choices import StageOrder
from cadgen.jobs.cam.checking import ProfileChecks
from cadgen.jobs.cam.choosing import best_of
from cadgen.jobs.cam.comparison import MeasuredCam, PlayComparison, known_trains
from cadgen.jobs.cam.mechanics import border_sentences, joint_sentences, rubbing_sentence
from cadgen.progress import Progress, silent

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

    If no profile passes the checks, the best is chosen without them, so that its own checks show what fails. Limits and
    choice go by the worst end over the band, or, if the play was measured, by the end with that play.

    Args:
        profile: the actual profile or one for play.
        checks: checks of the design's profiles.
        all_trains: whether the profiles are compared on the trains that the design does not use, too.
        measured: cam to compare with on a car as built; the actual profile if left out.
        progress: function that is called with a few words before each profile.

    Raises:
        DesignError: the design has no play.
        CheckError: no profile keeps the limits of [optimize]; the message adds another order of the stages that would.
    """
    design, task = checks.design, checks.task
    works = {name: TrainTask(task, name, band) for name, band in known_trains(design).items()}
    order, first = design.optimize.order, next(iter(works))
    work = works[order]
    old = None if measured is None else evaluate_measured(work, measured.profile, measured.lift, measured.curve)
    compared_on: dict[StageOrder, tuple[Evaluation, ...]] = {}
    reasons: list[str] = []
    for name, on_train in works.items():
        if name == order or all_trains:
            compared_on[name], refusals = _evaluations(on_train, profile, progress)
            reasons += refusals
        elif name == first and measured is None:
            compared_on[name] = (evaluate(on_train, ACTUAL),)
    chosen = compared_on[order][-1]
    if profile.best_of:
        progress("choosing the profile")
        try:
            best = best_of(compared_on[order], work.band, checks, old)
        except CheckError as error:
            others = {name: other_work for name, other_work in works.items() if name != order}
            raise CheckError(f"{error}{_other_order(others, profile, checks)}{_with_friction(design, task)}") from error
        chosen = best.evaluation
        reasons += best.reasons
    reasons += _lost_sentences(task, chosen)
    reasons += joint_sentences(design)
    reasons += border_sentences(design, task, chosen, work.band)
    evaluations = tuple(evaluation for several in compared_on.values() for evaluation in several)
    before = evaluations[0]
    if old is not None:
        before = old
        evaluations = (before, *evaluations)
    return PlayComparison(
        task=task,
        band=work.band,
        before=before,
        chosen=chosen,
        evaluations=evaluations,
        reasons=tuple(reasons),
        bound=work.bound(),
        rubbing="" if task.mechanics else rubbing_sentence(task, work.band, chosen, before),
    )


def _evaluations(
    work: TrainTask, profile: ProfileKind, progress: Progress
) -> tuple[tuple[Evaluation, ...], tuple[str, ...]]:
    """Evaluations of the actual and another profile, or of all that can be made; and why others cannot, in words."""
    if not profile.best_of:
        return tuple(evaluate(work, kind) for kind in ((ACTUAL,) if profile is ACTUAL else (ACTUAL, profile))), ()
    blend = work.task.lift.blend_start
    if not (falls(work.task.lift) % TURN < blend).any():
        where = f" before its closing blend at {degrees(blend):.1f}°" if work.task.lift.blended else ""
        reason = f"the lift has no peak and no valley{where}, so play changes nothing: the actual profile is made"
        return (evaluate(work, ACTUAL),), (reason,)
    work.prepare()  # what it refuses, no profile can have
    evaluations, refusals = [evaluate(work, ACTUAL)], dict[str, str]()
    for kind in compared()[1:]:
        progress(f"computing the {kind} profile")
        try:
            evaluations.append(evaluate(work, kind))
        except DesignError as error:  # several may be refused for the same reason
            refusals.setdefault(str(error), f"{kind} refused: {error}")
    return tuple(evaluations), tuple(refusals.values())


def _lost_sentences(task: PlayTask, chosen: Evaluation) -> list[str]:
    """Lift that a profile cannot give back because events are closer together than the play, in words."""
    if not chosen.lost:
        return []
    worst = max(chosen.lost, key=lambda dip: dip.tan_beta)
    missed = worst.tan_beta * task.follower.outer
    if missed < _LEAST_MISSED:
        return []
    verb = "is" if len(chosen.lost) == 1 else "are"
    return [
        f"{len(chosen.lost)} of the lift's dips {verb} narrower than the return error of "
        f"{degrees(chosen.made_for):.3f}° and cannot be driven: the rod misses at most {missed:.3g} mm of "
        f"lift there, at cam angle {degrees(worst.cam_angle):.2f}°"
    ]


def _with_friction(design: Design, task: PlayTask) -> str:
    """Advice where friction keeps every profile from its limit; empty if it does not apply."""
    known = task.mechanics
    if known is None or known.friction[1] == 0 or Hardware.DRAG in (design.optimize.hardware or ()):
        return ""
    return (
        "; with friction no profile gives the lift wanted on each fall, but a brake on the disc does: --set "
        "'optimize.hardware=[\"drag\"]', or remove optimize.max_lift_error_um to see what else helps in cadgen optimize"
    )


def _other_order(works: Mapping[StageOrder, TrainTask], profile: ProfileKind, checks: ProfileChecks) -> str:
    """Advice on another order of the train's stages that keeps the limits and the checks; empty if there is none."""
    for name, work in works.items():
        try:
            best = best_of(_evaluations(work, profile, silent)[0], work.band, checks).evaluation
        except (DesignError, CheckError):
            continue
        if not failing(checks.of(best)):
            return (
                f", or set the stages in the order {name}, with which {best.profile} keeps them all: "
                f"--set optimize.order={name}"
            )
    return ""
