"""Forms without a name that compete with the catalogue, so that an unknown effect is not forced into a known name.

All act at the stage `READING` on what the instrument shows, and know a row only by its place, time and run.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.deviations.effect import READING, UNITS, Effect, Parameter, Rows, Stage
from cadgen.messages import Message

BUMP_WIDTHS_DEG = (2.0, 4.0, 8.0, 16.0)
BUMP_PITCH = 0.75  # centres per half-width: a bump between two centres loses under 4 % of its square
SECTORS_DEG = np.arange(30.0, 121.0, 10.0)
SECTOR_PITCH_DEG = 10.0  # between edges: a fit finds its way to an edge five degrees off, not to one ten degrees off
EDGE = np.radians(2.0)
STEPS_PER_RUN = 24


def _size(name: str, unit: str) -> Parameter:
    limit = {"um": 2000.0, "mm": 1000.0, "deg": 20.0}[unit]
    return Parameter(name=f"{name}_{unit}", unit=unit, lower=-limit, upper=limit, step=limit / 1000)


def harmonic(order: float, unit: str) -> Effect:
    """Harmonic of an order n: p0 cos(n theta) + p1 sin(n theta).

    Args:
        order: order n, a number.
        unit: unit of the size on screen, such as `um`.
    """

    def act(reading: Array, p: Array, at: Rows) -> Array:
        return np.asarray(reading + p[0] * np.cos(order * at.place) + p[1] * np.sin(order * at.place))

    return _shape(Message("harmonic of order {order:g}", order=order), (_size("cos", unit), _size("sin", unit)), act)


def bump(centre_deg: float, width_deg: float, unit: str) -> Effect:
    """A local bump or dent: height, centre and half-width, the latter two searched from where it was offered.

    Args:
        centre_deg: middle from which the search begins, degrees.
        width_deg: half-width from which it begins, degrees.
        unit: unit of the size on screen, such as `um`.
    """

    def act(reading: Array, p: Array, at: Rows) -> Array:
        off = (at.place - p[1] + np.pi) % TURN - np.pi
        return np.asarray(reading + p[0] * np.exp(-((off / p[2]) ** 2) / 2))

    parameters = (
        _size("height", unit),
        Parameter(
            name="centre_deg", unit="deg", lower=centre_deg - 10, upper=centre_deg + 10, step=0.1, start=centre_deg
        ),
        Parameter(name="width_deg", unit="deg", lower=1.0, upper=40.0, step=0.1, start=width_deg),
    )
    return _shape(
        Message("local bump near {centre_deg:.0f} deg", centre_deg=centre_deg),
        parameters,
        act,
        variant=f"of {width_deg:g}",
    )


def sector(centre_deg: float, half_deg: float, unit: str) -> Effect:
    """A part of the turn that stands higher than the rest: height, centre and half-width; edges of two degrees.

    Args:
        centre_deg: middle from which the search begins, degrees.
        half_deg: half-width from which it begins, degrees.
        unit: unit of the size on screen, such as `um`.
    """

    def act(reading: Array, p: Array, at: Rows) -> Array:
        off = np.abs((at.place - p[1] + np.pi) % TURN - np.pi)
        return np.asarray(reading + p[0] * (1 - np.tanh((off - p[2]) / EDGE)) / 2)

    parameters = (
        _size("height", unit),
        Parameter(
            name="centre_deg", unit="deg", lower=centre_deg - 20, upper=centre_deg + 20, step=0.1, start=centre_deg
        ),
        Parameter(name="half_width_deg", unit="deg", lower=5.0, upper=90.0, step=0.1, start=half_deg),
    )
    return _shape(
        Message("sector about {centre_deg:.0f} deg", centre_deg=centre_deg),
        parameters,
        act,
        variant=f"of {half_deg:g}",
    )


def step(run: int, when: float, unit: str) -> Effect:
    """A jump of the zero within one run, at a share `when` of it, counted from its middle: -1/2 to 1/2.

    Args:
        run: number of the run.
        when: share of the run at which the zero jumps, from its middle, -1/2 to 1/2.
        unit: unit of the size on screen, such as `um`.
    """

    def act(reading: Array, p: Array, at: Rows) -> Array:
        return np.asarray(reading + p[0] * ((at.run == run) & (at.elapsed >= when)))

    name = Message("step in run {run} at {when:.0f} % of it", run=run + 1, when=100 * (when + 0.5))
    return _shape(name, (_size("step", unit),), act, one_run=True)


def _shape(
    name: str,
    parameters: tuple[Parameter, ...],
    act: Callable[[Array, Array, Rows], Array],
    variant: str = "",
    one_run: bool = False,
) -> Effect:
    return Effect(
        name=name,
        variant=variant,
        one_run=one_run,
        stage=READING,
        parameters=parameters,
        act=act,
        shape=True,
        member=True,
        separated_by="look at the part and the set-up there",
    )


def shapes(rows: Rows, unit: str, orders: Array | range, form_of: Stage[Any] | None = None) -> tuple[Effect, ...]:
    """Every competing form: harmonics of given orders, bumps and sectors all over the turn, steps in each run.

    Args:
        rows: where they were measured.
        unit: of the reading.
        orders: of the harmonics, dimensionless.
        form_of: stage of the car that bumps and sectors are a form of; None if they may be the instrument's.
    """
    if unit not in UNITS:
        raise KeyError(unit)
    forms: list[Effect] = []
    for width in BUMP_WIDTHS_DEG:
        centres = np.arange(0.0, 360.0, BUMP_PITCH * width)
        near = np.min(np.abs((rows.place[:, None] - np.radians(centres) + np.pi) % TURN - np.pi), axis=0)
        forms += [bump(float(c), width, unit) for c in centres[near < np.radians(width)]]
    for wide in SECTORS_DEG:
        first = np.arange(0.0, 360.0, SECTOR_PITCH_DEG)
        forms += [sector(float(edge + wide / 2) % 360, float(wide) / 2, unit) for edge in first]
    places = np.linspace(-0.5, 0.5, STEPS_PER_RUN + 2)[1:-1]
    waves = (harmonic(float(order), unit) for order in orders)
    forms = [*waves, *(replace(form, form_of=form_of) for form in forms)]
    return (*forms, *(step(run, float(when), unit) for run in range(rows.runs) for when in places))
