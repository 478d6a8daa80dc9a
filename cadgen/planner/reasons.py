"""Why a course cannot be driven: which limit, where, by how much, and the least change that would do.

Each limit that the best path violates is made loose in turn: violations of it become cheap, those of the others stay
dear. If all others can be kept then, what is left of the violation is how far this one must give way.
"""

from dataclasses import dataclass, replace

import numpy as np

from cadgen.planner.plan import KEPT, UNEVEN, Plan, search_of
from cadgen.planner.search import Path

_QUIET = 1e-3  # of the spread of the play: here only limits count
# Amounts of which each is about as much to ask as the other: shares of the limits of steering and cam, mm, rad.
_SHARE, _LENGTH, _GATE, _CLEARANCE, _HEADING = 0.15, 500.0, 60.0, 30.0, 0.2
_DRIVING = ("turn", "pressure angle", "convex radius", "valley", "slope", "bend")
_TIGHT = 0.05  # of the greatest curvature, beyond it
_MOST = 4  # limits that are tried
_ROUNDS = 30  # of each penalty
_NEARLY = 0.02  # as KEPT, of the other limits: how far one must give way is wanted to a percent or so


@dataclass(frozen=True)
class Reason:
    """A limit that must give way.

    Attributes:
        limit: name of the limit: one of `turn`, `pressure angle`, `convex radius`, `valley`, `slope`, `bend`, `length`,
            `near`, or the key of a gate or an obstacle, with ` heading` behind it for a direction.
        amount: by how much, as a share of the limits of steering and cam, else in mm or rad.
        place: where, as [x, y] of the planned point, mm.
        enough: whether all other limits can be kept then.
    """

    limit: str
    amount: float
    place: tuple[float, float]
    enough: bool

    @property
    def effort(self) -> float:
        """How much that is to ask, to compare limits of different kinds."""
        return self.amount / _unit(self.limit)


def _unit(limit: str) -> float:
    if limit in _DRIVING:
        return _SHARE
    if limit == "length":
        return _LENGTH
    if limit.endswith("heading"):
        return _HEADING
    return _GATE if limit.startswith(("course.gates", "course.start", "course.finish", "near")) else _CLEARANCE


def reasons(plan: Plan) -> tuple[Reason, ...]:
    """Limits of which each must give way for a course to be drivable, the one with the least to ask first.

    Where no single one is enough, a turn or else the most violated of them stands first.

    Args:
        plan: best path, which violates some limits.
    """
    missed = sorted(plan.missed, key=lambda name: -plan.missed[name] / _unit(name))
    tried = list(dict.fromkeys([*missed[: _MOST - 1], "turn"]))
    candidates = [reason for name in tried if (reason := _loosened(plan, name)) is not None]
    enough = [reason for reason in candidates if reason.enough]
    if not enough:  # then the limit that is beyond reach by most; a turn that is too tight brings others with it
        return tuple(sorted(candidates, key=lambda reason: (not _tight(reason), -reason.effort)))
    return tuple(sorted(enough, key=lambda reason: reason.effort))


def _tight(reason: Reason) -> bool:
    return reason.limit == "turn" and reason.amount > _TIGHT


def _loosened(plan: Plan, name: str) -> Reason | None:
    """Amount by which a limit must give way when all others are kept; None if it need not."""
    vehicle = replace(plan.task.vehicle, spread=plan.task.vehicle.spread * _QUIET)
    search = search_of(replace(plan.task, vehicle=vehicle), len(plan.path.points), loose=name)
    path = search.best(plan.begin, rounds=_ROUNDS)  # the best path may be crumpled
    violated = path.violated
    others = [most for other, most in violated.items() if other not in (name, *UNEVEN) and most > _NEARLY]
    amount = violated.get(name, 0.0)
    if amount <= KEPT:
        return None if not others else Reason(name, plan.missed.get(name, amount), _place(plan.path, name), False)
    return Reason(name, amount, _place(path, name), not others)


def _place(path: Path, name: str) -> tuple[float, float]:
    rows = [rows for rows in path.rows if rows.name == name and len(rows.values)]
    if not rows:
        return (0.0, 0.0)
    worst = max(rows, key=lambda each: each.worst)
    motion = path.cost.line.motion
    u = float(worst.u[int(worst.values.argmax())])
    x, y = motion.jets[0][int(np.abs(motion.places.u - u).argmin())].tolist()
    return x, y
