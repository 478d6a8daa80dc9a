"""Files of a cam with a groove: solids, meshes, drawings and programs of the part; points and tables of each flank."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from cadgen.curves.biarc import arcs
from cadgen.curves.contour import Contour, circle
from cadgen.curves.spline import SplineArc, splines
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import SPLINE_TOLERANCE, read_curves, write_curves
from cadgen.output.files.groove_nc import read_groove, rounds_of, write_groove
from cadgen.output.files.nc import assumed_in
from cadgen.output.files.publisher import Artifact, require
from cadgen.output.files.step import whole_part
from cadgen.output.files.stl import as_printed, for_printing, read_stl, stl_bytes, whole_mesh
from cadgen.output.files.tables import cam_table
from cadgen.output.files.threemf import read_3mf, threemf_bytes
from cadgen.output.files.xyz import cam_xyz

if TYPE_CHECKING:
    from cadgen.geometry.meshes.mesh import Mesh
    from cadgen.output.files.exports import CamExport, GrooveExport

# Greatest error of the lift due to a file, µm.
_STEP_LIMIT_UM, _DXF_LIMIT_UM, _NC_LIMIT_UM = 0.5, 1.0, 1.0
OUTSIDE, INNER, OUTER = "OUTSIDE", "INNER_FLANK", "OUTER_FLANK"  # layers of drawings


def _flanks(cam: GrooveExport) -> tuple[CamExport, CamExport]:
    return replace(cam.inner, stem=f"{cam.stem}_inner"), replace(cam.outer, stem=f"{cam.stem}_outer")


def groove_xyz(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """Cloud of points on each flank."""
    for flank in _flanks(cam):
        yield from cam_xyz(flank, folder)


def groove_table(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """Table of each flank by the cam angle; on the outer one the lift counts inwards."""
    for flank in _flanks(cam):
        yield from cam_table(flank, folder)


def groove_step(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """STEP file of the part, which must be one valid solid with the exact volume, and upright flanks."""
    from cadgen.geometry.solids.step import read_part, step_bytes
    from cadgen.geometry.solids.step_text import read_flanks

    name = f"{cam.stem}.step"
    (folder / name).write_bytes(step_bytes(cam.part))
    facts = whole_part(name, read_part(folder / name), cam)
    heights = cam.thickness, cam.thickness - cam.depth
    flanks = [read_flanks(folder / name, cam.step, height) for height in heights]
    yield cam.judged(name, flanks, _STEP_LIMIT_UM, facts)


def groove_stl(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """STL file of the part."""
    name = f"{cam.stem}.stl"
    (folder / name).write_bytes(stl_bytes(for_printing(cam.mesh, cam.holes, cam.printing), cam.stem))
    yield _judged_mesh(cam, name, read_stl(folder / name))


def groove_3mf(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """3MF file of the part."""
    name = f"{cam.stem}.3mf"
    mesh = for_printing(cam.mesh, cam.holes, cam.printing)
    (folder / name).write_bytes(threemf_bytes(mesh, cam.stem, cam.description))
    again, title = read_3mf(folder / name)
    require(title == cam.stem, name, Message("has lost its name"))
    yield _judged_mesh(cam, name, again)


def _judged_mesh(cam: GrooveExport, name: str, again: Mesh) -> Artifact:
    from cadgen.geometry.meshes.content import flanks_of, measured

    count, again = len(again.triangles), as_printed(again, cam.holes, cam.printing)
    facts = whole_mesh(name, measured(again), cam, count)
    return cam.judged(name, [flanks_of(again, cam.thickness, cam.step)], cam.chord * 1e3, facts)


def groove_dxf(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """Outside and both flanks as arcs and as splines, with bore and holes, each on a layer of its own."""
    tolerance = cam.inner.export.arc_tolerance_um * 1e-3
    outside, curves = circle((0.0, 0.0), cam.outside_radius), (cam.inner.curve, cam.outer.curve)
    for suffix in ("arcs", "spline"):
        drawn: list[Contour | Sequence[SplineArc]] = [
            arcs(curve, tolerance) if suffix == "arcs" else splines(curve, SPLINE_TOLERANCE, 3) for curve in curves
        ]
        name = f"{cam.stem}_{suffix}.dxf"
        blank = cam.inner.blank
        layers: dict[str, list[Contour | Sequence[SplineArc]]] = {
            OUTSIDE: [outside],
            INNER: [drawn[0]],
            OUTER: [drawn[1]],
        }
        write_curves(folder / name, layers, blank.bore(), blank.holes())
        read = read_curves(folder / name, (INNER, OUTER), cam.step)
        yield cam.judged(name, [(read[INNER], read[OUTER])], _DXF_LIMIT_UM, Facts(arc_tolerance_um=tolerance * 1e3))


def groove_programs(cam: GrooveExport, folder: Path) -> Iterator[Artifact]:
    """Program that mills the groove."""
    inner, machining = cam.inner, cam.inner.machining
    tolerance = inner.export.arc_tolerance_um * 1e-3
    rounds = rounds_of(inner.curve, cam.width, machining.cutter_diameter_mm / 2, tolerance)
    name, material = f"{cam.stem}_groove.nc", inner.material
    write_groove(folder / name, rounds, cam.depth, machining, name=cam.stem, material=material, notes=inner.notes)
    flanks = read_groove(folder / name, machining, cam.depth, machining.feed(material), cam.step)
    facts = Facts(rounds=len(rounds), cutter_diameter_mm=machining.cutter_diameter_mm)
    facts |= assumed_in(machining.assumptions(material))
    yield cam.judged(name, [flanks], _NC_LIMIT_UM, facts)
