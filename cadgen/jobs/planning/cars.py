"""Cars within the tolerances on planned paths: how many keep the course, and how much room they need.

A plan by play alone passes gates at their edges, where half of the cars miss each. So paths are planned with room for
some times the scatter of where the cars pass, and the one counts on which most cars keep the course.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from cadgen.design.schema import Design
from cadgen.errors import CadgenError
from cadgen.inference.monte_carlo.random_cars import margins_of_cars
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import CarUse, plan_cam
from cadgen.jobs.nominal_car import watched_cars
from cadgen.jobs.tolerance import CarSample, ToleranceRun, tolerance_of
from cadgen.progress import Progress

# Reserves that are tried one after the other as long as they help, two in any case: factors on the scatter.
REFINED: tuple[float, ...] = (1.0, 2.0, 3.0, 4.0, 5.0)
ALL = 0.999  # share of the cars that leaves nothing to gain
_AS_GOOD, _GAIN = 0.0005, 0.002  # of the cars: one of the few of a search; less than this is no reason to go on
_FEW, _MANY, _SEED = 2000, 10_000, 1  # cars of a search, and of its result: those of `cadgen tolerance`


@dataclass(frozen=True)
class Tried:
    """Cars on a path that was planned with a reserve.

    Attributes:
        factor: reserve, in units of the scatter.
        kept: share of the cars that keep the course.
        alone: share of the cars that keep each gate and obstacle alone, by its key.
        scatter: root mean square of how far from the planned run the cars pass each, by its key, mm.
        worst: worst position at the end of the run over the band of play, mm.
    """

    factor: float
    kept: float
    alone: Mapping[str, float]
    scatter: Mapping[str, float]
    worst: float

    def spare(self, factor: float) -> dict[str, float]:
        """Room for the scatter of the cars, by the keys of gates and obstacles, mm.

        Args:
            factor: reserve, as a factor on the scatter of the cars, dimensionless.
        """
        return {key: factor * off for key, off in self.scatter.items()}


@dataclass(frozen=True)
class CarsOnPaths:
    """Cars on the path that was chosen, beside others.

    Attributes:
        tried: all paths that were tried, the chosen one among them.
        number: number of the chosen one.
        after: many cars on it.
        before: many cars on the path that it takes the place of; None without, or if that cannot be driven.
    """

    tried: tuple[Tried, ...]
    number: int
    after: ToleranceRun[CamPlan]
    before: ToleranceRun[CamPlan] | None

    @property
    def chosen(self) -> Tried:
        """The path that was chosen."""
        return self.tried[self.number]

    @property
    def fewer(self) -> bool:
        """Whether fewer cars keep the course than on the path before."""
        return self.share_before is not None and self.share < self.share_before

    @property
    def share(self) -> float:
        """Share of the cars that keep the course on the path that was chosen, 0 to 1."""
        return self.after.passed or 0.0

    @property
    def share_before(self) -> float | None:
        """Share of the cars that keep it on the path before, 0 to 1; None without such a path."""
        return None if self.before is None else self.before.passed

    @property
    def binding(self) -> tuple[str, float]:
        """Key of what fewest cars keep, and their share."""
        return min(self.chosen.alone.items(), key=lambda pair: pair[1])


def tried(cam: CamPlan, factor: float) -> Tried | None:
    """Cars on a path that was planned with a reserve; None if nothing varies or they are held against nothing.

    Args:
        cam: plan of its cam, with all checks.
        factor: reserve, as a factor on the scatter of the cars.

    Raises:
        DesignError: a tolerance is too large to reckon with.
    """
    use = CarUse.of(cam)
    if use.comparison is None or use.course is None:
        return None
    cars = watched_cars(use, cam.curve)
    if not cars.items:
        return None
    seen = margins_of_cars(cars, use.tolerances(), _FEW, seed=_SEED)
    alone: dict[str, float] = {}
    scatter: dict[str, float] = {}
    margins = seen.margins
    for watch, margin, aside in zip(cars.items, margins, seen.distance, strict=True):
        key = watch.key.partition(",")[0]  # of a gate of each lap
        alone[key] = min(float(np.mean(margin >= 0)), alone.get(key, 1.0))
        scatter[key] = max(float(np.sqrt(np.mean(aside**2))), scatter.get(key, 0.0))
    if not any(scatter.values()):
        return None
    kept = float(np.mean(margins.min(axis=0) >= 0))
    return Tried(factor, kept, alone, scatter, use.comparison.chosen.band.worst_distance)


def saturated(paths: Sequence[Tried]) -> bool:
    """Whether more room will not make more cars keep the course."""
    last = paths[-1].kept
    return last >= ALL or (len(paths) > 2 and last <= paths[-2].kept + _GAIN)


def best(paths: Sequence[Tried]) -> int:
    """Number of the path on which most cars keep the course; of equals that which play moves least."""
    most = max(each.kept for each in paths)
    good = [number for number, each in enumerate(paths) if each.kept >= most - _AS_GOOD]
    return min(good, key=lambda number: paths[number].worst)


def cars_on(
    cam: CamPlan, replaced: Design | None, paths: Sequence[Tried], number: int, progress: Progress
) -> CarsOnPaths:
    """Many cars on the path that was chosen, and on the one before.

    Args:
        cam: plan of its cam.
        replaced: design with the path before; None without.
        paths: all that were tried.
        number: number of the chosen one.
        progress: function that is called with a few words on each step.
    """
    before = None
    if replaced is not None:
        try:
            before = tolerance_of(plan_cam(replaced, None, progress), CarSample(samples=_MANY, seed=_SEED), progress)
        except CadgenError:  # a path that no car drives has no yield
            before = None
    return CarsOnPaths(tuple(paths), number, tolerance_of(cam, CarSample(samples=_MANY, seed=_SEED), progress), before)
