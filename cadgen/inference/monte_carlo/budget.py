"""The whole error budget: cost of every deviation at the end of the run, before and after a trim.

A trim is a constant turn of the steering, set after a trial run so that the end is met as closely as it goes. It takes
out what repeats from run to run, as far as a turn of the steering can; what does not repeat, and how closely the base
radius can be set, by which it is done, it leaves as they are.

A disc alone is ranked by manufacturing process. Half widths, in mm and rad, are those that a process makes on a disc of
some 150 mm, 3 mm thick. The sources call them normal for it; a shop's own figures are better, and go into [tolerances].

- **milled**: an end mill in one clamping holds 0.025 mm (tables of process capability: 0.025 to 0.13 mm; Machinery's
  Handbook: milling IT 10, reaming and boring IT 7 to 8, which for a bore of 8 mm is 15 um); the mill gives way by some
  hundredth over its length; edges are broken by hand; faces as ISO 2768-f, 0.05 mm.
- **wire-cut** (wire EDM): 5 um of profile and taper with a second pass (makers' data: 2.5 to 5 um); bore and profile in
  one clamping.
- **laser-cut**: 0.1 mm of profile (ISO 9013, laser, up to 3 mm thick; job shops: 0.13 mm), the cut leans by
  0.05 mm + 0.003 of the thickness (ISO 9013, perpendicularity, range 1), and sheet varies in thickness.
- **printed** (melted filament): 0.15 mm (tables: 0.1 to 0.5 mm), the first layers stand out, edges are round with half
  the bead.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations.deviation import (
    COLUMNS,
    EACH_RUN,
    ECCENTRIC_BORE,
    EDGE_BREAK,
    INNER_FACE,
    OUTER_FACE,
    PROFILE_OFFSET,
    RETURN_ERROR,
    STEERING_ZERO,
    TAPER,
    WOBBLE,
    Deviation,
)
from cadgen.inference.monte_carlo.cars import Cars, run_cars
from cadgen.inference.monte_carlo.random_cars import MOST_STEERING, at_end, steering_effect

Complex = NDArray[np.complex128]

_DIRECTIONS = 24  # of a deviation that has one, searched for the worst
_TRIM_STEPS = 4  # of Newton's method
_TRIM_PROBE = radians(0.01)


class Process(StrEnum):
    """Process by which a disc is made."""

    MILLED = "milled"
    WIRE_CUT = "wire-cut"
    LASER_CUT = "laser-cut"
    PRINTED = "printed"


HALF_WIDTHS: dict[Process, dict[Deviation, float]] = {
    process: dict(
        zip((PROFILE_OFFSET, TAPER, EDGE_BREAK, ECCENTRIC_BORE, WOBBLE, INNER_FACE, OUTER_FACE), halves, strict=True)
    )
    for process, halves in {
        Process.MILLED: (0.025, 0.01, 0.05, 0.01, radians(0.05), 0.05, 0.05),
        Process.WIRE_CUT: (0.005, 0.005, 0.01, 0.005, radians(0.05), 0.05, 0.05),
        Process.LASER_CUT: (0.1, 0.06, 0.02, 0.05, radians(0.1), 0.1, 0.1),
        Process.PRINTED: (0.15, 0.1, 0.1, 0.1, radians(0.2), 0.1, 0.1),
    }.items()
}


@dataclass(frozen=True, kw_only=True)
class Cost:
    """Cost of one deviation at the end of the run.

    Attributes:
        name: name of the tolerance, or place of the play.
        deviation: what deviates.
        half_width: half of the tolerance zone, in the unit of the deviation.
        before: greatest distance by which the end of the run is moved, mm.
        after: that distance after a trim, mm; equal to `before` for a deviation that does not repeat.
        repeats: whether the next run has the same deviation, so that a trim can take it out.
        rough: whether the deviation is too large for an estimate to first order.
    """

    name: str
    deviation: Deviation
    half_width: float
    before: float
    after: float
    repeats: bool
    rough: bool


@dataclass(frozen=True)
class Budget:
    """Costs in order, greatest after a trim first."""

    costs: tuple[Cost, ...]

    @property
    def before(self) -> float:
        """All costs before a trim together, as the root of the sum of squares, mm."""
        return float(np.sqrt(sum(cost.before**2 for cost in self.costs)))

    @property
    def after(self) -> float:
        """All costs after a trim together, as the root of the sum of squares, mm."""
        return float(np.sqrt(sum(cost.after**2 for cost in self.costs)))


def each_run(costs: Iterable[Cost]) -> float:
    """Costs of what comes anew in every run together, as the root of the sum of squares, mm."""
    return float(np.sqrt(sum(cost.after**2 for cost in costs if cost.deviation in EACH_RUN)))


def error_budget(cars: Cars, half_widths: Mapping[Deviation, float], plays: Mapping[str, float]) -> Budget:
    """Rank all deviations by their cost at the end of the run.

    Args:
        cars: nominal car.
        half_widths: half widths of the tolerances, as in `robust.Tolerances`.
        plays: half of the zone of each play, rad, by the place of the play.
    """
    deviations = [(each.key, each, half) for each, half in half_widths.items() if half > 0]
    deviations += [(place, RETURN_ERROR, half) for place, half in plays.items() if half > 0]
    if not deviations:
        return Budget(())
    cars = at_end(cars)
    tables = [_cases(each, half) for _, each, half in deviations]
    cases = np.concatenate(tables)
    first = np.concatenate([[0], np.cumsum([len(table) for table in tables])])[:-1]
    before, after = _moved(cars, cases)
    costs = []
    for number, (name, each, half) in enumerate(deviations):
        rows = slice(first[number], first[number] + len(tables[number]))
        worst = float(before[rows].max())
        costs.append(
            Cost(
                name=name,
                deviation=each,
                half_width=half,
                before=worst,
                after=worst if each.fleeting else float(after[rows].max()),
                repeats=not each.fleeting,
                rough=each != RETURN_ERROR and half * steering_effect(cars, each) > MOST_STEERING,
            )
        )
    return Budget(tuple(sorted(costs, key=lambda cost: -cost.after)))


def by_process(cars: Cars) -> dict[Process, Budget]:
    """Budget of the disc's making, by process."""
    return {process: error_budget(cars, halves, {}) for process, halves in HALF_WIDTHS.items()}


def _cases(deviation: Deviation, half: float) -> Array:
    """Cars at the limits of one tolerance, in every direction if it has one; shape (k, columns)."""
    if deviation.directed:
        angle = TURN / _DIRECTIONS * np.arange(_DIRECTIONS)
        ends = half * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    else:
        ends = np.array([[half]] if deviation.one_sided else [[-half], [half]])
    cars = np.zeros((len(ends), len(COLUMNS)))
    cars[:, deviation.columns] = ends
    return cars


def _moved(cars: Cars, cases: Array) -> tuple[Array, Array]:
    """Distances of the ends of cars' runs from the nominal car's, before and after a trim, shape (m,) each, mm."""

    def ends(turn: Array) -> Complex:
        turned = cases.copy()
        turned[:, STEERING_ZERO.column] += turn
        return np.asarray(run_cars(cars, turned).position[:, cars.end] - nominal)

    nominal = run_cars(cars, np.zeros((1, len(COLUMNS)))).position[0, cars.end]
    turn = np.zeros(len(cases))
    now = before = ends(turn)
    for _ in range(_TRIM_STEPS):
        rate = (ends(turn + _TRIM_PROBE) - now) / _TRIM_PROBE
        turn = turn - (rate.conj() * now).real / np.abs(rate) ** 2
        now = ends(turn)
    return np.abs(before), np.abs(now)
