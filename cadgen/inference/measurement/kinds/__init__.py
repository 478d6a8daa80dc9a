"""The kinds of measured data: a new one is a file here and a line in the table, is registered, or is a plug-in's.

A kind brings its columns, its catalogue of effects, and its forward model (`Kind.model`), which stands in its file.
A vehicle without a cam is such a kind, too: see the package `cadgen-tricycle` in `docs/examples`.

| module          | what is measured                                                               |
|-----------------|--------------------------------------------------------------------------------|
| `lift`          | a dial on the lever, by cam angle                                              |
| `profile`       | the outline on a measuring machine                                             |
| `transmission`  | angles at both ends of the train                                               |
| `track`         | where the drive wheel is, by the motor's turns                                 |
| `zones`         | mean turns of the cam over starts and stops                                    |
"""

from collections.abc import Collection

from cadgen.errors import DesignError
from cadgen.inference.measurement.kinds import lift, profile, track, transmission, zones
from cadgen.inference.measurement.record import Kind
from cadgen.messages import Message, joined
from cadgen.registry import load_plugins, used

LIFT, PROFILE, TRANSMISSION, TRACK, ZONES = lift.KIND, profile.KIND, transmission.KIND, track.KIND, zones.KIND

_GROUP = "cadgen.data"
_kinds: dict[str, Kind] = {}
_looked_for: set[str] = set()  # groups whose plug-ins are in the table


def register(kind: Kind) -> None:
    """Add a kind, whose files are then recognised, judged and written like any other's.

    Raises:
        ValueError: there is one of that code, or one whose files have the same columns.
    """
    for other in _kinds.values():
        if other.code == kind.code or set(other.header) == set(kind.header):
            raise ValueError(
                Message(
                    "kind {code} cannot be told from {other}: give another code and columns",
                    code=kind.code,
                    other=other.code,
                )
            )
    _kinds[kind.code] = kind


def remove(kind: Kind) -> None:
    """Take a registered kind out again."""
    del _kinds[kind.code]


def kinds() -> tuple[Kind, ...]:
    """Every kind, in the order of the table, those of plug-ins last."""
    _look_for_plugins()
    return tuple(_kinds.values())


def codes() -> tuple[str, ...]:
    """Codes of all kinds, as files write them."""
    return tuple(kind.code for kind in kinds())


def has(code: str) -> bool:
    """Whether there is a kind with a code; plug-ins are looked for if the package has none."""
    if code not in _kinds:
        _look_for_plugins()
    return code in _kinds


def kind_of(code: str) -> Kind:
    """Kind with a code.

    Raises:
        DesignError: there is none.
    """
    if not has(code):
        raise DesignError('there is no kind of data "{code}": write {kinds}', code=code, kinds=joined(_kinds, " or "))
    kind: Kind = used(_kinds[code])
    return kind


def kind_with(columns: Collection[str]) -> Kind | None:
    """Kind whose files have exactly these columns; plug-ins are looked for if the package has none."""
    for _ in range(2):
        for kind in _kinds.values():
            if set(kind.header) == set(columns):
                found: Kind = used(kind)
                return found
        _look_for_plugins()
    return None


def _look_for_plugins() -> None:
    if _GROUP not in _looked_for:
        _looked_for.add(_GROUP)
        load_plugins(_GROUP, Kind, register, Message("a kind of measured data"))


for kind in (LIFT, PROFILE, TRANSMISSION, TRACK, ZONES):
    register(kind)
