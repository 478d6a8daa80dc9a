"""Drift of a car on a closed path: per lap and after the last one, without play and with it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import degrees, inf

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.running.drive import Run
from cadgen.check import Bound, Check, CheckCode
from cadgen.figures import Facts
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class Drift:
    """Drift of a car on a closed path, after each of its laps.

    Attributes:
        position: distance of the drive wheel from where it started, shape (n,), mm.
        heading: heading less that of the start, shape (n,), rad, positive to the left.
        furthest: greatest distance of the drive wheel on the last lap from where it is planned, mm: a lap that turns
            about its start is far off elsewhere.
    """

    position: Array
    heading: Array
    furthest: float

    @property
    def lap(self) -> tuple[float, float]:
        """Position (mm) and heading (rad) after the first lap."""
        return float(self.position[0]), float(self.heading[0])

    @property
    def end(self) -> tuple[float, float]:
        """Position (mm) and heading (rad) after the last lap."""
        return float(self.position[-1]), float(self.heading[-1])


def drift(run: Run, planned: Run, laps_per_turn: int, round_: float) -> Drift:
    """Drift at the end of each lap of a run.

    Args:
        run: run over whole laps, with motor positions at or close to the end of each.
        planned: the planned run, at the same motor positions.
        laps_per_turn: laps in one turn of the cam.
        round_: angle by which the car turns on its lap, rad: a whole number of turns.
    """
    lap = TURN / laps_per_turn
    number = np.arange(1, round(run.motor[-1] / lap) + 1)

    def at(values: Array) -> Array:
        return np.interp(number * lap, run.motor, values)

    x, y = run.drive_wheel.T
    last = run.motor >= run.motor[-1] - lap
    return Drift(
        position=np.hypot(at(x) - x[0], at(y) - y[0]),
        heading=at(run.heading) - run.heading[0] - number * round_,
        furthest=float(np.linalg.norm(run.drive_wheel[last] - planned.drive_wheel[last], axis=1).max()),
    )


# What a lap without play may leave: a hundredth of a millimetre, and a thousandth of a degree.
_MOST_MM, _MOST_DEG = 0.01, 0.001
Running = Callable[[Evaluation, float], Run]


@dataclass(frozen=True, kw_only=True)
class Laps:
    """The laps of a closed path.

    Attributes:
        in_turn: laps in one turn of the cam.
        in_run: laps of a run.
        length: length of the drive wheel's track on a lap, mm.
        turned: angle by which the car turns on a lap, rad: a whole number of turns.
        planned: the planned run.
    """

    in_turn: int
    in_run: int
    length: float
    turned: float
    planned: Run

    def of(self, run: Run) -> Drift:
        """Drift of a run, after each of its laps."""
        return drift(run, self.planned, self.in_turn, self.turned)

    def checks(self, chosen: Evaluation | None) -> tuple[Check, ...]:
        """Drift of a lap without play with its limits; with play as figures, for no path is free of it.

        Args:
            chosen: profile that was chosen against play; None if none was.
        """
        off, turned = self.of(self.planned).lap
        place = Message("without play, against the start")
        advice = Message("the lap does not close: report this design")
        heading = degrees(abs(turned))
        checks = [
            Check(CheckCode.LAP_DRIFT, Message("drift of a lap"), off, "mm", _MOST_MM, Bound.MAX, place, advice),
            Check(
                CheckCode.LAP_TURN,
                Message("drift of a lap, heading"),
                heading,
                "°",
                _MOST_DEG,
                Bound.MAX,
                place,
                advice,
            ),
        ]
        if chosen is None:
            return tuple(checks)
        place, with_play = Message("return error {play:.3f}°", play=degrees(chosen.play)), self.of(chosen.run)
        for code, turning, name, (off, turned) in (
            (CheckCode.LAP_DRIFT_PLAY, CheckCode.LAP_TURN_PLAY, Message("drift of a lap"), with_play.lap),
            (
                CheckCode.LAPS_DRIFT_PLAY,
                CheckCode.LAPS_TURN_PLAY,
                Message("drift of laps, {in_run}", in_run=self.in_run),
                with_play.end,
            ),
        ):
            checks += [
                Check(code, Message("{name}, with play", name=name), off, "mm", inf, Bound.MAX, place),
                Check(
                    turning,
                    Message("{name}, heading, with play", name=name),
                    degrees(abs(turned)),
                    "°",
                    inf,
                    Bound.MAX,
                    place,
                ),
            ]
        furthest = with_play.furthest
        checks.append(
            Check(
                CheckCode.LAP_FURTHEST_PLAY,
                Message("off on the last lap, with play"),
                furthest,
                "mm",
                inf,
                Bound.MAX,
                place,
            )
        )
        return tuple(checks)

    def sentences(self, running: Running, before: Evaluation, chosen: Evaluation) -> list[str]:
        """Drift with play, in words.

        Args:
            running: run on a profile with a return error, rad.
            before: the profile before.
            chosen: profile that was chosen against play.
        """
        lines: list[str] = []
        play = chosen.play
        for evaluation in (before, chosen) if before is not chosen else (chosen,):
            run, band = self.of(running(evaluation, play)), self._over_band(running, evaluation)
            lines.append(
                Message(
                    "Laps, {title}: at a return error of {play:.3f}° the car drifts {lap} in a lap and "
                    "{end} in {in_run}, and on the last of them is at most {furthest:.1f} mm off; over the "
                    "band {lap_band}, {end_band} and {furthest_band:.1f} mm.",
                    title=evaluation.title,
                    play=degrees(play),
                    lap=_words(run.lap),
                    end=_words(run.end),
                    in_run=self.in_run,
                    furthest=run.furthest,
                    lap_band=_words(_worst([each.lap for each in band])),
                    end_band=_words(_worst([each.end for each in band])),
                    furthest_band=max(each.furthest for each in band),
                )
            )
        return lines

    def entry(self, running: Running | None, **evaluations: Evaluation) -> Facts:
        """Drift without play and of profiles.

        Args:
            running: as in `sentences`; None where nothing is known of the play.
            evaluations: profiles by their names in the result; the return error is that of the last one.
        """
        found = Facts(
            per_turn=self.in_turn,
            in_run=self.in_run,
            lap_length_mm=self.length,
            drift_without_play=_greatest([self.of(self.planned)]),
        )
        if running is None:
            return found
        *_, chosen = evaluations.values()
        for name, evaluation in evaluations.items():
            drift = (
                Facts(return_error_deg=degrees(chosen.play))
                | _greatest([self.of(running(evaluation, chosen.play))])
                | Facts(worst_over_band=_greatest(self._over_band(running, evaluation)))
            )
            found |= Facts(**{f"drift_{name}": drift})
        return found

    def in_runs(self, **runs: Run) -> Facts:
        """Drift of runs by their names, after each lap."""
        drifts = {name: self.of(run) for name, run in runs.items()}
        return Facts(
            **{
                name: Facts(position_mm=each.position, heading_deg=np.degrees(each.heading))
                for name, each in drifts.items()
            }
        )

    def _over_band(self, running: Running, evaluation: Evaluation) -> list[Drift]:
        """Drift at the return errors of a profile's band."""
        return [self.of(running(evaluation, play)) for play in evaluation.band.plays.tolist()]


def _worst(drifts: Sequence[tuple[float, float]]) -> tuple[float, float]:
    off, turned = np.abs(np.array(drifts)).max(axis=0).tolist()
    return off, turned


def _words(off_and_turned: tuple[float, float]) -> str:
    off, turned = off_and_turned
    return Message("{off:.2f} mm and {turned:.3f}°", off=off, turned=degrees(abs(turned)))


def _greatest(drifts: Sequence[Drift]) -> Facts:
    """The greatest of several drifts; headings by size."""
    lap, end = _worst([each.lap for each in drifts]), _worst([each.end for each in drifts])
    return Facts(
        lap_mm=lap[0],
        lap_heading_deg=degrees(lap[1]),
        end_mm=end[0],
        end_heading_deg=degrees(end[1]),
        last_lap_off_mm=max(each.furthest for each in drifts),
    )
