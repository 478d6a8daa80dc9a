"""Settings with the least expected error over the cars that explain the trial runs, and what to expect with them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import radians
from types import MappingProxyType

import numpy as np
from scipy.optimize import lsq_linear

from cadgen.arrays import Array
from cadgen.inference.adjustment.posterior import Cars, started
from cadgen.inference.adjustment.trial import STARTS, Complex, Noise, Setting, Settings
from cadgen.inference.monte_carlo.fleet import Fleet, run_fleet

# How far each setting may be changed either way, mm and rad.
LIMITS: Mapping[Setting, float] = MappingProxyType(
    {
        Setting.HEAD: 1.0,
        Setting.KEY: radians(5.0),
        Setting.START_X: 100.0,
        Setting.START_Y: 100.0,
        Setting.START_HEADING: radians(3.0),
    }
)
# Changes from which derivatives are taken: a hundredth of what moves the end of the paper's car by a metre.
_PROBES = {
    Setting.HEAD: 5e-4,
    Setting.KEY: radians(0.02),
    Setting.START_X: 1.0,
    Setting.START_Y: 1.0,
    Setting.START_HEADING: radians(0.02),
}
_STEPS = 4
# Share of the mean square error along the run beside that at its end. More would trade the finish for the way.
_WAY = 0.25
_RIDGE = 1e-4  # of the limits, in the units of errors: settings that hardly matter stay where they are


@dataclass(frozen=True, kw_only=True)
class Forecast:
    """Position errors that cars make with some settings, m cars.

    Attributes:
        end: error at the end of the run, shape (m,), mm.
        way: greatest error anywhere on the run, shape (m,), mm.
    """

    end: Array
    way: Array

    def end_quantile(self, share: float) -> float:
        """Error at the end that a share of the cars stays within, mm.

        Args:
            share: share of the cars, 0 to 1.
        """
        return float(np.quantile(self.end, share))


def best_settings(
    fleet: Fleet,
    cars: Cars,
    free: Sequence[Setting],
    *,
    division: float,
    limits: Mapping[Setting, float],
    noise: Noise,
    generator: np.random.Generator,
) -> Settings:
    """Settings with the least expected square error: at the end of the run, and in a lesser part along it.

    A head that is turned stands a little off its new setting again, so it is turned only if that is worth it.

    Args:
        fleet: the nominal car, with stations over the whole run.
        cars: cars that may be this one.
        free: settings that may change; the others stay as in the last run.
        division: division of the micrometer head, mm: it is turned by a whole number of them.
        limits: how far each may be from the design, mm and rad.
        noise: standard deviations of start and head.
        generator: source of the random numbers.
    """
    others = [name for name in free if name != Setting.HEAD]
    left = _solved(fleet, cars, others, cars.last, limits)
    if Setting.HEAD not in free:
        return left
    moved = _solved(fleet, cars, free, cars.last, limits)
    turns = round((moved.head - cars.last.head) / division)
    if not turns:
        return left
    turned = _solved(fleet, cars, others, replace(moved, head=cars.last.head + turns * division), limits)
    error = noise.head * generator.standard_normal(len(cars.head))
    costs = [float(np.sum(_weighted(_errors(fleet, cars.run(one, error))) ** 2)) for one in (left, turned)]
    return left if costs[0] <= costs[1] else turned


def _solved(
    fleet: Fleet, cars: Cars, free: Sequence[Setting], start: Settings, limits: Mapping[Setting, float]
) -> Settings:
    settings = start
    if not free:
        return settings
    scale = np.array([limits[name] for name in free])
    for _ in range(_STEPS):
        value = np.array([settings.of(name) for name in free])
        table = cars.run(settings, cars.head)
        places = run_fleet(fleet, table).position
        base = _weighted(places - fleet.planned.position)
        columns = []
        for name in free:
            if name in STARTS:
                moved = started(places, table, name, _PROBES[name])
            else:
                probe = replace(settings, **{name: settings.of(name) + _PROBES[name]})
                moved = run_fleet(fleet, cars.run(probe, cars.head)).position
            error = _weighted(moved - fleet.planned.position)
            columns.append((error - base) * limits[name] / _PROBES[name])
        share = value / scale
        system = np.concatenate([np.stack(columns, axis=1), _RIDGE * np.sqrt(len(cars.head)) * np.diag(scale)])
        target = np.concatenate([np.stack(columns, axis=1) @ share - base, np.zeros(len(free))])
        solved = lsq_linear(system, target, bounds=(-1.0, 1.0)).x * scale
        settings = replace(settings, **dict(zip(free, solved.tolist(), strict=True)))
    return settings


def forecast(fleet: Fleet, cars: Cars, settings: Settings, noise: Noise, generator: np.random.Generator) -> Forecast:
    """Errors of cars with settings that a hand makes as well as it can.

    Args:
        fleet, cars, noise, generator: as in `best_settings`.
        settings: what is set for the run.
    """
    table = cars.run(settings, noise.head * generator.standard_normal(len(cars.head)))
    for name, sigma in noise.starts.items():
        table[:, name.column] += sigma * generator.standard_normal(len(table))
    errors = np.abs(_errors(fleet, table))
    return Forecast(end=errors[:, -1], way=errors.max(axis=1))


def _errors(fleet: Fleet, table: Array) -> Complex:
    """Position errors of the drive wheel at the stations, shape (m, g), mm."""
    return np.asarray(run_fleet(fleet, table).position - fleet.planned.position)


def _weighted(errors: Complex) -> Array:
    """Real and imaginary parts of all errors in one row, those along the run with their lesser weight."""
    way = errors[:, :-1] * np.sqrt(_WAY / max(errors.shape[1] - 1, 1))
    return np.concatenate([part.ravel() for part in (errors[:, -1:].real, errors[:, -1:].imag, way.real, way.imag)])
