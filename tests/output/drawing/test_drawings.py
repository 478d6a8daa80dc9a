"""Drawings: each dimension is that of the solid in the STEP file, measured by the CAD kernel on its faces."""

import csv
import json
import os
import re
import shutil
import subprocess
from dataclasses import replace
from math import hypot
from pathlib import Path

import numpy as np
import pytest
import trimesh

from cadgen import Design, draw
from cadgen.errors import CheckError, DesignError, FileError
from cadgen.jobs.drawings import Folder, _as_given, sheet_of
from cadgen.output.drawing.shaft_fit import deeper, limited, limits
from cadgen.output.drawing.sheet import DrawingSheet, LinearDimension, Title, View
from cadgen.output.drawing.sheet_files import document_of, read_dimensions
from cadgen.output.files.manifest import Origin

CLOSE = 1e-4  # mm
LIBRECAD_FONT = Path("/usr/share/librecad/fonts/standard.lff")


def measured(solid) -> dict[str, set[float]]:
    """Diameters of the cylinders on the axis and beside it, of the circle of those beside, gaps of parallel planes."""
    from build123d import GeomType

    on_axis, beside, circle = set(), set(), set()
    planes, screws, drills, angles = [], set(), set(), set()
    for face in solid.faces():
        if face.geom_type == GeomType.CYLINDER and abs(face.axis_of_rotation.direction.Z) < 1e-9:
            screws.add(face.axis_of_rotation.position.Z)
            drills.add(2 * face.radius)
            way = face.axis_of_rotation.direction
            angles |= {np.degrees(np.arctan2(side * way.Y, side * way.X)) % 360 for side in (-1, 1)}
        elif face.geom_type == GeomType.CYLINDER:
            place = face.axis_of_rotation.position
            away = hypot(place.X, place.Y)
            (on_axis if away < 1e-6 else beside).add(2 * face.radius)
            if away > 1e-6:
                circle.add(2 * away)
                angles.add(np.degrees(np.arctan2(place.Y, place.X)) % 360)
        elif face.geom_type == GeomType.PLANE:
            normal, point = face.normal_at(), face.center()
            planes.append((np.array([*normal]), np.array([*point])))
    gaps = {abs(float((b - a) @ n)) for n, a in planes for m, b in planes if abs(abs(float(n @ m)) - 1) < 1e-9}
    corners = [hypot(vertex.X, vertex.Y) for vertex in solid.vertices()]
    floors = {abs(float(n @ a)) for n, a in planes if abs(n[2]) < 1e-9}
    angles |= {np.degrees(np.arctan2(-n[1], -n[0])) % 360 for n, _ in planes if abs(n[2]) < 1e-9}  # flat, key's floor
    return {
        "radius": {each / 2 for each in circle},
        "drill": drills,
        "angle": angles | {360 - angle for angle in angles},
        "on the axis": on_axis,
        "beside": beside,
        "circle": circle,
        "gap": gaps,
        "floor": {floor + bore / 2 for floor in floors for bore in on_axis},
        "screw": {abs(screw - a[2]) for screw in screws for n, a in planes if abs(n[2]) > 0.5},
        "corner": {2 * corner for corner in corners},
    }


WHERE = {
    "bore": "on the axis",
    "hub diameter": "on the axis",
    "collar diameter": "on the axis",
    "recess diameter": "on the axis",
    "hole": "beside",
    "mark": "beside",
    "circle of holes": "circle",
    "keyway width": "gap",
    "thickness": "gap",
    "hub length": "gap",
    "length": "gap",
    "web thickness": "gap",
    "bore and keyway": "floor",
    "across the flat": "floor",
    "set screw height": "screw",
    "set screw": "drill",
    "circle of the mark": "radius",
}


def agree(dimensions: dict[str, float], solid) -> None:
    found = measured(solid)
    assert dimensions
    for name, length in dimensions.items():
        kind = WHERE.get(name) or ("corner" if name.startswith("tip diameter") else name.split()[-1])
        others = found.get(kind, found["gap"])
        assert min(abs(length - other) for other in others) < CLOSE, (name, length, sorted(others))


# What the design states for a workshop, taken out of it.
UNSTATED = {
    "drawing": None,
    "blank.joint": None,
    "blank.bore_fit": None,
    "train.material": None,
    "train.cutting": None,
    "train.plate": None,
    **{
        f"train.{place}.{key}": None
        for place in ("drive", "intermediate", "output")
        for key in ("bore_fit", "joint", "cut_apart")
    },
    "train.drive.hub.set_screw_thread": None,
}


@pytest.fixture(scope="module")
def design():
    return Design.load("carbon_free_car").with_(UNSTATED)


@pytest.fixture(scope="module")
def cam(design):
    return design.cam("actual")


@pytest.fixture(scope="module")
def train(design):
    return design.gears()


@pytest.fixture(scope="module")
def folder(tmp_path_factory, cam):
    out = tmp_path_factory.mktemp("cam_drawings")
    cam.write(out, ["dxf"])
    draw(out, cam=cam)
    return out


@pytest.fixture(scope="module")
def trains_folder(tmp_path_factory, train):
    out = tmp_path_factory.mktemp("train_drawings")
    draw(out, train=train)
    return out


@pytest.mark.slow
@pytest.mark.parametrize(
    "changes",
    [
        {},
        {
            "blank.hub": {
                "diameter_mm": 24.0,
                "length_mm": 10.0,
                "side": "inner",
                "set_screw": {"hole_diameter_mm": 4.2, "height_mm": 4.5, "angle_deg": 220.0},
            },
            "blank.keyway": None,
            "blank.d_flat": {"across_mm": 7.2, "angle_deg": 40.0},
            "blank.lightening.holes": 1,
            "blank.mark": {"diameter_mm": 3.5, "radius_mm": 20.0, "angle_deg": 100.0},
        },
    ],
)
def test_the_dimensions_of_a_cam_are_those_of_its_step_file(changes, design, tmp_path):
    from build123d import import_step

    cam = design.with_(changes).cam("actual")
    (step,) = cam.write(tmp_path, ["step"])
    drawn = draw(tmp_path, cam=cam)
    (page,) = [file for file in drawn if file.name.endswith("drawing.dxf")]
    agree(read_dimensions(page.path), import_step(str(step.path)))


@pytest.mark.slow
@pytest.mark.long
def test_the_dimensions_of_gears_are_those_of_their_step_files(trains_folder, train, tmp_path):
    from build123d import import_step

    from cadgen.geometry.solids.gear_solids import train_parts
    from cadgen.geometry.solids.step import step_bytes

    plan = train.computed
    for part in train_parts(plan.layout, plan.stem, plan.description)[1::2]:  # a cluster, and the keyed wheel
        step = tmp_path / f"{part.name}.step"
        step.write_bytes(step_bytes(part))
        agree(read_dimensions(trains_folder / f"{part.name}_drawing.dxf"), import_step(str(step)))


@pytest.mark.slow
@pytest.mark.long
def test_dimensions_are_those_that_the_design_names(trains_folder, design, tmp_path):
    """Also on a gear without a bore, which has a ring less in every section; and no number stands on its head."""
    import ezdxf

    expected = {"web thickness": 3.0, "hole": 10.0, "width, lower gear": 5.0, "collar diameter": 10.0}
    plain = design.with_({"train.intermediate.bore_diameter_mm": 0.0}).gears()
    draw(tmp_path, train=plain)
    for place in (trains_folder, tmp_path):
        lengths = read_dimensions(place / "carbon_free_car_as-given_2_cluster_drawing.dxf")
        assert {name: lengths[name] for name in expected} == pytest.approx(expected, abs=1e-9)
    wheel = read_dimensions(trains_folder / "carbon_free_car_as-given_4_wheel_drawing.dxf")
    expected = {"bore": 8.0, "keyway width": 3.0, "bore and keyway": 9.4, "hub diameter": 16.0, "hub length": 6.0}
    assert {name: wheel[name] for name in expected} == pytest.approx(expected, abs=1e-9)
    for file in trains_folder.glob("*_drawing.dxf"):
        for dimension in ezdxf.readfile(file).modelspace().query("DIMENSION"):
            for text in dimension.virtual_entities():
                if text.dxftype() in ("TEXT", "MTEXT"):
                    turned = text.dxf.rotation % 360 if text.dxf.hasattr("rotation") else 0.0
                    assert turned <= 90.5 or turned >= 270 - 1e-6, (file.name, turned)


@pytest.mark.slow
def test_texts_of_the_title_block_change_no_part(design):
    assert design.with_({"drawing.quantity": 3, "drawing.finish": "Ra 1.6"}).sha256 == design.sha256
    with pytest.raises(DesignError, match=r"drawing\.title has 🚗, which the fonts of drawings lack"):
        design.with_({"drawing.title": "car 🚗"})
    with pytest.raises(DesignError, match="1 to 36 letters"):
        design.with_({"drawing.finish": "x" * 37})


@pytest.mark.slow
@pytest.mark.long
def test_the_plate_has_the_axes_of_the_train(trains_folder, train):
    lengths = read_dimensions(trains_folder / f"{train.computed.stem}_plate_drawing.dxf")
    apart = [stage["centre_distance_mm"] for stage in train.facts()["stages"]]
    assert [lengths[f"axes {n} and {n + 1}"] for n in (1, 2, 3)] == pytest.approx(apart, abs=1e-9)


@pytest.mark.slow
@pytest.mark.long
def test_another_reader_sees_the_sheet_and_the_outlines(trains_folder):
    """trimesh reads lines, arcs and circles by code of its own: the gear's outline is closed and has the tips' size."""
    for file in trains_folder.glob("*_drawing.dxf"):
        assert len(trimesh.load_path(file).entities) > 40
    outline = trimesh.load_path(trains_folder / "carbon_free_car_as-given_1_pinion_outline.dxf")
    reach = np.linalg.norm(np.concatenate([entity.discrete(outline.vertices) for entity in outline.entities]), axis=1)
    assert reach.max() == pytest.approx(8.0, abs=1e-3)


@pytest.mark.slow
def test_what_the_sheets_leave_open_is_named_with_its_key(folder, cam, tmp_path):
    entry = json.loads((folder / "manifest.json").read_text())["parts"]["carbon_free_car_cam_drawings"]
    assert entry["not_stated"] == {
        "material": "blank.material",
        "fit of the bore": "blank.bore_fit",
        "surface finish": "drawing.finish",
    }
    stated = {"blank.material": "aluminium", "blank.bore_fit": "H7/g6", "drawing.finish": "Ra 1.6"}
    told = Design.load("carbon_free_car").with_(UNSTATED | stated).cam("actual")
    assert "not_stated" not in draw(tmp_path, cam=told).entry


@pytest.mark.slow
def test_the_sheet_names_the_files_by_their_hashes(folder, cam):
    import ezdxf

    parts = json.loads((folder / "manifest.json").read_text())["parts"]
    listed = {name: facts["sha256"] for part in parts.values() for name, facts in part["files"].items()}
    drawn = ezdxf.readfile(folder / "carbon_free_car_actual_drawing.dxf")
    texts = " ".join(text.dxf.text for text in drawn.modelspace().query("TEXT"))
    name = "carbon_free_car_actual_spline.dxf"
    assert name in texts
    assert listed[name][:12] in texts
    assert cam.computed.design.content_hash[:12] in texts


def sheet(views=(), title="t", finish=""):
    """A sheet with hardly anything on it."""
    block = Title(part="p", title=title, material="", finish=finish, quantity=1, date="", design="d", number="n")
    return DrawingSheet(size="A4", scale=1.0, title=block, views=views, tables=(), notes=(), columns=())


@pytest.mark.slow
def test_a_title_in_chinese_is_drawn_with_a_font_of_the_system(tmp_path, monkeypatch):
    """The letters are outlines in the PDF and texts in the DXF; without such a font the page alone is left out."""
    import ezdxf

    from cadgen.jobs.drawings import write_sheet
    from cadgen.output.drawing import sheet_files
    from cadgen.output.drawing.sheet_files import SheetDocument

    chinese, omitted = sheet(title="无碳小车", finish="Ra 1.6，去毛刺"), {}
    monkeypatch.setattr(sheet_files, "_far_eastern_files", lambda: ())
    assert [file.name for file in write_sheet(tmp_path, "n", chinese, omitted)] == ["n_drawing.dxf"]
    assert "no font of this system has" in omitted["PDF"]
    texts = {text.dxf.text: text.dxf.style for text in ezdxf.readfile(tmp_path / "n_drawing.dxf").query("TEXT")}
    assert texts["无碳小车"] == texts["Ra 1.6，去毛刺"] == "CADGEN_CJK"
    assert texts["d"] == "CADGEN"
    monkeypatch.undo()
    try:
        page = SheetDocument(chinese).page()
    except sheet_files.NoFontError:
        pytest.skip("this system has no font with Chinese letters")
    assert page.startswith(b"%PDF")
    assert sheet_files.know_far_eastern(frozenset("无碳小车")) in {
        file.name for file in sheet_files._far_eastern_files()
    }


@pytest.mark.slow
def test_a_sheet_is_said_in_the_language_that_is_shown(cam, tmp_path, monkeypatch):
    """Its dimensions keep their names; without a font for the letters the page is English, and that is said."""
    import ezdxf

    from cadgen import messages
    from cadgen.output.drawing import sheet_files

    before = messages.language()
    messages.choose("zh")
    try:
        monkeypatch.setattr(sheet_files, "_far_eastern_files", lambda: ())
        written = draw(tmp_path, cam=cam)
    finally:
        messages.choose(before)
    (file,) = [file for file in written if file.name.endswith("drawing.dxf")]
    texts = {text.dxf.text: text.dxf.style for text in ezdxf.readfile(file.path).modelspace().query("TEXT")}
    assert texts["绕轴的轮廓"] == texts["比例"] == "CADGEN_CJK"
    assert not [text for text in texts if "arrow" in text]
    assert "bore" in read_dimensions(file.path)
    assert [file.name for file in written if file.name.endswith(".pdf")]
    assert "the pages are in English" in written.omitted["translated PDF"]


@pytest.fixture(scope="module")
def toleranced():
    """Sheets of a keyed car's cam, of a groove and of a roller's cam with a D-shaft, each with a tolerance."""
    flat = {"blank.keyway": None, "blank.d_flat": {"across_mm": 14.5, "angle_deg": 40.0}}
    textures = {"drawing": {"rim_finish": "Ra 0.8", "bore_finish": "Ra 1.6"}}
    designs = (
        Design.load("carbon_free_car").with_({"tolerances.profile_offset_mm": 0.01}),
        Design.load("groove").with_({"lift_tolerances.base_circle_um": 20.0, **textures}),
        Design.load("roller").with_({"lift_tolerances.base_circle_um": 12.5, **flat, **textures}),
    )
    return [sheet_of(design.cam("actual").computed, Folder({}, "2026-01-01")) for design in designs]


def boxes(space) -> list:
    """Boxes of the texts of a page by the widths of their letters, with the texts."""
    import shapely
    from ezdxf.bbox import extents
    from ezdxf.fonts import fonts
    from shapely.affinity import rotate, translate

    from cadgen.output.drawing.sheet_files import FONT, know_font

    know_font()
    found = []
    for entity in space.query("TEXT DIMENSION"):
        parts = [entity] if entity.dxftype() == "TEXT" else entity.get_geometry_block().query("MTEXT")
        for part in parts:
            if part.dxftype() == "MTEXT":  # in one line, its middle at its place; ezdxf's extents would break it
                high = part.dxf.char_height
                long = fonts.make_font(FONT, high).text_width(part.plain_text())
                box = shapely.box(-long / 2, -high / 2, long / 2, high / 2)
                box = translate(rotate(box, part.get_rotation(), origin=(0.0, 0.0)), *part.dxf.insert.vec2)
            else:
                whole = extents([part])
                box = shapely.box(*whole.extmin.vec2, *whole.extmax.vec2)
            found.append((box, part.plain_text()))
    return found


@pytest.mark.slow
def test_the_tolerance_of_an_outline_stands_in_a_frame_that_refers_to_marked_datums(toleranced):
    """The arrow stands on the outline, at right angles to it; each datum on its bore, or in line with its width."""
    import shapely

    from cadgen.output.drawing.sheet import Characteristic, DatumFeature, SurfaceTexture, ToleranceFrame

    zones, textures = [], []
    for drawn in toleranced:
        face = drawn.views[0]
        every = [symbol for symbol in face.symbols if isinstance(symbol, ToleranceFrame)]
        frames = [frame for frame in every if frame.characteristic == Characteristic.LINE_PROFILE]
        datums = {symbol.letter: symbol for symbol in face.symbols if isinstance(symbol, DatumFeature)}
        dimensions = {dimension.name: dimension for dimension in face.dimensions}
        zones += [frame.zone for frame in frames]
        signs = [symbol for symbol in face.symbols if isinstance(symbol, SurfaceTexture)]
        textures.append([(sign.value, sign.all_around) for sign in signs])
        outlines = [
            shapely.LinearRing(curve.contour.polygon(1e-3)) for curve in face.curves if hasattr(curve, "contour")
        ]
        for frame in (*frames, *signs):
            touched = min(outlines, key=lambda line: line.distance(shapely.Point(frame.tip)))
            assert touched.distance(shapely.Point(frame.tip)) < 2e-2
            way = np.subtract(frame.bend, frame.tip)
            near, far = (touched.project(shapely.Point(frame.tip)) + step for step in (-0.2, 0.2))
            ends = [touched.interpolate(at % touched.length).coords[0] for at in (near, far)]
            assert abs(np.subtract(*ends) @ way) < 0.05 * np.linalg.norm(np.subtract(*ends)) * np.linalg.norm(way)
        assert np.hypot(*datums["A"].foot) == pytest.approx(dimensions["bore"].diameter / 2)
        keyed, width = "keyway width" in dimensions, dimensions.get("keyway width") or dimensions["across the flat"]
        (middle,) = [frame for frame in every if frame not in frames] or [None]
        assert (middle is not None) == keyed  # B hangs from the frame of the keyway
        aside = np.subtract(middle.tip if keyed else datums["B"].foot, width.at)
        along = np.array([np.cos(np.radians(width.angle)), np.sin(np.radians(width.angle))])
        assert aside @ [-along[1], along[0]] == pytest.approx(0.0, abs=1e-9)
        way = np.subtract(middle.bend, middle.tip) if keyed else np.subtract(datums["B"].foot, width.at)
        assert way @ [-along[1], along[0]] == pytest.approx(0.0, abs=1e-4)
        assert {(frame.all_around, frame.datums) for frame in frames} == {(True, ("A", "B"))}
        # What the frame holds is theoretically exact: radii by the angle, base circle, width of a groove.
        for table in drawn.tables[:3]:
            if table.rows[0][0] == "θ, °":
                assert {row for row, _ in table.exact} == set(range(1, len(table.rows)))
                assert {column for _, column in table.exact} == set(range(len(table.widths)))
        held = [dimensions[name] for name in ("base circle", "groove width") if name in dimensions]
        assert all(each.exact for each in held)
    assert zones == pytest.approx([0.02, 0.04, 0.04, 0.025])
    rim, bore = ("Ra 0.8", True), ("Ra 1.6", False)
    assert textures == [[], [rim, rim, bore], [rim, bore]]


def test_a_frame_refers_to_no_datum_that_is_not_marked():
    from cadgen.output.drawing.sheet import Characteristic, ToleranceFrame

    frame = ToleranceFrame(
        name="outline",
        characteristic=Characteristic.LINE_PROFILE,
        zone=0.02,
        datums=("A",),
        tip=(0.0, 0.0),
        bend=(5.0, 0.0),
    )
    with pytest.raises(ValueError, match="datum A of a sheet is marked 0 times"):
        sheet((View(place=(0.0, 0.0), curves=(), symbols=(frame,)),))


@pytest.mark.slow
def test_no_text_of_a_sheet_lies_on_another_and_heights_are_those_of_the_series(toleranced):
    from cadgen.output.drawing.sheet import HEIGHTS

    for drawn in toleranced:
        space = document_of(drawn).modelspace()
        assert {round(text.dxf.height, 3) for text in space.query("TEXT")} <= set(HEIGHTS)
        texts = boxes(space)
        shared = [
            (a, b)
            for number, (one, a) in enumerate(texts)
            for other, b in texts[:number]
            if one.intersection(other).area > 0.02 * min(one.area, other.area)
        ]
        assert shared == []


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="needs pdftotext")
@pytest.mark.parametrize("language", ["en", pytest.param("zh", marks=pytest.mark.long)])
def test_the_text_of_a_page_is_found_by_a_search(toleranced, tmp_path, language):
    """Words with ligatures, Greek letters, limits that stand upright, and Chinese ones: oblique ones it takes apart."""
    from cadgen.output.drawing.sheet_files import NoFontError, SheetDocument

    page = tmp_path / "page.pdf"
    try:
        page.write_bytes(SheetDocument(toleranced[1], language).page())
    except NoFontError:
        pytest.skip("this system has no font with Chinese letters")
    found = subprocess.run(["pdftotext", str(page), "-"], capture_output=True, text=True, check=True).stdout
    words = {
        "en": ["flanks of the groove", "At the arrow of 0°", "θ", "22.8 +0.1/0", "0.04"],
        "zh": ["单位名称", "22.8 +0.1/0", "ISO 2768-mK"],
    }[language]
    assert [word for word in words if word not in found] == []


def test_two_dimensions_of_a_sheet_have_two_names():
    one = LinearDimension(name="width", start=(0.0, 0.0), end=(5.0, 0.0), at=(0.0, 1.0))
    views = tuple(View(place=(0.0, 0.0), curves=(), dimensions=(one,)) for _ in range(2))
    assert sheet(views[:1]).dimensions == {"width": 5.0}
    with pytest.raises(ValueError, match="two dimensions of a sheet are named width"):
        sheet(views)


def test_angles_and_radii_are_read_from_their_points(tmp_path):
    """At 2:1: an angle from its three points, which the scale leaves alone, and a radius from its centre to its arc."""
    import ezdxf

    from cadgen.output.drawing.sheet import AngularDimension, RadiusDimension
    from cadgen.output.drawing.sheet_files import SheetDocument

    turned = AngularDimension(name="turn", centre=(3.0, 1.0), start=20.0, end=155.5, radius=12.0)
    bowed = RadiusDimension(name="bow", centre=(3.0, 1.0), radius=12.5, angle=70.0)
    whole = replace(sheet((View(place=(90.0, 90.0), curves=(), dimensions=(turned, bowed)),)), scale=2.0)
    (tmp_path / "sheet.dxf").write_bytes(SheetDocument(whole).dxf())
    assert read_dimensions(tmp_path / "sheet.dxf") == pytest.approx({"turn": 135.5, "bow": 12.5})
    angle, radius = ezdxf.readfile(tmp_path / "sheet.dxf").modelspace().query("DIMENSION")
    one, other = (np.subtract(angle.dxf.get(end), angle.dxf.defpoint4)[:2] for end in ("defpoint2", "defpoint3"))
    along = np.cos(np.radians(135.5)) * np.linalg.norm(one) * np.linalg.norm(other)
    assert one @ other == pytest.approx(along)
    assert angle.dxf.text == "135.5°"
    assert np.hypot(*np.subtract(radius.dxf.defpoint4, radius.dxf.defpoint)[:2]) == pytest.approx(2 * 12.5)
    assert (np.array(radius.dxf.defpoint)[:2], radius.dxf.text) == (pytest.approx([96.0, 92.0]), "R12.5")


def corners_of_edges(space) -> list[tuple[float, float, bool]]:
    """Corner of each sign of an edge, and whether a circle about it says all around: an upright, then a level line."""
    rings = [ring.dxf.center.vec2 for ring in space.query("CIRCLE")]
    found = []
    for line in space.query("LWPOLYLINE"):
        points = [*line.vertices()]
        if len(points) == 3 and not line.closed:
            (x, y), (a, b), (c, d) = points
            if abs(x - a) < 1e-9 and abs(b - d) < 1e-9 and 3.0 < y - b < 3.5 and c - a > 5.0:
                found.append((a, b, any(ring.distance((a, b)) < 1e-9 for ring in rings)))
    return found


def test_the_state_of_edges_is_a_sign_with_its_size(tmp_path):
    """ISO 13715: an outer and an inner edge in the title block, and both edges of an outline on a leader."""
    import ezdxf

    from cadgen.output.drawing.sheet import EdgeState
    from cadgen.output.drawing.sheet_files import SheetDocument

    edges = EdgeState(count=2, size=0.02, tip=(10.0, 0.0), bend=(15.0, 5.0))
    (tmp_path / "sheet.dxf").write_bytes(
        SheetDocument(sheet((View(place=(50.0, 90.0), curves=(), symbols=(edges,)),))).dxf()
    )
    space = ezdxf.readfile(tmp_path / "sheet.dxf").modelspace()
    texts = [(text.dxf.text, *text.dxf.insert.vec2) for text in space.query("TEXT")]
    said = {
        (next(text for text, a, b in texts if 0 < a - x < 2 and 0 < b - y < 1), around)
        for x, y, around in corners_of_edges(space)
    }
    assert said == {("-0.3", False), ("+0.3", False), ("-0.02", True)}
    assert [text for text, a, b in texts if a < 65.0 and abs(b - 95.6) < 0.2] == ["2 ×"]


@pytest.mark.parametrize(
    ("source", "name"),
    [("my_car.toml", "my_car.toml"), ("my car.toml", "'my car.toml'"), ("roller.toml", "roller"), ("", "my_title")],
)
def test_a_sheet_names_the_design_as_a_command_takes_it(source, name):
    """By its file: `cadgen check my_car` of a file my_car.toml is refused."""
    assert _as_given(Origin("my_title", source, (), "0" * 64)) == name


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", pytest.param("zh", marks=pytest.mark.long)])
def test_the_verdict_on_a_cam_stands_over_its_title(design, tmp_path, monkeypatch, language):
    """In a short line: the check that fails, or where the reservations are; nothing on a cam that is ready."""
    from cadgen import messages
    from cadgen.check import Bound, Check, CheckCode
    from cadgen.verdict import PartVerdict, Reservation

    walls = [Check(CheckCode.THINNEST_WALL, name, 1.0, "mm", 2.0, Bound.MIN) for name in ("thinnest wall", "lost lift")]
    doubt = Reservation("friction", "friction is not stated", "state it")
    said = {
        "en": (
            "NOT READY: thinnest wall",
            "NOT READY: thinnest wall and 1 more",
            "ready with reservations, see cadgen ",
        ),
        "zh": ("未就绪：最薄壁厚", "未就绪：最薄壁厚，另有 1 项", "就绪，有保留意见，见 cadgen "),
    }[language]
    before = messages.language()
    messages.choose(language)
    try:
        for verdict, line in (
            (PartVerdict(tuple(walls[:1])), said[0]),
            (PartVerdict(tuple(walls)), said[1]),
            (PartVerdict((), (doubt,)), said[2] + "check carbon_free_car"),
            (PartVerdict(()), None),
        ):
            made = design.cam("actual")
            monkeypatch.setitem(made.computed.__dict__, "verdict", verdict)
            drawn = document_of(sheet_of(made.computed, Folder.at(tmp_path)), language)
            lines = {text.dxf.text: text for text in drawn.modelspace().query("TEXT")}
            assert line is None or line in lines
            assert sum(
                text[:9] in ("NOT READY", "ready wit") or text[:2] in ("未就", "就绪") for text in lines
            ) == bool(line)
            if line:
                at = lines[line].dxf.insert
                (frame,) = [
                    line
                    for line in drawn.modelspace().query("LWPOLYLINE")
                    if len(line) == 3 and not line.closed and line.dxf.layer == "FRAME"
                ]
                left, up = min(point[0] for point in frame), max(point[1] for point in frame)
                assert left < at.x
                assert up < at.y < up + 7.0
    finally:
        messages.choose(before)


@pytest.mark.slow
def test_a_cam_by_its_motion_says_follower_and_cam_angle(tmp_path):
    """Kind, radius, offset, base circle, and where cam angle 0 lies."""
    from tests.cam.test_roller import TEXT

    made = Design.from_toml(TEXT).cam()
    sheet = sheet_of(made.computed, Folder.at(tmp_path))
    said = " ".join(sheet.notes)
    assert "Follower: roller, radius 9 mm, offset 8 mm." in said
    assert "Base circle" not in said
    assert "At the arrow of 0° stands the roller at cam angle 0." in said


@pytest.mark.parametrize("angle", range(-180, 181, 15))
@pytest.mark.parametrize("beside", [0.0, 22.0])
def test_arrows_of_a_dimension_point_from_its_middle_to_its_ends(angle, beside):
    """A block of an arrow points along +X at its place; of oblique ones both pointed inwards, with the lines inside."""
    way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    across = np.array([-way[1], way[0]])
    one = LinearDimension(
        name="oblique",
        start=(0.0, 0.0),
        end=tuple((30.0 * way + 2.0 * across).tolist()),
        at=tuple((5.0 * across).tolist()),
        angle=float(angle),
        beside=beside,
    )
    view = View(place=(100.0, 100.0), curves=(), dimensions=(one,))
    (drawn,) = document_of(sheet((view,))).modelspace().query("DIMENSION")
    arrows = [entity for entity in drawn.virtual_entities() if entity.dxftype() == "INSERT"]
    places = np.array([arrow.dxf.insert.vec2 for arrow in arrows]) - 100.0
    assert sorted((places @ way).tolist()) == pytest.approx([0.0, 30.0], abs=1e-9)
    assert places @ across == pytest.approx([5.0, 5.0], abs=1e-9)
    for arrow, away in zip(arrows, places - places.mean(axis=0), strict=True):
        turned = np.radians(arrow.dxf.rotation)
        assert np.array([np.cos(turned), np.sin(turned)]) @ away == pytest.approx(15.0, abs=1e-9)


# ISO 286-2, tables 6 (H), 10 (JS) and 12 (P) of holes, 8 (g) and 9 (h) of shafts, um.
@pytest.mark.parametrize(
    ("named", "size", "said"),
    [
        ("H7", 8.0, " H7 (+0.015/0)"),
        ("h6", 8.0, " h6 (0/-0.009)"),
        ("g6", 8.0, " g6 (-0.005/-0.014)"),
        ("JS9", 3.0, " JS9 (±0.0125)"),
        ("h9", 3.0, " h9 (0/-0.025)"),
        ("P9", 3.0, " P9 (-0.006/-0.031)"),
        ("P9", 6.0, " P9 (-0.012/-0.042)"),
        ("F8", 20.0, " F8 (+0.053/+0.02)"),
        ("", 20.0, ""),
    ],
)
def test_a_fit_is_said_by_its_limit_deviations(named, size, said):
    assert limited(size, named) == said


def test_a_keyway_may_be_deeper_by_what_its_standard_allows():
    """DIN 6885-1 and GB/T 1095: +0.1 for keys of 2 x 2 to 6 x 6, +0.2 for 8 x 7 to 32 x 18, +0.3 from 36 x 20 on."""
    assert [deeper(width) for width in (2.0, 6.0, 8.0, 32.0, 36.0, 100.0)] == [0.1, 0.1, 0.2, 0.2, 0.3, 0.3]
    assert limits(0.0, 0.1) == "+0.1/0"
    assert limits(-0.1, 0.2) == "+0.2/-0.1"


@pytest.mark.long
@pytest.mark.slow
def test_what_holds_a_wheel_on_its_shaft_is_on_its_sheet(design, tmp_path):
    """Width of the keyway with its class and its limits, depth with its limits, bore with its fit; thread; material."""
    import ezdxf

    keyed = {"joint": "keyed", "joint_fit": "JS9/h9", "bore_fit": "H7/h6"}
    changes = {f"{place}.{key}": value for place in ("blank", "train.output") for key, value in keyed.items()}
    changes |= {
        "blank.hub": {
            "diameter_mm": 24.0,
            "length_mm": 10.0,
            "set_screw": {"hole_diameter_mm": 2.5, "height_mm": 4.5, "thread": "M3"},
        },
        "train.material": "POM",
        "train.drive.material": "brass",
        "train.drive.hub.set_screw_thread": "M3 x 0.5",
        "train.plate": {"material": "plywood 5 mm", "hole_fit": "H8/h7"},
    }
    told = design.with_(changes)
    written = draw(tmp_path, cam=told.cam("actual"), train=told.gears())
    assert written.entry["not_stated"] == {
        "material": "blank.material",
        "surface finish": "drawing.finish",
        "fit of the bore, drive": "train.drive.bore_fit",
        "fit of the bore, intermediate": "train.intermediate.bore_fit",
    }

    def said(stem):
        space = ezdxf.readfile(tmp_path / f"{stem}_drawing.dxf").modelspace()
        notes = " ".join(text.dxf.text.strip() for text in space.query("TEXT"))
        return notes, {entity.dxf.text for entity in space.query("DIMENSION")}

    for stem in ("carbon_free_car_actual", "carbon_free_car_as-given_4_wheel"):
        notes, dimensions = said(stem)
        assert {"%%c8 H7", "<> JS9", "<> +0.1/0"} <= dimensions
        assert "%%c8 H7 +0.015/0 3 JS9 ±0.0125" in notes
        assert "not stated" not in notes.replace("finish not stated", "").replace("material not stated", "")
    assert "M<>" in said("carbon_free_car_actual")[1]
    notes, dimensions = said("carbon_free_car_as-given_1_pinion")
    assert "tapped" not in notes
    assert "M<> x 0.5" in dimensions
    assert "brass" in notes
    assert "POM" in said("carbon_free_car_as-given_2_cluster")[0]
    notes, _ = said("carbon_free_car_as-given_plate")
    assert "plywood 5 mm" in notes
    assert "8 H8" in notes
    assert "8 H8 (+0.022/0)" in notes


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"train.output.bore_fit": "H7"}, r'train\.output\.bore_fit: the fit "H7" is not in the table'),
        ({"train.plate.hole_fit": "H7"}, r'train\.plate\.hole_fit: the fit "H7" is not in the table'),
        (
            {"train.output.bore_diameter_mm": 60.0, "train.plate.hole_fit": "H7/h6"},
            r"train\.plate\.hole_fit: the fit .* is for a size of 60 mm, and the table ends at 50 mm",
        ),
        (
            {"train.intermediate.bore_diameter_mm": 0.0, "train.intermediate.bore_fit": "H7/h6"},
            r"train\.intermediate\.bore_fit needs the bore",
        ),
        ({"train.drive.hub": {"diameter_mm": 10.0, "set_screw_thread": "M3"}}, r"set_screw_thread needs the hole"),
        ({"train.material": "x" * 37}, r"train\.material must be one line of 1 to 36 letters"),
        ({"train.plate.material": "🚗"}, r"train\.plate\.material has 🚗, which the fonts of drawings lack"),
    ],
)
def test_a_fit_or_thread_that_is_of_nothing_is_refused(design, change, message):
    with pytest.raises(DesignError, match=message):
        design.with_(change)


# The sheets of a train take some ten seconds to draw: they are among the long tests, a cam's are always judged.
SHEETS = pytest.mark.parametrize("sheets", ["folder", pytest.param("trains_folder", marks=pytest.mark.long)])


@pytest.mark.slow
@SHEETS
def test_a_dxf_has_no_letter_that_readers_lose(sheets, request):
    """LibreCAD's own font has neither theta nor the dash, and of a text it takes %%c for the sign of a diameter."""
    import ezdxf

    for file in request.getfixturevalue(sheets).glob("*_drawing.dxf"):
        space = ezdxf.readfile(file).modelspace()
        texts = [entity.dxf.text for entity in space.query("TEXT")]
        texts += [entity.dxf.text for entity in space.query("DIMENSION")]
        assert len(texts) > 20
        assert set("".join(texts)) <= {*map(chr, range(32, 127)), *"×°±µ²"}, file.name
        diameters = [entity for entity in space.query("DIMENSION") if entity.dimtype == 3]
        assert diameters or "plate" in file.name
        for entity in diameters:  # the number is written, for some readers make no sign of "<>"
            length = read_dimensions(file)[entity.get_xdata("CADGEN")[-1].value]
            assert float(re.search(r"%%c([\d.]+)", entity.dxf.text)[1]) == pytest.approx(length, abs=5e-4)


@pytest.mark.parametrize(("turn", "lines"), [(0.0, {"VISIBLE"}), (90.0, {"PHANTOM"}), (-60.0, {"VISIBLE"})])
def test_the_hole_of_a_set_screw_is_in_both_views(turn, lines):
    """In the section: cut, before the plane as a phantom, or seen in the bore, on the cylinder that it opens into."""
    from cadgen.output.drawing.section import ScrewHole
    from cadgen.parts.body import RadialHole

    angle = 0.7
    screw = ScrewHole(RadialHole(4.0, 5.0, 13.0, angle + np.radians(turn)), 4.0, 12.0)
    edges = [stroke for stroke in screw.section(angle) if stroke.line != "CENTRE"]
    assert {edge.line for edge in edges} == lines
    for edge, radius in zip(edges, [4.0, 12.0] if turn == 0 else [4.0 if turn < 0 else 12.0], strict=True):
        # A point of the edge: z and r as seen, and the depth that makes it lie on the hole's cylinder.
        z, r = edge.points.T
        depth = np.sqrt(radius**2 - r**2)
        aside = [abs(-np.sin(np.radians(turn)) * r + side * np.cos(np.radians(turn)) * depth) for side in (-1, 1)]
        off = np.min([np.abs(np.hypot(away, z - 5.0) - 2.0) for away in aside], axis=0)
        assert off.max() < 1e-9
    hidden = [stroke for stroke in screw.face() if stroke.line == "HIDDEN"]
    assert len(hidden) == 2
    assert np.linalg.norm(hidden[0].points, axis=1) == pytest.approx([4.0, 12.0])


@pytest.mark.parametrize(("name", "size", "pitch"), [("M3", 3.0, ""), ("M4x0.5", 4.0, "x0.5"), ("1/4-20 UNC", 0.0, "")])
def test_the_thread_in_a_hub_has_thin_lines_and_its_name(name, size, pitch):
    """ISO 6410-1: a thin line at the major diameter on either side of the core, and the name as a dimension."""
    from cadgen.output.drawing.section import ScrewHole
    from cadgen.parts.blank import Blank
    from cadgen.parts.body import RadialHole
    from cadgen.parts.features import Hub

    blank = Blank(bore_diameter=8.0, hub=Hub(diameter=24.0, length=10.0))
    screw = ScrewHole.of(blank, RadialHole(2.5, 5.0, 13.0, 0.7), name)
    thin = [stroke.points[0, 0] for stroke in screw.section(0.7) if stroke.line == "THIN"]
    assert thin == ([5.0 - size / 2, 5.0 + size / 2] if size else [])
    on_section, on_face = screw.size_in_section(0.7, 20.0, 1.0), screw.size_on_face(3.0, 1.0)
    assert screw.size_in_section(2.0, 20.0, 1.0) is None  # out of the plane: on the face
    for made in (on_section, on_face):
        assert (made.prefix, made.suffix) == ("M" if size else "Ø", pitch)
        assert np.hypot(*np.subtract(made.end, made.start)) == pytest.approx(size or 2.5)
    assert len([stroke for stroke in screw.face() if stroke.line == "HIDDEN"]) == (4 if size else 2)


@pytest.mark.slow
def test_equal_designs_give_equal_bytes(folder, cam, tmp_path, monkeypatch):
    """But for the day: that of the first folder's manifest, here stated."""
    parts = json.loads((folder / "manifest.json").read_text())["parts"]
    date = parts["carbon_free_car_cam_drawings"]["date"]
    monkeypatch.setenv("SOURCE_DATE_EPOCH", str(int(np.datetime64(date, "s").astype(int))))
    cam.write(tmp_path, ["dxf"])
    written = draw(tmp_path, cam=cam)
    assert len(written) == 3
    for file in written:
        assert file.path.read_bytes() == (folder / file.name).read_bytes(), file.name


@pytest.mark.slow
@pytest.mark.long
def test_a_filled_form_is_read_by_calibrate_and_an_empty_one_is_refused(folder, cam, design, tmp_path):
    form = folder / "carbon_free_car_actual_inspection.csv"
    lines = form.read_text().splitlines()
    remarks = [line for line in lines if line.startswith("#")]
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    noise = np.random.default_rng(5).normal(0.0, 0.004, len(rows))
    for row, off in zip(rows, noise, strict=True):
        row["lift_mm"] = f"{float(cam.lift(np.radians(float(row['cam_angle_deg'])))) + off:.4f}"
    filled = tmp_path / "filled.csv"
    filled.write_text("\n".join([*remarks, ",".join(rows[0]), *(",".join(row.values()) for row in rows)]) + "\n")
    result = design.calibrate([filled], profile="actual")
    assert not result.effects
    with pytest.raises(FileError, match="lift_mm"):
        design.calibrate([form], profile="actual")


@pytest.mark.slow
def test_what_cannot_be_drawn_is_said(design, cam, train, tmp_path):
    with pytest.raises(DesignError, match="nothing to draw"):
        draw(tmp_path)
    with pytest.raises(DesignError, match="two designs"):
        draw(tmp_path, cam=cam, train=design.with_({"train.width_mm": 6.0}).gears())
    bad = design.with_({"checks.min_wall_mm": 50.0}).cam("actual")
    with pytest.raises(CheckError, match="thinnest wall"):
        draw(tmp_path, cam=bad)
    assert not list(tmp_path.iterdir())
    assert draw(tmp_path, cam=bad, force=True)


def texts_of(sheet):
    """Box and text of every text of a sheet, measured by ezdxf with the letters of the page; labels and dimensions."""
    import ezdxf
    import shapely
    from ezdxf.tools.text_size import mtext_size, text_size
    from shapely.affinity import rotate, translate

    from cadgen.output.drawing.sheet_files import know_font

    know_font()
    document = ezdxf.readfile(sheet)
    for entity in document.modelspace().query("DIMENSION TEXT"):
        drawn = list(entity.virtual_entities()) if entity.dxftype() == "DIMENSION" else [entity]
        for text in drawn:
            if text.dxftype() == "MTEXT":
                size = mtext_size(text)
                box = shapely.box(
                    -size.total_width / 2, -size.total_height / 2, size.total_width / 2, size.total_height / 2
                )
                yield (
                    text.plain_text(),
                    translate(rotate(box, text.get_rotation(), origin=(0, 0)), *text.dxf.insert.vec2),
                )
            elif text.dxftype() == "TEXT":
                size, (_, place, _) = text_size(text), text.get_placement()
                middle = text.get_align_enum().name == "MIDDLE_CENTER"
                left, low = (place.x - size.width / 2, place.y - size.cap_height / 2) if middle else (place.x, place.y)
                yield text.dxf.text, shapely.box(left, low, left + size.width, low + size.cap_height)


@pytest.mark.slow
@SHEETS
def test_no_text_stands_in_another_or_on_an_edge_of_the_part(sheets, request):
    """The pinion's Ø5 stood in its teeth, 3 in 11 under its section, and the plate's 1 and 40 in circles."""
    import ezdxf
    import shapely
    from ezdxf.path import make_path

    for sheet in request.getfixturevalue(sheets).glob("*_drawing.dxf"):
        texts = [(text, box.buffer(-0.1)) for text, box in texts_of(sheet)]
        assert len(texts) > 20
        for number, (text, box) in enumerate(texts):
            for other, beside in texts[number + 1 :]:
                assert not box.intersects(beside), (sheet.name, text, other)
        edges = [
            shapely.LineString([point.vec2 for point in make_path(curve).flattening(0.05)])
            for curve in ezdxf.readfile(sheet).modelspace().query('LWPOLYLINE CIRCLE[layer=="VISIBLE"]')
        ]
        for text, box in texts:
            assert not any(edge.intersects(box) for edge in edges), (sheet.name, text)


def ink(page, folder):
    """Dark pixels of a page of PDF, 3 a mm, by poppler."""
    subprocess.run(["pdftoppm", "-r", "76.2", "-gray", "-singlefile", page, folder / "page"], check=True)
    head, size, _, data = (folder / "page.pgm").read_bytes().split(b"\n", 3)
    assert head == b"P5"
    width, height = map(int, size.split())
    return np.frombuffer(data, np.uint8, width * height).reshape(height, width) < 160


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.skipif(
    not (shutil.which("librecad") and shutil.which("pdftoppm")), reason="LibreCAD or poppler is not installed"
)
def test_librecad_draws_the_sheets_as_the_pages_have_them(folder, trains_folder, tmp_path):
    """Its page from the DXF, at full size, has lines where the page has them; moved by 1.7 mm it has not."""
    from scipy.ndimage import binary_dilation

    for file in (*folder.glob("*_drawing.dxf"), *trains_folder.glob("*_drawing.dxf")):
        copy = tmp_path / file.name
        shutil.copy(file, copy)
        own = ink(file.with_suffix(".pdf"), tmp_path)
        run = ["librecad", "dxf2pdf", "-s", "1", "-p", "420x297", copy.name]  # of an A4 sheet its lower left
        quiet = {"QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(tmp_path)}
        subprocess.run(run, cwd=tmp_path, env=os.environ | quiet, capture_output=True, check=True, timeout=120)
        other = ink(copy.with_suffix(".pdf"), tmp_path)
        rows, columns = np.minimum(own.shape, other.shape)
        own, other = own[-rows:, :columns], other[-rows:, :columns]
        near = binary_dilation(other, iterations=2)
        found, moved = near[own].mean(), np.roll(near, (5, 5), (0, 1))[own].mean()
        print(f"{file.name}: {found:.1%} of the lines are there, {moved:.1%} if moved")
        assert found > 0.85
        assert moved < 0.6


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.skipif(not LIBRECAD_FONT.is_file(), reason="LibreCAD is not installed")
def test_librecad_has_every_letter_of_the_sheets(folder, trains_folder):
    """Its own fonts lack theta and the dash: what they lack it leaves out without a word."""
    import ezdxf

    known = {chr(int(code, 16)) for code in re.findall(r"^\[([0-9a-f]+)\]", LIBRECAD_FONT.read_text("utf-8"), re.M)}
    assert not {"θ", "–"} & known
    for file in (*folder.glob("*_drawing.dxf"), *trains_folder.glob("*_drawing.dxf")):
        space = ezdxf.readfile(file).modelspace()
        letters = set("".join(entity.dxf.text for entity in space.query("TEXT DIMENSION")))
        assert letters <= known | {" "}, file.name
