"""The whole error budget: what everything that may be off costs at the end of the run, before and after a trim.

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
from cadgen.monte_carlo.fleet import DIRECTED, PARAMETERS, Fleet, run_fleet
from cadgen.monte_carlo.processes import HALF_WIDTHS, Process
from cadgen.monte_carlo.robust import MOST_STEERING, ONE_SIDED, steering_effect

Complex = NDArray[np.complex128]

# A new run finds these anew, or the trim itself sets them no closer (the base radius, by which it is set).
FLEETING = ("base_radius", "cam_phase", "start_x", "start_y", "start_heading", "steering_lost_motion", "temperature")
_DIRECTIONS = 24  # of what has one, looked at for the worst
_TRIM_STEPS = 4  # of Newton's method
_TRIM_PROBE = radians(0.01)
_COLUMN = {name: number for number, name in enumerate(PARAMETERS)}


@dataclass(frozen=True, kw_only=True)
class Cost:
    """What one thing that may be off costs.

    Attributes:
        name: a tolerance, or where play is.
        parameter: tolerance that it acts as: one of `robust.TOLERANCES`, or `play`.
        half_width: how far off it may be, in the unit of the parameter.
        before: how far the end of the run is moved at most, mm.
        after: the same after a trim; of what does not repeat, as before.
        repeats: whether the next run has the same, so that a trim can take it out.
        rough: whether it is beyond what first order is good for.
    """

    name: str
    parameter: str
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
        """All of them together, as the root of the sum of squares, mm."""
        return float(np.sqrt(sum(cost.before**2 for cost in self.costs)))

    @property
    def after(self) -> float:
        """The same after a trim, mm."""
        return float(np.sqrt(sum(cost.after**2 for cost in self.costs)))


def error_budget(fleet: Fleet, half_widths: Mapping[str, float], plays: Mapping[str, float]) -> Budget:
    """Rank everything that may be off by what it costs at the end of the run.

    Args:
        fleet: the nominal car.
        half_widths: of tolerances, as in `robust.Tolerances`.
        plays: place of play -> half of its zone, rad.
    """
    wanted = [(name, name, half) for name, half in half_widths.items() if half > 0]
    wanted += [(name, "play", half) for name, half in plays.items() if half > 0]
    if not wanted:
        return Budget(())
    fleet = replace(
        fleet,
        stations=fleet.stations[-1:],
        planned=replace(fleet.planned, heading=fleet.planned.heading[:, -1:], position=fleet.planned.position[:, -1:]),
    )
    tables = [_cases(parameter, half) for _, parameter, half in wanted]
    cases = np.concatenate(tables)
    first = np.concatenate([[0], np.cumsum([len(table) for table in tables])])[:-1]
    before, after = _moved(fleet, cases)
    costs = []
    for number, (name, parameter, half) in enumerate(wanted):
        own = slice(first[number], first[number] + len(tables[number]))
        repeats = name not in FLEETING
        worst = float(before[own].max())
        costs.append(
            Cost(
                name=name,
                parameter=parameter,
                half_width=half,
                before=worst,
                after=float(after[own].max()) if repeats else worst,
                repeats=repeats,
                rough=parameter != "play" and half * steering_effect(fleet, parameter) > MOST_STEERING,
            )
        )
    return Budget(tuple(sorted(costs, key=lambda cost: -cost.after)))


def by_process(fleet: Fleet) -> dict[Process, Budget]:
    """The part of the budget that the disc's making decides, for processes by name."""
    return {process: error_budget(fleet, halves, {}) for process, halves in HALF_WIDTHS.items()}


def _cases(parameter: str, half: float) -> Array:
    """Cars at the limits of one tolerance, in every direction if it has one; shape (k, columns)."""
    if parameter in DIRECTED:
        angle = TURN / _DIRECTIONS * np.arange(_DIRECTIONS)
        found = np.zeros((_DIRECTIONS, len(PARAMETERS)))
        found[:, [_COLUMN[part] for part in DIRECTED[parameter]]] = half * np.stack(
            [np.cos(angle), np.sin(angle)], axis=1
        )
        return found
    ends = [half] if parameter in ONE_SIDED else [-half, half]
    found = np.zeros((len(ends), len(PARAMETERS)))
    found[:, _COLUMN[parameter]] = ends
    return found


def _moved(fleet: Fleet, cases: Array) -> tuple[Array, Array]:
    """How far the ends of the runs of cars are from the nominal car's, before and after a trim, mm, shape (m,)."""

    def ends(turn: Array) -> Complex:
        turned = cases.copy()
        turned[:, _COLUMN["steering_zero"]] += turn
        return np.asarray(run_fleet(fleet, turned).position[:, -1] - nominal)

    nominal = run_fleet(fleet, np.zeros((1, len(PARAMETERS)))).position[0, -1]
    turn = np.zeros(len(cases))
    now = before = ends(turn)
    for _ in range(_TRIM_STEPS):
        rate = (ends(turn + _TRIM_PROBE) - now) / _TRIM_PROBE
        turn = turn - (rate.conj() * now).real / np.abs(rate) ** 2
        now = ends(turn)
    return np.abs(before), np.abs(now)
