"""Kinds of stages: what one is, and the table of all of them by their codes.

A new kind is one file beside `spur`, such as `worm.py`, and one name in the table `STAGES`, or it is registered from
outside.
Spur gears have no entry: theirs are the keys of a stage that names no kind, and what a gear leaves out [train] says.
The module is light to import.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from cadgen.messages import Message
from cadgen.registry import Registry

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


SPUR = "spur"
# The table. A worm's stage would be `WORM` here, imported from `cadgen.gears.worm` beside `spur`.
STAGES: tuple[StageKind, ...] = ()
_KINDS = Registry(Message("kind of stage"), STAGES, (SPUR,), group="cadgen.stages", sort=StageKind)
register, remove, codes, kind_of, has = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of, _KINDS.has
