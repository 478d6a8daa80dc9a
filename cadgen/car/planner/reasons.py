"""Why a course cannot be driven: which limit, where, by how much, and the least change that would do.

Each limit that the best path violates is made loose in turn: violations of it become cheap, those of the others stay
dear. If all others can be kept then, what is left of the violation is how far this one must give way.
"""

from dataclasses import dataclass, replace

import numpy as np

from cadgen.car.planner.plan import UNEVEN, Plan, left, search_of
from cadgen.car.planner.rows import Limit, LimitKind
from cadgen.car.planner.search import Path

_QUIET = 1e-3  # of the spread of the play: here only limits count
# Amounts of which each is about as much to ask as the other: shares of the limits of steering and cam, mm, rad.
_SHARE, _LENGTH, _GATE, _CLEARANCE, _HEADING = 0.15, 500.0, 60.0, 30.0, 0.2
_UNITS = {
    LimitKind.LENGTH: _LENGTH,
    LimitKind.NEAR: _GATE,
    LimitKind.GATE: _GATE,
    LimitKind.HEADING: _HEADING,
    LimitKind.CLEARANCE: _CLEARANCE,
    LimitKind.FIELD: _CLEARANCE,
}
_TIGHT = 0.05  # of the greatest curvature, beyond it
_MOST = 4  # limits that are tried
_ROUNDS = 30  # of each penalty
_NEARLY = 0.02  # as `left`, of the other limits: how far one must give way is wanted to a percent or so


@dataclass(frozen=True)
class Reason:
    """A limit that must give way.

    Attributes:
        limit: limit that must give way.
        amount: by how much, as a share of the limits of steering and cam, else in mm or rad.
        place: where, as [x, y] of the planned point, mm.
        enough: whether all other limits can be kept then.
    """

    limit: Limit
    amount: float
    place: tuple[float, float]
    enough: bool

    @property
    def effort(self) -> float:
        """How much that is to ask, to compare limits of different kinds."""
        return self.amount / _unit(self.limit)


def _unit(limit: Limit) -> float:
    return _UNITS.get(limit.kind, _SHARE)


def reasons(plan: Plan) -> tuple[Reason, ...]:
    """Limits of which each must give way for a course to be drivable, the one with the least to ask first.

    Where no single one is enough, a turn or else the most violated of them stands first.

    Args:
        plan: best path, which violates some limits.
    """
    missed = sorted(plan.missed, key=lambda limit: -plan.missed[limit] / _unit(limit))
    tried = list(dict.fromkeys([*missed[: _MOST - 1], Limit(LimitKind.TURN)]))
    candidates = [reason for limit in tried if (reason := _loosened(plan, limit)) is not None]
    enough = [reason for reason in candidates if reason.enough]
    if not enough:  # then the limit that is beyond reach by most; a turn that is too tight brings others with it
        return tuple(sorted(candidates, key=lambda reason: (not _tight(reason), -reason.effort)))
    return tuple(sorted(enough, key=lambda reason: reason.effort))


def _tight(reason: Reason) -> bool:
    return reason.limit.kind == LimitKind.TURN and reason.amount > _TIGHT


def _loosened(plan: Plan, limit: Limit) -> Reason | None:
    """Amount by which a limit must give way when all others are kept; None if it need not."""
    vehicle = replace(plan.task.vehicle, spread=plan.task.vehicle.spread * _QUIET)
    search = search_of(replace(plan.task, vehicle=vehicle), len(plan.path.points), loose=limit)
    path = search.best(plan.begin, rounds=_ROUNDS)  # the best path may be crumpled
    violated = path.violated
    others = [
        most for other, most in violated.items() if other != limit and other.kind not in UNEVEN and most > _NEARLY
    ]
    amount = violated.get(limit, 0.0)
    if amount <= left(limit):
        return None if not others else Reason(limit, plan.missed.get(limit, amount), _place(plan.path, limit), False)
    return Reason(limit, amount, _place(path, limit), not others)


def _place(path: Path, limit: Limit) -> tuple[float, float]:
    rows = [rows for rows in path.rows if rows.limit == limit and len(rows.values)]
    if not rows:
        return (0.0, 0.0)
    worst = max(rows, key=lambda each: each.worst)
    motion = path.cost.line.motion
    u = float(worst.u[int(worst.values.argmax())])
    x, y = motion.jets[0][int(np.abs(motion.places.u - u).argmin())].tolist()
    return x, y
