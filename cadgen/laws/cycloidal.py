"""Cycloidal laws: s = u - sin(2 pi u) / (2 pi), at rest at both ends without a jump of acceleration, and its halves.

The whole one has a greatest velocity of 2 and a greatest acceleration of 2 pi, for a unit rise over a unit angle. The
halves, s = u -+ sin(pi u) / pi, lead from rest to a speed of 2 and back. With a straight line between them they are the
sine-line of VDI 2143.
"""

from math import pi, tau

from cadgen.laws.form import Zone, from_acceleration, sine_form
from cadgen.laws.law import MotionLaw

CYCLOIDAL = MotionLaw.of(
    "cycloidal",
    "The cycloid: from rest to rest, with a sine for its acceleration.",
    sine_form(1.0, ((-1 / tau, tau),)),
)
HALF_CYCLOID_1 = MotionLaw.of(
    "half_cycloid_1",
    "First half of the cycloid: from rest to a speed of 2, without a jump of acceleration.",
    sine_form(1.0, ((-1 / pi, pi),)),
)
HALF_CYCLOID_2 = MotionLaw.of(
    "half_cycloid_2",
    "Second half of the cycloid: from a speed of 2 to rest, without a jump of acceleration.",
    sine_form(1.0, ((1 / pi, pi),)),
)
CYCLOID_LINE = MotionLaw.of(
    "cycloid_line_50",
    "Half a cycloid, a straight line over half of the angle, half a cycloid.",
    from_acceleration((Zone(0.25, sine=(1.0, 4 * pi, 0.0)), Zone(0.5), Zone(0.25, sine=(-1.0, 4 * pi, 0.0)))),
)
CYCLOIDS = (CYCLOIDAL, HALF_CYCLOID_1, HALF_CYCLOID_2, CYCLOID_LINE)
