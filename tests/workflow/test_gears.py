"""From a design to a checked train: the paper's figures, orders, and what is refused."""

import pytest

from cadgen.design.load import load_design
from cadgen.errors import CheckError, DesignError
from cadgen.workflow.gears import PLAY_LIMIT_UM, plan_gears, teeth_of


@pytest.fixture(scope="module")
def paper():
    return plan_gears(load_design())


def test_the_design_reproduces_the_paper(paper):
    facts = paper.facts()
    assert f"{facts['return_error_deg']['greatest']:.3f}" == "0.962"
    assert [f"{stage['return_error_greatest_deg']:.3f}" for stage in facts["stages"]] == ["0.544", "0.676", "0.676"]
    assert [f"{stage['j_bn2_um']:.3f}" for stage in facts["stages"]] == ["302.324", "300.550", "300.550"]


def test_reordered_puts_the_highest_ratio_last():
    plan = plan_gears(load_design(), "reordered")
    assert teeth_of(plan.play) == "40/120 40/120 30/150"
    assert f"{plan.facts()['return_error_deg']['greatest']:.3f}" == "0.724"
    assert f"{plan.facts()['return_error_as_given_deg']['greatest']:.3f}" == "0.962"
    assert plan.passed


def test_search_finds_a_train_of_the_same_ratio_with_less_return_error():
    plan = plan_gears(load_design(None, ["train.search.keep=3"]), "search")
    assert plan.play.train.ratio == 45
    # Better than the best order of the given stages, 24.74 % less.
    assert plan.play.return_error_max < 0.7 * plan.given.return_error_max
    assert len(plan.ranked) == 3
    assert plan.passed


def test_the_override_stands_beside_the_standard(paper):
    (found,) = paper.facts()["overridden_tolerances"]
    assert found["symbol"] == "b_r"
    assert (found["used_um"], found["standard_um"]) == (pytest.approx(52), pytest.approx(43))
    assert paper.facts()["return_error_by_the_standard_deg"]["greatest"] < 0.962


def test_equations_and_exact_play_differ_by_less_than_the_bar(paper):
    for stage in paper.facts()["stages"]:
        assert abs(stage["exact_greatest_um"] - stage["j_bnmax_um"]) <= PLAY_LIMIT_UM
        assert abs(stage["exact_least_um"] - stage["j_bnmin_um"]) <= PLAY_LIMIT_UM


def test_the_thinning_moves_play_and_inspection(paper):
    thin = plan_gears(load_design(None, ["train.thinning=greatest"]))
    for one, two in zip(thin.facts()["stages"], paper.facts()["stages"], strict=True):
        assert one["play_as_cut_um"] > two["play_as_cut_um"]
    for plan in (thin, paper):
        for part in plan.facts()["parts"]:
            for gear in part["gears"]:
                assert gear["span_min_mm"] < gear["span_max_mm"] < gear["span_nominal_mm"]
                assert gear["over_pins_min_mm"] < gear["over_pins_max_mm"] < gear["over_pins_nominal_mm"]


def test_given_directions_are_kept():
    plan = plan_gears(load_design(None, ["train.stages.1.direction_deg=30", "train.stages.2.direction_deg=30"]))
    first, second, third, _ = (part.axis for part in plan.layout.parts)
    assert abs((second - first) / 45 - (third - second) / 40) == pytest.approx(0, abs=1e-12)


def test_teeth_that_jam_fail_a_check():
    with pytest.raises(CheckError, match=r"30 and 150 teeth.*overlap midway.*thin the teeth"):
        plan_gears(load_design(None, ["train.E_sn_um=30"]))


def test_a_design_without_a_train_says_what_is_missing():
    with pytest.raises(DesignError, match=r"carbon_free_car\.toml has no gear train: add a section \[train\]"):
        plan_gears(load_design(None, ["train="]))


def test_shallow_roots_fail_the_clearance_check():
    plan = plan_gears(
        load_design(None, ["train.dedendum_factor=1.1", "train.rack_tip_radius_factor=0.2", "train.E_sn_um=-1"])
    )
    failed = {check.name for check in plan.checks if not check.passed}
    assert "root clearance" in failed
    assert not plan.passed
