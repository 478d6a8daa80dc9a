"""A kind of path: its code, its keys of the design file, and the curve that they make."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cadgen.car.path.spline import PlannedPath


@dataclass(frozen=True, kw_only=True)
class PathKind:
    """A kind of path.

    Attributes:
        code: value of `path.spline` in the design file.
        meaning: phrase for the reference, the curve in a few words.
        keys: frozen dataclass of its keys, named as in the file, each `Annotated` with its limits and with a phrase
            for the reference; its `__post_init__` may refuse what contradicts itself by a `ValueError`, one sentence
            for the user.
        build: function of the keys that returns the curve, mm; it raises `DesignError` where there is none.
        build_closed: the same for a path that is closed, with a curve that ends as it starts and goes on as smoothly
            there as elsewhere; None for a kind that has none.
    """

    code: str
    meaning: str
    keys: type[Any]
    build: Callable[[Any], PlannedPath]
    build_closed: Callable[[Any], PlannedPath] | None = None
