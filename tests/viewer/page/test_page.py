"""The page without a browser: its numbers, its policy, and that what it draws touches where it must."""

import base64
import hashlib
import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest

from cadgen import Design, Report, verify
from cadgen.cam.contact import roll_curve
from cadgen.car.assembly.turning_train import height_beside, turned_to_axle, turning_train
from cadgen.check import CheckCode
from cadgen.design.load import load_design
from cadgen.figures import Cell, Sheet, number
from cadgen.geometry.meshes.mesh import Mesh
from cadgen.geometry.meshes.teeth import measured_pair
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.kernel import volume
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.viewer.page.car_page import plan_page
from cadgen.viewer.page.document import FloorKind, FloorShape, Travel
from cadgen.viewer.page.html import html_of, table_html
from cadgen.viewer.page.mesh_block import shaded
from cadgen.viewer.page.plan_views import course_view, rim_view
from cadgen.viewer.page.report import page_of
from cadgen.viewer.page.scene import pivot_of, section_of, travel_of
from cadgen.viewer.page.sections import parts_sections, tolerance_section
from tests.cam.test_roller import SquareFace
from tests.viewer.page.english import left_in_english
from tests.viewer.page.reading import Tables, at, data, going

POSITIONS = np.linspace(0.0, 2 * np.pi, 12, endpoint=False) + 0.05
TOUCH = 2e-3  # mm


def test_a_cube_is_shaded_face_by_face():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    cube = shaded(Mesh(corners, triangles))
    assert len(cube.vertices) == 24
    assert len(cube.edges) == 12
    assert np.allclose(np.abs(cube.normals).max(axis=1), 1.0)


def test_a_round_wall_is_smooth_and_its_rims_are_edges():
    count = 48
    ring = np.exp(2j * np.pi * np.arange(count) / count)
    corners = np.concatenate([np.column_stack([ring.real, ring.imag, np.full(count, z)]) for z in (0.0, 1.0)])
    low = np.arange(count)
    following = np.roll(low, -1)
    walls = [(a, b, b + count) for a, b in zip(low, following, strict=True)]
    walls += [(a, b + count, a + count) for a, b in zip(low, following, strict=True)]
    caps = [(0, b, a) for a, b in zip(low[1:-1], following[1:-1], strict=True)]
    caps += [(count, a + count, b + count) for a, b in zip(low[1:-1], following[1:-1], strict=True)]
    drum = shaded(Mesh(corners, np.array(walls + caps)))
    assert len(drum.edges) == 2 * count
    wall = np.abs(drum.normals[:, 2]) < 0.5
    assert wall.sum() == 2 * count
    assert np.einsum("ij,ij->i", drum.normals[wall][:, :2], drum.vertices[wall][:, :2]) == pytest.approx(1.0, abs=0.01)


def test_text_of_a_design_is_no_markup():
    cells = (Cell("<script>", 1.5), number(0.1, "mm"), 'a"<b')
    text = table_html(Sheet('c"<', "t<", ("h<", "", 'i"<'), (cells,), words=0))
    assert "<script" not in text
    assert text.count("<") == text.count(">")
    assert 'id="table-c&#34;&lt;"' in text
    assert 'data-value="0.1"' in text
    assert number(float("inf")).text == "–"


@pytest.mark.slow
def test_numbers_on_the_page_are_those_of_the_manifest(plan, html):
    tables, facts = Tables(html), plan.figures().json()
    checked = 0
    for name, given in (("cam-checks", facts["cam"]["checks"]), ("gear-checks", facts["gears"]["checks"])):
        wanted = [
            [float(check["value"])] + ([] if check["limit"] is None else [float(check["limit"])]) for check in given
        ]
        assert tables.numbers(name) == wanted
        checked += len(wanted)
    methods = facts["cam"]["play"]["compared"]
    for row, method in zip(tables.numbers("methods"), methods, strict=True):
        heading, position, *_, worst, lift, without = row
        assert heading == method["end_heading_deg"]
        assert position == method["end_position_mm"]
        assert worst == method["worst_end_position_mm"]
        assert lift == method["lift_error_um"]
        assert without == method["end_position_without_play_mm"]
    simulated = facts["simulation"]
    assert tables.numbers("runs") == [
        [simulated[run][key] for key in ("end_heading_deg", "end_position_mm", "greatest_position_mm")]
        for run in ("before", "after", "after_without_play")
    ]
    assert [row[2] for row in tables.numbers("events")] == [event["deflection_deg"] for event in simulated["events"]]
    assert tables.numbers("ends")[0] == [*facts["tolerance"]["end_position_mm"].values()]
    gears = [gear for part in facts["gears"]["parts"] for gear in part["gears"]]
    assert [row[2:4] for row in tables.numbers("gear-sizes")] == [
        [gear["span_min_mm"], gear["span_max_mm"]] for gear in gears
    ]
    print(f"{checked} checks, {len(methods)} methods, {len(gears)} gears")


@pytest.mark.slow
def test_limits_across_a_curve_are_those_of_the_checks(plan, page):
    """In the unit of the curve, whose greatest values are those that the checks found."""
    (chart,) = [chart for chart in page.charts if chart.code == "pressure"]
    checks = {check.code: check for check in plan.cam.checks}
    rise, fall = checks[CheckCode.PRESSURE_ANGLE_RISE], checks[CheckCode.PRESSURE_ANGLE_RETURN]
    assert [limit.value for limit in chart.limits] == pytest.approx([rise.limit, -fall.limit], rel=1e-12)
    assert chart.unit == rise.unit == "°"
    assert max(abs(chart.curves[0].values)) == pytest.approx(max(rise.value, fall.value), abs=0.05)


@pytest.mark.slow
def test_the_page_allows_only_its_own_parts_and_asks_for_nothing(html):
    assert len(html.encode()) <= 2_000_000
    print(f"{len(html.encode()) / 1e6:.3f} MB")
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', html)[1].replace("&#39;", "'")
    assert policy.startswith("default-src 'none'")
    assert "unsafe" not in policy
    for pattern in (r"<style>(.*?)</style>", r"<script>(.*?)</script>"):
        (inline,) = re.findall(pattern, html, re.DOTALL)
        assert base64.b64encode(hashlib.sha256(inline.encode()).digest()).decode() in policy
    markup = re.sub(r"<(script|style|pre)\b.*?</\1>", "", html, flags=re.DOTALL)
    assert not re.search(r'(src|href|action|poster)="(?!#)', markup)
    assert " style=" not in markup
    assert not re.search(r"\son\w+=", markup)


@pytest.mark.slow
def test_headings_and_captions_stand_in_both_languages(html):
    markup = re.sub(r"<(script|style)\b.*?</\1>", "", html, flags=re.DOTALL)
    for name in ("h2", "caption", "dt", "figcaption"):
        for attributes in re.findall(rf"<{name}\b([^>]*)>(?!<)", markup):
            assert "data-zh" in attributes, (name, attributes)
    for attributes, words in re.findall(r"<th\b([^>]*)>(.*?)</th>", markup):
        assert "data-zh" in attributes or re.fullmatch(r"[\d.]+ %", words), words


@pytest.mark.slow
def test_the_follower_touches_the_exact_cam_wherever_the_slider_stands(plan, html):
    document = data(html)
    worst = 0.0
    for code in ("free", "played"):
        states = [at(document, going(document, code), motor) for motor in POSITIONS]
        theta = np.array([state[0] for state in states]) % (2 * np.pi)
        contact, _ = roll_curve(plan.cam.curve, plan.cam.follower, theta)
        worst = max(worst, float(np.abs(contact.lift - [state[2] for state in states]).max()))
    print(f"gap or overlap at the cam: {1e3 * worst:.3f} um")
    assert worst <= TOUCH


@pytest.mark.slow
def test_teeth_touch_on_the_flanks_that_carry(plan, html):
    document, layout = data(html), plan.gears.layout
    shafts = document["scene"]["shafts"][1:][::-1]  # from the drive to the output
    ratios = [float(stage.ratio) for stage in layout.train.stages]
    assert [shaft["rate"] for shaft in shafts] == [45.0, -9.0, 3.0, -1.0]
    worst, carried = 0.0, 0
    for code in ("free", "played"):
        for motor in POSITIONS:
            *_, share = at(document, going(document, code), motor)
            angles = [shaft["angle"] + shaft["rate"] * motor + shaft["lead"] * share for shaft in shafts]
            for place, stage in enumerate(layout.train.stages):
                pair, (x0, y0), (x1, y1) = measured_pair(stage), shafts[place]["axis"], shafts[place + 1]["axis"]
                towards = np.arctan2(y1 - y0, x1 - x0)
                assert np.hypot(x1 - x0, y1 - y0) == pytest.approx(stage.centre_distance, abs=1e-9)
                driver, driven = angles[place] - towards, angles[place + 1] - towards
                pitch = 2 * np.pi / pair.driven.teeth
                middle = pair.middle(driver)
                driven = middle + (driven - middle + pitch / 2) % pitch - pitch / 2
                # The flank in the sense opposite to the driven wheel's carries as long as the gears push.
                sense = -np.sign(shafts[place + 1]["rate"]) * (1 if share < 0.5 else -1)
                gap = abs(pair.limit(driver, int(sense)) - driven) * pair.driven_pitch_radius
                if share in (0.0, 1.0) or share < 1e-6 or share > 1 - 1e-4:
                    worst, carried = max(worst, gap), carried + 1
                else:
                    assert pair.limit(driver, -1) <= driven <= pair.limit(driver, 1)
    print(f"gap or overlap at the teeth: {1e3 * worst:.3f} um, {carried} contacts, ratios {ratios}")
    assert carried > 40
    assert worst <= TOUCH


@pytest.mark.slow
def test_the_mesh_shown_touches_the_rod_within_its_chord(page, html):
    document = data(html)
    part = next(part for part in document["scene"]["parts"] if part["code"] == "cam")
    mesh, rod = part["mesh"], document["scene"]["rod"]
    places = np.array(mesh["low"]) + np.array(mesh["step"]) * mesh["vertices"].reshape(-1, 3)
    triangles = sum(len(part["mesh"]["triangles"]) for part in document["scene"]["parts"]) // 3
    assert triangles <= 150_000
    edges = mesh["edges"].reshape(-1, 2)
    worst = 0.0
    for motor in POSITIONS:
        theta, tan_beta, _, _ = at(document, going(document, "played"), motor)
        room = np.inf
        for height, face in zip((0.0, rod["faces"][1] - rod["faces"][0]), rod["faces"], strict=True):
            ends = places[edges]
            ends = ends[(np.abs(ends[..., 2] - height) < 1e-3).all(axis=1)][..., :2] @ [1, 1j]
            rim = ends[(np.abs(ends) > 50).all(axis=1)] * np.exp(-1j * theta)
            rim = rim[(np.abs(rim.imag) < 8).all(axis=1) & (rim.real > 0).all(axis=1)]
            points = (rim[:, :1] + (rim[:, 1:] - rim[:, :1]) * np.linspace(0, 1, 200)).ravel()
            points = points[np.abs(points.imag) < rod["radius"]]
            half = np.sqrt(rod["radius"] ** 2 - points.imag**2) * np.hypot(1, tan_beta)
            room = min(room, float((document["scene"]["base"] + face * tan_beta - half - points.real).min()))
        worst = max(worst, abs(room))
    print(f"{triangles} triangles; gap or overlap of the mesh shown: {1e3 * worst:.1f} um")
    assert worst <= 0.03


@pytest.mark.slow
def test_the_train_meshes_wherever_it_is_set(plan):
    layout = plan.gears.layout
    for behind in (20.0, 60.0, 200.0):
        train = turning_train(layout, turned_to_axle(layout, behind), height_beside(layout, -2.0, 1))
        drive = train.parts[0].axis
        assert abs(drive) == pytest.approx(abs(layout.parts[0].axis - layout.parts[-1].axis))
        assert drive.real == pytest.approx(-min(behind, abs(drive)))
        assert max(part.range[1] for part in train.parts) == pytest.approx(-2.0)
        assert train.parts[-1].angle == pytest.approx(0.0)


HUB = ["blank.hub={diameter_mm=22,length_mm=9,set_screw={hole_diameter_mm=4,height_mm=4.5}}"]


@pytest.mark.slow
@pytest.mark.parametrize("features", [[], HUB, ["blank.lightening=", "blank.material=steel"]])
@pytest.mark.parametrize("leg", [0.0, 0.4])
def test_the_volume_on_the_page_is_the_kernels(features, leg):
    cam = plan_cam(load_design("workshop_car", [f"blank.edge_break_mm={leg}", *features]), "actual", judged=False)
    part = cam_part(cam.curve, cam.made_blank, cam.thickness, name="cam", description="test")
    exact = volume(part.solid)
    assert cam.volume == pytest.approx(exact, rel=1e-5)
    (sheet,) = parts_sections(cam, None)[1].tables
    row = {head: cell.value for head, cell in zip(sheet.heads, sheet.cells[0], strict=True)}
    assert row["volume"] == pytest.approx(exact * 1e-3, rel=1e-3)
    assert row["mass"] == pytest.approx(exact * 1e-3 * (7.85 if "blank.material=steel" in features else 2.70), rel=1e-3)
    assert "teeth" not in row
    assert "module" not in row


def test_a_part_of_no_known_material_has_no_column_of_its_mass():
    cam = plan_cam(load_design("workshop_car", ["blank.material="]), "actual", judged=False)
    assert cam.mass is None
    (sheet,) = parts_sections(cam, None)[1].tables
    assert "mass" not in sheet.heads


@pytest.mark.parametrize(
    ("features", "words"),
    [
        ([], "Cam angle 0 is at the middle of the keyway, on the X axis"),
        (["blank.keyway.angle_deg=30"], "and the middle of the keyway at 30°, counterclockwise"),
        (["blank.keyway=", "blank.d_flat={across_mm=7}"], "Cam angle 0 is at the middle of the flat"),
        (["blank.keyway=", *HUB], "Cam angle 0 is at the set screw"),
        (["blank.keyway=", "blank.mark={diameter_mm=3,radius_mm=14,angle_deg=200}"], "the mark at 200°"),
        (["blank.keyway="], "The bore is plain: cam angle 0 is the X axis"),
    ],
)
def test_cam_angle_0_is_named_by_what_the_bore_has(features, words):
    changes = ["blank.mark=", *features]
    cam = plan_cam(load_design("workshop_car", changes), "actual", judged=False)
    (sentence,) = [line for line in parts_sections(cam, None)[0].lead if "angle 0" in line]
    assert words in sentence


@pytest.mark.slow
def test_the_cars_that_keep_the_course_are_those_of_the_verdict(plan):
    """One number on the page, that of `cadgen check`, whatever sample the tolerance run has."""
    (check,) = [check for check in plan.cam.verdict.checks if check.code == CheckCode.CARS_KEEP_COURSE]
    tiles = dict(plan.summary())
    assert tiles["cars that keep the course"].value == check.value
    assert "cars that pass" not in tiles
    assert plan.tolerance.samples == 60
    assert not [line for line in tolerance_section(plan.tolerance, "").lead if "%" in line]


PACKAGED = ("workshop_car", "appendix_car", "figure_eight", "s_course", "posts_and_walls")


@pytest.mark.slow
def test_no_sentence_stays_english_in_the_chinese_view(html, failing):
    assert left_in_english(html) == []
    assert left_in_english(failing[1]) == ["mine"]  # the design's name


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", PACKAGED)
def test_the_page_of_a_packaged_design_is_small_and_whole_in_chinese(name):
    page = page_of(plan_page(load_design(name), samples=20))
    html = html_of(page)
    assert left_in_english(html) == []
    assert len(html.encode()) <= 2e6
    assert all(0 <= mark.angle <= 2 * np.pi for mark in page.marks)  # a lap has no blend to mark


UNDERCUT = ["motion.segments.1.in_deg=40", "motion.segments.2.dwell_deg=90", "follower.radius_mm=30"]


@pytest.mark.slow
@pytest.mark.parametrize("changes", [[], UNDERCUT], ids=["as given", "with lift lost"])
def test_the_roller_of_a_motion_touches_the_disc_wherever_the_slider_stands(feeder, changes):
    """Distance of the roller's centre from the cut curve, turned to the cam angle, is the roller's radius."""
    plan = feeder(changes)
    scene = data(html_of(page_of(plan)))["scene"]
    assert bool(plan.cam.trims) == bool(changes)
    outline, radius, travel = plan.cam.curve.outline(0.01).points @ [1, 1j], plan.cam.follower.radius, scene["travel"]
    theta = np.linspace(0.0, 2 * np.pi, len(travel["ahead"]))
    off = []
    for place in range(0, len(theta), 97):
        way = travel["ahead"][place] + 1j * travel["across"][place]
        centre = (complex(*travel["centre"]) + way) * np.exp(1j * theta[place])
        off.append(np.abs(outline - centre).min() - radius)
    print(f"gap or overlap at the roller: {1e3 * np.abs(off).max():.2f} um")
    assert np.abs(off).max() < TOUCH
    assert np.ptp(travel["across"]) == 0
    assert np.ptp(travel["ahead"]) == pytest.approx(14.0, abs=2.0 if changes else 1e-4)


@pytest.mark.slow
def test_the_page_of_a_motion_has_what_moves_and_nothing_of_a_car(feeder):
    plan = feeder()
    page = page_of(plan)
    html = html_of(page)
    scene = data(html)["scene"]
    assert (scene["car"], scene["goings"], scene["unit"], scene["arm"]) == (None, [], "mm", None)
    assert [part["code"] for part in scene["parts"]] == ["cam"]
    assert 'id="course-figure"' not in html
    # The slide's guide stands beyond the roller at its farthest, and the stem within it at its nearest.
    slide, travel = page.scene.guide, page.scene.travel
    assert slide.across == travel.centre[1] == pytest.approx(8.0)
    assert slide.rails[0] > page.scene.section[:, 0].max() + travel.ahead.max()
    assert slide.stem + travel.ahead.min() > slide.rails[1]
    assert [cell.value for name, cell in page.summary if name == "travel of the follower"] == [pytest.approx(14.0)]
    # What is what is said below the picture, and curves have ticks where scripts are off.
    legend = unescape(html[html.index('id="cam-legend"') : html.index('id="notes"')])
    assert all(words in legend for words in ("roller", "guide of the slide", "mark of cam angle 0", "outer face"))
    assert html.count("<noscript><svg") == len(page.charts) == 6
    assert all(f">{place}°</text>" in html for place in (0, 60, 360))


def test_a_swinging_follower_has_its_pivot_and_a_straight_way_none():
    """The middle of the section goes 20 degrees to and fro on an arc of 50 mm about (30, 40)."""
    swing = np.radians(20) * (1 - np.cos(np.linspace(0, 2 * np.pi, 721))) / 2
    way = 50 * np.exp(1j * (swing - 1.0))
    ways = Travel((30 + way[0].real, 40 + way[0].imag), (way - way[0]).real, (way - way[0]).imag, swing)
    assert pivot_of(ways) == pytest.approx(30.0 + 40.0j, abs=1e-9)
    still = np.zeros(721)
    assert pivot_of(Travel((41.0, 0.0), still, still, still)) is None
    assert pivot_of(Travel((41.0, 0.0), 3 * swing, 2 * swing, still)) is None
    wavy = Travel((41.0, 0.0), swing, np.sin(9 * swing), still)
    assert pivot_of(wavy) is None


def test_a_flat_face_is_drawn_as_a_plate_that_turns_with_its_arm(feeder):
    cam = feeder().cam
    face = replace(cam, follower_as_built=SquareFace(base=30.0, radius=4.0))
    section = section_of(face, 2.0)
    assert section[0] == pytest.approx(section[-1])
    assert section[:, 0].min() == pytest.approx(32.0)
    assert np.ptp(section, axis=0) == pytest.approx([4.0, 8.0])
    assert travel_of(face, np.array([0.0, 2.0])).ahead == pytest.approx([0.0, 2.0])


@pytest.mark.slow
@pytest.mark.parametrize(
    "changes", [[], ["checks.min_convex_radius_mm=100", "machining.cutter_diameter_mm=90", "checks.min_wall_mm=60"]]
)
def test_the_page_of_a_motion_is_whole_in_chinese(feeder, changes):
    html = html_of(page_of(feeder(changes)))
    assert ('id="failures"' in html) == bool(changes)
    assert left_in_english(html) == ["feeder"]  # the design's name


@pytest.mark.long
@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("workshop_car", ["course.judged=play", "course.margin_mm=200", "checks.min_wall_mm=30"]),
        ("carbon_free_car", ["cam.base_radius_mm=30", "machining.cutter_diameter_mm=80"]),
    ],
)
def test_what_fails_is_said_in_chinese(name, changes):
    page = page_of(plan_page(load_design(name, changes), samples=5))
    assert len(page.failures) >= 2
    assert left_in_english(html_of(page)) == []


def test_english_words_are_found_in_either_language():
    html = '<p>ask a friend</p><p data-zh="问朋友">ask a friend</p><p data-zh="问朋友 please">ask a friend</p>'
    assert left_in_english(html) == ["ask a friend", "问朋友 please"]


@pytest.mark.slow
def test_a_measurement_that_is_missing_is_said_and_the_rest_is_there(minimal, written, tmp_path):
    design = Design.load(written(minimal))
    report = Report.of(design, "actual", data=tmp_path / "nothing.csv", samples=5)
    assert not report.passed
    (reason,) = report.refused
    assert "nothing.csv" in reason
    text = html_of(page_of(report.computed))
    assert unescape(text).count(reason) >= 2  # on top, and where the calibration would stand
    assert 'id="table-cam-checks"' in text


@pytest.mark.slow
def test_what_fails_comes_first(failing):
    plan, text = failing
    assert not plan.passed
    assert text.index('id="failures"') < text.index('id="model"') < text.index('id="checks"')
    assert "convex radius, profile" in text[text.index('id="failures"') : text.index('id="model"')]


@pytest.mark.slow
def test_a_design_without_gears_has_a_page(minimal, written):
    plan = plan_page(load_design(written(minimal)))
    text = html_of(page_of(plan))
    assert plan.gears is None
    assert plan.simulation is None
    document = data(text)
    assert [run["code"] for run in document["scene"]["goings"]] == ["free"]
    assert [part["code"] for part in document["scene"]["parts"]] == ["cam"]


@pytest.mark.slow
def test_what_costs_most_stands_on_top_and_its_picture_has_the_shares_of_the_table(plan, page, html):
    dearest = plan.tolerance.sensitivities[0]
    assert any(cell.text == dearest.name.replace("_", " ") for _, cell in page.summary)
    (section,) = (each for each in page.sections if each.code == "tolerance")
    (bars,) = section.bars
    assert sum(bar.value for bar in bars.rows) == pytest.approx(100.0)
    assert bars.rows[0].value == pytest.approx(100 * dearest.share)
    assert len(bars.rows) < len(plan.tolerance.sensitivities)
    assert section.folded == {"sensitivities"}
    assert '<details class="more"><summary>' in html


@pytest.mark.slow
def test_the_rim_shows_what_the_profile_takes_off_against_play(plan, page):
    """By another way: both outlines as polygons, whose areas differ as the deviations along the rim say."""
    from shapely.geometry import Polygon

    rim = page.scene.rim
    comparison = plan.use.comparison
    cut, plain = (Polygon(each.outline(0.05).points) for each in (plan.cam.curve, comparison.before.cut))
    radius = np.hypot(*rim.places.T)
    turned = np.pi * np.mean(radius**2 - (radius - 1e-3 * rim.values) ** 2)
    assert turned == pytest.approx(cut.area - plain.area, rel=0.02)
    drawn = dict(rim_view(rim))
    assert set(drawn) <= set(range(9))
    assert sum(path.count("M") for path in drawn.values()) == len(rim.places)


@pytest.mark.slow
def test_a_measured_profile_is_shown_on_the_rim_in_place_of_that():
    record = Path(__file__).parents[2] / "data/measured/profile_a.csv"
    page = page_of(Report.of(Design.load("carbon_free_car"), "actual", data=record, samples=20).computed)
    assert page.scene.rim.label == "measured, less the design"
    assert 1.0 < np.abs(page.scene.rim.values).max() < 1000.0


def test_a_broad_course_has_a_row_of_its_own():
    corners = {8: ((0.0, 0.0), (8000.0, 0.0), (8000.0, 1000.0), (0.0, 1000.0)), 0: ((0.0, 0.0), (900.0, 900.0))}
    broad = [course_view([FloorShape(FloorKind.EDGE, points)]).broad for points in corners.values()]
    assert broad == [6, 0]


@pytest.mark.slow
def test_files_of_the_design_beside_the_page_are_linked(tmp_path):
    design = Design.load("roller")
    design.cam().write(tmp_path, formats=["csv", "xyz"])
    Design.load("flat").cam().write(tmp_path, formats=["csv"])
    (page,) = Report.of(design).write(tmp_path)
    links = re.findall(r'<a href="([^"#]+)" download>', page.path.read_text(encoding="utf-8"))
    assert sorted(links) == ["roller_actual.csv", "roller_actual.xyz"]
    assert verify(tmp_path).is_true
