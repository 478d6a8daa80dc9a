"""The greatest difference of lift: between the stations too, against a brute force."""

import numpy as np
import pytest

from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.difference import Exact, dense_stations
from cadgen.curves.polygon import polygon, polyline


@pytest.mark.slow
def test_the_greatest_difference_is_that_of_a_dense_search(carbon_free_car):
    """A polygon's humps are a quarter of a degree wide, or less in a hollow: 0.1 degree passes their tops by."""
    car, step = carbon_free_car, 0.03
    corners = polygon(car.actual.curve, 5e-4)
    outline = polyline(corners, step)
    even = np.linspace(0, 2 * np.pi, 3600, endpoint=False)
    contact, _ = roll_curve(car.actual.curve, car.follower, even)
    exact = Exact(car.actual.curve.outline(step), car.follower, dense_stations(car.follower, contact))
    found = exact.compare(outline)[0] * 1e3
    coarse = np.abs(roll(outline, car.follower, even).lift - contact.lift).max() * 1e3
    dense = np.linspace(0, 2 * np.pi, 60_000, endpoint=False)
    lifts = [roll(one, car.follower, dense).lift for one in (outline, exact.outline)]
    brute = np.abs(lifts[0] - lifts[1]).max() * 1e3
    print(f"greatest difference {found:.4f} um, at even stations {coarse:.4f} um, by brute force {brute:.4f} um")
    assert brute * 0.99 < found < brute * 1.01
    assert found >= coarse
