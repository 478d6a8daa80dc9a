"""A design that has been read and checked: its values, and copies with some of them changed."""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, time
from numbers import Integral, Real
from os import PathLike
from pathlib import Path
from typing import Any, Self

from cadgen.api.values import name_or_path, paths, plain_text, real
from cadgen.design import load
from cadgen.design.override import KeyChange
from cadgen.design.schema import Design as DesignValues
from cadgen.design.schema import MotionDesign, TrainDesign
from cadgen.errors import DesignError, brief
from cadgen.output.files.publisher import folder_of


@dataclass(frozen=True, repr=False)
class LoadedDesign:
    """A design as it was read: its values, its text and its file. `cadgen.Design` adds the jobs.

    Attributes:
        values: values of all keys, checked, with defaults; as in docs/design-file.md.
        text: text of the design file, before overrides.
        file: path of the design file; for a design from text, its name with the ending .toml.
    """

    values: TrainDesign
    text: str
    file: Path

    @classmethod
    def load(
        cls,
        source: str | PathLike[str] | None = None,
        changes: Mapping[str, Any] | Iterable[str] = (),
        *,
        train_only: bool = False,
    ) -> Self:
        """Read a design and check it.

        Args:
            source: name of a packaged design, or path of a TOML file; the paper's car if left out.
            changes: changes as for `with_`, applied before the checks.
            train_only: whether only the gear train is used: sections of the cam may then be missing.

        Raises:
            DesignError: no such design, a file that is not TOML, or values that are not allowed. The message has a
                sentence for each of up to five errors, with the key and what is allowed.
        """
        text, file = load.read_design(name_or_path("source", source))
        return cls._checked(text, file, overrides_of(changes), train_only)

    @classmethod
    def from_toml(cls, text: str, name: str = "design", *, train_only: bool = False) -> Self:
        """Make a design from the text of a design file; errors as in `load`.

        Args:
            text: text of the design in TOML.
            name: name of the design, if the text has none.
            train_only: same as for `load`.
        """
        return cls._checked(plain_text("text", text), Path(f"{name}.toml"), (), train_only)

    @classmethod
    def new(
        cls,
        name: str,
        folder: str | PathLike[str] = ".",
        *,
        points: str | PathLike[str] | None = None,
        layer: str | None = None,
        gate_radius_mm: float = 50.0,
        field_mm: tuple[float, float] | None = None,
        closed: bool = False,
        train: bool = False,
        motion: bool = False,
        table: str | PathLike[str] | None = None,
        changes: Mapping[str, Any] | Iterable[str] = (),
    ) -> Self:
        """Begin a design: write a commented file, and load it.

        It has the paper's mechanism and a path, or is of a cam by its motion.

        Args:
            name, folder: name of the design and, with .toml, of its file; folder for that.
            points, layer: file of the path's points, CSV, TXT or DXF; layer of the polyline in a DXF with several.
            gate_radius_mm, field_mm: radius of the gates at the points; width and height of the field.
            closed: whether the path is a lap.
            train: whether a gear train is proposed for the wheel of the outline, laid out in the car.
            motion, table: whether it is a cam by its motion; file of its lift table, CSV, an example if left out.
            changes: changes as for `with_`, written into the file.

        Raises:
            DesignError, FileError: values that are not allowed; points that cannot be read, a file that is there; no
                train that fits the car.
        """
        from cadgen.design.begin import ProposedTrain, begin, begin_motion, points_of, write_new

        changed, place = overrides_of(changes), folder_of(folder)
        file = place / f"{plain_text('name', name)}.toml"
        if motion or table is not None:
            if points is not None or layer is not None or field_mm is not None or closed or train:
                raise DesignError("a cam by its motion has no path: leave points, layer, field, closed and train out")
            text = begin_motion(name, None if table is None else paths("table", table)[0], changed, place)
            write_new(text, file)
            return cls._checked(text, file, (), False)
        radius = real("gate_radius_mm", gate_radius_mm, 0, 100_000, "mm", above=True)
        if field_mm is not None:
            if not isinstance(field_mm, Sequence) or isinstance(field_mm, str) or len(field_mm) != 2:
                raise DesignError(
                    "{name} is {value}; it must be width and height, mm",
                    name="field_mm",
                    value=brief(repr(field_mm), 60),
                )
            field_mm = (real("field_mm", field_mm[0], 1, 1e6, "mm"), real("field_mm", field_mm[1], 1, 1e6, "mm"))
        source = None if points is None else paths("points", points)[0]
        path = points_of(source, layer, closed=closed)

        def text_with(proposal: ProposedTrain | None) -> str:
            return begin(name, path, changed, radius, field_mm, closed, proposal)

        if train:
            from cadgen.jobs.train_proposal import proposed

            text = proposed(text_with, name)
        else:
            text = text_with(None)
        write_new(text, file)
        return cls._checked(text, file, (), False)

    @classmethod
    def _checked(cls, text: str, file: Path, overrides: tuple[str, ...], train_only: bool) -> Self:
        return cls((load.train_of if train_only else load.complete_of)(text, file, overrides), text, file)

    def with_(self, changes: Mapping[str, Any] | Iterable[str]) -> Self:
        """The design with some keys changed, by the same rules as `--set` on the command line.

        Args:
            changes: new value by key, such as `{"cam.thickness_mm": 3.2, "path.waypoints_mm.3": [1, 2]}`. List items
                count from 1; None removes a key or a section. Texts `key=value` are taken, too.

        Raises:
            DesignError: a key is unknown, or the result is no design; the message names the key.
        """
        overrides = (*self.values.overrides, *overrides_of(changes))
        if isinstance(changes, Mapping):
            overrides = tuple(map(KeyChange, overrides))
        return self._checked(self.text, self.file, overrides, not isinstance(self.values, DesignValues | MotionDesign))

    def __repr__(self) -> str:
        changed = f", changed by {brief(' '.join(self.values.overrides), 80)}" if self.values.overrides else ""
        return f"<{type(self).__name__} {self.name} of {self.file.name}{changed}>"

    @property
    def name(self) -> str:
        """Name of the design; the names of exported files begin with it."""
        return self.values.name

    @property
    def sha256(self) -> str:
        """SHA-256 of the values of the design, hexadecimal, as in manifests."""
        return self.values.content_hash

    @property
    def by_motion(self) -> bool:
        """Whether the design is of a cam by its motion, and not of a car."""
        return isinstance(self.values, MotionDesign)

    @property
    def to_be_measured(self) -> bool:
        """Whether the motion of the design is to be found from a measured cam."""
        return isinstance(self.values, MotionDesign) and bool(self.values.motion.measured)

    def complete(self) -> DesignValues:
        """The design, if it has all that a cam needs."""
        known = self.values
        return known if isinstance(known, DesignValues) else load.design_of(self.text, self.file, known.overrides)


def overrides_of(changes: Mapping[str, Any] | Iterable[str]) -> tuple[str, ...]:
    """Overrides as `--set` takes them.

    Args:
        changes: new value by key, where None removes the key; or texts `key=value`, taken as they are.

    Raises:
        DesignError: the changes are neither, or a value has no form in TOML.
    """
    if isinstance(changes, Mapping):
        for key in changes:
            # A key with an equals sign would be read as another key with the start of a value.
            if not isinstance(key, str) or not key.isprintable() or {"=", " "} & set(key):
                raise DesignError(
                    '{key} is no key; write it as in the design file, such as "cam.thickness_mm"',
                    key=brief(repr(key), 60),
                )
        return tuple(KeyChange(f"{key}={'' if value is None else _toml(key, value)}") for key, value in changes.items())
    changes = tuple(changes) if isinstance(changes, Iterable) and not isinstance(changes, str) else changes
    if not isinstance(changes, tuple) or not all(isinstance(text, str) for text in changes):
        raise DesignError(
            'the changes are {given}; give keys with their values, such as {{"cam.thickness_mm": 3.2}}',
            given=brief(repr(changes), 60),
        )
    return changes


def _toml(key: str, value: Any) -> str:
    value = value.tolist() if hasattr(value, "tolist") else value  # numpy's
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value))
    if isinstance(value, str):
        if any("\ud800" <= sign <= "\udfff" for sign in value):  # halves of a pair
            raise DesignError(
                "{key} is given {value}, which is no text in UTF-8; correct it",
                key=brief(key),
                value=brief(repr(value), 60),
            )
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        inside = ", ".join(f"{json.dumps(str(name))} = {_toml(key, part)}" for name, part in value.items())
        return f"{{{inside}}}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_toml(key, part) for part in value)}]"
    kind = "a date" if isinstance(value, (date, time)) else f"a {type(value).__name__}"
    raise DesignError(
        "{key} is given {kind}; a value must be a number, a text, True or False, a list or a table of these",
        key=brief(key),
        kind=kind,
    )
