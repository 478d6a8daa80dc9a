"""Roll a follower on an outline: the motion, and so the lift, that a disc really gives.

This shares nothing with the envelope. At cam angle theta a point of the disc lies x ahead of the camshaft and y
across. The follower, pressed on the disc by its spring, clears the point from some q on (`Follower.least`). Of all
points of the outlines in the planes that carry it, it rests on the one that asks for the greatest.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Contact, Follower
from cadgen.cam.lower_hull import SAME
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.errors import DesignError

# Steps of an outline, mm, between which `roll_curve` chooses, and the change of lift at which it is content. The
# error falls with the third power of the step, so what is left is an eighth of the last change: 0.0025 um.
COARSEST_STEP = 0.06
FINEST_STEP = 5e-4
ROLLING_TOLERANCE = 2e-5
# Change of the pressure angle, rad, at which it is content as well, with followers that lean where the place of the
# contact counts, and the step, mm, at which it is in any case.
_ANGLE_TOLERANCE, _ANGLE_TOLERANCE_LEANING, _ANGLE_STEP = 2e-5, 3e-4, 4e-3
_POINTS_PER_RADIUS = 20  # of the follower at least, or two steps could agree by chance
# What a disc of any size may take: points on its outline, and points under the follower. The least rod on the largest
# disc that the schema allows still has some points under it.
_MOST_POINTS = 1_500_000
_MOST_UNDER = 10_000
# Stations handled at once, so that a table of candidates stays within the processor's cache; fewer if it is wide.
_BLOCK = 512
_APART = 1e-7  # rad; points closer together than this say nothing of a slope
_TIE = 1e-9  # of q, of two planes: within it rolling cannot tell which of them carries, and the first is taken
_APEX_STEPS = 4  # of Newton's method, from a sample two steps away at most
_HALVINGS = 50  # of the angle within which a point stands beside its line: to rounding
_TABLE = 100_000
# Every so many points one stands for those about it, and what is under the follower is narrowed down by these first.
_STRIDE = 8


def roll_curve(
    curve: ClosedCurve, follower: Follower, cam_angle: Array, *, by_place: bool = False
) -> tuple[Contact, float]:
    """Roll a follower on an exact curve, in steps halved until the lift no longer changes.

    Only the cam angles that still change, and those so steep that two steps may agree by chance, are rolled again: a
    cam that needs fine steps in one steep place is not sampled finely throughout.

    Args:
        curve: outline, mm.
        follower: follower of the cam.
        cam_angle: cam angles, rad, shape (n,).
        by_place: whether the place of the contact must no longer change either, as for all followers that do not lean;
            along a hollow that is hardly wider than the follower it moves far within little lift.

    Returns:
        The contact, and the finest step that was needed, mm: an outline read back from a file needs it too.

    Raises:
        DesignError: as `roll`.
    """
    cam_angle = np.atleast_1d(np.asarray(cam_angle, dtype=float))
    step = rolling_step(curve, follower)
    width = min(2 * follower.reach, curve.length())
    finest = max(FINEST_STEP, curve.length() / _MOST_POINTS, width / _MOST_UNDER)
    contact = roll(curve.outline(step), follower, cam_angle)
    pending = np.arange(len(cam_angle))
    while pending.size and step > finest:
        step /= 2
        finer = roll(curve.outline(step), follower, cam_angle[pending])
        changed = np.abs(finer.lift - contact.lift[pending]) > ROLLING_TOLERANCE
        if (by_place or not follower.leans) and step > _ANGLE_STEP:
            settled = _ANGLE_TOLERANCE_LEANING if follower.leans else _ANGLE_TOLERANCE
            changed |= np.abs(finer.pressure_angle - contact.pressure_angle[pending]) > settled
        for name in ("q", "lift", "face", "margin", "across", "pressure_angle"):
            getattr(contact, name)[pending] = getattr(finer, name)
        pending = pending[changed | (_left(step, follower, finer.pressure_angle) > ROLLING_TOLERANCE)]
    return contact, step


def _left(step: float, follower: Follower, pressure_angle: Array) -> Array:
    """The lift error that the parabola through points of an outline may leave, mm.

    The half-height h = sqrt(r^2 - y^2) of a round follower has the third derivative -3 r^2 y / h^5. A step along the
    outline is step cos(alpha) across it, so the error goes with step^3 sin(alpha) / (r cos(alpha))^2. The factor was
    measured on flanks of 74 to 76 degrees: 0.9 on fine steps, 1.5 on coarse ones.
    """
    if follower.radius == 0:
        return np.zeros_like(pressure_angle)
    width = follower.radius * np.cos(pressure_angle)
    return np.asarray(1.5 * step**3 * np.abs(np.sin(pressure_angle)) / np.maximum(width, 1e-9) ** 2)


def rolling_step(curve: ClosedCurve, follower: Follower, coarsest: float = COARSEST_STEP) -> float:
    """The step of an outline at which a follower can be rolled on it, mm: the coarsest, or less for a thin one.

    Args:
        curve: outline, mm.
        follower: follower of the cam.
        coarsest: coarsest step allowed, mm.
    """
    if follower.radius == 0:
        return coarsest
    return max(min(coarsest, follower.radius / _POINTS_PER_RADIUS), curve.length() / _MOST_POINTS)


def roll(outline: Outline, follower: Follower, cam_angle: Array) -> Contact:
    """Turn the disc to each cam angle and let the follower down on it.

    The best point of each smooth piece is refined by a quartic through it and its four neighbours, so the error falls
    with the fifth power of the outline's step; beside the ends of a piece by a parabola, with the third power.

    Args:
        outline: dense points of the disc's outline about the camshaft.
        follower: follower of any kind; radius 0 follows the outline with a point.
        cam_angle: shape (n,), rad.

    Raises:
        DesignError: the outline does not enclose the camshaft or is not star-shaped about it, or its points are so far
            apart that the follower falls between them.
    """
    return Ring.of(outline, follower).contact(cam_angle)


@dataclass(frozen=True)
class Ring:
    """An outline sorted by polar angle, laid out for looking up all points under a follower at once.

    What rolls on one outline again and again lays it out once.
    """

    follower: Follower
    angle: Array
    radius: Array
    points: Array
    piece: NDArray[np.intp]
    sector: tuple[float, float]

    @classmethod
    def of(cls, outline: Outline, follower: Follower) -> "Ring":
        """Lay out an outline; raises `DesignError` as `roll`."""
        angle = outline.angle
        slack = 5e-9  # rad; branches that meet within 2e-9 from either side count as joined, plus rounding
        turns = angle[-1] - angle[0]
        if not (np.diff(angle) > -slack).all() or abs(turns - TURN) > 1e-3:
            place = np.degrees(angle[int(np.argmin(np.diff(angle)))]) % 360
            raise DesignError(
                "the outline is not a closed curve run once round the camshaft: it overhangs near polar "
                "angle {place:.1f} degrees, where the {follower} cannot follow it; {flatter}",
                place=place,
                follower=follower.noun,
                flatter=follower.flatter,
                base_key=follower.base_key,  # of which a larger value is tried
            )
        radius = np.linalg.norm(outline.points, axis=1)
        sector = follower.sector(float(radius.min()), float(radius.max()))
        reach = max(-sector[0], sector[1])
        # A little more than a turn on either side, so that a window never wraps.
        first = angle[0]
        offsets = np.array([-TURN, 0.0, TURN])
        tiled = (angle + offsets[:, None]).ravel()
        near = (tiled > first - reach - 0.2) & (tiled < first + TURN + reach + 0.2)
        pieces = outline.piece + (outline.piece.max() + 1) * np.arange(3)[:, None]
        points = np.ascontiguousarray(np.tile(outline.points.T, 3)[:, near])
        return cls(follower, tiled[near], np.tile(radius, 3)[near], points, pieces.ravel()[near], sector)

    def contact(self, cam_angle: Array) -> Contact:
        """Let the follower down at cam angles, rad, shape (n,).

        Args:
            cam_angle: cam angles, rad, shape (n,).
        """
        cam_angle = np.atleast_1d(np.asarray(cam_angle, dtype=float))
        line = cam_angle + self.follower.azimuth
        best = self._point(line) if self.follower.radius == 0 else self._rest(line)
        q, face, across, pressure_angle, margin = best
        return Contact(cam_angle, q, self.follower.lift(q), face, margin, across, pressure_angle)

    @cached_property
    def _heads(self) -> tuple[NDArray[np.intp], Array]:
        """Every `_STRIDE`-th point, and how far from it, mm, those are for which it stands."""
        count = len(self.angle)
        heads = np.arange(0, count, _STRIDE)
        about = np.clip(heads[:, None] + np.arange(-_STRIDE // 2, _STRIDE // 2 + 1), 0, count - 1)
        off = self.points[:, about] - self.points[:, heads, None]
        return heads, np.sqrt(np.max(np.sum(off**2, axis=0), axis=1)) + SAME

    @cached_property
    def _inside(self) -> NDArray[np.bool_]:
        """Whether a point and its neighbours are of one piece."""
        same = np.diff(self.piece, prepend=-1, append=-1) == 0
        return np.asarray(same[:-1] & same[1:])

    def _within(self, theta: Array) -> Array:
        """Angles of the follower's line, in the turn that is laid out."""
        theta = self.angle[0] + (theta - self.angle[0]) % TURN
        return np.where(theta < self.angle[0] + max(-self.sector[0], self.sector[1]), theta + TURN, theta)

    def _point(self, theta: Array) -> Array:
        """Motion and contact of a point at each angle of its line, shape (5, n); rows as of `_rest`."""
        theta, follower = self._within(theta), self.follower
        aside = np.zeros_like(theta)
        if any(self.sector):
            # The outline, at the polar angle at which the point stands, is as far from the camshaft as the point is.
            low, high = (np.full_like(theta, side) for side in self.sector)
            for _ in range(_HALVINGS):
                aside = (low + high) / 2
                beyond = aside > follower.standing(self._polar(theta + aside)[0])[1]
                low, high = np.where(beyond, low, aside), np.where(beyond, aside, high)
        radius, slope = self._polar(theta + aside)
        q, carrying, margin = follower.of_lift(follower.standing(radius)[0])
        normal = aside - np.arctan2(slope, radius)
        return np.stack([q, carrying, radius * np.sin(aside), follower.pressed(q, normal), margin])

    def _polar(self, place: Array) -> tuple[Array, Array]:
        """Radius of the outline at polar angles, mm, and its derivative by the angle, mm/rad, shape (n,) each.

        By the cubic through four points of the piece, two on either side where they are there; for followers that lean,
        by the chord.
        """
        radius = np.interp(place, self.angle, self.radius)
        step = 1e-4  # rad; well above rounding, well below any feature
        before, after = (np.interp(place + side, self.angle, self.radius) for side in (-step, step))
        slope = (after - before) / (2 * step)
        if self.follower.leans:
            return radius, slope
        behind = np.clip(np.searchsorted(self.angle, place), 0, len(self.angle) - 1)
        begin, end = (np.searchsorted(self.piece, self.piece[behind], side) for side in ("left", "right"))
        start = np.clip(np.minimum(np.maximum(behind - 2, begin), end - 4), 0, len(self.angle) - 4)
        first = start[:, None] + np.arange(4)
        x, y = self.angle[first] - place[:, None], self.radius[first]
        smooth = (self.piece[first[:, 0]] == self.piece[first[:, 3]]) & (np.diff(x, axis=1) > _APART).all(axis=1)
        x = np.where(smooth[:, None], x, np.arange(4.0))
        # Divided differences at the place: value and slope of the Newton form.
        first_order = np.diff(y, axis=1) / np.diff(x, axis=1)
        second = np.diff(first_order, axis=1) / (x[:, 2:] - x[:, :-2])
        third = np.diff(second, axis=1)[:, 0] / (x[:, 3] - x[:, 0])
        a, b, c = x[:, 0], x[:, 1], x[:, 2]
        value = y[:, 0] - a * (first_order[:, 0] - b * (second[:, 0] - c * third))
        rise = first_order[:, 0] - (a + b) * second[:, 0] + (a * b + a * c + b * c) * third
        return np.where(smooth, value, radius), np.where(smooth, rise, slope)

    def _rest(self, theta: Array) -> Array:
        """tan(beta), carrying face, contact's y, pressure angle and margin at each cam angle, shape (5, n)."""
        theta = self._within(theta)
        heads, _ = self._heads
        angle = self.angle[heads]
        first, last = (
            np.searchsorted(angle, theta + self.sector[0]) - 1,
            np.searchsorted(angle, theta + self.sector[1]) + 1,
        )
        bounds = np.empty((2, len(theta)), dtype=np.intp)
        for block in _blocks(last - first):
            bounds[:, block] = self._narrowed(theta[block], first[block], int((last - first)[block].max()))
        begin, end = bounds
        best = np.empty((5, len(theta)))
        for block in _blocks(end - begin):
            best[:, block] = self._highest(theta[block], begin[block], int((end - begin)[block].max()))
        return best

    def _narrowed(self, theta: Array, first: NDArray[np.intp], width: int) -> NDArray[np.intp]:
        """Bounds of the points that the follower may rest on, shape (2, n): the first, and the one after the last.

        Where the points within `off` of a head ask for less than what some head asks for, none of them carries.

        Args:
            theta: cam angles, shape (n,), rad.
            first: the first head to look at, shape (n,).
            width: how many heads to look at.
        """
        heads, away = self._heads
        follower = self.follower
        first = np.clip(first, 0, len(heads) - width)
        x, y = _turned_back(self.points[:, heads], theta, first, width)
        off = sliding_window_view(away, width)[first]
        candidates = np.zeros(x.shape, dtype=bool)
        for asked, bound in zip(follower.least(x, y), follower.most(x, y, off), strict=True):
            candidates |= (bound >= asked.max(axis=1)[:, None]) & (bound > -np.inf)
        # The heads' own neighbours, and those that a parabola takes.
        reach = _STRIDE // 2 + 4
        begin = heads[first + np.argmax(candidates, axis=1)] - reach
        end = heads[first + width - 1 - np.argmax(candidates[:, ::-1], axis=1)] + reach + 1
        return np.stack([begin, end])

    def _highest(self, theta: Array, begin: NDArray[np.intp], width: int) -> Array:
        """Motion and contact at each cam angle among the points of a window, shape (5, n); rows as of `_rest`."""
        follower = self.follower
        begin = np.clip(begin, 0, len(self.angle) - width)
        x, y = _turned_back(self.points, theta, begin, width)
        asked = follower.least(x, y)
        if (lost := np.isneginf(np.max(asked, axis=(0, 2)))).any():
            place = np.degrees(theta[int(np.argmax(lost))]) % 360
            raise DesignError(
                "a {follower} of {radius:.4g} mm radius falls between the points of the outline at cam "
                "angle {place:.1f} degrees: give a larger radius",
                follower=follower.noun,
                radius=follower.radius,
                place=place,
            )
        best, *others = (self._refine(one, y, begin, face) for face, one in zip(follower.planes, asked, strict=True))
        apart = np.full(len(theta), np.inf)
        for other in others:
            apart = np.minimum(apart, np.abs(best[0] - other[0]))
            best = np.where(best[0] >= other[0] - _TIE, best, other)
        return np.vstack([best, follower.margin(apart, best[1])])

    def _refine(self, needed: Array, y: Array, first: NDArray[np.intp], face: float) -> Array:
        """The greatest tan(beta) between the samples: parabolas through three neighbours of one piece, or quartics."""
        last = needed.shape[1] - 1
        row = np.arange(len(needed))
        top = np.argmax(needed, axis=1)
        # A joint stands twice, and the contact may lie just beside it: look two points to either side.
        middle = np.clip(top, 3, last - 3)
        seven = needed[row[:, None], middle[:, None] + np.arange(-3, 4)]
        centre = middle[:, None] + np.arange(-2, 3)
        fits = self._inside[first[:, None] + centre] & np.isfinite(seven[:, :-2]) & np.isfinite(seven[:, 2:])
        before, at, after = (np.where(fits, seven[:, k : k + 5], 0.0) for k in range(3))
        slope, bend = (after - before) / 2, np.minimum(before - 2 * at + after, -1e-300)
        shift = np.clip(-slope / bend, -1.0, 1.0)
        value = np.where(fits, at + slope * shift + bend * shift**2 / 2, -np.inf)
        best = np.argmax(value, axis=1)
        refined, chosen, shift = value[row, best], centre[row, best], shift[row, best]
        # Where five are of one piece, by a quartic: its top errs by the fifth power of the step.
        inner = np.clip(best, 1, 3)
        five = (inner == best) & (fits[row, inner - 1] & fits[row, inner] & fits[row, inner + 1])
        around = [np.where(five, seven[row, inner + beside], 0.0) for beside in range(-1, 4)]
        place, highest = _quartic_top(around, shift, 1.0)
        refined, shift = np.where(five, highest, refined), np.where(five, place, shift)
        sampled = needed[row, top]
        use = refined >= sampled
        chosen, shift = np.where(use, chosen, top), np.where(use, shift, 0.0)
        if not self.follower.leans:
            apex = self._apex(needed, top, first)
            found = np.isfinite(apex)
            nearest = np.rint(np.where(found, apex, 0.0)).astype(np.intp)
            chosen, shift = np.where(found, nearest, chosen), np.where(found, apex - nearest, shift)
        beside = np.clip(chosen + np.where(shift >= 0, 1, -1), 0, last)
        across = y[row, chosen] + np.abs(shift) * (y[row, beside] - y[row, chosen])
        q = np.maximum(refined, sampled)
        angle = self.follower.pressure_angle(q, across)
        return np.stack([q, np.full(len(needed), face), across, angle])

    def _apex(self, needed: Array, top: NDArray[np.intp], first: NDArray[np.intp]) -> Array:
        """Place of the greatest value between samples, by quartics through five neighbours of one piece.

        The apex of a parabola errs by the third derivative, which for a small roller on a steep flank is some 0.01
        degrees. Beside a joint of two pieces the five points lie on one side.

        Returns:
            Numbers of samples with a share, shape (n,); nan where no five points of one piece are there.
        """
        last, place = needed.shape[1] - 1, np.full(len(needed), np.nan)
        highest, row = np.full(len(needed), -np.inf), np.arange(len(needed))
        for side in (0, -1, 1, -2, 2, -3, 3):
            middle = np.clip(top[row] + side, 2, last - 2)
            a, b, c, d, e = (needed[row, middle + beside] for beside in range(-2, 3))
            fits = np.isfinite(a + b + c + d + e)
            fits &= self._inside[first[row] + middle - 1] & self._inside[first[row] + middle + 1]
            a, b, c, d, e = (np.where(fits, each, 0.0) for each in (a, b, c, d, e))
            found, value = _quartic_top((a, b, c, d, e), np.zeros_like(c), 2.0)
            better = fits & (value > highest[row])
            highest[row[better]], place[row[better]] = value[better], (middle + found)[better]
            if side == 0:  # the others are for a sample beside a joint
                row = row[~fits | (middle != top)]
            if not row.size:
                break
        return place


def _quartic_top(samples: Sequence[Array], start: Array, most: float) -> tuple[Array, Array]:
    """Tops of quartics through five even samples, by Newton's method: places from the middle one on, and values.

    Args:
        samples: the five in order, each of shape (n,).
        start: places at which the search begins, shape (n,).
        most: greatest distance of a top from the middle sample, in samples.
    """
    a, b, c, d, e = samples
    slope, bend = (a - 8 * b + 8 * d - e) / 12, (16 * (b + d) - a - e - 30 * c) / 12
    third, fourth = (e - 2 * d + 2 * b - a) / 2, e - 4 * d + 6 * c - 4 * b + a
    place = start
    for _ in range(_APEX_STEPS):
        rate = np.minimum(bend + place * (third + place * fourth / 2), -1e-300)
        rise = slope + place * (bend + place * (third / 2 + place * fourth / 6))
        place = np.clip(place - rise / rate, -most, most)
    return place, c + place * (slope + place * (bend / 2 + place * (third / 6 + place * fourth / 24)))


def _blocks(width: NDArray[np.intp]) -> Iterator[slice]:
    """Stations to handle at once, so many that a table of so many points for each stays small."""
    if not len(width):
        return
    rows = int(np.clip(_TABLE // max(int(width.max()), 1), 1, _BLOCK))
    for start in range(0, len(width), rows):
        yield slice(start, start + rows)


def _turned_back(points: Array, theta: Array, first: NDArray[np.intp], width: int) -> tuple[Array, Array]:
    """Points of a window at each cam angle, ahead of the camshaft and across, shape (n, width) each.

    Whole rows are copied and turned by products: single look-ups and sines of all angles would take longer.
    """
    ahead, left = sliding_window_view(points, width, axis=1)[:, first]
    c, s = np.cos(theta)[:, None], np.sin(theta)[:, None]
    return ahead * c + left * s, left * c - ahead * s
