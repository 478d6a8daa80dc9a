"""Each check of a gear train fails on what it is there for."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.check import Bound, Check, CheckCode
from cadgen.design.load import load_design
from cadgen.gears.stage import PLAY_LIMIT_UM, cycle
from cadgen.geometry.meshes.made_train import _bodies, _worst, meshes, play_error_um, return_error_um
from cadgen.geometry.meshes.teeth import LEAST_OVERLAP, MeasuredPair, ToothSection, section_of
from cadgen.jobs.gears.gear_train import plan_gears


@pytest.fixture(scope="module")
def layout():
    return plan_gears(load_design()).layout


def sections(pair, **off):
    """The pair's sections with the driver's and the driven gear's E_sn changed by `off` µm."""
    deviations = [
        gear.form.tooth_thickness_deviation + off.get(role, 0.0) * 1e-3
        for role, gear in (("driver", pair.driver), ("driven", pair.driven))
    ]
    changed = pair.cut_to(*deviations)
    return MeasuredPair(section_of(changed.driver.form), section_of(changed.driven.form), pair.centre_distance)


def over_a_pitch(pair, engaged):
    return cycle(engaged, pair.free_angle(), pair.driver.form.teeth, pair.driven_pitch_radius)


@pytest.mark.slow
def test_parts_in_one_place_share_all_their_volume(layout):
    """And parts side by side none: the common volume is a volume, not a verdict."""
    part = layout.parts[1]
    (check,) = _bodies(replace(layout, parts=(part, part)), [1e-3] * 2)
    assert check.value == pytest.approx(part.volume, rel=1e-3)
    assert not check.passed
    (check,) = _bodies(replace(layout, parts=(part, replace(part, axis=part.axis + 100))), [1e-3] * 2)
    assert check.value == 0.0
    (check,) = _bodies(replace(layout, parts=(*layout.parts, replace(part, height=part.height + 0.5))), [1e-3] * 5)
    assert check.place.startswith("2_cluster, 2_cluster")


@pytest.mark.parametrize(("thicker", "within", "past"), [(0.0, True, True), (1.5, False, True), (-1.5, True, False)])
def test_the_cycle_tells_teeth_a_micrometre_too_thick_or_too_thin(layout, thicker, within, past):
    for pair in layout.train.stages[:2]:
        for role in ("driver", "driven"):
            over, least = over_a_pitch(pair, sections(pair, **{role: thicker}))
            assert (over <= LEAST_OVERLAP) is within
            assert (least >= LEAST_OVERLAP) is past


def test_the_cycle_finds_what_is_wrong_only_elsewhere_in_the_pitch(layout):
    """A rise of 3 µm near the tips of the driver carries only while contact is out there."""
    pair = layout.train.stages[0]
    good = sections(pair)
    corners = good.driver.corners
    radius = np.abs(corners)
    out = np.clip((radius - (radius.max() - 0.25)) / 0.1, 0.0, 1.0)
    tooth = np.exp(2j * np.pi / len(corners) * np.arange(len(corners)))[:, None]
    raised = MeasuredPair(
        ToothSection(corners * np.exp(1j * 3e-3 / radius * out * np.sign(np.angle(corners / tooth)))),
        good.driven,
        good.centre_distance,
    )
    overlaps = []
    half = pair.base_backlash(pair.centre_distance, 2 * pair.driver.form.tooth_thickness_deviation)
    assert half > 0
    for share in np.arange(16) / 16:
        angle = 2 * np.pi / 30 * share
        turned = good.limit(angle, 1) - 1e-3 * PLAY_LIMIT_UM / pair.driven_pitch_radius
        overlaps.append(raised.overlap(angle, turned) > LEAST_OVERLAP)
    assert any(overlaps)
    assert not all(overlaps)
    assert over_a_pitch(pair, raised)[0] > LEAST_OVERLAP


def test_play_and_return_error_are_off_by_what_the_teeth_are(layout):
    """A driver thinned by 2 µm more gives its own stage 2 µm of play more, and the output its share by the ratios."""
    cut = layout.train.stages
    measured = [[sections(cut[0], driver=-2.0)], *([sections(pair)] for pair in cut[1:])]
    assert play_error_um(cut[0], measured[0]) == pytest.approx(2.0, abs=0.06)
    assert play_error_um(cut[1], measured[1]) == pytest.approx(0.0, abs=0.06)
    # 2 µm at the radius of 37.5 mm, through 3 and 3 to one, at the radius of 30 mm.
    assert return_error_um(cut, measured) == pytest.approx(2.0 / 37.5 / 9 * 30, abs=0.06)


def test_teeth_mesh_unless_they_jam(layout):
    cut = layout.train.stages
    assert meshes(cut)
    assert not meshes((*cut[:2], cut[2].cut_to(0.03, 0.03)))


def test_the_worst_stage_is_shown_by_check_also_where_stages_have_fewer():
    codes = {"most": CheckCode.TEETH_JAM, "least": CheckCode.TEETH_HOLD, "gap": CheckCode.OVERLAP_PAST_PLAY}

    def check(name, value, bound, place=""):
        return Check(codes[name], name, value, "mm", 1.0, bound, place)

    found = _worst(
        [
            [check("most", 0.1, Bound.MAX), check("least", 3.0, Bound.MIN), check("gap", 2.0, Bound.MIN, "as cut")],
            [check("most", 0.3, Bound.MAX), check("least", 1.5, Bound.MIN)],
            [check("most", 0.2, Bound.MAX), check("least", 2.0, Bound.MIN), check("gap", 5.0, Bound.MIN, "least")],
        ]
    )
    assert [(one.name, one.value, one.place) for one in found] == [
        ("most", 0.3, "stage 2"),
        ("least", 1.5, "stage 2"),
        ("gap", 2.0, "stage 1, as cut"),
    ]


@pytest.mark.slow
def test_every_check_that_can_fail_says_what_to_do():
    for check in plan_gears(load_design()).checks:
        assert check.advice, check.name
