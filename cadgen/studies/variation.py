"""One key that varies: its value at any place of the unit interval, and its levels."""

from dataclasses import dataclass
from math import floor
from typing import Any

from cadgen.errors import DesignError

REPLAN = "replan."  # keys of the study itself, which vary as the design's do
_DIGITS = 6  # of a value in a range: more would only lengthen the files
ROUNDING = 1e-9  # of the number of steps in a range


@dataclass(frozen=True)
class Variation:
    """A key with its values, or its range.

    Attributes:
        key: dotted key of the design, or of [replan].
        values: values to choose from; empty for a range.
        least, most: ends of the range, which belong to it.
        step: between the values of a range; 0 for any value.
        whole: whether only whole numbers are taken.
        along: keys that change together with this one, each with a value for each of `values`.
    """

    key: str
    values: tuple[Any, ...] = ()
    least: float = 0.0
    most: float = 0.0
    step: float = 0.0
    whole: bool = False
    along: tuple[tuple[str, tuple[Any, ...]], ...] = ()

    @property
    def count(self) -> int | None:
        """Number of values; None for a range without steps."""
        if self.values:
            return len(self.values)
        step = self._step
        return floor((self.most - self.least) / step + ROUNDING) + 1 if step else None

    @property
    def levels(self) -> int:
        """Number of values, for a full factorial.

        Raises:
            DesignError: it is a range without steps.
        """
        if self.count is None:
            raise DesignError(f"{self.key} is a range, which a full factorial goes through in steps: add step")
        return self.count

    def level(self, number: int) -> Any:
        """Value of a level, counted from 0."""
        if self.values:
            return self.values[number]
        return self._rounded(self.least + number * self._step)

    def at(self, place: float) -> Any:
        """Value at a place of the unit interval, 0 to 1; all levels have equal shares of it.

        Args:
            place: place, a share from 0 to 1.
        """
        if self.count is not None:
            return self.level(min(floor(place * self.count), self.count - 1))
        return self._rounded(self.least + place * (self.most - self.least))

    @property
    def some(self) -> tuple[Any, ...]:
        """Values that are enough to know their type: all that are chosen from, or the ends of a range."""
        return self.values or (self._rounded(self.least), self._rounded(self.most))

    def changes(self, value: Any) -> list[tuple[str, Any]]:
        """Keys that change with a value, this one first, each with its own value."""
        number = self.values.index(value) if self.along else 0
        return [(self.key, value), *((key, values[number]) for key, values in self.along)]

    @property
    def _step(self) -> float:
        return self.step or (1.0 if self.whole else 0.0)

    def _rounded(self, value: float) -> float | int:
        return round(value) if self.whole else float(f"{value:.{_DIGITS}g}")
