"""The law `path`: the steering that drives a car along its path, by cam angle, closed by a blend."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from math import degrees, inf, radians
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import cam_place, seam_check
from cadgen.cam.follower import RolledCam
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import TAN, Unit
from cadgen.messages import Message

# rad; a shorter piece before the blend is a share of the open curve's own polynomial: from values and derivatives at
# its two ends its second derivative would err by the rounding of a value over the square of its length, 1e-8 here.
_SHORT = 1e-4
_KINK = 1e-5  # a jump of d tan(beta)/d theta below this turns the outline by less than 1e-5 rad: no kink

# In the closing blend the car does not drive, so a blend is only refused where it would lock: a rod that a flank drives
# outwards is held by friction from arctan(1 / mu) on, 73 degrees at mu = 0.3, the greatest of metal on metal with a
# trace of oil. Where the spring drives it back nothing locks, and the 70 degrees are the strict end of the return
# stroke's limits.
LOCKING_ANGLE = radians(70)


@dataclass(frozen=True)
class PathMotion(Motion):
    """Tangent of the steering angle by cam angle: q = tan(beta).

    Attributes:
        blend_start: cam angle from which the closing blend, and not the path, steers, rad; runs end there. Of a closed
            path, which has no blend, the motor position at which the last lap of a run ends: a turn or more.
    """

    blend_start: float
    unit: Unit = field(default=TAN, kw_only=True)

    noun: ClassVar[str] = Message("path")

    @property
    def blended(self) -> bool:
        """Whether a closing blend steers at the end of the turn."""
        return self.blend_start < TURN

    def idle(self, cam_angle: Array) -> NDArray[np.bool_]:
        """Whether the closing blend, where the car does not drive, steers at cam angles, rad.

        Args:
            cam_angle: cam angles, rad, shape (n,).
        """
        return np.asarray(np.asarray(cam_angle) % TURN > self.blend_start)

    def softer(self, cam_angle: float, key: str = "") -> str:
        """Advice that makes the steering milder at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
            key: key of the points that shape the path; left out of the advice if empty.
        """
        if cam_angle >= self.blend_start:
            return Message("raise cam.blend_deg (the closing blend steers there)")
        return Message("widen the turn there ({key})", key=key) if key else Message("widen the turn there")

    def higher(self, cam_angle: float) -> str:
        """Advice that keeps the follower farther from the camshaft at a cam angle, as part of a sentence.

        Args:
            cam_angle: cam angle, rad.
        """
        return Message("widen the turn there")

    def fewer(self, count: int) -> str:
        """Advice for a path with too many ripples, as part of a sentence.

        Args:
            count: how many times as many ripples as are followed.
        """
        return Message("keep one in {count} of the points of [path], or give them with more digits", count=count)

    @cached_property
    def mirrored(self) -> "PathMotion":
        """Motion of a cam that turns the other way, on which the blend comes first and has no place of its own."""
        return replace(super().mirrored, blend_start=TURN)


def path_motion(arc: Array, jets: Array, length: float, *, blend: float) -> PathMotion:
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
        raise DesignError("cam.blend_deg is {blend:g}; it must lie between 0 and 360 degrees", blend=degrees(blend))
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
    return PathMotion(q=closed, kinks=kinks[kinks < start], blend_start=start)


def lap_motion(arc: Array, jets: Array, laps: int, *, stop: float) -> PathMotion:
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
    return PathMotion(q=closed, kinks=np.array([]), blend_start=stop)


def blend_checks(cam: RolledCam) -> tuple[Check, ...]:
    """Checks of the closing blend, where the car does not drive: refused only where the follower would lock.

    Args:
        cam: cam of a car with its follower rolled on it; its motion is a `PathMotion`.
    """
    motion, contact, follower = cam.motion, cam.contact, cam.follower
    assert isinstance(motion, PathMotion)
    if not motion.blended:
        return ()
    within = motion.idle(contact.cam_angle)
    place, value = cam_place(motion.blend_start), 0.0
    # Corners lie between the stations.
    lost = [(loss.lift, loss.cam_angle) for loss in cam.losses if not loss.driven]
    off = list(zip(np.abs(cam.error[within]).tolist(), contact.cam_angle[within].tolist(), strict=True))
    if lost or off:
        value, angle = max(lost + off)
        place = Message("{place}, where the car does not drive", place=cam_place(angle))
    checks = [Check(CheckCode.BLEND_LIFT, Message("lift error on the blend"), value * 1e3, "µm", inf, Bound.MAX, place)]
    rising = motion.q(contact.cam_angle, nu=1) >= 0
    angles = np.abs(contact.pressure_angle)
    for code, name, of_kind, usual in (
        (
            CheckCode.BLEND_PRESSURE_ANGLE_RISE,
            Message("pressure angle, blend rise"),
            within & rising,
            cam.limits.pressure_angle.rise,
        ),
        (
            CheckCode.BLEND_PRESSURE_ANGLE_RETURN,
            Message("pressure angle, blend return"),
            within & ~rising,
            cam.limits.pressure_angle.fall,
        ),
    ):
        size = np.where(of_kind, angles, 0.0)
        worst = int(np.argmax(size))
        checks.append(
            Check(
                code,
                name,
                float(np.degrees(size[worst])),
                "°",
                float(np.degrees(max(LOCKING_ANGLE, usual))),
                Bound.MAX,
                cam_place(contact.cam_angle[worst]) if of_kind.any() else Message("none"),
                Message(
                    "on so steep a flank the {follower} locks when the cam is turned on to its start: "
                    "{softer} or raise cam.base_radius_mm",
                    follower=Message(follower.noun),
                    softer=motion.softer(motion.blend_start),
                ),
            )
        )
    return (*checks, seam_check(motion, motion.blend_start, CheckCode.BLEND_START, Message("start of the blend")))
