"""Flank tolerances of ISO 1328-1:2013 by class, and the class that a measured deviation reaches.

| symbol | deviation                     | value at class 5, µm                       | equation |
|--------|-------------------------------|--------------------------------------------|----------|
| f_p    | single pitch                  | 0.001 d + 0.4 m_n + 5                      | 5        |
| F_p    | total cumulative pitch        | 0.002 d + 0.55 √d + 0.7 m_n + 12           | 6        |
| f_Hα   | profile slope                 | 0.4 m_n + 0.001 d + 4                      | 7        |
| f_fα   | profile form                  | 0.55 m_n + 5                               | 8        |
| F_α    | total profile                 | √(f_Hα² + f_fα²)                           | 9        |
| f_Hβ   | helix slope                   | 0.05 √d + 0.35 √b + 4                      | 10       |
| f_fβ   | helix form                    | 0.07 √d + 0.45 √b + 4                      | 11       |
| F_β    | total helix                   | √(f_Hβ² + f_fβ²)                           | 12       |
| F_r    | run-out                       | 0.9 F_p                                    | annex    |

Another class A multiplies by √2^(A − 5), without rounding before. Values over 10 µm are rounded to 1 µm, from 5 µm
on to 0.5 µm, and below to 0.1 µm. The play of pairs is computed by the edition of 1995 (`tolerances`), which differs.
"""

from collections.abc import Callable
from math import floor, hypot, sqrt

CLASSES = range(1, 12)
FINEST_MODULE, COARSEST_MODULE = 0.5, 70.0
SMALLEST, LARGEST = 5.0, 15_000.0
NARROWEST, WIDEST = 4.0, 1200.0

_UM = 1e-3
_At = Callable[[float, float, float], float]  # d, m_n, b in mm -> um at class 5


def _f_p(d: float, m: float, b: float) -> float:
    return 0.001 * d + 0.4 * m + 5


def _cumulative(d: float, m: float, b: float) -> float:
    return 0.002 * d + 0.55 * sqrt(d) + 0.7 * m + 12


def _profile_slope(d: float, m: float, b: float) -> float:
    return 0.4 * m + 0.001 * d + 4


def _profile_form(d: float, m: float, b: float) -> float:
    return 0.55 * m + 5


def _helix_slope(d: float, m: float, b: float) -> float:
    return 0.05 * sqrt(d) + 0.35 * sqrt(b) + 4


def _helix_form(d: float, m: float, b: float) -> float:
    return 0.07 * sqrt(d) + 0.45 * sqrt(b) + 4


_RULES: dict[str, _At] = {
    "f_p": _f_p,
    "F_p": _cumulative,
    "f_Halpha": _profile_slope,
    "f_falpha": _profile_form,
    "F_alpha": lambda d, m, b: hypot(_profile_slope(d, m, b), _profile_form(d, m, b)),
    "f_Hbeta": _helix_slope,
    "f_fbeta": _helix_form,
    "F_beta": lambda d, m, b: hypot(_helix_slope(d, m, b), _helix_form(d, m, b)),
    "F_r": lambda d, m, b: 0.9 * _cumulative(d, m, b),
}
SYMBOLS = tuple(_RULES)


def covered(diameter: float, module: float, width: float) -> bool:
    """Whether the standard has tolerances for a gear; its formulas are not to be carried on beyond that.

    Args:
        diameter: reference diameter d, mm.
        module: normal module m_n, mm.
        width: face width b, mm.
    """
    return (
        SMALLEST <= diameter <= LARGEST and FINEST_MODULE <= module <= COARSEST_MODULE and NARROWEST <= width <= WIDEST
    )


def class_tolerance(symbol: str, diameter: float, module: float, width: float, flank_class: int) -> float:
    """Tolerance of ISO 1328-1:2013, mm.

    Args:
        symbol: one of `SYMBOLS`, as in the table above.
        diameter: reference diameter d, mm.
        module: normal module m_n, mm.
        width: face width b, mm.
        flank_class: class A, 1 to 11.
    """
    value = _RULES[symbol](diameter, module, width) * sqrt(2) ** (flank_class - 5)
    step = 1.0 if value > 10 else 0.5 if value >= 5 else 0.1
    return floor(value / step + 0.5) * step * _UM


def class_reached(symbol: str, diameter: float, module: float, width: float, deviation: float) -> int | None:
    """Least class whose tolerance holds a deviation; None where none does or the standard has none.

    Args:
        symbol: one of `SYMBOLS`.
        diameter, module, width: of the gear, mm.
        deviation: size of the deviation, mm.
    """
    if not covered(diameter, module, width):
        return None
    within = (
        each for each in CLASSES if abs(deviation) <= class_tolerance(symbol, diameter, module, width, each) + 1e-12
    )
    return next(within, None)
