"""A subset of the catalogue, fitted exactly and scored.

The fit is bounded least squares by Gauss and Newton with Levenberg's damping (Marquardt 1963). A step p changes half
the sum of squares by g'p + p'H p / 2, with g = J'r and H = J'J. It stops when the next step is small against the
parameters' standard errors: below a gain of `_CONTENT` every value is within a twentieth of its standard deviation of
where it would end, in any combination of values, whatever their units. General solvers do not offer that criterion, and
spend most of their steps past it.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import inf, log

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect, Quantity, activated
from cadgen.errors import DesignError
from cadgen.inference.measurement.evidence import Spectrum
from cadgen.inference.measurement.joint import Joint

# From good values two or three steps do; more means that the subset does not fit.
_MOST_STEPS = 12
# Gain, in half the sum of squares, after which no further step is taken; relative where values fit badly.
_CONTENT, _RELATIVE = 1e-3, 1e-6
# After so many steps a fit is given up whose cost would not come down to a level by so many times the gain expected.
_EARLY, _GENEROUS = 4, 20.0
_SINGULAR = 1e-12  # relative; keeps columns that are alike, or nothing, from a division by nothing
_DAMPED, _MORE, _LESS = 0.03, 30.0, 0.1  # damping after a first step too far, and its changes


def least_squares(
    half: Callable[[Array], float],
    normal: Callable[[Array], tuple[Array, Array]],
    start: Array,
    bounds: Array,
    level: float = inf,
) -> tuple[Array, Array, bool]:
    """Values of least squares, and the curvature of the sum of squares there.

    Args:
        half: of values, shape (k,): half the sum of squares of the residual, of unit variance.
        normal: of values: H, shape (k, k), and g, shape (k,).
        start: parameters to begin from, within the bounds, shape (k,).
        bounds: least and greatest parameters, shape (2, k).
        level: half the sum of squares above which the parameters are of no use, so that they need not settle.

    Returns:
        Values, shape (k,); H of the last step, shape (k, k); whether it settled.

    Raises:
        DesignError: of `half` at the start.
    """
    x, cost, damping = start, half(start), 0.0
    H, g = normal(start)
    for number in range(_MOST_STEPS):
        step, expected = _step(H, g, x, bounds, damping)
        content = expected < max(_CONTENT, _RELATIVE * cost)
        if number >= _EARLY and not content and cost - _GENEROUS * expected > level:
            break
        trial = np.clip(x + step, *bounds)
        try:
            after = half(trial)
        except DesignError:
            # A disc that no rod can follow: a step too far.
            after = np.inf
        if after < cost:
            damping = damping * _LESS if cost - after > expected / 4 else max(damping, _DAMPED)
            x, cost = trial, after
        elif not content:
            damping = max(damping * _MORE, _DAMPED)
            continue
        if content:
            return x, H, True
        H, g = normal(x)
    return x, H, False


def _step(H: Array, g: Array, x: Array, bounds: Array, damping: float) -> tuple[Array, float]:
    """A step within the bounds, and by how much it lessens half the sum of squares to first order of the residual."""
    size = np.sqrt(np.maximum(np.diag(H), 1e-300))
    H, g = H / size / size[:, None], g / size
    low, high = (bounds - x) * size
    step, free = np.zeros(len(x)), np.ones(len(x), dtype=bool)
    # What would leave the bounds is held at them, and the rest finds its step beside it.
    while free.any():
        inner = H[np.ix_(free, free)] + (damping + _SINGULAR) * np.eye(int(free.sum()))
        step[free] = np.linalg.solve(inner, -(g + H[:, ~free] @ step[~free])[free])
        beyond = free & ((step < low) | (step > high))
        step = np.clip(step, low, high)
        if not beyond.any():
            break
        free &= ~beyond
    return step / size, float(-(g @ step) - step @ H @ step / 2)


# However alike two effects are, both together must be narrowed by the data to a tenth of what was thought before.
LEAST_PRICE = 2 * log(10)
# Steps of the trials for a value that what is expected answers in steps, so many to either side, moved so often.
_COARSE, _FINE, _REACH, _MOST_MOVES = 0.015, 0.0025, 6, 3
# A fit begins this far inside the bounds, relative to the range, and a value this close to one at its end stands on it.
_AT_BOUND, _NEAR_BOUND = 1e-6, 1e-3


@dataclass(frozen=True, kw_only=True)
class Hypothesis:
    """Effects with their most likely values.

    Attributes:
        effects: the subset, in the order of the catalogue.
        active: datum and effects with values, as the model takes them.
        covariance: of all values in order, datum first.
        misfit: -2 log L for every spectrum of the form error.
        penalty: for the number of parameters and the size of the catalogue searched.
        within, beyond: spectrum of least misfit that keeps the stated floor, and that exceeds it.
        at_bound: names of parameters that stand on a physical bound.
        spectrum: of the form error that is reported with it.
    """

    effects: tuple[Effect, ...]
    active: Active
    covariance: Array
    misfit: Array
    penalty: float
    within: int
    beyond: int
    at_bound: tuple[str, ...]
    spectrum: Spectrum

    @property
    def score(self) -> float:
        """Extended information criterion with the form error held to its floor; less is better."""
        return float(self.misfit[self.within]) + self.penalty

    @property
    def loose_score(self) -> float:
        """Score with a form error of any size: how well the effects do beside an unknown smooth shape."""
        return float(self.misfit[self.beyond]) + self.penalty

    @property
    def key(self) -> frozenset[str]:
        """Identity of the subset: the keys of its effects."""
        return frozenset(effect.key for effect in self.effects)

    @property
    def parameters(self) -> int:
        """How many numbers it fits beside the datum."""
        return sum(len(effect.parameters) for effect in self.effects)

    @property
    def reach(self) -> frozenset[str]:
        """Keys of the subset and of every effect it becomes for some values: subsets within them are nested in it."""
        return self.key | {effect.includes.key for effect in self.effects if effect.includes}

    @property
    def claims(self) -> frozenset[str]:
        """Names of the effects that are not anonymous shapes."""
        return frozenset(effect.name for effect in self.effects if not effect.shape)

    @property
    def holds(self) -> frozenset[str]:
        """The claims, and the names of what they become for some values."""
        return self.claims | {effect.includes.name for effect in self.effects if effect.includes}

    def at(self, joint: Joint, *, loose: bool) -> "Hypothesis":
        """Subset with its best spectrum within the floor, or beyond it."""
        return replace(self, spectrum=joint.grid[self.beyond if loose else self.within])

    def datum(self) -> list[tuple[Effect, Array, Array]]:
        """The datum freedoms in the same form as `values`."""
        return self._entries(claimed=False)

    def values(self) -> list[tuple[Effect, Array, Array]]:
        """Each effect with its values and standard deviations, internal units."""
        return self._entries(claimed=True)

    def _entries(self, *, claimed: bool) -> list[tuple[Effect, Array, Array]]:
        sigma = np.sqrt(np.maximum(np.diag(self.covariance), 0.0))
        out, at = [], 0
        for effect, value in self.active:
            out.append((effect, value, sigma[at : at + len(value)]))
            at += len(value)
        return [entry for entry in out if (entry[0] in self.effects) == claimed]


@dataclass(frozen=True)
class Search:
    """Size of the search, for the penalty.

    Attributes:
        rows: measured numbers.
        entries: how many entries of the catalogue each sort of effect has (orders of waviness, noses); a sort is one
            cause, however many places it can show in.
        shapes: anonymous forms.
        usual: mean and standard deviation of numbers by their keys over the cars of a workshop, internal units.
    """

    rows: int
    entries: Mapping[str, int] = field(default_factory=dict)
    shapes: int = 1
    usual: Mapping[Quantity, tuple[float, float]] = field(default_factory=dict)

    def penalty(self, effects: tuple[Effect, ...], parameters: int) -> float:
        """Extended Bayesian information criterion (Chen and Chen 2008, gamma = 1): k ln n + 2 ln(choices).

        Beforehand all sorts are alike likely, and so are the entries of one sort; every further cause is as unlikely as
        the first, whatever others there are. What acts beside another is no further cause: every rod rubs, and only
        the number is paid for.
        """
        named = [e.sort for e in effects if not (e.shape or e.beside)]
        anonymous = sum(e.shape for e in effects)
        choices = sum(log(max(len(self.entries), 1) * self.entries.get(sort, 1)) for sort in named)
        return parameters * log(self.rows) + 2 * (choices + anonymous * log(self.shapes))


def fit(
    joint: Joint,
    effects: tuple[Effect, ...],
    start: Active,
    search: Search,
    known: Mapping[str, tuple[float, float]] | None = None,
    level: float = inf,
) -> Hypothesis:
    """Fit a subset and the datum exactly, with the form error as a random effect.

    Args:
        joint: the records.
        effects: the subset.
        start: values to begin from; effects without one begin at their own start.
        search: for the penalty.
        known: value and standard deviation of effects' first numbers by the effects' keys, from other measurements.
        level: -2 log L, dimensionless, above which the subset is out of the running, and need not be fitted to the end.
    """
    begin = {effect.key: values for effect, values in start}
    problem = _Problem(joint, (*joint.datum, *effects), known or {}, search.usual)
    chosen, bounds, stepwise = problem.chosen, problem.bounds, problem.stepwise
    x = np.concatenate([begin.get(e.key, e.start) for e in chosen]) if chosen else np.empty(0)
    if stepwise.any():
        x, _ = _tried(problem.misfit, x, stepwise, bounds, _COARSE)
    misfit, covariance = problem.misfit(x), np.empty((0, 0))
    # A run that is left out is judged by one spectrum, whatever it is.
    allowed = joint.within if joint.within.any() else ~joint.within
    if len(x):
        # A large discrepancy is forgiving, and so the first to be fitted with; but it may hide what an effect does, and
        # with a slight one the values go on from there, if the subset fits at all.
        fits = []
        for size in np.unique(joint.beside[allowed])[::-1]:
            spectrum = _least(misfit, allowed & (joint.beside == size))
            x, covariance, fitting = problem.solved(x, spectrum, level)
            misfit = problem.misfit(x)
            fits.append((float(misfit[allowed].min()), spectrum, x, covariance, misfit))
            if not fitting:
                break
        _, spectrum, x, covariance, misfit = min(fits, key=lambda entry: entry[0])
        # The best spectrum may change as the fit improves: once more if it does.
        for _ in range(2):
            before, spectrum = spectrum, _least(misfit, allowed)
            if spectrum == before or not fitting:
                break
            x, covariance, fitting = problem.solved(x, spectrum, level)
            misfit = problem.misfit(x)
        if stepwise.any():
            x, variance = _tried(problem.misfit, x, stepwise, bounds, _FINE)
            covariance[np.diag_indices(len(x))] += np.where(stepwise, variance, 0.0)
            misfit = problem.misfit(x)
    spectrum = _least(misfit, allowed)
    parameters = sum(len(e.parameters) for e in effects)
    shared = 0.0 if _usual_numbers(effects, search.usual) else _overlap(covariance, effects, log(search.rows))
    return Hypothesis(
        effects=effects,
        active=problem.active(x),
        covariance=covariance,
        misfit=misfit,
        penalty=search.penalty(effects, parameters) - shared + _unusual(problem.chosen, x, covariance, search),
        within=spectrum,
        beyond=_least(misfit, ~joint.within),
        spectrum=joint.grid[spectrum],
        at_bound=numbers_on_bound(chosen, x),
    )


class _Problem:
    """Least squares of a subset's values: bounds, residuals and tangents of whitened rows with prior knowledge."""

    def __init__(
        self,
        joint: Joint,
        chosen: tuple[Effect, ...],
        known: Mapping[str, tuple[float, float]],
        usual: Mapping[Quantity, tuple[float, float]],
    ) -> None:
        self._joint, self.chosen, self._prior = joint, chosen, _Prior(chosen, known, usual)
        self.bounds = np.concatenate([e.bounds for e in chosen], axis=1) if chosen else np.empty((2, 0))
        self.stepwise = np.array([p.stepwise for e in chosen for p in e.parameters], dtype=bool)

    def active(self, values: Array) -> Active:
        """The subset with values."""
        return activated(self.chosen, values)

    def misfit(self, values: Array) -> Array:
        """-2 log L for every spectrum."""
        return self._joint.misfit(self.active(values))

    def solved(self, x: Array, spectrum: int, level: float) -> tuple[Array, Array, bool]:
        """Values of least squares for one spectrum, their covariance, and whether they settled."""

        def half(values: Array) -> float:
            left = self._prior.residual(values)
            return (self._joint.square(self.active(values), spectrum) + float(left @ left)) / 2

        def normal(values: Array) -> tuple[Array, Array]:
            # What answers in steps has no slopes; it is found by trial.
            known, smooth = self._prior.rows, np.flatnonzero(~self.stepwise)
            even = tuple(e for e in self.chosen if not e.parameters[0].stepwise)
            H, g = known.T @ known, known.T @ self._prior.residual(values)
            (information,), (gradient,) = self._joint.normal(even, self.active(values), [spectrum])
            H[np.ix_(smooth, smooth)] += information
            g[smooth] += gradient
            return H, g

        inside = self.bounds + np.outer([1, -1], _AT_BOUND * (self.bounds[1] - self.bounds[0]))
        useless = (level - float(self._joint.constant[spectrum])) / 2
        x, H, done = least_squares(half, normal, np.clip(x, *inside), inside, useless)
        return x, _covariance(H, self.bounds, ~self.stepwise), done


def sized(joint: Joint, found: Hypothesis) -> Hypothesis:
    """Subset with the covariance over all spectra of what repeats, each by its chance.

    The spectrum of greatest likelihood at the fitted values leaves to the effects what they take from it, as an
    eccentricity does from the first harmonic. So it says that they are known too well. Each has the chance of
    its restricted likelihood instead, with the values integrated out (Patterson and Thompson 1971), and its own values.
    """
    if not found.active:
        return found
    chosen = tuple(e for e, _ in found.active)
    smooth = np.flatnonzero([not p.stepwise for e in chosen for p in e.parameters])
    even = tuple(e for e in chosen if not e.parameters[0].stepwise)
    among = np.flatnonzero(joint.within == found.spectrum.within)
    bounds = np.hstack([e.bounds for e in even]) if even else np.empty((2, 0))
    misfit: list[float] = []
    covariances: list[Array] = []
    for spectrum, H, g in zip(among.tolist(), *joint.normal(even, found.active, among), strict=True):
        own = _covariance(H, bounds, np.ones(len(H), dtype=bool))
        moved = -own @ g
        misfit.append(float(found.misfit[spectrum] + g @ moved - np.linalg.slogdet(own)[1]))
        covariances.append(own + np.outer(moved, moved))
    levels = np.array(misfit)
    if not np.isfinite(levels).any():  # what cannot be told at all, by no spectrum
        return found
    chance = np.exp((levels[np.isfinite(levels)].min() - levels) / 2)
    covariance = found.covariance.copy()
    covariance[np.ix_(smooth, smooth)] = np.tensordot(chance / chance.sum(), np.array(covariances), axes=1)
    return replace(found, covariance=covariance)


def _covariance(information: Array, bounds: Array, smooth: NDArray[np.bool_]) -> Array:
    """Covariance by the information; a number of which there is less than its bounds say is known by these alone.

    So is the play behind a friction that holds the cam all the way: more of it changes nothing. What answers in steps
    has no slopes, and so no information but what was known before; its variance is found by trial.
    """
    out = np.asarray(np.linalg.pinv(information), dtype=float)
    within = (bounds[1] - bounds[0]) ** 2 / 12
    blind = np.flatnonzero(smooth & (np.diag(information) * within < 1))
    out[blind, blind] = np.maximum(out[blind, blind], within[blind])
    return out


def numbers_on_bound(effects: Sequence[Effect], values: Array) -> tuple[str, ...]:
    """Names of the numbers that stand on a bound of what can be.

    Args:
        effects: effects.
        values: their values in a row, internal units (mm, rad), shape (p,).
    """
    if not effects:
        return ()
    stuck = on_bound(values, np.concatenate([e.bounds for e in effects], axis=1))
    return tuple(p.name for p, on in zip((p for e in effects for p in e.parameters), stuck, strict=True) if on)


def on_bound(values: Array, bounds: Array) -> NDArray[np.bool_]:
    """Whether values stand on a bound of what can be: then they are none that were found; shape (p,).

    Args:
        values: of parameters, mm or rad, shape (p,).
        bounds: least and greatest of each, mm or rad, shape (2, p).
    """
    near = _NEAR_BOUND * (bounds[1] - bounds[0])
    return np.asarray((values < bounds[0] + near) | (values > bounds[1] - near))


def _tried(
    misfit: Callable[[Array], Array], x: Array, stepwise: NDArray[np.bool_], bounds: Array, step: float
) -> tuple[Array, float]:
    """Values with the stepwise one at its likely mean over trials about it, and its variance."""
    k = int(np.argmax(stepwise))
    for _ in range(_MOST_MOVES):
        # On one grid, since what a value makes of the cam is remembered.
        near = step * (np.round(x[k] / step) + np.arange(-_REACH, _REACH + 1))
        trials = np.unique(np.clip(near, bounds[0, k], bounds[1, k]))
        found = np.array([misfit(np.where(stepwise, trial, x)).min() for trial in trials])
        weight = np.exp((found.min() - found) / 2)
        weight /= weight.sum()
        best, before = int(np.argmin(found)), x[k]
        x = np.where(stepwise, weight @ trials, x)
        if 0 < best < len(trials) - 1 or abs(x[k] - before) < step:
            break
    return x, float(weight @ (trials - x[k]) ** 2 + step**2 / 12)


class _Prior:
    """Prior knowledge of some values, as rows of a least-squares problem."""

    def __init__(
        self,
        chosen: tuple[Effect, ...],
        known: Mapping[str, tuple[float, float]],
        usual: Mapping[Quantity, tuple[float, float]],
    ) -> None:
        starts = np.cumsum([0, *(len(e.parameters) for e in chosen)])
        of = [(int(starts[i]), *known[e.key]) for i, e in enumerate(chosen) if e.key in known]
        of += [(column, *usual[key]) for column, key in _usual_numbers(chosen, usual)]
        self.rows = np.zeros((len(of), int(starts[-1])))
        self.mean = np.array([mean / sigma for _, mean, sigma in of])
        for row, (column, _, sigma) in enumerate(of):
            self.rows[row, column] = 1 / sigma

    def residual(self, values: Array) -> Array:
        return np.asarray(self.rows @ values - self.mean)


def _usual_numbers(
    chosen: Sequence[Effect], usual: Mapping[Quantity, tuple[float, float]]
) -> list[tuple[int, Quantity]]:
    """Columns and keys of the numbers of which a workshop's cars tell what is usual."""
    keys = [key for e in chosen for key in e.quantities]
    return [(column, key) for column, key in enumerate(keys) if key in usual]


def _unusual(chosen: Sequence[Effect], values: Array, covariance: Array, search: Search) -> float:
    """Change of the penalty where a workshop's cars tell what is usual.

    A number x then costs ((x - μ) / τ)² for being unusual. That the records narrow its spread τ to s costs 2 ln(τ / s)
    instead of ln n, where that is less: the Laplace approximation of the evidence with the prior N(μ, τ²).
    """
    more = 0.0
    for column, key in _usual_numbers(chosen, search.usual):
        mean, spread = search.usual[key]
        narrowed = log(max(spread**2 / max(float(covariance[column, column]), 1e-300), 1.0))
        more += ((float(values[column]) - mean) / spread) ** 2 + min(narrowed - log(search.rows), 0.0)
    return more


def _overlap(covariance: Array, effects: tuple[Effect, ...], price: float) -> float:
    """Sum of ln det I_ee over the named effects' blocks of their information I, less ln det I; datum and shapes fitted.

    The price of a parameter, ln n, is that of a prior that knows as much as one row does (Kass and Wasserman 1995).
    Such a prior belongs to each effect by itself: the data narrow the second of two near twins less, and by so much it
    costs less.
    """
    widths = [len(e.parameters) for e in effects]
    ends = len(covariance) - sum(widths) + np.cumsum([0, *widths])
    spans = [np.arange(a, b) for (a, b), e in zip(pairwise(ends), effects, strict=True) if not e.shape]
    if len(spans) < 2:
        return 0.0
    named = np.concatenate(spans)
    whole = np.linalg.slogdet(covariance[np.ix_(named, named)])[1]
    information = np.linalg.pinv(covariance[np.ix_(named, named)])
    cuts = np.cumsum([0, *(len(span) for span in spans)])
    saved = whole + sum(np.linalg.slogdet(information[a:b, a:b])[1] for a, b in pairwise(cuts))
    return float(np.clip(saved, 0.0, (len(spans) - 1) * (price - LEAST_PRICE))) if np.isfinite(saved) else 0.0


def least_penalty(search: Search, effects: tuple[Effect, ...], parameters: int) -> float:
    """Least penalty that a subset can have: all named effects but one are near twins.

    Args:
        search: size of the search.
        effects: the subset.
        parameters: how many numbers it has.
    """
    twins = max(sum(not e.shape for e in effects) - 1, 0)
    return search.penalty(effects, parameters) - twins * max(log(search.rows) - LEAST_PRICE, 0.0)


def _least(misfit: Array, among: NDArray[np.bool_]) -> int:
    return int(np.argmin(np.where(among, misfit, np.inf)))
