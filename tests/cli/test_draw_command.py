"""`cadgen draw` as a user meets it."""

import hashlib
import json

import ezdxf
import pytest

from tests.cli.conftest import one_sentence


@pytest.mark.slow
def test_a_cam_is_drawn_with_its_form(cadgen, tmp_path):
    result = cadgen("draw", "--only", "cam", "--profile", "actual", "--out", "out", code=1)
    print(result.stdout)
    assert "NOT READY: cars that keep the course fails" in " ".join(result.stdout.split())
    assert max(map(len, result.stdout.splitlines())) <= 80
    stem = "carbon_free_car_actual"
    names = {f"{stem}{ending}" for ending in ("_drawing.dxf", "_drawing.pdf", "_inspection.csv")}
    outlines = {f"{stem}_spline.dxf", f"{stem}_arcs.dxf"}
    names |= outlines
    assert {file.name for file in (tmp_path / "out").iterdir()} == names | {"manifest.json"}
    entry = json.loads((tmp_path / "out/manifest.json").read_text())["parts"]["carbon_free_car_cam_drawings"]
    assert set(entry["files"]) == names
    assert entry["files"][f"{stem}_drawing.dxf"]["dimensions_mm"]["keyway width"] == 3.0
    texts = {text.dxf.text.strip() for text in ezdxf.readfile(tmp_path / f"out/{stem}_drawing.dxf").query("TEXT")}
    for name in outlines:  # what the sheet names is what lies there
        digest = hashlib.sha256((tmp_path / "out" / name).read_bytes()).hexdigest()[:12]
        assert any(name in text for text in texts)
        assert any(digest in text for text in texts)
    # Those of cadgen cam stay those of its entry.
    cadgen("cam", "--profile", "actual", "--formats", "dxf", "--out", "out", "--force", code=0)
    cadgen("draw", "--only", "cam", "--profile", "actual", "--out", "out", code=1)
    parts = json.loads((tmp_path / "out/manifest.json").read_text())["parts"]
    assert not outlines & parts["carbon_free_car_cam_drawings"]["files"].keys()
    assert any(outlines <= part["files"].keys() for part in parts.values())


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
