"""Laws of powers: polynomials from rest to rest, constant velocity, constant accelerations, trapezoid of acceleration.

The polynomials 2-3, 3-4-5, 4-5-6-7 and 5-6-7-8-9 differ by how many derivatives are 0 at both ends. Their greatest
velocities are 3/2, 15/8, 35/16 and 315/128 (Norton, Cam Design and Manufacturing Handbook, ch. 4).

With the ratio r of the two accelerations of an unequal parabola, the first part takes the share 1 / (1 + r) of the
angle and of the rise; the accelerations are 2 (1 + r) and 2 (1 + r) / r. The velocity is 2 at its greatest.
"""

from cadgen.laws.form import AccelerationPart, Form, FormPart, from_acceleration, power_form
from cadgen.laws.law import MotionLaw
from cadgen.messages import Message

_RATIOS = (0.02, 50.0)

POLYNOMIAL_2_3 = MotionLaw.of(
    "polynomial_2_3",
    "The cubic: from rest to rest, with a jump of acceleration at both ends.",
    power_form((0, 0, 3, -2)),
    pieces=1,
)
POLYNOMIAL_3_4_5 = MotionLaw.of(
    "polynomial_3_4_5",
    "The 3-4-5 polynomial: from rest to rest, gentle in velocity.",
    power_form((0, 0, 0, 10, -15, 6)),
    pieces=1,
)
POLYNOMIAL_4_5_6_7 = MotionLaw.of(
    "polynomial_4_5_6_7",
    "The 4-5-6-7 polynomial: from rest to rest, without a jump of jerk.",
    power_form((0, 0, 0, 0, 35, -84, 70, -20)),
)
POLYNOMIAL_5_6_7_8_9 = MotionLaw.of(
    "polynomial_5_6_7_8_9",
    "The 5-6-7-8-9 polynomial: from rest to rest, without a jump of the jerk's derivative.",
    power_form((0, 0, 0, 0, 0, 126, -420, 540, -315, 70)),
)


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
    form = Form((FormPart(share, (0.0, 0.0, first / 2)), FormPart(1.0, (share, 2.0, -second / 2))))
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
    from_acceleration((AccelerationPart(0.5, 1.0), AccelerationPart(0.5, -1.0))),
    pieces=1,
)
TRAPEZOID = MotionLaw.of(
    "trapezoid",
    "Trapezoids of acceleration, each ramp an eighth of the angle.",
    from_acceleration(
        (
            AccelerationPart(1 / 8, 0.0, 8.0),
            AccelerationPart(1 / 4, 1.0),
            AccelerationPart(1 / 4, 1.0, -8.0),
            AccelerationPart(1 / 4, -1.0),
            AccelerationPart(1 / 8, -1.0, 8.0),
        )
    ),
    pieces=1,
)
POWER_LAWS = (
    POLYNOMIAL_2_3,
    POLYNOMIAL_3_4_5,
    POLYNOMIAL_4_5_6_7,
    POLYNOMIAL_5_6_7_8_9,
    CONSTANT_VELOCITY,
    CONSTANT_ACCELERATION,
    unequal_parabola(3.0),
    TRAPEZOID,
)
