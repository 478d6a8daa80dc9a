"""Pairs and trains of gears by their numbers, without a design file.

Lengths are mm and angles rad. The teeth are those of `cadgen gears`: exact involutes and trochoids, which every file
is compared with when it is read back.
"""

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import cos, pi
from typing import TYPE_CHECKING

from cadgen.api.assembly import Assembly
from cadgen.api.gear import Gear, require_name
from cadgen.api.values import optional, real, several, word
from cadgen.design.gear_model import usual_chord
from cadgen.design.train import MOST_STAGES
from cadgen.errors import DesignError, brief
from cadgen.gears import pair as numbers
from cadgen.gears import spur
from cadgen.gears import train as numeric
from cadgen.gears.choices import Thinning
from cadgen.gears.contact import contact_ratio
from cadgen.gears.tooth import tooth_of
from cadgen.jobs.gears.plan import GearsPlan as GearsPlan
from cadgen.jobs.gears.plan import NotMadeError as NotMadeError
from cadgen.parts.blank import Blank

if TYPE_CHECKING:
    from cadgen.geometry.solids.gear_solids import Compound
    from cadgen.jobs.gears.numbers import TrainPlan

# mm; of shafts whose bearings nobody has placed. Where the backlash is given no figure depends on it.
_ANY_SPAN = 1000.0


@dataclass(frozen=True)
class GearPair(Assembly):
    """Two gears in mesh, by default at the centre distance at which nominal teeth have no play.

    The teeth are thinned, each gear's by the same amount, until the pair has the backlash asked for. Without one they
    are thinned for their tolerance grade, as `cadgen gears` does, for which the bearings must be placed.

    Attributes:
        pinion, wheel: the gears; a thickness deviation of their own is kept.
        backlash: circumferential backlash, mm: travel of the wheel's working pitch circle while the pinion rests.
        centre_distance: distance of the axes, mm; None for that of nominal teeth without play.
        bearing_span: distance between the bearings of a shaft, mm; needed without a backlash.
        thinning: without a backlash, place of the tooth thickness in the zone of its grade: `least`, `middle` or
            `greatest`.
        centre_distance_deviation: ± deviation of the distance of the axes, mm; None for the standard's.
        name: name of the pair and its files.

    Raises:
        DesignError: gears that do not mesh, a number out of its range, or a tooth that cannot be cut so thin.

    Example:
        >>> from cadgen import Gear, GearPair
        >>> pair = GearPair(Gear(teeth=18, module=1, width=8), Gear(teeth=45, module=1, width=8), backlash=0.1)
        >>> pair.axes_apart
        31.5
        >>> assembly = pair.build123d()  # doctest: +SKIP
    """

    pinion: Gear
    wheel: Gear
    _: KW_ONLY
    backlash: float | None = None
    centre_distance: float | None = None
    bearing_span: float | None = None
    thinning: str = Thinning.MIDDLE
    centre_distance_deviation: float | None = None
    name: str = "pair"

    def __post_init__(self) -> None:
        for name in ("pinion", "wheel"):
            if not isinstance(value := getattr(self, name), Gear):
                raise DesignError(f"{name} is {brief(repr(value), 60)}; it must be a Gear")
        optional("backlash", self.backlash, 0, 100, "mm")
        optional("centre_distance", self.centre_distance, 0, 2000, "mm", above=True)
        optional("bearing_span", self.bearing_span, 0, 5000, "mm", above=True)
        optional("centre_distance_deviation", self.centre_distance_deviation, 0, 10, "mm")
        word("thinning", self.thinning, [place.value for place in Thinning])
        require_name(self.name)
        fixed = [gear.thickness_deviation is not None for gear in (self.pinion, self.wheel)]
        if self.backlash is not None and all(fixed):
            raise DesignError(
                f"backlash is {self.backlash:g} mm and both gears have a thickness_deviation; leave one of the three "
                "out, for two of them decide the third"
            )
        if self.backlash is None and self.bearing_span is None and not all(fixed):
            raise DesignError(
                "backlash is not given; give it in mm, or bearing_span in mm, for which the teeth are then thinned by "
                "their tolerance grade"
            )
        for gear in (self.cut.driver, self.cut.driven):
            tooth_of(gear.form)

    @cached_property
    def nominal(self) -> spur.SpurPair:
        """The pair with the thickness that its teeth are to be cut to."""
        gears = [
            numbers.GradedGear(form=gear.form.cut_to(0.0), grade=gear.grade, overrides=gear.overrides)
            for gear in (self.pinion, self.wheel)
        ]
        apart = self.centre_distance
        pair = spur.SpurPair(
            driver=gears[0],
            driven=gears[1],
            centre_distance=numbers.closest(gears[0].form, gears[1].form) if apart is None else float(apart),
            bearing_span=_ANY_SPAN if self.bearing_span is None else float(self.bearing_span),
            centre_distance_deviation=self.centre_distance_deviation,
        )
        return pair.thinned_to(*self._thinning(pair))

    def _thinning(self, pair: spur.SpurPair) -> tuple[float | Thinning, float | Thinning]:
        """Thickness of the pinion's and of the wheel's teeth: E_sn, mm, or a place in the zone of their grade."""
        fixed = self.pinion.thickness_deviation, self.wheel.thickness_deviation
        if self.backlash is None:
            pinion, wheel = (Thinning(self.thinning) if deviation is None else deviation for deviation in fixed)
            return pinion, wheel
        angle = self.backlash / pair.driven_pitch_radius
        along = angle * pair.driven.form.base_diameter / 2
        both = (pair.normal_backlash(pair.centre_distance) - along) / cos(pair.driver.form.transverse_pressure_angle)
        known = [deviation for deviation in fixed if deviation is not None]
        share = (both - sum(known)) / (2 - len(known))
        pinion, wheel = (share if deviation is None else deviation for deviation in fixed)
        return pinion, wheel

    @cached_property
    def cut(self) -> spur.SpurPair:
        """The pair with its teeth as they are cut."""
        pair = self.nominal
        driver, driven = pair.driver.thinning, pair.driven.thinning
        if isinstance(driver, str) or isinstance(driven, str):
            return spur.spur_pairs(numeric.thinned(numeric.Train((pair,))), "a pair is")[0]
        return pair.cut_to(driver, driven)

    @property
    def axes_apart(self) -> float:
        """Centre distance, mm."""
        return self.nominal.centre_distance

    @property
    def play(self) -> float:
        """Circumferential backlash of the teeth as they are cut, mm of arc of the wheel's working pitch circle."""
        return self.cut.free_angle() * self.cut.driven_pitch_radius

    @property
    def ratio(self) -> Fraction:
        """Turns of the pinion per turn of the wheel."""
        return self.nominal.ratio

    @property
    def contact_ratio(self) -> float:
        """Pairs of teeth in mesh on average, as cut."""
        return contact_ratio(self.cut)

    @property
    def working_pressure_angle(self) -> float:
        """Working pressure angle α_w, rad."""
        return self.nominal.working_pressure_angle

    @property
    def wheel_angle(self) -> float:
        """Angle of a tooth of the wheel, its teeth midway between those of a pinion with a tooth on x, rad."""
        return self.cut.driven_angle(0.0, 0.0)

    @cached_property
    def computed(self) -> "TrainPlan":
        """The pair as a train of one stage, laid out and measured in mesh."""
        return Train([self], name=self.name).computed

    def build123d(self) -> "Compound":
        """Both gears in mesh as one build123d compound, mm: the pinion's axis on z, that of the wheel along x.

        The teeth of the pinion begin at z = 0, and those of the wheel lie midway along them; hubs stand upwards.

        Raises:
            FileError: the CAD kernel cannot drill the set screw.
        """
        from cadgen.geometry.solids.gear_solids import mesh_compound
        from cadgen.jobs.gears.numbers import part_of
        from cadgen.output.files.exports import GearExport

        pinion, wheel = (
            GearExport(
                name=f"{self.name}_{role}",
                form=form,
                part=(part := part_of(form, gear.blank)),
                chord=usual_chord(part.gears),
                shaft=shaft,
            ).solid()
            for shaft, (role, gear, form) in enumerate(
                zip(("pinion", "wheel"), (self.pinion, self.wheel), self.cut.wheels, strict=True), 1
            )
        )
        height = (self.pinion.width - self.wheel.width) / 2
        return mesh_compound((pinion, wheel), ((0.0, 0.0, 0.0), (self.axes_apart, height, self.wheel_angle)), self.name)


@dataclass(frozen=True)
class Train(Assembly):
    """A gear train: pairs in a row, the wheel of each and the pinion of the next one part on one shaft.

    Attributes:
        stages: pairs from the drive to the output. The features of a part between two stages, besides its teeth, are
            those of the wheel; its hub is the collar.
        directions: direction of every stage's line of centres, rad, None for any; the train is folded tightly if left
            out.
        clearance: least gap between bodies on different shafts, mm.
        name: name of the train and its files.

    Raises:
        DesignError: no stage, or a pinion on a shaft with a wheel that has a bore of its own.

    Example:
        >>> from cadgen import Gear, GearPair, Train
        >>> stage = GearPair(Gear(teeth=20, module=1, width=6), Gear(teeth=60, module=1, width=6), backlash=0.05)
        >>> Train([stage, stage]).ratio
        Fraction(9, 1)
    """

    stages: Sequence[GearPair]
    _: KW_ONLY
    directions: Sequence[float | None] | None = None
    clearance: float = 0.3
    name: str = "train"

    def __post_init__(self) -> None:
        stages = self.stages
        if not isinstance(stages, Sequence) or not all(isinstance(pair, GearPair) for pair in stages) or not stages:
            raise DesignError(f"stages is {brief(repr(stages), 60)}; it must hold at least one GearPair")
        if len(stages) > MOST_STAGES:
            raise DesignError(f"stages has {len(stages)} pairs; it must have at most {MOST_STAGES}")
        for number, (before, after) in enumerate(pairwise(stages), 2):
            if after.pinion.blank not in (Blank(), before.wheel.blank):
                raise DesignError(
                    f"the pinion of stage {number} is one part with the wheel of stage {number - 1}; give bore, "
                    "keyway, hub, web and lightening to that wheel alone"
                )
        directions = None if self.directions is None else several("directions", self.directions, len(stages))
        for angle in directions or ():
            if angle is not None:
                real("directions", angle, -2 * pi, 2 * pi, "rad")
        real("clearance", self.clearance, 0, 100, "mm", above=True)
        require_name(self.name)

    @property
    def ratio(self) -> Fraction:
        """Turns of the drive per turn of the output."""
        return self._train.ratio

    @cached_property
    def _train(self) -> numeric.Train:
        return numeric.Train(tuple(pair.nominal for pair in self.stages))

    @cached_property
    def computed(self) -> "TrainPlan":
        """The train laid out and measured in mesh; it takes a second or so when it is first asked for."""
        from cadgen.jobs.gears.numbers import plan_train

        blanks = [self.stages[0].pinion.blank, *(pair.wheel.blank for pair in self.stages)]
        return plan_train(self._train, blanks, self.name, self.directions, self.clearance)
