"""A motion law: how a follower goes from one height to another over a segment of the turn."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cadgen.arrays import Array


@dataclass(frozen=True, kw_only=True)
class MotionLaw:
    """Normalised rise over a segment: s from 0 to 1 as its share u of the angle goes from 0 to 1.

    Attributes:
        code: value of `law` in a segment of the design file.
        meaning: sentence for the reference.
        jet: function of shares u, shape (n,), that returns s and its first two derivatives by u, shape (n, 3).
        pieces: quintic pieces by which the law is followed; one is exact for a polynomial of degree 5. With 64 a
            trigonometric law errs by some 1e-10 of the rise.
    """

    code: str
    meaning: str
    jet: Callable[[Array], Array]
    pieces: int = 64
