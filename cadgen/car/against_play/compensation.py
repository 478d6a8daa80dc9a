"""The profile that takes play out: the dilation of the wanted lift by a window as wide as the return error.

With play B the cam leads by B wherever the lift falls (see `cadgen.car.running.play`). So the wanted lift is
given back by a cam whose rises are those of the wanted lift and whose falls are the wanted ones turned ahead by B:

    s_c(theta) = max of s over [theta - B, theta].

A sliver of height about s'' B^2 / 8 is lost in each valley, where the cam must stand still for B whatever its shape
(the morphological closing of s). The dilation has two places that a spring and a
cutter cannot take as they are:

- At each peak p it is level from p to p + B, and nothing would pull the cam across: the rod would stay on the
  gears' side and drop B late. Here this plateau falls, by a little more than cutting errs, and joins both flanks
  with continuous curvature.
- In each valley its two flanks cross in a hollow kink. Here a quintic joins them over a stated angle; with an angle
  of 0 the kink stays and the rod's own section rounds the profile there.
"""

from dataclasses import dataclass
from math import ceil, degrees, floor, radians

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import falls
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError

KINK = 1e-6  # a jump of d tan(beta)/d theta below this turns the outline by less than 1e-6 rad: no kink
SIDE = 1e-12  # rad; how far beside a node its one-sided jets are taken


@dataclass(frozen=True)
class CutLift:
    """Lift that a profile is cut for.

    Attributes:
        lift: lift by cam angle.
        windows: widths of the windows by which the lift is turned ahead, rad: the play that it is cut for, or with
            friction the closest to it. For a lift that is not compensated, those for `compensated`.
        by_lead: whether each lead of the cam has a window of its own, and not all falls one.
    """

    lift: PathMotion
    windows: tuple[float, ...]
    by_lead: bool = False

    @property
    def made_for(self) -> float:
        """The widest window, rad."""
        return max(self.windows)


def nodes_between(
    lift: PathMotion, start: float, stop: float, *, ahead: float = 0.0, widest: float = TURN
) -> tuple[Array, Array]:
    """Nodes of the lift over a span, turned ahead.

    Args:
        lift: any closed lift.
        start: first cam angle of the span, rad; any turn.
        stop: last cam angle, rad.
        ahead: angle added to the angles of the result, rad.
        widest: greatest distance of neighbouring nodes, rad; nodes are added where the lift's are further apart.

    Returns:
        Cam angles, shape (n,), each inner one twice, and jets of tan(beta) from either side, shape (n, 3).
    """
    row = np.concatenate([_sides(lift, turn) for turn in range(floor(start / TURN), ceil(stop / TURN))])
    first = np.searchsorted(row[:, 0], start + 2 * SIDE, side="right")
    inner = row[first : np.searchsorted(row[:, 0], stop - 2 * SIDE)]
    ends = np.concatenate([[start], inner[::2, 0], [stop]])
    parts = np.ceil(np.diff(ends) / widest).astype(int)
    if parts.max() == 1:
        begin, end = _jets(lift, np.array([start + SIDE, stop - SIDE]))
        jets = np.concatenate([begin[None], inner[:, 1:], end[None]])
        return np.concatenate([[start], inner[:, 0], [stop]]) + ahead, jets
    span = np.repeat(np.arange(len(parts)), parts)
    part = np.arange(len(span)) - np.repeat(np.cumsum(parts) - parts, parts) + 1
    within = part * (np.diff(ends) / parts)[span] + ends[span]
    inner = np.where(part == parts[span], ends[span + 1], within)[:-1]
    x = np.concatenate([[start], np.repeat(inner, 2), [stop]])
    side = np.concatenate([[SIDE], np.tile([-SIDE, SIDE], len(inner)), [-SIDE]])
    return x + ahead, _jets(lift, x + side)


def _jets(lift: PathMotion, theta: Array) -> Array:
    """Jets of tan(beta) at cam angles, rad, shape (n, 3)."""
    return np.stack([lift.q(theta, nu=order) for order in range(3)], axis=1)


def _sides(lift: PathMotion, turn: int) -> Array:
    """Cam angles of the lift's own nodes in a turn, rad, each twice, with the jets on either side, shape (2 n, 4).

    Found once for each lift: a search turns one lift ahead again and again.
    """
    known = lift.derived
    if (_sides, turn) not in known:
        x = np.repeat(lift.q.x[:-1] + TURN * turn, 2)
        jets = _jets(lift, x + np.tile([-SIDE, SIDE], len(x) // 2))
        known[_sides, turn] = np.column_stack([x, jets])
    return known[_sides, turn]


def closed_lift(x: Array, jets: Array, blend_start: float) -> PathMotion:
    """A closed lift through nodes that run once round from anywhere in the first turn, cut again at 0.

    Args:
        x: cam angles, shape (n,), not decreasing, over one turn; a node that stands twice has a jet on either side.
        jets: tan(beta) with two derivatives, shape (n, 3).
        blend_start: cam angle at which the closing blend of the result starts, rad.
    """
    late = x > TURN
    # The piece that holds the seam; after a turn without one the nodes begin at 0.
    last = int(np.argmax(late)) if late.any() else 1
    piece = quintic_hermite(x[last - 1 : last + 1], jets[last - 1 : last + 1])
    seam = np.stack([piece(TURN if late.any() else x[0], nu=order) for order in range(3)])
    nodes = np.concatenate([[0.0], x[late] - TURN, x[~late], [TURN]])
    jets = np.concatenate([[seam], jets[late], jets[~late], [seam]])
    kinks = nodes[:-1][(np.diff(nodes) == 0) & (np.abs(np.diff(jets[:, 1])) > KINK)]
    return PathMotion(q=quintic_hermite(nodes, jets, periodic=True), kinks=kinks, blend_start=blend_start)


_LEAST_HALF_WIDTH = radians(0.1)  # of the mean; what it takes off a peak is far below a micrometre
_GREATEST_HALF_WIDTH = radians(0.5)
_SAMPLES = 48  # over the half width: at a kink the sampled mean then errs by some 2 nm of lift
_NODES = 4  # of the rounded lift over the half width; between them a quintic errs by less than rounding
_LEAST_DILATED_TILT = 4e-4  # of a plateau, by rad; well above what is level (`PathMotion.level`)
_FEW = 16  # samples apart are those of a plateau that are looked at first
_LEVEL = 1e-6  # of tan(beta): a plateau that changes by more is not the one of its peak


@dataclass(frozen=True, kw_only=True)
class LostDip:
    """Lift that no cam gives back in a valley, because the cam stands still there for the whole of the play.

    Attributes:
        cam_angle: cam angle of the valley, rad.
        tan_beta: height, in tan(beta), above the valley of the lowest point that a cam with this play can reach.
        whole: True if nothing of the dip is left: it is narrower than the play.
    """

    cam_angle: float
    tan_beta: float
    whole: bool


def lost_dips(lift: PathMotion, play: float, pairs: Array | None = None) -> tuple[LostDip, ...]:
    """Lift lost in each valley: the height that the morphological closing by the play adds there.

    Args:
        lift: any closed lift.
        play: return error B, rad.
        pairs: cam angles of peaks and valleys, shape (k, 2), rad; where the lift falls if left out.
    """
    pairs = falls(lift) if pairs is None else pairs
    if not len(pairs):
        return ()
    height = lift.q(pairs)
    next_peak = np.roll(height[:, 0], -1)
    # The closing in a valley is the least dilation over the windows that hold it; that lies where the fall turned
    # ahead meets the rise, which a grid of the window brackets and a smooth crossing's slope makes sharp enough.
    window = np.linspace(0.0, play, 257)
    seen = np.asarray(pairs[:, 1:] + window, dtype=np.float64)
    least = _dilation(lift, pairs, play, seen).min(axis=1)
    sides = np.minimum(height[:, 0], next_peak)
    return tuple(
        LostDip(cam_angle=float(valley % TURN), tan_beta=float(closed - low), whole=bool(closed >= side - _LEVEL))
        for valley, closed, low, side in zip(pairs[:, 1], least, height[:, 1], sides, strict=True)
    )


def rounded_dilation(lift: PathMotion, play: float, *, fall: float, half_width: float) -> PathMotion:
    """Dilation of a lift with its plateaus tilted and its kinks rounded: for events that are close together.

    With peaks and valleys closer together than the return error B, the dilation has parts that do not follow from one
    peak and one valley: dips narrower than B are gone, and plateaus of several peaks join. But its value is always that
    of the lift at an end of the window or at a peak within it, so it is known exactly at every angle. It is sampled,
    its plateaus are tilted so that the spring pulls the cam across them, and a mean over a narrow window rounds its
    kinks; a mean with weights of one sign keeps what falls falling.

    Args:
        lift: any closed lift.
        play: B, width of the window, rad, above 0.
        fall: fall of tan(beta) over each plateau; less where the dip after it is shallower.
        half_width: half the width of the mean that rounds kinks, rad; kept between 0.1 and 0.5 degrees.
    """
    half_width = float(np.clip(half_width, _LEAST_HALF_WIDTH, _GREATEST_HALF_WIDTH))
    count = int(np.ceil(TURN / (half_width / _NODES)))
    each = int(np.ceil(_SAMPLES / _NODES))  # samples between nodes
    step = TURN / (count * each)
    theta = np.asarray(step * np.arange(count * each), dtype=np.float64)
    pairs = falls(lift)
    height = _dilation(lift, pairs, play, theta)
    for peak, valley in pairs:
        _tilt(lift, theta, height, play, peak, valley, fall)

    reach = int(half_width / step)
    u = np.arange(-reach, reach + 1) * step / half_width
    weight = np.stack(
        [
            (1 - u**2) ** 4,
            8 * u * (1 - u**2) ** 3 / half_width,
            (48 * u**2 * (1 - u**2) ** 2 - 8 * (1 - u**2) ** 3) / half_width**2,
        ]
    )
    # Derivatives of a mean are sums with the weights' derivatives; those of a constant are made to vanish.
    weight /= weight[0].sum()
    weight[1:] -= weight[1:].mean(axis=1, keepdims=True)
    padded = np.concatenate([height[-reach:], height, height[:reach]])
    seen = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)[::each]
    jets = seen @ weight.T
    nodes = np.append(theta[::each], TURN)
    tan_beta = quintic_hermite(nodes, np.vstack([jets, jets[:1]]), periodic=True)
    return PathMotion(q=tan_beta, kinks=np.array([]), blend_start=lift.blend_start)


def _dilation(lift: PathMotion, pairs: Array, play: float, theta: Array) -> Array:
    """Greatest tan(beta) over [theta - B, theta]: at an end of the window or at a peak in it."""
    height = np.maximum(lift.q(theta), lift.q(theta - play))
    if not len(pairs):
        return np.asarray(height)
    # Twice round, so that a window across the start holds a row of peaks too.
    places = np.concatenate([pairs[:, 0] - TURN, pairs[:, 0]])
    highest = _Greatest(np.tile(lift.q(pairs[:, 0]), 2))
    end = theta % TURN
    first = np.searchsorted(places, end - min(play, TURN), side="left")
    return np.maximum(height, highest.between(first, np.searchsorted(places, end, side="right")))


class _Greatest:
    """The greatest of any stretch of a row of values, from the greatest of all stretches of 1, 2, 4, 8, ... of them."""

    def __init__(self, values: Array) -> None:
        rows = [values]
        while (half := 2 ** (len(rows) - 1)) < len(values):
            longer = rows[-1].copy()
            longer[:-half] = np.maximum(longer[:-half], rows[-1][half:])
            rows.append(longer)
        self._rows = np.array(rows)

    def between(self, first: NDArray[np.intp], end: NDArray[np.intp]) -> Array:
        """The greatest of values[first:end], for arrays of both; -inf where that is empty."""
        count = end - first
        row = np.maximum(np.frexp(count)[1] - 1, 0)  # the longest stretch within the count
        first, last = np.minimum(first, self._rows.shape[1] - 1), np.maximum(end - 2**row, 0)
        return np.where(count > 0, np.maximum(self._rows[row, first], self._rows[row, last]), -np.inf)


def _tilt(lift: PathMotion, theta: Array, height: Array, play: float, peak: float, valley: float, fall: float) -> None:
    """Make the plateau after a peak fall, in place, and the fall after it begin as much lower.

    What is taken off grows along the plateau in proportion, and vanishes again over the first of the fall in
    proportion to its own depth, so that nothing level is left.
    """
    most = min(int((valley - peak + play) / theta[1]) + 2, len(theta))
    span = (np.searchsorted(theta, peak) + np.arange(most)) % len(theta)
    # Most peaks of a rough lift lie under a higher one, which a few samples show.
    few = span[: int(play / theta[1])][::_FEW]
    top = float(lift.q(peak))
    if np.abs(height[few] - top).max(initial=0.0) > _LEVEL:
        return
    along = (theta[span] - peak) % TURN
    span = span[along <= valley - peak + play]
    along, wanted = along[: len(span)], height[span]
    plateau = along <= play
    # The fall lasts as long as the dilation goes down; a rise before that hides the plateau or ends the fall.
    rises = np.flatnonzero(~plateau[1:] & (np.diff(wanted) > 0))
    falling = ~plateau & (np.arange(len(span)) <= (rises[0] if rises.size else len(span)))
    # A plateau between two samples, of a play far narrower than the rounding, needs no tilt.
    if not (plateau.any() and falling.any()) or np.abs(wanted[plateau] - top).max() > _LEVEL:
        return
    depth = top - wanted[falling].min()
    # A fall that begins gently would stay lower for long: no more than half of what it falls over the play itself.
    own = top - float(lift.q(min(peak + play, valley)))
    drop = min(fall, depth / 16, max(own / 2, _LEAST_DILATED_TILT * play))
    height[span[plateau]] = wanted[plateau] - drop * along[plateau] / play
    height[span[falling]] = wanted[falling] - drop * np.clip(1 - (top - wanted[falling]) / (4 * drop), 0.0, 1.0)


# Fall of the plateau in lift, mm: above what a good mill errs over a degree of cam angle. What it costs in heading
# has the opposite sign to what the valleys cost.
PLATEAU_FALL = 0.005
# Half the angle of the valley's quintic over the play. It costs about as much heading as the sliver itself.
VALLEY_SHARE = 0.25
_ROOT = 1e-15  # rad; roots are found to rounding
# No plateau takes more than this share of the fall that follows it.
_GREATEST_SHARE = 1 / 16
# A plateau after a peak that is nearly level itself falls less steeply; below this slope of tan(beta) it would be level
# (`PathMotion.level`) and hold the cam.
_LEAST_TILT = 1e-4
# A rise of tan(beta) of less than this, 0.2 um of lift, must be level for so wide an angle to end a fall.
_LEAST_RISE = 1e-5
_LEAST_LEVEL = np.radians(0.6)


@dataclass(frozen=True)
class _Valley:
    """Course of the profile from a peak over its plateau, down the shifted fall and up again.

    Attributes:
        plateau: nodes and jets of the plateau.
        joined: cam angle from which on the profile is the shifted fall, rad.
        crossing: cam angle at which the shifted fall meets the rise, rad.
        next_peak: cam angle of the next peak, rad.
    """

    plateau: tuple[Array, Array]
    joined: float
    crossing: float
    next_peak: float


def compensated_lift(
    lift: PathMotion,
    follower: EdgeFollower,
    play: float,
    *,
    plateau_fall: float = PLATEAU_FALL,
    valley_blend: float | None = None,
) -> PathMotion:
    """Lift of the cam that gives `lift` back when its train has the return error `play`.

    Where events are too close together for a plateau and a blend each, the whole lift is dilated on samples
    (`rounded_dilation`); dips narrower than the play are lost there, since no cam gives them back (`lost_dips`). The
    closing blend is treated like the rest of the turn, so the result closes as smoothly as `lift` does.

    Args:
        lift: lift wanted by motor position.
        follower: follower, for the plateau's fall in lift.
        play: return error B that the cam is made for, rad; 0 gives `lift` itself, and so does a lift that never falls.
        plateau_fall: fall of the lift over each plateau, mm.
        valley_blend: half the angle over which a quintic rounds each valley, rad; a quarter of the play if left
            out, and 0 leaves a hollow kink where there is room for one.

    Returns:
        A lift by cam angle. Its blend_start is that of `lift`: the motor position up to which it serves the path.

    Raises:
        DesignError: the play is negative or no number, or plateau or blend are out of range.
    """
    if not play >= 0:
        raise DesignError("the return error is {play:g} degrees; it must be 0 or more", play=degrees(play))
    blend = VALLEY_SHARE * play if valley_blend is None else valley_blend
    if not (plateau_fall > 0 and blend >= 0):
        raise DesignError(
            "a plateau's fall of {plateau_fall:g} mm with a valley blend of {blend:g} degrees makes no "
            "profile: the fall must be above 0 and the blend 0 or more",
            plateau_fall=plateau_fall,
            blend=degrees(blend),
        )
    pairs = falls(lift)
    if play == 0 or not len(pairs):
        return lift
    cycles = []
    for number in range(len(pairs)):
        valley = _valley(lift, follower, play, pairs, number, plateau_fall, blend)
        if valley is None:
            return rounded_dilation(lift, play, fall=plateau_fall / follower.outer, half_width=VALLEY_SHARE * play)
        cycles += [
            valley.plateau,
            nodes_between(lift, valley.joined - play, valley.crossing - blend - play, ahead=play),
            nodes_between(lift, valley.crossing + blend, valley.next_peak),
        ]
    x, jets = (np.concatenate(part) for part in zip(*cycles, strict=True))
    return closed_lift(x, jets, lift.blend_start)


def _valley(
    lift: PathMotion, follower: EdgeFollower, play: float, pairs: Array, number: int, fall: float, blend: float
) -> _Valley | None:
    """The profile around a valley, from the peak before it to the one after it; None if there is no room."""
    peak, valley = (float(angle) for angle in pairs[number])
    next_peak = _next_peak(pairs, number)
    crossing = valley_crossing(lift, play, pairs, number)
    if crossing is None:
        return None
    joined, plateau, tilted = _plateau(lift, follower, play, peak, valley, fall)
    risen = lift.value(next_peak) - lift.value(crossing + blend)
    ends_fall = risen >= _LEAST_RISE or next_peak - crossing - blend >= _LEAST_LEVEL
    if tilted and joined < crossing - blend and crossing + blend < next_peak and ends_fall:
        return _Valley(plateau, joined, crossing, next_peak)
    return None


def valley_crossing(lift: PathMotion, window: float, pairs: Array, number: int) -> float | None:
    """Cam angle at which a fall turned ahead by a window meets the rise; None if it meets none before a peak.

    Args:
        lift: any closed lift.
        window: angle by which the fall is turned ahead, rad, above 0.
        pairs: cam angles of peaks and valleys, shape (k, 2), rad.
        number: number of the fall.
    """
    peak, valley = (float(angle) for angle in pairs[number])
    first, last = max(valley, peak + window), min(valley + window, _next_peak(pairs, number))

    def above(angle: float) -> float:
        return lift.value(angle) - lift.value(angle - window)

    if first >= last or above(first) >= 0 or above(last) < 0:
        return None
    return float(brentq(above, first, last, xtol=_ROOT))


def _next_peak(pairs: Array, number: int) -> float:
    """Cam angle of the peak that comes after a fall, rad; after the last fall it lies in the next turn."""
    return float(pairs[0, 0]) + TURN if number + 1 == len(pairs) else float(pairs[number + 1, 0])


def _plateau(
    lift: PathMotion, follower: EdgeFollower, play: float, peak: float, valley: float, fall: float
) -> tuple[float, tuple[Array, Array], bool]:
    """Cam angle at which the shifted fall takes over, nodes of the plateau, and whether it falls enough.

    From a smooth peak with second derivative -k the slope eases to -m as a parabola over 2 m / k, so it never
    turns up. The line then runs to p + B. With tau where the wanted fall has come down as far, a quintic over
    2 tau joins the shifted fall; there too the slope keeps its sign, and the curvature exceeds k by two thirds or so.
    """
    top, bottom = lift.value(peak), lift.value(valley)
    slope, bend = (float(lift.q(peak + SIDE, nu=order)) for order in (1, 2))
    drop = min(fall / float(follower.contact_face(np.array(top))), _GREATEST_SHARE * (top - bottom))
    steepness = drop / play
    ease = 0.0
    if slope > -KINK and bend < 0:
        steepness = min(steepness, -bend * play / 4)
        ease = -2 * steepness / bend
    edge = top - steepness * (play - ease / 3)
    tau = float(brentq(lambda t: lift.value(peak + t) - edge, 0.0, valley - peak, xtol=_ROOT))
    x = np.array([peak, peak + ease, peak + play])
    jets = np.array(
        [
            [top, 0.0 if ease else -steepness, bend if ease else 0.0],
            [top - 2 / 3 * steepness * ease, -steepness, 0.0],
            [edge, -steepness, 0.0],
        ]
    )
    return peak + play + 2 * tau, (x, jets), steepness > _LEAST_TILT
