"""A measured cam whose motion is known: what differs from its design, by its lift or its outline."""

from dataclasses import dataclass
from math import atan2, degrees

import numpy as np

from cadgen.cam.lift_errors import ECCENTRICITY, LiftErrors
from cadgen.design.schema import MotionDesign
from cadgen.errors import FileError
from cadgen.figures import Cell, Facts, Sheet, number
from cadgen.inference.measurement.record import understood_of
from cadgen.inference.motions.differences import (
    BASE_CIRCLE,
    WEAR,
    CamComparison,
    CamDifference,
    compared,
    either_side,
    lift_readings,
    outline_readings,
    wrong_side_readings,
)
from cadgen.inference.motions.off_bore import off_bore
from cadgen.inference.motions.record_kinds import lifts_of, points_of, refuse_several
from cadgen.jobs.calibration.sources import Source
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.jobs.lift_tolerance import ANGLES, NAMES
from cadgen.jobs.worn_cam.found_cam import mirrored
from cadgen.messages import Message, joined
from cadgen.output.files.manifest import Origin
from cadgen.output.report.terminal import Block
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness

_UM = 1e3
_NAMES = {**NAMES, WEAR: Message("wear of a flank")}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class ComparedCamPlan:
    """Measured cam beside its design. Lengths are mm and angles rad.

    Attributes:
        design: design, with its motion.
        source: measured file.
        cam: cam as designed.
        of_disc: whether the outline was measured, and not the lift.
        comparison: what differs.
    """

    design: MotionDesign
    source: Source
    cam: CamPlan
    of_disc: bool
    comparison: CamComparison

    def __repr__(self) -> str:
        found = ", ".join([*(each.code for each in self.found), *([WEAR] if self.comparison.worn else [])])
        found = found or ("as designed" if self.comparison.explained else "not explained")
        return f"<ComparedCam of {self.source.path.name}: {found}>"

    @property
    def found(self) -> tuple[CamDifference, ...]:
        """Deviations that explain the record."""
        return self.comparison.found

    @property
    def readiness(self) -> Readiness:
        """Whether the record is explained without wear; with reservations where something else explains it as well."""
        if not self.comparison.explained or self.comparison.mirrored or self.comparison.worn:
            return Readiness.NOT_READY
        return Readiness.RESERVATIONS if self.comparison.rivals else Readiness.READY

    def at_lift(self, difference: CamDifference) -> float:
        """Greatest error of the lift by a deviation, to first order, mm.

        Args:
            difference: deviation.
        """
        errors = LiftErrors.of(self.cam.motion, self.cam.follower_as_built, None).errors
        of_unit = next(each.of_unit for each in errors if each.code == difference.code)
        return float(np.abs(of_unit @ np.array(difference.values)).max())

    def entry(self) -> Facts:
        """Everything, as in the JSON file."""
        c = self.comparison
        return Origin.of(self.design).entry() | Facts(
            file=self.source.path.name,
            kind=self.source.kind.code,
            sha256=self.source.sha256,
            understood=self.source.record.notes,
            readiness=self.readiness.value,
            wrong_side_up=c.mirrored,
            noise_um=_UM * c.noise,
            before_um=_UM * c.before,
            after_um=_UM * c.after,
            left_um=_UM * c.worst[0],
            left_at_deg=degrees(c.worst[1]),
            datum={code: degrees(value) if code == "clocking" else value for code, value in c.datum.items()},
            found=[self._fact(each) for each in self.found],
            worn=[
                Facts(
                    from_deg=degrees(each.start),
                    to_deg=degrees(each.stop),
                    depth_um=_UM * each.depth,
                    cam_angle_deg=degrees(each.cam_angle),
                )
                for each in c.worn
            ],
            rivals=c.rivals,
        )

    def _fact(self, each: CamDifference) -> Facts:
        angle = each.code in ANGLES
        scale = degrees(1.0) if angle else _UM
        facts = Facts(
            deviation=each.code,
            unit="deg" if angle else "um",
            size=each.size * scale,
            sigma=max(each.sigmas) * scale,
            lift_um=_UM * self.at_lift(each),
        )
        return facts | Facts(direction_deg=direction(each)) if each.code == ECCENTRICITY else facts


def direction(each: CamDifference) -> float:
    """Polar angle of an eccentric bore's disc in the frame of the design, degrees.

    Args:
        each: deviation with a direction.
    """
    x, y = each.values
    return degrees(atan2(y, x)) % 360


def compare_cam(design: MotionDesign, sources: tuple[Source, ...], progress: Progress = silent) -> ComparedCamPlan:
    """Deviations of a measured cam from its design.

    Args:
        design: design with its motion.
        sources: measured file, one.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: no cam can be made of the design, or its follower does not say what its dimensions do.
        FileError: the record is none of one whole cam, or its points lie about another point than the bore.
    """
    record = refuse_several(tuple(source.record for source in sources))
    plan = plan_motion_cam(design, None, progress)
    follower = plan.follower_as_built
    progress("comparing")
    points = points_of(record)
    if points is None:
        angle, q = lifts_of(record, follower.unit)
        readings = lift_readings(angle, q, plan.motion, follower, plan.curve)
        comparison = compared(readings)
        if not comparison.explained:
            comparison = either_side(comparison, lambda: wrong_side_readings(readings))
    else:
        beside = off_bore(points, plan.curve)
        if beside is not None:
            raise FileError(
                "{file}: the points lie about ({x:.3g}, {y:.3g}), not about 0: put the bore at the origin; with that "
                "shift taken out the radii are off by {after:.2g} mm rms from the design, and by {before:.2g} mm as "
                "they are",
                file=record.source,
                x=beside.x,
                y=beside.y,
                after=beside.after,
                before=beside.before,
            )
        seen, other = points * [1.0, -1.0], points
        if not mirrored(design, record):
            seen, other = other, seen
        comparison = compared(outline_readings(seen, plan.motion, follower))
        if not comparison.explained:
            comparison = either_side(comparison, lambda: outline_readings(other, plan.motion, follower))
    return ComparedCamPlan(
        design=design, source=sources[0], cam=plan, of_disc=points is not None, comparison=comparison
    )


def compared_report(cam: ComparedCamPlan) -> list[Block]:
    """Report of a comparison.

    Args:
        cam: measured cam.
    """
    c = cam.comparison
    blocks: list[Block] = [understood_of(cam.source.record)] if cam.source.record.notes else []
    blocks.append(
        Message(
            "{file}: {rows} {what}; noise {noise:.2g} µm; off by {before:.1f} µm rms from the design, by {after:.1f} "
            "µm from what is found.",
            file=cam.source.path.name,
            rows=len(cam.source.record.run),
            what=Message("points") if cam.of_disc else Message("lifts"),
            noise=_UM * c.noise,
            before=_UM * c.before,
            after=_UM * c.after,
        )
    )
    if c.mirrored:
        blocks.append(Message("The disc is wrong side up: its other face belongs outwards."))
    if cam.found:
        heads = (Message("Deviation"), Message("Size"), Message("Size ±"), Message("Lift off by"))
        rows = tuple(_row(cam, each) for each in cam.found)
        blocks.append(Sheet("cam-differences", Message("What differs from the design"), heads, rows))
    blocks += [
        Message(
            "The disc stands off the bore towards {angle:.0f} degrees of the design's frame.", angle=direction(each)
        )
        for each in cam.found
        if each.code == ECCENTRICITY
    ]
    if cam.of_disc and any(each.code not in (BASE_CIRCLE, ECCENTRICITY) for each in cam.found):
        blocks.append(Message("Dimensions of the follower are those that the disc was cut for."))
    if any(each.code == BASE_CIRCLE for each in cam.found) and not cam.of_disc:
        blocks.append(Message("A larger roller lifts as a larger disc does: measure both."))
    worn = Message(
        "The flank from {start:.0f} to {stop:.0f} degrees of cam angle is worn: {depth:.0f} µm are missing along "
        "the normal at {angle:.0f} degrees."
    )
    if not c.surely_worn:
        worn = Message(
            "The flank from {start:.0f} to {stop:.0f} degrees of cam angle may be worn: then {depth:.0f} µm are "
            "missing along the normal at {angle:.0f} degrees. What is as likely without wear stands below."
        )
    blocks += [
        Message(
            worn.template,
            start=degrees(each.start),
            stop=degrees(each.stop),
            depth=_UM * each.depth,
            angle=degrees(each.cam_angle),
        )
        for each in c.worn
    ]
    if c.rivals:
        sets = [joined([_NAMES[code] for code in codes], Message(" and ")) or Message("nothing") for codes in c.rivals]
        blocks.append(Message("As likely: {rivals}.", rivals=joined(sets, "; ")))
    if not c.explained:
        blocks.append(
            Message(
                "{left:.1f} µm are left at {angle:.0f} degrees of cam angle, {what}.",
                left=abs(_UM * c.worst[0]),
                angle=degrees(c.worst[1]),
                what=Message("where material is missing: wear, or another motion")
                if c.worst[0] < 0
                else Message("where there is too much: another motion"),
            )
        )
    return blocks


def _row(cam: ComparedCamPlan, each: CamDifference) -> tuple[Cell | str, ...]:
    angle = each.code in ANGLES
    scale, unit = (degrees(1.0), "°") if angle else (_UM, "µm")
    digits = 3 if angle else 1
    return (
        NAMES[each.code],
        number(each.size * scale, unit, digits=digits),
        number(max(each.sigmas) * scale, unit, digits=digits),
        number(_UM * cam.at_lift(each), "µm", digits=1),
    )
