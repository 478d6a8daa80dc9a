"""Names of points of the car and of sides, for design files and for the course. The module is light to import."""

from typing import Literal

# `fork`: the front fork axis; `middle`: halfway between the rear wheels; the wheels: where they touch the floor.
CarPoint = Literal["fork", "middle", "drive_wheel", "idle_wheel"]
Side = Literal["left", "right"]
# What keeps the car away.
ObstacleKind = Literal["post", "wall", "zone"]
# Runs that must keep the course: the planned one, or those over the band of play as well.
Judged = Literal["planned", "play"]
# Kinds of things on a course that move when its spacing is drawn.
Scaled = Literal["field", "start", "finish", "posts", "walls", "zones", "gates"]
