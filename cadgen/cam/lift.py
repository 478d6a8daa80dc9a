"""The steering that one turn of the cam must give."""

from dataclasses import dataclass
from functools import cached_property
from math import degrees, factorial

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PPoly

from cadgen.arrays import TURN, Array
from cadgen.curves.piecewise import quintic_hermite, zeros
from cadgen.errors import DesignError

# rad; a shorter piece before the blend is a share of the open curve's own polynomial: from values and derivatives at
# its two ends its second derivative would err by the rounding of a value over the square of its length, 1e-8 here.
_SHORT = 1e-4
_KINK = 1e-5  # a jump of d tan(beta)/d theta below this turns the outline by less than 1e-5 rad: no kink
# A stretch of at least this angle over which tan(beta) stays within the second figure is level: the second is 0.01 um
# of lift, what rolling an outline errs by, and a smooth peak stays within it over so wide an angle only if its second
# derivative is below 0.042, a tenth of what a gentle turn has.
_LEVEL_ANGLE = np.radians(0.5)
_LEVEL_RANGE = 4e-7


@dataclass(frozen=True)
class LiftCurve:
    """tan(beta) as a function of the cam angle, closed over one turn.

    Attributes:
        tan_beta: periodic piecewise quintic, cam angle (rad) -> tan(beta).
        kinks: cam angles at which the slope jumps, shape (k,), rad.
        blend_start: cam angle from which the closing blend, and not the path, steers, rad; runs end there. Of a closed
            path, which has no blend, the motor position at which the last lap of a run ends: a turn or more.
        known_level: level stretches, shape (m, 2), rad, of a lift whose samples are too rough to show them; None
            where the lift itself shows them.
    """

    tan_beta: PPoly
    kinks: Array
    blend_start: float
    known_level: Array | None = None

    @property
    def blended(self) -> bool:
        """Whether a closing blend steers at the end of the turn."""
        return self.blend_start < TURN

    def in_blend(self, cam_angle: Array) -> NDArray[np.bool_]:
        """Whether the closing blend, where the car does not drive, steers at cam angles, rad.

        Args:
            cam_angle: cam angles, rad, shape (n,).
        """
        return np.asarray(np.asarray(cam_angle) % TURN > self.blend_start)

    @cached_property
    def stations(self) -> tuple[Array, Array]:
        """Cam angles from 0 to a turn between which tan(beta) only rises or only falls, and tan(beta) there.

        Found once for each lift: a car that runs with many plays asks again and again.
        """
        slope = self.tan_beta.derivative()
        roots = zeros(slope, jumps=False)
        nodes = np.unique(np.concatenate([self.tan_beta.x, roots[np.isfinite(roots)]]))
        return nodes, np.append(self.tan_beta(nodes[:-1]), self.tan_beta(nodes[0]))

    @cached_property
    def derived(self) -> dict[tuple[object, float], Array]:
        """Results of other rooms for this lift, kept for use again, by function and parameter."""
        return {}

    @cached_property
    def level(self) -> Array:
        """Stretches of at least 0.5 degrees over which the lift is level to rounding: straight runs and dwells.

        Returns:
            Cam angles at which each begins, in [0, 2 pi), and ends, perhaps beyond 2 pi; shape (m, 2), rad.
        """
        if self.known_level is not None:
            return self.known_level
        nodes, value = self.stations
        # Twice round, so that a stretch across the start is met whole.
        angle, height = np.concatenate([nodes[:-1], nodes + TURN]), np.concatenate([value[:-1], value])
        across = np.searchsorted(angle, angle[: len(nodes) - 1] + _LEVEL_ANGLE)
        close = np.flatnonzero(np.abs(height[across] - height[: len(across)]) <= _LEVEL_RANGE)
        stretches: list[list[float]] = []
        for first in close:
            last = across[first]
            if stretches and angle[last] <= stretches[-1][1]:
                continue
            if np.ptp(height[first : last + 1]) > _LEVEL_RANGE:
                continue
            # The stretch goes on as long as all of it stays within the range.
            last = first + _level_from(height[first : first + len(nodes)], last - first) - 1
            if stretches and angle[first] <= stretches[-1][1]:
                stretches[-1][1] = float(angle[last])
            else:
                stretches.append([float(angle[first]), float(angle[last])])
        # A stretch across the start is found once from 0 and once from where it really begins.
        if len(stretches) > 1 and stretches[-1][1] >= stretches[0][0] + TURN:
            stretches = stretches[1:]
        return np.array([[a, min(b, a + TURN)] for a, b in stretches]).reshape(-1, 2)

    @cached_property
    def mirrored(self) -> "LiftCurve":
        """The lift of a cam that turns the other way: tan(beta) at minus the cam angle."""
        x, degree = self.tan_beta.x, self.tan_beta.c.shape[0] - 1
        taylor, derivative = [], self.tan_beta.c
        for order in range(degree + 1):
            value = np.zeros(len(x) - 1)
            for row in derivative:
                value = value * np.diff(x) + row
            taylor.append((-1) ** order * value / factorial(order))
            derivative = derivative[:-1] * np.arange(len(derivative) - 1, 0, -1)[:, None]
        curve = PPoly(np.stack(taylor[::-1])[:, ::-1], TURN - x[::-1], extrapolate="periodic")
        level = None if self.known_level is None else _mirrored(self.known_level)
        return LiftCurve(curve, (-self.kinks) % TURN, TURN, level)

    def extrema(self) -> tuple[Array, Array]:
        """Cam angles of the peaks and of the valleys of the lift, rad, in order."""
        slope = self.tan_beta.derivative()
        roots = zeros(slope, jumps=True)
        roots = np.unique(roots[(roots >= 0) & (roots < TURN) & np.isfinite(roots)])
        # Both sides are probed: at a kink the slope changes sign without being zero.
        probe = 1e-7
        before, after = slope(roots - probe), slope(roots + probe)
        return roots[(before > 0) & (after < 0)], roots[(before < 0) & (after > 0)]


def _level_from(height: Array, sure: int) -> int:
    """Number of values, from the first on, that lie within the level range; `sure` of them are known to."""
    while True:
        sure *= 2
        part = height[:sure]
        outside = np.maximum.accumulate(part) - np.minimum.accumulate(part) > _LEVEL_RANGE
        if outside.any() or len(part) == len(height):
            return int(np.argmax(outside)) if outside.any() else len(part)


def _mirrored(stretches: Array) -> Array:
    begin = (-stretches[:, 1]) % TURN
    return np.stack([begin, begin + stretches[:, 1] - stretches[:, 0]], axis=1)


def lift_curve(arc: Array, jets: Array, length: float, *, blend: float) -> LiftCurve:
    """Turn steering by arc length into steering by cam angle, and close it.

    The steering gives the lift (eq. 19), and the cam turns in proportion to the drive wheel's travel: theta = 2 pi arc
    / length (eq. 20). Over the last `blend` of the turn a quintic leads back to the start; value, slope and second
    derivative are continuous at both its ends, so the profile's curvature is too.

    Args:
        arc: arc length at the nodes, shape (n,), mm; a kink stands twice.
        jets: tan(beta) and two derivatives by arc length, shape (n, 3).
        length: travel in one turn of the cam, mm.
        blend: angle of the closing blend, rad; it begins at the end of the nodes at the latest.

    Raises:
        DesignError: the blend covers the whole turn or nothing of it.
    """
    if not 0 < blend < TURN:
        raise DesignError(f"cam.blend_deg is {degrees(blend):g}; it must lie between 0 and 360 degrees")
    rate = length / TURN
    theta = arc / rate
    jets = jets * rate ** np.arange(3)
    open_curve = quintic_hermite(theta, jets)
    start = min(TURN - blend, float(theta[-1]))  # by rounding it could lie beyond
    driven = theta < start
    # On a kink the blend goes on from what the path steers before it.
    just = np.nextafter(start, 0.0) if start in theta else start
    at_start = np.stack([open_curve(just, nu=order) for order in range(3)])
    nodes = np.concatenate([theta[driven], [start, TURN]])
    closed = quintic_hermite(nodes, np.vstack([jets[driven], at_start, jets[0]]), periodic=True)
    last = int(np.searchsorted(closed.x, start)) - 1
    if start - closed.x[last] < _SHORT:
        closed.c[:, last] = open_curve.c[:, int(np.searchsorted(open_curve.x, start)) - 1]
    doubled = np.flatnonzero((np.diff(theta) == 0) & (np.abs(np.diff(jets[:, 1])) > _KINK))
    kinks = theta[doubled]
    return LiftCurve(tan_beta=closed, kinks=kinks[kinks < start], blend_start=start)


def lap_lift_curve(arc: Array, jets: Array, laps: int, *, stop: float) -> LiftCurve:
    """Turn steering along a closed path into steering by cam angle: some laps to the turn, and nothing blended.

    Args:
        arc: arc length at the nodes, from 0 to the end of the lap, shape (n,), mm.
        jets: tan(beta) and two derivatives by arc length, shape (n, 3); at the end of the lap those of its start.
        laps: laps in one turn of the cam.
        stop: motor position at which a run ends, rad, a turn or more.
    """
    rate = laps * arc[-1] / TURN
    jets = jets * rate ** np.arange(3)
    jets[-1] = jets[0]
    starts = TURN / laps * np.arange(laps + 1.0)
    theta = starts[:-1, None] + arc / rate
    theta[:, -1] = starts[1:]  # to the last bit, so that no piece is as short as rounding
    closed = quintic_hermite(theta.ravel(), np.tile(jets, (laps, 1)), periodic=True)
    return LiftCurve(tan_beta=closed, kinks=np.array([]), blend_start=stop)
