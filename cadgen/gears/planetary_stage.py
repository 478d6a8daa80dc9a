"""Planetary set as a stage of a train: input and output on one axis, planets and the held member beside them.

With the ring held the sun drives the carrier, with the carrier held the sun drives the ring, and with the sun held the
ring drives the carrier. The carrier is a plate above the gears with a hole for the pin of each planet.

**Play** of the output: of ideal planets each gives j_1 + j_2 of its two meshes along the lines of action, over
r_bs + r_br (carrier) or r_br (ring). Made ones differ. A planet lets the output turn within an interval; its width is
that play, and a pin off its place along the orbit shifts it. The output is free where all intervals overlap.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from fractions import Fraction
from functools import lru_cache
from math import degrees, pi
from typing import Self

import numpy as np

from cadgen.check import Bound, Check
from cadgen.figures import Facts, Figure, Figures
from cadgen.gears.choices import HeldMember, Law
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.planetary import PlanetarySet, spaced
from cadgen.gears.sliding import loss_factor
from cadgen.gears.spur import pair_checks, pair_facts
from cadgen.gears.stage import Engage, Mating, Stage, Standing, Wheel
from cadgen.messages import Message, clauses
from cadgen.parts.blank import Blank
from cadgen.parts.loop import Loop, circle

# Gap between the carrier's plate and the gears, and the wall round its holes, mm.
CARRIER_GAP, CARRIER_WALL = 0.5, 3.0
# A smaller profile shift of the ring is none.
LEAST_SHIFT = 5e-5
# Sets of planets that are drawn for the play of toothed ones, and the seed of the draw.
DRAWN_SETS, SEED = 4000, 1
# Numbers of planet and of the held member among the wheels of the stage.
PLANET, HELD = 2, 3


class PlanetaryCode(StrEnum):
    """Codes of the checks of planetary stages."""

    PLANETS_JAM = "planets-jam"


@dataclass(frozen=True, slots=True, kw_only=True)
class Carrier:
    """Plate that carries the planets, a wheel without teeth; its own axis at the origin, mm and rad.

    Attributes:
        width: thickness of the plate.
        centre_distance: distance of the pins from the axis.
        pin: diameter of the pins; 0 for none.
        orbits: angles of the pins round the axis.
    """

    width: float
    centre_distance: float
    pin: float
    orbits: tuple[float, ...]
    usual_chord = 5e-3

    def __str__(self) -> str:
        return Message("the carrier of {count} planets", count=len(self.orbits))

    @property
    def noun(self) -> str:
        """Name of its body in messages."""
        return str(self)

    @property
    def tip_diameter(self) -> float:
        """Diameter of the plate, mm."""
        return 2 * self.centre_distance + self.pin + 2 * CARRIER_WALL

    @property
    def root_diameter(self) -> float:
        """Diameter of the circle inside all pins and the walls round them, mm."""
        return 2 * self.centre_distance - self.pin - 2 * CARRIER_WALL

    @property
    def least_rim(self) -> float:
        """Least wall under that circle, mm."""
        return 0.0

    @property
    def outline(self) -> Loop:
        """Circle of the plate."""
        return circle(self.tip_diameter)

    @property
    def holes(self) -> tuple[Loop, ...]:
        """Holes for the pins."""
        if not self.pin:
            return ()
        return tuple(circle(self.pin, rect(self.centre_distance, orbit)) for orbit in self.orbits)


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanetaryPlay:
    """Play at the output of a planetary stage, rad, and its contributions.

    Attributes:
        B_min: least free angle within the tolerances, of planets that differ.
        B_max: greatest free angle.
        radius: radius on which arcs are counted, mm.
        contributions: contributions of one planet, as arcs of that radius, mm.
    """

    B_min: float
    B_max: float
    radius: float
    contributions: ZoneSum

    def distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Independent contributions to the play of one planet, as arcs of the pitch circle, mm."""
        return replace(self.contributions, law=law)


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanetaryStage(Stage):
    """Planetary set as a stage; lengths in mm, angles in rad.

    Attributes:
        nominal: set of nominal thickness.
        backlash: backlash of both meshes; None for that of their grade.
        deviations: deviations E_sn of sun, planet and ring, in place of a backlash; None for that backlash.
        carrier_thickness: thickness of the carrier's plate.
        planet_bore, sun_bore: bores of the planets, and of a sun that is held.
        pin_place: greatest distance of a pin from its place along the orbit.
        bearing_span: between the bearings of a shaft.
        made: the set as it is cut; None before.
    """

    nominal: PlanetarySet
    backlash: float | None = None
    deviations: tuple[float, float, float] | None = None
    carrier_thickness: float
    planet_bore: float = 0.0
    sun_bore: float = 0.0
    pin_place: float = 0.0
    bearing_span: float
    made: PlanetarySet | None = None
    centre_distance: float = field(default=0.0, init=False)

    @property
    def noun(self) -> str:
        """Planetary gears."""
        return Message("planetary gears")

    @property
    def cut(self) -> PlanetarySet:
        """The set as it is cut."""
        return self.made or _cut(self.nominal, self.backlash, self.deviations, self.pin_place)

    @property
    def held(self) -> HeldMember:
        """Member that does not turn."""
        return self.nominal.held

    @property
    def sense(self) -> int:
        """-1 with the carrier held, else +1."""
        return -1 if self.held == HeldMember.CARRIER else 1

    @property
    def ratio(self) -> Fraction:
        """Turns of the input per turn of the output, without sign."""
        return abs(self.nominal.ratio)

    @property
    def carrier(self) -> Carrier:
        """Plate of the planets."""
        cut = self.nominal
        return Carrier(
            width=self.carrier_thickness,
            centre_distance=cut.centre_distance,
            pin=self.planet_bore,
            orbits=cut.orbits,
        )

    @property
    def wheels(self) -> tuple[Wheel, Wheel]:
        """Input and output."""
        cut = self.made or self.nominal
        driver = cut.ring.form if self.held == HeldMember.SUN else cut.sun.form
        return driver, cut.ring.form if self.held == HeldMember.CARRIER else self.carrier

    @property
    def driven_pitch_radius(self) -> float:
        """Radius of the planets' orbit, or of the ring's working pitch circle where the carrier is held, mm."""
        if self.held == HeldMember.CARRIER:
            return self.nominal.meshes[1].driven_pitch_radius
        return self.nominal.centre_distance

    @property
    def label(self) -> str:
        """Teeth of sun, planet and ring, and the number of planets: 18/27/72 × 3."""
        sun, planet, ring = (gear.form.teeth for gear in (self.nominal.sun, self.nominal.planet, self.nominal.ring))
        return f"{sun}/{planet}/{ring} × {self.nominal.planets}"

    @property
    def module(self) -> float:
        """m_n, mm."""
        return self.nominal.sun.form.normal_module

    @property
    def rise(self) -> float:
        """Height of the carrier's middle over that of the gears, mm; 0 where the ring is driven."""
        return 0.0 if self.held == HeldMember.CARRIER else self.carrier_rise

    @property
    def carrier_rise(self) -> float:
        """Height of the carrier's middle over that of the gears, mm."""
        return self.widest / 2 + CARRIER_GAP + self.carrier_thickness / 2

    @property
    def widest(self) -> float:
        """Greatest width of its gears, mm."""
        return max(gear.form.width for gear in (self.nominal.sun, self.nominal.planet, self.nominal.ring))

    @property
    def begins(self) -> float:
        """Half the width of the widest gear, mm."""
        return self.widest / 2

    @property
    def stands_out(self) -> tuple[float, float]:
        """Height by which the widest gear stands out under the input, and nothing over the carrier, mm."""
        driver, driven = self.wheels
        above = self.carrier_rise + self.carrier_thickness / 2 - driven.width / 2
        return (self.widest - driver.width) / 2, above if self.held == HeldMember.CARRIER else 0.0

    @property
    def toothed(self) -> bool:
        """Play is the room between flanks."""
        return True

    @property
    def matings(self) -> tuple[Mating, ...]:
        """Sun and planet, planet and ring."""
        inner, outer = (self.made or self.nominal).meshes
        sun = HELD if self.held == HeldMember.SUN else 0
        ring = {HeldMember.RING: HELD, HeldMember.CARRIER: 1, HeldMember.SUN: 0}[self.held]
        return Mating(inner, sun, PLANET), Mating(outer, PLANET, ring)

    def free_angle_of(self, free: Sequence[float]) -> float:
        """Free angle of the output from those of a planet against the sun, and of the ring against a planet, rad.

        Args:
            free: free angles, rad.
        """
        meshes = self.nominal.meshes
        base = sum(angle * mesh.driven.form.base_diameter / 2 for angle, mesh in zip(free, meshes, strict=True))
        return self.nominal.output_angle(base)

    def play(self) -> PlanetaryPlay:
        """Play of the output within the tolerances of the meshes and of the pins' places."""
        least, greatest = self.cut.play_zone()
        radius, spread = self.driven_pitch_radius, []
        names: list[str] = []
        for mesh, name in zip(self.cut.meshes, (Message("sun and planet"), Message("planet and ring")), strict=True):
            zone = mesh.play().distribution()
            arc = mesh.driven.form.base_diameter / 2 / mesh.driven_pitch_radius
            share = self.nominal.output_angle(arc) * radius
            spread.append((zone.low * share, zone.high * share))
            names += [Message("{mesh}: {part}", mesh=name, part=part) for part in zone.names]
        low, high = (np.concatenate(ends) for ends in zip(*spread, strict=True))
        shift = 2 * self.pin_place / self.nominal.centre_distance if self.nominal.planets > 1 else 0.0
        if shift:
            names.append(Message("places of the pins"))
            low, high = np.append(low, -shift * radius), np.append(high, 0.0)
        return PlanetaryPlay(
            B_min=least - shift, B_max=greatest, radius=radius, contributions=ZoneSum(tuple(names), low, high)
        )

    def free_angle(self) -> float:
        """Play of the output of ideal planets as they are cut, rad."""
        return self.cut.play

    def drawn_play(self) -> ZoneDraw:
        """Play of the output with planets that differ within the tolerances, from sets drawn at random, rad."""
        return _drawn(self)

    def efficiency(self, friction: float) -> float:
        """Efficiency from that of the meshes with the carrier at rest, η_0 = (1 − μ H_v1)(1 − μ H_v2), i_0 = −z_r/z_s.

        Ring held, sun driving: (1 − i_0 η_0) / (1 − i_0). Sun held, ring driving: (i_0 − η_0) / (i_0 − 1).

        Args:
            friction: friction coefficient μ of the flanks.
        """
        inner, outer = self.cut.meshes
        fixed = (1 - friction * loss_factor(inner)) * (1 - friction * loss_factor(outer))
        ratio = -self.cut.ring.form.teeth / self.cut.sun.form.teeth
        match self.held:
            case HeldMember.CARRIER:
                return fixed
            case HeldMember.RING:
                return (1 - ratio * fixed) / (1 - ratio)
        return (ratio - fixed) / (ratio - 1)

    def opened(self, clearance: float) -> float:
        """Play that looser bearings add, rad: none, for a planet that leaves one mesh enters the other as far.

        Args:
            clearance: growth of the distance of the axes, mm.
        """
        return 0.0

    def as_cut(self) -> Self:
        """The stage with its teeth as they are cut."""
        return replace(self, made=self.cut)

    def driven_angle(self, driver_angle: float, direction: float) -> float:
        """Angle of the output: of a carrier, that of its first planet, which is the direction; of a ring, its tooth's.

        Args:
            driver_angle: angle of the input, rad.
            direction: direction of the first planet, rad.
        """
        if self.held != HeldMember.CARRIER:
            return direction % (2 * pi)
        return self._ring_angle(driver_angle, direction)

    def _ring_angle(self, sun_angle: float, direction: float) -> float:
        return self.cut.meshes[1].driven_angle(self.cut.planet_angle(direction, sun_angle), direction + pi)

    def standing(self, driver_angle: float, direction: float) -> tuple[Standing, ...]:
        """Planets, and the member that is held.

        Args:
            driver_angle: angle of the input, rad.
            direction: direction of the first planet, rad.
        """
        cut, sun_angle = self.cut, driver_angle
        if self.held == HeldMember.SUN:  # the ring drives
            z_sun, z_ring = self.nominal.sun.form.teeth, self.nominal.ring.form.teeth
            sun_angle = (self._ring_angle(0.0, direction) - driver_angle) * z_ring / z_sun
        blank = Blank(bore_diameter=self.planet_bore)
        planets = tuple(
            Standing(
                name=f"planet_{number}",
                wheel=cut.planet.form,
                blank=blank,
                axis=rect(cut.centre_distance, direction + orbit),
                angle=cut.planet_angle(direction + orbit, sun_angle),
                figures=PLANET,
                turns=self._planet_turns,
                orbits=self.held != HeldMember.CARRIER,
            )
            for number, orbit in enumerate(cut.orbits, 1)
        )
        if self.held == HeldMember.RING:
            ring = self._ring_angle(sun_angle, direction)
            return (*planets, _held("ring", cut.ring.form, Blank(), ring))
        if self.held == HeldMember.SUN:
            sun = Blank(bore_diameter=self.sun_bore)
            return (*planets, _held("sun", cut.sun.form, sun, sun_angle))
        return (*planets, _held("carrier", self.carrier, Blank(), direction, self.carrier_rise))

    @property
    def _planet_turns(self) -> tuple[float, float]:
        """Turning of a planet for one of the input and for one of the output.

        It stands midway between what the sun asks for, θ_c − z_s/z_p (θ_s − θ_c), and the ring, θ_c + z_r/z_p
        (θ_r − θ_c): within the play both differ.
        """
        cut = self.nominal
        sun, ring = cut.sun.form.teeth / cut.planet.form.teeth, cut.ring.form.teeth / cut.planet.form.teeth
        with_carrier = 1 + (sun - ring) / 2
        match self.held:
            case HeldMember.RING:
                return -sun / 2, with_carrier
            case HeldMember.CARRIER:
                return -sun / 2, ring / 2
            case _:
                return ring / 2, with_carrier

    def meshes(self, engage: Engage) -> bool:
        """Whether the teeth of both meshes, as cut, have one play all the time."""
        return all(mesh.meshes(engage) for mesh in self.cut.meshes)

    def checks(self, engage: Engage) -> tuple[Check, ...]:
        """Checks of both meshes, of each code the one that is nearer to its limit."""
        worst: dict[str, Check] = {}
        for mesh, name in zip(self.cut.meshes, (Message("sun and planet"), Message("planet and ring")), strict=True):
            for check in pair_checks(mesh, engage, True):
                placed = replace(check, place=clauses(name, check.place) if check.place else name)
                known = worst.setdefault(check.code, placed)
                nearer = check.value > known.value if check.bound == Bound.MAX else check.value < known.value
                if nearer:
                    worst[check.code] = placed
        play = self.play()
        least = play.B_min * self.driven_pitch_radius * 1e3
        jam = Check(
            PlanetaryCode.PLANETS_JAM,
            Message("least play with planets that differ"),
            least,
            "µm",
            0.0,
            Bound.MIN,
            advice=Message("raise backlash_um, or lower pin_place_um"),
        )
        return (*worst.values(), jam)

    def notes(self, number: int) -> tuple[str, ...]:
        """Places of the planets, the ring's shift, and the notes on both meshes.

        Args:
            number: number of the stage.
        """
        cut = self.cut
        said = [Message("in stage {number}, {note}", number=number, note=spaced(cut))]
        if abs(cut.ring.form.profile_shift) > LEAST_SHIFT:
            said.append(
                Message(
                    "in stage {number}, the ring has the profile shift {shift:.4f} (ISO 21771) at the centre distance "
                    "of {apart:.4f} mm",
                    number=number,
                    shift=cut.ring.form.profile_shift,
                    apart=cut.centre_distance,
                )
            )
        return (*said, *dict.fromkeys(note for mesh in cut.meshes for note in mesh.notes(number)))

    @property
    def grades(self) -> tuple[int | None, int | None]:
        """Grades by ISO 1328 of input and output; None for the carrier."""
        cut = self.nominal
        driver = cut.ring.grade if self.held == HeldMember.SUN else cut.sun.grade
        return driver, cut.ring.grade if self.held == HeldMember.CARRIER else None

    def entry(self) -> Facts:
        """Ratio, places of the planets, play at the output, and the facts of both meshes."""
        cut, play, drawn = self.cut, self.play(), self.drawn_play()
        inner, outer = cut.meshes
        return Facts(
            teeth=self.label,
            held=str(self.held),
            ratio=str(self.nominal.ratio),
            planets=cut.planets,
            planet_angles_deg=[degrees(angle) for angle in cut.orbits],
            neighbour_gap_mm=cut.neighbour_gap if cut.planets > 1 else None,
            counts_equally_spaced=list(cut.counts),
            centre_distance_mm=cut.centre_distance,
            ring_profile_shift=cut.ring.form.profile_shift,
            bearing_span_mm=self.bearing_span,
            return_error_greatest_deg=degrees(play.B_max),
            return_error_least_deg=degrees(play.B_min),
            play_ideal_deg=degrees(self.free_angle()),
            play_of_planets_that_differ_deg=Facts(
                mean=degrees(drawn.mean), std=degrees(drawn.std), least=degrees(drawn.least)
            ),
            sun_and_planet=pair_facts(inner),
            planet_and_ring=pair_facts(outer),
        )

    def wheel_figures(self) -> tuple[Figures, ...]:
        """Figures of input, output, planet and the held member."""
        cut = self.cut
        inner, outer = cut.meshes
        sun, planet = inner.wheel_figures()
        _, ring = outer.wheel_figures()
        carrier = self.carrier
        plate = Figures(
            Figure("diameter", Message("diameter"), carrier.tip_diameter, "mm"),
            Figure("width", Message("width"), carrier.width, "mm"),
        )
        match self.held:
            case HeldMember.RING:
                return sun, plate, planet, ring
            case HeldMember.CARRIER:
                return sun, ring, planet, plate
            case _:
                return ring, plate, planet, sun


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoneDraw:
    """Moments of a quantity that was drawn at random, rad.

    Attributes:
        mean, std: mean and standard deviation.
        least: least value drawn.
    """

    mean: float
    std: float
    least: float


def _held(name: str, wheel: Wheel, blank: Blank, angle: float, rise: float = 0.0) -> Standing:
    return Standing(name=name, wheel=wheel, blank=blank, axis=0j, angle=angle, figures=HELD, rise=rise)


@lru_cache(maxsize=64)
def _cut(
    nominal: PlanetarySet, backlash: float | None, deviations: tuple[float, float, float] | None, pin_place: float
) -> PlanetarySet:
    if deviations is not None:
        return nominal.finished(*deviations)
    return nominal.with_backlash(backlash, pin_place)


@lru_cache(maxsize=64)
def _drawn(stage: PlanetaryStage) -> ZoneDraw:
    """Play of sets of planets drawn within their zones, rad, from the overlap of their intervals.

    Of a mesh all contributions are drawn anew for each planet, but the thickness of sun and ring, which the planets
    share.
    """
    cut, generator = stage.cut, np.random.default_rng(SEED)
    count, widths = cut.planets, np.zeros((DRAWN_SETS, cut.planets))
    for mesh, shared in zip(cut.meshes, (1, 2), strict=True):
        zone = mesh.play().distribution()
        drawn = zone.sample_contributions(generator, DRAWN_SETS * count).reshape(DRAWN_SETS, count, -1)
        drawn[:, :, shared] = drawn[:, :1, shared]
        arc = mesh.driven.form.base_diameter / 2 / mesh.driven_pitch_radius
        widths += drawn.sum(axis=2) * cut.output_angle(arc)
    places = ZoneSum(("",), np.array([-stage.pin_place]), np.array([stage.pin_place]))
    middles = places.sample(generator, DRAWN_SETS * count).reshape(DRAWN_SETS, count) / cut.centre_distance
    free = (middles + widths / 2).min(axis=1) - (middles - widths / 2).max(axis=1)
    return ZoneDraw(mean=float(free.mean()), std=float(free.std()), least=float(free.min()))
