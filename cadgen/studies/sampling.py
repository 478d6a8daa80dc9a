"""Choice of designs: keys that vary, fixed plans over the unit cube, and the search by whole generations.

A fixed plan has places of the unit cube, or levels, chosen before anything is computed. The search is NSGA-II of pymoo.
A generation depends on all results of those before it and on nothing else, so a search that was killed goes through its
journal again and comes to the same places. docs/decisions/0020-explore.md has why it is pymoo.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from math import floor, prod
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.messages import Message
from cadgen.registry import Registry

REPLAN = "replan."  # keys of the study itself, which vary as the design's do
_DIGITS = 6  # of a value in a range: more would only lengthen the files
ROUNDING = 1e-9  # of the number of steps in a range


@dataclass(frozen=True)
class Variation:
    """A key with its values, or its range.

    Attributes:
        key: dotted key of the design, or of [replan].
        values: values to choose from; empty for a range.
        least, most: ends of the range, which belong to it.
        step: between the values of a range; 0 for any value.
        whole: whether only whole numbers are taken.
        along: keys that change together with this one, each with a value for each of `values`.
    """

    key: str
    values: tuple[Any, ...] = ()
    least: float = 0.0
    most: float = 0.0
    step: float = 0.0
    whole: bool = False
    along: tuple[tuple[str, tuple[Any, ...]], ...] = ()

    @property
    def count(self) -> int | None:
        """Number of values; None for a range without steps."""
        if self.values:
            return len(self.values)
        step = self._step
        return floor((self.most - self.least) / step + ROUNDING) + 1 if step else None

    @property
    def levels(self) -> int:
        """Number of values, for a full factorial.

        Raises:
            DesignError: it is a range without steps.
        """
        if self.count is None:
            raise DesignError("{key} is a range, which a full factorial goes through in steps: add step", key=self.key)
        return self.count

    def level(self, number: int) -> Any:
        """Value of a level, counted from 0."""
        if self.values:
            return self.values[number]
        return self._rounded(self.least + number * self._step)

    def at(self, place: float) -> Any:
        """Value at a place of the unit interval, 0 to 1; all levels have equal shares of it.

        Args:
            place: place, a share from 0 to 1.
        """
        if self.count is not None:
            return self.level(min(floor(place * self.count), self.count - 1))
        return self._rounded(self.least + place * (self.most - self.least))

    @property
    def some(self) -> tuple[Any, ...]:
        """Values that are enough to know their type: all that are chosen from, or the ends of a range."""
        return self.values or (self._rounded(self.least), self._rounded(self.most))

    def changes(self, value: Any) -> list[tuple[str, Any]]:
        """Keys that change with a value, this one first, each with its own value."""
        number = self.values.index(value) if self.along else 0
        return [(self.key, value), *((key, values[number]) for key, values in self.along)]

    @property
    def _step(self) -> float:
        return self.step or (1.0 if self.whole else 0.0)

    def _rounded(self, value: float) -> float | int:
        return round(value) if self.whole else float(f"{value:.{_DIGITS}g}")


FACTORIAL = "full_factorial"
Values = tuple[Any, ...]
# Values of a design by its number, counted from 0.
Plan = Callable[[int], Values]


@dataclass(frozen=True)
class Sampling:
    """A way to choose places of the unit cube.

    Attributes:
        code: name in studies.
        places: function of the number of places, of their dimensions and of the seed.
    """

    code: str
    places: Callable[[int, int, int], Array]


def _sobol(count: int, dimensions: int, seed: int) -> Array:
    """Places of a scrambled Sobol sequence (Joe & Kuo's directions, Owen's scrambling)."""
    from scipy.stats import qmc

    power = max(count - 1, 0).bit_length()  # whole powers of 2 are balanced; the first places of one are taken
    return qmc.Sobol(dimensions, rng=seed).random_base2(power)[:count]


def _latin_hypercube(count: int, dimensions: int, seed: int) -> Array:
    """Places of which each of `count` equal shares of every axis has one (McKay, Beckman & Conover 1979)."""
    from scipy.stats import qmc

    return qmc.LatinHypercube(dimensions, rng=seed).random(count)


_SAMPLINGS = Registry(
    Message("plan"), (Sampling("sobol", _sobol), Sampling("latin_hypercube", _latin_hypercube)), (FACTORIAL,)
)
register, remove = _SAMPLINGS.register, _SAMPLINGS.remove


def codes() -> tuple[str, ...]:
    """Codes of all fixed plans."""
    return (FACTORIAL, *_SAMPLINGS.codes())


def count(kind: str, variations: Sequence[Variation], designs: int | None) -> int:
    """Number of designs of a plan.

    Raises:
        DesignError: a full factorial has a range without steps.
    """
    return prod(each.levels for each in variations) if kind == FACTORIAL else designs or 0


def plan(kind: str, variations: Sequence[Variation], designs: int, seed: int) -> Plan:
    """A fixed plan.

    Args:
        kind: code of the plan.
        variations: what varies.
        designs: number of designs.
        seed: seed of a plan by chance.
    """
    if kind == FACTORIAL:
        return partial(_levels, variations)
    places = _SAMPLINGS.kind_of(kind).places(designs, len(variations), seed)
    return lambda number: values_at(variations, places[number].tolist())


def values_at(variations: Sequence[Variation], place: Sequence[float]) -> Values:
    """Values at a place of the unit cube."""
    return tuple(each.at(share) for each, share in zip(variations, place, strict=True))


def _levels(variations: Sequence[Variation], number: int) -> Values:
    """The last key varies fastest."""
    values = []
    for each in reversed(variations):
        number, level = divmod(number, each.levels)
        values.append(each.level(level))
    return tuple(reversed(values))


SEARCH = "nsga2"
_MISSING = 1e30  # of an objective that was not computed; such a design violates a limit, which counts first


class FrontSearch:
    """NSGA-II (Deb et al. 2002), asked for places and given their results.

    Args:
        dimensions: number of keys that vary.
        objectives: number of objectives.
        population: designs of a generation.
        generations: number of generations.
        seed: seed of its random numbers.

    Raises:
        DesignError: pymoo is not installed.
    """

    def __init__(self, dimensions: int, objectives: int, population: int, generations: int, seed: int) -> None:
        try:
            from pymoo.algorithms.moo.nsga2 import NSGA2
            from pymoo.core.problem import Problem
        except ImportError:
            raise DesignError(
                "a search by nsga2 needs pymoo: pip install '.[explore]' in cadgen's folder, or take the plan sobol"
            ) from None
        self._problem = Problem(n_var=dimensions, n_obj=objectives, n_ieq_constr=1, xl=0.0, xu=1.0)
        self._search: Any = NSGA2(pop_size=population)
        # One more, since it would otherwise end before the last results are in.
        self._search.setup(self._problem, termination=("n_gen", generations + 1), seed=seed % 2**32, verbose=False)
        self._asked: Any = None

    def ask(self) -> Array:
        """Places of the next generation in the unit cube, shape (population, dimensions)."""
        self._asked = self._search.ask()
        return np.asarray(self._asked.get("X"), dtype=float)

    def answer(self, objectives: Array, violations: Array) -> None:
        """Take the results of a generation.

        Args:
            objectives: objectives, each in the unit of its figure, less of which is better, shape (population,
                objectives); NaN where none was found.
            violations: shares by which each design violates its limits, shape (population,); 0 if it keeps them.
        """
        from pymoo.core.evaluator import Evaluator
        from pymoo.problems.static import StaticProblem

        filled = np.where(np.isfinite(objectives), objectives, _MISSING)
        Evaluator().eval(StaticProblem(self._problem, F=filled, G=violations[:, None]), self._asked)
        self._search.tell(infills=self._asked)
