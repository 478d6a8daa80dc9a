"""The kind of the paper's appendix: a cubic spline through waypoints, whose curvature has kinks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from cadgen.car.path.kinds.kind import PathKind
from cadgen.car.path.kinds.quintic import QuinticKeys

if TYPE_CHECKING:
    from cadgen.car.path.spline import PlannedPath

# What a cam takes in time and memory: of 1000 kinks some half a minute and 0.8 GB.
MOST_WAYPOINTS = 1000


@dataclass(frozen=True, kw_only=True)
class CubicKeys(QuinticKeys):
    """Keys of a cubic path through waypoints, as in its file."""

    def __post_init__(self) -> None:
        count = len(self.waypoints_mm)
        if count > MOST_WAYPOINTS:
            raise ValueError(
                f"path.waypoints_mm has {count} waypoints, and at each a cubic spline has a kink, where the profile is "
                f"joined anew; at most {MOST_WAYPOINTS} can be followed: keep one in {-(-count // MOST_WAYPOINTS)}, or "
                'set path.spline = "quintic"'
            )


def _build(keys: CubicKeys) -> PlannedPath:
    import numpy as np

    from cadgen.car.path.names import SplineKind
    from cadgen.car.path.spline import plan_path

    return plan_path(np.array(keys.waypoints_mm), SplineKind.CUBIC)


CUBIC = PathKind(
    code="cubic",
    meaning="the cubic of its appendix, whose curvature has kinks",
    keys=CubicKeys,
    build=_build,
)
