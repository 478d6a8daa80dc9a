"""Fixed plans: places of the unit cube, or levels, chosen before anything is computed; a new one is one function."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

from cadgen.arrays import Array
from cadgen.registry import Registry
from cadgen.studies.variation import Variation

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


_SAMPLINGS = Registry("plan", (Sampling("sobol", _sobol), Sampling("latin_hypercube", _latin_hypercube)), (FACTORIAL,))
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
        return lambda number: _levels(variations, number)
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
