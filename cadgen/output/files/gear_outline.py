"""The outline of a gear as DXF, for a laser or a wire, and its distance from the exact teeth."""

from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from cadgen.arrays import Array
from cadgen.curves.contour import Contour
from cadgen.curves.spline import SplineArc
from cadgen.errors import FileError
from cadgen.output.files.dxf import read_dxf, write_dxf
from cadgen.parts.loop import Loop, bezier_poles

# Greatest distance of the splines from the exact teeth, mm, and of what is read back.
OUTLINE_TOLERANCE, OUTLINE_LIMIT = 1e-5, 2e-5
_STEP = 0.05  # mm between points of an outline that is read back
_AREA_LIMIT = 1e-3  # of chords as long as the step, relative
_NODES = np.linspace(0.0, 1.0, 4001)  # of each curve of a tooth, for comparison


def write_outline(path: Path, outline: Loop, bore: Contour | None) -> float:
    """Write the outline of a gear with its bore, and return its greatest distance from the exact teeth, read back, mm.

    Raises:
        FileError: the file holds something else when it is read back.
    """
    write_dxf(path, _splines(outline), bore, ())
    drawing = read_dxf(path, _STEP)
    error = _distance(drawing.profile.points, outline)
    # Points on the teeth may leave out a tooth; the area does not.
    x, y = drawing.profile.points.T
    area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2
    if abs(area / outline.area - 1) > _AREA_LIMIT:
        raise FileError(f"{path.name}, read back, does not enclose the teeth: report this design")
    if error > OUTLINE_LIMIT or len(drawing.bore) != (bore is not None):
        raise FileError(f"{path.name}, read back, is {error * 1e3:.2g} µm off the exact teeth: report this design")
    return error


def _splines(outline: Loop) -> list[SplineArc]:
    """A wheel's outline as Bézier curves end to end."""
    poles = [bezier_poles(curve, OUTLINE_TOLERANCE) for curve in outline.curves]
    turned = [turn * points for turn in outline.turns for points in poles]
    return [
        SplineArc(
            degree=len(points) - 1,
            knots=np.repeat([0.0, 1.0], len(points)),
            control_points=np.stack([points.real, points.imag], axis=1),
        )
        for points in turned
    ]


def _distance(points: Array, outline: Loop) -> float:
    """Greatest distance of points from a wheel's exact outline, mm, from a dense polygon of one pitch."""
    pitch = 2 * np.pi / outline.repeats
    exact = np.concatenate([curve.point(_NODES) for curve in outline.curves])
    exact = np.concatenate([exact * np.exp(1j * pitch * turn) for turn in (-1, 0, 1)])
    tangent = np.concatenate([curve.tangent(_NODES) for curve in outline.curves])
    tangent = np.concatenate([tangent * np.exp(1j * pitch * turn) for turn in (-1, 0, 1)])
    seen = points[:, 0] + 1j * points[:, 1]
    middle = float(np.angle(exact[len(exact) // 2]))
    folded = seen * np.exp(-1j * pitch * np.rint((np.angle(seen) - middle) / pitch))
    _, nearest = cKDTree(np.stack([exact.real, exact.imag], axis=1)).query(np.stack([folded.real, folded.imag], axis=1))
    across = ((folded - exact[nearest]) * np.conj(tangent[nearest])).imag
    return float(np.abs(across).max())
