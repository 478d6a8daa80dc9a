"""The rim of a STEP file, from the file's own text: a second reader that shares nothing with the CAD kernel.

Of ISO 10303-21 and -42 it reads only the entities of a cam's rim: at one height a closed chain of edges that are all
B_SPLINE_CURVE_WITH_KNOTS, evaluated here by scipy. A rim with broken edges has such a chain on either side of its land.
"""

import re
from pathlib import Path

import numpy as np
from scipy.interpolate import BSpline

from cadgen.arrays import Array
from cadgen.curves.closed import Outline, cross
from cadgen.errors import FileError

# An instance ends at the first semicolon outside a string; a quote inside a string is doubled.
_INSTANCE = re.compile(r"#(\d+)\s*=\s*([A-Z0-9_]+)\s*\(((?:[^';]|'[^']*')*)\)\s*;")
_UNIT = re.compile(r"\bLENGTH_UNIT\s*\(\s*\)\s*NAMED_UNIT\s*\(\s*\*\s*\)\s*SI_UNIT\s*\(\s*\.MILLI\.\s*,\s*\.METRE\.")
_LIST = re.compile(r"\(([^()]*)\)")
_REFERENCE = re.compile(r"#(\d+)")
_LEVEL = 1e-9  # mm; greatest difference of a number in the file from the height
_JOINT = 1e-6  # mm; two edges of a loop that are further apart than this leave it open

Instances = dict[int, tuple[str, str]]


def read_rim(path: Path, step: float, height: float = 0.0) -> Outline:
    """Return the rim at a height, each edge one piece, points no more than `step` mm apart.

    Args:
        path: path of the file.
        step: largest distance of two points, mm.
        height: z of the inner face, 0, or of an edge of the land between broken edges, mm.

    Raises:
        FileError: the file cannot be read, is not in millimetres, or has not exactly one such rim, closed.
    """
    try:
        text = path.read_text(encoding="ascii")
    except (OSError, UnicodeError) as error:
        raise FileError(f"cannot read {path.name}: {error}") from error
    if not text.rstrip().endswith("END-ISO-10303-21;"):
        raise FileError(f"{path.name} is not a whole STEP file: export it again")
    if not _UNIT.search(text):
        raise FileError(f"{path.name} is not in millimetres: export it again")
    instances = {int(number): (kind, arguments) for number, kind, arguments in _INSTANCE.findall(text)}
    try:
        rims = _rims(instances, step, height)
    except (KeyError, IndexError, ValueError) as error:
        raise FileError(f"{path.name} is damaged: export it again") from error
    if len(rims) != 1:
        raise FileError(f"{path.name} has {len(rims)} closed rims of B-splines at z = {height:g} where one was wanted")
    return _outline(rims[0], path)


def _rims(instances: Instances, step: float, height: float) -> list[list[Array]]:
    """Points of every edge of every closed chain of B-splines at a height, joined by the vertices that they name."""
    edges = {}
    for kind, arguments in instances.values():
        if kind == "EDGE_CURVE":
            start, end, curve = _references(arguments)[:3]
            if instances[curve][0] == "B_SPLINE_CURVE_WITH_KNOTS":
                points = _points(instances, instances[curve][1], arguments.rstrip().endswith(".T."), step)
                if (np.abs(points[:, 2] - height) < _LEVEL).all():
                    edges[start, end] = points
    rims = []
    while edges:
        (first, at), points = edges.popitem()
        rim = [points]
        while at != first and (following := next((ends for ends in edges if at in ends), None)):
            points = edges.pop(following)
            rim.append(points if following[0] == at else points[::-1])
            at = following[following[0] == at]
        rims.append(rim)
    return rims


def _points(instances: Instances, arguments: str, forward: bool, step: float) -> Array:
    """Points along one B-spline, shape (n, 3), mm, evenly by its parameter; at least five."""
    poles, counts, knots = _LIST.findall(arguments)[:3]
    control = np.array([_numbers(_LIST.findall(instances[n][1])[0]) for n in _references(poles)])
    degree = int(_numbers(arguments.split("(")[0])[-1])
    spline = BSpline(np.repeat(_numbers(knots), _numbers(counts).astype(int)), control, degree)
    length = np.linalg.norm(np.diff(control, axis=0), axis=1).sum()
    count = max(5, int(np.ceil(length / step)) + 1)
    points = spline(np.linspace(spline.t[0], spline.t[-1], count))
    return np.asarray(points if forward else points[::-1])


def _outline(edges: list[Array], path: Path) -> Outline:
    gaps = [np.linalg.norm(a[-1] - b[0]) for a, b in zip(edges, edges[1:] + edges[:1], strict=True)]
    if max(gaps) > _JOINT:
        raise FileError(f"the rim in {path.name} is open by {max(gaps):.2g} mm: export it again")
    points = np.concatenate(edges)[:, :2]
    piece = np.repeat(np.arange(len(edges)), [len(edge) for edge in edges])
    clockwise = np.sum(cross(points, np.roll(points, -1, axis=0))) < 0
    return Outline(points[::-1], piece[::-1]) if clockwise else Outline(points, piece)


def _references(arguments: str) -> list[int]:
    return [int(number) for number in _REFERENCE.findall(arguments)]


def _numbers(arguments: str) -> Array:
    return np.array([float(field) for field in arguments.split(",") if re.fullmatch(r"\s*[-+.\dE]+\s*", field)])
