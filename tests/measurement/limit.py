"""Error rate of an ideal judge, who knows noise, spectrum of the form error and every other cause.

    python -m tests.measurement.limit

For a twin of true size x the misfits of the two names differ by D ~ N(d^2, 4 d^2), d = x / s, where s is the size at
which the data, noise and form error known, tell the twins apart by one standard error. Claiming a name at odds of r to
one or better (D > 2 ln r) is right with probability Phi((d^2 - 2 ln r) / 2d) and wrong with Phi(-(d^2 + 2 ln r) / 2d):
no method that is told less does better on the average (Neyman and Pearson 1933), but for a prior of the sizes.
"""

from collections.abc import Iterator

import numpy as np
from scipy.stats import norm

from cadgen.measurement.models.base import Model, fourier, slopes
from cadgen.measurement.verdict import SURE
from tests.measurement import study
from tests.measurement import synthetic as syn

TWINS = {"lift": ("lever gain", "axial offset"), "profile": ("cutter compensation", "uniform scale")}
ORDERS = 90
NOISES_UM = np.geomspace(2.0, 20.0, 6)
KNOWN = 1e6  # standard deviation of a datum, in its own unit: not known at all
SIZES = 200
DRAWS = 400


def spectra() -> Iterator[np.ndarray]:
    """Variance by order of the generator's form errors over what it draws them from."""
    order = np.arange(1, ORDERS + 1)
    for width in (4, 8, 12, 16, 20):
        yield np.exp(-((order * width * syn.DEG) ** 2))
    for width in (10, 15, 20, 25, 30):
        yield 1 / (1 + (order * width * syn.DEG) ** 2)


def covariance(model: Model, columns: np.ndarray, noise: np.ndarray, variance: np.ndarray) -> np.ndarray:
    """That of the least squares estimate of some columns' sizes, noise and form error known: Cramer and Rao's bound.

    Args:
        model: with its datum, which is fitted.
        columns: responses to one unit each, shape (n, k).
        noise: standard deviation of each row, shape (n,).
        variance: of each harmonic's amplitude, shape (ORDERS,).
    """
    waves, _ = fourier(model.rows.place, ORDERS)
    datum = np.hstack([model.offsets, slopes(model, model.datum, [(e, e.start) for e in model.datum])])
    unsure = np.hstack([waves * np.sqrt(np.tile(variance, 2)), datum * KNOWN]) / noise[:, None]
    z = columns / noise[:, None]
    mixed = unsure.T @ z
    information = z.T @ z - mixed.T @ np.linalg.solve(np.eye(unsure.shape[1]) + unsure.T @ unsure, mixed)
    return np.asarray(np.linalg.inv(information))


def rates(d: np.ndarray, odds: float) -> tuple[float, float]:
    """How often the right and the wrong twin are claimed at such odds, on the average over d."""
    bar = 2 * np.log(odds)
    right, wrong = norm.cdf((d**2 - bar) / (2 * d)), norm.cdf(-(d**2 + bar) / (2 * d))
    return float(right.mean()), float(wrong.mean())


def distances(car: syn.Car, kind: str) -> np.ndarray:
    """d of both twins over what the generator draws: noise, form error and size, those too small left out."""
    way, names = study.KINDS[kind], TWINS[kind]
    record = way.make(car, syn.Bench(), np.random.default_rng(0), noise_um=0.01)
    model = study.nominal(car).model(record)
    effects = tuple(next(e for e in model.catalogue if e.name == name) for name in names)
    columns = slopes(model, effects, [(e, e.start) for e in model.datum])
    shown = columns - columns.mean(axis=0) if kind == "lift" else columns
    rms = np.sqrt(np.mean(shown**2, axis=0))
    index = np.asarray(model.slip) * 0.01 * syn.DEG if kind == "lift" else np.zeros(len(columns))
    out = []
    for noise in NOISES_UM / 1e3:
        for spectrum in spectra():
            variance = spectrum / spectrum.sum() * (syn.FORM_UM / 1e3) ** 2
            told = np.sqrt(np.diag(covariance(model, columns, np.hypot(noise, index), variance)))
            for name, least, response in zip(names, told, rms, strict=True):
                _, low, high = way.truths[name]
                sizes = np.geomspace(low, high, SIZES)
                out.append(sizes[sizes * response > study.LEAST * noise] / least)
    return np.concatenate(out)


def least_errors(car: syn.Car, draws: int) -> np.ndarray:
    """Relative errors of a profile's parameters, each effect known to be there alone; wear is left out: not linear."""
    rng = np.random.default_rng(1)
    way = study.KINDS["profile"]
    model = study.nominal(car).model(way.make(car, syn.Bench(), rng, noise_um=0.01))
    names = [name for name in sorted(way.truths) if name != "worn nose"]
    shapes = list(spectra())
    datum = [(e, e.start) for e in model.datum]
    errors: list[float] = []
    while len(errors) < draws:
        name = names[rng.integers(len(names))]
        make, low, high = way.truths[name]
        change = make(car, rng)(float(np.exp(rng.uniform(np.log(low), np.log(high)))))
        order = next((f", order {v[0]}" for k, v in change.items() if k in ("lobes", "ripples")), "")
        effect = next(e for e in model.catalogue if e.name == name + order)
        size = np.array(study.PRINTED[name](change)) * [p.scale for p in effect.parameters]
        columns, noise = slopes(model, (effect,), datum), float(np.exp(rng.uniform(np.log(2e-3), np.log(20e-3))))
        if np.sqrt(np.mean((columns @ size) ** 2)) < study.LEAST * noise:
            continue
        spectrum = shapes[rng.integers(len(shapes))]
        variance = spectrum / spectrum.sum() * (syn.FORM_UM / 1e3) ** 2
        known = covariance(model, columns, np.full(len(columns), noise), variance)
        errors.append(float(np.linalg.norm(rng.multivariate_normal(0 * size, known)) / np.linalg.norm(size)))
    return np.array(errors)


def main() -> None:
    """Print how often the best judge claims the right and the wrong twin, for several odds, and the least errors."""
    from tests.conftest import build

    car = syn.Car(build("carbon_free_car"))
    print(f"profile  relative error of the parameters: median {np.median(least_errors(car, DRAWS)):.2%}")
    for kind in TWINS:
        d = distances(car, kind)
        for odds in (1.0, 3.0, SURE / (1 - SURE), 12.0):
            right, wrong = rates(d, odds)
            print(
                f"{kind:8} odds {odds:4.0f}: right {right:6.1%}, wrong {wrong:5.1%}, neither {1 - (right + wrong):5.1%}"
            )


if __name__ == "__main__":
    main()
