"""`cadgen gears` as a user meets it: files that hold what they claim, or no files at all."""

import csv
import hashlib
import json
import os
from dataclasses import replace
from pathlib import Path

import pytest

from cadgen.check import Bound, Check, CheckCode
from cadgen.cli.show import figures
from tests.cli.conftest import one_sentence
from tests.forks import MAIN

DATA = Path(__file__).parents[1] / "data" / "gears"


def contents(folder):
    return {file.name for file in folder.iterdir()}


def assert_made_and_proved(folder, parts, wheel_bytes):
    """The files of the train reordered, as the manifest has them; return the teeth in the table of parts."""
    stem = "carbon_free_car_reordered"
    names = {f"{stem}_{part}.{kind}" for part in parts for kind in ("step", "stl")}
    assert contents(folder) == names | {f"{stem}_train.step", f"{stem}_parts.csv", "manifest.json"}
    part = json.loads((folder / "manifest.json").read_text())["parts"][f"{stem}_train"]
    assert part["passed"] is True
    for name, facts in part["files"].items():
        data = (folder / name).read_bytes()
        assert hashlib.sha256(data).hexdigest() == facts["sha256"]
        if "flank_error_um" in facts:
            assert facts["flank_error_um"] <= 0.001
            assert facts["root_error_um"] <= 0.01
    train = part["files"][f"{stem}_train.step"]
    assert max(map(abs, train["play_error_um"])) <= 0.5
    assert abs(train["return_error_error_um"]) <= 0.5
    assert train["volume_error_relative"] <= 1e-6
    assert part["files"][f"{stem}_{parts[-1]}.step"]["bytes"] <= wheel_bytes
    rows = list(csv.DictReader((folder / f"{stem}_parts.csv").open()))
    assert all(float(row["span_min_mm"]) < float(row["span_max_mm"]) for row in rows)
    return [row["teeth"] for row in rows]


@pytest.mark.slow
def test_the_paper_s_train_has_the_paper_s_figures(cadgen, tmp_path):
    result = cadgen("gears", "--order", "reordered", "--formats", "csv", "--out", "out", code=0)
    print(result.stdout)
    assert max(map(len, result.stdout.splitlines())) <= 80
    for figure in ("0.724°", "0.962°", "-24.74 %", "b_r = 52 µm", "43 µm"):
        assert figure in result.stdout
    assert contents(tmp_path / "out") == {"carbon_free_car_reordered_parts.csv", "manifest.json"}


# Two stages, 24/60 and 24/48, on the blanks of the paper's train with smaller holes: webs, rims, hubs, a keyway.
WEBBED = ["train.stages.3=", *(f"train.stages.{number}.driver.teeth=24" for number in (1, 2))]
WEBBED += ["train.stages.1.driven.teeth=60", "train.stages.1.centre_distance_mm=21"]
WEBBED += ["train.stages.2.driven.teeth=48", "train.stages.2.centre_distance_mm=18"]
WEBBED += ["train.drive.hub.diameter_mm=9"]
WEBBED += [f"train.{place}.lightening.hole_diameter_mm=2" for place in ("intermediate", "output")]


@pytest.mark.slow
def test_all_files_are_made_proved_and_recorded(cadgen, tmp_path):
    changes = [part for text in WEBBED for part in ("--set", text)]
    result = cadgen("gears", "--order", "reordered", *changes, "--out", "out", code=0)
    assert max(map(len, result.stdout.splitlines())) <= 80
    teeth = assert_made_and_proved(tmp_path / "out", ("1_pinion", "2_wheel", "2_pinion", "3_wheel"), 880_000)
    assert teeth == ["24", "48", "24", "60"]


@pytest.mark.slow
@pytest.mark.long
def test_all_files_of_the_paper_s_train_are_made_proved_and_recorded(cadgen, tmp_path):
    cadgen("gears", "--order", "reordered", "--out", "out", code=0)
    parts = ("1_pinion", "2_wheel", "2_pinion", "3_wheel", "3_pinion", "4_wheel")
    assert assert_made_and_proved(tmp_path / "out", parts, 2_200_000) == ["40", "120", "40", "120", "30", "150"]


# Two small stages, which are quicker to make than the paper's train.
SMALL = ["train.stages.1.driver.teeth=30", "train.stages.2.driver.teeth=30", "train.stages.3="]
SMALL += ["train.stages.1.driven.teeth=42", "train.stages.1.centre_distance_mm=18"]
SMALL += ["train.stages.2.driven.teeth=45", "train.stages.2.centre_distance_mm=18.75"]
SMALL += [f"train.{place}.{what}=" for place in ("intermediate", "output") for what in ("lightening", "web")]


# Teeth that jam, which are made only by force.
JAMMING = [part for text in [*SMALL, "train.E_sn_um=30"] for part in ("--set", text)]


@pytest.fixture(scope="module")
def forced(forks, tmp_path_factory):
    """Folder with a small train whose teeth jam; what was printed."""
    folder = tmp_path_factory.mktemp("forced")
    arguments = ["gears", *JAMMING, "--force", "--out", "out"]
    result = forks.run(MAIN, *arguments, cwd=folder, env={**os.environ, "COLUMNS": "80"})
    assert result.returncode == 0, result.stderr
    return folder / "out", result.stdout


@pytest.mark.slow
@pytest.mark.long
def test_the_same_design_gives_the_same_bytes(forced, cadgen, tmp_path):
    folder, _ = forced
    cadgen("gears", *JAMMING, "--force", "--out", "out", code=0, fresh=True)
    assert contents(tmp_path / "out") == contents(folder)
    assert len(contents(folder)) == 11
    for name in contents(folder):
        assert (folder / name).read_bytes() == (tmp_path / "out" / name).read_bytes(), name


BAD = {
    "modules": (["train.stages.1.driver.module_mm=0.6"], 2, "joins the modules 0.6 and 0.5 mm"),
    "pressure angles": (["train.stages.2.driven.pressure_angle_deg=25"], 2, "joins the pressure angles 20° and 25°"),
    "few teeth": (["train.stages.1.driver.teeth=3"], 2, "train.stages.1.driver.teeth is 3; it must be at least 4"),
    "pointed": (["train.stages.1.driver.profile_shift=1.2", "train.stages.1.centre_distance_mm=45.6"], 2, "pointed"),
    "axes too close": (["train.stages.1.centre_distance_mm=44.9"], 2, "jams at the centre distance 44.9 mm"),
    "axes too far": (["train.stages.1.centre_distance_mm=47"], 2, "does not meet at the centre distance 47 mm"),
    "rack tip": (["train.rack_tip_radius_factor=0.6"], 2, "too large for the rack's tip"),
    "grade": (["train.grade=13"], 2, "train.grade is 13; it must be at least 3 and at most 12"),
    "keyway": (["train.output.keyway.depth_mm=25"], 2, "has a keyway that reaches to"),
    "collision": (["train.intermediate.bore_diameter_mm=5"], 2, "collide"),
    "no collar": (["train.intermediate.hub.length_mm=0.1"], 2, "collide"),
    "no train": (["train="], 2, "has no gear train: add a section [train]"),
    "uncovered": (["train.module_mm=0.2"], 2, "in stage 1,"),
    "no such ratio": (["train.search.teeth_min=100", "train.search.teeth_max=110"], 2, "no train of 3 stages"),
    "thinned away": (
        ["train.bearing_span_mm=5000"],
        2,
        "in stage 1, the gear with 30 teeth of",
    ),
    "short bearings": (["train.bearing_span_mm=2", "train.intermediate.bore_diameter_mm=8"], 2, "give at least 29 mm"),
    "rim": (
        ["train.output.web.rim_mm=100"],
        2,
        "has a rim of 100 mm between its root of",
    ),
    "holes": (["train.output.lightening.holes=100"], 2, "on a circle of 35.15 mm diameter; give at most 11"),
    "tiny": (["train.module_mm=1e-9"], 2, "of module 1e-09 does not meet at the centre distance 45 mm"),
    "grades of a search": (["train.stages.2.driver.grade=9"], 2, "one tolerance grade, and those given have 7 and 9"),
}
SEARCHED = ("no such ratio", "grades of a search")
DEAR = pytest.mark.slow


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name == "rim" else name for name in BAD]
)
def test_what_cannot_be_made_is_one_sentence_and_no_file(cadgen, tmp_path, name):
    settings, code, words = BAD[name]
    order = "search" if name in SEARCHED else "as-given"
    sets = [part for text in settings for part in ("--set", text)]
    message = one_sentence(cadgen("gears", "--order", order, *sets, "--out", "out", code=code))
    print(message)
    assert words in message
    assert contents(tmp_path) == set()


# Roots that leave the tips 0.1 modules.
SHALLOW = [
    part
    for text in ("train.dedendum_factor=1.0", "train.rack_tip_radius_factor=0.2", "train.E_sn_um=-40")
    for part in ("--set", text)
]


@pytest.mark.slow
def test_a_failed_check_exports_nothing(cadgen, tmp_path):
    result = cadgen("gears", *SHALLOW, "--out", "out", code=1)
    assert "so nothing was exported" in " ".join(result.stdout.split())
    assert "FAIL" in result.stdout
    assert contents(tmp_path) == set()


@pytest.mark.slow
def test_a_failed_check_is_told_to_machines(cadgen):
    facts = json.loads(cadgen("gears", *SHALLOW, "--json", code=1).stdout)
    assert facts["passed"] is False
    assert [check["name"] for check in facts["checks"] if not check["passed"]] == ["root clearance", "teeth jam"]


@pytest.mark.slow
def test_a_train_needs_no_car_and_the_other_commands_say_what_they_miss(cadgen, tmp_path):
    design = str(DATA / "onlytrain.toml")
    result = cadgen("gears", design, "--out", "out", code=0)
    assert "0.580°" in result.stdout
    assert "2 µm per mm of module" in " ".join(result.stdout.split())
    assert len(contents(tmp_path / "out")) == 7
    files = json.loads((tmp_path / "out/manifest.json").read_text())["parts"]["onlytrain_train"]["files"]
    assert files["onlytrain_2_wheel.stl"]["chord_um"] == 2.0
    for verb in ("cam", "check", "simulate"):
        said = one_sentence(cadgen(verb, design, code=2))
        assert "onlytrain.toml: the sections [path], [car], [cam] and [follower] are missing: add them" in said


@pytest.mark.slow
def test_forced_teeth_that_jam_are_exported_all_the_same(forced):
    folder, printed = forced
    assert "thin the teeth, or set the axes apart" in " ".join(printed.split())
    assert len(contents(folder)) == 11
    part = json.loads((folder / "manifest.json").read_text())["parts"]["carbon_free_car_as-given_train"]
    assert part["passed"] is False
    assert part["files"]["carbon_free_car_as-given_train.step"]["play_um"] is None


@pytest.mark.slow
def test_a_search_of_which_nothing_fits_prints_its_ranking_and_one_sentence(cadgen, tmp_path):
    result = cadgen("gears", "--order", "search", "--set", "train.intermediate.hub.diameter_mm=40", code=2)
    assert "none of 10 trains can be made" in one_sentence(result)
    assert result.stdout.count("°") == 2 * 8
    assert contents(tmp_path) == set()


def test_checks_that_failed_without_advice_say_no_empty_sentence(capsys):
    given = Check(CheckCode.ROOT_CLEARANCE, "gap", 1.0, "mm", 2.0, Bound.MIN, advice="move it")
    figures("checks", [given, replace(given, name="other", advice="")])
    said = capsys.readouterr().out
    assert "gap: move it." in said
    assert ": ." not in said
