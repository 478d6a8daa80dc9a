"""Search for the best path: a sequence of linear programmes in a trust region.

Each programme finds the step of the control points that lowers cost and violations most.

    minimise    z + sum calm p_j + sum weight_i e_i
    subject to  z >= sum_j f lever_j p_j + (derivative by the levers) dx
                p_j >= rise_j + rises'_j dx,  p_j >= 0
                e_i >= value_i + value'_i dx, e_i >= 0
                |dx| <= step.

The first row is the error along each direction. In the second the lift falls, or it does not; in the third a limit is
kept, or violated by e_i. What is fixed stays fixed.
Where the lever of a fall points against the error a fall would lower it, and a programme would make one of nothing; the
change of such a fall counts as it is.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import csr_array, eye_array, hstack, vstack

from cadgen.arrays import Array
from cadgen.car.planner.constraints import (
    Constraint,
    LimitKind,
    PathLimit,
    driving_constraints,
    evenness_constraints,
    length_constraints,
)
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import PathTask
from cadgen.car.planner.sensitivity import PlayCost, TrackLength

_SCALE = 1e3  # curvature in 1/m, so that all numbers of a programme are of one size
# A programme takes some 500. Where next to nothing costs anything the dual simplex may turn in circles for ever.
_MOST_PIVOTS = 20_000


@dataclass(frozen=True, eq=False)
class Fixed:
    """Linear equations that every step of the control points keeps: matrix @ step = 0.

    Attributes:
        matrix: shape (k, 2 n), for all x and then all y.
    """

    matrix: Array


def weight(constraint: Constraint, penalty: float) -> float:
    """Cost of a violation by one, mm of the end of the run.

    Args:
        constraint: whose weight counts; that of a distance which is kept besides grows up to the usual penalty alone.
        penalty: factor on its weight.
    """
    return constraint.weight * (min(penalty, _PENALTIES[-1]) if constraint.limit.spare else penalty)


def best_step(
    cost: PlayCost, constraints: list[Constraint], penalty: float, step: float, fixed: Fixed
) -> tuple[Array, float]:
    """Return the step of the control points, shape (n, 2), mm, and the cost with penalties that it promises.

    Args:
        cost: what the play costs now.
        constraints: constraints of the path, of which those count that a step can come to.
        penalty: factor on the weights of the limits.
        step: greatest change of a coordinate, mm.
        fixed: what stays as it is.

    Raises:
        ArithmeticError: the solver gave up.
    """
    points = 2 * cost.line.motion.places.count
    intervals = len(cost.rises)
    constraints = [kept for each in constraints if len((kept := each.reachable(step)).values)]
    # A violation for each place, and one for all places of a distance that is kept besides.
    sizes = [1 if each.limit.spare else len(each.values) for each in constraints]
    beyond = sum(sizes)
    # Variables: points, falls, the error, violations.
    columns, slopes = cost.by_rises()
    # Entries of a column that stands twice add up.
    rows = np.repeat(np.arange(len(slopes)), slopes.shape[1])
    by_rise = csr_array(((slopes * _SCALE).ravel(), (rows, columns.ravel())), shape=(len(slopes), points))
    blocks = [hstack([by_rise, -eye_array(intervals), csr_array((intervals, 1 + beyond))])]
    bounds_above = [-cost.rises * _SCALE]
    directed, least = _directed(cost, by_rise, beyond)
    blocks.append(directed)
    bounds_above.append(least)
    weights = np.zeros(0)
    if constraints:
        matrix = vstack([each.matrix(points) for each in constraints])
        values = np.concatenate([each.values for each in constraints])
        rows, columns = (
            np.arange(len(values)),
            np.concatenate(
                [
                    first + np.arange(len(each.values)) % size
                    for each, size, first in zip(constraints, sizes, np.cumsum([0, *sizes]), strict=False)
                ]
            ),
        )
        violated = csr_array((np.ones(len(values)), (rows, columns)), shape=(len(values), beyond))
        blocks.append(hstack([matrix, csr_array((len(values), intervals + 1)), -violated]))
        bounds_above.append(-values)
        weights = np.repeat([weight(each, penalty) for each in constraints], sizes)
    objective = np.concatenate([np.zeros(points), np.full(intervals, cost.calm / _SCALE), [1.0], weights])
    low = np.concatenate([np.full(points, -step), np.zeros(intervals + 1 + beyond)])
    high = np.concatenate([np.full(points, step), np.full(intervals + 1 + beyond, np.inf)])
    equal = hstack([csr_array(fixed.matrix), csr_array((len(fixed.matrix), intervals + 1 + beyond))], format="csr")
    bounds: Any = np.stack([low, high], axis=1)
    above: Any = vstack(blocks, format="csr")  # the stubs of scipy know no sparse arrays here
    equations: Any = equal if len(fixed.matrix) else None
    result = linprog(
        objective,
        A_ub=above,
        b_ub=np.concatenate(bounds_above),
        A_eq=equations,
        b_eq=np.zeros(len(fixed.matrix)) if len(fixed.matrix) else None,
        bounds=bounds,
        method="highs-ds",
        options={"maxiter": _MOST_PIVOTS},
    )
    if result.status != 0 or result.x is None:
        raise ArithmeticError(str(result.message))
    return np.asarray(result.x[:points].reshape(2, -1).T), float(result.fun or 0.0)


def _directed(cost: PlayCost, by_rise: csr_array, beyond: int) -> tuple[csr_array, Array]:
    """Rows that keep the error above its part in each direction, and their right sides."""
    main = cost.error / max(cost.distance, 1e-12)
    towards = cost.levers @ main > 0
    falling = cost.rises > 0
    rows, right = [], []
    for direction in cost.directions():
        lever = cost.factor * cost.line.driven * (cost.levers @ direction)
        as_it_is = np.where(~towards & falling, lever, 0.0)
        by_points = cost.by_levers(direction) + by_rise.T @ (as_it_is / _SCALE)
        by_falls = np.where(towards, lever / _SCALE, 0.0)
        # The derivative by the levers is about the present path: its value there counts already in the falls.
        rows.append(np.concatenate([by_points, by_falls, [-1.0], np.zeros(beyond)]))
        right.append(-float(as_it_is @ cost.rises))
    return csr_array(np.array(rows)), np.array(right)


EACH = 8  # places of a span at which the limits are held; an even number, for Simpson's rule
# Penalties in turn: first the search may go through what is not allowed, at last it hardly may.
_PENALTIES = (1.0, 10.0, 100.0)
_FIRST_STEPS = (60.0, 10.0, 10.0)  # mm
# Where play costs much by a little steering, a limit gives way even then: a penalty is exact only beyond what it saves.
_MORE_PENALTIES = (1e3, 1e4)
_MORE_STEP = 10.0  # mm
UNEVEN = (LimitKind.FAST, LimitKind.SLOW)  # limits that serve the search alone
_LEFT, _LEFT_MM = 2e-3, 0.01  # of a limit or rad, and mm of a gate or a clearance: what a search may leave
_IN_MM = (LimitKind.GATE, LimitKind.CLEARANCE, LimitKind.FIELD)
_MOST_ROUNDS = 40  # of each penalty
_LEAST_STEP, _WIDEST_STEP = 0.05, 150.0  # mm
_LEAST_GAINS = (1.0, 0.2, 0.02)  # mm of the cost that a programme must promise, with each penalty
_SHRINK, _GROW = 1 / 3, 2.0
_LOOSE = 3e-3  # of the weight of a limit that is to give way
_POOR, _GOOD = 0.25, 0.7  # shares of the promised gain

# Constraints that depend on the course, as a function of the control points.
CourseConstraints = Callable[[Array], list[Constraint]]


def left(limit: PathLimit) -> float:
    """Greatest violation that a search may leave, in the unit of the limit: a share, rad or mm.

    Of a gate and a clearance that is less than is kept from their edges for what happens between the places.

    Args:
        limit: which limit.
    """
    return _LEFT_MM if limit.kind in _IN_MM else _LEFT


@dataclass(frozen=True, eq=False)
class SearchedPath:
    """Path with its cost and its constraints.

    Attributes:
        points: control points, shape (n, 2), mm.
        cost: what the play costs.
        constraints: constraints of all limits.
    """

    points: Array
    cost: PlayCost
    constraints: tuple[Constraint, ...]

    def total(self, penalty: float) -> float:
        """Cost with penalties, mm.

        Args:
            penalty: factor of the cost of what is violated.
        """
        return self.cost.cost + sum(weight(each, penalty) * each.violation for each in self.constraints)

    @property
    def violated(self) -> dict[PathLimit, float]:
        """Greatest violation of each limit that is violated."""
        worst: dict[PathLimit, float] = {}
        for each in self.constraints:
            if each.worst > 0:
                worst[each.limit] = max(worst.get(each.limit, 0.0), each.worst)
        return worst

    @property
    def missed(self) -> dict[PathLimit, float]:
        """Limits that are not kept, with the greatest excess of each."""
        return {
            limit: most
            for limit, most in self.violated.items()
            if most > left(limit) and limit.kind not in UNEVEN and not limit.spare
        }


@dataclass(frozen=True, eq=False)
class PathSearch:
    """Search of a task with a certain number of control points.

    Attributes:
        task: what is planned.
        basis: B-splines of the path.
        fixed: what of the control points stays as it is.
        course_constraints: limits that depend on the course.
        loose: limit that may be violated at little cost; None if there is none.
    """

    task: PathTask
    basis: Basis
    fixed: Fixed
    course_constraints: CourseConstraints
    loose: PathLimit | None = None

    def path(self, points: Array) -> SearchedPath:
        """Path by its control points.

        Args:
            points: control points of the path, shape (n, 2), mm.
        """
        vehicle, limits = self.task.vehicle, self.task.limits
        motion = Kinematics(self.basis.even(EACH), points, vehicle.path_offset)
        line = TrackLength(motion, vehicle)
        constraints = [
            *driving_constraints(motion, line, vehicle, limits),
            *evenness_constraints(motion),
            *length_constraints(line, vehicle, 2 * self.basis.count),
            *self.course_constraints(points),
        ]
        if self.loose is not None:
            constraints = [
                replace(each, weight=each.weight * _LOOSE) if each.limit == self.loose else each for each in constraints
            ]
        return SearchedPath(points, PlayCost(line, vehicle.spread), tuple(constraints))

    def best(
        self, points: Array, report: Callable[[float], None] | None = None, *, rounds: int = _MOST_ROUNDS
    ) -> SearchedPath:
        """Best path found from one to begin with.

        Args:
            points: control points to begin with, shape (n, 2), mm; what is fixed is right already.
            report: function that is called with the cost as it falls.
            rounds: most programmes that are solved with each penalty.
        """
        before = path = self.path(points)
        for penalty, step, least in zip(_PENALTIES, _FIRST_STEPS, _LEAST_GAINS, strict=True):
            before, path = path, self._descend(path, penalty, (step, least), report, rounds)
        for penalty in _MORE_PENALTIES if self.loose is None else ():
            if not path.missed or path is before:  # a path that no step makes better is not by a greater penalty
                break
            before, path = path, self._descend(path, penalty, (_MORE_STEP, _LEAST_GAINS[-1]), report, rounds)
        return path

    def _descend(
        self,
        path: SearchedPath,
        penalty: float,
        first: tuple[float, float],
        report: Callable[[float], None] | None,
        rounds: int,
    ) -> SearchedPath:
        """Path after programmes with a penalty; `first` is the step to begin with and the least gain to go on for."""
        step, least = first
        for _ in range(rounds):
            total = path.total(penalty)
            try:
                change, promised = best_step(path.cost, list(path.constraints), penalty, step, self.fixed)
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
            if step < _LEAST_STEP or gain < least:
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
