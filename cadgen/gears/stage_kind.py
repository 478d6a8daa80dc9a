"""Kind of a stage, apart from the table of all kinds, which imports theirs. The module is light to import."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cadgen.gears.stage import Stage


@dataclass(frozen=True, kw_only=True)
class StageKind:
    """A kind of stage, beside spur gears.

    Attributes:
        code: value of `train.stages.kind`.
        meaning: a sentence for the reference.
        keys: a frozen dataclass of its keys, named as in the file, each `Annotated` with its limits and with a phrase
            for the reference; its `__post_init__` may refuse what contradicts itself by a `ValueError`, one sentence
            for the user. `bearing_span_mm` and `direction_deg` are keys of every stage and not among them.
        build: function of the keys and of the distance of the bearings, mm, that returns the stage; a `DesignError`
            where there is no such stage.
    """

    code: str
    meaning: str
    keys: type[Any]
    build: Callable[[Any, float], Stage]
