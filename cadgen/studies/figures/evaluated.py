"""A design with everything that its figures are computed from, computed when it is first asked for."""

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

from cadgen.car.against_play.band import PlayBand
from cadgen.car.path.track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design
from cadgen.jobs.cam.comparison import known_trains
from cadgen.jobs.cam.plan import CamPlan, plan_cam
from cadgen.jobs.runs.tolerance import CarSample, ToleranceRun, tolerance_of


class Evaluated:
    """A design of a study.

    Args:
        values: value of each varied key.
        read: function that reads the design, checked.
        profile: profile of the cam; that of `cadgen cam` if None.
        cars: number of random cars.
        seed: seed of the random cars, the same for all designs, so that they differ by design alone.
    """

    def __init__(
        self, values: Mapping[str, Any], read: Callable[[], Design], profile: str | None, cars: int, seed: int
    ) -> None:
        self.values, self._read, self._profile, self._cars, self._seed = values, read, profile, cars, seed

    @cached_property
    def design(self) -> Design:
        """The design, checked by its schema."""
        return self._read()

    @cached_property
    def track(self) -> Track:
        """Track of the drive wheel."""
        return cam_model.track(self.design)

    @cached_property
    def lift(self) -> PathMotion:
        """Planned lift."""
        return cam_model.lift(self.design, self.track)

    @cached_property
    def band(self) -> PlayBand:
        """Return error of the train that the design is made for."""
        return known_trains(self.design)[self.design.optimize.order]

    @cached_property
    def plan(self) -> CamPlan:
        """Cam with all its checks, compared under play."""
        return plan_cam(self.design, self._profile, with_play=bool(variation.play_bands(self.design)))

    @cached_property
    def tolerance(self) -> ToleranceRun:
        """Random cars with that cam."""
        return tolerance_of(self.plan, CarSample(samples=self._cars, seed=self._seed))
