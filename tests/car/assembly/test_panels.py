"""Sheets of a frame: areas by geometry, and gaps against the CAD kernel's distances."""

from math import pi

import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from cadgen.car.assembly.bodies import SolidCylinder
from cadgen.car.assembly.panels import (
    EdgeHole,
    Panel,
    PartPlace,
    SheetHole,
    cylinder_box,
    least_gap,
    parallel_gap,
    pieces,
    rectangle,
    rounded_corners,
    slot,
)
from cadgen.geometry.solids.car_solids import shape_solid


def panel_at(place: PartPlace, corner: float = 1.05) -> Panel:
    """A sheet with a notch, a slot, an opening and holes."""
    corners = np.array([[0, 0], [20, 0], [20, 6], [30, 6], [30, 0], [60, 0], [60, 40], [0, 40]], dtype=float)
    return Panel(
        code="sheet",
        name="sheet",
        outline=rounded_corners(corners, corner, inside=False),
        cuts=(slot((45.0, 12.0), 6.0, 4.0), rounded_corners(rectangle(5, 20, 25, 32), corner, inside=True)),
        holes=(SheetHole("hole", 40.0, 26.0, 8.0, "", 0),),
        edge_holes=(EdgeHole(10.0, 0.0, 2.5, 8.0),),
        features=(),
        thickness=5.0,
        place=place,
    )


def placed(panel: Panel) -> TopoDS_Shape:
    turn, shift = panel.place.turn, panel.place.shift
    trsf = gp_Trsf()
    trsf.SetValues(*(float(v) for row in range(3) for v in (*turn[row], shift[row])))
    return BRepBuilderAPI_Transform(shape_solid(panel.shape, "sheet"), trsf, True).Shape()


def cylinder(body: SolidCylinder) -> TopoDS_Shape:
    start = np.asarray(body.centre) - body.half * np.asarray(body.axis)
    ax = gp_Ax2(gp_Pnt(*start.tolist()), gp_Dir(*body.axis))
    return BRepPrimAPI_MakeCylinder(ax, body.radius, 2 * body.half).Shape()


def test_an_opened_corner_takes_half_a_disc_less_a_triangle() -> None:
    radius = 1.05
    more = radius**2 * (pi / 2 - 1)  # half a disc over the corner's hypotenuse, less the triangle that is open already
    cut = rounded_corners(rectangle(0, 0, 20, 12), radius, inside=True)
    assert cut.area() == pytest.approx(240 + 4 * more, rel=1e-12)
    corners = np.array([[0, 0], [20, 0], [20, 12], [8, 12], [8, 5], [0, 5]], dtype=float)
    assert rounded_corners(corners, radius, inside=False).area() == pytest.approx(20 * 12 - 8 * 7 - more, rel=1e-12)
    assert rounded_corners(corners, 0.0, inside=False).area() == pytest.approx(184)


def test_a_panel_has_the_volume_of_its_solid() -> None:
    from cadgen.geometry.solids.kernel import is_valid, volume

    panel = panel_at(PartPlace(np.eye(3), np.zeros(3)))
    solid = shape_solid(panel.shape, "sheet")
    assert is_valid(solid)
    assert volume(solid) == pytest.approx(panel.volume, rel=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_gaps_are_the_distances_of_the_cad_kernel(seed: int) -> None:
    random = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    panel = panel_at(PartPlace(turn, random.normal(size=3) * 10))
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    middle = panel.place.out(np.array([[30.0, 20.0, 2.5]]))[0] + random.normal(size=3) * 30
    body = SolidCylinder(name="", centre=tuple(middle.tolist()), axis=tuple(axis.tolist()), radius=4.0, half=15.0)
    made = [(0, piece, piece.box) for piece in pieces(panel)]
    found = least_gap(made, [(0, body, cylinder_box(body))], ())
    truth = BRepExtrema_DistShapeShape(placed(panel), cylinder(body)).Value()
    assert found is not None
    # Chords of arcs stay within 0.002 mm.
    assert found.size == pytest.approx(truth, abs=0.003)


def test_a_gap_along_the_normal_is_exact_and_negative_in_the_material() -> None:
    panel = panel_at(PartPlace(np.eye(3), np.array([0.0, 0.0, 10.0])))
    above = SolidCylinder(name="", centre=(50.0, 30.0, 20.0), radius=3.0, half=2.0)
    assert parallel_gap(panel, above) == pytest.approx(3.0)
    beside = SolidCylinder(name="", centre=(70.0, 20.0, 12.0), radius=3.0, half=2.0)
    assert parallel_gap(panel, beside) == pytest.approx(7.0)
    both = SolidCylinder(name="", centre=(67.0, 20.0, 20.0), radius=4.0, half=1.0)
    assert parallel_gap(panel, both) == pytest.approx(5.0)
    inside = SolidCylinder(name="", centre=(50.0, 30.0, 12.0), radius=3.0, half=1.0)
    assert parallel_gap(panel, inside) == pytest.approx(-3.0)
