"""`cadgen simulate`, `optimize` and `tolerance` as a user meets them."""

import json
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from cadgen.output.files.tables import read_tracks
from tests.cli.conftest import one_sentence
from tests.cli.test_commands import SQUARE_TURN

PLAY = "\n[play]\nmeasured_deg = 0.7\n"
STRAIGHT = SQUARE_TURN.replace("[2000, 300]", "[2000, 0]") + PLAY


@pytest.mark.slow
@pytest.mark.long
def test_simulate_writes_tracks_and_pictures_that_are_what_they_claim(cadgen, tmp_path):
    result = cadgen("simulate", "--play-deg", "0.962", "--out", "a", code=0, fresh=True)
    print(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    for figure in ("12.33", "1333.", "3.09", "3.681", "1.482", "-0.034", "4.287", "0.159"):
        assert figure in result.stdout
    part = json.loads((tmp_path / "a/manifest.json").read_text())["parts"]["carbon_free_car_optimized_simulation"]
    assert {file.name for file in (tmp_path / "a").iterdir()} == {*part["files"], "manifest.json"}
    tracks = read_tracks(tmp_path / "a/carbon_free_car_optimized_simulation_tracks.csv")
    off = [tracks[f"before_drive_{axis}_mm"][-1] - tracks[f"planned_drive_{axis}_mm"][-1] for axis in "xy"]
    assert np.hypot(*off) == pytest.approx(part["before"]["end_position_mm"], abs=1e-3)
    across = (
        tracks["after_front_x_mm"] - tracks["after_idle_x_mm"],
        tracks["after_front_y_mm"] - tracks["after_idle_y_mm"],
    )
    np.testing.assert_allclose(np.hypot(*across), np.hypot(167.0, 201.0), atol=1e-3)
    for name in part["files"]:
        if name.endswith(".svg"):
            ET.parse(tmp_path / "a" / name)


@pytest.mark.slow
def test_optimize_compares_alone_and_combined_and_writes_nothing(cadgen, tmp_path):
    result = cadgen("optimize", code=0)
    print(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    words = " ".join(result.stdout.split())
    for text in (
        "as-given",
        "reordered",
        "smoothed, compensated",
        "compensated chosen",
        "bound, same peaks",
        "no profile with the same peaks and valleys betters it, to first order",
        "smoothed 2012 mm 2012 mm",
        "45.31 %",
    ):
        assert text in words
    assert "raise the limit" not in words
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.long
def test_optimize_draws_on_request(cadgen, tmp_path):
    part = json.loads(cadgen("optimize", "--set", "optimize.order=reordered", "--json", "--out", "p", code=0).stdout)
    assert part["play"]["after"]["train"] == "reordered"
    assert part["play"]["before"]["train"] == "as-given"
    assert len(part["play"]["compared"]) == 8
    assert part["play"]["return_error_deg"]["greatest"] == pytest.approx(0.724, abs=5e-4)
    assert set(part["files"]) == {
        f"carbon_free_car_methods_{what}.{kind}"
        for what in ("events", "tracks", "tracks_by_event")
        for kind in ("png", "svg")
    }
    assert json.loads((tmp_path / "p/manifest.json").read_text())["parts"] == {"carbon_free_car_methods": part}


@pytest.mark.slow
@pytest.mark.long
def test_optimize_fails_if_even_the_best_profile_fails_a_check(cadgen):
    result = cadgen("optimize", "appendix_car", code=1)
    words = " ".join(result.stdout.split())
    assert "appendix_car: the optimized profile fails its checks" in words
    assert "FAIL" in words
    assert "lost lift, undercut: no profile gives this lift to this rod" in words
    assert "NOT READY: even the best profile fails a check" in words


@pytest.mark.slow
@pytest.mark.long
def test_predictions_on_a_failing_profile_say_so(cadgen):
    for command in (("simulate", "--profile", "smoothed", "--out", "s"), ("tolerance", "--profile", "actual")):
        more = ("--samples", "100") if command[0] == "tolerance" else ()
        words = " ".join(cadgen(*command, *more, code=1).stdout.split())
        assert f"the {command[2]} profile fails its checks" in words
        assert "lift error with play: the profile leaves the planned path" in words


def test_the_package_runs_as_a_module():
    result = subprocess.run([sys.executable, "-m", "cadgen", "--version"], capture_output=True, text=True, check=True)
    assert result.stdout.startswith("cadgen, version")


@pytest.mark.slow
@pytest.mark.long
def test_a_seed_gives_the_same_cars_on_any_number_of_processes(cadgen):
    arguments = ("tolerance", "--samples", "450", "--seed", "7", "--json")
    one, two = (json.loads(cadgen(*arguments, "--processes", n, code=0, fresh=n == "2").stdout) for n in "12")
    assert one == two
    assert one["seed"] == 7
    assert sum(item["share_of_variance"] for item in one["sensitivities"]) == pytest.approx(1.0)
    assert {item["tolerance"] for item in one["sensitivities"]} >= {"play", "wheel_radius", "start_heading"}


@pytest.mark.slow
def test_tolerance_fits_the_terminal_and_draws_on_request(cadgen, tmp_path):
    result = cadgen("tolerance", "--samples", "300", "--out", "p", code=0)
    print(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    assert "% keep the course: 11 gates and the edge" in result.stdout
    files = {file.name for file in (tmp_path / "p").iterdir()}
    assert files == {
        "carbon_free_car_optimized_tolerance.png",
        "carbon_free_car_optimized_tolerance.svg",
        "manifest.json",
    }


OFF = {
    "tolerances.eccentricity_mm": 0.01,
    "tolerances.steering_lost_motion_deg": 0.02,
    "tolerances.temperature_K": 5,
    "drawing.material": "",
    "blank.material": "acrylic",
    "blank.joint": "keyed",
    "blank.joint_clearance_greatest_um": 25,
    "mechanics.friction_least": 0.05,
    "mechanics.friction_greatest": 0.1,
    "optimize.max_lift_error_um": "",
}


@pytest.mark.slow
@pytest.mark.long
def test_the_budget_ranks_what_may_be_off_and_says_what_to_hold_tighter(cadgen, tmp_path):
    changes = [part for key, value in OFF.items() for part in ("--set", f"{key}={value}")]
    result = cadgen("tolerance", "--samples", "200", "--budget", "--out", "p", *changes, code=0)
    print(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    words = " ".join(result.stdout.split())
    assert "its key has 0.36° of the 1.32° of return error" in words
    assert "Hold tighter first: temperature, 5 K; half of it" in words
    assert "key of the cam" in words
    assert "what may be off milled wire-cut laser-cut printed" in words
    entry = json.loads((tmp_path / "p/manifest.json").read_text())["parts"]["carbon_free_car_optimized_tolerance"]
    assert {"carbon_free_car_optimized_tolerance_budget.png", "carbon_free_car_optimized_tolerance_budget.svg"} <= set(
        entry["files"]
    )
    costs = {cost["name"]: cost for cost in entry["budget"]["costs"]}
    assert costs["friction"]["half_width"] == pytest.approx(0.025)
    assert costs["temperature"]["end_position_mm"] == pytest.approx(320, abs=20)
    assert not costs["temperature"]["repeats"]
    assert costs["profile_offset"]["end_position_after_trim_mm"] < 2
    assert set(entry["budget"]["processes"]) == {"milled", "wire-cut", "laser-cut", "printed"}
    assert entry["budget"]["advice"][0].startswith("Hold tighter first")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "design", "overrides", "code", "words"),
    [
        ("tolerance", "carbon_free_car", ["tolerances.temperature_K=5"], 2, "set blank.material"),
        ("tolerance", "carbon_free_car", ["tolerances.rod_force_N=0.1"], 2, "add [mechanics] with rod_force_N"),
        ("tolerance", "carbon_free_car", ["blank.bore_fit=loose"], 2, "blank.bore_fit: the fit"),
        ("gears", "carbon_free_car", ["train.output.joint=keyed"], 2, "train.output.joint = "),
        (
            "tolerance",
            "plain.toml",
            ["play.measured_deg=0.5", "tolerances.wheel_runout_mm=0.1"],
            2,
            "tolerances.wheel_runout_mm needs the radius itself",
        ),
        ("tolerance", "plain.toml", [], 2, "says nothing of the gears' play"),
        ("simulate", "carbon_free_car --play-deg nan", [], 2, "nan is not a finite number"),
        ("tolerance", "plain.toml", ["play.measured_deg=0.5"], 2, "no dimension of the design varies"),
        (
            "tolerance",
            "plain.toml",
            ["play.measured_deg=0.5", "tolerances.wheel_radius_mm=0.1"],
            2,
            "needs the radius itself",
        ),
        ("cam", "plain.toml --profile smoothed", ["play.measured_deg=0.5"], 2, "aim lower, or compensate"),
        ("optimize", "carbon_free_car", ["play.least_deg=1", "play.greatest_deg=0.5"], 2, "exchange them"),
    ],
)
def test_bad_input_says_so_in_one_sentence_and_writes_nothing(
    cadgen, tmp_path, command, design, overrides, code, words
):
    (tmp_path / "straight.toml").write_text(STRAIGHT)
    (tmp_path / "plain.toml").write_text(SQUARE_TURN)
    arguments = [part for text in overrides for part in ("--set", text)]
    assert words in one_sentence(cadgen(command, *design.split(), *arguments, "--out", "out", code=code))
    assert not (tmp_path / "out").exists()


def test_a_limit_that_no_profile_keeps_is_not_ready_and_named(cadgen):
    result = cadgen("simulate", "carbon_free_car", "--set", "optimize.max_end_heading_deg=1", code=1)
    assert "NOT READY: worst end heading error fails" in result.stdout


def test_a_design_without_play_still_makes_the_actual_profile(cadgen, tmp_path):
    (tmp_path / "plain.toml").write_text(SQUARE_TURN)
    assert "plain, actual profile" in cadgen("check", "plain.toml", code=0).stdout
    assert "add [train] with the gears" in one_sentence(cadgen("check", "plain.toml", "--profile", "optimized", code=2))
