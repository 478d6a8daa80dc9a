"""Planetary sets: the trial of another program, and polygons that do or do not fit between sun and ring."""

from dataclasses import replace
from fractions import Fraction
from math import degrees, pi, radians

import manifold3d
import numpy as np
import pytest

from cadgen import Gear, Planetary
from cadgen.errors import DesignError
from cadgen.gears.pair import GradedGear, closest
from cadgen.gears.planetary import HeldMember, PlanetarySet, ring_for
from cadgen.geometry.meshes.teeth import section_of
from tests.gears.test_internal import form_of, pinion, ring, trial


def gear(teeth, **more):
    return Gear(teeth=teeth, module=1, width=6, **more)


@pytest.fixture(scope="module")
def said():
    return trial("14_planetary_spacing")


@pytest.fixture(scope="module")
def members(said):
    return {key: GradedGear(form=form_of(said["design"][key])) for key in ("sun", "planet", "ring")}


def test_planets_that_do_not_space_are_refused_with_counts_that_do(said, members):
    with pytest.raises(
        DesignError, match=r"give planets \(planet\.count\) = 2 or 3, or .* 0\.0000°, 91\.7647°, 180\.0000°, 268\.2353°"
    ):
        PlanetarySet(**members, centre_distance=said["design"]["a"], planets=4)
    with pytest.raises(DesignError, match=r"-7\.5 mm, .* give planets \(planet\.count\) = 1 or 2 or 3"):
        PlanetarySet(**members, centre_distance=said["design"]["a"], planets=6)
    for count in (2, 3):
        assert PlanetarySet(**members, centre_distance=said["design"]["a"], planets=count).counts == (2, 3)


def test_unequal_angles_are_offered_only_where_neighbours_clear(said, members):
    """Seven planets overlap at any angles: the flag that lets them stand unequally would be refused."""
    apart = said["design"]["a"]
    with pytest.raises(DesignError, match=r"give planets \(planet\.count\) = 2 or 3$"):
        PlanetarySet(**members, centre_distance=apart, planets=7)
    with pytest.raises(DesignError, match="near to each other"):
        PlanetarySet(**members, centre_distance=apart, planets=7, equal=False)


def test_angles_ratios_and_plays_are_those_of_another_program(said, members):
    unequal = PlanetarySet(**members, centre_distance=said["design"]["a"], planets=4, equal=False)
    expected = said["expected"]
    assert [degrees(angle) for angle in unequal.orbits] == pytest.approx(expected["nearest_angles_deg"], abs=1e-6)
    assert unequal.neighbour_gap == pytest.approx(expected["neighbour_gap"], abs=1e-6)
    ratios = {held: float(replace(unequal, held=held).ratio) for held in HeldMember}
    wanted = expected["ratios"]
    assert ratios[HeldMember.RING] == pytest.approx(wanted["ring_fixed_sun_in"])
    assert ratios[HeldMember.SUN] == pytest.approx(wanted["sun_fixed_ring_in"], abs=5e-7)
    assert ratios[HeldMember.CARRIER] == pytest.approx(wanted["carrier_fixed_sun_in"])
    plays = {held: degrees(replace(unequal, held=held).play) for held in HeldMember}
    assert plays[HeldMember.RING] == pytest.approx(expected["plays_deg"]["carrier"], abs=6e-7)
    assert plays[HeldMember.CARRIER] == pytest.approx(expected["plays_deg"]["ring"], abs=6e-7)


def test_lecad_planetary_program():
    """LECAD, uni-lj.si: m 1.75, 21/43/108, a 56.8, x 0.438/0.0426/0: tips, spans, ratio; the ring's x to 4e-5."""
    sun, planet, outer = (
        replace(form, normal_module=1.75)
        for form in (pinion(21, 0.438), pinion(43, 0.0426), ring(108, cutter_teeth=0, addendum=0.7))
    )
    assert [sun.tip_diameter, planet.tip_diameter] == pytest.approx([41.783, 78.8991], abs=1e-4)
    assert ring_for(sun, planet, outer, 56.8) == pytest.approx(0.0, abs=5e-5)
    assert 1 + Fraction(108, 21) == pytest.approx(6.14286, abs=5e-6)


def _overlap(planets, orbit):
    """Area of a planet at an angle of the carrier that is common with sun or ring, both at rest, best turned."""
    sun, planet, outer = (section_of(each.form, 1e-4) for each in (planets.sun, planets.planet, planets.ring))

    def polygon(corners):
        return manifold3d.CrossSection([np.column_stack([corners.real, corners.imag])])

    hole = polygon(outer.corners.ravel() * np.exp(1j * planets.ring_angle))
    inner = polygon(sun.corners.ravel())
    best = np.inf
    for turn in np.linspace(0.0, 2 * pi / planet.teeth, 41)[:-1] + planets.planet_angle(orbit):
        placed = planet.corners.ravel() * np.exp(1j * turn) + planets.centre_distance * np.exp(1j * orbit)
        one = polygon(placed)
        best = min(best, (one ^ inner).area() + (one - hole).area())
    return best


@pytest.mark.parametrize(("sun", "planet", "outer"), [(18, 27, 72), (20, 31, 82), (17, 22, 61)])
def test_planets_fit_where_polygons_say(sun, planet, outer):
    one, two = pinion(sun, deviation=-0.03), pinion(planet, deviation=-0.03)
    around = ring(outer, addendum=0.7, cutter_teeth=0)
    apart = closest(one, two)
    around = replace(around, profile_shift=ring_for(one, two, around, apart), tooth_thickness_deviation=-0.03)
    planets = PlanetarySet(
        sun=GradedGear(form=one),
        planet=GradedGear(form=two),
        ring=GradedGear(form=around),
        centre_distance=apart,
        planets=1,
    )
    step = 2 * pi / (sun + outer)
    for places in (0, 7, 23):
        assert _overlap(planets, places * step) < 1e-6
        assert _overlap(planets, (places + 0.5) * step) > 0.1


def test_a_set_from_numbers_is_made(tmp_path):
    made = Planetary(gear(18, bore=5), gear(27, bore=4), planets=3)
    assert made.ratio == 5
    assert made.ring_teeth == 72
    assert made.passed, made.failed
    assert made.return_error.least > 0
    assert [part.name for part in made.computed.layout.parts] == [
        *("sun", "planet_1", "planet_2", "planet_3", "ring", "carrier")
    ]
    written = made.write(tmp_path, formats=["step", "csv"])
    assert {file.name for file in written} >= {"planetary_train.step", "planetary_carrier.step", "planetary_parts.csv"}


def test_helical_sets_with_shifts_and_other_members_held():
    helix = {"helix_angle": radians(20)}
    one, two = gear(17, profile_shift=0.2, **helix), gear(25, hand="left", **helix)
    made = Planetary(
        one, two, gear(68, internal=True, hand="left", **helix), held="carrier", planets=3, equal=False, backlash=0.2
    )
    assert made.ratio == -4
    assert made.passed
    assert made.cut.meshes[1].backlash().pitch == pytest.approx(0.2)
    assert made.cut.meshes[0].backlash().pitch == pytest.approx(0.2)
    assert "profile shift" in "".join(made.notes)
    double = {"helix_angle": radians(25), "double": True}
    assert Planetary(gear(20, **double), gear(31, hand="left", **double)).passed


@pytest.mark.parametrize(
    ("members", "more", "said"),
    [
        ((gear(18), gear(27), gear(72)), {}, "ring has its teeth outside; give it internal=True"),
        ((gear(18), gear(27), gear(40, internal=True)), {}, "give the ring about 72 teeth"),
        ((gear(18), gear(72, internal=True)), {}, "planet is internal"),
        ((gear(18), gear(27)), {"planets": 20}, "planets is 20"),
        ((gear(18), gear(27)), {"held": "planet"}, "held"),
        ((gear(18, thickness_deviation=-0.05), gear(27)), {"backlash": 0.1}, "give one or the other"),
    ],
)
def test_what_cannot_be_is_refused(members, more, said):
    with pytest.raises(DesignError, match=said):
        Planetary(*members, **more)


def _fits(sections, apart, orbit, ring_angle):
    """Whether some angle of a planet at an orbit overlaps neither sun nor ring, tried at 80 angles over a pitch."""
    sun, planet, outer = sections

    def polygon(corners):
        return manifold3d.CrossSection([np.column_stack([corners.real, corners.imag])])

    inner, centre = polygon(sun.teeth_towards(0.0, orbit, 4)), apart * np.exp(1j * orbit)
    hole = polygon(outer.teeth_towards(ring_angle, orbit, 9))
    for turn in np.linspace(0.0, 2 * pi / planet.teeth, 81)[:-1]:
        facing = polygon(centre + planet.teeth_towards(turn, orbit + pi, 4))
        if (facing ^ inner).area() > 1e-7:
            continue
        outside = polygon(centre + planet.teeth_towards(turn, orbit, 4))
        if (outside - hole).area() < 1e-7:
            return True
    return False


@pytest.mark.parametrize("cases", [2, pytest.param(200, marks=(pytest.mark.slow, pytest.mark.long))])
def test_numbers_of_planets_that_are_possible_are_those_of_polygons(cases):
    """Random tooth counts: at equal angles N planets fit as polygons or not, and neighbours are as far apart."""
    generator, done = np.random.default_rng(31), 0
    while done < cases:
        small, middle = (int(count) for count in generator.integers(14, 32, 2))
        large = small + 2 * middle + int(generator.integers(-1, 2))
        try:
            one, two = pinion(small, deviation=-0.06), pinion(middle, deviation=-0.06)
            around = ring(large, addendum=0.7, cutter_teeth=0)
            apart = closest(one, two)
            shift = ring_for(one, two, around, apart)
            around = replace(around, profile_shift=shift, tooth_thickness_deviation=-0.06)
            planets = PlanetarySet(
                sun=GradedGear(form=one),
                planet=GradedGear(form=two),
                ring=GradedGear(form=around),
                centre_distance=apart,
                planets=1,
            )
            sections = [section_of(each, 2e-4) for each in (one, two, around)]
        except DesignError:
            continue
        done += 1
        assert _fits(sections, apart, 0.0, planets.ring_angle)
        tip = np.abs(sections[1].corners).max()
        for count in range(2, 9):
            places = apart * np.exp(2j * pi * np.arange(count) / count)
            gap = np.abs(np.diff(places)).min() - 2 * tip
            by_polygons = all(
                _fits(sections, apart, 2 * pi * number / count, planets.ring_angle) for number in range(1, count)
            )
            assert planets.spaced_equally(count) == by_polygons, (small, middle, large, count)
            if by_polygons:
                assert planets._gap(count) == pytest.approx(gap, abs=1e-6)
                assert (count in planets.counts) == (gap >= planets.clearance)
