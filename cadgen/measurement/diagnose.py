"""From measured data to a verdict: noise, search, comparison of the rivals, and a test on runs left out."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import UNITS, Active, Effect
from cadgen.deviations.names import Kind
from cadgen.measurement.doubt import doubted, refuse_too_few, resolved, unfit
from cadgen.measurement.evidence import Evidence
from cadgen.measurement.friction import with_friction_judged, with_known_play
from cadgen.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.measurement.models.base import Model, per_run, slopes
from cadgen.measurement.models.profile import ProfileModel
from cadgen.measurement.noise import Noise, estimate_noise
from cadgen.measurement.record import Record
from cadgen.measurement.search import find
from cadgen.measurement.verdict import SIGMAS, Judgement, judge, registered, within_error

Build = Callable[[Record], Model]
Step = Callable[[str], None]
# Name of the play in the kinds of data that show it by themselves, and verdicts beside which its absence counts.
PLAY = {"track": "backlash", "transmission": "return error"}
# The same of friction; a transmission that shows none was read with the rod lifted.
FRICTION = {"track": "sliding friction"}
SOUND = ("none", "traced", "combination")
# What the linear datum freedoms of one run are, by kind: name, and each number with its unit.
DATUM = {
    "lift": ("zero of the dial", (("zero_um", "um"),)),
    "transmission": ("zero of the inclinometer", (("zero_deg", "deg"),)),
    "track": ("start pose", (("start_x_mm", "mm"), ("start_y_mm", "mm"), ("start_heading_deg", "deg"))),
}


@dataclass(frozen=True, slots=True)
class Value:
    """One fitted number in the unit its name ends in, with its standard deviation."""

    name: str
    value: float
    sigma: float
    unit: str


@dataclass(frozen=True, slots=True)
class Finding:
    """An effect with its numbers, what it cannot be told from, and what is `given` with it (see `Effect.given`).

    `sigmas` is how many standard deviations from nothing its numbers must be to be sure: see `verdict.sigmas_of`.
    """

    effect: str
    values: tuple[Value, ...]
    twins: tuple[str, ...]
    at_bound: tuple[str, ...]
    given: tuple[tuple[str, float], ...] = ()
    sigmas: float = SIGMAS

    @property
    def within_error(self) -> bool:
        """Whether one of its numbers may be nothing: see `verdict.within_error`."""
        columns = zip(*((v.unit, v.value, v.sigma) for v in self.values), strict=True)
        units, values, sigma = columns
        return within_error(units, values, sigma, self.sigmas)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A row of the table of candidates: a subset with its numbers, and how much worse than the best it is.

    Of tracks with logged steering the score is the path error on runs left out, and `held_out` that of each run.
    """

    effects: tuple[str, ...]
    score: float
    loose_score: float
    findings: tuple[Finding, ...] = ()
    held_out: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Residual:
    """Root mean squares in the record's unit (um, deg or mm).

    Attributes:
        before: of the bare design, datum fitted.
        after: with the effects found.
        held_out: the same on each run in turn, the effects fitted to the others; nan with one run.
        held_out_repeating: the same, less what the other runs say of the form error.
        noise: what does not repeat between runs.
    """

    before: float
    after: float
    held_out: float
    held_out_repeating: float
    noise: float


@dataclass(frozen=True, slots=True)
class PerRun:
    """Root mean squares of each run in the record's unit, shape (runs,), as in `Residual`; of tracks with logged
    steering the distance, and `as_logged` before the start pose is registered."""

    before: Array
    after: Array
    held_out: Array
    as_logged: Array | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Diagnosis:
    """What one record says.

    Attributes:
        source, kind, unit: of the record; residuals are in the unit.
        judgement: the class of verdict, what is claimed, and one sentence.
        findings: the effects of the best subset, shapes among them.
        datum: fitted freedoms, never claimed; those of each run in order.
        candidates: the best subsets, best first.
        residual: before and after.
        per_run: the same for each run.
        correlation: of the noise between neighbours.
        place: of each measured row, shape (n,), internal units.
        run: of each row, shape (n,).
        before, after: residual of each row, datum fitted, internal units.
        active: the effects found with their values, internal units.
        measured: coordinate of each row of a track, mm; None for what is no track.
        known: effects that another record told, and that this one was judged with.
        unnamed_play: the play that a sound verdict does not name, fitted beside what it does; None otherwise.
        play_known: whether the play found has in it what was measured of it apart.
        unnamed_friction: the same of friction beside a play that a track names.
    """

    source: str
    kind: Kind
    unit: str
    judgement: Judgement
    findings: tuple[Finding, ...]
    datum: tuple[Finding, ...]
    candidates: tuple[Candidate, ...]
    residual: Residual
    per_run: PerRun
    correlation: float
    place: Array
    run: Array
    before: Array
    after: Array
    active: Active
    measured: Array | None = None
    known: tuple[str, ...] = ()
    unnamed_play: Finding | None = None
    unnamed_friction: Finding | None = None
    play_known: bool = False

    @property
    def verdict(self) -> str:
        """The class of verdict."""
        return self.judgement.verdict

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return len(self.per_run.before)


def diagnose(
    record: Record, build: Build, step: Step = lambda text: None, play: tuple[float, float] | None = None
) -> Diagnosis:
    """Trace what a record shows to effects, or say why not.

    Args:
        record: measured data of one kind.
        build: makes the forward model of a record; called again for records with some runs left out.
        step: told what is being done.
        play: return error that was measured apart, and its standard deviation, rad.

    Raises:
        FileError: one run only, with too few rows to tell its noise.
    """
    step(f"{record.source}: telling noise from what repeats")
    model = build(record)
    refuse_too_few(record, model)
    noise = resolved(record, model, estimate_noise(model, model.residual([(e, e.start) for e in model.datum])))
    evidence = Evidence(model, noise)
    step(f"{record.source}: comparing all small subsets of {len(model.catalogue)} effects")
    found = find(model, evidence)
    judgement, best = judge(model, evidence, noise, found)
    found_alone = best
    best, another = with_known_play(model, evidence, best, play)
    play_known = best is not found_alone
    none = next(h for h in found if not h.effects)
    before, after = (registered(model, noise, model.residual(h.active)) for h in (none, best))
    judgement = doubted(judgement, record, model, noise, best, after, unfit(model, evidence, noise, best))
    judgement = with_friction_judged(judgement, best, play_known=play_known)
    if another:
        judgement = replace(judgement, limits=(*judgement.limits, another))
    own, repeating = [], []
    for run in range(record.runs) if record.runs > 1 else ():
        step(f"{record.source}: run {run + 1} left out")
        one, less = _held_out(record, model, build, noise, best, run)
        own.append(one)
        repeating.append(less)
    held_out, held_out_repeating = (_rms(np.concatenate(parts)) if parts else np.nan for parts in (own, repeating))
    scale = UNITS[model.unit]
    return Diagnosis(
        source=record.source,
        kind=record.kind,
        unit=model.unit,
        judgement=judgement,
        findings=tuple(_finding(best, *entry) for entry in best.values()),
        datum=_datum(model, noise, best),
        candidates=tuple(
            Candidate(
                tuple(e.name for e in h.effects),
                h.score - found[0].score,
                h.loose_score - found[0].score,
                tuple(_finding(h, *entry) for entry in h.values()),
            )
            for h in found
        ),
        residual=Residual(
            before=_rms(before) / scale,
            after=_rms(after) / scale,
            held_out=held_out / scale,
            held_out_repeating=held_out_repeating / scale,
            noise=noise.rms / scale,
        ),
        per_run=PerRun(
            _by_run(before, model) / scale,
            _by_run(after, model) / scale,
            np.array([_rms(part) for part in own] or [np.nan] * record.runs) / scale,
        ),
        correlation=noise.correlation,
        place=model.rows.place,
        run=model.rows.run.astype(float),
        before=before,
        after=after,
        active=[(e, v) for e, v in best.active if e in best.effects],
        measured=model.measured,
        unnamed_play=_unnamed(model, evidence, judgement, best, PLAY.get(model.kind, "")),
        unnamed_friction=_unnamed(model, evidence, judgement, best, FRICTION.get(model.kind, "")),
        play_known=play_known,
    )


def _unnamed(model: Model, evidence: Evidence, judgement: Judgement, best: Hypothesis, name: str) -> Finding | None:
    """How much play or friction there could be where several runs and a sound verdict name none."""
    effect = next((e for e in model.catalogue if e.name == name), None)
    if effect is None or effect in best.effects or model.rows.runs < 2 or judgement.verdict not in SOUND:
        return None
    if effect.beside and effect.beside not in judgement.claimed:
        return None
    # With the effects found free beside it, what they could hide of it widens its error.
    beside = fit(model, evidence, (*best.effects, effect), best.active, Search(1))
    return next(_finding(beside, *entry) for entry in beside.values() if entry[0] == effect)


def _finding(best: Hypothesis, effect: Effect, values: Array, sigma: Array) -> Finding:
    told = tuple(
        Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
        for p, v, s in zip(effect.parameters, values, sigma, strict=True)
    )
    at_bound = tuple(p.name for p in effect.parameters if p.name in best.at_bound)
    return Finding(effect.name, told, effect.twins, at_bound, effect.given)


def _datum(model: Model, noise: Noise, best: Hypothesis) -> tuple[Finding, ...]:
    """The datum freedoms of each run, beside the effects."""
    if isinstance(model, ProfileModel):
        return _clocking(model, noise, best)
    if model.kind not in DATUM:
        return ()
    name, numbers = DATUM[model.kind]
    white = model.offsets / noise.sigma[:, None]
    fit = np.linalg.lstsq(white, model.residual(best.active) / noise.sigma, rcond=None)[0]
    sigma = np.sqrt(np.diag(np.linalg.pinv(white.T @ white)))
    found = []
    for run in range(model.rows.runs):
        at = range(run * len(numbers), (run + 1) * len(numbers))
        values = tuple(
            Value(n, float(fit[k] / UNITS[u]), float(sigma[k] / UNITS[u]), u)
            for k, (n, u) in zip(at, numbers, strict=True)
        )
        found.append(Finding(f"{name}, run {run + 1}", values, (), ()))
    return tuple(found)


def _clocking(model: ProfileModel, noise: Noise, best: Hypothesis) -> tuple[Finding, ...]:
    """Of each run: what it was turned back by, what all runs share, and what its tangents tell beside."""
    ((_, common, unsure),) = best.datum()
    white = slopes(model, model.datum, best.active) * per_run(model.rows.run) / noise.sigma[:, None]
    left = -np.linalg.lstsq(white, model.residual(best.active) / noise.sigma, rcond=None)[0]
    angle = (model.own + common[0] + left) / UNITS["deg"]
    sigma = np.hypot(unsure[0], 1 / np.linalg.norm(white, axis=0)) / UNITS["deg"]
    return tuple(
        Finding(f"clocking, run {run + 1}", (Value("clocking_deg", float(a), float(s), "deg"),), (), ())
        for run, (a, s) in enumerate(zip(angle, sigma, strict=True))
    )


def _held_out(
    record: Record, model: Model, build: Build, noise: Noise, best: Hypothesis, run: int
) -> tuple[Array, Array]:
    """Residual of a run with effects from the others: datum refitted, without and with their form error."""
    inside = model.rows.run != run
    train = build(record.only(np.setdiff1d(np.arange(record.runs), [run])))
    test = build(record.only(np.array([run])))
    learn, judged = (
        Noise(noise.sigma[rows], noise.correlation, noise.slip * (part.rows.runs > 1), part.rows.runs)
        for rows, part in ((inside, train), (~inside, test))
    )
    evidence = Evidence(train, learn, grid=(best.spectrum,))
    active = _refit(train, evidence, best)
    form = evidence.form_error(evidence.whiten(train.residual(active)), 0)
    own = test.residual(active)
    # Of a datum that is no column, the run left out has its own value too.
    turned = slopes(test, test.datum, active)
    return registered(test, judged, own, turned), registered(test, judged, own - test.form @ form, turned)


def _refit(model: Model, evidence: Evidence, best: Hypothesis) -> Active:
    """The best subset fitted to some of the runs; a step within one run is no use for another."""
    known = {e.key for e in model.catalogue}
    effects = tuple(e for e in best.effects if e.key in known or "run" not in e.name)
    return fit(model, evidence, effects, best.active, Search(1)).active


def _by_run(residual: Array, model: Model) -> Array:
    return np.array([_rms(residual[model.rows.run == run]) for run in range(model.rows.runs)])


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))
