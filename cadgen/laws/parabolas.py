"""Constant velocity, constant acceleration in two parts, and the trapezoid of acceleration.

With the ratio r of the two accelerations of an unequal parabola, the first part takes the share 1 / (1 + r) of the
angle and of the rise; the accelerations are 2 (1 + r) and 2 (1 + r) / r. The velocity is 2 at its greatest.
"""

from cadgen.laws.form import Form, Piece, Zone, from_acceleration, power_form
from cadgen.laws.law import MotionLaw
from cadgen.messages import Message

_RATIOS = (0.02, 50.0)


def unequal_parabola(ratio: float) -> MotionLaw:
    """Law of two constant accelerations.

    Args:
        ratio: first acceleration by the second, dimensionless, 1/50 to 50.

    Raises:
        ValueError: the ratio is out of its range.
    """
    low, high = _RATIOS
    if not low <= ratio <= high:
        raise ValueError(
            Message(
                "acceleration_ratio is {ratio:g}; it must be at least {low:g} and at most {high:g}: correct it",
                ratio=ratio,
                low=low,
                high=high,
            )
        )
    share = 1 / (1 + ratio)
    first, second = 2 / share, 2 / (1 - share)
    form = Form((Piece(share, (0.0, 0.0, first / 2)), Piece(1.0, (share, 2.0, -second / 2))))
    return MotionLaw.of(
        "unequal_parabola",
        "Two constant accelerations of unequal size, by `acceleration_ratio`, first one by second, 3 if left out.",
        form,
        pieces=1,
        key="acceleration_ratio",
        shaped=unequal_parabola,
    )


CONSTANT_VELOCITY = MotionLaw.of(
    "constant_velocity", "A straight line: its neighbours must move as fast.", power_form((0, 1)), pieces=1
)
CONSTANT_ACCELERATION = MotionLaw.of(
    "constant_acceleration",
    "The parabola: constant acceleration, then constant deceleration; the acceleration jumps thrice.",
    from_acceleration((Zone(0.5, 1.0), Zone(0.5, -1.0))),
    pieces=1,
)
TRAPEZOID = MotionLaw.of(
    "trapezoid",
    "Trapezoids of acceleration, each ramp an eighth of the angle.",
    from_acceleration(
        (
            Zone(1 / 8, 0.0, 8.0),
            Zone(1 / 4, 1.0),
            Zone(1 / 4, 1.0, -8.0),
            Zone(1 / 4, -1.0),
            Zone(1 / 8, -1.0, 8.0),
        )
    ),
    pieces=1,
)
PARABOLAS = (CONSTANT_VELOCITY, CONSTANT_ACCELERATION, unequal_parabola(3.0), TRAPEZOID)
