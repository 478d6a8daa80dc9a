"""Nearest approach by brute force: the car set down in fine steps, distances from points and sides by hand.

Shares nothing with the program: no shapely, no bounds, no halving. Rows are numpy arrays of steps.
"""

import numpy as np


def corners_on_floor(corners, fork, heading):
    """Corners (k, 2) in the car's frame, with the fork axis at `fork` (n, 2) and headings (n,): shape (n, k, 2)."""
    c, s = np.cos(heading)[:, None], np.sin(heading)[:, None]
    x, y = np.asarray(corners, float).T
    return np.stack([fork[:, :1] + c * x - s * y, fork[:, 1:] + s * x + c * y], axis=-1)


def to_segments(points, a, b):
    """Distance of points (..., 2) from segments a-b (..., 2)."""
    ab, ap = b - a, points - a
    t = np.clip((ap * ab).sum(-1) / np.maximum((ab * ab).sum(-1), 1e-30), 0, 1)
    return np.linalg.norm(ap - t[..., None] * ab, axis=-1)


def inside(points, polygon):
    """Whether points (n, 2) lie in polygons (n, k, 2), by the number of sides that a ray crosses."""
    x, y = points[:, :1], points[:, 1:]
    ax, ay = polygon[..., 0], polygon[..., 1]
    bx, by = np.roll(ax, -1, 1), np.roll(ay, -1, 1)
    meets = (ay > y) != (by > y)
    at = ax + (y - ay) / np.where(meets, by - ay, 1.0) * (bx - ax)
    return (meets & (x < at)).sum(1) % 2 == 1


def between(first, second, filled):
    """Distance between polygons (n, k, 2) and a line or polygon (m, 2), at n steps; less than 0 where they cross."""
    first = np.asarray(first)
    n = len(first)
    second = np.asarray(second, float)
    a, b = first, np.roll(first, -1, axis=1)
    ends = np.roll(second, -1, axis=0) if filled else second[1:]
    starts = second if filled else second[:-1]
    if len(second) == 1:
        starts, ends = second, second
    d = np.full(n, np.inf)
    for p in second:
        d = np.minimum(d, to_segments(p[None, None], a, b).min(1))
    for s, e in zip(starts, ends, strict=True):
        d = np.minimum(d, to_segments(first, s[None, None], e[None, None]).min(1))
    covered = inside(np.broadcast_to(second[0], (n, 2)), first)
    if filled:
        area = np.broadcast_to(second, (n, *second.shape))
        covered |= inside(first[:, 0], area)
    for s, e in zip(starts, ends, strict=True):
        covered |= _cross(a, b, s, e).any(1)
    return np.where(covered, -1.0, d)


def _cross(a, b, s, e):
    def turn(p, q, r):
        return (q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0])

    return (turn(a, b, s) * turn(a, b, e) < 0) & (turn(s, e, a) * turn(s, e, b) < 0)
