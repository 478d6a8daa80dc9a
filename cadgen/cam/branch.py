"""Parts of an envelope: what a follower sweeps between two kinks of the lift, and its own section at a kink."""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import Jet, cross


@dataclass(frozen=True, kw_only=True)
class Branch(ABC):
    """A part of the envelope in one carrying plane, by a parameter that runs forward round the camshaft.

    Attributes:
        face: lateral distance of the plane, mm.
        start: parameter at which it begins, rad.
        stop: parameter at which it ends, rad.
    """

    face: float
    start: float
    stop: float

    @abstractmethod
    def jet(self, t: Array) -> Jet:
        """Point, velocity by the parameter, and curvature (positive where the disc is convex) at n parameters.

        Args:
            t: parameters, shape (n,).
        """

    @abstractmethod
    def cam_angle(self, t: float) -> float:
        """Cam angle, rad, at which the follower touches the point of a parameter.

        Args:
            t: parameter of the point.
        """


@dataclass(frozen=True, kw_only=True)
class Swept(Branch):
    """Curve that the moving follower sweeps, by cam angle, over a span without kinks.

    Attributes:
        lift: the steering wanted.
    """

    lift: LiftCurve

    def cam_angle(self, t: float) -> float:
        """Return the parameter itself, rad.

        Args:
            t: parameter of the point, which is its cam angle, rad.
        """
        return t

    def advance(self, theta: Array) -> Array:
        """Rate of the tangential travel along the envelope, mm/rad; negative on a swallowtail.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        jet = self.jet(theta)
        return np.asarray(cross(jet.point, jet.velocity) / np.linalg.norm(jet.point, axis=1))


@dataclass(frozen=True, kw_only=True)
class Section(Branch):
    """The follower's own section, where it stands at a hollow kink of the lift.

    Attributes:
        theta: cam angle of the kink, rad.
    """

    theta: float

    def cam_angle(self, t: float) -> float:
        """Cam angle of the kink, rad.

        Args:
            t: parameter of the point.
        """
        return self.theta


def span_jets(lift: LiftCurve, theta: Array, start: float, stop: float) -> tuple[Array, Array, Array]:
    """tan(beta) and two derivatives inside [start, stop], one-sided at the ends (a kink may stand there).

    Args:
        lift: lift of the cam.
        theta: cam angles, rad, shape (n,).
        start: end of the span, rad.
        stop: other end of the span, rad.
    """
    inside = np.clip(theta, start, stop - 1e-13 * (1.0 + abs(stop)))
    return lift.tan_beta(inside), lift.tan_beta(inside, nu=1), lift.tan_beta(inside, nu=2)


def turned(radial: Array, around: Array, ray: tuple[Array, Array]) -> Array:
    """Turn components along and across rays into points of the cam frame, shape (n, 2), mm.

    Args:
        radial: components along the rays, shape (n,), mm.
        around: components across them, shape (n,), mm.
        ray: cosine and sine of the rays' angles, each of shape (n,).
    """
    c, s = ray
    return np.stack([radial * c - around * s, radial * s + around * c], axis=1)
