"""Laps of a car with play, step by step: a derivation that shares no code with the package.

The cam's steering is a table over the turn. At each step the gears push the cam if it is behind them; then the rod
turns it ahead, one place of the table after the other, as long as the next place is lower and within the play. The car
rolls along a short arc at each step, on the curvature that the wheelbase and the drive wheel's offset give.
"""

from dataclasses import dataclass
from math import cos, pi, sin


@dataclass(frozen=True)
class LapPose:
    """Position of the drive wheel, mm, and heading, rad."""

    x: float
    y: float
    heading: float


def laps_with_play(
    steering: list[float], play: int, turns: int, travel: float, wheelbase: float, offset: float
) -> list[LapPose]:
    """Poses at the start and after each turn of the cam, the cam being set on its gears' side.

    Args:
        steering: tan(beta) at even cam angles of one turn.
        play: return error, in places of that table.
        turns: turns of the cam.
        travel: of the drive wheel in one turn, mm.
        wheelbase: L, mm.
        offset: A1, mm.
    """
    count = len(steering)
    step, cam, x, y, heading = travel / count, 0, 0.0, 0.0, pi / 7
    poses = [LapPose(x, y, heading)]
    for motor in range(turns * count):
        cam = max(cam, motor)
        while cam < motor + play and steering[(cam + 1) % count] < steering[cam % count]:
            cam += 1
        tangent = steering[cam % count]
        turned = -tangent / (wheelbase + offset * tangent) * step
        # The chord of a short arc points along its middle.
        x += step * cos(heading + turned / 2)
        y += step * sin(heading + turned / 2)
        heading += turned
        if (motor + 1) % count == 0:
            poses.append(LapPose(x, y, heading))
    return poses
