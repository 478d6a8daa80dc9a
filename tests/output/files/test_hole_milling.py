"""Milled holes: what is left of the work by the program's moves alone, and what the reader refuses."""

import re
from math import cos, hypot, pi, sin

import numpy as np
import pytest
import shapely

from cadgen.design.machining import Drilling, Machining
from cadgen.errors import FileError
from cadgen.output.files.drilling import drills_of
from cadgen.output.files.gcode_reader import RoundHole, read_hole_milling
from cadgen.output.files.hole_milling import is_milled, write_hole_milling
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Lightening, Mark

THICKNESS = 3.0
BLANK = Blank(
    bore_diameter=8.0,
    lightening=Lightening(count=3, hole_diameter=18.0, circle_diameter=50.0, start_angle=0.3),
    mark=Mark(diameter=3.0, radius=12.0, angle=0.8),
)
MACHINING = Machining(drilling=Drilling())


def written(folder, machining=MACHINING, blank=BLANK, material="aluminium"):
    sizes = [size for size in drills_of(blank, THICKNESS, machining.drilling) if is_milled(size, machining)]
    path = folder / "cam_holes.nc"
    write_hole_milling(path, sizes, machining, name="cam", material=material)
    return path, [RoundHole(hole.place, size.diameter, hole.top, hole.bottom) for size in sizes for hole in size.holes]


def read(path, holes, machining=MACHINING, blank=BLANK, material="aluminium"):
    return read_hole_milling(path, machining, holes, material=material, hub=blank.hub)


def moves_of(path):
    """Cuts of a program as polylines in space with their feeds, by a reader of this test's own."""
    at, feed = [0.0, 0.0, 0.0], 0.0
    for line in path.read_text().splitlines():
        given = {word[0]: float(word[1:]) for word in re.findall(r"[A-Z]-?[0-9.]+", re.sub(r"\(.*?\)", "", line))}
        feed = given.get("F", feed)
        if "G" not in given or given["G"] > 3:
            continue
        start, at = at, [given.get(axis, old) for axis, old in zip("XYZ", at, strict=True)]
        if given["G"] == 1:
            yield np.array([start, at]), feed
        elif given["G"] == 3:
            x, y, radius = start[0] + given["I"], start[1] + given["J"], hypot(given["I"], given["J"])
            assert start[:2] == at[:2]  # a whole turn
            turn = np.linspace(0.0, 2 * pi, 721)
            angle = np.arctan2(start[1] - y, start[0] - x) + turn
            heights = np.linspace(start[2], at[2], turn.size)
            yield np.stack([x + radius * np.cos(angle), y + radius * np.sin(angle), heights], axis=1), feed


def left(path, cutter, height):
    """Area that the cutter takes away at a height: of every place of it that is no higher."""
    swept = []
    for points, _ in moves_of(path):
        low = points[:, 2] <= height + 1e-9
        if low.all():
            swept.append(shapely.LineString(points[:, :2]).buffer(cutter / 2, quad_segs=256))
    return shapely.get_parts(shapely.union_all(swept))


@pytest.mark.parametrize(
    "machining",
    [
        MACHINING,
        Machining(cutter_diameter_mm=6.0, step_down_mm=3.3, drilling=Drilling()),
        Machining(cutter_diameter_mm=2.0, step_down_mm=0.7, tool_number=4, drilling=Drilling()),
        Machining(cutter_diameter_mm=7.5, feed_mm_per_min=600.0, drilling=Drilling()),
    ],
)
def test_the_moves_leave_round_holes_of_their_size_at_their_places(machining, tmp_path):
    """All that the cutter sweeps at the lower face and below it is round discs, without a core."""
    path, holes = written(tmp_path, machining)
    sizes = [8.0, 18.0, 18.0, 18.0, 3.0][: 5 if machining.cutter_diameter_mm == 2.0 else 4]
    assert [hole.diameter for hole in holes] == sizes
    off, wrong = read(path, holes, machining)
    print(f"places {off * 1e3:.3f} um, diameters {wrong * 1e3:.3f} um off")
    assert max(off, wrong) < 2e-4
    for height in (-THICKNESS, -THICKNESS - machining.break_through_mm):
        pieces = left(path, machining.cutter_diameter_mm, height)
        assert len(pieces) == len(sizes)
        for piece in pieces:
            middle = np.array(piece.centroid.coords[0])
            (hole,) = [hole for hole in holes if np.hypot(*(middle - hole.place)) < 1e-3]
            assert sum(shapely.Polygon(core).area for core in piece.interiors) < 1e-6
            away = np.hypot(*(np.asarray(piece.exterior.coords) - hole.place).T)
            assert 2 * away == pytest.approx(np.full(away.size, hole.diameter), abs=1e-3)
    text = path.read_text()
    assert f"\nS{machining.spindle_rpm:g} M3\n" in text  # of the cutter that is there, not of a drill of 18 mm
    assert ("T4 M6" in text) == (machining.tool_number == 4)


def test_the_cutter_goes_down_in_a_helix_no_steeper_than_end_mills_take_and_slower_at_a_small_radius(tmp_path):
    path, _ = written(tmp_path)
    steepest, fastest, depth = 0.0, 0.0, 0.0
    for points, feed in moves_of(path):
        down, along = points[0, 2] - points[-1, 2], np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1).sum()
        if along == 0.0:
            assert points[-1, 2] == 0.0  # straight down to the work alone
            continue
        steepest = max(steepest, down / along)
        fastest = max(fastest, feed)
        depth = min(depth, points[:, 2].min())
        if along > 20.0 and down == 0.0:
            radius = along / (2 * pi)
            assert feed * (radius + 2.0) / radius <= MACHINING.feed("aluminium") + 1e-6
    print(f"slope {steepest:.4f}, feed up to {fastest:g} mm/min")
    assert steepest <= 0.07
    assert fastest < MACHINING.feed("aluminium")
    assert depth == pytest.approx(-THICKNESS - MACHINING.break_through_mm, abs=1e-4)


def test_a_hole_as_wide_as_a_drill_that_is_named_or_as_the_cutter_is_drilled():
    def milled(machining, blank=BLANK):
        return [size.diameter for size in drills_of(blank, THICKNESS, machining.drilling) if is_milled(size, machining)]

    assert milled(MACHINING) == [8.0, 18.0]
    assert milled(Machining(drilling=Drilling(bore_diameter_mm=7.8))) == [18.0]
    assert milled(Machining(cutter_diameter_mm=8.0, drilling=Drilling())) == [18.0]
    assert milled(Machining(cutter_diameter_mm=7.6, drilling=Drilling())) == [18.0]  # a turn of 0.2 mm is none
    assert milled(Machining(cutter_diameter_mm=18.0, drilling=Drilling())) == []
    assert milled(Machining(drilling=Drilling()), Blank(bore_diameter=8.0, key=DFlat(depth=1.0))) == [6.0]


@pytest.mark.parametrize(("side", "top", "bottom"), [("outer", 6.0, -3.0), ("inner", 0.0, -9.0)])
def test_a_bore_is_milled_through_the_hub(tmp_path, side, top, bottom):
    blank = Blank(bore_diameter=8.0, hub=Hub(diameter=16.0, length=6.0, side=side))
    path, holes = written(tmp_path, blank=blank)
    assert [(hole.top, hole.bottom) for hole in holes] == [(top, bottom)]
    assert max(read(path, holes, blank=blank)) < 2e-4
    (piece,) = left(path, 4.0, bottom)
    assert piece.area == pytest.approx(16 * pi, rel=1e-3)


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"I-7\.0000", "I-7.1000", "has an arc|beyond a hole"),
        (r"(?s)\(G1 X\S+ Y\S+ F\S+\n)?G3 X\S+ Y\S+ I-7\.0000 J0\.0000 F\S+\n", "", "instead of 18"),
        (r"S8000 M3", "M3", "not understood|with a speed"),
        (r"(?s)(.*)G3 (X\S+ Y\S+) Z-3\.3000 ", r"\1G3 \2 Z-2.9000 ", None),
        (r"M30\n", "", "no M30"),
        (r"M5\nM30", "M5\nM0\nM30", "stops before its end"),
        (r"G1 Z0\.0000 F60", "G1 Z-1.0000 F60", "plunges"),
        (r"G1 Z0\.0000 F60", "G1 Z0.0000 F61", "61 mm/min in line .*; 60 is allowed"),
        (r"(G3 X\S+ Y\S+ Z\S+ I\S+ J\S+) F\S+", r"\1 F9999", "9999 mm/min"),
        (r"G0 Z5\.0000\nG0 X", "G0 Z2.0000\nG0 X", "sideways at rapid speed at Z 2, below the safe height of 5 mm"),
    ],
)
def test_wrong_programs_are_refused(tmp_path, pattern, replacement, message):
    path, holes = written(tmp_path)
    text = path.read_text()
    changed, count = re.subn(pattern.replace(r"\(G1", "(G1"), replacement, text, count=1)
    assert count
    path.write_text(changed)
    with pytest.raises(FileError, match=message or "do not run"):
        read(path, holes)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"place": (0.01, 0.0)}, "beyond a hole"),
        ({"diameter": 8.01}, "leaves a hole of 8.000 mm at X 0.000 Y 0.000 instead of 8.01"),
        ({"diameter": 7.99}, "beyond a hole"),
        ({"bottom": -4.0}, "does not mill through"),
    ],
)
def test_a_hole_that_is_not_the_program_s_is_refused(tmp_path, change, message):
    from dataclasses import replace

    path, holes = written(tmp_path)
    with pytest.raises(FileError, match=message):
        read(path, [replace(holes[0], **change), *holes[1:]])


def test_a_core_that_would_come_loose_is_refused(tmp_path):
    """One turn along the wall of 18 mm leaves a disc of 10 mm."""
    lines = ["G21 G90 G17 G40 G94 G91.1", "S8000 M3", "G0 Z5", "G0 X7 Y0", "G0 Z1", "G1 Z0 F60"]
    for level in (-0.5, -1.0):
        lines += [f"G3 X7 Y0 Z{level} I-7 J0 F100", "G3 X7 Y0 I-7 J0 F100"]
    path = tmp_path / "core.nc"
    path.write_text("\n".join([*lines, "G0 Z5", "M5", "M30"]) + "\n")
    hole = RoundHole((0.0, 0.0), 18.0, 0.0, -1.0)
    with pytest.raises(FileError, match="leaves a core"):
        read(path, [hole])


def test_places_are_those_of_the_blank(tmp_path):
    path, _ = written(tmp_path)
    ends = re.findall(r"G1 X(\S+) Y(\S+) F\S+\nG0 Z", path.read_text())
    angles = [0.3 + 2 * pi * n / 3 for n in range(3)]
    expected = [(0.0, 0.0), *((25 * cos(angle), 25 * sin(angle)) for angle in angles)]
    assert np.array(ends, float) == pytest.approx(np.array(expected), abs=6e-5)
