"""What the tolerances of a design do to its runs: Monte Carlo, yield within a gate, and what matters most."""

from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from math import radians
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import DesignError
from cadgen.gears.distribution import ZoneSum
from cadgen.optimize.fleet import PARAMETERS, Fleet, Poses, cam_reach, run_fleet

Array = NDArray[np.float64]
Sampler = Callable[[np.random.Generator, int], Array]
Law = Literal["normal", "uniform"]

# Cars run together: their arrays of one value per step stay near the processor's cache, and a run of many uses
# little memory. It fixes the numbers that a seed gives, with any number of processes.
CHUNK = 100
_SPREAD_SAMPLES = 20_000  # they give a standard deviation to half a percent
UNITS = {"mm": 0.01, "rad": radians(0.1)}  # the steps that sensitivities are stated for


@dataclass(frozen=True, kw_only=True)
class Tolerances:
    """How the cars of a fleet may differ.

    Attributes:
        half_widths: parameter's name, as in `PARAMETERS`, -> half its tolerance zone, mm or rad. What is not named
            does not vary.
        law: `normal`, clipped at the limits, which are its 3 sigma; or `uniform`.
        play: return errors B of random cars, rad: a function of a generator and a number, such as a train's
            `sample`; or least and greatest, evenly spread. None keeps the nominal one.
    """

    half_widths: Mapping[str, float]
    law: Law = "normal"
    play: Sampler | tuple[float, float] | None = None

    def __post_init__(self) -> None:
        for name, half in self.half_widths.items():
            if name not in PARAMETERS or name == "play":
                known = ", ".join(key for key in PARAMETERS if key != "play")
                raise DesignError(f"there is no tolerance named {name}; use one of {known}")
            if not half >= 0:
                raise DesignError(f"the tolerance of {name} is {half:g}; it must be 0 or more")
        if isinstance(self.play, tuple) and not 0 <= self.play[0] <= self.play[1]:
            raise DesignError(f"the return error's band {self.play} must run from 0 or more upwards: put them in order")

    def draw(self, generator: np.random.Generator, count: int, nominal_play: float) -> Array:
        """Deviations of random cars, shape (count, 14), columns as in `PARAMETERS`."""
        names = tuple(PARAMETERS)[:-1]
        half = np.array([self.half_widths.get(name, 0.0) for name in names])
        own = ZoneSum(names, -half, half, self.law).sample_contributions(generator, count)
        if self.play is None:
            play = np.full(count, nominal_play)
        elif callable(self.play):
            play = np.asarray(self.play(generator, count), dtype=float)
        else:
            play = generator.uniform(*self.play, count)
        return np.column_stack([own, play - nominal_play])


@dataclass(frozen=True, kw_only=True)
class FleetErrors:
    """Errors of m cars at g stations against the planned run.

    Attributes:
        deviations: of each car, shape (m, 14), columns as in `PARAMETERS`.
        heading: error, shape (m, g), rad, positive to the left.
        along: position error of the drive wheel along the planned heading, shape (m, g), mm.
        across: the same to the left of it, shape (m, g), mm.
    """

    deviations: Array
    heading: Array
    along: Array
    across: Array

    @property
    def end_distance(self) -> Array:
        """Position error at the last station, shape (m,), mm."""
        return np.hypot(self.along[:, -1], self.across[:, -1])

    def quantiles(self, shares: Array) -> Array:
        """Position errors at the end that given shares of the cars stay within, mm."""
        return np.quantile(self.end_distance, shares)

    def yield_within(self, gate_width: float) -> float:
        """Share of the cars that pass every station within half the gate's width to either side."""
        return float(np.mean(np.all(np.abs(self.across) <= gate_width / 2, axis=1)))


@dataclass(frozen=True, kw_only=True)
class Sensitivity:
    """What one parameter does to the end of the run.

    Attributes:
        name: as in `PARAMETERS`.
        step: change that the figures are for: 0.01 mm, or 0.1 degree in rad.
        heading: error per step, rad.
        along: position error per step along the planned heading, mm.
        across: the same to the left of it, mm.
        share: of the variance of the position error at the end, 0 to 1, to first order.
    """

    name: str
    step: float
    heading: float
    along: float
    across: float
    share: float

    @property
    def distance(self) -> float:
        """Position error per step, mm."""
        return float(np.hypot(self.along, self.across))


def fleet_errors(
    fleet: Fleet, deviations: Array, *, processes: int = 1, done: Callable[[int], None] = lambda cars: None
) -> FleetErrors:
    """Errors of cars with given deviations.

    Args:
        fleet: the nominal car.
        deviations: shape (m, 14), columns as in `PARAMETERS`.
        processes: how many run at once; the numbers do not depend on it.
        done: told how many cars have run.
    """
    run = partial(run_fleet, fleet, reach=cam_reach(fleet, deviations))
    chunks = [deviations[start : start + CHUNK] for start in range(0, len(deviations), CHUNK)]
    if processes > 1:
        with ProcessPoolExecutor(processes) as pool:
            parts = _gathered(pool.map(run, chunks, chunksize=max(1, len(chunks) // (16 * processes))), done)
    else:
        parts = _gathered(map(run, chunks), done)
    heading = np.concatenate([part.heading for part in parts])
    position = np.concatenate([part.position for part in parts])
    off = (position - fleet.planned.position) * np.exp(-1j * fleet.planned.heading)
    return FleetErrors(deviations=deviations, heading=heading - fleet.planned.heading, along=off.real, across=off.imag)


def _gathered(parts: Iterable[Poses], done: Callable[[int], None]) -> list[Poses]:
    found: list[Poses] = []
    for part in parts:
        found.append(part)
        done(CHUNK * len(found))
    return found


def tolerance_run(
    fleet: Fleet,
    tolerances: Tolerances,
    samples: int,
    *,
    seed: int,
    processes: int = 1,
    done: Callable[[int], None] = lambda cars: None,
) -> FleetErrors:
    """Run random cars within the tolerances.

    Every chunk of cars draws from its own child of the seed, so a seed gives the same cars whatever the number of
    processes, and a longer run begins with the cars of a shorter one, but for its last chunk.

    Args:
        fleet: the nominal car.
        tolerances: how the cars may differ.
        samples: number of cars.
        seed: of the random numbers.
        processes: how many run at once.
        done: told how many cars have run.

    Raises:
        DesignError: fewer than one sample.
    """
    if samples < 1:
        raise DesignError(f"a tolerance run of {samples} samples says nothing: ask for at least 1")
    sizes = np.diff(np.append(np.arange(0, samples, CHUNK), samples))
    children = np.random.SeedSequence(seed).spawn(len(sizes))
    drawn = [
        tolerances.draw(np.random.default_rng(child), int(size), fleet.play)
        for child, size in zip(children, sizes, strict=True)
    ]
    return fleet_errors(fleet, np.concatenate(drawn), processes=processes, done=done)


def sensitivities(fleet: Fleet, tolerances: Tolerances) -> tuple[Sensitivity, ...]:
    """What each varying parameter does to the end of the run, by central differences, greatest share first."""
    spreads = _spreads(fleet, tolerances)
    names = [name for name, spread in spreads.items() if spread > 0]
    if not names:
        return ()
    steps = np.array([UNITS[PARAMETERS[name]] for name in names])
    deviations = np.zeros((2 * len(names), len(PARAMETERS)))
    for row, name in enumerate(names):
        deviations[2 * row : 2 * row + 2, list(PARAMETERS).index(name)] = np.array([-0.5, 0.5]) * steps[row]
    errors = fleet_errors(fleet, deviations)
    heading, along, across = (
        np.diff(e[:, -1].reshape(-1, 2))[:, 0] for e in (errors.heading, errors.along, errors.across)
    )
    variance = (along**2 + across**2) * (np.array([spreads[name] for name in names]) / steps) ** 2
    found = [
        Sensitivity(name=name, step=float(step), heading=float(h), along=float(x), across=float(y), share=float(share))
        for name, step, h, x, y, share in zip(
            names, steps, heading, along, across, variance / variance.sum(), strict=True
        )
    ]
    return tuple(sorted(found, key=lambda one: -one.share))


def _spreads(fleet: Fleet, tolerances: Tolerances) -> dict[str, float]:
    """Standard deviation of each parameter; a sampler's from its own random numbers."""
    spreads = {
        name: ZoneSum((name,), np.array([-half]), np.array([half]), tolerances.law).std
        for name, half in tolerances.half_widths.items()
    }
    play = tolerances.draw(np.random.default_rng(0), _SPREAD_SAMPLES, fleet.play)[:, -1]
    return {**spreads, "play": float(play.std())}
