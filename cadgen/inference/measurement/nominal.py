"""The design that data are measured against, and the forces on its cam."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import pi

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import Leads, Mechanics
from cadgen.car.steering import Car
from cadgen.curves.closed import ClosedCurve
from cadgen.deviations.disc import Disc, nominal_disc
from cadgen.deviations.effect import Quantity
from cadgen.errors import DesignError
from cadgen.inference.measurement.model import Cache, Model, Rolled
from cadgen.inference.measurement.record import Method, Record
from cadgen.laws.motion import mirrored

_KEPT = 256  # fits go back and forth between few frictions


@dataclass(frozen=True)
class Forces:
    """The cam that is measured and what acts on it.

    Attributes:
        cut: lift that it was cut for.
        mechanics: rod force and drag; the friction is what is sought.
    """

    cut: PathMotion
    mechanics: Mechanics
    _known: Cache[tuple[float, bool, int], tuple[PathMotion, Leads]] = field(
        default_factory=lambda: Cache(_KEPT), repr=False
    )

    def leads(self, friction: float, *, back: bool = False, lift: PathMotion | None = None) -> Leads:
        """Where the cam leads with a sliding friction; remembered, since most differences leave friction alone.

        Args:
            friction: friction coefficient between rod and disc.
            back: of a cam that is turned back, by the angle that it has turned back.
            lift: that the disc gives, where that is not the one it was cut for.
        """
        cut = lift or self.cut

        def made() -> tuple[PathMotion, Leads]:
            mechanics = replace(self.mechanics, friction=friction)
            # With the lift, so that no other one is taken for it.
            return cut, mechanics.leads(cut.mirrored if back else cut)

        return self._known.of((friction, back, id(cut)), made)[1]

    def drawn(self, friction: float) -> tuple[Array, Array]:
        """Where the rod draws a free cam on, and where it draws it back.

        Args:
            friction: coefficient of friction, a number.

        Returns:
            Cam angles between which it does, shape (k, 2) each, rad, begins in [0, 2 pi) and in order: the first draw
            to their ends, the second to their begins.
        """
        back = mirrored(self.leads(friction, back=True).intervals)
        return self.leads(friction).intervals, back[np.argsort(back[:, 0])]


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
        usual: mean and standard deviation of effects' numbers by their keys over the cars of the workshop that made
            it, internal units; empty where that is not known.
        blend_start: cam angle up to which tracks are judged, rad; that at which the blend of `lift` begins if left out.
    """

    lift: PathMotion
    follower: EdgeFollower
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
    usual: Mapping[Quantity, tuple[float, float]] = field(default_factory=dict)
    blend_start: float | None = None

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
            raise DesignError(
                "{file}: data of kind {kind} are not traced to effects of this design",
                file=record.source,
                kind=kind.code,
            )
        return kind.model(record, self)

    @property
    def forces(self) -> Forces:
        """The cam as it was cut, and what acts on it."""
        return Forces(self.cut or self.lift, self.mechanics or Mechanics(follower=self.follower))


@dataclass(frozen=True)
class LoggedCar:
    """A car whose steering and travel are logged.

    Attributes:
        wheelbase: of its design, mm.
        accepted: names of the formulas that its user has accepted as effects of the car.
    """

    wheelbase: float
    accepted: frozenset[str] = frozenset()
