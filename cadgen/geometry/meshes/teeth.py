"""Play and clearances measured on the teeth themselves, by overlapping their transverse sections.

A section is a polygon whose corners lie on the tooth curves; two of them overlap where the teeth do, which
manifold3d finds exactly. No formula of the involute is used here, so the figures of the formulas can fail.

Error of a measured play: a chord lies inside a convex flank by at most its tolerance ε. Both gears together seem to
have up to 2 ε more room along the normal on each side, 4 ε / cos α_w on the pitch circle: 0.04 µm at
`CHORD_TOLERANCE`. Overlaps below `LEAST_OVERLAP` are not seen; where they begin the teeth are pressed into each
other by less than 0.005 µm, and the search stops at `ANGLE_STEP`, 0.005 µm on a wheel of 1 m.

The wheels stand on the x axis here: the driver's axis at 0, the driven gear's at the centre distance. Of a ring the
section is that of its hole, and a pinion overlaps it where it stands out of that hole.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import asin, ceil, pi

import manifold3d
import numpy as np

from cadgen.errors import CheckError
from cadgen.gears.rack import RackForm
from cadgen.gears.stage import LEAST_OVERLAP, Stage, Wheel, is_ring
from cadgen.messages import Message
from cadgen.parts.loop import Points

# Greatest distance of a section's chords from the tooth curves, in mm.
CHORD_TOLERANCE = 1e-5
# At which the search for a limit of the play stops, in rad.
ANGLE_STEP = 1e-8
# Teeth to either side of the line of centres: a contact ratio below 3 needs no more.
TEETH_BESIDE = 2
# In a ring tips may foul each other far from the line of action, and the ring must reach past the pinion's last tooth.
# Of a smaller pinion all teeth are looked at.
TEETH_INSIDE, RING_BEYOND = 7, 3


@dataclass(frozen=True, slots=True, eq=False)
class ToothSection:
    """Transverse section of a gear: corners by tooth, counter-clockwise, shape (teeth, n); a tooth on the x axis.

    Of a `ring` it is that of its hole.
    """

    corners: Points
    ring: bool = False

    @property
    def teeth(self) -> int:
        """Number of teeth."""
        return len(self.corners)

    @property
    def tip_radius(self) -> float:
        """Distance of the tips from the axis, in mm: the greatest of a corner, of a ring the least."""
        return float(np.abs(self.corners).min() if self.ring else np.abs(self.corners).max())

    @property
    def root_radius(self) -> float:
        """Distance of the roots from the axis, in mm: the least of a corner, of a ring the greatest."""
        return float(np.abs(self.corners).max() if self.ring else np.abs(self.corners).min())

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


class MeasuredMesh(ABC):
    """Two sections in mesh, of which the driven one is turned, or moved, while the driver stands still."""

    __slots__ = ()

    driver: ToothSection
    driven: ToothSection
    centre_distance: float

    @property
    @abstractmethod
    def half_pitch(self) -> float:
        """Half a pitch as an angle of the driven gear, rad."""

    @property
    @abstractmethod
    def internal(self) -> bool:
        """Whether the driven gear turns the same way as the driver."""

    @abstractmethod
    def middle(self, driver_angle: float) -> float:
        """Angle of the driven gear with its teeth midway between the driver's, in rad, continuous.

        Args:
            driver_angle: angle of the driver, rad.
        """

    @abstractmethod
    def overlap(self, driver_angle: float, driven_angle: float) -> float:
        """Overlap of both sections in mm².

        Args:
            driver_angle: angle of the driver, rad.
            driven_angle: angle of the driven gear, rad.
        """

    @abstractmethod
    def clearances(self) -> tuple[float, float]:
        """Gap in mm between the driver's tips and the driven gear's roots, and the other way round."""

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
        return self.overlap(driver_angle, self.middle(driver_angle) + self.half_pitch)

    def limit(self, driver_angle: float, side: int) -> float:
        """Angle in rad at which the driven gear, turned from the middle to `side` (±1), begins to overlap the driver.

        Raises `CheckError` if it overlaps already, or not even half a pitch from the middle.

        Args:
            driver_angle: angle of the driver, rad.
            side: direction of the turn, 1 or -1.
        """
        middle = self.middle(driver_angle)
        free, blocked = 0.0, self.half_pitch
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

    def _fault(self, fault: Message) -> Message:
        return Message(
            "the sections with {driver} and {driven} teeth at {apart:g} mm {fault}",
            driver=self.driver.teeth,
            driven=self.driven.teeth,
            apart=self.centre_distance,
            fault=fault,
        )


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredPair(MeasuredMesh):
    """Two sections in mesh at a centre distance in mm."""

    driver: ToothSection
    driven: ToothSection
    centre_distance: float

    @property
    def internal(self) -> bool:
        """Whether one of both is a ring."""
        return self.driver.ring or self.driven.ring

    @property
    def half_pitch(self) -> float:
        """Half a pitch of the driven gear, rad."""
        return pi / self.driven.teeth

    @property
    def towards(self) -> tuple[float, float]:
        """Directions from the axes of driver and driven gear in which their teeth meet, rad."""
        if not self.internal:
            return 0.0, pi
        # Beside the pinion's axis, away from that of the ring.
        return (0.0, 0.0) if self.driver.ring else (pi, pi)

    @property
    def driven_pitch_radius(self) -> float:
        """Radius of the driven gear's working pitch circle in mm."""
        other = -self.driver.teeth if self.internal else self.driver.teeth
        return self.centre_distance * self.driven.teeth / abs(other + self.driven.teeth)

    def middle(self, driver_angle: float) -> float:
        """Angle of the driven gear with its teeth midway between the driver's, in rad, continuous.

        Args:
            driver_angle: angle of the driver, rad.
        """
        if self.internal:
            towards, _ = self.towards
            return towards + (self.driver.teeth * (driver_angle - towards) + pi) / self.driven.teeth
        return pi + (pi - self.driver.teeth * driver_angle) / self.driven.teeth

    def overlap(self, driver_angle: float, driven_angle: float) -> float:
        """Overlap of both sections in mm².

        Args:
            driver_angle: angle of the driver, rad.
            driven_angle: angle of the driven gear, rad.
        """
        ahead, back = self.towards
        one = _driver_section(self.driver, driver_angle, ahead, self._beside(self.driver))
        other = _section(
            self.centre_distance + self.driven.teeth_towards(driven_angle, back, self._beside(self.driven))
        )
        if not self.internal:
            return float((one ^ other).area())
        return float((other - one if self.driver.ring else one - other).area())

    def _beside(self, section: ToothSection) -> int:
        """Teeth of a section to either side of the line of centres that are looked at."""
        if not self.internal:
            return TEETH_BESIDE
        pinion = self.driven if self.driver.ring else self.driver
        if pinion.teeth > 2 * (2 * TEETH_INSIDE + 1):  # no more than a quarter of a turn to either side
            return TEETH_INSIDE + RING_BEYOND if section.ring else TEETH_INSIDE
        if not section.ring or pinion.tip_radius >= self.centre_distance:  # it reaches over the ring's axis
            return section.teeth
        # As far as all of the pinion is seen from the ring's axis, lest it stands out of what is left of the hole.
        seen = asin(pinion.tip_radius / self.centre_distance)
        return ceil(seen / (2 * pi) * section.teeth) + RING_BEYOND

    def clearances(self) -> tuple[float, float]:
        """Gap in mm between the driver's tips and the driven gear's roots, and the other way round."""
        if self.internal:
            pinion, ring = (self.driven, self.driver) if self.driver.ring else (self.driver, self.driven)
            return (
                ring.root_radius - self.centre_distance - pinion.tip_radius,
                ring.tip_radius - self.centre_distance - pinion.root_radius,
            )
        return (
            self.centre_distance - self.driver.tip_radius - self.driven.root_radius,
            self.centre_distance - self.driven.tip_radius - self.driver.root_radius,
        )


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredRack(MeasuredMesh):
    """A pinion and the section of a rack, whose reference line stands so many mm off; angles are those of the pinion.

    The rack's corners are those of its bar, its teeth towards y.
    """

    driver: ToothSection
    driven: ToothSection
    centre_distance: float
    rack: RackForm

    @property
    def half_pitch(self) -> float:
        """Half a pitch as an angle of the pinion, rad."""
        return pi / self.driver.teeth

    @property
    def internal(self) -> bool:
        """Whether it goes along with the pinion: it does."""
        return True

    @property
    def pitch_radius(self) -> float:
        """Radius of the pinion that rolls on the rack, mm."""
        return self.rack.pitch * self.driver.teeth / (2 * pi)

    def middle(self, driver_angle: float) -> float:
        """Angle by which the rack has gone along, which is that of the pinion, rad.

        Args:
            driver_angle: angle of the pinion, rad.
        """
        return driver_angle

    def overlap(self, driver_angle: float, driven_angle: float) -> float:
        """Overlap of both sections in mm².

        Args:
            driver_angle: angle of the pinion, rad.
            driven_angle: travel of the rack as an angle of the pinion, rad.
        """
        # Whole pitches of both change nothing but how far the bar has to reach.
        pitches = round(driver_angle / (2 * self.half_pitch)) * 2 * self.half_pitch
        pinion = _section(self.driver.corners.ravel() * np.exp(1j * (driver_angle - pitches)))
        # A space near the middle of the bar stands at the foot of the pinion's axis.
        space = round(self.rack.teeth / 2) * self.rack.pitch
        turned = self.driven.corners.ravel() - space
        bar = _section(self.centre_distance + 1j * (turned + self.pitch_radius * (driven_angle - pitches)))
        return float((pinion ^ bar).area())

    def clearances(self) -> tuple[float, float]:
        """Gap in mm between the pinion's tips and the rack's roots, and the other way round."""
        heights = np.unique(np.round(self.driven.corners.imag, 9))
        root, tip = heights[1], heights[-1]
        return (
            float(self.centre_distance - root - self.driver.tip_radius),
            float(self.centre_distance - tip - self.driver.root_radius),
        )


def section_of(wheel: Wheel, chord_tolerance: float = CHORD_TOLERANCE) -> ToothSection:
    """Section of a wheel from its exact curves, by chords no further off than `chord_tolerance`, mm.

    Args:
        wheel: gear with its place on a part.
        chord_tolerance: greatest distance of a chord from a curve, mm.
    """
    outline = wheel.outline
    corners = outline.polygon(chord_tolerance).reshape(outline.repeats, -1)
    return ToothSection(corners, is_ring(wheel))


def measured_pair(stage: Stage, centre_distance: float | None = None) -> MeasuredMesh:
    """A stage by its exact curves, as cut, at its own centre distance or at another one, mm.

    Args:
        stage: stage of gears.
        centre_distance: distance of the axes, mm; the stage's own if left out.
    """
    apart = stage.centre_distance if centre_distance is None else centre_distance
    driver, driven = stage.wheels
    return sections_in_mesh(stage, section_of(driver), section_of(driven), apart)


def sections_in_mesh(
    stage: Stage, driver: ToothSection, driven: ToothSection, centre_distance: float | None = None
) -> MeasuredMesh:
    """Sections of a stage, exact ones or those of files, set against each other.

    Args:
        stage: stage of gears.
        driver, driven: sections of its wheels.
        centre_distance: distance of the axes, mm; the stage's own if left out.
    """
    apart = stage.centre_distance if centre_distance is None else centre_distance
    rack = getattr(stage.wheels[1], "bar", None)
    return MeasuredPair(driver, driven, apart) if rack is None else MeasuredRack(driver, driven, apart, rack)


def return_error(stages: Sequence[MeasuredMesh], drive_angle: float = 0.0) -> float:
    """Free angle of the output while the drive stands still, in rad, through all stages.

    Every stage is held against one flank after the other at the angle that the stage before leaves it; the shafts of
    gears side by side turn against each other, so the driver's last angle gives the driven gear's first.

    Args:
        stages: stages from the drive to the output.
        drive_angle: angle of the drive, rad.
    """
    low = high = drive_angle
    for stage in stages:
        ends = (low, high) if stage.internal else (high, low)
        low, high = stage.limit(ends[0], -1), stage.limit(ends[1], 1)
    return high - low


@lru_cache(maxsize=8)  # the driver is held while the driven gear is turned
def _driver_section(driver: ToothSection, angle: float, towards: float, beside: int) -> manifold3d.CrossSection:
    return _section(driver.teeth_towards(angle, towards, beside))


def _section(points: Points) -> manifold3d.CrossSection:
    return manifold3d.CrossSection([np.column_stack([points.real, points.imag])])
