"""The gear data table of a sheet: its order, its circles by other sources, and room for every cell."""

from math import cos, radians, sin, tan

import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from cadgen import Gear, GearPair
from cadgen.jobs.gears.assembly import gear_figures
from cadgen.messages import shown
from cadgen.output.drawing.gear_sheets import _TABLE, gear_rows
from cadgen.output.drawing.sheet import TEXT, wrapped


def test_form_circles_of_a_published_gear():
    """MESYS calculator: z 20, m 1, rack tip radius 0.25."""
    facts = Gear(teeth=20, module=1, width=8, rack_tip_radius=0.25).facts()
    assert facts["form_diameter_mm"] == pytest.approx(18.8003, abs=5e-5)
    assert facts["tip_form_diameter_mm"] == facts["tip_diameter_mm"] == 22.0
    assert facts["tooth_depth_mm"] == pytest.approx(2.25)


def test_base_and_reference_diameter_of_a_helical_gear():
    facts = Gear(teeth=30, module=2, width=10, helix_angle=radians(25), tip_chamfer=0.1).facts()
    reference = 60 / cos(radians(25))
    assert facts["reference_diameter_mm"] == pytest.approx(reference)
    # cos² α_t = cos² β / (cos² β + tan² α_n)
    assert facts["base_diameter_mm"] == pytest.approx(
        reference * cos(radians(25)) / (cos(radians(25)) ** 2 + tan(radians(20)) ** 2) ** 0.5
    )
    assert facts["tip_form_diameter_mm"] == pytest.approx(facts["tip_diameter_mm"] - 0.2)
    assert facts["lead_mm"] * sin(radians(25)) == pytest.approx(reference * 3.141592653589793 * cos(radians(25)))


@pytest.fixture(scope="module")
def tables():
    helix = {"module": 1, "width": 12, "helix_angle": radians(20)}
    pairs = {
        "helical": (Gear(teeth=20, **helix), Gear(teeth=60, hand="left", **helix)),
        "ring": (Gear(teeth=20, module=1, width=8), Gear(teeth=60, module=1, width=8, internal=True)),
    }
    found = {}
    for name, gears in pairs.items():
        train = GearPair(*gears, backlash=0.08).computed.layout
        stage = train.train.stages[0]
        figures = [next(iter(each.values())) for each in gear_figures(train)]
        found[name] = [gear_rows(gear, ("z = 120, 3_cluster",), stage, drives=n == 0) for n, gear in enumerate(figures)]
    return found


def test_order_of_the_table(tables):
    names = [name for name, _ in tables["helical"][1]]
    assert names == [
        "module m_n",
        "teeth z",
        "pressure angle",
        "h_aP, h_fP, rho_fP",
        "helix angle, hand",
        "lead",
        "reference diameter d",
        "profile shift x",
        "tooth depth h",
        "tip diameter",
        "root form diameter",
        "root diameter, as cut",
        "face width",
        "grade, ISO 1328-1:1995",
        "centre distance, mm",
        "meshes with",
        "thickness E_sns / E_sni",
        "teeth spanned k",
        "span W_k, mm",
        "ball diameter D_M",
        "over balls, mm",
        "contact + overlap ratio",
    ]
    assert dict(tables["helical"][1])["h_aP, h_fP, rho_fP"] == "1, 1.25, 0.38 × m"  # no heights in mm
    ring = dict(tables["ring"][1])
    assert ring["teeth z"] == "60, inside"
    assert ring["root"] == "pinion cutter, z0 25"
    assert ring["spaces spanned k"] == "7"


def test_every_cell_has_room(tables):
    font = FontProperties(family="DejaVu Sans")
    for rows, widths in ((tables["helical"][1], _TABLE[2]), (tables["ring"][1], _TABLE[1])):
        for cells in rows:
            for cell, column in zip(cells, widths[:2], strict=True):
                path = TextPath((0, 0), shown(cell), size=10, prop=font).get_extents()
                # The height of the sheets' letters is that of capitals, 0.73 of the size of this font.
                assert path.width / 7.3 * 0.85 * TEXT < column - 1.0, cell


def test_a_planet_meshes_with_two_and_no_shift_is_minus_nought():
    pair = GearPair(Gear(teeth=20, module=1, width=8), Gear(teeth=25, module=1, width=8), backlash=0.08)
    stage = pair.computed.layout.train.stages[0]
    figures = next(iter(gear_figures(pair.computed.layout)[0].values()))
    shift = figures["profile_shift"]
    figures["profile_shift"] = type(shift)(shift.code, shift.name, -1e-17)
    rows = dict(gear_rows(figures, ("z = 18, 1_pinion", "z = 72, stage1_ring"), stage, drives=True))
    assert (rows["meshes with"], rows["and with"]) == ("z = 18, 1_pinion", "z = 72, stage1_ring")
    assert rows["profile shift x"] == "0"


@pytest.mark.slow
def test_simplified_teeth_are_a_tip_circle_and_a_thin_root_circle(tmp_path):
    """ISO 2203, of outer gears, of a ring and of a rack; all else of the sheet is as with teeth that are cut."""
    from cadgen.design.load import load_train
    from cadgen.jobs.drawings import Folder, sheets_of
    from cadgen.jobs.gears.gear_train import plan_gears
    from cadgen.output.drawing.sheet import Closed, LineKind, Stroke

    ring = """[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0
[drawing]
teeth = "simplified"
[[train.stages]]
driver = { teeth = 20, helix_angle_deg = 0.0 }
"""
    kinds = {
        "ring": ring.replace(", helix_angle_deg = 0.0", "") + "driven = { teeth = 60, internal = true }\n",
        "rack": ring.replace("[[train.stages]]", '[[train.stages]]\nkind = "rack"').replace(
            "driver = { teeth = 20, helix_angle_deg = 0.0 }", "driver = { teeth = 20 }\nrack = { teeth = 12 }"
        ),
    }
    for kind, text in kinds.items():
        file = tmp_path / f"{kind}.toml"
        file.write_text(text)
        plans = [plan_gears(load_train(file, overrides)) for overrides in ([], ["drawing.teeth=as_cut"])]
        sheets = [dict(sheets_of(plan, Folder({}, "2026-01-01"))) for plan in plans]
        simple, cut = ([drawn for name, drawn in each.items() if "plate" not in name] for each in sheets)
        for drawn, whole in zip(simple, cut, strict=True):
            assert drawn.dimensions == whole.dimensions
            curves = drawn.views[0].curves
            corners = [
                sum(len(c.contour.bulges) for c in each.views[0].curves if isinstance(c, Closed))
                for each in (drawn, whole)
            ]
            assert corners[0] < corners[1] / 2
            thin = [c for c in curves if c.line is LineKind.THIN]
            if kind == "rack" and drawn is simple[-1]:
                assert any(isinstance(c, Stroke) and (c.points[:, 1] == c.points[0, 1]).all() for c in thin)
                continue
            (data,) = drawn.tables
            sizes = dict(data.rows)
            roots = [2 * float(c.contour.radii[0]) for c in thin if isinstance(c, Closed)]
            assert roots == [pytest.approx(float(sizes["root diameter, as cut"].split()[0]), abs=5e-4)]
            tips = [
                2 * float(c.contour.radii[0]) for c in curves if isinstance(c, Closed) and c.line is LineKind.VISIBLE
            ]
            assert any(abs(size - float(sizes["tip diameter"].split()[0])) < 5e-4 for size in tips)


def test_no_line_of_a_chinese_note_begins_with_a_mark_that_closes():
    note = "从动杆的弹簧：套在转轴（上方）的轴颈上，以 ± 0.0025 mm 的精度保持；此时前轮向右偏 0.12°。"
    for width in (20.0, 30.0, 41.0, 55.0):
        lines = wrapped(note, width)
        assert "".join(line.strip() for line in lines).replace(" ", "") == note.replace(" ", "")
        assert len(lines) > 1
        assert not any(line.strip()[0] in "，。；：、）°" or line.rstrip()[-1] in "（±" for line in lines)
