"""A motion law: how a follower goes from one height to another over a segment of the turn."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from math import ceil
from typing import TYPE_CHECKING, Any

from cadgen.laws.form import ORDERS, Form

if TYPE_CHECKING:
    from cadgen.arrays import Array

_LEAST_PIECES = 8  # of a part between two seams
_STEP = 1e-5  # of the share, over which the jerk of a law that does not give it is a quotient of differences
_ROUNDING = 1e-9  # of the rise; a smaller velocity or acceleration at an end is none


@dataclass(frozen=True, kw_only=True)
class MotionLaw:
    """Normalised rise over a segment: s from 0 to 1 as its share u of the angle goes from 0 to 1.

    Attributes:
        code: value of `law` in a segment of the design file.
        meaning: sentence for the reference.
        jet: function of shares u, shape (n,), that returns s and its first two derivatives by u, shape (n, 3), or
            its first three, shape (n, 4).
        pieces: quintic pieces by which the law is followed; one is exact for a polynomial of degree 5. With 64 a
            trigonometric law errs by some 1e-10 of the rise.
        seams: shares inside at which a derivative jumps; a knot of the pieces stands on each.
        jet_before: as `jet`, but at a seam by the side before it; left out where nothing jumps inside.
        to_top: whether the law ends at the top of a lobe, so that a return runs it backwards.
        key: key of the segment that shapes the law, such as `powers`; empty if it has one shape.
        shaped: function of the value of that key that returns the law of that shape; it raises a `ValueError`, one
            sentence for the user, for a value that makes none.
    """

    code: str
    meaning: str
    jet: Callable[[Array], Array]
    pieces: int = 64
    seams: tuple[float, ...] = ()
    jet_before: Callable[[Array], Array] | None = None
    to_top: bool = False
    key: str = ""
    shaped: Callable[[Any], MotionLaw] | None = field(default=None, compare=False)

    @classmethod
    def of(cls, code: str, meaning: str, form: Form, **more: Any) -> MotionLaw:
        """Law of a closed form.

        Args:
            code: value of `law`.
            meaning: sentence for the reference.
            form: s by u.
            more: other attributes.
        """
        return cls(code=code, meaning=meaning, jet=form.jet, jet_before=form.jet_before, seams=form.seams, **more)

    @property
    def name(self) -> str:
        """Words of the code, its numbers joined, such as `polynomial 3-4-5`, for sheets."""
        words = self.code.split("_")
        numbers = [word for word in words if word.isdigit()]
        return " ".join([*(word for word in words if not word.isdigit()), *(["-".join(numbers)] if numbers else [])])

    def derivatives(self, u: Array, *, before: bool = False) -> Array:
        """Law and its first three derivatives by the share, from the law itself, shape (n, 4).

        Args:
            u: shares from 0 to 1, shape (n,).
            before: whether values at a seam are those of the side before it.
        """
        import numpy as np

        jet = self.jet_before if before and self.jet_before is not None else self.jet
        value = jet(u)
        if value.shape[1] == ORDERS:
            return value
        low, high = np.maximum(u - _STEP, 0.0), np.minimum(u + _STEP, 1.0)
        jerk = (jet(high)[:, 2] - jet(low)[:, 2]) / (high - low)
        return np.column_stack([value, jerk])

    def knots(self) -> tuple[Array, Array]:
        """Shares of the knots of the pieces, shape (n,), and the law there with two derivatives, shape (n, 3).

        A seam stands twice: with the values before it, and with those behind it.
        """
        import numpy as np

        shares, jets = [], []
        for start, stop in zip((0.0, *self.seams), (*self.seams, 1.0), strict=True):
            count = self.pieces if self.pieces == 1 else max(_LEAST_PIECES, ceil(self.pieces * (stop - start)))
            share = np.linspace(start, stop, count + 1)
            shares.append(share)
            jets.append(np.vstack([self.derivatives(share[:-1]), self.derivatives(share[-1:], before=True)])[:, :3])
        return np.concatenate(shares), np.concatenate(jets)

    @cached_property
    def ends(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Velocity and acceleration at the start and at the end, in rises by shares; 0 where only rounding is left."""
        import numpy as np

        values = [self.derivatives(np.array([0.0]))[0], self.derivatives(np.array([1.0]), before=True)[0]]
        start, stop = (tuple(x if abs(x) > _ROUNDING else 0.0 for x in value[1:3].tolist()) for value in values)
        return (start[0], start[1]), (stop[0], stop[1])

    @property
    def backwards(self) -> MotionLaw:
        """The law run backwards: 1 - s(1 - u)."""
        return self._reflected(True)

    @property
    def turned(self) -> MotionLaw:
        """The law from its end to its beginning: s(1 - u)."""
        return self._reflected(False)

    def _reflected(self, rising: bool) -> MotionLaw:
        return replace(
            self,
            jet=partial(_from_its_end, self, rising, True),
            jet_before=partial(_from_its_end, self, rising, False),
            seams=tuple(1 - seam for seam in self.seams[::-1]),
        )


def _from_its_end(law: MotionLaw, rising: bool, before: bool, u: Array) -> Array:
    """Jet of s(1 - u), or of 1 - s(1 - u), which rises again."""
    falling = law.derivatives(1 - u, before=before) * [1.0, -1.0, 1.0, -1.0]
    return [1.0, 0.0, 0.0, 0.0] - falling if rising else falling
