"""Features of a part: one shape for disc and gear, where a hub stands, and what only one of the two may have."""

from dataclasses import replace
from math import asin, hypot, pi, radians, sqrt

import numpy as np
import pytest

from cadgen.curves.contour import circle
from cadgen.errors import DesignError
from cadgen.gears.tooth import GearForm
from cadgen.gears.wheel_body import LEAST_WALL, gear_body
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Keyway, Lightening, Mark, SetScrew, Web
from cadgen.parts.loop import Arc, loop_of

GEAR = GearForm(teeth=60, normal_module=0.5, width=4.0)
KEYED = Blank(bore_diameter=8.0, key=Keyway(width=3.0, depth=1.4))
HUBBED = replace(KEYED, hub=Hub(diameter=16.0, length=6.0, set_screw=SetScrew(diameter=2.0, height=3.0)))


def keyed_area(diameter: float, width: float, depth: float) -> float:
    """Circle, and the keyway's rectangle beyond its chord less the circle's segment there."""
    r, half = diameter / 2, width / 2
    angle = asin(half / r)
    segment = r**2 * angle - half * sqrt(r**2 - half**2)
    return pi * r**2 + width * (r + depth - sqrt(r**2 - half**2)) - segment


def flat_area(diameter: float, depth: float) -> float:
    """Circle less the segment behind the flat."""
    r = diameter / 2
    off = r - depth
    angle = np.arccos(off / r)
    return pi * r**2 - (r**2 * angle - off * sqrt(r**2 - off**2))


@pytest.mark.parametrize(
    ("key", "area"),
    [
        (None, pi * 16.0),
        (Keyway(width=3.0, depth=1.4), keyed_area(8.0, 3.0, 1.4)),
        (Keyway(width=3.0, depth=1.4, angle=2.0), keyed_area(8.0, 3.0, 1.4)),
        (DFlat(depth=1.0, angle=-1.0), flat_area(8.0, 1.0)),
    ],
)
def test_a_bore_is_the_same_shape_as_contour_and_as_loop(key, area):
    contour = Blank(bore_diameter=8.0, key=key).bore()
    loop = loop_of(contour)
    assert contour.area() == pytest.approx(area, rel=1e-13)
    assert loop.area == pytest.approx(area, rel=1e-13)
    corners = loop.polygon(1e-4)
    assert np.abs(corners).min() == pytest.approx(min(np.linalg.norm(contour.polygon(1e-4), axis=1)), abs=1e-12)
    ends = [
        abs(a.point(1.0) - b.point(0.0)) for a, b in zip(loop.curves, loop.curves[1:] + loop.curves[:1], strict=True)
    ]
    assert max(ends) < 1e-12


def test_an_arc_of_a_bore_has_its_round_radius():
    arcs = [curve for curve in loop_of(KEYED.bore()).curves if isinstance(curve, Arc)]
    assert [(arc.radius, arc.centre) for arc in arcs] == [(4.0, 0j)]


@pytest.mark.parametrize(("side", "heights"), [("outer", (3.0, 9.0)), ("inner", (-6.0, 0.0))])
def test_a_hub_stands_on_its_face_and_its_bore_is_cut_through_both(side, heights):
    boss = replace(HUBBED, hub=replace(HUBBED.hub, side=side)).boss(3.0)
    assert (boss.low, boss.high) == heights
    assert boss.bottom < min(boss.low, 0.0)
    assert boss.top > max(boss.high, 3.0)
    assert boss.drill.height == np.mean(heights)
    assert boss.drill.reach > 8.0


def test_a_set_screw_may_stand_anywhere_along_a_gear_s_hub():
    low, high = (
        gear_body(GEAR, replace(HUBBED, hub=replace(HUBBED.hub, set_screw=SetScrew(diameter=2.0, height=height))))
        for height in (1.5, 4.5)
    )
    assert low.drilled == high.drilled == 1
    volumes = [body_mesh(body, 0.01).solid().volume() for body in (low, high)]
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-9)
    heights = [np.unique(body_mesh(body, 0.01).vertices[:, 2]) for body in (low, high)]
    assert [min(z[(z > 4.0) & (z < 10.0)]) for z in heights] == pytest.approx([4.5, 7.5], abs=0.01)


def test_the_circle_of_a_gear_s_holes_is_midway_or_as_given():
    def radii(ring: Lightening) -> list[float]:
        body = gear_body(GEAR, replace(HUBBED, lightening=ring))
        return [abs(hole.curves[0].centre) for hole in body.slabs[0].holes]

    ring = Lightening(count=5, hole_diameter=2.0)
    rim = GEAR.root_diameter - 0.5 * (GEAR.tip_diameter - GEAR.root_diameter)
    middle = (16.0 + rim) / 2
    even = round(10 * middle) / 10
    assert abs(even - middle) > 0.01
    assert [2 * radius for radius in radii(ring)] == pytest.approx([even] * 5, abs=1e-9)
    # Holes that have room only exactly midway stay there: no gear that could be made is refused for a round size.
    widest = replace(ring, hole_diameter=(rim - 16.0) / 2 - 2 * LEAST_WALL)
    assert [2 * radius for radius in radii(widest)] == pytest.approx([middle] * 5, abs=1e-9)
    assert radii(replace(ring, circle_diameter=20.0)) == pytest.approx([10.0] * 5)
    with pytest.raises(DesignError, match="lightening holes of 2 mm"):
        radii(replace(ring, circle_diameter=18.0))


@pytest.mark.parametrize(
    ("blank", "message"),
    [
        (replace(KEYED, edge_break=0.2), "tip chamfer"),
        (replace(KEYED, mark=Mark(diameter=2.0, radius=10.0, angle=1.0)), "has a mark"),
        (replace(HUBBED, hub=replace(HUBBED.hub, side="inner")), "inner face"),
        (replace(KEYED, key=Keyway(width=3.0, depth=1.4, angle=radians(90))), "keyway at 90°"),
        (replace(HUBBED, hub=replace(HUBBED.hub, set_screw=SetScrew(diameter=2.0, height=3.0, angle=1.0))), "57.29"),
        (replace(HUBBED, hub=replace(HUBBED.hub, set_screw=SetScrew(diameter=2.0, height=1.3))), "at most 1.8 mm"),
    ],
)
def test_a_gear_refuses_what_only_a_disc_may_have(blank, message):
    with pytest.raises(DesignError, match=message):
        gear_body(GEAR, blank)


def test_the_recess_of_a_web_has_a_round_size_and_leaves_the_rim():
    def recess(rim, holes=None):
        blank = replace(HUBBED, web=Web(thickness=2.0, rim_thickness=rim), lightening=holes)
        return 2 * gear_body(GEAR, blank).slabs[0].rings[1].radii[1]

    for rim in (1.5, 1.77, 2.0, 2.03):
        exact = GEAR.root_diameter - 2 * rim
        assert exact - 0.1 < recess(rim) <= exact + 1e-9
        assert abs(10 * recess(rim) - round(10 * recess(rim))) < 1e-9
    exact = GEAR.root_diameter - 4.0
    widest = Lightening(count=3, hole_diameter=(exact - 16.0) / 2 - 2 * LEAST_WALL)
    assert recess(2.0, widest) == pytest.approx(exact, abs=1e-9)


@pytest.mark.parametrize(
    ("blank", "message"),
    [
        (replace(KEYED, web=Web(thickness=2.0, rim_thickness=2.0)), "a web is for a gear"),
        (Blank(), "bore of a disc is 0 mm"),
        (replace(KEYED, lightening=Lightening(count=3, hole_diameter=5.0)), "diameter of the circle"),
    ],
)
def test_a_disc_refuses_what_only_a_gear_may_have(blank, message):
    with pytest.raises(DesignError, match=message):
        blank.require_walls(circle((0.0, 0.0), 40.0).outline(0.1))


def test_the_walls_of_a_mark():
    """On the x axis of a plain disc of 80 mm every wall is a difference of radii; the hole stands at 90 degrees."""
    blank = Blank(
        bore_diameter=8.0,
        mark=Mark(diameter=4.0, radius=20.0, angle=0.0),
        lightening=Lightening(count=2, hole_diameter=10.0, circle_diameter=50.0, start_angle=radians(90)),
    )
    walls = {wall.between: wall.thickness for wall in blank.walls(circle((0.0, 0.0), 40.0).outline(0.1))}
    assert walls["mark and bore"] == pytest.approx(20 - 2 - 4, abs=1e-4)
    assert walls["lightening hole 1 and profile"] == pytest.approx(40 - 25 - 5, abs=1e-3)
    assert walls["lightening hole 1 and mark"] == pytest.approx(hypot(20, 25) - 5 - 2, abs=1e-9)
    alone = replace(blank, lightening=None)
    walls = {wall.between: wall.thickness for wall in alone.walls(circle((0.0, 0.0), 40.0).outline(0.1))}
    assert walls["mark and profile"] == pytest.approx(40 - 20 - 2, abs=1e-3)
    assert alone.disc_volume(80.0**2, 3.0) == pytest.approx(3 * (80.0**2 - pi * (16 + 4)))
