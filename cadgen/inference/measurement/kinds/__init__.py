"""The kinds of measured data: a new one is a file here and a line in the table, or is registered.

A kind brings its columns, its catalogue of effects, and its forward model (`Kind.model`), which stands in its file.

| module          | what is measured                                                               |
|-----------------|--------------------------------------------------------------------------------|
| `lift`          | a dial on the lever, by cam angle                                              |
| `profile`       | the outline on a measuring machine                                             |
| `transmission`  | angles at both ends of the train                                               |
| `track`         | where the drive wheel is, by the motor's turns                                 |
| `steered_track` | where a tricycle is, with its steering logged                                  |
| `zones`         | mean turns of the cam over starts and stops                                    |
"""

from cadgen.errors import DesignError
from cadgen.inference.measurement.kinds import lift, profile, steered_track, track, transmission, zones
from cadgen.inference.measurement.record import Kind

LIFT, PROFILE, TRANSMISSION, TRACK = lift.KIND, profile.KIND, transmission.KIND, track.KIND
STEERED_TRACK, ZONES = steered_track.KIND, zones.KIND

_kinds: dict[str, Kind] = {}


def register(kind: Kind) -> None:
    """Add a kind, whose files are then recognised, judged and written like any other's.

    Raises:
        ValueError: there is one of that code, or one whose files have the same columns.
    """
    for other in _kinds.values():
        if other.code == kind.code or set(other.header) == set(kind.header):
            raise ValueError(f"kind {kind.code} cannot be told from {other.code}: give another code and columns")
    _kinds[kind.code] = kind


def remove(kind: Kind) -> None:
    """Take a registered kind out again."""
    del _kinds[kind.code]


def kinds() -> tuple[Kind, ...]:
    """Every kind, in the order of the table."""
    return tuple(_kinds.values())


def codes() -> tuple[str, ...]:
    """Their codes, as files write them."""
    return tuple(_kinds)


def kind_of(code: str) -> Kind:
    """The kind of a code.

    Raises:
        DesignError: there is none.
    """
    if code not in _kinds:
        raise DesignError(f'there is no kind of data "{code}": write {" or ".join(_kinds)}')
    return _kinds[code]


for kind in (LIFT, PROFILE, TRANSMISSION, TRACK, STEERED_TRACK, ZONES):
    register(kind)
