"""From a checked cam to files on disk, each read back and rolled against the rod before it is published."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.cam.cutter import largest_cutter
from cadgen.curves.biarc import arcs
from cadgen.curves.spline import splines
from cadgen.errors import CheckError, FileError
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.cam.job import Job, Result
from cadgen.jobs.cam.manifest import cam_facts
from cadgen.jobs.cam.plan import CamPlan
from cadgen.output.files.edges import edges_note
from cadgen.output.files.folder import publishing
from cadgen.output.files.formats import CAM_FORMATS, Format, chosen_formats, entry_formats, entry_name
from cadgen.output.files.manifest import Written, file_facts, versions, write_manifest
from cadgen.processes import beside
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import SolidPart

# Greatest error of the lift due to a file, um. STL and 3MF are held to their own chord tolerance.
STEP_LIMIT_UM = 0.5
POINTS_LIMIT_UM = 0.5
DXF_LIMIT_UM = 1.0
GCODE_LIMIT_UM = 1.0
# Relative error of the solid's volume against the profile's own area times thickness.
SOLID_VOLUME_LIMIT = 1e-6
# Greatest distance of the DXF's cubic splines from the profile, mm: a tenth of the error allowed to the lift.
_DXF_SPLINE_TOLERANCE = 1e-4


def write_cam(
    plan: CamPlan,
    out: Path,
    progress: Progress = silent,
    formats: str | Iterable[str] | None = None,
    *,
    cures: Cures | None = None,
) -> Written:
    """Write, read back, judge and publish the files of a cam.

    Args:
        plan: computed cam, normally with all checks passed.
        out: folder for the files; it is made if need be. Nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.
        cures: cures of lost lift, if they were sought already.
        formats: some of `CAM_FORMATS`; all of them if left out.

    Raises:
        DesignError: a format is unknown.
        CheckError: none of the formats can be made of this cam.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    wanted = chosen_formats(formats, CAM_FORMATS)
    with publishing(out) as staging:
        job = Job(plan, staging, wanted)
        files: dict[str, Any] = {}
        omitted: dict[str, str] = {}
        warnings: list[str] = []
        for writer, results in _made(job, progress).items():
            if isinstance(results, CheckError):
                # Only a forced export comes here: the check that failed names the same cause.
                omitted[writer.label] = str(results)
                continue
            for result in results:
                files[result.name] = _measured(job, result)
                warnings += _loss(job, result, writer.finer)
        if not files:
            raise CheckError(f"nothing can be written: {'; '.join(omitted.values())}")
        entry = {
            **cam_facts(plan, find_cures(plan, progress) if cures is None else cures),
            **entry_formats(wanted, CAM_FORMATS),
            "frame": _FRAME,
            "versions": versions(),
            "omitted": omitted,
            "warnings": warnings,
            "files": files,
        }
        part = entry_name(job.stem, wanted, CAM_FORMATS)
        write_manifest(staging, part, entry)
    return Written(part, entry)


def _made(job: Job, progress: Progress) -> dict["_Writer", "list[Result] | CheckError"]:
    """Results of each writer in turn; STEP is made beside the other formats.

    `cadgen cam carbon_free_car` takes 4.4 s so, and 5.7 s by one process: 1.3 times as long.
    """
    wanted = [writer for writer in _WRITERS if set(writer.formats) & set(job.formats)]
    progress(f"writing and reading back {', '.join(writer.label for writer in wanted)}")
    # The kernel gives the volume of a hub, which every format needs.
    apart = wanted[0] is _STEP and len(wanted) > 1 and job.plan.made_blank.hub is None
    if not apart:
        return {writer: _results(job, writer) for writer in wanted}
    with beside(partial(_results, job, _STEP)) as step:
        rest = {writer: _results(job, writer) for writer in wanted[1:]}
        return {_STEP: step(), **rest}


def _results(job: Job, writer: "_Writer") -> "list[Result] | CheckError":
    try:
        return list(writer.make(job))
    except CheckError as error:
        return error


def cam_solid(plan: CamPlan) -> "SolidPart":
    """Solid of the cam, as in its STEP file."""
    return Job(plan, Path(), CAM_FORMATS).part


_FRAME = (
    "mm; z = 0 is the disc's inner face (the one nearer to the fork axis), +z points to the outer face; at cam "
    "angle theta the rod stands at polar angle theta, counterclockwise from +X seen from the outer face"
)


def _measured(job: Job, result: Result) -> dict[str, Any]:
    if result.lift_error_um is None or result.lift_limit_um is None:
        return {**file_facts(job.staging / result.name), **result.facts}
    if not result.lift_error_um <= result.lift_limit_um:
        raise FileError(
            f"{result.name}, read back, moves the rod by {result.lift_error_um:.2f} µm, more than the "
            f"{result.lift_limit_um:g} µm allowed: use finer tolerances in the design's [export]"
        )
    return {
        **file_facts(job.staging / result.name),
        "lift_error_um": result.lift_error_um,
        "lift_limit_um": result.lift_limit_um,
        **result.facts,
    }


def _loss(job: Job, result: Result, refine: str) -> list[str]:
    """A warning if the file keeps its own tolerance, but loses the gain of the profile against play."""
    comparison, end = job.plan.comparison, result.facts.get("end_position_mm")
    if comparison is None or end is None or not comparison.loses(end):
        return []
    return [
        f"{result.name} gives away what the profile does against play, for with it the run ends {end:.1f} mm off, and "
        f"{comparison.chosen.error.end_distance:.1f} mm with the exact profile: {refine}"
    ]


def _step(job: Job) -> Iterator[Result]:
    from cadgen.geometry.solids.step import read_step, step_bytes

    name = f"{job.stem}.step"
    (job.staging / name).write_bytes(step_bytes(job.part))
    content = read_step(job.staging / name, job.step, job.land)
    if not content.valid or content.bodies != 1 or content.name != job.stem or content.description != job.description:
        raise FileError(f"{name}, read back, is not one valid solid with its name: report this design")
    error = abs(content.volume / job.volume - 1)
    if not error <= SOLID_VOLUME_LIMIT:
        raise FileError(f"{name}, read back, misses the exact volume by {error:.1e}: report this design")
    facts = {"volume_mm3": content.volume, "volume_error_relative": error}
    yield job.result(name, content.rim, STEP_LIMIT_UM, facts)


def _meshes(job: Job) -> Iterator[Result]:
    from cadgen.geometry.meshes.content import inspect
    from cadgen.geometry.meshes.mesh import Mesh, cam_mesh
    from cadgen.output.files.mesh import read_3mf, read_stl, stl_bytes, threemf_bytes

    chord = job.plan.design.export.cam_chord_um * 1e-3
    mesh = cam_mesh(job.plan.curve, job.plan.made_blank, job.thickness, chord, job.rim_share)

    def read(name: str, again: Mesh) -> Result:
        content = inspect(again, job.step, job.land)
        if not content.watertight or content.bodies != 1:
            raise FileError(f"{name}, read back, is not one watertight body: report this design")
        error = abs(content.volume - job.volume)
        if not error <= chord * content.wall_area:
            raise FileError(f"{name}, read back, misses the exact volume by {error:.3g} mm3: report this design")
        facts = {
            "triangles": len(again.triangles),
            "watertight": True,
            "volume_mm3": content.volume,
            "volume_error_relative": error / job.volume,
        }
        return job.result(name, content.rim, chord * 1e3, facts)

    if Format.STL in job.formats:
        name = f"{job.stem}.stl"
        (job.staging / name).write_bytes(stl_bytes(mesh, job.stem))
        yield read(name, read_stl(job.staging / name))
    if Format.THREE_MF not in job.formats:
        return
    name = f"{job.stem}.3mf"
    (job.staging / name).write_bytes(threemf_bytes(mesh, job.stem, job.description))
    again, title = read_3mf(job.staging / name)
    if title != job.stem:
        raise FileError(f"{name}, read back, has lost its name: report this design")
    yield read(name, again)


def _dxf(job: Job) -> Iterator[Result]:
    from cadgen.output.files.dxf import read_dxf, write_dxf

    plan = job.plan
    tolerance = plan.design.export.arc_tolerance_um * 1e-3
    chain = arcs(plan.curve, tolerance)
    cubic = splines(plan.curve, _DXF_SPLINE_TOLERANCE, 3)
    for suffix, profile, facts in (
        ("arcs", chain, {"arcs": len(chain.bulges), "arc_tolerance_um": tolerance * 1e3}),
        ("spline", cubic, {"splines": len(cubic)}),
    ):
        name = f"{job.stem}_{suffix}.dxf"
        note = edges_note(plan.made_blank.edge_break)
        write_dxf(job.staging / name, profile, plan.made_blank.bore(), plan.made_blank.holes(), note)
        drawing = read_dxf(job.staging / name, job.step)
        if drawing.note != note:
            raise FileError(f"{name}, read back, has lost its note on the edges: report this design")
        if len(drawing.bore) != 1 or len(drawing.holes) != len(plan.made_blank.holes()):
            raise FileError(f"{name}, read back, has lost the bore or a hole: report this design")
        yield job.result(name, drawing.profile, DXF_LIMIT_UM, facts)


def _programs(job: Job) -> Iterator[Result]:
    from cadgen.output.files.programs import Disc, programs

    plan, blank = job.plan, job.plan.made_blank
    disc = Disc(
        name=job.stem,
        curve=plan.curve,
        limit=largest_cutter(plan.curve),
        blank=blank,
        thickness=job.thickness,
        material=plan.design.blank.material,
        notes=[note for note in (plan.profile.note, edges_note(blank.edge_break)) if note],
    )
    tolerance = plan.design.export.arc_tolerance_um * 1e-3
    for program in programs(disc, plan.design.machining, job.staging, tolerance, job.step):
        if program.outline is None:
            yield Result(program.name, None, None, program.facts)
        else:
            yield job.result(program.name, program.outline, GCODE_LIMIT_UM, program.facts)


def _points(job: Job) -> Iterator[Result]:
    from cadgen.output.files.points import contact_outline, contact_rows, read_csv, read_xyz, write_csv, write_xyz

    plan = job.plan
    count = plan.design.export.point_count
    if Format.XYZ in job.formats:
        name = f"{job.stem}.xyz"
        write_xyz(job.staging / name, plan.curve, count)
        cloud = read_xyz(job.staging / name, job.step)
        yield job.result(name, cloud, POINTS_LIMIT_UM, {"points": count})
    if Format.CSV not in job.formats:
        return
    name = f"{job.stem}.csv"
    contact = contact_rows(plan.curve, plan.follower, count, job.rim_share * POINTS_LIMIT_UM * 1e-3)
    write_csv(job.staging / name, plan.curve, plan.follower, contact)
    table = read_csv(job.staging / name)
    result = job.result(name, contact_outline(table, job.step), POINTS_LIMIT_UM, {"rows": len(contact.lift)})
    column = float(np.abs(table["lift_mm"] - contact.lift).max() * 1e3)
    yield replace(result, lift_error_um=max(result.lift_error_um or 0.0, column))


@dataclass(frozen=True)
class _Writer:
    """Files of one or two formats that are made together.

    Attributes:
        label: name of the formats for people.
        formats: formats that it makes.
        make: function that writes the files, reads them back and yields what they hold.
        finer: change that makes them finer, in words.
    """

    label: str
    formats: tuple[Format, ...]
    make: Callable[[Job], Iterator[Result]]
    finer: str


_STEP = _Writer("STEP", (Format.STEP,), _step, "report this design")
_WRITERS = (
    _STEP,
    _Writer("STL and 3MF", (Format.STL, Format.THREE_MF), _meshes, "lower export.mesh_chord_um"),
    _Writer("DXF", (Format.DXF,), _dxf, "lower export.arc_tolerance_um"),
    _Writer("G-code", (Format.GCODE,), _programs, "lower export.arc_tolerance_um"),
    _Writer("points", (Format.XYZ, Format.CSV), _points, "raise export.point_count"),
)
