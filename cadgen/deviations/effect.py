"""An effect: a named change at one stage of a forward model, with parameters, bounds and rivals."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.deviation import Deviation, Place

State = TypeVar("State")

# Deviation that a number is of, or the effect where it is none, and name of the number: alike in all kinds of data.
Quantity = tuple[str, str]

UM = 1e-3  # mm in a micrometre
DEG = pi / 180
PERCENT = 1e-2

# Internal value of one of each unit that people read.
UNITS = {"um": UM, "mm": 1.0, "deg": DEG, "%": PERCENT, "": 1.0, "s": 1.0}

_USUAL_STEPS = 5.0


@dataclass(frozen=True, kw_only=True)
class Rows:
    """Run, angle and time of each measured number; arrays of shape (n,), in the order measured within each run.

    Attributes:
        run: number of the run, from 0.
        place: angle round the cam, rad.
        elapsed: place within the run, -1/2 to 1/2.
        cell: rows of different runs with one number were taken under the same conditions; -1 if none repeats.
    """

    run: NDArray[np.intp]
    place: Array
    elapsed: Array
    cell: NDArray[np.intp]

    @property
    def runs(self) -> int:
        """Number of runs."""
        return int(self.run.max()) + 1


@dataclass(frozen=True, eq=False)
class Stage(Generic[State]):
    """A place in a forward model at which effects change what passes there, such as a disc or the angles of a shaft.

    It is told from others by identity; `name` is for messages. What acts at one `of_instrument` leaves the car alone.
    """

    name: str
    of_instrument: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """Number of an effect, with its bounds.

    Attributes:
        name: name with the unit in it, as in a design file (`eccentric_x_um`).
        unit: key of `UNITS`; bounds and step are in it.
        lower, upper: bounds of physically possible values.
        step: small but visible value, for differences.
        usual: standard deviation from car to car, of parts made with care in a workshop and put together by hand, where
            nobody has measured it; five steps if left out. A design's own [tolerances] come before it.
        start: value at which a search begins.
        meaning: meaning of a positive value, or of the number; empty only for forms without a name.
        stepwise: whether the expected readings change in steps, so that it is found by trial instead of by slopes.
    """

    name: str
    unit: str
    lower: float
    upper: float
    step: float
    usual: float | None = None
    start: float = 0.0
    meaning: str = ""
    stepwise: bool = False

    @classmethod
    def of(
        cls,
        name: str,
        upper: float,
        step: float,
        usual: float | None = None,
        meaning: str = "",
        *,
        lower: float | None = None,
        start: float = 0.0,
    ) -> "Parameter":
        """Number whose unit stands at the end of its name, of either sign if no lower bound is given.

        Args:
            name: name with the unit in it.
            upper, lower: bounds, in the unit of the name.
            step: small but visible value, in the unit of the name.
            usual: standard deviation from car to car, in the unit of the name.
            meaning: meaning of a positive value.
            start: value at which a search begins, in the unit of the name.
        """
        ending = name.removesuffix("_per_run").rpartition("_")[2]
        return cls(
            name=name,
            unit="%" if ending == "percent" else ending,
            lower=-upper if lower is None else lower,
            upper=upper,
            step=step,
            usual=usual,
            start=start,
            meaning=meaning,
        )

    @property
    def scale(self) -> float:
        """Internal value (mm, rad, 1) of one unit."""
        return UNITS[self.unit]

    @property
    def spread(self) -> float:
        """Usual standard deviation from car to car, internal units."""
        return (_USUAL_STEPS * self.step if self.usual is None else self.usual) * self.scale


@dataclass(frozen=True)
class Group:
    """Effects of which a subset of the catalogue holds one at most; `name` is unique in the catalogue."""

    name: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Effect:
    """Entry of a catalogue, or (with `shape`) an anonymous form that competes with the entries.

    Attributes:
        name: name of the effect in claims.
        stage: stage of the forward model at which it acts.
        parameters: their internal values, in order, are the array `act` receives.
        act: (what passes the stage, values, stations) -> the same changed; exact, not linearised.
        deviation: entry of the catalogue that it is, whatever its kind of data calls it, so that records of several
            kinds agree about it; None for one that only its own kind of data shows.
        group: group of effects of which a subset holds one at most; None without one.
        twins: causes that no data of this kind can tell from this one.
        confused_with: causes that look like it.
        separated_by: the measurement that tells them apart.
        shape: True for a form without a name in the catalogue.
        member: True for a member of a family (orders, places); members enter a subset one at a time.
        includes: effect that this one becomes for some values.
        places: where the effect may be, the likeliest first; any effect may be `noted`.
        indices: numbers that say which of several alike it is, by their keys, as `nose_number`; they are not fitted.
        beside: effect without which it does nothing; with that it counts as one cause.
        looks_like: effect of the part or the car that it may be taken for: where the data do not tell them apart, they
            are one cause under two names.
        parts: effects that it stands for while a search begins, each with its share of the parameters in order.
        variant: makes entries of one name different (which nose, from which width the search begins).
        cause: what its orders and places share; the name if empty.
        one_run: True if it acts in one of the measured runs alone.
        form_of: stage at which a shape moves the car too, the lift or the disc; None if it may be the instrument's.
        called: name in its own catalogue, where a merged one has another; empty where it is the same.
    """

    name: str
    stage: Stage[Any]
    parameters: tuple[Parameter, ...]
    act: Callable[[Any, Array, Any], Any]
    deviation: Deviation | None = None
    group: Group | None = None
    twins: tuple[str, ...] = ()
    confused_with: str = ""
    separated_by: str = ""
    shape: bool = False
    member: bool = False
    variant: str = ""
    cause: str = ""
    one_run: bool = False
    form_of: Stage[Any] | None = None
    includes: "Effect | None" = None
    places: tuple[Place, ...] = (Place.NOTED,)
    indices: tuple[tuple[str, float], ...] = ()
    beside: "Effect | None" = None
    looks_like: "Effect | None" = None
    parts: tuple["Effect", ...] = ()
    called: str = ""

    @property
    def key(self) -> str:
        """Name and variant: what makes two entries different."""
        return f"{self.name} {self.variant}".strip()

    @property
    def sort(self) -> str:
        """Name of the cause: what all its orders and places share."""
        return self.cause or self.name

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Key of each number, by which what other cars have of it is known, whatever a kind of data calls it."""
        thing = (self.called or self.name) if self.deviation is None else self.deviation.name
        return tuple((thing, number.name) for number in self.parameters)

    @property
    def instrument(self) -> bool:
        """True of an effect of the instrument, which changes nothing but its own record."""
        return self.stage.of_instrument or (self.looks_like is not None and self.places == (Place.NOTED,))

    @property
    def steps(self) -> Array:
        """Difference steps, internal units."""
        return np.array([p.step * p.scale for p in self.parameters])

    @property
    def start(self) -> Array:
        """Where a search begins, internal units."""
        return np.array([p.start * p.scale for p in self.parameters])

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds, internal units."""
        lower = np.array([p.lower * p.scale for p in self.parameters])
        return lower, np.array([p.upper * p.scale for p in self.parameters])


# What the instrument shows; the forms without a name act here in every kind of data.
READING = Stage[Array]("reading")

Active = Sequence[tuple[Effect, Array]]


def activated(effects: Sequence[Effect], values: Array) -> list[tuple[Effect, Array]]:
    """Effects, each with its own of their values.

    Args:
        effects: effects.
        values: values of all in a row, internal units (mm, rad), shape (sum of parameters,).
    """
    cuts = np.cumsum([len(e.parameters) for e in effects])[:-1]
    return list(zip(effects, np.split(values, cuts), strict=True)) if effects else []


def causes(effects: Iterable[Effect]) -> int:
    """How many causes effects have: what acts beside another adds none, nor does what leaves the car alone."""
    return sum(not (effect.beside or effect.stage.of_instrument) for effect in effects)


def key_of(active: Active) -> bytes:
    """Identity of active effects with their values, for what is remembered of them."""
    return b"".join(effect.key.encode() + np.asarray(values, dtype=float).tobytes() for effect, values in active)


def through(stage: Stage[State], state: State, active: Iterable[tuple[Effect, Array]], at: Any) -> State:
    """Let every active effect of a stage act in turn on what passes there."""
    for effect, values in active:
        if effect.stage is stage:
            state = effect.act(state, values, at)
    return state
