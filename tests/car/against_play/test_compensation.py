"""The compensated profile: against a brute-force dilation, on the road, and through every check of the cam."""

import numpy as np
import pytest
from scipy.interpolate import PPoly

from cadgen.arrays import TURN
from cadgen.cam.checks import check_cam
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.car.against_play.compensation import PLATEAU_FALL, VALLEY_SHARE, compensated_lift, lost_dips
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.drive import drive
from cadgen.car.running.play import falls, follow
from cadgen.car.running.run_errors import run_error
from cadgen.car.running.sampled import sampled_lift
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.piecewise import quintic_hermite
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError

PLAY = np.radians(0.962)
CARS = ["carbon_free_car", "appendix_car"]


def dilated(lift: PathMotion, play: float, theta: np.ndarray, cells: int = 400) -> np.ndarray:
    """Greatest tan(beta) over [theta - B, theta], on a grid of the window."""
    return np.max(lift.q(theta[:, None] - np.linspace(0.0, play, cells + 1)), axis=1)


@pytest.mark.parametrize("name", CARS)
def test_is_the_dilation_but_for_plateaus_and_valleys(name, request):
    """Below it by the plateau's fall at most, above it by what the quintic in the valley fills, equal elsewhere."""
    built = request.getfixturevalue(name)
    mine = compensated_lift(built.lift, built.follower, PLAY)
    theta = np.linspace(0.0, TURN, 20001)
    off = built.follower.inner * (mine.q(theta) - dilated(built.lift, PLAY, theta))
    after_peak = (theta - falls(built.lift)[:, :1]) % TURN
    after_valley = (theta - falls(built.lift)[:, 1:]) % TURN
    plateau = (after_peak < 2.5 * PLAY).any(axis=0)
    valley = (np.abs(after_valley - PLAY / 2) < 1.1 * PLAY).any(axis=0)
    # The window's grid misses a maximum by a slope of 0.4 over half a cell of 4.2e-5 rad.
    missed = 0.4 * 25 * 4.2e-5
    assert off[plateau].min() > -1.1 * PLATEAU_FALL
    assert off[plateau & ~valley].max() < missed
    assert -missed < off[valley & ~plateau].min()
    assert off[valley].max() < 0.03
    assert np.abs(off[~plateau & ~valley]).max() < missed


@pytest.mark.parametrize("name", CARS)
def test_the_sliver_in_the_valleys(name, request):
    """With the kink left in, the realised lift is the closing of the wanted one: higher by s'' B^2 / 8 in a valley."""
    built = request.getfixturevalue(name)
    lift, play = built.lift, PLAY / 4
    cam = compensated_lift(lift, built.follower, play, valley_blend=0.0)
    motor = np.linspace(0.0, lift.blend_start, 200001)
    off = follow(cam, play).tan_beta(motor) - lift.q(motor)
    for valley in falls(lift)[:, 1] % TURN:
        if play < valley < lift.blend_start and not np.isclose(valley, lift.kinks).any():
            near = np.abs(motor - valley) < play
            expected = float(lift.q(valley, nu=2)) * play**2 / 8
            assert off[near].max() == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize("name", CARS)
@pytest.mark.parametrize("play_deg", [0.2, 0.724, 0.962, 2.0])
def test_has_the_events_of_the_lift_and_closes_smoothly(name, play_deg, request):
    built = request.getfixturevalue(name)
    play = np.radians(play_deg)
    cam = compensated_lift(built.lift, built.follower, play)
    assert falls(cam).shape == falls(built.lift).shape
    np.testing.assert_allclose(falls(cam)[:, 0], falls(built.lift)[:, 0], atol=1e-9)
    # Valleys come later by up to the play; a hollow kink in the wanted lift at a valley is replaced by the blend.
    waits = falls(cam)[:, 1] - falls(built.lift)[:, 1]
    assert ((waits > 0) & (waits < play)).all()
    assert len(cam.kinks) <= len(built.lift.kinks)
    step = 1e-9
    for joint in cam.q.x[:-1]:
        if not np.isclose(joint, cam.kinks, atol=1e-8).any():
            for order, allowed in ((0, 1e-8), (1, 1e-6), (2, 1e-3)):
                jump = cam.q(joint + step, nu=order) - cam.q(joint - step, nu=order)
                assert abs(jump) < allowed, (np.degrees(joint), order)


@pytest.mark.parametrize("name", CARS)
@pytest.mark.parametrize(("off_by", "least"), [(1.0, 0.99), (0.9, 0.88), (1.1, 0.88)])
def test_takes_the_error_off_on_the_rolled_profile(name, off_by, least, request):
    """Cut, rolled against the rod and driven with play: 99 % at the play it is made for, 88 % at 10 % off."""
    built = request.getfixturevalue(name)
    cam = compensated_lift(built.lift, built.follower, PLAY)
    theta = np.linspace(0.0, TURN, 3600, endpoint=False)
    contact = roll(actual_profile(cam, built.follower).curve.outline(0.06), built.follower, theta)
    rolled = sampled_lift(theta, contact.q, blend_start=built.lift.blend_start)
    length = built.track.length
    planned = drive(built.lift, built.car, length)
    before = run_error(drive(built.lift, built.car, length, play=PLAY), planned)
    after = run_error(drive(rolled, built.car, length, play=off_by * PLAY), planned)
    heading, distance = 1 - abs(after.end_heading / before.end_heading), 1 - after.end_distance / before.end_distance
    print(f"{name}, play {off_by:g} of its own: {100 * heading:.2f} % off heading, {100 * distance:.2f} % off position")
    assert heading > least
    assert distance > least


def test_costs_of_the_plateau_and_the_valley(carbon_free_car):
    """A kinked valley errs less, a wider blend more, and neither comes near a percent of what was there."""
    built = carbon_free_car
    length = built.track.length
    planned = drive(built.lift, built.car, length)

    def heading(fall: float, share: float) -> float:
        cam = compensated_lift(built.lift, built.follower, PLAY, plateau_fall=fall, valley_blend=share * PLAY)
        return np.degrees(run_error(drive(cam, built.car, length, play=PLAY), planned).end_heading)

    by_blend = [heading(PLATEAU_FALL, share) for share in (0.0, 0.1, VALLEY_SHARE, 0.5)]
    by_fall = [heading(fall, VALLEY_SHARE) for fall in (0.0005, 0.002, PLATEAU_FALL, 0.01)]
    print("heading error in degrees with a valley blend of 0, 0.1, 0.25, 0.5 of the play:", np.round(by_blend, 4))
    print("with a plateau's fall of 0.5, 2, 5, 10 um:", np.round(by_fall, 4))
    assert (np.diff(np.abs(by_blend)) > 0).all()
    assert (np.diff(by_fall) > 0).all()
    assert np.abs([*by_blend, *by_fall]).max() < 0.03


def test_passes_every_check_of_the_cam(carbon_free_car):
    built = carbon_free_car
    design = load_design("carbon_free_car")
    cam = compensated_lift(built.lift, built.follower, PLAY)
    profile = actual_profile(cam, built.follower)
    checks = check_cam(
        cam,
        built.follower,
        profile.curve,
        profile.trims,
        cam_model.blank(design),
        cam_model.check_limits(design),
        application=blend_checks,
    )
    assert len(checks) > 10
    assert not [check for check in checks if not check.passed]


def least_concave_radius(curve: ClosedCurve) -> float:
    curvature = np.concatenate([p.jet(np.linspace(p.start, p.stop, 20001)[1:-1]).curvature for p in curve.pieces])
    return float(-1 / curvature.min())


def test_a_kinked_valley_is_rounded_by_the_rod(carbon_free_car):
    """Without a blend the profile's hollow has the rod's section, r^2 / A at its sharpest; with one, a wider radius."""
    built = carbon_free_car
    rod = built.follower.radius
    kinked = actual_profile(compensated_lift(built.lift, built.follower, PLAY, valley_blend=0.0), built.follower)
    blended = actual_profile(compensated_lift(built.lift, built.follower, PLAY), built.follower)
    assert 0.9 * rod < least_concave_radius(kinked.curve) < rod
    assert least_concave_radius(blended.curve) > 1.5 * rod
    # What corners are left are those of the changes of face, which the uncompensated profile has too.
    assert {trim.kind for trim in blended.trims} == {"face change"}
    assert len(blended.curve.corners()) == len(blended.trims) == len(built.actual.trims)


def test_a_lift_of_kinks(carbon_free_car):
    """Straight flanks that meet in a sharp peak and valley: the realised valley is level, a B / 2 high."""
    slope, play = 0.4 / TURN, 0.05
    straight = PPoly(np.array([[slope, -slope], [0.0, 0.2]]), np.array([0.0, TURN / 2, TURN]), extrapolate="periodic")
    wanted = PathMotion(straight, np.array([0.0, TURN / 2]), 6.0)
    cam = compensated_lift(wanted, carbon_free_car.follower, play, valley_blend=0.0, plateau_fall=1e-3)
    motor = np.linspace(1.0, 1.0 + TURN, 20001)
    off = follow(cam, play).tan_beta(motor) - wanted.q(motor)
    assert off.max() == pytest.approx(slope * play / 2, rel=0.01)  # the grid misses the kink by up to 0.6 %
    assert off.min() > -1.1e-3 / carbon_free_car.follower.inner
    waiting = np.abs(motor - TURN) < 0.49 * play
    np.testing.assert_allclose(cam.q(follow(cam, play).cam_angle(motor[waiting])), slope * play / 2, rtol=1e-9)


def test_no_play_changes_nothing(carbon_free_car):
    assert compensated_lift(carbon_free_car.lift, carbon_free_car.follower, 0.0) is carbon_free_car.lift


@pytest.mark.parametrize("play_deg", [1e-9, 1e-3, 0.003, 0.01, 0.02])
def test_a_play_narrower_than_the_rounding_costs_no_more_than_that(play_deg, carbon_free_car):
    """Off by the dilation itself, slope times play, and by what a mean over 0.1 degrees fills: s'' h^2/2."""
    built, play = carbon_free_car, np.radians(play_deg)
    mine = compensated_lift(built.lift, built.follower, play)
    theta = np.linspace(0.0, built.lift.blend_start, 20001)
    slope, curvature = (np.abs(built.lift.q(theta, order)).max() for order in (1, 2))
    off = np.abs(mine.q(theta) - built.lift.q(theta)).max()
    assert off < slope * play + curvature * np.radians(0.1) ** 2 / 2 + PLATEAU_FALL / built.follower.outer


def test_refuses_what_is_no_play_or_plateau(carbon_free_car):
    built = carbon_free_car
    for play in (-0.01, float("nan")):
        with pytest.raises(DesignError, match="must be 0 or more"):
            compensated_lift(built.lift, built.follower, play)
    with pytest.raises(DesignError, match="the fall must be above 0"):
        compensated_lift(built.lift, built.follower, PLAY, plateau_fall=0.0)


def test_what_is_lost_of_a_rough_lift_is_its_brute_force_closing():
    """Ripples by the hundred, in number and depth as waypoints give them that were rounded."""
    nodes = np.linspace(0.0, TURN, 1201)
    rng = np.random.default_rng(5)
    jets = np.zeros((len(nodes), 3))
    jets[:, 0] = 0.1 * np.sin(3 * nodes) + 1e-3 * rng.uniform(-1, 1, len(nodes))
    jets[-1] = jets[0]
    rough = PathMotion(quintic_hermite(nodes, jets, periodic=True), np.array([]), TURN)
    lost = lost_dips(rough, PLAY)
    assert len(lost) > 100
    for dip in lost[::11]:
        windows = dip.cam_angle + np.linspace(0.0, PLAY, 257)
        closed = dilated(rough, PLAY, windows, 2000).min()
        assert dip.tan_beta == pytest.approx(closed - rough.q(dip.cam_angle), abs=2e-6)
