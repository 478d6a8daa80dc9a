"""Where on a cam something is, in words."""

import numpy as np

from cadgen.arrays import Array


def cam_place(theta: float) -> str:
    """A cam angle theta, rad, in words.

    Args:
        theta: cam angle, rad.
    """
    return f"cam angle {np.degrees(theta):.2f}°"


def polar_place(point: Array) -> str:
    """The direction of a point from the camshaft in words.

    Args:
        point: point, shape (2,), mm.
    """
    return f"polar angle {np.degrees(np.arctan2(point[1], point[0])) % 360:.2f}°"
