"""From measured data to a verdict: noise, search, comparison of the rivals, and a test on runs left out."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import UNITS, Active, Effect
from cadgen.deviations.quantities import Quantity
from cadgen.measurement.doubt import doubted, refuse_too_few, resolved, unfit
from cadgen.measurement.evidence import Evidence
from cadgen.measurement.findings import Candidate, EvidenceDiagnosis, Finding, HeldOut, PerRun, Residual, Value
from cadgen.measurement.friction import with_friction_judged, with_known_play
from cadgen.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.measurement.models.base import Model, repeating, slopes
from cadgen.measurement.noise import Noise, estimate_noise
from cadgen.measurement.record import Datum, Record
from cadgen.measurement.search import find
from cadgen.measurement.verdict import Judgement, judge, registered

Build = Callable[[Record], Model]
Step = Callable[[str], None]
# Noise that falls to this share once the likeliest effects are taken out was theirs.
NOT_NOISE = 0.8
# A discrepancy is said if one of its numbers is so many standard deviations from nothing.
SURE_SIGMAS = 4.0
# Verdicts beside which it counts that a quantity is not named.
SOUND = ("none", "traced", "combination")


def diagnose(
    record: Record, build: Build, step: Step = lambda text: None, play: tuple[float, float] | None = None
) -> EvidenceDiagnosis:
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
    noise = resolved(record, estimate_noise(model, model.residual([(e, e.start) for e in model.datum])))
    step(f"{record.source}: comparing all small subsets of {len(model.catalogue)} effects")
    found = find(model, evidence := Evidence(model, noise))
    less = resolved(record, estimate_noise(model, model.residual(found[0].active)))
    if less.rms < NOT_NOISE * noise.rms:
        # Runs that were taken differently differ by an effect, and not by noise alone.
        noise = less
        found = find(model, evidence := Evidence(model, noise))
    judgement, best = judge(model, evidence, noise, found)
    found_alone = best
    best, another = with_known_play(model, evidence, best, play)
    play_known = best is not found_alone
    none = next(h for h in found if not h.effects)
    before, after = (registered(model, noise, model.residual(h.active)) for h in (none, best))
    aside, unnamed = _discrepancy(model, evidence, best)
    left = registered(model, noise, model.residual(best.active) - aside)
    judgement = doubted(judgement, record, model, noise, best, left, unfit(model, evidence, noise, best))
    judgement = with_friction_judged(judgement, best, play_known=play_known)
    if another:
        judgement = replace(judgement, limits=(*judgement.limits, another))
    datum, held, against = _datum(record.kind.datum, model, noise, best)
    judgement = replace(judgement, limits=(*judgement.limits, *against))
    held_out = []
    for run in range(record.runs) if record.runs > 1 else ():
        step(f"{record.source}: run {run + 1} left out")
        held_out.append(_held_out(record, model, build, noise, best, run))
    residual, per_run = _figures(model, noise, before, after, held_out)
    return EvidenceDiagnosis(
        source=record.source,
        kind=record.kind,
        unit=model.unit,
        judgement=judgement,
        findings=tuple(_finding(best, *entry) for entry in best.values()),
        datum=datum,
        held=held,
        discrepancy=unnamed,
        candidates=tuple(
            Candidate(
                tuple(e.name for e in h.effects),
                h.score - found[0].score,
                tuple(_finding(h, *entry) for entry in h.values()),
            )
            for h in found
        ),
        residual=residual,
        per_run=per_run,
        correlation=noise.correlation,
        place=model.rows.place,
        run=model.rows.run.astype(float),
        before=before,
        after=after,
        active=[(e, v) for e, v in best.active if e in best.effects],
        measured=model.measured,
        unnamed=_unnamed(record.kind.absences, model, evidence, judgement, best),
        play_known=play_known,
    )


def _figures(
    model: Model, noise: Noise, before: Array, after: Array, held_out: list[tuple[Array, Array]]
) -> tuple[Residual, PerRun]:
    """Root mean squares of all rows and of each run, in the record's unit; `held_out` as of `_held_out`."""
    scale = UNITS[model.unit]
    whole, less = ([pair[k] for pair in held_out] for k in (0, 1))
    left_out = HeldOut(*(_rms(np.concatenate(parts)) / scale for parts in (whole, less))) if held_out else None
    return Residual(_rms(before) / scale, _rms(after) / scale, noise.rms / scale, left_out), PerRun(
        _by_run(before, model) / scale,
        _by_run(after, model) / scale,
        np.array([_rms(part) for part in whole]) / scale if held_out else None,
    )


def _unnamed(
    quantities: tuple[Quantity, ...], model: Model, evidence: Evidence, judgement: Judgement, best: Hypothesis
) -> dict[Quantity, Finding]:
    """How much of some quantities there could be where several runs and a sound verdict name none."""
    if model.rows.runs < 2 or judgement.verdict not in SOUND:
        return {}
    unnamed = {}
    for effect in model.catalogue:
        quantity = effect.quantity
        if quantity not in quantities or effect in best.effects or quantity is None or quantity in unnamed:
            continue
        if effect.beside and effect.beside.name not in judgement.claimed:
            continue
        # With the effects found free beside it, what they could hide of it widens its error.
        beside = fit(model, evidence, (*best.effects, effect), best.active, Search(1))
        unnamed[quantity] = next(_finding(beside, *entry) for entry in beside.values() if entry[0] == effect)
    return unnamed


def _finding(best: Hypothesis, effect: Effect, values: Array, sigma: Array) -> Finding:
    numbers = tuple(
        Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
        for p, v, s in zip(effect.parameters, values, sigma, strict=True)
    )
    at_bound = tuple(p.name for p in effect.parameters if p.name in best.at_bound)
    return Finding(effect.name, numbers, effect.twins, at_bound, effect.given)


def _discrepancy(model: Model, evidence: Evidence, best: Hypothesis) -> tuple[Array, Finding | None]:
    """What the discrepancy adds to the best subset's residual, and its numbers where they are sure."""
    of, orders = model.discrepancy, model.form.shape[1]
    spectrum = evidence.grid.index(best.spectrum)
    values = evidence.repeating(evidence.whiten(model.residual(best.active)), spectrum)[orders:]
    sigma = evidence.unsure(spectrum)[orders:]
    shown = tuple(
        Value(name, float(v / UNITS[unit]), float(s / UNITS[unit]), unit)
        for (name, unit), v, s in zip(of.numbers, values, sigma, strict=False)
    )
    sure = any(abs(v.value) > SURE_SIGMAS * v.sigma for v in shown)
    return of.columns @ values, Finding(of.words, shown, (), ()) if sure else None


def _datum(
    datum: Datum, model: Model, noise: Noise, best: Hypothesis
) -> tuple[tuple[Finding, ...], str, tuple[str, ...]]:
    """The datum freedoms of each run beside the effects, what was known of them, and what speaks against that."""
    if not datum.numbers:
        return (), "", ()
    fitted = (datum.fit or _offsets)(model, model.residual(best.active), noise.sigma, best.active, best.datum())
    held, against = datum.notes(model, *fitted) if datum.notes else ("", ())
    found = tuple(
        Finding(
            f"{datum.name}, run {run + 1}",
            tuple(
                Value(name, float(v / UNITS[unit]), float(s / UNITS[unit]), unit)
                for v, s, (name, unit) in zip(values, sigmas, datum.numbers, strict=True)
            ),
            (),
            (),
        )
        for run, (values, sigmas) in enumerate(zip(*fitted, strict=True))
    )
    return found, held, against


def _offsets(
    model: Model, residual: Array, sigma: Array, active: Active, datum: list[tuple[Effect, Array, Array]]
) -> tuple[Array, Array]:
    """Values of the linear freedoms of each run and their standard deviations; see `record.DatumFit`."""
    white = model.offsets / sigma[:, None]
    values = np.linalg.lstsq(white, residual / sigma, rcond=None)[0]
    error = np.sqrt(np.diag(np.linalg.pinv(white.T @ white)))
    shape = (model.rows.runs, -1)
    return np.asarray(values, dtype=float).reshape(shape), np.asarray(error, dtype=float).reshape(shape)


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
    repeats = evidence.repeating(evidence.whiten(train.residual(active)), 0)
    own = test.residual(active)
    # Of a datum that is no column, the run left out has its own value too.
    turned = slopes(test, test.datum, active)
    return registered(test, judged, own, turned), registered(test, judged, own - repeating(test) @ repeats, turned)


def _refit(model: Model, evidence: Evidence, best: Hypothesis) -> Active:
    """The best subset fitted to some of the runs; a step within one run is no use for another."""
    known = {e.key for e in model.catalogue}
    effects = tuple(e for e in best.effects if e.key in known or not e.one_run)
    return fit(model, evidence, effects, best.active, Search(1)).active


def _by_run(residual: Array, model: Model) -> Array:
    return np.array([_rms(residual[model.rows.run == run]) for run in range(model.rows.runs)])


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))
