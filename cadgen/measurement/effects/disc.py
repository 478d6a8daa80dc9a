"""Effects on the disc itself: they show in a measured profile, and some of them in the lift.

All act at the stage `disc`, on a `Disc`; the points are those of the outline about the bore.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.measurement.effects.base import Array, Effect, Parameter


@dataclass(frozen=True)
class Disc:
    """An outline about the bore.

    Attributes:
        points: shape (n, 2), mm, counterclockwise.
        normal: outward unit normal of the nominal outline, shape (n, 2).
        angle: polar angle of the nominal points, unwrapped, shape (n,), rad.
        noses: polar angles of the outline's noses (greatest radii), shape (k,), rad.
        piece: number of the smooth piece that each point belongs to, shape (n,).
    """

    points: Array
    normal: Array
    angle: Array
    noses: Array
    piece: NDArray[np.intp]

    def moved(self, along: Array) -> "Disc":
        """Every point moved outwards along its normal, mm."""
        return replace(self, points=self.points + along[:, None] * self.normal)


def _um(name: str, lower: float = -500.0, upper: float = 500.0) -> Parameter:
    return Parameter(name=name, unit="um", lower=lower, upper=upper, step=10.0)


def _percent(name: str) -> Parameter:
    return Parameter(name=name, unit="%", lower=-2.0, upper=2.0, step=0.02)


def _eccentric(disc: Disc, p: Array, at: object) -> Disc:
    return replace(disc, points=disc.points - p)


def _offset(disc: Disc, p: Array, at: object) -> Disc:
    return disc.moved(np.full(len(disc.angle), p[0]))


def _scale(disc: Disc, p: Array, at: object) -> Disc:
    return replace(disc, points=disc.points * (1 + p))


def _reversal(disc: Disc, p: Array, at: object) -> Disc:
    """The cutter runs counterclockwise; an axis with lost motion lags half of it behind its own direction."""
    travel = np.sign(np.stack([-disc.normal[:, 1], disc.normal[:, 0]], axis=1))
    return replace(disc, points=disc.points - travel * p / 2)


ECCENTRIC_BORE = Effect(
    name="eccentric bore",
    stage="disc",
    parameters=(_um("eccentric_x_um"), _um("eccentric_y_um")),
    act=_eccentric,
    confused_with="a wobbling camshaft, or run-out of the shaft, in lift data",
    separated_by="measure the profile about the bore on a CMM",
)
CUTTER_COMPENSATION = Effect(
    name="cutter compensation",
    stage="disc",
    parameters=(_um("cutter_offset_um"),),
    act=_offset,
    confused_with="uniform scale (they differ only where the outline is not a circle)",
    separated_by="measure a feature of known size that the same cutter made inside, such as a pocket: "
    "its error has the other sign for an offset",
)
UNIFORM_SCALE = Effect(
    name="uniform scale",
    stage="disc",
    parameters=(_percent("scale_percent"),),
    act=_scale,
    family="scale",
    confused_with="cutter compensation",
    separated_by="measure the distance of two hole centres: an offset leaves it, a scale does not",
)
ANISOTROPIC_SCALE = Effect(
    name="anisotropic scale",
    stage="disc",
    parameters=(_percent("scale_x_percent"), _percent("scale_y_percent")),
    act=_scale,
    family="scale",
    includes="uniform scale",
    confused_with="lobing of order two",
    separated_by="print or cut the part turned by 90 degrees: a scale stays with the machine",
)
AXIS_REVERSAL = Effect(
    name="machine-axis reversal",
    stage="disc",
    parameters=(_um("reversal_x_um", -200.0, 200.0), _um("reversal_y_um", -200.0, 200.0)),
    act=_reversal,
    confused_with="an eccentric bore if only one half was measured",
    separated_by="cut a circle on the same machine and look for steps at the four quadrants",
)


def _harmonic(order: int) -> Callable[[Disc, Array, object], Disc]:
    def act(disc: Disc, p: Array, at: object) -> Disc:
        return disc.moved(p[0] * np.cos(order * disc.angle) + p[1] * np.sin(order * disc.angle))

    return act


PROFILE_EFFECTS = (ECCENTRIC_BORE, CUTTER_COMPENSATION, UNIFORM_SCALE, ANISOTROPIC_SCALE, AXIS_REVERSAL)

LAST_LOBE = 8  # jaws of a chuck and supports of a spindle make up to eight lobes; finer is waviness


def undulation(order: int) -> Effect:
    """Lobing (few lobes) or waviness (many) of one order: normal offset p0 cos(n phi) + p1 sin(n phi)."""
    sort = "lobing" if order <= LAST_LOBE else "waviness"
    return Effect(
        name=f"{sort}, order {order}",
        stage="disc",
        parameters=(_um(f"{sort}_cos_um"), _um(f"{sort}_sin_um")),
        act=_harmonic(order),
        numerous=True,
        confused_with="anisotropic scale" if order == 2 else "the stylus or spindle of the measuring machine",
        separated_by="measure again with the disc clocked by 90 degrees: what turns with it is the disc's",
    )


def local(disc: Disc, centre: float, depth: float, width: float) -> Disc:
    """Move the outline by depth exp(-((phi - centre) / width)^2 / 2) along its normal."""
    off = (disc.angle - centre + np.pi) % (2 * np.pi) - np.pi
    return disc.moved(depth * np.exp(-((off / width) ** 2) / 2))


NOSE_WIDTHS_DEG = (2.5, 4.0, 6.0)  # from which the width of a worn nose is searched


def worn_nose(number: int, width_deg: float) -> Effect:
    """Material lost at one of the outline's noses, counted by polar angle: depth and half-width."""

    def act(disc: Disc, p: Array, at: object) -> Disc:
        return local(disc, disc.noses[number], -p[0], p[1])

    return Effect(
        name="worn nose",
        stage="disc",
        parameters=(
            _um("worn_depth_um", 0.0, 300.0),
            Parameter(name="worn_width_deg", unit="deg", lower=1.5, upper=10.0, step=0.2, start=width_deg),
        ),
        act=act,
        family="worn nose",
        variant=f"at {number} from {width_deg:g}",
        numerous=True,
        confused_with="a dent, or a local error of the cutter's path",
        separated_by="compare with a new cam, or look at the nose under a lens: wear is polished",
    )
