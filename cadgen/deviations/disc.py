"""Effects on the disc itself: they show in a measured profile, and some of them in the lift.

All act at the stage `DISC`, on a `Disc`; the points are those of the outline about the bore.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.curves.closed import ClosedCurve, left_normal
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.effect import Effect, Group, Parameter, Stage
from cadgen.messages import Message

_SCALES = Group("scale")

OUTLINE_STEP = 0.06  # mm; the rod rolled on it errs by under 0.01 um
_JOINT = 1e-9  # distance of a joint's two points at most, mm


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
        """Every point moved outwards along its normal, mm.

        Args:
            along: displacement of each point outwards, mm, shape (n,).
        """
        return replace(self, points=self.points + along[:, None] * self.normal)


DISC = Stage[Disc]("disc")

# Radius of the hollow at the foot of a ramp that takes a reversal back, where the outline itself is straight, mm.
LEAST_HOLLOW = 4.0
_LEAST_TURN = 1e-3  # rad; where the outline is nearly straight


def joined_normals(points: Array, normal: Array) -> Array:
    """Normals of which the two points of a joint share one, so that a moved outline stays closed there.

    Args:
        points: points of an outline, a joint between two pieces twice, shape (n, 2), mm.
        normal: unit normal of each point's own piece, shape (n, 2).
    """
    joint = np.flatnonzero(np.linalg.norm(np.diff(points, axis=0, append=points[:1]), axis=1) < _JOINT)
    after = (joint + 1) % len(normal)
    shared = normal[joint] + normal[after]
    out = normal.copy()
    out[joint] = out[after] = shared / np.linalg.norm(shared, axis=1)[:, None]
    return out


def _um(name: str, meaning: str, usual: float | None = None, lower: float = -500.0, upper: float = 500.0) -> Parameter:
    return Parameter(name=name, unit="um", lower=lower, upper=upper, step=10.0, usual=usual, meaning=meaning)


def _percent(name: str, meaning: str) -> Parameter:
    return Parameter(name=name, unit="%", lower=-2.0, upper=2.0, step=0.02, usual=0.02, meaning=meaning)


def eccentric(points: Array, p: Array) -> Array:
    """Points about a shaft whose axis lies off the bore of the outline.

    Args:
        points: points about the bore, mm, shape (..., 2).
        p: place of the shaft's axis, mm, shape (2,).
    """
    return np.asarray(points - p)


def _scale(disc: Disc, p: Array, at: object) -> Disc:
    return replace(disc, points=disc.points * (1 + p))


def lost_motion(disc: Disc, p: Array, at: object) -> Disc:
    """Reversal as the machine makes it: a turned axis stands until its command has gone back by all the lost motion.

    p holds the lost motions of the x and the y axis, mm. Beside the quadrants this is `_reversal`, which jumps there
    and is what a record is compared with.

    Args:
        disc: disc as it was commanded.
        p: lost motions of the x and the y axis, mm, shape (2,).
        at: stations, which do not matter here.
    """
    axes = [_dragged(values, width) for values, width in zip(disc.points.T, p, strict=True)]
    return replace(disc, points=np.stack(axes, axis=1))


def _dragged(asked: Array, width: float) -> Array:
    """The play operator on a closed path, y_i = clip(y_(i-1), u_i - width/2, u_i + width/2), after a first round."""
    half, y, out = abs(width) / 2, float(asked[0]), np.empty(len(asked))
    for _ in range(2):
        for i, u in enumerate(asked.tolist()):
            y = min(max(y, u - half), u + half)
            out[i] = y
    # An axis that was overcorrected leads by as much as it would lag.
    return out if width >= 0 else 2 * asked - out


def ramped_reversal(disc: Disc, p: Array, at: Array) -> Disc:
    """Reversal with ramps instead of jumps where an axis turns round, as far as an outline can have it.

    Over s to either side of a quadrant the direction turns by s times the curvature, and a ramp of height p has the
    curvature 1.44 p / s^2 at its foot; s is such that this is that of the least hollow.

    Args:
        disc: to be changed.
        p: lost motion of both axes, mm.
        at: curvature of the outline, shape (n,), mm^-1.
    """
    reach = np.sqrt(1.44 * np.abs(p) * LEAST_HOLLOW)
    turn = np.maximum(np.abs(at)[:, None] * reach, _LEAST_TURN)
    share = np.clip(_travel(disc) / turn, -1.0, 1.0)
    return replace(disc, points=disc.points - share * (15 - 10 * share**2 + 3 * share**4) / 8 * p / 2)


def _travel(disc: Disc) -> Array:
    """Direction in which the cutter runs, shape (n, 2)."""
    return np.stack([-disc.normal[:, 1], disc.normal[:, 0]], axis=1)


ECCENTRIC_BORE = Effect(
    name="eccentric bore",
    stage=DISC,
    parameters=(
        _um("eccentric_x_um", "+: the shaft's axis lies towards +x of the outline", 10.0),
        _um("eccentric_y_um", "+: towards +y", 10.0),
    ),
    act=lambda disc, p, at: replace(disc, points=eccentric(disc.points, p)),
    deviation=deviation.ECCENTRIC_BORE,
    places=(Place.PART, Place.PROCESS, Place.CAR),
    confused_with="a wobbling camshaft, or run-out of the shaft, in lift data",
    separated_by="measure the profile about the bore on a CMM",
)
CUTTER_COMPENSATION = Effect(
    name="cutter compensation",
    stage=DISC,
    parameters=(_um("cutter_offset_um", "+: too much stands all round, along the normal", 10.0),),
    act=lambda disc, p, at: disc.moved(np.full(len(disc.angle), p[0])),
    deviation=deviation.PROFILE_OFFSET,
    places=(Place.PROCESS, Place.PART),
    confused_with="uniform scale (they differ only where the outline is not a circle)",
    separated_by="measure a feature of known size that the same cutter made inside, such as a pocket: "
    "its error has the other sign for an offset",
)
UNIFORM_SCALE = Effect(
    name="uniform scale",
    stage=DISC,
    parameters=(_percent("scale_percent", "+: the disc is too big"),),
    act=_scale,
    places=(Place.PROCESS, Place.PART),
    group=_SCALES,
    confused_with="cutter compensation",
    separated_by="measure the distance of two hole centres: an offset leaves it, a scale does not",
)
ANISOTROPIC_SCALE = Effect(
    name="anisotropic scale",
    stage=DISC,
    parameters=(
        _percent("scale_x_percent", "+: too long in x"),
        _percent("scale_y_percent", "+: too long in y"),
    ),
    act=_scale,
    places=(Place.PROCESS, Place.PART),
    group=_SCALES,
    includes=UNIFORM_SCALE,
    confused_with="lobing of order two",
    separated_by="print or cut the part turned by 90 degrees: a scale stays with the machine",
)
AXIS_REVERSAL = Effect(
    name="machine-axis reversal",
    stage=DISC,
    parameters=(
        _um(
            "reversal_x_um", "+: the x axis lags by half of it, the cutter running counterclockwise", 3.0, -200.0, 200.0
        ),
        _um("reversal_y_um", "+: the y axis likewise", 3.0, -200.0, 200.0),
    ),
    # The cutter runs counterclockwise; an axis with lost motion lags half of it behind its own direction.
    act=lambda disc, p, at: replace(disc, points=disc.points - np.sign(_travel(disc)) * p / 2),
    deviation=deviation.AXIS_REVERSAL,
    places=(Place.PROCESS, Place.PART),
    confused_with="an eccentric bore if only one half was measured",
    separated_by="cut a circle on the same machine and look for steps at the four quadrants",
)


OUT_OF_SQUARE = Effect(
    name="axes out of square",
    stage=DISC,
    parameters=(
        Parameter.of("square_deg", 1.0, 0.01, 0.01, "+: the axes of the machine that cut it enclose more than 90°"),
    ),
    # A machine whose axes enclose 90 degrees plus p goes to x - p y where it is sent to x.
    act=lambda disc, p, at: replace(disc, points=disc.points - p[0] * disc.points[:, ::-1] * np.array([1.0, 0.0])),
    places=(Place.PROCESS, Place.PART),
    confused_with="lobing of order two",
    separated_by="measure the diagonals of a square that the same machine cut",
)


PROFILE_EFFECTS = (
    ECCENTRIC_BORE,
    CUTTER_COMPENSATION,
    UNIFORM_SCALE,
    ANISOTROPIC_SCALE,
    AXIS_REVERSAL,
    OUT_OF_SQUARE,
)

LAST_LOBE = 8  # jaws of a chuck and supports of a spindle make up to eight lobes; finer is waviness


def undulation(order: int) -> Effect:
    """Lobing (few lobes) or waviness (many) of one order: normal offset p0 cos(n phi) + p1 sin(n phi)."""
    sort = "lobing" if order <= LAST_LOBE else "waviness"
    return Effect(
        name=Message("{sort}, order {order}", sort=Message(sort), order=order),
        stage=DISC,
        parameters=(
            _um(f"{sort}_cos_um", "+: outwards where cos(n phi) = 1, phi the polar angle"),
            _um(f"{sort}_sin_um", "+: outwards where sin(n phi) = 1"),
        ),
        act=lambda disc, p, at: disc.moved(p[0] * np.cos(order * disc.angle) + p[1] * np.sin(order * disc.angle)),
        deviation=deviation.UNDULATION,
        cause=sort,
        places=(Place.PART,),
        member=True,
        confused_with="anisotropic scale" if order == 2 else "the stylus or spindle of the measuring machine",
        separated_by="measure again with the disc turned by 90 degrees on the machine: what turns is the disc's",
    )


def local(disc: Disc, centre: float, depth: float, width: float) -> Disc:
    """Move the outline by depth exp(-((phi - centre) / width)^2 / 2) along its normal: a depth in mm, angles in rad.

    Args:
        disc: disc before.
        centre: polar angle of the middle, rad.
        depth: depth at the middle, mm.
        width: half-width, rad.
    """
    off = (disc.angle - centre + np.pi) % (2 * np.pi) - np.pi
    return disc.moved(depth * np.exp(-((off / width) ** 2) / 2))


NOSE_WIDTHS_DEG = (2.5, 4.0, 6.0)  # from which the width of a worn nose is searched


def worn_nose(number: int, width_deg: float) -> Effect:
    """Material lost at one of the outline's noses, counted by polar angle: depth and half-width.

    Args:
        number: number of the nose, counted from 1.
        width_deg: half-width from which a search begins, degrees.
    """

    def act(disc: Disc, p: Array, at: object) -> Disc:
        return local(disc, disc.noses[number], -p[0], p[1])

    return Effect(
        name="worn nose",
        stage=DISC,
        parameters=(
            _um("worn_depth_um", "material that is gone at the middle", None, 0.0, 300.0),
            Parameter.of(
                "worn_width_deg",
                10.0,
                0.2,
                meaning="standard deviation of the dent, in polar angle",
                lower=1.5,
                start=width_deg,
            ),
        ),
        act=act,
        deviation=deviation.WORN_NOSE,
        places=(Place.PART,),
        group=Group("worn nose"),
        variant=f"at {number} from {width_deg:g}",
        indices=(("nose_number", number + 1),),
        member=True,
        confused_with="a dent, or a local error of the cutter's path",
        separated_by="compare with a new cam, or look at the nose under a lens: wear is polished",
    )


def nominal_disc(curve: ClosedCurve, step: float = OUTLINE_STEP) -> Disc:
    """The outline as points no further apart than `step` mm or so, with normals, joints twice.

    Args:
        curve: outline, mm.
        step: greatest distance of two points, mm.
    """
    outline = curve.outline(step)
    normals = []
    for number, piece in enumerate(curve.pieces):
        t = np.linspace(piece.start, piece.stop, int(np.sum(outline.piece == number)))
        normals.append(-left_normal(piece.jet(t).velocity))
    normal = joined_normals(outline.points, np.concatenate(normals))
    radius, angle = np.linalg.norm(outline.points, axis=1), outline.angle
    grid = angle[0] + np.linspace(0, TURN, 1440, endpoint=False)
    around = np.interp(grid, angle, radius)
    # A nose is the greatest radius within ten degrees either way.
    greatest = np.max([np.roll(around, k) for k in range(-40, 41)], axis=0)
    top = np.flatnonzero((around == greatest) & (around > around.min() + 1e-3))
    before, at, after = (around[(top + k) % len(around)] for k in (-1, 0, 1))
    vertex = (before - after) / (2 * (before - 2 * at + after))  # of the parabola through the three
    noses = np.sort((grid[top] + vertex * (grid[1] - grid[0])) % TURN)
    return Disc(outline.points, normal, angle, noses, outline.piece)
