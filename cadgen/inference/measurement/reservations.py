"""Reservations about a verdict: what speaks against it, and what these data cannot tell apart.

Doubtful are values on a bound or within their error, a large rest, noise that is none, and too little data.

Play and friction of one car may look alike. On a cam that leads its gears only near one place, twice the play over half
the way does nearly the same to the car: of the paper's car that is so from a friction of some 0.22 on. A play that was
measured with the rod lifted, where no friction holds the cam, tells them apart.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, combinations, pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.stats import f as f_distribution

from cadgen.arrays import Array
from cadgen.deviations.camera import CAMERA_FRAME
from cadgen.deviations.effect import UNITS, Effect, causes
from cadgen.deviations.return_error import MEASURE_FRICTION, NO_FRICTION
from cadgen.errors import FileError
from cadgen.inference.measurement.evidence import Evidence, Noise, Spectrum
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit, least_penalty
from cadgen.inference.measurement.joint import Joint
from cadgen.inference.measurement.model import Model, highest_order, repeating
from cadgen.inference.measurement.record import Record, instrument
from cadgen.inference.measurement.search import MOST_CAUSES
from cadgen.inference.measurement.verdict import (
    LEFT_OVER,
    RIVAL,
    SIGMAS,
    Judgement,
    Verdict,
    left_over,
    names_of,
    separations,
    unclaimed,
    within_error,
    within_words,
)
from cadgen.messages import Message

# What is left after the best subset, over what noise and the stated form error make: no part is so far off that was
# made to the design at all, and no effect stands beside such a rest with a name.
DWARFED = 6.0  # of noise and form error; up to six effects take some of what a wrong design leaves, too
# Beside a rest of this many times that, the size of an effect is the rest's as much as its own.
LARGE = 3.0
# Noise between runs this many times that of the instrument is another thing than the instrument.
BEYOND_INSTRUMENT = 3.0
# Neighbours so alike, or so opposite, are no neighbours in time.
OUT_OF_ORDER = 0.9
# What a subset of the largest size leaves is significant below this chance.
UNFIT = 0.01
# Form error of a middling spectrum, to weigh it in a track, where it is integrated twice.
TYPICAL = Spectrum(1.0, 6.0, 1.0)
LEAST_TURN_DEG = 300.0
LEAST_OVER = 1.1  # rows for each column that one run must tell apart
LEAST_ORDERS = 30  # below this, waviness and narrow bumps stand between the readings


def refuse_too_few(record: Record, model: Model) -> None:
    """A single run must have more rows than orders of form error, or nothing of it is noise.

    Raises:
        FileError: it has not.
    """
    rows, columns = len(model.rows.run), repeating(model).shape[1] + model.offsets.shape[1]
    if record.runs == 1 and rows < LEAST_OVER * columns:
        raise FileError(
            "{file}: one run of {rows} rows cannot tell noise from {orders} orders of form error; repeat the run, or "
            "give at least {least} rows in it",
            file=record.source,
            rows=rows,
            orders=int(model.order.max()),
            least=int(LEAST_OVER * columns) + 1,
        )


def resolved(record: Record, noise: Noise) -> Noise:
    """Noise no smaller than the steps of the instrument make: readings may repeat to the last digit."""
    steps = []
    for column in record.kind.readings:
        apart = np.diff(np.unique(record[column]))
        # Rounding of decimal numbers leaves steps of 1e-13 that are none.
        steps.append(float(np.min(apart[apart > 1e-9], initial=1.0)))
    least = min(steps) / np.sqrt(12) * UNITS[record.kind.reading_unit]
    return replace(noise, sigma=np.maximum(noise.sigma, least))


def unfit(model: Model, evidence: Evidence, noise: Noise, best: Hypothesis, residual: Array) -> float:
    """Chance that noise and form error alone leave so much that repeats, by F-test; 1 if it is not known.

    r' C^-1 r is chi-square with as many degrees of freedom as rows less parameters. Those from which the noise was told
    are left out: they are as large as the noise by definition.

    Args:
        model: model of the record.
        evidence: evidence of the record.
        noise: noise of the record.
        best: subset of effects that is judged.
        residual: residual that the subset leaves, shape (n,), mm or rad.
    """
    if not noise.freedom:
        return 1.0
    white = evidence.whiten(residual)[:, None]
    square = float(evidence.products(white, white, [evidence.grid.index(best.spectrum)])[0, 0, 0])
    fitted = model.offsets.shape[1] + sum(len(e.parameters) for e in (*model.datum, *best.effects))
    extra = len(residual) - fitted - noise.freedom
    if extra < 1:
        return 1.0
    ratio = (square - noise.freedom) / extra
    return float(f_distribution.sf(ratio, extra, noise.freedom))


def with_reservations(
    judgement: Judgement,
    record: Record,
    model: Model,
    noise: Noise,
    best: Hypothesis,
    after: Array,
    chance: float = 1.0,
) -> Judgement:
    """Judgement without the claims that the data do not support, with its limits stated.

    Args:
        judgement: judgement by the evidence alone.
        record: record that it is about.
        model: model of the record.
        noise: noise of the record.
        best: effects that were chosen.
        after: residual with these, in the record's unit, shape (n, m).
        chance: probability of such a misfit, as of `unfit`.
    """
    form = np.mean(model.form**2, axis=0) @ TYPICAL.variance(model.order, model.floor)
    allowed = float(np.sqrt(noise.rms**2 + form))
    left = float(np.sqrt(np.mean(after**2)))
    judgement = replace(
        judgement, limits=(*judgement.limits, *_too_little(record, model), *_noisier(record, model, noise))
    )
    if left > DWARFED * allowed:
        sentence = Message(
            "What the best effects leave is {times:.0f} times what noise and the stated form error make, and dwarfs "
            "every effect: check that the design and the profile belong to this file, and the file's units.",
            times=left / allowed,
        )
        return replace(judgement, verdict=Verdict.UNEXPLAINED, sentence=sentence, claimed=())
    if no_noise := _no_noise(record, noise):
        return replace(judgement, verdict=Verdict.UNEXPLAINED, sentence=no_noise, claimed=())
    if not judgement.claimed:
        return judgement
    if left > LARGE * allowed:
        why = Message(
            "what remains is {times:.1f} times what noise and the stated form error make", times=left / allowed
        )
        return unclaimed(judgement, judgement.claimed, why)
    if causes(best.effects) >= MOST_CAUSES and chance < UNFIT:
        sentence = Message(
            "Consistent with {names}, but what they leave is more than noise and form error: there are more than "
            "{most} effects, so sizes are not sure and nothing is claimed.",
            names=names_of(best.effects),
            most=MOST_CAUSES,
        )
        return replace(judgement, verdict=Verdict.AMBIGUOUS, sentence=sentence, claimed=())
    # That there is no friction is as sure a finding as that there is some.
    free = {e.name for e, v, s in best.values() if e.beside and v[0] + SIGMAS * s[0] <= NO_FRICTION}
    named = [e for e in best.effects if not e.shape and e.name not in free]
    stuck = {e.name: p.name for e in named for p in e.parameters if p.name in best.at_bound}
    for name, value in stuck.items():
        why = Message("{number} of {name} is on the bound of what can be", number=value, name=Message(name))
        judgement = unclaimed(judgement, [name], why)
    # How a camera errs need not be sure: it stays at home.
    unsure = [
        e.name
        for e, values, sigma in best.values()
        if e in named and not e.stage.of_instrument and within_error([p.unit for p in e.parameters], values, sigma)
    ]
    return unclaimed(judgement, unsure, within_words())


def _no_noise(record: Record, noise: Noise) -> Message | None:
    """Reason why what differs between runs is not the instrument's noise; None if it may be."""
    # With one run noise also holds what repeats, which neighbours share.
    # An encoder that wanders differs slowly from run to run; rows in another order never do.
    alike = -noise.correlation if record.kind.wanders else abs(noise.correlation)
    if noise.runs > 1 and alike > OUT_OF_ORDER:
        return Message(
            "The noise of neighbouring rows is correlated by {correlation:.2f}, which no instrument's is: write the "
            "rows in the order in which they were measured.",
            correlation=noise.correlation,
        )
    return None


def _noisier(record: Record, model: Model, noise: Noise) -> list[Message]:
    """Limit that the runs differ by more than the file says of its instrument: a figure in a file is often wrong."""
    stated = instrument(record)
    if not stated or noise.runs < 2 or noise.rms <= BEYOND_INSTRUMENT * stated.noise * UNITS[stated.unit]:
        return []
    return [
        Message(
            "the runs differ by {rms:.3g} {unit}, but the file says that the instrument's noise is {stated:g} "
            "{stated_unit}; all that is said of sizes goes by how the runs differ: make sure that they are of one part "
            "in one state",
            rms=noise.rms / UNITS[model.unit],
            unit=model.unit,
            stated=stated.noise,
            stated_unit=stated.unit,
        )
    ]


def _too_little(record: Record, model: Model) -> list[Message]:
    """Effects that these rows cannot show, in words."""
    rows = model.rows
    limits: list[Message] = []
    if "direction" in record.columns and len(set(record.columns["direction"].tolist())) == 1:
        limits.append(
            Message("measured in one direction only: backlash and friction cannot be told from an offset or a phase")
        )
    if not record.kind.around:
        return limits
    orders = highest_order(rows.place, rows.run)
    if orders < LEAST_ORDERS:
        limits.append(
            Message(
                "too few points for fine shapes: the spacing resolves up to {orders} waves round the cam", orders=orders
            )
        )
    around = np.sort(np.degrees(rows.place) % 360.0)
    turn = 360.0 - float(np.max(np.diff(around, append=around[0] + 360.0)))
    if turn < LEAST_TURN_DEG:
        limits.append(Message("only {turn:.0f} degrees of the turn were measured: the rest is not judged", turn=turn))
    return limits


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
        return best, Message(
            "the play measured apart, {apart:.3f}°, is not the {value:.3f} ± {error:.3f}° that these data show beside "
            "friction, and was not used: make sure that it is of the same car",
            apart=known[0] / number.scale,
            value=value / number.scale,
            error=error / number.scale,
        )
    again = fit(joint, best.effects, best.active, Search(joint.rows), {play.key: known})
    return replace(again, penalty=best.penalty, spectrum=best.spectrum), ""


def with_friction_judged(judgement: Judgement, best: Hypothesis, *, play_known: bool) -> Judgement:
    """Judgement that states where play and friction look alike, and claims no friction without play.

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
        why = Message(
            "{friction} shows only with a {play} that is sure", friction=Message(friction.name), play=Message(play.name)
        )
        return unclaimed(judgement, [friction.name], why)
    numbers = {e.key: (float(v[0]), float(s[0])) for e, v, s in best.values()}
    (value, error), (holds, unsure) = numbers[play.key], numbers[friction.key]
    sure = (play_known or error <= APART_PLAY * value) and unsure <= APART_FRICTION
    if friction.name not in judgement.claimed or sure:
        return judgement
    scale = play.parameters[0].scale
    limit = Message(
        "{play} and {friction} are not told apart: more play with more friction, {value:.2f} ± {error:.2f}° with "
        "{holds:.2f} ± {unsure:.2f}, does nearly the same to this cam; to tell them apart, {how}; set "
        "play.measured_deg, or give a transmission's file, and calibrate again",
        play=Message(play.name),
        friction=Message(friction.name),
        value=value / scale,
        error=error / scale,
        holds=holds,
        unsure=unsure,
        how=Message(MEASURE_FRICTION),
    )
    return replace(judgement, limits=(*judgement.limits, limit))


# What a camera's error gains beside a fitted rest is known to first order: so many times that, and so much more in
# -2 log L, it gains at most.
_FIRST_ORDER, _UNSURE = 1.5, 20.0


def with_cameras(judgement: Judgement, joint: Joint, best: Hypothesis) -> Judgement:
    """Judgement that claims nothing which an error of the camera explains as well, and names that error.

    Each error stands alone, beside all names, or in the place of one or two of them. It explains the data if it leaves
    no more than noise. It is as good with fewer numbers within `RIVAL` of the criterion, and with as many or more if
    it is better by that.
    """
    # A frame that is laid askew is in the start poses.
    cameras, search = [e for e in joint.cameras if e.key != CAMERA_FRAME.key], Search(joint.rows)
    if judgement.verdict is Verdict.NONE or not cameras:
        return judgement
    found = fit(joint, best.effects, best.active, search)
    named = tuple(e for e in best.effects if not e.shape)
    sizes = range(len(named), max(len(named) - 2, 0) - 1, -1)
    rests = dict.fromkeys([*chain.from_iterable(combinations(named, size) for size in sizes), ()])
    rivals: list[Hypothesis] = []
    known: dict[Effect, list[tuple[set[Effect], float]]] = {camera: [] for camera in cameras}
    for rest in rests:
        # With fewer names at least as much is left.
        left = [
            camera
            for camera in cameras
            if all(misfit <= _most(found, search, (*rest, camera)) for more, misfit in known[camera] if more >= {*rest})
        ]
        if not left or any(e.beside and e.beside not in rest for e in rest):
            continue
        bare = found if rest == best.effects else fit(joint, rest, best.active, search)
        for camera, gain in zip(left, _gains(joint, bare, left), strict=True):
            effects = (*rest, camera)
            most, least = _most(found, search, effects), bare.misfit[bare.within] - _FIRST_ORDER * gain - _UNSURE
            if least <= most:
                other = fit(joint, effects, bare.active, search, level=most)
                least = other.misfit[other.within] - _UNSURE
                near = _near(found, other.parameters)
                if other.score < found.score + near and all(
                    left_over(part, joint, other) <= LEFT_OVER for part in joint.parts
                ):
                    rivals.append(other)
            known[camera].append(({*rest}, least))
    if not rivals:
        return judgement
    first = min(rivals, key=lambda h: h.score)
    camera, values, sigma = next(entry for entry in first.values() if entry[0] in cameras)
    size = ", ".join(
        f"{p.name} {v / p.scale:.3g} ± {s / p.scale:.2g}"
        for p, v, s in zip(camera.parameters, values, sigma, strict=True)
    )
    why = Message("{camera} ({size}) explains these data as well", camera=Message(camera.name), size=size)
    judgement = replace(judgement, separate=(*judgement.separate, *separations([camera])))
    lost = [name for name in judgement.claimed if any(name not in h.claims for h in rivals)]
    if judgement.claimed:
        return unclaimed(judgement, lost, why)
    names = names_of(first.effects)
    sentence = Message("Consistent with {names} ({size}): nothing is claimed of the car.", names=names, size=size)
    return replace(judgement, verdict=Verdict.AMBIGUOUS, sentence=sentence)


def _near(found: Hypothesis, parameters: int) -> float:
    """How much worse than the best subset by the criterion one with so many numbers may be, and explain as well."""
    return RIVAL if parameters < found.parameters else -RIVAL


def _most(found: Hypothesis, search: Search, effects: tuple[Effect, ...]) -> float:
    """-2 log L above which a subset is no rival of the best one, at the least penalty that it can have."""
    parameters = sum(len(e.parameters) for e in effects)
    least = least_penalty(search, effects, parameters)
    return found.score + _near(found, parameters) - least


def _gains(joint: Joint, fitted: Hypothesis, cameras: Sequence[Effect]) -> list[float]:
    """By how much each error of the camera lessens -2 log L of a fitted subset, to first order of the residual."""
    even = tuple(effect for effect, _ in fitted.active if not effect.parameters[0].stepwise)
    active = [*fitted.active, *((camera, camera.start) for camera in cameras)]
    (H,), (g,) = joint.normal((*even, *cameras), active, [fitted.within])
    ends = np.cumsum([sum(len(e.parameters) for e in even), *(len(camera.parameters) for camera in cameras)])

    def gain(columns: NDArray[np.intp]) -> float:
        here = g[columns]
        return float(here @ np.linalg.lstsq(H[np.ix_(columns, columns)], here, rcond=None)[0])

    every = np.arange(len(g))
    return [gain(np.append(every[: ends[0]], every[a:b])) for a, b in pairwise(ends)]


def _pair(best: Hypothesis) -> tuple[Effect, Effect] | None:
    """The play and the friction beside it."""
    friction = next((e for e in best.effects if e.beside), None)
    if friction is None:
        return None
    return next(e for e in best.effects if e == friction.beside), friction
