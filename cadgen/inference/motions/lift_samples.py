"""Samples of a motion from a measured cam: of lifts by angle, or of points of its outline.

A point of the outline with its normal tells the cam angle at which the follower touches it, and the motion there. A
normal that is off turns the follower along the curve it moves on, so the sample stays on the motion to first order:
normals from a few neighbours are good enough, and the noise of a sample is that of its own point.
"""

from dataclasses import dataclass
from math import ceil, radians, sqrt

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Follower
from cadgen.laws.lift_table import noise_of

_BESIDE = 4  # points to each side at least, of which a normal is taken
_WINDOW = radians(1.5)  # about the centre, to each side
_MOST = 1080  # samples of a turn; of more, neighbours are taken together
_ARC = radians(15.0)  # of a circle about the camshaft at least, to tell its centre
_ARC_NOISE = 1.6  # times the noise that points on a circle are off it
_SAME_POINT = 1e-9  # mm
_SLOPE_WINDOW = radians(2.5)  # to each side, over which a slope is taken
_SLOPE_BESIDE = 3  # samples to each side at least
_STILL = 5.0  # times its standard deviation, below which a slope is none
_LEAST_RISE = 0.01  # of the travel; a smaller one is no flank
_LEAST_NOISES = 25.0


@dataclass(frozen=True, kw_only=True)
class LiftSamples:
    """Samples of a motion in the order of their cam angles, shape (n,) each.

    Attributes:
        cam_angle: cam angles, rad, from some 0 on, within a turn.
        q: motion measured, in its unit.
        push: displacement of the surface along its normal by the motion, mm by unit.
        normal: angle of the outward normal in the disc's frame, rad; None where lifts were measured.
        noise: standard deviation of a sample along the normal, mm.
    """

    cam_angle: Array
    q: Array
    push: Array
    normal: Array | None
    noise: float

    @property
    def centred(self) -> Array:
        """Displacement along the normal by a shift of the disc's centre along x and y, shape (n, 2)."""
        assert self.normal is not None
        return np.stack([np.cos(self.normal), np.sin(self.normal)], axis=1)


def samples_of_lifts(cam_angle: Array, q: Array, push: Array | None = None) -> LiftSamples:
    """Samples of lifts that were read by the cam angle.

    Args:
        cam_angle: cam angles, rad, shape (n,).
        q: lifts, in the motion's unit, shape (n,).
        push: displacement along the normal by the motion, mm by unit; 1 if left out.
    """
    angle = np.mod(cam_angle, TURN)
    order = np.argsort(angle, kind="stable")
    return _made(angle[order], q[order], np.ones_like(q) if push is None else push[order], None)


def samples_of_points(points: Array, normals: Array, follower: Follower) -> LiftSamples:
    """Samples of points of an outline.

    Args:
        points: points from the camshaft in the disc's frame, mm, shape (n, 2).
        normals: outward unit normals, shape (n, 2).
        follower: follower, whose base circle may be any.
    """
    angle, q = follower.touching(points, normals)
    angle = np.mod(angle, TURN)
    order = np.argsort(angle, kind="stable")
    angle, q = angle[order], q[order]
    turn = np.arctan2(normals[order, 1], normals[order, 0])
    step = 1e-6
    # Another motion at the cam angle: by how much the outline's tangent there is further out.
    moved = follower.touching(points[order] + step * normals[order], normals[order])[1]
    return _made(angle, q, step / np.maximum(moved - q, 1e-12), turn)


def _made(angle: Array, q: Array, push: Array, normal: Array | None) -> LiftSamples:
    apart = np.append(np.diff(angle) > 1e-9, True)
    angle, q, push = angle[apart], q[apart], push[apart]
    normal = None if normal is None else normal[apart]
    # By differences of neighbours, in the unit of the motion, and no less than the digits have.
    steps = np.diff(np.unique(q))
    digits = float(np.median(steps)) / sqrt(12.0) if len(steps) and len(steps) < len(q) / 2 else 0.0
    fourth = np.abs(np.convolve(q, [1.0, -4.0, 6.0, -4.0, 1.0], "valid"))
    noise = max(noise_of(angle, q), digits, float(np.median(fourth)) / (0.6745 * sqrt(70.0)) / 2)
    noise *= float(np.median(push))
    count = -(-len(angle) // _MOST)
    if count > 1:
        many = len(angle) // count * count
        angle, q, push = (each[:many].reshape(-1, count).mean(axis=1) for each in (angle, q, push))
        if normal is not None:
            turned = np.exp(1j * normal[:many]).reshape(-1, count).mean(axis=1)
            normal = np.angle(turned)
        noise /= np.sqrt(count)
    return LiftSamples(cam_angle=angle, q=q, push=push, normal=normal, noise=noise)


def ordered(points: Array) -> Array:
    """Points of an outline counter-clockwise round their middle, each once, shape (n, 2).

    Args:
        points: points in any order, mm, shape (n, 2).
    """
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    off = points - middle
    order = np.argsort(np.arctan2(off[:, 1], off[:, 0]), kind="stable")
    points = points[order]
    apart = np.hypot(*(points - np.roll(points, 1, axis=0)).T) > _SAME_POINT
    return np.asarray(points[apart])


def normals_of(points: Array) -> Array:
    """Outward unit normals of an outline by parabolas through neighbours, shape (n, 2).

    Args:
        points: points counter-clockwise, mm, shape (n, 2).
    """
    n = len(points)
    half = min(max(_BESIDE, ceil(_WINDOW * n / TURN)), max((n - 1) // 2, 1))
    number = (np.arange(n)[:, None] + np.arange(-half, half + 1)) % n
    near = points[number]
    step = np.hypot(*np.moveaxis(np.diff(near, axis=1), 2, 0))
    along = np.concatenate([np.zeros((n, 1)), np.cumsum(step, axis=1)], axis=1)
    along -= along[:, half : half + 1]
    along /= np.abs(along).max(axis=1, keepdims=True)
    basis = np.stack([np.ones_like(along), along, along**2], axis=2)
    slope = np.linalg.pinv(basis)[:, 1, :]
    tangent = np.einsum("nk,nkd->nd", slope, near)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    return np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)


def centre_of(points: Array) -> Array | None:
    """Centre of the longest arc of an outline that is a circle to within its noise, mm, shape (2,); None without one.

    A dwell is such an arc, and its centre is the camshaft.

    Args:
        points: points counter-clockwise, mm, shape (n, 2).
    """
    n = len(points)
    beside = np.roll(points, 1, axis=0) + np.roll(points, -1, axis=0)
    bend = 6 * points - 4 * beside + np.roll(points, 2, axis=0) + np.roll(points, -2, axis=0)
    # Noise of the points along their normals, mm, by fourth differences.
    across = np.sum(bend * normals_of(points), axis=1)
    noise = max(float(np.median(np.abs(across)) / 0.6745 / np.sqrt(70.0)), 1e-5)
    best: tuple[float, Array] | None = None
    width = max(7, n // 24)
    for first in range(0, n, max(1, width // 6)):
        count, found = width, None
        while count <= n:
            part = points[(first + np.arange(count)) % n]
            centre, radius = _circle(part)
            off = np.hypot(*(part - centre).T) - radius
            # An arc that bows wanders by more than noise does: means of eighths against their scatter.
            eighths = np.max(np.abs([eighth.mean() for eighth in np.array_split(off, 8)]))
            if np.sqrt(np.mean(off**2)) > _ARC_NOISE * noise or eighths > 4.5 * noise / np.sqrt(len(off) / 8):
                break
            found = (count, centre, part)
            count += max(1, width // 6)
        if found is not None:
            count, centre, part = found
            turned = part - centre
            around = np.unwrap(np.arctan2(turned[:, 1], turned[:, 0]))
            reach = float(abs(around[-1] - around[0]))
            if reach >= _ARC and (best is None or reach > best[0]):
                best = (reach, centre)
    return None if best is None else best[1]


def _circle(points: Array) -> tuple[Array, float]:
    """Centre and radius of the circle nearest to points, by Gauss and Newton from the algebraic one."""
    middle = points.mean(axis=0)
    off = points - middle
    matrix = np.column_stack([2 * off, np.ones(len(off))])
    a, b, c = np.linalg.lstsq(matrix, np.sum(off**2, axis=1), rcond=None)[0]
    centre, radius = np.array([a, b]), float(np.sqrt(max(c + a * a + b * b, 1e-12)))
    for _ in range(4):
        ray = off - centre
        distance = np.maximum(np.hypot(*ray.T), 1e-12)
        step = np.linalg.lstsq(
            np.column_stack([ray / distance[:, None], np.ones(len(off))]), distance - radius, rcond=None
        )[0]
        centre, radius = centre + step[:2], radius + float(step[2])
    return middle + centre, radius


@dataclass(frozen=True)
class SeenFlank:
    """Flank as it is seen: a stretch in which the motion only rises or only falls.

    Attributes:
        start: cam angle at which the slope begins to show, rad.
        stop: cam angle at which it ceases to, rad, greater than the start.
    """

    start: float
    stop: float


def seen_flanks(samples: LiftSamples) -> tuple[SeenFlank, ...]:
    """Flanks of a turn, in order from the first that begins after cam angle 0.

    Args:
        samples: samples of the motion.
    """
    angle, height = samples.cam_angle, samples.q * np.median(samples.push)
    slope, error = _slopes(angle, height, samples.noise)
    sign = np.where(np.abs(slope) < _STILL * error, 0, np.sign(slope)).astype(int)
    least = max(_LEAST_RISE * float(np.ptp(height)), _LEAST_NOISES * samples.noise)
    if not sign.any():
        return ()
    n = len(sign)
    # Begin where a stretch begins.
    starts = [k for k in range(n) if sign[k] != sign[k - 1]]
    if not starts:
        return ()
    found: list[SeenFlank] = []
    for place, begin in enumerate(starts):
        end = starts[(place + 1) % len(starts)]
        length = (end - begin) % n or n
        if not sign[begin]:
            continue
        rows = (begin + np.arange(length)) % n
        if abs(float(height[rows[-1]] - height[rows[0]])) < least:
            continue
        start = float(angle[rows[0]])
        stop = float(angle[rows[-1]])
        found.append(SeenFlank(start, stop if stop > start else stop + TURN))
    return tuple(sorted(found, key=lambda each: each.start))


def _slopes(angle: Array, height: Array, noise: float) -> tuple[Array, Array]:
    """Slope at each sample by a straight line through neighbours, and its standard deviation, shape (n,) each."""
    n = len(angle)
    half = max(_SLOPE_BESIDE, round(_SLOPE_WINDOW * n / TURN))
    number: NDArray[np.intp] = (np.arange(n)[:, None] + np.arange(-half, half + 1)) % n
    near = np.mod(angle[number] - angle[:, None] + TURN / 2, TURN) - TURN / 2
    near -= near.mean(axis=1, keepdims=True)
    power = np.sum(near**2, axis=1)
    return np.sum(near * height[number], axis=1) / power, max(noise, 1e-6) / np.sqrt(power)
