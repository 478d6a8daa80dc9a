"""Gaps between cylinders against meshes of them, whose least distance another library finds."""

import manifold3d
import numpy as np
import pytest

from cadgen.car.assembly.bodies import SolidCylinder, gap

SEGMENTS = 180  # a chord of a circle of 30 mm stays within 4.6 um of it


def meshed(body):
    """Cylinder about z as a mesh, then turned to its axis and shifted."""
    z = np.array(body.axis) / np.linalg.norm(body.axis)
    x = np.cross(z, [0.0, 1.0, 0.0] if abs(z[1]) < 0.9 else [1.0, 0.0, 0.0])
    x /= np.linalg.norm(x)
    frame = np.column_stack([x, np.cross(z, x), z, body.centre])
    solid = manifold3d.Manifold.cylinder(2 * body.half, body.radius, body.radius, SEGMENTS, center=True)
    return solid.transform(frame)


def random_body(rng, *, upright):
    axis = np.array([0.0, 0.0, 1.0]) if upright else rng.normal(size=3) * [1.0, 0.0, 1.0]
    return SolidCylinder(
        name="body",
        centre=tuple(rng.uniform(-60, 60, 3)),
        axis=tuple(axis / np.linalg.norm(axis)),
        radius=float(rng.uniform(1, 30)),
        half=float(rng.uniform(1, 30)),
    )


@pytest.mark.parametrize("upright", [True, False], ids=["parallel", "crossing"])
def test_a_gap_is_that_of_the_meshes(upright):
    rng = np.random.default_rng(5)
    worst, apart = 0.0, 0
    for _ in range(25):
        one, other = random_body(rng, upright=True), random_body(rng, upright=upright)
        exact = meshed(one).min_gap(meshed(other), 150.0)
        found = gap(one, other)
        if exact > 0.01:
            apart += 1
            worst = max(worst, abs(found - exact))
        else:
            assert found <= 0.01
    print(f"{apart} pairs apart; worst difference of the gap {worst:.5f} mm")
    assert apart > 10
    assert worst < 0.01


def test_an_overlap_of_parallel_cylinders_is_its_depth():
    one = SolidCylinder(name="a", centre=(0.0, 0.0, 0.0), radius=10.0, half=5.0)
    assert gap(one, SolidCylinder(name="b", centre=(15.0, 0.0, 0.0), radius=8.0, half=5.0)) == pytest.approx(-3.0)
    assert gap(one, SolidCylinder(name="b", centre=(3.0, 0.0, 9.0), radius=8.0, half=5.0)) == pytest.approx(-1.0)
    assert gap(one, SolidCylinder(name="b", centre=(21.0, 0.0, 14.0), radius=8.0, half=5.0)) == pytest.approx(5.0)
