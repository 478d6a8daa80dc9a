"""A gear train: stages in a row, their play, and its return error (eq. 25-26 of the paper).

The first stage is next to the drive, the last one turns the output: here, the camshaft.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import prod

import numpy as np

from cadgen.errors import DesignError
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.names import Law
from cadgen.gears.stage import Departure, Play, Stage


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
    def output_ratios(self) -> tuple[Fraction, ...]:
        """i_jn of every stage j: turns of its driven shaft per turn of the output (eq. 26)."""
        later = (self.stages[j + 1 :] for j in range(len(self.stages)))
        return tuple(prod((stage.ratio for stage in stages), start=Fraction(1)) for stages in later)

    def reordered(self, order: Sequence[int]) -> Train:
        """The same stages in another order: `order` holds their present numbers, from 0."""
        return Train(tuple(self.stages[j] for j in order))

    def by_the_standard(self) -> Train:
        """The same train without overrides."""
        return Train(tuple(stage.by_the_standard() for stage in self.stages))

    def departures(self) -> tuple[Departure, ...]:
        """Every tolerance of its own beside the standard's value."""
        return tuple(departure for number, stage in enumerate(self.stages, 1) for departure in stage.departures(number))


@dataclass(frozen=True, slots=True, kw_only=True)
class TrainPlay:
    """A train with its stages' play, and its return error B_Σ at the output in rad (eq. 25)."""

    train: Train
    stages: tuple[Play, ...]

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
            names=tuple(f"stage {j}: {name}" for j, part in enumerate(parts, 1) for name in part.names),
            low=np.concatenate([part.low for part in parts]),
            high=np.concatenate([part.high for part in parts]),
            law=law,
        )

    def _at_output(self) -> list[tuple[Play, float]]:
        """Each stage's play with its i_jn."""
        return [(play, float(i)) for play, i in zip(self.stages, self.train.output_ratios, strict=True)]


def train_play(train: Train) -> TrainPlay:
    """Play of every stage of a train; a `DesignError` names the stage it comes from."""
    plays = []
    for number, stage in enumerate(train.stages, 1):
        try:
            plays.append(stage.play())
        except DesignError as error:
            raise DesignError(f"in stage {number}, {error}") from error
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
            raise DesignError(f"in stage {number}, {error}") from error
    return Train(tuple(stages))


def teeth_of(play: TrainPlay) -> str:
    """The stages of a train as driver/driven teeth, from the drive on."""
    return " ".join(stage.label for stage in play.train.stages)
