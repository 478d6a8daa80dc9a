"""Workshop's file: what the cars that were measured differ by, and how long a measurement takes there."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf, nan, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.steering import Car
from cadgen.design.parse import parse
from cadgen.deviations.deviation import ECCENTRIC_BORE, RETURN_ERROR, VARIED, WHEEL_RADIUS, WHEELBASE, Deviation
from cadgen.deviations.effect import Effect, Parameter, Quantity
from cadgen.errors import FileError, brief
from cadgen.figures import Sheet
from cadgen.gears.choices import Law
from cadgen.inference.measurement.kinds import kinds
from cadgen.inference.measurement.record import Kind
from cadgen.inference.monte_carlo.random_cars import Tolerances
from cadgen.inference.workshop import Habit
from cadgen.messages import Message, joined
from cadgen.output.report.terminal import Block
from cadgen.reading import read_regular

# Deviations whose positive sense is the other one of the effect: a greater gain is that of a shorter wheelbase, and an
# eccentric bore moves the disc the other way than it lies itself.
_REVERSED = (WHEELBASE, ECCENTRIC_BORE)
# Minutes to set a measurement up, and of each run.
MINUTES: Mapping[str, tuple[float, float]] = {
    "track": (20.0, 3.0),
    "lift": (15.0, 15.0),
    "profile": (30.0, 15.0),
    "transmission": (20.0, 10.0),
    "by_hand": (5.0, 0.0),
}
MOST_BYTES = 1_000_000
_MOST_CARS, _MOST_MINUTES, _GREATEST = 1_000_000, 100_000.0, 1e12
_KEYS = ("effect", "kind", "name", "mean", "spread", "range_90_percent", "cars")
_UNREADABLE = "it cannot be opened"


def minutes_of(times: Mapping[str, tuple[float, float]], kind: str | None, runs: int) -> float:
    """Minutes that a measurement takes.

    Args:
        times: by the code of the kind: to set it up, and of each run.
        kind: code of its kind; None for the play by hand.
        runs: how many.
    """
    first, each = times[kind or "by_hand"]
    return first + runs * each


@dataclass(frozen=True, kw_only=True)
class Workshop:
    """Means and spreads of the deviations of a workshop's cars.

    Attributes:
        design: name of the design by which its cars were made.
        cars: how many were measured.
        habits: numbers of which enough is known.
        minutes: of a measurement by the code of its kind: to set it up, and of each run.
    """

    design: str
    cars: int
    habits: tuple[Habit, ...]
    minutes: Mapping[str, tuple[float, float]] = field(default_factory=lambda: dict(MINUTES))

    @property
    def usual(self) -> dict[Quantity, tuple[float, float]]:
        """Mean and standard deviation of numbers by their keys, internal units."""
        return {_entry(habit).quantity: (habit.mean, habit.spread) for habit in self.habits}

    def tolerances(self, given: Tolerances, car: Car, wheel_radius: float) -> Tolerances:
        """Tolerances with what the workshop does in the place of what the design allows.

        Args:
            given: by the design.
            car: that the cam steers.
            wheel_radius: of the drive wheel, mm.
        """
        sizes = {WHEELBASE: car.wheelbase, WHEEL_RADIUS: wheel_radius}
        halves, means, play = dict(given.half_widths), dict(given.means), given.play
        for deviation, habits in self._by_deviation().items():
            of = [sizes.get(deviation, 1.0) if habit.name.endswith("_percent") else 1.0 for habit in habits]
            spread = float(np.sqrt(np.mean([(habit.spread * k) ** 2 for habit, k in zip(habits, of, strict=True)])))
            if deviation == RETURN_ERROR:
                play = _Plays(habits[0].mean, spread)
                continue
            # A law's half width is 3 or √3 standard deviations, and one of a size with a direction √2 times as many.
            halves[deviation] = spread * (3 if given.law is Law.NORMAL else sqrt(3)) * sqrt(len(habits))
            sign = -1.0 if deviation in _REVERSED else 1.0
            means |= {
                column: sign * habit.mean * k for column, habit, k in zip(deviation.columns, habits, of, strict=True)
            }
        return replace(given, half_widths=halves, means=means, play=play)

    def _by_deviation(self) -> dict[Deviation, list[Habit]]:
        found: dict[Deviation, list[Habit]] = {}
        for habit in self.habits:
            if (known := _entry(habit).effect.deviation) in VARIED:
                found.setdefault(known, []).append(habit)
        return found

    @property
    def report(self) -> list[Block]:
        """Sentence and table of means and spreads."""
        rows = []
        for habit in self.habits:
            number = _entry(habit).number
            mean, spread, least, most = (
                value / number.scale for value in (habit.mean, habit.spread, habit.least, habit.most)
            )
            rows.append(
                (
                    Message(habit.effect),
                    habit.name,
                    f"{mean:.3g}",
                    f"{spread:.3g}",
                    f"{least:.3g} – {most:.3g}",
                    f"{habit.cars:.0f}",
                )
            )
        head = (
            *(Message("Effect"), Message("Number"), Message("Mean"), Message("Spread of a further car")),
            *(Message("Spread, 90 %"), Message("Cars")),
        )
        return [
            Message(
                "What {cars} cars of this workshop differ by; with few of them the spread is wide, for little is known "
                "of it yet. tolerance and calibrate take it with --workshop.",
                cars=self.cars,
            ),
            Sheet("workshop", "", head, tuple(rows)),
        ]

    def text(self) -> str:
        """Text of the file."""
        lines = [
            f"# {Message('Written by cadgen calibrate --each: what the cars of this workshop differ by.')}",
            f"design = {_text(self.design)}",
            f"cars = {self.cars}",
            "",
            f"[minutes]  # {Message('to set a measurement up, and of each run')}",
            *(f"{kind} = [{first}, {each}]" for kind, (first, each) in self.minutes.items()),
        ]
        for habit in self.habits:
            number = _entry(habit).number
            mean, spread, least, most = (
                float(f"{value / number.scale:.5g}") for value in (habit.mean, habit.spread, habit.least, habit.most)
            )
            lines += [
                "",
                "[[numbers]]",
                f"effect = {_text(habit.effect)}",
                f"kind = {_text(habit.kind)}",
                f"name = {_text(habit.name)}",
                f"mean = {mean}",
                f"spread = {spread}",
                f"range_90_percent = [{least}, {most}]",
                f"cars = {min(float(f'{habit.cars:.3g}'), float(self.cars))}",
            ]
        return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class _Plays:
    """Plays of a workshop's cars, rad: normal, and never below none."""

    mean: float
    spread: float

    def __call__(self, generator: np.random.Generator, count: int) -> Array:
        return np.maximum(generator.normal(self.mean, self.spread, count), 0.0)


@dataclass(frozen=True)
class _Entry:
    """Number of an effect in the catalogue of a kind of data."""

    kind: Kind
    effect: Effect
    number: Parameter

    @property
    def quantity(self) -> Quantity:
        return self.effect.quantities[self.effect.parameters.index(self.number)]


def _entries(effect: str, name: str) -> list[_Entry]:
    """Numbers of that name that effects of that name have, one of each kind of data."""
    return [
        _Entry(kind, entry, number)
        for kind in kinds()
        for entry in kind.catalogue.entries
        for number in entry.parameters
        if (entry.name, number.name) == (effect, name)
    ]


def _entry(habit: Habit) -> _Entry:
    return next(entry for entry in _entries(habit.effect, habit.name) if entry.kind.code == habit.kind)


def is_known(kind: Kind, effect: Effect) -> bool:
    """Whether the numbers of an effect are in the catalogue of a kind, so that a workshop's file may have them.

    Args:
        kind: of the data.
        effect: as data of that kind call it.
    """
    return all(any(entry.kind is kind for entry in _entries(effect.name, number.name)) for number in effect.parameters)


def can_be(habit: Habit) -> bool:
    """Whether mean and spread are such as cars can have.

    Args:
        habit: number over the cars of a workshop.
    """
    number = _entry(habit).number
    low, high = number.lower * number.scale, number.upper * number.scale
    return low <= habit.mean <= high and 0 < habit.spread <= high - low


def _text(words: str) -> str:
    import tomlkit

    return tomlkit.item(words).as_string()


def read_workshop(path: Path, design: str) -> Workshop:
    """Workshop's file.

    Args:
        path: of the file.
        design: name of the design that it is wanted for.

    Raises:
        FileError: it cannot be read, is of another design, or has something that cannot be.
    """
    try:
        values = parse(read_regular(path, MOST_BYTES).decode("utf-8-sig"))
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else brief(str(error))
        raise FileError(
            "{file} cannot be read as a workshop's file ({error}): give the one that cadgen calibrate --each --out "
            "writes",
            file=path,
            error=Message(str(reason or _UNREADABLE)),
        ) from error
    try:
        return _workshop(values, design)
    except FileError as error:
        raise FileError("{file}: {error}", file=path, error=error.message) from error


def _workshop(values: Mapping[str, Any], design: str) -> Workshop:
    """Workshop by the values of its file; FileError without its name where something cannot be."""
    for key in values:
        if key not in ("design", "cars", "minutes", "numbers"):
            raise FileError("there is no key {key} in a workshop's file: remove it", key=brief(key))
    made_by = values.get("design")
    if not isinstance(made_by, str):
        raise FileError("design is missing or no text: it must be the name of the design by which the cars were made")
    if made_by != design:
        raise FileError(
            "it is of cars that were made by {made_by}, and not by {design}: where these are made in the same way, "
            'write design = "{design}" in it',
            made_by=brief(made_by),
            design=design,
        )
    cars = values.get("cars")
    if isinstance(cars, bool) or not isinstance(cars, int) or not 1 <= cars <= _MOST_CARS:
        raise FileError("cars is missing or no whole number from 1: it must say how many cars were measured")
    tables = values.get("numbers", [])
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise FileError("numbers is no list of tables: each number of an effect must be a table [[numbers]]")
    habits = [_habit(table, cars) for table in tables]
    seen: dict[Quantity, Habit] = {}
    for habit in habits:
        quantity = _entry(habit).quantity
        if (other := seen.setdefault(quantity, habit)) is not habit:
            raise FileError(
                "{name} is given twice, by {one} of kind {kind} and by {other} of kind {kind2}, which are one thing: "
                "remove one of the two",
                name=habit.name,
                one=other.effect,
                kind=other.kind,
                other=habit.effect,
                kind2=habit.kind,
            )
    for habit in habits:
        # A size with a direction is drawn as a whole.
        if missing := [key[1] for key in _entry(habit).effect.quantities if key not in seen]:
            raise FileError(
                "{name} of {effect} is given without {missing}: give both, or remove it",
                name=habit.name,
                effect=habit.effect,
                missing=missing[0],
            )
    return Workshop(design=made_by, cars=cars, habits=tuple(habits), minutes={**MINUTES, **_minutes(values)})


def _minutes(values: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    table = values.get("minutes", {})
    if not isinstance(table, dict):
        raise FileError(
            "minutes is no table: write [minutes], and a line such as track = [20, 3] for each kind of data"
        )
    found = {}
    for code, pair in table.items():
        if code not in MINUTES:
            raise FileError(
                "minutes has {code}, which is measured nowhere: it may have {codes}",
                code=brief(code),
                codes=joined(MINUTES, ", "),
            )
        both = [_figure(each) for each in pair] if isinstance(pair, list) else []
        if len(both) != 2 or not all(0 <= each <= _MOST_MINUTES for each in both) or not sum(both) > 0:
            raise FileError(
                "minutes.{code} is not two times: write the minutes to set it up and those of each run, not both 0 and "
                "at most {most:g}, such as [20, 3]",
                code=code,
                most=_MOST_MINUTES,
            )
        found[code] = both[0], both[1]
    return found


def _habit(table: Mapping[str, Any], cars: int) -> Habit:
    for key in table:
        if key not in _KEYS:
            raise FileError("a number has the key {key}, which means nothing: remove it", key=brief(key))
    effect, name, kind = (table.get(key) for key in ("effect", "name", "kind"))
    entries = [e for e in _entries(str(effect), str(name)) if kind is None or e.kind.code == kind]
    if not entries:
        raise FileError(
            "there is no effect {effect} with the number {name}{where}: docs/effects.md has their names",
            effect=brief(str(effect)),
            name=brief(str(name)),
            where="" if kind is None else Message(" of kind {kind}", kind=brief(str(kind))),
        )
    if len({entry.quantity for entry in entries}) > 1:
        raise FileError(
            "{effect} is one thing in data of kind {kind}, and another in those of kind {other}: give its kind",
            effect=str(effect),
            kind=entries[0].kind.code,
            other=entries[1].kind.code,
        )
    number = entries[0].number
    mean, spread, known = (_figure(table.get(key)) for key in ("mean", "spread", "cars"))
    pair = table.get("range_90_percent")
    least, most = (_figure(each) for each in pair) if isinstance(pair, list) and len(pair) == 2 else (nan, nan)
    span = number.upper - number.lower
    for key, value, low, high in (("mean", mean, number.lower, number.upper), ("spread", spread, 0.0, span)):
        if not low <= value <= high or (key == "spread" and value == 0):
            raise FileError(
                "the {key} of {name} of {effect} is {value}; it must be a number between {low:g} and {high:g}: measure "
                "again, or remove this effect",
                key=key,
                name=number.name,
                effect=str(effect),
                value=brief(repr(table.get(key))),
                low=low,
                high=high,
            )
    if not 0 <= least <= most < inf:
        raise FileError(
            "range_90_percent of {name} of {effect} is not two numbers from 0 in their order: write them so",
            name=number.name,
            effect=str(effect),
        )
    if not 0 < known <= cars:
        raise FileError(
            "cars of {name} of {effect} must be a number above 0 and at most {cars}, as many as were measured",
            name=number.name,
            effect=str(effect),
            cars=cars,
        )
    mean, spread, least, most = (number.scale * value for value in (mean, spread, least, most))
    return Habit(entries[0].kind.code, str(effect), number.name, mean, spread, least, most, known)


def _figure(value: object) -> float:
    """Number of a file; NaN for what is none."""
    if isinstance(value, bool) or not isinstance(value, int | float) or abs(value) > _GREATEST:
        return nan
    return float(value)
