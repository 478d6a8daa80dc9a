"""The whole error budget: cost of every deviation at the end of the run, before and after a trim.

A trim is a constant turn of the steering, set after a trial run so that the end is met as closely as it goes. It takes
out what repeats from run to run, as far as a turn of the steering can; what does not repeat, and how closely the base
radius can be set, by which it is done, it leaves as they are.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.inference.monte_carlo.fleet import Fleet, run_fleet
from cadgen.inference.monte_carlo.parameters import Directed, Parameter, Tolerance
from cadgen.inference.monte_carlo.processes import HALF_WIDTHS, Process
from cadgen.inference.monte_carlo.robust import MOST_STEERING, ONE_SIDED, steering_effect

Complex = NDArray[np.complex128]

# These differ from run to run, or the trim itself sets them no closer (the base radius, by which it is set).
FLEETING = (
    Parameter.BASE_RADIUS,
    Parameter.CAM_PHASE,
    Parameter.START_X,
    Parameter.START_Y,
    Parameter.START_HEADING,
    Parameter.STEERING_LOST_MOTION,
    Parameter.TEMPERATURE,
)
_DIRECTIONS = 24  # of a deviation that has one, searched for the worst
_TRIM_STEPS = 4  # of Newton's method
_TRIM_PROBE = radians(0.01)


@dataclass(frozen=True, kw_only=True)
class Cost:
    """Cost of one deviation at the end of the run.

    Attributes:
        name: name of the tolerance, or place of the play.
        parameter: parameter that deviates: one of `TOLERANCES`, or `play`.
        half_width: half of the tolerance zone, in the unit of the parameter.
        before: greatest distance by which the end of the run is moved, mm.
        after: that distance after a trim, mm; equal to `before` for a deviation that does not repeat.
        repeats: whether the next run has the same deviation, so that a trim can take it out.
        rough: whether the deviation is too large for an estimate to first order.
    """

    name: str
    parameter: Tolerance
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


def error_budget(fleet: Fleet, half_widths: Mapping[Tolerance, float], plays: Mapping[str, float]) -> Budget:
    """Rank all deviations by their cost at the end of the run.

    Args:
        fleet: nominal car.
        half_widths: half widths of the tolerances, as in `robust.Tolerances`.
        plays: half of the zone of each play, rad, by the place of the play.
    """
    deviations: list[tuple[str, Tolerance, float]] = [
        (name, name, half) for name, half in half_widths.items() if half > 0
    ]
    deviations += [(name, Parameter.PLAY, half) for name, half in plays.items() if half > 0]
    if not deviations:
        return Budget(())
    at = [fleet.end]
    fleet = replace(
        fleet,
        stations=fleet.stations[at],
        planned=replace(fleet.planned, heading=fleet.planned.heading[:, at], position=fleet.planned.position[:, at]),
        end=-1,
        watches=(),
    )
    tables = [_cases(parameter, half) for _, parameter, half in deviations]
    cases = np.concatenate(tables)
    first = np.concatenate([[0], np.cumsum([len(table) for table in tables])])[:-1]
    before, after = _moved(fleet, cases)
    costs = []
    for number, (name, parameter, half) in enumerate(deviations):
        rows = slice(first[number], first[number] + len(tables[number]))
        repeats = parameter not in FLEETING
        worst = float(before[rows].max())
        costs.append(
            Cost(
                name=name,
                parameter=parameter,
                half_width=half,
                before=worst,
                after=float(after[rows].max()) if repeats else worst,
                repeats=repeats,
                rough=parameter != Parameter.PLAY and half * steering_effect(fleet, parameter) > MOST_STEERING,
            )
        )
    return Budget(tuple(sorted(costs, key=lambda cost: -cost.after)))


def by_process(fleet: Fleet) -> dict[Process, Budget]:
    """The part of the budget that the disc's making decides, for processes by name."""
    return {process: error_budget(fleet, halves, {}) for process, halves in HALF_WIDTHS.items()}


def _cases(parameter: Tolerance, half: float) -> Array:
    """Cars at the limits of one tolerance, in every direction if it has one; shape (k, columns)."""
    if isinstance(parameter, Directed):
        angle = TURN / _DIRECTIONS * np.arange(_DIRECTIONS)
        cars = np.zeros((_DIRECTIONS, len(Parameter)))
        cars[:, [part.column for part in parameter.parts]] = half * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        return cars
    ends = [half] if parameter in ONE_SIDED else [-half, half]
    cars = np.zeros((len(ends), len(Parameter)))
    cars[:, parameter.column] = ends
    return cars


def _moved(fleet: Fleet, cases: Array) -> tuple[Array, Array]:
    """Distances of the ends of cars' runs from the nominal car's, before and after a trim, shape (m,) each, mm."""

    def ends(turn: Array) -> Complex:
        turned = cases.copy()
        turned[:, Parameter.STEERING_ZERO.column] += turn
        return np.asarray(run_fleet(fleet, turned).position[:, fleet.end] - nominal)

    nominal = run_fleet(fleet, np.zeros((1, len(Parameter)))).position[0, fleet.end]
    turn = np.zeros(len(cases))
    now = before = ends(turn)
    for _ in range(_TRIM_STEPS):
        rate = (ends(turn + _TRIM_PROBE) - now) / _TRIM_PROBE
        turn = turn - (rate.conj() * now).real / np.abs(rate) ** 2
        now = ends(turn)
    return np.abs(before), np.abs(now)
