"""Compensation of files for what a printer does to a part."""

from __future__ import annotations

from dataclasses import dataclass

from cadgen.errors import DesignError
from cadgen.messages import Message, joined

# The height of a first layer of most printers, mm.
USUAL_FOOT_HEIGHT = 0.2


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintCompensation:
    """Changes of a mesh for a printer, which the printed part does not show.

    Attributes:
        hole: by how much bores and holes print too small, in diameter, mm.
        chords: whether corners of round holes stand outside their circles, so that the chords touch them.
        foot: by how much the first layers bulge outwards (elephant's foot), mm.
        foot_height: height over which the bulge dies away, mm.
        shrinkage: share of lengths in x and y by which the part shrinks.
        shrinkage_z: share of heights by which it shrinks.

    Raises:
        DesignError: a number out of its range.
    """

    hole: float = 0.0
    chords: bool = False
    foot: float = 0.0
    foot_height: float = USUAL_FOOT_HEIGHT
    shrinkage: float = 0.0
    shrinkage_z: float = 0.0

    def __post_init__(self) -> None:
        for name, most in (("hole", 2.0), ("foot", 1.0), ("foot_height", 5.0)):
            if not 0 <= getattr(self, name) <= most:
                raise DesignError(
                    "{name} is {value:g}; it must be a number from 0 to {most:g} mm",
                    name=name,
                    value=getattr(self, name),
                    most=most,
                )
        for name in ("shrinkage", "shrinkage_z"):
            if not -0.05 <= getattr(self, name) <= 0.1:
                raise DesignError(
                    "{name} is {value:g}; it must be a share from -0.05 to 0.1, such as 0.004",
                    name=name,
                    value=getattr(self, name),
                )
        if self.foot and not self.foot_height:
            raise DesignError(
                "foot_height is 0 and foot is {foot:g} mm; give the height of a layer, such as 0.2", foot=self.foot
            )

    @property
    def sizes(self) -> dict[str, float | bool]:
        """Sizes by their keys of a design, for manifests."""
        return {
            "hole_um": self.hole * 1e3,
            "chords": self.chords,
            "foot_um": self.foot * 1e3,
            "foot_height_um": self.foot_height * 1e3,
            "shrinkage_percent": self.shrinkage * 100,
            "shrinkage_z_percent": self.shrinkage_z * 100,
        }

    @property
    def note(self) -> Message:
        """Sentence for a sheet: what the files for printing have besides the part."""
        parts = []
        if self.hole or self.chords:
            parts.append(Message("holes {hole:g} mm larger", hole=self.hole))
        if self.foot:
            parts.append(
                Message("a foot narrower by {foot:g} mm up to {height:g} mm", foot=self.foot, height=self.foot_height)
            )
        if self.shrinkage or self.shrinkage_z:
            parts.append(
                Message(
                    "{across:g} % larger across and {up:g} % along the axis",
                    across=round((self.scales[0] - 1) * 100, 3),
                    up=round((self.scales[2] - 1) * 100, 3),
                )
            )
        return Message(
            "STL and 3MF are for printing: {parts}. The sizes here are those of the part.", parts=joined(parts)
        )

    @property
    def scales(self) -> tuple[float, float, float]:
        """Factors of x, y and z."""
        across = 1 / (1 - self.shrinkage)
        return across, across, 1 / (1 - self.shrinkage_z)
