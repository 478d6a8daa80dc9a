"""Helical gears: numbers of printed examples, and of trials that other code has computed; roots cut by polygons."""

import json
from math import acos, cos, degrees, pi, radians, sin, sqrt, tan
from pathlib import Path

import manifold3d
import numpy as np
import pytest

from cadgen.errors import DesignError
from cadgen.gears.contact import contact_ratio, found_contact_ratio, missing_shift
from cadgen.gears.inspection import inspection_of, size_over_pins, span_over
from cadgen.gears.pair import GradedGear, Pair, closest
from cadgen.gears.tooth import GearForm, tooth_of

TRIALS = Path(__file__).parents[1] / "data/gears2"
LAST_DIGIT = 6e-7  # the trials print six decimals


def trial(name):
    return json.loads((TRIALS / f"{name}.json").read_text())


def form_of(numbers, **more):
    """Gear by the keys of a trial."""
    return GearForm(
        teeth=numbers["z"],
        normal_module=numbers["mn"],
        width=numbers["b"],
        normal_pressure_angle=radians(numbers["alpha_deg"]),
        profile_shift=numbers["x"],
        addendum_factor=numbers["hap"],
        dedendum_factor=numbers["hfp"],
        rack_tip_radius_factor=numbers["rho"],
        tooth_thickness_deviation=numbers["E_sn"],
        helix_angle=radians(numbers["beta_deg"]),
        **more,
    )


def gear(teeth, module=1.0, width=10.0, helix=0.0, shift=0.0, **more):
    return GearForm(
        teeth=teeth, normal_module=module, width=width, profile_shift=shift, helix_angle=radians(helix), **more
    )


def pair_of(driver, driven, apart):
    return Pair(
        driver=GradedGear(form=driver), driven=GradedGear(form=driven), centre_distance=apart, bearing_span=40.0
    )


@pytest.mark.parametrize("name", ["01_helical_shifted", "03_undercut_helical", "05_z5_shift"])
def test_gears_and_pair_are_those_of_another_program(name):
    trials = trial(name)
    forms = [form_of(trials["design"][key]) for key in ("gear1", "gear2")]
    for form, key in zip(forms, ("gear1", "gear2"), strict=True):
        said, tooth = trials["expected"][key], tooth_of(form)
        deviation = form.tooth_thickness_deviation
        sizes = inspection_of(form, deviation, deviation, said["ball_D"])
        ours = {
            "d": form.reference_diameter,
            "db": form.base_diameter,
            "da": form.tip_diameter,
            "df": form.root_diameter,
            "dFf": tooth.root_form_diameter,
            "s_t": form.tooth_thickness,
            "tip_land": tooth.tip_land,
            "area_mm2": tooth.outline.area,
            "span_k": sizes.span.teeth_spanned,
            "span_W": sizes.span.span.upper,
            "span_width_needed": sizes.span.width_needed,
            "ball_M": sizes.pins.over_pins.upper,
            "alpha_t_deg": degrees(form.transverse_pressure_angle),
            "beta_b_deg": degrees(form.base_helix_angle),
        }
        assert ours == pytest.approx({each: said[each] for each in ours}, abs=LAST_DIGIT)
        assert tooth.undercut == said["undercut"]
        if tooth.undercut:
            short = said["x_min_no_undercut"] - form.generating_profile_shift
            assert missing_shift(form) == pytest.approx(short, abs=LAST_DIGIT)
    meshing, said = pair_of(*forms, trials["design"]["a"]), trials["expected"]["pair"]
    play = meshing.backlash()
    ours = {
        "a_tight": meshing.zero_backlash_centre_distance,
        "alpha_wt_deg": degrees(meshing.working_pressure_angle),
        "eps_alpha": contact_ratio(meshing),
        "eps_beta": meshing.overlap_ratio,
        "axial_force_per_tangential": meshing.axial_force,
        "j_bt_um": play.base * 1e3,
        "j_bn_um": play.normal * 1e3,
        "j_wt_um": play.pitch * 1e3,
        "free_angle_driver_deg": degrees(play.driver_angle),
        "free_angle_driven_deg": degrees(play.driven_angle),
    }
    assert ours == pytest.approx({each: said[each] for each in ours}, abs=LAST_DIGIT)
    assert found_contact_ratio(meshing) == pytest.approx(said["eps_alpha"], abs=5e-4)


@pytest.mark.parametrize(("teeth", "helix", "shift"), [(20, 20.0, 0.0), (9, 30.0, 0.2), (30, 45.0, -0.1)])
def test_the_root_is_what_a_rack_with_a_round_tip_in_its_normal_section_leaves(teeth, helix, shift):
    form = gear(teeth, helix=helix, shift=shift)
    stretch, radius = 1 / cos(radians(helix)), form.reference_diameter / 2
    # The normal section of the rack's tooth that cuts the space: flank, round tip, flat; then stretched along x.
    tip, angle, depth = 0.38, radians(20.0), 1.25 - shift
    turn = np.linspace(0.0, pi / 2 - angle, 200)
    middle = pi / 4 - (1.25 - tip) * tan(angle) - tip / cos(angle)
    right = np.column_stack([middle + tip * np.sin(turn), -depth + tip * (1 - np.cos(turn))])
    up = 3.0
    high = right[-1] + np.array([up * tan(angle), up])
    half = np.vstack([right, high])
    rack = np.vstack([half, half[::-1] * [-1, 1]]) * [stretch, 1.0]
    pitch = 2 * pi / teeth
    blank = np.linspace(-pitch / 2, pitch / 2, 2000)
    sector = np.vstack([[0.0, 0.0], form.tip_diameter / 2 * np.column_stack([np.cos(blank), np.sin(blank)])])
    left = manifold3d.CrossSection([sector])
    for rolled in np.linspace(-4.0 * stretch, 4.0 * stretch, 1601):
        placed = (radius + rack[::-1, 1]) + 1j * (rack[::-1, 0] + rolled)
        turned = placed * np.exp(-1j * rolled / radius)
        left -= manifold3d.CrossSection([np.column_stack([turned.real, turned.imag])])
    # The centre of the rack's tooth is a space's, so the tooth that is left is split in two.
    assert left.area() * teeth == pytest.approx(tooth_of(form).outline.area, abs=2e-5 * teeth)


def test_areas_follow_from_points():
    tooth = tooth_of(gear(13, helix=35.0, shift=0.1))
    points = tooth.upper_root.point(np.linspace(0.0, 1.0, 20001))
    area = 0.5 * float(np.sum((np.conj(points[:-1]) * points[1:]).imag))
    assert tooth.upper_root.swept_area() == pytest.approx(area, abs=1e-8)


def test_khk_helical_pair_of_the_normal_system():
    """KHK, SDP/SI D785 table 4-3: m_n 3, 30°, 12 and 60 teeth, x 0.09809 and 0."""
    one, two = gear(12, 3.0, 20.0, 30.0, 0.09809), gear(60, 3.0, 20.0, -30.0)
    apart = closest(one, two)
    meshing = pair_of(one, two, apart)
    assert apart == pytest.approx(125.000, abs=5e-4)
    assert degrees(meshing.working_pressure_angle) == pytest.approx(23.1126, abs=5e-5)
    assert [one.reference_diameter, two.reference_diameter] == pytest.approx([41.569, 207.846], abs=5e-4)
    # Tips are cut by k, so that they clear the roots as those of an unshifted pair do; the table cuts digits off.
    short = (apart - (one.reference_diameter + two.reference_diameter) / 2) / 3.0 - 0.09809
    tips = [form.tip_diameter + 6.0 * short for form in (one, two)]
    assert tips == pytest.approx([48.153, 213.842], abs=1e-3)


def test_khk_spans_and_sizes_over_pins():
    """KHK: span of m 3 z 24 x 0.4 over 4 teeth and of a helix of 25°; pins of m 1 z 20, and of 15° with x 0.4."""
    assert span_over(gear(24, 3.0, shift=0.4), 4) == pytest.approx(32.8266, abs=5e-5)
    assert span_over(gear(24, 3.0, 60.0, helix=25.0, shift=0.4), 5) == pytest.approx(42.0085, abs=5e-5)
    assert size_over_pins(gear(20), 1.7) == pytest.approx(22.2941, abs=5e-5)
    assert size_over_pins(gear(20, helix=15.0, shift=0.4), 2.0) == pytest.approx(24.5696, abs=5e-5)


def test_iso_6336_example_and_a_sheet_by_iso_21771():
    """ISO/TR 6336-30 example 1 by the tests of gearcore, to 1e-11; a sheet of m_n 3.5, 21°, 31/30 at 116.5."""
    one = gear(17, 8.0, 100.0, 15.8)
    assert one.reference_diameter == pytest.approx(141.34011306644808, abs=1e-11)
    assert one.base_diameter == pytest.approx(132.19856920126215, abs=1e-11)
    meshing = pair_of(gear(31, 3.5, 30.0, 21.0), gear(30, 3.5, 30.0, -21.0), 116.5)
    mesh = meshing.working_pressure_angle
    assert degrees(mesh) == pytest.approx(23.8707609654, abs=5e-11)
    alpha = meshing.driver.form.transverse_pressure_angle
    opened = tan(mesh) - mesh - tan(alpha) + alpha
    shifts = 61 * opened / (2 * tan(radians(20.0)))
    assert shifts == pytest.approx(0.6518771313, abs=6e-11)
    assert shifts - 0.03 / (2 * 3.5 * sin(radians(20.0))) == pytest.approx(0.639346541, abs=5e-10)


def test_mesys_calculator():
    """MESYS: z 20, m 1, rack tip 0.25: form circle, balls and where they and the span touch."""
    form = gear(20, rack_tip_radius_factor=0.25)
    assert tooth_of(form).root_form_diameter == pytest.approx(18.8003, abs=5e-5)
    sizes = inspection_of(form, 0.0, 0.0, 1.7)
    assert sizes.pins.over_pins.upper == pytest.approx(22.2941, abs=5e-5)
    assert sizes.pins.contact_diameter == pytest.approx(19.9594, abs=5e-5)
    assert tooth_of(form).tip_land == pytest.approx(0.6949, abs=5e-5)
    assert sqrt(form.base_diameter**2 + span_over(form, 2) ** 2) == pytest.approx(19.3746, abs=5e-5)


def test_balls_touch_the_helicoid_in_space():
    """A ball of the size that is said touches the flank's surface, searched without the formula of its centre."""
    form, ball = gear(21, 2.0, 30.0, 24.0, 0.2), 3.6
    size = size_over_pins(form, ball)
    centre = (size - ball) / cos(pi / 42) / 2
    radius = form.base_diameter / 2
    space = pi / 21
    at = 0.0
    roll = np.linspace(0.05, 0.9, 1201)[:, None]
    rate = 2 * tan(radians(24.0)) / form.reference_diameter
    for span in (1.0, 0.02):
        middle = 0.0 if span > 0.5 else at
        height = np.linspace(middle - span, middle + span, 1201)[None, :]
        # The flank of the tooth below the space in the middle of which the ball lies.
        around = form.base_half_angle - (roll - np.arctan(roll)) - space + rate * height
        reach = radius * np.sqrt(1 + roll**2)
        off = np.sqrt((reach * np.cos(around) - centre) ** 2 + (reach * np.sin(around)) ** 2 + height**2)
        nearest, at = off.min(), float(height[0, np.unravel_index(off.argmin(), off.shape)[1]])
    assert nearest == pytest.approx(ball / 2, abs=5e-6)  # the grid is that coarse
    assert at != 0.0


@pytest.mark.parametrize(
    ("driver", "driven", "said"),
    [
        (gear(20, helix=20.0), gear(40, helix=20.0), 'has the hand "right" twice'),
        (gear(20, helix=20.0), gear(40, helix=-15.0), "helix angles 20° and 15°; give both gears one"),
        (gear(20, helix=20.0), gear(40, helix=-20.0, double=True), "make both double, or neither"),
    ],
)
def test_helices_that_do_not_match_are_refused(driver, driven, said):
    with pytest.raises(DesignError, match=said):
        pair_of(driver, driven, 32.0)


def test_a_helix_that_turns_too_far_is_refused_with_a_width_that_does_not():
    with pytest.raises(DesignError, match="give a width_mm of at most") as refused:
        gear(10, width=60.0, helix=45.0)
    widest = float(str(refused.value).split("at most ")[1].split(",")[0])
    assert widest > 8.0
    assert gear(10, width=widest, helix=45.0).width == widest
    with pytest.raises(DesignError, match="at most 45°"):
        gear(20, helix=50.0)
    with pytest.raises(DesignError, match="helix_angle_deg"):
        gear(20, double=True)


def test_play_of_a_helical_pair_is_that_of_its_transverse_section():
    """Half angles of both teeth at the working pitch circles fill the pitch up to the play: no formula of j."""
    one, two = gear(23, helix=18.0, shift=0.3).cut_to(-0.05), gear(31, helix=-18.0).cut_to(-0.02)
    apart = closest(one, two) + 0.04
    meshing = pair_of(one, two, apart)
    arcs = 0.0
    for form in (one, two):
        pitch = 2 * apart * form.teeth / 54
        mesh = acos(form.base_diameter / pitch)
        half = form.base_half_angle - (tan(mesh) - mesh)
        arcs += pitch * half
    whole = 2 * pi * apart / 54
    assert meshing.backlash().pitch == pytest.approx(whole - arcs, abs=1e-12)


def test_sdp_si_chordal_thickness():
    """SDP/SI D785, tables 10-1 and 10-3: m 10 z 12 x 0.3; m_n 5 z 16 β 25° x 0.2, on the virtual gear."""
    spur = gear(12, 10.0, 20.0, shift=0.3)
    half = spur.tooth_thickness / spur.reference_diameter
    assert spur.reference_diameter * sin(half) == pytest.approx(17.8256, abs=5e-5)
    height = spur.tip_diameter / 2 - spur.reference_diameter / 2 * cos(half)
    assert height == pytest.approx(13.6657, abs=5e-5)
    helical = gear(16, 5.0, 20.0, 25.0, 0.2)
    virtual = 16 / cos(radians(25)) ** 3 * 5.0
    half = helical.tooth_thickness * cos(radians(25)) / virtual
    assert virtual * sin(half) == pytest.approx(8.5728, abs=5e-5)
    height = (helical.tip_diameter - helical.reference_diameter) / 2 + virtual / 2 * (1 - cos(half))
    assert height == pytest.approx(6.1712, abs=5e-5)


def test_shifted_spur_pairs_of_other_programs():
    """bolsover.com: m 3, 12/24 at 56.5, Σx 0.96; hanslhansl/din3990: m 4, 19/104, x 0.5/0.15."""
    meshing = pair_of(gear(12, 3.0, shift=0.6), gear(24, 3.0, shift=0.36), 56.5)
    assert degrees(meshing.working_pressure_angle) == pytest.approx(26.0888, abs=5e-5)
    assert meshing.zero_backlash_centre_distance == pytest.approx(56.5, abs=2e-4)
    assert closest(gear(19, 4.0, shift=0.5), gear(104, 4.0, shift=0.15)) == pytest.approx(248.506843355171, abs=1e-11)
