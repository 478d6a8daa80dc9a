"""STL files (binary, mm) of cams, gears and parts of trains.

They are written by trimesh, and read here from their bytes: lib3mf could read them, too, but welds vertices on a grid
of 1 µm and so would hide a flaw.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.gears.layout import TrainPart
from cadgen.geometry.meshes.mesh import Mesh
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, read_file, require
from cadgen.parts.print_compensation import PrintCompensation

if TYPE_CHECKING:
    from cadgen.geometry.meshes.content import MeshContent
    from cadgen.geometry.meshes.printing import HoleOutline
    from cadgen.output.files.exports import CamExport, GearExport, GrooveExport, RackExport, TrainExport

_HEADER = 80
_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def cam_stl(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """STL file of a cam, which must be one watertight body."""
    name = f"{cam.stem}.stl"
    (folder / name).write_bytes(stl_bytes(for_printing(cam.mesh, cam.holes, cam.printing), cam.stem))
    yield judged_mesh(cam, name, read_stl(folder / name))


def for_printing(mesh: Mesh, holes: Sequence[HoleOutline], printing: PrintCompensation | None) -> Mesh:
    """Mesh as a printer needs it; itself without a compensation.

    Args:
        mesh: mesh of a part.
        holes: its bores and holes.
        printing: what the printer does; None for nothing.
    """
    if printing is None:
        return mesh
    from cadgen.geometry.meshes.printing import compensated

    return compensated(mesh, holes, printing)


def as_printed(mesh: Mesh, holes: Sequence[HoleOutline], printing: PrintCompensation | None) -> Mesh:
    """Mesh of a part from that of a file for printing; itself without a compensation.

    Args:
        mesh: mesh as read.
        holes: bores and holes of the part.
        printing: what the printer does; None for nothing.
    """
    if printing is None:
        return mesh
    from cadgen.geometry.meshes.printing import restored

    return restored(mesh, holes, printing)


def print_facts(printing: PrintCompensation | None) -> Facts:
    """Compensation of a file for printing, for the manifest; nothing without one.

    Args:
        printing: what the printer does; None for nothing.
    """
    return Facts() if printing is None else Facts(print_compensation=printing.sizes)


def judged_mesh(cam: CamExport, name: str, again: Mesh) -> Artifact:
    """File of a cam's mesh, which must be one watertight body of the exact volume within chord times wall area.

    Args:
        cam: cam that was written.
        name: name of the file.
        again: mesh read back from it.

    Raises:
        FileError: it is something else, or moves the follower by more than the chords.
    """
    from cadgen.geometry.meshes.content import inspect

    content = inspect(as_printed(again, cam.holes, cam.printing), cam.step, cam.land)
    facts = whole_mesh(name, content, cam, len(again.triangles))
    return cam.judged(name, content.rim, cam.chord * 1e3, facts)


def whole_mesh(name: str, content: MeshContent, cam: CamExport | GrooveExport, triangles: int) -> Facts:
    """Facts on a mesh, which must be one watertight body of the exact volume within chord times wall area.

    Args:
        name: name of the file.
        content: measurements of the mesh that was read.
        cam: cam that was written.
        triangles: number of triangles that were read.

    Raises:
        FileError: it is something else.
    """
    require(content.watertight and content.bodies == 1, name, Message("is not one watertight body"))
    error = abs(content.volume - cam.volume)
    allowed = cam.chord * content.wall_area
    require(error <= allowed, name, Message("misses the exact volume by {error:.3g} mm3", error=error))
    return Facts(
        triangles=triangles,
        watertight=True,
        volume_mm3=content.volume,
        volume_error_relative=error / cam.volume,
    ) | print_facts(cam.printing)


def gear_stl(gear: GearExport, folder: Path) -> Iterator[Artifact]:
    """STL file of a gear."""
    yield _part_stl(gear.part, folder, gear.name, gear.chord, gear.printing)


def train_stl(train: TrainExport, folder: Path) -> Iterator[Artifact]:
    """STL file of each part of a train, in its own frame."""
    for part, chord in zip(train.layout.parts, train.chords, strict=True):
        yield _part_stl(part, folder, f"{train.stem}_{part.name}", chord, train.printing)


def rack_stl(rack: RackExport, folder: Path) -> Iterator[Artifact]:
    """STL file of a rack, which must be one watertight body of the exact volume within chord times wall area."""
    name, form = f"{rack.name}.stl", rack.form
    (folder / name).write_bytes(stl_bytes(for_printing(rack.mesh, (), rack.printing), rack.name))
    yield judged_body(name, read_stl(folder / name), form.area * form.width, rack)


class MeshedPart(NamedTuple):
    """Part by its mesh, for files of meshes.

    Attributes:
        mesh: exact part as a mesh.
        chord: greatest chord error, mm.
        holes: bores and holes of the part.
        printing: what files for printing take back; None for nothing.
        base: exact area of its lower face, mm².
    """

    mesh: Mesh
    chord: float
    holes: tuple[HoleOutline, ...]
    printing: PrintCompensation | None
    base: float

    @classmethod
    def of(cls, part: TrainPart, chord: float, printing: PrintCompensation | None) -> MeshedPart:
        """Part of a train, or a gear, meshed.

        Args:
            part: part of a train, or a gear.
            chord: greatest chord error, mm.
            printing: compensation of its files; None for none.
        """
        from cadgen.geometry.meshes.mesh import body_mesh
        from cadgen.geometry.meshes.printing import holes_of_body

        holes = holes_of_body(part.body, part.blank.bore_diameter, chord) if printing else ()
        return cls(body_mesh(part.body, chord), chord, holes, printing, part.body.slabs[0].area)


def _part_stl(part: TrainPart, folder: Path, stem: str, chord: float, printing: PrintCompensation | None) -> Artifact:
    name, meshed = f"{stem}.stl", MeshedPart.of(part, chord, printing)
    (folder / name).write_bytes(stl_bytes(for_printing(meshed.mesh, meshed.holes, printing), stem))
    return judged_body(name, read_stl(folder / name), part.volume, meshed)


def judged_body(name: str, again: Mesh, exact: float, part: MeshedPart | RackExport) -> Artifact:
    """Require of a mesh read back that it is closed, one body, and of the exact volume within chord times wall area.

    Args:
        name: name of the file.
        again: mesh read back from it.
        exact: exact volume, mm³.
        part: part that was written.

    Raises:
        FileError: it is something else.
    """
    count, chord = len(again.triangles), part.chord
    again = as_printed(again, part.holes, part.printing)
    solid = again.solid()
    require(len(solid.decompose()) == 1, name, Message("is not one body"))
    corners = again.vertices[again.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(across, axis=1) / 2
    walls = float(area[np.abs(across[:, 2]) < area].sum())
    error = abs(solid.volume() - exact)
    require(error <= chord * walls, name, Message("misses the exact volume by {error:.3g} mm³", error=error))
    facts = Facts(triangles=count, watertight=True, chord_um=chord * 1e3, volume_error_relative=error / exact)
    if part.printing:
        from cadgen.geometry.meshes.printing import lower_face

        base, length = lower_face(again)
        fault = Message("has a lower face {off:.3g} mm² off", off=abs(base - part.base))
        require(abs(base - part.base) <= chord * length, name, fault)
        facts |= print_facts(part.printing)
    return Artifact(name, facts, (Message("watertight, {count} triangles", count=count),))


def stl_bytes(mesh: Mesh, name: str) -> bytes:
    """Return a binary STL file; STL has no unit, so the header says mm."""
    import trimesh
    from trimesh.exchange.stl import export_stl

    data = export_stl(trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False))
    # Not "solid": readers take a file that begins so for text.
    header = f"cadgen: {name}; mm".encode("ascii", "replace")[:_HEADER].ljust(_HEADER)
    return bytes(header + data[_HEADER:])


def read_stl(path: Path) -> Mesh:
    """Read a binary STL file and join the vertices that are equal bit for bit.

    Raises:
        FileError: the file cannot be read or is cut off.
    """
    data = read_file(path)
    count = int.from_bytes(data[_HEADER : _HEADER + 4], "little")
    body = data[_HEADER + 4 :]
    if count == 0 or len(body) != count * _RECORD.itemsize:
        raise FileError("{file} is not a whole binary STL file: export it again", file=path.name)
    corners = np.frombuffer(body, _RECORD)["corners"].reshape(-1, 3)
    vertices, index = np.unique(corners, axis=0, return_inverse=True)
    return Mesh(vertices.astype(float), index.reshape(-1, 3))
