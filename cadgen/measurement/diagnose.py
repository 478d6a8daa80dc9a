"""From measured data to a verdict: noise, search, comparison of the rivals, and a test on runs left out."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from cadgen.measurement.effects.base import UNITS, Active, Array, Effect
from cadgen.measurement.evidence import Evidence
from cadgen.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.measurement.models.base import Model
from cadgen.measurement.noise import Noise, estimate_noise
from cadgen.measurement.record import Record
from cadgen.measurement.search import find
from cadgen.measurement.verdict import Judgement, judge, registered

Build = Callable[[Record], Model]


@dataclass(frozen=True, slots=True)
class Value:
    """One fitted number in the unit its name ends in, with its standard deviation."""

    name: str
    value: float
    sigma: float
    unit: str


@dataclass(frozen=True, slots=True)
class Finding:
    """An effect with its numbers, and what it cannot be told from."""

    effect: str
    values: tuple[Value, ...]
    twins: tuple[str, ...]
    at_bound: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Candidate:
    """A row of the table of candidates: a subset and how much worse than the best it is."""

    effects: tuple[str, ...]
    score: float
    loose_score: float


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


@dataclass(frozen=True, slots=True, kw_only=True)
class Diagnosis:
    """What one record says.

    Attributes:
        source, kind, unit: of the record; residuals are in the unit.
        judgement: the class of verdict, what is claimed, and one sentence.
        findings: the effects of the best subset, shapes among them.
        datum: fitted freedoms, never claimed.
        candidates: the best subsets, best first.
        residual: before and after.
        correlation: of the noise between neighbours.
        place: of each measured row, shape (n,), internal units.
        run: of each row, shape (n,).
        before, after: residual of each row, datum fitted, internal units.
    """

    source: str
    kind: str
    unit: str
    judgement: Judgement
    findings: tuple[Finding, ...]
    datum: tuple[Finding, ...]
    candidates: tuple[Candidate, ...]
    residual: Residual
    correlation: float
    place: Array
    run: Array
    before: Array
    after: Array

    @property
    def verdict(self) -> str:
        """The class of verdict."""
        return self.judgement.verdict


def diagnose(record: Record, build: Build) -> Diagnosis:
    """Trace what a record shows to effects, or say why not.

    Args:
        record: measured data of one kind.
        build: makes the forward model of a record; called again for records with some runs left out.
    """
    model = build(record)
    noise = estimate_noise(model, model.residual([(e, e.start) for e in model.datum]))
    evidence = Evidence(model, noise)
    found = find(model, evidence)
    judgement, best = judge(model, evidence, noise, found)
    none = next(h for h in found if not h.effects)
    before, after = (registered(model, noise, model.residual(h.active)) for h in (none, best))
    held_out, repeating = _held_out(record, model, build, noise, best)
    scale = UNITS[model.unit]
    return Diagnosis(
        source=record.source,
        kind=model.kind,
        unit=model.unit,
        judgement=judgement,
        findings=tuple(_finding(best, *entry) for entry in best.values()),
        datum=tuple(_finding(best, *entry) for entry in best.datum()),
        candidates=tuple(
            Candidate(tuple(e.name for e in h.effects), h.score - found[0].score, h.loose_score - found[0].score)
            for h in found
        ),
        residual=Residual(
            before=_rms(before) / scale,
            after=_rms(after) / scale,
            held_out=held_out / scale,
            held_out_repeating=repeating / scale,
            noise=noise.rms / scale,
        ),
        correlation=noise.correlation,
        place=model.rows.place,
        run=model.rows.run.astype(float),
        before=before,
        after=after,
    )


def _finding(best: Hypothesis, effect: Effect, values: Array, sigma: Array) -> Finding:
    told = tuple(
        Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
        for p, v, s in zip(effect.parameters, values, sigma, strict=True)
    )
    at_bound = tuple(p.name for p in effect.parameters if p.name in best.at_bound)
    return Finding(effect.name, told, effect.twins, at_bound)


def _held_out(record: Record, model: Model, build: Build, noise: Noise, best: Hypothesis) -> tuple[float, float]:
    """RMS on each run in turn with effects from the others: datum refitted, without and with their form error."""
    if record.runs < 2:
        return np.nan, np.nan
    squares, repeating = [], []
    for run in range(record.runs):
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
        squares.append(registered(test, judged, own) ** 2)
        repeating.append(registered(test, judged, own - test.form @ form) ** 2)
    return float(np.sqrt(np.mean(np.concatenate(squares)))), float(np.sqrt(np.mean(np.concatenate(repeating))))


def _refit(model: Model, evidence: Evidence, best: Hypothesis) -> Active:
    """The best subset fitted to some of the runs; a step within one run is no use for another."""
    known = {e.key for e in model.catalogue}
    effects = tuple(e for e in best.effects if e.key in known or "run" not in e.name)
    return fit(model, evidence, effects, best.active, Search(1, 0, 0, 0)).active


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))
