"""From the path that a search begins with to the best one: a row of linear programmes in a trust region."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.car.planner.basis import Basis
from cadgen.car.planner.limits import driving_rows, even_rows, length_rows
from cadgen.car.planner.motion import Motion
from cadgen.car.planner.programme import Fixed, best_step
from cadgen.car.planner.rows import Limit, Rows
from cadgen.car.planner.sensitivity import Line, Sensitivity
from cadgen.car.planner.task import Task

EACH = 8  # places of a span at which the limits are held; an even number, for Simpson's rule
# Penalties in turn: first the search may go through what is not allowed, at last it hardly may.
_PENALTIES = (1.0, 10.0, 100.0)
_FIRST_STEPS = (60.0, 10.0, 10.0)  # mm
_MOST_ROUNDS = 40  # of each penalty
_LEAST_STEP, _WIDEST_STEP = 0.05, 150.0  # mm
_LEAST_GAIN = 0.02  # mm of the cost
_SHRINK, _GROW = 1 / 3, 2.0
_LOOSE = 3e-3  # of the weight of a limit that is to give way
_POOR, _GOOD = 0.25, 0.7  # shares of the promised gain

# Limits that depend on the course: rows for the control points.
CourseRows = Callable[[Array], list[Rows]]


@dataclass(frozen=True, eq=False)
class Path:
    """A path with what it costs and what it violates.

    Attributes:
        points: control points, shape (n, 2), mm.
        cost: what the play costs.
        rows: all limits.
    """

    points: Array
    cost: Sensitivity
    rows: tuple[Rows, ...]

    def total(self, penalty: float) -> float:
        """Cost with penalties, mm.

        Args:
            penalty: factor of the cost of what is violated.
        """
        return self.cost.cost + penalty * sum(rows.weight * rows.violation for rows in self.rows)

    @property
    def violated(self) -> dict[Limit, float]:
        """Most by which each limit is violated, of those that are."""
        worst: dict[Limit, float] = {}
        for rows in self.rows:
            if rows.worst > 0:
                worst[rows.limit] = max(worst.get(rows.limit, 0.0), rows.worst)
        return worst


@dataclass(frozen=True, eq=False)
class Search:
    """The search of a task with control points of a certain number.

    Attributes:
        task: what is planned.
        basis: B-splines of the path.
        fixed: what of the control points stays as it is.
        course_rows: limits that depend on the course.
        loose: limit that may be violated at little cost; None if there is none.
    """

    task: Task
    basis: Basis
    fixed: Fixed
    course_rows: CourseRows
    loose: Limit | None = None

    def path(self, points: Array) -> Path:
        """A path by its control points, shape (n, 2), mm.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        vehicle, limits = self.task.vehicle, self.task.limits
        motion = Motion(self.basis.even(EACH), points, vehicle.path_offset)
        line = Line(motion, vehicle)
        rows = [
            *driving_rows(motion, line, vehicle, limits),
            *even_rows(motion),
            *length_rows(line, vehicle, 2 * self.basis.count),
            *self.course_rows(points),
        ]
        if self.loose is not None:
            rows = [replace(each, weight=each.weight * _LOOSE) if each.limit == self.loose else each for each in rows]
        return Path(points, Sensitivity(line, vehicle.spread), tuple(rows))

    def best(self, points: Array, report: Callable[[float], None] | None = None, *, rounds: int = _MOST_ROUNDS) -> Path:
        """The best path from one to begin with.

        Args:
            points: control points to begin with, shape (n, 2), mm; what is fixed is right already.
            report: function that is called with the cost as it falls.
            rounds: most programmes that are solved with each penalty.
        """
        path = self.path(points)
        for penalty, step in zip(_PENALTIES, _FIRST_STEPS, strict=True):
            path = self._descend(path, penalty, step, report, rounds)
        return path

    def _descend(
        self, path: Path, penalty: float, step: float, report: Callable[[float], None] | None, rounds: int
    ) -> Path:
        for _ in range(rounds):
            total = path.total(penalty)
            try:
                change, promised = best_step(path.cost, list(path.rows), penalty, step, self.fixed)
            except ArithmeticError:
                step *= _SHRINK
                continue
            gain = total - promised
            moved = self.path(path.points + change)
            share = (total - moved.total(penalty)) / gain if gain > 0 else 0.0
            if share > 0:
                path = moved
                if report is not None:
                    report(path.cost.distance)
            if share < _POOR:
                step *= _SHRINK
            elif share > _GOOD:
                step = min(step * _GROW, _WIDEST_STEP)
            if step < _LEAST_STEP or gain < _LEAST_GAIN:
                break
        return path


def fixed_start(basis: Basis, start: tuple[bool, float | None]) -> Fixed:
    """Equations that hold the start of a closed path; arguments as in `fixed_ends`."""
    held, heading = start
    columns, values = basis.first.columns[0], basis.first.values[:, 0]
    rows = []
    for axis in (0, basis.count) if held else ():
        row = np.zeros(2 * basis.count)
        row[axis + columns] = values[0]
        rows.append(row)
    if heading is not None:
        row = np.zeros(2 * basis.count)
        row[columns] = -np.sin(heading) * values[1]
        row[basis.count + columns] = np.cos(heading) * values[1]
        rows.append(row)
    return Fixed(np.array(rows).reshape(-1, 2 * basis.count))


def fixed_ends(count: int, start: tuple[bool, float | None], finish: tuple[bool, float | None]) -> Fixed:
    """Equations that hold the ends of a path.

    Args:
        count: number of control points.
        start: whether the place of the start stays, and its heading; None if that is free.
        finish: the same of the finish.
    """
    rows = []
    for (held, heading), number, inner in ((start, 0, 1), (finish, count - 1, count - 2)):
        if held:
            for axis in (0, count):
                row = np.zeros(2 * count)
                row[axis + number] = 1.0
                rows.append(row)
        if heading is not None:
            row = np.zeros(2 * count)
            row[[inner, number]] = -np.sin(heading), np.sin(heading)
            row[[count + inner, count + number]] = np.cos(heading), -np.cos(heading)
            rows.append(row)
    return Fixed(np.array(rows).reshape(-1, 2 * count))
