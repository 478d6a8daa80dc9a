"""Choose a subset by how well it predicts runs it was not fitted to: for tracks whose errors accumulate.

Where every small error of the floor and the wheels adds up along the path, residuals are not draws of a noise: the
runs are. Each subset of up to three effects is fitted to all runs but one, for every run, and judged by the path
error of the run left out, its start pose registered; the best of these grow into larger ones. The smallest subset
within one standard error (over runs, paired) or a few per cent of the best is told; others as small, and as good as
that one, are its rivals (Breiman and others 1984, sec. 3.4.3).

The verdict names effects that take away a part of the path error on runs left out.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect, activated
from cadgen.inference.measurement.findings import (
    Finding,
    FormulaProposal,
    PathCandidate,
    PathDiagnosis,
    PathError,
    PathErrors,
)
from cadgen.inference.measurement.formulas import proposal
from cadgen.inference.measurement.hypothesis import numbers_on_bound
from cadgen.inference.measurement.model import Model, slopes
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.repeats import (
    LEAST_ALIKE,
    STATIONS,
    Complex,
    Repeats,
    disturbances,
    one_path,
    repeats,
)
from cadgen.inference.measurement.verdict import (
    Judgement,
    Verdict,
    names_of,
    separations,
    sigmas_of,
    unclaimed,
    within_words,
)
from cadgen.messages import Message, joined
from cadgen.progress import Progress, silent

# All subsets of so many effects are tried; larger ones only beyond the best of those with one effect less.
TRIED_SUBSET, LARGEST_SUBSET = 3, 6
GROWN = 4
# Sizes at which the search of a single number begins on each side, from the usual one to the greatest, in equal
# ratios: a steering that was logged in another scale is off by several or by hundred times, which no search reaches
# from nothing.
STARTS = 25
LEAST_RUNS = 4
# A smaller subset must predict at least this many standard errors worse to be given up.
STANDARD_ERRORS = 1.0
# Path errors within this share of each other are the same, however steadily they differ: models err by as much, and
# what takes away less is not named.
SAME = 0.1
# Share of a run's extent that a path error may have: measured cars keep to 3 to 6 % once they are calibrated, and are
# 26 to 43 % off before.
LEFT_OF_EXTENT = 0.15


@dataclass(frozen=True)
class LeftOutFit:
    """A subset and its path error on runs left out.

    Attributes:
        effects: the subset.
        values: fitted to all runs, internal units.
        sigma: by the jackknife over runs.
        sigmas: how many of these a number must be from nothing to be sure, for so few runs and so many effects.
        at_bound: names of the numbers that the fit drives to the bound of what can be.
        held_out: path error rms of each run when left out, shape (runs,), mm.
        fitted: the same when all runs are fitted.
    """

    effects: tuple[Effect, ...]
    values: Array
    sigma: Array
    sigmas: float
    at_bound: tuple[str, ...]
    held_out: Array
    fitted: Array

    @property
    def error(self) -> float:
        """Mean over runs, mm."""
        return float(self.held_out.mean())


@dataclass(frozen=True)
class LeftOut:
    """Result of predicting runs that were left out.

    Attributes:
        before: path error rms of each run of the bare design, registered, mm.
        extent: rms distance of the measured points of a run from their middle, mean over runs, mm.
        chosen: the smallest subset among the best.
        rivals: others no larger that predict as well as that one, best first.
        trials: all subsets, best first.
    """

    before: Array
    extent: float
    chosen: LeftOutFit
    rivals: tuple[LeftOutFit, ...]
    trials: tuple[LeftOutFit, ...]


def leave_runs_out(record: Record, build: Callable[[Record], Model]) -> LeftOut:
    """Compare all subsets of a model's catalogue.

    Args:
        record: with its runs.
        build: makes the forward model of some of the runs; called once for each run.

    Fewer than `LEAST_RUNS` runs say nothing sure; with one run, that run is judged as it was fitted.
    """
    runs = [LoggedRun.of(build(record.only(np.array([k])))) for k in range(record.runs)]
    catalogue = runs[0].model.catalogue
    before = np.array([run.error([]) for run in runs])
    sigmas = sigmas_of(len(runs) - 1, len(catalogue))
    trials = [LeftOutFit((), np.empty(0), np.empty(0), sigmas, (), before, before)]
    last = list(trials)
    for size in range(1, min(LARGEST_SUBSET, len(catalogue)) + 1):
        if size > TRIED_SUBSET:
            grown = sorted(last, key=lambda t: t.error)[:GROWN]
            sets = {frozenset(t.effects) | {effect} for t in grown for effect in catalogue if effect not in t.effects}
            subsets = [tuple(e for e in catalogue if e in chosen) for chosen in sets]
        else:
            subsets = list(combinations(catalogue, size))
        last = [_trial(runs, subset, last, sigmas) for subset in subsets]
        trials += last
    trials.sort(key=lambda t: t.error)
    best = trials[0]
    close = [t for t in trials if _as_good(t, best)]
    chosen = min(close, key=lambda t: (len(t.values), t.error))
    rivals = [t for t in trials if t is not chosen and len(t.values) <= len(chosen.values) and _as_good(t, chosen)]
    extent = float(np.mean([run.extent for run in runs]))
    return LeftOut(before, extent, chosen, tuple(rivals), tuple(trials))


def _as_good(trial: LeftOutFit, best: LeftOutFit) -> bool:
    """Whether a subset predicts as well as another one, but for a few per cent or the standard error.

    The standard error is that of the paired difference over runs.
    """
    difference, runs = trial.held_out - best.held_out, len(best.held_out)
    if trial.error <= best.error * (1 + SAME):
        return True
    if runs < 2:
        return not difference.any()
    error = float(difference.std(ddof=1)) / np.sqrt(runs)
    return not error > 0 or float(difference.mean()) / error <= STANDARD_ERRORS


@dataclass(frozen=True)
class LoggedRun:
    """Run with its model and a basis of its start pose's columns."""

    model: Model
    pose: Array

    @classmethod
    def of(cls, model: Model) -> "LoggedRun":
        """Take the model of one run."""
        return cls(model, np.linalg.qr(model.offsets)[0])

    def registered(self, columns: Array) -> Array:
        """Take the start pose out of columns.

        Args:
            columns: changes of the coordinates of all rows, shape (n, ...), mm.
        """
        return np.asarray(columns - self.pose @ (self.pose.T @ columns))

    def residual(self, active: Active) -> Array:
        """Residual with some effects less the start pose, shape (n,), mm."""
        return self.registered(self.model.residual(active))

    def tangents(self, effects: tuple[Effect, ...], active: Active) -> Array:
        """Change of the path for each number of some effects, less the start pose."""
        return -self.registered(slopes(self.model, effects, active))

    @property
    def extent(self) -> float:
        """RMS distance of the measured points from their middle, along and across the run's own direction, mm."""
        assert self.model.measured is not None
        return float(np.sqrt(2 * np.mean(self.registered(self.model.measured) ** 2)))

    def error(self, active: Active) -> float:
        """RMS distance from the path; x and y are one row each."""
        return float(np.sqrt(2 * np.mean(self.residual(active) ** 2)))


def _starts(effects: tuple[Effect, ...], smaller: Sequence[LeftOutFit]) -> list[Array]:
    """Values from which the search of a subset begins: fits with one effect less; of a single number, its range."""
    if len(effects) == 1:
        (effect,) = effects
        start = np.asarray(effect.start, dtype=float)
        if len(start) > 1:
            return [start]
        (low,), (high,) = effect.bounds
        usual = effect.parameters[0].spread
        sides = [bound for bound in (low, high) if bound]
        sizes = np.concatenate([np.geomspace(np.sign(b) * min(usual, abs(b)), b, STARTS) for b in sides])
        return [start, *sizes[:, None]]
    starts = []
    for fit in smaller:
        if set(fit.effects) < set(effects):
            known = dict(activated(fit.effects, fit.values))
            starts.append(np.concatenate([known.get(effect, effect.start) for effect in effects]))
    return starts or [np.concatenate([effect.start for effect in effects])]


def single_fit(runs: list[LoggedRun], effect: Effect) -> Array:
    """Values of one effect fitted to all runs, internal units."""
    return _trial(runs, (effect,), (), 0.0).values


def _trial(
    runs: list[LoggedRun], effects: tuple[Effect, ...], smaller: Sequence[LeftOutFit], sigmas: float
) -> LeftOutFit:
    bounds = np.concatenate([e.bounds for e in effects], axis=1)

    def off(values: Array) -> Array:
        return np.concatenate([run.residual(activated(effects, values)) for run in runs])

    def tangents(values: Array) -> Array:
        return np.concatenate([run.tangents(effects, activated(effects, values)) for run in runs])

    # Not by `hypothesis.least_squares`: in logs that say little, the place in a valley where a fit stops decides.
    starts = _starts(effects, smaller)
    x = least_squares(
        off,
        min(starts, key=lambda start: float(np.sum(off(start) ** 2))) if len(starts) > 1 else starts[0],
        jac=tangents,
        bounds=(bounds[0], bounds[1]),
        x_scale=np.concatenate([e.steps for e in effects]),
        ftol=1e-6,
        max_nfev=20,
    ).x
    # One Gauss-Newton step from the fit to all runs gives the fit to all but one; the run left out is then driven
    # exactly with it.
    active = activated(effects, x)
    jacobians = [run.tangents(effects, active) for run in runs]
    grams = [j.T @ j for j in jacobians]
    pulls = [j.T @ run.residual(active) for j, run in zip(jacobians, runs, strict=True)]
    whole = np.sum(grams, axis=0)
    left = np.array(
        [x + np.linalg.lstsq(whole - gram, pull, rcond=1e-10)[0] for gram, pull in zip(grams, pulls, strict=True)]
    )
    # Before they are held within their bounds: held there, all would agree.
    spread = left - np.mean(left, axis=0)
    return LeftOutFit(
        effects=effects,
        values=x,
        sigma=np.sqrt((len(runs) - 1) / len(runs) * np.sum(spread**2, axis=0)),
        sigmas=sigmas,
        at_bound=numbers_on_bound(effects, x),
        held_out=np.array(
            [run.error(activated(effects, values)) for run, values in zip(runs, np.clip(left, *bounds), strict=True)]
        ),
        fitted=np.array([run.error(active) for run in runs]),
    )


# What repeats is said from this share of a run's extent on: models err by as much.
LEAST_REPEATED = 0.01
# A smaller one is said, too, where it is this share of the path error of the bare design.
SHARE_REPEATED = 0.1
# Places along a run at which what repeats may begin.
KNOTS = 12
# Effects must take away this share of the path error on runs left out to be named.
LEAST_GAIN = 0.1


def diagnose_logged(record: Record, build: Callable[[Record], Model], progress: Progress = silent) -> PathDiagnosis:
    """Trace the path error of logged runs to effects; of fewer than `LEAST_RUNS` runs nothing is claimed."""
    progress(Message("{source}: leaving runs out", source=record.source))
    model = build(record)
    left_out = leave_runs_out(record, build)
    wider = np.hypot(left_out.chosen.sigma, among_rivals(left_out))
    left_out = replace(left_out, chosen=replace(left_out.chosen, sigma=wider))
    active = activated(left_out.chosen.effects, left_out.chosen.values)
    as_logged = model.residual([])
    before, after = _registered(model, model.residual([])), _registered(model, model.residual(active))
    assert model.measured is not None
    paths = _along(model.measured, model.rows.run)
    again = [
        r
        for r in repeats(paths, _along(after, model.rows.run))
        if r.rms > min(LEAST_REPEATED * left_out.extent, SHARE_REPEATED * float(left_out.before.mean()))
    ]
    if again and active:
        wider = np.hypot(left_out.chosen.sigma, _unsure(model, left_out.chosen, one_path(paths), again))
        left_out = replace(left_out, chosen=replace(left_out.chosen, sigma=wider))
    chosen, judgement = left_out.chosen, _judgement(left_out)
    findings = _findings(chosen)
    if judgement.verdict is Verdict.NONE:
        again = repeats(paths, _along(before, model.rows.run))
        again = [r for r in again if r.rms > LEAST_REPEATED * left_out.extent]
    groups = one_path(paths)
    judgement = _with_what_repeats(judgement, again, driven=len(groups[0]) >= LEAST_ALIKE)
    if again and len(groups) == 1:
        why = Message("on one path an effect is not told from what repeats there; drive another path, too")
        judgement = unclaimed(judgement, judgement.claimed, why)
    judgement = replace(judgement, limits=(*judgement.limits, *model.notes))
    formula = proposal(model, chosen.effects, active, after, one_path(paths)) if again else None
    if formula is not None:
        judgement = replace(judgement, limits=(*judgement.limits, _proposed(formula, record)))
    return PathDiagnosis(
        source=record.source,
        kind=record.kind,
        unit=model.unit,
        judgement=judgement,
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
        before=before,
        after=after,
        active=active,
        measured=model.measured,
        proposal=formula,
    )


def _proposed(formula: FormulaProposal, record: Record) -> Message:
    """Proposal of a formula in words, and how to accept it."""
    (number,) = formula.finding.values
    words = Message(
        'a formula that no effect of the catalogue has predicts it: "{name}" with {number} {value:.3g} ± {sigma:.2g} '
        "lowers the path error on paths left out from {before:.0f} to {after:.0f} mm; to accept it as an effect of "
        'this car, put it with kind = "{kind}" and place = "noted" in [[as_built.effects]], and calibrate again',
        name=formula.finding.effect,
        number=number.name,
        value=number.value,
        sigma=number.sigma,
        before=formula.before,
        after=formula.after,
        kind=record.kind.code,
    )
    if not formula.rivals:
        return words
    return Message(
        "{words}; or one that does nearly as well: {rivals}", words=words, rivals=joined(formula.rivals, ", ")
    )


def _along(coordinates: Array, run: NDArray[np.intp]) -> list[Complex]:
    """Places of each run as x + iy, at `STATIONS` places along it, mm.

    Args:
        coordinates: first the x and then the y of each run, shape (n,), mm.
        run: number of the run of each, shape (n,).
    """
    along, out = np.linspace(0.0, 1.0, STATIONS), []
    for number in range(int(run.max()) + 1):
        both = coordinates[run == number].reshape(2, -1)
        x, y = (np.interp(along, np.linspace(0.0, 1.0, len(axis)), axis) for axis in both)
        out.append(x + 1j * y)
    return out


def among_rivals(left_out: LeftOut) -> Array:
    """Root mean square by which rivals have other values for the numbers of the chosen subset, shape (k,).

    A rival without the effect says nothing of its numbers.
    """
    chosen = left_out.chosen
    theirs = [dict(activated(rival.effects, rival.values)) for rival in left_out.rivals]
    apart: list[Array] = []
    for effect, values in activated(chosen.effects, chosen.values):
        others = [np.asarray(each[effect]) - np.asarray(values) for each in theirs if effect in each]
        apart.append(np.sqrt(np.mean(np.square(others), axis=0)) if others else np.zeros(len(values)))
    return np.concatenate(apart) if apart else np.zeros(0)


def _unsure(model: Model, chosen: LeftOutFit, groups: list[list[int]], again: list[Repeats]) -> Array:
    """Standard deviations of the numbers of a subset by what repeats without a name, internal units, shape (k,).

    Runs of one path share it, so that leaving one of them out does not show what it does to the numbers. It is taken as
    a disturbance of heading and travel that begins anew at each of `KNOTS` places: from place u on, the path z is off
    by i (z - z(u)) and by z - z(u). With their columns D, registered, and the slopes J of the numbers,

        cov = a^2 J+ D D' J+',   a^2 |(1 - J J+) D|^2 = square of what is seen to repeat.
    """
    run, coordinates = model.rows.run, model.measured
    assert coordinates is not None
    slope = _registered(model, slopes(model, chosen.effects, activated(chosen.effects, chosen.values)))
    inverse = np.linalg.pinv(slope, rcond=1e-10)
    covariance, seen, left = np.zeros((slope.shape[1], slope.shape[1])), 0.0, 0.0
    size = {number: r.rms for r in again for number in r.runs}
    for group in groups:
        columns = np.zeros((len(run), 2 * KNOTS))
        for number in group:
            mine = np.flatnonzero(run == number)
            x, y = coordinates[mine].reshape(2, -1)
            columns[mine] = disturbances(x + 1j * y, KNOTS)
            seen += len(x) * size.get(number, 0.0) ** 2
        # The start of each run has a direction of its own; what repeats is relative to that.
        columns = _registered(model, columns)
        answer = inverse @ columns
        rest = columns - slope @ answer
        left += float(np.sum(rest[np.isin(run, [n for n in group if n in size])] ** 2))
        covariance += answer @ answer.T
    return np.asarray(np.sqrt(seen / max(left, 1e-300) * np.diag(covariance)))


def _with_what_repeats(judgement: Judgement, again: list[Repeats], *, driven: bool) -> Judgement:
    """Judgement that says what is left without a name: nothing differs from the design only where noise explains it.

    Args:
        judgement: on the effects.
        again: what repeats beside them.
        driven: whether a path was driven often enough to tell noise from what repeats.
    """
    words = tuple(
        Message(
            "of the {left:.0f} mm that are left on runs {runs}, which are of one path, {rms:.0f} mm repeat, at most "
            "{size:.0f} mm at {share:.0f} % of the run: something that no effect of the catalogue makes",
            left=r.left,
            runs=joined((str(run + 1) for run in r.runs), ", "),
            rms=r.rms,
            size=r.size,
            share=100 * r.place,
        )
        for r in again
    )
    judgement = replace(judgement, limits=(*judgement.limits, *words))
    if judgement.verdict is Verdict.NONE:
        if words:
            sentence = Message("No effect of the catalogue lowers the path error, but something repeats in it.")
            return replace(judgement, verdict=Verdict.UNTRACED_SHAPE, sentence=sentence)
        if driven:
            return judgement
        why = Message(
            "no path was driven {least} times, so that what repeats cannot be told from noise", least=LEAST_ALIKE
        )
        return replace(judgement, verdict=Verdict.AMBIGUOUS, limits=(*judgement.limits, why))
    if any(r.most for r in again) and judgement.verdict in (Verdict.TRACED, Verdict.COMBINATION):
        return replace(judgement, verdict=Verdict.PARTIAL)
    return judgement


def _findings(trial: LeftOutFit) -> tuple[Finding, ...]:
    values, sigmas = (activated(trial.effects, each) for each in (trial.values, trial.sigma))
    return tuple(
        Finding.of(effect, value, sigma, trial.at_bound, trial.sigmas)
        for (effect, value), (_, sigma) in zip(values, sigmas, strict=True)
    )


def _registered(model: Model, residual: Array) -> Array:
    """The residual less the start pose of each run."""
    return np.asarray(residual - model.offsets @ np.linalg.lstsq(model.offsets, residual, rcond=None)[0])


def _judgement(left_out: LeftOut) -> Judgement:
    chosen, rivals, runs = left_out.chosen, left_out.rivals, len(left_out.before)
    before = float(left_out.before.mean())
    gained = 1 - chosen.error / before if before > 0 else 0.0
    names = tuple(e.name for e in chosen.effects)
    common = set(names).intersection(*({e.name for e in t.effects} for t in rivals))
    verdict: Verdict
    large = chosen.error > LEFT_OF_EXTENT * left_out.extent
    # A fit on the bound of what can be that leaves so much explains nothing.
    if not names or gained < LEAST_GAIN or (large and chosen.at_bound):
        verdict, common = Verdict.NONE, set()
        sentence = Message("No effect lowers the path error on runs left out.")
        if before > LEFT_OF_EXTENT * left_out.extent:
            verdict = Verdict.UNEXPLAINED
            sentence = Message(
                "The path error of {before:.0f} mm, on runs of {extent:.0f} mm about their middle, is by no effect of "
                "the catalogue: check scale and sign of the steering as it was logged, the file's units, and that "
                "the design belongs to this file.",
                before=before,
                extent=left_out.extent,
            )
    elif runs < LEAST_RUNS:
        verdict, common = Verdict.AMBIGUOUS, set()
        sentence = Message(
            "Consistent with {names}, but too few runs to tell it from chance.", names=names_of(chosen.effects)
        )
    elif rivals:
        verdict = Verdict.AMBIGUOUS
        sentence = Message(
            "Consistent with {names}; or {others}.",
            names=names_of(chosen.effects),
            others=joined((names_of(t.effects) for t in rivals), "; or "),
        )
    else:
        verdict = Verdict.TRACED if len(names) == 1 else Verdict.COMBINATION
        sentence = Message(
            "Traced to {names}: the path error on runs left out falls from {before:.0f} to {after:.0f} mm.",
            names=names_of(chosen.effects),
            before=before,
            after=chosen.error,
        )
    likely = [chosen, *rivals] if verdict not in (Verdict.NONE, Verdict.UNEXPLAINED) else []
    limits: tuple[str, ...] = ()
    if likely and large:
        limits = (Message("{after:.0f} mm of path error remain and have no name", after=chosen.error),)
    if runs < LEAST_RUNS:
        given = Message("one run") if runs == 1 else Message("{count} runs", count=runs)
        few = Message("{given} only: give at least {least}, to judge on runs left out", given=given, least=LEAST_RUNS)
        limits = (few, *limits)
    judgement = Judgement(
        verdict=verdict,
        sentence=sentence,
        claimed=tuple(sorted(common)),
        reported=tuple(sorted({e.name for t in likely for e in t.effects})),
        rivals=tuple(tuple(e.name for e in t.effects) for t in rivals),
        separate=separations(e for t in likely for e in t.effects),
        limits=limits,
    )
    findings = _findings(chosen)
    for finding in findings:
        if finding.at_bound:
            stuck = {"number": joined(finding.at_bound, " and "), "name": Message(finding.effect)}
            why = (
                Message("{number} of {name} is on the bound of what can be", **stuck)
                if len(finding.at_bound) == 1
                else Message("{number} of {name} are on the bound of what can be", **stuck)
            )
            judgement = unclaimed(judgement, [finding.effect], why)
    unsure = [finding.effect for finding in findings if finding.within_error]
    why = Message("{within}, which {runs} runs cannot tell from chance", within=within_words(chosen.sigmas), runs=runs)
    judgement = unclaimed(judgement, unsure, why)
    if large and judgement.verdict in (Verdict.TRACED, Verdict.COMBINATION):
        return replace(judgement, verdict=Verdict.PARTIAL)
    return judgement
