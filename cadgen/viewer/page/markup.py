"""HTML elements as text: escaped, and with both languages where a text has both."""

from html import escape
from typing import Final

from cadgen.viewer.page.document import Cell, Section, Table, Text, Words
from cadgen.viewer.page.names import State
from cadgen.viewer.page.words import named

EMPTY: Final = frozenset({"meta", "input", "br", "path", "circle", "ellipse", "line", "rect", "polyline", "polygon"})


def tag(element: str, /, *content: str, **attributes: str | int | float | bool | None) -> str:
    """An element; content is HTML already.

    Args:
        element: name of the element.
        content: its content, as HTML.
        attributes: its attributes; `_` in a name stands for `-`, and one at its end for nothing. None and False leave
            an attribute out, True gives it no value.
    """
    parts = [element]
    for key, value in attributes.items():
        if value is None or value is False:
            continue
        key = key.rstrip("_").replace("_", "-") if key not in _EXACT else key
        parts.append(key if value is True else f'{key}="{escape(str(value), quote=True)}"')
    opening = f"<{' '.join(parts)}"
    return f"{opening}/>" if element in EMPTY and not content else f"{opening}>{''.join(content)}</{element}>"


_EXACT: Final = frozenset({"viewBox"})


def text(words: Text, name: str = "span", **attributes: str | None) -> str:
    """A text in an element; the page's script shows the other language."""
    if isinstance(words, str):
        return (
            escape(words, quote=False) if name == "span" and not attributes else tag(name, escape(words), **attributes)
        )
    if words.en == words.zh:
        return tag(name, escape(words.en, quote=False), **attributes)
    return tag(name, escape(words.en, quote=False), data_zh=words.zh, **attributes)


def english(words: Text) -> str:
    """The English of a text."""
    return words if isinstance(words, str) else words.en


def labels(words: Text) -> dict[str, str]:
    """Attributes of an element's label in both languages."""
    if isinstance(words, Words):
        return {"aria_label": words.en, "data_label_zh": words.zh}
    return {"aria_label": words}


def cell(content: Cell, *, numeric: bool) -> str:
    """A cell of a table; a number carries its full value."""
    names = " ".join(filter(None, ["n" if numeric else "", content.state]))
    inside = text(content.text)
    if content.unit and content.text:
        inside += ("" if content.unit == "°" else " ") + text(named(content.unit), "small")
    value = None if content.value is None else repr(float(content.value))
    return tag("td", inside, class_=names or None, data_value=value)


def table(content: Table) -> str:
    """A table that scrolls sideways where it is too wide."""
    head = "".join(
        text(words, "th", scope="col", class_="n" if content.numeric(place) else None)
        if english(words)
        else "<td></td>"
        for place, words in enumerate(content.heads)
    )
    rows = "".join(
        tag(
            "tr",
            *(cell(item, numeric=content.numeric(place)) for place, item in enumerate(row)),
            class_="bad" if any(item.state == State.BAD for item in row) else None,
        )
        for row in content.rows
    )
    body = tag("table", text(content.caption, "caption"), tag("thead", tag("tr", head)), tag("tbody", rows))
    return tag(
        "div", body, class_="table", id=f"table-{content.code}", tabindex=0, role="region", **labels(content.caption)
    )


def section(content: Section) -> str:
    """A section of the page with its tables."""
    notes = tag("ul", *(text(note, "li") for note in content.notes), class_="notes") if content.notes else ""
    return tag(
        "section",
        text(content.title, "h2", id=f"{content.code}-title"),
        *(text(lead, "p", class_="lead") for lead in content.lead),
        tag("div", *(table(item) for item in content.tables), class_="tables"),
        notes,
        id=content.code,
        aria_labelledby=f"{content.code}-title",
    )
