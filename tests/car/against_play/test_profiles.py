"""Profiles are objects in one table: a new one needs nothing else, also if it comes from outside."""

import json
import pickle
from dataclasses import replace

import click
import numpy as np
import pytest
from click.testing import CliRunner

from cadgen.cam.contact import roll_curve
from cadgen.car.against_play import profile_kinds
from cadgen.car.against_play.profile_kinds import ACTUAL, ProfileKind, envelope
from cadgen.cli.options import profile_option
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam


@pytest.mark.parametrize("code", profile_kinds.codes())
def test_a_kind_comes_back_from_pickle_as_itself(code):
    """A cam that is sent to another process, or kept, has one; a function without a name cannot be pickled."""
    kind = profile_kinds.profile_of(code)
    assert pickle.loads(pickle.dumps(kind)) is kind


GROUND = 0.01  # mm by which the made-up rod is thicker: the cam is as much smaller all round


@pytest.fixture
def registered(monkeypatch):
    """A plain profile and one against play that the program knows nothing of."""
    monkeypatch.setattr(profile_kinds, "_PROFILES", dict(profile_kinds._PROFILES))
    ground = ProfileKind(
        code="ground",
        meaning="room for grinding",
        curve=lambda lift, rod: envelope(lift, replace(rod, radius=rod.radius + GROUND)),
        note="TO BE GROUND",
    )
    late = ProfileKind(
        code="late",
        meaning="nothing about play",
        for_play=True,
        lift=lambda work: work.cut_as(work.task.lift),
    )
    for profile in (ground, late):
        profile_kinds.register(profile)
    return ground, late


@pytest.mark.slow
def test_a_profile_from_outside_is_planned_by_its_code(registered):
    plan = plan_cam(load_design("carbon_free_car"), "ground")
    assert plan.kind is registered[0]
    angle = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
    thicker = replace(plan.follower, radius=plan.follower.radius + GROUND)
    lift = roll_curve(plan.curve, thicker, angle)[0].lift
    assert np.abs(lift - plan.follower.lift(plan.application.steering.q(angle))).max() < 1e-4
    assert "rod-falls-short" in [check.code for check in plan.failed]
    facts = cam_facts(plan, find_cures(plan)).json()
    assert facts["profile"] == "ground"
    json.dumps(facts, allow_nan=False)


@pytest.mark.slow
def test_a_profile_from_outside_takes_part_in_the_choice(registered):
    comparison = plan_cam(load_design("carbon_free_car"), "optimized").application.comparison
    assert [str(one.profile) for one in comparison.evaluations] == [
        "actual",
        "compensated",
        "smoothed",
        "smoothed+compensated",
        "late",
    ]
    plain, late = comparison.evaluations[0], comparison.evaluations[-1]
    assert late.error.end_distance == pytest.approx(plain.error.end_distance, rel=1e-9)
    assert any(reason.startswith("late ") for reason in comparison.reasons)


@pytest.mark.slow
def test_a_profile_that_cannot_be_made_is_left_out_with_its_reason(registered):
    def refused(work):
        raise DesignError("it cannot be made of this lift")

    for code in ("vain", "vainer"):
        profile_kinds.register(ProfileKind(code=code, meaning="none", for_play=True, lift=refused))
    comparison = plan_cam(load_design("carbon_free_car"), "optimized").application.comparison
    assert [reason for reason in comparison.reasons if "vain" in reason] == [
        "vain refused: it cannot be made of this lift"
    ]


def test_a_design_may_name_it_as_the_profile_that_was_measured(registered):
    assert load_design("carbon_free_car", ["as_built.profile=ground"]).as_built.profile == "ground"


def test_what_is_not_registered_is_refused_with_what_is():
    with pytest.raises(DesignError, match='there is no profile "ground": choose one of actual, optimized, '):
        plan_cam(load_design("carbon_free_car"), "ground")
    with pytest.raises(DesignError, match=r'as_built.profile is "ground"; it must be "actual", .* or "published"'):
        load_design("carbon_free_car", ["as_built.profile=ground"])


@pytest.mark.parametrize("code", ["actual", "Two words", "../up", ""])
def test_a_code_is_unique_and_fit_for_a_file(registered, code):
    with pytest.raises(DesignError, match=r"code"):
        profile_kinds.register(replace(ACTUAL, code=code))


def test_the_help_says_what_each_profile_is():
    @click.command()
    @profile_option
    def command(profile: str | None) -> None:
        """Nothing."""

    text = " ".join(CliRunner().invoke(command, ["--help"]).output.split())
    for code in profile_kinds.codes():
        assert f"{code}: {profile_kinds.profile_of(code).meaning}" in text
