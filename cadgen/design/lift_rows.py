"""Rows of a lift table from a file of two columns, angle and lift."""

import re
from math import isfinite
from pathlib import Path

from cadgen.errors import DesignError, brief, escaped
from cadgen.messages import Message
from cadgen.reading import read_regular

MOST_ROWS = 20_000
_MOST_BYTES = 2_000_000
_LONGEST_SHOWN = 60


def read_rows(file: Path) -> list[list[float]]:
    """Rows [angle, lift] of a file, in the file's units.

    Columns are set apart by commas, semicolons, tabs or spaces; with semicolons, tabs or spaces the decimals may have
    commas. Lines of words before the first row, empty lines and what follows `#` are passed over.

    Args:
        file: path of the CSV.

    Raises:
        DesignError: no such file, one that cannot be read, a row that is none, or too many.
    """
    name = brief(str(file))
    try:
        text = read_regular(file, _MOST_BYTES).decode("utf-8-sig")
    except FileNotFoundError:
        raise DesignError(
            "motion.table is {name}, and there is no such file: correct the path, which counts from the folder of the "
            "design file",
            name=name,
        ) from None
    except IsADirectoryError:
        raise DesignError("motion.table is {name}, a folder: give a CSV file in it", name=name) from None
    except UnicodeDecodeError:
        raise DesignError(
            "motion.table is {name}, which is not UTF-8 text: save it as CSV in UTF-8", name=name
        ) from None
    except (OSError, ValueError) as error:
        reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
        raise DesignError(
            "motion.table is {name}, which cannot be read ({reason}): give a CSV file that can",
            name=name,
            reason=reason,
        ) from None
    rows: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), 1):
        if not (content := line.partition("#")[0].strip()):
            continue
        values = _numbers(content)
        if values is None and not rows and re.search(r"[^\W\d_]", content):
            continue  # a line of words
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
    return rows


def _numbers(content: str) -> list[float] | None:
    """The two numbers of a row; None if it has others."""
    for mark in (r"\s*[;\t]\s*", r"\s*,\s*", r"\s+"):
        cells = re.split(mark, content)
        if len(cells) != 2:
            continue
        try:
            values = [float(cell if "," in mark else cell.replace(",", ".")) for cell in cells]
        except ValueError:
            continue
        return values if all(map(isfinite, values)) else None
    return None
