"""Every check can fail, says where, and passes on the paper's car; the cures cure."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from cadgen.cam.checks import check_cam
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import published_profile, theoretical_profile
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits
from cadgen.cam.lost_lift import lost_lift, undercut_cures, worst_loss
from cadgen.car import path_motion as law
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.against_play.smoothing import smoothed_lift
from cadgen.car.path_motion import blend_checks, path_motion
from cadgen.car.steering import steering_jets
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub

LIMITS = CheckLimits(
    pressure_angle=PRESSURE_ANGLE_LIMITS["norton_oscillating"],
    lost_lift=1e-3,
    min_convex_radius=0.5,
    cutter_radius=2.0,
    wall=2.0,
)
BLANK = Blank(bore_diameter=8.0)


def run(car, curve=None, *, trims=None, limits=LIMITS, blank=BLANK, follower=None):
    checks = check_cam(
        car.lift,
        follower or car.follower,
        curve or car.actual.curve,
        car.actual.trims if trims is None else trims,
        blank,
        limits,
        application=blend_checks,
    )
    return {check.name: check for check in checks}


def failed(checks):
    return {name for name, check in checks.items() if not check.passed}


def test_the_papers_car_passes(carbon_free_car):
    checks = run(carbon_free_car)
    for check in checks.values():
        print(f"{check.name:36s} {check.value:10.4f} {check.unit:8s} {check.bound} {check.limit:8.3g}  {check.place}")
    assert failed(checks) == set()


@pytest.mark.slow
def test_the_appendix_car_is_undercut(appendix_car):
    bearable = failed(run(appendix_car, limits=replace(LIMITS, cutter_radius=1.0, lost_lift=0.015)))
    assert bearable == {"pressure angle, rise", "pressure angle, return"}
    checks = run(appendix_car, limits=replace(LIMITS, cutter_radius=1.0))
    assert failed(checks) == {
        "convex radius, theory",
        "lost lift, undercut",
        "pressure angle, rise",
        "pressure angle, return",
    }
    worst = checks["lost lift, undercut"]
    assert worst.value == pytest.approx(14.7, abs=0.5)
    assert "cam angle 115.1" in worst.place


def test_pressure_angle_is_that_of_the_pitch_curve(carbon_free_car):
    """Independent: tan = ds/dtheta / (a + s) in the plane of the face, to which the lean adds little."""
    lift, follower = carbon_free_car.lift, carbon_free_car.follower
    theta = np.linspace(0, 2 * np.pi, 3600)
    w = follower.contact_face(lift.q(theta))
    angle = np.degrees(np.arctan2(w * lift.q(theta, nu=1), 70 + w * lift.q(theta)))
    checks = run(carbon_free_car)
    assert checks["pressure angle, rise"].value == pytest.approx(angle.max(), abs=0.6)
    assert checks["pressure angle, return"].value == pytest.approx(-angle.min(), abs=0.6)
    assert "; the present limit is from R. L. Norton, " in checks["pressure angle, rise"].advice


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"pressure_angle": PRESSURE_ANGLE_LIMITS["norton_translating"]}, None),
        ({"pressure_angle": replace(PRESSURE_ANGLE_LIMITS["norton_oscillating"], rise=0.3)}, "pressure angle, rise"),
        ({"pressure_angle": replace(PRESSURE_ANGLE_LIMITS["norton_oscillating"], fall=0.3)}, "pressure angle, return"),
        ({"cutter_radius": 9.0}, "largest cutter radius"),
        ({"min_convex_radius": 20.0}, "convex radius, profile"),
        ({"lost_lift": 1e-4}, "lost lift, face change"),
        ({"wall": 60.0}, "thinnest wall"),
    ],
)
def test_each_limit_binds(carbon_free_car, change, name):
    assert failed(run(carbon_free_car, limits=replace(LIMITS, **change))) == ({name} if name else set())


def test_a_rod_that_ends_on_the_rim(carbon_free_car):
    assert failed(run(carbon_free_car, follower=replace(carbon_free_car.follower, length=27.0))) == {
        "rod end beyond the rim"
    }


def test_a_hub_in_the_rods_way(carbon_free_car):
    low = run(carbon_free_car, blank=Blank(bore_diameter=8.0, hub=Hub(diameter=30.0, length=10.0)))
    assert failed(low) == set()
    high = run(carbon_free_car, blank=Blank(bore_diameter=8.0, hub=Hub(diameter=118.0, length=10.0)))
    assert "rod above the hub" in failed(high)


def test_the_published_profile_is_refused(carbon_free_car):
    curve = published_profile(carbon_free_car.lift, carbon_free_car.follower)
    checks = run(carbon_free_car, curve, trims=())
    assert "rod pushed out" in failed(checks)
    assert checks["rod pushed out"].value == pytest.approx(304, abs=5)


def test_a_profile_cut_too_deep_lets_the_rod_fall_short(carbon_free_car):
    thicker = replace(carbon_free_car.follower, radius=2.502)
    too_deep = actual_profile(carbon_free_car.lift, thicker).curve
    checks = run(carbon_free_car, too_deep)
    assert "rod falls short" in failed(checks)
    assert checks["rod falls short"].value == pytest.approx(2.0, rel=0.2)


def test_the_theoretical_profile_with_the_rods_axis(carbon_free_car):
    axis = replace(carbon_free_car.follower, radius=0.0)
    checks = run(carbon_free_car, theoretical_profile(carbon_free_car.lift, axis), trims=(), follower=axis)
    assert failed(checks) == set()


@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_losses_are_those_of_the_corner_alone(name, request):
    """In a trimmed interval the rod rests on the corner, a single point: a + w T - h sqrt(1 + T^2) = x there."""
    car = request.getfixturevalue(name)
    follower = car.follower
    for loss in lost_lift(car.lift, follower, car.actual.trims, car.actual.curve.outline(0.02)):
        off = np.arctan2(loss.trim.point[1], loss.trim.point[0]) - loss.cam_angle
        x, y = np.linalg.norm(loss.trim.point) * np.array([np.cos(off), np.sin(off)])
        h = np.sqrt(follower.radius**2 - y**2)
        needed = [
            brentq(lambda T, w=w, x=x, h=h: follower.base_radius + w * T - h * np.sqrt(1 + T**2) - x, -1, 1, xtol=1e-14)
            for w in (follower.inner, follower.outer)
        ]
        alone = float(follower.lift(car.lift.q(loss.cam_angle)) - follower.lift(np.array(max(needed))))
        print(f"{np.degrees(loss.cam_angle):7.2f}°: {loss.lift * 1e3:.4f} µm lost, by the corner {alone * 1e3:.4f} µm")
        assert abs(loss.lift - alone) < 1e-6


@pytest.mark.slow
def test_cures_are_the_smallest_change_that_cures(appendix_car):
    cures = undercut_cures(appendix_car.lift, appendix_car.follower, 5e-3)
    assert {cure.parameter for cure in cures} == {"follower.radius_mm", "cam.base_radius_mm"}
    assert [cure.factor for cure in cures] == sorted(cure.factor for cure in cures)
    for cure in cures:
        field = cure.parameter.split(".")[1].removesuffix("_mm")
        print(f"{cure.parameter}: {cure.now:g} -> {cure.value:.3f} mm")
        at = replace(appendix_car.follower, **{field: cure.value})
        short = replace(appendix_car.follower, **{field: cure.value * (1.03 if cure.value < cure.now else 0.97)})
        assert worst_loss(appendix_car.lift, at) <= 5e-3 < worst_loss(appendix_car.lift, short)


@pytest.mark.slow
def test_a_loss_is_found_at_any_base_radius(appendix_car):
    """On a disc of 4.5 m the envelope's branches join within a nanometre, not within rounding."""
    built = appendix_car
    smoothed = smoothed_lift(built.lift, 0.9)
    cam = compensated_lift(smoothed, built.follower, np.radians(0.962))
    losses = [worst_loss(cam, replace(built.follower, base_radius=70.0 * factor)) for factor in (1.0, 8.0, 64.0)]
    print("lost lift with 1, 8 and 64 times the base radius, um:", [f"{1e3 * loss:.2g}" for loss in losses])
    assert losses[0] > losses[1] > losses[2]


@pytest.mark.slow
def test_a_steep_blend_is_refused_only_where_it_locks(carbon_free_car, monkeypatch):
    """Over half a degree the blend is steeper than any limit of the path, where the car does not drive."""
    track = carbon_free_car.track
    lift = path_motion(track.arc, steering_jets(track, carbon_free_car.car), track.length, blend=np.radians(0.5))
    short = replace(carbon_free_car, lift=lift, actual=actual_profile(lift, carbon_free_car.follower))
    rows = run(short, limits=replace(LIMITS, cutter_radius=0.01))
    row = rows["pressure angle, blend return"]
    print(row.value, row.place, row.limit)
    milder = replace(LIMITS.pressure_angle, rise=0.52, fall=0.52)
    limits = replace(LIMITS, cutter_radius=0.01, lost_lift=1.0, pressure_angle=milder)
    assert row.value > 31 > np.degrees(limits.pressure_angle.fall)
    assert failed(run(short, limits=limits)) <= {"convex radius, profile"}
    monkeypatch.setattr(law, "LOCKING_ANGLE", np.radians(31.0))
    assert "pressure angle, blend return" in failed(run(short, limits=limits))


def test_lift_lost_in_the_blend_is_no_lost_lift_of_the_path(appendix_car):
    """The same trim counts where the path steers, and is only shown where the blend does."""
    worst = max(lost_lift_of(appendix_car), key=lambda loss: loss.lift)
    assert worst.driven
    moved = replace(appendix_car.lift, blend_start=worst.trim.before - 1e-3)
    blended = run(replace(appendix_car, lift=moved), limits=replace(LIMITS, cutter_radius=1.0))
    assert blended["lift error on the blend"].value == pytest.approx(worst.lift * 1e3, rel=0.02)
    assert "where the car does not drive" in blended["lift error on the blend"].place
    assert "lost lift, undercut" not in failed(blended)
    inside = replace(appendix_car.lift, blend_start=(worst.trim.before + worst.trim.after) / 2)
    parts = [loss for loss in lost_lift_of(replace(appendix_car, lift=inside)) if loss.trim is worst.trim]
    assert [loss.driven for loss in parts] == [True, False]


def lost_lift_of(car):
    return lost_lift(car.lift, car.follower, car.actual.trims, car.actual.curve.outline(0.02))
