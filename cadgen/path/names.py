"""Names and types of a path, for design files and for the numerics. The module is light to import."""

from typing import Literal

# Of degree 5, with a continuous rate of curvature, or of degree 3, whose rate of curvature has kinks.
SplineKind = Literal["quintic", "cubic"]
# [x, y] of points, as in a design file.
Points = tuple[tuple[float, float], ...]
