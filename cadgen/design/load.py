"""A design by name or file, with overrides, checked."""

import os
import re
from collections.abc import Mapping, Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from cadgen.cam.followers.table import has, kind_of
from cadgen.car.path.path_kinds import B_SPLINE
from cadgen.design.explain import explain
from cadgen.design.file_names import usable_name
from cadgen.design.kinds import NamedKinds, Place
from cadgen.design.lift_rows import read_rows
from cadgen.design.override import override, quoted
from cadgen.design.parse import DeepError, TomlValues, parse
from cadgen.design.path import OF_ANY_PATH
from cadgen.design.schema import OF_A_CAR, Design, DesignFile, MotionDesign, MotionFile, TrainDesign, TrainFile
from cadgen.design.section import listed
from cadgen.errors import DesignError, brief
from cadgen.laws.unit import MM
from cadgen.messages import Message, joined
from cadgen.reading import read_regular

DEFAULT_DESIGN = "carbon_free_car"
MAX_ERRORS_SHOWN = 5
_WHEEL_OFFSETS = ("drive_wheel_offset_mm", "idle_wheel_offset_mm")
_DECIMAL_COMMA = re.compile(r"=\s*[-+]?\d+,\d+\s*([,}#]|$)")
_STRAIGHT = [[100.0 * k, 0.0] for k in range(6)]
MOST_BYTES = 500_000  # of a file: ten thousand waypoints with every digit

# Beside this package in a wheel, beside `cadgen/` in a working copy.
_PACKAGE = Path(__file__).parent.parent
_PACKAGED = (_PACKAGE / "designs", _PACKAGE.parent / "designs")


def packaged_designs() -> dict[str, Path]:
    """The designs that come with cadgen, by name."""
    folder = next((folder for folder in _PACKAGED if (folder / f"{DEFAULT_DESIGN}.toml").is_file()), None)
    return {file.stem: file for file in sorted(folder.glob("*.toml"))} if folder else {}


def packaged_studies() -> dict[str, Path]:
    """The studies of `cadgen explore` that come with cadgen, by name."""
    return {file.stem: file for folder in _PACKAGED for file in sorted((folder / "studies").glob("*.toml"))}


def load_design(source: str | Path | None = None, overrides: Sequence[str] = ()) -> Design:
    """Read a design, apply the overrides in order, and check the result.

    Args:
        source: a packaged design's name, a path to a TOML file (a `Path`, or text that ends in `.toml` or
            names a folder), or None for the default.
        overrides: `key=value` each; see `cadgen.design.override`.

    Raises:
        DesignError: no such design, a file that cannot be read or is not TOML in UTF-8, or values that cannot
            be; one sentence for each of up to five errors, on a line of its own.
    """
    return design_of(*read_design(source), overrides)


def load_train(source: str | Path | None = None, overrides: Sequence[str] = ()) -> TrainDesign:
    """Read the gear train of a design, for which [train] alone is enough; a path without points is given some."""
    return train_of(*read_design(source), overrides)


def design_of(text: str, file: Path, overrides: Sequence[str] = ()) -> Design:
    """A design from its text.

    Args:
        text: TOML.
        file: path of the file, real or not, for messages.
        overrides: as for `load_design`.

    Raises:
        DesignError: as `load_design`.
    """
    made = complete_of(text, file, overrides)
    if isinstance(made, Design):
        return made
    raise _without_a_car(file)


def _without_a_car(file: Path) -> DesignError:
    return DesignError(
        "{file}: this is worked out for a car, but the design has [motion], and not [path] and [car]: a cam by its "
        "motion has cadgen check, cam, calibrate, tolerance, draw, report, edit, explore and gears",
        file=brief(file.name),
    )


def complete_of(text: str, file: Path, overrides: Sequence[str] = ()) -> Design | MotionDesign:
    """A design of a cam from its text: one with [path] and [car], or one with [motion].

    Args:
        text: TOML.
        file: path of the file, real or not, for messages.
        overrides: as for `load_design`.

    Raises:
        DesignError: as `load_design`.
    """
    values = _parsed(text, file)
    checked = _checked(DesignFile, values, file, overrides)
    made: type[Design | MotionDesign] = MotionDesign if "motion" in values else Design
    return made(**checked, overrides=tuple(overrides))


_BY_FLAGS = ("gear", "planetary")  # commands that read a file of their own flags
OF_A_CAM = ("path", "car", "cam", "follower", "motion")  # sections of which a design with a train alone has none


def is_train_alone(text: str, file: Path) -> bool:
    """Whether a design has a gear train and nothing of a cam.

    Args:
        text: TOML.
        file: path of the file, real or not, for messages.

    Raises:
        DesignError: the text is not TOML.
    """
    values = _parsed(text, file)
    return "train" in values and not any(section in values for section in OF_A_CAM)


def course_of(text: str, file: Path, overrides: Sequence[str] = ()) -> tuple[Design, bool]:
    """A design that a path is to be planned for, and whether it has one already.

    One that has none gets a short straight path, along which the point in the middle between the rear wheels runs.

    Args:
        text: TOML.
        file: path of the file, real or not, for messages.
        overrides: as for `load_design`.

    Raises:
        DesignError: as `load_design`.
    """
    values = _parsed(text, file)
    for change in overrides:
        override(values, change)
    if "motion" in values:
        raise _without_a_car(file)
    values.setdefault("path", {})
    drawn = not _draw(values)
    return Design(**_checked(DesignFile, values, file, ()), overrides=tuple(overrides)), drawn


def _draw(values: TomlValues) -> bool:
    """Give raw values whose path has no points a straight one; whether it had none."""
    path, car = values.get("path"), values.get("car")
    if not isinstance(path, dict) or any(key not in OF_ANY_PATH for key in path):
        return False
    offsets = [car.get(key) if isinstance(car, dict) else None for key in _WHEEL_OFFSETS]
    numbers = [offset for offset in offsets if isinstance(offset, int | float)]
    path.setdefault("offset_mm", sum(numbers) / 2)
    path.update(spline=B_SPLINE.code, control_points_mm=_STRAIGHT)
    return True


def train_of(text: str, file: Path, overrides: Sequence[str] = ()) -> TrainDesign:
    """Gear train of a design from its text, for which [train] alone is enough."""
    return TrainDesign(**_checked(TrainFile, _parsed(text, file), file, overrides), overrides=tuple(overrides))


D = TypeVar("D", Design, MotionDesign)


def with_overrides(design: D, overrides: Sequence[str]) -> D:
    """Return a design with more overrides applied, checked as `load_design` does.

    Raises:
        DesignError: the result is no design.
    """
    checked = _checked(DesignFile, design.values(), Path(design.source), overrides)
    return type(design)(**checked, overrides=(*design.overrides, *overrides))


def _checked(schema: type[TrainFile], values: TomlValues, file: Path, overrides: Sequence[str]) -> dict[str, Any]:
    """The values after the overrides, checked, with their source."""
    source = file.name
    applied = [(override(values, text), text) for text in overrides]
    _read_tables(values, file, [place for place, _ in applied])
    if "motion" in values and schema is not TrainFile:
        schema = MotionFile
    values.setdefault("name", usable_name(Path(source).stem))
    if schema is TrainFile:
        _draw(values)
    try:
        checked = schema.model_validate(values)
    except ValidationError as error:
        sentences, more = explain(error, MAX_ERRORS_SHOWN, NamedKinds.of(values))
        # Each after the file or the override that it comes from.
        lines = [
            joined(filter(None, (_blame(place, source, applied), sentence)), ": ") for place, sentence in sentences
        ]
        rest = [Message("and {more} more like these", more=more)] if more else []
        raise DesignError(joined([*lines, *rest], "\n")) from None
    unused = OF_A_CAR if schema is MotionFile else ()
    return {**{name: value for name, value in checked if name not in unused}, "source": source}


def with_rows(text: str, file: Path) -> str:
    """Text of a design in which the rows of its tables stand, so that it needs no other file; comments stay.

    Args:
        text: TOML.
        file: path of the design file, beside which the tables lie.

    Raises:
        DesignError: the text is no design, or a table cannot be read.
    """
    before = _parsed(text, file)
    after = deepcopy(before)
    _read_tables(after, file, ())
    if after == before:
        return text
    import tomlkit

    document: Any = tomlkit.parse(text)
    for section, table in after.items():
        if isinstance(table, dict):
            document[section] |= {key: value for key, value in table.items() if key not in before[section]}
    return tomlkit.dumps(document)


def _read_tables(values: Mapping[str, object], file: Path, changed: Sequence[Place]) -> None:
    """Put the rows of tables that the design names by their files into raw values; once read they stay.

    Args:
        values: raw values of the design.
        file: path of the design file.
        changed: places that overrides have changed.
    """
    for section, key, kept in (("motion", "table", "rows"), ("dynamics", "load", "load_rows")):
        table = values.get(section)
        if not isinstance(table, dict) or not isinstance(table.get(key), str) or not table[key]:
            continue
        if kept not in table or (section, key) in changed:
            stated = table.get("table_unit")
            named, bases = (
                f"{section}.{key}",
                _bases(values, *(("N", "Nm") if section == "dynamics" else ("mm", "deg"))),
            )
            unit = stated if isinstance(stated, str) else None
            table[kept], unit = read_rows(file.parent / table[key], unit, named, bases)
            if unit is not None and section == "motion":
                table["table_unit"] = unit


def _bases(values: Mapping[str, object], of_slide: str, of_arm: str) -> tuple[str, ...]:
    """Units of a column by the follower: of one that slides, or of an arm; both where it has no known kind."""
    follower = values.get("follower")
    code = follower.get("kind") if isinstance(follower, dict) else None
    if not isinstance(code, str) or not has(code):
        return of_slide, of_arm
    return (of_slide,) if kind_of(code).unit == MM else (of_arm,)


def design_file(source: str | Path | None = None) -> Path:
    """The file that `load_design` reads.

    Raises:
        DesignError: no packaged design has that name.
    """
    source = DEFAULT_DESIGN if source is None else source
    if isinstance(source, Path) or source.endswith(".toml") or Path(source).name != source:
        return Path(source)
    packaged = packaged_designs()
    if source in packaged:
        return packaged[source]
    here = next(
        (name for name in (source, f"{source}.toml") if os.path.isfile(name)), None
    )  # False for what no system has
    hint = (
        Message("the file in this folder is ./{here}", here=here)
        if here
        else Message("give a file by its path, such as ./my_car.toml")
    )
    names = listed(list(packaged), "and")
    raise DesignError(
        'there is no packaged design "{source}": the packaged ones are {names}; {hint}',
        source=brief(source),
        names=names,
        hint=hint,
    )


def read_design(source: str | Path | None = None) -> tuple[str, Path]:
    """Text of a design, and its file.

    Args:
        source: as for `load_design`.

    Raises:
        DesignError: no such design, or a file that cannot be read.
    """
    file = design_file(source)
    name = brief(str(file))
    try:
        return read_regular(file, MOST_BYTES).decode("utf-8-sig"), file
    except FileNotFoundError:
        raise DesignError(
            "there is no design file {name}: correct the path, or name a packaged design ({listed})",
            name=name,
            listed=listed(list(packaged_designs()), "or"),
        ) from None
    except IsADirectoryError:
        raise DesignError("{name} is a folder: give the path of a design file in it", name=name) from None
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        raise DesignError(
            "{name}, line {line}: not UTF-8 text: save the file again as UTF-8", name=name, line=line
        ) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise DesignError(
            "{name} cannot be read ({reason}): give a design file that can", name=name, reason=reason
        ) from None


def _parsed(text: str, file: Path) -> TomlValues:
    """The values in a file's text."""
    name = brief(str(file))
    try:
        values = parse(text)
    except DeepError:
        raise DesignError(
            "{name}: keys or brackets are nested too deeply for a design: correct the file", name=name
        ) from None
    except ValueError as error:
        raise DesignError(_syntax(str(error), name, text)) from None
    for command in _BY_FLAGS:
        if isinstance(values.get(command), dict):
            raise DesignError(
                "{name} has the flags of cadgen {command}, which reads it, and is no design: cadgen {command} {name}",
                name=name,
                command=command,
            )
    return values


def _syntax(problem: str, file: str, text: str) -> str:
    """Turn tomllib's message into file, line, column, problem and the line's own text."""
    lines = text.replace("\r\n", "\n").rstrip("\n").split("\n")
    match = re.fullmatch(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", problem, re.DOTALL)
    if not match:  # Python's own limit on the digits of a whole number
        return Message("{file}: a whole number has more digits than can be read: correct the file", file=file)
    line, column = (int(match[2]), int(match[3])) if match[2] else (len(lines), len(lines[-1]) + 1)
    quoted_line = brief(lines[min(line, len(lines)) - 1].strip()[:80])
    where = Message("{file}, line {line}, column {column}", file=file, line=line, column=column)
    if problem.startswith(("Cannot overwrite", "Cannot declare")):
        return Message(
            "{where}: `{quoted_line}` is given a second time: remove one of the two",
            where=where,
            quoted_line=quoted_line,
        )
    if _DECIMAL_COMMA.search(quoted_line):
        return Message(
            "{where}: a number in `{quoted_line}` has a decimal comma: write a point",
            where=where,
            quoted_line=quoted_line,
        )
    return Message(
        "{where}: not TOML ({match}): correct `{quoted_line}`",
        where=where,
        match=brief(match[1][:1].lower() + match[1][1:]),
        quoted_line=quoted_line,
    )


def _blame(place: Place, source: str, applied: Sequence[tuple[Place, str]]) -> str:
    """The override that set this place, or the file with the overrides that changed something inside it."""
    for where, text in reversed(applied):
        if place[: len(where)] == where:
            return quoted(text)
    inside = [quoted(text) for where, text in applied if where[: len(place)] == place]
    changes = brief(" ".join(inside))
    return (
        Message("{source} with {inside}", source=brief(source), inside=changes)
        if inside and source
        else changes or brief(source)
    )
