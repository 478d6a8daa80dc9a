"""The exact envelope of the leaning rod in a face plane.

In a face plane w the rod's section at cam angle theta is the ellipse
    X(theta, eta) = (d - A cos eta) e_r(theta) - r sin eta e_t(theta),
    d = a + w T(theta),  A = r sqrt(1 + T^2),  T = tan(beta).
It touches its neighbours where dX/dtheta is parallel to dX/deta (Litvin, Gear Geometry and Applied Theory,
sec. 6.1):
    (d' - A' cos eta + r sin eta) r cos eta + (d - A cos eta) A sin eta = 0.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Section, Swept, span_jets, turned
from cadgen.cam.followers.rod_geometry import RodGeometry, rod_half_width
from cadgen.curves.closed import Jet
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion

_NEWTON_STEPS = 20
_CONVERGED = 1e-13  # rad; Newton's method has doubled its digits past rounding
_JOINT = 1e-9  # rad; two pieces that touch the rod this close together meet
_SAMPLES = 3600  # of a turn


@dataclass(frozen=True, kw_only=True)
class EnvelopePiece(Swept):
    """The envelope in one face plane, by cam angle, over a span without kinks.

    Attributes:
        follower: the rod.
    """

    follower: RodGeometry

    def touch(self, theta: Array) -> Array:
        """The section's parameter eta at which it touches the envelope, rad.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        return self._touch(self._section(theta))

    def _touch(self, section: tuple[Array, Array, Array, Array, Array, Array]) -> Array:
        d, d1, _, A, A1, _ = section
        r, square = self.follower.radius, A**2
        eta = np.arctan2(-r * (d1 - A1), A * (d - A) + r**2)
        for _ in range(_NEWTON_STEPS):
            c, s = np.cos(eta), np.sin(eta)
            rc = r * c
            across, along = (d1 - A1 * c + r * s) * r, (d - A * c) * A
            f = across * c + along * s
            f_eta = (A1 * s + rc) * r * c - across * s + square * s**2 + along * c
            step = f / f_eta
            eta = eta - step
            if np.abs(step).max() < _CONVERGED:
                break
        return eta

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by cam angle t (rad), and curvature; on a swallowtail the velocity points backwards.

        Args:
            t: cam angles, rad, shape (n,).
        """
        d, d1, d2, A, A1, A2 = section = self._section(t)
        r = self.follower.radius
        eta = self._touch(section)
        c, s = np.cos(eta), np.sin(eta)
        p, q = d - A * c, -r * s
        p1 = d1 - A1 * c
        f_eta = (A1 * s + r * c) * r * c - (p1 - q) * r * s + A**2 * s**2 + p * A * c
        f_theta = (d2 - A2 * c) * r * c + p1 * A * s + p * A1 * s
        eta1 = -f_theta / f_eta
        # Derivative along the envelope in the turning frame, and the angle of the tangent (A sin, -r cos) in it.
        As, rc = A * s, r * c
        ahead, aside = p1 - q + As * eta1, p - rc * eta1
        size2 = As**2 + rc**2
        turn = 1.0 + (As * r * s * eta1 + rc * (A * c * eta1 + A1 * s)) / size2
        speed = (ahead * -As + aside * rc) / np.sqrt(size2)
        with np.errstate(divide="ignore"):
            curvature = turn / speed
        ray = np.cos(t), np.sin(t)
        return Jet(turned(p, q, ray), turned(ahead, aside, ray), curvature)

    def _section(self, theta: Array) -> tuple[Array, Array, Array, Array, Array, Array]:
        T, T1, T2 = span_jets(self.motion, theta, self.start, self.stop)
        d = self.follower.base_radius + self.face * T
        return d, self.face * T1, self.face * T2, *rod_half_width(self.follower.radius, T, T1, T2)


@dataclass(frozen=True, kw_only=True)
class RodArc(Section):
    """The rod's own section at a hollow kink of the lift, by t = -eta.

    Attributes:
        distance: distance of the rod's axis from the camshaft, mm.
        half_width: semi-axis along that distance, mm.
        follower: the rod.
    """

    distance: float
    half_width: float
    follower: RodGeometry

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the parameter t, and curvature (negative: the disc is hollow here).

        Args:
            t: parameters of the points, shape (n,).
        """
        A, r = self.half_width, self.follower.radius
        c, s = np.cos(t), np.sin(t)
        ray = np.cos(self.theta), np.sin(self.theta)
        return Jet(
            turned(self.distance - A * c, r * s, ray),
            turned(A * s, r * c, ray),
            -A * r / (A**2 * s**2 + r**2 * c**2) ** 1.5,
        )


def rod_arc(before: EnvelopePiece, after: EnvelopePiece) -> RodArc | None:
    """The rod's own section between two pieces at a kink of the lift; None unless that is hollow."""
    follower, face = after.follower, after.face
    eta_before, eta_after = before.touch(np.array([before.stop]))[0], after.touch(np.array([after.start]))[0]
    if eta_after >= eta_before - _JOINT:
        return None
    T = float(after.motion.q(after.start))
    distance, half = follower.base_radius + face * T, follower.radius * float(np.sqrt(1 + T**2))
    return RodArc(
        distance=distance,
        half_width=half,
        follower=follower,
        face=face,
        theta=after.start,
        start=-eta_before,
        stop=-eta_after,
    )


def refuse_thick_rod(motion: Motion, follower: RodGeometry) -> None:
    """Refuse a rod too thick for the cam's smallest radius.

    Raises:
        DesignError: it is so, and no disc remains.
    """
    theta = np.linspace(0, TURN, _SAMPLES, endpoint=False)
    T = motion.q(theta)
    room = follower.base_radius + follower.lift(T) - follower.radius * np.sqrt(1 + T**2)
    worst = int(np.argmin(room))
    if room[worst] <= 0:
        reach = follower.base_radius + follower.lift(T)[worst]
        raise DesignError(
            f"at cam angle {np.degrees(theta[worst]):.1f} degrees the rod's axis is {abs(reach):.2f} mm "
            f"{'from' if reach >= 0 else 'beyond'} the camshaft, but the rod's radius is "
            f"{follower.radius:g} mm, so nothing is left of the disc: lower follower.radius_mm or raise "
            f"cam.base_radius_mm"
        )
