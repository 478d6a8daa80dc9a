"""Base of all sections of a design file."""

import json
from collections.abc import Callable, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from difflib import get_close_matches
from enum import StrEnum
from typing import Annotated, Any, Generic, TypeVar, get_args, get_type_hints

from annotated_types import Ge, Le
from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    Strict,
    create_model,
    model_validator,
)
from pydantic_core import CoreSchema, core_schema

from cadgen.car.path import path_kinds
from cadgen.errors import DesignError
from cadgen.messages import Message, joined

FARTHEST_MM = 1e6  # one kilometre; a coordinate beyond it is a slip of unit

LEAST_FEATURE_MM = 0.01  # no tool cuts a smaller one, and the CAD kernel takes points 1e-7 mm apart for one
LONGEST_LINE = 60  # letters that a title block holds
LONGEST_CELL = 36  # letters that one of its smaller cells holds
# The last letter of Latin, Greek and Cyrillic; punctuation and signs; Chinese, Japanese and Korean ones.
_LETTERS = ((0x20, 0x52F), (0x2010, 0x22FF), (0x2E80, 0xD7A3), (0xF900, 0xFAFF), (0xFE30, 0xFE4F), (0xFF00, 0xFFEF))

# Beside an enumeration: files have its words, and the design its members.
WORD = Strict(False)

HERE = "{here}"  # in a message: the section that holds the keys, for one that several sections share

Coordinate = Annotated[float, Ge(-FARTHEST_MM), Le(FARTHEST_MM)]
Extent = Annotated[float, Ge(1.0), Le(FARTHEST_MM)]
# TOML has lists only. They are kept as tuples, which stay frozen; strictness is for what they hold.
Point = Annotated[tuple[Coordinate, Coordinate], Strict(False)]
Points = Annotated[tuple[Point, ...], Strict(False)]
Size = Annotated[tuple[Extent, Extent], Strict(False)]


class DesignSection(BaseModel):
    """A frozen table of a design file: no unknown keys, no text for numbers, no NaN or infinity.

    The docstring of a section and the descriptions of its keys make the reference page.
    """

    # Put off until a design of that kind is read: a command reads one, and building all of them takes 0.1 s.
    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False, defer_build=True)


def one_line(text: str, longest: int = LONGEST_LINE) -> str:
    """The text, which a title block or a comment must hold, of so many letters at most.

    Raises:
        ValueError: it is empty, too long, or has more than one line.
    """
    if not (0 < len(text) <= longest and text.isprintable()):
        raise ValueError(
            Message("{here} must be one line of 1 to {longest} letters: shorten it", here=HERE, longest=longest)
        )
    return text


def drawn_line(text: str, longest: int = LONGEST_CELL) -> str:
    """The text, of so many letters at most, all of which the fonts of drawings have.

    Raises:
        ValueError: it is empty, too long, has more than one line or another letter.
    """
    unknown = [letter for letter in text if not any(low <= ord(letter) <= high for low, high in _LETTERS)]
    if unknown and text.isprintable():
        raise ValueError(
            Message(
                "{here} has {unknown}, which the fonts of drawings lack: write it in Latin, Greek, Cyrillic, "
                "Chinese, Japanese or Korean letters",
                here=HERE,
                unknown=unknown[0],
            )
        )
    return one_line(text, longest)


CellText = Annotated[str, AfterValidator(drawn_line)]


def fit_in_table(fit: str) -> str:
    """The name of a fit, which the table of fits must have.

    Raises:
        ValueError: not a fit of the table.
    """
    from cadgen.gears.fits import zones_of

    try:
        zones_of(fit)
    except DesignError as error:
        raise ValueError(Message("{here}: {error}", here=HERE, error=error.message)) from None
    return fit


FitName = Annotated[str, AfterValidator(fit_in_table)]


def listed(items: Sequence[str], conjunction: str) -> Message:
    """Join words as in a sentence: a, b and c."""
    if len(items) < 2:
        return joined(items)
    return joined((joined(items[:-1]), items[-1]), f" {conjunction} ")


_READ_THROUGH = 20  # codes; of more, such as laws, the nearest is named in place of all


@dataclass(frozen=True)
class OneOf:
    """Text that must be one of the codes of registered objects, asked for when a design is read."""

    codes: Callable[[], Sequence[str]]
    has: Callable[[str], bool] | None = None  # which need not list all codes

    @property
    def allowed(self) -> str:
        """The codes as they read after "must be"."""
        return listed([json.dumps(code) for code in self.codes()], "or")

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_after_validator_function(self._checked, handler(source))

    def _checked(self, code: str) -> str:
        if not (code in self.codes() if self.has is None else self.has(code)):
            many = len(self.codes()) > _READ_THROUGH
            if many and (near := get_close_matches(code[:80].lower(), self.codes(), 1, 0.8)):
                raise ValueError(
                    Message(
                        "{here} is {value}: did you mean {near}?",
                        here=HERE,
                        value=json.dumps(code[:80]),
                        near=json.dumps(near[0]),
                    )
                )
            raise ValueError(
                Message(
                    "{here} is {value}; it must be {allowed}",
                    here=HERE,
                    value=json.dumps(code[:80]),
                    allowed=self.allowed,
                )
            )
        return code


@dataclass(frozen=True)
class ZeroOrFeature:
    """A length of a feature, mm, that is 0 where there is none, and else one that can be made."""

    allowed = Message("0, or at least {least:g}", least=LEAST_FEATURE_MM)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_after_validator_function(self._checked, handler(source))

    def _checked(self, length: float | None) -> float | None:
        if length and not length >= LEAST_FEATURE_MM:
            raise ValueError(
                Message("{here} is {length:g}; it must be {allowed}", here=HERE, length=length, allowed=self.allowed)
            )
        return length


# Lengths of a feature that must be there, or may be 0; how long they may be stands at each key.
Feature = Annotated[float, Ge(LEAST_FEATURE_MM)]
FeatureOrNone = Annotated[float, ZeroOrFeature()]

K = TypeVar("K")
R = TypeVar("R")
S = TypeVar("S", bound=DesignSection)


def section_with(base: type[S], meaning: str, keys: type[Any]) -> type[S]:
    """Section that has the keys of a registered kind besides those of its base.

    Args:
        base: section with the keys that all kinds have.
        meaning: docstring of the section, for the reference.
        keys: dataclass of the kind's keys, each `Annotated` with limits and a phrase.
    """
    hints = get_type_hints(keys, include_extras=True)
    more: dict[str, Any] = {}
    for item in fields(keys):
        phrase = next(text for text in hints[item.name].__metadata__ if isinstance(text, str))
        default = ... if item.default is MISSING else item.default
        if (below := _part_of(hints[item.name])) is not None:
            inner = section_with(DesignSection, below.__doc__ or "", below)
            more[item.name] = inner | None if default is None else inner, Field(default)
            continue
        # As a file is read, words are text, and points are lists with the limits of a coordinate.
        read, limits = get_args(hints[item.name])[0], get_args(hints[item.name])[1:]
        read_as: Any = hints[item.name]
        if is_word(read):
            read_as = Annotated[(read, *limits, WORD)]
        elif read == path_kinds.Points:
            read_as = Annotated[(Points, *limits)]
        more[item.name] = read_as, Field(default, description=phrase)

    def together(section: S) -> S:
        keys_in(section, keys)  # which refuses what contradicts itself
        return section

    validators: dict[str, Any] = {"together": model_validator(mode="after")(together)}
    made: type[S] = create_model(base.__name__, __base__=base, __doc__=meaning, __validators__=validators, **more)
    return made


def _part_of(hint: Any) -> type[Any] | None:
    """Dataclass of a section inside that of a kind; None where a key is a value."""
    arms = (arm for one in get_args(hint)[:1] for arm in (one, *get_args(one)))
    return next((arm for arm in arms if isinstance(arm, type) and is_dataclass(arm)), None)


def is_word(annotation: Any) -> bool:
    """Whether a value is a word of an enumeration, or may be left out and is else one."""
    arms = (annotation, *get_args(annotation))
    return any(isinstance(arm, type) and issubclass(arm, StrEnum) for arm in arms)


def keys_in(section: DesignSection, keys: type[Any]) -> Any:
    """Values of a section as the dataclass of its kind's keys, those of a section inside as its own dataclass."""
    values: dict[str, Any] = {}
    hints = get_type_hints(keys, include_extras=True)
    for item in fields(keys):
        value = getattr(section, item.name)
        below = _part_of(hints[item.name])
        values[item.name] = value if below is None or value is None else keys_in(value, below)
    return keys(**values)


@dataclass(frozen=True)
class ByKind(Generic[K, S]):
    """A section whose keys are those of the kind that one of them names.

    Attributes:
        key: key that names the kind.
        usual: code of the kind where none is named.
        has: whether there is a kind with a code.
        kind_of: kind of one of these codes.
        section: section with the keys of a kind.
    """

    key: str
    usual: str
    has: Callable[[str], bool]
    kind_of: Callable[[str], K]
    section: Callable[[K], type[S]]

    def kind(self, table: object) -> K:
        """Kind that raw values of the section name; the usual one where they name none that there is."""
        code = table.get(self.key) if isinstance(table, dict) else getattr(table, self.key, None)
        return self.kind_of(code if isinstance(code, str) and self.has(code) else self.usual)

    def check(self, table: object, otherwise: Callable[[object], R]) -> S | R:
        """Check raw values by the keys of their kind.

        Args:
            table: as the file has it.
            otherwise: check of what is no table, or names a kind that is not there.

        Raises:
            ValueError: a key is wrong, or the keys contradict each other.
        """
        if not isinstance(table, dict):
            return otherwise(table)
        code = table.get(self.key)
        if code is not None and not (isinstance(code, str) and self.has(code)):
            return otherwise({self.key: code})
        if code == self.usual:  # named or not, a design says the same
            table = {name: value for name, value in table.items() if name != self.key}
        return self.section(self.kind(table)).model_validate(table)
