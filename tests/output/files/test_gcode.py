"""Milling programs: what the cutter leaves, what a machine would refuse, and what the reader must notice."""

import re

import numpy as np
import pytest

from cadgen.cam.contact import roll
from cadgen.cam.cutter import largest_cutter
from cadgen.car.against_play.profile_kinds import profile_of
from cadgen.curves.contour import circle
from cadgen.design.machining import Machining
from cadgen.errors import CheckError, FileError
from cadgen.output.files.gcode import RaisedHub, cutter_path, plain, write_gcode
from cadgen.output.files.gcode_reader import read_gcode
from tests.curves.shapes import limacon

THICKNESS = 3.0
MACHINING = Machining()


def program(curve, path, machining=MACHINING, tolerance=2e-4):
    centre = cutter_path(curve, machining.cutter_diameter_mm / 2, largest_cutter(curve), tolerance)
    write_gcode(path, centre, machining, THICKNESS, name="a cam (of ours)")
    return path


@pytest.fixture(scope="module")
def disc(tmp_path_factory):
    """The program of an eccentric circle."""
    return program(circle((4.0, 3.0), 30.0).curve(), tmp_path_factory.mktemp("gcode") / "disc.nc")


@pytest.mark.parametrize("diameter", [0.8, 4.0, 12.0])
def test_the_part_gives_the_lift(diameter, carbon_free_car, tmp_path):
    car = carbon_free_car
    machining = Machining(cutter_diameter_mm=diameter)
    path = program(car.actual.curve, tmp_path / "cam.nc", machining)
    angle = np.linspace(0, 2 * np.pi, 7200, endpoint=False)
    lift = roll(read_gcode(path, machining, THICKNESS).outline, car.follower, angle).lift
    error = np.abs(lift - car.follower.lift(car.lift.q(angle))).max() * 1e3
    print(f"cutter of {diameter} mm: {error:.3f} um at lift, {path.stat().st_size} bytes")
    assert error <= 1.0


@pytest.mark.slow
def test_convex_corners_are_read_as_sharp_as_they_are_cut(appendix_car, tmp_path):
    """Rays pass beside a corner; against the exact outline, corners and all, the rod finds nothing missing."""
    car = appendix_car
    machining = Machining(cutter_diameter_mm=2.0)
    path = program(car.actual.curve, tmp_path / "cam.nc", machining)
    angle = np.union1d(np.linspace(0, 2 * np.pi, 7200, endpoint=False), car.lift.kinks)
    lift = roll(read_gcode(path, machining, THICKNESS).outline, car.follower, angle).lift
    error = np.abs(lift - roll(car.actual.curve.outline(0.02), car.follower, angle).lift).max() * 1e3
    print(f"cam with corners of up to 18 degrees: {error:.3f} um at lift")
    assert error <= 1.0


def test_rapid_moves_pass_above_a_hub(tmp_path):
    centre = cutter_path(circle((0.0, 0.0), 30.0).curve(), 2.0, largest_cutter(circle((0.0, 0.0), 30.0).curve()), 2e-4)
    write_gcode(tmp_path / "hub.nc", centre, MACHINING, THICKNESS, name="hub", hub=RaisedHub(10.0, 8.0))
    heights = [float(z) for z in re.findall(r"G0 Z([\d.]+)", (tmp_path / "hub.nc").read_text())]
    assert set(heights) == {13.0, 1.0, 0.175}  # above the hub, and down to the work beside it
    read_gcode(tmp_path / "hub.nc", MACHINING, THICKNESS, hub_height=8.0)
    with pytest.raises(FileError, match="sideways at rapid speed at Z 13, below the safe height of 15 mm"):
        read_gcode(tmp_path / "hub.nc", MACHINING, THICKNESS, hub_height=10.0)
    head = (tmp_path / "hub.nc").read_text().partition("G21")[0]
    assert "zero: centre of the bore, outer face of the disc" in head
    assert "its hub stands 8 mm above that face" in head
    assert "to 13 mm" in head


@pytest.mark.parametrize("profile", ["theoretical", "published"])
def test_an_outline_that_is_no_part_says_so_at_the_top(tmp_path, profile):
    curve = circle((4.0, 3.0), 30.0).curve()
    centre = cutter_path(curve, 2.0, largest_cutter(curve), 2e-4)
    write_gcode(tmp_path / "disc.nc", centre, MACHINING, THICKNESS, name="disc", notes=[profile_of(profile).note])
    lines = (tmp_path / "disc.nc").read_text().splitlines()
    assert lines[0].startswith("(material not stated: ")
    assert lines[2].startswith("(NOT THE OUTLINE OF A PART TO USE: ")
    read_gcode(tmp_path / "disc.nc", MACHINING, THICKNESS)


def test_the_part_of_a_circle_is_the_circle(disc):
    outline = read_gcode(disc, MACHINING, THICKNESS).outline
    # Scallops of 0.03 um, and 0.05 um of rounding at each coordinate.
    assert np.hypot(*(outline.points - [4.0, 3.0]).T) == pytest.approx(30.0, abs=1.5e-4)


def test_the_program_says_what_the_shop_must_know(disc):
    text = disc.read_text()
    lines = text.splitlines()
    head = " ".join(line for line in lines if line.startswith("("))
    for fact in (
        "a cam _of ours_",
        "diameter 4 mm",
        "climb",
        "clockwise",
        "centre of the bore",
        "outer face of the disc",
        "disc 3 mm thick;",
        "bore, keyway and holes are not in this program",
        "lifts the cutter where it stands, to 5 mm",
        "+X",
    ):
        assert fact in head
    assert lines[9:12] == ["G21 G90 G17 G40 G94 G91.1", "S8000 M3", "G0 Z5.0000"]
    assert lines[-3:] == ["G0 Z5.0000", "M5", "M30"]
    depths = [float(z) for z in re.findall(r"G1 Z(-[\d.]+) F60", text)]
    assert depths == pytest.approx([-0.825, -1.65, -2.475, -3.3])
    assert "F240" in text
    assert "-0.0000" not in text


def test_every_arc_ends_on_its_radius(disc):
    x, y = 0.0, 0.0
    mismatches = []
    for line in disc.read_text().splitlines():
        words = {letter: float(value) for letter, value in re.findall(r"([A-Z])(-?[\d.]+)", line.split("(")[0])}
        if "I" in words:
            cx, cy = x + words["I"], y + words["J"]
            mismatches.append(np.hypot(words["I"], words["J"]) - np.hypot(words["X"] - cx, words["Y"] - cy))
        x, y = words.get("X", x), words.get("Y", y)
    assert len(mismatches) > 20
    print(f"arc radius mismatch {np.abs(mismatches).max() * 1e3:.3f} um")
    assert np.abs(mismatches).max() < 5e-4


def test_leads_stay_outside_and_touch_along_the_tangent(disc):
    moves = re.findall(r"^(G[0-3]) X(\S+) Y(\S+)(?: I(\S+) J(\S+))?", disc.read_text(), re.M)
    first = next(i for i, move in enumerate(moves) if move[0] == "G3")
    begin, start = (np.array(moves[i][1:3], dtype=float) for i in (first - 1, first))
    centre = begin + np.array(moves[first][3:5], dtype=float)
    # A quarter circle of the lead's radius whose centre stands behind the start, seen from the disc's own centre.
    assert np.linalg.norm(start - centre) == pytest.approx(MACHINING.lead_radius_mm, abs=1e-3)
    assert np.dot(start - centre, begin - centre) == pytest.approx(0, abs=1e-3)
    outwards = (start - [4.0, 3.0]) / np.linalg.norm(start - [4.0, 3.0])
    assert (centre - start) / MACHINING.lead_radius_mm == pytest.approx(outwards, abs=1e-3)
    assert np.linalg.norm(begin - [4.0, 3.0]) > 30.0 + MACHINING.cutter_diameter_mm / 2


def test_tool_stock_and_fixture_are_in_the_program_where_they_are_given(disc, tmp_path):
    given = Machining(tool_number=3, stock="plate 80 x 80 x 3 (6082)", fixture="on an 8 mm arbor")
    path = program(circle((4.0, 3.0), 30.0).curve(), tmp_path / "tool.nc", given)
    plain, lines = disc.read_text().splitlines(), path.read_text().splitlines()
    assert [line for line in lines if line not in plain] == [
        "(stock: plate 80 x 80 x 3 _6082_)",
        "(fixture: on an 8 mm arbor)",
        "T3 M6",
    ]
    assert lines.index("T3 M6") + 1 == next(n for n, line in enumerate(lines) if line.endswith("M3"))
    assert np.array_equal(
        read_gcode(path, given, THICKNESS).outline.points, read_gcode(disc, MACHINING, THICKNESS).outline.points
    )
    for file, machining in ((path, MACHINING), (disc, given), (path, Machining(tool_number=4))):
        with pytest.raises(FileError, match="takes the tool"):
            read_gcode(file, machining, THICKNESS)
    late = tmp_path / "late.nc"
    late.write_text(path.read_text().replace("T3 M6\n", "").replace("(pass 2", "T3 M6\n(pass 2"))
    with pytest.raises(FileError, match="changes the tool after the work has begun"):
        read_gcode(late, given, THICKNESS)


def test_a_cutter_too_large_is_refused_with_the_largest_that_works(tmp_path):
    b, a = 20.0, 13.0
    radius = (b - a) ** 2 / (2 * a - b)
    machining = Machining(cutter_diameter_mm=2.01 * radius)
    with pytest.raises(
        CheckError, match=f"no cutter of more than {2 * radius:.3f} mm reaches the hollow at polar angle 180"
    ):
        program(limacon(b, a), tmp_path / "dent.nc", machining)
    fitting = Machining(cutter_diameter_mm=1.9 * radius)
    outline = read_gcode(program(limacon(b, a), tmp_path / "dent.nc", fitting), fitting, THICKNESS).outline
    angle = np.arctan2(outline.points[:, 1], outline.points[:, 0])
    assert np.abs(np.linalg.norm(outline.points, axis=1) - b - a * np.cos(angle)).max() < 4e-4


def edited(disc, tmp_path, pattern, replacement, count=1):
    path = tmp_path / "edited.nc"
    text, changes = re.subn(pattern, replacement, disc.read_text(), count=count, flags=re.M)
    assert changes
    path.write_text(text)
    return path


def test_a_gouge_shows_in_the_outline(disc, tmp_path):
    # A lead-in that begins inside the part's edge.
    path = edited(disc, tmp_path, r"^G3 X(\S+) Y(\S+) I\S+ J\S+ F240", r"G1 X33.0 Y10.0 F240\nG1 X\1 Y\2", count=0)
    outline = read_gcode(path, MACHINING, THICKNESS).outline
    depth = 30.0 - np.hypot(*(outline.points - [4.0, 3.0]).T).min()
    # The cutter's edge reaches 2 mm beyond its centre at (33, 10), towards the part's centre.
    assert depth == pytest.approx(30.0 - (np.hypot(29.0, 7.0) - 2.0), abs=0.05)


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"I(-?\d+)\.", r"I1\1.", "radius is"),
        (r"^G0 Z5.0000\n\(pass 2", "(pass 2", "rapid speed through the stock"),
        (r"^G1 Z-0.8250 F60", "G0 Z-0.8250", "rapid speed through the stock"),
        (r"G21", "G20", "G20, which is not understood"),
        (r" G91\.1", "", "cuts before"),
        (r"^S8000 M3\n", "", "cuts before"),
        (r" F60", "", "cuts before"),
        (r"F60", "F600", "600 mm/min"),
        (r"Z-0\.8250", "Z-1.8250", "1.8250 mm deep"),
        (r"Z-3\.3000", "Z-2.9000", "does not cut through 3 mm"),
        (r"^M30\n", "", "no M30"),
        (r"^M30\n", "M30\nG0 X0\n", "after the program's end"),
        (r"^G0 Z5.0000\nM5", "M5", "stops with the cutter in the stock"),
        (r"^M5", "hello world", "not made of words"),
        (r"G1 Z-0.8250", "G1 X50 Z-0.8250", "sideways and down at once"),
    ],
)
def test_what_a_machine_would_refuse_or_regret_is_refused(disc, tmp_path, pattern, replacement, message):
    path = edited(disc, tmp_path, pattern, replacement)
    with pytest.raises(FileError, match=message):
        read_gcode(path, MACHINING, THICKNESS)


def test_passes_that_differ_are_refused(disc, tmp_path):
    path = edited(disc, tmp_path, r"^G3 X(\S+) Y(\S+) I\S+ J\S+ F240", r"G1 X\1 Y\2 F240")
    with pytest.raises(FileError, match="passes that differ"):
        read_gcode(path, MACHINING, THICKNESS)


def test_a_program_run_the_other_way_is_refused(tmp_path):
    curve = circle((4.0, 3.0), 30.0).curve()
    clockwise = cutter_path(curve, 2.0, largest_cutter(curve), 2e-4)
    write_gcode(tmp_path / "disc.nc", clockwise.reversed(), MACHINING, THICKNESS, name="disc")
    with pytest.raises(FileError, match="does not run clockwise"):
        read_gcode(tmp_path / "disc.nc", MACHINING, THICKNESS)


@pytest.mark.parametrize(
    ("design", "changes", "face"),
    [
        ("roller", {"motion.turns": "counterclockwise"}, "inner"),
        ("roller", {"motion.turns": "clockwise"}, "outer"),
        ("carbon_free_car", {}, "outer"),
        ("carbon_free_car", {"cam.side": "right"}, "inner"),
    ],
)
def test_every_program_says_which_face_lies_up(design, changes, face, tmp_path):
    """The face that the sheet shows: turned over, the disc would run its motion backwards."""
    from cadgen import Design
    from cadgen.jobs.cam.cam_files import cam_export
    from cadgen.output.files.nc import programs

    plan = Design.load(design).with_(changes).cam("actual").computed
    assert plan.seen == face
    written = [tmp_path / program.name for program, _ in programs(cam_export(plan), tmp_path, 0.5)]
    for file in written:
        (line,) = [line for line in file.read_text().splitlines() if line.startswith("(zero")]
        assert line == f"(zero: centre of the bore, {face} face of the disc; cam angle 0 along +X, {face} face up)"


def test_names_that_lose_their_letters_are_told_apart():
    one, other = plain("凸轮一_actual, seen on the outer face"), plain("凸轮二_actual, seen on the outer face")
    assert re.fullmatch(r"actual_[0-9a-f]{4}, seen on the outer face", one)
    assert one != other
    assert plain("my_cam-2 (5 µm)") == "my_cam-2 _5 _m_"
