"""Longer lever as a remedy: the share of cars that it promises is that of the design with the keys that it names."""

import re
from dataclasses import replace

import pytest

from cadgen.check import CheckCode
from cadgen.design.load import load_design
from cadgen.jobs.cam.lever import longer_lever
from cadgen.jobs.cam.readiness import course_yield
from cadgen.jobs.cam.remedies import Remedy
from cadgen.jobs.cam.steering_cam import plan_cam

NOW = Remedy(name="now", cut_for=None, worst_end=1.0, on_way=2.0)


@pytest.mark.long
@pytest.mark.slow
def test_the_cars_that_it_promises_keep_the_course():
    as_made = ["frame=", "optimize.hardware=", "car.drive_wheel_radius_mm=", "tolerances.base_radius_mm=0.005"]
    plan = plan_cam(load_design("workshop_car", as_made))
    (row,) = longer_lever(plan.application.design, plan.application, plan.curve, NOW)
    promised, before = map(float, re.search(r"some (\d+) % of the cars keep the course, not (\d+)", row.build).groups())
    changes = re.findall(r"--set (\S+)", row.build)
    longer = plan_cam(load_design("workshop_car", [*as_made, *changes]))
    found = course_yield(longer.application, longer.curve).percent
    print(f"{before} to {promised} %, planned anew {found:.1f} %: {changes}")
    assert changes == ["cam.mid_plane_mm=35", "follower.length_mm=50", "cam.base_radius_mm=98"]
    assert promised == pytest.approx(found, abs=1.5)
    assert promised > before + 8.0
    # The disc then stands where the drive wheel is, 37 mm from the fork axis, and the row says so.
    (check,) = longer.failed
    assert check.code == CheckCode.CAR_CLEARANCE
    assert "the drive wheel and the disc" in row.build
    assert (row.worst_end, row.on_way) == (1.0, 2.0)


def test_no_row_without_a_course():
    plan = plan_cam(load_design("carbon_free_car", ["course="]), "actual")
    use = replace(plan.application, course=None)
    assert longer_lever(use.design, use, plan.curve, NOW) == ()
