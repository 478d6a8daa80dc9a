"""Free range of a carrier measured on STEP files by the kernel and polygons: nothing of the program reads or meshes.

Flanks and roots of a gear's section are lines of its surfaces at one height; arcs join their ends. A planet on the
carrier is free while some angle of its own keeps it off the sun and inside the ring.
"""

from math import degrees, pi

import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Cylinder
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS
from shapely import Polygon
from shapely.affinity import rotate, translate

from cadgen import Gear, Planetary

pytestmark = [pytest.mark.slow, pytest.mark.long]

POINTS = 60  # of a curve: chords of the flanks stay within 0.02 µm
SEEN = 2e-9  # mm², overlap that counts
SUN, PLANET, RING = 18, 27, 72
BACKLASH = 0.12


def curves(file, height):
    """Lines of a solid's walls at a height, without those of its cylinders."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(file))
    reader.TransferRoots()
    explorer, found = TopExp_Explorer(reader.OneShape(), TopAbs_FACE), []
    while explorer.More():
        surface = BRepAdaptor_Surface(TopoDS.Face(explorer.Current()), True)
        explorer.Next()
        ends = [
            surface.FirstUParameter(),
            surface.LastUParameter(),
            surface.FirstVParameter(),
            surface.LastVParameter(),
        ]
        points = {(i, j): surface.Value(ends[i], ends[2 + j]) for i in (0, 1) for j in (0, 1)}
        rises = [points[1, 0].Z() - points[0, 0].Z(), points[0, 1].Z() - points[0, 0].Z()]
        if surface.GetType() == GeomAbs_Cylinder or max(map(abs, rises)) < 1e-9:
            continue
        along = int(abs(rises[1]) > abs(rises[0]))  # parameter that runs with z, in which it is linear
        share = (height - points[0, 0].Z()) / rises[along]
        at = ends[2 * along] + share * (ends[2 * along + 1] - ends[2 * along])
        other = np.linspace(*ends[2 - 2 * along : 4 - 2 * along], POINTS).tolist()
        line = [surface.Value(each, at) if along else surface.Value(at, each) for each in other]
        assert max(abs(point.Z() - height) for point in line) < 1e-9
        found.append(np.array([complex(point.X(), point.Y()) for point in line]))
    return found


def section(file, height):
    """Polygon of the teeth."""
    left = curves(file, height)
    loop = left.pop()
    while True:
        ends = [(loop[0], None, None)] + [(line[end], line, end) for line in left for end in (0, -1)]
        last = loop[-1]
        point, line, end = min(
            (each for each in ends if abs(abs(each[0]) - abs(last)) < 1e-5), key=lambda each: abs(each[0] - last)
        )
        loop = np.append(loop, last * np.exp(1j * np.angle(point / last) * np.linspace(0, 1, POINTS)))
        if line is None:
            return Polygon(np.column_stack([loop.real, loop.imag])).buffer(0)
        left = [each for each in left if each is not line]
        loop = np.append(loop, line if end == 0 else line[::-1])


def turned(polygon, angle):
    return rotate(polygon, degrees(angle), origin=(0, 0))


def limits(planet, other, middle, inside):
    """Angles of a planet, from the middle of its play on, up to which it does not overlap a sun, or leave a ring."""

    def hits(angle):
        placed = turned(planet, angle)
        return (placed.difference(other) if inside else placed.intersection(other)).area > SEEN

    assert not hits(middle)
    found = []
    for side in (-1, 1):
        free, blocked = 0.0, pi / PLANET
        while blocked - free > 1e-8:
            tried = (free + blocked) / 2
            free, blocked = (free, tried) if hits(middle + side * tried) else (tried, blocked)
        found.append(middle + side * free)
    return found


def free_range(sun, planet, ring, apart, orbit):
    """Angles of the carrier between which a planet at an orbit is free, sun and ring at rest."""
    ends = []
    for side in (-1, 1):

        def room(angle, side=side):
            at = orbit + angle
            towards_sun = pi + pi / PLANET + at * SUN / PLANET
            towards_ring = pi + pi / PLANET - at * RING / PLANET
            towards_ring -= round((towards_ring - towards_sun) * PLANET / (2 * pi)) * 2 * pi / PLANET
            in_sun, in_ring = (
                limits(planet, translate(turned(each, -at), -apart), middle, inside)
                for each, middle, inside in ((sun, towards_sun, False), (ring, towards_ring, True))
            )
            return in_ring[1] - in_sun[0] if side > 0 else in_sun[1] - in_ring[0]

        # The room of a planet falls straight with the angle of the carrier.
        one, other = 0.0, side * 1e-3
        at_one, at_other = room(one), room(other)
        ends.append(one - at_one * (other - one) / (at_other - at_one))
    return ends


@pytest.mark.parametrize("helix", [0.0, 0.35], ids=["spur", "helical"])
def test_the_carrier_is_free_as_far_as_it_is_said(helix, tmp_path):
    """Within 0.2 µm of arc on the planets' axes, at two heights; planets at two orbits of three."""
    sun, planet = (
        Gear(teeth=teeth, module=1, width=6, helix_angle=helix, hand=hand, bore=4)
        for teeth, hand in ((SUN, "right"), (PLANET, "left"))
    )
    made = Planetary(sun, planet, planets=3, backlash=BACKLASH)
    made.write(tmp_path, formats=["step"])
    files = {name: next(tmp_path.glob(f"*{name}*.step")) for name in ("sun", "planet_1", "ring")}
    apart = made.cut.centre_distance
    for height, orbit in ((0.1, 0.0), (4.0, 2 * pi / 3)):
        one, other, outer = (section(file, height) for file in files.values())
        ring = turned(outer, pi / RING)  # a space towards a planet of an odd number of teeth
        low, high = free_range(one, other, ring, apart, orbit)
        assert (high - low - made.play) * apart * 1e3 == pytest.approx(0.0, abs=0.2)
