"""Sheet of a computed cam, and the sheet on which its lift is written down."""

from collections.abc import Iterator

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.course.layout import Side
from cadgen.curves.biarc import arcs
from cadgen.inference.measurement.record import Direction
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.drawing.title import Folder, bore_class, title_of
from cadgen.output.drawing.cam import EVERY, CamPart, cam_drawing
from cadgen.output.drawing.sheet import Drawing

_ENDINGS = ("_spline.dxf", "_arcs.dxf", ".step", ".nc")
_ARCS_WITHIN = 1e-3  # mm, of the outline on the sheet
_DENSE = 7200  # angles at which the greatest and least radius are sought
_RUNS = 3  # of the inspection, which tells noise from what repeats
_STEP = 5  # degrees between its readings


def stem_of(plan: CamPlan) -> str:
    """Stem of the names of the cam's files."""
    return f"{plan.design.name}_{plan.profile}"


def sheet_of(plan: CamPlan, folder: Folder) -> Drawing:
    """Sheet of a cam; it names the files of the folder that hold the same cam."""
    design, stem = plan.design, stem_of(plan)
    angles = np.radians(np.arange(0.0, 360.0, EVERY))
    dense = np.linspace(0.0, TURN, _DENSE, endpoint=False)
    radii = plan.curve.radius(dense)
    most, least = int(radii.argmax()), int(radii.argmin())
    inner, outer = design.cam.faces_mm
    offset = design.tolerances.profile_offset_mm
    part = CamPart(
        profile=arcs(plan.curve, _ARCS_WITHIN),
        angles=angles,
        radii=plan.curve.radius(angles),
        greatest=(float(radii[most]), float(dense[most])),
        least=(float(radii[least]), float(dense[least])),
        blank=plan.made_blank,
        thickness=outer - inner,
        bore_fit=bore_class(design.blank.bore_fit),
        profile_tolerance=offset or None,
        face="inner face" if design.cam.side == Side.RIGHT else "outer face",
        files=folder.files(stem, design.content_hash, _ENDINGS),
        notes=tuple(_notes(plan)),
    )
    name = f"steering cam, {plan.profile} profile"
    return cam_drawing(part, title_of(design, name, design.blank.material or "", stem, folder))


def _notes(plan: CamPlan) -> Iterator[str]:
    tolerances = plan.design.tolerances
    if tolerances.inner_face_mm or tolerances.outer_face_mm:
        yield (
            f"Faces: inner ± {tolerances.inner_face_mm:g}, outer ± {tolerances.outer_face_mm:g} mm from the fork axis, "
            "as the cars are reckoned."
        )
    if plan.profile.note:
        yield plan.profile.note


def inspection_csv(plan: CamPlan) -> str:
    """Form for a dial on the lever, in the columns that `cadgen calibrate` reads: the readings are left open.

    A form that is not filled in is refused by `calibrate`, which names the first open row.
    """
    lines = [
        f"# design: {plan.design.name}",
        f"# profile: {plan.profile}; give calibrate --profile {plan.profile}",
        "# a dial on the lever at the disc's inner face: write each reading into lift_mm",
        "run,direction,cam_angle_deg,lift_mm",
    ]
    for run in range(1, _RUNS + 1):
        for direction, angles in (
            (Direction.FORWARD, range(0, 360, _STEP)),
            (Direction.REVERSE, range(360 - _STEP, -1, -_STEP)),
        ):
            lines += [f"{run},{direction},{angle}," for angle in angles]
    return "\n".join(lines) + "\n"
