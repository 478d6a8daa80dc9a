"""Play and clearances measured on the teeth themselves, by overlapping their transverse sections.

A section is a polygon whose corners lie on the tooth curves; two of them overlap where the teeth do, which
manifold3d finds exactly. No formula of the involute is used here, so the figures of the formulas can fail.

Error of a measured play: a chord lies inside a convex flank by at most its tolerance ε. Both gears together seem to
have up to 2 ε more room along the normal on each side, 4 ε / cos α_w on the pitch circle: 0.04 µm at
`CHORD_TOLERANCE`. Overlaps below `LEAST_OVERLAP` are not seen; where they begin the teeth are pressed into each
other by less than 0.005 µm, and the search stops at `ANGLE_STEP`, 0.005 µm on a wheel of 1 m.

The wheels stand on the x axis here: the driver's axis at 0, the driven gear's at the centre distance.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import pi

import manifold3d
import numpy as np

from cadgen.errors import CheckError
from cadgen.gears.stage import LEAST_OVERLAP, Stage, Wheel
from cadgen.messages import Message
from cadgen.parts.loop import Points

# Greatest distance of a section's chords from the tooth curves, in mm.
CHORD_TOLERANCE = 1e-5
# At which the search for a limit of the play stops, in rad.
ANGLE_STEP = 1e-8
# Teeth to either side of the line of centres: a contact ratio below 3 needs no more.
TEETH_BESIDE = 2


@dataclass(frozen=True, slots=True, eq=False)
class ToothSection:
    """Transverse section of a gear: corners by tooth, counter-clockwise, shape (teeth, n); tooth 0 on the x axis."""

    corners: Points

    @property
    def teeth(self) -> int:
        """Number of teeth."""
        return len(self.corners)

    @property
    def tip_radius(self) -> float:
        """Greatest distance of a corner from the axis, in mm."""
        return float(np.abs(self.corners).max())

    @property
    def root_radius(self) -> float:
        """Least distance of a corner from the axis, in mm."""
        return float(np.abs(self.corners).min())

    def teeth_towards(self, angle: float, towards: float, beside: int = TEETH_BESIDE) -> Points:
        """Outline of the teeth that point `towards` (rad) when the gear stands at `angle`, closed over its axis.

        Args:
            angle: angle of the gear, rad.
            towards: direction of the teeth, rad.
            beside: number of teeth on either side.
        """
        if 2 * beside + 1 >= self.teeth:
            return np.asarray(self.corners.ravel() * np.exp(1j * angle))
        middle = round((towards - angle) * self.teeth / (2 * pi))
        rows = (np.arange(-beside, beside + 1) + middle) % self.teeth
        return np.append(self.corners[rows].ravel() * np.exp(1j * angle), 0j)


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredPair:
    """Two sections in mesh at a centre distance in mm."""

    driver: ToothSection
    driven: ToothSection
    centre_distance: float

    @property
    def driven_pitch_radius(self) -> float:
        """Radius of the driven gear's working pitch circle in mm."""
        return self.centre_distance * self.driven.teeth / (self.driver.teeth + self.driven.teeth)

    def middle(self, driver_angle: float) -> float:
        """Angle of the driven gear with its teeth midway between the driver's, in rad, continuous.

        Args:
            driver_angle: angle of the driver, rad.
        """
        return pi + (pi - self.driver.teeth * driver_angle) / self.driven.teeth

    def overlap(self, driver_angle: float, driven_angle: float) -> float:
        """Overlap of both sections in mm².

        Args:
            driver_angle: angle of the driver, rad.
            driven_angle: angle of the driven gear, rad.
        """
        driven = self.centre_distance + self.driven.teeth_towards(driven_angle, pi)
        return float((_driver_section(self.driver, driver_angle) ^ _section(driven)).area())

    def overlap_midway(self, driver_angle: float) -> float:
        """Overlap in mm² with the teeth midway between the other's: above `LEAST_OVERLAP` they jam.

        Args:
            driver_angle: angle of the driver, rad.
        """
        return self.overlap(driver_angle, self.middle(driver_angle))

    def overlap_tooth_on_tooth(self, driver_angle: float) -> float:
        """Overlap in mm² half a pitch on: up to `LEAST_OVERLAP` the teeth do not hold each other.

        Args:
            driver_angle: angle of the driver, rad.
        """
        return self.overlap(driver_angle, self.middle(driver_angle) + pi / self.driven.teeth)

    def limit(self, driver_angle: float, side: int) -> float:
        """Angle in rad at which the driven gear, turned from the middle to `side` (±1), begins to overlap the driver.

        Raises `CheckError` if it overlaps already, or not even half a pitch from the middle.

        Args:
            driver_angle: angle of the driver, rad.
            side: direction of the turn, 1 or -1.
        """
        middle = self.middle(driver_angle)
        free, blocked = 0.0, pi / self.driven.teeth
        if self.overlap_midway(driver_angle) > LEAST_OVERLAP:
            raise CheckError(
                self._fault(Message("overlap midway between their flanks; thin the teeth, or set the axes apart"))
            )
        if self.overlap_tooth_on_tooth(driver_angle) <= LEAST_OVERLAP:
            raise CheckError(self._fault(Message("pass each other freely; set the axes closer")))
        while blocked - free > ANGLE_STEP:
            turned = (free + blocked) / 2
            if self.overlap(driver_angle, middle + side * turned) > LEAST_OVERLAP:
                blocked = turned
            else:
                free = turned
        return middle + side * (free + blocked) / 2

    def play(self, driver_angle: float) -> float:
        """Free angle of the driven gear while the driver stands still, in rad.

        Args:
            driver_angle: angle of the driver, rad.
        """
        return self.limit(driver_angle, 1) - self.limit(driver_angle, -1)

    def clearances(self) -> tuple[float, float]:
        """Gap in mm between the driver's tips and the driven gear's roots, and the other way round."""
        return (
            self.centre_distance - self.driver.tip_radius - self.driven.root_radius,
            self.centre_distance - self.driven.tip_radius - self.driver.root_radius,
        )

    def _fault(self, fault: Message) -> Message:
        return Message(
            "the sections with {driver} and {driven} teeth at {apart:g} mm {fault}",
            driver=self.driver.teeth,
            driven=self.driven.teeth,
            apart=self.centre_distance,
            fault=fault,
        )


def section_of(wheel: Wheel, chord_tolerance: float = CHORD_TOLERANCE) -> ToothSection:
    """Section of a wheel from its exact curves, by chords no further off than `chord_tolerance`, mm.

    Args:
        wheel: gear with its place on a part.
        chord_tolerance: greatest distance of a chord from a curve, mm.
    """
    outline = wheel.outline
    return ToothSection(outline.polygon(chord_tolerance).reshape(outline.repeats, -1))


def measured_pair(stage: Stage, centre_distance: float | None = None) -> MeasuredPair:
    """A stage by its exact curves, as cut, at its own centre distance or at another one, mm.

    Args:
        stage: stage of gears.
        centre_distance: distance of the axes, mm; the stage's own if left out.
    """
    apart = stage.centre_distance if centre_distance is None else centre_distance
    driver, driven = stage.wheels
    return MeasuredPair(section_of(driver), section_of(driven), apart)


def return_error(stages: Sequence[MeasuredPair], drive_angle: float = 0.0) -> float:
    """Free angle of the output while the drive stands still, in rad, through all stages.

    Every stage is held against one flank after the other at the angle that the stage before leaves it; the
    shafts turn against each other, so the driver's last angle gives the driven gear's first.

    Args:
        stages: stages from the drive to the output.
        drive_angle: angle of the drive, rad.
    """
    low = high = drive_angle
    for stage in stages:
        low, high = stage.limit(high, -1), stage.limit(low, 1)
    return high - low


@lru_cache(maxsize=8)  # the driver is held while the driven gear is turned
def _driver_section(driver: ToothSection, angle: float) -> manifold3d.CrossSection:
    return _section(driver.teeth_towards(angle, 0.0))


def _section(points: Points) -> manifold3d.CrossSection:
    return manifold3d.CrossSection([np.column_stack([points.real, points.imag])])
