"""Roller and knife edge on a slide, which moves straight out from the camshaft, beside it by an offset.

**Envelope.** At cam angle theta the centre stands at z = y0 + s + i e in the frame of the ray. The prime radius is
R_p = R_b + r, and y0 = sqrt(R_p^2 - e^2). The profile is the parallel of its path at the radius r.

**Rolling.** The roller clears a point x ahead of the camshaft and y across from s = x - y0 + sqrt(r^2 - (y - e)^2) on.

The pressure angle is tan(alpha) = (s' - e) / (y0 + s). An offset e > 0, in the sense of growing polar angle, lessens
that of the rise, and raises that of the return.
"""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import LossRemedy, SizedByAnother, SizeThatFits
from cadgen.cam.limits import CheckLimits
from cadgen.cam.round_follower import Complex, RoundSlide
from cadgen.cam.sizing import SlideSizes, rounded_up
from cadgen.laws.motion import Motion
from cadgen.messages import Message

_WEDGE = np.array([[0.0, 0.0], [9.0, 3.0], [9.0, -3.0], [0.0, 0.0]])  # mm; of a knife edge in pictures


@dataclass(frozen=True, kw_only=True)
class Roller(RoundSlide):
    """Roller on a slide.

    Attributes:
        base: radius of the base circle, mm.
        radius: radius of the roller, mm; zero stands for its centre.
        offset: distance of the slide's line from the camshaft, mm.
        turned: angle from the ray to the slide's line, rad; pi for a roller on the other side of the camshaft.
    """

    base: float
    radius: float
    offset: float = 0.0
    turned: float = 0.0

    noun = Message("roller")
    base_key = "cam.base_circle_radius_mm"
    milder = Message("lower follower.radius_mm or raise cam.base_circle_radius_mm")

    @property
    def base_radius(self) -> float:  # type: ignore[override]
        """Distance y0 of the centre ahead of the camshaft where the lift is 0, mm."""
        return float(np.sqrt((self.base + self.radius) ** 2 - self.offset**2))

    @property
    def azimuth(self) -> float:
        """Angle from the ray to the slide's line, rad."""
        return self.turned

    def centre(self, q: Array, q1: Array, q2: Array) -> tuple[Complex, Complex, Complex]:
        """Centre in the frame of the ray, mm, with its first two derivatives by the cam angle.

        Args:
            q: lift, mm, shape (n,).
            q1: its first derivative, mm/rad.
            q2: its second derivative, mm/rad².
        """
        return self.base_radius + q + 1j * self.offset, q1 + 0j, q2 + 0j

    def point(self) -> "Roller":
        """The roller's centre."""
        return replace(self, base=self.base + self.radius, radius=0.0)

    def remedies(self) -> tuple[LossRemedy, ...]:
        """A smaller roller and a larger base circle."""
        return (
            LossRemedy("follower.radius_mm", self.radius, False, lambda value: replace(self, radius=value)),
            LossRemedy(self.base_key, self.base, True, lambda value: replace(self, base=value)),
        )

    def sizes(self, motion: Motion, limits: CheckLimits) -> tuple[SizeThatFits, ...]:
        """Least base circle for the limits of the pressure angle, and the offset for which it is least of all.

        Args:
            motion: motion wanted.
            limits: limits of the checks, mm and rad.
        """
        slide = SlideSizes(motion, limits.pressure_angle.rise, limits.pressure_angle.fall)
        base = rounded_up(slide.least_prime_radius(self.offset) - self.radius)
        best = round(slide.best_offset(), 2)
        sizes = (SizeThatFits(self.base_key, self.base, base),) if base > 0 else ()
        # With another offset the base circle stays as it is.
        fits = slide.least_prime_radius(best) <= self.base + self.radius
        return (*sizes, SizeThatFits("follower.offset_mm", self.offset, best)) if fits else sizes

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """Lift from which on the roller clears points, mm (see the module's equation).

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        across = y - self.offset
        half = np.sqrt(np.maximum(self.radius**2 - across**2, 0.0))
        return (np.where(np.abs(across) < self.radius, x - self.base_radius + half, -np.inf),)


@dataclass(frozen=True, kw_only=True)
class SecondRoller(SizedByAnother, Roller):
    """Second roller of a conjugate pair: on the same slide, on the other side of the camshaft."""

    noun = Message("second roller")
    base_key = "follower.second.span_mm"
    milder = Message("lower follower.second.radius_mm or raise follower.second.span_mm")

    @property
    def on_ray(self) -> str:
        """Roller on the ray of the cam angle: the first one, for the second stands opposite to it."""
        return Message("first roller")

    @classmethod
    def across(cls, first: Roller, radius: float, span: float, offset: float) -> Self:
        """Second roller of a slide, seen from its own side: its offset there is to the other side.

        Args:
            first: first roller.
            radius: radius of the second one, mm.
            span: distance of the centres along the slide, mm.
            offset: distance of its line from the camshaft, seen from the first one's side, mm.
        """
        prime = float(np.hypot(span - first.base_radius, offset))
        return cls(base=prime - radius, radius=radius, offset=-offset, turned=np.pi)


@dataclass(frozen=True, kw_only=True)
class Knife(Roller):
    """Edge on a slide: a roller of radius zero, whose profile is the path of the edge."""

    radius: float = 0.0

    noun = Message("knife edge")
    milder = Message("raise cam.base_circle_radius_mm")

    def point(self) -> "Knife":
        """The edge."""
        return self

    def remedies(self) -> tuple[LossRemedy, ...]:
        """Without a radius no lift is lost."""
        return ()

    def outline(self, q: float, face: float) -> Array:
        """The wedge that ends in the edge, in the frame of the ray, shape (4, 2), mm.

        Args:
            q: lift, mm.
            face: the follower's plane, as in `planes`, mm.
        """
        tip = np.array([self.base_radius + q, self.offset])
        return np.asarray(tip + _WEDGE)
