"""Return error of the train: the greatest of the cars that may be built."""

from math import degrees

from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure


def _return_error(evaluated: Evaluated) -> float:
    return degrees(evaluated.band.ends[1])


RETURN_ERROR = Figure(
    code="return_error_deg",
    meaning="greatest return error at the camshaft",
    of=_return_error,
    resolution=1e-4,
    cheap=True,
)
