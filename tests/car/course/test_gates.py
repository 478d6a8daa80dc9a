"""Gates on a straight run along x, whose passages can be told by hand."""

from math import inf, pi, radians

import numpy as np
import pytest

from cadgen.car.course.body import CarBody, CarWheel, RunPoses
from cadgen.car.course.judge import judge, passages
from cadgen.car.course.layout import Course, Gate, Obstacle, Shape
from cadgen.car.steering import Car

CAR = Car(wheelbase=100.0, drive_wheel_offset=40.0, idle_wheel_offset=60.0, max_steering_angle=0.6)
S = np.linspace(0.0, 1000.0, 41)
# The middle of the rear axle, 100 behind the fork and 10 to its right, runs along y = 0 from x = 0.
RUN = RunPoses(fork=S + 100 + 10j, heading=0 * S, steering=0 * S, travel=S)


def gate(at, radius=50.0, **more) -> Gate:
    return Gate(key="g", place=Shape.disc(at, radius), **more)


def test_a_disc_is_passed_by_what_is_left_of_its_radius():
    near, missed = passages(RUN, CAR, [gate((510.0, 30.0)), gate((700.0, -80.0))])
    assert (near.margin, near.off, near.travel) == pytest.approx((20.0, 30.0, 510.0))
    assert (missed.margin, missed.fault) == (pytest.approx(-30.0), "")


@pytest.mark.parametrize(
    ("point", "y"), [("middle", 0.0), ("fork", 10.0), ("drive_wheel", 50.0), ("idle_wheel", -50.0)]
)
def test_each_point_of_the_car_has_its_own_track(point, y):
    (passage,) = passages(RUN, CAR, [gate((500.0, y), point=point)])
    assert passage.off == pytest.approx(0.0, abs=1e-9)
    assert passage.travel == pytest.approx(400.0 if point == "fork" else 500.0)


def test_gates_are_passed_in_their_order_unless_they_are_free():
    first, second = gate((800.0, 0.0)), gate((300.0, 0.0))
    assert [p.fault for p in passages(RUN, CAR, [second, first])] == ["", ""]
    assert [p.fault for p in passages(RUN, CAR, [first, second])] == ["", "order"]
    assert [p.fault for p in passages(RUN, CAR, [first, gate((300.0, 0.0), free=True)])] == ["", ""]


@pytest.mark.parametrize(("heading", "fault"), [(0.0, ""), (80.0, ""), (100.0, "heading"), (180.0, "heading")])
def test_a_heading_is_kept_within_its_tolerance(heading, fault):
    (passage,) = passages(RUN, CAR, [gate((500.0, 0.0), heading=radians(heading), heading_tolerance=pi / 2)])
    assert passage.fault == fault


@pytest.mark.parametrize(
    ("ends", "margin"),
    [(((500, -100), (500, 40)), 40.0), (((500, 20), (500, 90)), -20.0), (((500, 0), (600, 100)), 0.0)],
)
def test_a_segment_is_crossed_between_its_ends(ends, margin):
    (passage,) = passages(RUN, CAR, [Gate(key="g", place=Shape(ends))])
    assert passage.margin == pytest.approx(margin, abs=1e-9)


def test_sides_start_and_finish_are_judged():
    wheel = CarWheel(name="front wheel", centre=(0.0, 0.0), radius=0.0, width=0.0, steered=True)
    body = CarBody(corners=((20, 80), (-120, 80), (-120, -80), (20, -80)), clearance=0.0, wheels=(wheel,))
    post = Obstacle(kind="post", key="p", shape=Shape.disc((500.0, 200.0), 10.0), side="left")
    finish = Gate(key="f", place=Shape.disc((1003.0, 4.0), 1.0), heading=radians(-2.0), heading_tolerance=0.01)
    driven = judge(RUN, CAR, body, Course(obstacles=(post,), finish=finish))
    assert driven.sides == ("right",)  # the post stands on its left
    assert driven.wrong_sides == (post,)
    assert driven.approaches[0][1].clearance == pytest.approx(200 - 90 - 10, abs=5e-3)
    assert driven.finish is not None
    assert (driven.finish.off, driven.finish.turned) == pytest.approx((5.0, radians(2.0)))
    assert post.height == inf
