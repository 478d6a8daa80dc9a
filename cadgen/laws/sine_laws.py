"""Laws of sines: cycloidal and harmonic ones with their halves, and laws of few harmonics for machines that swing.

**Cycloidal.** s = u - sin(2 pi u) / (2 pi) is at rest at both ends without a jump of acceleration. Its greatest
velocity is 2 and its greatest acceleration 2 pi. The halves, s = u -+ sin(pi u) / pi, lead from rest to a speed of 2
and back. With a straight line between them they are the sine-line of VDI 2143.

**Harmonic.** The simple one is half a cosine. The double harmonic, s = (1 - cos(pi u)) / 2 - (1 - cos(2 pi u)) / 8,
begins without acceleration and is at its top for an instant only.

**Few harmonics.** Gutman takes the first two terms of the Fourier series of the parabola. Freudenstein chooses the
amplitudes for the least peak of the acceleration (Chen, Mechanics and Design of Cam Mechanisms, ch. 2).
"""

from math import pi, tau

from cadgen.laws.form import AccelerationPart, Form, FormPart, from_acceleration, sine_form
from cadgen.laws.law import MotionLaw

_COS = pi / 2  # phase of a cosine
_SHARE = 1125 / 1192 / tau

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
    from_acceleration(
        (
            AccelerationPart(0.25, sine=(1.0, 4 * pi, 0.0)),
            AccelerationPart(0.5),
            AccelerationPart(0.25, sine=(-1.0, 4 * pi, 0.0)),
        )
    ),
)
SIMPLE_HARMONIC = MotionLaw.of(
    "simple_harmonic",
    "Half a cosine: the acceleration jumps beside a dwell.",
    Form((FormPart(1.0, (0.5,), ((-0.5, pi, _COS),)),)),
)
DOUBLE_HARMONIC = MotionLaw.of(
    "double_harmonic",
    "Two cosines: from rest to a top without dwell; a return runs it backwards.",
    Form((FormPart(1.0, (0.375,), ((-0.5, pi, _COS), (0.125, 2 * pi, _COS))),)),
    to_top=True,
)
HALF_HARMONIC_1 = MotionLaw.of(
    "half_harmonic_1",
    "First half of the simple harmonic: from rest to a speed of pi/2.",
    Form((FormPart(1.0, (1.0,), ((-1.0, pi / 2, _COS),)),)),
)
HALF_HARMONIC_2 = MotionLaw.of(
    "half_harmonic_2",
    "Second half of the simple harmonic: from a speed of pi/2 to rest.",
    Form((FormPart(1.0, (), ((1.0, pi / 2, 0.0),)),)),
)
GUTMAN_1_3 = MotionLaw.of(
    "gutman_1_3",
    "Gutman's law of the first and the third harmonic.",
    sine_form(1.0, ((-15 / (32 * pi), tau), (-1 / (96 * pi), 3 * tau))),
)
FREUDENSTEIN_1_3 = MotionLaw.of(
    "freudenstein_1_3",
    "Freudenstein's law of the first and the third harmonic.",
    sine_form(1.0, ((-27 / 28 / tau, tau), (-1 / 84 / tau, 3 * tau))),
)
FREUDENSTEIN_1_3_5 = MotionLaw.of(
    "freudenstein_1_3_5",
    "Freudenstein's law of the first, the third and the fifth harmonic.",
    sine_form(1.0, ((-_SHARE, tau), (-_SHARE / 54, 3 * tau), (-_SHARE / 1250, 5 * tau))),
    pieces=96,
)
SINE_LAWS = (
    CYCLOIDAL,
    HALF_CYCLOID_1,
    HALF_CYCLOID_2,
    CYCLOID_LINE,
    SIMPLE_HARMONIC,
    DOUBLE_HARMONIC,
    HALF_HARMONIC_1,
    HALF_HARMONIC_2,
    GUTMAN_1_3,
    FREUDENSTEIN_1_3,
    FREUDENSTEIN_1_3_5,
)
