"""Gears, pairs and trains: what is refused, and the exact geometry of play."""

from dataclasses import replace
from fractions import Fraction
from math import acos, cos, degrees, pi, radians, tan

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from cadgen.errors import DesignError
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train

teeth = st.integers(8, 200)
shifts = st.floats(-0.2, 0.6)


def gear(z: int, module: float = 0.5, **form: float) -> GradedGear:
    return GradedGear(form=GearForm(teeth=z, normal_module=module, width=5.0, **form))


def pair(z1: int, z2: int, module: float = 0.5, x1: float = 0.0, x2: float = 0.0) -> SpurPair:
    one, two = gear(z1, module, profile_shift=x1), gear(z2, module, profile_shift=x2)
    # Any distance at which the teeth do not jam serves to ask for the zero-backlash distance.
    loose = module * ((z1 + z2) / 2 + max(0.0, x1 + x2))
    probe = SpurPair(driver=one, driven=two, centre_distance=loose, bearing_span=80.0)
    return replace(probe, centre_distance=probe.zero_backlash_centre_distance)


def involute(angle: float) -> float:
    return tan(angle) - angle


def thickness(form: GearForm, deviation: float, diameter: float) -> float:
    """Tooth thickness on any circle: D (s/d + inv α − inv α_D)."""
    at_reference = form.normal_module * (pi / 2 + 2 * form.profile_shift * tan(form.normal_pressure_angle))
    return diameter * (
        (at_reference + deviation) / form.reference_diameter
        + involute(form.normal_pressure_angle)
        - involute(acos(form.base_diameter / diameter))
    )


def test_a_shifted_pair_meshes_where_the_handbook_says():
    # KHK gear technical reference, "profile shifted spur gear": m 3, z 12/24, x 0.6/0.36.
    meshing = pair(12, 24, 3.0, 0.6, 0.36)
    assert meshing.centre_distance == pytest.approx(56.4999, abs=5e-5)
    assert degrees(meshing.working_pressure_angle) == pytest.approx(26.0886, abs=5e-5)
    assert 2 * meshing.driven_pitch_radius == pytest.approx(75.333, abs=5e-4)


def has_working_angle(z1: int, z2: int, x1: float, x2: float) -> bool:
    """Whether a working pressure angle has the involute that these shifts ask for."""
    alpha = radians(20.0)
    return tan(alpha) - alpha + 2 * tan(alpha) * (x1 + x2) / (z1 + z2) > 0


@given(teeth, teeth, shifts, shifts, st.floats(0, 0.3), st.floats(-0.2, 0.0), st.floats(-0.2, 0.0))
def test_play_is_the_pitch_less_both_thicknesses_on_the_working_pitch_circles(z1, z2, x1, x2, apart, e1, e2):
    assume(has_working_angle(z1, z2, x1, x2))
    meshing = pair(z1, z2, 1.0, x1, x2)
    axes = meshing.centre_distance + apart
    radius = axes * z2 / (z1 + z2)
    pitch = 2 * pi * radius / z2
    taken = sum(
        thickness(made.form, e, 2 * axes * made.form.teeth / (z1 + z2))
        for made, e in ((meshing.driver, e1), (meshing.driven, e2))
    )
    angle = meshing.base_backlash(axes, e1 + e2) / (meshing.driven.form.base_diameter / 2)
    assert angle * radius == pytest.approx(pitch - taken, abs=1e-9)


@given(teeth, teeth, shifts, shifts, st.floats(0, 0.3), st.floats(-0.2, 0.0), st.floats(0.1, 10))
def test_play_scales_with_every_length(z1, z2, x1, x2, apart, deviation, factor):
    assume(has_working_angle(z1, z2, x1, x2))
    one, other = pair(z1, z2, 1.0, x1, x2), pair(z1, z2, factor, x1, x2)
    axes = one.centre_distance + apart
    assert other.base_backlash(factor * axes, factor * deviation) == pytest.approx(
        factor * one.base_backlash(axes, deviation), abs=1e-9 * factor
    )


@given(teeth, teeth, shifts, shifts)
def test_teeth_of_nominal_thickness_have_no_play_at_the_zero_backlash_distance(z1, z2, x1, x2):
    assume(has_working_angle(z1, z2, x1, x2))
    meshing = pair(z1, z2, 1.0, x1, x2)
    assert meshing.base_backlash(meshing.centre_distance) == pytest.approx(0, abs=1e-12 * (z1 + z2))


@given(st.lists(st.tuples(teeth, teeth), min_size=1, max_size=5), st.randoms())
def test_the_ratio_is_exact_and_free_of_the_order(choice, random):
    train = Train(tuple(pair(z1, z2) for z1, z2 in choice))
    order = list(range(len(choice)))
    random.shuffle(order)
    shuffled = train.reordered(order)
    product = Fraction(1)
    for z1, z2 in choice:
        product *= Fraction(z2, z1)
    assert shuffled.ratio == train.ratio == product
    assert train.output_ratios[-1] == 1
    assert train.output_ratios[0] * train.stages[0].ratio == train.ratio


def test_by_the_standard_drops_every_override():
    plain = pair(30, 150)
    overridden = replace(
        plain,
        driver=replace(plain.driver, overrides=ToleranceOverrides(b_r=0.052)),
        centre_distance_deviation=0.01,
    )
    assert overridden != plain
    assert Train((overridden,)).by_the_standard() == Train((plain,))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"driven": gear(150, 0.6)}, "joins the modules 0.5 and 0.6 mm; give both gears one module"),
        (
            {"driven": gear(150, normal_pressure_angle=radians(14.5))},
            "joins the pressure angles 20° and 14.5°; give both gears one pressure angle",
        ),
        ({"centre_distance": 44.999}, "jams at the centre distance 44.999 mm; give at least 45 mm"),
        ({"centre_distance": 4.5}, "jams at the centre distance 4.5 mm"),
        ({"centre_distance": float("nan")}, "jams at the centre distance nan mm"),
        ({"centre_distance": 46.0}, "does not meet at the centre distance 46 mm; give less than 46 mm"),
        ({"bearing_span": 0.0}, "bearing span 0 mm; give one above 0"),
        ({"centre_distance_deviation": -0.01}, "centre distance deviation -0.01 mm; give 0 or more"),
    ],
)
def test_a_pair_that_cannot_mesh_is_refused(change, said):
    with pytest.raises(DesignError, match=f"the pair of 30 and 150 teeth .*{said}"):
        replace(pair(30, 150), **change)


def test_a_centre_distance_rounded_to_the_micrometre_is_not_too_small():
    meshing = pair(13, 40, 1.0, 0.3, 0.1)
    rounded = round(meshing.centre_distance, 3)
    assert rounded < meshing.centre_distance
    assert replace(meshing, centre_distance=rounded).centre_distance == rounded


@given(shifts, shifts)
def test_overlapping_base_circles_have_no_play_to_speak_of(x1, x2):
    meshing = pair(20, 30, 1.0, x1, x2)
    assume(meshing.centre_distance > 0)
    with pytest.raises(DesignError, match=r"overlapping base circles .* give at least 23\.4923 mm"):
        meshing.base_backlash(25 * cos(radians(20)) - 1e-3)


@pytest.mark.parametrize("grade", [2, 13, 7.5])
def test_a_grade_outside_the_standards_is_refused(grade):
    with pytest.raises(DesignError, match=f"20 teeth .* tolerance grade {grade}; .* 3 to 12"):
        replace(gear(20), grade=grade)


def test_profile_shifts_that_no_centre_distance_allows_are_refused():
    with pytest.raises(DesignError, match="profile shifts of -3 together"):
        SpurPair(
            driver=gear(10, profile_shift=-1.5),
            driven=gear(10, profile_shift=-1.5),
            centre_distance=5.0,
            bearing_span=80.0,
        )


def test_fewer_than_four_teeth_and_no_stage_at_all_are_refused():
    with pytest.raises(DesignError, match="3 teeth"):
        gear(3)
    with pytest.raises(DesignError, match="no stage"):
        Train(())
