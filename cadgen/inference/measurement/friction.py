"""Play and friction of one car: whether they can be told apart, and what is known of the play beforehand.

On a cam that leads its gears only near one place, twice the play over half the way does nearly the same to the car: of
the paper's car that is so from a friction of some 0.22 on. A play that was measured with the rod lifted, where no
friction holds the cam, tells them apart.
"""

from dataclasses import replace

from cadgen.deviations.effect import Effect
from cadgen.deviations.return_error import MEASURE_FRICTION
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.inference.measurement.joint import Joint
from cadgen.inference.measurement.verdict import Judgement, unclaimed

# Play and friction are told apart if their standard deviations are no more than these, the play's relative to its size.
APART_PLAY, APART_FRICTION = 0.015, 0.015
# Standard deviations by which a play measured beforehand may differ from the play fitted to the data alone.
ANOTHER = 3.3


def with_known_play(joint: Joint, best: Hypothesis, known: tuple[float, float] | None) -> tuple[Hypothesis, str]:
    """The best subset with what is known of the play, if it holds friction beside it.

    Args:
        joint: the records.
        best: their best subset.
        known: play and its standard deviation, rad.

    Returns:
        The subset fitted anew, or itself, and why what is known was not used, if so.
    """
    pair = _pair(best)
    if pair is None or known is None:
        return best, ""
    play = pair[0]
    (value,), (error,) = next((v, s) for e, v, s in best.values() if e == play)
    if abs(value - known[0]) > ANOTHER * (error**2 + known[1] ** 2) ** 0.5:
        (number,) = play.parameters
        return best, (
            f"the play measured apart, {known[0] / number.scale:.3f}°, is not the {value / number.scale:.3f} ± "
            f"{error / number.scale:.3f}° that these data show beside friction, and was not used: make sure that it "
            "is of the same car"
        )
    again = fit(joint, best.effects, best.active, Search(joint.rows), {play.key: known})
    return replace(again, penalty=best.penalty, spectrum=best.spectrum), ""


def with_friction_judged(judgement: Judgement, best: Hypothesis, *, play_known: bool) -> Judgement:
    """A judgement that says so where play and friction are not told apart, and claims no friction without play.

    Args:
        judgement: on the best subset.
        best: that subset.
        play_known: whether its play is one that was measured apart.
    """
    pair = _pair(best)
    if pair is None:
        return judgement
    play, friction = pair
    if play.name not in judgement.claimed:
        return unclaimed(judgement, [friction.name], f"{friction.name} shows only with a {play.name} that is sure")
    numbers = {e.key: (float(v[0]), float(s[0])) for e, v, s in best.values()}
    (value, error), (holds, unsure) = numbers[play.key], numbers[friction.key]
    sure = (play_known or error <= APART_PLAY * value) and unsure <= APART_FRICTION
    if friction.name not in judgement.claimed or sure:
        return judgement
    scale = play.parameters[0].scale
    limit = (
        f"{play.name} and {friction.name} are not told apart: more play with more friction, {value / scale:.2f} ± "
        f"{error / scale:.2f}° with {holds:.2f} ± {unsure:.2f}, does nearly the same to this cam; to tell them apart, "
        f"{MEASURE_FRICTION}; set play.measured_deg, or give a transmission's file, and calibrate again"
    )
    return replace(judgement, limits=(*judgement.limits, limit))


def _pair(best: Hypothesis) -> tuple[Effect, Effect] | None:
    """The play and the friction beside it."""
    friction = next((e for e in best.effects if e.beside), None)
    if friction is None:
        return None
    return next(e for e in best.effects if e == friction.beside), friction
