"""The gear train beside its cam: shafts in the cam's frame, and how each turns with the motor and the play.

The frame is that of the cam's files: the camshaft is the z axis, which points to the car's left; x points ahead, to the
fork, and y down. Forwards the cam turns by -θ about z, or by θ if it sits turned over.

Every driver pushes on the same flanks as long as the gears push the cam. If the cam runs ahead by a share u of the
play, each stage's driven wheel goes through the same share of its play. Let σ = ±1 be the sense of a shaft, e its lead
over the middle of the play, measured in that sense, and j the play of the stage as cut. Then
    e(driven) = e(driver) / i + (u - 1/2) j.
The drive stands ahead by as much as makes the lead of the output 0 at u = 0.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi, prod, sqrt
from typing import NamedTuple

import numpy as np

from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.parts.body import Body


class Stand(NamedTuple):
    """A body at its height along its shaft.

    Attributes:
        body: body of a part.
        height: height of its own zero, mm.
        side: -1 if it is turned over, else 1.
    """

    body: Body
    height: float
    side: float


@dataclass(frozen=True)
class TurningPart:
    """A part of the train in the cam's frame.

    Attributes:
        part: part of the train.
        axis: its axis x + iy, mm.
        lift: height by which it is raised, mm.
        angle: its angle at motor position 0, the cam pushed, rad.
        rate: its turns by turn of the cam, with sign; negative for the sense of the cam.
        lead: angle by which it turns, beyond that, when the cam runs through the whole play, rad.
        carrier: number of the part of the train that its axis goes round with, for a planet; None for an axis that
            stands.
    """

    part: TrainPart
    axis: complex
    lift: float
    angle: float
    rate: float
    lead: float
    carrier: int | None = None

    def angle_at(self, motor: float, share: float) -> float:
        """Angle of the part, rad.

        Args:
            motor: motor position in cam units, rad.
            share: share of the play that the cam has run ahead, 0 to 1.
        """
        return self.angle + self.rate * motor + self.lead * share

    @property
    def pieces(self) -> tuple[TurningPart, ...]:
        """Part as a shop makes it: its gears by themselves where they are cut apart."""
        return tuple(replace(self, part=piece) for piece in self.part.pieces)

    @property
    def stand(self) -> Stand:
        """Body of the part where it stands along its shaft."""
        return Stand(self.part.body, self.part.height + self.lift, -1.0 if self.part.flipped else 1.0)

    @property
    def range(self) -> tuple[float, float]:
        """Heights between which it stands, mm."""
        ends = (0.0, self.part.body.slabs[-1].end)
        low, high = sorted(self.part.height + (-end if self.part.flipped else end) for end in ends)
        return low + self.lift, high + self.lift


@dataclass(frozen=True)
class TurningTrain:
    """A train beside its cam.

    Attributes:
        parts: parts from the drive to the output, whose axis is the camshaft.
        directions: directions of the lines of centres, rad.
        play: return error of the teeth as cut, rad.
        beside: parts beside the shafts, as planets are.
    """

    parts: tuple[TurningPart, ...]
    directions: tuple[float, ...]
    play: float
    beside: tuple[TurningPart, ...] = ()

    @property
    def reach(self) -> float:
        """Distance of the drive's axis from the camshaft, mm."""
        return abs(self.parts[0].axis)


def turned_to_axle(layout: TrainLayout, behind: float) -> float:
    """Angle by which a train is turned as a whole so that its drive stands on the rear axle, rad.

    Args:
        layout: train as laid out.
        behind: distance of the rear axle behind the camshaft, mm; the drive's axis is set there, below the height of
            the camshaft, or straight behind it as far as the train reaches.
    """
    way = layout.on_shafts[0].axis - layout.on_shafts[-1].axis
    reach = abs(way)
    drop = sqrt(max(reach**2 - behind**2, 0.0))
    target = complex(-behind, drop) if reach > behind else complex(-reach, 0.0)
    return float(np.angle(target / way)) if reach else 0.0


def height_beside(layout: TrainLayout, plane: float, side: int) -> float:
    """Height by which a train is raised so that it ends at a plane, mm.

    Args:
        layout: train as laid out.
        plane: height at which the stack of gears ends towards the cam, mm.
        side: 1 if the stack stands below that plane, -1 if above.
    """
    ends = ((part, part.body.slabs[-1].end) for part in layout.parts)
    heights = [z for part, end in ends for z in (part.height, part.height + (-end if part.flipped else end))]
    return plane - (max(heights) if side > 0 else min(heights))


def turning_train(layout: TrainLayout, turn: float, raised: float, sense: int = -1) -> TurningTrain:
    """Set a train beside its cam.

    Args:
        layout: train as laid out.
        turn: angle by which it is turned as a whole, rad.
        raised: height by which it is raised, mm.
        sense: sense in which the camshaft turns about z, 1 with a disc that sits turned over on it.
    """
    stages, parts = layout.train.stages, layout.on_shafts
    output = parts[-1].axis
    ratios = [float(stage.ratio) for stage in stages]
    frees = [stage.free_angle() for stage in stages]
    turns = [float(np.prod(ratios[number:])) for number in range(len(parts))]
    # A ring and its pinion turn the same way; gears side by side turn the sense round.
    senses = [sense * float(prod(stage.sense for stage in stages[number:])) for number in range(len(parts))]
    play = sum(free / turned for free, turned in zip(frees, turns[1:], strict=True))
    # Middle of the play: the output's own x axis is the cam's, and what drives it stands as the meshes ask.
    middles = [part.angle + turn for part in parts]
    shift = -middles[-1]
    angles = [0.0] * len(parts)
    for number in range(len(parts) - 1, -1, -1):
        angles[number] = middles[number] + shift
        if number:
            shift *= stages[number - 1].sense * ratios[number - 1]
    ahead, lead = turns[0] * play / 2, 0.0
    leads = [0.0]
    for number, (ratio, free) in enumerate(zip(ratios, frees, strict=True)):
        angles[number] += senses[number] * ahead
        ahead, lead = ahead / ratio - free / 2, lead / ratio + free
        leads.append(lead * senses[number + 1])
    turning = tuple(
        TurningPart(part, (part.axis - output) * np.exp(1j * turn), raised, angle % (2 * pi), sense * rate, lead)
        for part, angle, sense, rate, lead in zip(parts, angles, senses, turns, leads, strict=True)
    )
    beside = []
    for part in (part for part in layout.parts if part.beside):
        stage = part.stages[0]
        ends, shares = turning[stage - 1 : stage + 1], part.turns
        # What driver and driven wheel have turned from the middle of the play turns it, too; and whither it goes round.
        ahead_of = [angle - middle for angle, middle in zip(angles, middles, strict=True)][stage - 1 : stage + 1]
        orbit = ahead_of[1] if part.orbits else 0.0
        middle = parts[stage].axis
        axis = middle - output + (part.axis - middle) * np.exp(1j * orbit)
        beside.append(
            TurningPart(
                part,
                complex(axis * np.exp(1j * turn)),
                raised,
                (part.angle + turn + sum(share * by for share, by in zip(shares, ahead_of, strict=True))) % (2 * pi),
                sum(share * end.rate for share, end in zip(shares, ends, strict=True)),
                sum(share * end.lead for share, end in zip(shares, ends, strict=True)),
                stage if part.orbits else None,
            )
        )
    return TurningTrain(turning, tuple(direction + turn for direction in layout.directions), play, tuple(beside))
