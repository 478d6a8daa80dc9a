"""Sheets of small trains: frames, datums and threads in place of sentences, and texts that keep off each other."""

import re

import numpy as np
import pytest
import shapely

from cadgen.design.load import train_of
from cadgen.errors import DesignError
from cadgen.figures import Figure, Figures
from cadgen.gears.rack import RackForm
from cadgen.gears.tolerances import centre_distance_deviation, flank_tolerance, run_outs, tip_tolerance
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.jobs.drawings import Folder, sheets_of
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.messages import translate
from cadgen.output.drawing.gear_sheets import gear_rows
from cadgen.output.drawing.sheet import (
    EDGE,
    FRAME_HEIGHT,
    LEVEL,
    SIZES,
    AngularDimension,
    Characteristic,
    DatumFeature,
    DrawingSheet,
    LinearDimension,
    LineKind,
    Stroke,
    SurfaceTexture,
    ToleranceFrame,
)
from cadgen.output.drawing.sheet_files import document_of
from tests.output.drawing.test_drawings import boxes

NOWHERE = Folder({}, "2026-01-01")
HEAD = "[train]\nmodule_mm = 1.0\nwidth_mm = 8.0\nbearing_span_mm = 60.0\n"
TWO_STAGES = (
    HEAD
    + """
[train.plate]
thickness_mm = 5.0
hole_fit = "H7/h6"
bearing_bores_mm = [16]
[[train.stages]]
driver = { teeth = 20, grade = 6 }
driven = { teeth = 60, grade = 6 }
[[train.stages]]
driver = { teeth = 24 }
driven = { teeth = 64 }
[train.drive]
bore_diameter_mm = 6.0
bore_fit = "H7/h6"
keyway = { width_mm = 2.0, depth_mm = 1.0 }
hub = { diameter_mm = 14.0, length_mm = 6.0 }
[train.intermediate]
bore_diameter_mm = 6.0
[train.output]
bore_diameter_mm = 8.0
shaft_ends = true
"""
)
RING = (
    HEAD
    + """
[[train.stages]]
driver = { teeth = 18 }
driven = { teeth = 54, internal = true, rim_mm = 4.0 }
[train.drive]
bore_diameter_mm = 5.0
"""
)
PLANETARY = (
    HEAD
    + """
[[train.stages]]
kind = "planetary"
sun = { teeth = 18 }
planet = { teeth = 27, count = 3, bore_diameter_mm = 4.0 }
pin_place_um = 8.0
[train.drive]
bore_diameter_mm = 5.0
[train.output]
bore_diameter_mm = 6.0
"""
)
RACK = (
    HEAD
    + """
[[train.stages]]
kind = "rack"
driver = { teeth = 19 }
rack = { teeth = 20, height_mm = 8.0 }
[train.drive]
bore_diameter_mm = 5.0
hub = { diameter_mm = 12.0, length_mm = 7.0, set_screw_mm = 2.5, set_screw_thread = "M3" }
[drawing]
finish = "Ra 3.2"
flank_finish = "Ra 0.8"
bore_finish = "Ra 1.6"
"""
)
TRAINS = {"two stages": TWO_STAGES, "ring": RING, "planetary": PLANETARY, "rack": RACK}


@pytest.fixture(scope="module")
def sheets(tmp_path_factory) -> dict[str, dict[str, DrawingSheet]]:
    place = tmp_path_factory.mktemp("designs") / "train.toml"
    found = {}
    for name, text in TRAINS.items():
        plan = plan_gears(train_of(text, place))
        found[name] = {stem.removeprefix(f"{plan.stem}_"): sheet for stem, sheet in sheets_of(plan, NOWHERE)}
    return found


def frames(sheet: DrawingSheet) -> dict[str, ToleranceFrame]:
    symbols = [symbol for view in sheet.views for symbol in view.symbols]
    return {symbol.name: symbol for symbol in symbols if isinstance(symbol, ToleranceFrame)}


def datums(sheet: DrawingSheet) -> str:
    symbols = [symbol for view in sheet.views for symbol in view.symbols]
    return "".join(symbol.letter for symbol in symbols if isinstance(symbol, DatumFeature))


def test_a_blank_may_take_a_share_of_pitch_and_helix() -> None:
    """A blank off by e has a cumulative pitch of 2 e; a face that runs out by t leans the teeth by t b / D."""
    tip, face = run_outs(60.0, 2.0, 16.0, 64.0, 8)
    pitch, helix = (float(flank_tolerance(*each, 8)) for each in (("F_p", 60.0, 2.0), ("F_beta", 60.0, 16.0)))
    turn = np.linspace(0.0, 2 * np.pi, 10_000)
    off = tip / 2 * np.sin(turn)  # of the teeth along the pitch circle
    assert 0.3 * pitch - 1e-3 <= np.ptp(off) <= 0.3 * pitch
    leaning = 16.0 / 64.0 * face * np.sin(turn) / 2
    assert 0.2 * helix - 1e-3 <= np.ptp(leaning) <= 0.2 * helix
    assert run_outs(12.0, 0.5, 4.0, 13.0, 3) == (0.005, 0.005)


def test_tips_are_smaller_by_no_more_than_a_tenth_of_the_module(sheets) -> None:
    """IT11 of ISO 286-1, table 1: 160 µm above 30 up to 50 mm; a ring's tips stand back, too, and so are wider."""
    assert tip_tolerance(44.0, 2.0) == pytest.approx(0.16)
    assert tip_tolerance(16.0, 0.5) == pytest.approx(0.05)
    assert tip_tolerance(700.0, 3.0) == pytest.approx(0.3)
    said = {
        stem: [each.suffix for view in sheet.views for each in view.dimensions if each.name.startswith("tip diameter")]
        for stem, sheet in sheets["planetary"].items()
    }
    assert said["1_pinion"] == [" 0/-0.1"]
    assert said["stage1_ring"] == [" +0.1/0"]
    assert said["2_carrier"] == [""]  # a carrier


def test_gears_say_run_outs_by_frames_to_their_bore(sheets) -> None:
    pinion, cluster = sheets["two stages"]["1_pinion"], sheets["two stages"]["2_cluster"]
    said = frames(pinion)
    assert said.keys() == {"tip circle, gear", "lower face", "keyway"}
    del said["keyway"]
    assert {(each.characteristic, each.datums) for each in said.values()} == {(Characteristic.RUN_OUT, ("A",))}
    assert datums(pinion) == "A"
    assert frames(cluster).keys() == {"tip circle, lower gear", "tip circle, upper gear", "lower face"}
    # Of the ring the outer circle is the datum.
    assert datums(sheets["ring"]["2_wheel"]) == "A"
    assert "tip circle, gear" in frames(sheets["ring"]["2_wheel"])


def test_the_middle_of_a_keyway_is_held_to_the_bore(sheets) -> None:
    """The frame stands in line with the width: grade 8 of GB/T 1184 for 2 mm is 10 µm."""
    sheet = sheets["two stages"]["1_pinion"]
    frame = frames(sheet)["keyway"]
    assert (frame.characteristic, frame.zone_text, frame.datums) == (Characteristic.SYMMETRY, "0.01", ("A",))
    (width,) = (each for view in sheet.views for each in view.dimensions if each.name == "keyway width")
    assert (frame.tip[0], abs(frame.tip[1])) == pytest.approx((width.at[0], 2.0 / 2))
    assert frame.tip[1] * frame.bend[1] > 0.0  # outwards along the line of the dimension
    assert frame.bend[0] == pytest.approx(frame.tip[0], abs=1e-4)
    assert frame.tip[1] * width.beside < 0.0  # at the end that the number leaves free


def test_carriers_and_racks_say_their_places_by_frames(sheets) -> None:
    """Pins within 8 µm of their places lie in zones of 16 µm; tips of a rack keep the distance of its pinion."""
    carrier = sheets["planetary"]["2_carrier"]
    assert (frames(carrier)["pins"].zone_text, frames(carrier)["pins"].datums) == ("Ø0.016", ("A",))
    assert [each.name for view in carrier.views for each in view.dimensions if getattr(each, "exact", False)] == [
        "circle of holes"
    ]
    assert carrier.tables[0].rows[0][1] == "(22.5)"  # m (18 + 27) / 2; the frame holds it
    rack = sheets["rack"]["2_rack"]
    assert datums(rack) == "A"
    tips = frames(rack)["tips"]
    assert tips.characteristic == Characteristic.PARALLELISM
    assert tips.zone == pytest.approx(float(centre_distance_deviation(9.5, 7)))


def test_a_carrier_without_a_bore_holds_its_pins_to_each_other(tmp_path) -> None:
    """No axis is given that they could be counted from: the zones are combined (ISO 5458)."""
    text = PLANETARY.replace("[train.output]\nbore_diameter_mm = 6.0\n", "")
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    sheet = next(sheet for stem, sheet in sheets_of(plan, NOWHERE) if stem.endswith("2_carrier"))
    assert (frames(sheet)["pins"].zone_text, frames(sheet)["pins"].datums) == ("Ø0.016 CZ", ())
    assert datums(sheet) == ""


def test_a_carrier_whose_planets_stand_at_unequal_angles_says_them(tmp_path) -> None:
    """Planets fit at multiples of 360° / (17 + 69) alone: those nearest to 120° and 240° are 29 and 57 of them."""
    text = PLANETARY.replace("teeth = 18", "teeth = 17").replace("teeth = 27", "teeth = 26")
    text = text.replace("pin_place_um = 8.0", 'spacing = "nearest"')
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    sheet = next(sheet for stem, sheet in sheets_of(plan, NOWHERE) if stem.endswith("2_carrier"))
    angles = [each for each in sheet.views[0].dimensions if isinstance(each, AngularDimension)]
    assert [each.end - each.start for each in angles] == pytest.approx([29 * 360 / 86, 28 * 360 / 86])
    assert all(each.exact for each in angles)
    # No place of the pins is stated: they keep the deviation of their distance, which the play is reckoned with.
    deviation = float(centre_distance_deviation((17 + 26) / 2, 7))
    assert frames(sheet)["pins"].zone == pytest.approx(2 * deviation)
    assert sheet.tables[0].title == "carrier"
    assert "tooth" not in " ".join(map(str, sheet.notes))


def test_a_double_helical_gear_has_both_hands_in_its_table(tmp_path) -> None:
    text = TWO_STAGES.replace("[[train.stages]]", "[[train.stages]]\ndouble = true", 1)
    text = text.replace("module_mm = 1.0", "module_mm = 1.0\nhelix_angle_deg = 25.0")
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    rows = {stem: dict(sheet.tables[0].rows) for stem, sheet in sheets_of(plan, NOWHERE) if stem.endswith("1_pinion")}
    (pinion,) = rows.values()
    assert (pinion["helix of the lower half"], pinion["helix of the upper half"]) == ("25° right", "25° left")
    assert pinion["face width"] == "2 × 4 mm"
    assert "helix angle, hand" not in pinion


@pytest.mark.parametrize("hand", ["right", "left"])
def test_the_teeth_of_a_helical_rack_lean_on_its_sheet_as_in_its_mesh(hand, tmp_path) -> None:
    """Seen on its teeth, with the upper face below: the ends of the tips are those of the mesh, less a shift."""
    text = RACK.replace("module_mm = 1.0", "module_mm = 1.0\nhelix_angle_deg = 15.0")
    text = text.replace('kind = "rack"', f'kind = "rack"\nhand = "{hand}"')
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    sheet = next(sheet for stem, sheet in sheets_of(plan, NOWHERE) if stem.endswith("2_rack"))
    rows = dict(sheet.tables[0].rows)
    assert rows["transverse pitch"] == f"{np.pi / np.cos(np.radians(15.0)):.4f} mm"
    assert rows["helix angle, hand"] == f"15° {'left' if hand == 'right' else 'right'}"
    view = sheet.views[2]
    lines = np.array(
        [each.points for each in view.curves if isinstance(each, Stroke) and each.line == LineKind.VISIBLE]
    )
    across = lines[np.ptp(lines[:, :, 1], axis=1) > 1.0]
    (part,) = (each for each in plan.layout.parts if each.name == "2_rack")
    corners = body_mesh(part.body, 1e-3).vertices
    tips = corners[corners[:, 1] > corners[:, 1].max() - 1e-6]
    for height, end in ((0.0, across[:, 1]), (8.0, across[:, 0])):
        at = np.unique(np.round(tips[abs(tips[:, 2] - height) < 1e-6, 0], 6))
        assert np.unique(np.round(end[2:, 0], 6)) - across[0, 0, 0] == pytest.approx(
            at - corners[abs(corners[:, 2] - 8.0) < 1e-6, 0].min(), abs=1e-5
        )
        assert end[:, 1] == pytest.approx(-height)  # the first angle of projection
    (angle,) = view.dimensions
    assert angle.end - angle.start == pytest.approx(15.0)
    # From the front the end that leans out behind the face is seen, and the whole bar is that much longer.
    front = sheet.views[0]
    drawn = np.vstack([each.points for each in front.curves if isinstance(each, Stroke) and each.line == "VISIBLE"])
    near = corners[abs(corners[:, 2] - 8.0) < 1e-6, 0].min()
    ends = np.array([corners[:, 0].min(), corners[:, 0].max()]) - near
    out = ends[0] if hand == "right" else ends[1]  # of the rack, whose hand is the other one
    assert (drawn[:, 0].min() if hand == "right" else drawn[:, 0].max()) == pytest.approx(out, abs=1e-5)
    assert (drawn[:, 1].min(), drawn[:, 1].max()) == pytest.approx((-8.0, 1.0))
    assert sheet.dimensions["total length"] == pytest.approx(np.ptp(ends), abs=1e-5)
    assert sheet.dimensions["total length"] - sheet.dimensions["length"] == pytest.approx(8.0 * np.tan(np.radians(15)))
    (whole,) = (each for each in front.dimensions if each.name == "total length")
    assert (whole.prefix, whole.suffix) == ("(", ")")
    assert rows.keys() >= {"over a ball from back, mm", "axis to reference line, mm"}


def test_sections_have_the_lines_of_pitch_cylinders(sheets) -> None:
    """Thin chain lines at half the reference diameter, z m / 2, on either side of the axis (ISO 2203)."""
    for name, stem, radii in (
        ("two stages", "2_cluster", {30.0, 12.0}),
        ("ring", "2_wheel", {27.0}),
        ("planetary", "2_carrier", set()),
    ):
        section = sheets[name][stem].views[1]
        lines = [each.points for each in section.curves if isinstance(each, Stroke) and each.line == LineKind.CENTRE]
        level = {round(float(each[0, 1]), 6) for each in lines if len(each) == 2 and each[0, 1] == each[1, 1]}
        assert level == {0.0} | radii | {-each for each in radii}, stem


def test_what_a_design_cannot_state_is_said_to_be_open(sheets, tmp_path) -> None:
    """Neither rings nor racks have keys for what holds them; a sun that is held is on no shaft and no pin."""
    assert any("nor what holds the ring" in note for note in sheets["ring"]["2_wheel"].notes)
    assert any("states no fastening" in note for note in sheets["rack"]["2_rack"].notes)
    assert sheets["ring"]["2_wheel"].title.part == "2_wheel: ring gear of 54 teeth"
    text = PLANETARY.replace('kind = "planetary"', 'kind = "planetary"\nheld = "sun"')
    text = text.replace("sun = { teeth = 18 }", "sun = { teeth = 18, bore_diameter_mm = 6.0 }")
    text = text.replace("[train.drive]\nbore_diameter_mm = 5.0\n", "")
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    held = {stem.removeprefix(f"{plan.stem}_"): sheet for stem, sheet in sheets_of(plan, NOWHERE)}
    assert held.keys() == {"1_ring", "2_carrier", "stage1_planet_1", "stage1_sun", "plate"}
    assert any("choose it with what holds the gear" in note for note in held["stage1_sun"].notes)
    assert any("choose it with the pin" in note for note in held["stage1_planet_1"].notes)


def test_titles_and_hands_are_in_chinese_too(sheets, tmp_path) -> None:
    """The title of a carrier or a rack, and the hand of a helix, have no English word left but names of files."""
    for name, stem in (("planetary", "2_carrier"), ("rack", "2_rack")):
        title = translate(sheets[name][stem].title.part, "zh")
        assert not re.search("[A-Za-z]{2}", str(title).partition("：")[2]), title
    helix = Figures(Figure("teeth", "", 20), Figure("helix_angle", "", -15.0))
    stage = plan_gears(train_of(RACK, tmp_path / "train.toml")).layout.train.stages[0]
    rows = {translate(key, "zh"): translate(value, "zh") for key, value in gear_rows(helix, ("",), stage, drives=True)}
    assert rows["螺旋角，旋向"] == "15° 左旋"


def test_the_name_of_a_cell_stands_clear_of_large_chinese_letters_under_it(sheets) -> None:
    """Such letters reach 0.88 of their em up and 0.12 down, and an em is 1 / 0.73 of a capital's height."""
    texts = document_of(sheets["ring"]["plate"], "zh").modelspace().query("TEXT")
    name, part = (next(each.dxf for each in texts if each.dxf.text == text) for text in ("零件", "轴孔板"))
    assert name.insert.y - part.insert.y > (0.88 * part.height + 0.12 * name.height) / 0.73


def test_a_plate_keeps_its_dimensions_within_the_frame(sheets) -> None:
    """The number over the uppermost line is 3.1 mm high; an A4 ends 10 mm over its frame."""
    for name in TRAINS:
        plate = sheets[name]["plate"]
        view = plate.views[0]
        highest = max(each.at[1] for each in view.dimensions if isinstance(each, LinearDimension))
        assert view.place[1] + plate.scale * highest + 3.1 < SIZES[plate.size][1] - EDGE, name


def test_a_pin_in_a_rack_touches_both_flanks_at_the_height_that_its_sheet_states(sheets) -> None:
    """The pin's distance from the outline is its radius on either side; thicker teeth lift it."""
    for helix, thickness in ((0.0, 0.0), (0.0, -0.06), (0.0, 0.02)):
        rack = RackForm(teeth=4, normal_module=1.0, width=8.0, helix_angle=helix, tooth_thickness_deviation=thickness)
        radius, height = rack.pin_diameter / 2, rack.over_pin(thickness)
        centre = np.array([rack.pitch, height - rack.back_height - radius])
        corners = np.array([[point.real, point.imag] for point in rack.outline.polygon(1e-5)])
        bar = shapely.Polygon(corners)
        assert bar.exterior.distance(shapely.Point(centre)) == pytest.approx(radius, abs=1e-5)
        left, right = (shapely.box(*ends, 9.0) for ends in ((0, -9, centre[0]), (centre[0], -9, 9)))
        touching = [bar.exterior.intersection(side).distance(shapely.Point(centre)) for side in (left, right)]
        assert touching == pytest.approx([radius] * 2, abs=1e-5)
        assert height - rack.back_height > rack.addendum_factor * rack.normal_module  # a micrometer reaches it
    sheet = sheets["rack"]["2_rack"]
    rows, said = dict(sheet.tables[0].rows), {each.name: each for view in sheet.views for each in view.dimensions}
    # 1.75 mm of pin, h 8 mm, a tooth 20 to 70 µm thinner than pi / 2 (two pitches of 10 µm need room): by hand.
    assert (rows["pin diameter D_M"], rows["over a pin from back, mm"]) == ("1.75 mm", "9.179 to 9.248")
    assert sheet.dimensions["middle of the first tooth"] == pytest.approx(np.pi / 2)
    assert said["height to the reference line"].exact
    assert said["height"].suffix == " 0/-0.09"  # IT11 over 6 to 10 mm (ISO 286-1)
    assert (said["height of the roots"].prefix, said["height of the roots"].suffix) == ("(", ")")


def test_the_title_block_says_what_may_be_taken_off_an_edge(sheets) -> None:
    for stem, most in (("1_pinion", "-0.1"), ("plate", "-0.3")):
        said = [text.dxf.text for text in document_of(sheets["two stages"][stem]).modelspace().query("TEXT")]
        assert said[said.index("edges, ISO 13715") + 1 :].count(most) == 1


def test_holes_of_a_plate_stand_in_zones_that_keep_the_distances_of_the_axes(sheets) -> None:
    """Any three holes in their zones, the first one the datum, keep both distances within their deviations."""
    plate = sheets["two stages"]["plate"]
    said = frames(plate)
    assert [each.datums for each in said.values()] == [("A",), ("A", "B"), ("A", "B", "C")]
    assert {each.zone_text[0] for each in said.values()} == {"Ø"}
    assert sorted(datums(plate)) == ["A", "B", "C"]
    assert "±" not in " ".join(plate.notes)
    rows = plate.tables[0].rows[1:]
    assert rows[0][3] == "16 H7 (+0.018/0)"
    places = np.array([complex(float(x), float(y)) for _, x, y, _ in rows])
    rng = np.random.default_rng(3)
    widths = np.array([0.0, *(each.zone for each in list(said.values())[1:])])
    off = widths / 2 * np.exp(1j * rng.uniform(0, 2 * np.pi, (2000, 3)))
    lengths = np.abs(np.diff(places + off, axis=1))
    deviations = centre_distance_deviation(np.array([40.0, 44.0]), 6)[0], centre_distance_deviation(44.0, 7)
    assert np.all(np.abs(lengths - np.abs(np.diff(places))) <= np.array(deviations) + 1e-5)
    # Without a hole there is nothing to place, and no distance of 0 is "± 0".
    assert not frames(sheets["ring"]["plate"])
    assert not any("± 0 " in note for of in sheets.values() for note in of["plate"].notes)
    # Places in frames are boxed; without frames the distance has its limits, and the thickness its sign.
    assert plate.tables[0].exact == {(row, column) for row in (1, 2, 3) for column in (1, 2)}
    of_ring = sheets["ring"]["plate"]
    (apart_by,) = (each for each in of_ring.views[0].dimensions if each.name == "axes 1 and 2")
    assert apart_by.suffix == f" ±{float(centre_distance_deviation(18.0, 7)):g}"
    assert not of_ring.tables[0].exact
    assert [label.text for label in of_ring.views[0].labels][-1].startswith("t = ")
    assert [row[3] for row in of_ring.tables[0].rows[1:]] == ["5", "none"]  # the ring is on no shaft of its own
    coaxial = sheets["planetary"]["plate"]
    assert [row[:3] for row in coaxial.tables[0].rows[1:]] == [("1, 2", "0.000", "0.000")]
    assert coaxial.tables[0].rows[1][3] == "6"  # the larger of both


def test_tips_of_a_plate_leave_its_texts_free(sheets) -> None:
    """Phantom lines of the page against boxes of its texts and frames; each circle is whole but for these."""
    cut = 0
    for of in sheets.values():
        sheet = of["plate"]
        space = document_of(sheet).modelspace()
        lines = [shapely.LineString(each.get_points("xy")) for each in space.query("LWPOLYLINE[layer=='PHANTOM']")]
        rings = [shapely.Point(*each.dxf.center.vec2).buffer(each.dxf.radius, 512).exterior
                 for each in space.query("CIRCLE[layer=='PHANTOM']")]  # fmt: skip
        drawn = shapely.union_all([*lines, *rings])
        taken = [box for box, _ in [*boxes(space), *frame_boxes(sheet)]]
        assert max(drawn.intersection(box).length for box in taken) < 0.3
        cut += len(lines)
    assert cut > 2


def test_a_plate_without_a_tolerance_of_its_distances_says_none(tmp_path) -> None:
    text = TWO_STAGES.replace("[[train.stages]]", "[[train.stages]]\nf_a_um = 0.0", 2)
    plan = plan_gears(train_of(text, tmp_path / "train.toml"))
    plate = dict(sheets_of(plan, NOWHERE))[f"{plan.stem}_plate"]
    assert not frames(plate)
    assert not any("±" in note for note in plate.notes)


def test_flanks_bores_and_the_thread_in_a_hub_have_their_signs(sheets) -> None:
    """The leader of the flanks ends on one, at the pitch circle, where the tooth is half a pitch less its thinning."""
    pinion, rack = sheets["rack"]["1_pinion"], sheets["rack"]["2_rack"]
    face, section = pinion.views
    flank, bore = (symbol for symbol in face.symbols if isinstance(symbol, SurfaceTexture))
    assert (flank.value, bore.value) == ("Ra 0.8", "Ra 1.6")
    assert [np.hypot(*flank.tip), np.hypot(*bore.tip)] == pytest.approx([19 / 2, 5 / 2], abs=1e-3)
    of_middles = np.degrees(np.arctan2(*flank.tip[::-1])) % (360 / 19)  # a tooth stands on the x axis
    assert min(of_middles, 360 / 19 - of_middles) == pytest.approx(360 / 19 / 4, abs=0.35)
    (sign,) = (symbol for symbol in rack.views[0].symbols if isinstance(symbol, SurfaceTexture))
    assert (sign.tip[1], sign.bend) == (0.0, None)
    assert pinion.dimensions["set screw"] == 3.0
    assert pinion.dimensions["set screw height"] == 3.5
    thin = [each for each in section.curves if isinstance(each, Stroke) and each.line == LineKind.THIN]
    thread = [each.points[0][0] for each in thin if len(each.points) == 2]  # not the sign of a turned section
    assert thread == pytest.approx([8 + 3.5 - 1.5, 8 + 3.5 + 1.5])
    assert not any("tapped" in note for note in pinion.notes)
    texts = [text.dxf.text for text in document_of(pinion, "en").modelspace().query("TEXT")]
    assert texts.count("(") == 1  # after the texture of the title block: some surfaces have their own


@pytest.mark.parametrize("language", ["en", "zh"])
def test_texts_and_frames_of_gear_sheets_keep_off_each_other(sheets, language) -> None:
    for train, of_train in sheets.items():
        for stem, sheet in of_train.items():
            space = document_of(sheet, language).modelspace()
            assert apart([*boxes(space), *frame_boxes(sheet)]) == [], (train, stem)


def apart(found: list) -> list[tuple]:
    """Pairs of texts and frames that lie on each other; a frame holds texts of its own."""
    return [
        (a, b)
        for number, (one, a) in enumerate(found)
        for other, b in found[:number]
        if one.intersection(other).area > 0.02 * min(one.area, other.area)
        and not (isinstance(b, str) and isinstance(a, tuple) and b in a)
    ]


def frame_boxes(sheet: DrawingSheet) -> list:
    """Boxes of tolerance frames and datum letters on the paper, with the texts that stand in them."""
    found = []
    for view in sheet.views:
        for symbol in view.symbols:
            if isinstance(symbol, ToleranceFrame):
                x, y = np.array(view.place) + sheet.scale * np.array(symbol.bend)
                near = x + symbol.side * LEVEL
                left, right = sorted((near, near + symbol.side * sum(symbol.cells)))
                box = shapely.box(left, y - FRAME_HEIGHT / 2, right, y + FRAME_HEIGHT / 2)
                found.append((box, (symbol.zone_text, *symbol.datums)))
            elif isinstance(symbol, SurfaceTexture) and symbol.bend is not None:
                x, y = np.array(view.place) + sheet.scale * np.array(symbol.bend)
                side = 1 if symbol.bend[0] > symbol.tip[0] else -1
                left, right = sorted((x + side * LEVEL, x + side * (LEVEL + symbol.width)))
                found.append((shapely.box(left, y, right, y + 4.0), (symbol.value,)))
            elif isinstance(symbol, DatumFeature):
                way = np.array([np.cos(np.radians(symbol.angle)), np.sin(np.radians(symbol.angle))])
                x, y = np.array(view.place) + sheet.scale * np.array(symbol.foot) + symbol.reach * way
                half = FRAME_HEIGHT / 2
                found.append((shapely.box(x - half, y - half, x + half, y + half), (symbol.letter,)))
    return found


def test_pins_have_their_fits_in_carrier_and_planets(tmp_path) -> None:
    """ISO 286-2, over 3 up to 6 mm: P7 is -8 and -20 µm, F8 +28 and +10 µm."""
    fits = PLANETARY.replace("bore_diameter_mm = 4.0 }", 'bore_diameter_mm = 4.0, bore_fit = "F8/h6" }')
    plan = plan_gears(
        train_of(fits.replace("pin_place_um", 'pin_fit = "P7/h6"\npin_place_um'), tmp_path / "train.toml")
    )
    drawn = {stem.removeprefix(f"{plan.stem}_"): sheet for stem, sheet in sheets_of(plan, NOWHERE)}
    (hole,) = (each for view in drawn["2_carrier"].views for each in view.dimensions if each.name == "hole")
    assert (hole.prefix, hole.suffix) == ("3 × ", " P7")
    limits = [table for table in drawn["2_carrier"].tables if table.title == "limits, mm"]
    assert [table.rows for table in limits] == [(("Ø4 P7", "-0.008/-0.02"),)]
    (bore,) = (each for view in drawn["stage1_planet_1"].views for each in view.dimensions if each.name == "bore")
    assert bore.suffix == " F8"
    limits = [table for table in drawn["stage1_planet_1"].tables if table.title == "limits, mm"]
    assert [table.rows for table in limits] == [(("Ø4 F8", "+0.028/+0.01"),)]
    assert not any("not stated" in note for stem in ("stage1_planet_1",) for note in drawn[stem].notes)
    assert not any("Fit of the pins" in note for note in drawn["2_carrier"].notes)
    assert "train.stages.1.pin_fit" not in plan.making.open_keys(2).values()


def test_pins_without_fits_are_named_and_those_of_two_classes_refused(sheets, tmp_path) -> None:
    assert any("Fit of the pins: not stated" in note for note in sheets["planetary"]["2_carrier"].notes)
    place = tmp_path / "train.toml"
    open_keys = plan_gears(train_of(PLANETARY, place)).making.open_keys(2).values()
    assert {"train.stages.1.pin_fit", "train.stages.1.planet.bore_fit"} <= set(open_keys)
    two = PLANETARY.replace("bore_diameter_mm = 4.0 }", 'bore_diameter_mm = 4.0, bore_fit = "F8/h6" }')
    with pytest.raises(DesignError, match=r"pins of g6 and .* of h6"):
        train_of(two.replace("pin_place_um", 'pin_fit = "P7/g6"\npin_place_um'), place)
    with pytest.raises(DesignError, match="pin_fit needs the pins"):
        train_of(PLANETARY.replace(", bore_diameter_mm = 4.0 }", ' }\npin_fit = "P7/h6"'), place)


@pytest.mark.parametrize(
    ("carrier", "planets", "usual"),
    [("P7/h6", "P7/h6", "F8/h6"), ("H7/m6", "F8/m6", "E8/m6"), ("JS7/h6", "JS7/h6", "F8/h6")],
)
def test_planets_that_cannot_turn_are_refused_with_a_fit_that_lets_them(carrier, planets, usual, tmp_path) -> None:
    def design(carrier: str, planets: str) -> None:
        fits = PLANETARY.replace("bore_diameter_mm = 4.0 }", f'bore_diameter_mm = 4.0, bore_fit = "{planets}" }}')
        train_of(fits.replace("pin_place_um", f'pin_fit = "{carrier}"\npin_place_um'), tmp_path / "train.toml")

    with pytest.raises(DesignError, match="the planets then do not turn") as refused:
        design(carrier, planets)
    assert f'planet.bore_fit = "{usual}"' in str(refused.value)
    design(carrier, usual)
    design(usual, planets)  # pressed on pins that run in the carrier


@pytest.mark.slow
@pytest.mark.parametrize(("carrier", "told"), [("P7/h6", False), ("H7/h6", True)])
def test_pins_that_nothing_holds_are_told_on_the_sheet_of_their_carrier(carrier, told, tmp_path) -> None:
    fits = PLANETARY.replace("bore_diameter_mm = 4.0 }", 'bore_diameter_mm = 4.0, bore_fit = "F8/h6" }')
    fits = fits.replace("pin_place_um", f'pin_fit = "{carrier}"\npin_place_um')
    plan = plan_gears(train_of(fits, tmp_path / "train.toml"))
    drawn = {stem.removeprefix(f"{plan.stem}_"): sheet for stem, sheet in sheets_of(plan, NOWHERE)}
    assert [stem for stem, sheet in drawn.items() if any("hold them axially" in note for note in sheet.notes)] == (
        ["2_carrier"] if told else []
    )
