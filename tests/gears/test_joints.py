"""Play of keys, D-flats, fits and bearings, against the geometry of what touches what."""

from math import acos, cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest
from scipy.optimize import brentq, linprog

from cadgen.design import gear_model, variation
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.gears.fits import clearance, deviations, flat_play, key_play, runs

KEYED = ("blank.joint=keyed", "blank.joint_clearance_greatest_um=25")


def test_a_key_of_25_um_on_a_shaft_of_8_mm_has_the_play_of_the_bar():
    print(f"{degrees(key_play(0.025, 8.0)):.4f}°")
    assert degrees(key_play(0.025, 8.0)) == pytest.approx(0.36, abs=0.005)


def overlap(turned: float, radius: float, across: float, room: float) -> float:
    """How far a D-shaft turned in its bore cuts into it wherever it is pushed: a linear program over the two shifts.

    The shaft is a polygon of points on its outline, the bore a polygon of tangents and its flat.
    """
    flat = across - radius
    end = acos(flat / radius)
    arc = np.concatenate([np.linspace(end, 2 * pi - end, 181), [end, -end]])
    points = radius * np.exp(1j * (arc + turned))
    normals = np.linspace(end, 2 * pi - end, 361)
    reach = np.concatenate([np.full(normals.size, radius + room / 2), [flat + room / 2]])
    normals = np.append(normals, 0.0)
    most = np.array([(points * np.exp(-1j * angle)).real.max() for angle in normals])
    # Least t with  most + shift . normal <= reach + t.
    table = np.column_stack([np.cos(normals), np.sin(normals), -np.ones(normals.size)])
    found = linprog([0, 0, 1], A_ub=table, b_ub=reach - most, bounds=[(None, None)] * 3)
    return float(found.fun)


@pytest.mark.parametrize(("radius", "across", "room"), [(4.0, 7.5, 0.025), (2.5, 4.5, 0.06)])
def test_a_d_shaft_turns_until_it_touches_wherever_it_is_pushed(radius, across, room):
    half = brentq(lambda turned: overlap(turned, radius, across, room), 1e-4, 0.2, xtol=1e-6)
    print(f"{degrees(2 * half):.3f}° touched, {degrees(flat_play(room, 2 * radius, across)):.3f}° by the formula")
    assert 2 * half == pytest.approx(flat_play(room, 2 * radius, across), rel=2e-3)


@pytest.mark.parametrize(
    ("fit", "size", "least", "greatest"),
    [  # from the printed tables of ISO 286-2
        ("H7/g6", 8, 5, 29),
        ("H7/h6", 8, 0, 24),
        ("H8/f7", 5, 10, 40),
        ("JS9/h9", 3, 0, 37.5),
        ("P9/h9", 3, 0, 19),
        ("N9/h9", 5, 0, 30),
        ("D10/h9", 12, 50, 163),
    ],
)
def test_fits_are_those_of_the_printed_tables(fit, size, least, greatest):
    assert np.array(clearance(fit, size)) * 1e3 == pytest.approx([least, greatest])


# Lower and upper deviations in µm of printed extracts of DIN ISO 286-2, up to 3, 6, 10, 18, 30 and 50 mm.
HOLES = {
    "E8": ((14, 28), (20, 38), (25, 47), (32, 59), (40, 73), (50, 89)),
    "F7": ((6, 16), (10, 22), (13, 28), (16, 34), (20, 41), (25, 50)),
    "G6": ((2, 8), (4, 12), (5, 14), (6, 17), (7, 20), (9, 25)),
    "H7": ((0, 10), (0, 12), (0, 15), (0, 18), (0, 21), (0, 25)),
    "D12": ((20, 120), (30, 150), (40, 190), (50, 230), (65, 275), (80, 330)),
    "JS9": ((-12.5, 12.5), (-15, 15), (-18, 18), (-21.5, 21.5), (-26, 26), (-31, 31)),
    "N9": ((-29, -4), (-30, 0), (-36, 0), (-43, 0), (-52, 0), (-62, 0)),
    "P9": ((-31, -6), (-42, -12), (-51, -15), (-61, -18), (-74, -22), (-88, -26)),
    "P7": ((-16, -6), (-20, -8), (-24, -9), (-29, -11), (-35, -14), (-42, -17)),
}


@pytest.mark.parametrize("hole", HOLES)
def test_holes_and_grooves_have_the_printed_deviations(hole):
    """Of a shaft the same letter keeps as far off on the other side."""
    for size, (low, high) in zip((3.0, 6.0, 10.0, 18.0, 30.0, 50.0), HOLES[hole], strict=True):
        found, _ = deviations(f"{hole}/h6", size)
        assert np.array(found) * 1e3 == pytest.approx([low, high]), size
        if hole[0] in "DEFGH":
            _, shaft = deviations(f"H7/{hole.lower()}", size)
            assert np.array(shaft) * 1e3 == pytest.approx([-high, -low]), size


def test_dowel_pins_have_the_printed_deviations():
    """JIS B 0401 and an extract of DIN 6325 print both; a hole M7 ends at -m + IT7 - IT6, whose limits are printed."""
    printed = ((2, 8), (4, 12), (6, 15), (7, 18), (8, 21), (9, 25))
    upper_of_m7 = (None, 0, 0, 0, 0, 0)
    for size, limits, m7 in zip((3.0, 6.0, 10.0, 18.0, 30.0, 50.0), printed, upper_of_m7, strict=True):
        hole, pin = deviations("H7/m6", size)
        assert np.array(pin) * 1e3 == pytest.approx(limits), size
        width = (hole[1] - hole[0] - (pin[1] - pin[0])) * 1e3
        assert m7 is None or m7 == pytest.approx(width - pin[0] * 1e3), size
    with pytest.raises(DesignError, match="m6 for a dowel pin"):
        deviations("H7/m7", 8.0)


@pytest.mark.parametrize(
    ("fit", "size", "expected"),
    [("F8/h6", 4.0, True), ("H7/h6", 4.0, True), ("P7/h6", 4.0, False), ("F8/m6", 4.0, False), ("E8/m6", 4.0, True)],
)
def test_a_fit_runs_whose_thickest_shaft_goes_into_its_tightest_hole(fit, size, expected):
    """Over 3 up to 6 mm: F8 from +10, E8 from +20, H7 from 0, P7 to -8, m6 to +12, h6 to 0 µm."""
    assert runs(fit, size) is expected


@pytest.mark.parametrize("fit", ["H7", "h7/H6", "S7/h6", "H7/q6", "H99/h6", "H7/g6 "])
def test_what_is_no_fit_is_told(fit):
    if fit.strip() == "H7/g6":
        assert clearance(fit, 8) == clearance("H7/g6", 8)
    else:
        with pytest.raises(DesignError, match="fit"):
            clearance(fit, 8)


def test_joints_stand_beside_the_papers_sum_each_at_its_place():
    given = "bore_diameter_mm=5", "joint=keyed", "joint_clearance_least_um=5", "joint_clearance_greatest_um=20"
    places = [f"train.{place}.{key}" for place in ("drive", "intermediate", "output") for key in given]
    whole = variation.train_plays(load_design("carbon_free_car", (*KEYED, *places)))["as-given"]
    assert degrees(whole.teeth.return_error_max) == pytest.approx(0.962, abs=5e-4)
    own = 0.020 / 2.5
    # 45 turns of the drive and 9 and 3 of the shafts between for one of the camshaft, whose own wheel counts in full.
    expected = [own / 45, own / 9, own / 3, own, 0.025 / 4]
    assert [joint.greatest for joint in whole.loose] == pytest.approx(expected)
    assert whole.return_error_max == pytest.approx(whole.teeth.return_error_max + sum(expected))
    assert whole.return_error_min == pytest.approx(whole.teeth.return_error_min + 0.25 * (sum(expected) - 0.025 / 4))
    spread = whole.return_error_distribution()
    assert (spread.minimum, spread.maximum) == pytest.approx((whole.return_error_min, whole.return_error_max))
    assert "wheel on the camshaft: its key has 0.46° of the" in whole.sentence()


def test_the_cheapest_cure_of_a_keyed_cam():
    whole = variation.train_plays(load_design("carbon_free_car", KEYED))["as-given"]
    assert whole.sentence() == "clamp, pin or glue the cam: its key has 0.36° of the 1.32° of return error"


@pytest.mark.parametrize("joint", ["clamped", "pinned", "glued"])
def test_a_joint_without_play_changes_nothing(joint):
    plain, held = (load_design("carbon_free_car", given) for given in ((), (f"blank.joint={joint}",)))
    assert variation.play_bands(plain) == variation.play_bands(held)
    assert variation.whole_play(held).loose == ()


def test_bearings_open_each_mesh_by_the_change_of_its_distance():
    """Against the exact play of involutes at axes that are further apart."""
    design = load_design("carbon_free_car", ("train.bearing_clearance_um=10",))
    whole = variation.train_plays(design)["as-given"]
    train = gear_model.train(design)
    for loose, pair, ratio in zip(whole.loose, train.stages, train.output_ratios, strict=True):
        opened = pair.base_backlash(pair.centre_distance + 0.01) - pair.base_backlash(pair.centre_distance)
        assert loose.greatest == pytest.approx(opened / (pair.driven.form.base_diameter / 2) / ratio, rel=2e-3)
        assert loose.greatest == pytest.approx(0.02 * tan(radians(20)) / pair.driven_pitch_radius / ratio)


def test_a_cam_without_gears_has_the_play_of_its_joint():
    design = load_design("carbon_free_car", (*KEYED, "train="))
    assert variation.play_bands(design)["as-given"].ends == (0.0, 0.025 / 4)
    assert variation.tolerances(design).play(np.random.default_rng(0), 9).max() <= 0.025 / 4


def test_play_on_a_braked_shaft_is_behind_the_brake(carbon_free_car):
    braked = ("mechanics.friction_least=0.1", "mechanics.friction_greatest=0.2", "mechanics.drag_least_Nmm=50")
    for where, expected in (("shaft", 0.025 / 4), ("disc", 0.0)):
        design = load_design("carbon_free_car", (*KEYED, *braked, f"mechanics.drag_on={where}"))
        band = variation.mechanics(design, carbon_free_car.follower, carbon_free_car.lift)
        assert band.behind == expected


def test_a_flat_has_the_lever_of_half_its_width():
    across = 2 * 4.0 * cos(radians(30)) / 2 + 4.0
    play = flat_play(0.01, 8.0, across)
    assert play == pytest.approx(2 * 0.01 / (4.0 * sin(radians(30))), rel=0.01)


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (("blank.joint=keyed",), "^.*: blank.joint = .keyed. needs its clearance"),
        (("blank.joint=welded",), 'must be "clamped", "pinned", "glued", "keyed" or "d_flat"'),
        (("blank.joint=glued", "blank.joint_fit=H7/g6"), "remove joint_fit"),
        ((*KEYED, "blank.joint_fit=H7/g6"), "the same twice"),
        ((*KEYED, "blank.joint_clearance_least_um=30"), "exchange them"),
    ],
)
def test_half_a_joint_is_refused(overrides, words):
    with pytest.raises(DesignError, match=words):
        load_design("carbon_free_car", overrides)


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (("blank.joint=keyed", "blank.joint_fit=JS9/h9", "blank.keyway="), "width is not known"),
        (("blank.joint=d_flat", "blank.joint_fit=JS9/h9"), "blank.joint_across_mm between"),
        (
            (
                "train.drive.bore_diameter_mm=",
                "train.drive.bore_fit=",
                "train.drive.joint=keyed",
                "train.drive.joint_fit=H7/g6",
            ),
            "no bore",
        ),
        (("blank.joint=d_flat", "blank.joint_across_mm=7.9", "blank.joint_clearance_greatest_um=200"), "turns round"),
    ],
)
def test_a_joint_that_does_not_fit_its_shaft_is_refused(overrides, words):
    with pytest.raises(DesignError, match=words):
        variation.play_bands(load_design("carbon_free_car", overrides))
