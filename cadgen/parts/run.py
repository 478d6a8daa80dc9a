"""Way of a section along the axis of its body: straight, along a helix, or along a helix and back."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin, tan


@dataclass(frozen=True, slots=True)
class HelixRun:
    """Turning of a section with its height above the start of its wall, or its lean.

    Attributes:
        rate: turning per mm of height, rad/mm; positive for a right-hand helix, 0 for a prism.
        apex: height above the start at which the helix turns back, mm; None for one that does not.
        lean: shift of the section along x per mm of height, of a wall that does not turn, as that of a helical rack.
    """

    rate: float = 0.0
    apex: float | None = None
    lean: float = 0.0

    @property
    def straight(self) -> bool:
        """Whether the wall does not turn."""
        return self.rate == 0

    def angle(self, height: float) -> float:
        """Angle of the section at a height above the start against that at the start, rad.

        Args:
            height: height above the start, mm.
        """
        if self.apex is None or height <= self.apex:
            return self.rate * height
        return self.rate * (2 * self.apex - height)

    def pieces(self, length: float) -> tuple[tuple[float, float], ...]:
        """Heights above the start between which the section turns evenly, mm.

        Args:
            length: length of the wall, mm.
        """
        if self.apex is None or not 0 < self.apex < length:
            return ((0.0, length),)
        return ((0.0, self.apex), (self.apex, length))


STRAIGHT = HelixRun()


def helix(angle: float, diameter: float, apex: float | None = None) -> HelixRun:
    """HelixRun of a gear: a point of its reference cylinder turns by 2 tan β / d per mm (ISO 21771-1).

    Args:
        angle: helix angle β, rad; positive for a right-hand helix.
        diameter: reference diameter, mm.
        apex: height at which a double helix turns back, mm.
    """
    return HelixRun(2 * tan(angle) / diameter, apex) if angle else STRAIGHT


def lead(angle: float, diameter: float) -> float:
    """Lead of a helix: axial length of one whole turn, π d / tan |β|, mm.

    Args:
        angle: helix angle β, rad, not 0.
        diameter: reference diameter, mm.
    """
    return pi * diameter * cos(angle) / abs(sin(angle))
