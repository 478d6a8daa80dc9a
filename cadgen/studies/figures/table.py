"""Every figure by its code. A new one is a file in this folder and a name below, or is registered from outside."""

from cadgen.registry import Registry
from cadgen.studies.figures.cutting_time import CUTTING_TIME
from cadgen.studies.figures.disc_diameter import DISC_DIAMETER
from cadgen.studies.figures.disc_mass import DISC_MASS
from cadgen.studies.figures.drift import DRIFT
from cadgen.studies.figures.holding_energy import HOLDING_ENERGY
from cadgen.studies.figures.passed import PASSED
from cadgen.studies.figures.return_error import RETURN_ERROR
from cadgen.studies.figures.worst_end import WORST_END, WORST_HEADING

_FIGURES = Registry(
    "figure",
    (
        WORST_END,
        WORST_HEADING,
        PASSED,
        DISC_DIAMETER,
        DISC_MASS,
        HOLDING_ENERGY,
        RETURN_ERROR,
        CUTTING_TIME,
        DRIFT,
    ),
)
register, remove, codes, kind_of = _FIGURES.register, _FIGURES.remove, _FIGURES.codes, _FIGURES.kind_of
