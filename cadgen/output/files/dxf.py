"""DXF (R2000, mm) for laser, wire EDM and CAD: an outline as arcs or as splines, the bore, the holes, a note.

`ezdxf` writes. The reader takes the file's tags itself: it must not share code with the writer, and the one
other reader at hand, trimesh's, drops the layer of a polyline with arcs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from math import cos, degrees, pi
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

from cadgen.arrays import Array
from cadgen.curves.biarc import arcs
from cadgen.curves.closed import Outline
from cadgen.curves.contour import Contour, circle
from cadgen.curves.spline import SplineArc, splines
from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.gears.layout import TrainPart
from cadgen.gears.rack import RackForm
from cadgen.gears.stage import Wheel, is_ring, rim_diameter
from cadgen.gears.tooth import GearForm
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, require
from cadgen.parts.loop import Arc, Loop, bezier_poles
from cadgen.parts.run import lead

if TYPE_CHECKING:
    from ezdxf.layouts import Modelspace

    from cadgen.output.files.exports import CamExport, GearExport, RackExport, TrainExport

# Greatest error of the lift due to a file, µm.
LIFT_LIMIT_UM = 1.0
# Greatest distance of a cam's cubic splines from the profile, mm: a tenth of the error allowed to the lift.
SPLINE_TOLERANCE = 1e-4
# Greatest distance of a gear's splines from the exact teeth, mm, and of what is read back.
OUTLINE_TOLERANCE, OUTLINE_LIMIT = 1e-5, 2e-5
_STEP = 0.05  # mm between points of a gear's outline that is read back
_AREA_LIMIT = 1e-3  # of chords as long as the step, relative
_NODES = np.linspace(0.0, 1.0, 4001)  # of each curve of a tooth, for comparison
PROFILE, BORE, HOLES, NOTES = "CAM_PROFILE", "BORE", "HOLES", "NOTES"
RIM = "RIM"  # outer circle of a ring, whose profile is inside
_COLORS = {PROFILE: 7, BORE: 1, HOLES: 5}  # AutoCAD colour index: black or white, red, blue
_NOTE_COLOR, _NOTE_HEIGHT = 3, 2.0  # green; mm, of the letters, and between them and the outline
_MM = 4  # $INSUNITS
_PLACE_MM = 1e-9  # of a bore or a hole, for the digits of a file
_GAP_MM = 1e-9  # between the end of a spline and the begin of the next, which are written alike


def cam_dxf(cam: CamExport, folder: Path) -> Iterator[Artifact]:
    """Outline of a cam as arcs and as splines, with bore, holes and a note on its edges."""
    tolerance = cam.export.arc_tolerance_um * 1e-3
    chain, cubic = arcs(cam.curve, tolerance), splines(cam.curve, SPLINE_TOLERANCE, 3)
    note = edges_note(cam.blank.edge_break, cam.follower.noun)
    for suffix, profile, facts in (
        ("arcs", chain, Facts(arcs=len(chain.bulges), arc_tolerance_um=tolerance * 1e3)),
        ("spline", cubic, Facts(splines=len(cubic))),
    ):
        name = f"{cam.stem}_{suffix}.dxf"
        write_dxf(folder / name, profile, cam.blank.bore(), cam.blank.holes(), note)
        drawing = read_dxf(folder / name, cam.step)
        require(drawing.note == note, name, Message("has lost its note on the edges"))
        whole = len(drawing.bore) == 1 and len(drawing.holes) == len(cam.blank.holes())
        require(whole, name, Message("has lost the bore or a hole"))
        yield cam.judged(name, drawing.profile, LIFT_LIMIT_UM, facts)


def edges_note(edge_break: float, follower: str) -> str:
    """Note for the shop on the edges, broken by `edge_break` mm, for files of the outline alone; empty where sharp.

    Args:
        edge_break: leg of the chamfer on both edges, mm.
        follower: name of the follower, which rides between the edges.
    """
    if edge_break == 0:
        return ""
    return (
        f"afterwards break both edges of the outline by {edge_break:g} mm at 45 degrees: "
        f"the {follower} rides between them"
    )


def write_dxf(
    path: Path,
    profile: Contour | Sequence[SplineArc],
    bore: Contour | None,
    holes: Sequence[Contour],
    note: str = "",
    rim: Contour | None = None,
) -> None:
    """Write a drawing of the disc, each kind of contour on its own layer; equal input gives equal bytes.

    Args:
        path: file to write.
        profile: chain of arcs, which becomes one closed LWPOLYLINE, or splines end to end, each a SPLINE; mm.
        bore: bore with its keyway or flat, mm; None for a part without.
        holes: lightening holes, mm.
        note: line of text under the outline, on a layer of its own that is not plotted; none if empty.
        rim: outer circle of a ring, mm; None for a part whose profile is its outside.
    """
    import ezdxf

    with fixed_dates():
        drawing = ezdxf.new("R2000", units=_MM)
        for name, color in _COLORS.items():
            drawing.layers.add(name, color=color)
        space = drawing.modelspace()
        if isinstance(profile, Contour):
            _add(space, profile, PROFILE)
            points = profile.polygon(0.01)
        else:
            for arc in profile:
                spline = space.add_spline(degree=arc.degree, dxfattribs={"layer": PROFILE})
                spline.control_points = np.pad(arc.control_points, ((0, 0), (0, 1)))
                spline.knots = arc.knots
            points = np.concatenate([arc.control_points for arc in profile])
        if rim is not None:
            drawing.layers.add(RIM, color=_COLORS[PROFILE])
            _add(space, rim, RIM)
            points = rim.polygon(0.01)
        if bore is not None:
            _add(space, bore, BORE)
        for hole in holes:
            _add(space, hole, HOLES)
        if note:
            left, low = points.min(axis=0).tolist()
            drawing.layers.add(NOTES, color=_NOTE_COLOR, plot=False)
            text = space.add_text(note, height=_NOTE_HEIGHT, dxfattribs={"layer": NOTES})
            text.set_placement((left, low - 2 * _NOTE_HEIGHT))
        space.reset_extents(*((*corner.tolist(), 0.0) for corner in (points.min(axis=0), points.max(axis=0))))
        drawing.saveas(path)


def write_curves(
    path: Path,
    curves: Mapping[str, Sequence[Contour | Sequence[SplineArc]]],
    bore: Contour,
    holes: Sequence[Contour],
) -> None:
    """Write closed curves on layers of their own, with bore and holes; equal input gives equal bytes.

    Args:
        path: file to write.
        curves: chains of arcs, or splines end to end, by their layer, mm.
        bore: bore with its keyway or flat, mm.
        holes: lightening holes, mm.
    """
    import ezdxf

    with fixed_dates():
        drawing = ezdxf.new("R2000", units=_MM)
        layers = [*curves, BORE, HOLES]
        for number, name in enumerate(layers):
            drawing.layers.add(name, color=_COLORS.get(name, 7 - number % 2))
        space = drawing.modelspace()
        for layer, ones in (*curves.items(), (BORE, [bore]), (HOLES, holes)):
            for one in ones:
                if isinstance(one, Contour):
                    _add(space, one, layer)
                    continue
                for arc in one:
                    spline = space.add_spline(degree=arc.degree, dxfattribs={"layer": layer})
                    spline.control_points = np.pad(arc.control_points, ((0, 0), (0, 1)))
                    spline.knots = arc.knots
        drawing.saveas(path)


def read_curves(path: Path, layers: Sequence[str], step: float) -> dict[str, Outline]:
    """Read one closed curve of arcs or of splines from each of some layers.

    Args:
        path: file to read.
        layers: layers with one curve each.
        step: distance between the points of the curves, mm.

    Raises:
        FileError: the file is damaged, not in mm, or a curve is missing or open.
    """
    contours: dict[str, list[Contour]] = {layer: [] for layer in layers}
    splines: dict[str, list[BSpline]] = {layer: [] for layer in layers}
    with _whole(path):
        for kind, entity in _drawn(path):
            layer = entity[8][0]
            if layer not in contours:
                continue
            points = np.array([entity[10], entity[20]], dtype=float).T
            if kind == "SPLINE":
                splines[layer].append(BSpline(np.array(entity[40], dtype=float), points, int(entity[71][0])))
            elif kind == "LWPOLYLINE" and int(entity[70][0]) & 1:
                contours[layer].append(Contour(points, np.array(entity[42], dtype=float)))
    read: dict[str, Outline] = {}
    for layer in layers:
        if splines[layer] and not contours[layer]:
            read[layer] = _along(splines[layer], step, path)
        elif len(contours[layer]) == 1 and not splines[layer]:
            read[layer] = contours[layer][0].outline(step)
        else:
            raise FileError(
                "{file} must have one closed curve on layer {layer}: write it again", file=path.name, layer=layer
            )
    return read


def _add(space: Modelspace, contour: Contour, layer: str) -> None:
    attributes = {"layer": layer}
    if contour.is_circle:
        space.add_circle(contour.centers[0].tolist(), float(contour.radii[0]), dxfattribs=attributes)
    else:
        sides = np.column_stack([contour.vertices, contour.bulges])
        space.add_lwpolyline(sides, format="xyb", close=True, dxfattribs=attributes)


@contextmanager
def fixed_dates() -> Iterator[None]:
    """Let ezdxf write the same dates and identifiers every time."""
    import ezdxf

    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


@dataclass(frozen=True)
class Drawing:
    """Content of a drawing.

    Attributes:
        profile: points of the CAM_PROFILE layer, one piece an arc or a spline.
        bore: contours of the BORE layer.
        holes: contours of the HOLES layer.
        note: text of the NOTES layer.
        rim: contours of the RIM layer.
    """

    profile: Outline
    bore: tuple[Contour, ...]
    holes: tuple[Contour, ...]
    note: str = ""
    rim: tuple[Contour, ...] = ()


def read_dxf(path: Path, step: float = 0.05) -> Drawing:
    """Read a drawing of lines, arcs, circles and splines.

    Args:
        path: file to read.
        step: distance between the points of the profile, mm.

    Raises:
        FileError: the file is damaged, not in mm, or its profile is missing or open.
    """
    contours: dict[str, list[Contour]] = {layer: [] for layer in (*_COLORS, RIM)}
    splines: list[BSpline] = []
    notes: list[str] = []
    with _whole(path):
        for kind, entity in _drawn(path):
            layer = entity[8][0]
            if kind == "TEXT" and layer == NOTES:
                notes.append(entity[1][0])
                continue
            points = np.array([entity[10], entity[20]], dtype=float).T
            if kind == "SPLINE" and layer == PROFILE:
                splines.append(BSpline(np.array(entity[40], dtype=float), points, int(entity[71][0])))
            elif kind == "CIRCLE":
                contours[layer].append(circle(points[0], float(entity[40][0])))
            elif kind == "LWPOLYLINE" and int(entity[70][0]) & 1:
                contours[layer].append(Contour(points, np.array(entity[42], dtype=float)))
            else:
                raise FileError(
                    "{file} has a {kind} on layer {layer}, open or unexpected: write it again",
                    file=path.name,
                    kind=kind,
                    layer=layer,
                )
    profile = contours[PROFILE]
    if splines and not profile:
        outline = _along(splines, step, path)
    elif len(profile) == 1 and not splines:
        outline = profile[0].outline(step)
    else:
        raise FileError(
            "{file} must have one closed curve on layer {layer}: write it again", file=path.name, layer=PROFILE
        )
    return Drawing(outline, tuple(contours[BORE]), tuple(contours[HOLES]), " ".join(notes), tuple(contours[RIM]))


@contextmanager
def _whole(path: Path) -> Iterator[None]:
    """Say of a damaged file that it is one."""
    try:
        yield
    except (KeyError, ValueError, IndexError) as error:
        raise FileError("{file} is not a complete DXF file of a disc: write it again", file=path.name) from error


def _drawn(path: Path) -> Iterator[tuple[str, dict[int, list[str]]]]:
    """Kind and values of each entity of a file, which must be in millimetres."""
    lines = path.read_text(encoding="cp1252").splitlines()
    # A tag is a line with a code and a line with a value.
    tags = [(int(code), value.strip()) for code, value in zip(lines[::2], lines[1::2], strict=True)]
    if tags[-1] != (0, "EOF"):
        raise ValueError("cut short")
    begins = [i for i, tag in enumerate(tags) if tag == (0, "SECTION")] + [len(tags)]
    sections = {tags[begin + 1][1]: tags[begin + 2 : end] for begin, end in pairwise(begins)}
    header = sections["HEADER"]
    if int(header[header.index((9, "$INSUNITS")) + 1][1]) != _MM:
        raise FileError("{file} is not in millimetres: write it again", file=path.name)
    yield from _entities(sections["ENTITIES"])


Tag = tuple[int, str]


def _entities(tags: list[Tag]) -> Iterator[tuple[str, dict[int, list[str]]]]:
    """Kind of each entity and its values by code; a vertex (10) whose bulge (42) is left out has bulge 0."""
    begins = [i for i, (code, _) in enumerate(tags) if code == 0]
    for begin, end in pairwise(begins):
        entity: dict[int, list[str]] = {}
        for code, value in tags[begin + 1 : end]:
            if code == 42 and 42 in entity:
                entity[42][-1] = value
                continue
            entity.setdefault(code, []).append(value)
            if code == 10:
                entity.setdefault(42, []).append("0")
        yield tags[begin][1], entity


def _along(splines: list[BSpline], step: float, path: Path) -> Outline:
    """Points on splines end to end."""
    ends = np.array([spline(spline.t[[0, -1]]) for spline in splines])
    if np.abs(ends[:, 1] - np.roll(ends[:, 0], -1, axis=0)).max() > _GAP_MM:
        raise FileError(
            "{file} has a gap between two splines on layer {layer}: write it again", file=path.name, layer=PROFILE
        )
    points = []
    for spline in splines:
        length = np.linalg.norm(np.diff(spline.c, axis=0), axis=1).sum()
        points.append(spline(np.linspace(spline.t[0], spline.t[-1], max(5, int(length / step) + 2))))
    owner = np.repeat(np.arange(len(points)), [len(part) for part in points])
    return Outline(np.concatenate(points), owner)


def gear_dxf(gear: GearExport, folder: Path) -> Iterator[Artifact]:
    """Outline of a gear as splines, with its bore and holes, or with the outer circle of a ring."""
    yield from gear_outlines(folder, gear.part, gear.name)


def train_dxf(train: TrainExport, folder: Path) -> Iterator[Artifact]:
    """Outline of each gear of a train, in the frame of its part."""
    for part in train.layout.parts:
        yield from gear_outlines(folder, part, f"{train.stem}_{part.name}")


def gear_outlines(
    folder: Path, part: TrainPart, stem: str, ending: str = "", *, drilled: bool = True
) -> Iterator[Artifact]:
    """Write the transverse section of each gear of a part, that of a helical one at its lower face, and read it back.

    Args:
        folder: folder for the files.
        part: part with its gears, of which the first has the lightening holes.
        stem: start of the files' names.
        ending: end of the files' names.
        drilled: whether lightening holes are drawn.

    Raises:
        FileError: a file holds something else when it is read back.
    """
    bore = part.blank.bore() if part.blank.bore_diameter else None
    holes = next((slab.holes for slab in part.body.slabs if slab.holes), ()) if drilled else ()
    for number, gear in enumerate(part.gears, 1):
        name = f"{stem}{f'_{number}' if len(part.gears) > 1 else ''}{ending}.dxf"
        rim = circle((0.0, 0.0), rim_diameter(gear) / 2) if is_ring(gear) else None
        inside = [] if bore is None or rim else [bore]
        if number == 1 and not rim:
            arcs = [curve for hole in holes for curve in hole.curves if isinstance(curve, Arc)]
            inside += [circle((arc.centre.real, arc.centre.imag), arc.radius) for arc in arcs]
        section = gear.outline.from_below(gear.width)
        error = write_outline(folder / name, section, inside, rim, _lean(gear))
        yield Artifact(
            name, Facts(outline_error_um=error * 1e3), (Message("outline off by {off:.3f} µm", off=error * 1e3),)
        )


def _lean(gear: Wheel) -> str:
    """Note on the section of a helical gear; empty for teeth along the axis."""
    if not isinstance(gear, GearForm) or not gear.helix_angle:
        return ""
    hand = "right" if gear.helix_angle > 0 else "left"
    kind = "double helix, below" if gear.double else "helix"
    length = lead(gear.helix_angle, gear.reference_diameter)
    return (
        f"transverse section at the lower face: {kind} {abs(degrees(gear.helix_angle)):g} degrees, {hand} hand, "
        f"lead {length:.4f} mm"
    )


def write_outline(
    path: Path, outline: Loop, inside: Sequence[Contour], rim: Contour | None = None, note: str = ""
) -> float:
    """Write the outline of a gear, and return its greatest distance from the exact teeth, read back, mm.

    Args:
        path: file to write.
        outline: exact section of the teeth, mm.
        inside: bore and holes inside it, the bore first, mm; none of a ring.
        rim: outer circle of a ring, mm; None for a gear with teeth outside.
        note: line of text beside it.

    Raises:
        FileError: the file holds something else when it is read back.
    """
    bored = inside[:1]
    write_dxf(path, _teeth(outline), bored[0] if bored else None, inside[1:], note, rim)
    drawing = read_dxf(path, _STEP)
    error = _distance(drawing.profile.points, outline)
    # Points on the teeth may leave out a tooth; the area does not.
    x, y = drawing.profile.points.T
    area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2
    if abs(area / outline.area - 1) > _AREA_LIMIT:
        raise FileError("{file}, read back, does not enclose the teeth: report this design", file=path.name)
    if error > OUTLINE_LIMIT:
        raise FileError(
            "{file}, read back, is {error:.2g} µm off the exact teeth: report this design",
            file=path.name,
            error=error * 1e3,
        )
    read = (*drawing.bore, *drawing.holes, *drawing.rim)
    drawn = (*inside, *([rim] if rim else []))
    same = len(read) == len(drawn) and all(map(alike, read, drawn))
    require(same and drawing.note == note, path.name, Message("has another bore, hole, rim or note"))
    return error


def alike(read: Contour, drawn: Contour) -> bool:
    """Whether a contour read back is that which was drawn, to the rounding of the file.

    Args:
        read: contour read back.
        drawn: contour that was written.
    """
    return read.vertices.shape == drawn.vertices.shape and bool(
        np.allclose(read.vertices, drawn.vertices, rtol=0, atol=_PLACE_MM)
        and abs(read.area() - drawn.area()) <= _PLACE_MM * drawn.area()
    )


def _teeth(outline: Loop) -> list[SplineArc]:
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


def rack_dxf(rack: RackExport, folder: Path) -> Iterator[Artifact]:
    """Transverse section of a rack at its lower face as splines; its straight sides are splines of degree 1."""
    name, form = f"{rack.name}.dxf", rack.form
    note = ""
    if form.helix_angle:
        hand = "right" if form.helix_angle > 0 else "left"
        note = f"transverse section: helix {abs(degrees(form.helix_angle)):g} degrees, {hand} hand"
    write_dxf(folder / name, _rack_section(form), None, (), note)
    drawing = read_dxf(folder / name, _STEP)
    points = drawing.profile.points @ [1, 1j]
    error = float(_off_rack(points, form).max())
    area = float(np.sum(points.real * np.roll(points.imag, -1) - np.roll(points.real, -1) * points.imag)) / 2
    require(abs(area / form.area - 1) <= _AREA_LIMIT, name, Message("does not enclose the teeth"))
    require(error <= OUTLINE_LIMIT, name, Message("is {error:.2g} µm off the exact teeth", error=error * 1e3))
    require(drawing.note == note, name, Message("has another bore, hole, rim or note"))
    yield Artifact(
        name, Facts(outline_error_um=error * 1e3), (Message("outline off by {off:.3f} µm", off=error * 1e3),)
    )


def _rack_section(form: RackForm) -> list[SplineArc]:
    """Section of a rack, counterclockwise: fillets as Bézier curves, stretched along the bar, and straight sides."""
    radius, stretch = form.fillet_factor * form.normal_module, 1 / cos(form.helix_angle)
    quarter = bezier_poles(Arc(radius, -pi / 2, pi / 2 - form.normal_pressure_angle), OUTLINE_TOLERANCE / stretch)
    bend = quarter.real * stretch + 1j * (quarter.imag + radius)
    root, back = -form.dedendum_factor * form.normal_module, -form.back_height
    here = complex(0.0, root)
    pieces = []
    for start, deep, left, right, low, end in form.corners():
        up, down = start + bend, end - np.conj(bend[::-1])
        up[[0, -1]], down[[0, -1]] = (start, deep), (low, end)
        pieces += [
            np.array([here, start]),
            up,
            np.array([deep, left]),
            np.array([left, right]),
            np.array([right, low]),
            down,
        ]
        here = end
    ends = [here, complex(form.length, root), complex(form.length, back), complex(0.0, back), complex(0.0, root)]
    pieces += [np.array(side) for side in pairwise(ends)]
    return [
        SplineArc(
            degree=len(poles) - 1,
            knots=np.repeat([0.0, 1.0], len(poles)),
            control_points=np.stack([poles.real, poles.imag], axis=1),
        )
        for poles in (piece[::-1] for piece in pieces[::-1])
    ]


def _off_rack(points: Array, form: RackForm) -> Array:
    """Distance of points on a rack's section from its sides and, folded into half a tooth, from its exact teeth, mm."""
    radius, stretch = form.fillet_factor * form.normal_module, 1 / cos(form.helix_angle)
    half = form.pitch / 2
    x = np.abs((points.real % form.pitch) - half) / stretch  # from the middle of the tooth, in the normal section
    start, deep, corner = (complex(half - each.real, each.imag) for each in form.corners()[0][:3])
    start, deep, corner = (complex(each.real / stretch, each.imag) for each in (start, deep, corner))
    seen = x + 1j * points.imag
    flank = (corner - deep) / abs(corner - deep)
    centre = start + 1j * radius
    off = np.stack(
        [
            np.where(seen.real >= start.real, np.abs(seen.imag - start.imag), np.inf),
            np.where(
                (seen.real <= start.real) & (seen.imag <= deep.imag), np.abs(np.abs(seen - centre) - radius), np.inf
            ),
            np.where(seen.imag >= deep.imag, np.abs(((seen - deep) * np.conj(flank)).imag), np.inf),
            np.where(seen.real <= corner.real, np.abs(seen.imag - corner.imag), np.inf),
            np.abs(points.imag + form.back_height),
            np.abs(points.real),
            np.abs(points.real - form.length),
        ]
    )
    return np.asarray(off.min(axis=0))
