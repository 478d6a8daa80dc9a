"""The 3-4-5 polynomial: s = 10 u^3 - 15 u^4 + 6 u^5, at rest at both ends, without a jump of acceleration.

Its greatest velocity is 15/8 and its greatest acceleration 10 / sqrt(3), for a unit rise over a unit angle.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from cadgen.laws.law import MotionLaw

if TYPE_CHECKING:
    from cadgen.arrays import Array


def _jet(u: Array) -> Array:
    import numpy as np

    return np.stack(
        [
            u**3 * (10 - 15 * u + 6 * u**2),
            30 * u**2 * (1 - u) ** 2,
            60 * u * (1 - u) * (1 - 2 * u),
        ],
        axis=1,
    )


POLYNOMIAL_3_4_5 = MotionLaw(
    code="polynomial_3_4_5",
    meaning="The 3-4-5 polynomial: from rest to rest, gentle in velocity.",
    jet=_jet,
    pieces=1,
)
