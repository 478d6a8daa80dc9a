"""Sections: areas of simple bodies in closed form, and edges seen beyond the cut."""

import numpy as np
import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextToPath

from cadgen.curves.contour import circle, keyway_bore
from cadgen.output.drawing.placement import Room
from cadgen.output.drawing.section import Layer, edges_behind_cut, material
from cadgen.output.drawing.sheet import (
    ROW,
    TEXT,
    Closed,
    DiameterDimension,
    NoteColumn,
    chosen_scale,
    chosen_sheet,
    have_room,
    placed_notes,
    rounded,
    scale_text,
    width_of,
    wrapped,
)


def ring(diameter, centre=(0.0, 0.0)):
    return circle(centre, diameter / 2).polygon(1e-4)


def test_a_keyed_disc_with_a_hub():
    bore = keyway_bore(8.0, 3.0, 1.4, 0.0).polygon(1e-4)
    layers = [Layer(0.0, 3.0, (ring(60.0), bore)), Layer(3.0, 9.0, (ring(16.0), bore))]
    areas = material(layers, 0.0)
    # The section is of two pieces: towards the key the bore is 5.4 mm deep, away from it 4.
    expected = [3 * (30 - 5.4) + 6 * (8 - 5.4), 3 * (30 - 4.0) + 6 * (8 - 4.0)]
    assert sorted(area.area for area in areas) == pytest.approx(sorted(expected), abs=2e-3)


def test_a_hole_in_the_plane_and_a_recess():
    plain = material([Layer(0.0, 2.0, (ring(60.0), ring(10.0)), (ring(8.0, (20.0, 0.0)),))], 0.0)
    assert sum(area.area for area in plain) == pytest.approx(2 * (50 - 8), abs=2e-3)
    turned = material([Layer(0.0, 2.0, (ring(60.0), ring(10.0)), (ring(8.0, (20.0, 0.0)),))], np.pi / 2)
    assert sum(area.area for area in turned) == pytest.approx(2 * 50, abs=2e-3)
    recessed = material([Layer(0.0, 1.0, (ring(60.0), ring(50.0), ring(16.0), ring(10.0)))], 0.3)
    assert sum(area.area for area in recessed) == pytest.approx(10 + 6, abs=2e-3)


def test_edges_beyond_the_cut_bound_what_is_open():
    layers = [Layer(0.0, 2.0, (ring(60.0), ring(10.0)), (ring(8.0, (20.0, 0.0)),))]
    open_at = edges_behind_cut(layers, material(layers, 0.0))
    heights = sorted(float(np.ptp(stroke.points[:, 1])) for stroke in open_at)
    assert heights == pytest.approx([8.0, 10.0], abs=2e-3)


def test_sheets_and_numbers():
    assert chosen_scale((100.0, 50.0), (120.0, 120.0)) == 1.0
    assert chosen_scale((20.0, 10.0), (120.0, 120.0), greatest=2.0) == 2.0
    assert chosen_scale((1e6, 1.0), (120.0, 120.0)) is None
    assert chosen_sheet((90.0, 90.0), (100.0, 60.0), 1.0, 2.0) == ("A4", 1.0)
    assert chosen_sheet((150.0, 150.0), (150.0, 60.0), 1.0, 2.0) == ("A3", 1.0)
    assert [scale_text(scale) for scale in (5.0, 1.0, 0.5, 0.1)] == ["5:1", "1:1", "1:2", "1:10"]
    assert [rounded(number) for number in (8.0, 9.4, 39.69486, 0.0)] == ["8", "9.4", "39.695", "0"]
    lines = wrapped("a sentence that is far too long for the narrow column of a sheet", 50.0)
    assert len(lines) > 1
    assert lines[1].startswith("   ")


def test_notes_stay_in_their_column():
    """By the widths of the font itself, whose capitals are 0.729 of its size, also of a line full of figures."""
    letters = FontProperties(family="DejaVu Sans", size=TEXT / 0.729)
    note = "Axes 1 and 2: 45 ± 0.0195 mm, bearings 80 mm apart, as the play is reckoned: 1000 ± 0.0495 mm, 2000 mm."
    for width in (50.0, 62.0, 80.0, 120.0):
        for line in wrapped(note, width):
            assert TextToPath().get_text_width_height_descent(line, letters, False)[0] <= width


def test_a_note_in_chinese_is_broken_between_its_letters_and_not_in_its_words():
    note = "轴 1 与轴 2：45 ± 0.0195 mm，轴承相距 80 mm，侧隙即按此计算。" * 2
    lines = wrapped(note, 50.0)
    assert "".join(line.removeprefix("   ") for line in lines) == note
    assert all(TEXT * width_of(line) <= 50.0 for line in lines)
    assert sum("0.0195" in line for line in lines) == 2


def test_notes_flow_from_column_to_column_whole():
    columns = (
        NoteColumn(at=(10.0, 100.0), width=60.0, height=3 * ROW),
        NoteColumn(at=(5.0, 40.0), width=120.0, height=4 * ROW),
    )
    short, long = "One line.", "A sentence that takes two lines of the narrow column."
    assert len(wrapped(long, 60.0)) == 2
    lines = list(placed_notes([short, long, short, long], columns))
    assert [at[0] for _, at in lines] == [10.0] * 3 + [5.0] * 2  # the second column is wide enough for it in a line
    assert [at[1] for _, at in lines[:3]] == pytest.approx([100.0 - (n + 0.7) * ROW for n in range(3)])
    assert lines[3][1][1] == pytest.approx(40.0 - 0.7 * ROW)
    assert have_room([short] * 7, columns)
    assert not have_room([short] * 8, columns)


def test_a_sheet_is_as_large_as_its_notes_need():
    assert chosen_sheet((90.0, 90.0), (100.0, 60.0), 1.0, 2.0, lambda size: size != "A4") == ("A3", 2.0)


def test_a_diameter_is_written_where_its_line_crosses_no_edge():
    """Of a hole in a ring, the number lay across the rim beside it; here the rim leaves room on one side alone."""
    rim = [Closed(circle((0.0, 0.0), 50.0)), Closed(circle((-35.0, 0.0), 9.0))]
    hole = DiameterDimension(name="hole", centre=(-35.0, 0.0), diameter=18.0, angle=180.0, prefix="6 × ")
    (placed,) = Room(rim, 1.0).dimensions([hole], [])
    end = np.array([-35.0, 0.0]) + (placed.reach + 10.0) * np.array(
        [np.cos(np.radians(placed.angle)), np.sin(np.radians(placed.angle))]
    )
    assert np.hypot(*end) < 50.0
