"""Forces: published examples to their digits, statics solved beside them, energy of a turn, Hertz by its table."""

from dataclasses import replace
from math import degrees, inf, pi, radians, sqrt

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from cadgen.arrays import TURN
from cadgen.cam.contact import roll_curve
from cadgen.cam.derived_motions import OppositeMotion
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.flat import FlatFace
from cadgen.cam.followers.groove import pressed_outwards
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Roller
from cadgen.cam.followers.swinging_flat import SwingingFace
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.cam.forces import CamForces, Dynamics, Guide, Line, Load, joint_modulus
from cadgen.laws.segments import MotionSpan, SegmentMotion
from cadgen.laws.series import HarmonicMotion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM, RAD

STEEL = joint_modulus((206_000.0, 0.3), (206_000.0, 0.3))


def motion(*spans, unit=MM):
    segments, at, height = [], 0.0, 0.0
    for angle, after, law in spans:
        stop = at + angle
        segments.append(MotionSpan(radians(at), radians(stop), height, after, law and law_of(law)))
        at, height = stop, after
    return SegmentMotion.of(segments, unit)


def rpm(speed):
    return speed * TURN / 60


NORTON = motion((90, 10.0, "polynomial_3_4_5"), (45, 10.0, None), (180, 0.0, "polynomial_3_4_5"), (45, 0.0, None))
NORTON_BODY = Dynamics(inertia=7.5e-3, rate=0.1, preload=10.0, damping=2.74e-3)
NORTON_FORCES = CamForces(NORTON, Roller(base=63.7, radius=12.5), NORTON_BODY, 10.0)


def peaks(forces, figure):
    high, low = forces.motion.extremes_of(figure)
    return (high.value, degrees(high.cam_angle)), (low.value, degrees(low.cam_angle))


def test_example_1_a_spring_too_weak():
    """Cycloid of 10 mm in 120°, 1000 rev/min, 1.8 kg, 15 N/mm compressed by 2.5 mm: at 100° it leaves."""
    rise = motion((120, 10.0, "cycloidal"), (240, 0.0, "cycloidal"))
    forces = CamForces(
        rise, Roller(base=40.0, radius=10.0), Dynamics(inertia=1.8e-3, rate=15.0, preload=37.5), rpm(1000)
    )
    at = np.radians([100.0])
    jets = rise.jets(at)
    assert forces.resting(jets, at)[0] == pytest.approx(183.1748, abs=5e-5)
    assert forces.along(jets, at)[0] - forces.resting(jets, at)[0] == pytest.approx(-244.8629, abs=5e-5)
    assert forces.along(jets, at)[0] == pytest.approx(-61.6881, abs=5e-5)
    assert forces.lift_off.value * 60 / TURN == pytest.approx(779.83, abs=5e-3)
    assert degrees(forces.lift_off.cam_angle) == pytest.approx(86.9, abs=0.05)
    # With the same compression, the rate that would hold it: (k s + 2.5 k) >= -m a everywhere.
    held = replace(forces.dynamics, rate=24.666, preload=24.666 * 2.5)
    least = rise.extremes_of(replace(forces, dynamics=held).along)[1]
    assert least.value == pytest.approx(0.0, abs=5e-3)


def test_example_2_after_norton():
    forces = NORTON_FORCES
    (most, at_most), (least, at_least) = peaks(forces, forces.along)
    assert (most, least) == (pytest.approx(27.7644, abs=5e-5), pytest.approx(-6.4710, abs=5e-5))
    np.testing.assert_allclose([at_most, at_least], [19.29, 71.01], atol=5e-3)
    assert forces.lift_off.value == pytest.approx(7.9345, abs=5e-5)
    (torque, _), (back, _) = peaks(forces, forces.torque)
    np.testing.assert_allclose([torque * 1e-3, back * 1e-3], [0.22696, -0.06800], atol=5e-6)
    assert forces.work * 1e-3 == pytest.approx(3.738e-3, abs=5e-7)
    assert forces.mean_torque * 10 * 1e-3 == pytest.approx(5.95e-3, abs=5e-6)
    ((start, stop),) = forces.leaves
    np.testing.assert_allclose(np.degrees([start, stop]), [56.66, 83.02], atol=5e-3)
    assert forces.least_rate() == pytest.approx(0.7965, abs=5e-5)
    assert forces.least_preload() == pytest.approx(16.47, abs=5e-3)
    power = max(abs(peak.value) for peak in NORTON.extremes_of(forces.torque)) * 10 * 1e-3
    assert power == pytest.approx(2.27, abs=5e-3)


def test_example_5_an_eccentric_that_jumps():
    """Jump at sqrt((P + 2 k e) / (m e)) = 49.0653 rad/s; at 500 rev/min it leaves from 142.66 to 217.34°."""
    eccentric = HarmonicMotion.of([(0, 15.0, 0.0), (1, -15.0, 0.0)], MM)
    forces = CamForces(eccentric, FlatFace(base=25.0), Dynamics(inertia=0.9e-3, rate=1.0, preload=2.5), rpm(500))
    assert forces.lift_off.value == pytest.approx(sqrt((2.5 + 30.0) / (0.9e-3 * 15.0)), rel=1e-9)
    assert forces.lift_off.value * 60 / TURN == pytest.approx(468.539, abs=5e-4)
    ((start, stop),) = forces.leaves
    np.testing.assert_allclose(np.degrees([start, stop]), [142.66, 217.34], atol=5e-3)
    (torque, _), (back, _) = peaks(forces, forces.torque)
    assert torque == pytest.approx(371.007, abs=5e-4)
    assert back == pytest.approx(-371.007, abs=5e-4)
    assert (
        abs(forces.work)
        < 1e-9 * quad(lambda x: abs(forces.torque(eccentric.jets(np.array([x])), np.array([x]))[0]), 0, TURN)[0]
    )


# Figures of another program: force along the motion, normal force, lift-off, torque, pressure, each with its place.
FEEDER = motion((80, 14.0, "polynomial_3_4_5"), (50, 14.0, None), (110, 0.0, "modified_sine"), (120, 0.0, None))
VALVE = motion((120, 10.0, "cycloidal"), (30, 10.0, None), (150, 0.0, "polynomial_4_5_6_7"), (60, 0.0, None))
ARM = motion(
    (100, radians(14), "modified_trapezoid"),
    (40, radians(14), None),
    (60, radians(9), "cycloidal"),
    (30, radians(9), None),
    (90, 0.0, "modified_sine"),
    (40, 0.0, None),
    unit=RAD,
)
OTHER = {
    "roller": (
        CamForces(
            FEEDER,
            Roller(base=32.0, radius=9.0, offset=8.0),
            Dynamics(
                inertia=0.85e-3,
                rate=9.0,
                preload=60.0,
                damping=0.002,
                load=15.0,
                line=Line(width=8.0, modulus=STEEL, radius=9.0),
            ),
            rpm(420),
        ),
        ((201.0, 80.0), (75.0, 0.0), (203.177, 80.0), (76.4698, 0.0), (706.743, 61.815)),
        ((2679.7, 36.198), (-1777.09, 180.412), 4.75642, (348.78, 80.0)),
    ),
    "flat": (
        CamForces(
            VALVE,
            FlatFace(base=28.0),
            Dynamics(inertia=0.3e-3, rate=12.0, preload=80.0, line=Line(width=12.0, modulus=STEEL, radius=inf)),
            rpm(900),
        ),
        ((200.0, 120.0), (80.0, 0.0), (200.0, 120.0), (80.0, 0.0), (1997.46, 87.835)),
        ((1336.9, 60.007), (-1174.03, 222.392), 0.0, (141.336, 92.483)),
    ),
    "swinging roller": (
        CamForces(
            ARM,
            SwingingRoller(base=38.0, radius=8.0, arm=72.0, centre_distance=88.0, lifts=Lifts.WITH),
            Dynamics(inertia=0.9, rate=18_000.0, preload=2600.0, line=Line(width=7.0, modulus=STEEL, radius=8.0)),
            rpm(250),
        ),
        ((6998.23, 100.0), (2600.0, 0.0), (98.488, 100.0), (36.1925, 0.0), (1178.25, 155.36)),
        ((1374.98, 53.897), (-1036.46, 169.412), 0.0, (274.176, 152.604)),
    ),
}


@pytest.mark.parametrize("name", OTHER)
def test_forces_are_those_of_another_program(name):
    forces, (along, least, normal, weakest, off), (torque, back, mean, pressure) = OTHER[name]
    for figure, pair in (
        (forces.along, (along, least)),
        (forces.normal, (normal, weakest)),
        (forces.torque, (torque, back)),
    ):
        for (found, place), (value, angle) in zip(peaks(forces, figure), pair, strict=True):
            assert found == pytest.approx(value, rel=1e-5)
            assert place == pytest.approx(angle, abs=0.02)
    assert forces.lift_off.value * 60 / TURN == pytest.approx(off[0], rel=1e-5)
    assert degrees(forces.lift_off.cam_angle) == pytest.approx(off[1], abs=0.02)
    assert forces.mean_torque == pytest.approx(mean, rel=1e-5, abs=1e-6)
    (found, place), _ = peaks(forces, forces.pressure)
    assert found == pytest.approx(pressure[0], rel=1e-4)
    assert place == pytest.approx(pressure[1], abs=0.1)
    assert forces.leaves == ()


FOLLOWERS = {
    "roller": (FEEDER, Roller(base=32.0, radius=9.0, offset=8.0)),
    "tilted flat": (VALVE, FlatFace(base=28.0, tilt=radians(10), offset=4.0)),
    "with": (ARM, OTHER["swinging roller"][0].follower),
    "against": (ARM, replace(OTHER["swinging roller"][0].follower, lifts=Lifts.AGAINST)),
    "swinging flat": (
        ARM,
        SwingingFace(base=45.0, face_offset=5.0, centre_distance=95.0, lifts=Lifts.AGAINST),
    ),
}


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_torque_is_the_normal_force_times_its_lever(name):
    """By rolling: the outline's normal at the contact has a lever about the camshaft, and N times it is F q'."""
    moved, follower = FOLLOWERS[name]
    forces = CamForces(moved, follower, Dynamics(preload=100.0), 0.0)
    curve = actual_profile(moved, follower).curve
    theta = np.linspace(0.0, TURN, 360, endpoint=False) + 0.001
    contact, _ = roll_curve(curve, follower, theta)
    jet, _ = curve.at_angle(follower.place(contact))
    tangent = jet.velocity / np.linalg.norm(jet.velocity, axis=1, keepdims=True)
    lever = (jet.point * tangent).sum(axis=1)  # of the normal about the camshaft
    jets = moved.jets(theta)
    found = forces.normal(jets, theta) * lever
    torque = forces.torque(jets, theta)
    assert np.abs(found - torque).max() < 2e-4 * np.abs(torque).max()
    radius = follower.profile_radius(*jets[:, :3].T)
    curved = np.abs(jet.curvature) > 1e-4
    np.testing.assert_allclose(1 / radius[curved], jet.curvature[curved], atol=2e-4)


def test_damping_is_all_the_work_of_a_turn():
    """The integral of T is that of c w q'^2: springs, inertia, weight and a load by angle of no sum give nothing."""
    body = replace(NORTON_BODY, weight=73.5)
    forces = replace(NORTON_FORCES, dynamics=body)
    size = quad(lambda x: abs(float(forces.torque(NORTON.jets(np.array([x])), np.array([x]))[0])), 0, TURN, limit=200)[
        0
    ]
    lost = sum(
        quad(lambda x: body.damping * 10.0 * float(NORTON.jets(np.array([x]))[0, 1]) ** 2, a, b, epsabs=1e-13)[0]
        for a, b in ((0, pi / 2), (3 * pi / 4, 7 * pi / 4))
    )
    assert abs(forces.work - lost) < 1e-9 * size
    assert abs(replace(forces, dynamics=replace(body, damping=0.0)).work) < 1e-9 * size


def test_a_guide_jams_by_its_statics():
    """Two forces of the guide and their friction, solved as three equations of equilibrium beside the closed form."""
    friction, length, overhang = 0.15, 60.0, 40.0
    guide = Guide(friction=friction, length=length, overhang=overhang)
    forces = CamForces(FEEDER, Roller(base=32.0, radius=9.0), Dynamics(preload=100.0, guide=guide), 0.0)
    theta = np.radians([20.0, 40.0, 60.0, 170.0, 200.0])
    jets = FEEDER.jets(theta)
    y0 = 41.0
    for row, angle in zip(jets, theta, strict=True):
        alpha = np.arctan2(row[1], y0 + row[0])
        down = np.sign(row[1])  # friction acts against the motion
        # Unknown: N, and the forces R1 (at the end near the contact) and R2 across the slide, whose friction is mu |R|.
        side = np.sign(alpha)
        equations = [
            [np.cos(alpha), -down * friction * side, -down * friction * side],
            [np.sin(alpha), -1.0, 1.0],
            [0.0, overhang, -(overhang + length)],
        ]
        normal, near, far = np.linalg.solve(equations, [100.0, 0.0, 0.0])
        assert near * side > 0
        assert far * side > 0
        found = forces.normal(np.array([row]), np.array([angle]))[0]
        assert found == pytest.approx(normal, rel=1e-12)
    tight = replace(forces, dynamics=replace(forces.dynamics, guide=replace(guide, friction=1.4)))
    assert tight.jams.value < 0
    steepest = FEEDER.extremes_of(lambda jets, theta: jets[:, 1] / (y0 + jets[:, 0]))[0].value
    limit = brentq(
        lambda mu: replace(forces, dynamics=replace(forces.dynamics, guide=replace(guide, friction=mu))).jams.value,
        0.1,
        1.4,
    )
    assert length / (limit * (2 * overhang + length)) == pytest.approx(steepest, rel=1e-9)


def test_two_rollers_of_steel():
    """10 mm of radius each, 10 mm wide, 1000 N: 848.86 MPa."""
    round_disc = HarmonicMotion.of([(0, 0.0, 0.0)], MM)
    line = Line(width=10.0, modulus=STEEL, radius=10.0)
    forces = CamForces(round_disc, Roller(base=10.0, radius=10.0), Dynamics(preload=1000.0, line=line), 0.0)
    jets, theta = round_disc.jets(np.array([1.0])), np.array([1.0])
    assert forces.pressure(jets, theta)[0] == pytest.approx(848.86, abs=5e-3)


def test_lift_off_by_brute_force():
    """Least speed at which the force along the motion is negative anywhere, by bisection over whole turns."""
    theta = np.linspace(0.0, TURN, 20_001)
    jets = NORTON.jets(theta)

    def least(speed):
        return replace(NORTON_FORCES, speed=speed).along(jets, theta).min()

    assert brentq(least, 1.0, 50.0) == pytest.approx(NORTON_FORCES.lift_off.value, rel=1e-6)
    fast = replace(NORTON_FORCES, dynamics=replace(NORTON_BODY, damping=2.0))
    assert brentq(lambda speed: replace(fast, speed=speed).along(jets, theta).min(), 0.01, 50.0) == pytest.approx(
        fast.lift_off.value, rel=1e-6
    )
    standing = replace(NORTON_FORCES, dynamics=replace(NORTON_BODY, preload=-1.0))
    assert standing.lift_off.value == 0.0
    massless = replace(NORTON_FORCES, dynamics=Dynamics(preload=1.0))
    assert massless.lift_off.value == inf


def test_a_load_by_angle_goes_straight_from_row_to_row():
    load = Load(cam_angle=np.radians([0.0, 90.0, 270.0]), value=np.array([10.0, 30.0, 10.0]))
    np.testing.assert_allclose(load.at(np.radians([0.0, 45.0, 180.0, 315.0, 360.0])), [10, 20, 20, 10, 10])
    forces = replace(NORTON_FORCES, dynamics=Dynamics(load=load))
    expected = quad(
        lambda x: load.at(x) * NORTON.jets(np.array([x]))[0, 1],
        0,
        TURN,
        points=[pi / 2, 3 * pi / 4, 1.5 * pi, 7 * pi / 4],
        limit=200,
    )[0]
    assert forces.work == pytest.approx(expected, rel=1e-9)


def test_a_closed_follower_changes_its_flank():
    """Modified sine of 25 mm in 110°, 2 kg, 300 rev/min: 74.0107 N at 13.75°, the flank changes at 55 and 215°."""
    moved = motion((110, 25.0, "modified_sine"), (50, 25.0, None), (110, 0.0, "modified_sine"), (90, 0.0, None))
    forces = CamForces(moved, Roller(base=45.0, radius=10.0), Dynamics(inertia=2e-3), rpm(300), closed=True)
    (most, place), _ = peaks(forces, forces.along)
    assert (most, place) == (pytest.approx(74.0107, abs=5e-5), pytest.approx(13.75, abs=1e-4))
    np.testing.assert_allclose(np.degrees(forces.leaves), [[55, 110], [160, 215]], atol=1e-6)
    assert abs(forces.work) < 1e-9 * most * 25


def test_the_second_disc_carries_where_the_first_does_not():
    """Rollers of one slide across the camshaft: the second one's own pressure angle takes the force."""
    second = Roller(base=54.0, radius=9.0)
    forces = CamForces(FEEDER, Roller(base=38.0, radius=9.0), Dynamics(inertia=1e-3), rpm(300), True, second)
    at = np.radians([60.0])
    jets = FEEDER.jets(at)
    alpha = np.arctan2(-jets[0, 1], 63.0 - jets[0, 0])
    assert forces.along(jets, at)[0] < 0
    assert forces.normal(jets, at)[0] == pytest.approx(forces.along(jets, at)[0] / np.cos(alpha), rel=1e-12)


def test_stretches_that_leave_across_the_start():
    shifted = HarmonicMotion.of([(0, 15.0, 0.0), (1, 15.0, 0.0)], MM)
    forces = CamForces(shifted, FlatFace(base=25.0), Dynamics(inertia=0.9e-3, rate=1.0, preload=2.5), rpm(500))
    ((start, stop),) = forces.leaves
    np.testing.assert_allclose(np.degrees([start, stop]), [322.66, 397.34], atol=5e-3)
    assert replace(forces, dynamics=Dynamics(preload=-1.0)).leaves == ((0.0, TURN),)


def test_a_weight_presses_on_the_disc_at_180_degrees():
    """At rest and without a spring the disc bears the weight, or nothing, or the follower hangs from it."""
    at = np.array([radians(110)])  # in a dwell: the pressure angle is 0
    jets = NORTON.jets(at)
    for angle, force in ((180.0, 2.0), (90.0, 0.0), (0.0, -2.0), (120.0, 1.0)):
        body = Dynamics(weight=2.0, downhill=radians(angle))
        found = CamForces(NORTON, Roller(base=63.7, radius=12.5), body, 0.0).normal(jets, at)[0]
        assert found == pytest.approx(force, abs=1e-12)


SWUNG = motion(
    (100, radians(25), "modified_sine"), (60, radians(25), None), (100, 0.0, "cycloidal"), (100, 0.0, None), unit=RAD
)


@pytest.mark.parametrize("lifts", list(Lifts))
@pytest.mark.parametrize("down", [180.0, 120.0, -70.0, 0.0])
def test_the_weight_of_an_arm_is_what_its_height_asks_for(lifts, down):
    """Work of a virtual swing: the moment is the weight times the rise of the centre of mass, by coordinates."""
    arm, far = 60.0, 45.0
    follower = SwingingRoller(base=30, radius=8, arm=arm, centre_distance=88, lifts=lifts)
    body = Dynamics(weight=3.0 * far, downhill=radians(down), swings=True)
    forces = CamForces(SWUNG, follower, body, 0.0)
    # The arm points from the pivot, which stands on the ray, at -exp(i g (rest + q)); it moves outwards along this:
    turn = 1j * lifts.side
    outwards = -turn * np.exp(turn * follower.rest)
    weight = outwards * np.exp(turn * radians(down))  # counted in the sense in which it lifts
    theta = np.radians([0.0, 30.0, 60.0, 130.0, 210.0])
    jets = SWUNG.jets(theta)

    def height(q):
        centre = -far * np.exp(turn * (follower.rest + q))
        return -(centre * weight.conjugate()).real

    step = 1e-6
    moment = 3.0 * (height(jets[:, 0] + step) - height(jets[:, 0] - step)) / (2 * step)
    np.testing.assert_allclose(forces.along(jets, theta), moment, atol=1e-6)
    assert abs(forces.work) < 1e-9 * 3.0 * far


def test_the_outer_flank_presses_by_its_own_curvature():
    """Hertz beside the made outline of the outer flank: hollow metal about the roller where the path is convex."""
    roller, half = Roller(base=40.0, radius=9.0), 9.02
    wide = Roller(base=39.98, radius=half)
    line = Line(width=6.0, modulus=STEEL, radius=9.0, other_radius=9.0)
    body = Dynamics(inertia=2e-3, line=line)
    forces = CamForces(FEEDER, wide, body, rpm(400), closed=True)
    outer = actual_profile(OppositeMotion.of(FEEDER), pressed_outwards(wide)).curve
    theta = np.radians([50.0, 60.0, 70.0, 140.0, 150.0])
    jets = FEEDER.jets(theta)
    normal = forces.normal(jets, theta)
    assert (normal < 0).any()
    z = 0j + np.sqrt(49.0**2) + jets[:, 0]
    tangent = jets[:, 1] + 1j * z
    contact = (z - half * 1j * tangent / np.abs(tangent)) * np.exp(1j * theta)  # on the far side of the path
    jet, _ = outer.at_angle(np.angle(contact))
    np.testing.assert_allclose(jet.point @ np.array([1, 1j]), contact, atol=1e-6)
    inner = 1 / roller.profile_radius(*jets[:, :3].T)
    metal = np.where(normal < 0, -jet.curvature, inner)
    wanted = np.sqrt(np.abs(normal) * STEEL * (metal + 1 / 9.0) / (pi * 6.0))
    np.testing.assert_allclose(forces.pressure(jets, theta), wanted, rtol=5e-3)
    np.testing.assert_allclose(forces.pressure(jets, theta)[normal < 0], wanted[normal < 0], rtol=1e-6)


def test_the_second_roller_presses_with_its_own_radius():
    line = Line(width=8.0, modulus=STEEL, radius=9.0, other_radius=6.0)
    second = Roller(base=54.0, radius=6.0)
    forces = CamForces(FEEDER, Roller(base=38.0, radius=9.0), Dynamics(inertia=1e-3, line=line), rpm(300), True, second)
    theta = np.radians([20.0, 60.0])
    jets = FEEDER.jets(theta)
    normal = forces.normal(jets, theta)
    assert normal[0] > 0 > normal[1]
    y0, q, q1, q2 = 60.0, -jets[1, 0], -jets[1, 1], -jets[1, 2]
    z = y0 + q
    path = (z**2 + q1**2) ** 1.5 / (z**2 + 2 * q1**2 - z * q2)  # of the second roller's centre
    found = forces.pressure(jets, theta)[1]
    assert found == pytest.approx(sqrt(-normal[1] * STEEL * (1 / (path - 6.0) + 1 / 6.0) / (pi * 8.0)), rel=1e-12)


def test_no_spring_of_a_negative_rate_is_proposed():
    """Below lift 0 a spring pulls away from the disc: there a weaker one holds, down to none, and no less."""
    moved = HarmonicMotion.of([(0, -1.0, 0.0), (1, 1.0, 0.0), (2, 0.5, 0.0)], MM)
    low = float(moved.extremes(0)[1].value)
    assert low < -1
    body = Dynamics(rate=8.0, preload=4.0)
    forces = CamForces(moved, Roller(base=40.0, radius=8.0), body, 0.0)
    assert forces.leaves
    assert forces.least_rate() == 0.0
