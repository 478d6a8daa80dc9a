"""The section [follower]: its keys are those of the kind that it names."""

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any

from pydantic import Field

from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.followers.table import codes, kind_of
from cadgen.design.section import OneOf, Section, keys_in, section_with


class Follower(Section):
    """Follower that rides on the disc."""

    kind: Annotated[str | None, OneOf(codes)] = Field(
        default=None, description="which follower; left out, the leaning rod"
    )

    @property
    def registered(self) -> FollowerKind:
        """The kind that it names."""
        return ROD if self.kind is None else kind_of(self.kind)

    @property
    def keys(self) -> Any:
        """Keys of the file, as the dataclass of the follower's kind."""
        return keys_in(self, self.registered.keys)


@cache
def section_of(kind: FollowerKind) -> type[Follower]:
    """The section with the keys of a kind."""
    return section_with(Follower, kind.meaning, kind.keys)


def named_kind(values: object) -> FollowerKind:
    """The kind that raw values of a design name; the leaning rod where they name none that there is."""
    section = values.get("follower") if isinstance(values, dict) else None
    code = section.get("kind") if isinstance(section, dict) else None
    return kind_of(code) if isinstance(code, str) and code in codes() else ROD


def by_kind(value: object, usual: Callable[[object], Follower | None]) -> Follower | None:
    """Check a section by the keys of its kind.

    Args:
        value: as the file has it.
        usual: the check of what is no table, or names no kind.

    Raises:
        ValueError: the keys contradict each other.
    """
    if not isinstance(value, dict):
        return usual(value)
    code = value.get("kind")
    if code is not None and code not in codes():
        return usual({"kind": code})
    kind = named_kind({"follower": value})
    if kind is ROD:  # named or not, a design with the rod says the same
        value = {name: given for name, given in value.items() if name != "kind"}
    section = section_of(kind).model_validate(value)
    section.keys  # noqa: B018 - refuses what contradicts itself
    return section
