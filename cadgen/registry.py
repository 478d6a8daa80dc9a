"""Kinds of one sort by their codes: those of the package, and those that are registered from outside."""

import re
from collections.abc import Iterable
from typing import Generic, Protocol, TypeVar

from cadgen.errors import DesignError

# A unit at the end is written as it is, such as _J.
_CODE = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*(_[A-Z][a-z]*)?")


class Kind(Protocol):
    """An object with a code by which a design names it."""

    @property
    def code(self) -> str:
        """Small letters, digits and single underscores."""


K = TypeVar("K", bound=Kind)


class Registry(Generic[K]):
    """All kinds of one sort.

    Args:
        noun: name of the sort in messages, such as `follower`.
        kinds: kinds of the package.
        reserved: codes that no kind may take.
    """

    def __init__(self, noun: str, kinds: Iterable[K], reserved: Iterable[str] = ()) -> None:
        self._noun, self._reserved = noun, tuple(reserved)
        self._kinds: dict[str, K] = {}
        for kind in kinds:
            self.register(kind)

    def register(self, kind: K) -> None:
        """Add a kind, which design files may then name.

        Raises:
            DesignError: the code is taken, or cannot be the value of a key.
        """
        if kind.code in (*self._reserved, *self._kinds):
            raise DesignError(f'there is a {self._noun} "{kind.code}" already: choose another code')
        if not _CODE.fullmatch(kind.code):
            raise DesignError(
                f'"{kind.code}" cannot be the code of a {self._noun}: take small letters, digits and single _'
            )
        self._kinds[kind.code] = kind

    def remove(self, kind: K) -> None:
        """Take a registered kind out again."""
        del self._kinds[kind.code]

    def codes(self) -> tuple[str, ...]:
        """Codes of all kinds."""
        return tuple(self._kinds)

    def kind_of(self, code: str) -> K:
        """Kind with a code.

        Raises:
            DesignError: no kind has that code.
        """
        if code not in self._kinds:
            raise DesignError(f'there is no {self._noun} "{code}": choose one of {", ".join(self._kinds)}')
        return self._kinds[code]
