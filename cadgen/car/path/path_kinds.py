"""Kinds of path: the keys of the design file and the curve that each kind makes of them.

A new kind is a dataclass of keys and an entry of the registry below, or is registered from outside. The module is light
to import: numerics are imported when a curve is built.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from annotated_types import MaxLen, MinLen

from cadgen.messages import Message
from cadgen.registry import Registry

if TYPE_CHECKING:
    from cadgen.car.path.spline import PlannedPath

# What a cam takes in time and memory: of 10 000 waypoints some half a minute and 0.3 GB, of 1000 kinks half a minute
# and 0.8 GB.
_MOST_WAYPOINTS = 10_000
_MOST_KINKS = 1000

# [x, y] of points, as in a design file.
Points = tuple[tuple[float, float], ...]


@dataclass(frozen=True, kw_only=True)
class PathKind:
    """Kind of path.

    Attributes:
        code: value of `path.spline` in the design file.
        meaning: phrase for the reference, the curve in a few words.
        keys: frozen dataclass of its keys, named as in the file, each `Annotated` with its limits and with a phrase
            for the reference; its `__post_init__` may refuse what contradicts itself by a `ValueError`, one sentence
            for the user.
        build: function of the keys that returns the curve, mm; it raises `DesignError` where there is none.
        build_closed: function for a closed path, whose curve ends as it starts and is as smooth there as elsewhere;
            None for a kind that has none.
    """

    code: str
    meaning: str
    keys: type[Any]
    build: Callable[[Any], PlannedPath]
    build_closed: Callable[[Any], PlannedPath] | None = None


@dataclass(frozen=True, kw_only=True)
class QuinticKeys:
    """Keys of a path through waypoints, as in its file."""

    waypoints_mm: Annotated[
        Points,
        MinLen(4),
        "[x, y] of each waypoint, in the order driven; 10 000 at most, of a cubic 1000, and so smooth that the rod's "
        "contact turns back at 1000 places at most",
    ]

    def __post_init__(self) -> None:
        count = len(self.waypoints_mm)
        if count > _MOST_WAYPOINTS:
            raise ValueError(
                Message(
                    "path.waypoints_mm has {count} waypoints, of which the lift is made piece by piece; at most "
                    "{most} can be followed: keep one in {step}",
                    count=count,
                    most=_MOST_WAYPOINTS,
                    step=-(-count // _MOST_WAYPOINTS),
                )
            )


@dataclass(frozen=True, kw_only=True)
class CubicKeys(QuinticKeys):
    """Keys of a cubic path through waypoints, as in its file."""

    def __post_init__(self) -> None:
        count = len(self.waypoints_mm)
        if count > _MOST_KINKS:
            raise ValueError(
                Message(
                    "path.waypoints_mm has {count} waypoints, and at each a cubic spline has a kink, where the "
                    "profile is joined anew; at most {most} can be followed: keep one in {step}, or set "
                    'path.spline = "quintic"',
                    count=count,
                    most=_MOST_KINKS,
                    step=-(-count // _MOST_KINKS),
                )
            )


@dataclass(frozen=True, kw_only=True)
class BSplineKeys:
    """Keys of a path by control points, as in its file."""

    control_points_mm: Annotated[
        Points,
        MinLen(6),
        MaxLen(10_000),
        "[x, y] of each control point, in the order driven, 10 000 at most. The path is the B-spline of degree 5 with "
        "these n points over the knots 0, 1, 2, ..., n - 5, the first and the last sixfold: it starts on the first "
        "point towards the second, and ends on the last, coming from the one before. Closed, the points follow "
        "each other round and round over the knots 0, 1, 2, ..., n, and the path starts beside the first",
    ]


def _splines() -> Any:
    """Module of the curves, imported when one is built."""
    from cadgen.car.path import spline

    return spline


QUINTIC = PathKind(
    code="quintic",
    meaning="the sixth-order natural spline of the paper's text through waypoints",
    keys=QuinticKeys,
    build=lambda keys: _splines().plan_path(keys.waypoints_mm, "quintic"),
    build_closed=lambda keys: _splines().plan_lap(keys.waypoints_mm),
)
CUBIC = PathKind(
    code="cubic",
    meaning="the cubic of its appendix, whose curvature has kinks",
    keys=CubicKeys,
    build=lambda keys: _splines().plan_path(keys.waypoints_mm, "cubic"),
)
B_SPLINE = PathKind(
    code="b_spline",
    meaning="a B-spline of degree 5 by control points, which `cadgen plan` writes",
    keys=BSplineKeys,
    build=lambda keys: _splines().control_path(keys.control_points_mm),
    build_closed=lambda keys: _splines().closed_control_path(keys.control_points_mm),
)

_KINDS = Registry(Message("path"), (QUINTIC, CUBIC, B_SPLINE))
register, remove, codes, kind_of, has = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of, _KINDS.has
