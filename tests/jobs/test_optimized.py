"""The profile against play as a user gets it: judged on the files, by code that does not know how it was made."""

import json
import re
from math import radians

import numpy as np
import pytest

from cadgen.cam.checks import STATIONS
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.against_play.profile_kinds import ACTUAL, COMPENSATED
from cadgen.car.running.drive import drive
from cadgen.car.running.run_errors import run_error
from cadgen.car.running.sampled import sampled_lift
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import default_profile, plan_cam
from cadgen.output.files.dxf import read_dxf

PAPER = 0.4531  # what both of the paper's methods take off


@pytest.fixture(scope="module")
def optimized():
    return plan_cam(load_design("carbon_free_car"), "optimized")


@pytest.fixture(scope="module")
def exported(optimized, tmp_path_factory):
    out = tmp_path_factory.mktemp("exported")
    return out, write_cam(optimized, out, find_cures(optimized)).entry


def read_back(name, out, optimized):
    """The outline that a file holds."""
    if name.endswith(".dxf"):
        return read_dxf(out / name, 0.05).profile
    from cadgen.geometry.solids.step import read_step

    return read_step(out / name, 0.05).rim


def error_of_run(outline, optimized, play, built):
    """Roll the rod on an outline and run the car, from the design's numbers alone."""
    theta = np.linspace(0.0, 2 * np.pi, STATIONS, endpoint=False)
    contact = roll(outline, built.follower, theta)
    cam = sampled_lift(theta, contact.q, blend_start=built.lift.blend_start)
    length = built.track.length
    planned = drive(built.lift, built.car, length)
    error = run_error(drive(cam, built.car, length, play=play, stop=built.lift.blend_start), planned)
    return np.array([abs(error.end_heading), error.end_distance])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["carbon_free_car_optimized.step", "carbon_free_car_optimized_arcs.dxf"])
def test_takes_play_out_on_the_exported_profile(exported, optimized, carbon_free_car, name):
    """At the play it was made for 99 %, with play 10 % off 88 %, and over the band far more than the paper's best."""
    out, entry = exported
    bound = entry["play"]["bound_with_same_peaks_and_valleys"]["worst_position_percent_off"]
    outline = read_back(name, out, optimized)
    bare = carbon_free_car.actual.curve.outline(0.05)
    band, made_for = optimized.application.comparison.band.ends, optimized.application.comparison.chosen.play

    def off(play):
        before = error_of_run(bare, optimized, play, carbon_free_car)
        return 1 - error_of_run(outline, optimized, play, carbon_free_car) / before

    at, beside = off(made_for), [off(share * made_for) for share in (0.9, 1.1)]
    worst = 1 - max(error_of_run(outline, optimized, play, carbon_free_car)[1] for play in band) / max(
        error_of_run(bare, optimized, play, carbon_free_car)[1] for play in band
    )
    print(
        f"{name}, cut for {np.degrees(made_for):.4f}: heading and position {100 * at} % off; play 10 % less or more "
        f"{100 * np.array(beside)}; worst over the band {100 * worst:.2f} %, the paper's best {100 * PAPER} %, bound "
        f"{bound:.2f} %"
    )
    assert (at >= 0.99).all()
    assert np.min(beside) >= 0.88
    assert PAPER < worst < bound / 100
    # The manifest has the same figure for the file.
    position = error_of_run(outline, optimized, made_for, carbon_free_car)[1]
    assert entry["files"][name]["end_position_mm"] == pytest.approx(position, abs=0.05)


@pytest.mark.slow
def test_every_file_takes_99_percent_off(exported, optimized):
    before = optimized.application.comparison.before.error.end_distance
    ends = {name: facts["end_position_mm"] for name, facts in exported[1]["files"].items() if "csv" not in name}
    assert len(ends) == 7
    print({name: round(end, 2) for name, end in ends.items()}, f"of {before:.0f} mm")
    assert max(ends.values()) < 0.01 * before
    assert not exported[1]["warnings"]


@pytest.mark.slow
def test_a_file_that_gives_the_compensation_away_says_so_and_what_to_change(tmp_path):
    """Facets of 20 um keep their own tolerance, and put the car 0.16 m off."""
    plan = plan_cam(load_design("carbon_free_car", ["export.mesh_chord_um=20"]), "compensated")
    entry = write_cam(plan, tmp_path, find_cures(plan)).entry
    assert entry["files"]["carbon_free_car_compensated.stl"]["end_position_mm"] > 50
    stl, threemf = entry["warnings"]
    for name, words in (("stl", stl), ("3mf", threemf)):
        end = entry["files"][f"carbon_free_car_compensated.{name}"]["end_position_mm"]
        assert f"carbon_free_car_compensated.{name} gives away" in words
        assert f"the run ends {end:.1f} mm off, and 0.6 mm" in words
        assert words.endswith("lower export.mesh_chord_um")


@pytest.mark.slow
def test_passes_every_check_and_says_why_it_was_chosen(exported, optimized):
    assert optimized.passed
    assert {"rod pushed out", "lift error with play"} <= {check.name for check in optimized.checks}
    entry = exported[1]
    assert any(reason.startswith("compensated chosen") for reason in entry["play"]["reasons"])
    assert entry["play"]["paper_percent_off"] == 45.31
    assert entry["play"]["before"]["profile"] == "actual"
    assert entry["play"]["after"]["position_percent_off"] > 99
    assert json.loads((exported[0] / "manifest.json").read_text())["parts"]["carbon_free_car_optimized"] == json.loads(
        json.dumps(entry)
    )


def test_the_wanted_lift_stays_the_planned_one(optimized, carbon_free_car):
    """The cam's own lift is another: it agrees with its checks, and not with the planned one."""
    theta = np.linspace(0.0, 2 * np.pi, 500)
    wanted, cut = optimized.application.comparison.task.lift, optimized.application.steering
    np.testing.assert_array_equal(wanted.q(theta), carbon_free_car.lift.q(theta))
    assert np.abs(cut.q(theta) - wanted.q(theta)).max() > 0.01


@pytest.mark.slow
@pytest.mark.parametrize(
    ("play", "order", "heading_deg", "position_mm"),
    [(0.962, "as-given", 12.335, 1333.2), (0.724, "reordered", 9.287, 999.9)],
)
def test_the_papers_return_errors_come_from_the_train_of_table_2(play, order, heading_deg, position_mm):
    plan = plan_cam(load_design("carbon_free_car", [f"optimize.order={order}"]), "compensated")
    bare = next(one for one in plan.application.comparison.evaluations if one.profile is ACTUAL and one.train == order)
    assert f"{np.degrees(plan.application.comparison.band.greatest):.3f}" == f"{play}"
    assert np.degrees(bare.band.worst_heading) == pytest.approx(heading_deg, rel=1e-3)
    assert bare.band.worst_distance == pytest.approx(position_mm, rel=1e-3)


@pytest.mark.slow
def test_a_measured_play_is_what_it_is_cut_for():
    plan = plan_cam(load_design("carbon_free_car", ["play.measured_deg=0.6"]), "optimized")
    assert plan.application.comparison.chosen.play == radians(0.6)
    assert np.degrees(plan.application.comparison.band.ends) == pytest.approx([0.512, 0.962], abs=5e-4)
    outside = plan_cam(load_design("carbon_free_car", ["play.measured_deg=1.1"]), "compensated")
    assert np.degrees(outside.application.comparison.band.ends[1]) == pytest.approx(1.1)


@pytest.mark.slow
def test_a_band_in_the_design_overrides_the_trains():
    design = load_design("carbon_free_car", ["play.least_deg=0.6", "play.greatest_deg=0.962"])
    plan = plan_cam(design, "compensated")
    assert np.degrees(plan.application.comparison.band.ends) == pytest.approx([0.6, 0.962])
    assert np.degrees(plan.application.comparison.chosen.play) == pytest.approx(0.781, abs=1e-3)


@pytest.mark.slow
def test_the_next_best_is_not_taken_where_it_loses_the_car():
    """A cutter too large for the compensated valley, but not for the actual one, which ends 1.3 m off.

    Neither is ready, and of the two that is shown whose cure is a matter of the disc.
    """
    tight = ["machining.cutter_diameter_mm=8", "optimize.max_lift_error_um="]
    plan = plan_cam(load_design("carbon_free_car", tight), "optimized")
    assert plan.application.comparison.chosen.profile is COMPENSATED
    assert [check.name for check in plan.failed] == ["largest cutter radius"]
    assert "the actual profile keeps that, but ends 1333 mm off" in plan.failed[0].advice


@pytest.mark.slow
def test_if_all_fail_a_check_the_failing_best_is_shown():
    plan = plan_cam(load_design("appendix_car"), "optimized")
    assert plan.application.comparison.chosen.profile is COMPENSATED
    assert not plan.passed
    assert "lost lift, undercut" in plan.application.comparison.reasons[0]


@pytest.mark.slow
def test_names_the_limit_that_binds_and_by_how_much():
    design = load_design("carbon_free_car", ["optimize.max_end_position_mm=100"])
    refused = plan_cam(design, "optimized")
    assert not refused.passed
    assert re.search(
        r"compensated, has a worst end position error of 306\.\d mm, 206\.\d mm more",
        refused.application.comparison.reasons[0],
    )


@pytest.mark.slow
def test_smoothing_fails_the_lift_check_and_is_made_without_it():
    failing = plan_cam(load_design("carbon_free_car"), "smoothed")
    assert [check.name for check in failing.checks if not check.passed] == ["lift error with play"]
    free = plan_cam(load_design("carbon_free_car", ["optimize.max_lift_error_um="]), "smoothed")
    assert free.sound
    assert free.application.comparison.chosen.error.end_distance > free.application.comparison.before.error.end_distance
    sums = [one.deflection_sum for one in free.application.comparison.evaluations]
    assert 1 - sums[1] / sums[0] == pytest.approx(0.2715, abs=1e-4)


def test_a_design_without_play_has_the_actual_profile_and_says_what_the_others_need():
    bare = load_design("carbon_free_car", ["train="])
    assert default_profile(bare).code == "actual"
    assert default_profile(load_design("carbon_free_car")).code == "optimized"
    with pytest.raises(DesignError, match=r"says nothing of the gears' play.*add \[train\].*or \[play\]"):
        plan_cam(bare, "optimized")
    assert plan_cam(bare).kind is ACTUAL


@pytest.mark.parametrize("play_deg", [0.5, 0.738, 0.9])
def test_the_area_of_a_profile_with_plateaus_is_that_of_its_points(carbon_free_car, play_deg):
    """The shoelace formula on points 0.01 mm apart errs by 1e-8; the solid's volume is held to 1e-6 of this area."""
    cut = actual_profile(
        compensated_lift(carbon_free_car.lift, carbon_free_car.follower, radians(play_deg)), carbon_free_car.follower
    )
    x, y = cut.curve.outline(0.01).points.T
    shoelace = 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    assert cut.curve.area() == pytest.approx(shoelace, rel=3e-8)
