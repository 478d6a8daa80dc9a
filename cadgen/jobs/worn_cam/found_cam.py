"""A measured cam of unknown motion: the motion that was meant, the design that states it, and the new cam."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.follower import Follower
from cadgen.cam.followers.kind import FollowerSeat
from cadgen.design.load import complete_of
from cadgen.design.override import override
from cadgen.design.schema import MotionDesign
from cadgen.design.sources.source import DiscSense
from cadgen.errors import DesignError, FileError
from cadgen.figures import Facts
from cadgen.inference.measurement.record import Record
from cadgen.inference.motions.found_motion import FoundFlank, FoundMotion, OutlineMotion, found_motion, outline_motion
from cadgen.inference.motions.lift_samples import samples_of_lifts
from cadgen.inference.motions.record_kinds import lifts_of, points_of, refuse_several
from cadgen.inference.motions.stated_motion import StatedMotion, StatedSegment, stated_motion
from cadgen.jobs.calibration.sources import Source
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.laws.unit import MM, TAN
from cadgen.output.files.manifest import Origin
from cadgen.parts.face import Face
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness

_STEPS_MM = (0.5, 0.1, 0.05)  # of round heights
_STEPS_DEG = (0.5, 0.1, 0.05)
_GUESS_MM = 10.0  # base circle with which a follower is built before that of the disc is known
_ROUND_BASE = 0.1  # mm
_BEFORE = 1e-9  # rad; a flank that begins at cam angle 0 is the first
_BASE_WITHIN = 0.003  # mm, within which a base circle is a round one
_INNER = re.compile(r"\s*face\s*:?\s*inner\b", re.IGNORECASE)


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FoundCamPlan:
    """Cam whose motion was found. Lengths are mm and angles rad.

    Attributes:
        design: design without its motion.
        text: text of its file.
        source: measured file.
        stated: motion that was found, as the new design states it.
        outline: outline with its centre and base circle; None where lifts were measured.
        follower: follower with the base circle of the disc.
    """

    design: MotionDesign
    text: str
    source: Source
    stated: StatedMotion
    outline: OutlineMotion | None
    follower: Follower

    def __repr__(self) -> str:
        laws = ", ".join(flank.best.candidate.code if flank.in_table else "?" for flank in self.flanks)
        return f"<FoundCam of {self.source.path.name}: {laws}>"

    @property
    def motion(self) -> FoundMotion:
        """Motion without wear, with the values that are stated."""
        return self.stated.motion

    @property
    def flanks(self) -> tuple[FoundFlank, ...]:
        """Rises and returns, in the order of the new design."""
        return tuple(sorted(self.motion.flanks, key=lambda flank: (flank.start - self.stated.zero + _BEFORE) % TURN))

    @property
    def named(self) -> bool:
        """Whether the law of every flank is named."""
        return self.motion.named

    @property
    def noise_um(self) -> float:
        """Noise of a reading along the normal, um."""
        return 1e3 * self.motion.samples.noise

    @property
    def scale(self) -> float:
        """Factor from the unit of the motion to that of the design file: 1 for mm, 57.3 from rad to degrees."""
        return 1.0 if self.follower.unit == MM else degrees(1.0)

    @property
    def mirrored(self) -> bool:
        """Whether the files of the cam show its other face, not the measured one."""
        return mirrored(self.design, self.source.record)

    @property
    def base_circle(self) -> float | None:
        """Radius of the base circle that the new design states, mm; None where the design has it."""
        if self.outline is None:
            return None
        nearest = round(self.outline.base / _ROUND_BASE) * _ROUND_BASE
        near = abs(self.outline.base - nearest) < _BASE_WITHIN
        return round(nearest if near else self.outline.base, 4)

    @property
    def name(self) -> str:
        """Name of the new design."""
        return f"{self.design.name}_found"

    @cached_property
    def toml(self) -> str:
        """Text of the new design file."""
        unit = "mm" if self.follower.unit == MM else "deg"
        return found_text(self.text, self.design.overrides, self.name, self.stated, unit, self.base_circle)

    @cached_property
    def cam(self) -> CamPlan:
        """New cam, made for the motion that was found, and checked by rolling.

        Raises:
            DesignError: no cam can be made for it.
        """
        made = complete_of(self.toml, Path(f"{self.name}.toml"))
        assert isinstance(made, MotionDesign)  # it has [motion]
        return plan_motion_cam(made)

    @property
    def readiness(self) -> Readiness:
        """Readiness of the found motion: not ready with an unknown law, with reservations where laws are alike."""
        if not all(flank.in_table for flank in self.flanks):
            return Readiness.NOT_READY
        sure = self.named and (self.stated.grid is None or self.stated.grid.sure)
        return Readiness.READY if sure else Readiness.RESERVATIONS

    def entry(self) -> Facts:
        """Everything, as in the JSON file."""
        outline = self.outline
        placed = Facts()
        if outline is not None:
            x, y = outline.centre
            placed = Facts(
                centre_mm=(float(x), float(-y if self.mirrored else y)),
                centre_found=outline.centred,
                base_circle_radius_mm=outline.base,
            )
        return (
            Origin.of(self.design).entry()
            | Facts(
                file=self.source.path.name,
                kind=self.source.kind.code,
                sha256=self.source.sha256,
                understood=self.source.record.notes,
                rows=len(self.source.record.run),
                readiness=self.readiness.value,
                noise_um=self.noise_um,
                left_um=1e3 * self.motion.rms,
            )
            | placed
            | Facts(
                zero_deg=degrees(self.zero),
                grid_deg=None if self.stated.grid is None else self.stated.grid.step,
                grid_sure=None if self.stated.grid is None else self.stated.grid.sure,
                segments=[self._flank(number) for number in range(len(self.flanks))],
            )
        )

    @property
    def zero(self) -> float:
        """Polar angle in the frame of the measured points, or cam angle of the measured lifts, of cam angle 0, rad."""
        angle = self.stated.zero
        return float((-angle if self.mirrored and self.outline is not None else angle) % TURN)

    def _flank(self, number: int) -> Facts:
        flank = self.flanks[number]
        unit = "mm" if self.follower.unit == MM else "deg"
        depth, place, (first, last) = flank.wear
        start, stop = (degrees((angle - self.stated.zero) % TURN) for angle in (flank.start, flank.stop))
        facts = Facts(
            **{
                "from_deg": start,
                "to_deg": stop or 360.0,
                "from_sigma_deg": degrees(flank.start_sigma),
                "to_sigma_deg": degrees(flank.stop_sigma),
                f"before_{unit}": (flank.before - self.motion.base) * self.scale,
                f"after_{unit}": (flank.after - self.motion.base) * self.scale,
                f"rise_sigma_{unit}": flank.rise_sigma * self.scale,
            },
            law=flank.best.candidate.code if flank.in_table else None,
            named=flank.named,
            rivals=[fit.candidate.code for fit in flank.rivals],
            nearest=flank.best.candidate.code,
            next_law=flank.fits[1].candidate.code,
            next_worse_by=flank.fits[1].score - flank.best.score,
            wear_um=1e3 * depth,
            wear_may_be_another_law=flank.doubtful,
        )
        if not depth:
            return facts
        return facts | Facts(
            wear_at_deg=degrees((place - self.stated.zero) % TURN),
            worn_from_deg=degrees((first - self.stated.zero) % TURN),
            worn_to_deg=degrees((last - self.stated.zero) % TURN),
        )


def find_cam(design: MotionDesign, text: str, sources: tuple[Source, ...], progress: Progress = silent) -> FoundCamPlan:
    """Motion of a measured cam.

    Args:
        design: design with `motion.measured`.
        text: text of its file.
        sources: measured file, one.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the follower is one whose motion is not found.
        FileError: the file does not show a motion.
    """
    record = refuse_several(tuple(source.record for source in sources))
    kind = design.follower.registered
    if kind.unit == TAN:
        raise DesignError(
            'follower.kind is "{code}", which leans on two edges: a motion is found for a follower on one curve, '
            "such as a roller",
            code=kind.code,
        )
    follower = follower_with(design, design.cam.base_circle_radius_mm or _GUESS_MM)
    progress("finding the motion")
    points = points_of(record)
    outline = None
    if points is not None:
        seen = points * [1.0, -1.0] if mirrored(design, record) else points
        outline = outline_motion(seen, follower)
        found = outline.found
        if outline.base <= 0:
            raise FileError(
                "{file} shows no cam for this follower: its base circle would have {base:.3g} mm: check the keys of "
                "[follower]",
                file=record.source,
                base=outline.base,
            )
        follower = follower_with(design, outline.base)
    else:
        angle, q = lifts_of(record, kind.unit)
        # Way of the contact by the motion: of a swinging follower, mm/rad.
        push = np.ones_like(q) if kind.unit == MM else np.full_like(q, float(follower.lift(np.array([1.0]))[0]))
        found = found_motion(samples_of_lifts(angle, q, push))
    stated = stated_motion(
        found,
        1.0 if kind.unit == MM else degrees(1.0),
        _STEPS_MM if kind.unit == MM else _STEPS_DEG,
        design.motion.ends_at_deg,
    )
    return FoundCamPlan(design=design, text=text, source=sources[0], stated=stated, outline=outline, follower=follower)


def follower_with(design: MotionDesign, base: float) -> Follower:
    """Follower of a design on a disc with a base circle.

    Args:
        design: design with [motion].
        base: radius of the base circle, mm.
    """
    inner, outer = design.cam.faces_mm
    seat = FollowerSeat(base_radius=base, faces=(inner, outer), carrying=(inner, outer))
    return design.follower.registered.follower(design.follower.keys, seat)


def mirrored(design: MotionDesign, record: Record) -> bool:
    """Whether files, which show the face on which the disc turns clockwise, show another than was measured.

    Args:
        design: design, which says the sense of the disc.
        record: record, whose remarks say if it was measured on the inner face.
    """
    return (design.motion.turns == DiscSense.COUNTERCLOCKWISE) != (measured_face(record) == Face.INNER)


def measured_face(record: Record) -> Face:
    """Face on which an outline was measured: the outer one, unless a remark says the other.

    Args:
        record: record of an outline.
    """
    return Face.INNER if any(_INNER.match(remark) for remark in record.remarks) else Face.OUTER


def found_text(
    text: str, overrides: Sequence[str], name: str, stated: StatedMotion, unit: str, base: float | None
) -> str:
    """Text of a design with the motion that was found in the place of `measured`.

    Args:
        text: text of the design that the cam was measured against.
        overrides: its overrides.
        name: name of the new design.
        stated: motion.
        unit: unit of its heights, `mm` or `deg`.
        base: radius of the base circle that was found, mm; None to leave the design's.
    """
    import tomlkit

    values: Any = tomlkit.parse(text)
    for change in overrides:
        override(values, change)
    if "name" in values:
        values["name"] = name
    motion = values["motion"]
    motion.pop("measured", None)
    motion.pop("ends_at_deg", None)
    if stated.segments:
        made = tomlkit.array()
        for segment in stated.segments:
            made.append(_segment_table(segment, unit))
        motion["segments"] = made.multiline(multiline=True)
    else:
        points = tomlkit.array()
        for angle, height in stated.points:
            points.append([angle, height])
        motion["points"] = points.multiline(multiline=True)
    if base is not None:
        values["cam"]["base_circle_radius_mm"] = base
    made_text = values.as_string()
    if "name" not in values:
        named = tomlkit.document()
        named.add("name", name)
        made_text = f"{named.as_string()}{made_text}"
    return f"# Written by cadgen calibrate: the motion was found from the measured cam.\n{made_text}"


def _segment_table(segment: StatedSegment, unit: str) -> Any:
    import tomlkit

    table = tomlkit.inline_table()
    if not segment.law:
        table["dwell_deg"] = segment.width
        return table
    table[f"to_{unit}"] = segment.after
    table["in_deg"] = segment.width
    table["law"] = segment.law
    if segment.ratio is not None:
        table["acceleration_ratio"] = segment.ratio
    return table
