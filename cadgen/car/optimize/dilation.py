"""The dilation of any lift by the window of the play, rounded: the compensated profile where events are close.

With peaks and valleys closer together than the return error B the dilation
    c(theta) = max of s over [theta - B, theta]
has parts that no longer follow from one peak and one valley: dips narrower than B are gone, and plateaus of several
peaks join. But its value is always that of s at an end of the window or at a peak within it, so it is known exactly
at every angle. Here it is sampled, its plateaus are tilted so that the spring pulls the cam across them, and a mean
over a narrow window rounds its kinks; a mean with weights of one sign keeps what falls falling.
"""

from dataclasses import dataclass
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.motion.play import falls
from cadgen.car.path_motion import PathMotion
from cadgen.curves.piecewise import quintic_hermite

_LEAST_HALF_WIDTH = radians(0.1)  # of the mean; what it takes off a peak is far below a micrometre
_GREATEST_HALF_WIDTH = radians(0.5)
_SAMPLES = 48  # over the half width: at a kink the sampled mean then errs by some 2 nm of lift
_NODES = 4  # of the rounded lift over the half width; between them a quintic errs by less than rounding
_LEAST_TILT = 4e-4  # of a plateau, by rad; well above what is level (`PathMotion.level`)
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
    """The dilation of a lift with its plateaus tilted and its kinks rounded.

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
    drop = min(fall, depth / 16, max(own / 2, _LEAST_TILT * play))
    height[span[plateau]] = wanted[plateau] - drop * along[plateau] / play
    height[span[falling]] = wanted[falling] - drop * np.clip(1 - (top - wanted[falling]) / (4 * drop), 0.0, 1.0)
