"""Numbers and words that a caller gives, refused in one sentence that names them and says what is allowed."""

from collections.abc import Sequence
from math import inf, isfinite
from numbers import Integral, Real

from cadgen.errors import DesignError, brief


def real(name: str, value: object, least: float = -inf, most: float = inf, unit: str = "") -> float:
    """A finite number of a range.

    Args:
        name: of the argument.
        value: as given.
        least, most: bounds, which belong to the range.
        unit: of the number, for the message.

    Raises:
        DesignError: it is none.
    """
    number = float(value) if isinstance(value, Real) and not isinstance(value, bool) else float("nan")
    if isfinite(number) and least <= number <= most:
        return number
    raise DesignError(f"{name} is {_shown(value)}; it must be a number{_range(least, most)} {unit}".rstrip())


def whole(name: str, value: object, least: int, most: float = inf) -> int:
    """A whole number of a range; arguments and errors as of `real`."""
    if isinstance(value, Integral) and not isinstance(value, bool) and least <= int(value) <= most:
        return int(value)
    raise DesignError(f"{name} is {_shown(value)}; it must be a whole number{_range(least, most)}")


def word(name: str, value: object, allowed: Sequence[str]) -> str:
    """One of several words.

    Args:
        name: of the argument.
        value: as given.
        allowed: the words.

    Raises:
        DesignError: it is none of them.
    """
    if isinstance(value, str) and value in allowed:
        return value
    raise DesignError(f"{name} is {_shown(value)}; it must be one of {', '.join(allowed)}")


def _range(least: float, most: float) -> str:
    if least == -inf and most == inf:
        return ""
    if most == inf:
        return f" of at least {least:g}"
    return f" from {least:g} to {most:g}"


def _shown(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else brief(repr(value), 60)
