"""Opposite of a motion: what a second follower does that goes in as far as the first one goes out."""

from dataclasses import dataclass
from typing import Self

from scipy.interpolate import PPoly

from cadgen.arrays import Array
from cadgen.laws.motion import Motion
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
