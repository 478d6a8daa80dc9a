"""The cam as a mesh, its STL and its 3MF: closed, one body, true to the chord tolerance, read back from bytes."""

import os
import subprocess
import sys
import zipfile
from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from cadgen.cam.contact import roll
from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.closed import ClosedCurve, cross
from cadgen.curves.contour import Contour, circle
from cadgen.errors import DesignError, FileError
from cadgen.geometry.meshes.content import MeshContent, inspect
from cadgen.geometry.meshes.mesh import Mesh, cam_mesh
from cadgen.output.files.stl import read_stl, stl_bytes
from cadgen.output.files.threemf import read_3mf, threemf_bytes
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Keyway, Lightening, SetScrew

THICKNESS = 3.0
CHORD = 0.005  # mm, the designs' default
STEP = 0.05
CAM_ANGLES = np.radians(np.arange(0, 360, 0.1))
KEYED = Blank(
    bore_diameter=8.0,
    key=Keyway(width=3.0, depth=1.4),
    lightening=Lightening(count=6, hole_diameter=18.0, circle_diameter=78.0),
)
HUB = Hub(diameter=20.0, length=10.0, set_screw=SetScrew(diameter=4.2, height=5.0, angle=pi))
BLANKS = {
    "keyway and holes": KEYED,
    "plain": Blank(bore_diameter=8.0),
    "D-flat": Blank(bore_diameter=8.0, key=DFlat(depth=1.0, angle=0.3)),
    "outer hub": replace(KEYED, hub=HUB),
    "inner hub": replace(KEYED, hub=replace(HUB, side="inner")),
    "hub without screw": replace(KEYED, hub=replace(HUB, set_screw=None)),
}


def exact_volume(blank: Blank, area: float) -> float:
    """Disc and hub, less the drill's cut through the hub's wall where the bore is round (quadrature)."""
    total = blank.disc_volume(area, THICKNESS)
    if blank.hub is None:
        return total
    total += (pi * blank.hub.diameter**2 / 4 - blank.bore().area()) * blank.hub.length
    if blank.hub.set_screw is None:
        return total
    drill, outside = blank.hub.set_screw.diameter / 2, blank.hub.diameter / 2
    inside = blank.bore_diameter / 2

    def wall(y: float) -> float:
        return 2 * sqrt(drill**2 - y**2) * (sqrt(outside**2 - y**2) - sqrt(inside**2 - y**2))

    return total - quad(wall, -drill, drill)[0]


@pytest.fixture(params=["stl", "3mf"])
def through_file(request, tmp_path):
    """Write a mesh to a file and read it again."""

    def round_trip(mesh: Mesh) -> Mesh:
        path = tmp_path / f"cam.{request.param}"
        if request.param == "stl":
            path.write_bytes(stl_bytes(mesh, "cam"))
            return read_stl(path)
        path.write_bytes(threemf_bytes(mesh, "cam", "a cam"))
        again, name = read_3mf(path)
        assert name == "cam"
        return again

    return round_trip


def lift_error(car, content: MeshContent) -> float:
    wanted = car.follower.lift(car.lift.q(CAM_ANGLES))
    return float(np.abs(roll(content.rim, car.follower, CAM_ANGLES).lift - wanted).max())


@pytest.mark.slow
@pytest.mark.parametrize("name", BLANKS)
def test_round_trip(carbon_free_car, through_file, name):
    curve, blank = carbon_free_car.actual.curve, BLANKS[name]
    made = cam_mesh(curve, blank, THICKNESS, CHORD)
    content = inspect(through_file(made), STEP)
    exact = exact_volume(blank, curve.area())
    lift = lift_error(carbon_free_car, content)
    print(
        f"\n{name}: {len(made.triangles)} triangles, {1e3 * lift:.2f} um at lift, "
        f"volume off by {content.volume / exact - 1:.1e}, bound {CHORD * content.wall_area / exact:.1e}"
    )
    assert content.watertight
    assert content.bodies == 1
    assert lift <= CHORD
    assert abs(content.volume - exact) <= CHORD * content.wall_area


def test_bores_and_holes_go_through():
    """The Euler number of a closed surface is 2 - 2 x tunnels: bore, six holes, and the set screw's."""
    curve = circle((0.0, 0.0), 60.0).curve()
    for name, tunnels in {"plain": 1, "keyway and holes": 7, "hub without screw": 7, "outer hub": 8}.items():
        mesh = cam_mesh(curve, BLANKS[name], THICKNESS, CHORD)
        body = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
        assert body.euler_number == 2 - 2 * tunnels, name


@pytest.mark.slow
def test_lift_and_volume_follow_the_chord_tolerance(carbon_free_car, through_file):
    curve = carbon_free_car.actual.curve
    exact = exact_volume(KEYED, curve.area())
    for chord in (0.05, 0.005, 0.0005):
        content = inspect(through_file(cam_mesh(curve, KEYED, THICKNESS, chord)), STEP)
        lift = lift_error(carbon_free_car, content)
        off = abs(content.volume - exact)
        print(f"\nchord {1e3 * chord:g} um: {1e3 * lift:.3f} um at lift, volume off by {off / exact:.1e}", end="")
        assert lift <= chord
        assert off <= chord * content.wall_area


@pytest.mark.slow
def test_rays_from_the_camshaft_meet_the_profile(carbon_free_car, through_file):
    """Where each ray at mid-thickness leaves the disc for good."""
    curve = carbon_free_car.actual.curve
    mesh = through_file(cam_mesh(curve, KEYED, THICKNESS, CHORD))
    body = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    section = trimesh.intersections.mesh_plane(body, [0.0, 0.0, 1.0], [0.0, 0.0, THICKNESS / 2])
    start, along = section[:, 0, :2], (section[:, 1] - section[:, 0])[:, :2]
    rays = np.stack([np.cos(CAM_ANGLES), np.sin(CAM_ANGLES)], axis=1)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = cross(start, along) / cross(rays, along)
        share = cross(start, rays) / cross(rays, along)
    met = (distance > 0) & (share >= -1e-9) & (share <= 1 + 1e-9)
    found = np.where(met, distance, 0.0).max(axis=1)
    error = np.abs(found - curve.radius(CAM_ANGLES)).max()
    print(f"\n3600 rays, mesh: {1e3 * error:.2f} um")
    assert error <= CHORD


def test_a_profile_with_corners(appendix_car, through_file):
    curve = appendix_car.actual.curve
    content = inspect(through_file(cam_mesh(curve, KEYED, 2.7, CHORD)), STEP)
    error = np.abs(np.linalg.norm(content.rim.points, axis=1) - curve.radius(content.rim.angle)).max()
    print(f"\nappendix car: {1e3 * error:.2f} um")
    assert content.watertight
    assert content.bodies == 1
    assert error <= CHORD


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(
    bore=st.floats(4, 12),
    count=st.integers(1, 8),
    hole=st.floats(1, 10),
    angle=st.floats(-pi, pi),
    chord=st.sampled_from([0.05, 0.005]),
    hub=st.sampled_from([None, HUB]),
)
def test_any_blank_that_fits_gives_a_closed_mesh(bore, count, hole, angle, chord, hub):
    blank = Blank(
        bore_diameter=bore,
        key=Keyway(width=0.3 * bore, depth=0.2 * bore, angle=angle),
        hub=hub and replace(hub, set_screw=replace(HUB.set_screw, diameter=0.4 * bore, angle=angle + pi)),
        lightening=Lightening(count=count, hole_diameter=hole, circle_diameter=45.0, start_angle=angle),
    )
    profile: ClosedCurve = circle((4.0, 4.0), 40.0).curve()
    content = inspect(cam_mesh(profile, blank, THICKNESS, chord), 0.5)
    assert content.watertight
    assert content.bodies == 1
    assert abs(content.volume - exact_volume(blank, pi * 40.0**2)) <= chord * content.wall_area


@pytest.mark.slow
def test_bytes_depend_on_the_part_alone(carbon_free_car):
    """Also in another process, with another order of hashing."""
    mesh = cam_mesh(circle((2.0, 0.0), 30.0).curve(), Blank(bore_diameter=8.0), THICKNESS, CHORD)
    expected = stl_bytes(mesh, "disc") + threemf_bytes(mesh, "disc", "test")
    cam_mesh(carbon_free_car.actual.curve, KEYED, THICKNESS, CHORD)
    assert stl_bytes(mesh, "disc") + threemf_bytes(mesh, "disc", "test") == expected
    program = """
import sys
from cadgen.parts.blank import Blank
from cadgen.curves.contour import circle
from cadgen.output.files.stl import stl_bytes
from cadgen.output.files.threemf import threemf_bytes
from cadgen.geometry.meshes.mesh import cam_mesh
mesh = cam_mesh(circle((2.0, 0.0), 30.0).curve(), Blank(bore_diameter=8.0), 3.0, 0.005)
sys.stdout.buffer.write(stl_bytes(mesh, "disc") + threemf_bytes(mesh, "disc", "test"))
"""
    environment = os.environ | {"PYTHONHASHSEED": "7", "PYTHONPATH": os.pathsep.join(sys.path)}
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True, env=environment)
    assert run.stdout == expected


def test_headers_name_part_and_unit():
    mesh = cam_mesh(circle((2.0, 0.0), 30.0).curve(), Blank(bore_diameter=8.0), THICKNESS, CHORD)
    assert stl_bytes(mesh, "disc")[:80].rstrip() == b"cadgen: disc; mm"
    assert len(stl_bytes(mesh, 200 * "x")) == len(stl_bytes(mesh, "disc"))


def washer() -> Mesh:
    return cam_mesh(circle((0.0, 0.0), 10.0).curve(), Blank(bore_diameter=8.0), THICKNESS, 0.1)


def test_faults_of_a_mesh_are_found(through_file):
    """One triangle missing, one turned over, and a second body: each must be noticed after the file, too."""
    vertices, triangles = washer()
    upright = np.flatnonzero(np.ptp(vertices[triangles][:, :, 2], axis=1) > 0)[0]
    turned = triangles.copy()
    turned[upright] = turned[upright][::-1]
    beside = vertices + np.array([50.0, 0.0, 0.0])
    two = Mesh(np.vstack([vertices, beside]), np.vstack([triangles, triangles + len(vertices)]))
    assert inspect(through_file(washer()), STEP).watertight
    assert not inspect(through_file(Mesh(vertices, np.delete(triangles, upright, axis=0))), STEP).watertight
    assert not inspect(through_file(Mesh(vertices, turned)), STEP).watertight
    assert inspect(through_file(two), STEP).bodies == 2


def test_a_mesh_without_its_inner_face_is_refused(through_file):
    vertices, triangles = washer()
    flat = (vertices[triangles][:, :, 2] == 0).all(axis=1)
    with pytest.raises(FileError, match="no face at z = 0"):
        inspect(through_file(Mesh(vertices, triangles[~flat])), STEP)


def test_stl_keeps_vertices_closer_than_a_micrometre(tmp_path):
    """The reason for a reader of our own: lib3mf's welds them."""
    mesh = cam_mesh(circle((0.0, 0.0), 0.01).curve(), Blank(bore_diameter=0.002), 0.001, 1e-6)
    path = tmp_path / "tiny.stl"
    path.write_bytes(stl_bytes(mesh, "tiny"))
    apart = np.linalg.norm(mesh.vertices[mesh.triangles[:, 0]] - mesh.vertices[mesh.triangles[:, 1]], axis=1)
    assert apart.min() < 1e-3
    assert len(read_stl(path).vertices) == len(mesh.vertices)
    assert inspect(read_stl(path), STEP).watertight


@pytest.mark.slow
def test_a_full_disk_is_one_clear_error_and_leaves_nothing(forks, tmp_path):
    """The system refuses files of more than 20 kB to another process; the kernel's file must not slip through."""
    program = f"""
import resource
from pathlib import Path
from cadgen.parts.blank import Blank
from cadgen.curves.contour import circle
from cadgen.errors import FileError
from cadgen.output.files.folder import publishing
from cadgen.output.files.stl import stl_bytes
from cadgen.output.files.threemf import threemf_bytes
from cadgen.geometry.meshes.mesh import cam_mesh
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.step import step_bytes
profile, blank = circle((2.0, 0.0), 30.0).curve(), Blank(bore_diameter=8.0)
mesh, part = cam_mesh(profile, blank, 3.0, 1e-5), cam_part(profile, blank, 3.0, name="disc", description="test")
files = {{"stl": stl_bytes(mesh, "disc"), "3mf": threemf_bytes(mesh, "disc", ""), "step": step_bytes(part)}}
resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))
for suffix, data in files.items():
    assert len(data) > 5000, len(data)
    try:
        with publishing(Path({str(tmp_path / "out")!r})) as staging:
            (staging / f"disc.{{suffix}}").write_bytes(data)
    except FileError as error:
        print(error)
"""
    run = forks.run(program, cwd=tmp_path)
    lines = run.stdout.splitlines()
    assert (run.returncode, len(lines)) == (0, 3), run.stderr
    assert all(line.startswith("nothing was written to ") and "larger than" in line for line in lines)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda data: data[:-1], "not a whole binary STL"),
        (lambda data: data[:84], "not a whole binary STL"),
        (lambda data: b"", "not a whole binary STL"),
        (lambda data: b"solid disc\nendsolid disc\n", "not a whole binary STL"),
    ],
)
def test_a_damaged_stl_is_one_clear_error(tmp_path, damage, message):
    path = tmp_path / "cam.stl"
    path.write_bytes(damage(stl_bytes(washer(), "disc")))
    with pytest.raises(FileError, match=message):
        read_stl(path)


def test_entries_of_a_3mf_have_a_date_that_exists(tmp_path):
    path = tmp_path / "cam.3mf"
    path.write_bytes(threemf_bytes(washer(), "cam", ""))
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        assert {entry.date_time for entry in package.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_a_damaged_3mf_is_one_clear_error(tmp_path):
    path = tmp_path / "cam.3mf"
    data = threemf_bytes(washer(), "disc", "test")
    for cut in (0, 100, len(data) // 2, len(data) - 1):
        path.write_bytes(data[:cut])
        with pytest.raises(FileError, match=r"cam\.3mf is not a whole 3MF"):
            read_3mf(path)
    path.write_bytes(data)
    model = zipfile.ZipFile(path).read("3D/3dmodel.model").decode()
    for old, new, message in (
        ('unit="millimeter"', 'unit="inch"', "1 bodies in inch, not a whole one in mill"),
        ("<object ", "<other ", "not a whole 3MF"),
        ("</resources>", '<object id="9"/></resources>', "2 bodies in millimeter"),
        ('x="', 'w="', "not a whole 3MF"),
        ('v1="0"', 'v1="99999"', "not a whole one"),
    ):
        with zipfile.ZipFile(path, "w") as package:
            package.writestr("3D/3dmodel.model", model.replace(old, new))
        with pytest.raises(FileError, match=message):
            read_3mf(path)


def test_a_missing_file_is_one_clear_error(tmp_path):
    for read in (read_stl, read_3mf):
        with pytest.raises(FileError, match="cannot read none: No such file"):
            read(tmp_path / "none")


def test_what_does_not_fit_is_refused(carbon_free_car):
    ring = Lightening(count=6, hole_diameter=18.0, circle_diameter=125.0)
    with pytest.raises(DesignError, match=r"lightening hole . and profile overlap"):
        cam_mesh(carbon_free_car.actual.curve, replace(KEYED, lightening=ring), THICKNESS, CHORD)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["keyway and holes", "inner hub"])
def test_broken_edges(carbon_free_car, through_file, name):
    """The chamfers' volume by Steiner's formula, and the outline at both edges of the land."""
    curve = carbon_free_car.actual.curve
    blank = replace(BLANKS[name], edge_break=0.2)
    mesh = through_file(cam_mesh(curve, blank, THICKNESS, CHORD))
    content = inspect(mesh, STEP, (0.2, THICKNESS - 0.2))
    assert content.watertight
    assert content.bodies == 1
    exact = exact_volume(blank, curve.area()) - 2 * chamfered_off(curve, 0.2)
    assert abs(content.volume - exact) < CHORD * content.wall_area
    off = np.linalg.norm(content.rim.points, axis=1) - curve.radius(content.rim.angle)
    assert np.abs(off).max() < CHORD
    # Chamfers elsewhere, none at all, or a land that leans.
    with pytest.raises(FileError, match=r"no face at z = 0\.3"):
        inspect(mesh, STEP, (0.3, THICKNESS - 0.3))
    leaning = mesh.vertices.copy()
    leaning[np.argmax((np.abs(leaning[:, 2] - 0.2) < 1e-5) & (leaning[:, 0] > 40)), 0] += 1e-3
    with pytest.raises(FileError, match="is not upright"):
        inspect(Mesh(leaning, mesh.triangles), STEP, (0.2, THICKNESS - 0.2))


@pytest.mark.parametrize(
    "corners",
    [
        [[-10, -10], [10, -10], [10, 2], [3, 2], [3, 10], [-10, 10]],
        [[-10, -10], [10, -10], [10, 9.8], [9.8, 10], [-10, 10]],
    ],
    ids=["hollow corner", "swallowed piece"],
)
def test_broken_edges_that_come_to_a_point(corners):
    curve = Contour(np.array(corners, dtype=float), np.zeros(len(corners))).curve()
    blank = Blank(bore_diameter=2.0, edge_break=0.5)
    content = inspect(cam_mesh(curve, blank, THICKNESS, 1e-4), STEP, (0.5, THICKNESS - 0.5))
    assert content.watertight
    assert content.volume == pytest.approx(
        blank.disc_volume(curve.area(), THICKNESS) - 2 * chamfered_off(curve, 0.5), rel=3e-6
    )
