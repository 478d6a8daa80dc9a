"""The section [follower]: its keys are those of the kind that it names."""

from functools import cache
from typing import Annotated, Any

from pydantic import Field

from cadgen.cam.followers.kind import FollowerKind, RunningSurface
from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.followers.table import codes, has, kind_of
from cadgen.design.section import ByKind, DesignSection, OneOf, keys_in, listed, section_with
from cadgen.laws.unit import TAN
from cadgen.messages import Message


class FollowerSection(DesignSection):
    """Follower that rides on the disc."""

    kind: Annotated[str | None, OneOf(codes, has)] = Field(
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

    @property
    def surface(self) -> RunningSurface | None:
        """Surface that runs on the disc; None where the file does not say."""
        return self.keys.material if self.registered.runs else None

    @property
    def bearing_width(self) -> float | None:
        """Width of a ball bearing on it, mm; None where the file does not say."""
        return self.keys.width_mm if self.registered.runs else None


@cache
def section_of(kind: FollowerKind) -> type[FollowerSection]:
    """The section with the keys of a kind."""
    return section_with(FollowerSection, kind.meaning, kind.keys)


FOLLOWER = ByKind("kind", ROD.code, has, kind_of, section_of)


def fitting_kinds(*, moved: bool) -> Message:
    """Kinds of follower that fit a design, as they read after "must be".

    Args:
        moved: whether the design has [motion], under which every kind runs; else the follower leans with a fork.
    """
    return listed([f'"{code}"' for code in codes() if moved or kind_of(code).unit == TAN], "or")


def kinds_with(key: str) -> list[str]:
    """Codes of the kinds of follower that have a key.

    Args:
        key: name of a key of [follower].
    """
    return [code for code in codes() if key in section_of(kind_of(code)).model_fields]


def lifted_kinds() -> Message:
    """Kinds of follower that move by their lift or swing, and not with a fork, as they read after "to"."""
    return listed([f'"{code}"' for code in codes() if kind_of(code).unit != TAN], "or")
