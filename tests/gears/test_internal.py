"""Internal gears: trials of another program, printed examples, and polygons that roll in each other."""

import json
import re
from dataclasses import replace
from math import cos, degrees, pi, radians, sin, tan
from pathlib import Path

import manifold3d
import numpy as np
import pytest
from shapely import Polygon
from shapely.affinity import rotate, translate

from cadgen import Gear, GearPair
from cadgen.errors import DesignError
from cadgen.gears.contact import contact_ratio, found_contact_ratio
from cadgen.gears.inspection import inspection_of, size_over_pins, span_over
from cadgen.gears.internal import greatest_addendum, require_free, reserves
from cadgen.gears.pair import GradedGear, closest
from cadgen.gears.ring import RingForm, TipMesh, cutter_of, placed_cutter, ring_of, ring_tooth
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm, ToothError
from cadgen.geometry.meshes.teeth import measured_pair

TRIALS = Path(__file__).parents[1] / "data/gears2"
LAST_DIGIT = 6e-7


def trial(name):
    return json.loads((TRIALS / f"{name}.json").read_text())


def form_of(numbers):
    """Gear by the keys of a trial."""
    form = GearForm(
        teeth=numbers["z"],
        normal_module=numbers["mn"],
        width=numbers["b"],
        profile_shift=numbers["x"],
        addendum_factor=numbers["hap"],
        tooth_thickness_deviation=numbers["E_sn"],
        helix_angle=radians(numbers["beta_deg"]),
    )
    if not numbers["internal"]:
        return form
    return ring_of(form, cutter_teeth=numbers["z0"], root_rounding=numbers["rho0"], keeps_addendum=True)


def pinion(teeth, shift=0.0, deviation=0.0, helix=0.0, **more):
    return GearForm(
        teeth=teeth,
        normal_module=1.0,
        width=8.0,
        profile_shift=shift,
        tooth_thickness_deviation=deviation,
        helix_angle=radians(helix),
        **more,
    )


def ring(teeth, shift=0.0, deviation=0.0, helix=0.0, addendum=1.0, **more):
    return ring_of(pinion(teeth, shift, deviation, helix, addendum_factor=addendum), **more)


def pair_of(driver, driven, apart):
    return SpurPair(
        driver=GradedGear(form=driver), driven=GradedGear(form=driven), centre_distance=apart, bearing_span=40.0
    )


def test_ring_and_pair_are_those_of_another_program():
    trials = trial("07_internal_ok")
    one, two = (form_of(trials["design"][key]) for key in ("gear1", "gear2"))
    said, tooth = trials["expected"]["gear2"], ring_tooth(two)
    sizes = inspection_of(two, two.tooth_thickness_deviation, two.tooth_thickness_deviation, said["ball_D"])
    ours = {
        "d": two.reference_diameter,
        "db": two.base_diameter,
        "da": two.tip_diameter,
        "df": two.root_diameter,
        "dFf": tooth.root_form_diameter,
        "s_t": two.tooth_thickness,
        "tip_land": tooth.tip_land,
        "area_mm2": tooth.outline.area,
        "span_W": span_over(two, int(said["span_k"])),
        "ball_M": sizes.pins.over_pins.upper,
    }
    assert ours == pytest.approx({each: said[each] for each in ours}, abs=LAST_DIGIT)
    meshing, said = pair_of(one, two, trials["design"]["a"]), trials["expected"]["pair"]
    play, room = meshing.backlash(), reserves(meshing)
    clearances = measured_pair(meshing).clearances()
    ours = {
        "a_tight": meshing.zero_backlash_centre_distance,
        "alpha_wt_deg": degrees(meshing.working_pressure_angle),
        "eps_alpha": contact_ratio(meshing),
        "j_bt_um": play.base * 1e3,
        "j_wt_um": play.pitch * 1e3,
        "free_angle_driver_deg": degrees(play.driver_angle),
        "free_angle_driven_deg": degrees(play.driven_angle),
        "reserve_involute_mm": room.involute,
        "reserve_ring_root_mm": room.ring_root,
        "reserve_trochoid_rad": room.trochoid,
        "reserve_trimming_rad": room.trimming,
    }
    assert ours == pytest.approx({each: said[each] for each in ours}, abs=LAST_DIGIT)
    assert clearances == pytest.approx([said["tip_clearance_1"], said["tip_clearance_2"]], abs=2e-5)
    assert found_contact_ratio(meshing) == pytest.approx(said["eps_alpha"], abs=5e-4)


def test_ring_tips_that_dig_in_are_shortened_or_refused_with_what_does_not():
    trials = trial("08_internal_full_addendum")
    one, two = (form_of(trials["design"][key]) for key in ("gear1", "gear2"))
    two = replace(two, cutter_teeth=0)  # with full tips that of 20 teeth would not reach them, and is refused before
    said = trials["expected"]
    meshing = pair_of(one, two, trials["design"]["a"])
    assert reserves(meshing).involute == pytest.approx(said["pair"]["reserve_involute_mm"], abs=LAST_DIGIT)
    assert greatest_addendum(meshing) == pytest.approx(said["greatest_ring_hap"], abs=LAST_DIGIT)
    with pytest.raises(DesignError, match=r"addendum_factor is 1; give the ring at most 0\.9"):
        meshing.fitted()
    cured = pair_of(one, replace(two, addendum_factor=0.9), meshing.centre_distance)
    assert cured.fitted() == cured
    fitted = pair_of(one, replace(two, keeps_addendum=False), meshing.centre_distance).fitted()
    tips = fitted.driven.form.tip_diameter
    assert said["least_ring_tip_diameter"] <= tips < said["least_ring_tip_diameter"] + 0.12
    assert "shortened to an addendum_factor of 0.8" in "".join(fitted.notes(1))
    # Polygons see the tips meet the fillets; shortened, the play is that of the formula.
    arc = meshing.driven_pitch_radius * 1e3
    assert (measured_pair(meshing).play(0.0) - meshing.free_angle()) * arc < -10
    assert (measured_pair(fitted).play(0.0) - fitted.free_angle()) * arc == pytest.approx(0, abs=0.06)


PLAYS = {
    "spur": (pinion(22, 0.2, -0.03), ring(52, -0.1, -0.04, addendum=0.7), -0.01),
    "helical": (pinion(20, 0.1, -0.03, 15.0), ring(60, 0.2, -0.03, 15.0, addendum=0.7), -0.02),
    "arc": (pinion(18, 0.0, -0.05, -25.0), ring(40, 0.0, 0.0, -25.0, addendum=0.7, cutter_teeth=0), 0.0),
}


@pytest.mark.parametrize("name", PLAYS)
def test_play_of_the_polygons_is_that_of_the_formula_whoever_drives(name):
    one, two, nearer = PLAYS[name]
    apart = closest(one, two) + nearer
    for driver, driven in ((one, two), (two, one)):
        meshing = pair_of(driver, driven, apart)
        measured = measured_pair(meshing)
        for angle in (0.0, 0.05):
            off = measured.play(angle) - meshing.free_angle()
            assert off * meshing.driven_pitch_radius * 1e3 == pytest.approx(0, abs=0.06)
    # An internal pair's play grows as its axes come nearer.
    assert meshing.exact_play(apart - 0.01) > meshing.exact_play()


def test_half_angles_fill_the_pitch_up_to_the_play():
    one, two, nearer = PLAYS["helical"]
    apart = closest(one, two) + nearer
    arcs = []
    for form in (one, two):
        pitch = 2 * apart * form.teeth / 40
        mesh = np.arccos(form.base_diameter / pitch)
        arcs.append(pitch * (form.base_half_angle - (np.tan(mesh) - mesh)))
    assert pair_of(one, two, apart).backlash().pitch == pytest.approx(arcs[1] - arcs[0], abs=1e-12)


@pytest.mark.parametrize("numbers", [(60, 0.0, 25), (40, -0.3, 16), (36, 0.4, 12)])
def test_the_cutter_rolled_through_the_ring_leaves_its_root(numbers):
    """A cutter's polygon, with round tips of its own, swept by rolling, covers the space and no more."""
    teeth, shift, cutting = numbers
    form = ring(teeth, shift, -0.05, cutter_teeth=cutting, addendum=0.7)
    tooth, cutter = ring_tooth(form), cutter_of(form)
    base, tip, rounding = cutter.base_radius, cutter.tip_radius, cutter.rounding
    # The cutter's tooth from its own numbers: pi / (2 z0) at the reference circle, involute, round corner, tip.
    half = pi / (2 * cutting) + tan(radians(20)) - radians(20)
    centre = tip - rounding
    angle = half - rounding / base - np.tan(np.arccos(base / centre)) + np.arccos(base / centre)
    roll_end = np.sqrt((centre / base) ** 2 - 1) + rounding / base
    roll = np.linspace(0.0, roll_end, 400)
    flank = base * np.exp(1j * (half - roll)) * (1 + 1j * roll)
    turn = np.linspace(half - roll_end + pi / 2, angle, 200)
    corner = centre * np.exp(1j * angle) + rounding * np.exp(1j * turn)
    upper = np.concatenate([flank, corner])
    one = np.concatenate([[0.0], np.conj(upper), upper[::-1]])
    space = manifold3d.CrossSection()
    for rolled in np.linspace(-1.2, 1.2, 1201) * pi * 2 / cutting:
        placed = (cutter.axes_apart + one * np.exp(1j * rolled)) * np.exp(-1j * rolled * cutting / teeth)
        space += manifold3d.CrossSection([np.column_stack([placed.real, placed.imag])])
    turns = np.exp(1j * np.linspace(-pi / teeth, pi / teeth, 400))
    outer, inner = 1.1 * form.root_diameter / 2 * turns, form.tip_diameter / 2 * turns
    sector = np.concatenate([outer, inner[::-1]])
    cut = space ^ manifold3d.CrossSection([np.column_stack([sector.real, sector.imag])])
    exact = tooth.outline.area / teeth - (form.tip_diameter / 2) ** 2 * pi / teeth
    assert cut.area() == pytest.approx(exact, abs=1e-4)
    assert abs(complex(tooth.upper_root.point(0.0)) - complex(tooth.upper_flank.point(1.0))) < 1e-12


@pytest.mark.parametrize("wanted", [3, pytest.param(30, marks=(pytest.mark.slow, pytest.mark.long))])
def test_reserves_have_the_sign_that_polygons_have(wanted):
    """Pairs at zero play: overlaps beside the line of action are the trochoid's, on the way in the trimming's."""
    found = {"trochoid": [], "trimming": []}
    generator = np.random.default_rng(30)

    def fewest():
        signs = [[sign for sign, _ in each] for each in found.values()]
        return min(each.count(sign) for each in signs for sign in (True, False))

    while fewest() < wanted:
        small = int(generator.integers(14, 40))
        large = small + int(generator.integers(4, 22))
        shift = float(generator.uniform(-0.2, 0.4))
        try:
            one = pinion(small, shift)
            two = ring(
                large, float(generator.uniform(-0.4, 0.2)), addendum=float(generator.uniform(0.5, 0.8)), cutter_teeth=0
            )
            apart = closest(one, two)
            meshing = pair_of(one, two, apart)
            room = reserves(meshing)
        except DesignError:
            continue
        if room.involute < 0.02 or room.ring_root < 0.02:
            continue
        measured = measured_pair(meshing)
        for kind, value in (("trochoid", room.trochoid), ("trimming", room.trimming)):
            signs = [sign for sign, _ in found[kind]]
            if abs(value) < 0.002 or value in (1.0, -1.0) or signs.count(value > 0) >= wanted:
                continue
            whole = _whole(measured)
            overlap = max(_overlaps(whole, apart, kind))
            found[kind].append((value > 0, overlap < 1e-4))
    for kind, pairs in found.items():
        assert all(sign == free for sign, free in pairs), kind


def _whole(measured):
    return measured.driver.corners.ravel(), measured.driven.corners.ravel(), measured


def _overlaps(whole, apart, kind):
    """Area of the pinion outside its ring at some angles; on its way out of mesh, too, for trimming."""
    small, large, measured = whole
    hole = manifold3d.CrossSection([np.column_stack([large.real, large.imag])])
    for number in range(6):
        angle = 2 * pi / measured.driver.teeth * number / 6
        ring_angle = measured.middle(angle)
        ways = (apart,) if kind == "trochoid" else np.linspace(apart, 0.0, 25)[:20]
        for way in ways:
            placed = (small * np.exp(1j * angle) - way) * np.exp(-1j * ring_angle)
            out = manifold3d.CrossSection([np.column_stack([placed.real, placed.imag])]) - hole
            # What touches on the line of action at zero play is no fouling.
            yield out.area() if kind == "trochoid" or way < apart else 0.0


def test_khk_internal_pair():
    """KHK: m 3, 16 and 24 teeth, x 0 and +0.5 in its count, -0.5 here: α_w 31.0937°, a 13.1683, d_w 52.673 / 79.010."""
    one = GearForm(teeth=16, normal_module=3.0, width=20.0)
    two = RingForm(teeth=24, normal_module=3.0, width=20.0, profile_shift=-0.5, addendum_factor=0.5)
    apart = closest(one, two)
    assert apart == pytest.approx(13.1683, abs=5e-5)
    meshing = pair_of(one, two, apart)
    assert degrees(meshing.working_pressure_angle) == pytest.approx(31.0937, abs=1e-4)
    assert 2 * meshing.driven_pitch_radius == pytest.approx(79.010, abs=5e-4)


def test_khk_size_between_pins():
    """KHK: internal, m 1, z 40, pins of 1.7: 37.5951."""
    assert size_over_pins(ring(40), 1.7) == pytest.approx(37.5951, abs=5e-5)


def test_standard_teeth_clear_from_a_difference_of_nine():
    """SDP/SI D785: trochoid interference does not occur where the ring has more than nine teeth more."""
    for small in (20, 30, 40):
        for more in (10, 12, 20):
            one, two = pinion(small), ring(small + more)
            assert reserves(pair_of(one, two, closest(one, two))).trochoid > 0
    one, two = pinion(20), ring(25)
    with pytest.raises(DesignError, match="give the ring at least") as refused:
        require_free(pair_of(one, two, closest(one, two)))
    words = str(refused.value).split("at least ")[1]
    least, apart = int(words.split(" ")[0]), float(words.rsplit(" ", 1)[1])
    cured = pair_of(one, ring(least), apart)
    require_free(cured)
    assert least > 25


# Cutter teeth and the fewest teeth of a ring that such a cutter does not trim: SDP/SI D785, table 5-3a (x 0).
UNTRIMMED = {
    15: 34,
    16: 34,
    17: 35,
    18: 36,
    19: 37,
    20: 38,
    21: 39,
    22: 40,
    24: 42,
    25: 43,
    27: 45,
    28: 46,
    30: 48,
    31: 49,
    32: 50,
    33: 51,
    34: 52,
    35: 53,
    38: 56,
    40: 58,
    42: 60,
    44: 62,
    48: 66,
    50: 68,
    56: 74,
    60: 78,
    64: 82,
    66: 84,
    80: 98,
    96: 114,
    100: 118,
}


def test_rings_that_a_cutter_does_not_trim_are_those_of_the_handbook():
    for cutting, least in UNTRIMMED.items():
        found = [
            teeth
            for teeth in range(cutting + 10, cutting + 25)
            # With fewer teeth its tips would lie inside its base circle.
            if teeth * (1 - cos(radians(20))) >= 2.0
            and _trimming(RingForm(teeth=teeth, normal_module=1.0, width=5.0), cutting) > 0
        ]
        assert found[0] == least, cutting


def _trimming(form, cutting):
    cutter = placed_cutter(form, cutting)
    base = form.base_diameter / 2
    tips = TipMesh(
        cutting, cutter.base_radius, cutter.tip_radius, form.teeth, base, form.tip_diameter / 2, cutter.working_angle
    )
    return tips.trimming()


def test_a_cutter_that_trims_its_ring_is_refused_with_one_that_does_not():
    form = ring(48, cutter_teeth=40)
    with pytest.raises(ToothError, match=r"trims its tips; give (\d+), or 0") as refused:
        ring_tooth(form)
    serves = int(str(refused.value).split("give ")[1].split(",")[0])
    assert ring_tooth(replace(form, cutter_teeth=serves)).outline.area > 0
    assert ring_tooth(replace(form, cutter_teeth=0)).outline.area > 0
    assert placed_cutter(form, 48) is None


@pytest.mark.parametrize("cutting", [0, 20])
def test_areas_follow_from_points(cutting):
    tooth = ring_tooth(ring(50, 0.2, cutter_teeth=cutting))
    for curve in tooth.outline.curves:
        points = curve.point(np.linspace(0.0, 1.0, 20001))
        area = 0.5 * float(np.sum((np.conj(points[:-1]) * points[1:]).imag))
        assert curve.swept_area() == pytest.approx(area, abs=1e-7)
        ends = curve.point([0.5 - 1e-6, 0.5 + 1e-6])
        along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        assert complex(curve.tangent(0.5)) == pytest.approx(complex(along), abs=1e-6)


def test_axes_too_far_or_too_near_are_refused_with_a_distance_that_is_not():
    one, two = pinion(20), ring(60, addendum=0.8)
    with pytest.raises(DesignError, match=r"jams at the centre distance 20\.1 mm; give at most 20 mm"):
        pair_of(one, two, 20.1)
    with pytest.raises(DesignError, match=r"does not meet .* such as 20$"):
        pair_of(one, two, 15.0)
    for teeth in (18, 20):
        with pytest.raises(DesignError, match="at least 29 teeth"):
            pair_of(one, ring(teeth), 1.0)
        with pytest.raises(DesignError, match="at least 29 teeth"):
            closest(one, ring(teeth))
    with pytest.raises(DesignError, match="two internal gears"):
        pair_of(two, two, 20.0)


def test_spans_over_spaces_touch_where_the_flats_are_square_to_the_flank():
    form = ring(52, -0.1, -0.04, 12.0, addendum=0.7)
    over = span_over(form, 6)
    # Half of the flats' distance is the arc of the base circle from the middle to the flank, seen across the helix.
    base = form.base_diameter / 2
    arc = form.base_half_angle + 5 * pi / 52
    assert over / 2 == pytest.approx(base * arc * cos(form.base_helix_angle), abs=1e-12)
    assert sin(form.base_helix_angle) == pytest.approx(sin(radians(12)) * cos(radians(20)))


@pytest.mark.parametrize(("small", "large"), [(12, 25), (16, 26), (17, 60), (18, 31), (29, 40), (31, 42), (40, 120)])
def test_sectors_overlap_as_whole_sections_do(small, large):
    """Only teeth near the line of centres are set against each other: shapely finds the same with all of them."""
    pair = pair_of(pinion(small, 0.0, -0.05), ring(large, addendum=0.6, cutter_teeth=0), (large - small) / 2)
    built = measured_pair(pair)
    teeth, hole = (
        Polygon(np.column_stack([section.corners.ravel().real, section.corners.ravel().imag]))
        for section in (built.driver, built.driven)
    )
    for step in range(3):
        turned = 2 * pi / small * step / 3
        for off in (0.0, 0.4 * built.half_pitch, built.half_pitch):
            at = built.middle(turned) + off
            moved = translate(rotate(hole, degrees(at), origin=(0, 0)), built.centre_distance)
            whole = rotate(teeth, degrees(turned), origin=(0, 0)).difference(moved).area
            # Far beside the line of centres more teeth of a large pinion meet than are looked at.
            found = built.overlap(turned, at)
            assert found <= whole + 1e-6
            assert (found > 1e-6) == (whole > 1e-6)
            assert small > 30 or found == pytest.approx(whole, abs=1e-6)


@pytest.mark.parametrize("ring", [21, 22, 24])
def test_a_ring_that_is_too_small_is_told_the_least_teeth_which_then_pass(ring):
    """Of 22 teeth the base circles overlap where tolerances bring the axes together: that, too, is too few teeth."""
    pinion, wide = (Gear(teeth=teeth, module=1.0, width=8.0, internal=teeth != 20) for teeth in (20, ring))
    with pytest.raises(DesignError, match=r"give the ring at least (\d+) teeth") as refused:
        GearPair(pinion, wide, bearing_span=100.0)
    teeth = int(re.search(r"at least (\d+) teeth", str(refused.value))[1])
    assert GearPair(pinion, Gear(teeth=teeth, module=1.0, width=8.0, internal=True), bearing_span=100.0).passed
