"""From a checked cam to files on disk, each read back and rolled against the rod before it is published."""

from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cadgen.cam.checks import cam_angles
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact
from cadgen.car.running.sampled import rolled_lift
from cadgen.curves.closed import Outline
from cadgen.errors import CheckError
from cadgen.jobs.cam.cures import Cures, find_cures
from cadgen.jobs.cam.manifest import cam_facts
from cadgen.jobs.cam.plan import CamPlan
from cadgen.messages import Message
from cadgen.output.files.exports import CamExport
from cadgen.output.files.formats import CAM
from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import SolidPart

_FRAME = (
    "mm; z = 0 is the disc's inner face (the one nearer to the fork axis), +z points to the outer face; at cam "
    "angle theta the rod stands at polar angle theta, counterclockwise from +X seen from the outer face"
)


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
        formats: endings of the formats, some of those of `CAM`; all of them if left out.
        cures: cures of lost lift, if they were sought already.

    Raises:
        DesignError: a format is unknown.
        CheckError: none of the formats can be made of this cam.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    wanted, cam = CAM.chosen(formats), cam_export(plan)
    omitted: dict[str, str] = {}
    warnings: list[str] = []

    def files(folder: Path) -> Iterator[Artifact]:
        progress(f"writing and reading back {', '.join(each.label for each in wanted)}")
        # The kernel gives the volume of a hub, which every format needs.
        made = CAM.made(cam, folder, wanted, apart=cam.blank.hub is None)
        for each, result in made:
            if isinstance(result, CheckError):
                # Only a forced export comes here: the check that failed names the same cause.
                omitted[each.label] = str(result)
                continue
            warnings.extend(warning for file in result for warning in _loss(plan, file, each.finer))
            yield from result
        if len(omitted) == len(wanted):
            raise CheckError(f"nothing can be written: {'; '.join(dict.fromkeys(omitted.values()))}")

    part, chosen = CAM.entry(cam.stem, wanted)
    facts = cam_facts(plan, find_cures(plan, progress) if cures is None else cures)
    return publish(
        part,
        out,
        files,
        {**facts, **chosen, "frame": _FRAME},
        lambda _: {"omitted": omitted, "warnings": warnings},
    )


def cam_export(plan: CamPlan) -> CamExport:
    """Cam as the writers of all formats take it."""
    design, profile = plan.design, plan.profile
    inner, outer = design.cam.faces_mm
    cam_angle = cam_angles(plan.lift)
    return CamExport(
        stem=f"{design.name}_{profile}",
        description=f"steering cam, {profile} profile, design {design.content_hash[:12]}",
        curve=plan.curve,
        area=plan.area,
        follower=plan.follower,
        cam_angle=cam_angle,
        blank=plan.made_blank,
        thickness=outer - inner,
        material=design.blank.material,
        notes=(profile.note,) if profile.note else (),
        export=design.export,
        machining=design.machining,
        in_use=partial(_end_of_run, plan),
    )


def cam_solid(plan: CamPlan) -> "SolidPart":
    """Solid of the cam, as in its STEP file."""
    return cam_export(plan).part


def _end_of_run(plan: CamPlan, outline: Outline, contact: Contact, limit: float) -> Mapping[str, float]:
    """End of a run with play on an outline that was read back; nothing for a profile that is not for play."""
    comparison = plan.comparison
    if comparison is None:
        return {}
    as_built, cam_angle = comparison.task.as_built, cam_angles(plan.lift)
    if as_built.shapes_discs:
        rolled = roll(as_built.finished(outline), plan.follower, cam_angle)
    else:
        rolled = contact.at(np.searchsorted(contact.cam_angle, cam_angle))
    # Rises and falls within the error allowed to the file are no events of the path.
    least_swing = max(comparison.chosen.least_swing, limit * 1e-3 / comparison.task.follower.inner)
    lift = rolled_lift(rolled, plan.lift, blend_start=plan.lift.blend_start)
    heading, distance = comparison.end_of(lift, least_swing)
    return {"end_heading_deg": degrees(heading), "end_position_mm": distance}


def _loss(plan: CamPlan, file: Artifact, finer: str) -> Iterator[str]:
    """A warning if the file keeps its own tolerance, but loses the gain of the profile against play."""
    comparison, end = plan.comparison, file.facts.get("end_position_mm")
    if comparison is not None and end is not None and comparison.loses(end):
        yield Message(
            "{file} gives away what the profile does against play, for with it the run ends {end:.1f} mm off, and "
            "{exact:.1f} mm with the exact profile: {finer}",
            file=file.name,
            end=end,
            exact=comparison.chosen.error.end_distance,
            finer=finer,
        )
