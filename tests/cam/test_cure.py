"""Cures of lost lift, where the limit asks for more than arithmetic holds."""

import pytest

from cadgen.cam import lost_lift as cure


@pytest.mark.parametrize("limit", [5e-324, 1e-30])
@pytest.mark.parametrize("power", [0, 2])
def test_a_limit_below_rounding_is_sought_as_rounding(carbon_free_car, monkeypatch, limit, power):
    """Loss that stays has no cure; loss that falls with the square of the radius has one within reach or none."""
    radius = carbon_free_car.follower.radius
    monkeypatch.setattr(cure, "worst_loss", lambda lift, rod: 1e-3 * (rod.radius / radius) ** power)
    assert cure.undercut_cures(carbon_free_car.lift, carbon_free_car.follower, limit) == ()
