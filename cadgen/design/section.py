"""Base of all sections of a design file."""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from annotated_types import Ge, Le
from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, Strict
from pydantic_core import CoreSchema, core_schema

FARTHEST_MM = 1e6  # one kilometre; a coordinate beyond it is a slip of unit

HERE = "{here}"  # in a message: the section that holds the keys, for one that several sections share

Coordinate = Annotated[float, Ge(-FARTHEST_MM), Le(FARTHEST_MM)]
Extent = Annotated[float, Ge(1.0), Le(FARTHEST_MM)]
# TOML has lists only. They are kept as tuples, which stay frozen; strictness is for what they hold.
Point = Annotated[tuple[Coordinate, Coordinate], Strict(False)]
Points = Annotated[tuple[Point, ...], Strict(False)]
Size = Annotated[tuple[Extent, Extent], Strict(False)]


class Section(BaseModel):
    """A frozen table of a design file: no unknown keys, no text for numbers, no NaN or infinity.

    The docstring of a section and the descriptions of its keys make the reference page.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)


def listed(items: Sequence[str], conjunction: str) -> str:
    """Join words as in a sentence: a, b and c."""
    return f"{', '.join(items[:-1])} {conjunction} {items[-1]}" if len(items) > 1 else "".join(items)


@dataclass(frozen=True)
class OneOf:
    """Text that must be one of the codes of registered objects, asked for when a design is read."""

    codes: Callable[[], Sequence[str]]

    @property
    def allowed(self) -> str:
        """The codes as they read after "must be"."""
        return listed([json.dumps(code) for code in self.codes()], "or")

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_after_validator_function(self._checked, handler(source))

    def _checked(self, code: str) -> str:
        if code not in self.codes():
            raise ValueError(f"{HERE} is {json.dumps(code[:80])}; it must be {self.allowed}")
        return code
