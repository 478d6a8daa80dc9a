"""Laws that a flank between two rests may have: those of the table that begin and end at rest."""

from collections.abc import Iterator
from math import exp, log

from cadgen.inference.motions.flank_fit import LawCandidate
from cadgen.laws.law import MotionLaw
from cadgen.laws.power_laws import unequal_parabola
from cadgen.laws.table import codes, law_of

_RATIO_ROOM = (log(0.02), log(50.0))
RATIO_CODE = "unequal_parabola"


def candidates(*, rises: bool) -> tuple[LawCandidate, ...]:
    """Candidates for a rise, or for a return.

    Args:
        rises: whether the flank rises; a law to the top of a lobe runs backwards in a return.
    """
    return tuple(_candidates(rises))


def _candidates(rises: bool) -> Iterator[LawCandidate]:
    for code in codes():
        law = law_of(code)
        (first, _), (last, _) = law.ends
        if first or last:
            continue
        if code == RATIO_CODE:
            yield LawCandidate(code=code, law=law, shape=_ratio, room=_RATIO_ROOM)
        else:
            yield LawCandidate(code=code, law=law.backwards if law.to_top and not rises else law)


def _ratio(logarithm: float) -> MotionLaw:
    low, high = _RATIO_ROOM
    return unequal_parabola(exp(min(max(logarithm, low + 1e-9), high - 1e-9)))
