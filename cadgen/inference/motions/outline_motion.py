"""The motion of an outline that was measured in any frame: its centre is found, and taken off until it stays."""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Follower
from cadgen.errors import FileError
from cadgen.inference.motions.found_motion import FoundMotion, found_motion
from cadgen.inference.motions.lift_samples import centre_of, normals_of, ordered, samples_of_points

_ROUNDS = 4
_SETTLED = 2e-3  # mm; a centre that moves by less leaves the samples as they are
_LEAST_POINTS = 90


@dataclass(frozen=True, kw_only=True, eq=False)
class OutlineMotion:
    """Motion of an outline.

    Attributes:
        found: motion.
        centre: place of the camshaft in the frame of the points, mm, shape (2,).
        centred: whether the centre was found, and not taken to be the origin.
        base: radius of the base circle, mm.
    """

    found: FoundMotion
    centre: Array
    centred: bool
    base: float


def outline_motion(points: Array, follower: Follower) -> OutlineMotion:
    """Motion that points of an outline show.

    Args:
        points: points on the face on which the disc turns clockwise, in any order and about any origin, mm, (n, 2).
        follower: follower, whose base circle may be any.

    Raises:
        FileError: the points do not show a cam that the follower can run on.
    """
    points = ordered(points)
    if len(points) < _LEAST_POINTS:
        raise FileError(
            "{count} points are too few to find a motion: measure at least {least} of the outline",
            count=len(points),
            least=_LEAST_POINTS,
        )
    normals, centre = normals_of(points), centre_of(points)
    placed = centre is not None
    at = np.zeros(2) if centre is None else centre
    found = None
    for _ in range(_ROUNDS):
        found = found_motion(samples_of_points(points - at, normals, follower))
        if found.centre is None:
            break
        at, placed = at + found.centre, True
        if float(np.hypot(*found.centre)) < _SETTLED:
            break
    assert found is not None
    return OutlineMotion(found=found, centre=at, centred=placed, base=follower.dwelling(found.base))
