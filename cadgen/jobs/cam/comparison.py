"""A profile against play beside the plain profile: runs and errors of both, and the gain."""

from dataclasses import dataclass
from math import degrees, radians

from cadgen.cam.follower import Follower
from cadgen.cam.followers.rod import rod_of
from cadgen.car.against_play.band import EndBound, PlayBand
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.against_play.profile_kinds import ProfileKind
from cadgen.car.path.track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, start_pose
from cadgen.car.running.errors import run_error
from cadgen.car.running.play import LEAST_SWING, Following
from cadgen.curves.closed import ClosedCurve
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.figures import Figure, Figures
from cadgen.gears.choices import StageOrder
from cadgen.messages import Message

PAPER_PERCENT = 45.31  # reduction of the sum of deflection errors by the paper's two methods together
# An error before that is no greater than this is within the error of rolling: no share of it can be taken off; mm, rad.
_NO_DISTANCE, _NO_HEADING = 1.0, radians(0.01)
_LOSS = 0.01  # share of the error before that a file may give away
_LEAST_LOSS = 10.0  # mm; less is within what a start by hand is off


@dataclass(frozen=True, kw_only=True)
class MeasuredCam:
    """Cam that was on the car when the car was measured: its profile, its lift, and the curve that was cut, mm."""

    profile: ProfileKind
    lift: PathMotion
    curve: ClosedCurve


@dataclass(frozen=True, kw_only=True)
class PlayComparison:
    """A profile against play, beside the plain profile.

    Attributes:
        task: lift wanted, car and follower.
        band: return error of the design's train, rad.
        before: the actual profile with the train as given; of a design as built, the cam as it was measured.
        chosen: the profile to be cut.
        evaluations: all profiles that were compared, `before` and `chosen` among them.
        reasons: sentences on the choice, one for each profile.
        bound: lower bound of the worst end over the band, to first order, for profiles with the same peaks and valleys
            if the rod slides without friction.
        rubbing: effect of friction on the run, a sentence; empty if the design has friction or it changes nothing.
    """

    task: PlayTask
    band: PlayBand
    before: Evaluation
    chosen: Evaluation
    evaluations: tuple[Evaluation, ...]
    reasons: tuple[str, ...]
    bound: EndBound
    rubbing: str

    def gain(self, evaluation: Evaluation) -> tuple[float | None, float | None]:
        """Shares of heading and position error at the end that a profile takes off; None where there is hardly any.

        Both cars have the same play, that of `evaluation`; `worst_gain` is for a train with less play.
        """
        error = run_error(self.run(self.before, evaluation.play), self.task.planned())
        return (
            _off(evaluation.error.end_heading, error.end_heading, _NO_HEADING),
            _off(evaluation.error.end_distance, error.end_distance, _NO_DISTANCE),
        )

    def worst_gain(self, distance: float) -> float | None:
        """Share by which a worst end position error `distance` (mm) is below that of `before` over its band.

        Args:
            distance: distance, mm.
        """
        return _off(distance, self.before.band.worst_distance, _NO_DISTANCE)

    def sum_gain(self, evaluation: Evaluation) -> float | None:
        """Share by which a profile's sum of deflection errors, on its own train, is below that of `before`."""
        return _off(evaluation.deflection_sum, self.before.deflection_sum, _NO_HEADING)

    def figures(self, evaluation: Evaluation) -> Figures:
        """Errors of a profile and what it takes off, as they are shown.

        Args:
            evaluation: profile that was compared.
        """
        e, band = evaluation, evaluation.band
        heading, distance = self.gain(e)
        return Figures(
            Figure("return_error", Message("return error"), degrees(e.play), "°"),
            Figure("deflection_sum", Message("sum of deflection errors"), degrees(e.deflection_sum), "°"),
            *(e.error.figures[code] for code in ("end_heading", "end_position")),
            Figure("heading_percent_off", Message("heading taken off"), _percent(heading), "%"),
            Figure("position_percent_off", Message("taken off"), _percent(distance), "%"),
            Figure("worst_end_heading", Message("worst heading over the band"), degrees(band.worst_heading), "°"),
            Figure("worst_end_position", Message("worst position over the band"), band.worst_distance, "mm"),
            Figure(
                "worst_position_percent_off",
                Message("worst position taken off"),
                _percent(self.worst_gain(band.worst_distance)),
                "%",
            ),
            Figure("greatest_position_on_run", Message("greatest on the run"), float(e.error.distance.max()), "mm"),
            Figure("end_position_without_play", Message("position without play"), e.deviation.end_distance, "mm"),
            Figure(
                "greatest_position_without_play",
                Message("greatest without play"),
                float(e.deviation.distance.max()),
                "mm",
            ),
            Figure("lift_error", Message("lift error with play"), e.worst_lift_error * 1e3, "µm"),
        )

    def loses(self, end_distance: float) -> bool:
        """Whether a file whose run ends `end_distance` (mm) off gives away the gain of the profile.

        It does if its run ends further off than the profile's by more than 10 mm and one percent of the error before.

        Args:
            end_distance: distance of the end of the run from the planned one, mm.
        """
        error = run_error(self.run(self.before, self.chosen.play), self.task.planned())
        return end_distance - self.chosen.error.end_distance > max(_LOSS * error.end_distance, _LEAST_LOSS)

    def run(self, evaluation: Evaluation, play: float) -> Run:
        """Run on a profile with any play, rad.

        Args:
            evaluation: profile that was compared.
            play: return error, rad.
        """
        return self.task.run(evaluation.rolled, play, least_swing=evaluation.least_swing, cut=evaluation.lift)

    def following(self, evaluation: Evaluation, play: float) -> Following:
        """Motion of the cam with a profile that follows the motor with any play, rad.

        Args:
            evaluation: profile that was compared.
            play: return error, rad.
        """
        return self.task.following(evaluation.rolled, play, least_swing=evaluation.least_swing, cut=evaluation.lift)

    def end_of(self, lift: PathMotion, least_swing: float = LEAST_SWING) -> tuple[float, float]:
        """Heading error (rad) and position error (mm) at the end, with the play of `chosen`, on the lift of a file.

        Args:
            lift: lift that the follower gets.
            least_swing: smallest rise or fall of tan(beta) that counts as an event.
        """
        run = self.task.run(lift, self.chosen.play, least_swing=least_swing, cut=self.chosen.lift)
        error = run_error(run, self.task.planned())
        return error.end_heading, error.end_distance


def _percent(share: float | None) -> float | None:
    return None if share is None else 100 * share


def _off(error: float, before: float, smallest: float) -> float | None:
    return 1 - abs(error / before) if abs(before) > smallest else None


def task_of(design: Design, track: Track, lift: PathMotion, follower: Follower) -> PlayTask:
    """Task of a profile against play, for a design and its track.

    Raises:
        DesignError: the follower is not the leaning rod.
    """
    rod = rod_of(follower, "what the play of the gears does to a cam", "take --profile actual")
    return PlayTask(
        lift=lift,
        follower=rod,
        car=cam_model.car(design),
        length=cam_model.travel(design, track),
        aim=design.optimize.smoothing_percent / 100,
        start=start_pose(track),
        as_built=cam_model.as_built(design),
        mechanics=variation.mechanics(design, rod, lift),
    )


def known_trains(design: Design) -> dict[StageOrder, PlayBand]:
    """Return errors of the design's train as given and, if its gears are known, reordered.

    Raises:
        DesignError: the design has no play.
    """
    bands = variation.play_bands(design)
    if not bands:
        raise DesignError(
            "the design says nothing of the gears' play, which this needs: add [train] with the gears, or [play] with "
            "measured_deg or least_deg and greatest_deg; --profile actual makes the cam without"
        )
    return bands
