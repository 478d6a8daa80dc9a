"""How far cars are off at what they must keep: on the line on which the margin is measured."""

import numpy as np
import pytest

from cadgen.inference.monte_carlo.course_margins import ClearanceItem, FinishItem, GateItem

TRACK = np.arange(-600, 601, 10) * np.exp(0.3j)  # straight, by 0.3 rad, through 0


@pytest.mark.parametrize(("off", "by"), [(20.0, -1.0), (-20.0, 1.0)])
def test_off_the_middle_of_a_disc_the_margin_changes_by_what_a_car_is_aside(off, by):
    gate = GateItem(0, np.array([1j * off * np.exp(0.3j)]), 50.0, TRACK)
    moved = gate.places + np.array([3.0 * 1j * np.exp(0.3j), 5.0 * np.exp(0.3j)])[:, None]  # across, and along
    np.testing.assert_allclose(gate.distance(moved), [3.0, 0.0], atol=1e-9)
    nominal = gate.margin(gate.places[None, :], np.zeros(1))
    np.testing.assert_allclose(gate.margin(moved, np.zeros(2)) - nominal, by * gate.distance(moved), atol=1e-9)


def test_on_a_segment_the_crossing_moves_by_what_a_car_is_aside():
    """The segment lies at 60 degrees to the track."""
    along = np.exp(1j * (0.3 + np.pi / 3))
    gate = GateItem(0, np.array([-30.0, 100.0]) * along, 0.0, TRACK)
    moved = gate.places + np.array([4.0 * 1j * np.exp(0.3j), 7.0 * np.exp(0.3j)])[:, None]
    np.testing.assert_allclose(gate.distance(moved), [4.0 / np.sin(np.pi / 3), 0.0], atol=1e-9)
    nominal = gate.margin(gate.places[None, :], np.zeros(1))
    np.testing.assert_allclose(gate.margin(moved, np.zeros(2)) - nominal, -gate.distance(moved), atol=1e-9)


def test_room_grows_as_an_obstacle_goes_away():
    post = ClearanceItem(0, np.array([200j]), 1j, 30.0)
    moved = post.places + np.array([[2.0 + 5j], [-3j]])
    np.testing.assert_allclose(post.distance(moved), [5.0, -3.0])
    np.testing.assert_allclose(post.margin(moved, np.zeros(2)), [35.0, 27.0])


def test_at_the_finish_it_counts_where_a_car_ends_and_not_what_it_passes():
    """The planned run ends 30 mm short of the middle of a disc of 50 mm; one that overruns it by 60 mm fails."""
    finish = FinishItem(0, np.array([30.0 + 0j]), 50.0, 0j, (0.05, 0.1))
    places = np.array([30.0, 50.5, -60.0, 30.0 + 45j, 30.0])[:, None]  # of the middle, as they lie to each car's end
    turned = np.array([0.0, 0.0, 0.0, 0.0, 0.06])
    margins = finish.margin(places, turned)
    np.testing.assert_allclose(margins[:4], [20.0, -0.5, -10.0, 50 - np.hypot(30, 45)])
    assert margins[4] < 0  # it heads in a wrong direction
    np.testing.assert_allclose(finish.distance(places[:4]), [0.0, 20.5, 90.0, 45.0], atol=1e-12)
