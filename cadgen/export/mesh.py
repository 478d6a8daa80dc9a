"""The cam as a closed mesh, made of polygons by manifold3d and not by the CAD kernel; its STL and 3MF files.

Each file is written by a library and read again without it: STL is written by trimesh and 3MF by lib3mf, and
both are read here from their bytes. lib3mf could read STL, but welds vertices on a grid of 1 um and so would
hide a flaw; trimesh could read 3MF, but only with two more libraries installed.
"""

import io
import uuid
import zipfile
import zlib
from dataclasses import dataclass
from hashlib import sha256
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import lib3mf
import numpy as np
import trimesh
from manifold3d import CrossSection, Error, FillRule, Manifold, Mesh64, triangulate
from numpy.typing import NDArray
from trimesh.exchange.stl import export_stl

from cadgen.arrays import Array
from cadgen.cam.blank import CamBlank, Hub
from cadgen.curves.closed import ClosedCurve, Outline, cross
from cadgen.curves.contour import Contour, circle
from cadgen.curves.inset import chamfer_strips
from cadgen.curves.polygon import polygon, polyline, strip_polygons
from cadgen.errors import FileError

Triangles = NDArray[np.int64]

_OVERSHOOT = 1.0  # mm by which a cutting tool sticks out of what it cuts
_STEP = 0.1  # mm between the profile's points when the walls are measured

_UPRIGHT = 0.9  # a face whose normal's z is more is horizontal; chamfers have 0.707
_LEVEL = 1e-5  # mm; what the single precision of a file leaves of a height

_STL_HEADER = 80
_STL_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_MODEL = "3D/3dmodel.model"
_DATE = (1980, 1, 1, 0, 0, 0)  # the first that a ZIP file can have; equal parts give equal bytes
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


class Mesh(NamedTuple):
    """Vertices, shape (n, 3), mm, and triangles, shape (m, 3), counterclockwise seen from outside."""

    vertices: Array
    triangles: Triangles


@dataclass(frozen=True, kw_only=True, slots=True)
class MeshContent:
    """What a mesh is, measured.

    Attributes:
        rim: outline of the disc at its carrying planes, each chord one piece: at z = 0, or where the edges are broken
            at either edge of the land between the chamfers, which are found to be alike.
        watertight: whether trimesh and manifold3d both find it closed, oriented and free of faults.
        bodies: number of connected parts.
        volume: mm^3.
        wall_area: of all faces that are not horizontal, mm^2; the volume misses the true one by no more than
            the chord tolerance times this.
    """

    rim: Outline
    watertight: bool
    bodies: int
    volume: float
    wall_area: float


def cam_mesh(
    profile: ClosedCurve, blank: CamBlank, thickness: float, chord_tolerance: float, rim_share: float = 0.5
) -> Mesh:
    """Return the disc with its bore, holes and hub; z = 0 is the inner face, z = thickness the outer one.

    Args:
        profile: of the rim, mm.
        blank: what else the disc has.
        thickness: of the disc, mm.
        chord_tolerance: what bore, holes and hub may stray from the true shape, mm.
        rim_share: of that, what the rim may stray along its normal; the lift strays by as much over the cosine of
            the pressure angle.

    Raises:
        DesignError: a hole cuts into another one, into the hub or through the profile.
        CheckError: the chamfers of broken edges meet, or run out at a ridge.
    """
    blank.require_walls(profile.outline(_STEP))
    holes = [contour.polygon(chord_tolerance) for contour in blank.holes()]
    bore, rim_chord = blank.bore(), rim_share * chord_tolerance
    if blank.hub is None:
        solid = _disc(profile, [bore.polygon(chord_tolerance), *holes], thickness, blank.edge_break, rim_chord)
    else:
        disc = _disc(profile, holes, thickness, blank.edge_break, rim_chord)
        solid = _with_hub(disc, blank.hub, bore, thickness, chord_tolerance)
    mesh = solid.to_mesh64()
    return Mesh(np.asarray(mesh.vert_properties), np.asarray(mesh.tri_verts).astype(np.int64))


def inspect(mesh: Mesh, step: float, land: tuple[float, float] | None = None) -> MeshContent:
    """Measure a mesh, as read from a file.

    Args:
        mesh: with vertices joined.
        step: largest distance of two points of the rim, mm.
        land: heights of the edges of the land between broken edges, mm; None for a rim with sharp edges.

    Raises:
        FileError: the mesh has no closed outline at z = 0, or not the same one at both edges of its land.
    """
    body = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
    # Copies: manifold3d takes no array that is read-only or out of order.
    solid = Manifold(Mesh64(np.array(mesh.vertices, order="C"), mesh.triangles.astype(np.uint64, order="C")))
    closed = body.is_watertight and body.is_winding_consistent and solid.status() == Error.NoError
    upright = np.abs(body.face_normals[:, 2]) < _UPRIGHT
    return MeshContent(
        rim=polyline(_rim(mesh) if land is None else _land(mesh, land), step),
        watertight=bool(closed),
        bodies=int(body.body_count),
        volume=float(body.volume),
        wall_area=float(body.area_faces[upright].sum()),
    )


def stl_bytes(mesh: Mesh, name: str) -> bytes:
    """Return a binary STL file; STL knows no unit, so the header says that it is mm."""
    data = export_stl(trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False))
    # Not "solid": readers take a file that begins so for text.
    header = f"cadgen: {name}; mm".encode("ascii", "replace")[:_STL_HEADER].ljust(_STL_HEADER)
    return bytes(header + data[_STL_HEADER:])


def read_stl(path: Path) -> Mesh:
    """Read a binary STL file and join the vertices that are equal bit for bit.

    Raises:
        FileError: the file cannot be read or is cut off.
    """
    data = _read(path)
    count = int.from_bytes(data[_STL_HEADER : _STL_HEADER + 4], "little")
    body = data[_STL_HEADER + 4 :]
    if count == 0 or len(body) != count * _STL_RECORD.itemsize:
        raise FileError(f"{path.name} is not a whole binary STL file: export it again")
    corners = np.frombuffer(body, _STL_RECORD)["corners"].reshape(-1, 3)
    vertices, index = np.unique(corners, axis=0, return_inverse=True)
    return Mesh(vertices.astype(float), index.reshape(-1, 3))


def threemf_bytes(mesh: Mesh, name: str, description: str) -> bytes:
    """Return a 3MF file in mm; its identifiers come from the content, so equal parts give equal bytes."""
    vertices, triangles = mesh.vertices.astype(np.float32), mesh.triangles.astype(np.uint32)
    content = sha256(vertices.tobytes() + triangles.tobytes() + f"{name}\0{description}".encode()).hexdigest()
    wrapper = lib3mf.get_wrapper()
    model = wrapper.CreateModel()
    model.SetUnit(lib3mf.ModelUnit.MilliMeter)
    for key, value in (("Title", name), ("Description", description), ("Application", "cadgen")):
        model.GetMetaDataGroup().AddMetaData("", key, value, "xs:string", True)
    body = model.AddMeshObject()
    body.SetName(name)
    body.SetGeometry(
        (lib3mf.Position * len(vertices)).from_buffer_copy(vertices),
        (lib3mf.Triangle * len(triangles)).from_buffer_copy(triangles),
    )
    item = model.AddBuildItem(body, wrapper.GetIdentityTransform())
    for role, identify in (("body", body.SetUUID), ("item", item.SetUUID), ("build", model.SetBuildUUID)):
        identify(str(uuid.uuid5(uuid.NAMESPACE_OID, f"cadgen {role} {content}")))
    return _dated(bytes(model.QueryWriter("3mf").WriteToBuffer()))


def _dated(package: bytes) -> bytes:
    """The same package with a date that exists: lib3mf leaves month and day at 0."""
    file = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(package)) as old, zipfile.ZipFile(file, "w") as new:
        for entry in old.infolist():
            dated = zipfile.ZipInfo(entry.filename, _DATE)
            dated.compress_type = entry.compress_type
            dated.create_system = entry.create_system
            new.writestr(dated, old.read(entry))
    return file.getvalue()


def read_3mf(path: Path) -> tuple[Mesh, str]:
    """Read the only body of a 3MF file, and its name.

    Raises:
        FileError: the file cannot be read, is not in millimetres or does not hold exactly one body.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(_read(path))) as package:
            model = ElementTree.fromstring(package.read(_MODEL))
        bodies = list(model.iter(f"{_CORE}object"))
        vertices = [[float(v.attrib[k]) for k in ("x", "y", "z")] for v in model.iter(f"{_CORE}vertex")]
        triangles = [[int(t.attrib[k]) for k in ("v1", "v2", "v3")] for t in model.iter(f"{_CORE}triangle")]
        mesh = Mesh(np.array(vertices), np.array(triangles))
        whole = mesh.triangles.min() >= 0 and mesh.triangles.max() < len(vertices)
    except (zipfile.BadZipFile, zlib.error, ElementTree.ParseError, KeyError, ValueError) as error:
        raise FileError(f"{path.name} is not a whole 3MF file: export it again") from error
    unit = model.get("unit")
    if not whole or unit != "millimeter" or len(bodies) != 1:
        raise FileError(f"{path.name} holds {len(bodies)} bodies in {unit}, not a whole one in millimeter")
    return mesh, bodies[0].get("name", "")


def _prism(polygons: list[Array], bottom: float, height: float) -> Manifold:
    section = CrossSection(polygons, FillRule.EvenOdd)
    return Manifold.extrude(section, height).translate((0.0, 0.0, bottom))


def _disc(profile: ClosedCurve, holes: list[Array], thickness: float, edge_break: float, chord: float) -> Manifold:
    """The disc with holes, the edges of its rim broken."""
    if edge_break == 0:
        return _prism([polygon(profile, chord), *holes], 0.0, thickness)
    outer, inner = strip_polygons(chamfer_strips(profile, edge_break), chord)
    rings, vertices = [], np.empty((0, 3))
    heights = 0.0, edge_break, thickness - edge_break, thickness
    for points, z in zip((inner, outer, outer, inner), heights, strict=True):
        # Where a side of the chamfer is a point it stands there once.
        new = np.any(points != np.roll(points, 1, axis=0), axis=1)
        rings.append(len(vertices) + (np.cumsum(new) - 1) % new.sum())
        vertices = np.vstack([vertices, np.column_stack([points[new], np.full(new.sum(), z)])])
    triangles = [
        np.concatenate([np.stack(corners, axis=1) for corners in ((a, a1, b1), (a, b1, b))])
        for a, b in pairwise(rings)
        for a1, b1 in [(np.roll(a, -1), np.roll(b, -1))]
    ]
    cap = triangulate([vertices[np.unique(rings[0]), :2]])
    triangles += [cap[:, ::-1] + rings[0].min(), cap + rings[-1].min()]
    faces = np.concatenate(triangles)
    whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    solid = Manifold(Mesh64(vertices, faces[whole].astype(np.uint64)))
    if solid.status() != Error.NoError:
        raise FileError("the mesh of the disc with broken edges does not close: report this design")
    if holes:
        solid -= _prism(holes, -_OVERSHOOT, thickness + 2 * _OVERSHOOT)
    return solid


def _with_hub(disc: Manifold, hub: Hub, bore: Contour, thickness: float, chord_tolerance: float) -> Manifold:
    """Set the hub on a disc without bore, then cut bore and set screw through both."""
    # From the disc's middle on, so that the two bodies do not merely touch.
    low, high = sorted((thickness / 2, hub.level(hub.length, thickness)))
    boss = _prism([circle((0.0, 0.0), hub.diameter / 2).polygon(chord_tolerance)], low, high - low)
    bottom, top = min(low, 0.0) - _OVERSHOOT, max(high, thickness) + _OVERSHOOT
    solid = disc + boss - _prism([bore.polygon(chord_tolerance)], bottom, top - bottom)
    if screw := hub.set_screw:
        section = circle((0.0, 0.0), screw.diameter / 2).polygon(chord_tolerance)
        drill = _prism([section], 0.0, hub.diameter / 2 + _OVERSHOOT)
        c, s, z = np.cos(screw.angle), np.sin(screw.angle), hub.level(screw.height, thickness)
        # Lays the drill's axis, which is z, along the ray of the screw.
        solid -= drill.transform(np.array([[0.0, -s, c, 0.0], [0.0, c, s, 0.0], [-1.0, 0.0, 0.0, z]]))
    return solid


def _rim(mesh: Mesh) -> Array:
    """Corners of the outer boundary of the faces at z = 0, counterclockwise, shape (n, 2), mm."""
    flat = (mesh.vertices[mesh.triangles][:, :, 2] == 0).all(axis=1)
    edges = mesh.triangles[flat][:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    count = len(mesh.vertices)
    inner = np.isin(edges @ [count, 1], edges @ [1, count])
    return _loop(mesh, edges[~inner], 0.0)


def _land(mesh: Mesh, heights: tuple[float, float]) -> Array:
    """Corners of the outline at both edges of the land, as `_rim`.

    Raises:
        FileError: there is none at one of them, or the two are not alike.
    """
    loops = []
    for height, other in zip(heights, heights[::-1], strict=True):
        z = mesh.vertices[mesh.triangles][:, :, 2]
        at = np.abs(z - height) < _LEVEL
        # The walls of the land have two corners at one of its edges and the third at the other.
        wall = (at.sum(axis=1) == 2) & (np.abs(z - other) < _LEVEL).any(axis=1)
        apex = np.argmin(at[wall], axis=1)
        ends = np.stack([(apex + 1) % 3, (apex + 2) % 3], axis=1)
        loops.append(_loop(mesh, np.take_along_axis(mesh.triangles[wall], ends, axis=1), height))
    low, high = loops
    if low.shape != high.shape or not np.array_equal(low[np.lexsort(low.T)], high[np.lexsort(high.T)]):
        raise FileError("the land between the broken edges of the mesh is not upright: export it again")
    return low


def _loop(mesh: Mesh, edges: Triangles, height: float) -> Array:
    """Corners of the loop of directed edges that holds the point farthest from the axis, counterclockwise."""
    after = dict(edges.tolist())
    if not after:
        raise FileError(f"the mesh has no face at z = {height:g}: export it again")
    boundary = np.array(list(after))
    first = int(boundary[np.argmax(np.linalg.norm(mesh.vertices[boundary], axis=1))])
    loop = [first]
    while (following := after.pop(loop[-1], None)) not in (first, None):
        loop.append(following)
    if following is None:
        raise FileError(f"the outline of the mesh at z = {height:g} is open: export it again")
    corners = mesh.vertices[loop][:, :2]
    if np.sum(cross(corners, np.roll(corners, -1, axis=0))) < 0:
        corners = corners[::-1]
    return corners


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise FileError(f"cannot read {path.name}: {error.strerror}") from error
