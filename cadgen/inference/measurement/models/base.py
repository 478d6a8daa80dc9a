"""Interface of every forward model to the search."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.effect import Active, Effect, Rows, Stage
from cadgen.inference.measurement.models.rolled import Rolled

SMALL = 0.1  # of the step of a parameter


@dataclass(frozen=True)
class Discrepancy:
    """Systematic errors of a kind of record that no effect describes: columns with amplitudes of a known spread.

    Attributes:
        words: as in "fitted and never claimed: the slope of the floor".
        columns: response to one unit of each amplitude, shape (n, k).
        sigma: standard deviation of each amplitude beforehand, internal units, shape (k,).
        numbers: name and unit of each amplitude that is reported; empty where none is.
    """

    words: str = ""
    columns: Array = field(default_factory=lambda: np.empty((0, 0)))
    sigma: Array = field(default_factory=lambda: np.empty(0))
    numbers: tuple[tuple[str, str], ...] = ()

    @classmethod
    def none(cls, rows: int) -> "Discrepancy":
        """Nothing beside effects and form error, of so many rows."""
        return cls(columns=np.empty((rows, 0)))


# Of an effect, the place of one of its numbers and what is active: the answer, shape (n,), or None if it is not known.
Tangent = Callable[[Effect, int, Active], Array | None]


class Model(Protocol):
    """A forward model with its data."""

    @property
    def behind(self) -> tuple[Stage[Any], ...]:
        """Stages at which effects that other kinds of data show change this one too."""

    @property
    def rolled(self) -> Rolled | None:
        """The lift that effects on disc and rod change; None where they act otherwise, or not at all."""

    @property
    def tangent(self) -> "Tangent | None":
        """How what is expected answers some numbers, to first order; None where differences do for all."""

    @property
    def resolved(self) -> int | None:
        """The highest order that the spacing of the rows resolves; None where no catalogue goes by it."""

    @property
    def unit(self) -> str:
        """Key of `UNITS` of residuals as they are reported."""

    @property
    def rows(self) -> Rows:
        """Where each number belongs."""

    @property
    def catalogue(self) -> tuple[Effect, ...]:
        """The effects that can show, numerous ones included."""

    @property
    def shapes(self) -> tuple[Effect, ...]:
        """The anonymous forms that compete with the catalogue and act on the reading alone."""

    @property
    def datum(self) -> tuple[Effect, ...]:
        """Effects that are always fitted and never claimed."""

    @property
    def offsets(self) -> Array:
        """Linear datum freedoms as columns, shape (n, d)."""

    @property
    def spread(self) -> Array:
        """Standard deviation of each of these beforehand, shape (d,); infinite where nothing is known of it."""

    @property
    def discrepancy(self) -> Discrepancy:
        """Repeating errors beside effects and form error."""

    @property
    def form(self) -> Array:
        """Response to each harmonic of the form error, for one unit of amplitude, shape (n, q)."""

    @property
    def order(self) -> Array:
        """Order of each column of `form`, shape (q,)."""

    @property
    def floor(self) -> float:
        """Stated form error, rms, in the unit of amplitude of `form`."""

    @property
    def slip(self) -> Array:
        """Response to an error of the abscissa that a whole run shares, shape (n,); empty if none can be."""

    @property
    def measured(self) -> Array | None:
        """Coordinate of each row of a track, mm; None for what is no track."""

    def residual(self, active: Active) -> Array:
        """Measured less expected with some effects active, shape (n,), internal units."""


def repeating(model: Model) -> Array:
    """Columns of form error and discrepancy, shape (n, q + k): what repeats between runs without a name."""
    return np.hstack([model.form, model.discrepancy.columns])


def unknown(columns: Array) -> Array:
    """Infinite standard deviations for freedoms of which nothing is known, one for each column.

    Args:
        columns: columns of the freedoms, shape (n, d), internal units (mm, rad).
    """
    return np.full(columns.shape[1], np.inf)


def fourier(angle: Array, last: int) -> tuple[Array, Array]:
    """Cosines and sines of orders 1 to `last`, shape (n, 2 last), and the order of each column.

    Args:
        angle: angles, rad, shape (n,).
        last: highest order.
    """
    orders = np.arange(1, last + 1)
    waves = angle[:, None] * orders
    return np.hstack([np.cos(waves), np.sin(waves)]), np.tile(orders, 2).astype(float)


def highest_order(angle: Array, run: NDArray[np.intp]) -> int:
    """The highest order that the spacing of the points resolves (Nyquist), with a fifth in hand.

    Args:
        angle: angles of the readings, rad, shape (n,).
        run: number of the run of each, shape (n,).
    """
    widest = 0.0
    for number in range(int(run.max()) + 1):
        mine = np.unique(np.round(angle[run == number] % (2 * np.pi), 9))
        widest = max(widest, float(np.median(np.diff(mine)))) if len(mine) > 1 else np.pi
    return max(1, int(0.8 * np.pi / widest))


def per_run(run: NDArray[np.intp]) -> Array:
    """One column for each run: its own zero, shape (n, runs)."""
    return np.asarray((run[:, None] == np.arange(run.max() + 1)).astype(float))


def elapsed(run: NDArray[np.intp]) -> Array:
    """Place of each row within its run, -1/2 to 1/2."""
    out = np.empty(len(run))
    for number in range(int(run.max()) + 1):
        mine = np.flatnonzero(run == number)
        out[mine] = np.linspace(-0.5, 0.5, len(mine)) if len(mine) > 1 else 0.0
    return out


def slopes(model: Model, effects: tuple[Effect, ...], active: Active, known: Array | None = None) -> Array:
    """How the expected value answers each parameter of some effects, shape (n, sum of parameters).

    Central differences over each parameter's own step; one-sided where a bound is in the way. An effect that is
    active is varied about its value, any other about its start. In place of an effect on disc or rod its change of the
    lift to first order is varied, so that the rod is rolled once and not for every difference; what follows the lift
    is smooth, so that a small step to one side will do. So does a step for the numerous ones that are not active: they
    are small, and looked at to first order alone. `known` is the residual with what is active, where it is at hand.

    Args:
        model: model of the record.
        effects: effects.
        active: effects that are active, with their values.
        known: residual with these, shape (n,), mm or rad; computed if left out.
    """
    values = {effect.key: v for effect, v in active}

    @cache
    def base() -> Array:
        return model.residual(active) if known is None else known

    columns = []
    for effect in effects:
        rolled = model.rolled if model.rolled and effect.stage in model.rolled.stages else None
        others = [(e, v) for e, v in active if e.key != effect.key]
        middle = np.asarray(values.get(effect.key, effect.start), dtype=float)
        for k, step in enumerate(effect.steps):
            if rolled:
                standing = rolled.first_order(effect, k, active, model.rows), np.array([SMALL * step])
                columns.append((base() - model.residual([*active, standing])) / (SMALL * step))
                continue
            if model.tangent and (column := model.tangent(effect, k, active)) is not None:
                columns.append(column)
                continue
            one_sided = effect.numerous and effect.key not in values
            low, high = (middle if one_sided else moved(effect, middle, k, -step)), moved(effect, middle, k, step)
            before = base() if one_sided else model.residual([*others, (effect, low)])
            columns.append((before - model.residual([*others, (effect, high)])) / (high[k] - low[k]))
    return np.stack(columns, axis=1) if columns else np.empty((len(model.rows.run), 0))


def moved(effect: Effect, values: Array, number: int, by: float) -> Array:
    """Values of an effect of which one is moved by `by`, in its unit (rad, mm), as far as its bounds let it.

    Args:
        effect: effect.
        values: values of its parameters, internal units (mm, rad).
        number: number of the parameter that is moved.
        by: change, mm or rad.
    """
    there, (lower, upper) = values.copy(), effect.bounds
    there[number] = np.clip(there[number] + by, lower[number], upper[number])
    return there
