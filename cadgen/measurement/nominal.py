"""The design that data are measured against, and the forward model of each kind of data."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np

from cadgen.cam.contact import roll
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.deviations.disc import Disc, nominal_disc
from cadgen.deviations.effect import UNITS, Active, through
from cadgen.deviations.transmission import RETURN_ERROR
from cadgen.errors import DesignError
from cadgen.measurement.diagnose import Diagnosis, Step, diagnose
from cadgen.measurement.load import join
from cadgen.measurement.models.base import Model
from cadgen.measurement.models.forces import Forces
from cadgen.measurement.models.lift import LiftModel
from cadgen.measurement.models.profile import ProfileModel
from cadgen.measurement.models.track import TrackModel
from cadgen.measurement.models.transmission import TransmissionModel
from cadgen.measurement.models.tricycle import TricycleModel
from cadgen.measurement.record import Record
from cadgen.measurement.steered import diagnose_steered
from cadgen.measurement.units import refuse_wrong_log, refuse_wrong_units
from cadgen.motion.mechanics import Mechanics
from cadgen.motion.sampled import sampled_lift
from cadgen.path.track import Track
from cadgen.steering.car import Car

MACHINED_UM = 2.0
PRINTED_UM = 30.0
# Steps of the train that repeat each turn and are no effect: pitch errors of a tooth, of a grade 7 gear.
TRAIN_DEG = 0.01
# Kinds of data that the disc shows in without being measured itself.
BEHIND_THE_DISC = ("lift", "track")
_STATIONS = 3600  # of the lift of a disc that is known to differ; it errs by under 0.01 um between them


@dataclass(frozen=True, kw_only=True)
class Nominal:
    """What the design says of the part.

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
    follower: Follower
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
        return through("disc", nominal_disc(self.profile), self.known, None)

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
            return TransmissionModel(
                record, self.lift, self.ratios, self._forces, teeth=self.teeth, floor=self.train_error
            )
        if record.kind == "track":
            return TrackModel(record, self.lift, self.car, self.track, self._forces, floor=self.form_error)
        raise DesignError(f"{record.source}: data of kind {record.kind} are not traced to effects of this design")

    @property
    def _forces(self) -> Forces:
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
        disc = through("disc", self.disc, known, None)
        angle = np.linspace(0.0, 2 * pi, _STATIONS, endpoint=False)
        before, after = (
            roll(Outline(one.points, one.piece), self.follower, angle).tan_beta for one in (self.disc, disc)
        )
        steering = self.lift.tan_beta(angle) + after - before
        lift = sampled_lift(angle, steering, blend_start=self.lift.blend_start, level=self.lift.level)
        return replace(self, lift=lift, known=(*self.known, *known), cut=self.cut or self.lift)


def calibrate(records: Sequence[Record], nominal: Nominal, step: Step = lambda text: None) -> tuple[Diagnosis, ...]:
    """Diagnose several records; those of one kind are taken together.

    The effects on the disc that a profile's verdict claims are known to the lift and the track; the return error that a
    transmission's claims, to a track that shows friction.

    Raises:
        DesignError, FileError: see `Nominal.model`, `load.join` and `units.refuse_wrong_units`.
    """
    kinds = dict.fromkeys(record.kind for record in records)
    joined = {kind: join([r for r in records if r.kind == kind]) for kind in kinds}
    for record in joined.values():
        refuse_wrong_units(record, nominal)
    told = {}
    behind, names = nominal, tuple[str, ...]()
    play = nominal.play
    for kind in sorted(joined, key=lambda kind: ("profile", "transmission", "lift", "track").index(kind)):
        if kind in BEHIND_THE_DISC:
            told[kind] = _behind(diagnose(joined[kind], behind.model, step, play), joined[kind], nominal, names)
            continue
        told[kind] = diagnose(joined[kind], nominal.model, step)
        if kind == "transmission":
            play = _play(told[kind]) or play
        if kind == "profile":
            known = [(e, v) for e, v in told[kind].active if e.name in told[kind].judgement.claimed]
            behind, names = nominal.with_disc(known), tuple(e.name for e, _ in known)
    return tuple(told[kind] for kind in kinds)


def _play(told: Diagnosis) -> tuple[float, float] | None:
    """Return error that a transmission's data claim, and its standard deviation, rad."""
    for finding in told.findings:
        if finding.effect == RETURN_ERROR.name and finding.effect in told.judgement.claimed:
            (value,) = finding.values
            return value.value * UNITS[value.unit], value.sigma * UNITS[value.unit]
    return None


def _behind(told: Diagnosis, record: Record, nominal: Nominal, names: tuple[str, ...]) -> Diagnosis:
    """A diagnosis with the effects that were known, and a doubt where these made things worse."""
    if not names:
        return told
    model = nominal.model(record)
    residual = model.residual([])
    without = residual - model.offsets @ np.linalg.lstsq(model.offsets, residual, rcond=None)[0]
    rms = float(np.sqrt(np.mean(without**2))) / UNITS[model.unit]
    judgement = told.judgement
    if told.residual.before > rms:
        doubt = (
            f"with {' and '.join(names)} of the profile taken as known the residual before is "
            f"{told.residual.before:.4g} and without {rms:.4g}: make sure that both files are of one disc"
        )
        judgement = replace(judgement, limits=(*judgement.limits, doubt))
    return replace(told, known=names, judgement=judgement)


def calibrate_tricycle(records: Sequence[Record], wheelbase: float, step: Step = lambda text: None) -> Diagnosis:
    """Diagnose runs of a tricycle whose steering was logged.

    Raises:
        FileError: see `load.join` and `units.refuse_wrong_log`.
    """
    record = join(records)
    refuse_wrong_log(record, wheelbase)
    return diagnose_steered(record, lambda part: TricycleModel(part, wheelbase), step)
