"""The design that data are measured against."""

from dataclasses import dataclass
from functools import cached_property
from math import pi

from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.motion.mechanics import Mechanics
from cadgen.car.path.track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.disc import Disc, nominal_disc
from cadgen.errors import DesignError
from cadgen.inference.measurement.models.base import Model
from cadgen.inference.measurement.models.forces import Forces
from cadgen.inference.measurement.models.rolled import Rolled
from cadgen.inference.measurement.record import Method, Record

MACHINED_UM = 2.0
PRINTED_UM = 30.0
# Steps of the train that repeat each turn and are no effect: pitch errors of a tooth, of a grade 7 gear.
TRAIN_DEG = 0.01


@dataclass(frozen=True, kw_only=True)
class Nominal:
    """Nominal part by its design.

    Attributes:
        lift, follower, profile: of the cam; the profile is the one that was made.
        car, track: that it steers.
        ratios: of the train's stages, from the motor to the camshaft; empty if there is none.
        teeth: of each stage's driven wheel; empty if unknown.
        form_error: stated form error of the disc, rms, mm.
        train_error: the same of the train, rms, rad.
        cut: lift that the cam was cut for, by whose slope friction holds the cam or lets it go; `lift` if left out.
        mechanics: what the design says of rod force and drag; nothing if left out.
        play: return error that was measured apart, with the rod lifted, and its standard deviation, rad.
    """

    lift: PathMotion
    follower: LeaningRod
    profile: ClosedCurve
    car: Car
    track: Track
    ratios: tuple[float, ...] = ()
    teeth: tuple[int, ...] = ()
    form_error: float = MACHINED_UM / 1e3
    train_error: float = TRAIN_DEG * pi / 180
    cut: PathMotion | None = None
    mechanics: Mechanics | None = None
    play: tuple[float, float] | None = None

    @cached_property
    def disc(self) -> Disc:
        """The profile as points."""
        return nominal_disc(self.profile)

    @cached_property
    def rolled(self) -> Rolled:
        """The lift with effects on the disc and the rod: one for all records, which share what they roll."""
        return Rolled(self.lift, self.follower, self.disc)

    def model(self, record: Record) -> Model:
        """The forward model of a record.

        Raises:
            DesignError: the design has no train for a transmission's data, or the kind needs no model.
        """
        kind = record.kind
        if kind.model is None or kind.method is not Method.EVIDENCE:
            raise DesignError(f"{record.source}: data of kind {kind.code} are not traced to effects of this design")
        return kind.model(record, self)

    @property
    def forces(self) -> Forces:
        """The cam as it was cut, and what acts on it."""
        return Forces(self.cut or self.lift, self.mechanics or Mechanics(follower=self.follower))


@dataclass(frozen=True)
class LoggedCar:
    """A car whose steering and travel are logged: of its design the wheelbase alone counts, mm."""

    wheelbase: float
