"""The cycloidal law: s = u - sin(2 pi u) / (2 pi), at rest at both ends, without a jump of acceleration.

Its greatest velocity is 2 and its greatest acceleration 2 pi, for a unit rise over a unit angle.
"""

from __future__ import annotations

from math import tau
from typing import TYPE_CHECKING

from cadgen.laws.law import MotionLaw

if TYPE_CHECKING:
    from cadgen.arrays import Array


def _jet(u: Array) -> Array:
    import numpy as np

    return np.stack([u - np.sin(tau * u) / tau, 1 - np.cos(tau * u), tau * np.sin(tau * u)], axis=1)


CYCLOIDAL = MotionLaw(
    code="cycloidal",
    meaning="The cycloid: from rest to rest, with a sine for its acceleration.",
    jet=_jet,
)
