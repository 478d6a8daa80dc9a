"""Energy in a turn of the cam that the drag takes which holds the cam on its gears."""

from cadgen.car.against_play.remedies import holding
from cadgen.errors import DesignError
from cadgen.jobs.cam.plan import comparison_of
from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure


def _energy(evaluated: Evaluated) -> float:
    comparison = comparison_of(evaluated.plan)
    if comparison.task.mechanics is None:
        raise DesignError("the energy that holds the cam needs the rod's force: add [mechanics] with rod_force_N")
    return holding(comparison.chosen.lift, comparison.task.mechanics).energy


HOLDING_ENERGY = Figure(
    code="holding_energy_J",
    meaning="energy in a turn of the cam that the drag takes which holds it",
    of=_energy,
    resolution=1e-4,
)
