"""Play beside that of the teeth: wheels loose on their shafts (`fits`), and shafts loose in their bearings.

**Bearings.** Shafts that can move by C across their bearings let the axes of a mesh stand further apart by as much as
C, half of it from either; by eq. 1 that opens 2 C tan(alpha) on the pitch circle. That a force which turns round may
carry a shaft across its bearings, by up to 2 C / cos(alpha) there, is not counted: weight, the rod's force or a preload
hold it.

Each counts at its place: at the camshaft in full, elsewhere divided by the turns of its shaft for one of the camshaft.
"""

from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.gears.distribution import ZoneSum
from cadgen.gears.names import Law
from cadgen.gears.train import Train, TrainPlay


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

    def at(self, ratio: float) -> "Loose":
        """The same on a shaft that turns so many times for one turn of the camshaft.

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
            name=f"bearings of stage {number}",
            least=0.0,
            greatest=stage.opened(clearance) / ratio,
            cure=f"preload the bearings of stage {number}, which have",
        )
        for number, (stage, ratio) in enumerate(zip(train.stages, ratios, strict=True), 1)
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
        """Least, rad."""
        return (self.teeth.return_error_min if self.teeth else 0.0) + sum(one.least for one in self.loose)

    @property
    def return_error_max(self) -> float:
        """Greatest, rad."""
        return (self.teeth.return_error_max if self.teeth else 0.0) + sum(one.greatest for one in self.loose)

    def return_error_distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Distribution, rad: every contribution free in its own zone."""
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
        return (
            f"{worst.cure} {degrees(worst.greatest):.2f}° of the {degrees(self.return_error_max):.2f}° of return error"
        )
