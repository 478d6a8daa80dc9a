"""Checks of profiles that were evaluated against play, each computed once."""

from dataclasses import dataclass, field
from math import degrees, inf

import numpy as np

from cadgen.cam.checks import check_cam
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.path_motion import blend_checks
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import cam_model
from cadgen.design.schema import Design
from cadgen.jobs.cam.mechanics import mechanics_checks


@dataclass(frozen=True)
class ProfileChecks:
    """Checks of the profiles of one design; they take time, so they are computed once for a profile on a train.

    Attributes:
        design: loaded design.
        task: lift wanted, car and follower of the design.
    """

    design: Design
    task: PlayTask
    _computed: dict[str, tuple[Check, ...]] = field(default_factory=dict, repr=False)
    _allowed: list[float] = field(default_factory=list, repr=False)

    def allow_lift_error(self, most: float) -> None:
        """Let profiles miss the lift with play by so much, instead of by what the design says.

        Args:
            most: greatest lift error, um.
        """
        self._allowed[:] = [most]
        self._computed.clear()

    def of(self, evaluation: Evaluation) -> tuple[Check, ...]:
        """Every check of a profile."""
        if evaluation.name not in self._computed:
            self._computed[evaluation.name] = self._compute(evaluation)
        return self._computed[evaluation.name]

    def _compute(self, evaluation: Evaluation) -> tuple[Check, ...]:
        design, wanted = self.design, evaluation.wanted
        rod, blank, limits = cam_model.follower(design), cam_model.blank(design), cam_model.check_limits(design)
        return (
            *check_cam(
                evaluation.lift,
                rod,
                wanted.curve,
                wanted.trims,
                blank,
                limits,
                cut=evaluation.cut,
                application=blend_checks,
            ),
            _lift_check(evaluation, (*self._allowed, design.optimize.max_lift_error_um)[0]),
            *mechanics_checks(design, rod, evaluation.lift, self.task.mechanics),
        )


def _lift_check(evaluation: Evaluation, most: float | None) -> Check:
    """Check of the lift that the follower gets with play against the lift wanted; `most` in um, None for any."""
    where = float(evaluation.run.motor[np.argmax(np.abs(evaluation.lift_error))])
    return Check(
        CheckCode.LIFT_ERROR_WITH_PLAY,
        "lift error with play",
        evaluation.worst_lift_error * 1e3,
        "µm",
        inf if most is None else most,
        Bound.MAX,
        f"motor {degrees(where):.2f}° (play {degrees(evaluation.play):.3f}°)",
        "the profile leaves the planned path: use --profile compensated, or raise optimize.max_lift_error_um",
    )
