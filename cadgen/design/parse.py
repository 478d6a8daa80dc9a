"""TOML text as plain values, refused before it can cost more than any design needs."""

import re
import tomllib
from typing import Any

TomlValues = dict[str, Any]  # of a TOML document, before they are checked

MOST_PARTS = 32  # of one dotted key, and of brackets within brackets; the schema's deepest value lies seven deep
_PART = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+"""
_LONG_KEY = re.compile(rf"""(?<![\w-]){_PART}(?:\.[ \t]*+{_PART}){{{MOST_PARTS}}}""")


class DeepError(ValueError):
    """Keys or brackets are nested more deeply than those of any design."""


def parse(text: str) -> TomlValues:
    """Return the values of a TOML document.

    Raises:
        DeepError: a key of more than `MOST_PARTS` parts, or values as deep as that.
        ValueError: it is not TOML, as `tomllib` says.
    """
    # The library's time grows with the square of a key's parts.
    if _LONG_KEY.search(text):
        raise DeepError
    try:
        values = tomllib.loads(text)
    except RecursionError:
        raise DeepError from None
    _refuse_deep(values)
    return values


def _refuse_deep(values: TomlValues) -> None:
    """Level by level, since a walk down could itself go too deep."""
    level: list[Any] = [values]
    for _ in range(MOST_PARTS):
        level = [
            item
            for holder in level
            for item in (holder.values() if isinstance(holder, dict) else holder)
            if isinstance(item, dict | list)
        ]
        if not level:
            return
    raise DeepError
