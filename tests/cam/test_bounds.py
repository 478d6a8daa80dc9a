"""Time and memory of rolling and of the track, by the size of their input."""

import numpy as np
import pytest

from cadgen.cam import contact
from cadgen.cam.contact import roll, roll_curve, rolling_step
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.path import wheel_track
from cadgen.car.path_motion import PathMotion
from cadgen.curves.contour import circle
from cadgen.curves.piecewise import quintic_hermite
from cadgen.design.cam_model import lift
from cadgen.design.load import load_design, load_train
from cadgen.errors import DesignError
from cadgen.jobs.cam import cures as cures_module
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam


@pytest.mark.parametrize(
    ("disc", "rod"), [(70.0, 2.5), (70.0, 0.05), (3000.0, 0.05), (3000.0, 100.0), (150.0, 100.0), (1.0, 0.05)]
)
def test_steps_follow_the_sizes_of_disc_and_rod(disc, rod):
    follower = LeaningRod(base_radius=disc, inner=rod + 10.0, outer=rod + 12.0, radius=rod)
    step = rolling_step(circle((0.0, 0.0), disc).curve(), follower)
    assert 2 * np.pi * disc / step <= 1.6e6  # points on the outline
    assert 6 <= 2 * rod / step <= 4000  # points under the rod
    assert step <= contact.COARSEST_STEP


def test_the_paper_s_disc_is_rolled_as_finely_as_ever():
    follower = LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=2.5)
    assert rolling_step(circle((0.0, 0.0), 67.5).curve(), follower) == contact.COARSEST_STEP


def test_blocks_of_any_size_give_the_same(monkeypatch):
    follower = LeaningRod(base_radius=30.0, inner=23.5, outer=26.5, radius=2.5)
    outline = circle((1.5, -0.5), 28.0).curve().outline(0.02)
    angle = np.linspace(0.0, 2 * np.pi, 300, endpoint=False)
    whole = roll(outline, follower, angle)
    monkeypatch.setattr(contact, "_TABLE", 1000)
    assert (roll(outline, follower, angle).lift == whole.lift).all()


def test_a_thin_rod_on_a_circle_gives_its_lift():
    # The rod rests on a circle about the camshaft where it is nearest to the fork, square to the ray.
    follower = LeaningRod(base_radius=30.0, inner=10.0, outer=10.0, radius=0.05)
    rolled, _ = roll_curve(circle((0.0, 0.0), 29.0).curve(), follower, np.linspace(0.0, 6.0, 50))
    tangent = rolled.q[0]
    assert pytest.approx(30.0 + 10.0 * tangent - 0.05 * np.hypot(1.0, tangent), abs=1e-6) == 29.0
    assert np.ptp(rolled.lift) < 2e-5


def test_fewer_nodes_keep_the_lift(monkeypatch):
    design = load_design("carbon_free_car")
    angle = np.linspace(0.0, 2 * np.pi, 5000)
    fine = lift(design).q(angle)
    monkeypatch.setattr(wheel_track, "MOST_NODES", 0)
    assert np.abs(lift(design).q(angle) - fine).max() * 26.5e3 < 0.003  # um
    monkeypatch.setattr(wheel_track, "_BLOCK", 1)
    assert np.abs(lift(design).q(angle) - fine).max() * 26.5e3 < 0.003


@pytest.mark.parametrize(("spline", "most"), [("quintic", 10_000), ("cubic", 1000)])
def test_more_waypoints_than_can_be_followed_are_refused(spline, most):
    points = [[float(k), 0.0] for k in range(most + 1)]
    with pytest.raises(DesignError, match=f"has {most + 1} waypoints.*at most {most} can be followed: keep one in 2"):
        load_design("carbon_free_car", [f"path.spline={spline}", f"path.waypoints_mm={points}"])
    points = points[:-1]
    assert len(load_design(None, [f"path.spline={spline}", f"path.waypoints_mm={points}"]).path.waypoints_mm) == most


def test_a_rod_too_thin_is_refused_by_its_key():
    with pytest.raises(DesignError, match=r"follower.radius_mm is 0.0001; it must be at least 0.05"):
        load_design("carbon_free_car", ["follower.radius_mm=0.0001"])


def test_cures_are_not_sought_at_very_many_kinks(monkeypatch):
    plan = plan_cam(load_design("appendix_car"), "actual")
    assert plan.lost
    monkeypatch.setattr(cures_module, "MOST_KINKS_CURED", len(plan.application.steering.kinks) - 1)
    cures = find_cures(plan)
    assert cures.proved == ()
    (said,) = cures.sentences()
    assert f"the lift has {len(plan.application.steering.kinks)} kinks" in said
    assert 'set path.spline = "quintic"' in said


_STAGE = "{centre_distance_mm=40.0,driver={teeth=40},driven={teeth=120}}"


@pytest.mark.parametrize(
    ("override", "words"),
    [
        (f"train.stages=[{','.join([_STAGE] * 8)}]", "train.stages has 8 items; it can have at most 7: remove some"),
        (f"train.search.modules_mm={[0.5] * 101}", "modules_mm has 101 items; it can have at most 100: remove some"),
    ],
)
def test_trains_too_long_to_be_compared_are_refused(override, words):
    """Of ten stages all 3.6 million orders were compared, by `check` too."""
    with pytest.raises(DesignError, match=words):
        load_train("carbon_free_car", [override])
    assert len(load_train(None, [f"train.stages=[{','.join([_STAGE] * 7)}]"]).train.stages) == 7


def test_a_path_whose_envelopes_fold_too_often_is_refused_by_its_key():
    """Ten thousand waypoints rounded to a nanometre took minutes: each ripple folds both faces' envelopes."""
    waves = 1500
    nodes = np.linspace(0.0, 2 * np.pi, 4 * waves + 1)
    phase = waves * nodes
    wave = 1e-4 * np.stack([np.sin(phase), waves * np.cos(phase)], axis=1)
    jets = np.column_stack([wave, -(waves**2) * wave[:, 0]])
    rough = PathMotion(quintic_hermite(nodes, jets, periodic=True), np.array([]), 2 * np.pi)
    with pytest.raises(DesignError, match=r"turns back at \d+ places, 1000 at most .* points of \[path\]") as refusal:
        actual_profile(rough, LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=2.5))
    assert "1000 at most are followed: keep one in" in str(refusal.value)
