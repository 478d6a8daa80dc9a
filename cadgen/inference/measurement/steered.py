"""Verdict on tracks with logged steering, by runs left out."""

from collections.abc import Callable

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import Active
from cadgen.inference.measurement.findings import Finding, PathCandidate, PathDiagnosis, PathError, PathErrors, Value
from cadgen.inference.measurement.leave_out import LEAST_RUNS, LeftOut, Trial, leave_runs_out
from cadgen.inference.measurement.model import Model
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.verdict import Judgement, Verdict, unclaimed, within_words
from cadgen.progress import Progress, silent

# Effects must take away this share of the path error on runs left out to be named.
LEAST_GAIN = 0.1


def diagnose_steered(record: Record, build: Callable[[Record], Model], progress: Progress = silent) -> PathDiagnosis:
    """Trace the path error of logged runs to effects; of fewer than `LEAST_RUNS` runs nothing is claimed."""
    progress(f"{record.source}: leaving runs out")
    model = build(record)
    left_out = leave_runs_out(record, build)
    chosen = left_out.chosen
    findings = _findings(chosen)
    active = _active(chosen)
    as_logged = model.residual([])
    return PathDiagnosis(
        source=record.source,
        kind=record.kind,
        unit=model.unit,
        judgement=_judgement(left_out),
        findings=findings,
        candidates=tuple(
            PathCandidate(tuple(e.name for e in t.effects), t.error, _findings(t), tuple(t.held_out.tolist()))
            for t in left_out.trials
        ),
        residual=PathError(float(left_out.before.mean()), float(chosen.fitted.mean()), chosen.error),
        per_run=PathErrors(
            left_out.before,
            chosen.fitted,
            chosen.held_out,
            np.array([np.sqrt(2 * np.mean(as_logged[model.rows.run == run] ** 2)) for run in range(record.runs)]),
        ),
        place=model.rows.place,
        run=model.rows.run.astype(float),
        before=_registered(model, []),
        after=_registered(model, active),
        active=active,
        measured=model.measured,
    )


def _active(trial: Trial) -> Active:
    cuts = np.cumsum([len(e.parameters) for e in trial.effects])[:-1]
    return list(zip(trial.effects, np.split(trial.values, cuts), strict=True)) if trial.effects else []


def _findings(trial: Trial) -> tuple[Finding, ...]:
    sigmas = np.split(trial.sigma, np.cumsum([len(e.parameters) for e in trial.effects])[:-1])
    return tuple(
        Finding(
            effect.name,
            tuple(
                Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
                for p, v, s in zip(effect.parameters, value, sigma, strict=True)
            ),
            effect.twins,
            tuple(p.name for p in effect.parameters if p.name in trial.at_bound),
            sigmas=trial.sigmas,
        )
        for (effect, value), sigma in zip(_active(trial), sigmas, strict=False)
    )


def _registered(model: Model, active: Active) -> Array:
    """The residual less the start pose of each run."""
    residual = model.residual(active)
    return np.asarray(residual - model.offsets @ np.linalg.lstsq(model.offsets, residual, rcond=None)[0])


def _judgement(left_out: LeftOut) -> Judgement:
    chosen, rivals, runs = left_out.chosen, left_out.rivals, len(left_out.before)
    before = float(left_out.before.mean())
    gained = 1 - chosen.error / before if before > 0 else 0.0
    names = tuple(e.name for e in chosen.effects)
    common = set(names).intersection(*({e.name for e in t.effects} for t in rivals))
    verdict: Verdict
    if not names or gained < LEAST_GAIN:
        verdict, common, sentence = Verdict.NONE, set(), "No effect lowers the path error on runs left out."
    elif runs < LEAST_RUNS:
        verdict, common = Verdict.AMBIGUOUS, set()
        sentence = f"Consistent with {_names(chosen)}, but too few runs to tell it from chance."
    elif rivals:
        verdict = Verdict.AMBIGUOUS
        sentence = f"Consistent with {_names(chosen)}; or {'; or '.join(_names(t) for t in rivals)}."
    else:
        verdict = Verdict.TRACED if len(names) == 1 else Verdict.COMBINATION
        sentence = (
            f"Traced to {_names(chosen)}: the path error on runs left out falls from "
            f"{before:.0f} to {chosen.error:.0f} mm."
        )
    likely = [chosen, *rivals] if verdict != Verdict.NONE else []
    limits: tuple[str, ...] = ()
    if runs < LEAST_RUNS:
        given = "one run" if runs == 1 else f"{runs} runs"
        limits = (f"{given} only: give at least {LEAST_RUNS}, to judge on runs left out",)
    separate = {e.name: e.separated_by for t in likely for e in t.effects}
    judgement = Judgement(
        verdict=verdict,
        sentence=sentence,
        claimed=tuple(sorted(common)),
        reported=tuple(sorted({e.name for t in likely for e in t.effects})),
        rivals=tuple(tuple(e.name for e in t.effects) for t in rivals),
        separate=tuple(f"{name}: {how}" for name, how in separate.items()),
        limits=limits,
    )
    findings = _findings(chosen)
    for finding in findings:
        if finding.at_bound:
            verb = "is" if len(finding.at_bound) == 1 else "are"
            why = f"{' and '.join(finding.at_bound)} of {finding.effect} {verb} on the bound of what can be"
            judgement = unclaimed(judgement, [finding.effect], why)
    unsure = [finding.effect for finding in findings if finding.within_error]
    return unclaimed(judgement, unsure, f"{within_words(chosen.sigmas)}, which {runs} runs cannot tell from chance")


def _names(trial: Trial) -> str:
    return " and ".join(e.name for e in trial.effects)
