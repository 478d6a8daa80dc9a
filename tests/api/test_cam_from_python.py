"""Cams without a design file: the same as those of one, figures of published examples, and refusals."""

import pickle
import subprocess
import sys
from math import degrees, radians

import numpy as np
import pytest

from cadgen import Cam, Design, Flat, KnifeEdge, Motion, Roller, Spring, SwingingFlat, SwingingRoller, dwell, rise
from cadgen.errors import DesignError

FEEDER = Motion(
    [rise(14, radians(80)), dwell(radians(50)), rise(-14, radians(110), "modified_sine"), dwell(radians(120))], rpm=420
)
FILE = """
name = "feeder"
[motion]
turns = "counterclockwise"
speed_rpm = 420
segments = [
    { to_mm = 14.0, in_deg = 80.0, law = "polynomial_3_4_5" },
    { dwell_deg = 50.0 },
    { to_mm = 0.0, in_deg = 110.0, law = "modified_sine" },
    { dwell_deg = 120.0 },
]
[follower]
kind = "roller"
radius_mm = 9.0
offset_mm = 8.0
[cam]
base_circle_radius_mm = 32.0
thickness_mm = 10.0
[blank]
bore_diameter_mm = 12.0
[dynamics]
mass_kg = 0.85
spring_rate_N_per_mm = 9.0
preload_N = 60.0
"""


@pytest.fixture(scope="module")
def feeder():
    return Cam(FEEDER, Roller(radius=9, offset=8), base_circle_radius=32, thickness=10, bore=12, name="feeder")


def test_it_is_the_cam_of_the_design_file_that_says_the_same(feeder):
    of_file = Design.from_toml(FILE).cam()
    assert np.array_equal(feeder.profile.points(), of_file.profile.points())
    assert feeder.checks.passed
    forces = feeder.forces(rpm=420, mass=0.85, spring=Spring(rate=9, preload=60))
    shown = {str(figure.code): figure.value for figure in of_file.application.figures(of_file)}
    assert forces.lift_off_rpm == pytest.approx(shown["lift-off-speed"], rel=1e-9)
    assert forces.torque.greatest == pytest.approx(shown["camshaft-torque-greatest"], rel=1e-9)
    assert forces.normal.greatest == pytest.approx(shown["normal-force-greatest"], rel=1e-9)
    assert forces.pressure == pytest.approx(shown["contact-pressure"], rel=1e-9)
    assert not forces.leaves


def test_figures_by_hand(feeder):
    """Of a roller at an offset tan(alpha) = (s' - e) / (y0 + s), Norton's formula, on stations of the law itself."""
    theta = np.linspace(0, radians(80), 20001)
    u = theta / radians(80)
    lift = 14 * (10 * u**3 - 15 * u**4 + 6 * u**5)
    slope = 14 / radians(80) * (30 * u**2 - 60 * u**3 + 30 * u**4)
    angle = np.degrees(np.arctan((slope - 8) / (np.sqrt(41**2 - 64) + lift)))
    rising = next(check.value for check in feeder.checks if check.code == "pressure-angle-rise")
    assert rising == pytest.approx(np.abs(angle).max(), abs=1e-3)
    assert feeder.pressure_angle.greatest >= feeder.pressure_angle.least


def test_the_spring_of_a_published_example():
    """10 mm cycloidal in 120°, 1000 rev/min, 1.8 kg, 15 N/mm compressed 2.5 mm: it leaves from 779.83 rev/min on."""
    motion = Motion(
        [
            rise(10, radians(120), "cycloidal"),
            dwell(radians(60)),
            rise(-10, radians(120), "cycloidal"),
            dwell(radians(60)),
        ]
    )
    cam = Cam(motion, Roller(radius=10), base_circle_radius=40, thickness=10)
    forces = cam.forces(rpm=1000, mass=1.8, spring=Spring(rate=15, preload=37.5))
    assert forces.lift_off_rpm == pytest.approx(779.83, abs=0.005)
    assert any(radians(56) < start < radians(100) < stop for start, stop in forces.leaves)
    # With 24.666 N/mm it holds, compressed by the same 2.5 mm.
    assert cam.forces(1000, mass=1.8, spring=Spring(rate=24.666, preload=2.5 * 24.666)).lift_off_rpm >= 999.99
    assert not cam.forces(rpm=779, mass=1.8, spring=Spring(rate=15, preload=37.5)).leaves


@pytest.mark.parametrize(
    ("follower", "height"),
    [
        (KnifeEdge(offset=4), 14),
        (Flat(), 14),
        (Flat(tilt=radians(10)), 14),
        (SwingingRoller(radius=9, arm=60, centre_distance=80, lifts="with"), radians(14)),
        (SwingingFlat(centre_distance=90, face_offset=5), radians(14)),
        ({"kind": "roller", "radius_mm": 9.0}, 14),
        ({"kind": "swinging_flat", "centre_distance_mm": 90.0, "lifts": "against", "face_offset_mm": 5.0}, radians(14)),
    ],
)
def test_every_follower_has_its_cam(follower, height):
    motion = Motion([rise(height, radians(90)), dwell(radians(60)), rise(-height, radians(120)), dwell(radians(90))])
    cam = Cam(motion, follower, base_circle_radius=40, thickness=10)
    assert cam.sound
    greatest = float(cam.motion.q(np.linspace(0, 2 * np.pi, 3601)).max())
    assert greatest == pytest.approx(height, abs=1e-9)


def test_a_pressure_angle_in_place_of_the_base_circle():
    cam = Cam(FEEDER, Roller(radius=9), pressure_angle=radians(25), thickness=10)
    assert degrees(cam.pressure_angle.greatest) == pytest.approx(25.0, abs=1e-3)


def test_other_keys_of_a_design_can_be_given():
    changes = {"blank.hub": {"diameter_mm": 24.0, "length_mm": 8.0}}
    cam = Cam(FEEDER, Roller(radius=9, offset=8), base_circle_radius=32, thickness=10, changes=changes)
    assert cam.blank.hub.diameter == 24.0


def test_it_can_be_pickled(feeder):
    again = pickle.loads(pickle.dumps(feeder))
    assert again.checks.passed
    assert again.least_radius == feeder.least_radius


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: rise(14, 80), "80 looks like degrees: give radians"),
        (lambda: Motion(), "either steps or points"),
        (lambda: Motion([1.0]), "must be a list of rise"),
        (lambda: Motion([dwell(1.0)], turns="left"), "turns"),
        (lambda: Cam(FEEDER, Roller(radius=9), thickness=10), "give either base_circle_radius"),
        (lambda: Cam(FEEDER, "roller", base_circle_radius=32, thickness=10), "it must be a Roller"),
        (lambda: Cam(FEEDER, {"kind": "rolex"}, base_circle_radius=32, thickness=10), "follower.kind"),
        (lambda: Cam([], Roller(radius=9), base_circle_radius=32, thickness=10), "it must be a Motion"),
        (lambda: Cam(FEEDER, Roller(radius=-1), base_circle_radius=32, thickness=10), "follower.radius_mm"),
        (lambda: Cam(FEEDER, Roller(radius=9), base_circle_radius=object(), thickness=10), "no number or text"),
        (
            lambda: Cam(Motion([rise(5, 1.0), dwell(1.0)]), Roller(radius=9), base_circle_radius=32, thickness=10),
            r"ends at 5, which is a jump at cam angle 0: set motion\.segments\.1\.rise_mm to 0",
        ),
    ],
)
def test_bad_input_is_one_sentence(made, said):
    with pytest.raises(DesignError, match=said):
        made()


def test_a_mass_is_of_a_slide_and_an_inertia_of_an_arm(feeder):
    with pytest.raises(DesignError, match="give the other one"):
        feeder.forces(rpm=100, inertia=3)


def test_a_groove_holds_its_roller_and_presses_by_its_depth():
    """Mass alone: the flank changes where the acceleration does, in the middle of each sine (55 and 215 degrees)."""
    rises = [rise(25, radians(110), "modified_sine"), dwell(radians(50)), rise(-25, radians(110), "modified_sine")]
    keys = {"kind": "roller", "radius_mm": 10.0, "closure": "groove", "clearance_mm": 0.05, "depth_mm": 5.0}
    cam = Cam(Motion([*rises, dwell(radians(90))]), keys, base_circle_radius=45, thickness=10)
    forces = cam.forces(rpm=300, mass=2.0)
    assert np.degrees(forces.leaves) == pytest.approx(np.array([[55, 110], [160, 215]]), abs=1e-6)
    assert forces.torque.greatest == pytest.approx(-forces.torque.least, rel=1e-9)
    disc = Cam(Motion([*rises, dwell(radians(90))]), Roller(radius=10), base_circle_radius=45, thickness=5)
    pressed = disc.forces(rpm=300, mass=2.0).pressure
    assert forces.pressure == pytest.approx(pressed, rel=2e-3)  # on the inner flank, 25 um nearer the camshaft


def test_a_cam_by_its_motion_is_checked_without_what_only_a_car_needs():
    """A process of its own, for this one has imported everything."""
    code = (
        "import sys, cadgen; cam = cadgen.Design.load('roller').cam(); assert cam.passed and cam.facts() "
        "and cam.comparison is None; print([name for name in sys.modules if name in "
        "('cadgen.jobs.cam.steering_cam', 'cadgen.jobs.cam.comparison', 'manifold3d', 'OCP')]); "
        # Nor does a car's cam need what measured data need, which would take a tenth of its time.
        "import cadgen.api.runs; print([name for name in sys.modules if name.startswith('cadgen.inference.meas')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["[]", "[]"]
