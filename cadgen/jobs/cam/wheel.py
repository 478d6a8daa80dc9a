"""The drive wheel that a cam is for, and what the closing blend does to the last of the path."""

from dataclasses import dataclass
from math import degrees, isfinite

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import drive, start_pose
from cadgen.design import cam_model, gear_model, variation
from cadgen.design.schema import Design
from cadgen.figures import Facts
from cadgen.messages import Message, joined
from cadgen.verdict import Reservation

FIELD_NOTICE = Message(
    "[field] is drawn and checks nothing: with the field's size in [course.field], and posts, walls and gates in "
    "[course], every run is checked against them."
)


def field_notice(design: Design) -> list[str]:
    """Notice that [field] checks nothing; empty without [field]."""
    return [] if design.field is None else [FIELD_NOTICE]


def sense_of_train(design: Design) -> Reservation | None:
    """Reservation on a train that turns the cam the other way round; None if it does not, or is not known."""
    if design.train is None:
        return None
    train = gear_model.train(design)
    return gear_model.sense_reservation(design, len(train.stages), train.sense)


@dataclass(frozen=True)
class BlendEnd:
    """End of the turn where the closing blend steers the last of the path.

    Attributes:
        stretch: travel of the drive wheel on the blend, mm.
        off: distance of the drive wheel from the end of its track at the end of the turn, mm.
        turned: heading there against that of the path, rad, positive to the left.
    """

    stretch: float
    off: float
    turned: float


@dataclass(frozen=True)
class DriveWheel:
    """The drive wheel that a cam is for.

    Attributes:
        radius: radius R_h, mm; None where neither it nor a train is known.
        known: whether the design gives the radius; else a turn of the cam takes the whole path.
        turn: travel in one turn of the cam, mm.
        finish: motor position up to which runs are judged, rad: there the closing blend begins, or the laps end.
        laps: laps of a closed path in one turn of the cam, and in a run; None of an open path.
        blend: end of the turn, if the blend steers the last of the path; None if all of it is driven before.
    """

    radius: float | None
    known: bool
    turn: float
    finish: float
    blend: BlendEnd | None
    laps: tuple[int, int] | None = None

    def sentence(self) -> Message:
        """Radius of the wheel and end of the run, in words."""
        if self.radius is None:
            first = Message(
                "Drive wheel: the car goes {turn:.0f} mm in a turn of the cam; its radius follows from the ratio of "
                "[train], which the design lacks.",
                turn=self.turn,
            )
        else:
            digits = 3 if self.laps is None else 4  # of a closed path all four are needed to give it in the design
            first = Message(
                "Drive wheel: radius {radius} mm, the car goes {turn:.0f} mm in a turn of the cam; the cam is right "
                "for this wheel alone.",
                radius=f"{self.radius:.{digits}f}",
                turn=self.turn,
            )
        return joined((first, self._end()), " ")

    def _end(self) -> Message:
        """End of the run: of laps, of a path that is driven whole, or of one that the blend steers at last."""
        if self.laps is not None:
            in_turn, in_run = self.laps
            turn = (
                Message("a lap")
                if in_turn == 1
                else Message("{laps} laps of {length:.0f} mm", laps=in_turn, length=self.turn / in_turn)
            )
            return Message(
                "The path is closed and a turn of the cam is {turn}; nothing is blended, and runs are judged after "
                "{run}.",
                turn=turn,
                run=Message("a lap") if in_run == 1 else Message("{laps} laps", laps=in_run),
            )
        if self.blend is None:
            return Message(
                "The whole path is driven by cam angle {finish:.2f}°, before the closing blend.",
                finish=degrees(self.finish),
            )
        return Message(
            "The path takes the whole turn, so the closing blend steers the last {stretch:.0f} mm: runs are judged to "
            "{finish:.2f}°, and at the end of the blend the car stands {off:.1f} mm and {turned:.2f}° off the path's "
            "end (car.drive_wheel_radius_mm puts the blend behind the path).",
            stretch=self.blend.stretch,
            finish=degrees(self.finish),
            off=self.blend.off,
            turned=degrees(abs(self.blend.turned)),
        )

    def entry(self) -> Facts:
        """Wheel and end of the run."""
        blend = self.blend
        return Facts(
            radius_mm=self.radius,
            radius_given=self.known,
            travel_per_turn_mm=self.turn,
            run_judged_to_deg=degrees(self.finish),
            blend_on_path=blend
            and Facts(length_mm=blend.stretch, end_off_mm=blend.off, end_heading_off_deg=degrees(blend.turned)),
        )


def drive_wheel(design: Design, track: Track, lift: PathMotion) -> DriveWheel:
    """The wheel that a design's cam is for.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift wanted.

    Raises:
        DesignError: the wheel's radius has a tolerance but no value.
    """
    turn, known = cam_model.travel(design, track), design.car.drive_wheel_radius_mm is not None
    radius = variation.wheel_radius(design, turn)
    blend = None
    laps = (track.turn_laps, design.path.run_laps) if track.closed else None
    if not known and laps is None:
        run = drive(lift, cam_model.car(design), turn, start=start_pose(track), stop=TURN)
        off = float(np.hypot(*(run.drive_wheel[-1] - track.position(track.length))))
        turned = float(run.heading[-1] - track.heading(np.array([0.0, track.length]))[-1])
        turned = (turned + TURN / 2) % TURN - TURN / 2
        blend = BlendEnd(track.length - cam_model.path_end(design, track), off, turned)
    return DriveWheel(radius if isfinite(radius) else None, known, turn, lift.blend_start, blend, laps)
