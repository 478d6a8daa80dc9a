"""Tolerances of spur gears, from the formulas of the standards.

| symbol | what it limits                          | source                                      |
|--------|-----------------------------------------|---------------------------------------------|
| f_pt   | single pitch deviation                  | ISO 1328-1:1995, 6.1                         |
| F_pk   | cumulative pitch deviation over k teeth | ISO 1328-1:1995, 6.2                         |
| F_p    | total cumulative pitch deviation        | ISO 1328-1:1995, 6.3                         |
| F_α    | total profile deviation                 | ISO 1328-1:1995, 6.4                         |
| F_β    | total helix deviation                   | ISO 1328-1:1995, 6.5                         |
| F_i''  | total radial composite deviation        | ISO 1328-2:1997, clause 7                    |
| f_i''  | tooth-to-tooth radial composite         | ISO 1328-2:1997, clause 7                    |
| F_r    | radial runout                           | ISO 1328-2:1997, annex B                     |
| IT     | standard tolerance of a size            | ISO 286-1:1988, annex A                      |
| f_a    | centre distance, ± half an IT           | GB/T 10095-1988, supplementary table         |
| b_r    | radial feed when cutting the teeth      | Chinese gear handbooks for GB/T 10095        |

A formula of ISO 1328 holds for grade 5, with the geometric means of the limits of the steps that hold d, m
and b; another grade Q multiplies the unrounded value by 2^((Q − 5)/2), and the result is rounded. Grades 3 to
12 are offered. ISO 1328-1 and the runout go down to grade 0; ISO 1328-2 begins at 4 for F_i'' and f_i'', and
3 is its own rule carried one step further. The handbooks give b_r for 4 to 9; the others follow its pattern.

Sizes may be arrays, which broadcast. Sizes and results are in mm; a size or grade outside the ranges raises
`DesignError`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import cache, partial
from math import floor
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.messages import Message

# One gear's numbers, or the arrays of many.
T = TypeVar("T", float, Array)

UM_PER_MM = 1000
GRADES = range(3, 13)
DIAMETER_STEPS = (5, 20, 50, 125, 280, 560, 1000, 1600, 2500, 4000, 6000, 8000, 10000)
MODULE_STEPS = (0.5, 2, 3.5, 6, 10, 16, 25, 40, 70)
WIDTH_STEPS = (4, 10, 20, 40, 80, 160, 250, 400, 650, 1000)
COMPOSITE_DIAMETER_STEPS = (5, 20, 50, 125, 280, 560, 1000)
COMPOSITE_MODULE_STEPS = (0.2, 0.5, 0.8, 1, 1.5, 2.5, 4, 6, 10)
SIZE_STEPS = (0, 3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500)
# The reference diameters for which every one of `GearTolerances` has a rule.
COVERED_DIAMETERS = (DIAMETER_STEPS[0], SIZE_STEPS[-1])
# A size that equals a step's upper limit but for rounding of z·m (relative) belongs to that step.
STEP_SLACK = 1e-12

_OF_PITCH, _OF_HELIX = 0.3, 0.2  # shares of F_p and F_β that a blank may take
_OF_MODULE = 0.1  # greatest tolerance of a tip diameter
_LEAST_RUN_OUT = 0.005  # mm

IT_FACTORS = {5: 7, 6: 10, 7: 16, 8: 25, 9: 40, 10: 64}
# Where the printed table of ISO 286-1, which prevails by the standard's own note, departs from its formulas
# and rounding: {grade: {upper limit of the size step, mm: value, µm}}.
IT_DEPARTURES: dict[int, dict[int, float]] = {
    3: {6: 2.5, 10: 2.5, 30: 4, 400: 13, 500: 15},
    4: {6: 4, 400: 18, 500: 20},
    6: {3: 6, 6: 8, 400: 36, 500: 40},
    7: {3: 10, 10: 15, 18: 18, 500: 63},
    9: {3: 25, 6: 30},
    10: {3: 40, 6: 48, 10: 58, 18: 70},
    11: {6: 75},
}
CENTRE_DISTANCE_GRADES = {3: 6, 4: 6, 5: 7, 6: 7, 7: 8, 8: 8, 9: 9, 10: 9, 11: 11, 12: 11}


class _Rule(NamedTuple):
    """Formula of ISO 1328 for grade 5, in µm, on the step means of the reference diameter and of a second size, mm."""

    formula: Callable[[Array, Array], Array]
    second: str = "module"
    second_steps: Sequence[float] = MODULE_STEPS
    standard: str = "ISO 1328-1"
    diameter_steps: Sequence[float] = DIAMETER_STEPS
    finest: float = 0.1  # µm, to which values below 5 µm are rounded


def _f_pt(d: Array, m: Array) -> Array:
    return 0.3 * (m + 0.4 * np.sqrt(d)) + 4


_of_part_2 = partial(
    _Rule,
    second_steps=COMPOSITE_MODULE_STEPS,
    standard="ISO 1328-2",
    diameter_steps=COMPOSITE_DIAMETER_STEPS,
    finest=0.5,
)
_RULES = {
    "f_pt": _Rule(_f_pt),
    "F_p": _Rule(lambda d, m: 0.3 * m + 1.25 * np.sqrt(d) + 7),
    "F_alpha": _Rule(lambda d, m: 3.2 * np.sqrt(m) + 0.22 * np.sqrt(d) + 0.7),
    "F_beta": _Rule(lambda d, b: 0.1 * np.sqrt(d) + 0.63 * np.sqrt(b) + 4.2, "face width", WIDTH_STEPS),
    "F_r": _Rule(lambda d, m: 0.24 * m + np.sqrt(d) + 5.6, finest=0.5),  # 0.8 F_p
    "F_i_radial": _of_part_2(lambda d, m: 3.2 * m + 1.01 * np.sqrt(d) + 6.4),
    "f_i_radial": _of_part_2(lambda d, m: 2.96 * m + 0.01 * np.sqrt(d) + 0.8),
}


def flank_tolerance(symbol: str, diameter: ArrayLike, second: ArrayLike, grade: int) -> Array:
    """Tolerance of ISO 1328 for its symbol, mm: of f_pt, F_p, F_alpha, F_beta, F_r, F_i_radial (F_i'') or f_i_radial.

    Args:
        symbol: one of these.
        diameter: reference diameter d, mm.
        second: normal module m, or for F_beta the face width b, mm.
        grade: tolerance grade, 3 to 12.

    Raises:
        DesignError: a size or the grade is outside the standard.
    """
    return _by_rule(symbol, _RULES[symbol], diameter, second, grade)


def span_pitch_deviation(diameter: ArrayLike, module: ArrayLike, pitches: int, grade: int) -> Array:
    """F_pk = f_pt + 1.6 √((k − 1) m) µm at grade 5, over k = `pitches`, 2 to z/8 in the standard.

    Args:
        diameter: reference diameter d, mm.
        module: normal module, mm.
        pitches: number k of pitches.
        grade: tolerance grade, 3 to 12.
    """
    if pitches < 2:
        raise DesignError("F_pk over {pitches} pitches is not defined; give 2 or more", pitches=pitches)
    rule = _Rule(lambda d, m: _f_pt(d, m) + 1.6 * np.sqrt((pitches - 1) * m))
    return _by_rule("F_pk", rule, diameter, module, grade)


def run_outs(diameter: float, module: float, width: float, face: float, grade: int) -> tuple[float, float]:
    """Circular run-out of a blank's tip circle and of its face to the axis of the bore, mm.

    A blank off its axis by e adds 2 e to the cumulative pitch. A face that runs out by t over the diameter D leans the
    teeth by t b / D over their width b. The tips are left 0.3 of F_p, which takes 5 % of it in a root sum of squares.
    The face is left 0.2 of F_β. This gives run-outs 0.3 F_p and 0.2 (D / b) F_β. Rounded down to whole µm, but at least
    5 µm, which a shop still measures.

    Args:
        diameter: reference diameter d, mm.
        module: normal module, mm.
        width: face width b, mm.
        face: greatest diameter D of the face, mm.
        grade: tolerance grade of ISO 1328.

    Raises:
        DesignError: a size that the standard does not cover.
    """
    tip = _OF_PITCH * float(flank_tolerance("F_p", diameter, module, grade))
    side = _OF_HELIX * face / width * float(flank_tolerance("F_beta", diameter, width, grade))
    tip, side = (max(floor(value * UM_PER_MM + STEP_SLACK) / UM_PER_MM, _LEAST_RUN_OUT) for value in (tip, side))
    return tip, side


def tip_tolerance(diameter: float, module: float) -> float:
    """Tolerance of a tip diameter that no size is measured from, mm: into the material, as of an h or H.

    IT11, but no more than a tenth of the normal module (GB/T 10095-1988, blanks), so that the tips keep their clearance
    and the teeth nearly all of their contact ratio.

    Args:
        diameter: tip diameter, mm.
        module: normal module, mm.
    """
    most = _OF_MODULE * module
    return min(most, float(standard_tolerance(diameter, 11))) if diameter <= SIZE_STEPS[-1] else most


def standard_tolerance(size: ArrayLike, it_grade: int, quantity: str = "size", symbol: str = "IT") -> Array:
    """Standard tolerance of ISO 286-1, IT3 to IT12, for sizes above 0 and up to 500 mm.

    IT5 to IT10 are multiples of i = 0.45 ∛D + 0.001 D µm with the geometric mean D of the step (of 1 and 3 mm
    in the first); IT11 and IT12 are ten times IT6 and IT7; IT3 and IT4 lie in geometric progression between
    IT1 = 0.8 + 0.020 D and IT5. Rounded to 1 µm, above 100 µm to 5, above 200 µm to 10; `IT_DEPARTURES` are
    the values printed otherwise. (The standard goes on to 3150 mm with another formula.) `quantity` is what is
    sized, and `symbol` what for, in the words of an error.

    Args:
        size: nominal size, mm.
        it_grade: number of the grade, 3 to 12.
        quantity: name of what is sized, for the words of an error.
        symbol: symbol of what it is for, likewise.
    """
    sizes = np.asarray(size, dtype=np.float64)
    if not np.all(sizes > 0):
        raise DesignError(
            "the {quantity} {size:g} mm is outside ISO 286-1; give one above 0 mm",
            quantity=Message(quantity),
            size=_first(sizes, sizes > 0),
        )
    step = _step(sizes, SIZE_STEPS, quantity, "ISO 286-1", symbol)
    return _it_um(_checked(it_grade, "IT grade"))[step - 1] / UM_PER_MM


def centre_distance_deviation(centre_distance: ArrayLike, grade: int) -> Array:
    """f_a (mm) of the centre distance a ± f_a: half of IT6 (grades 3-4), 7 (5-6), 8 (7-8), 9 (9-10) or 11.

    Args:
        centre_distance: distance a of the axes, mm.
        grade: tolerance grade, 3 to 12.
    """
    return standard_tolerance(centre_distance, CENTRE_DISTANCE_GRADES[_checked(grade)], "centre distance", "f_a") / 2


def cutting_feed_tolerance(diameter: ArrayLike, grade: int) -> Array:
    """b_r (mm): IT7 for grade 3, 1.26 IT7 for 4, IT8 for 5, 1.26 IT8 for 6, IT9 for 7, and so on.

    Args:
        diameter: reference diameter d, mm.
        grade: tolerance grade, 3 to 12.
    """
    step, coarser = divmod(_checked(grade) - GRADES[0], 2)
    return standard_tolerance(diameter, 7 + step, "reference diameter", "b_r") * (1.26 if coarser else 1.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class GearTolerances(Generic[T]):
    """The tolerances of one gear (or of many) that enter eq. 1-13, in mm; `F_i_radial` is F_i''."""

    f_pt: T
    F_beta: T
    F_r: T
    b_r: T
    F_i_radial: T


@dataclass(frozen=True, slots=True, kw_only=True)
class ToleranceOverrides:
    """Values in mm that stand in for the standards'; None leaves the standard's value.

    Raises `DesignError` for a value that is negative or not finite.
    """

    f_pt: float | None = None
    F_beta: float | None = None
    F_r: float | None = None
    b_r: float | None = None
    F_i_radial: float | None = None

    def __post_init__(self) -> None:
        for name, value in self.overridden().items():
            if not 0 <= value < np.inf:
                raise DesignError(
                    "the override {name} = {value:g} mm is no tolerance; give 0 or more", name=name, value=value
                )

    def overridden(self) -> dict[str, float]:
        """The overridden values by symbol."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value for name, value in values.items() if value is not None}


def gear_tolerance(symbol: str, diameter: T, module: T, width: T, grade: int) -> T:
    """The standard's value of one of `GearTolerances`' symbols, for d, m and b."""
    if symbol == "b_r":
        value: Any = cutting_feed_tolerance(diameter, grade)
    else:
        value = flank_tolerance(symbol, diameter, width if symbol == "F_beta" else module, grade)
    of_kind: T = value
    return of_kind


def gear_tolerances(
    diameter: T, module: T, width: T, grade: int, overrides: ToleranceOverrides | None = None
) -> GearTolerances[T]:
    """Tolerances of a gear of reference diameter d, module m and face width b.

    An overridden one is not looked up. Raises `DesignError` when d, m, b or the grade is outside the rule of
    one that is.
    """
    values: dict[str, Any] = dict(overrides.overridden()) if overrides else {}
    for symbol in (field.name for field in fields(GearTolerances)):
        if symbol not in values:
            values[symbol] = gear_tolerance(symbol, diameter, module, width, grade)
    return GearTolerances(**values)


def _by_rule(symbol: str, rule: _Rule, diameter: ArrayLike, second: ArrayLike, grade: int) -> Array:
    """Value in mm at the grade, rounded to 1 µm above 10 µm, to 0.5 µm below, and below 5 µm to the rule's finest."""
    d = _step_mean(diameter, rule.diameter_steps, "reference diameter", rule.standard, symbol)
    other = _step_mean(second, rule.second_steps, rule.second, rule.standard, symbol)
    value = rule.formula(d, other) * 2 ** ((_checked(grade) - 5) / 2)
    return _rounded(value, np.where(value > 10, 1.0, np.where(value >= 5, 0.5, rule.finest))) / UM_PER_MM


def _step_mean(size: ArrayLike, steps: Sequence[float], quantity: str, standard: str, symbol: str) -> Array:
    """Geometric mean of the limits of the step (lower, upper] that holds each size."""
    upper = _step(size, steps, quantity, standard, symbol)
    limits = np.asarray(steps, dtype=np.float64)
    return np.sqrt(limits[upper - 1] * limits[upper])


def _step(size: ArrayLike, steps: Sequence[float], quantity: str, standard: str, symbol: str) -> NDArray[np.intp]:
    """Index of the upper limit of the step that holds each size; the least size belongs to the first step."""
    sizes = np.asarray(size, dtype=np.float64)
    covered = (sizes >= steps[0] * (1 - STEP_SLACK)) & (sizes <= steps[-1] * (1 + STEP_SLACK))
    if not np.all(covered):
        raise DesignError(
            "the {quantity} {size:g} mm is outside {standard}, which gives {symbol}; give {least:g} to "
            "{most:g} mm, a value for {symbol}, or standard free for the tolerances of your own alone",
            quantity=Message(quantity),
            size=_first(sizes, covered),
            standard=standard,
            symbol=symbol,
            least=steps[0],
            most=steps[-1],
        )
    return np.maximum(np.searchsorted(steps, sizes * (1 - STEP_SLACK), side="left"), 1)


def _first(sizes: Array, good: NDArray[np.bool_]) -> float:
    return float(np.extract(~good, sizes)[0])


def _checked(grade: int, name: str = "tolerance grade") -> int:
    if grade not in GRADES:
        raise DesignError(
            "the {name} {grade} is not offered; give a whole number from {finest} to {coarsest}",
            name=Message(name),
            grade=grade,
            finest=GRADES[0],
            coarsest=GRADES[-1],
        )
    return grade


def _rounded(value: Array, unit: Array) -> Array:
    return np.asarray(unit * np.floor(value / unit + 0.5))


@cache
def _it_um(grade: int) -> Array:
    """IT in µm of every size step, shape (13,)."""
    upper = np.asarray(SIZE_STEPS[1:], dtype=np.float64)
    mean = np.sqrt(np.maximum(SIZE_STEPS[:-1], 1.0) * upper)
    unit = 0.45 * np.cbrt(mean) + 0.001 * mean
    if grade < 5:
        value = (0.8 + 0.020 * mean) ** ((5 - grade) / 4) * (IT_FACTORS[5] * unit) ** ((grade - 1) / 4)
    elif grade > 10:
        value = 10 * _it_um(grade - 5)
    else:
        value = IT_FACTORS[grade] * unit
    table = _rounded(value, np.where(value <= 100, 1.0, np.where(value <= 200, 5.0, 10.0)))
    for limit, printed in IT_DEPARTURES.get(grade, {}).items():
        table[upper == limit] = printed
    table.flags.writeable = False
    return table
