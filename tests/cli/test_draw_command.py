"""`cadgen draw` as a user meets it."""

import json

import pytest

from tests.cli.conftest import one_sentence


@pytest.mark.slow
def test_a_cam_is_drawn_with_its_form(cadgen, tmp_path):
    result = cadgen("draw", "--only", "cam", "--profile", "actual", "--out", "out", code=1)
    print(result.stdout)
    assert "NOT READY: cars that keep the course fails" in " ".join(result.stdout.split())
    assert max(map(len, result.stdout.splitlines())) <= 80
    stem = "carbon_free_car_actual"
    names = {f"{stem}_drawing.dxf", f"{stem}_drawing.pdf", f"{stem}_inspection.csv"}
    assert {file.name for file in (tmp_path / "out").iterdir()} == names | {"manifest.json"}
    entry = json.loads((tmp_path / "out/manifest.json").read_text())["parts"]["carbon_free_car_cam_drawings"]
    assert set(entry["files"]) == names
    assert entry["files"][f"{stem}_drawing.dxf"]["dimensions_mm"]["keyway width"] == 3.0


@pytest.mark.slow
def test_a_failed_check_draws_nothing(cadgen, tmp_path):
    result = cadgen("draw", "--only", "cam", "--profile", "actual", "--set", "checks.min_wall_mm=50", code=1)
    assert "NOT READY: thinnest wall fails, so nothing was drawn" in " ".join(result.stdout.split())
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["--set", "drawing.quantity=0"], 2, "drawing.quantity is 0; it must be at least 1"),
        (["--set", f"drawing.title={'x' * 61}"], 2, "drawing.title must be one line of 1 to 60 letters"),
        (["--set", "drawing.colour=red"], 2, "drawing.colour is not a key"),
    ],
)
def test_what_cannot_be_drawn_is_one_sentence(cadgen, tmp_path, arguments, code, words):
    result = cadgen("draw", "--only", "cam", "--profile", "actual", "--out", "out", *arguments, code=code)
    assert words in one_sentence(result)
    assert not (tmp_path / "out").exists()
