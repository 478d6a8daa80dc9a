"""Task of a cam against play: the run wanted, and on a train the window by which a lift is best dilated."""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from cadgen.arrays import Array
from cadgen.cam.follower import Contact, EdgeFollower
from cadgen.car.against_play.band import EndBound, PlayBand, best_for_band, fixed_profile_bound
from cadgen.car.against_play.compensation import CutLift, compensated_lift
from cadgen.car.against_play.smoothing import smooth_to
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Pose, Run, drive
from cadgen.car.running.mechanics import Mechanics, MechanicsBand
from cadgen.car.running.play import LEAST_SWING, Following, follow
from cadgen.car.steering import Car
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.gears.choices import StageOrder


class FinishedDisc(Protocol):
    """How a disc comes out of the workshop and stands on its shaft: `AS_DESIGNED`, or a car as built."""

    def precompensated(self, wanted: ClosedCurve) -> ClosedCurve:
        """Curve to be cut, mm, so that the finished disc has the profile wanted."""

    def roll_new(self, curve: ClosedCurve, follower: EdgeFollower, cam_angle: Array, step: float) -> Contact:
        """Contact of the follower with the finished disc of a curve that is cut.

        Args:
            curve: curve that is cut, mm.
            follower: follower as designed.
            cam_angle: cam angles, rad, shape (n,).
            step: step of the outline, mm.
        """

    def roll_measured(self, curve: ClosedCurve, follower: EdgeFollower, cam_angle: Array, step: float) -> Contact:
        """Contact of the follower with the disc that was measured; arguments as for `roll_new`.

        Args:
            curve: profile of that disc as designed, mm.
            follower: follower as built.
            cam_angle: cam angles, rad, shape (n,).
            step: step of the outline, mm.
        """

    @property
    def shapes_discs(self) -> bool:
        """Whether a new disc comes out, or runs, other than it is cut."""

    def finished(self, outline: Outline) -> Outline:
        """Outline on its shaft, mm, of a disc cut to an outline."""

    def unevenness(self, *, measured: bool) -> float:
        """Rises and falls of the lift, mm, that waves and steps of the finished disc may make."""


@dataclass(frozen=True, kw_only=True)
class PlayTask:
    """The lift wanted, with the car and the follower that are to give it.

    Attributes:
        lift: lift wanted by motor position.
        follower: follower of the car.
        car: dimensions of the car.
        length: travel of the drive wheel's rim in one turn of the cam, mm.
        aim: share of the sum of deflection errors that smoothing takes off.
        start: pose at which runs begin, mm and rad.
        as_built: deviations of the car as built, which change a disc that is cut.
        mechanics: range of friction and drag; None where they are left out, as if the rod slid freely.
        trimmed: whether the steering is trimmed after a trial run of each car, so that ends are those after the trim.
    """

    lift: PathMotion
    follower: EdgeFollower
    car: Car
    length: float
    aim: float
    start: Pose
    as_built: FinishedDisc
    mechanics: MechanicsBand | None = None
    trimmed: bool = False

    def planned(self) -> Run:
        """Run of the car by the lift wanted, without play."""
        return self.run(self.lift, 0.0)

    def run(
        self,
        lift: PathMotion,
        play: float,
        *,
        least_swing: float = LEAST_SWING,
        cut: PathMotion | None = None,
        mechanics: Mechanics | None = None,
    ) -> Run:
        """The run that a cam gives with play.

        Args:
            lift: lift that the follower gets.
            play: return error B, rad.
            least_swing: same as in `follow`.
            cut: lift that the cam was cut for; `lift` itself if left out.
            mechanics: friction and drag; those of the nominal car if left out.
        """
        following = self.following(lift, play, least_swing=least_swing, cut=cut, mechanics=mechanics)
        stop = self.lift.blend_start
        return drive(lift, self.car, self.length, start=self.start, stop=stop, following=following)

    def following(
        self,
        lift: PathMotion,
        play: float,
        *,
        least_swing: float = LEAST_SWING,
        cut: PathMotion | None = None,
        mechanics: Mechanics | None = None,
    ) -> Following:
        """Motion of a cam that follows the motor.

        Args:
            lift: lift that the follower gets.
            play: return error, rad.
            least_swing: least rise or fall of tan(beta) that counts.
            cut: lift that the cam was cut for; `lift` itself if left out.
            mechanics: forces and friction on the cam; those of the task if left out.
        """
        if mechanics is None and self.mechanics is not None:
            mechanics = self.mechanics.nominal
        if mechanics is None:
            return follow(lift, play, least_swing=least_swing)
        return mechanics.leads(cut or lift).follow(lift, play)


@dataclass(frozen=True)
class TrainTask:
    """A task on one train. The train enters by its return error alone: the paper's train `reordered` has a smaller one.

    Attributes:
        task: lift wanted, car and follower.
        train: order of its stages.
        band: return error of the train, rad.
    """

    task: PlayTask
    train: StageOrder
    band: PlayBand

    @cached_property
    def compensated(self) -> CutLift:
        """Lift wanted, compensated: `compensated_of` of it.

        Raises:
            DesignError: the band does not run upwards from 0 or more.
        """
        return self.compensated_of(self.task.lift)

    @property
    def windows(self) -> tuple[float, ...]:
        """Windows of `compensated`, rad; errors as there."""
        return self.compensated.windows

    def cut_as(self, lift: PathMotion) -> CutLift:
        """Lift that is cut as it is, with the windows of `compensated`; errors as there."""
        return CutLift(lift, self.windows)

    def compensated_of(self, lift: PathMotion) -> CutLift:
        """Lift dilated by the measured play or, where none is measured, with the least worst end of run over the band.

        With friction it is dilated by one window, or turned ahead by one on each lead, so that the worst end over plays
        and frictions is least; also for a measured play.

        Args:
            lift: lift that is to be compensated.

        Raises:
            DesignError: the band does not run upwards from 0 or more.
        """
        task, ends, measured = self.task, self.band.ends, self.band.measured
        if measured is not None:
            ends = measured, measured
            if task.mechanics is None:
                return CutLift(compensated_lift(lift, task.follower, measured), (measured,))
        trimmed = task.trimmed and task.mechanics is not None
        mechanics: tuple[Mechanics, ...] = ()
        if task.mechanics is not None:
            mechanics = task.mechanics.cases if trimmed else task.mechanics.usual
        best = best_for_band(
            lift,
            task.follower,
            task.car,
            task.length,
            ends,
            wanted=task.lift,
            mechanics=mechanics,
            trimmed=trimmed,
        )
        return CutLift(best.lift, best.windows or (best.made_for,), by_lead=bool(best.windows))

    @cached_property
    def smoothed(self) -> PathMotion:
        """The lift wanted with its peaks and valleys brought nearer, by the aim of the task.

        Raises:
            DesignError: no smoothing reaches the aim.
        """
        task = self.task
        return smooth_to(task.lift, task.follower, task.car, task.length, self.band.ends[1], aim=task.aim)

    @cached_property
    def planned(self) -> Run:
        """Run of the car by the lift wanted, without play."""
        return self.task.planned()

    def prepare(self) -> None:
        """Compute what every profile needs: windows and planned run.

        Raises:
            DesignError: the band does not run upwards from 0 or more.
        """
        _ = self.windows, self.planned

    def run_at(self, made_for: float) -> float:
        """Return error of the run that a profile is evaluated by, rad: that it is cut for, or with friction the car's.

        Args:
            made_for: width of the window that the profile is cut for, rad.
        """
        if self.task.mechanics is None:
            return made_for
        return sum(self.band.ends) / 2 if self.band.measured is None else self.band.measured

    def bound(self) -> EndBound:
        """Lower bound of the worst end of the run over the band, for profiles with these peaks and valleys."""
        return fixed_profile_bound(self.task.lift, self.task.car, self.task.length, self.band.ends)
