"""Play and clearances measured on sections, against exact involutes, the paper and limit cases."""

from dataclasses import replace
from math import degrees, pi

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from cadgen.errors import CheckError, DesignError
from cadgen.gears.contact import contact_ratio
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned, train_play
from cadgen.geometry.meshes.teeth import (
    LEAST_OVERLAP,
    MeasuredPair,
    measured_pair,
    return_error,
    section_of,
)

# The error that `mesh_check` argues, in mm of arc: four chord tolerances, what is not seen, and the search's step.
MEASURING_ERROR = 0.06e-3
BAR = 0.5e-3


def pair(z1: int, z2: int, module: float = 0.5, x1: float = 0.0, x2: float = 0.0, **overrides: float) -> SpurPair:
    one, two = (
        GradedGear(form=GearForm(teeth=z, normal_module=module, width=5.0, profile_shift=x))
        for z, x in ((z1, x1), (z2, x2))
    )
    loose = module * ((z1 + z2) / 2 + max(0.0, x1 + x2))
    one = replace(one, overrides=ToleranceOverrides(**overrides))
    probe = SpurPair(driver=one, driven=two, centre_distance=loose, bearing_span=80.0)
    return replace(probe, centre_distance=probe.zero_backlash_centre_distance)


@pytest.fixture(scope="module")
def paper():
    return train_play(Train((pair(30, 150, b_r=0.052), pair(40, 120), pair(40, 120))))


def arc(made: SpurPair, apart: float) -> float:
    """Exact play as an arc of the nominal pitch circle of the driven gear, mm."""
    deviation = sum(gear.form.tooth_thickness_deviation for gear in (made.driver, made.driven))
    return made.base_backlash(apart, deviation) / (made.driven.form.base_diameter / 2) * made.driven_pitch_radius


def test_the_greatest_play_is_that_of_equation_13(paper):
    """Bar: 0.5 µm of arc. What is left is the second order, cot α Δ²/a, in the opening of the axes."""
    for given_pair, found in zip(paper.train.stages[:2], paper.stages[:2], strict=True):
        loose = given_pair.cut_to(found.driver.E_sni, found.driven.E_sni)
        opened = found.f_a + found.driver.tolerances.F_i_radial + found.driven.tolerances.F_i_radial
        measured = measured_pair(loose, given_pair.centre_distance + opened).play(0.1) * given_pair.driven_pitch_radius
        off = measured - found.j_wt_max
        second = opened**2 / given_pair.centre_distance / np.tan(np.radians(20))
        print(f"\nplay {1e3 * measured:.3f} µm, eq. 13 {1e3 * found.j_wt_max:.3f}, off {1e3 * off:.3f}")
        assert abs(off) <= BAR
        assert off == pytest.approx(second, abs=MEASURING_ERROR)


def test_the_least_play_is_that_of_the_equations(paper):
    given_pair, found = paper.train.stages[0], paper.stages[0]
    tight = given_pair.cut_to(found.driver.E_sns, found.driven.E_sns)
    measured = measured_pair(tight, given_pair.centre_distance - found.f_a).play(0.0) * given_pair.driven_pitch_radius
    assert measured == pytest.approx(found.j_wt_min, abs=BAR)


def test_the_return_error_of_the_train_is_that_of_equation_25(paper):
    """At the greatest play of every stage; the paper prints 0.962°."""
    stages, second = [], 0.0
    for given_pair, found, ratio in zip(paper.train.stages, paper.stages, paper.train.output_ratios, strict=True):
        loose = given_pair.cut_to(found.driver.E_sni, found.driven.E_sni)
        opened = found.f_a + found.driver.tolerances.F_i_radial + found.driven.tolerances.F_i_radial
        stages.append(measured_pair(loose, given_pair.centre_distance + opened))
        of_stage = opened**2 / given_pair.centre_distance / np.tan(np.radians(20)) / given_pair.driven_pitch_radius
        second += of_stage / float(ratio)
    measured = return_error(stages, 0.02)
    print(f"\nreturn error measured {degrees(measured):.4f}°, eq. 25 {degrees(paper.return_error_max):.4f}°")
    radius = paper.train.stages[-1].driven_pitch_radius
    assert (measured - paper.return_error_max - second) * radius == pytest.approx(0, abs=2 * MEASURING_ERROR)
    assert abs(measured - paper.return_error_max) * radius <= 1.5 * BAR


def test_the_return_error_as_cut_over_a_turn_of_the_drive(paper):
    cut = thinned(paper.train).stages
    stages = [measured_pair(made) for made in cut]
    computed = sum(
        arc(made, made.centre_distance) / made.driven_pitch_radius / float(ratio)
        for made, ratio in zip(cut, paper.train.output_ratios, strict=True)
    )
    for angle in (0.0, 1.3):
        assert (return_error(stages, angle) - computed) * 30.0 == pytest.approx(0.0, abs=2 * MEASURING_ERROR)


teeth = st.integers(17, 150)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(teeth, teeth, st.floats(0.3, 3.0), st.floats(-0.2, 0.4), st.floats(-0.2, 0.4), st.floats(0.01, 0.1))
def test_any_pair_has_the_play_of_exact_involutes(z1, z2, module, x1, x2, thinning):
    try:
        made = pair(z1, z2, module, x1, x2).cut_to(-thinning * module, -thinning * module)
        assume(contact_ratio(made) > 1.0)
        measured = measured_pair(made)
        assume(min(measured.clearances()) > 0)
        play = measured.play(0.3)
    except (DesignError, CheckError):
        assume(False)
    assert play * made.driven_pitch_radius == pytest.approx(arc(made, made.centre_distance), abs=MEASURING_ERROR)


def test_clearances_are_the_basic_rack_s():
    """Profile A leaves 0.25 m, and thinning each gear by E opens the roots by E / (2 tan α)."""
    made = pair(30, 150).cut_to(-0.05, -0.1)
    at_driven_root, at_driver_root = measured_pair(made).clearances()
    assert at_driven_root == pytest.approx(0.125 + 0.1 / 2 / np.tan(np.radians(20)), abs=1e-6)
    assert at_driver_root == pytest.approx(0.125 + 0.05 / 2 / np.tan(np.radians(20)), abs=1e-6)


def test_overlap_begins_where_the_play_ends_all_over_a_pitch():
    made = pair(40, 120).cut_to(-0.05, -0.05)
    measured = measured_pair(made)
    half, step = arc(made, made.centre_distance) / 2 / 30.0, 0.5e-3 / 30.0
    for angle in 2 * pi / 40 * np.arange(12) / 12:
        for side in (-1, 1):
            middle = measured.middle(angle)
            assert measured.overlap(angle, middle + side * (half - step)) <= LEAST_OVERLAP
            assert measured.overlap(angle, middle + side * (half + step)) > LEAST_OVERLAP


def test_thickened_teeth_and_axes_too_far_apart_are_said():
    jammed = measured_pair(pair(30, 60).cut_to(0.02, 0.0))
    with pytest.raises(CheckError, match="overlap midway"):
        jammed.play(0.0)
    section = section_of(pair(30, 60).driver.form)
    with pytest.raises(CheckError, match="pass each other freely"):
        MeasuredPair(section, section, 99.0).play(0.0)
