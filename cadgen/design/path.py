"""The section [path]: its keys are those of the kind of path that `spline` names."""

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any

from pydantic import Field

from cadgen.design.section import OneOf, Section, keys_in, section_with
from cadgen.path.kinds.kind import PathKind
from cadgen.path.kinds.quintic import QUINTIC
from cadgen.path.kinds.table import codes, kind_of


class Path(Section):
    """The path the car is to drive."""

    spline: Annotated[str, OneOf(codes)] = Field(
        default=QUINTIC.code,
        description="curve of the path: the sixth-order natural spline of the paper's text through waypoints, the "
        "cubic of its appendix, whose curvature has kinks, or a B-spline by control points, which `cadgen plan` writes",
    )
    offset_mm: float = Field(
        default=0.0,
        ge=-1000,
        le=1000,
        description="how far to the right of the drive wheel the path runs",
    )

    @property
    def registered(self) -> PathKind:
        """The kind that it names."""
        return kind_of(self.spline)

    @property
    def keys(self) -> Any:
        """Keys of the file, as the dataclass of the path's kind."""
        return keys_in(self, self.registered.keys)


@cache
def path_section(kind: PathKind) -> type[Path]:
    """The section with the keys of a kind."""
    return section_with(Path, Path.__doc__ or "", kind.keys)


def named_path(values: object) -> PathKind:
    """The kind of path that raw values of a design name; the spline of the paper's text where they name none."""
    section = values.get("path") if isinstance(values, dict) else None
    code = section.get("spline") if isinstance(section, dict) else None
    return kind_of(code) if isinstance(code, str) and code in codes() else QUINTIC


def path_by_kind(value: object, usual: Callable[[object], Path | None]) -> Path | None:
    """Check a section by the keys of its kind.

    Args:
        value: as the file has it.
        usual: the check of what is no table, or names no kind.

    Raises:
        ValueError: the keys contradict each other.
    """
    if not isinstance(value, dict):
        return usual(value)
    code = value.get("spline", QUINTIC.code)
    if code not in codes():
        return usual({"spline": code})
    section = path_section(kind_of(code)).model_validate(value)
    section.keys  # noqa: B018 - refuses what contradicts itself
    return section
