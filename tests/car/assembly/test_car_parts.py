"""Volumes, centres and motions of the parts of a car, against closed formulas."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from cadgen.car.assembly.car_parts import (
    Block,
    BodyShape,
    CarPart,
    Content,
    Drilled,
    GroupKind,
    MovingGroup,
    Prism,
    along,
    at,
    still,
    together,
)
from cadgen.curves.contour import Contour, circle
from cadgen.messages import Message
from cadgen.parts.body import Body, RadialHole, Slab
from cadgen.parts.loop import circle as circle_loop

TRIANGLE = Contour(np.array([[0.0, 0.0], [6.0, 0.0], [0.0, 3.0]]), np.zeros(3))


def part_of(shape: Block | BodyShape, *places: np.ndarray, group: MovingGroup | None = None) -> CarPart:
    return CarPart(
        code="part",
        title=Message("part"),
        shape=shape,
        places=places or (still(),),
        group=group or MovingGroup(GroupKind.FRAME),
        material="steel",
        density=7.85e-3,
    )


def test_a_prism_has_its_centre_at_the_triangle_s_and_a_hole_moves_it_away() -> None:
    whole = Block((Prism(TRIANGLE, 1.0, 5.0),)).content()
    assert whole.volume == pytest.approx(36.0)
    assert whole.centre == pytest.approx((2.0, 1.0, 3.0))
    holed = Block((Prism(TRIANGLE, 1.0, 5.0, (circle((1.0, 1.0), 0.5),)),)).content()
    taken = pi / 4 * 4
    assert holed.volume == pytest.approx(36.0 - taken)
    assert holed.centre[0] == pytest.approx((72.0 - taken) / (36.0 - taken), abs=2e-3)


def test_a_drilled_hole_and_a_cut_are_taken_away() -> None:
    box = Contour(np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [0.0, 4.0]]), np.zeros(4))
    slot = Contour(np.array([[8.0, 0.0], [10.0, 0.0], [10.0, 4.0], [8.0, 4.0]]), np.zeros(4))
    block = Block(
        (Prism(box, 0.0, 2.0),), (Prism(slot, 1.0, 2.0),), (Drilled((2.0, 0.0, 1.0), (0.0, 1.0, 0.0), 1.0, 4.0),)
    )
    found = block.content()
    assert found.volume == pytest.approx(80.0 - 8.0 - pi)
    assert found.centre[0] == pytest.approx((400.0 - 72.0 - 2 * pi) / (72.0 - pi))
    assert found.centre[2] == pytest.approx((80.0 - 12.0 - pi) / (72.0 - pi))


def test_a_stepped_body_with_a_radial_hole() -> None:
    slabs = (
        Slab(0.0, 2.0, (circle_loop(20.0), circle_loop(4.0))),
        Slab(2.0, 8.0, (circle_loop(10.0), circle_loop(4.0))),
    )
    found = BodyShape(Body(slabs)).content()
    one, two = pi / 4 * (400 - 16) * 2, pi / 4 * (100 - 16) * 6
    assert found.volume == pytest.approx(one + two)
    assert found.centre == pytest.approx((0.0, 0.0, (one + 5 * two) / (one + two)))
    drilled = BodyShape(Body(slabs, RadialHole(1.0, 5.0, 6.0, radians(30)))).content()
    hole = pi / 4 * 3.0
    assert drilled.volume == pytest.approx(one + two - hole)
    assert drilled.centre[:2] == pytest.approx(
        tuple(-hole * 3.5 / (one + two - hole) * each for each in (cos(radians(30)), sin(radians(30))))
    )


def test_masses_add_up_at_their_common_centre() -> None:
    two = part_of(Block((Prism(TRIANGLE, 0.0, 1.0),)), at(10.0, 0.0, 0.0), at(0.0, 4.0, 2.0))
    found = two.balance()
    assert found.volume == pytest.approx(2 * 9 * 7.85e-3)
    assert found.centre == pytest.approx((7.0, 3.0, 1.5))
    assert together([Content(1.0, (0.0, 0.0, 0.0)), Content(3.0, (4.0, 0.0, -8.0))]).centre == (3.0, 0.0, -6.0)


def test_a_shaft_turns_about_its_axis_and_the_fork_about_its_own() -> None:
    shaft = MovingGroup(GroupKind.SHAFT, 2, 3 + 4j, -2.0)
    found = shaft.motion(pi / 4, 0.0) @ [4.0, 4.0, 7.0, 1.0]
    assert found == pytest.approx((3.0, 3.0, 7.0))
    fork = MovingGroup(GroupKind.FORK, axis=70.0 - 20.0j)
    tip = fork.motion(0.0, radians(10)) @ [70.0, 5.0, 20.0, 1.0]
    assert tip == pytest.approx((70 + 40 * sin(radians(10)), 5.0, -20 + 40 * cos(radians(10))))


def test_a_planet_goes_round_with_its_carrier_and_spins_by_itself() -> None:
    carrier = MovingGroup(GroupKind.SHAFT, 2, 1 + 0j, 1.0)
    planet = MovingGroup(GroupKind.BESIDE, 5, 3 + 0j, -3.0, carrier)
    motion = planet.motion(pi / 2, 0.0)
    assert motion @ [3.0, 0.0, 0.0, 1.0] == pytest.approx((1.0, 2.0, 0.0))
    assert motion[:, :3] @ [1.0, 0.0, 0.0] == pytest.approx((0.0, 1.0, 0.0))


def test_a_place_along_a_direction_is_a_turning() -> None:
    place = along((0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (70.0, 0.0, -20.0))
    assert np.linalg.det(place[:, :3]) == pytest.approx(1.0)
    assert place @ [0.0, 0.0, 5.0, 1.0] == pytest.approx((70.0, -5.0, -20.0))
