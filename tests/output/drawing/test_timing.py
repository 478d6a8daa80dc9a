"""Sheets of cams by their motion: timing diagram, segments, sense; and the groove, held against closed forms."""

import re
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from cadgen import Design, DesignError
from cadgen.jobs.drawings import Folder, sheet_of
from cadgen.laws.table import codes, law_of
from cadgen.messages import LANGUAGES, Message
from cadgen.output.drawing.sheet import TEXT, TITLE_SIZE, LineKind, SheetTable, Stroke, have_room
from cadgen.output.drawing.sheet_files import NoFontError, table_widths, text_length
from cadgen.output.drawing.timing import TimingDiagram
from tests.jobs.test_gear_sheets import apart, frame_boxes
from tests.jobs.test_packaged_cams import CAMS
from tests.output.drawing.table_cells import leaving


def sheets(name, tmp_path, changes=()):
    cam = Design.load(name, changes).cam()
    return [sheet_of(disc, Folder.at(tmp_path)) for disc in cam.computed.discs]


@pytest.mark.parametrize("code", codes())
def test_laws_have_chinese_names_without_english_words(code):
    name = Message(law_of(code).name)
    assert "_" not in name
    assert not re.search(r"[A-Za-z]{2}", name.translated("zh")), name


@pytest.mark.parametrize("name", ["flat", "valve_lobe", "conjugate_pair"])
def test_segments_of_a_chinese_sheet_are_chinese(name, tmp_path):
    for sheet in sheets(name, tmp_path):
        (table,) = [each for each in sheet.tables if str(each.title).startswith("segments")]
        for row in table.rows[1:]:
            assert re.search(r"[\u4e00-\u9fff]", row[-1].translated("zh")), row


def diagram(sheet):
    return sheet.views[-1]


def words(sheet):
    return [str(label.text) for view in sheet.views for label in view.labels]


@pytest.mark.parametrize("name", CAMS)
def test_each_packaged_cam_has_its_diagram_and_room_for_its_words(name, tmp_path):
    for sheet in sheets(name, tmp_path):
        assert have_room(sheet.notes, sheet.columns)
        assert words(sheet).count("0°") == 2  # on the face, and at the diagram
        assert "turns" in words(sheet)
        for label in diagram(sheet).labels:  # numbers of segments keep off the arrow of the datum
            if label.text[0].isdigit() and not label.text.endswith("°") and label.at[0] >= 0.0:
                over = label.at[1] * sheet.scale > TITLE_SIZE[1] - 18.0
                assert not over or label.at[0] * sheet.scale > 1.4
        # The diagram stays beside the title block and its notes, within the frame.
        points = np.vstack([each.points for each in diagram(sheet).curves]) * sheet.scale + diagram(sheet).place
        assert points.min() > 10.0
        right = min([column.at[0] for column in sheet.columns if column.at[1] < 60.0], default=240.0)
        assert points[:, 0].max() < right


def test_the_curve_of_the_diagram_is_the_lift(tmp_path):
    """A 3-4-5 polynomial by hand, on the paper's scale from the axes to the number at the greatest lift."""
    (sheet,) = sheets("roller", tmp_path)
    curve, *_ = diagram(sheet).curves
    x, y = (curve.points * sheet.scale).T
    angle, lift = 360 * x / x.max(), 10 * y / y.max()
    u = np.clip(angle / 90, 0, 1)
    rising = angle <= 90
    np.testing.assert_allclose(lift[rising], 10 * (10 * u**3 - 15 * u**4 + 6 * u**5)[rising], atol=1e-9)
    assert np.all(lift[(angle > 90) & (angle < 135)] == 10.0)
    (table,) = [each for each in sheet.tables if str(each.title) == "segments"]
    assert [tuple(map(str, row)) for row in table.rows[1:]] == [
        ("1", "0 – 90", "10", "polynomial 3-4-5"),
        ("2", "90 – 135", "10", "dwell"),
        ("3", "135 – 315", "0", "polynomial 3-4-5"),
        ("4", "315 – 360", "0", "dwell"),
    ]
    assert_cells_hold_their_texts(sheet)


def assert_cells_hold_their_texts(sheet):
    try:
        assert [leaving(sheet, language) for language in LANGUAGES] == [[], []]
    except NoFontError as error:
        pytest.skip(str(error))


def test_a_column_that_lacks_room_for_wide_letters_takes_what_the_others_spare():
    widths = (7.0, 27.0, 17.0, 40.0)
    table = SheetTable(title="", at=(0.0, 0.0), widths=widths, rows=(("", "0", "升程，mm", "1"),))
    lent = table_widths(table, str)
    assert sum(lent) == pytest.approx(sum(widths))
    assert lent[2] == pytest.approx(TEXT * text_length("升程，mm") + 1.5)
    assert all(one < other for one, other in zip(lent[:2], widths[:2], strict=True))
    for text in ("升" * 40, "W" * 7):  # no room in any, and Latin ones: the letters are smaller instead
        assert table_widths(replace(table, rows=((text,) * 4,)), str) == list(widths)


def test_both_discs_of_a_pair_show_the_motion_of_their_lever(tmp_path):
    first, second = sheets("conjugate_pair", tmp_path)
    one, other = (next(each.rows for each in sheet.tables if each.title == "segments") for sheet in (first, second))
    assert one == other
    assert "Second disc of a conjugate pair: key and angle 0 stand as on the first." in second.notes


def test_lobes_are_counted_and_the_first_is_listed():
    halves = {f"motion.segments.{n}.{key}": value for n, key, value in ((1, "in_deg", 45.0), (3, "in_deg", 90.0))}
    dwells = {f"motion.segments.{n}.dwell_deg": 22.5 for n in (2, 4)}
    changes = {"dynamics": None, "motion.repeat": 2} | halves | dwells
    drawn = TimingDiagram.of(Design.load("roller", changes).cam().computed.motion)
    assert (drawn.repeat, len(drawn.segments)) == (2, 8)
    table = drawn.table((0.0, 100.0))
    assert str(table.title) == "segments of the first of 2 lobes"
    assert len(table.rows) == 5


def test_the_arrow_of_the_sense_is_clockwise(tmp_path):
    """The disc turns clockwise on the face that is seen: its arrow goes round the axis with a negative moment."""
    (sheet,) = sheets("roller", tmp_path)
    arcs = [
        each.points
        for each in sheet.views[0].curves
        if isinstance(each, Stroke) and each.line == LineKind.THIN and len(each.points) == 25
    ]
    (arc,) = arcs
    (x, y), (along, up) = arc[:-1].T, np.diff(arc, axis=0).T
    assert np.all(x * up - y * along < 0)


def test_the_groove_has_both_flanks_width_depth_and_the_path_of_its_roller(tmp_path):
    """Harmonic motion of 2 inches: the path is 3 inches less an inch by the cosine of the cam angle."""
    (sheet,) = sheets("groove", tmp_path)
    assert sheet.dimensions["groove width"] == pytest.approx(19.1, abs=1e-6)
    assert sheet.dimensions["groove depth"] == pytest.approx(8.0)
    assert sheet.dimensions["outside"] == pytest.approx(237.0)
    path = max(
        (each for each in sheet.views[0].curves if isinstance(each, Stroke) and each.line == LineKind.CENTRE),
        key=lambda each: len(each.points),
    ).points
    angle = np.arctan2(path[:, 1], path[:, 0])
    np.testing.assert_allclose(np.hypot(*path.T), 25.4 * (3 - np.cos(angle)), atol=1e-3)
    rows = [row for table in sheet.tables[:2] for row in table.rows[1:]]
    assert len(rows) == 36
    # A path r = a - b cos θ has the radius r² / (a - 2b) where r is least, and r² / (a + 2b) at the greatest.
    assert [row[:3] for row in sheet.tables[2].rows[1:]] == [
        ("inner: least", "0", "41.250"),
        ("inner: greatest", "180", "92.050"),
        ("outer: least", "0", "60.350"),
        ("outer: greatest", "180", "111.150"),
    ]
    bends = [float(row[3]) for row in sheet.tables[2].rows[1:]]
    of_path = np.array([50.8**2 / 25.4, 101.6**2 / 127.0])
    assert bends == pytest.approx([*(of_path - 9.55), *(of_path + 9.55)], abs=0.06)
    # Titles stay over the tables, which end at the frame.
    assert all(0.79 * TEXT * len(table.title) < 93.0 for table in sheet.tables)
    lines = [each for each in sheet.views[0].dimensions if each.name in ("outside", "groove width")]
    turned = [each.angle % 180.0 for each in lines]
    assert 15.0 < abs(turned[0] - turned[1]) < 165.0  # the lines of both keep apart
    radii = {float(row[0]): (float(row[1]), float(row[2])) for row in rows}
    # Where the follower stands still, both flanks are at right angles to the ray.
    assert radii[0.0] == pytest.approx((50.8 - 9.55, 50.8 + 9.55), abs=1e-9)
    assert radii[180.0] == pytest.approx((3 * 25.4 + 25.4 - 9.55, 3 * 25.4 + 25.4 + 9.55), abs=1e-9)
    assert any("A cutter of 19.1 mm mills it in one round" in note for note in sheet.notes)
    cut = sheet.views[1].hatches
    areas = sum(_area(hatch.outside) for hatch in cut)
    # Section along the ray at 0 and 180 degrees: the disc less bore with keyway, less the groove twice.
    assert areas == pytest.approx(14 * (237 - 20 - 2.8) - 2 * 8 * 19.1, rel=1e-4)
    assert_cells_hold_their_texts(sheet)


def _area(corners):
    x, y = corners.T
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


@pytest.mark.parametrize("diameter", [160, 170, 180, 200, 237.5])
def test_the_words_below_a_groove_stay_over_the_title_block(tmp_path, diameter):
    """At 170 mm they stood in it: the dimension of the depth takes room below the section."""
    changes = {"follower.radius_mm": 4.0, "cam.base_circle_radius_mm": 20.0, "motion.segments.1.to_mm": 20.0}
    (sheet,) = sheets("groove", tmp_path, {**changes, "cam.outside_diameter_mm": diameter, "blank.keyway": None})
    for view in sheet.views[:2]:
        for label in view.labels:
            assert view.place[1] + sheet.scale * label.at[1] > 10.0 + sheet.title.height + 1.0, label.text


def test_a_motion_without_segments_has_its_curve_alone(tmp_path):
    (sheet,) = sheets("eccentric", tmp_path)
    assert not [table for table in sheet.tables if str(table.title).startswith("segments")]
    x, y = diagram(sheet).curves[0].points.T
    np.testing.assert_allclose(y / y.max(), (1 - np.cos(2 * pi * x / x.max())) / 2, atol=1e-9)


@pytest.mark.slow
def test_both_sheets_of_a_conjugate_pair_have_the_distance_of_the_discs(tmp_path):
    """The other disc stands dash-dotted beside this one, as far off as its key says, and as large as it is."""
    first, second = Design.load("conjugate_pair").cam().computed.discs
    assert first.application.design.follower.keys.second.gap_mm == 12.0
    for disc, other, side in ((first, second, -1), (second, first, 1)):
        section = sheet_of(disc, Folder.at(tmp_path), other).views[1]
        (gap,) = [each for each in section.dimensions if each.name == "gap between the discs"]
        (beside,) = [each for each in section.curves if getattr(each, "line", None) is LineKind.PHANTOM]
        near, far = sorted(beside.points[:2, 0], key=abs) if side < 0 else sorted(beside.points[:2, 0])
        face = disc.thickness if side > 0 else 0.0
        assert (gap.prefix, gap.suffix) == ("(", ")")  # it is not of this disc
        assert [gap.end[0] - gap.start[0], side * (near - face), side * (far - near)] == pytest.approx(
            [12.0, 12.0, 10.0]
        )
        assert beside.points[:, 1].max() == pytest.approx(
            other.curve.radius(np.linspace(0, 2 * pi, 3600)).max(), abs=1e-3
        )
    assert not any(each.name.startswith("gap") for each in sheets("conjugate_pair", tmp_path)[0].views[1].dimensions)


@pytest.mark.slow
def test_a_distance_of_discs_that_their_hub_needs_is_refused_and_a_missing_one_is_named():
    hub = {"blank.hub": {"side": "outer", "diameter_mm": 26.0, "length_mm": 15.0}}
    with pytest.raises(DesignError, match="gap_mm is 12; a hub of 15 mm stands between the discs: give 15 or more"):
        Design.load("conjugate_pair").with_(hub).cam()
    assert Design.load("conjugate_pair").with_(hub | {"follower.second.gap_mm": 15.0}).cam()
    plain = Design.load("conjugate_pair", ["follower.second.gap_mm="]).cam().computed
    missing = [key for key, value in plain.application.open_keys().values() if not value]
    assert missing == ["follower.second.gap_mm"]


def test_letters_of_bore_and_flat_keep_apart_and_a_wide_keyway_has_its_frame_at_its_arrow(tmp_path):
    flat = {"blank.keyway": None, "blank.d_flat": {"across_mm": 13.5}, "blank.bore_diameter_mm": 15.0}
    sheet = sheet_of(Design.load("swinging_roller").with_(flat).cam().computed, Folder.at(tmp_path))
    view = sheet.views[0]
    assert apart(frame_boxes(sheet)) == []
    (across,) = [each for each in view.dimensions if each.name == "across the flat"]
    line = sheet.scale * across.at[1] + view.place[1]
    assert all(box.bounds[1] > line + 1 for box, words in frame_boxes(sheet) if words == ("A",))
    (sheet,) = sheets("roller", tmp_path)
    (width,) = [each for each in sheet.views[0].dimensions if each.name == "keyway width"]
    (frame,) = [each for each in sheet.views[0].symbols if getattr(each, "name", "") == "keyway"]
    assert np.abs(np.array([width.start, width.end])[:, 1] - frame.tip[1]).min() == pytest.approx(0.0, abs=1e-9)
    assert apart(frame_boxes(sheet)) == []
