"""Clock of the camera against that of the vehicle's log, by the speeds that both show.

Camera and vehicle write with clocks of their own, started by hand. At the log's time t (1 + rate) + lag the vehicle
stood where the camera saw it at t. Speeds of both show lag and rate wherever the vehicle starts, stops or changes
speed, whatever else is off: the odometer's scale is a factor of all speeds, and the way that is taken changes none.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from cadgen.arrays import Array

# Span over which a speed is taken: a camera's noise of 1 mm is then 3 mm/s.
SPAN_S = 0.5
# Clocks that a run may have, s and 1, and the grid from which the search begins.
MOST_LAG, MOST_RATE = 3.0, 0.04
_LAGS, _RATES = np.arange(-2.5, 2.6, 0.25), np.arange(-0.02, 0.021, 0.01)
# A clock is taken if it leaves this share of the misfit of two clocks that agree, or less, and is this many standard
# deviations off: runs of constant speed show none.
LEAST_GAIN, SIGMAS = 0.7, 6.0
# Residuals beyond so many mm/s count linearly: odometers skip.
_SKIPS = 5.0
_LEAST_ROWS = 50  # of a run; coarser logs do not resolve a start


@dataclass(frozen=True, slots=True)
class Clock:
    """Clock of the camera: the log's time is t (1 + rate) + lag, s and 1."""

    lag: float = 0.0
    rate: float = 0.0

    def __bool__(self) -> bool:
        return self.lag != 0 or self.rate != 0

    def log_time(self, time: Array) -> Array:
        """Time of the log at times of the camera, s."""
        return np.asarray(time * (1 + self.rate) + self.lag)


def clock(time: Array, seen: NDArray[np.complex128], driven: Array) -> Clock:
    """Clock of the camera in one run; two clocks that agree where speeds do not show another.

    Minimises |speed seen (t) - c speed driven (t (1 + rate) + lag)|^2 over lag, rate and scale c.

    Args:
        time: of each row, s, shape (n,).
        seen: places that the camera saw, x + iy, mm, shape (n,).
        driven: distance that the rear axle went by the log, mm, shape (n,).
    """
    step = float(np.median(np.diff(time))) if len(time) >= _LEAST_ROWS else 0.0
    span = max(round(SPAN_S / step), 2) if step > 0 else len(time)
    even = np.arange(time[0], time[-1], step) if step > 0 else time
    if len(even) < 4 * span:
        return Clock()
    place = np.interp(even, time, seen.real) + 1j * np.interp(even, time, seen.imag)
    middle = (even[span:] + even[:-span]) / 2
    camera = np.abs(place[span:] - place[:-span]) / (span * step)
    along = np.interp(even, time, driven)
    logged = (along[span:] - along[:-span]) / (span * step)

    def misfit(numbers: Array) -> Array:
        lag, rate, scale = numbers
        return np.asarray(camera - scale * np.interp(middle * (1 + rate) + lag, middle, logged))

    start = min(product(_LAGS, _RATES), key=lambda each: float(np.sum(misfit(np.array([*each, 1.0])) ** 2)))
    bounds = [-MOST_LAG, -MOST_RATE, 0.1], [MOST_LAG, MOST_RATE, 10.0]
    options = {"loss": "soft_l1", "f_scale": _SKIPS, "diff_step": 1e-3}
    fit = least_squares(misfit, [*start, 1.0], x_scale=[0.1, 1e-3, 1e-2], bounds=bounds, **options)
    agree = least_squares(lambda c: misfit(np.array([0.0, 0.0, c[0]])), [1.0], **options)
    # Speeds over overlapping spans are alike: so many rows say one thing.
    information = fit.jac.T @ fit.jac / (2 * fit.cost / len(middle) * span + 1e-12)
    sigma = np.sqrt(np.diag(np.linalg.pinv(information)))[:2]
    lag, rate = fit.x[:2]
    off = max(abs(lag) / sigma[0], abs(rate) / sigma[1]) if (sigma > 0).all() else 0.0
    most = min(MOST_LAG, (time[-1] - time[0]) / 10)
    bound = abs(lag) > 0.99 * most or abs(rate) > 0.99 * MOST_RATE
    if bound or off < SIGMAS or fit.cost > LEAST_GAIN * agree.cost:
        return Clock()
    return Clock(float(lag), float(rate))
