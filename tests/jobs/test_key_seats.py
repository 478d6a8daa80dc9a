"""Seats of keys beside bearings: heights by hand, of a disc that is set nearer and nearer to its plate."""

from dataclasses import replace

import pytest

from cadgen.car.assembly.car_parts import Block, KeySlot
from cadgen.design.load import load_design
from cadgen.jobs.assembly_checks import assembly_verdict
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_assembly import CarAssembly, put_together
from cadgen.jobs.gears.gear_train import plan_gears

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def car() -> CarAssembly:
    design = load_design("workshop_car")
    return put_together(plan_cam(design, "actual", judged=False), plan_gears(design))


def moved(car: CarAssembly, gap: float) -> tuple[CarAssembly, KeySlot, tuple[float, float], tuple[float, float]]:
    """Car whose disc stands `gap` mm off the plate beside it: seat of its key, heights of disc and plate."""
    layout = car.train.car
    assert layout is not None
    assert layout.arrangement is not None
    site, place = layout.site, layout.arrangement.place
    low, high = min(each.low for each in site.disc), max(each.high for each in site.disc)
    plate = min(
        ((z - site.plate / 2, z + site.plate / 2) for z in (place.near, place.far)),
        key=lambda ends: min(abs(ends[0] - high), abs(low - ends[1])),
    )
    shift = plate[0] - gap - high if high <= plate[0] else plate[1] + gap - low
    disc = tuple(each._replace(low=each.low + shift, high=each.high + shift) for each in site.disc)
    train = replace(car.train, car=replace(layout, site=replace(site, disc=disc)))
    again = put_together(car.cam, train)
    shape = again.part("shaft-4").shape
    assert isinstance(shape, Block)
    return again, shape.seats[-1], (low + shift, high + shift), plate


@pytest.mark.parametrize(("gap", "length"), [(5.0, 3.0), (1.5, 3.0), (1.0, 2.5), (0.4, 1.9)])
def test_a_square_key_is_shorter_where_its_seat_would_run_into_the_bearing(
    car: CarAssembly, gap: float, length: float
) -> None:
    """A key 3 mm wide runs out 1.5 mm beyond a disc of 3 mm: what the gap lacks of that is taken off the key."""
    again, seat, disc, plate = moved(car, gap)
    assert seat.key is not None
    assert (seat.key.form, seat.key.length) == ("B", pytest.approx(length))
    beyond = max(plate[0] - seat.high, seat.low - plate[1])
    assert beyond == pytest.approx(max(gap - 1.5, 0.0), abs=1e-9)
    far = seat.low - disc[0] if disc[1] <= plate[0] else disc[1] - seat.high
    assert far == pytest.approx(-1.5)
    assert "key-seat-in-bearing" not in {each.code for each in assembly_verdict(again).reservations}


def test_a_seat_that_would_leave_no_half_of_its_key_is_said(car: CarAssembly) -> None:
    """0.1 mm off the bearing would leave 1.6 mm of 3; in it by 0.2 mm, 1.3 mm: the key stays whole, and is named."""
    _, seat, _, _ = moved(car, 0.1)
    assert seat.key is not None
    assert seat.key.length == pytest.approx(1.6)
    again, seat, _, _ = moved(car, -0.2)
    assert seat.key is not None
    assert seat.key.length == pytest.approx(3.0)
    (said,) = (each for each in assembly_verdict(again).reservations if each.code == "key-seat-in-bearing")
    assert "B 3 x 3 x 3 in shaft 4 runs 1.7 mm into its bearing" in said.text
