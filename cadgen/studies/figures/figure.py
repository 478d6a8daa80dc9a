"""A figure of a design, by which a study ranks or limits designs."""

from collections.abc import Callable
from dataclasses import dataclass

from cadgen.studies.figures.evaluated import Evaluated


@dataclass(frozen=True, kw_only=True)
class Figure:
    """A figure of a design.

    Attributes:
        code: name in studies and tables, with its unit at the end.
        meaning: a phrase.
        of: function that computes it, a finite number; a function of a module, so that other processes find it.
        more: whether a greater figure is better.
        resolution: differences below it are those of rounding and search, and make no design better.
        cheap: whether it takes milliseconds; a limit on it then screens, and nothing else of the design is computed.
    """

    code: str
    meaning: str
    of: Callable[[Evaluated], float]
    more: bool = False
    resolution: float = 0.0
    cheap: bool = False

    def aim(self, value: float) -> float:
        """A value in the figure's own unit, rounded to its resolution, with the sign by which less is better.

        Args:
            value: value of the figure, a number in its own unit.
        """
        seen = round(value / self.resolution) * self.resolution if self.resolution else value
        return -seen if self.more else seen
