"""Adjustment by hand after trial runs: measured points of a few tracks -> settings of the micrometer, key and start.

A trial run is fitted with everything that the tolerances let vary. At each pair of play and friction of a grid the
car's track is linear in all other deviations to a good part of what the tolerances allow: with another play or friction
the car jumps elsewhere. So the most probable deviations follow from Gauss-Newton steps, and the weight of the pair from
Laplace's approximation of the evidence:

    ln p = -(|r|^2 / sigma^2 + |m|^2) / 2 - ln det(1 + J^T J / sigma^2) / 2

Here r are the residuals, m the deviations in units of their prior standard deviations, and J the derivatives by m.
Source: MacKay, Information Theory, Inference, and Learning Algorithms, 2003, chapters 27 and 28.

The settings are those with the least expected error over the cars that explain the trial runs.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from cadgen.arrays import Array
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    COLUMNS,
    RETURN_ERROR,
    SETTABLE,
    SIDE_SLIP,
    SLIDING_FRICTION,
    START_HEADING,
    START_X,
    START_Y,
    STARTS,
    Deviation,
)
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.cars import Cars, run_cars

Complex = NDArray[np.complex128]

# Steps of Gauss and Newton from the prior, and more of them for the cells that are left after the first: the last
# moves the end of the run by less than a millimetre.
_FIRST_STEPS, _MORE_STEPS = 2, 2
_FAR = 15.0  # a cell whose evidence is less by exp(15) is left
_GRIDDED = (RETURN_ERROR, SLIDING_FRICTION)
_BLOCK = 100  # cars run at once: their tables stay in the processor's cache
_STEPS = 4
# Share of the mean square error along the run beside that at its end. More would trade the finish for the way.
_WAY = 0.25
_REPEATED = 3  # runs with the same settings, at least, whose scatter says something
_SLIP_PROBE = 1e-4  # rad
_RIDGE = 1e-4  # of the limits, in the units of errors: settings that hardly matter stay where they are


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Changes of a car that a hand makes without a new part.

    Attributes:
        head: growth of the base radius at the micrometer head, mm.
        key: angle by which the cam is set ahead on its shaft, rad.
        start_x: start moved ahead along the planned heading, mm.
        start_y: start moved to the left of it, mm.
        start_heading: start turned to the left, rad.
    """

    head: float = 0.0
    key: float = 0.0
    start_x: float = 0.0
    start_y: float = 0.0
    start_heading: float = 0.0

    @property
    def deviations(self) -> dict[Deviation, float]:
        """Settings as deviations of a car."""
        return {each: self.of(each) for each in SETTABLE}

    def of(self, deviation: Deviation) -> float:
        """Change of one deviation that can be set, mm or rad.

        Args:
            deviation: one of `SETTABLE`.
        """
        return float(getattr(self, _setting(deviation)))

    def with_(self, values: Mapping[Deviation, float]) -> "Settings":
        """Settings with other values, mm or rad.

        Args:
            values: values of deviations that can be set.
        """
        return replace(self, **{_setting(each): value for each, value in values.items()})


def _setting(deviation: Deviation) -> str:
    assert deviation.hand is not None
    return deviation.hand.setting


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A trial run.

    Attributes:
        points: measured places of a point of the car, x + iy from the planned start, x along the planned heading
            there, shape (n,), mm, in the order of driving.
        motor: motor position at each point, shape (n,), rad; None where the car was not stopped for the measurement:
            then each point lies somewhere on the track, and the last where the run ends.
        settings: what was set for this run.
    """

    points: Complex
    motor: Array | None = None
    settings: Settings = field(default_factory=Settings)


@dataclass(frozen=True, kw_only=True)
class TrialNoise:
    """Standard deviations of what repeats from run to run only so well.

    Attributes:
        point: a measured coordinate, mm.
        start: place of the start in each direction, mm.
        heading: heading of the start, rad.
        head: setting of the micrometer head, mm; its error stays as it is until the head is turned again.
        side_slip: side slip of a run, as a turn of the front wheel, rad.
    """

    point: float = 10.0
    start: float = 3.0
    heading: float = float(np.radians(0.15))
    head: float = 0.002
    side_slip: float = 0.0

    @property
    def runs(self) -> Mapping[Deviation, float]:
        """Standard deviations of what comes anew in each run, the start last, mm and rad."""
        slip = {SIDE_SLIP: self.side_slip} if self.side_slip > 0 else {}
        return {**slip, START_X: self.start, START_Y: self.start, START_HEADING: self.heading}


@dataclass(frozen=True, kw_only=True)
class RunScatter:
    """How far runs with the same settings end apart.

    Attributes:
        count: number of runs.
        end: standard deviation of the places where they end, mm, that of the measured points taken out.
        side_slip: half width of a side slip that would do it alone, rad: three standard deviations.
    """

    count: int
    end: float
    side_slip: float

    @classmethod
    def of(cls, nominal: Cars, trials: Sequence[Trial], noise: TrialNoise) -> "RunScatter | None":
        """Scatter of the runs with the settings of the last; None for fewer than three.

        Args:
            nominal: the nominal car.
            trials: in the order of driving.
            noise: standard deviations of points and starts.
        """
        ends = np.array([trial.points[-1] for trial in trials if trial.settings == trials[-1].settings])
        if len(ends) < _REPEATED:
            return None
        square = float(np.sum(np.abs(ends - ends.mean()) ** 2)) / (len(ends) - 1)
        end = float(np.sqrt(max(square - 2 * noise.point**2, 0.0)))
        cars = np.zeros((2, len(COLUMNS)))
        cars[1, SIDE_SLIP.column] = _SLIP_PROBE
        places = run_cars(nominal, cars).position[:, -1]
        return cls(count=len(ends), end=end, side_slip=3 * end * _SLIP_PROBE / float(abs(places[1] - places[0])))


def stations_of(track: Complex, points: Complex) -> NDArray[np.intp]:
    """Which station of a track each point belongs to, so that points in order stay in order.

    The sum of squared distances is least among all assignments in order, by dynamic programming; a track that
    crosses itself is no trouble. The last point is that of the last station.

    Args:
        track: places at g stations, shape (g,), mm.
        points: shape (n,), mm.
    """
    square = np.abs(track[None, :] - points[:, None]) ** 2
    total = square[0]
    steps = []
    for row in square[1:]:
        # The best station so far up to each one.
        least = np.minimum.accumulate(total)
        steps.append(np.maximum.accumulate(np.where(total == least, np.arange(len(total)), 0)))
        total = least + row
    at = np.empty(len(points), dtype=np.intp)
    at[-1] = len(track) - 1
    for number in range(len(points) - 2, -1, -1):
        at[number] = steps[number][at[number + 1]]
    return at


@dataclass(frozen=True, kw_only=True)
class CarPrior:
    """Deviations of a car before any trial run.

    Attributes:
        sigma: standard deviation of each deviation that varies, of each component of one with a direction.
        grid: deviations of return error and friction at which the run is looked at, shape (k,) each. About each the
            deviation varies by half a step of the grid; a grid of one is the nominal value, 0.
        noise: standard deviations of points, starts and the head's settings.
    """

    sigma: Mapping[Deviation, float]
    grid: Mapping[Deviation, Array]
    noise: TrialNoise

    @property
    def columns(self) -> list[int]:
        """Columns of the car's deviations, those of the grid last."""
        gridded = [each for each in _GRIDDED if len(self.grid[each]) > 1]
        return [column for each in (*self.sigma, *gridded) for column in each.columns]

    @property
    def cells(self) -> Array:
        """Play and friction of every cell, shape (c, 2)."""
        return np.stack(np.meshgrid(*(self.grid[name] for name in _GRIDDED), indexing="ij"), axis=-1).reshape(-1, 2)

    def scales(self) -> Array:
        """Standard deviations of `columns`."""
        steps = [float(np.diff(self.grid[n]).mean()) / 2 for n in _GRIDDED if len(self.grid[n]) > 1]
        return np.array([*(sigma for each, sigma in self.sigma.items() for _ in each.columns), *steps])


@dataclass(frozen=True, kw_only=True)
class LikelyCars:
    """LikelyCars that explain the trial runs, m of them.

    Attributes:
        table: their deviations, shape (m, c), columns as `deviation.COLUMNS`.
        head: by how much the micrometer head stands off what it was last set to, shape (m,), mm.
        last: settings of the last trial run.
    """

    table: Array
    head: Array
    last: Settings

    def run(self, settings: Settings, turned: Array | float = 0.0) -> Array:
        """Deviations in a run with settings, shape (m, c).

        Args:
            settings: what is set for the run.
            turned: by how much the head stands off its new setting, if it is turned, shape (m,) or one for all, mm.
        """
        table = self.table.copy()
        for name, setting in settings.deviations.items():
            table[:, name.column] += setting
        table[:, BASE_RADIUS.column] += self.head if settings.head == self.last.head else turned
        return table


@dataclass(frozen=True, kw_only=True)
class Posterior:
    """Deviations of the car after the trial runs: cells of a mixture.

    Attributes:
        columns: of the car's deviations, p of them.
        weight: share of each cell, shape (c,), adding up to 1.
        mean: deviations, then the head's error in the last trial run, shape (c, p + 1), internal units.
        root: square root of the covariance: mean + root @ standard normal numbers, shape (c, p + 1, p + 1).
        last: settings of the last trial run.
        residual: root mean square of the residuals of the likeliest cell in standard deviations of a point.
    """

    columns: list[int]
    weight: Array
    mean: Array
    root: Array
    last: Settings
    residual: float

    def draw(self, generator: np.random.Generator, count: int) -> LikelyCars:
        """Random cars."""
        cell = generator.choice(len(self.weight), count, p=self.weight)
        normal = generator.standard_normal((count, self.mean.shape[1]))
        values = self.mean[cell] + np.einsum("npq,nq->np", self.root[cell], normal)
        table = np.zeros((count, len(COLUMNS)))
        table[:, self.columns] = values[:, :-1]
        return LikelyCars(table=table, head=values[:, -1], last=self.last)


def explain(nominal: Cars, lever: complex, prior: CarPrior, trials: Sequence[Trial]) -> Posterior:
    """LikelyCars that explain trial runs.

    Args:
        nominal: the nominal car, with stations close together over the whole run, the last one its end.
        lever: place of the measured point in the car's frame from the drive wheel, x + iy, mm.
        prior: what may deviate, and how much is measured.
        trials: one or more, in the order of driving.

    Raises:
        DesignError: no trial run, or one of fewer than two points.
    """
    if not trials or any(len(trial.points) < 2 for trial in trials):
        raise DesignError("an adjustment needs at least one trial run of two points: measure some along the track")
    columns, cells, noise = prior.columns, prior.cells, prior.noise
    # Each turn of the head leaves an error of its own, which stays for the runs that follow.
    settings = [trial.settings.head for trial in trials]
    turns = np.cumsum([0, *(later != earlier for earlier, later in pairwise(settings))]).tolist()
    starts = list(noise.runs.values())
    # Deviations of the car, errors of the head, and of each start, all in units of their standard deviations.
    unit = np.concatenate([prior.scales(), np.full(turns[-1] + 1, noise.head), *(starts for _ in trials)])
    shared, first = len(columns), len(columns) + turns[-1] + 1
    fits = [
        _CarFit(nominal, lever, prior, trial, [*range(shared), shared + turn, *range(at, at + len(starts))])
        for trial, turn, at in zip(trials, turns, range(first, len(unit), len(starts)), strict=True)
    ]
    value = np.zeros((len(cells), len(unit)))
    for number in range(_FIRST_STEPS + _MORE_STEPS):
        system = _System.of(fits, cells, value, unit)
        step = system.step(value)
        value = value + step
        if number == _FIRST_STEPS - 1:
            evidence = system.evidence_after(step, value)
            near = evidence > evidence.max() - _FAR
            cells, value = cells[near], value[near]
    system = _System.of(fits, cells, value, unit)
    log = system.evidence(value)
    weight = np.exp(log - log.max())
    keep = weight > 1e-4 * weight.sum()
    kept = [*range(shared), shared + turns[-1]]
    covariance = np.linalg.inv(system.information[keep])[:, kept][:, :, kept]
    mean = value[keep][:, kept] * unit[kept]
    varied = [len(prior.grid[name]) > 1 for name in _GRIDDED]
    mean[:, shared - sum(varied) : shared] += cells[keep][:, varied]
    return Posterior(
        columns=columns,
        weight=weight[keep] / weight[keep].sum(),
        mean=mean,
        root=np.linalg.cholesky(covariance) * unit[kept][:, None],
        last=trials[-1].settings,
        residual=float(np.sqrt(np.mean(system.residual[int(np.argmax(log))] ** 2))),
    )


@dataclass(frozen=True)
class _CarFit:
    """Trial run against the nominal car; `columns` are the values of the car, its head and its start."""

    nominal: Cars
    lever: complex
    prior: CarPrior
    trial: Trial
    columns: list[int]

    def cars(self, cells: Array, value: Array, scales: Array) -> Array:
        """Deviations in this run: shape (m, c), for the car's own, then the run's, in units of `scales`."""
        table = np.zeros((len(cells), len(COLUMNS)))
        table[:, [name.column for name in _GRIDDED]] = cells
        own = (BASE_RADIUS, *self.prior.noise.runs)
        for number, column in enumerate((*self.prior.columns, *(each.column for each in own))):
            table[:, column] += value[:, number] * scales[number]
        for name, setting in self.trial.settings.deviations.items():
            table[:, name.column] += setting
        return table

    def residual(self, places: Complex, along: Complex) -> Array:
        """Points less places of the track, shape (m, q), mm: across it, and along it where the place is known.

        The last point is where the run ends.

        Args:
            places, along: of the track at each point, and its direction there, shape (m, n) each.
        """
        off = (self.trial.points - places) * np.conj(along)
        if self.trial.motor is not None:
            return np.concatenate([off.imag, off.real], axis=1)
        return np.concatenate([off.imag, off.real[:, -1:]], axis=1)

    def assigned(self, track: Complex) -> tuple[NDArray[np.intp], Complex]:
        """Station of each point, and the direction of the track there, shape (m, n) each."""
        if self.trial.motor is None:
            at = np.stack([stations_of(row, self.trial.points) for row in track])
        else:
            nearest = np.searchsorted(self.nominal.stations, self.trial.motor)
            at = np.broadcast_to(np.clip(nearest, 0, track.shape[1] - 1), (len(track), len(nearest)))
        ends = np.clip(at - 1, 0, None), np.clip(at + 1, None, track.shape[1] - 1)
        chord = np.take_along_axis(track, ends[1], axis=1) - np.take_along_axis(track, ends[0], axis=1)
        return at, chord / np.abs(chord)


@dataclass(frozen=True)
class _System:
    """Residuals, derivatives and information of all cells, in standard deviations."""

    residual: Array
    derivative: Array
    information: Array

    @classmethod
    def of(cls, fits: Sequence[_CarFit], cells: Array, value: Array, unit: Array) -> "_System":
        count, width = value.shape
        residuals, derivatives = [], []
        for fit in fits:
            columns = fit.columns
            own, scales = value[:, columns], unit[columns]
            table = fit.cars(cells, own, scales)
            track = track_of(fit.nominal, fit.lever, table)
            at, along = fit.assigned(track)
            places = np.take_along_axis(track, at, axis=1)
            # The places of the points alone, with each deviation of car and head greater by a standard deviation.
            number = len(columns) - len(STARTS)
            moved = (own[:, None, :] + np.eye(len(columns))[:number]).reshape(-1, len(columns))
            cars = fit.cars(np.repeat(cells, number, axis=0), moved, scales)
            stations = np.repeat(fit.nominal.stations[at], number, axis=0)
            shifted = track_of(fit.nominal, fit.lever, cars, stations).reshape(count, number, -1)
            begun = [started(places, table, each, scale) for each, scale in zip(STARTS, scales[number:], strict=True)]
            base = fit.residual(places, along)
            off = [fit.residual(shifted[:, k], along) for k in range(number)]
            off += [fit.residual(place, along) for place in begun]
            residuals.append(base / fit.prior.noise.point)
            derivative = np.zeros((count, base.shape[1], width))
            derivative[:, :, columns] = (np.stack(off, axis=2) - base[:, :, None]) / fit.prior.noise.point
            derivatives.append(derivative)
        derivative = np.concatenate(derivatives, axis=1)
        information = np.eye(width) + derivative.transpose(0, 2, 1) @ derivative
        return cls(np.concatenate(residuals, axis=1), derivative, information)

    def evidence(self, value: Array) -> Array:
        """Logarithm of each cell's evidence at the values that the system is about, but for a constant."""
        squares = np.sum(self.residual**2, axis=1) + np.sum(value**2, axis=1)
        return np.asarray(-(squares + np.linalg.slogdet(self.information)[1]) / 2)

    def evidence_after(self, step: Array, value: Array) -> Array:
        """Evidence at values a step further on, as the linear system foresees it."""
        moved = self.residual + np.einsum("cqp,cp->cq", self.derivative, step)
        return replace(self, residual=moved).evidence(value)

    def step(self, value: Array) -> Array:
        """Step of Gauss and Newton from values."""
        gradient = np.einsum("cqp,cq->cp", self.derivative, self.residual) + value
        return np.asarray(-np.linalg.solve(self.information, gradient[..., None])[..., 0])


def track_of(nominal: Cars, lever: complex, table: Array, stations: Array | None = None) -> Complex:
    """Places of a point of the car at the nominal car's stations, or at each car's own, shape (m, g), mm.

    Args:
        nominal: the nominal car.
        lever: place of the point in the car's frame from the drive wheel, x + iy, mm.
        table: deviations, shape (m, c), columns as `deviation.COLUMNS`.
        stations: motor positions of each car, shape (m, g), rad; the nominal car's if left out.
    """
    tracks = []
    for begin in range(0, len(table), _BLOCK):
        block = slice(begin, begin + _BLOCK)
        poses = run_cars(nominal, table[block], None if stations is None else stations[block])
        tracks.append(poses.position + lever * np.exp(1j * poses.heading))
    return np.concatenate(tracks)


def started(places: Complex, table: Array, setting: Deviation, by: float) -> Complex:
    """Places of cars that are started otherwise, without running them again, shape (m, g), mm.

    Args:
        places: of a point of the cars, shape (m, g), mm.
        table: their deviations, shape (m, c), columns as `deviation.COLUMNS`.
        setting: one of `STARTS`.
        by: what is added to it, mm or rad.
    """
    if setting != START_HEADING:
        return places + (by if setting == START_X else 1j * by)
    start = table[:, START_X.columns] + 1j * table[:, START_Y.columns]
    return np.asarray(start + (places - start) * np.exp(1j * by))


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
    nominal: Cars,
    cars: LikelyCars,
    free: Sequence[Deviation],
    *,
    division: float,
    noise: TrialNoise,
    generator: np.random.Generator,
) -> Settings:
    """Settings with the least expected square error: at the end of the run, and in a lesser part along it.

    A head that is turned stands a little off its new setting again, so it is turned only if that is worth it.

    Args:
        nominal: the nominal car, with stations over the whole run.
        cars: cars that may be this one.
        free: deviations that may be set, within their limits from the design; the others stay as in the last run.
        division: division of the micrometer head, mm: it is turned by a whole number of them.
        noise: standard deviations of start and head.
        generator: source of the random numbers.
    """
    others = [name for name in free if name != BASE_RADIUS]
    left = _solved(nominal, cars, others, cars.last)
    if BASE_RADIUS not in free:
        return left
    moved = _solved(nominal, cars, free, cars.last)
    turns = round((moved.head - cars.last.head) / division)
    if not turns:
        return left
    turned = _solved(nominal, cars, others, replace(moved, head=cars.last.head + turns * division))
    error = noise.head * generator.standard_normal(len(cars.head))
    costs = [float(np.sum(_weighted(_errors(nominal, cars.run(one, error))) ** 2)) for one in (left, turned)]
    return left if costs[0] <= costs[1] else turned


def _solved(nominal: Cars, cars: LikelyCars, free: Sequence[Deviation], start: Settings) -> Settings:
    settings = start
    hands = [(name, name.hand.limit, name.hand.probe) for name in free if name.hand]
    if not hands:
        return settings
    scale = np.array([limit for _, limit, _ in hands])
    for _ in range(_STEPS):
        value = np.array([settings.of(name) for name in free])
        table = cars.run(settings, cars.head)
        places = run_cars(nominal, table).position
        base = _weighted(places - nominal.planned.position)
        columns = []
        for name, limit, probe in hands:
            if name in STARTS:
                moved = started(places, table, name, probe)
            else:
                probed = settings.with_({name: settings.of(name) + probe})
                moved = run_cars(nominal, cars.run(probed, cars.head)).position
            error = _weighted(moved - nominal.planned.position)
            columns.append((error - base) * limit / probe)
        share = value / scale
        system = np.concatenate([np.stack(columns, axis=1), _RIDGE * np.sqrt(len(cars.head)) * np.diag(scale)])
        target = np.concatenate([np.stack(columns, axis=1) @ share - base, np.zeros(len(free))])
        solved = lsq_linear(system, target, bounds=(-1.0, 1.0)).x * scale
        settings = settings.with_(dict(zip(free, solved.tolist(), strict=True)))
    return settings


def forecast(
    nominal: Cars, cars: LikelyCars, settings: Settings, noise: TrialNoise, generator: np.random.Generator
) -> Forecast:
    """Errors of cars with settings that a hand makes as well as it can.

    Args:
        nominal, cars, noise, generator: as in `best_settings`.
        settings: what is set for the run.
    """
    table = cars.run(settings, noise.head * generator.standard_normal(len(cars.head)))
    for name, sigma in noise.runs.items():
        table[:, name.column] += sigma * generator.standard_normal(len(table))
    errors = np.abs(_errors(nominal, table))
    return Forecast(end=errors[:, -1], way=errors.max(axis=1))


def _errors(nominal: Cars, table: Array) -> Complex:
    """Position errors of the drive wheel at the stations, shape (m, g), mm."""
    return np.asarray(run_cars(nominal, table).position - nominal.planned.position)


def _weighted(errors: Complex) -> Array:
    """Real and imaginary parts of all errors in one row, those along the run with their lesser weight."""
    way = errors[:, :-1] * np.sqrt(_WAY / max(errors.shape[1] - 1, 1))
    return np.concatenate([part.ravel() for part in (errors[:, -1:].real, errors[:, -1:].imag, way.real, way.imag)])
