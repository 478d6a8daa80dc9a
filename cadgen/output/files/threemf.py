"""3MF files (mm) of cams, gears and parts of trains: written by lib3mf, and read here without it."""

from __future__ import annotations

import io
import uuid
import zipfile
import zlib
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import numpy as np

from cadgen.errors import FileError
from cadgen.gears.layout import TrainPart
from cadgen.geometry.meshes.mesh import Mesh
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, read_file, require
from cadgen.output.files.stl import MeshedPart, for_printing, judged_body, judged_mesh
from cadgen.parts.print_compensation import PrintCompensation

if TYPE_CHECKING:
    from cadgen.output.files.exports import CamExport, GearExport, RackExport, TrainExport

_MODEL = "3D/3dmodel.model"
_DATE = (1980, 1, 1, 0, 0, 0)  # the first that a ZIP file can have; equal parts give equal bytes
_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def cam_3mf(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """3MF file of a cam, which must be one watertight body with its name."""
    name = f"{cam.stem}.3mf"
    (folder / name).write_bytes(
        threemf_bytes(for_printing(cam.mesh, cam.holes, cam.printing), cam.stem, cam.description)
    )
    again, title = read_3mf(folder / name)
    require(title == cam.stem, name, Message("has lost its name"))
    yield judged_mesh(cam, name, again)


def gear_3mf(gear: GearExport, folder: Path) -> Iterator[Artifact]:
    """3MF file of a gear."""
    yield _part_3mf(gear.part, folder, (gear.name, gear.description), gear.chord, gear.printing)


def train_3mf(train: TrainExport, folder: Path) -> Iterator[Artifact]:
    """3MF file of each part of a train, in its own frame."""
    for part, chord in zip(train.layout.parts, train.chords, strict=True):
        named = (f"{train.stem}_{part.name}", train.description)
        yield _part_3mf(part, folder, named, chord, train.printing)


def rack_3mf(rack: RackExport, folder: Path) -> Iterator[Artifact]:
    """3MF file of a rack."""
    name, form = f"{rack.name}.3mf", rack.form
    mesh = for_printing(rack.mesh, (), rack.printing)
    (folder / name).write_bytes(threemf_bytes(mesh, rack.name, rack.description))
    again, title = read_3mf(folder / name)
    require(title == rack.name, name, Message("has lost its name"))
    yield judged_body(name, again, form.area * form.width, rack)


def _part_3mf(
    part: TrainPart, folder: Path, named: tuple[str, str], chord: float, printing: PrintCompensation | None
) -> Artifact:
    """3MF file of a part, which must be one closed body of the exact volume with its name."""
    (stem, description), meshed = named, MeshedPart.of(part, chord, printing)
    name = f"{stem}.3mf"
    mesh = for_printing(meshed.mesh, meshed.holes, printing)
    (folder / name).write_bytes(threemf_bytes(mesh, stem, description))
    again, title = read_3mf(folder / name)
    require(title == stem, name, Message("has lost its name"))
    return judged_body(name, again, part.volume, meshed)


def threemf_bytes(mesh: Mesh, name: str, description: str) -> bytes:
    """Return a 3MF file in mm; its identifiers come from the content, so equal parts give equal bytes."""
    import lib3mf

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
        with zipfile.ZipFile(io.BytesIO(read_file(path))) as package:
            model = ElementTree.fromstring(package.read(_MODEL))
        bodies = list(model.iter(f"{_CORE}object"))
        vertices = [[float(v.attrib[k]) for k in ("x", "y", "z")] for v in model.iter(f"{_CORE}vertex")]
        triangles = [[int(t.attrib[k]) for k in ("v1", "v2", "v3")] for t in model.iter(f"{_CORE}triangle")]
        mesh = Mesh(np.array(vertices), np.array(triangles))
        whole = mesh.triangles.min() >= 0 and mesh.triangles.max() < len(vertices)
    except (zipfile.BadZipFile, zlib.error, ElementTree.ParseError, KeyError, ValueError) as error:
        raise FileError("{file} is not a whole 3MF file: export it again", file=path.name) from error
    unit = model.get("unit")
    if not whole or unit != "millimeter" or len(bodies) != 1:
        raise FileError(
            "{file} holds {count} bodies in {unit}, not a whole one in millimeter",
            file=path.name,
            count=len(bodies),
            unit=unit,
        )
    return mesh, bodies[0].get("name", "")
