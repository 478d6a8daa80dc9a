"""A study from its file: read, checked against its base design, and refused in one sentence."""

from copy import deepcopy
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from cadgen.design.file_names import usable_name
from cadgen.design.load import design_of, packaged_designs, packaged_studies, read_design
from cadgen.design.override import key_at, override
from cadgen.design.parse import DeepError, parse
from cadgen.design.section import listed
from cadgen.errors import DesignError, brief
from cadgen.reading import read_regular
from cadgen.studies.evaluate import override_of
from cadgen.studies.faults import sentence
from cadgen.studies.study import Study, StudyFile, Vary
from cadgen.studies.variation import REPLAN, Variation

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
        raise DesignError(f"there is no study {name}: correct the path, or name a packaged one ({known})") from None
    except UnicodeDecodeError:
        raise DesignError(f"{name} is not UTF-8 text: save it again as UTF-8") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise DesignError(f"{name} cannot be read ({reason}): give a study that can") from None
    content = _content(text, name)
    if content.base in packaged_designs():
        base, source = read_design(content.base)
    else:
        base, source = read_design(file.parent / content.base)
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
        raise DesignError(f"{name}: {sentence(error, StudyFile)}") from None
    except DeepError:
        raise DesignError(f"{name} nests keys or brackets more deeply than any study does: correct it") from None
    except ValueError as error:
        raise DesignError(f"{name} is not TOML ({brief(str(error))}): correct it") from None


def _study(content: StudyFile, base: str, source: str, named: str, stem: str) -> Study:
    values = parse(base)
    try:
        design_of(base, Path(source), content.overrides)
        for change in content.overrides:
            override(values, change)
        variations = tuple(_variation(each, values) for each in content.vary)
        study = Study(content, content.name or stem, base, source, variations)
        for each in variations:
            _refuse_unusable(each, study, values)
        study.count  # noqa: B018 - refuses a plan that is too large
    except DesignError as error:
        raise DesignError(f"{named}: {error}") from None
    return study


def _variation(given: Vary, values: dict[str, Any]) -> Variation:
    whole = given.key == f"{REPLAN}seeds"
    if not given.key.startswith(REPLAN):
        key = key_at(values, given.key)
        whole = key is not None and key.kinds[-1] == _WHOLE
    for more in given.along:
        key_at(values, more)
    ends = given.least or 0.0, given.most or 0.0, given.step or 0.0
    made = Variation(given.key, given.values or (), *ends, whole, tuple(given.along.items()))
    if whole and not given.values and any(each != round(each) for each in (made.least, made.most, made.step)):
        raise DesignError(f"{given.key} takes whole numbers: make least, most and step of its range whole")
    return made


def _refuse_unusable(each: Variation, study: Study, values: dict[str, Any]) -> None:
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
            design_of(study.text, Path(study.source), (*study.file.overrides, change))
        except DesignError as error:
            # What only other keys forbid may be right together with what they vary to.
            if f"{key} is " in str(error) and "; it must be " in str(error):
                raise
