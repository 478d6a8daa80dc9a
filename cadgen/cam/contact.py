"""Roll the rod on an outline: the steering, and so the lift, that a disc really gives.

This shares nothing with the envelope. At cam angle theta a point of the disc lies x ahead of the camshaft and y
across. In the face plane w the rod, pressed on the disc by its spring, clears the point when
    x <= a + w T - h sqrt(1 + T^2),  h^2 = r^2 - y^2,  T = tan(beta),
so the least T that clears it is the greater root of a quadratic,
    T = (w u + h sqrt(u^2 + w^2 - h^2)) / (w^2 - h^2),  u = x - a.
The rod rests on the point, of both faces' outlines, that asks for the greatest T. Between the faces the bound is
linear in w, so the faces decide.
"""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from cadgen.cam.follower import Follower
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.errors import DesignError

Array = NDArray[np.float64]

_TURN = 2 * np.pi

# Steps of an outline, mm, between which `roll_curve` chooses, and the change of lift at which it is content. The
# error falls with the third power of the step, so what is left is an eighth of the last change: 0.0025 um.
COARSEST_STEP = 0.06
FINEST_STEP = 5e-4
ROLLING_TOLERANCE = 2e-5
_POINTS_PER_RADIUS = 20  # of the rod at least, or two steps could agree by chance
# What a disc of any size may take: points on its outline, and points under the rod. The least rod on the largest disc
# that the schema allows still has some points under it.
_MOST_POINTS = 1_500_000
_MOST_UNDER = 10_000
# Stations handled at once, so that the table of candidates stays within the processor's cache; fewer if it is wide.
_BLOCK = 128
_TABLE = 500_000


@dataclass(frozen=True)
class Contact:
    """Where the rod rests at each cam angle; all arrays have shape (n,).

    Attributes:
        cam_angle: rad.
        tan_beta: of the steering angle that results.
        lift: s, mm.
        face: lateral distance of the face that carries the rod, mm.
        margin: lift by which that face lifts the rod further than the other face alone would, mm; where it is no
            more than `ROLLING_TOLERANCE` either face may be the one that carries.
        across: y of the contact point, mm, ahead in the sense of growing polar angle.
        pressure_angle: between the force on the rod and the velocity of its axis, rad; positive where the
            outline rises under the rod. The axis moves horizontally and the force is square to it, so
            sin(pressure angle) = across / r; for the rod's axis on its own curve tan = (dR/dphi) / R.
    """

    cam_angle: Array
    tan_beta: Array
    lift: Array
    face: Array
    margin: Array
    across: Array
    pressure_angle: Array


def roll_curve(curve: ClosedCurve, follower: Follower, cam_angle: Array) -> tuple[Contact, float]:
    """Roll the rod on an exact curve, in steps halved until the lift no longer changes.

    Only the cam angles that still change are rolled again, so a cam that needs fine steps in one steep place is not
    sampled finely throughout.

    Returns:
        The contact, and the finest step that was needed, mm: what is read back from a file needs it too.

    Raises:
        DesignError: as `roll`.
    """
    cam_angle = np.atleast_1d(np.asarray(cam_angle, dtype=float))
    step = rolling_step(curve, follower)
    finest = max(FINEST_STEP, curve.length() / _MOST_POINTS, 2 * follower.radius / _MOST_UNDER)
    contact = roll(curve.outline(step), follower, cam_angle)
    pending = np.arange(len(cam_angle))
    while pending.size and step > finest:
        step /= 2
        finer = roll(curve.outline(step), follower, cam_angle[pending])
        changed = np.abs(finer.lift - contact.lift[pending]) > ROLLING_TOLERANCE
        for name in ("tan_beta", "lift", "face", "margin", "across", "pressure_angle"):
            getattr(contact, name)[pending] = getattr(finer, name)
        pending = pending[changed]
    return contact, step


def rolling_step(curve: ClosedCurve, follower: Follower, coarsest: float = COARSEST_STEP) -> float:
    """The step of an outline at which a rod can be rolled on it, mm: the coarsest, or less for a thin rod."""
    if follower.radius == 0:
        return coarsest
    return max(min(coarsest, follower.radius / _POINTS_PER_RADIUS), curve.length() / _MOST_POINTS)


def _clearing(u: Array, h: Array, face: float) -> Array:
    """The least tan(beta) at which the rod clears a point in a face plane (see the module's equation)."""
    square = h * h
    return np.asarray((face * u + h * np.sqrt(u * u + (face**2 - square))) / (face**2 - square))


def roll(outline: Outline, follower: Follower, cam_angle: Array) -> Contact:
    """Turn the disc to each cam angle and let the rod down on it.

    The best point of each smooth piece is refined by a parabola through it and its neighbours, so the error
    falls with the third power of the outline's step.

    Args:
        outline: dense points of the disc's outline about the camshaft.
        follower: the rod and the faces; radius 0 follows the outline with the rod's axis.
        cam_angle: shape (n,), rad.

    Raises:
        DesignError: the outline does not enclose the camshaft or is not star-shaped about it.
    """
    cam_angle = np.atleast_1d(np.asarray(cam_angle, dtype=float))
    ring = _Ring.of(outline, follower)
    rows = ring.rows(cam_angle)
    best = np.concatenate(
        [ring.rest(block) for block in np.split(cam_angle, range(rows, len(cam_angle), rows))], axis=1
    )
    tan_beta, face, across, pressure_angle, margin = best
    return Contact(cam_angle, tan_beta, follower.lift(tan_beta), face, margin, across, pressure_angle)


@dataclass(frozen=True)
class _Ring:
    """An outline sorted by polar angle, laid out for looking up all points under the rod at once."""

    follower: Follower
    angle: Array
    radius: Array
    points: Array
    piece: NDArray[np.intp]
    window: float

    @classmethod
    def of(cls, outline: Outline, follower: Follower) -> "_Ring":
        angle = outline.angle
        slack = 5e-9  # rad; branches that meet within 2e-9 from either side count as joined, plus rounding
        turns = angle[-1] - angle[0]
        if not (np.diff(angle) > -slack).all() or abs(turns - _TURN) > 1e-3:
            place = np.degrees(angle[int(np.argmin(np.diff(angle)))]) % 360
            raise DesignError(
                f"the outline is not a closed curve run once round the camshaft: it overhangs near polar angle "
                f"{place:.1f} degrees, where the rod cannot follow it; raise cam.base_radius_mm, widen the turn "
                f"there, or raise cam.blend_deg if the closing blend steers there"
            )
        radius = np.linalg.norm(outline.points, axis=1)
        reach = np.arcsin(min(1.0, follower.radius / radius.min())) if follower.radius > 0 else 0.0
        # A little more than a turn on either side, so that a window never wraps.
        first = angle[0]
        offsets = np.array([-_TURN, 0.0, _TURN])
        tiled = (angle + offsets[:, None]).ravel()
        near = (tiled > first - reach - 0.2) & (tiled < first + _TURN + reach + 0.2)
        pieces = outline.piece + (outline.piece.max() + 1) * np.arange(3)[:, None]
        points = np.tile(outline.points.T, 3)[:, near]
        return cls(follower, tiled[near], np.tile(radius, 3)[near], points, pieces.ravel()[near], reach)

    def rows(self, theta: Array) -> int:
        """How many of these cam angles `rest` may be asked for at once."""
        if self.follower.radius == 0:
            return _BLOCK
        first, last = self._window(self._within(theta))
        return int(np.clip(_TABLE // max(int((last - first).max(initial=1)), 1), 1, _BLOCK))

    def _within(self, theta: Array) -> Array:
        """Cam angles of the turn that is laid out."""
        theta = self.angle[0] + (theta - self.angle[0]) % _TURN
        return np.where(theta < self.angle[0] + self.window, theta + _TURN, theta)

    def _window(self, theta: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """The points under the rod at each cam angle: the first, and the one after the last."""
        return np.searchsorted(self.angle, theta - self.window), np.searchsorted(self.angle, theta + self.window)

    def rest(self, theta: Array) -> Array:
        """tan(beta), carrying face, contact's y, pressure angle and margin at each cam angle, shape (5, n)."""
        theta = self._within(theta)
        follower = self.follower
        if follower.radius == 0:
            u = np.interp(theta, self.angle, self.radius) - follower.base_radius
            carrying = follower.contact_face(u)
            step = 1e-4  # rad; well above rounding, well below any feature
            ahead, behind = (np.interp(theta + side, self.angle, self.radius) for side in (step, -step))
            slope = (ahead - behind) / (2 * step)
            angle = np.arctan2(slope, u + follower.base_radius)
            return np.stack([u / carrying, carrying, np.zeros_like(u), angle, follower.land * np.abs(u / carrying)])
        first, last = self._window(theta)
        # Whole rows are copied and turned by products: single look-ups and sines of all angles would take longer.
        width = int((last - first).max()) + 2
        first = np.clip(first - 1, 0, len(self.angle) - width)
        ahead, left = (sliding_window_view(values, width)[first] for values in self.points)
        c, s = np.cos(theta)[:, None], np.sin(theta)[:, None]
        x, y = ahead * c + left * s, left * c - ahead * s
        under = np.abs(y) < follower.radius
        h = np.sqrt(np.where(under, follower.radius**2 - y**2, 0.0))
        results = []
        for face in (follower.inner, follower.outer):
            needed = np.where(under, _clearing(x - follower.base_radius, h, face), -np.inf)
            results.append(self._refine(needed, y, first, face))
        inner, outer = results
        best = np.where(inner[0] >= outer[0], inner, outer)
        return np.vstack([best, best[1] * np.abs(inner[0] - outer[0])])

    def _refine(self, needed: Array, y: Array, first: NDArray[np.intp], face: float) -> Array:
        """The greatest tan(beta) between the samples: parabolas through three neighbours of one piece."""
        last = needed.shape[1] - 1
        rows = np.arange(len(needed))[:, None]
        top = np.argmax(needed, axis=1)[:, None]
        # A joint stands twice, and the contact may lie just beside it: look two points to either side.
        centre = np.clip(top + np.arange(-2, 3), 1, last - 1)
        before, at, after = (needed[rows, centre + k] for k in (-1, 0, 1))
        piece = self.piece[first[:, None, None] + centre[..., None] + np.arange(-1, 2)]
        fits = (piece == piece[..., 1:2]).all(axis=2) & np.isfinite(before) & np.isfinite(after)
        before, at, after = (np.where(fits, f, 0.0) for f in (before, at, after))
        slope, bend = (after - before) / 2, np.minimum(before - 2 * at + after, -1e-300)
        shift = np.clip(-slope / bend, -1.0, 1.0)
        value = np.where(fits, at + slope * shift + bend * shift**2 / 2, -np.inf)
        row, best = np.arange(len(needed)), np.argmax(value, axis=1)
        refined, chosen, shift = value[row, best], centre[row, best], shift[row, best]
        sampled = needed[row, top[:, 0]]
        use = refined >= sampled
        chosen, shift = np.where(use, chosen, top[:, 0]), np.where(use, shift, 0.0)
        beside = np.clip(chosen + np.where(shift >= 0, 1, -1), 0, last)
        across = y[row, chosen] + np.abs(shift) * (y[row, beside] - y[row, chosen])
        angle = np.arcsin(np.clip(across / self.follower.radius, -1.0, 1.0))
        return np.stack([np.maximum(refined, sampled), np.full(len(needed), face), across, angle])
