"""Rolling: against closed forms, against brute force, its order, and then as the judge of the envelope."""

from dataclasses import dataclass

import numpy as np
import pytest

from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.followers.rod import LeaningRod, theoretical_profile
from cadgen.curves.closed import ClosedCurve, Jet, Outline
from cadgen.errors import DesignError

TURN = 2 * np.pi
FOLLOWER = LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=2.5)


def circle(radius: float, centre: float = 0.0, count: int = 7200) -> Outline:
    angle = np.linspace(0, TURN, count + 1)
    points = np.stack([centre + radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    return Outline(points, np.zeros(len(points), dtype=np.intp))


@pytest.mark.parametrize("radius", [63.0, 67.5, 74.0])
def test_concentric_circle_leans_by_a_closed_form(radius):
    """a + w T - r sqrt(1 + T^2) = R at the face that carries."""
    contact = roll(circle(radius), FOLLOWER, np.linspace(0, 6, 20))
    T, w = contact.q, contact.face
    np.testing.assert_allclose(70.0 + w * T - 2.5 * np.sqrt(1 + T**2), radius, atol=1e-9)
    assert (w == (FOLLOWER.outer if radius < 67.5 else FOLLOWER.inner)).all()
    np.testing.assert_allclose(contact.pressure_angle, 0.0, atol=2e-5)


def test_eccentric_circle_far_from_the_fork():
    """d = e cos + sqrt((R + r)^2 - e^2 sin^2), the textbook eccentric (Norton, Design of Machinery, ch. 8)."""
    far = LeaningRod(base_radius=60.0, inner=1e7, outer=1e7 + 1, radius=2.5)
    theta = np.linspace(0, TURN, 360, endpoint=False)
    contact = roll(circle(60.0, 6.0), far, theta)
    exact = 6 * np.cos(theta) + np.sqrt(62.5**2 - 36 * np.sin(theta) ** 2) - 60.0
    np.testing.assert_allclose(contact.lift, exact, atol=2e-6)
    # Straight-line follower: tan(pressure angle) = (ds/dtheta) / (a + s).
    slope = -6 * np.sin(theta) - 36 * np.sin(theta) * np.cos(theta) / np.sqrt(62.5**2 - 36 * np.sin(theta) ** 2)
    np.testing.assert_allclose(contact.pressure_angle, np.arctan(slope / (60.0 + exact)), atol=1e-4)


def test_the_parabola_makes_rolling_third_order_or_better():
    fine = roll(circle(60.0, 9.0, 400_000), FOLLOWER, np.linspace(0, 6, 50)).lift
    errors = [
        np.abs(roll(circle(60.0, 9.0, n), FOLLOWER, np.linspace(0, 6, 50)).lift - fine).max() for n in (600, 1200)
    ]
    order = np.log2(errors[0] / errors[1])
    print(f"order {order:.2f}; {errors[1] * 1e3:.5f} um at {TURN * 60 / 1200:.2f} mm")
    assert order > 2.7


@dataclass(frozen=True)
class Eccentric:
    """A circle about a point beside the camshaft, by its own angle."""

    radius: float
    off: float
    start: float = 0.0
    stop: float = TURN

    def jet(self, t):
        c, s = np.cos(t), np.sin(t)
        point = np.stack([self.off + self.radius * c, self.radius * s], axis=1)
        return Jet(point, self.radius * np.stack([-s, c], axis=1), np.full(len(t), 1 / self.radius))


@pytest.mark.slow
@pytest.mark.parametrize("off", [10.0, 18.0, 19.5, 19.9])
@pytest.mark.parametrize("rod", [0.3, 1.25, 4.0])
def test_steep_flanks_are_rolled_until_nothing_is_left(off, rod):
    """A textbook eccentric at pressure angles up to 80 degrees: steps that agree by chance do not end the rolling."""
    far = LeaningRod(base_radius=20.0, inner=1e7, outer=1e7 + 1, radius=rod)
    theta = np.linspace(0, TURN, 3600, endpoint=False)
    contact, step = roll_curve(ClosedCurve((Eccentric(20.0, off),)), far, theta)
    reach = 20.0 + rod
    exact = off * np.cos(theta) + np.sqrt(reach**2 - off**2 * np.sin(theta) ** 2) - 20.0
    error = np.abs(contact.lift - exact).max() * 1e3
    steepest = np.degrees(np.arcsin(off / reach))
    print(f"rod {rod} mm, up to {steepest:.1f} degrees: {error:.4f} um at steps down to {step:.4f} mm")
    assert error < 0.005


def test_brute_force_in_space(carbon_free_car):
    """Push a solid cylinder down on 40 parallel slices of the disc by bisection: no formula of `contact` is used."""
    follower = carbon_free_car.follower
    points = carbon_free_car.actual.curve.outline(0.02).points
    widths = np.linspace(follower.inner, follower.outer, 41)
    stations = np.radians([20.0, 91.3, 112.2, 129.4, 160.0, 178.6, 235.0, 300.0, 355.0])
    expected = roll(carbon_free_car.actual.curve.outline(0.02), follower, stations)
    for theta, tan_beta in zip(stations, expected.q, strict=True):
        c, s = np.cos(theta), np.sin(theta)
        turned = points @ np.array([[c, -s], [s, c]])
        near = turned[(np.abs(turned[:, 1]) < 3) & (turned[:, 0] > 0)]
        solid = np.concatenate([np.column_stack([near, np.full(len(near), w)]) for w in widths])
        low, high = -0.6, 0.6
        for _ in range(60):
            T = (low + high) / 2
            axis = np.array([T, 0.0, 1.0]) / np.sqrt(1 + T**2)
            offset = solid - np.array([follower.base_radius, 0.0, 0.0])
            distance = np.linalg.norm(offset - np.outer(offset @ axis, axis), axis=1)
            ahead = (offset[:, 0] - offset[:, 2] * T) > 0  # past the axis is inside just as well
            cut = np.any((distance < follower.radius) | ahead)
            low, high = (T, high) if cut else (low, T)
        assert abs(high - tan_beta) * follower.outer < 5e-5


@pytest.mark.parametrize("name", ["carbon_free_car"])
def test_the_actual_profile_gives_its_lift_back(name, request):
    car = request.getfixturevalue(name)
    theta = np.linspace(0, TURN, 36_000, endpoint=False)
    error = (
        roll(car.actual.curve.outline(0.03), car.follower, theta).lift - car.follower.lift(car.lift.q(theta))
    ) * 1e3
    in_trim = np.zeros(len(theta), dtype=bool)
    for trim in car.actual.trims:
        in_trim |= (theta - trim.before) % TURN <= trim.after - trim.before
    print(
        f"{name}: {np.abs(error[~in_trim]).max():.4f} um away from face changes, {-error[in_trim].min():.3f} um there"
    )
    assert np.abs(error[~in_trim]).max() <= 0.05
    slope = car.lift.q(np.radians(112.3), nu=1)
    turn = car.follower.land * slope / car.follower.base_radius
    closed_form = car.follower.radius * turn**2 / 8 * 1e3
    print(f"closed form at 112.3 deg: {closed_form:.3f} um")
    assert -error[in_trim].min() < closed_form * 1.15


def test_undercut_corners_lose_the_closed_form(appendix_car):
    """r (1/cos(delta/2) - 1) along the normal at each convex corner of angle delta, / cos(pressure angle) as lift."""
    from cadgen.cam.lost_lift import lost_lift

    lift, follower = appendix_car.lift, appendix_car.follower
    losses = [
        loss
        for loss in lost_lift(lift, follower, appendix_car.actual.trims, appendix_car.actual.curve.outline(0.02))
        if loss.trim.kind == "local"
    ]
    assert len(losses) == 6
    for loss in losses:
        kink = lift.kinks[np.argmin(np.abs(lift.kinks - loss.cam_angle))]
        w = float(follower.contact_face(lift.q(kink)))
        slopes = [np.arctan2(w * lift.q(kink + side, nu=1), 70.0 + w * lift.q(kink)) for side in (-1e-9, 1e-9)]
        delta, pressure = slopes[0] - slopes[1], sum(slopes) / 2
        expected = follower.radius * (1 / np.cos(delta / 2) - 1) / np.cos(pressure) * 1e3
        lost = loss.lift * 1e3
        print(
            f"{np.degrees(kink):8.3f}°: corner {np.degrees(delta):6.3f}°, lost {lost:7.3f}, closed {expected:7.3f} µm"
        )
        assert abs(lost - expected) < 0.5


def test_a_knife_edge_reads_the_radius(carbon_free_car):
    follower = LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=0.0)
    theta = np.linspace(0, TURN, 500)
    curve = theoretical_profile(carbon_free_car.lift, carbon_free_car.follower)
    error = roll(curve.outline(0.03), follower, theta).lift - follower.lift(carbon_free_car.lift.q(theta))
    assert np.abs(error).max() < 2e-5  # linear interpolation over 0.03 mm


def test_refuses_what_does_not_enclose_the_camshaft():
    with pytest.raises(DesignError, match="closed curve run once round the camshaft"):
        roll(circle(5.0, 20.0), FOLLOWER, np.array([0.0]))
    backwards = circle(67.0)
    with pytest.raises(DesignError, match="closed curve"):
        roll(Outline(backwards.points[::-1], backwards.piece), FOLLOWER, np.array([0.0]))


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("radius", [-0.3, 0.01])
def test_refuses_a_follower_that_falls_between_the_points(radius):
    angle = np.linspace(0, 2 * np.pi, 401)
    outline = Outline(40 * np.stack([np.cos(angle), np.sin(angle)], axis=1), np.zeros(len(angle), dtype=int))
    rod = LeaningRod(base_radius=40.0, inner=25.0, outer=28.0, radius=radius)
    with pytest.raises(DesignError, match="falls between the points of the outline at cam angle"):
        roll(outline, rod, np.linspace(0, 6, 50))
