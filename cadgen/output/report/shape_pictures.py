"""Pictures of plane shapes: a section, the sheets of a frame, an assembly seen from two sides."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from math import ceil
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from cadgen.arrays import Array
from cadgen.output.report.style import BLACK, SKY, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH, _LEAST, _MOST = 9.0, 1.6, 6.0  # inches, of the picture and of the height of a row
_COLUMNS = 3


class Filled(NamedTuple):
    """Shape that is filled.

    Attributes:
        rings: outline, counterclockwise, and openings, clockwise, mm, shape (n, 2) each.
        color: colour of the filling, as matplotlib takes it.
    """

    rings: Sequence[Array]
    color: str | tuple[float, float, float] = SKY


@contextmanager
def shapes_picture(title: str, views: Mapping[str, Sequence[Filled]]) -> "Iterator[Figure]":
    """Draw shapes beside each other, in each view those in front last.

    Args:
        title: title of the picture.
        views: shapes by the name of their view, which may be empty.
    """
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    columns = min(len(views), _COLUMNS)
    rows = ceil(len(views) / columns)
    sizes = [
        np.ptp(np.concatenate([ring for shape in shapes for ring in shape.rings]), axis=0) for shapes in views.values()
    ]
    high = max(float(size[1] / size[0]) for size in sizes) * _WIDTH / columns
    with figure(_WIDTH, 0.7 + rows * float(np.clip(high + 0.5, _LEAST, _MOST))) as picture:
        picture.suptitle(title, x=0.02, ha="left")
        panels = picture.subplots(rows, columns, squeeze=False).flatten()
        for axes in panels[len(views) :]:
            axes.set_axis_off()
        for axes, (name, shapes) in zip(panels, views.items(), strict=False):
            for shape in shapes:
                path = Path.make_compound_path(
                    *(Path(np.vstack([ring, ring[:1]]), closed=True) for ring in shape.rings)
                )
                axes.add_patch(PathPatch(path, facecolor=shape.color, edgecolor=BLACK, linewidth=0.5))
            axes.set(title=name, xlabel="mm", aspect="equal")
            axes.autoscale_view()
        yield picture
