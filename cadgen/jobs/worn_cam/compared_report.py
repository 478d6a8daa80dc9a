"""A measured cam beside its design, in sentences and a table."""

from math import degrees

from cadgen.cam.lift_errors import ECCENTRICITY
from cadgen.figures import Cell, Sheet, number
from cadgen.inference.measurement.record import understood_of
from cadgen.inference.motions.differences import BASE_CIRCLE, CamDifference
from cadgen.jobs.lift_tolerance import ANGLES, NAMES
from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan, direction
from cadgen.messages import Message, joined
from cadgen.output.report.terminal import Block

_UM = 1e3


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
    if c.rivals:
        sets = [joined([NAMES[code] for code in codes], Message(" and ")) for codes in c.rivals if codes]
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
