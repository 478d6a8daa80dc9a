"""A disc anywhere in space, and the rod let down on it: an oracle for what a disc that is a little off does.

Its two edges are curves in space; they are moved as a rigid body, and the rod, a cylinder that turns about the fork
axis, is turned back until it clears every point of both. Nothing here is linear or shared with what it judges.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.cam.followers.rod import LeaningRod
from cadgen.curves.closed import ClosedCurve

_NEAR = np.radians(3.0)  # points farther from the ray to the rod cannot carry it


@dataclass(frozen=True)
class Disc:
    """Edges of a disc about its own shaft: points of shape (n, 2), mm, by growing polar angle, and normals."""

    points: np.ndarray
    normals: np.ndarray

    @classmethod
    def of(cls, curve: ClosedCurve, step: float = 0.01) -> "Disc":
        points = curve.outline(step).points
        points = points[np.argsort(np.arctan2(points[:, 1], points[:, 0]))]
        tangent = np.roll(points, -3, axis=0) - np.roll(points, 3, axis=0)
        normals = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
        return cls(points, normals / np.linalg.norm(normals, axis=1)[:, None])


def rest(
    disc: Disc,
    rod: LeaningRod,
    theta: np.ndarray,
    *,
    shift: tuple[float, float] = (0.0, 0.0),
    tilt: tuple[float, float] = (0.0, 0.0),
    height: float = 0.0,
    taper: float = 0.0,
    scale: float = 1.0,
) -> np.ndarray:
    """tan(beta) at cam angles.

    Args:
        disc: as it was cut.
        rod: the rod and the faces.
        theta: cam angles, rad.
        shift: of the disc on its shaft, in its own frame, mm.
        tilt: by which the disc leans so that its side at polar angle 0 (90 degrees) goes outwards, rad.
        height: of the rod's axis, mm.
        taper: by which the outer edge is larger than the inner one along the normal, mm.
        scale: of the disc about its shaft and middle.
    """
    middle = (rod.inner + rod.outer) / 2
    edges = []
    for face, grown in ((rod.inner, -taper / 2), (rod.outer, taper / 2)):
        plane = disc.points + grown * disc.normals
        body = scale * np.column_stack([plane, np.full(len(plane), face - middle)])
        edges.append((body @ _leaning(tilt).T) + [*shift, middle])
    angle = np.arctan2(disc.points[:, 1], disc.points[:, 0])
    found = []
    for turn in theta:
        c, s = np.cos(turn), np.sin(turn)
        needed = []
        for edge in edges:
            begin, stop = np.searchsorted(angle, np.array([-_NEAR, _NEAR]) + (turn + np.pi) % (2 * np.pi) - np.pi)
            x0, y0, w = np.take(edge, np.arange(begin - 600, stop + 600), axis=0, mode="wrap").T
            x, y = x0 * c + y0 * s - rod.base_radius, y0 * c - x0 * s - height
            under = np.abs(y) < rod.radius
            x, w, square = x[under], w[under], rod.radius**2 - y[under] ** 2
            # (w T - x)^2 = h^2 (1 + T^2): the rod's axis passes the point at the distance of its radius.
            a, b, last = w**2 - square, -x * w, x**2 - square
            needed.append(((-b + np.sqrt(b * b - a * last)) / a).max())
        found.append(max(needed))
    return np.array(found)


def _leaning(tilt: tuple[float, float]) -> np.ndarray:
    """Rotation by the size of the tilt about the axis in the disc's plane that is square to it (Rodrigues)."""
    size = np.hypot(*tilt)
    if size == 0:
        return np.eye(3)
    towards = np.array([*tilt, 0.0]) / size
    axis = np.cross(towards, [0.0, 0.0, 1.0])
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(size) * cross + (1 - np.cos(size)) * cross @ cross
