"""Every kind of follower by its code. A new one is a file in this folder and a line below, or is registered."""

import re

from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.followers.rod_kind import ROD
from cadgen.errors import DesignError

_CODE = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
_KINDS: dict[str, FollowerKind] = {}


def register(kind: FollowerKind) -> None:
    """Add a kind, which design files may then name.

    Raises:
        DesignError: the code is taken, or cannot be the value of a key.
    """
    if kind.code in _KINDS:
        raise DesignError(f'there is a follower "{kind.code}" already: choose another code')
    if not _CODE.fullmatch(kind.code):
        raise DesignError(f'"{kind.code}" cannot be the code of a follower: take small letters, digits and single _')
    _KINDS[kind.code] = kind


def remove(kind: FollowerKind) -> None:
    """Take a registered kind out again."""
    del _KINDS[kind.code]


for _kind in (ROD,):
    register(_kind)


def codes() -> tuple[str, ...]:
    """Codes of all kinds."""
    return tuple(_KINDS)


def kind_of(code: str) -> FollowerKind:
    """The kind with a code.

    Raises:
        DesignError: no kind has the code.
    """
    if code not in _KINDS:
        raise DesignError(f'there is no follower "{code}": choose one of {", ".join(_KINDS)}')
    return _KINDS[code]
