"""Polynomials from rest to rest: 2-3, 3-4-5, 4-5-6-7 and 5-6-7-8-9, which differ by how many derivatives are 0 there.

Their greatest velocities are 3/2, 15/8, 35/16 and 315/128, for a unit rise over a unit angle (Norton, Cam Design and
Manufacturing Handbook, ch. 4).
"""

from cadgen.laws.form import power_form
from cadgen.laws.law import MotionLaw

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
POLYNOMIALS = (POLYNOMIAL_2_3, POLYNOMIAL_3_4_5, POLYNOMIAL_4_5_6_7, POLYNOMIAL_5_6_7_8_9)
