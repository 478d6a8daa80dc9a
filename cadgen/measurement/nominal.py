"""The design that data are measured against."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np

from cadgen.cam.contact import roll
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.deviations.disc import DISC, Disc, nominal_disc
from cadgen.deviations.effect import Active, through
from cadgen.errors import DesignError
from cadgen.measurement.models.base import Model
from cadgen.measurement.models.forces import Forces
from cadgen.measurement.record import Method, Record
from cadgen.motion.mechanics import Mechanics
from cadgen.motion.sampled import sampled_lift
from cadgen.path.track import Track
from cadgen.steering.car import Car

MACHINED_UM = 2.0
PRINTED_UM = 30.0
# Steps of the train that repeat each turn and are no effect: pitch errors of a tooth, of a grade 7 gear.
TRAIN_DEG = 0.01
_STATIONS = 3600  # of the lift of a disc that is known to differ; it errs by under 0.01 um between them


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
        known: effects on the disc that the lift already has.
        cut: lift that the cam was cut for, by whose slope friction holds the cam or lets it go; `lift` if left out.
        mechanics: what the design says of rod force and drag; nothing if left out.
        play: return error that was measured apart, with the rod lifted, and its standard deviation, rad.
    """

    lift: LiftCurve
    follower: LeaningRod
    profile: ClosedCurve
    car: Car
    track: Track
    ratios: tuple[float, ...] = ()
    teeth: tuple[int, ...] = ()
    form_error: float = MACHINED_UM / 1e3
    train_error: float = TRAIN_DEG * pi / 180
    known: Active = ()
    cut: LiftCurve | None = None
    mechanics: Mechanics | None = None
    play: tuple[float, float] | None = None

    @cached_property
    def disc(self) -> Disc:
        """The profile as points, with what is known to differ."""
        return through(DISC, nominal_disc(self.profile), self.known, None)

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

    def with_disc(self, known: Active) -> "Nominal":
        """The same with a disc that is known to differ: what is measured behind it is not blamed for that again.

        Args:
            known: effects on the disc with their values.

        Raises:
            DesignError: no rod can follow that disc.
        """
        if not known:
            return self
        disc = through(DISC, self.disc, known, None)
        angle = np.linspace(0.0, 2 * pi, _STATIONS, endpoint=False)
        before, after = (roll(Outline(of.points, of.piece), self.follower, angle).tan_beta for of in (self.disc, disc))
        steering = self.lift.tan_beta(angle) + after - before
        lift = sampled_lift(angle, steering, blend_start=self.lift.blend_start, level=self.lift.level)
        return replace(self, lift=lift, known=(*self.known, *known), cut=self.cut or self.lift)


@dataclass(frozen=True)
class LoggedCar:
    """A car whose steering and travel are logged: of its design the wheelbase alone counts, mm."""

    wheelbase: float
