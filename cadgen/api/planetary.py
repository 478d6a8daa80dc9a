"""Planetary sets by their numbers, without a design file: lengths in mm, angles in rad."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import degrees, pi

from cadgen.api.gears import Gear, _ByNumbers, require_name
from cadgen.api.values import Stated, optional, real, whole, word
from cadgen.errors import DesignError, brief
from cadgen.figures import Facts
from cadgen.gears.choices import HeldMember
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.pair import GradedGear, closest
from cadgen.gears.planetary import MOST_PLANETS, PlanetarySet, fitted_ring, spaced
from cadgen.gears.planetary_stage import Carrier, PlanetaryStage
from cadgen.gears.ring import RingForm
from cadgen.gears.stage import Standing
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train as Stages
from cadgen.gears.train import train_play
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.made_train import MadeTrain, gear_checks
from cadgen.jobs.gears.assembly import ReturnError, checks_facts, parts_facts, stages_facts
from cadgen.parts.blank import Blank


@dataclass(frozen=True, repr=False)
class Planetary(Stated, _ByNumbers):
    """A planetary set: sun and ring on one axis, planets between them on a carrier.

    The teeth are thinned until both meshes have the backlash asked for: sun and planet by the same amount, the ring by
    what is then left. Sun and planets have opposite hands, the ring that of the planets.

    Attributes:
        sun, planet: external gears; a bore of the planet makes the pins of the carrier.
        ring: internal gear; None for one of as many teeth as an unshifted set has. Its profile shift follows from the
            centre distance unless it has one.
        planets: number of planets.
        held: member that does not turn: `ring` (the sun drives the carrier), `carrier` (the sun drives the ring) or
            `sun` (the ring drives the carrier).
        backlash: circumferential backlash of both meshes, mm; None for the thickness deviations of all three gears if
            they have them, and else for so much that none jams within its tolerances.
        centre_distance: distance of the planets' axes from the sun's, mm; None for that without play.
        equal: whether the planets must stand at equal angles; else they stand as near to that as they fit.
        clearance: least gap between neighbouring planets, mm.
        carrier_thickness: thickness of the carrier's plate, mm; None for half the planet's width; 0 for no carrier.
        bearing_span: distance of the bearings of a shaft, mm, for the play within tolerances.
        name: name of the set and its files.

    Raises:
        DesignError: planets that do not fit or touch, teeth that do not mesh, or a number out of its range.

    Example:
        >>> from cadgen import Gear, Planetary
        >>> sun, planet = Gear(teeth=18, module=1, width=8, bore=5), Gear(teeth=27, module=1, width=8, bore=4)
        >>> gears = Planetary(sun, planet, planets=3)
        >>> gears.ratio, gears.ring_teeth
        (Fraction(5, 1), 72)
    """

    sun: Gear
    planet: Gear
    ring: Gear | None = None
    _: KW_ONLY
    planets: int = 3
    held: str = HeldMember.RING
    backlash: float | None = None
    centre_distance: float | None = None
    equal: bool = True
    clearance: float = 0.3
    carrier_thickness: float | None = None
    bearing_span: float = 60.0
    name: str = "planetary"

    def __post_init__(self) -> None:
        for name in ("sun", "planet", "ring"):
            value = getattr(self, name)
            if not isinstance(value, Gear) and not (name == "ring" and value is None):
                raise DesignError("{name} is {value}; it must be a Gear", name=name, value=brief(repr(value), 60))
        for name, gear in (("sun", self.sun), ("planet", self.planet)):
            if gear.internal:
                raise DesignError("{name} is internal; give a gear with teeth outside", name=name)
        if self.ring is not None and not self.ring.internal:
            raise DesignError("ring has its teeth outside; give it internal=True")
        whole("planets", self.planets, 1, MOST_PLANETS)
        word("held", self.held, [held.value for held in HeldMember])
        if not isinstance(self.equal, bool):
            raise DesignError("{name} is {value}; it must be True or False", name="equal", value=repr(self.equal))
        optional("backlash", self.backlash, 0, 100, "mm")
        optional("centre_distance", self.centre_distance, 0, 2000, "mm", above=True)
        optional("carrier_thickness", self.carrier_thickness, 0, 500, "mm")
        real("clearance", self.clearance, 0, 100, "mm", above=True)
        real("bearing_span", self.bearing_span, 0, 5000, "mm", above=True)
        require_name(self.name)
        for given, cut in ((self.sun, self.cut.sun), (self.planet, self.cut.planet), (self.ring, self.cut.ring)):
            gear_body(cut.form, None if given is None else given.blank)

    @property
    def ring_teeth(self) -> int:
        """Teeth of the ring."""
        return self.cut.ring.form.teeth

    @cached_property
    def cut(self) -> PlanetarySet:
        """The set with its teeth as they are cut."""
        sun, planet = self.sun.form.cut_to(0.0), self.planet.form.cut_to(0.0)
        given = self.ring or Gear(
            teeth=sun.teeth + 2 * planet.teeth,
            module=planet.normal_module,
            width=planet.width,
            pressure_angle=planet.normal_pressure_angle,
            grade=self.planet.grade,
            helix_angle=self.planet.helix_angle,
            hand=self.planet.hand,
            double=self.planet.double,
            internal=True,
        )
        apart = closest(sun, planet) if self.centre_distance is None else float(self.centre_distance)
        ring = given.form.cut_to(0.0)
        assert isinstance(ring, RingForm)
        if ring.profile_shift == 0:
            ring = fitted_ring(sun, planet, ring, apart)

        def graded(gear: Gear, form: GearForm) -> GradedGear:
            return GradedGear(form=form, grade=gear.grade, overrides=gear.overrides)

        nominal = PlanetarySet(
            sun=graded(self.sun, sun),
            planet=graded(self.planet, planet),
            ring=graded(given, ring),
            centre_distance=apart,
            planets=self.planets,
            held=HeldMember(self.held),
            equal=self.equal,
            clearance=self.clearance,
            bearing_span=self.bearing_span,
        )
        own = [gear.thickness_deviation for gear in (self.sun, self.planet, given)]
        if self.backlash is None and None not in own:
            return nominal.finished(*(float(each or 0.0) for each in own))
        if any(each is not None for each in own):
            raise DesignError(
                "sun, planet and ring have a thickness_deviation, all three, or a backlash; give one or the other"
            )
        return nominal.with_backlash(self.backlash)

    @property
    def ratio(self) -> Fraction:
        """Turns of the input per turn of the output; below 0 they turn against each other."""
        return self.cut.ratio

    @property
    def play(self) -> float:
        """Free angle of the output while the input rests, of ideal planets as they are cut, rad."""
        return self.cut.play

    @cached_property
    def return_error(self) -> ReturnError:
        """Free angle of the output within the tolerances of one planet's meshes, rad."""
        least, greatest = self.cut.play_zone()
        return ReturnError(least, self.play, greatest)

    @property
    def frame(self) -> str:
        """Frames of the files, in words."""
        return (
            "mm; the axis of sun and ring is z, and their teeth have their middle at z = 0; the sun has a tooth on x "
            "there, and the first planet stands on x; every part's own file has its axis on z and its lower face at z "
            "= 0"
        )

    @property
    def axes_apart(self) -> float:
        """Centre distance, mm."""
        return self.cut.centre_distance

    @cached_property
    def stage(self) -> PlanetaryStage:
        """The set as a stage of a train."""
        thickness = self.cut.planet.form.width / 2 if self.carrier_thickness is None else self.carrier_thickness
        return PlanetaryStage(
            nominal=self.cut,
            made=self.cut,
            carrier_thickness=thickness,
            planet_bore=self.planet.bore,
            sun_bore=self.sun.bore,
            bearing_span=self.bearing_span,
        )

    @cached_property
    def computed(self) -> MadeTrain:
        """The set at its place, measured in mesh: sun on planet, and planet in the ring."""
        stages = Stages((self.stage,))
        layout = TrainLayout(train=stages, parts=self._parts(), directions=(0.0,))
        return MadeTrain(
            train_play(stages), layout, gear_checks(layout, [self.chord(part.gears) for part in layout.parts])
        )

    def _parts(self) -> tuple[TrainPart, ...]:
        """Sun, planets, ring, and the carrier below them; the sun's teeth have their middle at z = 0."""
        stage, names = self.stage, ("sun", "planet", "ring", "carrier")
        first = stage.cut.ring_angle if self.held == HeldMember.SUN else 0.0
        ends = zip(stage.wheels, (first, stage.driven_angle(first, 0.0)), strict=True)
        every = [
            Standing(name="", wheel=wheel, blank=Blank(), axis=0j, angle=angle, figures=number)
            for number, (wheel, angle) in enumerate(ends)
        ]
        parts = []
        for each in (*every, *stage.standing(first, 0.0)):
            wheel, carrier = each.wheel, isinstance(each.wheel, Carrier)
            if carrier and not (self.planet.bore and self.carrier_thickness != 0):
                continue
            sun = isinstance(wheel, GearForm) and wheel.side > 0 and each.axis == 0
            name = each.name or ("carrier" if carrier else "sun" if sun else "ring")
            blank = Blank(bore_diameter=self.sun.bore) if carrier else self.planet.blank if each.axis else Blank()
            blank = self.sun.blank if sun else blank
            parts.append(
                TrainPart(
                    name=name,
                    shaft=names.index(name.partition("_")[0]) + 1,
                    gears=(wheel,),
                    stages=(1,),
                    blank=blank,
                    body=gear_body(wheel, blank),
                    axis=each.axis,
                    angle=each.angle % (2 * pi),
                    height=-wheel.width / 2 - (stage.carrier_rise if carrier else 0.0),
                    flipped=False,
                    figures=each.figures,
                )
            )
        # Each on a shaft, as it were: that decides its colour.
        parts.sort(key=lambda part: part.shaft)
        return tuple(replace(part, shaft=number) for number, part in enumerate(parts, 1))

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks on the set: where the planets stand, the ring's shift, and those on its meshes."""
        return (spaced(self.cut), *self.stage.notes(1)[1:])

    def entry(self) -> Facts:
        """Every tolerance, play, part and inspection size, as in the manifest."""
        made, cut, error = self.computed, self.cut, self.return_error
        return Facts(
            planetary=self.name,
            passed=self.passed,
            held=self.held,
            ratio=str(self.ratio),
            planets=self.planets,
            planet_angles_deg=[degrees(angle) for angle in cut.orbits],
            neighbour_gap_mm=cut.neighbour_gap if self.planets > 1 else None,
            counts_equally_spaced=list(cut.counts),
            centre_distance_mm=cut.centre_distance,
            output_play_deg=Facts(
                least=degrees(error.least), as_cut=degrees(error.as_cut), greatest=degrees(error.greatest)
            ),
            notes=self.notes,
            stages=stages_facts(made.layout),
            checks=checks_facts(made.checks),
            parts=parts_facts(made.layout),
        )
