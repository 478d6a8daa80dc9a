"""Exit codes, one sentence for each bad input, and no kernel where none is needed."""

import json
import os
import subprocess
import sys

import pytest
from click.testing import CliRunner

from cadgen.cli import cli
from tests.cli.conftest import one_sentence

SQUARE_TURN = """
[path]
waypoints_mm = [[0, 0], [1000, 0], [2000, 300], [3000, 0], [4000, 0]]
[car]
wheelbase_mm = 167
drive_wheel_offset_mm = 37
idle_wheel_offset_mm = 201
[cam]
base_radius_mm = 70
mid_plane_mm = 25
thickness_mm = 3
[follower]
radius_mm = 2.5
"""


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["check", "no_such_design"], "no packaged design"),
        (["check", "./none.toml"], "no design file"),
        (["check", "--set", "cam.thicknes_mm=3"], "thickness_mm"),
        (["check", "--set", "cam.thickness_mm=nan"], "thickness_mm"),
        (["check", "--set", "follower.radius_mm=80"], "radius_mm"),
        (["check", "--set", "path.waypoints_mm=[[0,0],[1,1],[2,2]]"], "waypoints_mm"),
        (["check", "--set", "path.waypoints_mm=[[0,0],[900,0],[900,0],[2000,5],[3000,9]]"], "waypoints 2 and 3"),
        (
            [
                "check",
                "--set",
                "cam.mid_plane_mm=",
                "--set",
                "cam.thickness_mm=",
                "--set",
                "cam.inner_face_mm=27",
                "--set",
                "cam.outer_face_mm=24",
            ],
            "wrong order",
        ),
        (["check", "--set", "car.max_steering_angle_deg=12"], "wider turn"),
        (["check", "--profile", "pretty"], "pretty"),
        (["frobnicate"], "frobnicate"),
    ],
)
def test_usage_and_design_errors_exit_2(cadgen, arguments, words):
    assert words in one_sentence(cadgen(*arguments, code=2))


def test_unreadable_toml_names_the_line(cadgen, tmp_path):
    (tmp_path / "broken.toml").write_text("[path]\nwaypoints_mm = [[0, 0]\n[car]\n")
    assert "line 3" in one_sentence(cadgen("check", "broken.toml", code=2))


def test_json_errors_are_json(cadgen):
    result = cadgen("check", "none.toml", "--json", code=2)
    assert json.loads(result.stdout)["exit_code"] == 2
    assert result.stderr == ""


@pytest.mark.slow
@pytest.mark.long
def test_check_says_what_failed_and_how_to_cure_it(cadgen):
    result = cadgen("check", "appendix_car", "--profile", "actual", code=1)
    assert "FAIL" in result.stdout
    assert "lost lift, undercut" in result.stdout
    assert "14.7" in result.stdout
    assert "--set follower.radius_mm=" in result.stdout
    assert '--set path.spline="quintic" (now cubic) cures it' in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 80
    # What fails stands in the first lines, before what is reserved, and the last line has a cure of all of it, if any.
    said = " ".join(result.stdout.split())
    assert said.index(": not ready For a drive wheel ") < said.index("Fails: convex radius, theory 0 mm, at least 1.25")
    assert said.index("Fails: ") < said.index("Reservation: ")
    assert "the plain profile does nothing against it: cadgen optimize compares it" in said
    assert said.endswith("next: change the design as it is said above")
    said = " ".join(cadgen("check", "appendix_car", code=1).stdout.split())
    assert said.endswith("""fail; next: cadgen check appendix_car --set 'path.spline="quintic"'""")


@pytest.mark.slow
def test_check_passes_on_the_default_and_on_a_minimal_design(cadgen, tmp_path):
    assert "FAIL" not in cadgen("check", code=0).stdout
    (tmp_path / "mine.toml").write_text(SQUARE_TURN)
    facts = json.loads(cadgen("check", "mine.toml", "--json", code=0).stdout)
    assert facts["design"] == "mine"
    assert facts["passed"] is True


def test_without_a_name_beside_one_design_the_one_that_is_taken_is_said_first_and_last(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pyproject.toml").write_text("[project]\nname = 'no design'\n")
    (tmp_path / "broken.toml").write_text("[")
    alone = ["check", "--set", "x=1"]  # refused at once
    assert "no design was named" not in CliRunner().invoke(cli, alone).stderr
    (tmp_path / "my car.toml").write_text(SQUARE_TURN)
    for command in (
        ["check"],
        ["gears", "--set", "x=1"],
        ["check", "--json"],
        ["adjust"],
        ["plan", "--within", "3"],
    ):
        said = (
            "cadgen: no design was named, so this is the packaged carbon_free_car, not my car.toml in this folder: "
            f"for that one, write cadgen {command[0]} 'my car.toml'"
        )
        run = CliRunner().invoke(cli, command, standalone_mode=False)
        lines = run.stderr.splitlines()
        assert (lines[0], lines[-1]) == (said, said)
        assert not any(said in line for line in lines[1:-1])
        if run.stdout:  # last of all, not after itself
            assert run.output.splitlines()[0] == run.output.splitlines()[-1] == said
            assert run.stdout.splitlines()[-1] in run.output.splitlines()[1:-1]
        assert bool(run.stdout) == (command[0] == "check")
    assert CliRunner().invoke(cli, ["check", "my car.toml"]).stderr == ""
    (tmp_path / "other.toml").write_text(SQUARE_TURN)  # which of the two could be meant is not known
    assert "no design was named" not in CliRunner().invoke(cli, alone).stderr


def test_a_path_may_cross_itself(cadgen, tmp_path):
    loop = "[[0, 0], [1500, 0], [2600, 900], [1700, 1800], [900, 900], [1700, -400], [3200, -900]]"
    (tmp_path / "loop.toml").write_text(
        SQUARE_TURN.replace("[[0, 0], [1000, 0], [2000, 300], [3000, 0], [4000, 0]]", loop)
    )
    assert cadgen("check", "loop.toml", "--set", "checks.pressure_angle_limit=chinese_texts", code=0)


@pytest.mark.slow
@pytest.mark.parametrize("arguments", [["--help"], ["check", "--set", "course="], ["cam", "--help"], ["--version"]])
def test_no_kernel_is_imported(arguments):
    """The CAD kernel takes seconds; help and checks do without, and without a course also without shapely."""
    script = (
        "import sys, atexit\n"
        "atexit.register(lambda: sys.stderr.write('LOADED ' + ' '.join(m for m in sys.modules if m.split('.')[0] in\n"
        "    ('OCP', 'build123d', 'ezdxf', 'trimesh', 'lib3mf', 'shapely'))))\n"
        "from cadgen.cli import main\n"
        "main()\n"
    )
    result = subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True)
    assert result.returncode == 0
    assert result.stderr.split("LOADED ")[1] == ""


@pytest.mark.long
@pytest.mark.slow
@pytest.mark.skipif(
    sys.platform != "linux" or len(os.sched_getaffinity(0)) == 1, reason="no second process that makes the solids"
)
def test_the_command_of_a_cam_leaves_the_kernel_to_its_second_process(tmp_path):
    """Clearing the kernel away at the end of a process takes 0.4 s, a twentieth of the command."""
    script = (
        "import sys, atexit\n"
        "atexit.register(lambda: sys.stderr.write(f'KERNEL {\"OCP\" in sys.modules}'))\n"
        "from cadgen.cli import main\n"
        "main()\n"
    )
    command = [sys.executable, "-c", script, "cam", "--out", str(tmp_path)]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert list(tmp_path.glob("*.step"))
    assert result.stderr.endswith("KERNEL False")
