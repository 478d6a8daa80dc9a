"""`cadgen calibrate` as a user meets it."""

import json
import os
import signal
import sys
import tomllib
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from cadgen.cli import interrupt, main
from cadgen.design.load import load_design, packaged_designs
from tests.cli.conftest import one_sentence
from tests.forks import MAIN

MEASURED = Path(__file__).parents[1] / "data" / "measured"
LIFT = "run,direction,cam_angle_deg,lift_mm\n" + "".join(f"1,forward,{k}.0,{0.01 * k:.3f}\n" for k in range(30))
METRES = LIFT.splitlines()[0] + "\n" + "".join(f"1,forward,{12 * k}.0,{-7e-3 * (k == 15)}\n" for k in range(29))
ZONES = "zone,cam_angle_deg,std_deg,n\nsmooth,113.37,0.68,100\njump,{jump},0.68,100\nreverse,{reverse},0.69,100\n"
SVG_AND_PNG = {"carbon_free_car_calibration_track.png", "carbon_free_car_calibration_track.svg"}


@pytest.fixture(scope="module")
def run_of_a_track(forks, tmp_path_factory):
    """A track and the paper's zones, with an override; the folder written and what was printed."""
    folder = tmp_path_factory.mktemp("calibrate")
    files = [str(MEASURED / name) for name in ("track_c.csv", "paper_section5.csv")]
    arguments = ["calibrate", *files, "--set", "optimize.smoothing_percent=20", "--out", "out"]
    result = forks.run(MAIN, *arguments, cwd=folder, env={**os.environ, "COLUMNS": "80"})
    assert (result.returncode, result.stderr) == (0, "")
    return folder / "out", result.stdout


@pytest.fixture
def failing(monkeypatch, capsys, tmp_path):
    """Call the command line within this process and return the one sentence that it fails with."""
    monkeypatch.setattr(interrupt, "install", lambda: None)
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str, code: int) -> str:
        monkeypatch.setattr(sys, "argv", ["cadgen", "calibrate", *arguments])
        with pytest.raises(SystemExit) as left:
            main()
        printed = capsys.readouterr()
        assert (left.value.code, printed.out) == (code, "")
        (line,) = printed.err.strip().splitlines()
        return line

    return run


@pytest.mark.slow
def test_the_report_says_what_was_found(run_of_a_track):
    out, printed = run_of_a_track
    print(printed)
    assert max(map(len, printed.splitlines())) <= 80
    words = " ".join(printed.split())
    for text in (
        "form error of the disc 2 µm rms (machined: no file says printed)",
        "track: track_c.csv (4 runs, 724 rows)",
        "Traced to backlash",
        "the start pose of each run",
        "hold the motor and turn the camshaft to and fro",
        "Traced to return error: 0.805°, 95 % from 0.710 to 0.901°",
        "as-given train by [train] is 0.962°: outside the interval, B is 3.2 standard errors below it",
        "reordered train by [train] is 0.724°: inside the interval, B is 1.7 standard errors above it",
        "turned 113.38 ± 0.04° and not 120.00°",
        "56.7 rpm; 0.83 s of full speed lost in starting and stopping; a ratio of 47.63",
        "return error shows in track_c.csv and paper_section5.csv, and they agree",
        "Recorded only: the backlash from track stands for it",
    ):
        assert text in words
    # The file holds the same report, folded wider.
    written = " ".join((out / "carbon_free_car_calibration.txt").read_text().split())
    assert written in words


@pytest.mark.slow
def test_files_are_those_of_the_manifest(run_of_a_track):
    out, _ = run_of_a_track
    part = json.loads((out / "manifest.json").read_text())["parts"]["carbon_free_car_calibration"]
    assert {file.name for file in out.iterdir()} == {*part["files"], "manifest.json"}
    assert set(part["files"]) == SVG_AND_PNG | {
        "carbon_free_car_calibration.json",
        "carbon_free_car_calibration.txt",
        "carbon_free_car_as_built.toml",
    }
    ET.parse(out / "carbon_free_car_calibration_track.svg")


@pytest.mark.slow
def test_the_json_document_has_every_number(run_of_a_track):
    out, _ = run_of_a_track
    facts = json.loads((out / "carbon_free_car_calibration.json").read_text())
    (track,) = facts["records"]
    assert (track["verdict"], track["claimed"], track["unit"]) == ("traced", ["backlash"], "mm")
    value = track["effects"][0]["values"][0]
    assert value["name"] == "return_error_deg"
    assert value["value"] == pytest.approx(0.862, abs=0.01)
    assert 0 < value["sigma"] < 0.01
    assert track["residual"]["before"] > 40 * track["residual"]["left_out"]
    assert [len(track["runs"]), len([d for d in track["datum"] if d["effect"].startswith("start pose")])] == [4, 4]
    assert track["candidates"][-1]["worse_by"] > 1000
    assert facts["zones"]["interval_deg"] == pytest.approx([0.710, 0.900], abs=1e-3)
    assert facts["shared"][0]["agrees"]
    assert [(one["effect"], one["place"]) for one in facts["as_built"]] == [
        ("backlash", "car"),
        ("sliding friction", "car"),
        ("return error", "noted"),
    ]
    assert [file["kind"] for file in facts["files"]] == ["track", "zones"]


@pytest.mark.slow
def test_the_as_built_design_is_the_design_with_what_was_measured(run_of_a_track):
    out, _ = run_of_a_track
    text = (out / "carbon_free_car_as_built.toml").read_text()
    given = packaged_designs()["carbon_free_car"].read_text()
    comments = [line[line.index("#") :] for line in given.splitlines() if "#" in line]
    assert all(comment in text for comment in comments)
    built, plain = load_design(out / "carbon_free_car_as_built.toml"), load_design()
    assert built.optimize.smoothing_percent == 20
    assert built.path == plain.path
    assert built.as_built is not None
    assert [source.file for source in built.as_built.sources] == ["track_c.csv", "paper_section5.csv"]
    backlash, friction, noted = built.as_built.effects
    assert (backlash.effect, backlash.place, noted.place) == ("backlash", "car", "noted")
    assert (friction.effect, friction.numbers["friction"]) == ("sliding friction", pytest.approx(0.0, abs=0.01))
    assert "# backlash, from track: return_error_deg 0.86" in text
    # Two digits of the standard deviation, and the value to the same decimal.
    (value,) = tomllib.loads(text, parse_float=str)["as_built"]["effects"][0]["values"]
    assert len(value["value"]) == len(value["sigma"])
    assert len(value["sigma"].lstrip("0.")) == 2


@pytest.mark.slow
def test_a_run_without_out_writes_nothing_and_each_is_one_table(cadgen, tmp_path):
    files = [str(MEASURED / "paper_section5.csv"), str(MEASURED / "track_c.csv")]
    result = cadgen("calibrate", "--each", "--profile", "actual", *files, code=0)
    assert list(tmp_path.iterdir()) == []
    lines = [line.split() for line in result.stdout.splitlines()]
    assert lines[0][:2] == ["file", "verdict"]
    assert lines[1][:3] == ["paper_section5", "traced", "°"]
    assert lines[2][:3] == ["track_c", "traced", "mm"]
    assert 150 < float(lines[2][3]) < 170
    assert float(lines[2][5]) < 3.1
    assert any(line[:3] == ["track_c", "backlash:", "return_error_deg"] for line in lines)
    assert max(map(len, result.stdout.splitlines())) <= 80
    assert "track_c.csv: All this holds for the actual cam" in result.stdout


@pytest.mark.slow
@pytest.mark.long
def test_each_asks_which_cam_was_on_the_car(cadgen):
    """More play on the other cam does the same to a track, and here nothing says which was on the car."""
    result = cadgen("calibrate", "--each", str(MEASURED / "track_c.csv"), code=1)
    assert "NOT READY: it is not sure which cam is on the car of track_c.csv" in " ".join(result.stdout.split())


@pytest.mark.slow
def test_each_in_a_folder_and_as_json(cadgen, tmp_path):
    files = [str(MEASURED / "paper_section5.csv")]
    facts = json.loads(cadgen("calibrate", "--each", "--json", "--out", "o", *files, code=0, fresh=True).stdout)
    assert [one["zones"]["verdict"] for one in facts["each"]] == ["traced"]
    names = {file.name for file in (tmp_path / "o").iterdir()}
    assert names == {"carbon_free_car_each.json", "carbon_free_car_each.txt", "manifest.json"}
    assert json.loads((tmp_path / "o/carbon_free_car_each.json").read_text()) == facts


def test_where_nothing_is_claimed_no_as_built_design_is_written(cadgen, tmp_path):
    (tmp_path / "zones.csv").write_text(ZONES.format(jump=113.40, reverse=113.35))
    result = cadgen("calibrate", "zones.csv", "--out", "o", code=0)
    words = " ".join(result.stdout.split())
    assert "Verdict: none. No return error beyond chance: 0.025°" in words
    assert "there is no as-built design" in words
    # Speed and time of the runs stand in no remark.
    assert "What it should have turned is not known" in words
    assert not list((tmp_path / "o").glob("*.toml"))


@pytest.mark.slow
def test_one_run_names_nothing(cadgen, tmp_path):
    rows = (MEASURED / "track_c.csv").read_text().splitlines(keepends=True)
    (tmp_path / "one.csv").write_text("".join(row for row in rows if row[0] in "#r1"))
    facts = json.loads(cadgen("calibrate", "one.csv", "--json", code=1).stdout)
    (track,) = facts["records"]
    assert (track["verdict"], track["claimed"], facts["as_built"]) == ("ambiguous", [], [])
    assert "one run only" in track["limits"][0]
    assert track["residual"]["left_out"] is None


@pytest.mark.slow
@pytest.mark.long
def test_the_wrong_design_is_said_to_be_wrong(cadgen):
    facts = json.loads(cadgen("calibrate", "appendix_car", str(MEASURED / "track_c.csv"), "--json", code=1).stdout)
    (track,) = facts["records"]
    assert (track["verdict"], track["claimed"]) == ("unexplained", [])
    assert "dwarfs every effect: check that the design" in track["sentence"]
    assert facts["warnings"] == ["track_c.csv says design carbon_free_car, but it was judged against appendix_car"]


BAD = {
    "empty.csv": ("", 3, "no table in it"),
    "header.csv": (LIFT.splitlines()[0] + "\n", 3, "no row stands under its header"),
    "missing.csv": (LIFT.replace("direction,", ""), 3, "nearest is lift, which lacks direction"),
    "mixed.csv": (LIFT.replace("lift_mm", "lift_mm,x_mm"), 3, "4 cells under 5 columns"),
    "nan.csv": (LIFT.replace("0.050", "nan"), 3, "one run of 29 rows cannot tell noise from"),  # a lost point
    "inf.csv": (LIFT.replace("0.050", "-inf"), 3, "line 7: lift_mm is '-inf'"),
    "huge.csv": (LIFT.replace("0.050", "1e300"), 3, "line 7: lift_mm is 1e+300, outside -100 to 100"),
    "twice.csv": (LIFT + "1,forward,5.0,0.050\n", 3, "goes round more than once"),
    "few.csv": ("".join(LIFT.splitlines(keepends=True)[:10]), 3, "run 1 has 9 rows; give at least 24"),
    "rad.csv": (LIFT.replace(".0,", "e-2,"), 3, "spans only 0.29; check its unit"),
    "metres.csv": (METRES, 3, "by a factor of 1000, so it seems to be in m: give mm"),
    "semicolons.csv": (LIFT.replace(",", ";"), 3, "cannot tell noise from"),
    "tabs.csv": (LIFT.replace(",", "\t"), 3, "cannot tell noise from"),
    "decimals.csv": (LIFT.replace(".", ","), 3, "line 2: 6 cells under 4 columns; correct the line, with commas"),
    "quote.csv": (LIFT.replace("1,forward,5.0", '"1,forward,5.0'), 3, "line 7: unexpected end of data"),
    "zeros.csv": ("\0" * 100, 3, "is not text"),
    "alone.csv": (LIFT, 3, "one run of 30 rows cannot tell noise from 90 orders of form error; repeat the run"),
    "copied.csv": (LIFT + LIFT.split("\n", 1)[1].replace("1,f", "2,f"), 3, "runs 1 and 2 are the same"),
    "zones.csv": (ZONES.format(jump=1, reverse=1).replace("jump", "hop", 1), 3, "give smooth, jump, reverse, each"),
}


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_is_refused_in_one_sentence_and_nothing_is_written(failing, tmp_path, name):
    text, code, words = BAD[name]
    Path(name).write_text(text)
    line = failing(name, "--out", "out", code=code)
    assert name in line
    assert words in line
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        ([], 2, "no measured file was given"),
        (["carbon_free_car"], 2, "no measured file was given"),
        (["absent.csv"], 3, "there is no file absent.csv"),
        (["folder.csv"], 3, "folder.csv is a folder"),
        (["lift.csv", "carbon_free_car"], 2, "carbon_free_car is a design and not measured data"),
        (["a.toml", "b.toml"], 2, "b.toml is a design and not measured data"),
        (["a.toml", "lift.csv"], 2, "there is no design file a.toml"),
        (["lift.csv", "./lift.csv"], 3, "holds the same data as lift.csv: give each file once"),
        (["lift.csv", "--form-error-um", "0"], 2, "--form-error-um"),
        (["lift.csv", "--form-error-um", "nan"], 2, "'--form-error-um': nan is not a finite number"),
        (["lift.csv", "--profile", "round"], 2, "--profile"),
        (["lift.csv", "--set", "cam.x=1"], 2, "cam.x is not a key"),
        ([str(MEASURED / "transmission_a.csv"), "--set", "train="], 2, "the design has no gear train"),
    ],
)
def test_bad_arguments_are_refused(failing, tmp_path, arguments, code, words):
    Path("lift.csv").write_text(LIFT)
    Path("folder.csv").mkdir()
    assert words in failing(*arguments, "--out", "out", code=code)
    assert not (tmp_path / "out").exists()


def test_an_unreadable_file(cadgen, tmp_path, monkeypatch):
    (tmp_path / "binary.csv").write_bytes(bytes(range(256)))
    assert "is not text" in one_sentence(cadgen("calibrate", "binary.csv", code=3))


@pytest.mark.slow
def test_an_interrupted_run_leaves_nothing(forks, tmp_path_factory, tmp_path):
    """The signal comes when the report stands in the staging folder and pictures are about to be drawn."""
    script = (
        "import os, signal\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # jobs in a shell's background ignore it
        "from cadgen.cli import main\n"
        "from cadgen.jobs.calibration import files as calibrate_files\n"
        f"calibrate_files.save = lambda *args: os.kill(os.getpid(), {int(signal.SIGINT)}) or []\n"
        "main()\n"
    )
    rows = (MEASURED / "track_c.csv").read_text().splitlines(keepends=True)
    head, points = [row for row in rows if row[0] in "#r"], [row for row in rows if row[0] == "1"]
    one = tmp_path_factory.mktemp("data") / "one.csv"
    one.write_text("".join([*head, *points[::2]]))
    arguments = ["calibrate", str(one), "--out", "out"]
    result = forks.run(script, *arguments, cwd=tmp_path)
    assert result.returncode == 130
    assert result.stderr.strip() == "cadgen: interrupted: nothing was written"
    assert list(tmp_path.iterdir()) == []


def test_next_and_predict_are_asked_of_one_car(failing):
    assert "--each judges files of several" in failing("--next", "--each", "a.csv", code=2)
    assert "--each judges files of several" in failing("--predict", "b.csv", "--each", "a.csv", code=2)
    assert "remove --out" in failing("--next", "--out", "x", code=2)
    assert "name at least one" in failing("--next", "--predict", "b.csv", code=2)
