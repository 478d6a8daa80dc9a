"""Trial runs: points assigned to a track in order, settings written and read."""

from dataclasses import replace
from itertools import combinations_with_replacement
from math import radians

import numpy as np
import pytest

from cadgen.car.running.drive import Pose
from cadgen.deviations.deviation import BASE_RADIUS, COLUMNS, START_X
from cadgen.errors import FileError
from cadgen.inference.adjustment import LikelyCars, Settings, stations_of
from cadgen.inference.records.load import MOST_POINTS, STOPPED, TRIAL, load_text, settings_in, settings_line, trials_of


@pytest.mark.parametrize("seed", range(5))
def test_points_in_order_go_to_stations_in_order(seed):
    """Against every assignment in order there is, on a track that crosses itself."""
    rng = np.random.default_rng(seed)
    angle = np.linspace(0, 2 * np.pi, 12)
    track = 100 * np.sin(angle) + 60j * np.sin(2 * angle)
    points = rng.normal(0, 80, 4) + 1j * rng.normal(0, 60, 4)
    found = stations_of(track, points)
    every = [(*rest, 11) for rest in combinations_with_replacement(range(12), 3)]
    costs = [np.sum(np.abs(track[list(one)] - points) ** 2) for one in every]
    assert found[-1] == 11
    assert (np.diff(found) >= 0).all()
    np.testing.assert_allclose(np.sum(np.abs(track[found] - points) ** 2), min(costs))


def test_the_heads_error_adds_to_the_base_radius_until_the_head_is_turned():
    """By hand: a head that stands 4 um out makes the base circle larger by that; turned, its new error counts."""
    table = np.zeros((3, len(COLUMNS)))
    table[:, BASE_RADIUS.column] = [0.010, 0.020, -0.030]
    last = Settings(head=0.05)
    cars = LikelyCars(table=table, head=np.array([0.004, -0.002, 0.001]), last=last)
    left = cars.run(replace(last, start_x=7.0), np.array([9.0, 9.0, 9.0]))
    np.testing.assert_allclose(left[:, BASE_RADIUS.column], [0.064, 0.068, 0.021], rtol=1e-12)
    np.testing.assert_allclose(left[:, START_X.column], 7.0)
    turned = cars.run(Settings(head=0.06), np.array([0.001, 0.002, -0.003]))
    np.testing.assert_allclose(turned[:, BASE_RADIUS.column], [0.071, 0.082, 0.027], rtol=1e-12)
    np.testing.assert_allclose(cars.run(Settings(head=0.06))[:, BASE_RADIUS.column], [0.07, 0.08, 0.03], rtol=1e-12)
    assert table[0, BASE_RADIUS.column] == 0.010  # the cars themselves stay


def test_settings_are_read_as_they_are_written():
    settings = Settings(head=-0.012, key=radians(1.5), start_x=3.25, start_y=-80.5, start_heading=radians(-0.75))
    text = f"# {settings_line(settings)}\nrun,x_mm,y_mm\n1,0,0\n1,5,5\n"
    again = settings_in(load_text(text, "t.csv", (TRIAL,)))
    for name, value in settings.deviations.items():
        assert again.deviations[name] == pytest.approx(value, abs=1e-9)
    assert settings_in(load_text("run,x_mm,y_mm\n1,0,0\n1,5,5\n", "t.csv", (TRIAL,))) == Settings()


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("# settings: head 3\n", "is not understood; write it as"),
        (
            f"# {settings_line(Settings())}\n# {settings_line(Settings(head=0.01))}\n",
            "its comment lines give different settings",
        ),
    ],
)
def test_settings_that_are_no_settings(lines, said):
    with pytest.raises(FileError, match=said):
        settings_in(load_text(f"{lines}run,x_mm,y_mm\n1,0,0\n1,5,5\n", "t.csv", (TRIAL,)))


def test_points_stand_in_the_frame_of_the_start():
    """A car that starts at (10, 20) heading 90 degrees to the left."""
    record = load_text("run,x_mm,y_mm\n1,10,20\n1,10,120\n1,-90,120\n", "t.csv", (TRIAL,))
    (trial,) = trials_of([record], Pose(x=10.0, y=20.0, heading=np.pi / 2), 6.0)
    np.testing.assert_allclose(trial.points, [0, 100, 100 + 100j], atol=1e-9)
    assert trial.motor is None


def test_points_with_cam_angles_end_where_the_run_ends():
    rows = "".join(f"1,{angle},{10 * angle},0\n" for angle in (10, 100, 200, 340, 355))
    record = load_text(f"run,cam_angle_deg,x_mm,y_mm\n{rows}", "t.csv", (TRIAL, STOPPED))
    (trial,) = trials_of([record], Pose(), radians(348))
    np.testing.assert_allclose(np.degrees(trial.motor), [10, 100, 200, 340])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("run,x_mm,y_mm\n1,0,0\n", "run 1 has 1 rows; give at least 2"),
        ("run,x_mm,y_mm\n" + "".join(f"1,{k},0\n" for k in range(MOST_POINTS + 1)), "keep one in 2"),
        ("run,x_mm,y_mm\n" + "".join(f"{k},{k},0\n{k},{k},1\n" for k in range(11)), "11 trial runs"),
        ("run,cam_angle_deg,x_mm,y_mm\n1,20,0,0\n1,10,5,5\n", "must grow from row to row"),
        ("run,cam_angle_deg,x_mm,y_mm\n1,350,0,0\n1,360,5,5\n", "fewer than two points lie before 340.0 degrees"),
    ],
    ids=["one point", "too many points", "too many runs", "no order", "after the end"],
)
def test_what_is_no_trial_run(text, said):
    with pytest.raises(FileError, match=said):
        trials_of([load_text(text, "t.csv", (TRIAL, STOPPED))], Pose(), radians(340))
