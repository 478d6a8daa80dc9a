"""A gear train as it is made: teeth thinned, parts at their places, inspected and measured in mesh; and its checks.

The checks are those of each stage by its own kind, of the whole train, and of its parts at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache

from cadgen.check import Bound, Check, CheckCode
from cadgen.errors import DesignError
from cadgen.gears.layout import Blanks, TrainLayout, lay_out
from cadgen.gears.stage import CONTRADICTION, PLAY_LIMIT_UM, Stage, Wheel
from cadgen.gears.train import Train, TrainPlay, thinned
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.geometry.meshes.teeth import MeasuredMesh, measured_pair, return_error
from cadgen.messages import Message, clauses, joined
from cadgen.parts.blank import Blank

# Parts of which a volume in mm³ below this is common only touch: the rounding of the meshes.
OVERLAP_LIMIT = 1e-6


def gear_checks(layout: TrainLayout, chords: Sequence[float]) -> tuple[Check, ...]:
    """Every check of a train that is laid out; `chords` (mm) are those of the parts' meshes."""
    cut = layout.train.stages
    checks = [*_bodies(layout, chords), *_worst([_of_stage(stage) for stage in cut])]
    if meshes(cut):
        error = return_error_um(
            cut, [[_built(mating.pair, mating.pair.centre_distance) for mating in stage.matings] for stage in cut]
        )
        code, name = CheckCode.RETURN_ERROR, Message("return error - computed")
        checks.append(
            Check(code, name, abs(error), "µm", PLAY_LIMIT_UM, Bound.MAX, Message("whole train"), CONTRADICTION)
        )
    return tuple(checks)


def failing_stages(layout: TrainLayout) -> list[int]:
    """Stages, from 0, that fail a check of their own."""
    cut = enumerate(layout.train.stages)
    return [number for number, stage in cut if not all(check.passed for check in _of_stage(stage))]


def meshes(cut: Sequence[Stage]) -> bool:
    """Whether all stages, as made, have flanks with one play all the time: they neither jam nor pass each other."""
    return all(stage.meshes(_built) for stage in cut)


def play_error_um(stage: Stage, measured: Sequence[MeasuredMesh]) -> float:
    """Measured less computed play as cut, µm of arc on the driven gear's pitch circle.

    Args:
        stage: stage as cut.
        measured: sections of its matings, by the exact curves or from a file.
    """
    found = stage.free_angle_of([pair.play(0.0) for pair in measured])
    return (found - stage.free_angle()) * stage.driven_pitch_radius * 1e3


def return_error_um(cut: Sequence[Stage], measured: Sequence[Sequence[MeasuredMesh]]) -> float:
    """Measured less computed return error as cut, µm of arc on the output wheel's pitch circle.

    Args:
        cut: stages as cut.
        measured: sections of each stage's matings.
    """
    ratios = Train(tuple(cut)).output_ratios
    computed = sum(stage.free_angle() / float(ratio) for stage, ratio in zip(cut, ratios, strict=True))
    if all(len(pairs) == 1 for pairs in measured):
        found = return_error([pair for (pair,) in measured])
    else:
        found = sum(
            stage.free_angle_of([pair.play(0.0) for pair in pairs]) / float(ratio)
            for stage, pairs, ratio in zip(cut, measured, ratios, strict=True)
        )
    return (found - computed) * cut[-1].driven_pitch_radius * 1e3


@cache  # equal stages of a train have equal sections
def _built(stage: Stage, apart: float) -> MeasuredMesh:
    return measured_pair(stage, apart)


@cache  # equal stages of a train have equal figures
def _of_stage(stage: Stage) -> tuple[Check, ...]:
    return stage.checks(_built)


def _bodies(layout: TrainLayout, chords: Sequence[float]) -> list[Check]:
    """The parts at their places as meshes: no two of them may have any volume in common."""
    solids = [
        body_mesh(part.body, chord).solid().transform(part.transform)
        for part, chord in zip(layout.parts, chords, strict=True)
    ]
    shared = [
        ((first ^ second).volume(), joined((layout.parts[i].name, layout.parts[j].name)))
        for i, first in enumerate(solids)
        for j, second in enumerate(solids)
        if i < j
    ]
    worst, place = max(shared)
    advice = Message("give a longer collar, smaller hubs, or more thinning")
    met = place if worst > 0 else ""
    return [
        Check(CheckCode.BODIES_OVERLAP, Message("bodies overlap"), worst, "mm3", OVERLAP_LIMIT, Bound.MAX, met, advice)
    ]


def _worst(stages: Sequence[Sequence[Check]]) -> list[Check]:
    """Each check at the stage that comes nearest to its limit, or oversteps it most.

    A stage that does not mesh has fewer checks than others.
    """
    worst: dict[StrEnum, Check] = {}
    for number, checks in enumerate(stages, 1):
        for check in checks:
            stage = Message("stage {number}", number=number)
            placed = replace(check, place=clauses(stage, check.place) if check.place else stage)
            nearest = worst.setdefault(check.code, placed)
            if _reserve(check, nearest.limit) < _reserve(nearest, check.limit):
                worst[check.code] = placed
    return list(worst.values())


def _reserve(check: Check, other_limit: float) -> float:
    """Margin of a value to its limit: in its unit, or as a share of the limit where stages have different limits."""
    value = -check.value if check.bound == Bound.MAX else check.value
    if check.limit == other_limit:
        return value
    limit = -check.limit if check.bound == Bound.MAX else check.limit
    return (value - limit) / abs(check.limit) if check.limit else value - limit


# Greatest number of corners of all gears' sections. Two gears with 112 000 are made, set against one another, written
# and read back in 6 s of processor time and 0.3 GB.
MOST_CORNERS = 500_000


@dataclass(frozen=True)
class MadeTrain:
    """A train that can be made.

    Attributes:
        play: play and return error of the train and its stages, mm and rad.
        layout: parts at their places, with thinned teeth.
        checks: every figure with its verdict.
    """

    play: TrainPlay
    layout: TrainLayout
    checks: tuple[Check, ...]


def make_train(
    play: TrainPlay,
    blanks: Blanks | Sequence[Blank],
    directions: Sequence[float | None] | None,
    clearance: float,
    chord: Callable[[Sequence[Wheel]], float],
) -> MadeTrain:
    """Thin the teeth of a train, lay it out, and measure it in mesh.

    Args:
        play: play of the train.
        blanks: features of the gears besides their teeth, by place or by shaft.
        directions: directions of the stages' lines of centres, rad; None for any.
        clearance: least gap between bodies on different shafts, mm.
        chord: function of the gears of a part that returns the greatest chord error of its mesh, mm.

    Raises:
        DesignError: a gear, its blank or the layout is impossible, with the stage or the shaft in the message; or the
            chords are too short for so many teeth.
    """
    layout = lay_out(thinned(play.train), blanks, directions, clearance)
    chords = [chord(part.gears) for part in layout.parts]
    _require_meshable(layout, chords)
    for number, stage in enumerate(layout.train.stages, 1):
        try:
            stage.wheel_figures()  # refuses gears that the shop could not measure
        except DesignError as error:
            raise DesignError("in stage {number}, {error}", number=number, error=error.message) from error
    return MadeTrain(play, layout, gear_checks(layout, chords))


def _require_meshable(layout: TrainLayout, chords: Sequence[float]) -> None:
    corners = sum(
        len(gear.outline.polygon(chord))
        for part, chord in zip(layout.parts, chords, strict=True)
        for gear in part.gears
    )
    if corners > MOST_CORNERS:
        shortest = min(chords) * 1e3
        raise DesignError(
            "export.mesh_chord_um is {shortest:.4g}; with it the meshes of all gears have {corners} corners, and "
            "at most {most} are made: raise it to {least:.2g}",
            shortest=shortest,
            corners=corners,
            most=MOST_CORNERS,
            least=1.05 * shortest * (corners / MOST_CORNERS) ** 2,
        )
