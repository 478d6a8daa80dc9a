"""Results in a notebook: each has a picture, a line, and its figures."""

from math import radians
from xml.etree import ElementTree

import numpy as np
import pytest

from cadgen import Cam, Design, Gear, GearPair, Motion, Roller, Spring, dwell, rise

PINION, WHEEL = (Gear(teeth=teeth, module=1.0, width=5.0) for teeth in (18, 45))


@pytest.fixture(scope="module")
def results():
    """Results of every kind that can be had in a second or two, by name."""
    design = Design.load("s_course")
    motion = Motion([rise(14, radians(80)), dwell(radians(50)), rise(-14, radians(110)), dwell(radians(120))])
    cam = Cam(motion, Roller(radius=9), base_circle_radius=32, thickness=10)
    comparison = design.optimize()
    return {
        "cam": cam,
        "steering cam": comparison.cam,
        "comparison": comparison,
        "simulation": design.simulate(),
        "tolerance": design.tolerance(50),
        "gear": PINION,
        "pair": GearPair(PINION, WHEEL, backlash=0.1),
    }


@pytest.mark.slow
@pytest.mark.parametrize("name", ["cam", "steering cam", "comparison", "simulation", "tolerance", "gear", "pair"])
def test_a_result_shows_itself_in_a_notebook(results, name):
    result = results[name]
    assert len(repr(result).splitlines()) == 1
    page = result._repr_html_()
    svg = ElementTree.fromstring(page[page.index("<svg") :])
    assert svg.tag.endswith("svg")
    assert page.count("<tr>") >= 3
    assert result.plot().axes


@pytest.mark.slow
def test_forces_over_the_turn_have_their_greatest_values_in_the_picture(results):
    forces = results["cam"].forces(rpm=300, mass=0.5, spring=Spring(rate=5, preload=50))
    upper, lower = forces.plot().axes
    assert np.max(upper.lines[0].get_ydata()) == pytest.approx(forces.normal.greatest, rel=1e-3)
    assert np.max(lower.lines[0].get_ydata()) == pytest.approx(forces.torque.greatest / 1000, rel=1e-3)


@pytest.mark.slow
def test_a_picture_of_gears_has_their_areas_and_no_tooth_in_another(results):
    """The sections by another library: shapely."""
    from shapely.geometry import Polygon

    from cadgen.output.report.gear_pictures import outlines

    parts = results["pair"].computed.layout.parts
    drawn = [Polygon(np.stack([found[0].real, found[0].imag], 1)) for part in parts for _, found in outlines(part)]
    assert drawn[0].intersection(drawn[1]).area < 1e-6
    assert drawn[0].distance(drawn[1]) < 0.1
    for gear, polygon in zip((PINION, WHEEL), drawn, strict=True):
        assert polygon.area * gear.width == pytest.approx(gear.volume, rel=0.02)  # thinned teeth
