"""Motions made of another one: its opposite, of a second follower, and the tangent of a steering angle, of a rod."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Self

import numpy as np
from scipy.interpolate import PPoly

from cadgen.arrays import Array
from cadgen.curves.piecewise import quintic_hermite
from cadgen.laws.motion import Motion
from cadgen.laws.unit import TAN
from cadgen.messages import Message


@dataclass(frozen=True)
class OppositeMotion(Motion):
    """Motion -q of another motion.

    Attributes:
        first: motion q.
    """

    first: Motion | None = None

    @classmethod
    def of(cls, first: Motion) -> Self:
        """Opposite of a motion.

        Args:
            first: motion of the first follower.
        """
        curve = PPoly(-first.q.c, first.q.x, extrapolate="periodic")
        return cls(curve, first.kinks, unit=first.unit, known_level=first.known_level, first=first)

    def jets(self, cam_angle: Array, *, before: bool = False) -> Array:
        """Motion with its first three derivatives, from what the first motion is made of, shape (n, 4).

        Args:
            cam_angle: cam angles, rad, shape (n,).
            before: whether values where a derivative jumps are those of the side before.
        """
        return (
            super().jets(cam_angle, before=before) if self.first is None else -self.first.jets(cam_angle, before=before)
        )

    @property
    def breaks(self) -> Array:
        """Cam angles at which some derivative may jump, rad, shape (m,)."""
        return super().breaks if self.first is None else self.first.breaks

    @property
    def bends(self) -> Array:
        """Cam angles within the turn at which the acceleration is meant to jump, rad, shape (n,)."""
        return super().bends if self.first is None else self.first.bends

    def continuous(self, cam_angle: float) -> int:
        """Number of values meant to be continuous at a cam angle: the motion and its first derivatives, 3 at most.

        Args:
            cam_angle: cam angle, rad.
        """
        return super().continuous(cam_angle) if self.first is None else self.first.continuous(cam_angle)

    def softer(self, cam_angle: float, key: str = "") -> str:
        """Advice that makes both motions milder at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
            key: key of the design file that shapes the motion; left out of the advice if empty.
        """
        return super().softer(cam_angle, key) if self.first is None else self.first.softer(cam_angle, key)

    def higher(self, cam_angle: float) -> str:
        """Advice that keeps the second follower farther from the camshaft, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
        """
        return Message("lead the first follower less far out there")

    def fewer(self, count: int) -> str:
        """Advice for a motion with too many ripples, as part of a sentence.

        Args:
            count: how many times as many ripples as are followed.
        """
        return super().fewer(count) if self.first is None else self.first.fewer(count)

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys, rad: the valleys and peaks of the first."""
        if self.first is None:
            return super().extrema()
        peaks, valleys = self.first.extrema()
        return valleys, peaks


_PARTS = 16  # of each piece: the tangent of a swing of 30 degrees then errs by less than 1e-10


@dataclass(frozen=True)
class TangentMotion(Motion):
    """Motion tan(beta) of a fork whose steering angle is the motion beta.

    Attributes:
        angle: motion beta, rad.
    """

    angle: Motion | None = None

    @classmethod
    def of(cls, angle: Motion) -> Self:
        """Tangent of a steering angle.

        Args:
            angle: steering angle by cam angle, rad.
        """
        x, c = angle.q.x, angle.q.c
        share = np.linspace(0.0, 1.0, _PARTS + 1)
        thetas, jets = [], []
        for number, (start, stop) in enumerate(pairwise(x.tolist())):
            at = share * (stop - start)
            # Each piece by its own polynomial: at a seam both sides keep their own derivatives.
            beta, rate, bend = (np.polyval(np.polyder(c[:, number], order), at) for order in range(3))
            tangent = np.tan(beta)
            steep = 1 + tangent**2
            thetas.append(start + at)
            jets.append(np.stack([tangent, steep * rate, steep * (bend + 2 * tangent * rate**2)], axis=1))
        theta = np.concatenate(thetas)
        theta[-1] = x[-1]
        curve = quintic_hermite(theta, np.concatenate(jets), periodic=True)
        return cls(curve, angle.kinks, unit=TAN, angle=angle)

    @property
    def bends(self) -> Array:
        """Cam angles within the turn at which the acceleration is meant to jump, rad, shape (n,)."""
        return super().bends if self.angle is None else self.angle.bends

    def softer(self, cam_angle: float, key: str = "") -> str:
        """Advice that makes the motion milder at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
            key: key of the design file that shapes the motion; left out of the advice if empty.
        """
        return super().softer(cam_angle, key) if self.angle is None else self.angle.softer(cam_angle, key)

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys, rad: those of the steering angle."""
        return super().extrema() if self.angle is None else self.angle.extrema()
