"""Checks of a caller's numbers and words; each refusal is a sentence with the name and what is allowed."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields
from math import inf, isfinite, nan, radians
from numbers import Integral, Real
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from cadgen.arrays import Array
from cadgen.design.section import LEAST_FEATURE_MM
from cadgen.errors import DesignError, brief
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.inference.monte_carlo.random_cars import Map

T = TypeVar("T")


class Stated:
    """Base of what a caller states by a dataclass: its text has what was given, and no value that is left as it was."""

    def __repr__(self) -> str:
        stated: Any = self
        given = []
        for each in fields(stated):
            value = getattr(self, each.name)
            # An array, which has no single answer to a comparison, is no default.
            if value is not each.default and (hasattr(value, "shape") or value != each.default):
                given.append(f"{each.name}={brief(' '.join(repr(value).split()), _SHOWN)}")
        return f"{type(self).__name__}({', '.join(given)})"


_SHOWN = 200  # letters of a value, such as a table


def real(
    name: str, value: object, least: float = -inf, most: float = inf, unit: str = "", *, above: bool = False
) -> float:
    """Require a finite number of a range, and return it.

    Args:
        name: name of the argument.
        value: value of the argument.
        least, most: bounds of the range, in its unit, which belong to it.
        unit: unit of the number, for the message.
        above: whether the number must be greater than `least`, which then does not belong to the range.

    Raises:
        DesignError: the value is no such number.
    """
    try:
        number = float(value) if isinstance(value, Real) and not isinstance(value, bool) else nan
    except OverflowError:  # a whole number beyond floats
        number = nan
    if isfinite(number) and least <= number <= most and not (above and number == least):
        return number
    allowed = _range(least, most)
    if above:
        allowed = Message(", greater than {least:.10g} and at most {most:.10g}", least=least, most=most)
    if not unit:
        raise DesignError(
            "{name} is {value}; it must be a number{range}", name=name, value=_shown(value), range=allowed
        )
    if unit == "rad" and isfinite(number) and least <= radians(number) <= most:
        raise DesignError(
            "{name} is {value}; it must be a number{range} rad, and {value} looks like degrees: give radians({value})",
            name=name,
            value=_shown(value),
            range=allowed,
        )
    raise DesignError(
        "{name} is {value}; it must be a number{range} {unit}",
        name=name,
        value=_shown(value),
        range=allowed,
        unit=Message(unit),
    )


def feature(name: str, value: object, most: float, *, or_none: bool = False) -> float:
    """Require the length of a feature that can be made, mm, or 0 for none where that is allowed, and return it.

    Args:
        name: name of the argument.
        value: value of the argument, mm.
        most: greatest length allowed, mm.
        or_none: whether 0 is allowed.

    Raises:
        DesignError: the value is no such length.
    """
    if or_none and isinstance(value, Real) and not isinstance(value, bool) and value == 0:
        return 0.0
    return real(name, value, LEAST_FEATURE_MM, most, "mm")


def whole(name: str, value: object, least: int, most: float = inf) -> int:
    """Require a whole number of a range, and return it; arguments and errors as of `real`.

    Args:
        name: name of the value, for messages.
        value: value of the caller.
        least: least allowed.
        most: greatest allowed, a number.
    """
    if isinstance(value, Integral) and not isinstance(value, bool) and least <= int(value) <= most:
        return int(value)
    # `1e4` shown as 10000 would look like the whole number that it must be.
    shown = repr(float(value)) if isinstance(value, float) else _shown(value)
    raise DesignError(
        "{name} is {value}; it must be a whole number{range}", name=name, value=shown, range=_range(least, most)
    )


def word(name: str, value: object, allowed: Sequence[str]) -> str:
    """Require one of several words, and return it.

    Args:
        name: name of the argument.
        value: value of the argument.
        allowed: allowed words.

    Raises:
        DesignError: the value is none of the words.
    """
    if isinstance(value, str) and value in allowed:
        return value
    raise DesignError(
        "{name} is {value}; it must be one of {allowed}", name=name, value=_shown(value), allowed=joined(allowed)
    )


def optional(
    name: str, value: object, least: float = -inf, most: float = inf, unit: str = "", *, above: bool = False
) -> float | None:
    """Require None or a number, and return it; arguments and errors as of `real`.

    Args:
        name: name of the value, for messages.
        value: value of the caller.
        least: least allowed, in `unit`, such as mm.
        most: greatest allowed, in `unit`, such as mm.
        unit: unit, for messages.
        above: whether the value must be above the least.
    """
    return None if value is None else real(name, value, least, most, unit, above=above)


def numbers(name: str, value: ArrayLike, unit: str) -> Array:
    """Require finite numbers, of any shape, and return them as an array.

    Args:
        name: name of the argument.
        value: numbers in the unit, any shape.
        unit: unit of the numbers, for the message.

    Raises:
        DesignError: a value is no number, or not finite.
    """
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise DesignError(
            "{name} is {value}; it must be a number or an array of numbers, {unit}",
            name=name,
            value=_shown(value),
            unit=Message(unit),
        ) from None
    if not np.isfinite(array).all():
        worst = float(array[~np.isfinite(array)][0])
        raise DesignError(
            "{name} holds {worst:g}; all its numbers must be finite, {unit}", name=name, worst=worst, unit=Message(unit)
        )
    return array


def stage_angles(name: str, value: Iterable[float | None], count: int) -> list[float | None]:
    """Require one value a stage, and return them.

    Args:
        name: name of the argument.
        value: angles, rad, or None for any, one a stage.
        count: number of stages.

    Raises:
        DesignError: the value is no sequence, or is of another length.
    """
    try:
        values = list(value)
    except TypeError:
        raise DesignError(
            "{name} is {value}; it must have {count} angles, one a stage", name=name, value=_shown(value), count=count
        ) from None
    if len(values) != count:
        raise DesignError(
            "{name} has {given} angles; it must have {count}, one a stage", name=name, given=len(values), count=count
        )
    return values


def instance(name: str, value: object, kind: type[T]) -> T:
    """Require an object of a class, and return it.

    Args:
        name: name of the argument.
        value: value of the argument.
        kind: class that it must be of.

    Raises:
        DesignError: the value is of another class.
    """
    if isinstance(value, kind):
        return value
    raise DesignError("{name} is {value}; it must be a {kind}", name=name, value=_shown(value), kind=kind.__name__)


def paths(name: str, value: str | PathLike[str] | Iterable[str | PathLike[str]]) -> list[Path]:
    """Require the path of a file, or several, and return them.

    Args:
        name: name of the argument.
        value: value of the argument.

    Raises:
        DesignError: the value holds something else, or nothing.
    """
    try:
        each = [value] if isinstance(value, (str, PathLike)) else list(value)
        files = [Path(one) for one in each]
    except TypeError:
        files = []
    if not files:
        raise DesignError(
            "{name} is {value}; it must be the path of a file, or several", name=name, value=_shown(value)
        )
    return files


def plain_text(name: str, value: object) -> str:
    """Require a text, and return it.

    Args:
        name: name of the argument.
        value: value of the argument.

    Raises:
        DesignError: the value is no text.
    """
    if isinstance(value, str):
        return value
    raise DesignError("{name} is {value}; it must be a text", name=name, value=_shown(value))


def name_or_path(name: str, value: str | PathLike[str] | None) -> str | Path | None:
    """Require the name of a design, the path of a file, or None, and return it; errors as of `plain_text`."""
    try:
        return value if value is None or isinstance(value, str) else Path(value)
    except TypeError:
        raise DesignError(
            "{name} is {value}; it must be the name of a design or the path of a file", name=name, value=_shown(value)
        ) from None


class Pool(Protocol):
    """Anything with a `map`: `concurrent.futures`, `multiprocessing`, mpi4py, dask."""

    def map(self, function: Callable[[int], Array], numbers: Iterable[int], /) -> Iterable[Array]:
        """The function's results in order, computed anywhere.

        Args:
            function: function of a number, which can be pickled.
            numbers: numbers to compute it for.
        """


def map_of(pool: "Pool | Map | None") -> Callable[..., Iterable[Any]] | None:
    """Map function of an executor or pool, or the function itself.

    Args:
        pool: object with a method `map` or `submit`, function like the built-in `map`, or None.

    Raises:
        DesignError: the pool is none of these.
    """
    from cadgen.studies.engines import mapping

    if pool is None:
        return None
    if (function := mapping(pool)) is None:
        raise DesignError(
            "map is {given}; it must be a function such as map, or have a method map", given=brief(repr(pool), 60)
        )
    return function


def _range(least: float, most: float) -> str:
    if least == -inf and most == inf:
        return ""
    if most == inf:
        return Message(" of at least {least:g}", least=least)
    return Message(" from {least:.10g} to {most:.10g}", least=least, most=most)


def _shown(value: object) -> str:
    try:
        return f"{value:g}" if isinstance(value, float) else brief(repr(value), 60)
    except ValueError:  # more digits than Python writes
        return Message("too large")
