"""Broken edges and a divider that errs several times a turn have names, by a lift, alone or beside a track.

Cars and records are those of the study of circles, whose generator shares nothing with the package's models.
"""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.deviations.lift import BROKEN_EDGES, Seat
from cadgen.inference.measurement.diagnosis import calibrate
from tests.studies.circles_truth import CELLS, DEG, Car, World, drawn_form

pytestmark = pytest.mark.slow

BROKEN = Car(edge=0.2)


@pytest.fixture(scope="module")
def world(synthetic_car):
    return World(synthetic_car.built, synthetic_car, drawn_form(np.random.default_rng(5)))


def found(told):
    return {v.name: v for f in told.findings for v in f.values}


@pytest.mark.parametrize("kinds", [("dial",), ("track", "dial")])
def test_broken_edges_are_named_and_measured(world, nominal, kinds):
    rng = np.random.default_rng(1)
    for told in calibrate([getattr(world, kind)(BROKEN, rng) for kind in kinds], nominal):
        assert told.judgement.claimed == ("broken edges",)
        edges = found(told)["broken_edges_um"]
        assert edges.value == pytest.approx(200.0, abs=15.0)
        assert abs(edges.value - 200.0) < 3 * edges.sigma
        assert "from a thinner disc" in told.judgement.sentence


@pytest.mark.parametrize("order", [2, 3])
def test_a_divider_that_errs_several_times_a_turn_is_named(world, nominal, order):
    right = world.dial(Car(), np.random.default_rng(3))
    turn, inner = right["cam_angle_deg"], world.built.follower.inner
    at = (turn + 0.2 * np.cos(order * turn * DEG)) / 360 * CELLS
    shown = inner * np.interp(at, np.arange(CELLS), world.lift(Car()), period=CELLS)
    noise = np.random.default_rng(4).normal(0, 4e-3, len(turn))
    (told,) = calibrate([replace(right, columns={**right.columns, "lift_mm": shown + noise})], nominal)
    assert told.judgement.claimed == (f"index error, order {order}",)
    assert found(told)["index_cos_deg"].value == pytest.approx(0.2, abs=0.01)
    assert found(told)["index_sin_deg"].value == pytest.approx(0.0, abs=0.01)


def test_a_divider_set_by_the_disc_leaves_the_cam_phase_of_the_track_claimed(world, nominal):
    """On the lift a phase and the zero of the divider cancel, since that is what the zero is for."""
    rng = np.random.default_rng(6)
    for told in calibrate([world.track(Car(phase=0.5 * DEG), rng), world.dial(Car(), rng)], nominal):
        assert "cam phase" in told.judgement.sentence
        assert not any("cancel" in str(limit) for limit in told.judgement.limits)
        assert told.judgement.claimed


def test_the_rod_rides_between_the_broken_edges(synthetic_car):
    rod = synthetic_car.built.follower
    moved = BROKEN_EDGES.act(Seat(rod), np.array([0.1]), None).follower
    assert (moved.inner, moved.outer) == pytest.approx((rod.inner + 0.1, rod.outer - 0.1))
    assert moved.radius == rod.radius
