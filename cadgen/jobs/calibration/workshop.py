"""Workshop's file: what the cars that were measured differ by, and how long a measurement takes there."""

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.steering import Car
from cadgen.deviations.deviation import ECCENTRIC_BORE, RETURN_ERROR, VARIED, WHEEL_RADIUS, WHEELBASE, Deviation
from cadgen.deviations.effect import Effect, Parameter
from cadgen.errors import FileError
from cadgen.figures import Sheet
from cadgen.gears.choices import Law
from cadgen.inference.measurement.kinds import kinds
from cadgen.inference.monte_carlo.random_cars import Tolerances
from cadgen.inference.workshop import Habit
from cadgen.messages import Message
from cadgen.output.report.terminal import Block

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
    def usual(self) -> dict[str, tuple[float, float]]:
        """Mean and standard deviation of numbers by their names, internal units; no name twice."""
        names = [habit.name for habit in self.habits]
        return {habit.name: (habit.mean, habit.spread) for habit in self.habits if names.count(habit.name) == 1}

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
            effect, _ = _number(habit.effect, habit.name)
            if effect.deviation in VARIED:
                found.setdefault(effect.deviation, []).append(habit)
        # Of a quantity with a direction both components must be known.
        return {d: habits for d, habits in found.items() if len(habits) == (2 if d.directed else 1)}

    @property
    def report(self) -> list[Block]:
        """Sentence and table of means and spreads."""
        rows = []
        for habit in self.habits:
            _, number = _number(habit.effect, habit.name)
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
            f'design = "{self.design}"',
            f"cars = {self.cars}",
            "",
            f"[minutes]  # {Message('to set a measurement up, and of each run')}",
            *(f"{kind} = [{first:g}, {each:g}]" for kind, (first, each) in self.minutes.items()),
        ]
        for habit in self.habits:
            _, number = _number(habit.effect, habit.name)
            mean, spread, least, most = (
                float(f"{value / number.scale:.5g}") for value in (habit.mean, habit.spread, habit.least, habit.most)
            )
            lines += [
                "",
                "[[numbers]]",
                f'effect = "{habit.effect}"',
                f'name = "{habit.name}"',
                f"mean = {mean}",
                f"spread = {spread}",
                f"range_90_percent = [{least}, {most}]",
                f"cars = {float(f'{habit.cars:.3g}')}",
            ]
        return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class _Plays:
    """Plays of a workshop's cars, rad: normal, and never below none."""

    mean: float
    spread: float

    def __call__(self, generator: np.random.Generator, count: int) -> Array:
        return np.maximum(generator.normal(self.mean, self.spread, count), 0.0)


def is_known(effect: str, name: str) -> bool:
    """Whether a number of that name is in a catalogue, so that a workshop's file may have it."""
    try:
        _number(effect, name)
    except KeyError:
        return False
    return True


def _number(effect: str, name: str) -> tuple[Effect, Parameter]:
    """Effect and number by their names; KeyError if there is none."""
    for kind in kinds():
        for entry in kind.catalogue.entries:
            for number in entry.parameters:
                if (entry.name, number.name) == (effect, name):
                    return entry, number
    raise KeyError(name)


def read_workshop(path: Path) -> Workshop:
    """Workshop's file.

    Args:
        path: of the file.

    Raises:
        FileError: it cannot be read, or is none.
    """
    try:
        values: Any = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise FileError("{file} cannot be read as a workshop's file: {error}", file=path, error=error) from error
    try:
        habits = []
        for entry in values["numbers"]:
            _, number = _number(entry["effect"], entry["name"])
            mean, spread, least, most = (
                number.scale * float(each) for each in (entry["mean"], entry["spread"], *entry["range_90_percent"])
            )
            if not spread > 0 or not np.all(np.isfinite([mean, spread, least, most])):
                raise ValueError
            habits.append(Habit(entry["effect"], entry["name"], mean, spread, least, most, float(entry["cars"])))
        if not set(values.get("minutes", {})) <= set(MINUTES) or not int(values["cars"]) > 0:
            raise ValueError
        minutes = {code: (float(pair[0]), float(pair[1])) for code, pair in values.get("minutes", {}).items()}
        if any(not (first >= 0 and each >= 0 and 0 < first + each < inf) for first, each in minutes.values()):
            raise ValueError
        return Workshop(
            design=str(values["design"]), cars=int(values["cars"]), habits=tuple(habits), minutes={**MINUTES, **minutes}
        )
    except (KeyError, TypeError, ValueError, IndexError, AttributeError, OverflowError) as error:
        raise FileError(
            "{file} is no workshop's file, or one of its numbers is none: write it anew with cadgen calibrate --each "
            "--out",
            file=path,
        ) from error
