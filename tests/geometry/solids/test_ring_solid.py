"""Rings as solids: read from STEP by the bare kernel, faces against the exact space at their height."""

from math import pi, radians

import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.GeomAbs import GeomAbs_BezierCurve, GeomAbs_BezierSurface, GeomAbs_BSplineCurve, GeomAbs_BSplineSurface
from OCP.ShapeAnalysis import ShapeAnalysis_ShapeTolerance
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopoDS import TopoDS

from cadgen.errors import FileError
from cadgen.gears.ring import ring_of, ring_tooth
from cadgen.gears.tooth import GearForm
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.geometry.solids.gear_solids import body_solid
from cadgen.geometry.solids.kernel import edges_on_surfaces, fits, is_valid, volume
from cadgen.geometry.solids.step_text import read_gear
from tests.geometry.solids.test_helical_wall import FLANK_BAR_UM, ROOT_BAR_UM, VOLUME_BAR, parts, read, turned_back


def ring(teeth, helix=0.0, *, cutter=None, module=1.0, width=8.0, **numbers):
    form = GearForm(teeth=teeth, normal_module=module, width=width, helix_angle=radians(helix), **numbers)
    return ring_of(form, cutter_teeth=cutter)


RINGS = {
    "spur": ring(60, addendum_factor=0.8),
    "arc": ring(50, cutter=0),
    "helical": ring(40, 20.0, profile_shift=-0.2, tooth_thickness_deviation=-0.05),
    "helical arc": ring(32, -15.0, cutter=0),
    "double": ring(40, -30.0, double=True, tip_chamfer=0.1),
    "small": ring(37, 25.0, module=0.2, width=3.0),
    "45 degrees, large": ring(28, 45.0, module=10.0, width=100.0),
}


def lines(shape, form):
    """Points of flanks and roots of the solid, turned to the section midway, by curve or face."""
    found = []
    if form.helix_angle == 0:
        for edge in parts(shape, TopAbs_EDGE):
            curve = BRepAdaptor_Curve(TopoDS.Edge(edge))
            if curve.GetType() in (GeomAbs_BezierCurve, GeomAbs_BSplineCurve):
                points = [curve.Value(t) for t in np.linspace(curve.FirstParameter(), curve.LastParameter(), 17)]
                found.append(np.array([complex(p.X(), p.Y()) for p in points]))
        return found[::5]
    for face in parts(shape, TopAbs_FACE)[::5]:
        surface = BRepAdaptor_Surface(TopoDS.Face(face))
        if surface.GetType() in (GeomAbs_BezierSurface, GeomAbs_BSplineSurface):
            u, v = np.linspace(0.0, 1.0, 17), np.linspace(0.0, 1.0, 7)
            points = [surface.Value(float(a), float(b)) for a in u for b in v]
            found.append(turned_back(np.array([[p.X(), p.Y(), p.Z()] for p in points]), form))
    return found


def errors_um(shape, form):
    """Greatest distance of flanks and roots from the exact ones of a space, µm."""
    tooth = ring_tooth(form)
    exact = tooth.upper_root.point(np.linspace(0.0, 1.0, 8001))
    pitch, base = 2 * pi / form.teeth, form.base_diameter / 2
    flank = root = 0.0
    for local in lines(shape, form):
        middle = local[len(local) // 2]
        local *= np.exp(-1j * pitch * (np.floor(np.angle(middle) / pitch) + 0.5))
        local = np.conj(local) if local[len(local) // 2].imag < 0 else local
        reach = np.abs(local)
        if form.tip_chamfer and reach.min() < form.tip_form_diameter / 2 - 1e-6:
            continue
        if abs(middle) < tooth.root_form_diameter / 2:
            angle = np.arccos(np.minimum(base / reach, 1.0))
            off = base * np.abs(np.angle(local) - (form.base_half_angle - np.tan(angle) + angle))
            flank = max(flank, float(off.max()))
        else:
            nearest = np.clip(np.argmin(np.abs(local[:, None] - exact), axis=1), 1, len(exact) - 2)
            along = exact[nearest + 1] - exact[nearest - 1]
            root = max(root, float(np.abs(((local - exact[nearest]) * np.conj(along / np.abs(along))).imag).max()))
    return flank * 1e3, root * 1e3


@pytest.mark.parametrize("name", RINGS)
def test_a_ring_in_the_file_is_exact(name, tmp_path):
    form = RINGS[name]
    body = gear_body(form)
    solid = body_solid(body)
    assert is_valid(solid)
    assert fits(solid)
    assert edges_on_surfaces(solid)
    assert volume(solid) == pytest.approx(body.prismatic_volume, rel=VOLUME_BAR)
    shape = read(solid, tmp_path / "ring.step")
    assert BRepCheck_Analyzer(shape).IsValid()
    assert len(parts(shape, TopAbs_SOLID)) == 1
    assert ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1) <= 1e-7
    flank, root = errors_um(shape, form)
    assert flank <= FLANK_BAR_UM
    assert root <= ROOT_BAR_UM
    content = read_gear(tmp_path / "ring.step", [form], [0.0])
    assert content.flank_error * 1e3 <= FLANK_BAR_UM
    assert content.root_error * 1e3 <= ROOT_BAR_UM
    mesh = body_mesh(body, 2e-3)
    assert mesh.solid().volume() == pytest.approx(body.prismatic_volume, rel=4e-3 if name == "small" else 4e-4)


def test_a_ring_with_other_roots_is_seen(tmp_path):
    read(body_solid(gear_body(RINGS["arc"])), tmp_path / "ring.step")
    with pytest.raises(FileError, match="does not have all the flanks and roots"):
        read_gear(tmp_path / "ring.step", [ring(50)], [0.0])
