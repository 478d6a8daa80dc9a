"""From a checked cam to files on disk, each read back and rolled against its follower before it is published."""

from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from cadgen.cam.checks import cam_angles
from cadgen.errors import CheckError
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan, Groove
from cadgen.jobs.cam.cures import Cures
from cadgen.laws.unit import TAN
from cadgen.messages import Message, joined
from cadgen.output.files.exports import CamExport, GrooveExport
from cadgen.output.files.formats import CAM, GROOVE
from cadgen.output.files.publisher import Artifact, Written, publish
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import SolidPart


def write_cam(
    plan: CamPlan,
    out: Path,
    cures: Cures,
    progress: Progress = silent,
    formats: str | Iterable[str] | None = None,
) -> Written:
    """Write, read back, judge and publish the files of a cam.

    Args:
        plan: computed cam, normally with all checks passed.
        out: folder for the files; it is made if need be. Nothing appears in it unless everything succeeded.
        cures: cures of lost lift, for the manifest.
        progress: function that is called with a few words on each step.
        formats: endings of the formats, some of those of `CAM`; all of them if left out.

    Raises:
        DesignError: a format is unknown.
        CheckError: none of the formats can be made of this cam.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    wanted = (CAM if plan.groove is None else GROOVE).chosen(formats)
    omitted: dict[str, str] = {}
    warnings: list[str] = []

    def files(folder: Path) -> Iterator[Artifact]:
        progress(Message("writing and reading back {formats}", formats=joined(each.label for each in wanted)))
        # The kernel gives the volume of a hub, which every format needs.
        apart = plan.blank.hub is None
        made = (
            [one for disc in plan.discs for one in CAM.made(cam_export(disc), folder, wanted, apart=apart)]
            if plan.groove is None
            else GROOVE.made(groove_export(plan, plan.groove), folder, wanted)
        )
        for each, result in made:
            if isinstance(result, CheckError):
                # Only a forced export comes here: the check that failed names the same cause.
                omitted[each.label] = result.message
                continue
            for file in result:
                warnings.extend(plan.application.of_loss(file.name, file.in_use, each.finer))
            yield from result
        if len(omitted) == len(wanted):
            raise CheckError("nothing can be written: {reasons}", reasons=joined(dict.fromkeys(omitted.values()), "; "))

    part, chosen = (CAM if plan.groove is None else GROOVE).entry(plan.stem, wanted)
    facts = cam_facts(plan, cures)
    return publish(
        part,
        out,
        files,
        facts | chosen | Facts(frame=plan.application.frame(plan)),
        lambda _: Facts(omitted=omitted, warnings=warnings),
    )


def cam_export(plan: CamPlan) -> CamExport:
    """Cam as the writers of all formats take it."""
    profile, making, use = plan.kind, plan.making, plan.application
    return CamExport(
        stem=plan.stem,
        description=f"{use.noun}, {profile} profile, design {plan.origin.content_hash[:12]}",
        curve=plan.curve,
        area=plan.area,
        follower=plan.follower,
        cam_angle=cam_angles(plan.motion),
        blank=plan.made_blank,
        thickness=plan.thickness,
        material=making.material,
        notes=(profile.note,) if profile.note else (),
        export=making.export,
        machining=making.machining,
        seen=plan.seen,
        motion=None if plan.motion.unit == TAN else plan.motion,
        forces=use.forces(plan),
        in_use=partial(use.of_file, plan),
    )


def groove_export(plan: CamPlan, groove: Groove) -> GrooveExport:
    """Cam with a groove as the writers of all formats take it.

    Args:
        plan: plan of the cam, whose curve is the inner flank.
        groove: its groove.
    """
    outer = groove.outer
    return GrooveExport(
        inner=cam_export(plan), outer=cam_export(outer), depth=groove.depth, outside_radius=groove.outside_radius
    )


def cam_solid(plan: CamPlan) -> "SolidPart":
    """Solid of the cam, as in its STEP file."""
    export = cam_export(plan)
    return export.part if plan.groove is None else groove_export(plan, plan.groove).part
