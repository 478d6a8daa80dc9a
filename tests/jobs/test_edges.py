"""A design with broken edges as a user gets it: keys, files, notes, manifest and figure."""

import json

import pytest

from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.output.files.dxf import edges_note

FILES = {".step", ".stl", ".3mf", "_arcs.dxf", "_spline.dxf", ".nc", ".xyz", ".csv"}


@pytest.fixture(scope="module")
def plan():
    return plan_cam(load_design("carbon_free_car", ["blank.edge_break_mm=0.2"]), "actual")


@pytest.mark.slow
def test_every_file_has_them(plan, tmp_path):
    """Each file is rolled at its carrying planes, where the profile is right; the manifest says where these are."""
    entry = write_cam(plan, tmp_path, find_cures(plan)).entry
    assert {name.removeprefix("carbon_free_car_actual") for name in entry["files"]} == FILES
    assert not entry["omitted"]
    assert entry["edge_break_mm"] == 0.2
    assert entry["carrying_planes_mm"] == pytest.approx([23.7, 26.3])
    volumes = [facts["volume_mm3"] for facts in entry["files"].values() if "volume_mm3" in facts]
    assert len(volumes) == 3
    note = edges_note(0.2, "rod")
    assert "break both edges of the outline by 0.2 mm" in note
    for suffix in (".nc", "_arcs.dxf", "_spline.dxf"):
        assert note in (tmp_path / f"carbon_free_car_actual{suffix}").read_text(encoding="cp1252")
    shown = json.loads((tmp_path / "manifest.json").read_text())["parts"]["carbon_free_car_actual"]
    (row,) = [check for check in shown["checks"] if check["name"] == "edges broken 0.1 mm more"]
    assert row["limit"] is None
    assert row["value"] == pytest.approx(147.4, abs=1.5)


@pytest.mark.slow
def test_no_key_and_zero_make_the_same_part():
    without, zero = load_design("carbon_free_car"), load_design("carbon_free_car", ["blank.edge_break_mm=0"])
    assert plan_cam(zero, "theoretical").checks == plan_cam(without, "theoretical").checks
    assert "edge_break_mm" not in json.dumps(without.values())


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (["blank.edge_break_mm=1.46"], r"leave no land of at least 0\.1 mm .* 3 mm thick: lower it to 1\.45 or less"),
        (["blank.edge_break_mm=4"], r"leave no land of at least 0\.1 mm"),
        (["blank.edge_break_mm=0.1", "cam.thickness_mm=0.1"], r"0\.1 mm thick: leave it out, or make the disc thicker"),
        (["blank.edge_break_mm=-0.1"], r"it must be 0, or at least 0\.01"),
        (['blank.edge_break_mm="wide"'], "it must be a number in mm"),
        (["blank.edge_break=0.1"], "write blank.edge_break_mm, in mm"),
    ],
)
def test_bad_input(overrides, message):
    with pytest.raises(DesignError, match=message):
        load_design("carbon_free_car", overrides)


def test_the_widest_break_that_is_named_is_allowed():
    design = load_design("carbon_free_car", ["blank.edge_break_mm=1.45"])
    assert plan_cam(design, "published").follower_as_built.land == pytest.approx(0.1)
