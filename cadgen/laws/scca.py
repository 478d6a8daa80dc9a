"""The SCCA family: a sine, a constant, a cosine for the acceleration, and the same again backwards.

The shares b, c and d of the angle, with b + c + d = 1, belong to the sines at the ends, the constant accelerations and
the cosine. With (1/4, 1/2, 1/4) it is the modified trapezoid and (1/4, 0, 3/4) the modified sine. The greatest
acceleration is 4 pi^2 / ((pi^2 - 8)(b^2 - d^2) - 2 pi (pi - 2) b + pi^2) (Norton, Cam Design and Manufacturing
Handbook, ch. 3). A straight line of a share k in the middle leaves 1 - k to these: the modified sine with constant
velocity.
"""

from math import pi

from cadgen.laws.form import AccelerationPart, Form, from_acceleration
from cadgen.laws.law import MotionLaw


def scca(sine: float, constant: float, cosine: float, straight: float = 0.0) -> Form:
    """Form of the family.

    Args:
        sine, constant, cosine: b, c and d, which add up to 1, dimensionless.
        straight: share of the angle with constant velocity, in the middle, dimensionless.
    """
    b, c, d = ((1 - straight) * share for share in (sine, constant, cosine))
    up, down = pi / b if b else 0.0, pi / d if d else 0.0
    return from_acceleration(
        (
            AccelerationPart(b / 2, sine=(1.0, up, 0.0)),
            AccelerationPart(c / 2, 1.0),
            AccelerationPart(d / 2, sine=(1.0, down, pi / 2)),
            AccelerationPart(straight),
            AccelerationPart(d / 2, sine=(-1.0, down, 0.0)),
            AccelerationPart(c / 2, -1.0),
            AccelerationPart(b / 2, sine=(-1.0, up, pi / 2)),
        )
    )


def _modified_sine(name: str, straight: float, said: str) -> MotionLaw:
    return MotionLaw.of(
        f"modified_sine_{name}",
        f"The modified sine with constant velocity over {said} of the angle.",
        scca(0.25, 0.0, 0.75, straight),
    )


MODIFIED_TRAPEZOID = MotionLaw.of(
    "modified_trapezoid",
    "The modified trapezoid: from rest to rest, gentle in acceleration.",
    scca(0.25, 0.5, 0.25),
)
MODIFIED_SINE = MotionLaw.of(
    "modified_sine",
    "The modified sine: from rest to rest, gentle in velocity and in torque.",
    scca(0.25, 0.0, 0.75),
)
SCCA = (
    MODIFIED_TRAPEZOID,
    MODIFIED_SINE,
    _modified_sine("20", 0.2, "20 %"),
    _modified_sine("33", 1 / 3, "a third"),
    _modified_sine("50", 0.5, "half"),
    _modified_sine("66", 2 / 3, "two thirds"),
)
