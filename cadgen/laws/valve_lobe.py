"""The lobe of a valve, 2-p-q-r-s: a polynomial of five powers from the nose, where x = 0, to the end, where x = 1.

    lift(x) = 1 + C_2 x^2 + C_p x^p + C_q x^q + C_r x^r + C_s x^s,

with the lift and four derivatives 0 at x = 1: five linear equations (Rothbart, Cam Design Handbook, ch. 3, polydyne
cams). As a rise its share is u = 1 - x, and a return runs it backwards, so the nose is always the top.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from math import perm
from typing import TYPE_CHECKING

from cadgen.laws.form import ORDERS
from cadgen.laws.law import MotionLaw
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.arrays import Array

_USUAL = (10, 18, 26, 34)
_MOST_POWER = 60  # beyond, quintic pieces no longer follow it
_PIECES = 256


def valve_lobe(powers: Sequence[int]) -> MotionLaw:
    """Law of a lobe.

    Args:
        powers: p, q, r and s, whole numbers that grow, 3 to 60.

    Raises:
        ValueError: not four such numbers.
    """
    powers = tuple(powers)
    if (
        len(powers) != 4
        or powers[0] < 3
        or powers[-1] > _MOST_POWER
        or len(set(powers)) < 4
        or sorted(powers) != [*powers]
    ):
        raise ValueError(
            Message(
                "powers is {powers}; it must be four whole numbers that grow, from 3 to {most}, such as {usual}: "
                "correct it",
                powers=str(list(powers)),
                most=_MOST_POWER,
                usual=str(list(_USUAL)),
            )
        )
    return MotionLaw(
        code="valve_lobe",
        meaning="The lobe of a valve, 2-p-q-r-s, by `powers` = [p, q, r, s], [10, 18, 26, 34] if left out.",
        jet=partial(_jet, powers, coefficients(powers)),
        pieces=_PIECES,
        to_top=True,
        key="powers",
        shaped=valve_lobe,
    )


def coefficients(powers: Sequence[int]) -> tuple[float, ...]:
    """C_2, C_p, C_q, C_r and C_s, by exact elimination.

    Args:
        powers: p, q, r and s.
    """
    every = (2, *powers)
    rows = [[Fraction(perm(n, order)) for n in every] + [Fraction(-1 if order == 0 else 0)] for order in range(5)]
    for column in range(5):
        pivot = next(row for row in range(column, 5) if rows[row][column])
        rows[column], rows[pivot] = rows[pivot], rows[column]
        rows[column] = [value / rows[column][column] for value in rows[column]]
        for row in range(5):
            if row != column:
                factor = rows[row][column]
                rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column], strict=True)]
    return tuple(float(row[-1]) for row in rows)


def _jet(powers: tuple[int, ...], factors: tuple[float, ...], u: "Array") -> "Array":
    import numpy as np

    x = 1.0 - u
    value = np.zeros((len(u), ORDERS))
    value[:, 0] = 1.0
    for power, factor in zip((2, *powers), factors, strict=True):
        for order in range(min(ORDERS, power + 1)):
            value[:, order] += (-1) ** order * factor * perm(power, order) * x ** (power - order)
    return value


VALVE_LOBE = valve_lobe(_USUAL)
