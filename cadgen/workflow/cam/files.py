"""From a checked cam to files on disk, each read back and rolled against the rod before it is published."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.checks import cam_angles
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.cutter import largest_cutter
from cadgen.cam.difference import Exact, dense_stations
from cadgen.cam.rolled import Contact
from cadgen.curves.biarc import arcs
from cadgen.curves.closed import Outline
from cadgen.curves.inset import chamfered_off
from cadgen.curves.spline import splines
from cadgen.errors import CheckError, FileError
from cadgen.export.folder import publishing
from cadgen.export.formats import CAM_FORMATS, chosen_formats, entry_formats, entry_name
from cadgen.export.manifest import Written, file_facts, versions, write_manifest
from cadgen.motion.sampled import rolled_lift
from cadgen.progress import Progress, silent
from cadgen.workflow.cam.cures import Cures, find_cures
from cadgen.workflow.cam.manifest import cam_facts
from cadgen.workflow.cam.plan import CamPlan

if TYPE_CHECKING:
    from cadgen.solids.kernel import Part

# Greatest error of the lift due to a file, um. STL and 3MF are held to their own chord tolerance.
STEP_LIMIT_UM = 0.5
POINTS_LIMIT_UM = 0.5
DXF_LIMIT_UM = 1.0
GCODE_LIMIT_UM = 1.0
# Relative error of the solid's volume against the profile's own area times thickness.
SOLID_VOLUME_LIMIT = 1e-6
# Greatest distance of the DXF's cubic splines from the profile, mm: a tenth of the error allowed to the lift.
_DXF_SPLINE_TOLERANCE = 1e-4
# Share of the chord tolerance that the rim's chords may take at a pressure angle of 0; and at least, at 87 degrees.
_RIM_SHARE = 0.8
_LEAST_RIM_SHARE = 0.04


@dataclass(frozen=True)
class _Result:
    """A file that was written and read back; one without an outline has no error at the lift."""

    name: str
    lift_error_um: float | None
    lift_limit_um: float | None
    facts: dict[str, Any]


@dataclass(frozen=True)
class _Job:
    """Plan, folder and formats that the writers share, with what they compute once."""

    plan: CamPlan
    staging: Path
    formats: tuple[str, ...]

    @property
    def stem(self) -> str:
        return f"{self.plan.design.name}_{self.plan.profile}"

    @property
    def description(self) -> str:
        return f"steering cam, {self.plan.profile} profile, design {self.plan.design.content_hash[:12]}"

    @property
    def thickness(self) -> float:
        inner, outer = self.plan.design.cam.faces_mm
        return outer - inner

    @property
    def land(self) -> tuple[float, float] | None:
        """Heights of the edges of the land above the inner face, where the rod rides, mm; None with sharp edges."""
        return self.plan.made_blank.carrying(0.0, self.thickness) if self.plan.made_blank.edge_break else None

    @cached_property
    def cam_angle(self) -> Array:
        return cam_angles(self.plan.lift)

    @cached_property
    def rolled(self) -> tuple[Contact, float]:
        """Contact of the follower on the exact curve, and the step of the outline for it, mm."""
        return roll_curve(self.plan.curve, self.plan.follower, self.cam_angle)

    @property
    def step(self) -> float:
        """Distance of the points on an outline that is read back, mm."""
        return self.rolled[1]

    @cached_property
    def exact(self) -> Exact:
        """Exact curve for comparison with a file's lift, in points as close together as on an outline read back."""
        follower = self.plan.follower
        return Exact(self.plan.curve.outline(self.step), follower, dense_stations(follower, self.rolled[0]))

    @cached_property
    def rim_share(self) -> float:
        """Share of the error allowed to the lift that a chord of the rim may take along its normal.

        A chord that is off by e shifts the lift by e / cos(pressure angle).
        """
        steepest = float(np.cos(self.rolled[0].pressure_angle).min())
        return max(_RIM_SHARE * steepest, _LEAST_RIM_SHARE)

    @cached_property
    def part(self) -> "Part":
        """The solid, for STEP, and for its volume."""
        from cadgen.solids.cam import cam_part

        plan = self.plan
        return cam_part(plan.curve, plan.made_blank, self.thickness, name=self.stem, description=self.description)

    @cached_property
    def volume(self) -> float:
        """Volume for comparison with every file's, mm^3: by the profile, or with a hub that of the exact solid."""
        from cadgen.solids.kernel import volume

        if self.plan.made_blank.hub is None:
            whole = self.plan.made_blank.disc_volume(self.plan.area, self.thickness)
            return whole - 2 * chamfered_off(self.plan.curve, self.plan.made_blank.edge_break)
        return volume(self.part.solid)

    def result(self, name: str, outline: Outline, lift_limit_um: float, facts: dict[str, Any]) -> _Result:
        """Roll the rod on an outline that was read back: error of the lift, and end of a run with play.

        Only lifts rolled in equal steps are compared, for the error of rolling is then nearly the same in both.
        """
        difference, contact = self.exact.compare(outline)
        end = self._end_of_run(outline, contact, lift_limit_um)
        return _Result(name, difference * 1e3, lift_limit_um, {**facts, **end})

    def _end_of_run(self, outline: Outline, contact: Contact, lift_limit_um: float) -> dict[str, float]:
        comparison = self.plan.comparison
        if comparison is None:
            return {}
        as_built = comparison.task.as_built
        if as_built.shapes_discs:
            rolled = roll(as_built.finished(outline), self.plan.follower, self.cam_angle)
        else:
            rolled = contact.at(np.searchsorted(contact.cam_angle, self.cam_angle))
        # Rises and falls within the error allowed to the file are no events of the path.
        least_swing = max(comparison.chosen.least_swing, lift_limit_um * 1e-3 / comparison.task.follower.inner)
        lift = rolled_lift(rolled, self.plan.lift, blend_start=self.plan.lift.blend_start)
        heading, distance = comparison.end_of(lift, least_swing)
        return {"end_heading_deg": degrees(heading), "end_position_mm": distance}


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
        job = _Job(plan, staging, wanted)
        files: dict[str, Any] = {}
        omitted: dict[str, str] = {}
        warnings: list[str] = []
        for label, make in _FORMATS.items():
            if not any(_LABELS[ending] == label for ending in wanted):
                continue
            progress(f"writing and reading back {label}")
            try:
                results = list(make(job))
            except CheckError as error:
                # Only a forced export comes here: the check that failed names the same cause.
                omitted[label] = str(error)
                continue
            for result in results:
                files[result.name] = _measured(job, result)
                warnings += _loss(job, result, _REFINE[label])
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


def cam_solid(plan: CamPlan) -> "Part":
    """Solid of the cam, as in its STEP file."""
    return _Job(plan, Path(), CAM_FORMATS).part


_FRAME = (
    "mm; z = 0 is the disc's inner face (the one nearer to the fork axis), +z points to the outer face; at cam "
    "angle theta the rod stands at polar angle theta, counterclockwise from +X seen from the outer face"
)


def edges_note(edge_break: float) -> str:
    """Note for the shop on the edges, broken by `edge_break` mm, for files of the outline alone; empty where sharp."""
    if edge_break == 0:
        return ""
    return f"afterwards break both edges of the outline by {edge_break:g} mm at 45 degrees: the rod rides between them"


def _measured(job: _Job, result: _Result) -> dict[str, Any]:
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


def _loss(job: _Job, result: _Result, refine: str) -> list[str]:
    """A warning if the file keeps its own tolerance, but loses the gain of the profile against play."""
    comparison, end = job.plan.comparison, result.facts.get("end_position_mm")
    if comparison is None or end is None or not comparison.loses(end):
        return []
    return [
        f"{result.name} gives away what the profile does against play, for with it the run ends {end:.1f} mm off, and "
        f"{comparison.chosen.error.end_distance:.1f} mm with the exact profile: {refine}"
    ]


def _step(job: _Job) -> Iterator[_Result]:
    from cadgen.solids.step import read_step, step_bytes

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


def _meshes(job: _Job) -> Iterator[_Result]:
    from cadgen.export.mesh import read_3mf, read_stl, stl_bytes, threemf_bytes
    from cadgen.meshes.content import inspect
    from cadgen.meshes.disc import cam_mesh
    from cadgen.meshes.mesh import Mesh

    chord = job.plan.design.export.cam_chord_um * 1e-3
    mesh = cam_mesh(job.plan.curve, job.plan.made_blank, job.thickness, chord, job.rim_share)

    def read(name: str, again: Mesh) -> _Result:
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

    if "stl" in job.formats:
        name = f"{job.stem}.stl"
        (job.staging / name).write_bytes(stl_bytes(mesh, job.stem))
        yield read(name, read_stl(job.staging / name))
    if "3mf" not in job.formats:
        return
    name = f"{job.stem}.3mf"
    (job.staging / name).write_bytes(threemf_bytes(mesh, job.stem, job.description))
    again, title = read_3mf(job.staging / name)
    if title != job.stem:
        raise FileError(f"{name}, read back, has lost its name: report this design")
    yield read(name, again)


def _dxf(job: _Job) -> Iterator[_Result]:
    from cadgen.export.dxf import read_dxf, write_dxf

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


def _programs(job: _Job) -> Iterator[_Result]:
    from cadgen.export.programs import Disc, programs

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
            yield _Result(program.name, None, None, program.facts)
        else:
            yield job.result(program.name, program.outline, GCODE_LIMIT_UM, program.facts)


def _points(job: _Job) -> Iterator[_Result]:
    from cadgen.export.points import contact_outline, contact_rows, read_csv, read_xyz, write_csv, write_xyz

    plan = job.plan
    count = plan.design.export.point_count
    if "xyz" in job.formats:
        name = f"{job.stem}.xyz"
        write_xyz(job.staging / name, plan.curve, count)
        cloud = read_xyz(job.staging / name, job.step)
        yield job.result(name, cloud, POINTS_LIMIT_UM, {"points": count})
    if "csv" not in job.formats:
        return
    name = f"{job.stem}.csv"
    contact = contact_rows(plan.curve, plan.follower, count, job.rim_share * POINTS_LIMIT_UM * 1e-3)
    write_csv(job.staging / name, plan.curve, plan.follower, contact)
    table = read_csv(job.staging / name)
    result = job.result(name, contact_outline(table, job.step), POINTS_LIMIT_UM, {"rows": len(contact.lift)})
    column = float(np.abs(table["lift_mm"] - contact.lift).max() * 1e3)
    yield replace(result, lift_error_um=max(result.lift_error_um or 0.0, column))


_FORMATS: dict[str, Callable[[_Job], Iterator[_Result]]] = {
    "STEP": _step,
    "STL and 3MF": _meshes,
    "DXF": _dxf,
    "G-code": _programs,
    "points": _points,
}
# The endings of the files -> what makes them.
_LABELS = {
    "step": "STEP",
    "stl": "STL and 3MF",
    "3mf": "STL and 3MF",
    "dxf": "DXF",
    "nc": "G-code",
    "xyz": "points",
    "csv": "points",
}
# What makes the files of a format finer.
_REFINE = {
    "STEP": "report this design",
    "STL and 3MF": "lower export.mesh_chord_um",
    "DXF": "lower export.arc_tolerance_um",
    "G-code": "lower export.arc_tolerance_um",
    "points": "raise export.point_count",
}
