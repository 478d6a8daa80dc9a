"""One figure and its verdict, for cams and for gears: light to import."""

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Check:
    """One figure and its verdict.

    Attributes:
        name: what is checked.
        value: the figure, in `unit`.
        unit: of value and limit.
        limit: the bound; infinite for a figure that is shown and not judged.
        bound: `max` if the value must not exceed the limit, `min` if it must reach it.
        place: where the figure occurs.
        advice: what to change if it fails; empty if there is nothing to say.
    """

    name: str
    value: float
    unit: str
    limit: float
    bound: Literal["max", "min"]
    place: str = ""
    advice: str = ""

    @property
    def passed(self) -> bool:
        """True when the value keeps its limit; a value that is not a number never does."""
        return bool(self.value <= self.limit if self.bound == "max" else self.value >= self.limit)
