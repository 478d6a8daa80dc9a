"""Facts that sheets and mounting plan must state: the list of docs/reference/sheets.md, part by part of a car."""

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
import shapely

from cadgen.car.assembly.car_parts import CarPart, Supply
from cadgen.car.assembly.fork_sizes import JOURNAL
from cadgen.car.assembly.panels import Panel
from cadgen.car.assembly.standard_parts import key_length, key_size
from cadgen.design import gear_model
from cadgen.design.blank import TIGHT
from cadgen.design.load import complete_of, load_design, packaged_designs, read_design
from cadgen.design.machining import Machining
from cadgen.design.schema import Design
from cadgen.jobs import frame_writer
from cadgen.jobs.assembly_checks import assembly_verdict
from cadgen.jobs.assembly_files import listed, loose_parts, mounting_notes, mountings, sheet_notes, views_of
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_assembly import CarAssembly, put_together
from cadgen.jobs.car_frame import frame_in
from cadgen.jobs.car_layout import layout_of, train_in_car
from cadgen.jobs.drawings import Folder, sheet_of, sheets_of, title_of
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.jobs.gears.train_making import TrainMaking
from cadgen.jobs.mounting_parts import spring_sizes
from cadgen.jobs.part_drawings import part_sheets
from cadgen.output.drawing import assembly_sheet
from cadgen.output.drawing.assembly_sheet import assembly_drawing, mounting_sheet
from cadgen.output.drawing.part_sheets import KeySeat, PartTexts, TurnedStep, turned_drawing
from cadgen.output.drawing.shaft_fit import fillet, longer
from cadgen.output.drawing.sheet import (
    EDGE,
    FRAME_HEIGHT,
    HEIGHTS,
    LEVEL,
    AngularDimension,
    Characteristic,
    Closed,
    DatumFeature,
    DrawingSheet,
    LinearDimension,
    SurfaceTexture,
    Title,
    ToleranceFrame,
    placed_notes,
)
from cadgen.output.drawing.sheet_files import document_of
from cadgen.output.files.dxf import write_dxf
from cadgen.output.files.sheet_nc import sheet_program
from tests.jobs.test_gear_sheets import apart, frame_boxes
from tests.output.drawing.table_cells import leaving
from tests.output.drawing.test_drawings import boxes

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "sheets.md"
# Sheets say in one of these ways what they count from: axis and face, a hole or edges, angle 0.
DATUMS = ("Datum", "places from 0", "0°")
# Words of the mounting page, the assembly's sheet and the checks that are features of a part, or need one to be done:
# the beginning of its code. A word that is neither here nor below nor in a title of the list is a part that is missing.
NEEDS = {
    "brake": "brake-felt", "cam": "cam-disc", "fork": "fork-", "teeth": "gear-", "hub": "drive-wheel",
    "joint": "adhesive",
    "bond": "adhesive", "bonded": "adhesive", "glue": "adhesive", "glued": "adhesive", "clamped": "collar-disc",
    "tapped": "set-screws", "tighten": "screw-", "tightened": "collar-", "knot": "string", "knotted": "string",
    "wind": "string", "winding": "string", "wound": "string", "hang": "drop-weight", "flange": "drum",
    "journal": "fork-spindle", "pin": "front-pin", "ring": "bearing-", "rim": "cam-disc", "seat": "bearing-",
    "tab": "plate-near", "slot": "base", "feet": "plate-near",
}  # fmt: skip
NO_PARTS = frozenset(
    """
    above acros adjust after again against ahead all along and angle apart are average axi back backward balloon base
    bed before behind belong below beside between beyond both but cadgen cannot car centre clear come counted cut design
    doe down drawn each edge either ended energy face fall find fit first floor flush for forward frame free from gap
    give goe gravity ha hand height hold hole inner into it itself last lead least leave left length lie line little
    longest look lower lowest mas material measure more mounting move must nearest never not nowhere off one open
    opening order other outer outside outward over overhang parallel part path piece place play point pres presse
    pressed printer pull push pushed pushing put ray right rolling room round run say sheet short shown side slack
    speed stand start state step suit table take than that the their them then there these they those through tip
    together too touche toward train trial trim turn turning two under until used usual wall way waypoint what where
    which while with within without wrong
    """.split()  # noqa: SIM905
)
WITHOUT_FITS = ("base", "platform")  # whose holes are for screws, and whose slots for tabs
NOWHERE = Folder({}, "2026-01-01")


def facts_of_the_page() -> dict[str, set[str]]:
    """Facts of each section of the page."""
    sections = re.split(r"^## ", PAGE.read_text("utf-8"), flags=re.MULTILINE)[1:]
    return {text.partition("\n")[0]: set(re.findall(r"^\| `([\w-]+)` \|", text, re.MULTILINE)) for text in sections}


@pytest.fixture(scope="module")
def car() -> CarAssembly:
    design = load_design("workshop_car")
    return put_together(plan_cam(design, "actual"), plan_gears(design))


@pytest.fixture(scope="module")
def sheets(car: CarAssembly) -> dict[str, DrawingSheet]:
    return {
        car.cam.stem: sheet_of(car.cam, NOWHERE),
        **dict(sheets_of(car.train, NOWHERE)),
        **dict(part_sheets(car, NOWHERE)),
        **of_frame(car),
    }


def of_frame(car: CarAssembly, panels: dict[str, Panel] | None = None) -> dict[str, DrawingSheet]:
    """Sheets of the frame, whose files are not written here; its sheet parts, as the files have them, are kept."""
    found: dict[str, DrawingSheet] = {}

    def collect(_staging: Path, stem: str, sheet: DrawingSheet, _omitted: dict[str, str]) -> tuple[()]:
        found[stem] = sheet
        return ()

    def keep(panel: Panel, _folder: Path, stem: str, *_: object) -> tuple[()]:
        if panels is not None:
            panels[stem] = panel
        return ()

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(frame_writer, "write_sheet", collect)
        patch.setattr(frame_writer, "panel_files", keep)
        patch.setattr(frame_writer, "block_files", lambda *_, **__: ())
        patch.setattr(frame_writer, "text_file", lambda *_: None)
        patch.setattr(frame_writer, "publish", lambda _stem, out, files, *_, **__: list(files(out)))
        frame_writer.write_frame(frame_in(car.layout), Path("nowhere"))
    return found


def texts(sheet: DrawingSheet) -> Iterator[str]:
    yield from sheet.notes
    for table in sheet.tables:
        yield table.title
        yield from (cell for row in table.rows for cell in row)
    for view in sheet.views:
        yield from (label.text for label in view.labels)
        yield from (f"{dimension.prefix}{dimension.suffix}" for dimension in view.dimensions)


def of_part(part: CarPart, sheet: DrawingSheet) -> dict[str, bool]:
    """Facts that the part has, and whether its sheet states each."""
    said, title, sizes = list(texts(sheet)), sheet.title, sheet.dimensions
    whole = " | ".join(said)
    gear, disc = part.code.startswith("gear"), part.code == "cam-disc"
    facts = {
        "material": bool(title.material),
        "finish": bool(title.finish),
        "tolerance": "H7" in whole or "h6" in whole or "F8" in whole,  # ISO 2768-mK is printed in every title block
        "quantity": title.quantity == part.quantity,
        "number": bool(title.number),
        "sizes": len(sizes) >= 2 or gear,
        "datum": gear
        or any(words in whole for words in DATUMS)
        or any(isinstance(symbol, DatumFeature) for view in sheet.views for symbol in view.symbols)
        or from_one_end(sheet),
        "fit": bool(re.search(r"[HhF]\d", whole)),
    }
    if part.code in WITHOUT_FITS:
        facts["tolerance"] = True  # ISO 2768-mK
        del facts["fit"]
    if gear:
        facts["teeth"] = any("span" in text.lower() or "W" in text for text in said)
    if part.code in ("drive-wheel", "fork-bridge") or (gear and "1-pinion" in part.code):
        facts["thread"] = "tapped" in whole or any(
            "M" in (getattr(each, "sign", ""), each.prefix) for view in sheet.views for each in view.dimensions
        )
    if disc:
        facts["tolerance"] = bool(re.search(r"±|tolerance", whole, re.IGNORECASE))
    return facts


def from_one_end(sheet: DrawingSheet) -> bool:
    """Whether the lengths of a turned part count from its left end."""
    lengths = [
        each.start[0]
        for each in sheet.views[0].dimensions
        if isinstance(each, LinearDimension) and (each.name == "length" or each.name.endswith("from the left end"))
    ]
    return len(lengths) > 0 and np.ptp(lengths) == 0


def test_a_frame_refers_to_every_datum_and_leaning_sides_have_their_ends(sheets: dict[str, DrawingSheet]) -> None:
    for stem, sheet in sheets.items():
        symbols = [symbol for view in sheet.views for symbol in view.symbols]
        drawn = {each.letter for each in symbols if isinstance(each, DatumFeature)}
        assert drawn == {each for frame in symbols if isinstance(frame, ToleranceFrame) for each in frame.datums}, stem
        if "_frame_" not in stem or not sheet.tables:
            continue
        told = {(row[1], row[2]) for row in sheet.tables[0].rows if row[4] == "corner of the outline"}
        outline = next(curve.contour for curve in sheet.views[0].curves if isinstance(curve, Closed))
        for (x, y), (u, v), bulge in zip(
            outline.vertices, np.roll(outline.vertices, -1, axis=0), outline.bulges, strict=True
        ):
            if not bulge and min(abs(u - x), abs(v - y)) > 0.5:
                assert {(f"{x:.3f}", f"{y:.3f}"), (f"{u:.3f}", f"{v:.3f}")} <= told, stem
    assert (
        len([row for row in sheets["workshop_car_frame_plate_near"].tables[0].rows if row[4].startswith("corner")]) > 3
    )


@pytest.mark.slow
def test_sheet_outline_and_program_of_a_frame_have_one_zero_on_the_part(car: CarAssembly, tmp_path: Path) -> None:
    panels: dict[str, Panel] = {}
    sheets, design = of_frame(car, panels), frame_in(car.layout).frame
    assert len(panels) == 6
    for stem, panel in panels.items():
        write_dxf(tmp_path / "outline.dxf", panel.outline, None, panel.openings)
        space = ezdxf.readfile(tmp_path / "outline.dxf").modelspace()
        circles = [(*each.dxf.center.vec2, 2 * each.dxf.radius) for each in space.query("CIRCLE")]
        rows = [row for row in sheets[stem].tables[0].rows if row[3].startswith("Ø")]
        told = [(float(row[1]), float(row[2]), float(row[3].split()[0][1:])) for row in rows]
        assert sorted(circles) == pytest.approx(np.array(sorted(told)), abs=6e-4), stem
        sheet_program(panel, tmp_path, "part", Machining(cutter_diameter_mm=2.0), "car", "")
        program = (tmp_path / "part.nc").read_text()
        turns = re.findall(r"\(hole \S+ mm\)\n.*?G3 X(\S+) Y(\S+) Z\S+ I(\S+) J(\S+)", program, re.DOTALL)
        milled = [(float(x) + float(i), float(y) + float(j)) for x, y, i, j in turns]
        assert sorted(milled) == pytest.approx(np.array(sorted(told))[:, :2], abs=6e-4), stem
        if stem.endswith("_base"):  # two edges
            assert panel.outline.vertices.min(axis=0).tolist() == [0.0, 0.0]
        else:
            assert (0.0, 0.0) in milled, stem
        opened = any(note.startswith("Inner corners") for note in sheets[stem].notes)
        assert opened != stem.endswith("_platform"), stem  # a rectangle has none
        (whole,) = (each for each in design.sheets if stem.endswith(f"_{each.code}"))
        for one, other in zip(panel.holes, whole.holes, strict=True):  # where it was in the car
            at = [each.place.out(np.array([[hole.u, hole.v, 0.0]])) for each, hole in ((panel, one), (whole, other))]
            assert at[0] == pytest.approx(at[1], abs=1e-9)


def test_every_part_that_is_made_has_a_sheet_that_says_all_of_it(
    car: CarAssembly, sheets: dict[str, DrawingSheet]
) -> None:
    known = facts_of_the_page()["On the sheet of every part that is made"]
    rows = {row.code: row for row in listed(car)}
    missing, counted = [], set()
    for part in car.parts:
        if part.supply == Supply.BOUGHT:
            continue
        facts = of_part(part, sheets[rows[part.code].source])
        counted |= facts.keys()
        missing += [f"{part.code}: {fact}" for fact, there in facts.items() if not there]
    assert not missing, "\n".join(missing)
    assert counted == known


def test_plain_parts_say_fits_threads_and_positions_by_symbols(sheets: dict[str, DrawingSheet]) -> None:
    """Limits by ISO 286: h6 and H7 up to 6 mm, P9 up to 3 mm; M3 in Ø3.2 leaves 0.1 mm to each of two parts."""
    drawn = {stem.removeprefix("workshop_car_"): sheet for stem, sheet in sheets.items()}
    said = {
        code: {each.name: each for view in sheet.views for each in view.dimensions} for code, sheet in drawn.items()
    }
    symbols = {code: [symbol for view in sheet.views for symbol in view.symbols] for code, sheet in drawn.items()}
    assert said["rod"]["diameter 5"].suffix == " h6 (0/-0.008)"
    assert said["fork-spindle"]["radial hole"].suffix == " H7 (+0.012/0) x 7"
    assert said["drive-wheel"]["radial hole"].prefix == "M"
    assert said["drive-wheel"]["bore 5"].suffix == " H7 (+0.012/0)"
    assert (said["fork-spindle"]["diameter 6"].prefix, said["front-wheel"]["diameter 10"].prefix) == ("2 × Ø", "2 × Ø")
    # Hub and rim are one part: two areas of the section, Ø39 x 4 and twice Ø10 x 4 less the bore of Ø4.
    areas = [shapely.Polygon(each.outside).area for each in drawn["front-wheel"].views[0].hatches]
    assert areas == pytest.approx([4 * (19.5 - 2) + 8 * (5 - 2)] * 2)
    wheel = said["drive-wheel"]
    assert [each.suffix for name, each in wheel.items() if name.startswith("diameter 131")] == [" ±0.04"]
    assert said["front-wheel"]["length"].suffix == " (-0.1/-0.2)"  # it turns between cheeks as far apart as it is long
    assert said["shaft-4"]["width of seats 1"].suffix == " P9 (-0.006/-0.031)"
    assert said["fork-cheek"]["height"].end[1] - said["fork-cheek"]["height"].start[1] == pytest.approx(38.5, abs=1e-4)
    assert [each.value for each in symbols["rod"] if isinstance(each, SurfaceTexture)] == ["Ra 0.4 ="]
    for code, exact in (("fork-cheek", 2), ("fork-bridge", 2)):
        (frame,) = (each for each in symbols[code] if isinstance(each, ToleranceFrame))
        assert (frame.characteristic, frame.zone_text, frame.datums) == (Characteristic.POSITION, "Ø0.1", ("A", "B"))
        assert sum(isinstance(each, LinearDimension) and each.exact for each in said[code].values()) == exact
        # Box of each exact dimension, frame, and the boxes of both datums.
        closed = [line for line in document_of(drawn[code]).modelspace().query("LWPOLYLINE") if line.closed]
        assert sum(line.dxf.layer == "DIMENSION" for line in closed) == exact + 1 + 2
    # The seats of the camshaft are alike: one section across the shaft, d - t1 = 8 - 1.8 of a key 3 x 3 (DIN 6885-1).
    depth = said["shaft-4"]["shaft less seat 1"]
    assert (depth.prefix, depth.suffix) == ("2 × ", " (0/-0.1)")
    assert drawn["shaft-4"].dimensions["shaft less seat 1"] == pytest.approx(6.2, abs=1e-9)
    # Keys of up to 28 mm have seats 0 to 0.2 mm longer; the chamfer of a key 3 x 3 clears a radius of 0.16 mm.
    assert [said["shaft-4"][f"length of seat {number}"].suffix for number in (1, 2)] == [" +0.2/0"] * 2
    # A gear of 11 mm takes a key of 10 with round ends. For 3 mm none is sold: the seat ends beyond the disc.
    assert drawn["shaft-4"].tables[0].rows[1:] == (("68.5", "A 3 x 3 x 10"), ("88.5", "B 3 x 3 x 3"))
    assert [drawn["shaft-4"].dimensions[f"length of seat {number}"] for number in (1, 2)] == pytest.approx([10.0, 6.0])
    (middle,) = (each for each in symbols["shaft-4"] if isinstance(each, ToleranceFrame))
    assert (middle.characteristic, middle.zone_text, middle.datums) == (Characteristic.SYMMETRY, "0.01", ("A",))
    outlines = [each.contour for each in drawn["shaft-4"].views[0].curves if isinstance(each, Closed)]
    areas = [each.area() for each in outlines if each.bulges.any()]
    assert areas == pytest.approx([3 * (length - 3) + np.pi * 1.5**2 for length in (10, 6)])
    assert (drawn["shaft-4"].title.edge, drawn["shaft-4"].title.inner) == (0.3, 0.16)
    for code in ("rod", "shaft-1", "shaft-4", "fork-cheek", "fork-bridge", "drive-wheel"):
        assert not drawn[code].notes


def test_steps_of_mounting_are_written_in_heights_of_the_series(car: CarAssembly) -> None:
    """ISO 3098: no letter is lower than 1.8 mm; what a cell lists beyond its width goes on in the next row, whole."""
    title = Title(part="", title="", material="", finish="", quantity=1, date="2026-01-01", design="", number="n")
    sheet = mounting_sheet(mountings(car), loose_parts(car), (), title)
    assert {round(text.dxf.height, 3) for text in document_of(sheet).modelspace().query("TEXT")} <= set(HEIGHTS)
    cells = [row[-1] for table in sheet.tables for row in table.rows]
    told = [part for _, steps in mountings(car) for step in steps for part in step.remark.split(", ")]
    told += [part for *_, how in loose_parts(car) for part in how.split(", ")]
    assert [part for cell in cells for part in cell.split(", ") if cell not in ("how", "where it belongs")] == told


def test_extension_lines_of_a_wheel_cross_no_number(sheets: dict[str, DrawingSheet]) -> None:
    """The bore's ran through the number of the hub, which stands at the other end now."""
    for code in ("front-wheel", "drive-wheel", "idle-wheel"):
        (view,) = sheets[f"workshop_car_{code}"].views
        across = [each for each in view.dimensions if isinstance(each, LinearDimension) and each.angle == 90.0]
        for each in across:
            nearer = [other for other in across if (other.at[0] - each.start[0]) * (other.at[0] - each.at[0]) < 0]
            for other in nearer:
                half = 0.7 * 2.5 * len(f"{other.prefix}10{other.suffix}") / 2 / sheets[f"workshop_car_{code}"].scale
                assert all(abs(end[1]) > half for end in (each.start, each.end)), (code, each.name, other.name)


def test_a_shaft_has_the_class_of_the_fits_that_are_stated(car: CarAssembly) -> None:
    """ISO 286: g6 over 6 to 10 mm is -5 to -14 µm, h6 0 to -9; over 3 to 6 mm g6 is -4 to -12."""

    def shaft(number: int, **stated: str | None) -> tuple[str, tuple[str, ...]]:
        train, cam = car.train, car.cam
        fits = {place: stated.get(place) for place in ("drive", "output")}
        making = replace(
            train.making,
            **{place: replace(each := getattr(train.making, place), fit=replace(each.fit, bore=fit))
               for place, fit in fits.items()},
        )  # fmt: skip
        disc = replace(cam.making, fit=replace(cam.making.fit, bore=stated.get("disc")))
        other = replace(car, train=replace(train, making=making), cam=replace(cam, making=disc))
        sheet = next(sheet for stem, sheet in part_sheets(other, NOWHERE) if stem.endswith(f"shaft-{number}"))
        (across,) = (each for each in sheet.views[0].dimensions if each.name.startswith("diameter"))
        return across.suffix, tuple(map(str, sheet.notes))

    assert shaft(4, output="H7/g6", disc="P7/g6") == (" g6 (-0.005/-0.014)", ())
    assert shaft(1, drive="H7/g6") == (" g6 (-0.004/-0.012)", ())
    assert shaft(1) == (" h6 (0/-0.008)", ())
    torn = ("Ø8 g6 (-0.005/-0.014): in the gear.", "Ø8 h6 (0/-0.009): in the disc.")
    assert shaft(4, output="H7/g6", disc="P7/h6") == ("", torn)


def test_seats_of_keys_have_the_limits_of_their_width_and_length() -> None:
    """DIN 6885-1: t1 of a key 8 x 7 is 4 +0.2, of 6 x 6 3.5 +0.1; seats over 28 to 80 mm are up to 0.3 mm longer."""
    assert [key_size(width) for width in (6.0, 8.0, 10.0, 18.0)] == [(6.0, 3.5), (7.0, 4.0), (8.0, 5.0), (11.0, 7.0)]
    assert [key_size(width) for width in (22.0, 25.0, 28.0)] == [(14.0, 9.0), (14.0, 9.0), (16.0, 10.0)]
    assert [key_length(3.0, room) for room in (5.9, 6.0, 11.0, 17.9)] == [None, 6.0, 10.0, 16.0]
    assert [key_length(8.0, room) for room in (17.0, 24.0, 31.0)] == [None, 22.0, 28.0]
    assert key_length(3.0, 80.0) == 36.0  # longer ones are not sold
    seats = [KeySeat(5.0, 45.0, 8.0, 13.0 - 4.0, 0.0)]
    title = Title(
        part="shaft", title="", material="", finish="", quantity=1, date="2026-01-01", design="", number="shaft"
    )
    sheet = turned_drawing([TurnedStep(0.0, 60.0, 26.0, 0.0)], None, seats, PartTexts(notes=()), title)
    said = {each.name: each.suffix for view in sheet.views for each in view.dimensions}
    assert sheet.dimensions["shaft less seat 1"] == pytest.approx(22.0)
    assert (said["shaft less seat 1"], said["length of seat 1"]) == (" (0/-0.2)", " +0.3/0")
    assert [longer(length) for length in (28.0, 32.0, 80.0, 90.0)] == [0.2, 0.3, 0.3, 0.5]
    assert [fillet(width) for width in (4.0, 5.0, 10.0, 20.0, 36.0, 56.0)] == [0.16, 0.25, 0.4, 0.6, 1.0, 1.6]
    section = sheet.views[1]
    assert section.place[1] - sheet.scale * 13.0 > EDGE + sheet.title.height
    assert apart(boxes(document_of(sheet).modelspace())) == []


def test_a_section_across_a_shaft_shows_depth_and_angle_of_each_seat() -> None:
    """The area of a section is that of the disc less its seat; what is turned says by how much."""
    seats = [KeySeat(5.0, 12.0, 3.0, 2.2, 0.0), KeySeat(40.0, 45.0, 2.0, 2.8, 2.0)]
    title = Title(
        part="shaft", title="", material="", finish="", quantity=1, date="2026-01-01", design="", number="shaft"
    )
    sheet = turned_drawing([TurnedStep(0.0, 60.0, 8.0, 0.0)], None, seats, PartTexts(notes=()), title)
    sections = sheet.views[1:]
    assert len(sections) == 2
    for seat, view in zip(seats[::-1], sections, strict=True):
        cut = shapely.Polygon(view.hatches[0].outside)
        side = np.sqrt(16.0 - seat.width**2 / 4)
        segment = 16.0 * np.arcsin(seat.width / 8) + seat.width / 2 * side - seat.width * seat.floor
        assert cut.area == pytest.approx(16.0 * np.pi - segment, rel=1e-3)
        x, y = np.array(cut.centroid.coords[0])
        assert np.arctan2(x, -y) == pytest.approx(seat.angle, abs=1e-6)  # away from the seat
    assert [each.text for each in sections[0].labels] == ["seen from the right end"]
    (turned,) = (each for each in sections[0].dimensions if isinstance(each, AngularDimension))
    assert (turned.start, turned.end - turned.start) == pytest.approx((90.0, np.degrees(2.0)))
    assert sheet.dimensions["shaft less seat 2"] == pytest.approx(6.8)
    assert apart(boxes(document_of(sheet).modelspace())) == []


def test_sheets_that_are_not_full_size_state_the_factor_of_lengths_where_readers_look(
    sheets: dict[str, DrawingSheet],
) -> None:
    """LibreCAD takes it from the header: without it 12 mm at 2:1 was shown as 24."""
    cheek = sheets["workshop_car_fork-cheek"]
    document = document_of(cheek)
    assert cheek.scale == 2.0
    assert document.header["$DIMLFAC"] == 0.5
    assert {style.dxf.dimlfac for style in document.dimstyles if style.dxf.name != "Standard"} >= {0.5}


def test_texts_of_plain_parts_have_heights_of_the_series_and_do_not_lie_on_each_other(
    sheets: dict[str, DrawingSheet],
) -> None:
    for stem in (
        "rod",
        "shaft-1",
        "shaft-4",
        "fork-cheek",
        "fork-bridge",
        "fork-spindle",
        "drive-wheel",
        "front-wheel",
    ):
        space = document_of(sheets[f"workshop_car_{stem}"]).modelspace()
        assert {round(text.dxf.height, 3) for text in space.query("TEXT")} <= set(HEIGHTS)
        found = boxes(space)
        shared = [
            (a, b)
            for number, (one, a) in enumerate(found)
            for other, b in found[:number]
            if one.intersection(other).area > 0.02 * min(one.area, other.area)
        ]
        assert shared == [], stem


def test_plates_and_block_of_the_frame_hold_their_seats_by_frames(sheets: dict[str, DrawingSheet]) -> None:
    """Bearing plates by the deviations of the train's distances, the block by the width of its seats' class."""
    for code, count in (("plate_near", 4), ("plate_far", 3)):
        sheet = sheets[f"workshop_car_frame_{code}"]
        first, *others = (each for each in sheet.views[0].symbols if isinstance(each, ToleranceFrame))
        assert (first.characteristic, first.datums) == (Characteristic.PERPENDICULARITY, ("A",))
        assert [each.datums for each in others] == [("A", "B"), *[("A", "B", "C")] * (count - 2)]
        assert {each.characteristic for each in others} == {Characteristic.POSITION}
        assert not any("±" in note or "Ø" in note or "M3" in note for note in sheet.notes)
        assert any(cell == "M3 × 6 / Ø2.5 × 8" for row in sheet.tables[0].rows for cell in row)
        # Boxes hold the places of the seats alone, and tabs and foot keep near and far seats in line.
        table = sheet.tables[0]
        boxed = {row: {column for each, column in table.exact if each == row} for row in range(len(table.rows))}
        assert [row for row, columns in boxed.items() if columns == {1, 2}] == [
            row for row, cells in enumerate(table.rows) if cells[4].startswith("seat of shaft")
        ]
        seats = {cells[0]: float(cells[1]) for cells in table.rows if cells[4].startswith("seat of shaft")}
        tabs = {cells[0]: (float(cells[1]), float(cells[2])) for cells in table.rows if cells[4] == "tab"}
        (along,) = (cells for cells in table.rows if cells[4] == "along, middle to middle")
        one, other = along[0].split("–")
        assert along[3] == f"{abs(tabs[other][0] - seats[one]):g}±0.025"
        (foot,) = (each for each in sheet.views[0].dimensions if each.name == "datum across")
        assert foot.suffix == " ±0.025"
        assert sheet.dimensions["datum across"] == pytest.approx(-tabs[other][1] - 3.0, abs=1e-3)  # tabs of 6 mm
    # Sheets without a view from the side say their thickness by the sign of ISO 129-1, within their outline.
    for code, thick in (("base", 6), ("platform", 6), ("bracket_idle", 8), ("bracket_micrometer", 8)):
        sheet = sheets[f"workshop_car_frame_{code}"]
        (sign,) = (each for each in sheet.views[0].labels if each.text.startswith("t"))
        texts = document_of(sheet).modelspace().query("TEXT")
        assert [text.dxf.text for text in texts].count(f"t = {thick}") == 1
        outline = next(curve.contour for curve in sheet.views[0].curves if isinstance(curve, Closed))
        assert shapely.Polygon(outline.polygon(0.01)).contains(shapely.Point(sign.at))
    (set_apart,) = (
        each for each in sheets["workshop_car_frame_base"].views[0].dimensions if each.name == "camshaft to fork axis"
    )
    assert (set_apart.prefix, set_apart.suffix) == ("(", ")")  # auxiliary (ISO 129-1)
    block = sheets["workshop_car_frame_block"]
    square, aligned = (each for each in block.views[1].symbols if isinstance(each, ToleranceFrame))
    assert (square.characteristic, square.zone_text, square.datums) == (
        Characteristic.PERPENDICULARITY,
        "Ø0.018",
        ("A",),
    )
    assert (aligned.characteristic, aligned.zone_text, aligned.datums) == (Characteristic.COAXIALITY, "Ø0.018", ("B",))
    assert [each.suffix for each in block.views[1].dimensions if each.name.endswith("seat")][:1] == [" H7 (+0.018/0)"]
    assert len(block.notes) == 1
    # The cut metal: the box less its seats, the hole between them and the drilled holes, in their middle plane.
    said = block.dimensions
    open_area = 2 * said["seat"] * said["depth of the upper seat"]
    open_area += said["hole between the seats"] * (said["height"] - 2 * said["depth of the upper seat"])
    open_area += 2 * 2.5 * said["depth of the threads' holes"]
    hatched = sum(shapely.Polygon(each.outside, each.holes).area for each in block.views[1].hatches)
    assert hatched == pytest.approx(said["length"] * said["height"] - open_area, abs=1e-6)
    assert [label.text for label in block.views[1].labels] == ["A–A"]
    assert [label.text for label in block.views[0].labels].count("A") == 2
    assert any("bonded" in note for note in sheets["workshop_car_frame_bracket_micrometer"].notes)
    # Standards of machined parts say nothing of a printed one.
    printed = document_of(replace(block, title=replace(block.title, printed=True, finish="")))
    said_of_it = [text.dxf.text for text in printed.modelspace().query("TEXT")]
    assert (said_of_it.count("as printed"), said_of_it.count("ISO 2768-mK"), said_of_it.count("-0.3")) == (3, 0, 0)


@pytest.mark.parametrize("language", ["en", "zh"])
def test_texts_of_the_frame_keep_off_each_other_and_numbers_off_outlines(
    sheets: dict[str, DrawingSheet], language: str
) -> None:
    for stem, sheet in sheets.items():
        if "_frame_" not in stem:
            continue
        space = document_of(sheet, language).modelspace()
        found = [*boxes(space), *frame_boxes(sheet)]
        assert apart(found) == [], stem
        outlines = shapely.union_all(
            [
                shapely.LineString([*(at := sheet.scale * curve.contour.polygon(0.01) + sheet.views[0].place), at[0]])
                for curve in sheet.views[0].curves
                if isinstance(curve, Closed)
            ]
        )
        for box, text in boxes(space):
            assert not (text.isdigit() and text != "0" and outlines.intersects(box.buffer(-0.2))), (stem, text)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_text_of_a_table_comes_up_to_the_next_cell(
    car: CarAssembly, sheets: dict[str, DrawingSheet], language: str
) -> None:
    title = title_of(car.origin, None, "car", "", "car", NOWHERE)
    whole = assembly_drawing(*views_of(car, 0.0), listed(car), tuple(sheet_notes(car, car.balance())), title)
    steps = mounting_sheet(mountings(car), loose_parts(car), tuple(mounting_notes(car)), title)
    for stem, sheet in {**sheets, "car": whole, "steps": steps}.items():
        if sheet.tables:
            assert leaving(sheet, language) == [], stem


def test_the_list_names_what_is_bought_with_its_standard(car: CarAssembly) -> None:
    assert facts_of_the_page()["In the list of parts"] == {"listed", "standard", "spoken"}
    for row, part in zip(listed(car), car.parts, strict=True):
        assert row.title
        assert row.quantity
        assert row.source
        # Of motor or weight no more is known than what the design says: its mass is not in that of the car.
        assert all((row.material, row.mass)) or row.code == "drive"
        if part.supply == Supply.BOUGHT and row.code not in ("adhesive", "grease", "drive"):
            # Bearings by their designation, spacers by thread and length, tubes and felt by their sizes.
            sizes = r"(ISO|DIN|EN) \d+|\d+(/\d+)?(-2Z)?$|M\d(\.\d)? x \d+$|Ø[\d.]+ x [\d.]+|[\d.]+( x [\d.]+){2}$"
            assert re.match(sizes, row.source), row.source


def words_on(car: CarAssembly) -> set[str]:
    """Words of the mounting page, of the assembly's notes and of the checks of car, frame and energy."""
    said = [*mounting_notes(car), *sheet_notes(car, car.balance())]
    for table in mountings(car):
        said += [table.title, *(text for step in table.steps for text in (step.part, step.way, step.remark))]
    said += [text for row in loose_parts(car) for text in row[1:]]
    checks = (*assembly_verdict(car).checks, *car.layout.plain_checks, *frame_in(car.layout).plain_checks)
    said += [text for check in checks for text in (check.name, check.place)]
    return {word for text in said for word in split(text)}


def split(text: str) -> set[str]:
    return {word.lower().removesuffix("s") for word in re.findall(r"[A-Za-z]{3,}", str(text))}


def lacking(car: CarAssembly) -> list[str]:
    """Words that name no part of the list and need none, and parts without balloon or place."""
    # Of a title what the part is, and not what it belongs to.
    titles = [re.sub(r" (of|beside|between|away|in)\b[^,]*", "", str(part.title)) for part in car.parts]
    listed_words = {word for title in titles for word in split(title)}
    unknown = words_on(car) - listed_words - NO_PARTS
    missing = [word for word in unknown if not any(part.code.startswith(NEEDS.get(word, "?")) for part in car.parts)]
    return sorted(missing) + [part.code for part in car.parts if not part.places and not part.how]


def test_what_the_mounting_page_speaks_of_is_in_the_list_of_parts(car: CarAssembly) -> None:
    assert lacking(car) == []
    assert all(row[3] for row in loose_parts(car))
    # The words find a part that is left out: each of these is spoken of.
    for code in ("brake-felt", "fork-spring", "micrometer-head", "collar-disc", "adhesive", "grease", "drive"):
        without = replace(car, parts=tuple(part for part in car.parts if part.code != code))
        assert lacking(without), code


def test_the_faces_of_a_disc_have_their_own_limits_on_the_side_of_the_rod(car: CarAssembly) -> None:
    """Inner 19.5, outer 24.5 mm on the right: the outer face is the farther to the right, with a hub or without."""
    keys = ["cam.mid_plane_mm=22", "cam.thickness_mm=5", "tolerances.inner_face_mm=0.02"]
    design = load_design("workshop_car", keys)
    other = replace(
        car, layout=replace(car.layout, design=design, site=replace(car.layout.site, fork=1.0, rod_side=-1))
    )
    (place,) = (step.place for table in mountings(other) for step in table.steps if step.part == "disc of the cam")
    assert place == "-24.5 ±0.05 … -19.5 ±0.02 mm"
    assert "inner face stands 19.5 ± 0.02 mm and its outer face 24.5 ± 0.05 mm to the right" in str(
        list(mounting_notes(other))
    )
    untold = load_design("workshop_car", ["tolerances="])
    notes = str(list(mounting_notes(replace(car, layout=replace(car.layout, design=untold)))))
    assert "inner face stands 23.5 mm" in notes
    assert "not stated (tolerances.inner_face_mm, tolerances.outer_face_mm)" in notes


def test_the_rim_of_a_disc_stands_square_to_its_face_within_the_taper(sheets: dict[str, DrawingSheet]) -> None:
    """The design's taper is 0.005 mm; A and B are bore and keyway, and a design without a taper has no third datum."""
    face, section, *_ = sheets["workshop_car_actual"].views
    (frame,) = (each for each in section.symbols if isinstance(each, ToleranceFrame))
    assert (frame.characteristic, frame.zone, frame.datums) == (Characteristic.PERPENDICULARITY, 0.005, ("C",))
    (datum,) = (each for each in section.symbols if isinstance(each, DatumFeature))
    assert datum.foot[0] == 0.0  # on a face, not on the rim
    assert frame.tip == pytest.approx((1.5, min(hatch.outside[:, 1].min() for hatch in section.hatches)), abs=0.3)
    assert {each.letter for each in face.symbols if isinstance(each, DatumFeature)} == {"A", "B"}
    plain = plan_cam(load_design("workshop_car", ["tolerances.taper_mm="]), "actual", judged=False)
    assert not sheet_of(plain, NOWHERE).views[1].symbols


def test_the_keyway_of_a_disc_has_a_frame_from_which_its_datum_hangs(sheets: dict[str, DrawingSheet]) -> None:
    """GB/T 1184, grade 8: 0.01 mm up to a width of 3 mm; without a tolerance of the outline B is of nothing."""
    sheet = sheets["workshop_car_actual"]
    frames = {each.characteristic: each for each in sheet.views[0].symbols if isinstance(each, ToleranceFrame)}
    keyway = frames[Characteristic.SYMMETRY]
    assert (keyway.zone_text, keyway.datums) == ("0.01", ("A",))
    (width,) = (each for each in sheet.views[0].dimensions if each.name == "keyway width")
    assert isinstance(width, LinearDimension)
    assert keyway.tip[0] == pytest.approx(width.at[0])  # in line with the dimension: of the middle
    (middle,) = (each for each in sheet.views[0].symbols if isinstance(each, DatumFeature) and each.letter == "B")
    near, far = sorted(keyway.bend[0] + keyway.side * (LEVEL + way) / sheet.scale for way in (0.0, sum(keyway.cells)))
    assert near < middle.foot[0] < far
    assert abs(middle.foot[1] - keyway.bend[1]) == pytest.approx(FRAME_HEIGHT / 2 / sheet.scale)
    assert not apart(frame_boxes(sheet))
    untold = sheet_of(plan_cam(load_design("workshop_car", ["tolerances="]), "actual", judged=False), NOWHERE)
    (alone,) = (each for each in untold.views[0].symbols if isinstance(each, ToleranceFrame))
    assert alone.characteristic == Characteristic.SYMMETRY
    assert [each.letter for each in untold.views[0].symbols if isinstance(each, DatumFeature)] == ["A"]


def test_sheets_of_gears_leave_open_what_no_mesh_needs_and_close_no_chain(
    car: CarAssembly, sheets: dict[str, DrawingSheet]
) -> None:
    """Width 5 and hub 6 make the length of 11: one of the three is auxiliary (ISO 129-1). Drivers read the card."""
    of = {part.name: sheets[f"{car.train.stem}_{part.name}"] for part in car.train.layout.pieces.parts}
    for name in ("1_pinion", "4_wheel"):
        said = {each.name: each for each in of[name].views[1].dimensions}
        assert [of[name].dimensions[each] for each in ("width, gear", "hub length", "length")] == [5.0, 6.0, 11.0]
        marks = [(said[each].prefix, said[each].suffix) for each in ("width, gear", "hub length", "length")]
        assert marks == [("", ""), ("(", ")"), ("", "")]
    between, keyed = "Angle between the teeth of both: free.", "Angle of the teeth to the keyway: free."
    free = [name for name, sheet in of.items() if any(between in note for note in sheet.notes)]
    assert free == ["2_wheel", "2_pinion", "3_wheel", "3_pinion"]
    assert [name for name, sheet in of.items() if keyed in sheet.notes] == ["4_wheel"]
    assert car.cam.application.before_each_run
    assert not any("each run" in note for note in sheets["workshop_car_actual"].notes)
    # The upright leader of the keyway's symmetry passes beside the letter of the bore.
    face, scale = of["4_wheel"].views[0], of["4_wheel"].scale
    (frame,) = (each for each in face.symbols if isinstance(each, ToleranceFrame))
    boxes = [box for box, words in frame_boxes(of["4_wheel"]) if words == ("A",)]
    leader = shapely.LineString(np.array(face.place) + scale * np.array([frame.tip, frame.bend]))
    assert all(box.distance(leader) > 0.2 for box in boxes)


@pytest.mark.parametrize("code", ["plate_near", "plate_far"])
def test_no_leader_of_a_plate_crosses_a_number(sheets: dict[str, DrawingSheet], code: str) -> None:
    sheet = sheets[f"workshop_car_frame_{code}"]
    view = sheet.views[0]
    leaders = [
        shapely.LineString(sheet.scale * np.array([each.tip, each.bend]))
        for each in view.symbols
        if isinstance(each, ToleranceFrame)
    ]
    assert len(leaders) > 2
    for label in view.labels:
        (x, y), half = sheet.scale * np.array(label.at), 0.3 * label.height * len(label.text)
        letters = shapely.box(x - half, y - label.height / 2, x + half, y + label.height / 2).buffer(0.5)
        assert not any(leader.intersects(letters) for leader in leaders), label.text


@pytest.mark.slow
def test_limits_of_a_small_tip_diameter_stand_over_its_extension_line(sheets: dict[str, DrawingSheet]) -> None:
    """Letters are 0.6 of their height wide at least; what is longer than the diameter stands beyond its end."""
    outside = 0
    one_piece = plan_gears(load_design("workshop_car", ["layout=", "frame=", "train.intermediate.cut_apart="]))
    for sheet in (*sheets.values(), *dict(sheets_of(one_piece, NOWHERE)).values()):
        for each in (dimension for view in sheet.views for dimension in view.dimensions):
            if not each.name.startswith("tip diameter") or not isinstance(each, LinearDimension):
                continue
            diameter = sheet.scale * abs(each.end[1] - each.start[1])
            long = 0.6 * 2.5 * len(f"Ø{diameter / sheet.scale:g}{each.suffix}")
            assert long < diameter or each.beside - long / 2 > diameter / 2
            outside += each.beside > 0
    assert outside > 0


@pytest.mark.parametrize("name", packaged_designs())
def test_a_packaged_design_states_what_its_sheets_need(name: str) -> None:
    design = complete_of(*read_design(name))
    blank = design.blank
    assert design.drawing
    assert all((blank.material or design.drawing.material, blank.bore_fit, design.drawing.finish))
    assert blank.keyway is None or blank.joint in TIGHT
    if isinstance(design, Design):
        train = gear_model.train_keys(design)
        assert TrainMaking.of(train).open_keys(len(train.stages) + 1) == {}
        made = gear_model.makings(design, train_in_car(layout_of(design)).parts)
        assert all(each.cutting and (each.apart or each.place in ("drive", "output")) for each in made)
        assert design.tolerances.profile_offset_mm
    else:
        assert design.lift_tolerances.base_circle_um


def test_a_disc_without_a_bearing_beside_it_is_not_said_to_have_a_sleeve(car: CarAssembly) -> None:
    without = replace(car, parts=tuple(part for part in car.parts if part.code != "sleeve-disc"))
    between = "between sleeve and set collar"
    assert between in str(mountings(car))
    assert between not in str(mountings(without))
    assert "held by a set collar" in str(mountings(without))


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    "given",
    [
        ["frame.make=printed", "frame.material="],
        [
            "drive={kind='weight', mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=400, drum_mm=20}",
            "mechanics.drive_energy_J=",
            "mechanics.rolling_resistance=0.007",
        ],
        ["drive={kind='motor', mass_kg=0.3, size_mm=[40, 40, 30]}"],
        ["mechanics="],
    ],
)
def test_the_list_holds_what_other_cars_are_mounted_with(given: list[str]) -> None:
    design = load_design("workshop_car", given)
    assert lacking(put_together(plan_cam(design, "actual", judged=False), plan_gears(design))) == []


@pytest.mark.slow
def test_the_list_has_set_screws_of_the_stated_threads(car: CarAssembly) -> None:
    """Two of M3 are on the packaged car: in the hub of its drive, as the design states, and in the wheel's."""
    stated = ["train.drive.hub.set_screw_thread=M4 x 0.7", "train.drive.hub.set_screw_mm=3.3"]
    design = load_design("workshop_car", stated)
    other = put_together(plan_cam(design, "actual", judged=False), plan_gears(design))

    def screws(of: CarAssembly) -> dict[str, int]:
        return {part.standard: part.further for part in of.parts if part.code.startswith("set-screws")}

    assert screws(car) == {"ISO 4029, M3 x 4": 2}
    assert screws(other) == {"ISO 4029, M3 x 4": 1, "ISO 4029, M4 x 4": 1}


@pytest.mark.parametrize("torque", [2.0, 25.0, 400.0])
def test_a_leg_spring_bears_its_torque(torque: float) -> None:
    """Bending of a round wire: stress M / W with W = π d³/32, no wire of the next size below would do."""
    wire, coils = spring_sizes(torque)
    section = np.pi * wire**3 / 32
    assert 300.0 < torque / section <= 1000.0
    assert coils * wire <= JOURNAL


def test_the_sheet_of_the_car_has_every_axis_and_balloon(car: CarAssembly, sheets: dict[str, DrawingSheet]) -> None:
    title = title_of(car.origin, None, "car", "", "car", NOWHERE)
    side, top = views_of(car, 0.0)
    sheet = assembly_drawing(side, top, listed(car), tuple(sheet_notes(car, car.balance())), title)
    # A list that reaches down to the title block leaves its notes room beside that.
    more = [row._replace(number=row.number + 100, code="", drawn=False) for row in listed(car)]
    longer = assembly_drawing(side, top, [*listed(car), *more][:52], tuple(sheet_notes(car, car.balance())), title)
    for each in (sheet, longer):
        places = [place for _, place in placed_notes(each.notes, each.columns)]
        assert places
        assert all(y > 10.0 and (x < 236.0 or y > 58.0) for x, y in places)
    names, plate = sheet.dimensions, sheets[f"{car.train.stem}_plate"]
    labels = {label.text for view in sheet.views for label in view.labels}
    seen = {each.code for view in (side, top) for each in view.seen}
    facts = {
        "axes": len(plate.tables[0].rows) == 1 + len(car.train.layout.on_shafts)
        and all(isinstance(symbol, ToleranceFrame | DatumFeature) for symbol in plate.views[0].symbols)
        and len(plate.views[0].symbols) > 2,
        "fork-distance": names["fork axis to camshaft"] == pytest.approx(70.0)
        and any("±" in dimension.suffix for view in sheet.views for dimension in view.dimensions),
        "axle-distance": names["camshaft to rear axle"] == pytest.approx(97.0),
        "heights": {"height of the camshaft", "height of the rear axle"} <= names.keys(),
        "across": names["drive wheel from the fork axis"] == pytest.approx(37.0)
        and names["idle wheel from the fork axis"] == pytest.approx(201.0)
        and names["disc's lower face from the fork axis"] == pytest.approx(23.5),
        "balloon": all(str(number) in labels for number, part in enumerate(car.parts, 1) if part.code in seen),
    }
    assert [fact for fact, there in facts.items() if not there] == []
    assert facts.keys() == facts_of_the_page()["On the assembly's sheet and the plate's"]


def test_balloons_of_the_lower_view_stand_below_those_of_the_upper_one(car: CarAssembly) -> None:
    """Also where a tall part makes the scale small and the columns long: they met on the sheet of a car with weight."""
    _, top = views_of(car, 0.0)
    found, scale = assembly_sheet._visible(top.seen), 0.2
    numbers = {code: number for number, code in enumerate(dict.fromkeys(each.code for each in top.seen), 1)}
    free = assembly_sheet._balloons(top, found, numbers, scale, (np.inf, np.inf))[1]
    sides = [sorted(label.at[1] for label in free if (label.at[0] < top.bounds[0]) == left) for left in (True, False)]
    ceilings = (sides[0][-1] - 40.0, sides[1][-1] + 40.0)
    _, held, lowest = assembly_sheet._balloons(top, found, numbers, scale, ceilings)
    moved = [label.at[1] - before.at[1] for label, before in zip(held, free, strict=True)]
    assert {round(each, 6) for each in moved} == {-40.0, 0.0}
    assert lowest == pytest.approx((sides[0][0] - 40.0, sides[1][0]))
    assert all(np.diff(heights).min() >= assembly_sheet._APART / scale - 1e-9 for heights in sides)


def test_the_mounting_plan_says_order_direction_place_and_hold(car: CarAssembly) -> None:
    tables, notes = mountings(car), " ".join(mounting_notes(car))
    steps = [step for table in tables for step in table.steps]
    put_on = [step for step in steps if step.way]
    on_shafts = [part for part in car.parts if part.shaft and part.places]
    facts = {
        "order": len(steps) == len(on_shafts),
        "direction": all(step.way in ("from the left", "from the right") for step in put_on),
        "place": all(re.fullmatch(r"-?[\d.]+( ±0.05)? … -?[\d.]+( ±0.05)? mm", step.place) for step in put_on),
        # Mid-plane 25 mm and thickness 3 mm, each face within its half width of the design's tolerances.
        "faces": [step.place for step in steps if step.part == "disc of the cam"] == ["23.5 ±0.05 … 26.5 ±0.05 mm"]
        and "inner face stands 23.5 ± 0.05 mm and its outer face 26.5 ± 0.05 mm to the left of the fork" in notes,
        "held": all(step.remark for step in steps),
        "slack": "Take up the slack before each start: pushing" in notes and "0.05°" in notes,
        "zero": "Start: turn the drive forward" in notes,
        "trim": "Trim: after a trial run" in notes,
    }
    assert [fact for fact, there in facts.items() if not there] == []
    assert facts.keys() == facts_of_the_page()["On the mounting plan"]
    camshaft = [str(step.part) for step in tables[0].steps]
    assert camshaft.index("key of the disc") < camshaft.index("disc of the cam")


def test_tabs_go_into_their_slots_by_the_limits_that_the_sheets_state(car: CarAssembly) -> None:
    """Largest tabs and smallest slots, their distances off against each other, and the thickest sheet."""
    panels: dict[str, Panel] = {}
    sheets = of_frame(car, panels)

    def limited_sizes(cell: str) -> list[tuple[float, float]]:
        return [(float(size), float(off or 0)) for size, off in re.findall(r"([\d.]+)(?:±([\d.]+))?", cell)]

    def joints(stem: str, name: str) -> list[tuple[float, float, list[tuple[float, float]]]]:
        rows = [row for row in sheets[stem].tables[0].rows if row[4] == name]
        return [(float(row[1]), float(row[2]), limited_sizes(row[3])) for row in rows]

    def distances(stem: str) -> list[list[tuple[float, float]]]:
        return [limited_sizes(row[3]) for row in sheets[stem].tables[0].rows if row[4].startswith("distance")]

    base = "workshop_car_frame_base"
    slots, apart = joints(base, "slot for a tab"), distances(base)
    closed = 0
    for number, code in enumerate(("plate_near", "plate_far", "bracket_idle", "bracket_micrometer")):
        stem = f"workshop_car_frame_{code}"
        (one, other), (((between, off),),) = joints(stem, "tab"), distances(stem)
        pair, along = slots[2 * number : 2 * number + 2], int(code == "bracket_micrometer")
        assert between == pytest.approx(abs(other[0] - one[0]), abs=1e-9)
        assert between == pytest.approx(abs(pair[1][along] - pair[0][along]), abs=1e-9)
        widest, least = sum(one[2][0]), pair[0][2][along][0] - pair[0][2][along][1]
        assert off > 0
        assert least - widest >= off + apart[number][0][1] - 1e-9, code  # each pair may be off the other way
        if pair[0][2][1 - along][1]:  # a slot that is closed all around
            closed += 1
            sign = next(each.suffix for each in sheets[stem].views[1].dimensions if each.name == "thickness")
            thickest = panels[stem].thickness + float(sign.removeprefix(" ±"))
            narrowest = pair[0][2][1][0] - pair[0][2][1][1]
            assert narrowest - thickest >= apart[number][1][1] - 1e-9
    assert closed == 1
    # What goes through several sheets is held by the slots of all of them, from the first one of the first sheet.
    in_line = [row for row in sheets[base].tables[0].rows if row[4] == "along, middle to middle"]
    assert [limited_sizes(row[3]) for row in in_line] == [
        [(abs(slots[each][0] - slots[0][0]), apart[0][0][1])] for each in (2, 4)
    ]
    assert slots[0][0] == slots[2][0]


@pytest.mark.slow
def test_a_platform_too_small_for_its_thickness_has_it_beside() -> None:
    design = load_design("figure_eight")
    panels: dict[str, Panel] = {}
    sheets = of_frame(put_together(plan_cam(design, "actual", judged=False), plan_gears(design)), panels)
    stem = "figure_eight_frame_platform"
    (sign,) = (each for each in sheets[stem].views[0].labels if each.text.startswith("t = "))
    assert sign.text == f"t = {panels[stem].thickness:g}"
    (left, low), (right, high) = (getattr(panels[stem].outline.polygon(0.1), end)(axis=0) for end in ("min", "max"))
    letters = shapely.box(*(x + way for way in (-1.5, 1.5) for x in sign.at))
    assert letters.disjoint(shapely.box(left, low, right, high))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("overrides", "thickness"),
    [
        ((), 8.0),  # shafts of 5, 3, 3 and 8 mm in plain holes
        (("train.plate.bearing_bores_mm=[16,10,10,22]",), 7.0),  # 625, 623, 623 and 608 are 5, 4, 4 and 7 mm wide
        (("train.plate.material=plywood 5.5 mm",), 5.5),
        (("train.plate.thickness_mm=6",), 6.0),
    ],
)
def test_a_plate_for_the_axes_has_its_thickness(overrides: tuple[str, ...], thickness: float) -> None:
    design = load_design("carbon_free_car", list(overrides))
    (plate,) = (sheet for stem, sheet in sheets_of(plan_gears(design), NOWHERE) if stem.endswith("_plate"))
    assert plate.dimensions["thickness"] == thickness
    assert not any("hickness" in note for note in plate.notes)
