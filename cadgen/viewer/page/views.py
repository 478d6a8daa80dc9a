"""The two plan views as SVG: the cam with its follower, and the car on its course. The page's script moves them."""

from collections.abc import Iterable, Sequence
from math import atan, cos

import numpy as np

from cadgen.arrays import Array
from cadgen.parts.face import Face
from cadgen.viewer.page.document import CarShape, Figure, Going, Scene, Words
from cadgen.viewer.page.markup import labels, tag, text
from cadgen.viewer.page.names import FigureKind
from cadgen.viewer.page.words import say

_MARGIN = 4.0  # mm about the cam
_ROOM = 220.0  # mm about the floor
_TRACK = 6  # of a run's positions, one in so many is on its track
_WHEEL = (32.0, 10.0)  # mm, half length and half width of a wheel whose size is not known


def cam_view(scene: Scene) -> str:
    """Cam and follower, seen from the left of the car with its front to the left.

    What turns, what moves and what stands are drawings of their own, one above the other, so that a browser paints each
    but once. All have the frame of the file, mirrored, with the camshaft at the place that the disc turns about.
    """
    reach = float(np.hypot(*scene.outline.T).max())
    radius = 0.0 if scene.follower is None else scene.follower.radius
    ahead = scene.base + float(np.abs(scene.lift.lift).max()) + radius + 6
    left, wide, high = -max(ahead, reach) - _MARGIN, max(ahead, reach) + reach + 2 * _MARGIN, 2 * (reach + _MARGIN)
    box = f"{_n(left)} {_n(-high / 2)} {_n(wide)} {_n(high)}"
    ray = scene.outline[int(np.argmin(np.abs(np.arctan2(scene.outline[:, 1], scene.outline[:, 0]))))][0]
    disc = (
        tag("path", d=f"{_path(scene.outline)} {' '.join(_path(hole) for hole in scene.openings)}", class_="disc"),
        tag("line", x1=_n(ray - 7), y1=0, x2=_n(ray - 1.5), y2=0, class_="zero"),
    )
    still = (
        tag("circle", cx=0, cy=0, r=_n(scene.base - radius), class_="base"),
        tag("line", x1=_n(-reach), y1=0, x2=_n(ahead), y2=0, class_="axis"),
        tag("line", x1=0, y1=_n(-reach), x2=0, y2=_n(reach), class_="axis"),
        tag("line", x1=_n(scene.base), y1=-9, x2=_n(scene.base), y2=9, class_="axis"),
    )
    layers = (
        _layer(box, disc, "disc", origin=f"{_n(100 * -left / wide)}%"),
        _layer(box, still, "cam-frame"),
        _layer(box, _follower(scene), "rod"),
    )
    return _stage(layers, wide / high, say("Cam and follower"), "cam-view")


def _stage(layers: Iterable[str], aspect: float, title: Words, code: str) -> str:
    return tag("div", *layers, class_="stage", id=code, role="img", data_aspect=f"{aspect:.4f}", **labels(title))


def _layer(box: str, content: Iterable[str], code: str, *, origin: str | None = None) -> str:
    """A mirrored drawing that fills its stage."""
    group = tag("g", *content, transform="scale(-1 1)")
    return tag("svg", group, viewBox=box, class_="layer", id=f"{code}-layer", aria_hidden="true", data_origin=origin)


def _follower(scene: Scene) -> list[str]:
    """The rod's sections in both faces of the disc, that in the carrying face last; a point for another follower."""
    rod, tan_beta = scene.follower, float(scene.lift.tan_beta[0])
    if rod is None:
        return [tag("circle", cx=_n(scene.base + float(scene.lift.lift[0])), cy=0, r=2.5, class_="rod", id="rod-point")]
    inner = tan_beta >= 0
    return [
        tag(
            "ellipse",
            cx=_n(rod.base + face * tan_beta),
            cy=0,
            rx=_n(rod.radius / cos(atan(tan_beta))),
            ry=_n(rod.radius),
            class_="rod" if (side == Face.INNER) == inner else "rod far",
            id=f"rod-{side}",
        )
        for side, face in zip(Face, reversed(rod.faces), strict=True)
    ]


def course_view(
    floor: Sequence[Figure],
    goings: Sequence[Going] = (),
    car: CarShape | None = None,
    points: Sequence[tuple[float, float]] = (),
) -> str:
    """The floor from above with the tracks of the car's middle, and the car in a drawing of its own.

    Args:
        floor: what stands or lies on the floor.
        goings: runs of the car; none of a design that cannot be driven.
        car: the car that makes them.
        points: further places to have in the picture, mm.
    """
    tracks = {going.code: _track(going, car) for going in goings if car is not None}
    edges = [np.array(figure.points) for figure in floor if figure.kind == FigureKind.EDGE]
    places = [*tracks.values(), *(np.array(figure.points) for figure in floor), *(np.array([at]) for at in points)]
    seen = edges or places or [np.zeros((1, 2))]
    room = _ROOM / 2 if edges else _ROOM
    low, high = np.concatenate(seen).min(axis=0) - room, np.concatenate(seen).max(axis=0) + room
    order = {"planned": 0, "before": 1, "free": 2, "played": 3}
    drawn = [
        *(_figure(figure) for figure in floor),
        *(
            tag("polyline", points=_points(tracks[code]), class_=f"track {code}", id=f"track-{code}")
            for code in sorted(tracks, key=lambda code: order.get(code, 9))
        ),
    ]
    wide, tall = float(high[0] - low[0]), float(high[1] - low[1])
    box = f"{_n(low[0])} {_n(-high[1])} {_n(wide)} {_n(tall)}"
    size = 0.0 if car is None else _car_size(car)
    frame = {"left": _n(low[0]), "top": _n(high[1]), "width": _n(wide), "height": _n(tall), "size": _n(size)}
    cars = (
        tag(
            "svg",
            tag("g", *_car(car), transform="scale(1 -1)"),
            viewBox=f"{_n(-size / 2)} {_n(-size / 2)} {_n(size)} {_n(size)}",
            class_=f"layer {kind}",
            id=code,
            aria_hidden="true",
        )
        for code, kind in (("car-planned", "car ghost"), ("car", "car"))
        if car is not None
    )
    ground = tag("svg", tag("g", *drawn, transform="scale(1 -1)"), viewBox=box, class_="layer", aria_hidden="true")
    return tag(
        "div",
        ground,
        *cars,
        class_="stage",
        id="course-view",
        role="img",
        data_aspect=f"{wide / tall:.4f}",
        **{f"data_{key}": value for key, value in frame.items()},
        **labels(say("The car on its course")),
    )


def _car_size(car: CarShape) -> float:
    """Side of the square in which the car turns, mm."""
    return 2.2 * max(abs(complex(*point)) for point in (car.fork, car.idle, *car.corners, (60.0, 0.0)))


def _track(going: Going, car: CarShape) -> Array:
    """Track of the car's middle, shape (n, 2), mm."""
    at = (going.x + 1j * going.y + complex(*car.middle) * np.exp(1j * going.heading))[::_TRACK]
    return np.column_stack([at.real, at.imag])


def _car(car: CarShape) -> list[str]:
    """The car about its drive wheel, x ahead."""
    half = (car.wheel or _WHEEL[0], _WHEEL[1])
    spots = [car.fork, (0.0, 0.0), car.idle]
    body = car.corners or tuple(spots)
    return [
        tag("polygon", points=_points(np.array(body)), class_="body"),
        tag("g", _wheel((0.0, 0.0), half), _wheel(car.idle, half)),
        tag(
            "g",
            tag("g", _wheel((0.0, 0.0), (0.6 * half[0], half[1])), class_="front"),
            transform=f"translate({_n(car.fork[0])} {_n(car.fork[1])})",
        ),
    ]


def _wheel(centre: tuple[float, float], half: tuple[float, float]) -> str:
    x, y = centre[0] - half[0], centre[1] - half[1]
    return tag("rect", x=_n(x), y=_n(y), width=_n(2 * half[0]), height=_n(2 * half[1]), rx=4, class_="wheel")


def _figure(figure: Figure) -> str:
    """A thing on the floor: a disc, a line as thick as its reach, an area."""
    points = np.array(figure.points)
    if len(points) == 1:
        return tag("circle", cx=_n(points[0, 0]), cy=_n(points[0, 1]), r=_n(max(figure.reach, 1.0)), class_=figure.kind)
    if figure.filled:
        return tag("polygon", points=_points(points), class_=figure.kind)
    wide = _n(max(2 * figure.reach, 12.0))
    return tag("polyline", points=_points(points), class_=f"{figure.kind} bar", stroke_width=wide)


def _path(points: Array) -> str:
    return f"M{_points(points)}Z"


def _points(points: Array | Iterable[Iterable[float]]) -> str:
    return " ".join(f"{_n(x)},{_n(y)}" for x, y in points)


def _n(value: float) -> str:
    """A coordinate in as few digits as it takes: to a hundredth."""
    return f"{float(value):.2f}".rstrip("0").rstrip(".")


def legend(goings: Iterable[Going]) -> str:
    """Names of the lines on the course, as items of a list."""
    return "".join(tag("li", tag("i", class_=f"key {going.code}"), text(going.label)) for going in goings)
