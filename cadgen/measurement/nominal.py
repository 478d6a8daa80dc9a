"""The design that data are measured against, and the forward model of each kind of data."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi

from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import ClosedCurve
from cadgen.errors import DesignError
from cadgen.measurement.diagnose import Diagnosis, diagnose
from cadgen.measurement.effects.disc import Disc
from cadgen.measurement.load import join
from cadgen.measurement.models.base import Model
from cadgen.measurement.models.lift import LiftModel, nominal_disc
from cadgen.measurement.models.profile import ProfileModel
from cadgen.measurement.models.track import TrackModel
from cadgen.measurement.models.transmission import TransmissionModel
from cadgen.measurement.models.tricycle import TricycleModel
from cadgen.measurement.record import Record
from cadgen.measurement.steered import diagnose_steered
from cadgen.path.track import Track
from cadgen.steering.car import Car

MACHINED_UM = 2.0
PRINTED_UM = 30.0
# Steps of the train that repeat each turn and are no effect: pitch errors of a tooth, of a grade 7 gear.
TRAIN_DEG = 0.01


@dataclass(frozen=True, kw_only=True)
class Nominal:
    """What the design says of the part.

    Attributes:
        lift, follower, profile: of the cam; the profile is the one that was made.
        car, track: that it steers.
        ratios: of the train's stages, from the motor to the camshaft; empty if there is none.
        teeth: of each stage's driven wheel; empty if unknown.
        form_error: stated form error of the disc, rms, mm.
    """

    lift: LiftCurve
    follower: Follower
    profile: ClosedCurve
    car: Car
    track: Track
    ratios: tuple[float, ...] = ()
    teeth: tuple[int, ...] = ()
    form_error: float = MACHINED_UM / 1e3
    train_error: float = TRAIN_DEG * pi / 180

    @cached_property
    def disc(self) -> Disc:
        """The profile as points."""
        return nominal_disc(self.profile)

    def model(self, record: Record) -> Model:
        """The forward model of a record.

        Raises:
            DesignError: the design has no train for a transmission's data, or the kind needs no model.
        """
        if record.kind == "lift":
            return LiftModel(record, self.lift, self.follower, self.disc, floor=self.form_error)
        if record.kind == "profile":
            return ProfileModel(record, self.disc, floor=self.form_error)
        if record.kind == "transmission":
            if not self.ratios:
                raise DesignError(f"{record.source}: the design has no gear train; add its stages to judge this file")
            return TransmissionModel(record, self.lift, self.ratios, teeth=self.teeth, floor=self.train_error)
        if record.kind == "track":
            return TrackModel(record, self.lift, self.car, self.track, self.follower.inner, floor=self.form_error)
        raise DesignError(f"{record.source}: data of kind {record.kind} are not traced to effects of this design")


def calibrate(records: Sequence[Record], nominal: Nominal) -> tuple[Diagnosis, ...]:
    """Diagnose several records; those of one kind are taken together.

    Raises:
        DesignError, FileError: see `Nominal.model` and `load.join`.
    """
    kinds = dict.fromkeys(record.kind for record in records)
    joined = [join([r for r in records if r.kind == kind]) for kind in kinds]
    return tuple(diagnose(record, nominal.model) for record in joined)


def calibrate_tricycle(records: Sequence[Record], wheelbase: float) -> Diagnosis:
    """Diagnose runs of a tricycle whose steering was logged."""
    return diagnose_steered(join(records), lambda record: TricycleModel(record, wheelbase))
