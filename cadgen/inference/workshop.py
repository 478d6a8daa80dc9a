"""Workshop's prior: mean and spread of each deviation over the cars that it made, learned from their records.

Every car c has deviations θ_c in p directions, of which its records say exp(−θ' H_c θ/2 + b_c' θ), with the
information H_c. Over cars they are normal, θ_c ~ N(μ, diag τ²). Directions are measured in a stated size, such as what
the tolerances allow: beforehand μ ~ N(0, 10²), and τ is half-Cauchy with the scale 1, so that few cars do not make it
narrow (Gelman, Bayesian Analysis 1 (2006) 515-533). As a mixture of inverse gammas (Huang and Wand, Bayesian Analysis 8
(2013) 439-452) everything is conjugate: μ and θ together, τ² and the mixing a are drawn in turn, each from its own
distribution given the others. μ is drawn with θ integrated out, since else the draws creep where records tell two
directions hardly apart: its information is H (H + T)⁻¹ T of each car, with T = diag τ⁻². A car whose records say
nothing of a direction counts for nothing in it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array

DRAWS, DISCARDED = 1500, 300
RANGE = (5.0, 95.0)
_NORMAL = 1.6449  # half of the 90 % range of a normal distribution in standard deviations
_MEAN = 10.0  # standard deviation of the mean beforehand
_LEAST = 1e-4  # spread below which none is followed


@dataclass(frozen=True)
class Habit:
    """Number of an effect over the cars of a workshop, internal units (mm, rad, 1).

    Attributes:
        kind: code of a kind of data that shows the effect.
        effect: name that it has there.
        name: name of the number, with its unit.
        mean, spread: of a further car.
        least, most: 90 % range of the spread over cars.
        cars: how many cars' worth is known of it.
    """

    kind: str
    effect: str
    name: str
    mean: float
    spread: float
    least: float
    most: float
    cars: float


@dataclass(frozen=True, eq=False)
class Shown:
    """Information of one car's records on its deviations.

    Attributes:
        information: H, shape (p, p).
        pull: b, shape (p,).
    """

    information: Array
    pull: Array

    @property
    def known(self) -> Array:
        """Share by which each deviation is known beside a spread of 1, 0 to 1, shape (p,)."""
        return np.asarray(1 - np.diag(np.linalg.inv(self.information + np.eye(len(self.pull)))))


@dataclass(frozen=True, eq=False)
class Learned:
    """Mean and spread of a workshop's cars in each of p directions.

    Attributes:
        mean: of a further car, shape (p,).
        spread: standard deviation of a further car, with what is not known of mean and spread; shape (p,).
        least, most: 90 % range of the spread τ over cars, shape (p,).
        cars: how many cars' worth is known of each direction, shape (p,).
    """

    mean: Array
    spread: Array
    least: Array
    most: Array
    cars: Array


def learn(cars: Sequence[Shown], groups: Sequence[int], seed: int = 0) -> Learned:
    """Mean and spread over cars.

    Args:
        cars: what the records of each show.
        groups: number of the quantity of each direction, shape (p,); both components of a quantity with a direction
            have one spread.
        seed: seed of the random numbers.
    """
    rng = np.random.default_rng(seed)
    information = np.array([car.information for car in cars])
    pull = np.array([car.pull for car in cars])
    count, size = pull.shape
    of = np.unique(np.asarray(groups), return_inverse=True)[1]
    per_group = count * np.bincount(of)
    variance, mixing = np.ones(of.max() + 1), np.ones(of.max() + 1)
    kept = []
    for number in range(DISCARDED + DRAWS):
        between = variance[of]
        within = information + np.diag(1 / between)
        told = np.linalg.solve(within, np.concatenate([information, pull[..., None]], axis=2)).sum(axis=0)
        precision = told[:, :-1] / between[:, None]
        root = np.linalg.cholesky((precision + precision.T) / 2 + np.diag(np.full(size, _MEAN**-2)))
        half = np.linalg.solve(root, told[:, -1] / between) + rng.standard_normal(size)
        mean = np.linalg.solve(root.T, half)
        roots = np.linalg.cholesky(within)
        halves = np.linalg.solve(roots, (pull + mean / between)[..., None]) + rng.standard_normal((count, size, 1))
        theta = np.linalg.solve(np.swapaxes(roots, 1, 2), halves)[..., 0]
        squares = np.bincount(of, weights=((theta - mean) ** 2).sum(axis=0))
        variance = (squares / 2 + 1 / mixing) / rng.gamma((per_group + 1) / 2)
        variance = np.maximum(variance, _LEAST**2)
        mixing = (1 / variance + 1) / rng.gamma(1.0, size=len(mixing))
        if number >= DISCARDED:
            kept.append((mean, np.sqrt(variance[of]), mean + np.sqrt(variance[of]) * rng.standard_normal(size)))
    means, spreads, further = (np.array(each) for each in zip(*kept, strict=True))
    low, high = np.percentile(further, RANGE, axis=0)
    least, most = np.percentile(spreads, RANGE, axis=0)
    return Learned(
        mean=np.median(means, axis=0),
        spread=np.asarray((high - low) / 2 / _NORMAL),
        least=np.asarray(least),
        most=np.asarray(most),
        cars=np.sum([car.known for car in cars], axis=0),
    )
