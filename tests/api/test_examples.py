"""The scripts of the documentation run as they stand, and give what they say; what they made serves the other tests."""

import csv
import hashlib
import json
import os
import runpy
import shutil
from contextlib import chdir
from itertools import pairwise
from pathlib import Path

import build123d
import ezdxf
import numpy as np
import pytest

from cadgen import Design
from cadgen.api.measured import Measured, sources_of
from cadgen.inference.records.columns import AS_NAMED

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "docs" / "examples").glob("*.py"))
TRACK = ROOT / "tests" / "data" / "measured" / "track_a.csv"


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Run a script in a folder of its own, once; give its variables and the folder."""
    known = {}

    def run(name):
        if name not in known:
            folder = tmp_path_factory.mktemp(name)
            shutil.copy(TRACK, folder / "track.csv")
            with chdir(folder):
                known[name] = runpy.run_path(str(ROOT / "docs" / "examples" / f"{name}.py")), folder
        return known[name]

    return run


@pytest.mark.slow
@pytest.mark.parametrize("script", EXAMPLES, ids=lambda script: script.stem)
def test_a_script_is_short_and_runs(ran, script):
    assert len(script.read_text().splitlines()) <= 12
    assert ran(script.stem)


def test_readme_has_the_script_of_a_cam_by_its_motion():
    lines = (ROOT / "docs" / "examples" / "feeder.py").read_text().split('"""', 2)[2].strip()
    for name in ("README.md", "README.zh-CN.md"):
        assert lines in (ROOT / name).read_text("utf-8")


@pytest.mark.slow
def test_the_cam_files_are_those_asked_for_and_the_manifest_says_so(ran):
    made, folder = ran("cam")
    files = made["files"]
    stem = "carbon_free_car_actual"
    assert [file.name for file in files] == [f"{stem}.step", f"{stem}_arcs.dxf", f"{stem}_spline.dxf"]
    assert {name for name in os.listdir(folder / "exports") if not name.startswith(".")} == {
        *(file.name for file in files),
        "manifest.json",
    }
    entry = json.loads((folder / "exports" / "manifest.json").read_text())["parts"][files.part]
    assert entry["formats"] == ["step", "dxf"]
    for file in files:
        content = (folder / file.path).read_bytes()
        assert (file.bytes, file.sha256) == (len(content), hashlib.sha256(content).hexdigest())
        assert file.lift_error_um <= file.lift_limit_um <= 1.0
        assert entry["files"][file.name]["sha256"] == file.sha256
    assert (folder / "cam.png").stat().st_size > 10_000


@pytest.mark.slow
def test_the_solid_in_step_has_the_profile_s_area_times_its_thickness(ran):
    made, folder = ran("cam")
    cam = made["cam"]
    read = build123d.import_step(folder / made["files"][0].path)
    solid = cam.build123d()
    assert solid.volume == pytest.approx(read.volume, rel=1e-9)
    assert solid.label == "carbon_free_car_actual"
    box = read.bounding_box()
    assert pytest.approx((0.0, cam.thickness), abs=1e-6) == (box.min.Z, box.max.Z)
    points = cam.profile.points()
    assert pytest.approx((points[:, 0].min(), points[:, 0].max()), abs=1e-3) == (box.min.X, box.max.X)
    x, y = points.T
    shoelace = 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    assert shoelace == pytest.approx(cam.profile.area, rel=1e-6)
    left = cam.profile.area - sum(abs(contour.area()) for contour in cam.computed.blank.inner_contours())
    assert left * cam.thickness == pytest.approx(made["files"][0].facts["volume_mm3"], rel=1e-6)
    assert solid.volume == pytest.approx(left * cam.thickness, rel=1e-4)  # the kernel's plain rule


@pytest.mark.slow
def test_the_outline_in_dxf_lies_on_the_profile(ran):
    made, folder = ran("cam")
    lines = ezdxf.readfile(folder / made["files"][1].path).modelspace().query("LWPOLYLINE")
    corners = np.array(max(lines, key=len).get_points("xy"))
    points = made["cam"].profile.points(200_000)
    step = len(corners) // 20
    for corner in corners[::step]:
        assert np.hypot(*(points - corner).T).min() < 2e-3


@pytest.mark.slow
def test_the_lift_peaks_where_it_says(ran):
    lift = ran("cam")[0]["cam"].lift
    for angles, sign in ((lift.peaks, 1), (lift.valleys, -1)):
        here = sign * lift(angles)
        assert len(here)
        assert (here >= sign * lift(angles + 1e-4)).all()
        assert (here >= sign * lift(angles - 1e-4)).all()
    assert float(lift(0.3)) == pytest.approx(float(lift(0.3 + 2 * np.pi)))


def flanks(solid, axis, radius, towards):
    """Where the tooth flanks of a solid near the line of centres cross a circle about its axis: arcs from it, mm."""
    low = solid.bounding_box().min.Z
    arcs = []
    for edge in solid.edges():
        places = [edge.position_at(t) for t in (0.0, 1.0)]
        ends = np.array([complex(place.X - axis, place.Y) for place in places]) * np.exp(-1j * towards)
        if abs(places[0].Z - low) > 1e-6 or abs(places[1].Z - low) > 1e-6 or np.abs(np.angle(ends)).max() * radius > 7:
            continue
        if (abs(ends[0]) - radius) * (abs(ends[1]) - radius) < 0:
            places = [edge.position_at(t) for t in np.linspace(0.0, 1.0, 33)]
            points = np.array([complex(place.X - axis, place.Y) for place in places]) * np.exp(-1j * towards)
            order = np.argsort(np.abs(points))
            arcs.append(radius * float(np.interp(radius, np.abs(points)[order], np.angle(points)[order])))
    return np.array(arcs)


@pytest.mark.slow
def test_the_gears_of_a_pair_mesh_with_the_backlash_asked_for(ran):
    """On the solids as they stand: half of the backlash on either side of every tooth at the line of centres."""
    made, folder = ran("gear_pair")
    pair = made["pair"]
    pinion, wheel = made["assembly"].children
    assert pair.axes_apart == pytest.approx((18 + 45) / 2)
    assert (pinion.label, wheel.label) == ("pair_pinion", "pair_wheel")
    one = flanks(pinion, 0.0, pair.axes_apart * 18 / 63, 0.0)
    two = -flanks(wheel, pair.axes_apart, pair.axes_apart * 45 / 63, np.pi)
    assert min(len(one), len(two)) >= 6
    near = sorted([(arc, "pinion") for arc in one if abs(arc) < 5] + [(arc, "wheel") for arc in two if abs(arc) < 5])
    gaps = [b - a for (a, of), (b, other) in pairwise(near) if of != other]
    assert len(gaps) >= 4
    assert gaps == pytest.approx([0.05] * len(gaps), abs=2e-4)
    assert pair.play == pytest.approx(0.1, abs=1e-12)
    assert build123d.import_step(folder / "pair.step").volume == pytest.approx(pinion.volume + wheel.volume, rel=1e-6)


@pytest.mark.slow
def test_a_calibration_gives_the_design_as_built(ran):
    made, _ = ran("calibration")
    calibration = made["calibration"]
    built = calibration.as_built
    assert calibration.verdicts == {"track": "traced"}
    assert {effect.effect for effect in built.values.as_built.effects} == {"steering zero", "backlash"}
    assert Design.from_toml(built.text, "again").values.as_built == built.values.as_built
    assert built.values.as_designed().values() == calibration.computed.against.values
    assert "steering zero" in str(calibration)
    assert made["cam"].design.as_built is not None


def test_arrays_are_read_as_the_file_that_holds_them():
    remarks = [line.lstrip("# ") for line in TRACK.read_text().splitlines() if line.startswith("#")]
    body = [line for line in TRACK.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(body))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    (of_file,) = sources_of(TRACK, AS_NAMED)
    (of_arrays,) = sources_of(Measured(columns, remarks, "mine"), AS_NAMED)
    assert of_arrays.record.remarks == of_file.record.remarks
    assert of_arrays.kind.code == of_file.kind.code == "track"
    assert np.array_equal(of_arrays.record.run, of_file.record.run)
    for name in of_file.record.columns:
        assert np.array_equal(of_arrays.record[name], of_file.record[name])
    del columns["run"]
    half = {name: values[: len(values) // of_file.record.runs] for name, values in columns.items()}
    assert sources_of([half], AS_NAMED)[0].record.runs == 1
