"""A follower and a kind of gear from outside the package, through every command that takes any: one file, one line."""

import os
import re

import pytest

from cadgen.design.load import packaged_designs
from tests.docs.blocks import DOCS, blocks
from tests.forks import MAIN

CAR = packaged_designs()["carbon_free_car"].read_text(encoding="utf-8")


def shown(page: str) -> str:
    """The program that a page shows, down to the line that registers its kind, and the command line."""
    text = max((block.text for block in blocks(DOCS / page) if block.language == "python"), key=len)
    registered = re.match(r".*^\w+\.register\(\w+\)\n", text, re.M | re.S)
    assert registered
    return f"{registered[0]}\n{MAIN}"


def feeder() -> str:
    """The page's own design: a roller with a motion, and no car."""
    text = (DOCS / "how-to/followers.md").read_text(encoding="utf-8")
    return text.partition('Design.from_toml("""')[2].partition('"""')[0].lstrip()


def friction_car() -> str:
    """The paper's car with two stages of friction discs in place of its teeth."""
    stage = """
[[train.stages]]
kind = "friction_discs"
driver_diameter_mm = 10.0
driven_diameter_mm = {driven}
width_mm = 6.0
press_N = 20.0
torque_Nmm = 150.0
creep_deg = 0.2
"""
    train = f"[train]\nbearing_span_mm = 60.0\n{stage.format(driven=70.0)}{stage.format(driven=64.0)}\n"
    without = re.sub(r"^\[\[?train[.\]].*?(?=^\[(?!\[?train\b)|\Z)", "", CAR, flags=re.M | re.S)
    assert "train" not in re.findall(r"^\[+(\w+)", without, re.M)
    return f"{without}\n{train}"


CASES = {
    "how-to/followers.md": (
        feeder,
        (
            ("check", "car.toml", "--profile", "actual"),
            ("cam", "car.toml", "--profile", "actual", "--out", "out"),
            ("draw", "car.toml", "--only", "cam", "--profile", "actual", "--out", "out"),
            ("report", "car.toml", "--profile", "actual", "--samples", "20", "--processes", "1", "--out", "out"),
        ),
    ),
    "how-to/gear-kinds.md": (
        friction_car,
        (
            ("check", "car.toml"),
            ("gears", "car.toml", "--order", "reordered", "--out", "out"),
            ("draw", "car.toml", "--only", "train", "--order", "reordered", "--out", "out"),
            ("report", "car.toml", "--samples", "20", "--processes", "1", "--out", "out"),
            ("simulate", "car.toml", "--out", "out"),
            ("tolerance", "car.toml", "--samples", "20", "--processes", "1"),
        ),
    ),
}


@pytest.mark.long
@pytest.mark.slow
@pytest.mark.parametrize("page", CASES)
def test_every_command_takes_it(forks, page, tmp_path):
    design, commands = CASES[page]
    (tmp_path / "car.toml").write_text(design(), encoding="utf-8")
    for command in (*commands, ("verify", "out")):
        result = forks.run(shown(page), *command, cwd=tmp_path, env={**os.environ, "COLUMNS": "100"})
        assert result.returncode == 0, f"{' '.join(command)}: {result.stderr}{result.stdout}"
        assert "PASS" in result.stdout or "READY" in result.stdout
