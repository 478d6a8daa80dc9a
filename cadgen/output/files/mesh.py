"""Meshes as STL and 3MF files.

Each file is written by a library and read again without it: STL is written by trimesh and 3MF by lib3mf, and
both are read here from their bytes. lib3mf could read STL, but welds vertices on a grid of 1 um and so would
hide a flaw; trimesh could read 3MF, but only with two more libraries installed.
"""

import io
import uuid
import zipfile
import zlib
from hashlib import sha256
from pathlib import Path
from xml.etree import ElementTree

import lib3mf
import numpy as np
import trimesh
from trimesh.exchange.stl import export_stl

from cadgen.errors import FileError
from cadgen.geometry.meshes.mesh import Mesh

_STL_HEADER = 80
_STL_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_MODEL = "3D/3dmodel.model"
_DATE = (1980, 1, 1, 0, 0, 0)  # the first that a ZIP file can have; equal parts give equal bytes
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def stl_bytes(mesh: Mesh, name: str) -> bytes:
    """Return a binary STL file; STL has no unit, so the header says mm."""
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
    """A 3MF package with valid dates: lib3mf leaves month and day at 0."""
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


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise FileError(f"cannot read {path.name}: {error.strerror}") from error
