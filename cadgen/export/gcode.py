"""The milling program (G-code) of a profile: G2 and G3 arcs along the cutter's centre."""

import re
from collections.abc import Sequence
from math import ceil, degrees
from pathlib import Path

import numpy as np

from cadgen.cam.cutter import CutterLimit
from cadgen.curves.biarc import arcs
from cadgen.curves.closed import ClosedCurve, left_normal, polar_angle
from cadgen.curves.contour import Contour
from cadgen.curves.offset import parallel
from cadgen.design.schema import Machining
from cadgen.errors import CheckError

DECIMALS = 4  # of a coordinate: hobby controllers read as many, and rounding is 0.05 um at most
# An arc that bulges less than the rounding is a line; so none is left whose rounded ends coincide, which a
# controller would take for a full circle.
_STRAIGHT = 10.0**-DECIMALS / 2
# The search for the farthest point: samples of a piece, then of two spans, in rounds down to about 1e-5 mm.
_COARSE, _FINE, _ROUNDS = 1025, 33, 4


def cutter_path(curve: ClosedCurve, cutter_radius: float, limit: CutterLimit, tolerance: float) -> Contour:
    """Return the path of a cutter's centre round a profile as arcs, run clockwise.

    It begins at its point farthest from the camshaft. The whole path lies inside the circle through that
    point, so an arc that leaves it outwards along the tangent cannot take the cutter into the disc.

    Args:
        curve: profile, counterclockwise, mm.
        cutter_radius: radius of the cutter, mm.
        limit: largest cutter for the profile, from `cadgen.cam.cutter.largest_cutter`.
        tolerance: greatest distance of the arcs from the exact path, mm.

    Raises:
        CheckError: the cutter is too large for a hollow of the profile, or a corner of it is hollow.
    """
    if limit.point is not None and limit.radius and cutter_radius > limit.radius:
        raise CheckError(
            f"machining.cutter_diameter_mm is {2 * cutter_radius:g}, but no cutter of more than "
            f"{2 * limit.radius:.3f} mm reaches the hollow at polar angle "
            f"{degrees(float(polar_angle(limit.point))) % 360:.1f} degrees: choose a smaller cutter"
        )
    path = parallel(curve, cutter_radius)
    return arcs(path.begun_at(*_farthest(path)), tolerance).reversed()


def write_gcode(
    path: Path,
    centre: Contour,
    machining: Machining,
    thickness: float,
    *,
    name: str,
    hub_height: float = 0.0,
    notes: Sequence[str] = (),
) -> None:
    """Write the program that mills a disc's outline from outside, in equal passes, by climb milling.

    With a spindle that turns clockwise, the path runs clockwise round the part and so keeps it on its right:
    the teeth enter at full chip and leave at the finished wall.

    Args:
        path: file to write.
        centre: path of the cutter's centre, clockwise, from `cutter_path`, mm.
        machining: cutter, speeds and heights, units in the names.
        thickness: thickness of the disc, mm.
        name: name of the design, for the first comment.
        hub_height: height of a hub above the disc's outer face, mm; rapid moves pass above it.
        notes: further comments for the shop on this outline.
    """
    depth = thickness + machining.break_through_mm
    passes = ceil(depth / machining.step_down_mm - 1e-9)
    round_once = _round_once(centre, machining.lead_radius_mm, machining.feed_mm_per_min)
    height = machining.safe_height_mm + hub_height
    safe = _words(Z=height)
    above = f", its hub stands {hub_height:g} mm above that face" if hub_height else ""
    lines = [
        f"({_plain(name)}: outline of the cam, milled from outside)",
        *(f"({_plain(note)})" for note in notes),
        *(
            f"({word}: {_plain(said)})"
            for word, said in (("stock", machining.stock), ("fixture", machining.fixture))
            if said
        ),
        f"(cutter diameter {machining.cutter_diameter_mm:g} mm, no radius compensation at the machine)",
        "(climb milling: spindle clockwise, clockwise round the part)",
        "(zero: centre of the bore, outer face of the disc; cam angle 0 along +X, outer face up)",
        f"(disc {thickness:g} mm thick{above}; hold the part by its bore, the last pass of {passes} cuts it free)",
        "(bore, keyway and holes are not in this program)",
        f"(the first move lifts the cutter where it stands, to {height:g} mm: be above every clamp at that height)",
        "G21 G90 G17 G40 G94 G91.1",
        *([] if machining.tool_number is None else [f"T{machining.tool_number} M6"]),
        f"S{machining.spindle_rpm:g} M3",
        f"G0 {safe}",
    ]
    for number in range(1, passes + 1):
        lines += [
            f"(pass {number} of {passes})",
            round_once[0],
            f"G1 {_words(Z=-depth * number / passes)} F{machining.plunge_feed_mm_per_min:g}",
            *round_once[1:],
            f"G0 {safe}",
        ]
    lines += ["M5", "M30"]
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


def _round_once(centre: Contour, lead: float, feed: float) -> list[str]:
    """The lines of one pass: the rapid move to its begin, and the cuts from there through both leads."""
    start = centre.vertices[:1]
    ahead = centre.curve().pieces[0].jet(np.zeros(1)).velocity
    ahead = lead * ahead / np.linalg.norm(ahead)
    out = lead * left_normal(ahead)
    quarter = np.tan(np.pi / 8)
    # The arcs' centres come from the rounded ends, so that both radii of an arc agree. The last side, from
    # lead-out to lead-in, closes the chain and is not cut.
    vertices = np.vstack([start + out - ahead, centre.vertices, start, start + out + ahead]).round(DECIMALS)
    chain = Contour(vertices, np.concatenate([[quarter], centre.bulges, [quarter, 0.0]]))
    length = np.linalg.norm(chain.chords, axis=1)
    straight = np.abs(chain.bulges) * length / 2 < _STRAIGHT
    to_centre = chain.centers - vertices
    lines = [f"G0 {_words(X=vertices[0, 0], Y=vertices[0, 1])}"]
    for i in range(len(vertices) - 1):
        end = _words(X=vertices[i + 1, 0], Y=vertices[i + 1, 1])
        if not straight[i]:
            turn = "G3" if chain.bulges[i] > 0 else "G2"
            lines.append(f"{turn} {end} {_words(I=to_centre[i, 0], J=to_centre[i, 1])}")
        elif length[i] > 0:
            lines.append(f"G1 {end}")
    lines[1] += f" F{feed:g}"
    return lines


def _farthest(curve: ClosedCurve) -> tuple[int, float]:
    """Piece and parameter of the point farthest from the origin."""
    reach = [
        np.linalg.norm(piece.jet(np.linspace(piece.start, piece.stop, _COARSE)).point, axis=1).max()
        for piece in curve.pieces
    ]
    number = int(np.argmax(reach))
    piece = curve.pieces[number]
    t = np.linspace(piece.start, piece.stop, _COARSE)
    for _ in range(_ROUNDS):
        top = int(np.argmax(np.linalg.norm(piece.jet(t).point, axis=1)))
        t = np.linspace(t[max(top - 1, 0)], t[min(top + 1, len(t) - 1)], _FINE)
    return number, float(t[_FINE // 2])


def _plain(text: str) -> str:
    """Text as it may stand in a comment."""
    return re.sub(r"[^ -~]|[()]", "_", text)


def _words(**values: float) -> str:
    """Address words with the coordinate's decimals; + 0.0 turns a negative zero positive."""
    return " ".join(f"{letter}{round(float(value), DECIMALS) + 0.0:.{DECIMALS}f}" for letter, value in values.items())
