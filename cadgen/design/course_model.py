"""From a design to the course and the car's outline."""

from math import floor, inf, radians

from cadgen.car.course.body import CarBody, CarWheel, PartName
from cadgen.car.course.layout import Course, Draw, Gate, Obstacle, ObstacleKind, Point, Shape
from cadgen.design import cam_model
from cadgen.design import course as keys
from cadgen.design.outline import Outline
from cadgen.design.schema import Design

GATE_RADIUS = 50.0
STAND_RADIUS = 1.0


def course(design: Design) -> Course | None:
    """The course; None without [course]."""
    given = design.course
    if given is None:
        return None
    return Course(
        edge=_edge(given.field) if given.field else None,
        obstacles=(
            *(_post(post, f"course.posts.{i}") for i, post in enumerate(given.posts, 1)),
            *(_wall(wall, f"course.walls.{i}") for i, wall in enumerate(given.walls, 1)),
            *(_zone(zone, f"course.zones.{i}") for i, zone in enumerate(given.zones, 1)),
        ),
        gates=tuple(_gate(gate, f"course.gates.{i}", GATE_RADIUS) for i, gate in enumerate(given.gates, 1)),
        start=_gate(given.start, "course.start", STAND_RADIUS) if given.start else None,
        finish=_gate(given.finish, "course.finish", STAND_RADIUS) if given.finish else None,
        margin=given.margin_mm,
        judged=given.judged,
    )


def draw(design: Design) -> Draw | None:
    """The spacings of the course; None where it has one spacing alone."""
    given = None if design.course is None else design.course.spacing
    if given is None:
        return None
    steps = floor((given.to_mm - given.from_mm) / given.step_mm + 1e-9)
    spacings = {given.from_mm + step * given.step_mm for step in range(steps + 1)} | {given.to_mm}
    return Draw(
        spacings=tuple(sorted(spacings)), stated=given.stated_mm, about=given.about_mm, kinds=frozenset(given.scaled)
    )


def body(design: Design) -> CarBody:
    """Outline and wheels of the car; without [car.outline] the points where its wheels touch the floor."""
    car, given = cam_model.car(design), design.car.outline
    rear_radius, rear_width, front_radius, front_width, clearance = 0.0, 0.0, 0.0, 0.0, 0.0
    if given:
        rear_radius, rear_width = (given.wheel_diameter_mm or 0.0) / 2, given.wheel_width_mm
        front_radius, front_width = (given.front_wheel_diameter_mm or 0.0) / 2, given.front_wheel_width_mm
        clearance = given.ground_clearance_mm
    drive, idle = (-car.wheelbase, car.drive_wheel_offset), (-car.wheelbase, -car.idle_wheel_offset)
    return CarBody(
        corners=_corners(given, (drive[1] + idle[1]) / 2) if given else (),
        clearance=clearance,
        wheels=(
            CarWheel(
                name=PartName.FRONT_WHEEL, centre=(0.0, 0.0), radius=front_radius, width=front_width, steered=True
            ),
            CarWheel(name=PartName.DRIVE_WHEEL, centre=drive, radius=rear_radius, width=rear_width),
            CarWheel(name=PartName.IDLE_WHEEL, centre=idle, radius=rear_radius, width=rear_width),
        ),
    )


def _corners(given: Outline, middle: float) -> tuple[Point, ...]:
    if given.corners_mm is not None:
        return given.corners_mm
    length, width, front = given.length_mm or 0.0, given.width_mm or 0.0, given.front_overhang_mm or 0.0
    left = middle + width / 2 if given.left_overhang_mm is None else given.left_overhang_mm
    return ((front, left), (front - length, left), (front - length, left - width), (front, left - width))


def _edge(given: keys.Edge) -> Shape:
    if given.outline_mm is not None:
        return Shape(given.outline_mm, filled=True)
    return _rectangle(given.corner_mm or (0.0, 0.0), given.size_mm or (0.0, 0.0))


def _rectangle(corner: Point, size: tuple[float, float]) -> Shape:
    (x, y), (width, height) = corner, size
    return Shape(((x, y), (x + width, y), (x + width, y + height), (x, y + height)), filled=True)


def _height(given: float | None) -> float:
    return inf if given is None else given


def _post(given: keys.Post, key: str) -> Obstacle:
    shape = Shape.disc(given.at_mm, given.radius_mm)
    return Obstacle(kind=ObstacleKind.POST, key=key, shape=shape, height=_height(given.height_mm), side=given.side)


def _wall(given: keys.Wall, key: str) -> Obstacle:
    shape = Shape(given.line_mm, reach=given.thickness_mm / 2)
    return Obstacle(kind=ObstacleKind.WALL, key=key, shape=shape, height=_height(given.height_mm))


def _zone(given: keys.Zone, key: str) -> Obstacle:
    if given.outline_mm is not None:
        shape = Shape(given.outline_mm, filled=True)
    elif given.corner_mm is not None and given.size_mm is not None:
        shape = _rectangle(given.corner_mm, given.size_mm)
    else:
        shape = Shape.disc(given.at_mm or (0.0, 0.0), given.radius_mm or 0.0)
    return Obstacle(kind=ObstacleKind.ZONE, key=key, shape=shape, height=_height(given.height_mm))


def _gate(given: keys.Gate | keys.Stand, key: str, radius: float) -> Gate:
    if given.from_mm is not None and given.to_mm is not None:
        place = Shape((given.from_mm, given.to_mm))
    else:
        place = Shape.disc(given.at_mm or (0.0, 0.0), radius if given.radius_mm is None else given.radius_mm)
    return Gate(
        key=key,
        place=place,
        point=given.point,
        heading=None if given.heading_deg is None else radians(given.heading_deg),
        heading_tolerance=radians(given.heading_tolerance_deg),
        free=isinstance(given, keys.Gate) and given.free,
    )
