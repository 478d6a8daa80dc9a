"""An item put into a design's text, taken out or exchanged with the next one: a point of a list, a post, a gate."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from cadgen.design.parse import parse
from cadgen.design.schema import Design
from cadgen.viewer.editor.lists import item_at, with_exchange, with_item, without_item
from cadgen.viewer.editor.tables import tables_of, with_table, with_tables_exchanged, without_table
from cadgen.viewer.editor.text import applied, checked

Item = list[float] | dict[str, Any]


def inserted(text: str, file: Path, key: str, item: Item) -> tuple[str, Design]:
    """Text of a design with one item more, and the design that it is.

    Args:
        text: TOML.
        file: path of the file, for messages.
        key: dotted key that it gets: a number in a list, at most one more than the list has items, or a section's name.
        item: x and y of a point, mm; or values of a table by key.

    Raises:
        DesignError: the result is no design; or the text cannot be changed and read back.
    """
    values = parse(text)
    name, index = _split(key)
    if index is None:
        holder, _, last = name.rpartition(".")
        values.setdefault(holder, {})[last] = item
        assert isinstance(item, dict)
        return checked(with_table(text, name, 0, item, several=False), file, values)
    if isinstance(item, dict):
        section, _, kind = name.partition(".")
        values.setdefault(section, {}).setdefault(kind, []).insert(index, item)
    else:
        item_at(values, name).insert(index, item)
    return checked(_with(text, name, index, item), file, values)


def removed(text: str, file: Path, key: str) -> tuple[str, Design]:
    """Text of a design without an item, and the design that it is; as `inserted`."""
    values = parse(text)
    name, index = _split(key)
    if index is None:
        if not tables_of(text, name):
            return applied(text, file, [f"{name}="])
        holder, _, last = name.rpartition(".")
        del values[holder][last]
        return checked(without_table(text, name, 0), file, values)
    del item_at(values, name)[index]
    of_text = without_table if tables_of(text, name) else without_item
    return checked(of_text(text, name, index), file, values)


def exchanged(text: str, file: Path, key: str) -> tuple[str, Design]:
    """Text of a design with an item and the next one of its list exchanged, and the design; as `inserted`."""
    values = parse(text)
    name, index = _split(key)
    assert index is not None
    items = item_at(values, name)
    items[index], items[index + 1] = items[index + 1], items[index]
    of_text = with_tables_exchanged if tables_of(text, name) else with_exchange
    return checked(of_text(text, name, index), file, values)


def _with(text: str, name: str, index: int, item: Item) -> Iterator[str]:
    """Texts with an item more: in the list in brackets if there is one, else as a table under its heading."""
    if not tables_of(text, name):
        yield from with_item(text, name, index, item)
    if isinstance(item, dict):
        yield from with_table(text, name, index, item, several=True)


def _split(key: str) -> tuple[str, int | None]:
    """Dotted key of the list, and index of the item in it, from 0; None of a section that is alone."""
    name, _, number = key.rpartition(".")
    return (name, int(number) - 1) if number.isdecimal() else (key, None)
