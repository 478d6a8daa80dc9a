"""Closed forms of laws: pieces of powers and sines, with derivatives of every order and both sides of every seam.

On a piece that begins at the share u0, with t = u - u0,

    s(t) = sum of c_k t^k + sum of A sin(w t + p).

A law that is given by its acceleration, in pieces a0 + a1 t + A sin(w t + p), is integrated twice from rest and scaled
to a rise of 1. The module is light to import.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import cos, perm, pi, sin
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cadgen.arrays import Array

ORDERS = 4  # s and its derivatives up to the jerk


@dataclass(frozen=True)
class FormPart:
    """Part of a form.

    Attributes:
        stop: share of the segment at which it ends; it begins where the one before ends.
        powers: coefficients of t^0, t^1 and so on.
        sines: amplitude, rate and phase of each sine.
    """

    stop: float
    powers: tuple[float, ...] = ()
    sines: tuple[tuple[float, float, float], ...] = ()

    def derivative(self, t: Array, order: int) -> Array:
        """Derivative of an order, shape (n,).

        Args:
            t: shares from the piece's beginning, shape (n,).
            order: 0 for the form itself.
        """
        import numpy as np

        value = np.zeros_like(t)
        for power in range(len(self.powers) - 1, order - 1, -1):
            value = value * t + perm(power, order) * self.powers[power]
        for amplitude, rate, phase in self.sines:
            value += amplitude * rate**order * np.sin(rate * t + phase + order * pi / 2)
        return value

    def scaled(self, share: float) -> FormPart:
        """The piece times a number.

        Args:
            share: number, dimensionless.
        """
        return FormPart(
            self.stop, tuple(share * c for c in self.powers), tuple((share * a, w, p) for a, w, p in self.sines)
        )


@dataclass(frozen=True)
class Form:
    """Function of the share u from 0 to 1, in pieces.

    Attributes:
        pieces: pieces in order, the last of which ends at 1.
    """

    pieces: tuple[FormPart, ...]

    @property
    def seams(self) -> tuple[float, ...]:
        """Shares inside at which two pieces meet."""
        return tuple(piece.stop for piece in self.pieces[:-1])

    def jet(self, u: Array) -> Array:
        """Value and three derivatives at shares, shape (n, 4), at a seam those of the piece behind it.

        Args:
            u: shares, dimensionless, shape (n,).
        """
        return self._of_pieces(u, False)

    def jet_before(self, u: Array) -> Array:
        """Value and three derivatives at shares, shape (n, 4), at a seam those of the piece before it.

        Args:
            u: shares, dimensionless, shape (n,).
        """
        return self._of_pieces(u, True)

    def _of_pieces(self, u: Array, before: bool) -> Array:
        import numpy as np

        number = np.searchsorted(np.array(self.seams), u, side="left" if before else "right")
        value = np.empty((len(u), ORDERS))
        start = 0.0
        for index, piece in enumerate(self.pieces):
            here = number == index
            for order in range(ORDERS):
                value[here, order] = piece.derivative(u[here] - start, order)
            start = piece.stop
        return value


def power_form(coefficients: Sequence[float]) -> Form:
    """Polynomial of the share.

    Args:
        coefficients: of u^0, u^1 and so on.
    """
    return Form((FormPart(1.0, tuple(map(float, coefficients))),))


def sine_form(slope: float, sines: Iterable[tuple[float, float]]) -> Form:
    """Straight line with sines: slope u + sum of A sin(w u).

    Args:
        slope: slope of the line, dimensionless.
        sines: amplitude and rate of each.
    """
    return Form((FormPart(1.0, (0.0, slope), tuple((amplitude, rate, 0.0) for amplitude, rate in sines)),))


@dataclass(frozen=True)
class AccelerationPart:
    """Part of a law given by its acceleration: a0 + a1 t + A sin(w t + p).

    Attributes:
        share: share of the segment that it takes.
        constant: a0.
        slope: a1.
        sine: A, w and p; None without a sine.
    """

    share: float
    constant: float = 0.0
    slope: float = 0.0
    sine: tuple[float, float, float] | None = None


def from_acceleration(zones: Iterable[AccelerationPart]) -> Form:
    """Form that begins at rest, has an acceleration of this shape, and rises by 1.

    Args:
        zones: parts in order, whose shares add up to 1; those of no share are left out.
    """
    at, s, v = 0.0, 0.0, 0.0
    pieces = []
    for zone in zones:
        if not zone.share:
            continue
        amplitude, rate, phase = zone.sine or (0.0, 1.0, 0.0)
        powers = (
            s + amplitude / rate**2 * sin(phase),
            v + amplitude / rate * cos(phase),
            zone.constant / 2,
            zone.slope / 6,
        )
        sines = ((-amplitude / rate**2, rate, phase),) if zone.sine else ()
        pieces.append(FormPart(at + zone.share, powers, sines))
        t, at = zone.share, at + zone.share
        s = sum(c * t**k for k, c in enumerate(powers)) + sum(a * sin(w * t + p) for a, w, p in sines)
        v = powers[1] + 2 * powers[2] * t + 3 * powers[3] * t**2 + sum(a * w * cos(w * t + p) for a, w, p in sines)
    pieces[-1] = FormPart(1.0, pieces[-1].powers, pieces[-1].sines)
    return Form(tuple(piece.scaled(1 / s) for piece in pieces))
