"""Friction and drag from the design file to the choice, the checks and the words."""

import json

import numpy as np
import pytest

from cadgen.car.against_play.profile_kinds import ACTUAL, COMPENSATED
from cadgen.check import CheckCode, failing
from cadgen.design import cam_model, variation
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cam_plan import Making
from cadgen.jobs.cam.car_facts import comparison_facts, remedy_facts
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.remedies import remedies
from cadgen.jobs.cam.steering_cam import plan_cam

FRICTION = ["mechanics.friction_least=0.05", "mechanics.friction_greatest=0.3", "optimize.max_lift_error_um="]


def band(*overrides, name="carbon_free_car"):
    design = load_design(name, overrides)
    return variation.mechanics(design, cam_model.follower(design), cam_model.lift(design))


@pytest.fixture(scope="module")
def workshop():
    return plan_cam(load_design("workshop_car"))


@pytest.fixture(scope="module")
def rubbing():
    return plan_cam(load_design("carbon_free_car", FRICTION), "optimized")


@pytest.mark.slow
def test_the_workshop_s_car_does_not_mind_its_play(workshop):
    assert workshop.passed
    assert workshop.application.comparison.chosen.profile is ACTUAL
    assert workshop.application.comparison.chosen.band.worst_distance < 1.0
    assert workshop.application.comparison.rubbing == ""
    checks = {check.name: check for check in workshop.checks}
    assert checks["torque that turns the cam ahead"].value == 0.0
    assert checks["drag over the drag that holds the cam"].value == pytest.approx(42.0 / 33.5, rel=5e-3)
    assert workshop.application.design.blank.edge_break_mm == 0.2
    facts = comparison_facts(workshop.application.comparison).json()["mechanics"]
    assert facts["friction"] == [0.05, 0.20]
    assert facts["drag_Nmm"] == [42.0, 60.0]


@pytest.mark.slow
def test_a_cam_for_a_rod_that_rubs(rubbing):
    comparison = rubbing.application.comparison
    assert comparison.chosen.profile is COMPENSATED
    assert comparison.chosen.band.worst_distance <= 510.0
    assert comparison.chosen.band.worst.friction == pytest.approx(0.3)
    # The window of the dilation is not the play of the run that it is evaluated at.
    assert comparison.chosen.made_for < comparison.chosen.play == pytest.approx(sum(comparison.band.ends) / 2)
    assert any("a change by 0.01 moves the end of the run" in reason for reason in comparison.reasons)
    checks = {check.name: check for check in rubbing.checks}
    assert checks["torque that turns the cam ahead"].value > 20.0
    assert "drag over the drag that holds the cam" not in checks


@pytest.mark.slow
def test_the_sheet_of_remedies(rubbing):
    sheet = {remedy.name: remedy for remedy in remedies(rubbing.application.design, rubbing.application.comparison)}
    ends = {name: remedy.worst_end for name, remedy in sheet.items()}
    assert ends["plain cam"] > ends["plain cam, reordered"] > ends["compensated for all"]
    assert ends["compensated for all"] <= 510.0
    assert ends["compensated for all"] < ends["compensated for one car"]
    assert ends["ball bearing, compensated"] <= 350.0
    assert 70.0 < ends["plain cam, trimmed"] <= 83.0
    assert ends["compensated, trimmed"] <= 45.0
    assert ends["plain cam, drag that holds"] <= 1.0
    assert all(remedy.on_way >= remedy.worst_end - 0.01 for remedy in sheet.values())
    assert "40.8 N·mm for a rod force of 1 N" in sheet["plain cam, drag that holds"].build
    assert "by -9 to -61 µm" in sheet["plain cam, trimmed"].build
    # The design's own profile is the one for all cars: nothing is searched for twice.
    assert sheet["compensated for all"].cut_for == rubbing.application.comparison.chosen.made_for


@pytest.mark.slow
def test_a_design_that_says_nothing_of_friction_is_told_what_a_rod_would_make_of_it():
    plan = plan_cam(load_design("carbon_free_car"))
    assert plan.application.comparison.chosen.made_for == plan.application.comparison.chosen.play  # as without friction
    assert "up to 814 mm off" in plan.application.comparison.rubbing
    assert "1207 mm" in plan.application.comparison.rubbing
    assert comparison_facts(plan.application.comparison).json()["friction_note"] == plan.application.comparison.rubbing


@pytest.mark.slow
def test_hardware_that_the_design_allows():
    known = band(*FRICTION, 'optimize.hardware=["drag"]')
    assert known.drag == pytest.approx((1.25 * 32.63, 1.25 * 32.63), rel=1e-3)
    # A brake that is strong enough stays as it is.
    kept = band(*FRICTION, 'optimize.hardware=["drag"]', "mechanics.drag_least_Nmm=50")
    assert kept.drag == (50.0, 50.0)
    assert band(*FRICTION).drag == (0.0, 0.0)


@pytest.mark.slow
def test_a_trim_is_chosen_by_the_figure_that_the_sheet_shows():
    """A profile compensated for what the trim leaves halves that: 42 mm at the worst friction, 83 the plain cam."""
    design = load_design("carbon_free_car", [*FRICTION, 'optimize.hardware=["trim"]'])
    comparison = plan_cam(design, "optimized").application.comparison
    assert comparison.chosen.profile is COMPENSATED
    assert any("after a trial run" in reason for reason in comparison.reasons)
    ends = {remedy.name: remedy.worst_end for remedy in remedies(design, comparison)}
    left = ends["this design: compensated, trimmed"]
    assert left <= 45.0
    assert left == pytest.approx(ends["compensated, trimmed"], abs=0.1)
    (plain,) = (reason for reason in comparison.reasons if reason.startswith("actual not chosen"))
    (chosen,) = (reason for reason in comparison.reasons if reason.startswith("compensated chosen"))
    assert f"{ends['plain cam, trimmed']:.4g} mm" in plain
    assert f"{left:.4g} mm" in chosen


KNOWN = ["play.measured_deg=0.75", "optimize.max_lift_error_um="]


@pytest.mark.slow
def test_a_known_friction_that_the_profile_cannot_meet(tmp_path):
    """The best that it can, with the figure; the ramps of one that meets it take a closer cloud of points."""
    known = [*KNOWN, "mechanics.friction_least=0.15", "mechanics.friction_greatest=0.15"]
    plan = plan_cam(load_design("carbon_free_car", known), "optimized")
    (cloud,) = write_cam(plan, tmp_path, find_cures(plan), formats="xyz")
    assert cloud.lift_error_um < cloud.lift_limit_um
    met = plan.application.comparison
    assert not any("No profile of those compared meets the end" in reason for reason in met.reasons)
    assert met.chosen.error.end_distance < 3.0
    small = ["cam.base_radius_mm=17", "blank.lightening=", "blank.keyway=", "blank.bore_diameter_mm=2"]
    comparison = plan_cam(load_design("carbon_free_car", [*known, *small]), "optimized").application.comparison
    (said,) = (reason for reason in comparison.reasons if "No profile of those compared meets the end" in reason)
    assert f"ends {comparison.chosen.error.end_distance:.1f} mm off" in said
    ends = [evaluation.error.end_distance for evaluation in comparison.evaluations]
    assert comparison.chosen.error.end_distance == min(ends)


@pytest.mark.slow
def test_a_friction_at_which_the_cam_holds_everywhere():
    held = [*KNOWN, "mechanics.friction_least=0.6", "mechanics.friction_greatest=0.6"]
    comparison = plan_cam(load_design("carbon_free_car", held), "optimized").application.comparison
    assert comparison.chosen.profile is ACTUAL
    assert comparison.chosen.windows == (0.0,)
    assert any("there is nothing to compensate" in reason for reason in comparison.reasons)


def test_a_brake_that_the_program_dimensions_is_on_the_disc():
    """Also where the drag given acts on a shaft, on which the disc has play."""
    joint = ["blank.joint=keyed", "blank.joint_clearance_greatest_um=25", "mechanics.drag_on=shaft"]
    given = band(*FRICTION, *joint, "mechanics.drag_least_Nmm=41")
    assert np.degrees(given.behind) == pytest.approx(0.358, abs=1e-3)
    known = band(*FRICTION, *joint, "mechanics.drag_least_Nmm=41", 'optimize.hardware=["drag"]')
    assert known.behind == 0.0
    assert known.drag[0] == pytest.approx(1.25 * 32.63, rel=1e-3)


@pytest.mark.slow
def test_with_a_measured_play_the_friction_is_not_known_either(rubbing):
    """The limit of [optimize] is for the worst friction at that play, not for the middle one."""
    overrides = [*FRICTION, "play.measured_deg=0.74", "optimize.max_end_position_mm=200"]
    refused = plan_cam(load_design("carbon_free_car", overrides), "optimized")
    (check,) = (check for check in refused.failed if check.code == CheckCode.END_POSITION_WITH_PLAY)
    assert 320.0 < check.value < 333.5
    assert "a brake on the disc does" in check.advice


@pytest.mark.slow
@pytest.mark.long
def test_a_remedy_that_cannot_be_built_is_no_number():
    small = ["cam.base_radius_mm=17", "blank.lightening=", "blank.keyway=", "blank.bore_diameter_mm=2"]
    plan = plan_cam(load_design("carbon_free_car", [*FRICTION, *small]), "optimized", all_trains=True)
    facts = [remedy_facts(remedy).json() for remedy in remedies(plan.application.design, plan.application.comparison)]
    json.dumps(facts, allow_nan=False)
    (bearing,) = (fact for fact in facts if fact["remedy"].startswith("ball bearing"))
    assert bearing["worst_end_position_mm"] is None
    assert "no cam can be made" in bearing["build"]


@pytest.mark.slow
def test_friction_alone_is_never_counted_on(rubbing):
    steep = ["mechanics.friction_least=0.55", "mechanics.friction_greatest=0.6", "optimize.max_lift_error_um="]
    plan = plan_cam(load_design("carbon_free_car", steep), "optimized")
    assert any("friction alone holds the cam" in reason for reason in plan.application.comparison.reasons)
    assert not any("friction alone" in reason for reason in rubbing.application.comparison.reasons)


def test_the_plain_profile_has_its_torques_too():
    plan = plan_cam(load_design("carbon_free_car", [*FRICTION, "mechanics.drag_least_Nmm=10"]), "actual")
    checks = {check.name: check for check in plan.checks}
    assert checks["drag over the drag that holds the cam"].value == pytest.approx(10 / 32.63, rel=1e-3)
    assert checks["torque that turns the cam ahead"].value == pytest.approx(18.8, abs=0.2)


def test_friction_follows_from_the_materials():
    assert band("mechanics.rod_force_N=1").friction == (0.05, 0.30)
    greased = band("mechanics.rod_force_N=1", "blank.material=aluminium")
    assert greased.friction == (0.05, 0.20)
    assert band("mechanics.greased=false", "blank.material=PLA", "drawing.material=").friction == (0.25, 0.60)
    assert band("mechanics.rod_force_N=1", "follower.material=ball_bearing").friction == (0.0, 0.02)
    assert band() is None
    # Materials alone are enough, and a dry rod on an unknown disc is not a greased one.
    assert band("blank.material=POM", "drawing.material=").friction == (0.05, 0.15)
    assert band("follower.material=ball_bearing").friction == (0.0, 0.02)
    assert band("mechanics.greased=false").friction == (0.15, 0.60)


def test_a_material_of_the_drawing_alone_makes_no_rod_rub():
    """Fed and weighed goes what the title block says; friction stays what the design says of it."""
    design = load_design("carbon_free_car")
    assert design.blank.material is None
    assert band() is None
    making = Making.of(design)
    assert (making.material, making.ordered) == ("aluminium", "aluminium EN AW-6082")
    graded = Making.of(load_design("carbon_free_car", ["drawing.material=EN AW-6082"]))
    assert (graded.material, graded.ordered) == ("aluminium", "EN AW-6082")
    unnamed = Making.of(load_design("carbon_free_car", ["drawing.material=carbon fibre"]))
    assert (unnamed.material, unnamed.ordered) == (None, "carbon fibre")
    alloy = Making.of(load_design("carbon_free_car", ["blank.material=aluminium"]))
    assert alloy.ordered == "aluminium EN AW-6082"
    plain = Making.of(load_design("carbon_free_car", ["blank.material=aluminium", "drawing.material="]))
    assert plain.ordered == "aluminium"
    other = Making.of(load_design("carbon_free_car", ["blank.material=steel"]))
    assert (other.material, other.ordered) == ("steel", "steel")


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["mechanics.rod_rate_N_per_mm=0.5"], "the rod leaves the disc: raise mechanics.rod_force_N to 3.3 or more"),
        (["mechanics.drag_least_Nmm=50", "mechanics.drive_torque_Nmm=60"], "mechanics.drive_torque_Nmm is 60"),
        (['optimize.hardware=["drag"]'], "add [mechanics]"),
        (["mechanics.rod_force_N=1", "tolerances.rod_force_N=1"], "the rod leaves the disc"),
        (["mechanics.drag_least_Nmm=42", "mechanics.drive_energy_J=0.1"], "mechanics.drive_energy_J is 0.1"),
        (["mechanics.friction_least=0.1", "mechanics.friction_greatest=1.5", "cam.base_radius_mm=40"], "the rod jams"),
    ],
)
def test_forces_that_cannot_be_are_refused(overrides, said):
    with pytest.raises(DesignError) as error:
        band(*overrides)
    assert said in str(error.value)


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["mechanics.friction_least=-0.1", "mechanics.friction_greatest=0.1"], "at least 0"),
        (["mechanics.friction_least=0.1", "mechanics.friction_greatest=9"], "at most 1.5"),
        (["mechanics.friction_least=0.1"], "give both or neither"),
        (["mechanics.friction_least=0.3", "mechanics.friction_greatest=0.1"], "exchange them"),
        (["mechanics.drag_least_Nmm=5", "mechanics.drag_greatest_Nmm=1"], "exchange them"),
        (["mechanics.drag_least_Nmm=50", "mechanics.drive_torque_Nmm=40"], "it cannot turn that"),
        (["follower.width_mm=5"], "the width of a ball bearing"),
        (["blank.material=cheese"], '"aluminium", "steel"'),
    ],
)
def test_a_file_that_cannot_be_is_refused(overrides, said):
    with pytest.raises(DesignError) as error:
        load_design("carbon_free_car", overrides)
    assert said in str(error.value)


def test_a_bearing_too_narrow_fails_a_check():
    overrides = ["follower.radius_mm=5.5", "follower.material=ball_bearing", "follower.width_mm=4"]
    plan = plan_cam(load_design("carbon_free_car", overrides), "actual")
    (failed,) = failing(plan.checks)
    assert failed.name == "bearing width"
    assert failed.value > 5.0
    assert np.isfinite(failed.value)
