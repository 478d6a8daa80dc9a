"""Tabs and feeds of milling programs, against what shapely leaves of the stock when the tool's places are cut away."""

import re

import numpy as np
import pytest
import shapely

from cadgen.cam.cutter import largest_cutter
from cadgen.curves.contour import circle
from cadgen.design.machining import Machining, Tabs
from cadgen.errors import DesignError, FileError
from cadgen.export.gcode import cutter_path, write_gcode
from cadgen.export.gcode_reader import read_gcode
from tests.curves.shapes import limacon

THICKNESS = 3.0
TABBED = Machining(tabs=Tabs(count=4, width_mm=3.0, height_mm=1.2), break_through_mm=0.3)
CURVE = limacon(28.0, 6.0)


def program(path, machining=TABBED, curve=CURVE):
    centre = cutter_path(curve, machining.cutter_diameter_mm / 2, largest_cutter(curve), 2e-4)
    write_gcode(path, centre, machining, THICKNESS, name="tabs")
    return path


@pytest.fixture(scope="module")
def tabbed(tmp_path_factory):
    return program(tmp_path_factory.mktemp("tabs") / "cam.nc")


def cut_at(text, depth, radius):
    """Area that a program cuts away of the plane Z = -depth: each move a thick line."""
    at, motion, areas = {"X": 0.0, "Y": 0.0, "Z": 99.0}, "", []
    for line in text.splitlines():
        words = dict(re.findall(r"([A-Z])(-?[\d.]+)", re.sub(r"\(.*?\)", "", line)))
        motion = f"G{words['G']}" if "G" in words and words["G"] in "0123" else motion
        new = {axis: float(words.get(axis, at[axis])) for axis in "XYZ"}
        if motion != "G0" and max(at["Z"], new["Z"]) <= -depth:
            start, end = (np.array([place["X"], place["Y"]]) for place in (at, new))
            if "I" in words:
                centre = start + np.array([float(words["I"]), float(words["J"])])
                first, last = (np.arctan2(*(p - centre)[::-1]) for p in (start, end))
                turn = (last - first) % (2 * np.pi) if motion == "G3" else -((first - last) % (2 * np.pi))
                angles = first + np.linspace(0, turn, max(2, int(abs(turn) / 0.01)))
                reach = np.linalg.norm(start - centre)
                points = centre + reach * np.stack([np.cos(angles), np.sin(angles)], axis=1)
            else:
                points = np.array([start, end])
            if np.ptp(points, axis=0).max() > 0:
                areas.append(shapely.LineString(points).buffer(radius, quad_segs=64))
        at = new
    return shapely.union_all(areas)


def test_the_stock_that_is_left_before_the_stop_are_the_tabs(tabbed):
    text = tabbed.read_text()
    before, after = text.split("\nM0\n")
    slot = cut_at(text, THICKNESS, 2.0)
    left = [part for part in shapely.get_parts(slot.difference(cut_at(before, THICKNESS, 2.0))) if part.area > 0.5]
    above = cut_at(before, THICKNESS - TABBED.tabs.height_mm, 2.0)
    assert len(left) == 4
    assert all(above.contains(part.buffer(-0.01)) for part in left)  # nothing is left above their height
    tabs = read_gcode(tabbed, TABBED, THICKNESS).tabs
    for part, tab in zip(
        left,
        sorted(tabs, key=lambda tab: min(range(4), key=lambda n: left[n].distance(shapely.Point(tab.place)))),
        strict=True,
    ):
        halves = cut_at(before, THICKNESS, 2.0)
        narrow = 2 * halves.distance(shapely.Point(tab.place))
        print(f"tab at {tab.place.round(1)}: {narrow:.4f} mm wide, read as {tab.width:.4f}; {tab.height:.4f} mm high")
        assert part.contains(shapely.Point(tab.place))
        assert narrow == pytest.approx(3.0, abs=2e-3)
        assert (tab.width, tab.height) == pytest.approx((3.0, 1.2), abs=1e-3)
    # What follows the stop cuts the tabs off, in passes that the design allows.
    assert cut_at(after, THICKNESS, 2.0).buffer(1e-6).covers(slot)
    depths = [float(z) for z in re.findall(r"G1 Z(-[\d.]+)", after)]
    assert depths == pytest.approx([-2.475, -3.3])


def test_nothing_of_the_tabs_is_left_on_the_rim(tabbed, tmp_path):
    plain = Machining()
    whole = read_gcode(program(tmp_path / "plain.nc", plain), plain, THICKNESS).outline.points
    points = read_gcode(tabbed, TABBED, THICKNESS).outline.points
    other = np.interp(*(np.unwrap(np.arctan2(p[:, 1], p[:, 0])) for p in (points, whole)), np.hypot(*whole.T))
    assert np.abs(np.hypot(*points.T) - other).max() < 2e-4


def test_the_program_says_when_to_clamp(tabbed):
    text = tabbed.read_text()
    assert "clamp the plate outside the outline, 4 tabs 3 mm wide and 1.2 mm high hold the part until M0" in text
    assert "at M0 clamp the part through its bore, with nothing above 5 mm" in text
    lines = text.splitlines()
    stop = lines.index("M0")
    assert lines[stop - 2] == "M5"
    assert lines[stop + 1].endswith("M3")


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"G1 Z-1\.8000 F60\n", "", "passes that differ"),
        (r"G1 Z-1\.8000", "G1 Z-1.6400", "leaves a tab at X .* with a height of 1.350 mm, not 1.2 mm"),
        (r"\nM0\n", "\n", "leaves 0 tabs where the design has 4"),
        (r"M5\n\(clamp", "(clamp", "stops for a clamp with the spindle on"),
        (r"(?s)\(tabs, pass 2.*?M5", "M5", "does not cut through"),
    ],
)
def test_other_tabs_are_refused(tabbed, tmp_path, pattern, replacement, message):
    text, changes = re.subn(pattern, replacement, tabbed.read_text())
    assert changes
    (tmp_path / "edited.nc").write_text(text)
    with pytest.raises(FileError, match=message):
        read_gcode(tmp_path / "edited.nc", TABBED, THICKNESS)


def test_tabs_of_another_width_or_place_are_refused(tmp_path):
    wide = TABBED.model_copy(update={"tabs": Tabs(count=4, width_mm=3.1, height_mm=1.2)})
    with pytest.raises(FileError, match=r"with a width of 3\.100 mm, not 3 mm"):
        read_gcode(program(tmp_path / "wide.nc", wide), TABBED, THICKNESS)
    three = TABBED.model_copy(update={"tabs": Tabs(count=3, height_mm=1.2)})
    with pytest.raises(FileError, match="leaves 3 tabs where the design has 4"):
        read_gcode(program(tmp_path / "three.nc", three), TABBED, THICKNESS)


def test_a_rapid_move_down_ends_above_what_was_cut_there(tabbed, tmp_path):
    """From the second pass on the cutter comes down in its own hole, and no deeper than the floor of it."""
    text = tabbed.read_text()
    assert re.findall(r"G0 Z(-?[\d.]+)\nG1 Z", text)[:4] == ["1.0000", "0.1750", "-0.6500", "-1.4750"]
    for pattern, replacement in ((r"G0 Z-0\.6500", "G0 Z-1.7"), (r"G0 Z1\.0000", "G0 Z-0.1")):
        (tmp_path / "deep.nc").write_text(re.sub(pattern, replacement, text, count=1))
        with pytest.raises(FileError, match="rapid speed through the stock"):
            read_gcode(tmp_path / "deep.nc", TABBED, THICKNESS)


def test_too_many_tabs_are_refused(tmp_path):
    many = TABBED.model_copy(update={"tabs": Tabs(count=24, height_mm=1.2)})
    with pytest.raises(DesignError, match=r"lower machining\.tabs\.count or width_mm"):
        program(tmp_path / "many.nc", many)


def test_the_feed_goes_by_the_material_where_the_design_gives_none(tmp_path):
    assert Machining(feed_mm_per_min=300.0).feed("steel") == 300.0
    assert Machining().feed(None) == 240.0
    # A cutter of 4 mm with 2 teeth at 8000 turns: 0.016 mm a tooth in aluminium, half of that in steel.
    assert Machining().feed("aluminium") == pytest.approx(0.016 * 2 * 8000)
    assert Machining().feed("steel") == pytest.approx(0.008 * 2 * 8000)
    assert Machining(cutter_teeth=3).feed("steel") == pytest.approx(0.008 * 3 * 8000)
    path, centre = tmp_path / "cam.nc", cutter_path(circle((0, 0), 20).curve(), 2.0, largest_cutter(CURVE), 1e-3)
    write_gcode(path, centre, Machining(), THICKNESS, name="fed", material="steel")
    assert "(feed for steel: 0.008 mm a tooth, 2 teeth, 8000 turns a minute)" in path.read_text()
    assert " F128\n" in path.read_text()
    read_gcode(path, Machining(), THICKNESS, material="steel")
