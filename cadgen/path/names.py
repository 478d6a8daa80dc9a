"""Names that files of designs and the path share: light to import."""

from typing import Literal

# Of degree 5, with a continuous rate of curvature, or of degree 3, whose rate of curvature has kinks.
SplineKind = Literal["quintic", "cubic"]
