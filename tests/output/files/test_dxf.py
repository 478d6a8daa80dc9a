"""DXF read again by its own reader, by ezdxf and by trimesh, and rolled against the rod."""

import ezdxf
import numpy as np
import pytest
import trimesh

from cadgen.cam.contact import roll
from cadgen.curves.biarc import arcs
from cadgen.curves.contour import circle, keyway_bore
from cadgen.curves.spline import splines
from cadgen.errors import FileError
from cadgen.output.files.dxf import BORE, HOLES, NOTES, PROFILE, read_dxf, write_dxf

BORE_CONTOUR = keyway_bore(8.0, 3.0, 1.4, np.radians(20))
HOLE_CONTOURS = tuple(circle((39.0 * np.cos(a), 39.0 * np.sin(a)), 9.0) for a in np.arange(6) * np.pi / 3)


@pytest.fixture(scope="module", params=["arcs", "spline"])
def drawing(request, carbon_free_car, tmp_path_factory):
    curve = carbon_free_car.actual.curve
    profile = arcs(curve, 2e-4) if request.param == "arcs" else splines(curve, 1e-4, 3)
    path = tmp_path_factory.mktemp("dxf") / f"cam_{request.param}.dxf"
    write_dxf(path, profile, BORE_CONTOUR, HOLE_CONTOURS)
    return path, profile


def test_the_rod_on_what_was_read_gives_the_lift(drawing, carbon_free_car):
    car = carbon_free_car
    angle = np.linspace(0, 2 * np.pi, 7200, endpoint=False)
    lift = roll(read_dxf(drawing[0]).profile, car.follower, angle).lift
    wanted = car.follower.lift(car.lift.q(angle))
    error = np.abs(lift - wanted).max() * 1e3
    print(f"{drawing[0].name}: {error:.3f} um at lift, {drawing[0].stat().st_size} bytes")
    assert error <= 1.0


def test_bore_and_holes_come_back_exactly(drawing):
    read = read_dxf(drawing[0])
    (bore,) = read.bore
    assert np.array_equal(bore.vertices, BORE_CONTOUR.vertices)
    assert np.array_equal(bore.bulges, BORE_CONTOUR.bulges)
    assert len(read.holes) == len(HOLE_CONTOURS)
    for hole, original in zip(read.holes, HOLE_CONTOURS, strict=True):
        assert hole.is_circle
        assert hole.centers == pytest.approx(original.centers, abs=1e-12)
        assert hole.radii == pytest.approx(original.radii, rel=1e-14)


def test_equal_input_gives_equal_bytes(drawing, tmp_path):
    path, profile = drawing
    again = tmp_path / "again.dxf"
    write_dxf(again, profile, BORE_CONTOUR, HOLE_CONTOURS)
    assert again.read_bytes() == path.read_bytes()
    assert ezdxf.options.write_fixed_meta_data_for_testing is False


def test_ezdxf_finds_units_layers_and_no_fault(drawing, carbon_free_car):
    document = ezdxf.readfile(drawing[0])
    assert document.units == ezdxf.units.MM
    assert not document.audit().errors
    kinds = sorted((entity.dxf.layer, entity.dxftype()) for entity in document.modelspace())
    outer = ["LWPOLYLINE"] if "arcs" in drawing[0].name else ["SPLINE"] * 5
    assert kinds == sorted(
        [(PROFILE, kind) for kind in outer] + [(BORE, "LWPOLYLINE")] + [(HOLES, "CIRCLE")] * len(HOLE_CONTOURS)
    )
    points = carbon_free_car.actual.curve.outline(0.1).points
    low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
    assert [*low[:2], *high[:2]] == pytest.approx([*points.min(axis=0), *points.max(axis=0)], abs=0.5)


def test_trimesh_reads_the_same_curve(drawing, carbon_free_car):
    path = trimesh.load_path(drawing[0])
    curve = carbon_free_car.actual.curve
    rim = [entity for entity in path.entities if np.linalg.norm(path.vertices[entity.points[0]]) > 55]
    assert len(rim) == (5 if "spline" in drawing[0].name else len(drawing[1].bulges))
    # An arc is kept as its two ends and its middle.
    points = np.concatenate(
        [
            path.vertices[entity.points]
            if isinstance(entity, trimesh.path.entities.Arc)
            else entity.discrete(path.vertices, count=200)
            for entity in rim
        ]
    )
    off = np.linalg.norm(points, axis=1) - curve.radius(np.arctan2(points[:, 1], points[:, 0]))
    assert np.abs(off).max() < 2.5e-4


def damaged(text, kind):
    if kind == "cut short":
        return text[: len(text) // 2]
    if kind == "inches":
        return text.replace("$INSUNITS\n 70\n4\n", "$INSUNITS\n 70\n1\n")
    if kind == "no profile":
        return text.replace(PROFILE, BORE)
    if kind == "open":
        start = text.index("AcDbPolyline")
        return text[:start] + text[start:].replace(" 70\n1\n", " 70\n0\n", 1)
    return "not a drawing"


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ("cut short", "not a complete DXF file"),
        ("inches", "not in millimetres"),
        ("no profile", "one closed curve on layer CAM_PROFILE"),
        ("open", "LWPOLYLINE on layer CAM_PROFILE, open"),
        ("text", "not a complete DXF file"),
    ],
)
def test_a_damaged_file_is_refused(kind, message, tmp_path):
    path = tmp_path / "cam.dxf"
    profile = arcs(circle((0.0, 0.0), 60.0).curve(), 1e-3)
    write_dxf(path, profile, circle((0.0, 0.0), 4.0), ())
    text = path.read_text()
    assert damaged(text, kind) != text
    path.write_text(damaged(text, kind))
    with pytest.raises(FileError, match=message):
        read_dxf(path)


def test_a_gap_between_splines_is_refused(tmp_path, carbon_free_car):
    path = tmp_path / "cam.dxf"
    parts = splines(carbon_free_car.actual.curve, 1e-3, 3)
    write_dxf(path, parts[:-1], BORE_CONTOUR, ())
    with pytest.raises(FileError, match="gap between two splines"):
        read_dxf(path)


def test_a_note_stands_beside_the_outline(tmp_path):
    path = tmp_path / "disc.dxf"
    write_dxf(path, circle((0.0, 0.0), 30.0), BORE_CONTOUR, (), "break both edges by 0.2 mm")
    read = read_dxf(path)
    assert read.note == "break both edges by 0.2 mm"
    document = ezdxf.readfile(path)
    assert document.layers.get(NOTES).dxf.plot == 0
    (text,) = document.modelspace().query("TEXT")
    assert text.dxf.layer == NOTES
    assert text.dxf.insert.y + text.dxf.height < -30.0
    write_dxf(path, circle((0.0, 0.0), 30.0), BORE_CONTOUR, ())
    assert read_dxf(path).note == ""
    assert NOTES not in ezdxf.readfile(path).layers
