"""An ideal judge, who knows noise, spectrum of the form error, and every effect but which it is.

For names A and B of true distance d (the part of A's signal that B cannot make, in standard errors) the misfits differ
by D ~ N(d^2, 4 d^2). Claiming A at odds of r to one or better (D > 2 ln r) is right with probability
Phi((d^2 - 2 ln r) / 2d): no method that is told less does better on the average (Neyman and Pearson 1933), but for a
prior of the sizes. A name with more numbers pays ln n for each, as in the criterion of Schwarz (1978). Of all names
that could stand instead the nearest one is the limit; the error of a size has the covariance of Cramer and Rao.
"""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from scipy.stats import norm

from cadgen.deviations.effect import Active, Effect
from cadgen.inference.measurement.model import Model, fourier, slopes
from cadgen.inference.measurement.verdict import sure_of
from tests.inference.measurement import study
from tests.inference.measurement import synthetic as syn

KNOWN = 1e6  # standard deviation of a datum, in its own unit: not known at all
INDEX_DEG = 0.01  # of the divider, as `synthetic.lift_record` draws it
DRAWS = 20  # errors of sizes for each case


def information(model: Model, columns: np.ndarray, noise: np.ndarray, variance: np.ndarray) -> np.ndarray:
    """Products of columns by the inverse covariance of what is measured, form error and datum integrated out.

    Args:
        model: with its datum, which is fitted.
        columns: responses to one unit each, shape (n, k).
        noise: standard deviation of each row, shape (n,).
        variance: of each harmonic's amplitude, from order 1 on.
    """
    waves, _ = fourier(model.rows.place, len(variance))
    datum = np.hstack([model.offsets, slopes(model, model.datum, [(e, e.start) for e in model.datum])])
    unsure = np.hstack([waves * np.sqrt(np.tile(variance, 2)), datum * KNOWN]) / noise[:, None]
    z = columns / noise[:, None]
    mixed = unsure.T @ z
    return np.asarray(z.T @ z - mixed.T @ np.linalg.solve(np.eye(unsure.shape[1]) + unsure.T @ unsure, mixed))


def covariance(model: Model, columns: np.ndarray, noise: np.ndarray, variance: np.ndarray) -> np.ndarray:
    """That of the least squares estimate of some columns' sizes; arguments as of `information`."""
    return np.asarray(np.linalg.inv(information(model, columns, noise, variance)))


def rates(d: np.ndarray, odds: float) -> tuple[float, float]:
    """How often the right and the wrong of two names are claimed at such odds, on the average over d."""
    bar = 2 * np.log(odds)
    right, wrong = norm.cdf((d**2 - bar) / (2 * d)), norm.cdf(-(d**2 + bar) / (2 * d))
    return float(right.mean()), float(wrong.mean())


def best(car: syn.Car, case: study.Case, rng: np.random.Generator) -> tuple[float, list[float]]:
    """Chance that an ideal judge names all effects of a case; and relative errors of their sizes, drawn."""
    model = study.nominal(car).model(case.record)
    truth = [_entry(model, car, n, v) for n, v in zip(case.truth, case.values, strict=True)]
    datum: Active = [(e, e.start) for e in model.datum]
    scales = [np.array([p.scale for p in effect.parameters]) for effect in truth]
    values = [study.printed(n, v) * s for n, v, s in zip(case.truth, case.values, scales, strict=True)]
    there: Active = [*datum, *zip(truth, values, strict=True)]
    whole = model.residual(there)
    # What each effect adds to the others.
    signals = [model.residual([(e, v) for e, v in there if e is not lost]) - whole for lost in truth]
    own = slopes(model, tuple(truth), there)
    others = tuple(e for e in model.catalogue if _rival(e, truth))
    noise, variance = _noise(model, case), case.form[: model.form.shape[1] // 2]
    products = information(model, np.column_stack([*signals, own, slopes(model, others, datum)]), noise, variance)
    spans = _spans((*truth, *others), len(truth))
    mine, theirs = spans[: len(truth)], spans[len(truth) :]
    sure = sure_of(len(truth))
    price, bar = np.log(len(whole)), 2 * np.log(sure / (1 - sure))
    chance, first = 1.0, len(truth)
    for lost in range(len(truth)):
        base = np.concatenate([np.empty(0, dtype=int), *(span for k, span in enumerate(mine) if k != lost)])
        for more in (np.empty(0, dtype=int), *theirs):
            square = _left(products, lost, np.concatenate([base, more]))
            paid = (len(more) - len(mine[lost])) * price
            d = np.sqrt(max(square, 1e-12))
            chance = min(chance, float(norm.cdf((square + paid - bar) / (2 * d))))
    known = np.linalg.inv(products[first : first + own.shape[1], first : first + own.shape[1]])
    drawn = rng.multivariate_normal(np.zeros(len(known)), known, DRAWS)
    errors = [
        float(np.linalg.norm(row[span - first] / scale) / np.linalg.norm(value / scale))
        for row in drawn
        for span, value, scale in zip(mine, values, scales, strict=True)
    ]
    return chance, errors


def _left(products: np.ndarray, signal: int, chosen: np.ndarray) -> float:
    """Square of a signal, one of the columns, that chosen columns leave."""
    if not len(chosen):
        return float(products[signal, signal])
    gram, right = products[np.ix_(chosen, chosen)], products[chosen, signal]
    return float(products[signal, signal] - right @ np.linalg.lstsq(gram, right, rcond=1e-12)[0])


def _spans(effects: tuple[Effect, ...], first: int) -> list[np.ndarray]:
    """Columns of each effect, behind so many of signals."""
    ends = first + np.cumsum([0, *(len(e.parameters) for e in effects)])
    return [np.arange(a, b) for a, b in pairwise(ends)]


def _rival(effect: Effect, truth: list[Effect]) -> bool:
    """Whether a name may stand for another: none of these, none that becomes one of these, no twin, none beside it."""
    if effect.beside or any(effect.name == e.name for e in truth):
        return False
    same = [effect.includes, effect.looks_like]
    same += [e.looks_like for e in same if e]
    return effect not in truth and not any(e is not None and any(e.key == t.key for t in truth) for e in same)


def _entry(model: Model, car: syn.Car, name: str, values: dict) -> Effect:
    """The catalogue's entry for an effect of the generator."""
    alike: Iterator[Effect] = (e for e in model.catalogue if study.same(name, e.name))
    order = next((value[0] for key, value in values.items() if key in ("lobes", "ripples")), None)
    if order is not None:
        return next(e for e in alike if e.name.endswith(f" {order}"))
    if "dent" in values:
        number = int(np.argmin(np.abs(np.sort(car.noses) - values["dent"][0])))
        return next(e for e in alike if dict(e.indices)["nose_number"] == number + 1)
    return next(alike)


def _noise(model: Model, case: study.Case) -> np.ndarray:
    """Standard deviation of each row in the model's internal unit."""
    rows = len(model.rows.run)
    if case.kind == "lift":
        return np.hypot(case.noise * 1e-3, np.asarray(model.slip) * INDEX_DEG * syn.DEG)
    unit = {"profile": 1e-3, "transmission": syn.DEG, "track": 1.0}[case.kind]
    return np.full(rows, case.noise * unit)
