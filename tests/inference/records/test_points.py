"""Points of a path from rows of numbers and from DXF."""

from math import hypot
from pathlib import Path

import ezdxf
import pytest

from cadgen.errors import FileError
from cadgen.inference.records.points import read_points

DRAWINGS = Path(__file__).parents[2] / "data" / "dxf"
ROWS = {
    "spaces": "0 0\n10 5\n20 0\n30 5\n",
    "commas and words": "x_mm,y_mm,weight\n0,0,1\n10,5,1\n20,0,1\n30,5,1\n",
    "semicolons and remarks": "# mine\n0; 0\n10; 5 # turn\n\n20; 0\n30; 5",
}


@pytest.mark.parametrize("name", ROWS)
def test_rows_are_read_however_they_are_separated(name, tmp_path):
    (tmp_path / "p.csv").write_text(ROWS[name])
    points = read_points(tmp_path / "p.csv")
    assert points.places == ((0, 0), (10, 5), (20, 0), (30, 5))
    assert points.weights == (1, 1, 1, 1)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 0\n1 nan\n", "line 2: `1 nan` is no point"),
        ("0 0\n1 1 1 1\n", "line 2: `1 1 1 1` is no point"),
        ("0 0 -1\n", "line 1: `0 0 -1` is no point"),
        ("a b\nc d\n", "line 2: `c d` is no point"),
        ("x,y\n0,0,5\n", "line 2: `0,0,5` is no point"),
        ("x [px],y [px]\n0,0\n", "`px` is no unit of length that is known"),
        ("x,y,speed\n0,0,5\n", "the column speed beside x and y is not understood: take it out, or call it weight"),
        ("# x [m], y [m], speed\n0 0 5\n", "the column speed beside x and y is not understood"),
        ("# y, x, by hand\n0 0\n", "the column by hand beside x and y is not understood"),
        ("x, y [m]\n0,0\n", "the unit m stands at one of the two columns alone: write one at both"),
        ("Path of car 3, in m\n0,0\n", "the unit m stands at one of the two columns alone"),
        ("0 0\n1 1\n", "has 2 points; a path needs at least 4"),
    ],
)
def test_rows_that_are_no_points_are_named(text, message, tmp_path):
    (tmp_path / "p.txt").write_text(text)
    with pytest.raises(FileError, match=message):
        read_points(tmp_path / "p.txt")


@pytest.mark.parametrize(
    "text",
    [
        "X;Y\n0;0\n450,5;120\n900;500,25\n1500;-5\n",
        "0 0\n450,5 120\n900 500,25\n1500 -5\n",
        "Nr\tX\tY\n1\t0\t0\n2\t450,5\t120\n3\t900\t500,25\n4\t1500\t-5\n",
        "East [m];North [m]\n0;0\n0,4505;0,12\n0,9;0,50025\n1,5;-0,005\n",
        "# x_cm y_cm\n0 0\n45.05 12\n90 50.025\n150 -.5\n",
        "t,x,y,z\n0,0,0,9\n1,450.5,120,9\n2,900,500.25,9\n3,1500,-5,9\n",
        "X Y [weight]\n0 0 1\n450.5 120\n900 500.25\n1500 -5\n",
        "X坐标/mm，Y坐标/mm\n0，0\n450.5，120\n900，500.25\n1500，-5\n",
    ],
)
def test_points_as_people_export_them(text, tmp_path):
    (tmp_path / "p.csv").write_text(text, encoding="utf-8")
    points = read_points(tmp_path / "p.csv")
    assert points.places == tuple(pytest.approx(p) for p in ((0, 0), (450.5, 120), (900, 500.25), (1500, -5)))
    assert points.weights == (1, 1, 1, 1)


def drawing(tmp_path, unit, polylines):
    made = ezdxf.new(units=unit)
    for layer, corners, closed in polylines:
        made.modelspace().add_lwpolyline(corners, close=closed, dxfattribs={"layer": layer})
    made.saveas(tmp_path / "path.dxf")
    return tmp_path / "path.dxf"


PATH = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0), (3.0, 0.5)]


@pytest.mark.parametrize(
    ("header", "first"),
    [
        ("Y X", (25.0, 90.0)),
        ("y_m;x_m", (25e3, 90e3)),
        ("X [cm], Y [in]", (900.0, 635.0)),
        ("East, North", (90.0, 25.0)),
        ("x", (90.0, 25.0)),
    ],
)
def test_a_header_says_the_order_and_the_unit(header, first, tmp_path):
    path = tmp_path / "points.csv"
    path.write_text(f"{header}\n90, 25\n170, -15\n260, -30\n340, 15\n")
    assert read_points(path).places[0] == pytest.approx(first)


def test_a_polyline_is_read_in_its_unit_beside_closed_ones(tmp_path):
    file = drawing(tmp_path, 6, [("PATH", PATH, False), ("FIELD", [(0, 0), (4, 0), (4, 4)], True)])
    assert read_points(file).places == ((0, 0), (1000, 500), (2000, 0), (3000, 500))


def test_an_arc_of_a_polyline_is_followed_within_a_millimetre(tmp_path):
    file = drawing(tmp_path, 4, [("PATH", [(0, 0, 0, 0, 1.0), (2000, 0, 0, 0, 0)], False)])
    places = read_points(file).places
    assert len(places) > 20
    assert max(abs(hypot(x - 1000, y) - 1000) for x, y in places) < 1.0


def test_one_of_several_polylines_is_named_by_its_layer(tmp_path):
    file = drawing(tmp_path, 4, [("A", PATH, False), ("B", [(x, -y) for x, y in PATH], False)])
    with pytest.raises(FileError, match=r"has 2 open polylines \(layers with one: A, B\)"):
        read_points(file)
    assert read_points(file, "B").places[1] == (1.0, -0.5)
    (tmp_path / "p.txt").write_text("0 0\n")
    with pytest.raises(FileError, match="has no layers"):
        read_points(tmp_path / "p.txt", "A")
    (tmp_path / "no.dxf").write_bytes(b"no drawing")
    with pytest.raises(FileError, match=r"no\.dxf"):
        read_points(tmp_path / "no.dxf")


@pytest.mark.parametrize("name", ["bad_dxf_6", "bad_dxf_28", "bad_dxf_53"])
def test_a_damaged_drawing_is_one_sentence(name):
    """The library ends on these with IndexError, AttributeError and UnicodeDecodeError."""
    with pytest.raises(FileError, match=rf"^{name}\.dxf is no DXF that can be read \([^\n]+\): save it again$"):
        read_points(DRAWINGS / f"{name}.dxf")


def test_a_command_on_a_damaged_drawing_says_nothing_but_the_sentence(forks, tmp_path):
    """The library logs 34 lines on its entities."""
    drawing = str(DRAWINGS / "bad_dxf_28.dxf")
    run = forks.run("from cadgen.cli import main; main()", "new", "a", "--points", drawing, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (3, "")
    assert run.stderr.startswith("cadgen: bad_dxf_28.dxf is no DXF that can be read (")
    assert run.stderr.count("\n") == 1


def test_a_bulge_without_bound_is_refused_before_its_arc_is_followed():
    """A bulge of 1e12 is an arc of 1e16 mm: to a millimetre, it has a hundred million points."""
    with pytest.raises(FileError, match=r"^bulge\.dxf: its polyline reaches [\d.]+e\+16 mm .* correct its corners"):
        read_points(DRAWINGS / "bulge.dxf")


@pytest.mark.parametrize("place", [(1e9, 0.0), (float("inf"), 0.0), (0.0, float("nan"))])
def test_a_corner_that_no_path_has_is_refused(place, tmp_path):
    with pytest.raises(FileError, match=r"path\.dxf"):
        read_points(drawing(tmp_path, 4, [("PATH", [*PATH, place], False)]))


def test_more_points_than_a_design_has_room_for_are_refused(tmp_path):
    many = [(float(k), float(k % 7)) for k in range(10_001)]
    text = "".join(f"{x} {y}\n" for x, y in many)
    (tmp_path / "fits.csv").write_text(text[: text.rindex("10000.0")])
    assert len(read_points(tmp_path / "fits.csv").places) == 10_000
    (tmp_path / "p.csv").write_text(text)
    for file in (tmp_path / "p.csv", drawing(tmp_path, 4, [("PATH", many, False)])):
        with pytest.raises(FileError, match="has more than 10000 points"):
            read_points(file)
    arcs = [(8e5 * (k % 2), 0.0, 0.0, 0.0, 1.0) for k in range(200)]
    with pytest.raises(FileError, match="has more than 10000 points"):
        read_points(drawing(tmp_path, 4, [("PATH", arcs, False)]))


def test_a_mesh_among_polylines_is_no_path(tmp_path):
    made = ezdxf.new(units=4)
    made.modelspace().add_polyface().append_faces([[(0, 0), (1, 0), (1, 1)]])
    made.modelspace().add_lwpolyline(PATH)
    made.saveas(tmp_path / "path.dxf")
    assert len(read_points(tmp_path / "path.dxf").places) == 4


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("0 0\n900 250\n900 250\n1700 0\n2600 0\n", r"points 2 and 3 are both \(900, 250\): remove one"),
        ("0 0\n", "has one point; a path needs at least 4"),
    ],
)
def test_points_that_make_no_path_are_refused(rows, said, tmp_path):
    path = tmp_path / "points.csv"
    path.write_text(rows)
    with pytest.raises(FileError, match=said):
        read_points(path)
