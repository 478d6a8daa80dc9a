"""A slice of the study of crowned rims: what it says of contact is so."""

import numpy as np

from cadgen.cam.contact import roll
from tests.studies.crown import STEP, crowned, laid_on_slices


def test_a_crown_is_a_tube_and_does_not_feel_its_edges(carbon_free_car):
    cam = crowned(carbon_free_car, 4.0)
    theta = np.radians([20.0, 91.0, 129.4, 178.0, 232.0, 300.0])
    tube = roll(cam.centre.outline(STEP), cam.rod, theta).q
    np.testing.assert_allclose(tube, carbon_free_car.lift.q(theta), atol=1e-7)
    laid, place = laid_on_slices(cam, theta)
    # Slices 0.05 mm apart miss the crown's top by 0.025^2 / 8 at most.
    assert 0 <= (tube - laid).max() * 25 < 1e-4
    assert np.abs(place).max() < 1.0
    assert np.array_equal(laid_on_slices(cam, theta, 0.3)[0], laid)
