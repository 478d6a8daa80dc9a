"""Laws of few harmonics, for machines that swing: Gutman 1-3, Freudenstein 1-3 and 1-3-5, all from rest to rest.

Gutman takes the first two terms of the Fourier series of the parabola; Freudenstein chooses the amplitudes for the
least peak of the acceleration (Chen, Mechanics and Design of Cam Mechanisms, ch. 2).
"""

from math import pi, tau

from cadgen.laws.form import sine_form
from cadgen.laws.law import MotionLaw

_SHARE = 1125 / 1192 / tau

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
FEW_HARMONICS = (GUTMAN_1_3, FREUDENSTEIN_1_3, FREUDENSTEIN_1_3_5)
