"""Printed output, wherever it goes: full disks, closed pipes, old terminals, narrow ones."""

import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from cadgen.check import Bound, Check, CheckCode
from cadgen.cli import cli, show
from cadgen.cli.output import sentence
from cadgen.errors import MOST_REPEATED, brief
from cadgen.jobs.cam.cam_plan import Application
from cadgen.jobs.cam.cures import Cure, Cures
from cadgen.output.files.publisher import Written
from cadgen.verdict import PartVerdict
from tests.cli.conftest import one_sentence
from tests.cli.test_commands import SQUARE_TURN

COMMAND = [sys.executable, "-c", "from cadgen.cli import main; main()"]
LONG = "long_name_" * 6 + "four"


def run(folder, arguments, **kwargs):
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)} | kwargs.pop("env", {})
    return subprocess.run([*COMMAND, *arguments], cwd=folder, text=True, env=environment, **kwargs)


@pytest.fixture
def quick(tmp_path):
    """A design without gears, course or blank, which is checked soonest."""
    (tmp_path / "quick.toml").write_text(SQUARE_TURN)
    return "quick.toml"


def test_an_empty_folder_name_is_no_folder(cadgen, tmp_path):
    assert "it is empty: name a folder" in one_sentence(cadgen("cam", "--out", "", code=2))
    assert list(tmp_path.iterdir()) == []


def test_a_name_too_long_for_a_folder(cadgen, tmp_path):
    message = one_sentence(cadgen("cam", "--profile", "actual", "--out", "x" * 300, code=3))
    assert message.endswith("the path is too long: choose a shorter one")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("epoch", ["x", "", "-1", "1e9", "9" * 30])
def test_a_damaged_source_date_epoch(cadgen, monkeypatch, epoch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", epoch)
    message = one_sentence(cadgen("check", code=2))
    assert f'SOURCE_DATE_EPOCH is "{epoch}"; it must be seconds since 1970' in message


@pytest.mark.slow
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no full device")
@pytest.mark.parametrize("more", [[], ["--json"]])
def test_a_full_disk_behind_standard_output(tmp_path, quick, more):
    with open("/dev/full", "w") as full:
        result = run(tmp_path, ["check", quick, *more], stdout=full, stderr=subprocess.PIPE)
    assert result.returncode == 3
    assert one_sentence(result).startswith("cadgen: the output cannot be written (No space left on device)")


@pytest.mark.slow
@pytest.mark.parametrize("more", [[], ["--json"]])
def test_a_reader_that_has_gone_does_not_change_the_verdict(tmp_path, quick, more):
    read, write = os.pipe()
    os.close(read)
    failing = ["check", quick, "--set", "checks.min_convex_radius_mm=100", *more]
    result = run(tmp_path, failing, stdout=write, stderr=subprocess.PIPE)
    os.close(write)
    assert (result.returncode, result.stderr) == (1, "")


@pytest.mark.slow
def test_a_terminal_that_knows_only_ascii(tmp_path, quick):
    plain = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONIOENCODING": "ascii"}
    result = run(tmp_path, ["check", quick, "--all"], env=plain, capture_output=True)
    assert (result.returncode, result.stderr) == (0, "")
    assert re.search(r"cam angle \d+\.\d\d\?", result.stdout)
    assert result.stdout.isascii()


def files_table(capsys, monkeypatch, columns, omitted=()):
    monkeypatch.setenv("COLUMNS", str(columns))
    entries = {
        f"{LONG}_actual{end}": {"bytes": 41_700, "sha256": "", "lift_error_um": 0.3, "lift_limit_um": 1.0}
        for end in (".step", "_arcs.dxf", "_spline.dxf")
    }
    entry = {"files": entries, "omitted": dict(omitted)}
    show.files(Written.of(Path("exports"), f"{LONG}_actual", entry), Path("exports"))
    return capsys.readouterr().out


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_files_with_long_names_can_be_told_apart(capsys, monkeypatch, columns):
    printed = files_table(capsys, monkeypatch, columns)
    assert max(map(len, printed.splitlines())) <= columns
    title, _, table = printed.partition("file ")
    assert "".join(title.split()) == f"exports/{LONG}_actual"
    assert [line.split()[0] for line in table.splitlines()[1:]] == [".step", "_arcs.dxf", "_spline.dxf"]


def test_what_is_left_out_is_said_with_its_reason(capsys, monkeypatch):
    reason = "the cutter is too large: choose a smaller one [machining]"
    printed = files_table(capsys, monkeypatch, 80, [("G-code", reason)])
    assert "".join(printed.split()).endswith("".join(f"G-code left out: {reason}.".split()))


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_numbers_are_never_folded(capsys, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    check = Check(CheckCode.PUSHED_OUT, "rod pushed out", 0.000456, "µm", 0.2, Bound.MAX, "cam angle 126.40°", "")
    plan = SimpleNamespace(
        wheel="",
        origin=SimpleNamespace(name="car"),
        profile="actual",
        application=Application(),
        expected=None,
        figures=(check, check),
        verdict=PartVerdict((check, check)),
        deciding=(),
    )
    show.checks(plan, Cures((), (), 0), every=True)
    printed = capsys.readouterr().out
    assert max(map(len, printed.splitlines())) <= columns
    assert "0.000456 µm" in printed
    assert "<= 0.2" in printed


def test_brackets_and_colons_are_printed_as_they_are(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    check = Check(
        CheckCode.PUSHED_OUT,
        "wall [red]",
        1.0,
        "mm",
        2.0,
        Bound.MIN,
        "hole :smile: [blank]",
        "move it (the design's [blank])",
    )
    plan = SimpleNamespace(
        wheel="",
        origin=SimpleNamespace(name="car[1]"),
        application=Application(),
        expected=None,
        profile="actual",
        figures=(check, check),
        verdict=PartVerdict((check, check)),
        deciding=(),
    )
    show.checks(plan, Cures((check,), (Cure("[x]", "1", ()),), 0), every=True)
    printed = capsys.readouterr().out
    for text in (
        "car[1], actual",
        "hole :smile: [blank]",
        "wall [red]: move it (the design's [blank]).",
        "--set [x] (now 1) cures it",
    ):
        assert text in printed


@pytest.mark.parametrize("columns", ["0", "00"])
def test_a_width_that_is_not_known_prints_all_the_same(capsys, monkeypatch, columns):
    known = files_table(capsys, monkeypatch, 80)
    assert files_table(capsys, monkeypatch, columns) == known


@pytest.mark.parametrize("width", [60, 80])
@pytest.mark.parametrize("name", ["", *sorted(cli.commands)])
def test_help_fits_and_shows_no_escapes(name, width):
    result = CliRunner().invoke(cli, [*name.split(), "--help"], terminal_width=width)
    assert result.exit_code == 0
    assert "\\" not in result.output
    assert max(map(len, result.output.splitlines())) <= width


LONG_TEXTS = {
    "words": "some words " * 9000,
    "a word": "x" * 100_000,
    "signs": "\x1b[31m\x07\u202e" * 9000,
    "parts": "a." * 40_000 + "b",
    "lines": "a\nb " * 20_000,
}
PLACES = {
    "design": ["check", "{}"],
    "path": ["check", "./{}.toml"],
    "override": ["check", "--set", "{}"],
    "key": ["check", "--set", "cam.{}=1"],
    "item": ["check", "--set", "path.waypoints_mm.{}=1"],
    "value": ["check", "--set", "cam.thickness_mm={}"],
    "inline table": ["check", "--set", "path={{{}=1}}"],
    "name": ["check", "--set", "name={}"],
    "choice": ["check", "--profile", "{}"],
    "number": ["simulate", "--play-deg", "{}"],
    "option": ["check", "--{}"],
    "rest": ["check", "carbon_free_car", "{}"],
    "command": ["{}"],
    "measured": ["calibrate", "{}"],
    "folder": ["verify", "{}"],
}


@pytest.mark.parametrize("place", PLACES)
def test_messages_repeat_at_most_a_line_of_what_was_given(place, monkeypatch, capsys):
    from cadgen.cli import interrupt, main

    monkeypatch.setattr(interrupt, "install", lambda: None)
    monkeypatch.setattr(interrupt, "ignore", lambda: None)
    for text in LONG_TEXTS.values():
        monkeypatch.setattr(sys, "argv", ["cadgen", *(part.format(text) for part in PLACES[place])])
        with pytest.raises(SystemExit) as leave:
            main()
        printed = capsys.readouterr().err
        assert leave.value.code in (2, 3)
        assert all(sign.isprintable() or sign == "\n" for sign in printed)
        assert len(printed.splitlines()) <= 2  # an unknown key and a missing one
        assert not any(text[n : n + MOST_REPEATED + 1] in printed for n in range(40))
        assert len(printed) < 700


def test_a_message_of_click_repeats_at_most_a_line():
    given = 'say "x"\t' * 1000
    assert len(sentence(f"No such option: {given!r} or {given}", [f"--set={given}"])) < 3 * MOST_REPEATED
    assert brief("a\tb\x1b") == "a\\tb\\x1b"
    assert len(brief("x" * 10**6)) == len(brief("\x00" * 10**6)) == MOST_REPEATED


@pytest.mark.skipif(os.name != "posix", reason="no such signals there")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_while_python_shuts_down_changes_nothing(number, tmp_path):
    """Python has taken its handlers down by the time that the last object of a module is cleared away."""
    script = f"""
import os, sys
class Last:
    def __del__(self, kill=os.kill, process=os.getpid()):
        kill(process, {int(number)})
sys.modules["last"] = Last()
sys.modules["sys"].last_object = Last()
from cadgen.cli import main
main()
"""
    command = [sys.executable, "-c", script, "no_such_command"]
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 2, result.stderr


def test_formats_that_help_names_are_those_of_the_table():
    from cadgen.cli.options import USUAL_FORMATS
    from cadgen.output.files.formats import CAM, GEAR, RACK, TRAIN

    offers = {"cam": CAM, "gear": GEAR, "train": TRAIN}
    assert {part: tuple(each.code for each in offer.usual) for part, offer in offers.items()} == USUAL_FORMATS
    assert [each.code for each in RACK.usual] == list(USUAL_FORMATS["gear"])
