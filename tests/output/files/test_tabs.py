"""Tabs and feeds of milling programs, against what shapely leaves of the stock when the tool's places are cut away."""

import re

import numpy as np
import pytest
import shapely

from cadgen import Design
from cadgen.cam.cutter import largest_cutter
from cadgen.curves.contour import circle
from cadgen.design.machining import Machining, Tabs
from cadgen.errors import DesignError, FileError
from cadgen.messages import shown
from cadgen.output.files.gcode import cutter_path, write_gcode
from cadgen.output.files.gcode_reader import read_gcode
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
    off = cut_at(after, THICKNESS, 2.0).buffer(1e-6)
    assert all(off.covers(part) for part in left)
    depths = [float(z) for z in re.findall(r"G1 Z(-[\d.]+)", after)]
    assert depths == pytest.approx(4 * [-2.475, -3.3])


def test_a_tab_is_taken_off_where_it_stands(tabbed):
    """After the stop the cutter is in the work only at the tabs, with a lead before and after, and nowhere else."""
    _, after = tabbed.read_text().split("\nM0\n")
    # Every move sideways after the stop, at feed, by shapely: four short pieces of the slot.
    ways = shapely.get_parts(cut_at(after, THICKNESS, 1e-3))
    lengths = [part.length / 2 for part in ways]
    print("ways at the tabs:", [round(length, 2) for length in lengths], "mm")
    assert len(ways) == 4
    assert lengths == pytest.approx(4 * [3.0 + 4.0 + 2 * 3.0], abs=0.1)
    # Rapid moves sideways are at the safe height, and those down end above the work: the slot is as wide as the cutter.
    rapid = re.findall(r"G0 ([XYZ].*)", after)
    assert {word for word in rapid if word.startswith("Z")} == {"Z1.0000", "Z5.0000"}
    assert [word[0] for word in rapid] == 8 * ["X", "Z", "Z"]
    assert rapid[2::3] == 8 * ["Z5.0000"]


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
        (r"(?s)\(tab 4 of 4, pass 2.*?M5", "M5", "does not cut through"),
        (r"(?s)\(tab 2 of 4, pass 1.*?\(tab 2 of 4, pass 2", "(tab 2 of 4, pass 2", "pass 1.5000 mm deep"),
    ],
)
def test_other_tabs_are_refused(tabbed, tmp_path, pattern, replacement, message):
    text, changes = re.subn(pattern, replacement, tabbed.read_text())
    assert changes
    (tmp_path / "edited.nc").write_text(text)
    with pytest.raises(FileError, match=message):
        read_gcode(tmp_path / "edited.nc", TABBED, THICKNESS)


def test_a_pass_that_begins_in_a_tab_or_beside_the_path_is_refused(tabbed, tmp_path):
    before, after = tabbed.read_text().split("\nM0\n")
    lines = after.splitlines()
    down = next(i for i, line in enumerate(lines) if line.startswith("G1 Z"))
    places = [re.search(r"X(\S+) Y(\S+)", line) for line in lines]
    start = np.array(places[down - 2].groups(), dtype=float)
    # The last corner of the lead, where the tab begins.
    inside = next(
        i
        for i in range(down + 1, len(lines))
        if np.linalg.norm(np.array(places[i].groups(), dtype=float) - start) > 2.9
    )

    def refused(changed, message):
        (tmp_path / "edited.nc").write_text("\nM0\n".join([before, "\n".join(changed) + "\n"]))
        with pytest.raises(FileError, match=message):
            read_gcode(tmp_path / "edited.nc", TABBED, THICKNESS)

    kept = [*lines[: down - 2], f"G0 {places[inside].group()}", *lines[down - 1 : down + 1]]
    refused([*kept, f"{lines[inside + 1]} F240", *lines[inside + 2 :]], "in a tab, not in the slot beside it")
    x = start[0]
    # From another place: beside the path of the rounds.
    aside = [line.replace(f"X{x:.4f}", f"X{x + 0.01:.4f}") for line in lines]
    refused(aside, "differ|radius")


def test_a_round_through_air_is_refused(tabbed, tmp_path):
    """The passes of before: round the whole outline at the depths of the tabs, most of it through air."""
    before, after = tabbed.read_text().split("\nM0\n")
    rounds = before.split("(pass ")
    whole = re.sub(r"(?m)^G1 Z-1\.8000.*\n|^G1 Z-3\.3000.*\n", "", rounds[4])
    whole = whole.replace("G0 Z-1.4750\n", "G0 Z-1.4750\nG1 Z-2.4750 F60\n", 1)
    body = "\n".join(line for line in whole.splitlines()[1:] if not line.startswith(("M", "(")))
    (tmp_path / "air.nc").write_text(
        "\nM0\n".join([before, "\n".join([after.splitlines()[0], body, "M5", "M30"]) + "\n"])
    )
    with pytest.raises(FileError, match=r"cuts \d+\.\d mm of air to take a tab off; 6 mm lead to it and away"):
        read_gcode(tmp_path / "air.nc", TABBED, THICKNESS)


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


def test_a_material_that_nobody_stated_is_told_with_what_is_assumed():
    """Fed for aluminium whatever the cutter: never faster than there, and what steel takes where that is less."""
    for diameter, feed, steel in ((1.0, 64.0, 32.0), (2.0, 128.0, 64.0), (4.0, 240.0, 128.0)):
        machining = Machining(cutter_diameter_mm=diameter)
        assert machining.feed(None) == feed <= machining.feed("aluminium")
        assert f"aluminium at {feed:g} mm/min, where steel takes {steel:g};" in machining.assumption(None)
    wide = Machining(cutter_diameter_mm=16.0)
    assert wide.feed(None) == 240.0 < wide.feed("steel")
    assert "steel" not in wide.assumption(None)
    assert Machining().assumption("steel") is None
    assert Machining(feed_mm_per_min=300.0).assumption(None) is None


def test_a_cutter_and_a_speed_that_nobody_stated_are_told_beside_the_material():
    """Neither the cutter, whose centre a program leads, nor its speed is taken in silence."""
    cutter = "cutter not stated: the path is for one of 4 mm; state machining.cutter_diameter_mm"
    speed = "spindle speed not stated: 8000 turns a minute; state machining.spindle_rpm"
    said = f"{cutter}; {speed}"
    assert said == Machining().assumptions("steel") == Machining(feed_mm_per_min=300.0).assumptions(None)
    assert Machining().assumptions(None) == f"{Machining().assumption(None)}; {said}"
    assert Machining(spindle_rpm=8000.0).assumptions("steel") == cutter
    assert Machining(cutter_diameter_mm=4.0).assumptions("steel") == speed
    stated = Machining(cutter_diameter_mm=4.0, spindle_rpm=6000.0)
    assert stated.assumptions("steel") is None
    assert stated.assumptions(None) == stated.assumption(None)


def test_the_verdict_names_what_the_mill_goes_by_and_nobody_stated():
    assert Machining().unstated(None) == ("material", "cutter", "spindle speed")
    assert Machining(feed_mm_per_min=300.0).unstated(None) == ("cutter", "spindle speed")
    drilled = Machining(feed_mm_per_min=300.0, cutter_diameter_mm=4.0, spindle_rpm=8000.0, drilling={})
    assert drilled.unstated(None) == ("material",)  # by which a drill turns
    assert drilled.unstated("steel") == ()


def test_the_command_names_the_cutter_that_it_assumed(tmp_path):
    written = Design.load("roller").cam().write(tmp_path, formats="nc")
    assert any("the path is for one of 4 mm" in warning for warning in written.warnings)


def test_the_first_line_of_a_program_and_the_command_say_what_is_assumed(tmp_path):
    stated = {"machining.cutter_diameter_mm": 3.0, "machining.spindle_rpm": 8000}
    holes = {"machining.drilling.bore_diameter_mm": 7.8, **stated}
    design = Design.load("roller", holes | {"blank.material": None})
    written = design.cam().write(tmp_path, formats="nc")
    firsts = [file.path.read_text("ascii").partition("\n")[0] for file in written]
    assert [line.strip("()") for line in firsts] == [file.facts["assumed"] for file in written]
    fed, drilled = written.warnings
    assert "fed for aluminium at 192 mm/min, where steel takes 96; state blank.material" in fed
    assert "drilled as steel, the slowest, at 816 turns" in drilled
    assert "按铝取进给速度" in shown(fed, "zh")
    stated = design.with_({"blank.material": "steel"}).cam().write(tmp_path, formats="nc")
    assert stated.warnings == ()
    assert not any(file.path.read_text("ascii").startswith("(material") for file in stated)
