"""Planetary sets: a sun, planets on a carrier, and a ring round them, all on one centre distance.

The ring's profile shift follows from the distance of sun and planet. Planets fit where sun and ring let them: at
multiples of 360°/(z_s + z_r) round the axis, so that N of them are spaced equally where (z_s + z_r)/N is whole. Ratios
are signed: below 0 the output turns against the input.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import acos, ceil, cos, degrees, inf, pi, radians, sin, tan
from typing import Self

from cadgen.errors import DesignError
from cadgen.gears.choices import HeldMember
from cadgen.gears.pair import GradedGear
from cadgen.gears.ring import RingForm, ring_of
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm, involute
from cadgen.messages import Message, joined

# A profile shift that is rounding of the numbers that it follows from, in modules.
_NO_SHIFT = 1e-12
# Most planets that are tried for the counts that work, and held by a set.
MOST_PLANETS = 12
# Greatest profile shift of a ring, in modules: with more its teeth number too few or too many.
MOST_SHIFT = 2.0
# Least working pressure angle of planets and ring: the tolerance of their distance takes some of it.
LEAST_MESH = radians(8.0)
# Backlash that is left at the least play within the tolerances where none is given, mm, and its steps.
LEFT_BACKLASH = 0.01


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanetarySet:
    """A sun, equal planets and a ring; lengths in mm, angles in rad.

    Attributes:
        sun, planet, ring: gears, with the thickness that they are cut to.
        centre_distance: distance of the planets' axes from that of the sun, mm.
        planets: number of planets.
        held: member that does not turn.
        equal: whether the planets must be spaced equally; else they stand as near to that as they fit.
        clearance: least gap between neighbouring planets, mm.
        bearing_span: distance of the bearings of a shaft, mm.
        centre_distance_deviation: deviation of the planets' distance, mm; None for the standard's.

    Raises:
        DesignError: planets that do not fit so, or that touch; teeth that do not mesh.
    """

    sun: GradedGear
    planet: GradedGear
    ring: GradedGear
    centre_distance: float
    planets: int
    held: HeldMember = HeldMember.RING
    equal: bool = True
    clearance: float = 0.3
    bearing_span: float = 1000.0
    centre_distance_deviation: float | None = None

    def __post_init__(self) -> None:
        if not 1 <= self.planets <= MOST_PLANETS:
            raise DesignError(
                "a planetary set has {planets} planets; give 1 to {most}", planets=self.planets, most=MOST_PLANETS
            )
        self.meshes  # noqa: B018
        if self.equal and not self.spaced_equally(self.planets):
            said = Message(
                "{planets} planets do not fit at equal angles between a sun of {sun} and a ring of {ring} teeth; give "
                "planets (planet.count) = {counts}",
                planets=self.planets,
                sun=self.sun.form.teeth,
                ring=self.ring.form.teeth,
                counts=joined([str(count) for count in self.counts or (1,)], " or "),
            )
            if not self.neighbour_gap >= self.clearance:  # at the nearest angles, too
                raise DesignError(said)
            raise DesignError(
                '{said}, or spacing = "nearest" (--unequal) for the nearest angles, {angles}',
                said=said,
                angles=joined([f"{degrees(angle):.4f}°" for angle in self.orbits], ", "),
            )
        if not self.neighbour_gap >= self.clearance:
            fewer = [count for count in range(1, self.planets) if self._gap(count) >= self.clearance]
            raise DesignError(
                "{planets} planets come as near to each other as {gap:.4g} mm, and {clearance:g} mm is the least; give "
                "planets (planet.count) = {fewer}",
                planets=self.planets,
                gap=self.neighbour_gap,
                clearance=self.clearance,
                fewer=joined([str(count) for count in fewer if not self.equal or self.spaced_equally(count)], " or "),
            )

    @property
    def meshes(self) -> tuple[SpurPair, SpurPair]:
        """Sun and planet, and planet and ring, as pairs at the centre distance."""
        return (
            SpurPair(
                driver=self.sun,
                driven=self.planet,
                centre_distance=self.centre_distance,
                bearing_span=self.bearing_span,
                centre_distance_deviation=self.centre_distance_deviation,
            ),
            SpurPair(
                driver=self.planet,
                driven=self.ring,
                centre_distance=self.centre_distance,
                bearing_span=self.bearing_span,
                centre_distance_deviation=self.centre_distance_deviation,
            ),
        )

    @property
    def teeth_round(self) -> int:
        """Places at which a planet fits round the axis: z_s + z_r."""
        return self.sun.form.teeth + self.ring.form.teeth

    def spaced_equally(self, count: int) -> bool:
        """Whether so many planets fit at equal angles.

        Args:
            count: number of planets.
        """
        return self.teeth_round % count == 0

    @property
    def counts(self) -> tuple[int, ...]:
        """Numbers of planets, from 2 on, that fit at equal angles without touching."""
        tried = range(2, MOST_PLANETS + 1)
        return tuple(count for count in tried if self.spaced_equally(count) and self._gap(count) >= self.clearance)

    @property
    def orbits(self) -> tuple[float, ...]:
        """Angles of the planets round the axis, the nearest to equal ones at which they fit, rad."""
        return self._orbits(self.planets)

    def _orbits(self, count: int) -> tuple[float, ...]:
        step = 2 * pi / self.teeth_round
        return tuple(round(2 * pi * number / count / step) * step for number in range(count))

    @property
    def neighbour_gap(self) -> float:
        """Least gap between the tips of neighbouring planets, 2 a sin(δ/2) − d_a, mm; infinite for one planet."""
        return self._gap(self.planets)

    def _gap(self, count: int) -> float:
        if count < 2:
            return float("inf")
        orbits = self._orbits(count)
        apart = min((after - before) % (2 * pi) for before, after in zip(orbits, (*orbits[1:], orbits[0]), strict=True))
        return 2 * self.centre_distance * sin(min(apart, 2 * pi - apart) / 2) - self.planet.form.tip_diameter

    @property
    def ratio(self) -> Fraction:
        """Turns of the input per turn of the output, signed.

        The sun drives the carrier with the ring held, and the ring with the carrier held; the ring drives the carrier
        with the sun held.
        """
        sun, ring = self.sun.form.teeth, self.ring.form.teeth
        if self.held == HeldMember.RING:
            return 1 + Fraction(ring, sun)
        return 1 + Fraction(sun, ring) if self.held == HeldMember.SUN else -Fraction(ring, sun)

    @property
    def play(self) -> float:
        """Free angle of the output of ideal planets while the input rests, as cut, rad."""
        return self.output_angle(sum(mesh.backlash().base for mesh in self.meshes))

    def output_angle(self, base: float) -> float:
        """Free angle of the output for the play of both meshes together, rad.

        Args:
            base: plays of both meshes along the transverse lines of action, mm.
        """
        sun, ring = self.sun.form.base_diameter / 2, self.ring.form.base_diameter / 2
        return base / (ring if self.held == HeldMember.CARRIER else sun + ring)

    def play_zone(self) -> tuple[float, float]:
        """Least and greatest free angle of the output within the tolerances of one planet's meshes, rad.

        Raises:
            DesignError: a size that the standards do not cover.
        """
        zones = [(mesh, mesh.play()) for mesh in self.meshes]
        ends = [
            sum(getattr(zone, end) * mesh.driven.form.base_diameter / 2 for mesh, zone in zones)
            for end in ("B_min", "B_max")
        ]
        least, greatest = (self.output_angle(float(end)) for end in ends)
        return least, greatest

    def planet_angle(self, orbit: float, sun_angle: float = 0.0) -> float:
        """Angle of a tooth of a planet, rad.

        Args:
            orbit: angle of the planet round the axis, rad.
            sun_angle: angle of a tooth of the sun, rad.
        """
        return self.meshes[0].driven_angle(sun_angle, orbit)

    @property
    def ring_angle(self) -> float:
        """Angle of a tooth of the ring while the sun has one on the x axis, rad."""
        orbit = self.orbits[0]
        return self.meshes[1].driven_angle(self.planet_angle(orbit), orbit + pi)

    def cut_to(self, sun: float, planet: float, ring: float) -> Self:
        """Set with other deviations E_sn of its teeth.

        Args:
            sun, planet, ring: deviations, mm.
        """
        forms = ((self.sun, sun), (self.planet, planet), (self.ring, ring))
        one, two, three = (replace(gear, form=gear.form.cut_to(each), thinning=each) for gear, each in forms)
        return replace(self, sun=one, planet=two, ring=three)

    def with_backlash(self, backlash: float | None = None, pin_place: float = 0.0) -> Self:
        """Set of which both meshes have a backlash on their working pitch circles.

        Sun and planets are thinned by the same amount, the ring by what is then left.

        Args:
            backlash: backlash, mm; None for so much that no mesh jams within its tolerances.
            pin_place: greatest distance of a planet's pin from its place along the orbit, mm, that such a backlash
                leaves room for.
        """
        if backlash is None:
            short = 0.0
            for mesh in self.meshes:
                fixed = mesh.thinned_to(*(wheel.tooth_thickness_deviation for wheel in mesh.wheels))
                short = max(short, (fixed.free_angle() - float(fixed.play().B_min)) * mesh.driven_pitch_radius)
            if self.planets > 1:
                bases = (self.sun.form.base_diameter + self.ring.form.base_diameter) / 2
                short += pin_place * bases / self.centre_distance / cos(self.meshes[0].working_pressure_angle)
            backlash = ceil((short + LEFT_BACKLASH) / LEFT_BACKLASH) * LEFT_BACKLASH
        inner, outer = (mesh.thinning_for(backlash) for mesh in self.meshes)
        return self.finished(inner / 2, inner / 2, outer - inner / 2)

    def finished(self, sun: float, planet: float, ring: float) -> Self:
        """Set as it is cut: teeth of the given deviations, and tips of the ring that the planets' flanks allow.

        Args:
            sun, planet, ring: deviations E_sn, mm.

        Raises:
            DesignError: teeth that cannot be cut, or that foul.
        """
        cut = replace(self, ring=self.meshes[1].with_free_tips().driven).cut_to(sun, planet, ring)
        inner, outer = cut.meshes
        outer = outer.fitted()
        for gear in (inner.driver, inner.driven, outer.driven):
            gear.form.tooth  # noqa: B018
        return replace(cut, ring=outer.driven)


def ring_for(sun: GearForm, planet: GearForm, ring: GearForm, centre_distance: float) -> float:
    """Profile shift of the ring that meshes without play at the centre distance of sun and planet.

    x_r = −(inv α_w − inv α_t)(z_r − z_p)/(2 tan α_n) − x_p.

    Args:
        sun: numbers of the sun.
        planet: numbers of a planet.
        ring: numbers of the ring, its profile shift aside.
        centre_distance: distance of the planets' axes from the sun's, mm.

    Raises:
        DesignError: the ring's teeth do not meet the planets there.
    """
    more, alpha = ring.teeth - planet.teeth, planet.transverse_pressure_angle
    base = (ring.base_diameter - planet.base_diameter) / 2
    shift = inf
    if more > 0 and base < centre_distance * cos(LEAST_MESH):
        opened = involute(acos(base / centre_distance)) - involute(alpha)
        shift = -opened * more / (2 * tan(planet.normal_pressure_angle)) - planet.profile_shift
    if not abs(shift) <= MOST_SHIFT:
        raise DesignError(
            "a ring of {ring} teeth does not reach round planets of {planet} teeth {apart:.5g} mm from a sun of {sun} "
            "teeth; give the ring about {usual} teeth",
            ring=ring.teeth,
            planet=planet.teeth,
            apart=centre_distance,
            sun=sun.teeth,
            usual=sun.teeth + 2 * planet.teeth,
        )
    return shift if abs(shift) > _NO_SHIFT else 0.0


def fitted_ring(sun: GearForm, planet: GearForm, ring: RingForm, centre_distance: float) -> RingForm:
    """Ring with the profile shift that the centre distance asks for.

    Args:
        sun: numbers of the sun.
        planet: numbers of a planet.
        ring: numbers of the ring, its profile shift aside.
        centre_distance: distance of the planets' axes from the sun's, mm.
    """
    shifted = replace(ring, profile_shift=ring_for(sun, planet, ring, centre_distance))
    return ring_of(
        shifted,
        rim_width=ring.rim_width,
        cutter_teeth=ring.cutter_teeth,
        root_rounding=ring.root_rounding,
        keeps_addendum=ring.keeps_addendum,
    )


def spaced(planets: PlanetarySet) -> Message:
    """Angles at which the planets stand, in words."""
    return Message(
        "the planets stand at {angles}", angles=joined([f"{degrees(angle):.4f}°" for angle in planets.orbits], ", ")
    )
