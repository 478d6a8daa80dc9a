"""A figure of a design, by which a study ranks or limits designs."""

from collections.abc import Callable
from dataclasses import dataclass

from cadgen.exploration.figures.evaluated import Evaluated


@dataclass(frozen=True, kw_only=True)
class Figure:
    """A figure of a design.

    Attributes:
        code: name in studies and tables, with its unit at the end.
        meaning: a phrase.
        of: function that computes it, a finite number; a function of a module, so that other processes find it.
        more: whether a greater figure is better.
        cheap: whether it takes milliseconds; a limit on it then screens, and nothing else of the design is computed.
    """

    code: str
    meaning: str
    of: Callable[[Evaluated], float]
    more: bool = False
    cheap: bool = False

    @property
    def sign(self) -> float:
        """Factor that makes less of the figure better: 1 or -1."""
        return -1.0 if self.more else 1.0
