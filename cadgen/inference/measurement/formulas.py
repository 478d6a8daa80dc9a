"""Formula for an error of logged runs that repeats and that no effect of the catalogue makes, searched over a library.

A kind of data brings formulas: effects of the same form as those of its catalogue, each with one number. They are
products of a physical input (angle of the steering, its rate, heading, distance, angle of a shaft) and of what this
acts on. They are so many that one of them would fit anything; so they are not searched for among the effects, and none
is ever claimed.

Errors of a path add up, so that small formulas act linearly on it. With the columns J of the effects found, those F of
the formulas, and the residual r, all registered, the one proposed makes the path error least on paths left out:

    min over j of the mean over runs k of |r_k - J_k c - F_kj d|,   (c, d) fitted to the runs of the other paths.

Runs of one path share what repeats, whatever it is, and are left out together: a formula that predicts them has learnt
it elsewhere. By chance the best of many formulas gains something, too. How much follows from the same search in other
residuals: what disturbs heading and travel is told from each residual, and shifted along its path, by as much in all
runs of one path, with either sign. It is as large and as rough as before, and goes with no input any more.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect
from cadgen.inference.measurement.findings import Finding, FormulaProposal
from cadgen.inference.measurement.model import Model, slopes
from cadgen.inference.measurement.repeats import disturbances

# A formula must take away this share of the path error on paths left out.
LEAST_GAIN = 0.35
# Draws of the search in turned residuals, and the chance below which a gain is none of them.
DRAWS, CHANCE = 400, 0.004
# Fewer paths leave none to learn from when one is left out.
LEAST_PATHS = 3
# Formulas of which one gains this share of the other's gain or more are rivals: the data do not tell them apart.
RIVAL = 0.9
# Share of the mean path error by which a path may become worse: it may be near the noise already.
WORSE = 0.1
# Places along a run at which what disturbs it may begin, and the share of the largest singular value below which what
# they make is noise.
KNOTS, _ROUGHEST = 24, 1e-2
_RIDGE = 1e-9  # of each column's square: some formulas are alike on some paths


def proposal(
    model: Model, effects: tuple[Effect, ...], active: Active, residual: Array, paths: Sequence[Sequence[int]]
) -> FormulaProposal | None:
    """The formula that predicts what repeats, with its gain on paths left out; None if none does.

    Args:
        model: model of the record, with its formulas.
        effects: effects found.
        active: the same with their values.
        residual: what they leave, shape (n,), mm.
        paths: numbers of the runs of each path.
    """
    if not model.formulas or len(paths) < LEAST_PATHS:
        return None
    columns = np.hstack([slopes(model, effects, active), slopes(model, model.formulas, active)])
    scale = np.sqrt(np.mean(columns**2, axis=0))
    columns = columns / np.where(scale > 0, scale, 1.0)
    runs = [_FormulaRun.of(model, columns, number) for number in range(int(model.rows.run.max()) + 1)]
    search = _FormulaSearch.of(runs, paths, columns.shape[1] - len(model.formulas))
    left = [run.registered(residual[run.rows]) for run in runs]
    base, errors = search.left_out(left)
    best = int(np.argmin(errors))
    gain = 1 - errors[best] / base
    if gain < LEAST_GAIN:
        return None
    rng, as_large = np.random.default_rng(0), 0
    for _ in range(DRAWS):
        shifted = list(left)
        for path in paths:
            by, sign = int(rng.integers(KNOTS)), float(rng.choice([-1.0, 1.0]))
            for number in path:
                shifted[number] = sign * runs[number].shifted(left[number], by)
        one, others = search.left_out(shifted)
        as_large += bool(1 - others.min() / one >= gain)
    chance = (1 + as_large) / (1 + DRAWS)
    if chance >= CHANCE:
        return None
    formula = model.formulas[best]
    value, sigma = search.fitted(left, best)
    unit = scale[search.found + best]
    alike = np.flatnonzero(base - errors >= RIVAL * (base - errors[best]))
    return FormulaProposal(
        finding=Finding.of(formula, np.array([value / unit]), np.array([sigma / unit]), ()),
        before=float(base),
        after=float(errors[best]),
        chance=float(chance),
        rivals=tuple(model.formulas[n].name for n in alike if n != best),
    )


@dataclass(frozen=True)
class _FormulaRun:
    """Rows of a run and its columns registered, a basis of its start pose, and its disturbances with their inverse."""

    rows: NDArray[np.intp]
    columns: Array
    pose: Array
    disturbed: Array
    inverse: Array

    @classmethod
    def of(cls, model: Model, columns: Array, number: int) -> "_FormulaRun":
        rows = np.flatnonzero(model.rows.run == number)
        offsets = model.offsets[rows]
        pose = np.linalg.qr(offsets[:, np.abs(offsets).any(axis=0)])[0]
        assert model.measured is not None
        x, y = model.measured[rows].reshape(2, -1)
        every = np.hstack([columns[rows], disturbances(x + 1j * y, KNOTS)])
        every = every - pose @ (pose.T @ every)
        own = every[:, columns.shape[1] :]
        return cls(rows, every[:, : columns.shape[1]], pose, own, np.asarray(np.linalg.pinv(own, rcond=_ROUGHEST)))

    def registered(self, residual: Array) -> Array:
        """Residual of the run less its start pose."""
        return np.asarray(residual - self.pose @ (self.pose.T @ residual))

    def shifted(self, residual: Array, by: int) -> Array:
        """Residual whose disturbances come so many of their places later along the run, mm."""
        sizes = (self.inverse @ residual).reshape(2, KNOTS)
        return np.asarray(self.disturbed @ np.roll(sizes, by, axis=1).ravel())


@dataclass(frozen=True)
class _FormulaSearch:
    """Fits of each formula beside the effects found, all formulas at once.

    Attributes:
        runs: with the columns of effects found and formulas, in this order.
        paths: numbers of the runs of each path.
        found: how many numbers the effects found have.
        numbers: of each formula those of the effects found and its own, shape (formulas, found + 1).
        grams: of each run's columns over its rows, shape (runs, k, k).
        inverses: for each path, of the sum of all others: of the effects found alone, and beside each formula.
    """

    runs: Sequence[_FormulaRun]
    paths: Sequence[Sequence[int]]
    found: int
    numbers: NDArray[np.intp]
    grams: Array
    inverses: tuple[tuple[Array, Array], ...]

    @classmethod
    def of(cls, runs: Sequence[_FormulaRun], paths: Sequence[Sequence[int]], found: int) -> "_FormulaSearch":
        grams = np.array([run.columns.T @ run.columns / len(run.rows) for run in runs])
        numbers = np.array([[*range(found), n] for n in range(found, grams.shape[1])])
        inverses = []
        for path in paths:
            gram = np.delete(grams, path, axis=0).sum(axis=0)
            gram = gram + _RIDGE * np.diag(np.maximum(np.diag(gram), 1e-12))
            beside = gram[numbers[:, :, None], numbers[:, None, :]]
            inverses.append((np.linalg.inv(gram[:found, :found]), np.linalg.inv(beside)))
        return cls(runs, paths, found, numbers, grams, tuple(inverses))

    def _pulls(self, left: Sequence[Array]) -> Array:
        return np.array([run.columns.T @ r / len(run.rows) for run, r in zip(self.runs, left, strict=True)])

    def left_out(self, left: Sequence[Array]) -> tuple[float, Array]:
        """Path error on paths left out, mean over runs, mm: of the effects found alone, and with each formula beside.

        A formula that makes one of the paths worse, by more than `WORSE`, gains nothing.

        Args:
            left: registered residual of each run, mm.
        """
        pulls, squares = self._pulls(left), np.array([float(r @ r) / len(r) for r in left])
        befores, afters = [], []
        for path, (alone, beside) in zip(self.paths, self.inverses, strict=True):
            pull = np.delete(pulls, path, axis=0).sum(axis=0)
            one = alone @ pull[: self.found]
            many = np.einsum("fij,fj->fi", beside, pull[self.numbers])
            before, after = 0.0, np.zeros(len(self.numbers))
            for run in path:
                gram, own = self.grams[run], pulls[run]
                square = squares[run] - 2 * one @ own[: self.found] + one @ gram[: self.found, : self.found] @ one
                # Numbers of the effects that were fitted to other paths must do no harm that a formula then undoes.
                before += float(np.sqrt(2 * min(max(square, 0.0), squares[run])))
                inner = gram[self.numbers[:, :, None], self.numbers[:, None, :]]
                quadratic = np.einsum("fi,fij,fj->f", many, inner, many)
                linear = np.einsum("fi,fi->f", many, own[self.numbers])
                after += np.sqrt(2 * np.maximum(squares[run] - 2 * linear + quadratic, 0.0))
            befores.append(before)
            afters.append(after)
        base, total = sum(befores) / len(self.runs), np.sum(afters, axis=0) / len(self.runs)
        share = np.array([len(path) for path in self.paths]) * WORSE * base
        sure = (np.array(afters) <= (np.array(befores) + share)[:, None]).all(axis=0)
        return base, np.where(sure, total, np.maximum(total, base))

    def fitted(self, left: Sequence[Array], formula: int) -> tuple[float, float]:
        """Number of a formula fitted to all runs beside the effects found; its standard deviation by the jackknife."""
        pulls, mine = self._pulls(left), self.numbers[formula]

        def fit(without: Sequence[int]) -> float:
            gram = np.delete(self.grams, without, axis=0).sum(axis=0)[np.ix_(mine, mine)]
            return float(np.linalg.solve(gram, np.delete(pulls, without, axis=0).sum(axis=0)[mine])[-1])

        each = np.array([fit(path) for path in self.paths])
        spread = np.sum((each - each.mean()) ** 2) * (len(each) - 1) / len(each)
        return fit([]), float(np.sqrt(spread))
