"""Pages of cams by their motion: both discs of a pair, and the arm of a swinging face beside its disc."""

from pathlib import Path

import numpy as np
import pytest
from shapely import LineString, Point, Polygon
from shapely.affinity import rotate

from cadgen import Design, Report
from cadgen.design.load import complete_of, read_design
from cadgen.viewer.page.html import html_of, pieces_of
from cadgen.viewer.page.page_plan import plan_motion_page
from cadgen.viewer.page.report import page_of
from tests.viewer.page.chromium import READY
from tests.viewer.page.english import left_in_english

SWINGING_FACE = """
name = "face"
motion = {{ turns = "clockwise", segments = [
    {{ to_deg = 12.0, in_deg = 100.0, law = "modified_sine" }}, {{ dwell_deg = 60.0 }},
    {{ to_deg = 0.0, in_deg = 120.0, law = "cycloidal" }}, {{ dwell_deg = 80.0 }},
] }}
follower = {{ kind = "swinging_flat", centre_distance_mm = 90.0, lifts = "{lifts}", face_offset_mm = {offset} }}
cam = {{ base_circle_radius_mm = 40.0, thickness_mm = 10.0 }}
"""


def page_of_design(text, name):
    """Page of a design by its motion."""
    return page_of(plan_motion_page(complete_of(text, Path(name))))


def test_the_rim_of_a_measured_cam_shows_where_it_differs_from_its_design(tmp_path):
    """Of an outline 50 um off the bore each place shows the share along its normal, found here by differences."""
    design = Design.load("roller")
    points = design.cam().computed.curve.outline(0.5).points[::2] + np.array([0.05, 0.0])
    rows = "".join(f"{x:.5f},{y:.5f}\n" for x, y in points * [1.0, -1.0])
    (tmp_path / "xy.csv").write_text(f"# seen on the outer face\nx [mm],y [mm]\n{rows}")
    report = Report.of(design, data=tmp_path / "xy.csv")
    page = page_of(report.computed)
    rim = page.scene.rim
    along = np.roll(rim.places, -1, axis=0) - np.roll(rim.places, 1, axis=0)
    assert rim.values == pytest.approx(50.0 * along[:, 1] / np.hypot(*along.T), abs=1.5)
    (section,) = [each for each in page.sections if each.code == "calibration"]
    assert section.tables[0].rows[0][0] == "eccentric bore"


def test_the_curves_say_what_the_triangles_over_them_mean():
    charts = str(pieces_of(page_of_design(*read_design("roller")))["charts"])
    assert "▲ peak of the lift, ▼ valley" in charts
    assert "▲ 升程的峰，▼ 谷" in charts
    assert "blend" not in charts  # a cam by its motion has none


def test_what_was_not_measured_on_a_cam_is_said_first_on_its_page():
    report = Report.of(Design.load("roller"), data=Path(__file__).parents[3] / "docs/tutorial/camera.csv")
    assert not report.passed
    assert report.refused
    assert page_of(report.computed).scene.rim is None


def test_both_discs_of_a_pair_touch_their_rollers_as_the_page_turns_them():
    """In the frame of the page, in which the discs turn and the lever swings; either roller is 9.5 mm from its rim."""
    page = page_of_design(*read_design("conjugate_pair"))
    scene = page.scene
    pair = ((scene.outline, scene.travel, scene.guide), (scene.second.outline, scene.second.travel, scene.second.arm))
    for outline, travel, arm in pair:
        points = outline @ [1, 1j]
        for place in range(0, len(travel.ahead), 240):
            theta = 2 * np.pi * place / (len(travel.ahead) - 1)
            centre = complex(*travel.centre) + travel.ahead[place] + 1j * travel.across[place]
            rim = points * np.exp(-1j * theta)
            closed = np.append(rim, rim[0])
            edge = LineString(np.column_stack([closed.real, closed.imag]))
            # Chords are half a millimetre long.
            assert edge.distance(Point(centre.real, centre.imag)) == pytest.approx(9.5, abs=2e-3)
            assert abs(centre - complex(*arm.pivot)) == pytest.approx(65.0, abs=1e-6)
    # The lever is one: both arms turn by the same angle about the same pivot.
    assert scene.guide.pivot == pytest.approx(scene.second.arm.pivot, abs=1e-6)
    codes = [part.code for part in scene.parts]
    assert codes == ["cam", "second-cam"]
    low, high = (part.mesh.vertices[:, 2] for part in scene.parts)
    assert low.max() < high.min()
    assert scene.shafts[0].high > high.max()
    sheets = {sheet.code: sheet for section in page.sections for sheet in section.tables}
    assert [str(row[0].text) for row in sheets["parts"].cells] == ["cam", "second cam"]
    assert {"cam-sizes", "second-cam-sizes"} <= set(sheets)
    assert left_in_english(html_of(page)) == []


@pytest.mark.parametrize(("offset", "lifts"), [(8.0, "against"), (-8.0, "with"), (0.0, "with")])
def test_the_arm_of_a_swinging_face_keeps_clear_of_the_disc(offset, lifts):
    """The bent arm, a bar of 5 mm, and the plate over the turn, on the disc that is turned under them."""
    scene = page_of_design(SWINGING_FACE.format(offset=offset, lifts=lifts), "face.toml").scene
    travel, arm = scene.travel, scene.guide
    pivot, middle = complex(*arm.pivot), complex(*travel.centre)
    line = np.array([arm.pivot, *arm.bends]) @ [1, 1j]
    disc = Polygon(scene.outline)
    for place in range(0, len(travel.ahead), 120):
        theta = np.degrees(2 * np.pi * place / (len(travel.ahead) - 1))
        way = travel.ahead[place] + 1j * travel.across[place]
        swung = pivot + (line - pivot) * np.exp(1j * np.angle((middle + way - pivot) / (middle - pivot)))
        bar = LineString(np.column_stack([swung.real, swung.imag])).buffer(2.5)
        under = rotate(disc, -theta, origin=(0.0, 0.0))
        assert bar.intersection(under).area < 0.5
        about = (scene.section @ [1, 1j] - middle) * np.exp(1j * travel.turned[place]) + middle + way
        assert Polygon(np.column_stack([about.real, about.imag])).intersection(under).area < 0.5


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 390])
def test_the_browser_turns_both_discs_and_both_arms(chromium, tmp_path, width):
    from playwright.sync_api import sync_playwright

    from tests.viewer.page.chromium import ARGUMENTS

    file = tmp_path / "page.html"
    file.write_text(html_of(page_of_design(*read_design("conjugate_pair"))), encoding="utf-8")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        page, said = browser.new_page(viewport={"width": width, "height": 844}, locale="en-GB"), []
        page.on("pageerror", lambda error: said.append(str(error)))
        page.goto(file.as_uri())
        page.wait_for_selector(READY, state="attached")
        page.evaluate(
            "() => { const angle = document.getElementById('angle');"
            " angle.value = 75; angle.dispatchEvent(new Event('input')); }"
        )
        page.wait_for_function("() => document.getElementById('disc-layer').style.transform === 'rotate(75deg)'")
        turned = [page.locator(f"#{name}-arm").get_attribute("transform") for name in ("follower", "second")]
        # The lever stands at its greatest swing, 3.528 degrees: both arms are turned by it about one pivot.
        angles = [float(each.removeprefix("rotate(").split()[0]) for each in turned]
        assert [abs(angle) for angle in angles] == pytest.approx([3.528, 3.528], abs=2e-3)
        assert angles[0] == pytest.approx(angles[1], abs=2e-3)
        assert page.locator(".second-edge").count() == 1
        assert page.evaluate("() => document.documentElement.scrollWidth") <= width
        assert said == []
        browser.close()
