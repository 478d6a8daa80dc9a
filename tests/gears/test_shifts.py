"""Proposed profile shifts: no undercut, balanced sliding, the distance asked for; each passes its checks."""

from math import acos, cos, pi, radians, tan

import pytest
from click.testing import CliRunner

from cadgen import Gear, GearPair
from cadgen.cli import cli
from cadgen.errors import DesignError
from cadgen.gears.contact import missing_shift
from cadgen.gears.shifts import ShiftAim, sum_of_shifts


def pair(*teeth, backlash=0.06, **more):
    return GearPair(*(Gear(teeth=z, module=1, width=8, **more) for z in teeth), backlash=backlash)


def test_proposals_are_free_of_undercut_and_slide_alike():
    """12 teeth lack (17 - 12)/17 by the formula of the sharp rack; that of ISO 53 profile A lacks less."""
    proposals = pair(12, 40).propose_shifts()
    assert [each.aim for each in proposals] == [ShiftAim.NO_UNDERCUT, ShiftAim.BALANCED]
    plain, balanced = proposals
    assert plain.centre_distance == balanced.centre_distance == 26.0  # the usual one
    assert 0.25 < plain.driver < 5 / 17 + 0.06
    assert balanced.sliding[0] == pytest.approx(balanced.sliding[1], abs=0.01)
    assert max(map(abs, balanced.sliding)) < max(map(abs, plain.sliding))
    for each in proposals:
        made = pair(12, 40).shifted(each)
        assert made.passed
        assert missing_shift(made.cut.driver.form) == missing_shift(made.cut.driven.form) == 0
        assert made.specific_sliding == pytest.approx(each.sliding, rel=1e-6)


def test_distance_asked_for_is_kept_without_play():
    """m 3, 12/24, a 56.5 (bolsover.com): the sum of the shifts is 0.96006."""
    gears = [Gear(teeth=z, module=3, width=8) for z in (12, 24)]
    free = GearPair(*gears, backlash=0.1)
    assert sum_of_shifts(free.cut, 56.5) == pytest.approx(0.96006, abs=1e-5)
    for each in free.propose_shifts(56.5):
        assert each.driver + each.driven == pytest.approx(0.96006, abs=1e-5)
        angle = acos(36 / 2 * 3 * cos(radians(20)) / 56.5)
        assert tan(angle) - angle == pytest.approx(
            tan(radians(20)) - pi / 9 + 2 * tan(radians(20)) * (each.driver + each.driven) / 36
        )
        made = free.shifted(each)
        assert made.axes_apart == 56.5
        assert made.play == pytest.approx(0.1, abs=1e-6)


def test_shifts_of_a_ring_count_as_those_of_its_pinion():
    gears = (Gear(teeth=20, module=1, width=8), Gear(teeth=60, module=1, width=8, internal=True))
    free = GearPair(*gears, backlash=0.16)
    plain, balanced = free.propose_shifts()
    assert (plain.driver, plain.driven) == (0.0, 0.0)
    assert balanced.driver + balanced.driven == pytest.approx(0.0, abs=1e-9)
    assert balanced.sliding[0] == pytest.approx(balanced.sliding[1], abs=0.01)


def test_what_cannot_be_is_refused_with_what_can():
    with pytest.raises(DesignError, match="give a least land \\(least_land, --least-land\\) of ") as refused:
        pair(9, 15).propose_shifts()
    most = float(str(refused.value).rsplit(" ", 1)[1])
    assert min(pair(9, 15).propose_shifts(least_land=most)[0].lands) >= most
    with pytest.raises(DesignError, match=r"within the base circles; give more than 37\.59 mm"):
        pair(20, 60).propose_shifts(36.0)
    with pytest.raises(DesignError, match="give more teeth"):
        pair(6, 6).propose_shifts()
    with pytest.raises(DesignError, match="a check of the pair fails, teeth jam: thin the teeth"):
        pair(20, 60, backlash=0.01).propose_shifts()


def test_flags_propose_shifts():
    run = CliRunner().invoke(
        cli, ["pair", "--teeth", "12,40", "--module", "1", "--width", "8", "--backlash-um", "60", "--propose-shifts"]
    )
    assert run.exit_code == 0
    assert "balanced sliding" in run.output
    assert "0.3400, -0.3400" in run.output
