"""Random cars within a design's tolerances: ends of their runs, yield within a gate, and sensitivities."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from math import degrees, floor, log10, radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    COLUMNS,
    EDGE_BREAK,
    EDGE_WEAR,
    INNER_FACE,
    OUTER_FACE,
    RETURN_ERROR,
    SIDE_SLIP,
    STEERING_ZERO,
    TOLERANCES,
    VARIED,
    WHEEL_RADIUS,
    WHEEL_RUNOUT,
    WHEELBASE,
    Deviation,
    tolerance,
)
from cadgen.deviations.first_order import ROWS
from cadgen.errors import DesignError
from cadgen.gears.choices import Law
from cadgen.gears.distribution import ZoneSum
from cadgen.inference.monte_carlo.cars import Cars, Poses, run_cars
from cadgen.inference.monte_carlo.course_margins import CourseMargins, margins_at
from cadgen.messages import Message

# Type of the built-in `map` and of a pool's: calls may run anywhere, but results come in order.
Map = Callable[[Callable[[int], Array], Iterable[int]], Iterable[Array]]
_OF_A_MAP = Message("it must give every result once, in order, as the built-in map does")
Sampler = Callable[[np.random.Generator, int], Array]

# Cars run together: their arrays of one value per step stay near the processor's cache, and a run of many uses
# little memory. It fixes the numbers that a seed gives, with any number of processes.
CHUNK = 100
_BLOCK = 3  # chunks that a process is given at once
_SPREAD_SAMPLES = 20_000  # they give a standard deviation to half a percent
# Greatest angle by which a tolerance may turn the front wheel, rad. First order then misses at most 2 % of its effect
# on the end of the run on the paper's cars, and in proportion less of smaller tolerances.
MOST_STEERING = 0.004
MOST_SHARE = 0.1  # greatest tolerance of a length, as a share of that length
# The steps that sensitivities are stated for.
UNITS = {"mm": 0.01, "rad": radians(0.1), "1": 0.01, "Nmm": 1.0, "N": 0.1, "K": 10.0}
_TRIM_STEPS, _TRIM_PROBE = 2, radians(0.01)  # of the search for a trim: what it leaves is below 1e-3 of what it takes
_TURN = np.eye(len(COLUMNS))[STEERING_ZERO.column]
_REPEATING = [column for each in (*TOLERANCES, RETURN_ERROR) if not each.fleeting for column in each.columns]
_FIRST = VARIED[: VARIED.index(RETURN_ERROR)]  # drawn for every car, before its play; others only where they vary


@dataclass(frozen=True, kw_only=True)
class Tolerances:
    """Tolerances within which the cars that are run differ.

    Attributes:
        half_widths: half of the tolerance zone by deviation, one of `TOLERANCES`, or by its key, in its unit. One
            without an entry does not vary. A deviation with a direction has this size, in any direction; a one-sided
            one lies between 0 and this.
        law: distribution: `normal`, clipped at the limits, which are its 3 sigma; or `uniform`.
        play: return errors B of random cars, rad: a function of a generator and a number, such as a train's
            `sample`; or least and greatest, evenly spread. None keeps the nominal play.
        means: means of deviations by their columns, of cars that are not made as designed in the mean.
        trimmed: whether the steering of each car was set after a trial run of its own, so that the end of that was met.
            What is fleeting was another one in the trial run; the base radius differs by how closely it was set.
    """

    half_widths: Mapping[Deviation, float]
    law: Law = Law.NORMAL
    play: Sampler | tuple[float, float] | None = None
    trimmed: bool = False
    means: Mapping[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "half_widths", {tolerance(str(each)): half for each, half in self.half_widths.items()})
        for name, half in self.half_widths.items():
            if not half >= 0:
                raise DesignError("the tolerance of {name} is {half:g}; it must be 0 or more", name=name, half=half)
        if isinstance(self.play, tuple) and not 0 <= self.play[0] <= self.play[1]:
            raise DesignError(
                "the return error's band {play} must run from 0 or more upwards: put them in order", play=self.play
            )

    def draw(self, generator: np.random.Generator, count: int, nominal_play: float) -> Array:
        """Deviations of random cars, shape (count, c), columns as `deviation.COLUMNS`.

        Args:
            generator: source of the random numbers.
            count: number of cars.
            nominal_play: nominal return error, rad.
        """
        half = np.array([self.half_widths.get(name, 0.0) for name in _FIRST])
        drawn = ZoneSum(tuple(map(str, _FIRST)), -half, half, self.law).sample_contributions(generator, count)
        play = self._play(generator, count, nominal_play)
        deviations = np.zeros((count, len(COLUMNS)))
        deviations[:, : len(_FIRST)] = drawn
        deviations[:, RETURN_ERROR.column] = play - nominal_play
        for name in TOLERANCES[len(_FIRST) :]:
            if self.half_widths.get(name, 0.0) > 0:
                size = self.zone(name).sample(generator, count)
                if name.directed:
                    angle = generator.uniform(0.0, TURN, count)
                    deviations[:, name.columns] = size[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
                else:
                    deviations[:, name.column] = size
        for column, mean in self.means.items():
            deviations[:, column] += mean
        return deviations

    def halved(self, name: Deviation, nominal_play: float) -> "Tolerances":
        """Tolerances with half of one, or with a play that differs half as much from the nominal one.

        Args:
            name: what is halved.
            nominal_play: nominal return error, rad.
        """
        if name == RETURN_ERROR:
            return replace(
                self, play=lambda random, count: (self._play(random, count, nominal_play) + nominal_play) / 2
            )
        return replace(self, half_widths={**self.half_widths, name: self.half_widths[name] / 2})

    def _play(self, generator: np.random.Generator, count: int, nominal: float) -> Array:
        """Return errors of random cars, shape (count,), rad."""
        if self.play is None:
            return np.full(count, nominal)
        if callable(self.play):
            return np.asarray(self.play(generator, count), dtype=float)
        return generator.uniform(*self.play, count)

    def zone(self, name: Deviation) -> ZoneSum:
        """Distribution of one tolerance about the nominal value; of its size if the deviation has a direction."""
        half = self.half_widths.get(name, 0.0)
        return ZoneSum((str(name),), np.array([0.0 if name.one_sided else -half]), np.array([half]), self.law)


_WORDS = {"mm": "mm", "rad": Message("degrees"), "1": "", "Nmm": "N mm", "N": "N", "K": "K"}


@dataclass(frozen=True, kw_only=True)
class CarErrors:
    """Errors of m cars at g stations against the planned run.

    Attributes:
        heading: heading error, shape (m, g), rad, positive to the left.
        along: position error of the drive wheel along the planned heading, shape (m, g), mm.
        across: position error to the left of the planned heading, shape (m, g), mm.
    """

    heading: Array
    along: Array
    across: Array


@dataclass(frozen=True, kw_only=True)
class CarEnds:
    """Errors of m random cars at the end, and the widest on the run: little enough that millions fit into memory.

    Attributes:
        heading: heading error at the last station, shape (m,), rad, positive to the left.
        along: position error of the drive wheel there along the planned heading, shape (m,), mm.
        across: position error there to the left of the planned heading, shape (m,), mm.
        widest: greatest size of `across` over all stations, shape (m,), mm.
        margin: least margin to the gates, obstacles and edge of a course, shape (m,), mm; infinite without a course.
    """

    heading: Array
    along: Array
    across: Array
    widest: Array
    margin: Array

    @property
    def distance(self) -> Array:
        """Position error at the end, shape (m,), mm."""
        return np.hypot(self.along, self.across)


@dataclass(frozen=True, kw_only=True)
class Sensitivity:
    """Effect of one parameter on the end of the run.

    Attributes:
        deviation: one of `TOLERANCES`, or the return error.
        step: change that the figures are for, as in `UNITS`; if it has a direction, in the worst direction.
        heading: heading error per step, rad.
        along: position error per step along the planned heading, mm.
        across: position error per step to the left of the planned heading, mm.
        share: share of the variance of the position error at the end, 0 to 1, to first order.
    """

    deviation: Deviation
    step: float
    heading: float
    along: float
    across: float
    share: float

    @property
    def name(self) -> str:
        """Key of the deviation."""
        return self.deviation.key

    @property
    def distance(self) -> float:
        """Position error per step, mm."""
        return float(np.hypot(self.along, self.across))


def errors_of_cars(cars: Cars, deviations: Array) -> CarErrors:
    """Errors of cars with known deviations, all at once.

    Args:
        cars: nominal car.
        deviations: deviations of m cars, shape (m, c), columns and units as `deviation.COLUMNS`.
    """
    return _errors(cars, run_cars(cars, deviations))


def _errors(cars: Cars, poses: Poses) -> CarErrors:
    off = (poses.position - cars.planned.position) * np.exp(-1j * cars.planned.heading)
    return CarErrors(heading=poses.heading - cars.planned.heading, along=off.real, across=off.imag)


def tolerance_run(
    cars: Cars,
    tolerances: Tolerances,
    samples: int,
    *,
    seed: int,
    map_with: Map | None = None,
    done: Callable[[int], None] = lambda cars: None,
) -> CarEnds:
    """Run random cars within the tolerances.

    Every chunk of cars draws from its own child of the seed where it is run. So a seed gives the same cars whatever the
    map, and a longer run begins with the cars of a shorter one, but for its last chunk.

    Args:
        cars: nominal car.
        tolerances: tolerances within which the cars differ.
        samples: number of cars.
        seed: seed of the random numbers.
        map_with: function that runs the blocks of cars, such as the `map` of a pool; the built-in one if left out. The
            numbers do not depend on it.
        done: function that is called with the number of cars that have run.

    Raises:
        DesignError: fewer than one sample, a tolerance too large for first order, or a map that does not give every
            result once.
    """
    if samples < 1:
        raise DesignError("a tolerance run of {samples} samples says nothing: ask for at least 1", samples=samples)
    _refuse_wide(cars, tolerances)
    run = partial(_chunk, cars, tolerances, seed, samples)
    chunks, count = range(-(-samples // CHUNK)), 5 if cars.items else 4
    if map_with is None:
        rows = _gathered(map(run, chunks), count, samples, done)
    else:
        blocks = range(-(-len(chunks) // _BLOCK))
        rows = _gathered(map_with(partial(_block, run, len(chunks)), blocks), count, samples, done)
    margin = rows[4] if cars.items else np.broadcast_to(np.inf, samples)
    return CarEnds(heading=rows[0], along=rows[1], across=rows[2], widest=rows[3], margin=margin)


def _block(run: Callable[[int], Array], chunks: int, number: int) -> Array:
    """The rows of several chunks, so that the nominal car is not sent to another process for each."""
    return np.concatenate([run(chunk) for chunk in range(number * _BLOCK, min((number + 1) * _BLOCK, chunks))], axis=1)


def _chunk(cars: Cars, tolerances: Tolerances, seed: int, samples: int, number: int) -> Array:
    """Rows of `CarEnds` for one chunk of random cars."""
    poses = _cars(cars, tolerances, seed, samples, number)
    errors = _errors(cars, poses)
    ends = (each[:, cars.end] for each in (errors.heading, errors.along, errors.across))
    rows = [*ends, np.abs(errors.across).max(axis=1)]
    if cars.items:
        rows.append(_met(cars, poses).margins.min(axis=0))
    return np.stack(rows)


def _cars(cars: Cars, tolerances: Tolerances, seed: int, samples: int, number: int) -> Poses:
    """Poses of one chunk of random cars."""
    generator = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(number,)))
    count = min(CHUNK, samples - number * CHUNK)
    deviations = tolerances.draw(generator, count, cars.play)
    if tolerances.trimmed:
        trial = tolerances.draw(generator, count, cars.play)
        trial[:, _REPEATING] = deviations[:, _REPEATING]
        trial[:, BASE_RADIUS.column] = 0.0
        deviations[:, STEERING_ZERO.column] += _trims(cars, trial)
    return run_cars(cars, deviations)


def _trims(cars: Cars, deviations: Array) -> Array:
    """Turns of the steering with which cars end nearest to the end of the planned run, shape (m,), rad.

    Args:
        cars: nominal car.
        deviations: deviations of m cars in their trial runs, shape (m, c).
    """
    cars = at_end(cars)

    def off(turn: Array) -> NDArray[np.complex128]:
        turned = deviations + turn[:, None] * _TURN
        return np.asarray((run_cars(cars, turned).position - cars.planned.position)[:, 0])

    ends = run_cars(cars, np.stack([0.0 * _TURN, _TRIM_PROBE * _TURN])).position[:, 0]
    rate = complex(ends[1] - ends[0]) / _TRIM_PROBE  # that of each car is within some percent of the nominal one's
    turn = np.zeros(len(deviations))
    for _ in range(_TRIM_STEPS):
        turn -= (off(turn) / rate).real
    return turn


def at_end(cars: Cars) -> Cars:
    """Nominal car with the end of its run as the one station, and without a course.

    Args:
        cars: nominal car.
    """
    at = [cars.end]
    ends = Poses(cars.planned.heading[:, at], cars.planned.position[:, at])
    return replace(cars, stations=cars.stations[at], planned=ends, end=-1, items=())


def _met(cars: Cars, poses: Poses) -> CourseMargins:
    planned = cars.planned.heading, cars.planned.position
    return margins_at(cars.items, poses.heading, poses.position, planned)


def margins_of_cars(cars: Cars, tolerances: Tolerances, samples: int, *, seed: int) -> CourseMargins:
    """Items, as the random cars of `tolerance_run` meet it.

    Args:
        cars: nominal car with the items of its course.
        tolerances: tolerances within which the cars differ.
        samples: number of cars.
        seed: seed of the random numbers.

    Raises:
        DesignError: a tolerance is too large for first order.
    """
    _refuse_wide(cars, tolerances)
    chunks = [_met(cars, _cars(cars, tolerances, seed, samples, number)) for number in range(-(-samples // CHUNK))]
    places = zip(*(chunk.places for chunk in chunks), strict=True)
    turned = np.concatenate([chunk.turned for chunk in chunks], axis=1)
    return CourseMargins(cars.items, tuple(np.concatenate(several) for several in places), turned)


def most_moving(cars: Cars, tolerances: Tolerances, number: int) -> list[Deviation]:
    """Deviations by how far they move the cars at an item of the course, the furthest first, the play among them.

    Args:
        cars: nominal car with the items of its course.
        tolerances: tolerances within which the cars differ.
        number: number of the item.
    """
    spreads = _spreads(cars, tolerances)
    parts = [(name, column) for name in spreads for column in name.columns]
    deviations = np.zeros((len(parts) + 1, len(COLUMNS)))  # the last car has none
    for row, (name, column) in enumerate(parts):
        deviations[row, column] = spreads[name]
    aside = _met(cars, run_cars(cars, _settled(cars, tolerances, deviations))).distance[number]
    moved = dict.fromkeys(spreads, 0.0)
    for (name, _), off in zip(parts, (aside - aside[-1]).tolist(), strict=False):
        moved[name] += off**2 / len(name.columns)
    return sorted(moved, key=lambda name: -moved[name])


def _settled(cars: Cars, tolerances: Tolerances, deviations: Array) -> Array:
    """Deviations of cars after a trim of what repeats, where they are trimmed, shape (m, c)."""
    if not tolerances.trimmed:
        return deviations
    repeating = np.zeros_like(deviations)
    repeating[:, _REPEATING] = deviations[:, _REPEATING]
    return np.asarray(deviations + _trims(cars, repeating)[:, None] * _TURN)


def _spreads(cars: Cars, tolerances: Tolerances) -> dict[Deviation, float]:
    """Standard deviation of everything that varies, the play last."""
    spreads = {name: tolerances.zone(name).std for name in tolerances.half_widths}
    play = tolerances.draw(np.random.default_rng(0), _SPREAD_SAMPLES, cars.play)[:, RETURN_ERROR.column]
    spreads[RETURN_ERROR] = float(play.std())
    return {name: spread for name, spread in spreads.items() if spread > 0}


def _gathered(parts: Iterable[Array], count: int, samples: int, done: Callable[[int], None]) -> Array:
    gathered, filled = np.empty((count, samples)), 0
    for part in parts:
        rows = np.asarray(part)
        if rows.ndim != 2 or len(rows) != len(gathered) or filled + rows.shape[1] > samples:
            raise DesignError(
                "map gave something else than its function, after {filled} cars; {rule}", filled=filled, rule=_OF_A_MAP
            )
        gathered[:, filled : filled + rows.shape[1]] = rows
        filled += rows.shape[1]
        done(filled)
    if filled < samples:
        raise DesignError(
            "map gave the results of {filled} of {samples} cars; {rule}", filled=filled, samples=samples, rule=_OF_A_MAP
        )
    return gathered


def _refuse_wide(cars: Cars, tolerances: Tolerances) -> None:
    """Refuse tolerances that are no longer small beside the car, or too large for first order."""
    for name, size in (
        (WHEELBASE, cars.car.wheelbase),
        (WHEEL_RADIUS, cars.wheel_radius),
        (WHEEL_RUNOUT, cars.wheel_radius),
    ):
        half = tolerances.half_widths.get(name, 0.0)
        if half > size * MOST_SHARE:
            raise DesignError(
                "the tolerance of {name} is {half:g} mm, more than a tenth of the {size:g} mm itself: make it "
                "{most:g} mm or less",
                name=name,
                half=half,
                size=size,
                most=_below(size * MOST_SHARE),
            )
    for name, half in tolerances.half_widths.items():
        steepest = steering_effect(cars, name)
        if half * steepest > MOST_STEERING:
            unit = name.unit
            shown = degrees if unit == "rad" else float
            raise DesignError(
                "{key} is {half:g} {unit}, which turns the front wheel by up to {turned:.2g} degrees; many cars are "
                "reckoned to first order, good up to {good:.2g} degrees: make it {least:g} {unit} or less",
                key=f"tolerances.{name.tolerance_key}" if name.zone else name,
                half=shown(half),
                unit=_WORDS[unit],
                turned=degrees(half * steepest),
                good=degrees(MOST_STEERING),
                least=_below(shown(MOST_STEERING / steepest)),
            )


def steering_effect(cars: Cars, name: Deviation) -> float:
    """Greatest angle by which one unit of a deviation turns the front wheel, rad."""
    row = dict(zip(ROWS, cars.derivatives, strict=True))
    if name in (EDGE_BREAK, EDGE_WEAR):
        return float(np.abs(row[INNER_FACE.column] - row[OUTER_FACE.column]).max())
    if name == SIDE_SLIP:
        return float(np.abs(row[STEERING_ZERO.column]).max())
    parts = [row[column] for column in name.columns if column in row]
    return float(np.sqrt(sum(part**2 for part in parts)).max()) if parts else 0.0


def _below(value: float) -> float:
    """The next lower number of two digits."""
    unit = 10.0 ** (floor(log10(value)) - 1)
    return floor(value / unit) * unit


def sensitivities(cars: Cars, tolerances: Tolerances) -> tuple[Sensitivity, ...]:
    """Effect of each varying parameter on the end of the run, by differences, greatest share first."""
    spreads = _spreads(cars, tolerances)
    names = list(spreads)
    if not names:
        return ()
    parts = [(name, column) for name in names for column in name.columns]
    steps = np.array([UNITS[name.unit] for name, _ in parts])
    deviations = np.zeros((2 * len(parts), len(COLUMNS)))
    for row, (name, column) in enumerate(parts):
        ends = [0.0, 1.0] if name.one_sided else [-0.5, 0.5]
        deviations[2 * row : 2 * row + 2, column] = np.array(ends) * steps[row]
    errors = errors_of_cars(cars, _settled(cars, tolerances, deviations))
    moved = np.stack(
        [np.diff(e[:, cars.end].reshape(-1, 2))[:, 0] for e in (errors.heading, errors.along, errors.across)], axis=1
    )
    effects = []
    for name in names:
        rows = [row for row, (owner, _) in enumerate(parts) if owner == name]
        step = float(steps[rows[0]])
        # In the worst direction the end moves furthest, and in any direction as far as their mean square.
        worst = np.linalg.svd(moved[rows, 1:].T)[2][0] if len(rows) > 1 else np.ones(1)
        heading, along, across = worst @ moved[rows]
        variance = float((moved[rows, 1:] ** 2).sum() / len(rows) * (spreads[name] / step) ** 2)
        effects.append((variance, name, step, float(heading), float(along), float(across)))
    whole = float(np.sum([effect[0] for effect in effects])) or 1.0  # nothing moves the end: no share of it
    return tuple(
        Sensitivity(deviation=name, step=step, heading=heading, along=along, across=across, share=variance / whole)
        for variance, name, step, heading, along, across in sorted(effects, key=lambda effect: -effect[0])
    )
