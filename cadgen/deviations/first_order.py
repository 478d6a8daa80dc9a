"""Change of the steering with small deviations of disc, rod and frame, to first order.

As `cadgen.cam.followers.rod` has it:

- a **larger disc**, along its normal, lifts the rod as a thicker rod would, but for 1 / cos(beta);
- an **eccentric bore** displaces every point alike, in a direction that turns with the cam;
- a disc that **wobbles**, tilted by gamma towards the direction d, has dw = gamma p . d at the point p, and the edge,
  off the disc's middle by w - m, goes to the other side by gamma (w - m);
- a rod **above** the camshaft's plane is a disc below it;
- a **taper** of the cut makes one face larger along its normal, and the other smaller, by half of it;
- a **camshaft that leans** in the frame is a wobble towards a direction that does not turn;
- gears that are **ahead and behind** once in a turn of their shaft, and shafts that **wind up**, turn the disc;
- a rod that **bends** gives way as a cantilever does: of the deflection d at zero lift, tan(beta) loses
  d (w^2 / m^3) (1 + T^2)^(5/2), with m the middle of the faces;
- a front wheel with **lost motion** lags the rod by half of it in every turn, to either side;
- **heat** scales the disc about the shaft, and the frame, which holds camshaft and fork apart.

Near zero steering the two edges of the rim lift the rod almost equally. A taper or a wobble can then make
the other edge carry the rod, instead of the edge that carries it on the nominal disc (`OtherEdge`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.cam.follower import Contact, EdgeFollower, FirstOrder
from cadgen.car.running.friction import DiscMaterial
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    BEARING_SEATS,
    ECCENTRIC_BORE,
    GEAR_ERRORS,
    INNER_FACE,
    OUTER_FACE,
    PROFILE_OFFSET,
    ROD_BENDING,
    ROD_HEIGHT,
    ROD_RADIUS,
    STEERING_LOST_MOTION,
    STEERING_ZERO,
    TAPER,
    TEMPERATURE,
    WIND_UP,
    WOBBLE,
)
from cadgen.deviations.disc import eccentric

# Deviations that turn the rod, in the order of the rows.
STEERING = (
    *(BASE_RADIUS, INNER_FACE, OUTER_FACE, ROD_RADIUS, PROFILE_OFFSET, STEERING_ZERO, TAPER, ROD_HEIGHT),
    *(ECCENTRIC_BORE, WOBBLE, TEMPERATURE, STEERING_LOST_MOTION, ROD_BENDING, WIND_UP, BEARING_SEATS, *GEAR_ERRORS),
)
# Column of each row in a table of deviations.
ROWS = [column for each in STEERING for column in each.columns]

# Linear thermal expansion per K near room temperature: handbooks' tables, such as those that The Engineering ToolBox
# collects; PLA by makers of filament.
EXPANSION: dict[DiscMaterial, float] = {
    DiscMaterial.ALUMINIUM: 23e-6,
    DiscMaterial.STEEL: 12e-6,
    DiscMaterial.BRASS: 19e-6,
    DiscMaterial.ACRYLIC: 70e-6,
    DiscMaterial.PLA: 68e-6,
    DiscMaterial.POM: 110e-6,
}


@dataclass(frozen=True, kw_only=True)
class OtherEdge:
    """The edge that does not carry the nominal rod, at n cam angles.

    Attributes:
        below: amount by which tan(beta) would be less if this edge alone carried the rod, shape (n,).
        rising: excess of its derivatives of tan(beta) by `COLUMNS` over those of the carrying edge, shape (5, n).
    """

    below: Array
    rising: Array

    COLUMNS: ClassVar[list[int]] = [*TAPER.columns, *WOBBLE.columns, *BEARING_SEATS.columns]

    @classmethod
    def of(cls, contact: Contact, follower: EdgeFollower) -> "OtherEdge":
        """The edge opposite a contact of the nominal rod on the nominal disc."""
        opposite = replace(contact, face=follower.inner + follower.outer - contact.face)
        carrying, other = (steering_derivatives(edge, follower) for edge in (contact, opposite))
        rows = [ROWS.index(column) for column in cls.COLUMNS]
        # Both edges have one outline, so the lift would be the same, further out or further in.
        below = np.abs(contact.q * (1 - contact.face / opposite.face))
        return cls(below=below, rising=other[rows] - carrying[rows])

    def raised(self, deviations: Array, columns: NDArray[np.intp]) -> tuple[NDArray[np.intp], Array]:
        """Cam angles at which cars ride on this edge, and the angle by which it turns the rod.

        Args:
            deviations: deviations in `COLUMNS`, mm and rad, shape (m, 5).
            columns: indices of cam angles, shape (j,).

        Returns:
            Places in `columns` at which some car may ride on it, shape (q,), and increase of tan(beta), shape (m, q).
        """
        most = np.abs(deviations).max(axis=0) @ np.abs(self.rising)
        near = np.flatnonzero((most > self.below)[columns])
        at = columns[near]
        return near, np.maximum(np.einsum("ci,ij->cj", deviations, self.rising[:, at]) - self.below[at], 0.0)


@dataclass(frozen=True, kw_only=True)
class Expansion:
    """Coefficients of linear thermal expansion, per K.

    Attributes:
        disc, frame, rod: coefficient of that part, 1/K.
    """

    disc: float = 0.0
    frame: float = 0.0
    rod: float = 0.0


def displaced(first: FirstOrder, cam_angle: Array, x: Array | float, y: Array | float) -> Array:
    """Change of tan(beta) with a displacement of the points that the rod rests on, in the disc's own frame.

    Args:
        first: derivatives at n cam angles.
        cam_angle: the cam angles, rad, shape (n,).
        x, y: displacement, mm, shape (n,) or one for all.
    """
    c, s = np.cos(cam_angle), np.sin(cam_angle)
    return first.displaced(x * c + y * s, y * c - x * s)


def steering_derivatives(
    contact: Contact,
    follower: EdgeFollower,
    gain: float = 1.0,
    expansion: Expansion | None = None,
    *,
    orders: Sequence[float] = (),
    stiffening: float = 0.0,
) -> Array:
    """Derivatives of tan(beta) at each cam angle by the dimensions of cam and rod.

    The wheel turned against the rod adds to the angle behind the lever, whose tangent is g T.

    Args:
        contact: contact of the nominal rod with the nominal disc, at n cam angles.
        follower: the rod and the faces.
        gain: gain g of the lever, a number.
        expansion: thermal expansion of disc and frame; none if left out.
        orders: turns of each shaft of the train for one of the camshaft, from the camshaft on.
        stiffening: share by which the rod's force grows for a mm of lift, 1/mm.

    Returns:
        Shape (r, n), a row for each of `ROWS`: per mm, rad or K; two rows of a deviation with a direction.
    """
    T, w, y = contact.q, contact.face, contact.across
    first = follower.first_order(contact)
    root, height, divisor = first.root, first.height, first.divisor
    raised, face = first.thicker, first.face
    inner = w == follower.inner
    zero = (1 + (gain * T) ** 2) / gain
    base = [-1 / divisor, np.where(inner, face, 0.0), np.where(inner, 0.0, face), raised, raised, zero]

    middle = (follower.inner + follower.outer) / 2
    x = follower.base_radius + w * T - height * root
    c, s = np.cos(contact.cam_angle), np.sin(contact.cam_angle)

    # The bore off centre the other way moves the disc towards a direction.
    shifts = [eccentric(np.zeros(2), -np.array(towards)) for towards in ((1.0, 0.0), (0.0, 1.0))]
    shifted = [displaced(first, contact.cam_angle, *shift) for shift in shifts]
    wobbles = [
        face * (x * along + y * across) - (w - middle) * moved
        for (along, across), moved in zip(((c, -s), (s, c)), shifted, strict=True)
    ]
    heat = expansion or Expansion()
    grown = heat.disc * first.displaced(x, y) - heat.frame * follower.base_radius / divisor
    grown += face * (heat.frame * middle + heat.disc * (w - middle)) + heat.rod * follower.radius * raised
    # Along the outline's normal in the plane of the edge, (h / sqrt(1 + T^2), -y) before it is made a unit.
    normal = np.hypot(height / root, y)
    offset = first.displaced(height / root / normal, -y / normal) if follower.radius > 0 else 1 / divisor
    # Turned ahead, the disc brings the point nearer along the ray and takes it back across.
    turned = first.displaced(y, -x)
    torque = turned / max(float(np.abs(turned).max()), 1e-300)
    ones, nothing = np.ones_like(T), np.zeros_like(T)
    leaning = [
        face * (x * along + y * across) - (w - middle) * first.displaced(along, across)
        for along, across in ((ones, nothing), (nothing, ones))
    ]
    bent = -(w**2) / abs(middle) ** 3 * root**5 * (1 + stiffening * contact.lift) * np.sign(middle)
    runs = [
        part
        for order in [*orders, *[None] * len(GEAR_ERRORS)][: len(GEAR_ERRORS)]
        for part in (
            (np.zeros_like(T), np.zeros_like(T))
            if order is None
            else (turned * np.cos(order * contact.cam_angle), turned * np.sin(order * contact.cam_angle))
        )
    ]
    more = [
        np.where(inner, -0.5, 0.5) * offset,
        first.displaced(np.zeros_like(T), -np.ones_like(T)),
        *shifted,
        *wobbles,
        grown,
        -np.sign(T) * zero,
        bent,
        -torque * turned,
        *leaning,
        *runs,
    ]
    return np.stack([*base, *more])
