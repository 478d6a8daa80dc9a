"""Values of Python as the overrides that the command line takes: `key=value`, the value in TOML."""

import json
from collections.abc import Iterable, Mapping
from datetime import date, time
from numbers import Integral, Real
from typing import Any

from cadgen.errors import DesignError, brief


def overrides_of(changes: Mapping[str, Any] | Iterable[str]) -> tuple[str, ...]:
    """Overrides as `--set` takes them.

    Args:
        changes: new value by key, where None removes the key; or texts `key=value`, taken as they are.

    Raises:
        DesignError: the changes are neither, or a value has no form in TOML.
    """
    if isinstance(changes, Mapping):
        return tuple(f"{_key(key)}={'' if value is None else _toml(key, value)}" for key, value in changes.items())
    changes = tuple(changes) if isinstance(changes, Iterable) and not isinstance(changes, str) else changes
    if not isinstance(changes, tuple) or not all(isinstance(text, str) for text in changes):
        raise DesignError(
            f"the changes are {brief(repr(changes), 60)}; give keys with their values, such as "
            '{"cam.thickness_mm": 3.2}'
        )
    return changes


def _key(key: object) -> str:
    """A key as it is; one with an equals sign would be read as another key with the start of a value."""
    if isinstance(key, str) and key.isprintable() and not {"=", " "} & set(key):
        return key
    raise DesignError(f'{brief(repr(key), 60)} is no key; write it as in the design file, such as "cam.thickness_mm"')


def _writable(text: str) -> bool:
    return not any("\ud800" <= sign <= "\udfff" for sign in text)


def _toml(key: str, value: Any) -> str:
    value = value.tolist() if hasattr(value, "tolist") else value  # numpy's
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if isinstance(value, str):
        if not _writable(value):
            raise DesignError(f"{brief(key)} is given {brief(repr(value), 60)}, which is no text in UTF-8; correct it")
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        inside = ", ".join(f"{json.dumps(str(name))} = {_toml(key, part)}" for name, part in value.items())
        return f"{{{inside}}}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_toml(key, part) for part in value)}]"
    kind = "a date" if isinstance(value, (date, time)) else f"a {type(value).__name__}"
    raise DesignError(
        f"{brief(key)} is given {kind}; a value must be a number, a text, True or False, a list or a table of these"
    )
