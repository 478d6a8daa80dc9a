"""Harmonic laws: simple, double, and two halves of the simple one.

The double harmonic, s = (1 - cos(pi u)) / 2 - (1 - cos(2 pi u)) / 8, begins without acceleration and is at its top for
an instant only. Half laws lead from rest to a speed, or from a speed to rest.
"""

from math import pi

from cadgen.laws.form import Form, Piece
from cadgen.laws.law import MotionLaw

_COS = pi / 2  # phase of a cosine

SIMPLE_HARMONIC = MotionLaw.of(
    "simple_harmonic",
    "Half a cosine: the acceleration jumps beside a dwell.",
    Form((Piece(1.0, (0.5,), ((-0.5, pi, _COS),)),)),
)
DOUBLE_HARMONIC = MotionLaw.of(
    "double_harmonic",
    "Two cosines: from rest to a top without dwell; a return runs it backwards.",
    Form((Piece(1.0, (0.375,), ((-0.5, pi, _COS), (0.125, 2 * pi, _COS))),)),
    to_top=True,
)
HALF_HARMONIC_1 = MotionLaw.of(
    "half_harmonic_1",
    "First half of the simple harmonic: from rest to a speed of pi/2.",
    Form((Piece(1.0, (1.0,), ((-1.0, pi / 2, _COS),)),)),
)
HALF_HARMONIC_2 = MotionLaw.of(
    "half_harmonic_2",
    "Second half of the simple harmonic: from a speed of pi/2 to rest.",
    Form((Piece(1.0, (), ((1.0, pi / 2, 0.0),)),)),
)
HARMONICS = (SIMPLE_HARMONIC, DOUBLE_HARMONIC, HALF_HARMONIC_1, HALF_HARMONIC_2)
