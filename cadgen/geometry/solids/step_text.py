"""STEP files read from their own text: a second reader that shares nothing with the CAD kernel.

**Of a cam** it reads the rim (ISO 10303-21 and -42): at one height a closed chain of edges that are all
B_SPLINE_CURVE_WITH_KNOTS, evaluated here by scipy. A rim with broken edges has such a chain on either side of its land.

**Of a gear** it reads the tooth curves, and the solid for comparison. Flanks and roots are Bézier curves, which STEP
writes as B-splines of one span. Each is set against the exact curve of its tooth, point by point at equal parameters,
and the section that they enclose is measured in mesh. Walls of helical teeth are Bézier patches. At any height such a
patch is a Bézier curve again, which is turned back by the exact angle there; so a wrong lead shows as flanks that are
off.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from cadgen.arrays import Array
from cadgen.curves.closed import Outline, cross
from cadgen.errors import FileError
from cadgen.gears.stage import Wheel, is_bar, is_ring
from cadgen.geometry.meshes.teeth import CHORD_TOLERANCE, ToothSection
from cadgen.parts.loop import (
    Arc,
    Curve,
    CutterTrochoid,
    EllipseArc,
    Involute,
    Loop,
    Trochoid,
    bernstein,
    chord_parameters,
)

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
        raise FileError("cannot read {name}: {error}", name=path.name, error=str(error)) from error
    if not text.rstrip().endswith("END-ISO-10303-21;"):
        raise FileError("{name} is not a whole STEP file: export it again", name=path.name)
    if not _UNIT.search(text):
        raise FileError("{name} is not in millimetres: export it again", name=path.name)
    instances = {int(number): (kind, arguments) for number, kind, arguments in _INSTANCE.findall(text)}
    try:
        rims = _rims(instances, step, height)
    except (KeyError, IndexError, ValueError) as error:
        raise FileError("{name} is damaged: export it again", name=path.name) from error
    if len(rims) != 1:
        raise FileError(
            "{name} has {rims} closed rims of B-splines at z = {height:g} where one was wanted",
            name=path.name,
            rims=len(rims),
            height=height,
        )
    return _outline(rims[0], path)


def read_flanks(path: Path, step: float, height: float) -> tuple[Outline, Outline]:
    """Return both flanks of a groove at a height, the inner one first.

    Args:
        path: path of the file.
        step: largest distance of two points, mm.
        height: z of the face or of the floor, mm.

    Raises:
        FileError: the file cannot be read, or has not exactly two such curves, closed.
    """
    try:
        instances = {int(n): (kind, rest) for n, kind, rest in _INSTANCE.findall(path.read_text(encoding="ascii"))}
        rims = sorted(_rims(instances, step, height), key=lambda rim: float(np.abs(np.concatenate(rim)[:, 0]).max()))
    except (OSError, UnicodeError, KeyError, IndexError, ValueError) as error:
        raise FileError("{name} is damaged: export it again", name=path.name) from error
    if len(rims) != 2:
        raise FileError(
            "{name} has {rims} closed rims of B-splines at z = {height:g} where two were wanted",
            name=path.name,
            rims=len(rims),
            height=height,
        )
    return _outline(rims[0], path), _outline(rims[1], path)


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
        raise FileError("the rim in {name} is open by {gap:.2g} mm: export it again", name=path.name, gap=max(gaps))
    points = np.concatenate(edges)[:, :2]
    piece = np.repeat(np.arange(len(edges)), [len(edge) for edge in edges])
    clockwise = np.sum(cross(points, np.roll(points, -1, axis=0))) < 0
    return Outline(points[::-1], piece[::-1]) if clockwise else Outline(points, piece)


def _references(arguments: str) -> list[int]:
    return [int(number) for number in _REFERENCE.findall(arguments)]


def _numbers(arguments: str) -> Array:
    return np.array([float(field) for field in arguments.split(",") if re.fullmatch(r"\s*[-+.\dE]+\s*", field)])


_SOLID = re.compile(r"#(\d+)=MANIFOLD_SOLID_BREP\(.*?(?=#\d+=(?:STYLED_ITEM|\(GEOMETRIC_REPRESENTATION_CONTEXT))")
_POINT = re.compile(r"#(\d+)=CARTESIAN_POINT\('',\(([^)]*)\)\)")
_BEZIER = re.compile(
    r"=B_SPLINE_CURVE_WITH_KNOTS\('',\d+,\(([^)]*)\),\.UNSPECIFIED\.,\.F\.,\.F\.,\((\d+),\2\),\(0\.,1\.\)"
)
_PATCH = re.compile(
    r"=B_SPLINE_SURFACE_WITH_KNOTS\('',(\d+),(\d+),\(\((.*?)\)\),\.UNSPECIFIED\.,\.F\.,\.F\.,\.F\.,"
    r"\((\d+),\4\),\((\d+),\5\),\(0\.,1\.\),\(0\.,1\.\)"
)
_HEIGHT_DECIMALS = 6  # of a mm, to which patches begin at one height
_CIRCLE = re.compile(r"=CIRCLE\('',#(\d+),([^)]*)\)")
_AXES = re.compile(r"#(\d+)=AXIS2_PLACEMENT_3D\('',#(\d+),")
_ROOTS: tuple[type[Curve], ...] = (Trochoid, CutterTrochoid)
_SAMPLES = np.linspace(0.0, 1.0, 33)
# Ends of curves that belong together are no further apart, in mm: the rounding of the poles and no more.
_SAME_END = 1e-6
# Every tooth curve stands at both ends of its wall, and once more as what the wall's surface is swept from.
_TIMES_WRITTEN = 3


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class GearContent:
    """Content of a part's STEP file.

    Attributes:
        solid: text of the solid, as by `solids_in`.
        sections: section of every gear, from below.
        flank_error: greatest distance of a flank from the exact flank, mm; None without teeth.
        root_error: greatest distance of a root curve from the exact root curve, mm; None without teeth.
        rim_error: greatest distance of an arc of a rim without teeth from the exact one, mm; None if all have teeth.
        lead_error: greatest difference of the flanks' distances between two heights, mm; None without helical teeth.
        slices: sections of every gear at its lower end, midway and at its upper end, turned back by the helix; of a
            gear that is no helical one the one section that it has.
    """

    solid: bytes
    sections: tuple[ToothSection, ...]
    flank_error: float | None
    root_error: float | None
    rim_error: float | None
    lead_error: float | None = None
    slices: tuple[tuple[ToothSection, ...], ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class _Curves:
    """Bézier curves of one degree: poles, shape (n, degree + 1), and heights, shape (n,), in mm."""

    poles: NDArray[np.complex128]
    height: NDArray[np.float64]


def solids_in(text: str) -> list[bytes]:
    """Texts of the solids in a STEP file, numbers counted from the first, so that equal solids have equal texts."""
    solids = []
    for solid in _SOLID.finditer("".join(text.split())):
        words = re.split(r"#(\d+)", solid[0])
        numbers = np.array(words[1::2], dtype=np.int64) - int(solid[1])
        solids.append("#".join(words[::2]).encode() + numbers.tobytes())
    return solids


def read_gear(path: Path, gears: Sequence[Wheel], starts: Sequence[float]) -> GearContent:
    """Read a part with `gears` that begin at the heights `starts` (mm).

    Raises `FileError` if the file cannot be read, is not of one solid, or has other tooth curves than the gears.
    """
    try:
        bare = "".join(path.read_text(encoding="ascii").split())
    except (OSError, UnicodeError) as error:
        raise FileError("cannot read {name}: {error}", name=path.name, error=str(error)) from error
    solids = solids_in(bare)
    if not bare.endswith("END-ISO-10303-21;") or len(solids) != 1 or "SI_UNIT(.MILLI.,.METRE.)" not in bare:
        raise FileError("{name} is not a whole STEP file of one solid in mm: export it again", name=path.name)
    curves = _curves(bare, path)
    slices: list[tuple[ToothSection, ...]] = []
    lead_error: float | None = None
    errors: dict[type[Curve], float] = {}
    for wheel, start in zip(gears, starts, strict=True):
        outline, heights = wheel.outline, (start, start + wheel.width)
        if is_bar(wheel):
            off, sections = _read_bar(outline, heights, bare, path)
            errors[Involute] = max(errors.get(Involute, 0.0), off)
            errors[Trochoid] = max(errors.get(Trochoid, 0.0), _fillet_error(outline, start, bare, curves, path))
            slices.append(sections)
            continue
        if not outline.run.straight:
            helical = _read_helical(outline, start, wheel.width, bare, path, ring=is_ring(wheel))
            for kind, off in helical.errors.items():
                errors[kind] = max(errors.get(kind, 0.0), off)
            lead_error = max(lead_error or 0.0, helical.lead_error)
            slices.append(helical.slices)
            continue
        tooth_curves = [exact for exact in outline.curves if _is_tooth_curve(exact)]
        if not tooth_curves:
            errors[Arc] = max(errors.get(Arc, 0.0), _rim_error(outline, bare, heights, path))
            slices.append((ToothSection(outline.polygon(CHORD_TOLERANCE).reshape(outline.repeats, -1)),))
            continue
        rows: list[NDArray[np.complex128]] = []
        for exact in tooth_curves:
            if isinstance(exact, Arc):
                rounding = replace(outline, curves=(exact,))
                errors[Trochoid] = max(errors.get(Trochoid, 0.0), _rim_error(rounding, bare, heights, path))
                points = exact.point(chord_parameters(exact, CHORD_TOLERANCE))
                rows.append(outline.turns[:, None] * points)
                continue
            poles = _matched(exact, outline.repeats, curves, heights, path)
            deviation = float(np.abs(_across(poles, exact)).max())  # over all teeth
            errors[type(exact)] = max(errors.get(type(exact), 0.0), deviation)
            rows.append(poles @ bernstein(poles.shape[1] - 1, chord_parameters(exact, CHORD_TOLERANCE)).T)
        slices.append((ToothSection(np.concatenate(rows, axis=1), is_ring(wheel)),))
    return GearContent(
        solid=solids[0],
        sections=tuple(each[len(each) // 2] for each in slices),
        flank_error=errors.get(Involute),
        root_error=max((errors[kind] for kind in _ROOTS if kind in errors), default=None),
        rim_error=errors.get(Arc),
        lead_error=lead_error,
        slices=tuple(slices),
    )


def _read_bar(
    outline: Loop, heights: tuple[float, float], bare: str, path: Path
) -> tuple[float, tuple[ToothSection, ...]]:
    """Sections of a rack at both ends of its width and midway, and the greatest error of a corner, mm.

    Flanks, tips and roots of a rack are straight, so their ends say where they are.
    """
    places = np.array([[float(number) for number in place.split(",")] for _, place in _POINT.findall(bare)])
    counts = [len(chord_parameters(curve, CHORD_TOLERANCE)) - 1 for curve in outline.curves]
    first = np.cumsum([0, *counts[:-1]])
    corners = outline.polygon(CHORD_TOLERANCE)
    ends, worst = [], 0.0
    for height in heights:
        wanted = corners[first] + outline.run.lean * (height - heights[0])
        level = places[np.abs(places[:, 2] - height) < _LEVEL]
        found = level[:, 0] + 1j * level[:, 1]
        if not len(found):
            raise FileError("{name} has other teeth than this gear: export it again", name=path.name)
        nearest = found[np.abs(found[:, None] - wanted).argmin(axis=0)]
        worst = max(worst, float(np.abs(nearest - wanted).max()))
        read = corners.copy()
        read[first] = nearest - outline.run.lean * (height - heights[0])
        ends.append(read)
    return worst, tuple(ToothSection(read[None]) for read in (ends[0], (ends[0] + ends[1]) / 2, ends[1]))


def _fillet_error(outline: Loop, height: float, bare: str, curves: Sequence[_Curves], path: Path) -> float:
    """Greatest distance of the fillets of a rack in the file from the exact ones, at its lower face, mm."""
    worst = _rim_error(outline, bare, (height, height), path)
    for exact in (curve for curve in outline.curves if isinstance(curve, EllipseArc)):
        ends, off = exact.point([0.0, 1.0]), np.inf
        for each in curves:
            near = (np.abs(each.poles[:, [0, -1]] - ends).max(axis=1) < _SAME_END) & (each.height == height)
            if near.any():
                off = float(np.abs(_across(each.poles[near][:1], exact)).max())
        worst = max(worst, off)
    return worst


class _Helical(NamedTuple):
    """Teeth of a helical wheel as read: errors of its curves by their kind, mm, of its lead, mm, and its sections."""

    errors: dict[type[Curve], float]
    lead_error: float
    slices: tuple[ToothSection, ...]


def _is_tooth_curve(curve: Curve) -> bool:
    """Whether a curve is a flank or a root, and no land, circle or chamfer."""
    return isinstance(curve, Involute | Trochoid | CutterTrochoid) or (isinstance(curve, Arc) and curve.centre != 0)


def _read_helical(outline: Loop, start: float, width: float, bare: str, path: Path, *, ring: bool) -> _Helical:
    """Teeth of a wheel whose section turns from the height `start` on, mm; `outline` is that midway."""
    run, patches = outline.run, _patches(bare, path)
    middle, teeth = run.angle(width / 2), outline.repeats
    exacts = [exact for exact in outline.curves if _is_tooth_curve(exact)]
    errors: dict[type[Curve], float] = {}
    offsets: list[NDArray[np.float64]] = []
    slices: dict[float, ToothSection] = {}
    for low, high in run.pieces(width):
        for share in (0.0, 0.5, 1.0):
            height = low + share * (high - low)
            back = np.exp(1j * (middle - run.angle(height)))
            cut = [patch.section(share, back) for patch in patches if patch.spans(start + low, start + high)]
            rows, mean = [], []
            for exact in exacts:
                poles = _of_teeth(exact, teeth, cut, 1, path)
                off = _across(poles, exact)
                kind = Trochoid if isinstance(exact, Arc) else type(exact)
                errors[kind] = max(errors.get(kind, 0.0), float(np.abs(off).max()))
                if isinstance(exact, Involute):
                    mean.append(off.mean(axis=1))
                rows.append(poles @ bernstein(poles.shape[1] - 1, chord_parameters(exact, CHORD_TOLERANCE)).T)
            offsets.append(np.concatenate(mean))
            slices[height] = ToothSection(np.concatenate(rows, axis=1), ring)
    ends = (0.0, width / 2, width)
    chosen = tuple(slices[min(slices, key=lambda height: abs(height - wanted))] for wanted in ends)
    return _Helical(errors, float(np.ptp(offsets, axis=0).max()), chosen)


@dataclass(frozen=True, slots=True, eq=False)
class _Patches:
    """Bézier patches of one size: poles, shape (n, p, q), mm, and the heights that they begin and end at, (n,), mm."""

    poles: NDArray[np.complex128]
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    def spans(self, low: float, high: float) -> bool:
        """Whether any of them reach from one height to another, mm."""
        return bool(((np.abs(self.low - low) < _SAME_END) & (np.abs(self.high - high) < _SAME_END)).any())

    def section(self, share: float, turn: complex) -> NDArray[np.complex128]:
        """Poles of all at a share of their height, turned, shape (n, p)."""
        return np.asarray(self.poles @ bernstein(self.poles.shape[2] - 1, np.array([share]))[0] * turn)


def _patches(bare: str, path: Path) -> list[_Patches]:
    """Patches of the file by their size and heights; their heights rise evenly."""
    points = dict(_POINT.findall(bare))
    sizes: dict[tuple[int, int], list[str]] = {}
    for u, v, poles, *_ in _PATCH.findall(bare):
        sizes.setdefault((int(u) + 1, int(v) + 1), []).append(poles)
    found = []
    try:
        for (u, v), texts in sizes.items():
            names = ",".join(texts).replace("),(", ",").split(",")
            places = ",".join(points[name[1:]] for name in names).split(",")
            x, y, z = np.array(places, dtype=np.float64).reshape(-1, u, v, 3).transpose(3, 0, 1, 2)
            even = np.linspace(z[:, :, 0], z[:, :, -1], v, axis=2)
            level = (np.abs(z - even).max(axis=(1, 2)) < _SAME_END) & (np.ptp(z[:, :, 0], axis=1) < _SAME_END)
            low, high = np.round(z[level, 0, 0], _HEIGHT_DECIMALS), np.round(z[level, 0, -1], _HEIGHT_DECIMALS)
            for ends in sorted(set(zip(low.tolist(), high.tolist(), strict=True))):
                of_these = (low == ends[0]) & (high == ends[1])
                found.append(_Patches((x + 1j * y)[level][of_these], low[of_these], high[of_these]))
    except (KeyError, ValueError) as error:
        raise FileError("{name} is damaged: export it again", name=path.name) from error
    return found


def _across(poles: NDArray[np.complex128], exact: Curve) -> NDArray[np.float64]:
    """Distance of the copies of a curve from the exact one, across it, by tooth and parameter, mm."""
    turns = np.exp(-2j * np.pi / len(poles) * np.arange(len(poles)))
    off = (poles @ bernstein(poles.shape[1] - 1, _SAMPLES).T) * turns[:, None] - exact.point(_SAMPLES)
    return np.asarray((off * np.conj(exact.tangent(_SAMPLES))).imag)


def _rim_error(outline: Loop, bare: str, heights: tuple[float, float], path: Path) -> float:
    """Greatest distance of the arcs of a rim without teeth from the file's circles, at both of its ends, mm."""
    points, axes = dict(_POINT.findall(bare)), dict(_AXES.findall(bare))
    try:
        circles = np.array(
            [
                [*map(float, points[axes[place]].split(",")), float(radius)]
                for place, radius in _CIRCLE.findall(bare)
                if place in axes  # and not in the plane of a surface's parameters
            ]
        ).reshape(-1, 4)
    except (KeyError, ValueError) as error:
        raise FileError("{name} is damaged: export it again", name=path.name) from error
    worst = 0.0
    for arc in (curve for curve in outline.curves if isinstance(curve, Arc)):
        for centre in arc.centre * outline.turns:
            for height in heights:
                wanted = np.array([centre.real, centre.imag, height, arc.radius])
                off = np.abs(circles - wanted).sum(axis=1).min(initial=np.inf)
                worst = max(worst, float(off))
    return worst


def _curves(bare: str, path: Path) -> list[_Curves]:
    points = dict(_POINT.findall(bare))
    by_count: dict[str, list[str]] = {}
    for poles, count in _BEZIER.findall(bare):
        by_count.setdefault(count, []).append(poles)
    groups = []
    try:
        for count, texts in by_count.items():
            places = ",".join(points[name[1:]] for name in ",".join(texts).split(","))
            x, y, z = np.array(places.split(","), dtype=np.float64).reshape(-1, int(count), 3).transpose(2, 0, 1)
            flat = np.all(z == z[:, :1], axis=1)  # where a set screw meets a hub, curves rise
            groups.append(_Curves((x + 1j * y)[flat], z[flat, 0]))
    except (KeyError, ValueError) as error:
        raise FileError("{name} is damaged: export it again", name=path.name) from error
    return groups


def _matched(
    exact: Curve, teeth: int, curves: list[_Curves], heights: tuple[float, float], path: Path
) -> NDArray[np.complex128]:
    """Poles of the file's copies of a tooth curve by tooth, shape (teeth, degree + 1)."""
    within = [
        group.poles[(group.height >= heights[0] - _SAME_END) & (group.height <= heights[1] + _SAME_END)]
        for group in curves
    ]
    return _of_teeth(exact, teeth, within, _TIMES_WRITTEN, path)


def _of_teeth(
    exact: Curve, teeth: int, groups: Sequence[NDArray[np.complex128]], times: int, path: Path
) -> NDArray[np.complex128]:
    """Poles of a tooth curve by tooth, shape (teeth, degree + 1), of which each is written so many times.

    Args:
        exact: curve of tooth 0.
        teeth: number of teeth.
        groups: poles of the curves in the file, by degree, shape (n, degree + 1).
        times: how often each curve stands in the file.
        path: path of the file.
    """
    turns = np.exp(2j * np.pi / teeth * np.arange(teeth))
    ends = np.outer(turns, exact.point([0.0, 1.0]))
    for poles in groups:
        if not len(poles):
            continue
        poles_at_ends = poles[:, [0, -1]]
        turned = np.angle(poles_at_ends[:, 0] / ends[0, 0])
        tooth = np.rint(turned * teeth / (2 * np.pi)).astype(int) % teeth
        near = np.abs(poles_at_ends - ends[tooth]).max(axis=1) <= _SAME_END
        counts = np.bincount(tooth[near], minlength=teeth)
        if np.all(counts == times):
            by_tooth = np.empty((teeth, poles.shape[1]), dtype=np.complex128)
            by_tooth[tooth[near]] = poles[near]
            copies = poles[near] / turns[tooth[near], None]
            spread = float(np.abs(copies - copies[0]).max())
            if spread > _SAME_END:
                raise FileError(
                    "{name} has teeth that differ by {spread:.2g} mm: export it again", name=path.name, spread=spread
                )
            return by_tooth
    raise FileError(
        "{name} does not have all the flanks and roots of {teeth} teeth: export it again", name=path.name, teeth=teeth
    )
