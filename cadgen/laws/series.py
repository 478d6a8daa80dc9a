"""A motion of harmonics: q = sum over k of a_k cos(k theta) + b_k sin(k theta)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import quintic_hermite
from cadgen.laws.form import ORDERS
from cadgen.laws.motion import Motion
from cadgen.laws.unit import Unit

_PIECES = 48  # quintic pieces a period of the highest harmonic: they err by 1e-10 of its amplitude
_LEAST_PIECES = 180


@dataclass(frozen=True)
class HarmonicMotion(Motion):
    """Motion of harmonics.

    Attributes:
        harmonics: number k and the amplitudes a_k and b_k of each, in the motion's unit.
    """

    harmonics: tuple[tuple[int, float, float], ...] = ()

    key: ClassVar[str] = "motion.harmonics"

    @classmethod
    def of(cls, harmonics: Sequence[tuple[int, float, float]], unit: Unit) -> "HarmonicMotion":
        """Motion of harmonics, each with its number and the amplitudes of its cosine and of its sine.

        Args:
            harmonics: k, a_k and b_k of each; k = 0 is the mean, of which b_k counts for nothing.
            unit: unit of the amplitudes.
        """
        kept = tuple(harmonics)
        highest = max((number for number, *_ in kept), default=0)
        theta = np.linspace(0.0, TURN, max(_LEAST_PIECES, _PIECES * highest) + 1)
        curve = quintic_hermite(theta, _summed(kept, theta)[:, :3], periodic=True)
        return cls(curve, np.array([]), unit=unit, harmonics=kept)

    def jets(self, cam_angle: Array, *, before: bool = False) -> Array:
        """Motion with its first three derivatives by the cam angle, from the series itself, shape (n, 4).

        Args:
            cam_angle: cam angles, rad, shape (n,).
            before: counts for nothing, since no derivative jumps.
        """
        return _summed(self.harmonics, np.asarray(cam_angle, dtype=float))

    @property
    def mirrored(self) -> "HarmonicMotion":
        """The motion of a cam that turns the other way: the sines change their sign."""
        return HarmonicMotion.of([(number, a, -b) for number, a, b in self.harmonics], self.unit)


def _summed(harmonics: Sequence[tuple[int, float, float]], theta: Array) -> Array:
    value = np.zeros((len(theta), ORDERS))
    for number, cosine, sine in harmonics:
        for order in range(ORDERS):
            angle = number * theta + order * np.pi / 2
            value[:, order] += float(number) ** order * (cosine * np.cos(angle) + sine * np.sin(angle))
    return value
