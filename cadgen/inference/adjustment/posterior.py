"""Cars that explain trial runs: a mixture of Gaussians over the deviations of a fleet.

At each pair of play and friction of a grid the car's track is linear in all other deviations to a good part of what
the tolerances allow, so the most probable deviations follow from Gauss-Newton steps, and the weight of the pair from
Laplace's approximation of the evidence,
    ln p = -(|r|^2 / sigma^2 + |m|^2) / 2 - ln det(1 + J^T J / sigma^2) / 2,
with r the residuals, m the deviations in units of their prior standard deviations and J the derivatives by m
(MacKay, Information Theory, Inference, and Learning Algorithms, 2003, chapters 27 and 28).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.inference.adjustment.trial import STARTS, Complex, Noise, Setting, Settings, Trial, stations_of
from cadgen.inference.monte_carlo.fleet import Fleet, run_fleet
from cadgen.inference.monte_carlo.parameters import Parameter

# Steps of Gauss and Newton from the prior, and more of them for the cells that are left after the first: the last
# moves the end of the run by less than a millimetre.
_FIRST_STEPS, _MORE_STEPS = 2, 2
_FAR = 15.0  # a cell whose evidence is less by exp(15) is left
_GRIDDED = (Parameter.PLAY, Parameter.FRICTION)
_BLOCK = 100  # cars run at once: their tables stay in the processor's cache


@dataclass(frozen=True, kw_only=True)
class Prior:
    """Deviations of a car before any trial run.

    Attributes:
        sigma: standard deviation of each deviation that varies, by the names of `PARAMETERS`.
        grid: deviations of play and friction at which the run is looked at: `play`, `friction` -> shape (k,). About
            each the deviation varies by half a step of the grid; a grid of one is the nominal value, 0.
        noise: standard deviations of points, starts and the head's settings.
    """

    sigma: Mapping[Parameter, float]
    grid: Mapping[Parameter, Array]
    noise: Noise

    @property
    def names(self) -> tuple[Parameter, ...]:
        """The deviations of the car, those of the grid last."""
        return (*self.sigma, *(name for name in _GRIDDED if len(self.grid[name]) > 1))

    @property
    def cells(self) -> Array:
        """Play and friction of every cell, shape (c, 2)."""
        return np.stack(np.meshgrid(*(self.grid[name] for name in _GRIDDED), indexing="ij"), axis=-1).reshape(-1, 2)

    def scales(self) -> Array:
        """Standard deviations by `names`."""
        steps = [float(np.diff(self.grid[n]).mean()) / 2 for n in _GRIDDED if len(self.grid[n]) > 1]
        return np.array([*self.sigma.values(), *steps])


@dataclass(frozen=True, kw_only=True)
class Cars:
    """Cars that explain the trial runs, m of them.

    Attributes:
        table: their deviations, shape (m, 29), columns as in `PARAMETERS`.
        head: by how much the micrometer head stands off what it was last set to, shape (m,), mm.
        last: settings of the last trial run.
    """

    table: Array
    head: Array
    last: Settings

    def run(self, settings: Settings, turned: Array | float = 0.0) -> Array:
        """Deviations in a run with settings, shape (m, 29).

        Args:
            settings: what is set for the run.
            turned: by how much the head stands off its new setting, if it is turned, shape (m,) or one for all, mm.
        """
        table = self.table.copy()
        for name, setting in settings.deviations.items():
            table[:, name.column] += setting
        table[:, Parameter.BASE_RADIUS.column] += self.head if settings.head == self.last.head else turned
        return table


@dataclass(frozen=True, kw_only=True)
class Posterior:
    """Deviations of the car after the trial runs: cells of a mixture.

    Attributes:
        names: of the car's deviations, p of them.
        weight: share of each cell, shape (c,), adding up to 1.
        mean: deviations, then the head's error in the last trial run, shape (c, p + 1), internal units.
        root: square root of the covariance: mean + root @ standard normal numbers, shape (c, p + 1, p + 1).
        last: settings of the last trial run.
        residual: root mean square of the residuals of the likeliest cell in standard deviations of a point.
    """

    names: tuple[Parameter, ...]
    weight: Array
    mean: Array
    root: Array
    last: Settings
    residual: float

    def draw(self, generator: np.random.Generator, count: int) -> Cars:
        """Random cars."""
        cell = generator.choice(len(self.weight), count, p=self.weight)
        normal = generator.standard_normal((count, self.mean.shape[1]))
        values = self.mean[cell] + np.einsum("npq,nq->np", self.root[cell], normal)
        table = np.zeros((count, len(Parameter)))
        table[:, [name.column for name in self.names]] = values[:, :-1]
        return Cars(table=table, head=values[:, -1], last=self.last)


def explain(fleet: Fleet, lever: complex, prior: Prior, trials: Sequence[Trial]) -> Posterior:
    """Cars that explain trial runs.

    Args:
        fleet: the nominal car, with stations close together over the whole run, the last one its end.
        lever: place of the measured point in the car's frame from the drive wheel, x + iy, mm.
        prior: what may deviate, and how much is measured.
        trials: one or more, in the order of driving.

    Raises:
        DesignError: no trial run, or one of fewer than two points.
    """
    if not trials or any(len(trial.points) < 2 for trial in trials):
        raise DesignError("an adjustment needs at least one trial run of two points: measure some along the track")
    names, cells, noise = prior.names, prior.cells, prior.noise
    # Each turn of the head leaves an error of its own, which stays for the runs that follow.
    settings = [trial.settings.head for trial in trials]
    turns = np.cumsum([0, *(later != earlier for earlier, later in pairwise(settings))]).tolist()
    starts = list(noise.starts.values())
    # Deviations of the car, errors of the head, and of each start, all in units of their standard deviations.
    unit = np.concatenate([prior.scales(), np.full(turns[-1] + 1, noise.head), *(starts for _ in trials)])
    shared, first = len(names), len(names) + turns[-1] + 1
    fits = [
        _Fit(fleet, lever, prior, trial, [*range(shared), shared + turn, *range(at, at + len(starts))])
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
    mean[:, len(prior.sigma) : shared] += cells[keep][:, varied]
    return Posterior(
        names=names,
        weight=weight[keep] / weight[keep].sum(),
        mean=mean,
        root=np.linalg.cholesky(covariance) * unit[kept][:, None],
        last=trials[-1].settings,
        residual=float(np.sqrt(np.mean(system.residual[int(np.argmax(log))] ** 2))),
    )


@dataclass(frozen=True)
class _Fit:
    """One trial run against the fleet; `columns` says which of all values are the car's, its head's and its start's."""

    fleet: Fleet
    lever: complex
    prior: Prior
    trial: Trial
    columns: list[int]

    def cars(self, cells: Array, value: Array, scales: Array) -> Array:
        """Deviations in this run: shape (c, 29), for the car's own, then the run's, in units of `scales`."""
        table = np.zeros((len(cells), len(Parameter)))
        table[:, [name.column for name in _GRIDDED]] = cells
        for column, name in enumerate((*self.prior.names, Parameter.BASE_RADIUS, *self.prior.noise.starts)):
            table[:, name.column] += value[:, column] * scales[column]
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
            nearest = np.searchsorted(self.fleet.stations, self.trial.motor)
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
    def of(cls, fits: Sequence[_Fit], cells: Array, value: Array, unit: Array) -> "_System":
        count, width = value.shape
        residuals, derivatives = [], []
        for fit in fits:
            columns, starts = fit.columns, list(fit.prior.noise.starts)
            own, scales = value[:, columns], unit[columns]
            table = fit.cars(cells, own, scales)
            track = track_of(fit.fleet, fit.lever, table)
            at, along = fit.assigned(track)
            places = np.take_along_axis(track, at, axis=1)
            # The places of the points alone, with each deviation of car and head greater by a standard deviation.
            number = len(columns) - len(starts)
            moved = (own[:, None, :] + np.eye(len(columns))[:number]).reshape(-1, len(columns))
            cars = fit.cars(np.repeat(cells, number, axis=0), moved, scales)
            stations = np.repeat(fit.fleet.stations[at], number, axis=0)
            shifted = track_of(fit.fleet, fit.lever, cars, stations).reshape(count, number, -1)
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
        """The same at values a step further on, as the linear system foresees it."""
        moved = self.residual + np.einsum("cqp,cp->cq", self.derivative, step)
        return replace(self, residual=moved).evidence(value)

    def step(self, value: Array) -> Array:
        """Step of Gauss and Newton from values."""
        gradient = np.einsum("cqp,cq->cp", self.derivative, self.residual) + value
        return np.asarray(-np.linalg.solve(self.information, gradient[..., None])[..., 0])


def track_of(fleet: Fleet, lever: complex, table: Array, stations: Array | None = None) -> Complex:
    """Places of a point of the car at the fleet's stations, or at each car's own, shape (m, g), mm.

    Args:
        fleet: the nominal car.
        lever: place of the point in the car's frame from the drive wheel, x + iy, mm.
        table: deviations, shape (m, 29), columns as in `PARAMETERS`.
        stations: motor positions of each car, shape (m, g), rad; the fleet's if left out.
    """
    tracks = []
    for begin in range(0, len(table), _BLOCK):
        block = slice(begin, begin + _BLOCK)
        poses = run_fleet(fleet, table[block], None if stations is None else stations[block])
        tracks.append(poses.position + lever * np.exp(1j * poses.heading))
    return np.concatenate(tracks)


def started(places: Complex, table: Array, setting: Setting, by: float) -> Complex:
    """Places of cars that are started otherwise, without running them again, shape (m, g), mm.

    Args:
        places: of a point of the cars, shape (m, g), mm.
        table: their deviations, shape (m, 29), columns as in `PARAMETERS`.
        setting: one of `STARTS`.
        by: what is added to it, mm or rad.
    """
    if setting != Setting.START_HEADING:
        return places + (by if setting == Setting.START_X else 1j * by)
    start = (table[:, Parameter.START_X.column] + 1j * table[:, Parameter.START_Y.column])[:, None]
    return np.asarray(start + (places - start) * np.exp(1j * by))
