"""The exact envelope against closed forms and against a search that knows no calculus."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import PPoly

from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import LeaningRod, published_profile, theoretical_profile
from cadgen.car.path_motion import PathMotion
from cadgen.errors import DesignError

TURN = 2 * np.pi


def harmonic_lift(amplitude: float, order: int, mean: float = 0.0, pieces: int = 720) -> PathMotion:
    """tan(beta) = mean + amplitude cos(order theta), as quintic pieces."""
    from cadgen.curves.piecewise import quintic_hermite

    theta = np.linspace(0, TURN, pieces + 1)
    phase = order * theta
    jets = np.stack(
        [mean + amplitude * np.cos(phase), -order * amplitude * np.sin(phase), -(order**2) * amplitude * np.cos(phase)],
        axis=1,
    )
    return PathMotion(quintic_hermite(theta, jets, periodic=True), np.array([]), TURN - 0.2)


def constant_lift(value: float) -> PathMotion:
    return PathMotion(PPoly(np.array([[value]]), np.array([0.0, TURN]), extrapolate="periodic"), np.array([]), 6.0)


def least_radius(lift: PathMotion, follower: LeaningRod, angle: np.ndarray) -> np.ndarray:
    """Polar radius of the disc that no section cuts: the nearest crossing of each ray with any ellipse."""
    theta = np.concatenate([np.linspace(0, TURN, 40_001), lift.kinks])
    T = lift.q(theta)
    out = np.empty(len(angle))
    for i, phi in enumerate(angle):
        off = (phi - theta + np.pi) % TURN - np.pi
        near = np.abs(off) < 0.1
        c, s = np.cos(off[near]), np.sin(off[near])
        best = np.inf
        for w in (follower.inner, follower.outer):
            d, A, r = follower.base_radius + w * T[near], follower.radius * np.sqrt(1 + T[near] ** 2), follower.radius
            # ((R c - d)/A)^2 + (R s / r)^2 = 1
            qa, qb, qc = (c / A) ** 2 + (s / r) ** 2, -2 * c * d / A**2, (d / A) ** 2 - 1
            root = qb**2 - 4 * qa * qc
            hit = root >= 0
            if hit.any():
                best = min(best, float(((-qb[hit] - np.sqrt(root[hit])) / (2 * qa[hit])).min()))
        out[i] = best
    return out


@pytest.mark.parametrize("tan_beta", [0.0, 0.2, -0.25])
def test_constant_lift_gives_a_circle(tan_beta):
    """The rod leans by beta all round: a circle of radius a + s - r / cos(beta)."""
    follower = LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=2.5)
    curve = actual_profile(constant_lift(tan_beta), follower).curve
    radius = curve.radius(np.linspace(0, TURN, 50))
    expected = 70.0 + follower.lift(np.array(tan_beta)) - 2.5 * np.sqrt(1 + tan_beta**2)
    np.testing.assert_allclose(radius, expected, atol=1e-12)
    assert abs(curve.area() - np.pi * expected**2) < 1e-9


def test_eccentric_circle():
    """A follower so far from the fork that it moves in a straight line: eccentric disc <-> its closed-form lift."""
    far, eccentricity, disc, rod = 1e7, 6.0, 60.0, 2.5
    theta = np.linspace(0, TURN, 1441)
    c, s = np.cos(theta), np.sin(theta)
    root = np.sqrt((disc + rod) ** 2 - eccentricity**2 * s**2)
    d = eccentricity * c + root
    d1 = -eccentricity * s - eccentricity**2 * s * c / root
    d2 = -eccentricity * c - eccentricity**2 * (c**2 - s**2) / root - eccentricity**4 * s**2 * c**2 / root**3
    from cadgen.curves.piecewise import quintic_hermite

    jets = np.stack([d - 60.0, d1, d2], axis=1) / far
    lift = PathMotion(quintic_hermite(theta, jets, periodic=True), np.array([]), 6.0)
    follower = LeaningRod(base_radius=60.0, inner=far, outer=far + 1.0, radius=rod)
    curve = actual_profile(lift, follower).curve
    points = curve.outline(0.5).points
    error = np.hypot(points[:, 0] - eccentricity, points[:, 1]) - disc
    print(f"eccentric circle: largest error {np.abs(error).max() * 1e6:.4f} nm")
    assert np.abs(error).max() < 1e-6
    assert abs(curve.area() - np.pi * disc**2) < 1e-4


@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_equals_the_smallest_radius_of_all_sections(name, request):
    """Independent of the envelope's derivative, kinks, faces and trimming: rays against 40 000 ellipses a face."""
    car = request.getfixturevalue(name)
    angle = np.random.default_rng(5).uniform(0, TURN, 300)
    brute = least_radius(car.lift, car.follower, angle)
    error = brute - car.actual.curve.radius(angle)
    print(f"{name}: brute force minus envelope {error.min() * 1e3:.4f} to {error.max() * 1e3:.4f} um")
    # The search is over a grid, so it can only come out too large: by R'' step^2 / 8 and, at a kink, by its slope.
    assert error.min() > -1e-8
    assert error.max() < 1e-4


def test_pieces_meet_and_run_forward(appendix_car):
    pieces = appendix_car.actual.curve.pieces
    for before, after in zip(pieces, pieces[1:] + pieces[:1], strict=True):
        gap = after.jet(np.array([after.start])).point - before.jet(np.array([before.stop])).point
        assert np.abs(gap).max() < 1e-9
    angle = appendix_car.actual.curve.outline(0.05).angle
    assert (np.diff(angle) > -1e-12).all()
    assert abs(angle[-1] - angle[0] - TURN) < 1e-9


@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_velocity_and_curvature_are_derivatives(name, request):
    for piece in request.getfixturevalue(name).actual.curve.pieces:
        width = piece.stop - piece.start
        if width < 0.02:
            continue
        t = np.linspace(piece.start + 0.1 * width, piece.stop - 0.1 * width, 40)
        # Nodes of the quintic pieces jump in the third derivative: keep the difference step well inside.
        step = 1e-6
        before, at, after = piece.jet(t - step), piece.jet(t), piece.jet(t + step)
        velocity = (after.point - before.point) / (2 * step)
        np.testing.assert_allclose(velocity, at.velocity, atol=1e-5 * np.abs(at.velocity).max())
        turn = np.unwrap(np.arctan2(after.velocity[:, 1], after.velocity[:, 0])) - np.unwrap(
            np.arctan2(before.velocity[:, 1], before.velocity[:, 0])
        )
        turn = (turn + np.pi) % TURN - np.pi
        curvature = turn / (2 * step) / np.linalg.norm(at.velocity, axis=1)
        np.testing.assert_allclose(curvature, at.curvature, atol=1e-4)


def test_faces_change_with_a_true_corner(carbon_free_car):
    """Delta = (w_out - w_in) d(tan beta)/d theta / a at each zero of the lift, 1.3 degrees at most."""
    lift, follower = carbon_free_car.lift, carbon_free_car.follower
    zeros = lift.q.roots(extrapolate=False)
    zeros = np.sort(zeros[np.isfinite(zeros)])
    expected = np.abs(follower.land * lift.q(zeros, nu=1) / follower.base_radius)
    corners = sorted(carbon_free_car.actual.curve.corners(), key=lambda c: np.arctan2(c.point[1], c.point[0]) % TURN)
    turns = np.array([corner.turn for corner in corners])
    print("corners, deg:", np.degrees(turns).round(3), "first order:", np.degrees(expected).round(3))
    assert len(turns) == len(zeros) == 4
    np.testing.assert_allclose(turns, expected, rtol=0.06)
    assert {trim.kind for trim in carbon_free_car.actual.trims} == {"face change"}


@pytest.mark.slow
def test_a_peak_sharper_than_the_rod_is_trimmed_as_local():
    """Sixteen waves of 4 mm on 70 mm: the pitch curve's peaks are sharper than a rod of 6 mm."""
    lift = harmonic_lift(0.16, 16)
    follower = LeaningRod(base_radius=70.0, inner=25.0, outer=26.0, radius=6.0)
    profile = actual_profile(lift, follower)
    assert sum(trim.kind == "local" for trim in profile.trims) == 16
    angle = np.linspace(0, TURN, 60)
    np.testing.assert_allclose(least_radius(lift, follower, angle), profile.curve.radius(angle), atol=1e-4)
    outline = profile.curve.outline(0.05)
    missing = follower.lift(lift.q(0.0)) - roll(outline, follower, np.array([0.0])).lift[0]
    assert missing > 0.01


def test_swallowtails_run_backwards():
    lift = harmonic_lift(0.16, 16)
    piece = LeaningRod(base_radius=70.0, inner=25.0, outer=26.0, radius=6.0).piece(lift, 25.0, 0.0, TURN)
    assert (piece.advance(np.array([0.0])) < 0).all()


def test_nothing_left_of_the_disc():
    follower = LeaningRod(base_radius=8.0, inner=23.5, outer=26.5, radius=4.0)
    with pytest.raises(DesignError, match="nothing is left of the disc"):
        actual_profile(harmonic_lift(0.2, 3), follower)
    with pytest.raises(DesignError, match=r"axis is \d+\.\d+ mm beyond the camshaft"):
        actual_profile(harmonic_lift(0.2, 3), replace(follower, base_radius=2.0, radius=1.0))


def test_theoretical_profile_is_base_plus_lift(carbon_free_car):
    lift, follower = carbon_free_car.lift, carbon_free_car.follower
    theta = np.linspace(0, TURN, 721)[:-1]
    radius = theoretical_profile(lift, follower).radius(theta)
    np.testing.assert_allclose(radius, 70.0 + follower.lift(lift.q(theta)), atol=1e-10)


def test_theoretical_curvature_by_differences(carbon_free_car):
    curve = theoretical_profile(carbon_free_car.lift, carbon_free_car.follower)
    piece = max(curve.pieces, key=lambda p: p.stop - p.start)
    t = np.linspace(piece.start + 0.01, piece.stop - 0.01, 50)
    step = 1e-5
    r0, r1, r2 = (np.linalg.norm(piece.jet(t + k * step).point, axis=1) for k in (-1, 0, 1))
    first, second = (r2 - r0) / (2 * step), (r2 - 2 * r1 + r0) / step**2
    expected = (r1**2 + 2 * first**2 - r1 * second) / (r1**2 + first**2) ** 1.5
    np.testing.assert_allclose(piece.jet(t).curvature, expected, atol=2e-4)


@pytest.mark.parametrize(("name", "stated"), [("carbon_free_car", 0.27), ("appendix_car", 0.36)])
def test_the_published_formula_lifts_too_much(name, stated, request):
    """It rides high, never low. The stated 0.27 and 0.36 mm are lifts at the inner face, where tan(beta) is scaled."""
    car = request.getfixturevalue(name)
    theta = np.linspace(0, TURN, 3600, endpoint=False)
    contact = roll(published_profile(car.lift, car.follower).outline(0.05), car.follower, theta)
    excess = contact.q - car.lift.q(theta)
    at_inner, at_contact = excess * car.follower.inner, contact.lift - car.follower.lift(car.lift.q(theta))
    print(
        f"{name}: published profile lifts too much by {at_inner.max():.3f} mm at the inner face, "
        f"{at_contact.max():.3f} mm at the contact face, {np.sqrt(np.mean(at_contact**2)):.4f} mm rms"
    )
    assert abs(at_inner.max() - stated) < 0.006
    assert at_contact.min() > -1e-3
