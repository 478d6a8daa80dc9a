"""Exact edges where a drilled hole meets a round wall or a slanting floor.

Two cylinders meet in a curve that is neither a line nor a conic. The kernel's boolean follows it within a tolerance
that it then understates. A STEP file gives it without its parameters on the surfaces, which readers find by too few of
its points: they see the edge beside its surfaces, by 2e-5 mm, and miss the volume by 3e-5 of itself. The same goes for
an ellipse on a cylinder. Here every such edge gets the curve from its equation, in space and in the parameters of both
surfaces. It is one spline of so many spans that all three are right to 1e-8 mm.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.collections import Array1_gp_Pnt, Array1_gp_Pnt2d
from OCP.Geom import Geom_BSplineCurve, Geom_CylindricalSurface, Geom_Plane
from OCP.Geom2d import Geom2d_BSplineCurve
from OCP.GeomAbs import GeomAbs_BSplineCurve, GeomAbs_Ellipse
from OCP.gp import gp_Dir, gp_Pnt, gp_Pnt2d
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopExp import TopExp
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape
from scipy.interpolate import BSpline, make_interp_spline

from cadgen.arrays import TURN, Array
from cadgen.errors import FileError
from cadgen.geometry.solids.kernel import TOLERANCE, faces, filled, knots_of, parts_of

_DEGREE = 5
_ERROR = 1e-8  # mm; a tenth of the kernel's smallest distance
_FEWEST_SPANS, _MOST_SPANS = 8, 2048
_PARALLEL = 1 - 1e-9  # cosine of the angle between axes above which nothing crosses
_SEAM = 1e-6  # rad; an edge that ends so near to a cylinder's seam ends on it


class _Side(NamedTuple):
    """A round or flat face at an edge: its frame's origin and axes, and its radius, infinite for a plane."""

    face: TopoDS_Face
    origin: Array
    x: Array
    y: Array
    axis: Array
    radius: float

    @classmethod
    def of(cls, face: TopoDS_Face) -> "_Side | None":
        surface = BRep_Tool.Surface_s(face)
        if not isinstance(surface, Geom_CylindricalSurface | Geom_Plane):
            return None
        frame = surface.Position()
        x, y, axis = (_vector(way) for way in (frame.XDirection(), frame.YDirection(), frame.Direction()))
        radius = surface.Radius() if isinstance(surface, Geom_CylindricalSurface) else np.inf
        return cls(face, _vector(frame.Location()), x, y, axis, radius)

    def parameters(self, points: Array, near: Array) -> Array:
        """Parameters of points on the surface, angles within half a turn of `near` (rad), shape (n, 2)."""
        off = points - self.origin
        if self.radius == np.inf:
            return np.stack([off @ self.x, off @ self.y], axis=1)
        angle = np.arctan2(off @ self.y, off @ self.x)
        return np.stack([near + (angle - near + np.pi) % TURN - np.pi, off @ self.axis], axis=1)

    def reach(self, foot: Array, axis: Array, near: float) -> Array:
        """Distance of the surface along lines, mm; of two crossings, the nearer to `near`.

        Args:
            foot: start of each line, shape (n, 3), mm.
            axis: direction of the lines, shape (3,).
            near: approximate distance, mm.
        """
        off = foot - self.origin
        if self.radius == np.inf:
            return np.asarray(-(off @ self.axis) / (axis @ self.axis))
        # Square to the cylinder's axis, |off + v ahead| = radius.
        off = off - np.outer(off @ self.axis, self.axis)
        ahead = axis - (axis @ self.axis) * self.axis
        half, square = off @ ahead, ahead @ ahead
        root = np.sqrt(np.maximum(half**2 - square * (np.sum(off**2, axis=1) - self.radius**2), 0.0))
        both = np.stack([-half - root, -half + root]) / square
        return np.asarray(both[int(np.argmin(np.abs(both.mean(axis=1) - near)))])


def with_exact_crossings(shape: TopoDS_Shape) -> TopoDS_Shape:
    """Replace the edges of a shape between a hole and a round wall or a slanting floor by exact edges.

    Raises:
        FileError: the two are so nearly of one size that no spline follows where they meet.
    """
    edges: list[tuple[TopoDS_Edge, list[_Side]]] = []
    for face in map(TopoDS.Face, faces(shape)):
        side = _Side.of(face)
        if side is None:
            continue
        for edge in map(TopoDS.Edge, parts_of(face, TopAbs_EDGE)):
            if BRepAdaptor_Curve(edge).GetType() in (GeomAbs_BSplineCurve, GeomAbs_Ellipse):
                known = next((sides for earlier, sides in edges if earlier.IsSame(edge)), None)
                if known is None:
                    edges.append((edge, [side]))
                else:
                    known.append(side)
    for edge, sides in edges:
        drill, wall = min(sides, key=lambda side: side.radius), max(sides, key=lambda side: side.radius)
        if len(sides) == 2 and drill.radius < np.inf and abs(drill.axis @ wall.axis) < _PARALLEL:
            _replace(edge, drill, wall)
    return shape


def _replace(edge: TopoDS_Edge, drill: _Side, wall: _Side) -> None:
    curve = BRepAdaptor_Curve(edge)
    first, last = curve.FirstParameter(), curve.LastParameter()
    on_drill, on_wall = (BRep_Tool.CurveOnSurface_s(edge, side.face, first, last) for side in (drill, wall))
    ends = [on_drill.Value(t).X() for t in (first, last)]
    ends = [seam if abs(end - (seam := round(end / TURN) * TURN)) < _SEAM else end for end in ends]

    def exact(t: Array) -> Array:
        """Points, and parameters on the drill and on the wall, shape (n, 7)."""
        share = (t - first) / (last - first)
        angle = ends[0] + share * (ends[1] - ends[0])
        foot = drill.origin + drill.radius * (np.cos(angle)[:, None] * drill.x + np.sin(angle)[:, None] * drill.y)
        along = wall.reach(foot, drill.axis, on_drill.Value((first + last) / 2).Y())
        points = foot + along[:, None] * drill.axis
        near = np.array([on_wall.Value(float(s)).X() for s in t])
        return np.column_stack([points, angle, along, wall.parameters(points, near)])

    spline = _fitted(exact, first, last)
    builder = BRep_Builder()
    knots, rows = knots_of(spline.t), np.asarray(spline.c)
    in_space = filled(Array1_gp_Pnt, [gp_Pnt(*row) for row in rows[:, :3].tolist()])
    builder.UpdateEdge(edge, Geom_BSplineCurve(in_space, *knots, _DEGREE), TOLERANCE)
    for side, columns in ((drill, slice(3, 5)), (wall, slice(5, 7))):
        on_surface = filled(Array1_gp_Pnt2d, [gp_Pnt2d(*row) for row in rows[:, columns].tolist()])
        builder.UpdateEdge(edge, Geom2d_BSplineCurve(on_surface, *knots, _DEGREE), side.face, TOLERANCE)
    builder.SameRange(edge, True)
    builder.SameParameter(edge, True)
    builder.Range(edge, first, last)
    for vertex, t in ((TopExp.FirstVertex_s(edge), first), (TopExp.LastVertex_s(edge), last)):
        builder.UpdateVertex(vertex, gp_Pnt(*spline(t)[:3].tolist()), TOLERANCE)


def _fitted(exact: Callable[[Array], Array], first: float, last: float) -> BSpline:
    """The spline through exact rows at even parameters: from uneven ones readers find a poor curve on the surface."""
    spans = _FEWEST_SPANS
    while spans <= _MOST_SPANS:
        nodes = np.linspace(first, last, spans + 1)
        spline = make_interp_spline(nodes, exact(nodes), k=_DEGREE)
        between = np.linspace(first, last, 8 * spans + 1)
        if np.abs(spline(between) - exact(between)).max() < _ERROR:
            return spline
        spans *= 2
    raise FileError("the set screw's hole is about as wide as the bore that it meets: give it a smaller diameter")


def _vector(place: gp_Pnt | gp_Dir) -> Array:
    return np.array([place.X(), place.Y(), place.Z()])
