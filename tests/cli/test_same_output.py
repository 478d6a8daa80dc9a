"""The same bytes whatever the environment: threads of the libraries, hash seed, locale, time zone, current folder."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DATA = ROOT / "tests/data"
ENVIRONMENTS = (
    {"OPENBLAS_NUM_THREADS": "1", "PYTHONHASHSEED": "0", "LC_ALL": "C", "TZ": "UTC"},
    {
        "OPENBLAS_NUM_THREADS": "4",
        "OMP_NUM_THREADS": "3",
        "PYTHONHASHSEED": "7",
        "LC_ALL": "zh_CN.UTF-8",
        "TZ": "Asia/Tokyo",
    },
)
COMMANDS = {
    "check": ["check", "workshop_car"],
    "gears": ["gears", "workshop_car"],
    "simulate": ["simulate", "workshop_car"],
    "optimize": ["optimize", "workshop_car"],
    "tolerance": ["tolerance", "workshop_car", "--samples", "300"],
    "calibrate track": ["calibrate", str(DATA / "measured/track_a.csv")],
    "calibrate profile": ["calibrate", str(DATA / "measured/profile_b.csv")],
    "calibrate car": ["calibrate", *map(str, sorted((DATA / "loop/C13").glob("*.csv")))],
    "card": ["card", "s_course"],
    "cam": ["cam", "workshop_car", "--formats", "dxf,nc,csv,xyz"],
}


def outputs(folder: Path, command: list[str]) -> list[tuple[int, bytes, dict[str, bytes]]]:
    """Exit code, standard output and files of a command in each environment."""
    found = []
    for number, environment in enumerate(ENVIRONMENTS):
        place = folder / f"{number}"
        place.mkdir()
        out = ["--out", "out"] if command[0] == "cam" else []
        run = subprocess.run(
            [sys.executable, "-m", "cadgen", *command, *out, "--json"],
            cwd=place,
            capture_output=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
            timeout=600,
        )
        files = {file.name: file.read_bytes() for file in sorted(place.rglob("*")) if file.is_file()}
        found.append((run.returncode, run.stdout, files))
        assert run.stdout, run.stderr
    return found


@pytest.mark.long
@pytest.mark.slow
def test_a_judgement_is_the_same_whatever_the_environment(tmp_path):
    """The fast slice: least squares over many rows, which threads add up in another order."""
    first, second = outputs(tmp_path, ["calibrate", str(DATA / "measured/lift_a.csv")])
    assert first == second


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("command", COMMANDS)
def test_commands_print_and_write_the_same_whatever_the_environment(tmp_path, command):
    first, second = outputs(tmp_path, COMMANDS[command])
    assert first == second
