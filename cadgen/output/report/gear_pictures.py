"""Pictures of gears: their sections in mesh."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np

from cadgen.gears.layout import TrainPart
from cadgen.output.report.style import BLACK, BLUE, GREEN, ORANGE, SKY, figure
from cadgen.parts.loop import Points

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_CHORD = 0.01  # mm
_FACES = (SKY, ORANGE, GREEN, BLUE)
_WIDTH, _LEAST, _MOST = 7.0, 2.5, 7.0  # inches


def outlines(part: TrainPart, chord: float = _CHORD) -> Iterator[tuple[int, list[Points]]]:
    """Outlines of a part at its place, x + iy, mm: of each slab that has teeth, the outer one first.

    Those with the material outside run clockwise, so that a filled picture leaves them open.

    Args:
        part: part of a train.
        chord: greatest error of the chords, mm.

    Yields:
        Number of the gear in the part, from 0, and its outlines.
    """
    turn = np.exp(1j * part.angle)
    for number, start in enumerate(part.starts):
        slab = next(slab for slab in part.body.slabs if slab.start <= start + 1e-9 < slab.end)
        own = [loop.polygon(chord)[:: 1 if full else -1] for loop, full in slab.walls().items()]
        yield number, [part.axis + turn * (points.conjugate() if part.flipped else points) for points in own]


@contextmanager
def gears_picture(title: str, parts: Sequence[TrainPart]) -> "Iterator[Figure]":
    """Draw the sections of gears at their places, those on one shaft in one colour.

    Args:
        title: title of the picture.
        parts: parts of the train.
    """
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    drawn = [(part, found) for part in parts for _, found in outlines(part)]
    every = np.concatenate([points for _, found in drawn for points in found])
    across, along = np.ptp(every.real), np.ptp(every.imag)
    with figure(_WIDTH, float(np.clip(_WIDTH * along / across, _LEAST, _MOST)) + 0.5) as picture:
        axes = picture.subplots()
        for part, found in drawn:
            ends = [np.append(points, points[0]) for points in found]  # a closed path ends where it begins
            path = Path.make_compound_path(*(Path(np.stack([p.real, p.imag], 1), closed=True) for p in ends))
            axes.add_patch(
                PathPatch(path, facecolor=_FACES[part.shaft % len(_FACES)], edgecolor=BLACK, linewidth=0.5, alpha=0.8)
            )
            axes.plot(part.axis.real, part.axis.imag, "+", color=BLACK, markersize=4)
        axes.set(title=title, xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
        axes.autoscale_view()
        yield picture
