"""Rows of a lift table from a file of two columns, angle and lift."""

import re
from collections.abc import Sequence
from math import isfinite
from pathlib import Path

from cadgen.errors import DesignError, FileError, brief, escaped
from cadgen.messages import Message, joined
from cadgen.reading import TooLargeError, read_regular

MOST_ROWS = 20_000
_MOST_BYTES = 2_000_000
_LONGEST_SHOWN = 60
_MARKS = (r"\s*[;\t|]\s*", r"\s*,\s*", r"\s+")
# Unit of the columns, and its size, that a value of `motion.table_unit` stands for.
_STATED = {"mm": ("mm", 1.0), "inch": ("mm", 25.4), "deg": ("deg", 1.0)}
# Units that a column may have, as messages name them.
_IN_THEIR_WORDS = {"mm": "mm, um, in", "deg": "deg, rad", "N": "N, kN", "Nm": "N·mm, Nm"}
# What a title calls all of a table, or its second column.
_OF_TABLE = r"^(all|alle)|lift|stroke|hub|rise|swing|force|load|moment|torque|units?$|sizes?$|dimension|升程|行程|单位"
_RADIUS = ("radius", "radii", "rayon", "halbmesser", "半径", "向径", "矢径", "极径")


def read_rows(
    file: Path, stated: str | None = None, key: str = "motion.table", bases: Sequence[str] = ("mm", "deg")
) -> tuple[list[list[float]], str | None]:
    """Rows [angle, lift] of a file, the angle in degrees, and the unit of the lift.

    Columns are set apart by commas, semicolons, tabs, bars or spaces; where it is not commas, decimals may have commas.
    Lines of words before the first row, empty lines and what follows `#` are passed over. The last line of words that
    has units counts, such as `angle [deg], lift [in]` or `deg; in`, or the remark above the first row if it has both.
    A title that says inches, where nothing states the unit of the lift, is refused, and so is a column of radii.

    Args:
        file: path of the file.
        stated: unit of the lift, `mm`, `inch` or `deg`, that the design states; None if it does not.
        key: key of the design that names the file, for messages.
        bases: units that the second column may have, or such as are multiples of them: mm, deg, N or Nm.

    Returns:
        Rows, and the unit of their lift: the one stated, or one of `bases` where the file names one; None if neither
        does. Moments in Nm are returned in N·mm.

    Raises:
        DesignError: no such file, one that cannot be read, a row that is none, too many, a unit that is not known or
            does not do, or another one than stated; radii in place of lifts, or a unit in a title alone.
    """
    name, words, remark = brief(str(file)), [], ""
    rows: list[list[float]] = []
    titles: list[str] = []
    for number, line in enumerate(_text(file, name, key).splitlines(), 1):
        if not rows:
            titles.append(line.strip("# "))
        if not (content := line.partition("#")[0].strip()):
            remark = line.strip("# ") if line.startswith("#") and not rows else remark
            continue
        values = _numbers(content)
        if values is None and not rows and re.search(r"[^\W\d_]", content):
            words.append(content)
            remark = ""
            continue
        if values is None:
            raise DesignError(
                "{name}, line {line}: `{text}` is no row: write an angle and a lift, two numbers",
                name=name,
                line=number,
                text=escaped(content[:_LONGEST_SHOWN]),
            )
        if len(rows) == MOST_ROWS:
            raise DesignError("{name} has more than {most} rows: keep every second one", name=name, most=MOST_ROWS)
        rows.append(values)
    if not rows:
        raise DesignError("{name} has no rows: write an angle and a lift in each", name=name)
    units = _units(words, remark)
    if "mm" in bases:
        _refuse_radii(words[-1] if words else remark, name)
        if not units[1] and stated is None:
            _refuse_titles(titles, name)
    return _in_their_units(rows, units, stated, name, bases)


def _refuse_radii(names: str, name: str) -> None:
    """Refuse a second column that is called a radius: as lifts its values would stand on the base circle."""
    called = _two(names)[1].strip('" ')
    if any(word in called.lower() for word in _RADIUS):
        raise DesignError(
            'the second column of {name} is called "{called}", and lifts are needed: subtract from each row the '
            "distance of the follower at lift 0, and call the column lift",
            name=name,
            called=escaped(called[:_LONGEST_SHOWN]),
        )


def _refuse_titles(titles: Sequence[str], name: str) -> None:
    """Refuse a title or remark that says another unit than mm, where neither a column nor the design states one."""
    from cadgen.inference.records.units import other_length

    if said := other_length(titles):
        raise DesignError(
            "{name}, line {line}, says {unit}, and no column has a unit: write it beside the name of its column, as "
            'in "angle [deg], lift [in]"',
            name=name,
            line=said[0],
            unit=said[1],
        )


def _text(file: Path, name: str, key: str) -> str:
    from cadgen.inference.records.text_table import text_of  # with which most designs need not wait

    try:
        text, _ = text_of(read_regular(file, _MOST_BYTES), name, lambda text: 0)
    except FileNotFoundError:
        raise DesignError(
            "{key} is {name}, and there is no such file: correct the path, which counts from the folder of the "
            "design file",
            name=name,
            key=key,
        ) from None
    except IsADirectoryError:
        raise DesignError("{key} is {name}, a folder: give a CSV file in it", name=name, key=key) from None
    except FileError as error:
        raise DesignError("{key}: {error}", key=key, error=error.message) from None
    except TooLargeError:
        raise DesignError(
            "{key} is {name}, which is larger than {most:g} MB, the most that is read: keep two columns, with fewer "
            "decimals, and no more than {rows} rows",
            key=key,
            name=name,
            most=_MOST_BYTES / 1e6,
            rows=MOST_ROWS,
        ) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise DesignError(
            "{key} is {name}, which cannot be read ({reason}): give a CSV file that can",
            key=key,
            name=name,
            reason=reason,
        ) from None
    return text


def _numbers(content: str) -> list[float] | None:
    """The two numbers of a row; None if it has others."""
    for mark in _MARKS:
        cells = re.split(mark, content)
        if len(cells) != 2:
            continue
        try:
            values = [float(cell if "," in mark else cell.replace(",", ".")) for cell in cells]
        except ValueError:
            continue
        return values if all(map(isfinite, values)) else None
    return None


def _in_their_units(
    rows: list[list[float]], units: tuple[str, str], stated: str | None, name: str, bases: Sequence[str]
) -> tuple[list[list[float]], str | None]:
    """Rows with the angle in degrees, and the lift in mm or degrees where the file alone names its unit."""
    from cadgen.inference.records.units import unit_of

    of_angle, of_lift = units
    angle, lift = unit_of(of_angle), unit_of(of_lift)
    if of_angle and (angle is None or angle[0] != "deg"):
        raise DesignError(
            'the unit of the angle in {name} is "{unit}" by its first lines, which is none of angles that is known: '
            "write deg or rad there, and the angles in it",
            name=name,
            unit=escaped(of_angle[:_LONGEST_SHOWN]),
        )
    if of_lift and (lift is None or lift[0] not in bases) and (stated is None or lift is not None):
        raise DesignError(
            'the unit of the second column of {name} is "{unit}" by its first lines, which does not do here: write '
            "{known} there, and the numbers in it",
            name=name,
            unit=escaped(of_lift[:_LONGEST_SHOWN]),
            known=joined([_IN_THEIR_WORDS[base] for base in bases], Message(" or ")),
        )
    turn = angle[1] if angle is not None else 1.0
    if lift is not None and stated is not None and lift != _STATED.get(stated, lift):
        raise DesignError(
            'the unit of the lift in {name} is "{unit}" by its first lines, and motion.table_unit is "{stated}": '
            "remove motion.table_unit (on the command line with --set motion.table_unit=)",
            name=name,
            unit=of_lift,
            stated=stated,
        )
    scale, unit = (lift[1], lift[0]) if lift is not None and stated is None else (1.0, stated)
    scale *= 1000.0 if unit == "Nm" else 1.0  # [dynamics] has moments in N·mm
    return [[turn * at, scale * height] for at, height in rows], unit


def _units(words: Sequence[str], remark: str) -> tuple[str, str]:
    """Units of both columns as the lines above the rows name them, empty where they do not; the last line counts."""
    from cadgen.inference.records.units import heading, unit_of

    for number, line in enumerate(reversed(words)):
        cells = _two(line)
        bare = (cells[0].strip("[]()"), cells[1].strip("[]()"))
        first = unit_of(bare[0])
        named = (heading(cells[0]).unit, heading(cells[1]).unit)
        units = bare if first and first[0] == "deg" and unit_of(bare[1]) else named
        # Brackets of a title above the names of the columns are no units.
        known = number == 0 or all(unit_of(unit) for unit in units if unit)
        if any(units) and known and not _is_title(cells, units):
            return units
    # Programs write the names as a remark, too: a line of two names with a known unit each, and nothing else.
    cells = _two(remark) if not re.search(r"\d", remark) else ("", "")
    units = (heading(cells[0]).unit, heading(cells[1]).unit)
    first = unit_of(units[0])
    return units if first and first[0] == "deg" and unit_of(units[1]) else ("", "")


def _is_title(cells: tuple[str, str], units: tuple[str, str]) -> bool:
    """Whether a line of two clauses speaks of units, as `Cam in mm, not inches` does, and is none of columns."""
    from cadgen.inference.records.units import denied, heading, unit_of

    if any(re.search(r"[\])]\s*$", cell) for cell in cells):
        return False
    first, second = (unit_of(unit) for unit in units)
    if first and first[0] != "deg":
        return True
    named = re.search(_OF_TABLE, heading(cells[1]).quantity)
    return bool(second) and (denied(cells[1].removesuffix(units[1])) or not (first or named))


def _two(line: str) -> tuple[str, str]:
    """Names of two columns in a line; empty if it has not two."""
    for mark in _MARKS[:2]:
        if len(cells := re.split(mark, line)) == 2:
            return cells[0], cells[1]
    match = re.fullmatch(r"(\S+)\s+(\S+)", line) or re.fullmatch(r"(.+?[\])])\s+(.+[\])])", line)
    return (match[1], match[2]) if match else ("", "")
