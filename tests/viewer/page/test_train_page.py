"""Page of gears without a cam: they stay in mesh as the slider turns the output, and its figures are the command's."""

import re

import numpy as np
import pytest
from shapely import Polygon
from shapely.affinity import rotate, translate

from cadgen import Design, Report
from cadgen.viewer.page.html import html_of
from cadgen.viewer.page.report import page_of
from tests.viewer.page.chromium import ARGUMENTS, READY
from tests.viewer.page.english import left_in_english

TRAIN = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0

[[train.stages]]
driver = { teeth = 18 }
driven = { teeth = 40 }
"""
PLANETARY = """
[[train.stages]]
kind = "planetary"
sun = { teeth = 18 }
planet = { teeth = 27, count = 3, bore_diameter_mm = 5.0 }
"""


@pytest.fixture(scope="module")
def report():
    return Report.of(Design.from_toml(TRAIN, "small_train", train_only=True))


@pytest.fixture(scope="module")
def page(report):
    return page_of(report.computed)


def test_gears_push_on_each_other_as_the_page_turns_them(page):
    """By angle + rate phi of each shaft, as the script does: in touch, apart half of the play back, in each other on.

    Outlines are right to 0.03 mm, and the play of the first mesh is some 0.19 mm.
    """
    scene = page.scene
    wheels = {wheel.shaft: Polygon(wheel.outlines[0]) for wheel in scene.wheels}
    drive = scene.shafts[scene.drive]
    pinion, wheel = wheels[scene.drive], wheels[scene.drive - 1]
    assert abs(drive.rate) == pytest.approx(40 / 18)

    def common(phi, ahead):
        placed = []
        for index, body, more in ((scene.drive, pinion, ahead), (scene.drive - 1, wheel, 0.0)):
            shaft = scene.shafts[index]
            turn = shaft.angle + shaft.rate * phi + more * np.sign(shaft.rate)
            placed.append(translate(rotate(body, turn, origin=(0.0, 0.0), use_radians=True), *shaft.axis))
        return placed[0].intersection(placed[1]).area

    back = 0.095 / 9.0  # rad of the pinion
    for phi in np.linspace(0.0, 1.0, 6):
        assert common(phi, -back) == 0.0
        assert common(phi, 0.0) < 0.02
        assert common(phi, 2 * back) > 0.1
        assert common(phi, -4 * back) > 0.1


def test_its_figures_are_those_of_the_command_and_all_of_it_is_in_chinese(report, page):
    assert [section.code for section in page.sections] == ["checks", "play", "inspection", "parts"]
    gears = Design.from_toml(TRAIN, "small_train", train_only=True).gears()
    assert report.facts()["gears"]["return_error_deg"] == gears.facts()["return_error_deg"]
    assert report.passed == gears.passed
    text = html_of(page)
    assert "Gear train" in text
    assert 'href="#curves"' not in text
    assert re.search(r'id="curves"[^>]* hidden', text)
    assert left_in_english(text) == []


@pytest.mark.slow
@pytest.mark.long
def test_the_browser_turns_its_gears_and_planets_go_round(chromium, tmp_path):
    from playwright.sync_api import sync_playwright

    page = page_of(Report.of(Design.from_toml(TRAIN + PLANETARY, "small_train", train_only=True)).computed)
    planet = next(index for index, shaft in enumerate(page.scene.shafts) if shaft.round is not None)
    x, y = page.scene.shafts[planet].axis
    (tmp_path / "page.html").write_text(html_of(page), encoding="utf-8")
    drive = page.scene.shafts[page.scene.drive]
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        tab = browser.new_page()
        faults = []
        tab.on("pageerror", lambda error: faults.append(str(error)))
        tab.goto(f"file://{tmp_path / 'page.html'}")
        tab.wait_for_selector(READY)
        tab.locator("#angle").fill("90")
        turned = tab.locator(f"#wheel-{page.scene.drive}").get_attribute("transform")
        carried = tab.locator(f"#wheel-{planet}").get_attribute("transform")
        shown = tab.locator("#now .drive b").text_content()
        browser.close()
    assert faults == []
    angle = float(re.search(r"rotate\(([-\d.]+)\)", turned)[1])
    assert angle == pytest.approx(np.degrees(drive.angle + drive.rate * np.pi / 2), abs=2e-3)
    assert shown == "-1000.00°"  # a pair turns the sense round
    place = [float(each) for each in re.search(r"translate\(([-\d.]+) ([-\d.]+)\)", carried).groups()]
    assert place == pytest.approx([y, -x], abs=2e-3)  # a quarter turn with the carrier, which is the output
