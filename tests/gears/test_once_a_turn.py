"""Transmission error of each shaft, against the printed tables of ISO 1328-1 and the seats of the gears."""

from math import cos, radians

import pytest

from cadgen.design import gear_model, variation
from cadgen.design.load import load_design
from cadgen.deviations.deviation import GEAR_ERRORS
from cadgen.gears.train import once_a_turn

# F_p of grade 7, um, for a module of 0.5 to 2 mm, by the step of the diameter: 20, 50 and 125 mm at most.
TABLE = {15.0: 23.0, 20.0: 23.0, 60.0: 37.0, 75.0: 37.0}


def arc(diameter: float, seat: float) -> float:
    return TABLE[diameter] / 2e3 + seat / cos(radians(20.0))


@pytest.mark.parametrize("seat", [0.0, 0.01])
def test_shafts_have_the_errors_of_their_gears(seat):
    """30:150, 40:120 and 40:120 teeth of 0.5 mm, from the drive to the camshaft."""
    found = once_a_turn(gear_model.train(load_design("workshop_car")), seat)
    assert [shaft.order for shaft in found] == [1.0, 3.0, 9.0, 45.0]
    last, middle, first = arc(60.0, seat) / 30.0, arc(60.0, seat) / 30.0 / 3, arc(75.0, seat) / 37.5 / 9
    pinions = arc(20.0, seat) / 30.0, arc(20.0, seat) / 30.0 / 3, arc(15.0, seat) / 37.5 / 9
    sums = [last, pinions[0] + middle, pinions[1] + first, pinions[2]]
    assert [shaft.size for shaft in found] == pytest.approx(sums, rel=0.02)  # the tables are rounded
    left = [last, pinions[0] - middle, abs(pinions[1] - first), pinions[2]]
    assert [shaft.least for shaft in found] == pytest.approx(left, rel=0.03)


def test_cars_vary_by_them_where_the_seat_is_given():
    design = load_design("workshop_car", overrides=["tolerances.gear_seat_mm=0"])
    forces = variation.mechanics(design, *_follower_and_lift(design))
    halves = variation.half_widths(design, forces)
    assert [halves[each] for each in GEAR_ERRORS[:4]] == [shaft.size for shaft in variation.once_a_turn_of(design)]
    assert GEAR_ERRORS[4] not in halves
    plain = load_design("workshop_car")
    assert not set(GEAR_ERRORS) & set(variation.half_widths(plain, forces))
    assert set(GEAR_ERRORS[:4]) < set(variation.of_the_parts(plain, forces))


def test_a_thin_rod_bends_as_a_cantilever_does():
    """By hand: 1 N at 25 mm on steel of 1.25 mm radius, F l^3 / 3 E I with I = pi r^4 / 4."""
    design = load_design("workshop_car", overrides=["follower.radius_mm=1.25"])
    forces = variation.mechanics(design, *_follower_and_lift(design))
    (bending,) = (half for each, half in variation.of_the_parts(design, forces).items() if each.key == "rod_bending")
    assert bending == pytest.approx(25.0**3 / (3 * 206e3 * 1.9175), rel=0.01)


def _follower_and_lift(design):
    from cadgen.design import cam_model

    return cam_model.follower(design), cam_model.lift(design, cam_model.track(design))
