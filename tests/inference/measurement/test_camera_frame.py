"""Axes of a camera: a track is the same in any of four frames, and refused in those of the other hand."""

import re

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.errors import FileError
from cadgen.inference.measurement.camera_frame import in_design_frame
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.record import Record
from cadgen.jobs.calibration.cam_on_car import nominal_of


@pytest.fixture(scope="module")
def track():
    return nominal_of(load_design("carbon_free_car"), "actual").track


def driven(track, *, lag=0.0, noise=3.0, scale=1.0, runs=2):
    """Runs whose places come from the planned path, later by some way, and set down by hand."""
    rng, angle = np.random.default_rng(4), np.arange(0.0, 345.0, 3.0)
    path = track.position(np.maximum(track.turn * angle / 360 - lag, 0.0)) @ np.array([1.0, 1j])
    places = []
    for _ in range(runs):
        pose = np.exp(1j * np.radians(rng.normal(0, 0.2)))
        places.append(path[0] + pose * (path - path[0]) + rng.normal(0, 3, 2) @ np.array([1, 1j]))
    both = scale * (np.concatenate(places) + noise * rng.standard_normal((2, runs * len(angle))).T @ np.array([1, 1j]))
    return recorded(both, np.tile(angle, runs), np.repeat(np.arange(runs), len(angle)))


def recorded(places, angle, run):
    columns = {"cam_angle_deg": angle, "x_mm": places.real, "y_mm": places.imag}
    return Record(kind=TRACK, columns=columns, run=run, remarks=(), source="made")


def moved(record, by, shift=0j, *, mirrored=False):
    places = record["x_mm"] + 1j * record["y_mm"]
    return recorded(by * (places.conj() if mirrored else places) + shift, record["cam_angle_deg"], record.run)


@pytest.mark.parametrize("quarters", range(4))
@pytest.mark.parametrize("shift", [0j, 5000 - 300j])
def test_turned_and_shifted_axes_give_the_same_track(track, quarters, shift):
    straight = driven(track)
    assert in_design_frame(straight, track) is straight
    found = in_design_frame(moved(straight, 1j**quarters, shift), track)
    off = found["x_mm"] - straight["x_mm"] + 1j * (found["y_mm"] - straight["y_mm"])
    assert np.abs(off - off[0]).max() < 1e-6  # where the runs start together is no longer known
    assert abs(off[0]) < 10
    if quarters or shift:
        # The path in the camera's axes is that of the design, turned and then moved, as it was made here.
        angle, x, y = map(float, re.findall(r"-?\d+", str(found.notes[0])))
        assert angle == 90 * quarters
        assert abs(complex(x, y) - shift) < 10
    else:
        assert not found.notes


@pytest.mark.parametrize("quarters", range(4))
def test_a_track_in_a_mirror_is_refused(track, quarters):
    with pytest.raises(FileError, match="in a mirror"):
        in_design_frame(moved(driven(track, lag=20.0), 1j**quarters, 700j, mirrored=True), track)


def test_other_units_and_axes_that_lie_askew_are_left_as_they_are(track):
    for record in (driven(track, scale=0.1), moved(driven(track), np.exp(0.6j), 900 + 0j)):
        assert in_design_frame(record, track) is record
    short = driven(track)
    few = Record(
        kind=TRACK,
        columns={name: values[:4] for name, values in short.columns.items()},
        run=short.run[:4],
        remarks=(),
        source="few",
    )
    assert in_design_frame(few, track) is few
