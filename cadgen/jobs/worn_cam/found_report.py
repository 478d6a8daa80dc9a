"""The motion that was found in a measured cam, in sentences and a table."""

import json
from collections.abc import Iterator, Mapping, Sequence
from math import degrees, radians
from pathlib import Path

import numpy as np

from cadgen.arrays import TURN
from cadgen.check import failing
from cadgen.errors import DesignError
from cadgen.figures import Cell, Emphasis, Facts, Sheet, number
from cadgen.inference.measurement.record import understood_of
from cadgen.inference.motions.found_motion import FoundFlank
from cadgen.jobs.worn_cam.found_cam import FoundCamPlan, measured_face
from cadgen.laws.unit import MM
from cadgen.messages import Message, joined
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.terminal import Block, plain
from cadgen.parts.face import Face
from cadgen.progress import Progress

_UM = 1e3
_TURNED_DEG = 0.1  # turn of a segment that is told in wear
REPORT_WIDTH = 110


def found_report(cam: FoundCamPlan) -> list[Block]:
    """Report of a motion that was found.

    Args:
        cam: measured cam.
    """
    blocks: list[Block] = []
    record = cam.source.record
    if record.notes:
        blocks.append(understood_of(record))
    blocks += _measured(cam)
    blocks.append(_sheet(cam))
    blocks.append(
        Message(
            "Rises are known to {sigma:.2g} {unit}.",
            sigma=max(flank.rise_sigma for flank in cam.flanks) * (_UM if cam.follower.unit == MM else cam.scale),
            unit="µm" if cam.follower.unit == MM else Message("degrees"),
        )
    )
    blocks += [sentence for place in range(len(cam.flanks)) if (sentence := _doubt(cam, place))]
    blocks += [sentence for place in range(len(cam.flanks)) if (sentence := _worn(cam, place))]
    asked = cam.design.motion.ends_at_deg
    if asked is None and (cam.stated.grid is None or not cam.stated.grid.sure):
        blocks += [sentence for flank in cam.flanks if (sentence := _alike(flank))]
    if (grid := cam.stated.grid) is not None and grid.sure and asked is not None:
        blocks.append(
            Message(
                "All ends of segments are put at multiples of {step:g}° from the first, as motion.ends_at_deg "
                "says; as measured alone they lie up to {most:.2f} degrees beside, which is wear.{whole}",
                step=grid.step,
                most=float(abs(grid.shifts).max()),
                whole=Message(" Every segment is worn: cam angle 0 may be off by as much.")
                if all(flank.best.process.size for flank in cam.flanks)
                else "",
            )
        )
    elif grid is None and asked is not None:
        blocks.append(
            Message(
                "Ends of segments at multiples of {step:g}°, as motion.ends_at_deg says, do not fit what was "
                "measured: ends stay as they were measured. Remove the key, or give the step of the drawing.",
                step=asked,
            )
        )
    elif grid is not None and grid.sure:
        blocks.append(
            Message(
                "All ends of segments lie at multiples of {step:g}° from the first, by far too well for chance, "
                "and are taken to be there; wear turned those of worn segments by up to {most:.2f} degrees.",
                step=grid.step,
                most=float(abs(grid.shifts).max()),
            )
        )
    elif grid is not None:
        blocks.append(
            Message(
                "Which flank is worn cannot be told: one may be turned by wear by up to {most:.2f} degrees from whole "
                "degrees, or another one. Ends stay as they were measured: look at the surfaces, or measure lifts from "
                "a mark on the shaft.",
                most=float(abs(grid.shifts).max()),
            )
        )
    blocks.append(_zero(cam))
    blocks.append(_new_cam(cam))
    return blocks


def _measured(cam: FoundCamPlan) -> list[Block]:
    """Record, its noise, and the place of the camshaft in it."""
    rows = len(cam.source.record.run)
    said = Message(
        "{file}: {rows} {what}; noise {noise:.2g} µm, {left:.2g} µm left besides wear.",
        file=cam.source.path.name,
        rows=rows,
        what=Message("lifts") if cam.outline is None else Message("points"),
        noise=cam.noise_um,
        left=_UM * cam.motion.rms,
    )
    if cam.outline is None:
        return [said]
    x, y = cam.outline.centre
    y = -y if cam.mirrored else y
    if not cam.outline.centred:
        place = Message(
            "No dwell is long enough to show where the camshaft is: it is taken to be at the origin of the points. "
            "Base circle {base:.3f} mm.",
            base=cam.outline.base,
        )
    else:
        sigma = cam.motion.centre_sigma
        place = Message(
            "The camshaft is at x = {x:.4f}, y = {y:.4f} mm of the measured points, to {sigma:.2g} µm; base circle "
            "{base:.3f} mm.",
            x=float(x),
            y=float(y),
            sigma=_UM * float(max(sigma)) if sigma is not None else cam.noise_um,
            base=cam.outline.base,
        )
    if measured_face(cam.source.record) == Face.INNER:
        return [said, place]
    seen = Message(
        "The points are taken as seen on the outer face. If it was the inner one, the motion that was found runs "
        'backwards: begin their file with a line "# face: inner".'
    )
    return [said, place, seen]


def _sheet(cam: FoundCamPlan) -> Sheet:
    """Segments with their ends, heights, laws and wear."""
    unit = "mm" if cam.follower.unit == MM else "°"
    rows = []
    for flank in cam.flanks:
        depth, *_ = flank.wear
        if flank.in_table:
            codes = joined([fit.candidate.code for fit in flank.rivals], Message(" or "))
            law = Cell(codes, state=Emphasis.PLAIN if flank.named else Emphasis.STRONG)
        else:
            law = Cell(Message("none of the table"), state=Emphasis.BAD)
        rows.append(
            (
                law,
                number(_angle(cam, flank.start), "°", digits=3),
                number(_angle(cam, flank.stop) or 360.0, "°", digits=3),
                number(degrees(max(flank.start_sigma, flank.stop_sigma)), "°", digits=3),
                number((flank.after - flank.before) * cam.scale, unit, digits=4),
                number(_UM * depth, "µm", Emphasis.BAD if depth else Emphasis.PLAIN, 0),
            )
        )
    heads = (
        Message("Law"),
        Message("From"),
        Message("To"),
        Message("Ends ±"),
        Message("Rise"),
        Message("Wear"),
    )
    return Sheet("found-motion", Message("Motion that was found, without wear"), heads, tuple(rows))


def _angle(cam: FoundCamPlan, theta: float) -> float:
    """Cam angle of the new design, degrees."""
    return degrees((theta - cam.stated.zero) % TURN)


def _doubt(cam: FoundCamPlan, place: int) -> Message | None:
    """Sentence on a flank whose law is not named."""
    flank = cam.flanks[place]
    ends = {"start": _angle(cam, flank.start), "stop": _angle(cam, flank.stop) or 360.0}
    lever = float(abs(flank.best.data.push).mean())
    if not flank.in_table:
        return Message(
            "From {start:.2f} to {stop:.2f} degrees the motion has no law of the table; the nearest is {law}, which is "
            "{off:.0f} µm off. The new design has the measured motion by points, and with it any wear of this flank.",
            **ends,
            law=flank.best.candidate.code,
            off=_UM * float(abs(flank.best.residual).max()),
        )
    if flank.named:
        return None
    one, two = (fit.candidate.code for fit in flank.rivals[:2])
    return Message(
        "From {start:.2f} to {stop:.2f} degrees it is undecided between {one} and {two}: their lifts differ by "
        "{apart:.1f} µm, the noise is {noise:.1f} µm{worn}. The new design has {one}.",
        **ends,
        one=one,
        two=two,
        apart=_UM * lever * flank.apart,
        noise=cam.noise_um,
        worn=Message(", and the flank is worn") if flank.wear[0] else "",
    )


def _worn(cam: FoundCamPlan, place: int) -> Message | None:
    """Sentence on the wear of a flank."""
    depth, at, (first, last) = cam.flanks[place].wear
    if not depth:
        return None
    doubt: str = ""
    if cam.flanks[place].doubtful:
        doubt = Message(" It may also be a law that is not in the table, without wear: look at the surface.")
    return Message(
        "Worn by up to {depth:.0f} µm at {at:.0f} degrees, and by a third of that from {first:.0f} to {last:.0f}."
        "{doubt}",
        doubt=doubt,
        depth=_UM * depth,
        at=_angle(cam, at),
        first=_angle(cam, first),
        last=_angle(cam, last),
    )


def _alike(flank: FoundFlank) -> Message | None:
    """Sentence on a worn flank of which wear and a turn look alike: what a turn is in wear; None on a sound one."""
    if not flank.wear[0]:
        return None
    theta = np.linspace(flank.start, flank.stop, 721)
    steepest = float(np.abs(np.gradient(flank.share(theta), theta)).max()) * abs(flank.after - flank.before)
    turn = _UM * steepest * float(np.median(flank.best.data.push)) * radians(_TURNED_DEG)
    return Message(
        "Wear spread as the velocity of that segment looks like a segment that is turned: {turned:g} degrees of turn "
        "are {turn:.0f} µm of wear where it is steepest, and as much of the new lift. If the drawing has all ends at "
        "whole degrees, motion.ends_at_deg = 1 settles it.",
        turned=_TURNED_DEG,
        turn=turn,
    )


def _zero(cam: FoundCamPlan) -> Message:
    """Where cam angle 0 of the new design stands on the measured cam."""
    if cam.outline is None:
        return Message(
            "Cam angle 0 of the new design is cam angle {angle:.3f} degrees of the measured lifts.",
            angle=degrees(cam.zero),
        )
    return Message(
        "At cam angle 0 of the new design the {part} stands at polar angle {angle:.3f} degrees of the measured points, "
        "seen on the measured face: a key there goes with it.",
        part=Message(cam.follower.on_ray),
        angle=degrees(cam.zero),
    )


def _new_cam(cam: FoundCamPlan) -> Message:
    """Verdict on the cam of the new design."""
    try:
        failed = failing(cam.cam.checks)
    except DesignError as error:
        return Message("No new cam can be made for it: {reason}.", reason=error.message)
    if not failed:
        return Message("The new cam was rolled under its follower: every check holds.")
    names = joined([Message(each.name) for each in dict.fromkeys(failed)], "; ")
    return Message("The new cam was rolled under its follower, and does not keep: {names}.", names=names)


def write_measured(
    stem: str, folder: Path, facts: Facts, report: Sequence[Block], progress: Progress, designs: Mapping[str, str]
) -> Written:
    """Write report and JSON of a measured cam, with the new design where there is one.

    Args:
        stem: begin of the files' names.
        folder: where to.
        facts: result as facts.
        report: result in words.
        progress: function that is called with a few words on each step.
        designs: texts of new designs by their names.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    progress("writing")

    def files(staging: Path) -> Iterator[Artifact]:
        content = json.dumps(facts.json(), indent=2, allow_nan=False, ensure_ascii=False)
        yield text_file(staging / f"{stem}.json", f"{content}\n")
        yield text_file(staging / f"{stem}.txt", plain(report, REPORT_WIDTH))
        for name, text in designs.items():
            yield text_file(staging / f"{name}.toml", text)

    return publish(stem, folder, files, facts)
