"""Names of the kinds of splines, for design files and for the path. The module is light to import."""

from typing import Literal

# Of degree 5, with a continuous rate of curvature, or of degree 3, whose rate of curvature has kinks.
SplineKind = Literal["quintic", "cubic"]
