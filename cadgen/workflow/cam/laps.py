"""Drift of a car on a closed path: per lap and after the last one, without play and with it."""

from dataclasses import dataclass
from math import degrees, inf
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.build import cam_model
from cadgen.cam.lift import LiftCurve
from cadgen.check import Check, CheckCode
from cadgen.design.schema import Design
from cadgen.motion.drive import Run, drive, start_pose
from cadgen.motion.laps import Drift, drift
from cadgen.optimize.evaluate import Evaluation
from cadgen.path.track import Track
from cadgen.workflow.cam.against import Against

# What a lap without play may leave: a hundredth of a millimetre, and a thousandth of a degree.
_MOST_MM, _MOST_DEG = 0.01, 0.001


@dataclass(frozen=True)
class Laps:
    """The laps of a design's closed path.

    Attributes:
        design: loaded design.
        track: track of the drive wheel, one lap.
        lift: lift wanted.
    """

    design: Design
    track: Track
    lift: LiftCurve

    @property
    def in_turn(self) -> int:
        """Laps in one turn of the cam."""
        return self.track.turn_laps

    @property
    def count(self) -> int:
        """Laps of a run."""
        return self.design.path.run_laps

    def of(self, run: Run) -> Drift:
        """Drift of a run, after each of its laps."""
        heading = self.track.heading(self.track.arc)
        return drift(run, self.in_turn, TURN * round(float(heading[-1] - heading[0]) / TURN))

    @property
    def planned(self) -> Drift:
        """Drift without play on the lift wanted."""
        travel = cam_model.travel(self.design, self.track)
        return self.of(drive(self.lift, cam_model.car(self.design), travel, start=start_pose(self.track)))

    def over_band(self, against: Against, evaluation: Evaluation) -> tuple[Drift, ...]:
        """Drift of a profile at each return error of its band."""
        return tuple(self.of(against.run(evaluation, play)) for play in evaluation.band.plays.tolist())

    def checks(self, against: Against | None) -> tuple[Check, ...]:
        """Drift of a lap without play with its limits; with play as figures, for no path is free of it.

        Args:
            against: comparison of the profiles under play; None if there was none.
        """
        off, turned = self.planned.lap
        place, advice = "without play, against the start", "the lap does not close: report this design"
        heading = degrees(abs(turned))
        checks = [
            Check(CheckCode.LAP_DRIFT, "drift of a lap", off, "mm", _MOST_MM, "max", place, advice),
            Check(CheckCode.LAP_TURN, "drift of a lap, heading", heading, "°", _MOST_DEG, "max", place, advice),
        ]
        if against is not None:
            chosen = against.chosen
            place = f"return error {degrees(chosen.play):.3f}°"
            with_play = self.of(chosen.run)
            for code, turning, name, (off, turned) in (
                (CheckCode.LAP_DRIFT_PLAY, CheckCode.LAP_TURN_PLAY, "drift of a lap", with_play.lap),
                (CheckCode.LAPS_DRIFT_PLAY, CheckCode.LAPS_TURN_PLAY, self._after, with_play.end),
            ):
                checks += [
                    Check(code, f"{name}, with play", off, "mm", inf, "max", place),
                    Check(turning, f"{name}, heading, with play", degrees(abs(turned)), "°", inf, "max", place),
                ]
        return tuple(checks)

    @property
    def _after(self) -> str:
        return "drift of 1 lap" if self.count == 1 else f"drift of {self.count} laps"

    def sentences(self, against: Against) -> list[str]:
        """Drift with play of the profile before and of the chosen one, in words."""
        rows = {"the actual profile": against.before, f"the {against.chosen.profile} profile": against.chosen}
        lines = []
        for name, evaluation in rows.items():
            run = self.of(against.run(evaluation, against.chosen.play))
            band = self.over_band(against, evaluation)
            lines.append(
                f"Laps with {name}: at a return error of {degrees(against.chosen.play):.3f}° the car drifts "
                f"{_words(run.lap)} in a lap and {_words(run.end)} in {self.count}; over the band at most "
                f"{_words(_worst([each.lap for each in band]))} in a lap and "
                f"{_words(_worst([each.end for each in band]))} in {self.count}."
            )
        return lines[-1:] if against.before is against.chosen else lines

    def facts(self, against: Against | None) -> dict[str, Any]:
        """The same as plain values."""
        found: dict[str, Any] = {
            "per_turn": self.in_turn,
            "in_run": self.count,
            "lap_length_mm": self.track.length,
            "drift_without_play": _facts(self.planned),
        }
        if against is None:
            return found
        for name, evaluation in (("before", against.before), ("after", against.chosen)):
            band = self.over_band(against, evaluation)
            found[f"drift_{name}"] = {
                "return_error_deg": degrees(against.chosen.play),
                **_facts(self.of(against.run(evaluation, against.chosen.play))),
                "worst_over_band": _plain(_worst([each.lap for each in band]), _worst([each.end for each in band])),
            }
        return found


def laps_of(design: Design, track: Track, lift: LiftCurve) -> Laps | None:
    """The laps of a design; None if its path is open."""
    return Laps(design, track, lift) if track.closed else None


def _worst(drifts: list[tuple[float, float]]) -> tuple[float, float]:
    off, turned = np.abs(np.array(drifts)).max(axis=0).tolist()
    return off, turned


def _words(off_and_turned: tuple[float, float]) -> str:
    off, turned = off_and_turned
    return f"{off:.2f} mm and {degrees(abs(turned)):.3f}°"


def _facts(found: Drift) -> dict[str, float]:
    return _plain(found.lap, found.end)


def _plain(lap: tuple[float, float], end: tuple[float, float]) -> dict[str, float]:
    return {
        "lap_mm": lap[0],
        "lap_heading_deg": degrees(lap[1]),
        "end_mm": end[0],
        "end_heading_deg": degrees(end[1]),
    }
