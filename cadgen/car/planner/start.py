"""The path that the search begins with: smooth, through the gates or near them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.planner.basis import Basis
from cadgen.car.planner.motion import Motion

# What counts alike: so many mm off a stop, off another place of the route, and so great a third derivative (mm for each
# span to the third).
_STOP, _PLACE, _BEND = 3.0, 60.0, 100.0
# Stops that are close to each other make the path swing far out if it is to pass them so near; then it need not.
_STOPS, _MOST_SWING = (_STOP, 20.0, _PLACE), 1.5  # mm; times the length of the route
_SURE = 1e4  # weight of what must be kept
_ROUNDS = 4  # in which the parameters of the points follow the length of the path
_EACH = 8


@dataclass(frozen=True, eq=False)
class End:
    """Start or finish of a path.

    Attributes:
        place: where it is, mm; None if that is free.
        heading: direction of travel, rad; None if that is free.
    """

    place: Array | None = None
    heading: float | None = None


def smooth_path(
    basis: Basis, route: Array, is_stop: NDArray[np.bool_], start: End, finish: End, calmness: float = 1.0
) -> Array:
    """Control points of a smooth path that passes near the points of a route, shape (n, 2), mm.

    Args:
        basis: B-splines of the path.
        route: points to pass, those of start and finish among them, shape (k, 2), mm.
        is_stop: which of them are stops, that the path passes more closely, shape (k,).
        start: start, whose place and heading the path keeps.
        finish: finish, likewise.
        calmness: so many times as much a bend counts; with more than 1 stops count like other places.
    """
    points = np.zeros((basis.count, 2))
    for stop in _STOPS if calmness == 1 else _STOPS[-1:]:
        weight = np.where(is_stop, 1 / stop, 1 / _PLACE) / calmness
        points, swing = _settled(basis, route, weight, (start, finish))
        if swing <= _MOST_SWING:
            break
    return points


def _settled(basis: Basis, route: Array, weight: Array, ends: tuple[End, End]) -> tuple[Array, float]:
    """Control points of a path whose parameter follows its length, and its length by that of the route."""
    legs = np.linalg.norm(np.diff(route, axis=0), axis=1)
    u = np.append(0.0, np.cumsum(legs)) / legs.sum() * basis.stop
    length = float(legs.sum())
    points = np.zeros((basis.count, 2))
    fine = basis.even(_EACH)
    for _ in range(_ROUNDS):
        points = _fitted(basis, route, weight, u, ends, length)
        motion = Motion(fine, points, 0.0)
        arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(motion.jets[0], axis=0), axis=1)))
        length = float(arc[-1])
        # Each point of the route at the same share of the length as before, and the parameter in step with the length.
        u = np.interp(u, fine.u, arc) / length * basis.stop
    return points, length / float(legs.sum())


def _fitted(basis: Basis, route: Array, weights: Array, u: Array, ends: tuple[End, End], length: float) -> Array:
    n, step = basis.count, length / basis.stop
    even, at = basis.even(2), basis.at(u)
    calm, near = _dense(basis, even.columns, even.values[3]), _dense(basis, at.columns, at.values[0])
    weight = weights[:, None]
    rows = [weight * near, calm / _BEND]
    right = [weight * route, np.zeros((len(calm), 2))]
    if basis.closed:
        rows, right = [*rows, *_held(basis, ends[0], step)[0]], [*right, *_held(basis, ends[0], step)[1]]
    for number, end in () if basis.closed else ((0, ends[0]), (n - 1, ends[1])):
        inner = 1 if number == 0 else n - 2
        if end.place is not None:
            row = np.zeros((1, n))
            row[0, number] = _SURE
            rows.append(row)
            right.append(_SURE * end.place[None])
        if end.heading is not None:
            # The first leg of a clamped B-spline of degree 5 is a fifth of the slope.
            row = np.zeros((1, n))
            row[0, [number, inner]] = -_SURE, _SURE
            leg = step / 5 * np.array([np.cos(end.heading), np.sin(end.heading)]) * (1 if number == 0 else -1)
            rows.append(row)
            right.append(_SURE * leg[None])
    solution, *_ = np.linalg.lstsq(np.vstack(rows), np.vstack(right), rcond=None)
    return np.asarray(solution)


def _held(basis: Basis, start: End, step: float) -> tuple[list[Array], list[Array]]:
    """Equations that hold the start of a closed path, and their right sides."""
    rows, right = [], []
    if start.place is not None:
        rows.append(_SURE * _dense(basis, basis.first.columns, basis.first.values[0]))
        right.append(_SURE * start.place[None])
    if start.heading is not None:
        rows.append(_SURE * _dense(basis, basis.first.columns, basis.first.values[1]))
        right.append(_SURE * step * np.array([[np.cos(start.heading), np.sin(start.heading)]]))
    return rows, right


def fitted_to(basis: Basis, curve: Array) -> Array:
    """Control points of the path nearest to a curve, shape (n, 2), mm.

    Args:
        basis: B-splines of the path.
        curve: points of the curve at even arc lengths, many more than `basis.count`, shape (m, 2), mm.
    """
    at = basis.at(np.linspace(0.0, basis.stop, len(curve)))
    matrix = _dense(basis, at.columns, at.values[0])
    ends = _SURE * matrix[[0, -1]]
    solution, *_ = np.linalg.lstsq(np.vstack([matrix, ends]), np.vstack([curve, _SURE * curve[[0, -1]]]), rcond=None)
    return np.asarray(solution)


def _dense(basis: Basis, columns: NDArray[np.intp], values: Array) -> Array:
    matrix = np.zeros((len(values), basis.count))
    np.put_along_axis(matrix, columns, values, axis=1)
    return matrix
