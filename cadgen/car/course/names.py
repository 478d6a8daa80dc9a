"""Names of points of the car and of sides, for design files and for the course. The module is light to import."""

from enum import StrEnum


class CarPoint(StrEnum):
    """Point of the car: its fork axis, halfway between the rear wheels, or where a wheel touches the floor."""

    FORK = "fork"
    MIDDLE = "middle"
    DRIVE_WHEEL = "drive_wheel"
    IDLE_WHEEL = "idle_wheel"


class Side(StrEnum):
    """Side of a thing, seen in the direction of driving."""

    LEFT = "left"
    RIGHT = "right"


class ObstacleKind(StrEnum):
    """Kind of a thing that keeps the car away."""

    POST = "post"
    WALL = "wall"
    ZONE = "zone"


class Judged(StrEnum):
    """Runs that must keep the course: the planned one, or those over the band of play as well."""

    PLANNED = "planned"
    PLAY = "play"


class Scaled(StrEnum):
    """Kind of things on a course that move when its spacing is drawn."""

    FIELD = "field"
    START = "start"
    FINISH = "finish"
    POSTS = "posts"
    WALLS = "walls"
    ZONES = "zones"
    GATES = "gates"
