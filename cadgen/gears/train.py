"""A gear train: stages in a row, their play, and its return error (eq. 25-26 of the paper).

The first stage is next to the drive, the last one turns the output: here, the camshaft.

**Joints and bearings** have play beside that of the teeth: wheels loose on their shafts (`fits`), and shafts loose in
their bearings. Shafts that can move by C across their bearings let the axes of a mesh stand further apart by as much as
C, half of it from either; by eq. 1 that opens 2 C tan(alpha) on the pitch circle. That a force which turns round may
carry a shaft across its bearings, by up to 2 C / cos(alpha) there, is not counted: weight, the rod's force or a preload
hold it. Each counts at its place: at the camshaft in full, elsewhere divided by the turns of its shaft for one of the
camshaft.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import cos, degrees, prod

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.choices import Law
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.pair import Pair
from cadgen.gears.stage import Departure, PlayZone, Stage
from cadgen.gears.tolerances import flank_tolerance
from cadgen.messages import Message


@dataclass(frozen=True, slots=True)
class Train:
    """Stages from the drive to the output. Raises `DesignError` if there is none."""

    stages: tuple[Stage, ...]

    def __post_init__(self) -> None:
        if not self.stages:
            raise DesignError("the gear train has no stage; give at least one")

    @property
    def ratio(self) -> Fraction:
        """Turns of the drive per turn of the output."""
        return prod((stage.ratio for stage in self.stages), start=Fraction(1))

    @property
    def finest_grade(self) -> int | None:
        """Finest tolerance grade of its gears; None where none is stated."""
        return min((grade for stage in self.stages for grade in stage.grades if grade is not None), default=None)

    @property
    def sense(self) -> int:
        """-1 where the output turns against the drive, +1 where it turns with it."""
        return prod(stage.sense for stage in self.stages)

    @property
    def output_ratios(self) -> tuple[Fraction, ...]:
        """i_jn of every stage j: turns of its driven shaft per turn of the output (eq. 26)."""
        later = (self.stages[j + 1 :] for j in range(len(self.stages)))
        return tuple(prod((stage.ratio for stage in stages), start=Fraction(1)) for stages in later)

    def reordered(self, order: Sequence[int]) -> Train:
        """Train of the stages in another order: `order` holds their present numbers, from 0."""
        return Train(tuple(self.stages[j] for j in order))

    def by_the_standard(self) -> Train:
        """Train without overrides."""
        return Train(tuple(stage.by_the_standard() for stage in self.stages))

    def departures(self) -> tuple[Departure, ...]:
        """Every tolerance of its own beside the standard's value."""
        return tuple(departure for number, stage in enumerate(self.stages, 1) for departure in stage.departures(number))


@dataclass(frozen=True, slots=True, kw_only=True)
class TrainPlay:
    """A train with its stages' play, and its return error B_Σ at the output in rad (eq. 25)."""

    train: Train
    stages: tuple[PlayZone, ...]

    @property
    def return_error_max(self) -> float:
        """Greatest B_Σ in rad: every stage at its B_max."""
        return sum(stage.B_max / i for stage, i in self._at_output())

    @property
    def return_error_min(self) -> float:
        """Least B_Σ in rad: every stage at its B_min."""
        return sum(stage.B_min / i for stage, i in self._at_output())

    def return_error_distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Distribution of B_Σ in rad: every contribution of every stage free in its own zone."""
        parts = [
            play.distribution(law).scaled(1 / (stage.driven_pitch_radius * i))
            for stage, (play, i) in zip(self.train.stages, self._at_output(), strict=True)
        ]
        return ZoneSum(
            names=tuple(
                Message("stage {number}: {part}", number=j, part=name)
                for j, part in enumerate(parts, 1)
                for name in part.names
            ),
            low=np.concatenate([part.low for part in parts]),
            high=np.concatenate([part.high for part in parts]),
            law=law,
        )

    def _at_output(self) -> list[tuple[PlayZone, float]]:
        """Each stage's play with its i_jn."""
        return [(play, float(i)) for play, i in zip(self.stages, self.train.output_ratios, strict=True)]


def train_play(train: Train) -> TrainPlay:
    """Play of every stage of a train; a `DesignError` names the stage it comes from."""
    plays = []
    for number, stage in enumerate(train.stages, 1):
        try:
            plays.append(stage.play())
        except DesignError as error:
            raise DesignError("in stage {number}, {error}", number=number, error=error.message) from error
    return TrainPlay(train=train, stages=tuple(plays))


def thinned(train: Train) -> Train:
    """The train as it is made: every tooth thinned to the middle of its limits.

    Raises `DesignError`, with the stage and what thins most, for a tooth that cannot be cut so or at its limits.
    """
    stages = []
    for number, stage in enumerate(train.stages, 1):
        try:
            stages.append(stage.as_cut())
        except DesignError as error:
            raise DesignError("in stage {number}, {error}", number=number, error=error.message) from error
    return Train(tuple(stages))


def teeth_of(play: TrainPlay) -> str:
    """The stages of a train as driver/driven teeth, from the drive on."""
    return " ".join(stage.label for stage in play.train.stages)


@dataclass(frozen=True, kw_only=True)
class Loose:
    """Play of one joint, or of the bearings of one mesh, at the camshaft.

    Attributes:
        name: such as `key of the cam`.
        least, greatest: rad.
        cure: what takes it out, and what has it: `clamp the cam: its key has`.
    """

    name: str
    least: float
    greatest: float
    cure: str

    def at(self, ratio: float) -> Loose:
        """Play at the camshaft of the joint on a shaft that turns faster.

        Args:
            ratio: turns of the shaft for one turn of the camshaft.
        """
        return Loose(name=self.name, least=self.least / ratio, greatest=self.greatest / ratio, cure=self.cure)


def bearings(train: Train, clearance: float) -> tuple[Loose, ...]:
    """Free angle that the clearance of the shafts' bearings, mm, adds in every mesh.

    Args:
        train: train of gears.
        clearance: clearance by which a shaft can move across its bearings, mm.
    """
    if clearance <= 0:
        return ()
    ratios = [float(ratio) for ratio in train.output_ratios]
    return tuple(
        Loose(
            name=Message("bearings of stage {number}", number=number),
            least=0.0,
            greatest=stage.opened(clearance) / ratio,
            cure=Message("preload the bearings of stage {number}, which have", number=number),
        )
        for number, (stage, ratio) in enumerate(zip(train.stages, ratios, strict=True), 1)
    )


@dataclass(frozen=True, kw_only=True)
class OnceATurn:
    """Error of the gears of one shaft, once in its turn, seen at the camshaft.

    Attributes:
        order: turns of the shaft for one of the camshaft.
        size: greatest amplitude, its gears together, rad.
        least: amplitude that is left where wheel and pinion stand so that they cancel, rad.
    """

    order: float
    size: float
    least: float


def once_a_turn(train: Train, seat: float = 0.0) -> tuple[OnceATurn, ...]:
    """Transmission error of every shaft, from the camshaft on; of stages of spur gears alone.

    A gear's cumulative pitch runs through F_p in a turn: a sine of F_p / 2 on its pitch circle. A gear off its shaft's
    axis by e adds e / cos(alpha).

    Args:
        train: the train.
        seat: eccentricity of each gear on its shaft, mm.

    Raises:
        DesignError: a gear that ISO 1328 does not cover.
    """
    ratios = [float(ratio) for ratio in train.output_ratios]
    orders = [*ratios[::-1], float(train.ratio)]
    sizes: list[list[float]] = [[] for _ in orders]
    for place, (stage, ratio) in enumerate(zip(train.stages[::-1], ratios[::-1], strict=True)):
        if not isinstance(stage, Pair):
            continue
        for shaft, gear in ((place, stage.driven), (place + 1, stage.driver)):
            form = gear.form
            pitch = float(flank_tolerance("F_p", form.reference_diameter, form.normal_module, gear.grade))
            arc = pitch / 2 + seat / cos(form.transverse_pressure_angle)
            sizes[shaft].append(arc / (stage.driven_pitch_radius * ratio))
    return tuple(
        OnceATurn(order=order, size=sum(each), least=2 * max(each, default=0.0) - sum(each))
        for order, each in zip(orders, sizes, strict=True)
    )


@dataclass(frozen=True, kw_only=True)
class WholePlay:
    """Return error at the camshaft with everything in it; the paper's own sum is that of the teeth.

    Attributes:
        teeth: of the gears; None if the design has none.
        loose: joints and bearings beside them.
    """

    teeth: TrainPlay | None
    loose: tuple[Loose, ...] = ()

    @property
    def return_error_min(self) -> float:
        """Least return error, rad."""
        return (self.teeth.return_error_min if self.teeth else 0.0) + sum(one.least for one in self.loose)

    @property
    def return_error_max(self) -> float:
        """Greatest return error, rad."""
        return (self.teeth.return_error_max if self.teeth else 0.0) + sum(one.greatest for one in self.loose)

    def return_error_distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Distribution of the return error, rad: every contribution free in its own zone."""
        joints = ZoneSum(
            names=tuple(one.name for one in self.loose),
            low=np.array([one.least for one in self.loose]),
            high=np.array([one.greatest for one in self.loose]),
            law=law,
        )
        if self.teeth is None:
            return joints
        teeth = self.teeth.return_error_distribution(law)
        if not self.loose:
            return teeth
        return ZoneSum(
            names=(*teeth.names, *joints.names),
            low=np.concatenate([teeth.low, joints.low]),
            high=np.concatenate([teeth.high, joints.high]),
            law=law,
        )

    def sentence(self) -> str:
        """The cheapest cure: what takes out the most without a new gear; empty if every joint is tight."""
        if not self.loose:
            return ""
        worst = max(self.loose, key=lambda one: one.greatest)
        return Message(
            "{cure} {part:.2f}° of the {whole:.2f}° of return error",
            cure=worst.cure,
            part=degrees(worst.greatest),
            whole=degrees(self.return_error_max),
        )
