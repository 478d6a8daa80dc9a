"""A stage of a train of any kind: an arrangement in which one wheel turns another, with a signed ratio.

The train, its play, its layout, its checks and its files go by this and by nothing else. Spur gears are the first kind
(`spur`): two wheels on parallel axes. In a planetary set (`planetary_stage`) both turn about one axis, and planets and
a member that is held stand beside them. Friction discs, which have no teeth, are that of the how-to page. `Engaged` is
what the checks of a stage measure on two wheels set against each other; the meshes room finds it on their outlines.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import Any, Protocol, Self, runtime_checkable

from cadgen.check import Check
from cadgen.figures import Facts, Figures
from cadgen.gears.choices import Law
from cadgen.gears.distribution import ZoneSum
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.loop import Loop

# Overlap in mm² below which teeth only touch: ten times the rounding of the sections' common area (1e-8 mm).
LEAST_OVERLAP = 1e-8
# What a measured play may differ from the computed one, µm of arc on the driven wheel's pitch circle.
PLAY_LIMIT_UM = 0.5
# What to do about a figure that only an error of the program can spoil.
CONTRADICTION = Message("the teeth contradict the formulas: report this design")
# Positions of the driver over one pitch at which the teeth are set against each other.
POSITIONS = 8


class Engaged(Protocol):
    """Outlines of two wheels in mesh: the driver's axis at 0, the driven wheel's on x; angles are the wheels', rad."""

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
        """Common area at `middle`, mm²: above `LEAST_OVERLAP` the teeth jam.

        Args:
            driver_angle: angle of the driver, rad.
        """

    def overlap_tooth_on_tooth(self, driver_angle: float) -> float:
        """Common area half a pitch on, mm²: up to `LEAST_OVERLAP` the teeth do not hold each other.

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


class Wheel(Protocol):
    """Wheel of a stage, without what it has besides its rim; its own axis at the origin.

    `str` of it names it at the head of a sentence.
    """

    @property
    def width(self) -> float:
        """Width of the face, mm."""

    @property
    def tip_diameter(self) -> float:
        """Diameter of the circle that holds the rim, mm."""

    @property
    def root_diameter(self) -> float:
        """Diameter of the circle that the rim leaves whole, mm; of a plain disc, its own."""

    @property
    def least_rim(self) -> float:
        """Least wall under that circle, mm."""

    @property
    def outline(self) -> Loop:
        """Section of the rim midway along its width as it is made, with its first pitch about the x axis.

        Its run says how it turns along the axis.

        Raises:
            DesignError: it cannot be made.
        """

    @property
    def noun(self) -> str:
        """Name of the wheel's body in messages: `the gear of 20 teeth`."""

    @property
    def usual_chord(self) -> float:
        """Greatest chord error of its mesh where none is given, mm."""


@runtime_checkable
class WithHoles(Protocol):
    """Wheel with holes through its face besides its bore, as a carrier has them for the pins of its planets."""

    @property
    def holes(self) -> tuple[Loop, ...]:
        """Holes through the face; none where the pins have no diameter."""


def holes_of(wheel: Wheel) -> tuple[Loop, ...]:
    """Holes through the face of a wheel besides its bore; none of most wheels."""
    return wheel.holes if isinstance(wheel, WithHoles) else ()


def is_ring(wheel: Wheel) -> bool:
    """Whether the rim of a wheel is round its teeth: its outline is then that of its hole."""
    return getattr(wheel, "side", 1) < 0


def rim_diameter(wheel: Wheel) -> float:
    """Diameter of the circle that holds the whole rim, mm: the tips' but for a ring."""
    return float(getattr(wheel, "rim_diameter", wheel.tip_diameter))


def is_bar(wheel: Wheel) -> bool:
    """Whether a wheel is a straight bar, as a rack is, which travels and does not turn."""
    return hasattr(wheel, "bar")


class PlayZone(Protocol):
    """Play of a stage at its driven shaft: a zone, and how it is distributed in it."""

    @property
    def B_min(self) -> float:  # noqa: N802
        """Least free angle of the driven wheel, rad; below 0 the stage may jam."""

    @property
    def B_max(self) -> float:  # noqa: N802
        """Greatest free angle of the driven wheel, rad."""

    def distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Independent contributions to the play, as arcs of the driven wheel's pitch circle, mm."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Standing:
    """Body of a stage that stands beside its driver and its driven wheel: a planet, or the member that is held.

    Attributes:
        name: its name in those of its part and files, such as `planet_1`.
        wheel: its rim.
        blank: what it has besides its rim.
        axis: its axis from that of the driver, mm.
        angle: its angle about its axis, rad.
        rise: height of its middle over that of the driver, mm.
        figures: number of its figures in those of the stage's wheels.
        turns: its turning for one of the driver and for one of the driven wheel, which add up.
        orbits: whether its axis goes round with the driven wheel.
    """

    name: str
    wheel: Wheel
    blank: Blank
    axis: complex
    angle: float
    figures: int
    rise: float = 0.0
    turns: tuple[float, float] = (0.0, 0.0)
    orbits: bool = False


@dataclass(frozen=True, slots=True)
class Mating:
    """Two wheels of a stage in mesh, as a stage of their own, and their numbers among its wheels.

    Numbers 0 and 1 are driver and driven wheel of the stage; from 2 on they are those of `Standing.figures`.
    """

    pair: Stage
    driver: int = 0
    driven: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Departure:
    """An overridden tolerance: `used` in place of `standard`, in mm (None: no standard covers the size)."""

    where: str
    symbol: str
    used: float
    standard: float | None


class Stage(ABC):
    """Stage of a train: a driver turns a driven wheel, perhaps by other bodies that stand beside them.

    What has a body here holds for stages without teeth and tolerances.

    Attributes:
        centre_distance: of the axes, mm.
        bearing_span: between the bearings of either shaft, mm.
    """

    __slots__ = ()

    centre_distance: float
    bearing_span: float

    @property
    @abstractmethod
    def noun(self) -> str:
        """Name of what it consists of: `spur gears`."""

    @property
    def sense(self) -> int:
        """-1 where the driven wheel turns against the driver, +1 where it turns with it: the sign of the ratio."""
        return -1

    @property
    @abstractmethod
    def wheels(self) -> tuple[Wheel, Wheel]:
        """Driver and driven wheel."""

    @property
    @abstractmethod
    def ratio(self) -> Fraction:
        """i: turns of the driver per turn of the driven wheel, without its sign, which is `sense`."""

    @property
    @abstractmethod
    def driven_pitch_radius(self) -> float:
        """Radius at which the driven wheel is driven, mm: play and errors are arcs of this circle."""

    @property
    @abstractmethod
    def label(self) -> str:
        """Driver and driven wheel in a table, such as the teeth of both: `20/60`."""

    @property
    def module(self) -> float | None:
        """Module of the teeth, mm; None without teeth."""
        return None

    @abstractmethod
    def play(self) -> PlayZone:
        """Play of the stage.

        Raises:
            DesignError: it cannot be known.
        """

    @abstractmethod
    def free_angle(self) -> float:
        """Play at the driven shaft as it is made, its sizes in the middle, rad."""

    def opened(self, clearance: float) -> float:
        """Play that axes further apart by as much, mm, add at the driven shaft, rad; none where they are pressed on.

        Args:
            clearance: growth of the distance of the axes, mm.
        """
        return 0.0

    def as_cut(self) -> Self:
        """The stage as it is made for the play it is to have.

        Raises:
            DesignError: it cannot be made.
        """
        return self

    def by_the_standard(self) -> Self:
        """Stage without tolerances of its own."""
        return self

    def departures(self, number: int) -> tuple[Departure, ...]:
        """Tolerances of its own, beside those of the standard; `number` is that of the stage, from 1."""
        return ()

    @abstractmethod
    def driven_angle(self, driver_angle: float, direction: float) -> float:
        """Angle of the driven wheel in mesh with a driver at an angle, rad.

        Args:
            driver_angle: of the driver, rad.
            direction: from the driver's axis to that of the driven wheel, rad.
        """

    def efficiency(self, friction: float) -> float | None:
        """Share of the power that the teeth pass on, bearings not counted; None where that is not known.

        Args:
            friction: friction coefficient μ of the flanks.
        """
        return None

    def driven_shift(self, driver_angle: float, direction: float) -> complex:
        """Way from where the driven wheel's axis is to the origin of its own frame, mm; none but of a bar.

        Args:
            driver_angle: angle of the driver, rad.
            direction: from the driver's axis to that of the driven wheel, rad.
        """
        return 0j

    @property
    def toothed(self) -> bool:
        """Whether its play is the room between flanks, which can be measured on the outlines of both wheels."""
        return False

    def meshes(self, engage: Engage) -> bool:
        """Whether its flanks, as made, hold each other with some play all the time; `engage` as of `checks`."""
        return False

    @property
    def rise(self) -> float:
        """Height of the driven wheel's middle over that of the driver, mm."""
        return 0.0

    @property
    def begins(self) -> float:
        """Height of the driver's middle over the lowest of what is in mesh, mm, where the stage is the first one."""
        return self.wheels[1].width / 2

    @property
    def stands_out(self) -> tuple[float, float]:
        """Height by which others stand out under the driver and over the driven wheel, mm; below 0 if they do not."""
        driver, driven = self.wheels
        return (driven.width - driver.width) / 2, (driver.width - driven.width) / 2

    def standing(self, driver_angle: float, direction: float) -> tuple[Standing, ...]:
        """Bodies beside driver and driven wheel, in their places; none of a pair.

        Args:
            driver_angle: angle of the driver, rad.
            direction: direction of the stage, rad.
        """
        return ()

    @property
    def matings(self) -> tuple[Mating, ...]:
        """Wheels in mesh, two by two: of a pair, itself; none without teeth."""
        return (Mating(self),) if self.toothed else ()

    def free_angle_of(self, free: Sequence[float]) -> float:
        """Free angle of the driven wheel, rad, from those of the driven wheels of its `matings`, rad.

        Args:
            free: free angles, rad, in the order of the matings.
        """
        return free[0]

    @abstractmethod
    def checks(self, engage: Engage) -> tuple[Check, ...]:
        """Figures of the stage as it is made, with limits and verdicts; of one code there is one.

        Args:
            engage: a stage, perhaps of another thickness, and a centre distance, mm -> its outlines set against each
                other.
        """

    def notes(self, number: int) -> tuple[str, ...]:
        """Remarks on the stage as it is made, a sentence each, in small letters and without a full stop."""
        return ()

    @property
    def grades(self) -> tuple[int | None, int | None]:
        """Grades by ISO 1328 of driver and driven wheel; None for wheels without one."""
        return None, None

    @property
    def distance_deviation(self) -> float | None:
        """Deviation f_a of the axes' distance that the play is computed with, mm; None where there is none."""
        return None

    @abstractmethod
    def entry(self) -> Facts:
        """Facts on the stage as it is made, for the manifest; keys end in the unit."""

    @abstractmethod
    def wheel_figures(self) -> tuple[Figures, ...]:
        """Figures of driver, driven wheel and what stands beside them, as in the table of parts.

        They are what each is made and measured by.

        Raises:
            DesignError: a wheel that it could not measure.
        """
