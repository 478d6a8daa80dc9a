"""Gear solids and meshes: their curves against the exact ones, their volumes against Green's theorem, their files."""

import os
from math import pi
from pathlib import Path

import numpy as np
import pytest
import trimesh
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.GeomAbs import GeomAbs_BezierCurve, GeomAbs_BSplineCurve
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Shape, TopoDS_Solid

from cadgen.errors import DesignError
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.gears.wheel_body import cluster_body, gear_body
from cadgen.geometry.meshes.mesh import Mesh, body_mesh
from cadgen.geometry.solids.gear_solids import body_solid
from cadgen.geometry.solids.kernel import SolidPart, is_valid, volume
from cadgen.geometry.solids.step import step_bytes
from cadgen.parts.blank import Blank
from cadgen.parts.body import Body
from cadgen.parts.features import Hub, Keyway, Lightening, SetScrew, Web

FLANK_BAR_UM = 0.001
ROOT_BAR_UM = 0.01
VOLUME_BAR = 1e-6
STEP_BAR_BYTES = 2.2e6
UM = 1e-3


def gear(teeth: int, module: float = 0.5, shift: float = 0.0, **numbers: float) -> GearForm:
    return GearForm(teeth=teeth, normal_module=module, width=5.0, profile_shift=shift, **numbers)


FULL = Blank(
    bore_diameter=8.0,
    key=Keyway.standard(8.0),
    hub=Hub(diameter=16.0, length=6.0, set_screw=SetScrew(diameter=3.0, height=3.0)),
    web=Web(thickness=2.0, rim_thickness=3.0),
    lightening=Lightening(count=6, hole_diameter=8.0),
)
COLLAR = Blank(bore_diameter=5.0, hub=Hub(diameter=15.0, length=4.0))
BODIES = {
    "plain disc": gear_body(gear(30)),
    "bore": gear_body(gear(30), Blank(bore_diameter=5.0)),
    "keyway": gear_body(gear(40, 1.0), Blank(bore_diameter=10.0, key=Keyway.standard(10.0))),
    "hub": gear_body(gear(40, 1.0), Blank(bore_diameter=10.0, hub=Hub(diameter=20.0, length=7.0))),
    "hub without bore": gear_body(gear(40, 1.0), Blank(hub=Hub(diameter=20.0, length=7.0))),
    "holes": gear_body(gear(60), Blank(bore_diameter=5.0, lightening=Lightening(count=5, hole_diameter=6.0))),
    "web": gear_body(
        gear(60, 1.0),
        Blank(bore_diameter=8.0, hub=Hub(diameter=14.0), web=Web(thickness=2.0, rim_thickness=4.0)),
    ),
    "everything": gear_body(gear(80, 1.0), FULL),
    "chamfer": gear_body(gear(24, 1.0, tip_chamfer=0.1)),
    "undercut": gear_body(gear(9, 1.0)),
    "limit of undercut": gear_body(gear(12, 1.0, 1.25 - 0.38 * (1 - 0.3420201433256687) - 6 * 0.11697777844051097)),
    "cluster": cluster_body(gear(120), gear(40), Blank(bore_diameter=5.0), turn=0.02),
    "cluster with collar": cluster_body(gear(60), gear(40), COLLAR, turn=0.02),
}


def curve_points(shape: TopoDS_Shape, height: float) -> list[np.ndarray]:
    """Points, 33 on each, of the splines among the edges of `shape` at `height`, as x + iy in mm."""
    found, seen = [], set()
    explorer = TopExp_Explorer(shape, TopAbs_EDGE)
    while explorer.More():
        curve = BRepAdaptor_Curve(TopoDS.Edge(explorer.Current()))
        explorer.Next()
        if curve.GetType() not in (GeomAbs_BezierCurve, GeomAbs_BSplineCurve):
            continue
        points = [curve.Value(t) for t in np.linspace(curve.FirstParameter(), curve.LastParameter(), 33)]
        plane = np.array([complex(p.X(), p.Y()) for p in points])
        key = complex(np.round(plane[16], 6))
        if abs(points[0].Z() - height) < 1e-9 and key not in seen:
            seen.add(key)
            found.append(plane)
    return found


def errors_um(shape: TopoDS_Shape, form: GearForm) -> tuple[float, float]:
    """Largest distance of the solid's flanks from the exact involute, and of its roots from the exact root."""
    tooth = tooth_of(form)
    exact_root = tooth.upper_root.point(np.linspace(0.0, 1.0, 4001))
    flank_error = root_error = 0.0
    curves = curve_points(shape, 0.0)
    assert len(curves) == 4 * form.teeth
    for points in curves[:40]:
        # Every curve is brought to the upper side of the tooth on the x axis.
        pitch = 2 * pi / form.teeth
        local = points * np.exp(-1j * pitch * np.round(np.angle(points[16]) / pitch))
        local = np.where(local.imag < 0, np.conj(local), local)
        if abs(local[16]) > tooth.root_form_diameter / 2:
            angle = np.arccos(np.minimum(form.base_diameter / 2 / np.abs(local), 1.0))
            exact = form.base_half_angle - np.tan(angle) + angle
            off = form.base_diameter / 2 * np.abs(np.angle(local) - exact)
            flank_error = max(flank_error, float(off.max()))
        else:
            nearest = np.clip(np.argmin(np.abs(local[:, None] - exact_root), axis=1), 1, len(exact_root) - 2)
            along = exact_root[nearest + 1] - exact_root[nearest - 1]
            off = np.abs(((local - exact_root[nearest]) * np.conj(along / np.abs(along))).imag)
            root_error = max(root_error, float(off.max()))
    return flank_error / UM, root_error / UM


def through_step(solid: TopoDS_Solid, path: Path) -> TopoDS_Shape:
    path.write_bytes(step_bytes(SolidPart(solid=solid, name="gear", description="a gear", colour=(0.5, 0.5, 0.5))))
    reader = STEPControl_Reader()
    assert reader.ReadFile(os.fspath(path)) == IFSelect_RetDone
    reader.TransferRoots()
    return reader.OneShape()


@pytest.mark.slow
@pytest.mark.parametrize("teeth", [12, 13, 17, 18, 25, 42, 60, 99, 150, 200])
def test_flank_root_and_volume_of_the_solid_are_exact(teeth: int) -> None:
    form = gear(teeth, 1.0)
    solid = body_solid(gear_body(form))
    flank, root = errors_um(solid, form)
    off = volume(solid) / (tooth_of(form).outline.area * form.width) - 1
    print(f"z = {teeth}: flank {flank:.1e} µm, root {root:.1e} µm, volume {off:+.1e}")
    assert is_valid(solid)
    assert flank <= FLANK_BAR_UM
    assert root <= ROOT_BAR_UM
    assert abs(off) <= VOLUME_BAR


@pytest.mark.slow
@pytest.mark.long
def test_a_step_file_of_150_teeth_is_small_and_keeps_the_errors(tmp_path: Path) -> None:
    form = gear(150, 1.0)
    body = gear_body(form, Blank(bore_diameter=10.0))
    path = tmp_path / "gear.step"
    again = through_step(body_solid(body), path)
    flank, root = errors_um(again, form)
    off = volume(again) / body.prismatic_volume - 1
    size = path.stat().st_size
    print(f"STEP of z = 150: {size} bytes; read again: flank {flank:.1e} µm, root {root:.1e} µm, volume {off:+.1e}")
    assert size <= STEP_BAR_BYTES
    assert is_valid(again)
    assert flank <= FLANK_BAR_UM
    assert root <= ROOT_BAR_UM
    assert abs(off) <= VOLUME_BAR


def drilled_volume(body: Body, bore_diameter: float, keyway_depth: float) -> float:
    """Volume of the radial hole between the bore, or the keyway's floor on its way, and the hub's outside."""
    hole, hub = body.radial_hole, body.radial_hole.reach / 2
    y = np.linspace(-hole.diameter / 2, hole.diameter / 2, 200001)
    inner = np.sqrt((bore_diameter / 2) ** 2 - y**2)
    inner = np.where(np.abs(y) < 1.0, bore_diameter / 2 + keyway_depth, inner) if keyway_depth else inner
    height = 2 * np.sqrt(np.maximum((hole.diameter / 2) ** 2 - y**2, 0.0))
    return float(np.trapezoid(height * (np.sqrt(hub**2 - y**2) - inner), y))


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_every_feature_makes_a_valid_solid_of_the_exact_volume(name: str) -> None:
    body = BODIES[name]
    solid = body_solid(body)
    exact = body.prismatic_volume
    if body.radial_hole:
        exact -= drilled_volume(body, 8.0, 1.0)
    assert is_valid(solid)
    assert volume(solid) == pytest.approx(exact, rel=VOLUME_BAR)


def wall_count(body: Body) -> int:
    explorer = TopExp_Explorer(body_solid(body), TopAbs_FACE)
    count = 0
    while explorer.More():
        count += 1
        explorer.Next()
    return count


def test_a_gear_has_no_more_faces_than_curves_and_caps() -> None:
    assert wall_count(BODIES["plain disc"]) == 6 * 30 + 2
    assert wall_count(BODIES["bore"]) == 6 * 30 + 1 + 2
    assert wall_count(BODIES["keyway"]) == 6 * 40 + 4 + 2
    assert wall_count(BODIES["hub"]) == 6 * 40 + 2 + 3
    assert wall_count(BODIES["cluster with collar"]) == 6 * (60 + 40) + 2 + 4


def through_stl(mesh: Mesh) -> trimesh.Trimesh:
    written = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False).export(file_type="stl")
    return trimesh.load(trimesh.util.wrap_as_stream(written), file_type="stl")


@pytest.mark.parametrize("name", BODIES)
def test_every_mesh_is_watertight_also_through_stl_and_as_large_as_the_solid(name: str) -> None:
    body, tolerance = BODIES[name], 2e-3
    mesh = body_mesh(body, tolerance)
    again = through_stl(mesh)
    assert again.is_watertight
    assert again.is_winding_consistent
    assert again.is_volume
    solid = mesh.solid()
    assert len(solid.decompose()) == 1
    assert Mesh(np.asarray(again.vertices), np.asarray(again.faces)).solid().volume() > 0
    # Chords err by less than their tolerance over the whole wall.
    side = again.area - 2 * abs(again.area_faces[np.abs(again.face_normals[:, 2]) > 0.5].sum()) / 2
    assert abs(solid.volume() - volume(body_solid(body))) < tolerance * side


@pytest.mark.slow
@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4])
def test_the_stl_keeps_its_chord_tolerance(tolerance: float) -> None:
    form = gear(30, 1.0)
    again = through_stl(body_mesh(gear_body(form, Blank(bore_diameter=8.0)), tolerance))
    cut = trimesh.intersections.mesh_plane(again, [0.0, 0.0, 1.0], [0.0, 0.0, 2.0])[:, :, :2] @ np.array([1.0, 1j])
    start, along = cut[:, 0], cut[:, 1] - cut[:, 0]
    worst = 0.0
    for curve in tooth_of(form).outline.curves:
        points = curve.point(np.linspace(0.0, 1.0, 301))[:, None]
        share = np.clip(((points - start) * np.conj(along)).real / np.abs(along) ** 2, 0.0, 1.0)
        worst = max(worst, float(np.abs(points - start - share * along).min(axis=1).max()))
    rounded = 2e-6  # single precision of an STL file at 16 mm
    print(f"chord tolerance {tolerance / UM:g} µm: worst {worst / UM:.3f} µm, {len(again.faces)} triangles")
    assert 0.5 * tolerance < worst <= tolerance + rounded


def test_solid_and_mesh_of_a_cluster_turn_the_upper_gear() -> None:
    turn = 0.03
    body = cluster_body(gear(60), gear(30), Blank(bore_diameter=5.0), turn=turn)
    mesh = body_mesh(body, 1e-3)
    top = mesh.vertices[mesh.vertices[:, 2] == 10.0]
    tips = np.angle(top @ np.array([1.0, 1j, 0.0]))[np.hypot(top[:, 0], top[:, 1]) > 8.0 - 1e-9]
    pitch = 2 * pi / 30
    middle = (tips - turn + pitch / 2) % pitch - pitch / 2
    assert abs(middle.max() + middle.min()) < 1e-9


REFUSED = {
    "bore that reaches": Blank(bore_diameter=28.0),
    "keyway that reaches": Blank(bore_diameter=22.0, key=Keyway(width=6.0, depth=2.8)),
    "give a narrower one": Blank(bore_diameter=5.0, key=Keyway(width=6.0, depth=1.0)),
    "keyway depth of 0": Blank(bore_diameter=5.0, key=Keyway(width=2.0, depth=0.0)),
    "bore of -1": Blank(bore_diameter=-1.0),
    "hub of 30": Blank(bore_diameter=5.0, hub=Hub(diameter=30.0, length=3.0)),
    "hub of 5 mm": Blank(bore_diameter=5.0, hub=Hub(diameter=5.0, length=3.0)),
    "hub of 0 mm length": Blank(bore_diameter=5.0, hub=Hub(diameter=10.0)),
    "hub of -1 mm length": Blank(hub=Hub(diameter=10.0, length=-1.0), web=Web(thickness=2.0, rim_thickness=2.0)),
    "set screw of 3": Blank(
        bore_diameter=5.0, hub=Hub(diameter=10.0, length=3.0, set_screw=SetScrew(diameter=3.0, height=1.5))
    ),
    "bore of 0": Blank(hub=Hub(diameter=10.0, length=8.0, set_screw=SetScrew(diameter=3.0, height=4.0))),
    "web but no hub": Blank(web=Web(thickness=2.0, rim_thickness=2.0)),
    "web of 4.5": Blank(hub=Hub(diameter=10.0), web=Web(thickness=4.5, rim_thickness=2.0)),
    "rim of 0.5": Blank(hub=Hub(diameter=10.0), web=Web(thickness=2.0, rim_thickness=0.5)),
    "give a hub of 0.8 to": Blank(hub=Hub(diameter=25.0), web=Web(thickness=2.0, rim_thickness=2.0)),
    "0 lightening holes": Blank(lightening=Lightening(count=0, hole_diameter=3.0)),
    "9 lightening holes": Blank(bore_diameter=8.0, lightening=Lightening(count=9, hole_diameter=7.0)),
}


@pytest.mark.parametrize(("said", "blank"), REFUSED.items(), ids=REFUSED)
def test_impossible_blanks_are_refused_in_one_sentence(said: str, blank: Blank) -> None:
    with pytest.raises(DesignError) as refusal:
        gear_body(gear(30, 1.0), blank)
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_clusters_that_do_not_fit_are_refused() -> None:
    with pytest.raises(DesignError, match="put a collar"):
        cluster_body(gear(40), gear(38))
    with pytest.raises(DesignError, match="stands in the teeth"):
        cluster_body(gear(60), gear(30), COLLAR)
    with pytest.raises(DesignError, match="bore that reaches"):
        cluster_body(gear(60), gear(14), Blank(bore_diameter=5.0))


def test_standard_keyways_end_where_the_standard_ends() -> None:
    assert Keyway.standard(8.0) == Keyway(width=2.0, depth=1.0)
    assert Keyway.standard(8.1) == Keyway(width=3.0, depth=1.4)
    for bore in (6.0, 110.5):
        with pytest.raises(DesignError, match="no keyway is standardised"):
            Keyway.standard(bore)
