"""Trains that are proposed for new cars: the cars are ready, and what stands in the way is named."""

from math import pi

import pytest

from cadgen import Design
from cadgen.check import failing
from cadgen.errors import DesignError
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_layout import laid_out
from cadgen.verdict import Readiness


@pytest.mark.parametrize("wheel", [pytest.param(80, marks=[pytest.mark.slow, pytest.mark.long]), 128])
def test_a_new_car_with_a_proposed_train_is_ready(tmp_path, wheel):
    design = Design.new("mine", tmp_path, train=True, changes={"car.outline.wheel_diameter_mm": wheel}).values
    assert not failing(laid_out(design).checks)
    assert design.frame is not None
    cam = plan_cam(design)
    assert cam.verdict.readiness == Readiness.READY
    # The brake keeps the cam on its gears: play moves nothing.
    assert cam.application.comparison.chosen.band.worst_distance < 0.01
    # The path ends before the blend of 12 degrees, and not by more than 3 % of the turn.
    ratio = 1.0
    for stage in design.train.stages:
        ratio *= stage.driven.teeth / stage.driver.teeth
    share = cam.application.track.length / (pi * wheel * ratio)
    assert (1 - 12 / 360) / 1.03 <= share <= 1 - 12 / 360


def test_a_lap_gets_the_wheel_of_its_outline(tmp_path):
    design = Design.new("lap", tmp_path, train=True, closed=True).values
    cam = plan_cam(design, "actual", judged=False)
    assert 2 * cam.application.drive_wheel.radius == pytest.approx(128, rel=0.01)
    assert not failing(laid_out(design).checks)


def test_a_wheel_too_small_for_its_pinion_is_refused_before_any_train_is_laid_out(tmp_path):
    """The pinion of 30 teeth of module 0.5 reaches 8 mm, and 5 mm are kept to the floor; 26 mm were tried and do."""
    for wheel in (1, 10):
        with pytest.raises(
            DesignError, match="of 30 teeth, needs a wheel of at least 26 mm to clear the floor by 5 mm"
        ):
            Design.new("small", tmp_path, train=True, changes={"car.outline.wheel_diameter_mm": wheel})


@pytest.mark.slow
@pytest.mark.long
def test_what_forbids_a_train_is_named(tmp_path):
    with pytest.raises(
        DesignError,
        match=r"none of the \d+ trains .* fits the car; .* mm \(.+ and .+\), where 45 is asked for; raise train",
    ):
        Design.new("high", tmp_path, train=True, changes={"layout.clearance_mm": 45})
    with pytest.raises(DesignError, match="no train of one to four stages brings a wheel of 2000 mm"):
        Design.new("large", tmp_path, train=True, changes={"car.outline.wheel_diameter_mm": 2000})
    with pytest.raises(DesignError, match=r"car\.outline\.wheel_diameter_mm is not given"):
        Design.new("none", tmp_path, train=True, changes={"car.outline": None})
    with pytest.raises(DesignError, match="leave points, layer, field, closed and train out"):
        Design.new("cam", tmp_path, train=True, motion=True)
    points = tmp_path / "tight.csv"
    points.write_text("500 500\n800 500\n850 800\n500 850\n")
    with pytest.raises(DesignError, match="steering of 35 degrees holds no less than"):
        Design.new("tight", tmp_path, points=points, train=True)
    points.unlink()
    assert not list(tmp_path.iterdir())
