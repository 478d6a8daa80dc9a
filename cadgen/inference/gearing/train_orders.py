"""Orders of a train's shafts and meshes, and how the run-out of a wheel shows in the transmission error.

Order is the number of turns, or of teeth that pass, in one turn of the output. A wheel whose teeth are off its axis by
e (radial run-out) shifts the flanks along the line of action. Let α be the working pressure angle and r_b the base
radius of the driven wheel of the mesh. Let ψ be the angle from the way to the other axis to the direction of e. A
driven wheel that is off its axis is turned by (e/r_b) sin(ψ − α), by its other flanks by (e/r_b) sin(ψ + α). A driver
that is off turns it by −(e/r_b) sin(ψ − α) and −(e/r_b) sin(ψ + α). So the phase differs by 2α between both flanks,
with one sense for a driver and the other for a driven wheel: play goes round with the wheel by 2 e tan α of arc. A
pitch that is off, or an encoder that is, shows alike on both flanks.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from cadgen.gears.pair import Pair
from cadgen.gears.train import Train
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class SeenWheel:
    """Wheel of a train, as the transmission error shows it.

    Attributes:
        stage: number of the stage, from 1.
        driver: whether it drives its stage.
        teeth: number of its teeth.
        lean: angle by which forward flanks lead, rad: that of pressure, with its sign.
        lever: base radius of the driven wheel of the stage times turns of that for one of the output, mm.
        pitch_lever: own reference radius times its turns for one of the output, mm.
        high: angle in its line, as a sine, at which its high side points at the other axis, rad; None in a ring's pair.
        reference_diameter, module, grade: of its tolerances; mm.
    """

    stage: int
    driver: bool
    teeth: int
    lean: float
    lever: float
    pitch_lever: float
    high: float | None
    reference_diameter: float
    module: float
    grade: int

    @property
    def name(self) -> Message:
        """Name of the wheel in a report."""
        if self.driver:
            return Message("driver of {teeth} teeth of stage {number}", teeth=self.teeth, number=self.stage)
        return Message("driven wheel of {teeth} teeth of stage {number}", teeth=self.teeth, number=self.stage)


@dataclass(frozen=True, kw_only=True)
class SeenShaft:
    """Shaft of a train.

    Attributes:
        number: from 1, that of the input.
        order: turns for one of the output.
        wheels: wheels on it.
        read: whether an encoder sits on it: input or output.
    """

    number: int
    order: float
    wheels: tuple[SeenWheel, ...]
    read: bool


@dataclass(frozen=True, kw_only=True)
class SeenMesh:
    """Mesh of a pair: number of its stage, teeth that pass in one turn of the output, and lever of a flank, mm."""

    stage: int
    order: float
    lever: float


@dataclass(frozen=True, kw_only=True)
class SeenTrain:
    """Train as the transmission error shows it: shafts from the input on, and meshes."""

    shafts: tuple[SeenShaft, ...]
    meshes: tuple[SeenMesh, ...]
    ratio: float
    sense: int


def seen(train: Train) -> SeenTrain:
    """Orders of a train of any stages; wheels and meshes of pairs of cylindrical gears.

    Args:
        train: train of gears.
    """
    later = [float(ratio) for ratio in train.output_ratios]
    orders = [float(train.ratio), *later]
    on: list[list[SeenWheel]] = [[] for _ in orders]
    meshes = []
    for place, (stage, turns) in enumerate(zip(train.stages, later, strict=True)):
        if not isinstance(stage, Pair):
            continue
        angle = stage.working_pressure_angle
        lever = stage.driven.form.base_diameter / 2 * turns
        for wheel, at in ((stage.driver, place), (stage.driven, place + 1)):
            form, drives = wheel.form, wheel is stage.driver
            # A ring's flanks push inwards, and it turns with its pinion.
            inside = stage.driver.form.side < 0
            with_driver = drives or stage.internal
            lean = (1 if with_driver else -1) * (-1 if inside else 1) * angle
            on[at].append(
                SeenWheel(
                    stage=place + 1,
                    driver=drives,
                    teeth=form.teeth,
                    lean=lean,
                    lever=lever,
                    pitch_lever=form.reference_diameter / 2 * orders[at],
                    high=None if stage.internal else (0.0 if drives else pi),
                    reference_diameter=form.reference_diameter,
                    module=form.normal_module,
                    grade=wheel.grade,
                )
            )
        meshes.append(SeenMesh(stage=place + 1, order=stage.driven.form.teeth * turns, lever=lever))
    last = len(orders) - 1
    shafts = tuple(
        SeenShaft(number=number + 1, order=order, wheels=tuple(wheels), read=number in (0, last))
        for number, (order, wheels) in enumerate(zip(orders, on, strict=True))
    )
    return SeenTrain(shafts=shafts, meshes=tuple(meshes), ratio=float(train.ratio), sense=train.sense)
