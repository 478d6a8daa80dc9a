"""The rod on a rim with broken edges, against a rod laid on the whole body in space: land, chamfers and faces."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from cadgen.cam.checks import check_cam
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import CHAMFER_LEAN
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, CheckLimits
from cadgen.curves.closed import left_normal
from cadgen.deviations.as_built import AS_DESIGNED, edges_check
from cadgen.parts.blank import Blank

STEP = 4e-3  # mm between points: a rod of 2.5 mm then rests within 1e-6 mm
THETA = np.radians(np.arange(1.3, 348, 3.1))


def steering_in_space(curve, follower, faces, leg, theta, steps=STEP):
    """tan(beta) of the rod laid on the body: points on land, chamfers and faces against the rod's axis in space.

    A point (w, x, y) lies |(x - a) cos(beta) - w sin(beta)| from the axis in the plane of the steering, so it touches
    the rod where that is -sqrt(r^2 - y^2): beta = arccos(-h / hypot(u, w)) - atan2(w, u) with u = x - a.
    """
    jets = [piece.jet(t) for piece, t in zip(curve.pieces, curve.parameters(steps), strict=True)]
    points = np.concatenate([jet.point for jet in jets])
    inward = np.concatenate([left_normal(jet.velocity) for jet in jets])
    body = [
        (w, points + depth * inward)
        for face, way in zip(faces, (1.0, -1.0), strict=True)
        for w, depth in [(face + way * d, leg - d) for d in np.linspace(0.0, leg, 3 if leg else 1)]
    ]
    body.append((sum(faces) / 2, points))
    polar = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    polar = np.concatenate([polar - 2 * np.pi, polar, polar + 2 * np.pi])
    reach = np.arcsin(follower.radius / np.linalg.norm(points, axis=1).min()) + 0.01
    angles = []
    for angle in theta:
        c, s = np.cos(angle), np.sin(angle)
        beta = -np.inf
        near = np.arange(*np.searchsorted(polar, [angle - reach, angle + reach])) % len(points)
        for w, at in body:
            x, y = at[near] @ [c, s], at[near] @ [-s, c]
            under = (np.abs(y) < follower.radius) & (x > 0)
            u, h = x[under] - follower.base_radius, np.sqrt(follower.radius**2 - y[under] ** 2)
            beta = max(beta, float((np.arccos(-h / np.hypot(u, w)) - np.arctan2(w, u)).max()))
        angles.append(beta)
    return np.tan(angles)


def end_of_run(tan_beta, car, length, stop, trim=0.0):
    """Where the drive wheel ends, by the midpoint rule on steering at even cam angles."""
    steering = np.tan(np.arctan(tan_beta) + trim)
    step = length / (2 * np.pi) * stop / len(steering)
    turned = -steering / (car.wheelbase + car.drive_wheel_offset * steering) * step
    heading = np.cumsum(turned) - turned / 2
    return complex(np.sum(np.exp(1j * heading)) * step)


def broken(follower, leg):
    """The rod on a rim of which both edges are broken."""
    inner, outer = Blank(bore_diameter=8.0, edge_break=leg).carrying(follower.inner, follower.outer)
    return replace(follower, inner=inner, outer=outer)


@pytest.mark.parametrize("leg", [0.1, 0.5])
def test_a_cam_made_with_broken_edges_gives_the_lift(carbon_free_car, leg):
    lift, faces = carbon_free_car.lift, (carbon_free_car.follower.inner, carbon_free_car.follower.outer)
    rod = broken(carbon_free_car.follower, leg)
    profile = actual_profile(lift, rod)
    wanted = rod.lift(lift.q(THETA))
    got = rod.lift(steering_in_space(profile.curve, rod, faces, leg, THETA))
    # Where the rod goes over to the other plane it loses what no profile can give.
    away = np.ones(len(THETA), dtype=bool)
    for trim in profile.trims:
        away &= (THETA - trim.before) % (2 * np.pi) > (trim.after - trim.before) % (2 * np.pi)
    error = np.abs(got - wanted)[away].max() * 1e3
    print(f"edges broken by {leg} mm, made for: {error:.5f} um at {away.sum()} cam angles")
    assert error < 0.02
    assert away.sum() > 100


@pytest.mark.parametrize(("leg", "due"), [(0.05, 74.0), (0.1, 149.0), (0.2, 298.0), (0.5, 744.0)])
def test_a_cam_made_without_puts_the_car_off(carbon_free_car, leg, due):
    car, rod = carbon_free_car, carbon_free_car.follower
    count, stop = 1740, car.lift.blend_start
    theta = (np.arange(count) + 0.5) / count * stop
    got = roll(car.actual.curve.outline(0.03), broken(rod, leg), theta)
    # The contact code agrees with the rod in space.
    every = slice(None, None, 20)
    laid = steering_in_space(car.actual.curve, rod, (rod.inner, rod.outer), leg, theta[every], 0.01)
    np.testing.assert_allclose(got.q[every], laid, atol=2e-6)
    ends = [end_of_run(T, car.car, car.track.length, stop) for T in (car.lift.q(theta), got.q)]
    off = abs(ends[1] - ends[0])
    print(f"edges broken by {leg} mm, made without: {off:.1f} mm at the end of the run")
    assert off == pytest.approx(due, rel=0.02)


def test_the_figure_shown_is_that_of_the_rolled_cam(carbon_free_car):
    car = carbon_free_car
    shown = edges_check(car.lift, car.follower, car.actual.curve, AS_DESIGNED, car.car, car.track.length)
    count, stop = 3480, car.lift.blend_start
    theta = (np.arange(count) + 0.5) / count * stop
    outline = car.actual.curve.outline(0.06)
    sharp, off = (
        partial(end_of_run, roll(outline, rod, theta).q, car.car, car.track.length, stop)
        for rod in (car.follower, broken(car.follower, 0.1))
    )
    trimmed = min(abs(off(trim) - sharp()) for trim in np.radians(np.linspace(0.0, 0.04, 81)))
    print(f"{shown.name}: {shown.value:.2f} mm {shown.place}; here {trimmed:.2f} mm by trying trims")
    assert shown.name == "edges broken 0.1 mm more"
    assert shown.value == pytest.approx(abs(off() - sharp()), abs=0.05)
    assert float(shown.place.split()[3]) == pytest.approx(trimmed, abs=0.4)
    assert shown.passed


def test_faces_and_planes_belong_together(carbon_free_car):
    blank = Blank(bore_diameter=8.0, edge_break=0.3)
    rod = replace(carbon_free_car.follower, inner=23.8, outer=26.2)
    assert blank.carrying(23.5, 26.5) == pytest.approx((23.8, 26.2))
    assert blank.faces(rod.inner, rod.outer) == pytest.approx((23.5, 26.5))
    assert rod.land == pytest.approx(2.4)


def test_walls_are_those_of_the_face(carbon_free_car):
    outline = carbon_free_car.actual.curve.outline(0.05)
    sharp, eased = (Blank(bore_diameter=8.0, edge_break=leg).walls(outline)[0].thickness for leg in (0.0, 0.3))
    assert sharp - eased == pytest.approx(0.3)


def checks_of(built, leg, lift=None):
    rod = broken(built.follower, leg)
    lift = lift or built.lift
    profile = actual_profile(lift, rod)
    limits = CheckLimits(
        pressure_angle=PRESSURE_ANGLE_LIMITS["norton_oscillating"],
        lost_lift=1e-3,
        min_convex_radius=0.5,
        cutter_radius=2.0,
        wall=2.0,
    )
    blank = Blank(bore_diameter=8.0, edge_break=leg)
    return {check.name: check for check in check_cam(lift, rod, profile.curve, profile.trims, blank, limits)}


def test_checks_of_broken_edges(carbon_free_car):
    checks = checks_of(carbon_free_car, 1.2)
    assert all(check.passed for check in checks.values())
    lean = checks["lean over the chamfers"]
    steepest = np.abs(carbon_free_car.lift.q(np.linspace(0, 6.283, 20_000))).max()
    assert (lean.value, lean.limit) == (pytest.approx(np.degrees(np.arctan(steepest)), abs=1e-3), CHAMFER_LEAN)
    # The rod must still pass the disc's outer face, at 26.5 mm, not only its land.
    assert checks["rod end beyond the rim"].value == pytest.approx(11.735, abs=2e-3)
    assert checks["convex radius, profile"].limit == 1.2
    assert "lean over the chamfers" not in checks_of(carbon_free_car, 0.0)


def test_a_rod_that_leans_more_than_the_chamfer_is_refused(carbon_free_car):
    lift = carbon_free_car.lift
    steep = replace(lift, q=type(lift.q)(lift.q.c * 4.2, lift.q.x, extrapolate="periodic"))
    lean = checks_of(carbon_free_car, 0.2, steep)["lean over the chamfers"]
    assert 45 < lean.value < 60
    assert not lean.passed
    assert "blank.edge_break_mm" in lean.advice
