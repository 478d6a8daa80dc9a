"""A slice of the study of dense, straight, dwelling and rippling paths, and blends beside a node."""

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.jobs.cam.steering_cam import plan_cam
from tests.studies.paths import KINDS, case_of, verdict

SEED = 3


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "number"), [(kind, n) for n, kind in enumerate(KINDS)])
def test_no_false_refusal_and_no_fault(kind, number):
    case = case_of(SEED, number, kind)
    said = verdict(case, 1)
    print(f"{kind}, {len(case.waypoints)} waypoints: {said}")
    assert said in ("passed", "refused")


@pytest.mark.slow
def test_an_exactly_straight_path_is_a_circle(tmp_path):
    """tan(beta) is nothing but rounding: both faces' envelopes coincide all round."""
    points = ", ".join(f"[{600.0 * i}, {250.0 * i}]" for i in range(9))
    for spline in ("quintic", "cubic"):
        (tmp_path / "a.toml").write_text(
            f'[path]\nspline = "{spline}"\noffset_mm = 20.0\nwaypoints_mm = [{points}]\n'
            "[car]\nwheelbase_mm = 167.0\ndrive_wheel_offset_mm = 37.0\nidle_wheel_offset_mm = 201.0\n"
            "[cam]\nbase_radius_mm = 70.0\ninner_face_mm = 23.5\nthickness_mm = 3.0\n[follower]\nradius_mm = 2.5\n"
        )
        design = load_design(tmp_path / "a.toml")
        for profile in ("actual", "theoretical"):
            plan = plan_cam(design, profile)
            assert plan.passed
            assert not plan.trims
            radius = 70.0 if profile == "theoretical" else 67.5
            assert plan.curve.radius(np.linspace(0, 6, 99)) == pytest.approx(radius, abs=1e-7)
