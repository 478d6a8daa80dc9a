"""Places that a frame's parts go by: heights of base, platform and block, openings of the base, screws in edges."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, inf, sqrt

import numpy as np
import shapely

from cadgen.car.assembly.arrangement import Arrangement
from cadgen.car.assembly.fork_sizes import (
    BRIDGE_HEIGHT,
    BRIDGE_LENGTH,
    CHEEK,
    FRONT_WIDTH,
    GAP,
    HEAD_HALF,
    SPINDLE,
    front_radius,
    hub_width,
)
from cadgen.car.assembly.frame.frame_sizes import STEP, FrameSizes
from cadgen.car.assembly.panels import THREAD_END
from cadgen.car.assembly.site import STEERING_STEPS, CarSite, OnShaft
from cadgen.car.assembly.standard_parts import Bearing, screw_length, smallest_bearing

NUT_PLAY = 0.2  # mm of a nut in its slot
_RIM = 1.5  # walls of material round a seat, where nothing else decides
_SPACERS = (5, 6, 8, 10, 12, 15, 16, 18, 20, 25, 30, 35, 40, 45, 50, 60, 70, 80)  # mm, lengths that are sold
_LEAST_OPENING = 8.0  # mm, of an opening of the base along the car: cutters pass


@dataclass(frozen=True, eq=False)
class FrameGround:
    """Places that a frame's parts go by.

    Attributes:
        sizes: what the design states.
        site: what stands in the car.
        found: train at its place.
        shafts: round bodies on every shaft.
        bores: diameter of every shaft, mm.
        stated_top: height y of the base's upper face, mm; None for the highest that the bearings allow.
    """

    sizes: FrameSizes
    site: CarSite
    found: Arrangement
    shafts: Sequence[Sequence[OnShaft]]
    bores: Sequence[float]
    stated_top: float | None = None

    @property
    def rim(self) -> float:
        """Material round a seat, mm."""
        return _RIM * self.sizes.wall

    @property
    def low(self) -> list[float]:
        """Heights of the right faces of both bearing plates, the lower one first, mm."""
        return sorted(z - self.site.plate / 2 for z in (self.found.place.near, self.found.place.far))

    @property
    def axle(self) -> complex:
        """Rear axle, x and y, mm."""
        return self.found.axes[0]

    @cached_property
    def fork_bearing(self) -> Bearing:
        """Bearing of the fork's spindle."""
        return smallest_bearing(SPINDLE, inf) or Bearing("", SPINDLE, 2 * SPINDLE, SPINDLE)

    @property
    def ceiling(self) -> float:
        """Height y of the block's upper face, mm."""
        return HEAD_HALF + self.site.clearance

    @property
    def wheel(self) -> float:
        """Radius of the front wheel, mm."""
        return front_radius(self.site, self.found.height)

    @property
    def _lowest(self) -> float:
        """Height y of the platform's lower face at the lowest, mm."""
        bridge = self.found.height - 2 * self.wheel - GAP - BRIDGE_HEIGHT
        return bridge - self.site.clearance - self.sizes.screw.head_height

    @cached_property
    def top(self) -> float:
        """Height y of the base's upper face, mm."""
        return self._base_top(self._lowest) if self.stated_top is None else self.stated_top

    @cached_property
    def spacer(self) -> float:
        """Length of the platform's spacers, mm."""
        return float(next((each for each in _SPACERS if each >= self.top - self._lowest - 1e-9), _SPACERS[-1]))

    @cached_property
    def swept(self) -> tuple[float, float]:
        """Half of the lengths along and across the car that fork and front wheel need in the base, mm."""
        site, hub = self.site, hub_width(self.site) / 2 + CHEEK
        angles = np.linspace(*site.wheel_angles, STEERING_STEPS + 1)
        c, s = np.cos(angles), np.abs(np.sin(angles))
        # Of the wheel as much as the base meets.
        over = max(self.found.height - self.wheel - self.top - self.sizes.base, 0.0)
        chord = sqrt(max(self.wheel**2 - over**2, 0.0))
        boxes = ((BRIDGE_LENGTH / 2, hub), (chord, (site.front_width or FRONT_WIDTH) / 2))
        margin = site.clearance + self.sizes.travel / 2
        along = max(float((long * c + wide * s).max()) for long, wide in boxes) + margin
        across = max(float((long * s + wide * c).max()) for long, wide in boxes) + site.clearance
        return ceil(along / STEP) * STEP, ceil(across / STEP) * STEP

    @cached_property
    def openings(self) -> list[shapely.Polygon]:
        """Openings of the base for what reaches down to it, that for fork and front wheel last."""
        u, v, (along, across) = -self.site.base_radius, -self.site.fork, self.swept
        return [*self._dips(), shapely.box(u - along, v - across, u + along, v + across)]

    @property
    def open_plate(self) -> float:
        """Height of the middle of the plate that the rear axle passes without a bearing, mm.

        A third bearing beside that of the other plate and that of the idle bracket would bend the axle wherever the
        three are not in line.
        """
        return min(self.found.place.near, self.found.place.far, key=lambda z: abs(z - self.site.idle_wheel))

    @property
    def screw_length(self) -> float:
        """Length of the screws from below into the sheets, mm."""
        sizes = self.sizes
        inside = sizes.screw.least_length if sizes.tapped else sizes.wall + sizes.screw.nut_height + 1.0
        return screw_length(sizes.base + inside)

    @property
    def screw_depth(self) -> float:
        """Depth of what a screw needs in a sheet, with the wall behind it, mm."""
        return self.screw_length - self.sizes.base + THREAD_END + self.sizes.wall

    @property
    def nut_half(self) -> float:
        """Half of the width of what a screw needs in a sheet, mm."""
        screw = self.sizes.screw
        return screw.diameter / 2 if self.sizes.tapped else (screw.nut_width + NUT_PLAY) / 2

    def _base_top(self, platform: float) -> float:
        """Height y of the base's upper face: as high as seats and spacers allow, or as stated.

        Args:
            platform: height y of the platform's lower face at the lowest, mm.
        """
        if self.sizes.base_height is not None:
            return self.found.height - self.sizes.base_height - self.sizes.base
        # Of shafts that have a seat in both plates.
        shafts = zip(self.found.axes, self.site.bearings, self.site.ending, strict=True)
        seats = [axis.imag + diameter / 2 + self.rim for axis, diameter, ends in shafts if diameter and not ends]
        stem = platform - self.sizes.base / 2 + self.sizes.stem / 2 + self.rim
        return ceil(max(*seats, platform - _SPACERS[0], stem if self.sizes.stem else 0.0) / STEP - 1e-9) * STEP

    def _dips(self) -> Iterator[shapely.Polygon]:
        """Openings of the base for bodies that reach down to it, in the base's own frame."""
        keep, train = self.site.clearance, []
        for axis, bodies in zip(self.found.axes, self.shafts, strict=True):
            for body, of_train in bodies:
                reach, deep = body.radius + keep, self.top - axis.imag
                if reach <= deep:
                    continue
                half = max(sqrt(reach**2 - max(deep, 0.0) ** 2), _LEAST_OPENING / 2)
                box = shapely.box(-axis.real - half, -body.high - keep, -axis.real + half, -body.low + keep)
                if of_train:
                    train.append(box)
                else:
                    yield box
        if train:  # one opening for all gears, which a saw or a laser cuts at once
            yield shapely.box(*shapely.union_all(train).bounds)
