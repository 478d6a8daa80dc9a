"""The tutorial's measured file: a car with faults of its own, driven four times before a camera.

    python -m docs.tutorial.make_camera

The car is stepped by the generator of the tests of calibration (`tests/inference/measurement/synthetic_drive.py`),
which shares no code with `cadgen calibrate`: the camshaft walks through its play, and the car goes by short arcs.
"""

import tomllib
from math import radians
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from cadgen.car.path.spline import plan_path
from cadgen.car.path.wheel_track import offset_track
from cadgen.car.path_motion import path_motion
from cadgen.car.steering import Car, steering_jets
from tests.inference.measurement.synthetic_drive import Wheels, track_record

HERE = Path(__file__).parent
# What is wrong with the car: zero of the steering, radius of the drive wheel, play at the camshaft.
FAULTS = Wheels(zero=radians(0.4), radius=1.008, play=radians(0.75))
NOISE_MM = 2.0
SEED = 7


def car_as_designed() -> SimpleNamespace:
    """Compute car, track and lift of `first_car.toml` by the numeric rooms alone."""
    data = tomllib.loads((HERE / "first_car.toml").read_text(encoding="utf-8"))
    sizes = data["car"]
    car = Car(
        wheelbase=sizes["wheelbase_mm"],
        drive_wheel_offset=sizes["drive_wheel_offset_mm"],
        idle_wheel_offset=sizes["idle_wheel_offset_mm"],
        max_steering_angle=radians(35.0),
    )
    track = offset_track(plan_path(np.array(data["path"]["waypoints_mm"], float), "quintic"), 0.0)
    lift = path_motion(track.arc, steering_jets(track, car), track.length, blend=radians(12.0))
    return SimpleNamespace(track=track, car=car, lift=lift)


def camera_file() -> str:
    """Drive the faulty car four times and return the camera's file: a place every two degrees of the cam."""
    record = track_record(
        SimpleNamespace(built=car_as_designed()), FAULTS, np.random.default_rng(SEED), noise_mm=NOISE_MM
    )
    remarks = ["# design: first_car", f"# instrument: camera over the field, noise {NOISE_MM:g} mm"]
    rows = [
        f"{run + 1},{angle:g},{x:.1f},{y:.1f}"
        for run, angle, x, y in zip(record.run, *record.columns.values(), strict=True)
    ]
    return "\n".join([*remarks, ",".join(["run", *record.columns]), *rows, ""])


if __name__ == "__main__":
    (HERE / "camera.csv").write_text(camera_file(), encoding="utf-8")
