"""Two wheels set against each other on their outlines: what checks of a stage measure, and the meshes room finds."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, Protocol

# Overlap in mm² below which teeth only touch: ten times the rounding of the sections' common area (1e-8 mm).
LEAST_OVERLAP = 1e-8
# What a measured play may differ from the computed one, µm of arc on the driven wheel's pitch circle.
PLAY_LIMIT_UM = 0.5
# What to do about a figure that only an error of the program can spoil.
CONTRADICTION = "the teeth contradict the formulas: report this design"
# Positions of the driver over one pitch at which the teeth are set against each other.
POSITIONS = 8


class Engaged(Protocol):
    """Both wheels' outlines, the driver's axis at 0 and the driven wheel's on x; angles are the wheels', rad."""

    def middle(self, driver_angle: float) -> float:
        """Angle of the driven wheel midway between the driver's flanks, rad, at an angle of the driver, rad.

        Args:
            driver_angle: angle of the driver, rad.
        """

    def overlap(self, driver_angle: float, driven_angle: float) -> float:
        """Common area, mm².

        Args:
            driver_angle: angle of the driver, rad.
            driven_angle: angle of the driven wheel, rad.
        """

    def overlap_midway(self, driver_angle: float) -> float:
        """The same at `middle`: above `LEAST_OVERLAP` the teeth jam.

        Args:
            driver_angle: angle of the driver, rad.
        """

    def overlap_tooth_on_tooth(self, driver_angle: float) -> float:
        """The same half a pitch on: up to `LEAST_OVERLAP` the teeth do not hold each other.

        Args:
            driver_angle: angle of the driver, rad.
        """

    def play(self, driver_angle: float) -> float:
        """Free angle of the driven wheel while the driver stands still, rad.

        Args:
            driver_angle: angle of the driver, rad.
        """

    def clearances(self) -> tuple[float, float]:
        """Gap between the driver's tips and the driven wheel's roots, and the other way round, mm."""


# A stage and a centre distance, mm -> its outlines set against each other.
Engage = Callable[[Any, float], Engaged]


def cycle(engaged: Engaged, free_angle: float, teeth: int, pitch_radius: float) -> tuple[float, float]:
    """Greatest overlap just within the computed play and least just past it, mm², over a whole pitch.

    Just is `PLAY_LIMIT_UM`. The outlines may be the exact ones or those of a file.

    Args:
        engaged: the outlines.
        free_angle: computed play at the driven wheel, rad.
        teeth: of the driver.
        pitch_radius: of the driven wheel, mm.
    """
    half, margin = free_angle / 2, PLAY_LIMIT_UM * 1e-3 / pitch_radius
    within, past = [], []
    for number in range(POSITIONS):
        angle = 2 * pi / teeth * number / POSITIONS
        middle = engaged.middle(angle)
        within += [engaged.overlap(angle, middle + side * max(half - margin, 0.0)) for side in (-1, 1)]
        past += [engaged.overlap(angle, middle + side * (half + margin)) for side in (-1, 1)]
    return max(within), min(past)
