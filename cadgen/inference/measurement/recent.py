"""Results that are asked for again and again, as long as they are among the last."""

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Recent(Generic[Key, Value]):
    """The last so many results by their keys; the oldest is forgotten first."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._known: dict[Key, Value] = {}

    def __contains__(self, key: Key) -> bool:
        return key in self._known

    def __getitem__(self, key: Key) -> Value:
        return self._known[key]

    def __setitem__(self, key: Key, value: Value) -> None:
        self._known.pop(key, None)
        if len(self._known) >= self._most:
            self._known.pop(next(iter(self._known)))
        self._known[key] = value

    def of(self, key: Key, make: Callable[[], Value]) -> Value:
        """The result of a key, made if it is not known."""
        if key not in self._known:
            self[key] = make()
        return self._known[key]
