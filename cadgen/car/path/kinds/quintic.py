"""The kind of the paper's text: a sixth-order natural spline through waypoints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import MinLen

from cadgen.car.path.kinds.kind import PathKind
from cadgen.car.path.names import Points

if TYPE_CHECKING:
    from cadgen.car.path.spline import PlannedPath

# What a cam takes in time and memory: of 10 000 waypoints some half a minute and 0.3 GB.
MOST_WAYPOINTS = 10_000


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
        if count > MOST_WAYPOINTS:
            raise ValueError(
                f"path.waypoints_mm has {count} waypoints, of which the lift is made piece by piece; at most "
                f"{MOST_WAYPOINTS} can be followed: keep one in {-(-count // MOST_WAYPOINTS)}"
            )


def _build(keys: QuinticKeys) -> PlannedPath:
    import numpy as np

    from cadgen.car.path.names import SplineKind
    from cadgen.car.path.spline import plan_path

    return plan_path(np.array(keys.waypoints_mm), SplineKind.QUINTIC)


def _build_closed(keys: QuinticKeys) -> PlannedPath:
    import numpy as np

    from cadgen.car.path.spline import plan_lap

    return plan_lap(np.array(keys.waypoints_mm))


QUINTIC = PathKind(
    code="quintic",
    meaning="the sixth-order natural spline of the paper's text through waypoints",
    keys=QuinticKeys,
    build=_build,
    build_closed=_build_closed,
)
