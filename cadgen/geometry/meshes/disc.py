"""The disc of a cam as a closed mesh, made of polygons by manifold3d and not by the CAD kernel."""

from itertools import pairwise

import numpy as np
from manifold3d import CrossSection, Error, FillRule, Manifold, Mesh64, triangulate

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.inset import chamfer_strips
from cadgen.curves.polygon import polygon, strip_polygons
from cadgen.errors import FileError
from cadgen.geometry.meshes.mesh import Mesh, drill, mesh_of
from cadgen.parts.blank import OVERSHOOT, PROFILE_STEP, Blank, Boss


def cam_mesh(
    profile: ClosedCurve, blank: Blank, thickness: float, chord_tolerance: float, rim_share: float = 0.5
) -> Mesh:
    """Return the disc with its bore, holes and hub; z = 0 is the inner face, z = thickness the outer one.

    Args:
        profile: profile of the rim, mm.
        blank: features of the disc besides its profile.
        thickness: thickness of the disc, mm.
        chord_tolerance: greatest distance of bore, holes and hub from the true shape, mm.
        rim_share: share of chord_tolerance allowed to the rim along its normal; the error of the lift is that over the
            cosine of the pressure angle.

    Raises:
        DesignError: a hole cuts into another one, into the hub or through the profile.
        CheckError: the chamfers of broken edges meet, or run out at a ridge.
    """
    blank.require_walls(profile.outline(PROFILE_STEP))
    holes = [contour.polygon(chord_tolerance) for contour in blank.holes()]
    bore, rim_chord = blank.bore(), rim_share * chord_tolerance
    boss = blank.boss(thickness)
    if boss is None:
        solid = _disc(profile, [bore.polygon(chord_tolerance), *holes], thickness, blank.edge_break, rim_chord)
    else:
        disc = _disc(profile, holes, thickness, blank.edge_break, rim_chord)
        solid = _with_hub(disc, boss, bore, thickness, chord_tolerance)
    return mesh_of(solid)


def _prism(polygons: list[Array], bottom: float, height: float) -> Manifold:
    section = CrossSection(polygons, FillRule.EvenOdd)
    return Manifold.extrude(section, height).translate((0.0, 0.0, bottom))


def _disc(profile: ClosedCurve, holes: list[Array], thickness: float, edge_break: float, chord: float) -> Manifold:
    """The disc with holes, the edges of its rim broken."""
    if edge_break == 0:
        return _prism([polygon(profile, chord), *holes], 0.0, thickness)
    outer, inner = strip_polygons(chamfer_strips(profile, edge_break), chord)
    rings, vertices = [], np.empty((0, 3))
    heights = 0.0, edge_break, thickness - edge_break, thickness
    for points, z in zip((inner, outer, outer, inner), heights, strict=True):
        # Where a side of the chamfer is a point it stands there once.
        new = np.any(points != np.roll(points, 1, axis=0), axis=1)
        rings.append(len(vertices) + (np.cumsum(new) - 1) % new.sum())
        vertices = np.vstack([vertices, np.column_stack([points[new], np.full(new.sum(), z)])])
    triangles = [
        np.concatenate([np.stack(corners, axis=1) for corners in ((a, a1, b1), (a, b1, b))])
        for a, b in pairwise(rings)
        for a1, b1 in [(np.roll(a, -1), np.roll(b, -1))]
    ]
    cap = triangulate([vertices[np.unique(rings[0]), :2]])
    triangles += [cap[:, ::-1] + rings[0].min(), cap + rings[-1].min()]
    faces = np.concatenate(triangles)
    whole = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    solid = Manifold(Mesh64(vertices, faces[whole].astype(np.uint64)))
    if solid.status() != Error.NoError:
        raise FileError("the mesh of the disc with broken edges does not close: report this design")
    if holes:
        solid -= _prism(holes, -OVERSHOOT, thickness + 2 * OVERSHOOT)
    return solid


def _with_hub(disc: Manifold, boss: Boss, bore: Contour, thickness: float, chord_tolerance: float) -> Manifold:
    """Set the hub on a disc without bore, then cut bore and set screw through both."""
    # From the disc's middle on, so that the two bodies do not merely touch.
    low, high = min(boss.low, thickness / 2), max(boss.high, thickness / 2)
    hub = _prism([circle((0.0, 0.0), boss.diameter / 2).polygon(chord_tolerance)], low, high - low)
    solid = disc + hub - _prism([bore.polygon(chord_tolerance)], boss.bottom, boss.top - boss.bottom)
    if boss.drill is None:
        return solid
    return solid - drill(boss.drill, circle((0.0, 0.0), boss.drill.diameter / 2).polygon(chord_tolerance))
