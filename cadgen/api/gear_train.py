"""The gear train of a design. Lengths are mm and angles rad."""

from dataclasses import dataclass

from cadgen.api.assembly import Assembly
from cadgen.gears import train as numeric
from cadgen.jobs.gears.plan import GearsPlan as GearsPlan
from cadgen.jobs.gears.plan import NotMadeError as NotMadeError


@dataclass(frozen=True, eq=False, repr=False)
class GearTrain(Assembly):
    """The gear train of a design: what `Design.gears` gives.

    Attributes:
        plan: numeric plan, with all other figures; mm and rad.
    """

    plan: GearsPlan

    def __repr__(self) -> str:
        return f"<GearTrain of {self.name}, {self.order}, ratio {self.ratio}>"

    @property
    def computed(self) -> GearsPlan:
        """Numeric plan, with the trains that were passed over and the reasons."""
        return self.plan

    @property
    def name(self) -> str:
        """Name of the design."""
        return self.plan.design.name

    @property
    def order(self) -> str:
        """Order of the stages: `as-given`, `reordered` or `search`."""
        return self.plan.order

    @property
    def ranked(self) -> tuple[numeric.TrainPlay, ...]:
        """Play of the trains that the order calls for, least return error first; mm and rad."""
        return self.plan.ranked

    @property
    def baseline(self) -> numeric.TrainPlay:
        """Play that the ranked trains are compared with; mm and rad."""
        return self.plan.baseline

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on the train that is made."""
        return self.plan.notes
