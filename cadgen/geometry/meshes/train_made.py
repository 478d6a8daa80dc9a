"""A gear train as it is made: teeth thinned, parts at their places, inspected, and measured in mesh."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.gears.layout import Blanks, TrainLayout, lay_out
from cadgen.gears.stage import Wheel
from cadgen.gears.train import Train, TrainPlay, thinned
from cadgen.geometry.meshes.train_checks import gear_checks
from cadgen.parts.blank import Blank

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
    _inspect(layout.train)
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
            f"export.mesh_chord_um is {shortest:.4g}; with it the meshes of all gears have {corners} corners, and at "
            f"most {MOST_CORNERS} are made: raise it to {1.05 * shortest * (corners / MOST_CORNERS) ** 2:.2g}"
        )


def _inspect(train: Train) -> None:
    """Refuse gears that the shop could not measure."""
    for number, stage in enumerate(train.stages, 1):
        try:
            stage.wheel_facts()
        except DesignError as error:
            raise DesignError(f"in stage {number}, {error}") from error
