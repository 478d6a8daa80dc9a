"""Names and types of a path, for design files and for the numerics. The module is light to import."""

from enum import StrEnum


class SplineKind(StrEnum):
    """Spline through waypoints: of degree 5, with a continuous rate of curvature, or of 3, whose rate has kinks."""

    QUINTIC = "quintic"
    CUBIC = "cubic"


# [x, y] of points, as in a design file.
Points = tuple[tuple[float, float], ...]
