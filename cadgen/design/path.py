"""The section [path]: its keys are those of the kind of path that `spline` names."""

from functools import cache
from typing import Annotated, Any

from pydantic import Field, model_validator

from cadgen.car.path.path_kinds import QUINTIC, PathKind, codes, has, kind_of
from cadgen.design.section import ByKind, DesignSection, OneOf, keys_in, listed, section_with
from cadgen.messages import Message

MOST_LAPS = 100
_LAPS = 10  # of a run, where the design does not say


class PathSection(DesignSection):
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

    closed: bool | None = Field(
        default=None,
        description="whether the path is a lap that ends as it starts and is driven again and again. Its first point "
        "need not stand at the end as well. One turn of the cam is one lap or `laps_per_turn` of them, and nothing is "
        "blended",
    )
    laps_per_turn: int | None = Field(
        default=None, ge=1, le=MOST_LAPS, description="laps of a closed path in one turn of the cam; left out, 1"
    )
    laps: int | None = Field(
        default=None,
        ge=1,
        le=MOST_LAPS,
        description="laps of a closed path that make a run: at the end of the last one all end errors are taken; left "
        "out, 10, or `laps_per_turn` if that is more",
    )

    @property
    def turn_laps(self) -> int:
        """Laps of a closed path in one turn of the cam."""
        return self.laps_per_turn or 1

    @property
    def run_laps(self) -> int:
        """Laps of a closed path in a run."""
        return self.laps or max(_LAPS, self.turn_laps)

    @model_validator(mode="after")
    def _laps_are_of_a_closed_path(self) -> "PathSection":
        if not self.closed:
            for name in ("laps", "laps_per_turn"):
                if getattr(self, name) is not None:
                    raise ValueError(
                        Message(
                            "path.{name} is {value}, but the path is not closed: set path.closed = true, or remove "
                            "path.{name}",
                            name=name,
                            value=getattr(self, name),
                        )
                    )
            return self
        if self.registered.build_closed is None:
            closing = listed([f'"{code}"' for code in codes() if kind_of(code).build_closed is not None], "or")
            raise ValueError(
                Message(
                    'path.closed is true, but a path with spline = "{spline}" does not go on smoothly where it '
                    "closes: set path.spline = {closing}, or remove path.closed",
                    spline=self.spline,
                    closing=closing,
                )
            )
        if self.run_laps < self.turn_laps:
            raise ValueError(
                Message(
                    "path.laps is {run_laps}, but one turn of the cam is {turn_laps} laps (path.laps_per_turn): "
                    "a run takes at least one turn, so raise path.laps or lower path.laps_per_turn",
                    run_laps=self.run_laps,
                    turn_laps=self.turn_laps,
                )
            )
        return self

    @property
    def registered(self) -> PathKind:
        """The kind that it names."""
        return kind_of(self.spline)

    @property
    def keys(self) -> Any:
        """Keys of the file, as the dataclass of the path's kind."""
        return keys_in(self, self.registered.keys)


OF_ANY_PATH = tuple(PathSection.model_fields)  # keys that do not depend on the kind


@cache
def path_section(kind: PathKind) -> type[PathSection]:
    """The section with the keys of a kind."""
    return section_with(PathSection, PathSection.__doc__ or "", kind.keys)


PATH = ByKind("spline", QUINTIC.code, has, kind_of, path_section)
