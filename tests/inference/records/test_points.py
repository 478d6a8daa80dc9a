"""Points of a path from rows of numbers and from DXF."""

from math import hypot

import ezdxf
import pytest

from cadgen.errors import FileError
from cadgen.inference.records.points import read_points

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
        ("0 0\n1 1\n", "has 2 points; a path needs at least 4"),
    ],
)
def test_rows_that_are_no_points_are_named(text, message, tmp_path):
    (tmp_path / "p.txt").write_text(text)
    with pytest.raises(FileError, match=message):
        read_points(tmp_path / "p.txt")


def drawing(tmp_path, unit, polylines):
    made = ezdxf.new(units=unit)
    for layer, corners, closed in polylines:
        made.modelspace().add_lwpolyline(corners, close=closed, dxfattribs={"layer": layer})
    made.saveas(tmp_path / "path.dxf")
    return tmp_path / "path.dxf"


PATH = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0), (3.0, 0.5)]


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
