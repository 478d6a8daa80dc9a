"""One linear programme: the step of the control points that lowers cost and violations most, within a trust region.

    minimise    z + sum calm p_j + sum weight_i e_i
    subject to  z >= error along each direction:  sum_j f lever_j p_j + (derivative by the levers) dx
                p_j >= rise_j + rises'_j dx,  p_j >= 0          the lift falls, or it does not
                e_i >= value_i + value'_i dx, e_i >= 0          a limit is kept, or violated by e_i
                |dx| <= step,  what is fixed stays fixed

Where the lever of a fall points against the error a fall would lower it, and a programme would make one of nothing; the
change of such a fall counts as it is.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog
from scipy.sparse import csr_array, eye_array, hstack, vstack

from cadgen.arrays import Array
from cadgen.car.planner.rows import Rows
from cadgen.car.planner.sensitivity import Sensitivity

_SCALE = 1e3  # curvature in 1/m, so that all numbers of a programme are of one size
# A programme takes some 500. Where next to nothing costs anything the dual simplex may turn in circles for ever.
_MOST_PIVOTS = 20_000


@dataclass(frozen=True, eq=False)
class Fixed:
    """Linear equations that the control points must keep: matrix @ step = 0.

    Attributes:
        matrix: shape (k, 2 n), for all x and then all y.
    """

    matrix: Array


def best_step(cost: Sensitivity, rows: list[Rows], penalty: float, step: float, fixed: Fixed) -> tuple[Array, float]:
    """Return the step of the control points, shape (n, 2), mm, and the cost with penalties that it promises.

    Args:
        cost: what the play costs now.
        rows: limits at the places where a step can come to them.
        penalty: factor on the weights of the limits.
        step: greatest change of a coordinate, mm.
        fixed: what stays as it is.

    Raises:
        ArithmeticError: the solver gave up.
    """
    points = 2 * cost.line.motion.places.count
    intervals = len(cost.rises)
    rows = [kept for each in rows if len((kept := each.reachable(step)).values)]
    beyond = sum(len(each.values) for each in rows)
    # Variables: points, falls, the error, violations.
    columns, slopes = cost.by_rises()
    by_rise = _sparse(columns, slopes * _SCALE, points)
    blocks = [hstack([by_rise, -eye_array(intervals), csr_array((intervals, 1 + beyond))])]
    bounds_above = [-cost.rises * _SCALE]
    directed, least = _directed(cost, by_rise, beyond)
    blocks.append(directed)
    bounds_above.append(least)
    weights = np.zeros(0)
    if rows:
        matrix = vstack([each.matrix(points) for each in rows])
        blocks.append(hstack([matrix, csr_array((beyond, intervals + 1)), -eye_array(beyond)]))
        bounds_above.append(-np.concatenate([each.values for each in rows]))
        weights = penalty * np.concatenate([np.full(len(each.values), each.weight) for each in rows])
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


def _directed(cost: Sensitivity, by_rise: csr_array, beyond: int) -> tuple[csr_array, Array]:
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


def _sparse(columns: NDArray[np.intp], values: Array, width: int) -> csr_array:
    """A sparse matrix of rows with their columns, which may stand twice."""
    count, each = values.shape
    number = np.repeat(np.arange(count), each)
    return csr_array((values.ravel(), (number, columns.ravel())), shape=(count, width))
