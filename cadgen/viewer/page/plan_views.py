"""The two plan views: the cam with its follower, and the car on its course. The page's script moves them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import atan, cos

import numpy as np

from cadgen.arrays import Array
from cadgen.parts.face import Face
from cadgen.viewer.page.document import Arm, CarShape, FloorKind, FloorShape, Going, RimDeviations, Scene, Slide

_MARGIN = 4.0  # mm about the cam
_PIVOT = 4.0  # mm, radius of a pivot's circle
_STATION = 24  # one in so many positions of a follower says how much room it takes
_STEM = 0.85  # of the way between the rails is the stem's
_ROOM = 220.0  # mm about the floor
_TRACK = 6  # of a run's positions, one in so many is on its track
_WHEEL = (32.0, 10.0)  # mm, half length and half width of a wheel whose size is not known
_COLOURS = 4  # of a rim to either side of the middle one
# Greatest ratio of width to height at which the course stands beside the cam; a broader one has a row of its own.
_BESIDE = 1.8
_ROWS = (2, 3, 4, 6)  # ratios of the boxes of broader ones
_ORDER = {"planned": 0, "before": 1, "free": 2, "played": 3}  # of tracks, the last on top


def coordinate(value: float) -> str:
    """A coordinate in as few digits as it takes, to a hundredth.

    Args:
        value: coordinate, mm.
    """
    return f"{float(value):.2f}".rstrip("0").rstrip(".")


@dataclass(frozen=True)
class RodSection:
    """Section of the rod in a face of the disc.

    Attributes:
        face: face of the disc.
        x: place along the fork's axis, mm.
        half_length: half of its length, mm.
        radius: half of its width, mm.
        carries: whether this face carries the rod at cam angle 0.
    """

    face: Face
    x: str
    half_length: str
    radius: str
    carries: bool


@dataclass(frozen=True)
class GuideView:
    """Guide of a follower as it is drawn: rails and stem of a slide, or the pivot of an arm; coordinates as text, mm.

    Attributes:
        rails: places along and across the ray of the ends of each rail; empty of an arm.
        stem: corner of the stem with its length and width; empty of an arm.
        pivot: place of the pivot; None of a slide.
        arm: points of the arm from the pivot on; empty of a slide.
    """

    rails: tuple[tuple[str, str, str], ...] = ()
    stem: tuple[str, str, str, str] | None = None
    pivot: tuple[str, str] | None = None
    arm: str = ""


@dataclass(frozen=True)
class CompanionView:
    """Second disc of a conjugate pair with its follower; coordinates as text, mm.

    Attributes:
        disc: outline, as a path of SVG.
        follower: section of the follower at cam angle 0, as points of SVG.
        centre: middle of that section.
        arm: points of its arm; empty of a slide.
    """

    disc: str
    follower: str
    centre: tuple[str, str]
    arm: str


@dataclass(frozen=True)
class CamView:
    """Cam and follower, the ray of the cam angle to the left; coordinates as text, mm.

    All drawings have the frame of the file, mirrored, with the camshaft at the place that the disc turns about.

    Attributes:
        box: frame of the drawings.
        aspect: width over height.
        axis_at: place of the camshaft across the drawing, percent.
        disc: outline with bore and holes, as a path of SVG.
        zero: ends of the mark of cam angle 0.
        inner: radius that the follower's nearest point has at lift 0.
        reach: greatest radius of the disc.
        ahead: how far the drawing goes to the front.
        base: base radius.
        sections: sections of the rod, that in the carrying face last; empty for another follower.
        follower: section of another follower at cam angle 0, as points of SVG.
        centre: middle of that section; None of the rod.
        guide: what leads it; None where that is not drawn.
        second: second disc of a conjugate pair; None for one disc.
        rim: stretches of the rim by the number of their colour, as paths of SVG.
    """

    box: str
    aspect: str
    axis_at: str
    disc: str
    zero: tuple[str, str]
    inner: str
    reach: str
    ahead: str
    base: str
    sections: tuple[RodSection, ...]
    follower: str
    centre: tuple[str, str] | None
    guide: GuideView | None
    second: CompanionView | None
    rim: tuple[tuple[int, str], ...] = ()


def rim_view(rim: RimDeviations | None) -> tuple[tuple[int, str], ...]:
    """Stretches of a rim by the number of their colour, from 0 far inside to 8 far outside.

    Args:
        rim: deviations on the rim.
    """
    if rim is None:
        return ()
    most = float(np.abs(rim.values).max()) or 1.0
    colours = np.rint(_COLOURS * (1 + rim.values / most)).astype(int)
    after = np.roll(rim.places, -1, axis=0)
    drawn: dict[int, list[str]] = {}
    for colour, start, end in zip(colours.tolist(), rim.places, after, strict=True):
        drawn.setdefault(colour, []).append(f"M{_points([start, end])}")
    return tuple((colour, "".join(drawn[colour])) for colour in sorted(drawn))


@dataclass(frozen=True)
class TrainView:
    """Gears of a train alone, mirrored as the cam is; coordinates as text, mm.

    Attributes:
        box: frame of the drawing.
        aspect: width over height.
        wheels: shaft, place, angle, and paths of SVG of each part: its area, and further edges.
    """

    box: str
    aspect: str
    wheels: tuple[tuple[int, str, str, str, str], ...]


def train_view(scene: Scene) -> TrainView:
    """Gears along their axes, each about the place of its shaft."""
    places = [np.array(scene.shafts[wheel.shaft].axis, float) for wheel in scene.wheels]
    reaches = [max(float(np.hypot(*ring.T).max()) for ring in wheel.outlines) + _MARGIN for wheel in scene.wheels]
    low = np.min([place - reach for place, reach in zip(places, reaches, strict=True)], axis=0)
    high = np.max([place + reach for place, reach in zip(places, reaches, strict=True)], axis=0)
    wide, tall = (high - low).tolist()
    return TrainView(
        box=f"{coordinate(-high[0])} {coordinate(low[1])} {coordinate(wide)} {coordinate(tall)}",
        aspect=f"{wide / tall:.4f}",
        wheels=tuple(
            (
                wheel.shaft,
                f"{coordinate(place[0])} {coordinate(place[1])}",
                coordinate(float(np.degrees(scene.shafts[wheel.shaft].angle))),
                "".join(f"M{_points(ring)}Z" for ring in wheel.outlines),
                "".join(f"M{_points(ring)}Z" for ring in wheel.edges),
            )
            for wheel, place in zip(scene.wheels, places, strict=True)
        ),
    )


def cam_view(scene: Scene) -> CamView:
    """Cam and follower from the side."""
    n, rod, tan_beta = coordinate, scene.follower, float(scene.lift.q[0])
    second = scene.second
    reach = max(float(np.hypot(*disc.outline.T).max()) for disc in (scene, second) if disc is not None)
    if rod is None:
        inner = scene.clearance
        ahead, behind, aside = _room(scene)
    else:
        ahead, inner = scene.base + float(np.abs(scene.lift.lift).max()) + rod.radius + 6, scene.base - rod.radius
        behind, aside = 0.0, rod.radius
    left = -max(ahead, reach) - _MARGIN
    wide, high = max(reach, behind) + _MARGIN - left, 2 * (max(reach, aside) + _MARGIN)
    ray = scene.outline[int(np.argmin(np.abs(np.arctan2(scene.outline[:, 1], scene.outline[:, 0]))))][0]
    outlines = (scene.outline, *scene.openings)
    sections = (
        ()
        if rod is None
        else tuple(
            RodSection(
                face=side,
                x=n(rod.base + face * tan_beta),
                half_length=n(rod.radius / cos(atan(tan_beta))),
                radius=n(rod.radius),
                carries=(side == Face.INNER) == (tan_beta >= 0),
            )
            for side, face in zip(Face, reversed(rod.faces), strict=True)
        )
    )
    return CamView(
        box=f"{n(left)} {n(-high / 2)} {n(wide)} {n(high)}",
        aspect=f"{wide / high:.4f}",
        axis_at=n(100 * -left / wide),
        disc=_path(outlines),
        zero=(n(ray - 7), n(ray - 1.5)),
        inner=n(inner),
        reach=n(reach),
        ahead=n(ahead),
        base=n(scene.base),
        sections=sections,
        follower="" if rod else _points(scene.section),
        centre=None if scene.travel is None else (n(scene.travel.centre[0]), n(scene.travel.centre[1])),
        guide=_guide_view(scene),
        second=None
        if second is None
        else CompanionView(
            disc=_path((second.outline, *scene.openings)),
            follower=_points(second.section),
            centre=(n(second.travel.centre[0]), n(second.travel.centre[1])),
            arm=_arm(second.arm),
        ),
        rim=rim_view(scene.rim),
    )


def _path(outlines: Iterable[Array]) -> str:
    return " ".join(f"M{_points(outline)}Z" for outline in outlines)


def _points(points: Iterable[Sequence[float]] | Array) -> str:
    return " ".join(f"{coordinate(x)},{coordinate(y)}" for x, y in points)


def _arm(arm: Arm | None) -> str:
    """Points of an arm from its pivot on; empty without one."""
    return "" if arm is None else _points((arm.pivot, *arm.bends))


def _room(scene: Scene) -> tuple[float, float, float]:
    """Room that a follower and its guide take ahead of the camshaft, behind it and to either side, mm."""
    assert scene.travel is not None
    riders = [(scene.section, scene.travel, scene.guide)]
    if scene.second is not None:
        riders.append((scene.second.section, scene.second.travel, scene.second.arm))
    ends = []
    for section, travel, guide in riders:
        middle, way = complex(*travel.centre), (travel.ahead + 1j * travel.across)[::_STATION]
        about = (section[:, 0] + 1j * section[:, 1] - middle)[:, None] * np.exp(1j * travel.turned[::_STATION])
        places = [(about + middle + way).ravel()]
        match guide:
            case Slide(stem=stem):
                places.append(np.array([stem + float(travel.ahead.max()) + 0j]))
            case Arm(pivot=pivot, bends=bends):
                at, foot = complex(*pivot), middle - complex(*pivot)
                turn = (foot + way) / foot
                reach = np.array([complex(*bend) - at for bend in bends])[:, None] * turn / np.abs(turn) + at
                round_pivot = _PIVOT * np.array([1, -1, 1j, -1j])
                places += [at + round_pivot, (reach[..., None] + round_pivot).ravel()]
        every = np.concatenate(places)
        ends.append(np.column_stack([every.real, every.imag]))
    along, across = np.concatenate(ends).T
    return float(along.max()), float(-along.min()), float(np.abs(across).max())


def _guide_view(scene: Scene) -> GuideView | None:
    n = coordinate
    match scene.guide:
        case Slide(across=across, half_width=half, rails=(begin, end), stem=stem):
            assert scene.travel is not None
            foot = scene.travel.centre[0]
            return GuideView(
                rails=tuple((n(begin), n(end), n(across + side * half)) for side in (-1, 1)),
                stem=(n(foot), n(across - _STEM * half), n(stem - foot), n(2 * _STEM * half)),
            )
        case Arm(pivot=(x, y)):
            return GuideView(pivot=(n(x), n(y)), arm=_arm(scene.guide))
    return None


@dataclass(frozen=True)
class CourseView:
    """The floor from above with the tracks of the car's middle; coordinates as text, mm.

    Attributes:
        left: left edge of the drawing.
        top: its upper edge.
        width: its width.
        height: its height.
        aspect: width over height.
        floor: what stands or lies on the floor.
        tracks: code and points of each track, shape (n, 2), mm.
        car: the car, in a drawing of its own; None of a design that cannot be driven.
        size: side of the square in which the car turns, mm.
        wheel: half length and half width of a wheel, mm.
    """

    left: str
    top: str
    width: str
    height: str
    aspect: str
    floor: Sequence[FloorShape]
    tracks: Sequence[tuple[str, Array]]
    car: CarShape | None
    size: float
    wheel: tuple[float, float]

    @property
    def broad(self) -> int:
        """Ratio of the box of a course that is broader than high; 0 for one that stands beside the cam."""
        ratio = float(self.aspect)
        return 0 if ratio < _BESIDE else min(_ROWS, key=lambda row: abs(np.log(row / ratio)))

    @property
    def box(self) -> str:
        """Frame of the drawing, whose y points down."""
        return f"{self.left} {coordinate(-float(self.top))} {self.width} {self.height}"


def course_view(
    floor: Sequence[FloorShape],
    goings: Sequence[Going] = (),
    car: CarShape | None = None,
    points: Sequence[tuple[float, float]] = (),
) -> CourseView:
    """The floor with the runs of the car.

    Args:
        floor: what stands or lies on the floor.
        goings: runs of the car; none of a design that cannot be driven.
        car: the car that makes them.
        points: further places to have in the picture, mm.
    """
    tracks = {}
    middle = complex(*car.middle) if car is not None else 0j
    for going in goings if car is not None else ():
        at = (going.x + 1j * going.y + middle * np.exp(1j * going.heading))[::_TRACK]
        tracks[going.code] = np.column_stack([at.real, at.imag])
    edges = [np.array(shape.points) for shape in floor if shape.kind == FloorKind.EDGE]
    places = [*tracks.values(), *(np.array(shape.points) for shape in floor), *(np.array([at]) for at in points)]
    seen = edges or places or [np.zeros((1, 2))]
    room = _ROOM / 2 if edges else _ROOM
    low, high = np.concatenate(seen).min(axis=0) - room, np.concatenate(seen).max(axis=0) + room
    wide, tall = float(high[0] - low[0]), float(high[1] - low[1])
    corners = () if car is None else (car.fork, car.idle, *car.corners, (60.0, 0.0))
    return CourseView(
        left=coordinate(low[0]),
        top=coordinate(high[1]),
        width=coordinate(wide),
        height=coordinate(tall),
        aspect=f"{wide / tall:.4f}",
        floor=floor,
        tracks=[(code, tracks[code]) for code in sorted(tracks, key=lambda code: _ORDER.get(code, 9))],
        car=car,
        size=2.2 * max((abs(complex(*point)) for point in corners), default=0.0),
        wheel=((car and car.wheel) or _WHEEL[0], _WHEEL[1]),
    )
