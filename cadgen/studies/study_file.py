"""A study from its file: read, checked against its base design, and refused in one sentence.

The sentence names the key, its value, and what is allowed.
"""

from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from cadgen.design.file_names import usable_name
from cadgen.design.load import complete_of, packaged_designs, packaged_studies, read_design, with_rows
from cadgen.design.override import key_at, override
from cadgen.design.parse import DeepError, TomlValues, parse
from cadgen.design.schema import Design, MotionDesign
from cadgen.design.section import listed
from cadgen.errors import DesignError, brief
from cadgen.messages import Message
from cadgen.reading import read_regular
from cadgen.studies import study_figures
from cadgen.studies.design_row import override_of
from cadgen.studies.sampling import REPLAN, Variation
from cadgen.studies.study import Study, StudyFile, Vary, at_place
from cadgen.studies.study_figures import FigureScope

_KINDS = {
    "string_type": Message("a text"),
    "int_type": Message("a whole number"),
    "int_from_float": Message("a whole number"),
    "float_type": Message("a number"),
    "tuple_type": Message("a list"),
    "model_type": Message("a section"),
    "model_attributes_type": Message("a section"),
    "finite_number": Message("a finite number"),
}
_BOUNDS = {
    "greater_than": (Message("more than"), "gt"),
    "greater_than_equal": (Message("at least"), "ge"),
    "less_than": (Message("less than"), "lt"),
    "less_than_equal": (Message("at most"), "le"),
}


def sentence(error: ValidationError, schema: type[BaseModel]) -> Message:
    """The first fault, and how many more there are."""
    every = error.errors(include_url=False)
    # A list with a faulty item also counts as one that is too short.
    holders = {other["loc"][:depth] for other in every for depth in range(len(other["loc"]))}
    errors = [each for each in every if each["type"] != "too_short" or each["loc"] not in holders]
    first = _one(min(errors, key=lambda item: item["type"] != "extra_forbidden"), schema)
    rest = len(errors) - 1
    if rest == 0:
        return first
    more = Message("{fault} (and 1 more fault)", fault=first)
    return more if rest == 1 else Message("{fault} (and {count} more faults)", fault=first, count=rest)


def _one(item: Any, schema: type[BaseModel]) -> Message:
    kind, place, context = item["type"], item["loc"], item.get("ctx", {})
    name = ".".join(str(part + 1 if isinstance(part, int) else part) for part in place)
    value = brief(repr(item["input"]), 60)
    if kind == "extra_forbidden":
        names, heading = _names(schema, place[:-1])
        return Message(
            "{name} is not a key of a study: {heading} takes {names}",
            name=brief(name),
            heading=heading or Message("its top"),
            names=listed(names, "and"),
        )
    if kind == "missing":
        return Message("{name} is missing: add it", name=name)
    if kind == "value_error":
        return at_place(context["error"], name)
    if kind in _BOUNDS:
        words, bound = _BOUNDS[kind]
        return Message(
            "{name} is {value}; it must be {bound} {limit:g}",
            name=name,
            value=value,
            bound=words,
            limit=context[bound],
        )
    if kind == "tuple_type" and isinstance(item["input"], dict):
        return Message("{name} is one section; it must be a list of them: write [[{name}]]", name=name)
    if kind in ("too_short", "string_too_short"):
        return Message("{name} is empty: add at least one", name=name)
    if kind == "string_pattern_mismatch":
        return Message(
            "{name} is {value}; it must be letters, digits, _, - and points, the first a letter or digit",
            name=name,
            value=value,
        )
    wanted = _KINDS.get(kind, Message("something else"))
    return Message("{name} is {value}; it must be {wanted}", name=name, value=value, wanted=wanted)


def _names(schema: Any, place: Sequence[str | int]) -> tuple[list[str], str]:
    """Keys that a section takes, and its heading."""
    heading, many = "", False
    for part in place:
        if isinstance(part, int):
            many = True
            continue
        heading = part
        annotation = schema.model_fields[part].annotation
        schema = next(kind for kind in _inside(annotation) if isinstance(kind, type) and issubclass(kind, BaseModel))
    names = [field.alias or name for name, field in schema.model_fields.items()]
    return names, f"[[{heading}]]" if many else f"[{heading}]" if heading else ""


def _inside(annotation: Any) -> list[Any]:
    parts = getattr(annotation, "__args__", ())
    return [annotation, *(inner for part in parts for inner in _inside(part))]


_MOST_BYTES = 5_000_000
_WHOLE = "a whole number"


def read_study(file: Path) -> tuple[Study, str]:
    """Read a study and check it.

    Args:
        file: path of a TOML file, or name of a packaged study; a base design that the study names by a path lies
            relative to it.

    Returns:
        The study, and the text of its file.

    Raises:
        DesignError: the file, or a value in it, cannot be; or the base design cannot.
    """
    file = packaged_studies().get(str(file), file)
    name = brief(str(file))
    try:
        text = read_regular(file, _MOST_BYTES).decode("utf-8-sig")
    except FileNotFoundError:
        known = listed(list(packaged_studies()), "or")
        raise DesignError(
            "there is no study {name}: correct the path, or name a packaged one ({known})", name=name, known=known
        ) from None
    except UnicodeDecodeError:
        raise DesignError("{name} is not UTF-8 text: save it again as UTF-8", name=name) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise DesignError("{name} cannot be read ({reason}): give a study that can", name=name, reason=reason) from None
    content = _content(text, name)
    if content.base in packaged_designs():
        base, source = read_design(content.base)
    else:
        base, source = read_design(file.parent / content.base)
    try:
        base = with_rows(base, source)
    except DesignError as error:
        raise DesignError("{named}: {error}", named=name, error=error.message) from None
    return _study(content, base, source.name, name, usable_name(file.stem)), text


def study_of(text: str, base: str, source: str, name: str) -> Study:
    """A study from texts that were read before, as a journal has them.

    Args:
        text: text of the study.
        base: text of its base design.
        source: name of that design's file.
        name: name of the study.

    Raises:
        DesignError: as `read_study`.
    """
    return _study(_content(text, name), base, source, name, name)


def _content(text: str, name: str) -> StudyFile:
    try:
        return StudyFile.model_validate(parse(text))
    except ValidationError as error:
        raise DesignError("{name}: {sentence}", name=name, sentence=sentence(error, StudyFile)) from None
    except DeepError:
        raise DesignError(
            "{name} nests keys or brackets more deeply than any study does: correct it", name=name
        ) from None
    except ValueError as error:
        raise DesignError("{name} is not TOML ({error}): correct it", name=name, error=brief(str(error))) from None


def _study(content: StudyFile, base: str, source: str, named: str, stem: str) -> Study:
    values = parse(base)
    try:
        _refuse_other_figures(content, complete_of(base, Path(source), content.overrides))
        for change in content.overrides:
            override(values, change)
        variations = tuple(_variation(each, values) for each in content.vary)
        study = Study(content, content.name or stem, base, source, variations)
        for each in variations:
            _refuse_unusable(each, study, values)
        study.count  # noqa: B018 - refuses a plan that is too large
    except DesignError as error:
        raise DesignError("{named}: {error}", named=named, error=error.message) from None
    return study


def _refuse_other_figures(content: StudyFile, base: Design | MotionDesign) -> None:
    """Refuse figures that the base design does not have, and paths that are planned where there is no car.

    Args:
        content: content of the study.
        base: its base design.
    """
    moved = isinstance(base, MotionDesign)
    if moved and content.replan is not None:
        raise DesignError(
            "[replan] plans the path of a car, and the base design {base} has [motion]: remove it", base=base.name
        )
    scope = FigureScope.MOTION if moved else FigureScope.CAR
    fitting = [code for code in study_figures.codes() if study_figures.kind_of(code).scope in (scope, FigureScope.BOTH)]
    named = {
        "objectives": content.objectives,
        "record": content.record,
        "limits": tuple(limit.figure for limit in content.limits),
    }
    for key, figures in named.items():
        for code in figures:
            if code not in fitting:
                other = Message("[path] and [car]") if moved else Message("[motion]")
                raise DesignError(
                    "{key} names {code}, which is of a design with {other}, and the base design {base} has none: take "
                    "{fitting}",
                    key=key,
                    code=code,
                    other=other,
                    base=base.name,
                    fitting=listed(fitting, "or"),
                )


def _variation(given: Vary, values: TomlValues) -> Variation:
    whole = given.key == f"{REPLAN}seeds"
    if not given.key.startswith(REPLAN):
        key = key_at(values, given.key)
        whole = key is not None and key.kinds[-1] == _WHOLE
    for more in given.along:
        key_at(values, more)
    ends = given.least or 0.0, given.most or 0.0, given.step or 0.0
    made = Variation(given.key, given.values or (), *ends, whole, tuple(given.along.items()))
    if whole and not given.values and any(each != round(each) for each in (made.least, made.most, made.step)):
        raise DesignError("{key} takes whole numbers: make least, most and step of its range whole", key=given.key)
    return made


def _refuse_unusable(each: Variation, study: Study, values: TomlValues) -> None:
    """Refuse a value that its key cannot have in the base design, where it varies alone.

    Args:
        each: what varies.
        study: the study.
        values: raw values of the base design.
    """
    for key, value in [change for some in each.some for change in each.changes(some)]:
        if key.startswith(REPLAN):
            continue
        change = override_of(key, value)
        override(deepcopy(values), change)  # refuses a key, or an item of a list, that is not there
        try:
            complete_of(study.text, Path(study.source), (*study.file.overrides, change))
        except DesignError as error:
            # What only other keys forbid may be right together with what they vary to.
            if f"{key} is " in str(error) and "; it must be " in str(error):
                raise
