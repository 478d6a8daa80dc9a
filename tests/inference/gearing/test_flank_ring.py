"""Flank lines of a ring: its spaces are the teeth of an external gear, which the generator of these draws."""

from math import cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured
from cadgen.errors import FileError
from cadgen.gears.inspection import ideal_pin_diameter, size_over_pins
from tests.inference.gearing import flank_truth as truth
from tests.inference.gearing.test_train_errors import DESIGN

ALPHA, TEETH, HALF = radians(20.0), 61, pi / 122
RING = Design.from_toml(DESIGN.replace("teeth = 61 }", "teeth = 61, internal = true }", 1), train_only=True)


def judged(*tables):
    return RING.judge_gear([Measured(rows, ("gear: driven of stage 1",), f"data {n}") for n, rows in enumerate(tables)])


def alike(table):
    """Arcs by which an index that is off moves each tooth, um."""
    return 1e3 * TEETH / 2 * table * np.sin(2 * pi * np.arange(TEETH) / TEETH)


def index_of(centre, table, noise=0.2):
    """Index of a ring's teeth: each stands before a space, whose left flank is its right one."""
    rng = np.random.default_rng(1)
    spaces = truth.index_um(TEETH, 1.0, ALPHA, centre * np.exp(-1j * pi / TEETH), 0.0)
    both = {"right": spaces[-1] + alike(table), "left": np.roll(spaces[1], 1) + alike(table)}
    return {
        "tooth": np.tile(np.arange(1.0, TEETH + 1), 2),
        "flank": np.repeat(["left", "right"], TEETH),
        "index_um": np.concatenate([both[side] + noise * rng.standard_normal(TEETH) for side in ("left", "right")]),
    }


@pytest.mark.parametrize(("off", "table"), [(0.02, 0.0), (0.0, 3e-4), (0.02, 3e-4)])
def test_teeth_off_the_axis_are_told_from_an_index_that_is_off(off, table):
    pitch = judged(index_of(off * np.exp(1.1j), table)).pitch
    assert pitch.off.value == pytest.approx(off, abs=4 * pitch.off.sigma + 1e-4)
    assert pitch.table.value == pytest.approx(table * TEETH / 2, abs=4 * pitch.table.sigma + 1e-4)
    if off:
        assert pitch.towards == pytest.approx(1.1, abs=0.02)


def test_run_out_is_that_of_a_ball_in_each_space():
    """A ball of 1.7 mm within two involutes, drawn in by its radius."""
    centre, table, base, ball = 0.02 * np.exp(1.1j), 3e-4, TEETH / 2 * cos(ALPHA), 0.85
    extra = alike(table) / 1e3 / (TEETH / 2)
    away = []
    for space in range(TEETH):
        # The space's right flank is the next tooth's left one.
        right = truth.flank_start(TEETH, 1.0, ALPHA, space, 1, extra[(space + 1) % TEETH]) - ball / base
        left = truth.flank_start(TEETH, 1.0, ALPHA, space, -1, extra[space]) + ball / base
        at = base / cos(truth._unrolled((right - left) / 2))
        away.append(abs(centre + at * np.exp(1j * (right + left) / 2)))
    rows = index_of(centre * np.exp(1j * pi / TEETH), table, noise=0.0)
    run_out = next(each for each in judged(rows).pitch.measured if each.symbol == "F_r")
    assert 1e3 * run_out.worst == pytest.approx(1e3 * np.ptp(away), rel=0.02)


def test_a_tool_of_another_pressure_angle_is_found():
    """Material too much on an external flank lacks on a ring's; contact runs from the root to the tip of the ring."""
    wrong = radians(0.08)
    roll, much = truth.profile_um(TEETH, 1.0, ALPHA, ALPHA + wrong)
    rng = np.random.default_rng(2)
    rows = {"tooth": [], "flank": [], "diameter_mm": [], "profile_um": []}
    for tooth in (1, 16, 31, 46):
        for flank in ("left", "right"):
            rows["tooth"] += [tooth] * len(roll)
            rows["flank"] += [flank] * len(roll)
            rows["diameter_mm"] += (2 * np.hypot(roll, TEETH / 2 * cos(ALPHA))).tolist()
            rows["profile_um"] += (0.2 * rng.standard_normal(len(roll)) - much).tolist()
    told = judged(rows)
    profile = told.profile
    assert profile.tool.value == pytest.approx(wrong, rel=0.03)
    assert profile.cutter is None
    slope = next(each for each in profile.measured if each.symbol == "f_Halpha")
    # From where the tip of the pinion of 20 teeth makes contact to the tip of the ring.
    control = 20.5 * sin(ALPHA) + sqrt(11**2 - (10 * cos(ALPHA)) ** 2)
    whole = control - sqrt((told.form.tip_diameter / 2) ** 2 - (30.5 * cos(ALPHA)) ** 2)
    assert slope.left == pytest.approx(-whole * tan(ALPHA) * wrong, rel=0.05)


def test_helix_taper_and_an_axis_that_leans_are_found():
    """A flank moves out where it turns along its normal, that of a ring's right flanks forward and inward."""
    beta, taper, lean, towards = radians(0.05), 0.004, radians(0.04), 0.6
    depth, rng = np.linspace(0.0, 8.0, 17), np.random.default_rng(3)
    rows = {"tooth": [], "flank": [], "face_mm": [], "helix_um": []}
    for tooth in (1, 16, 31, 46):
        for flank, side in (("right", 1), ("left", -1)):
            place = 2 * pi * (tooth - 1) / TEETH + side * HALF
            normal = np.exp(1j * place) * (side * 1j * cos(ALPHA) - sin(ALPHA))
            shift = lean * depth * (np.exp(1j * towards) * np.conj(normal)).real
            much = side * tan(beta) * cos(ALPHA) * depth + taper * depth / 8.0 + shift
            rows["tooth"] += [tooth] * len(depth)
            rows["flank"] += [flank] * len(depth)
            rows["face_mm"] += depth.tolist()
            rows["helix_um"] += (1e3 * much + 0.1 * rng.standard_normal(len(depth))).tolist()
    helix = judged(rows).helix
    assert helix.angle.value == pytest.approx(beta, rel=0.03)
    assert helix.taper.value == pytest.approx(taper, rel=0.05)
    assert helix.leaning.value == pytest.approx(lean, rel=0.05)


def test_thickness_by_sizes_between_balls_and_lines_of_another_gear():
    form = judged(index_of(0j, 0.0)).form
    ball = round(ideal_pin_diameter(form), 2)
    cut = form.cut_to(form.tooth_thickness_deviation - 0.05)
    told = judged({"ball_diameter_mm": [ball], "over_balls_mm": [size_over_pins(cut, ball)]})
    assert told.thickness.value == pytest.approx(cut.tooth_thickness_deviation, abs=1e-6)
    assert "E_sn" in told.as_built
    with pytest.raises(FileError, match="reaches"):
        judged({"tooth": [1] * 9, "flank": ["left"] * 9, "roll_length_mm": range(0, 90, 10), "profile_um": [0.0] * 9})
