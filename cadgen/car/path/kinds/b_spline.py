"""The kind of a planned path: a B-spline by its control points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import MaxLen, MinLen

from cadgen.car.path.kinds.kind import PathKind
from cadgen.car.path.names import Points

if TYPE_CHECKING:
    from cadgen.car.path.spline import PlannedPath


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


def _build(keys: BSplineKeys) -> PlannedPath:
    import numpy as np

    from cadgen.car.path.spline import control_path

    return control_path(np.array(keys.control_points_mm))


def _build_closed(keys: BSplineKeys) -> PlannedPath:
    import numpy as np

    from cadgen.car.path.spline import closed_control_path

    return closed_control_path(np.array(keys.control_points_mm))


B_SPLINE = PathKind(
    code="b_spline",
    meaning="a B-spline of degree 5 by control points, which `cadgen plan` writes",
    keys=BSplineKeys,
    build=_build,
    build_closed=_build_closed,
)
