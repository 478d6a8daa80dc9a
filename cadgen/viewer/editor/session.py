"""A design that is edited: its text, the changes made and undone, and its file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from threading import Lock
from typing import Any

from cadgen.design.load import complete_of
from cadgen.design.parse import parse
from cadgen.design.schema import Design, MotionDesign
from cadgen.errors import DesignError, brief
from cadgen.figures import Facts
from cadgen.viewer.editor.controls import Control, ControlGroup, groups_of
from cadgen.viewer.editor.course_items import (
    ItemKind,
    MovablePoint,
    items_of,
    kinds_of,
    new_item,
    places_of,
    points_of,
)
from cadgen.viewer.editor.saving import EditedFile, refuse_name
from cadgen.viewer.editor.text_changes import Value, applied, changed, exchanged, inserted, removed
from cadgen.viewer.editor.timing import added, taken_out, timing_of
from cadgen.viewer.page.data import both

MOST_STEPS = 200  # that can be undone
_ENDING = ".toml"


@dataclass(frozen=True)
class Version:
    """The design between two changes.

    Attributes:
        text: TOML.
        design: the same, checked.
    """

    text: str
    design: Design | MotionDesign

    @property
    def car(self) -> bool:
        """Whether it is the design of a car, with a course, and not of a cam by its motion."""
        return isinstance(self.design, Design)

    @cached_property
    def keys(self) -> frozenset[str]:
        """Keys that can be changed."""
        controls = (control.key for group in groups_of(self.design, self.design) for control in group.controls)
        timing = timing_of(self.design)
        moved = frozenset[str]() if timing is None else timing.keys
        return frozenset(controls) | frozenset(point.key for point in points_of(self.design)) | moved


class Session:
    """A design that is edited; each method is safe to call from several threads.

    Attributes:
        revision: number of the version now; each change, undo and redo makes another one.
    """

    def __init__(self, source: str | Path | None, overrides: Sequence[str] = ()) -> None:
        """Open a design.

        Args:
            source: packaged design or file, as of `cadgen.design.load.load_design`.
            overrides: `key=value` each, written into the text as a first change.

        Raises:
            DesignError: no such design, or it is none.
        """
        self._lock = Lock()
        self._origin, text, self._file = EditedFile.of(source)
        self._opened = self._saved = self._now = Version(text, complete_of(text, self._file))
        self._undo: list[Version] = []
        self._redo: list[Version] = []
        self._gesture: str | None = None
        self._name: str | None = None  # under which the design was last saved as another one
        self.revision = 1
        if overrides:
            self._step(Version(*applied(text, self._file, list(overrides))))

    @property
    def now(self) -> Version:
        """The design as it is now."""
        return self._now

    @property
    def name(self) -> str:
        """Name of the design."""
        return self._now.design.name

    @property
    def unsaved(self) -> bool:
        """Whether there are changes that are in no file."""
        return self._now.text != self._saved.text

    def job(self) -> tuple[int, str, str]:
        """Revision, text and path of the file, of one moment."""
        with self._lock:
            return self.revision, self._now.text, str(self._file)

    def change(self, changes: Mapping[str, Value], gesture: str | None = None) -> None:
        """Change some numbers.

        Args:
            changes: new value by key.
            gesture: name of the move that the change is part of: all changes of one are undone together.

        Raises:
            DesignError: a key cannot be changed here, or the result is no design; nothing has changed then.
        """
        with self._lock:
            for key in changes:
                if key not in self._now.keys:
                    raise DesignError("{key} cannot be changed here: change it in a text editor", key=brief(key, 60))
            version = Version(*changed(self._now.text, self._file, changes))
            if version.text == self._now.text:
                return
            if gesture is not None and gesture == self._gesture and self._undo:
                self._now = version
                self.revision += 1
            else:
                self._step(version)
            self._gesture = gesture

    def insert(self, key: str, at: tuple[float, float]) -> None:
        """Put a point into a list, a post, gate or the like onto the course, or a segment into a motion, as a step.

        Args:
            key: dotted key of its place: that of the item that it is put before, or one more than the last item's.
            at: x and y, mm; of what has several points, of its middle; of a segment, the angle that it takes from the
                one before it, degrees, and the height at its end.

        Raises:
            DesignError: there is no such list here, or the result is no design; nothing has changed then.
        """
        with self._lock:
            text, design = self._now.text, self._now.design
            if isinstance(design, MotionDesign):
                number = self._segment(key, more=1)
                item, changes = added(design, number - 1, *at)
                self._step(Version(*inserted(text, self._file, key, item, changes)))
                self._gesture = None
                return
            lists = [point.listed for point in points_of(design) if point.listed]
            if key in {f"{name}.{number}" for name in set(lists) for number in range(1, lists.count(name) + 2)}:
                self._step(Version(*inserted(text, self._file, key, list(at))))
            elif key in places_of(design):
                self._step(Version(*inserted(text, self._file, key, new_item(design, text, key, at))))
            else:
                raise DesignError(
                    "{key} is no place for a point, nor for anything else on the course", key=brief(key, 60)
                )
            self._gesture = None

    def remove(self, key: str) -> None:
        """Take a point out of a list, a post, gate or the like off the course, or a segment out, as a step of its own.

        Raises:
            DesignError: there is no such thing here, or the result is no design; nothing has changed then.
        """
        with self._lock:
            design = self._now.design
            if isinstance(design, MotionDesign):
                changes = taken_out(design, self._segment(key))
                self._step(Version(*removed(self._now.text, self._file, key, changes)))
                self._gesture = None
                return
            points = {point.key for point in points_of(self._now.design) if point.listed}
            if key not in points | items_of(self._now.design):
                raise DesignError("{key} cannot be removed here: remove it in a text editor", key=brief(key, 60))
            self._step(Version(*removed(self._now.text, self._file, key)))
            self._gesture = None

    def exchange(self, key: str) -> None:
        """Exchange a gate, or a segment of a motion, with the next one, as a step: they count in their order.

        Raises:
            DesignError: there is no such thing, none after it, or the result is no design; nothing has changed then.
        """
        with self._lock:
            if not self._now.car:
                self._segment(key, more=-1)
                self._step(Version(*exchanged(self._now.text, self._file, key)))
                self._gesture = None
                return
            gates = sum(item.startswith("course.gates.") for item in items_of(self._now.design))
            if key not in {f"course.gates.{number}" for number in range(1, gates)}:
                raise DesignError(
                    "{key} cannot be exchanged with the next one: choose a gate but the last", key=brief(key, 60)
                )
            self._step(Version(*exchanged(self._now.text, self._file, key)))
            self._gesture = None

    def _segment(self, key: str, more: int = 0) -> int:
        """Number of a segment by its key, from 1, or of a place for one.

        Args:
            key: dotted key.
            more: places behind the last segment.

        Raises:
            DesignError: the motion has no such segment.
        """
        design = self._now.design
        count = len(design.motion.segments) if isinstance(design, MotionDesign) else 0
        places = {f"motion.segments.{number}": number for number in range(1 + max(more, 0), count + more + 1)}
        if key not in places:
            raise DesignError("{key} is no segment of the motion that this can be done with", key=brief(key, 60))
        return places[key]

    def undo(self) -> None:
        """Take the last change back; nothing without one."""
        with self._lock:
            self._back(self._undo, self._redo)

    def redo(self) -> None:
        """Make the change again that was taken back; nothing without one."""
        with self._lock:
            self._back(self._redo, self._undo)

    def save(self, name: str | None = None) -> str:
        """Write the design's file, and return its name.

        Args:
            name: name of a new design, with .toml or without; its file has the ending once. The file that was opened if
                left out.

        Raises:
            DesignError: a copy of a packaged design needs a name, or no file can have it.
            FileError: a new file is there already, the old one was changed meanwhile, or writing fails.
        """
        with self._lock:
            if name is None:
                self._origin = self._origin.save(self._now.text)
            else:
                name = name.strip()
                if name.lower().endswith(_ENDING):  # typed as a file's name
                    name = name[: -len(_ENDING)]
                refuse_name(name)
                version = _renamed(self._now, name)
                self._origin = self._origin.save_as(name, version.text)
                self._file, self._name = self._origin.folder / f"{name}.toml", name
                if version is not self._now:
                    self._now = version
                    self.revision += 1
            self._saved = self._now
            self._gesture = None
            return self._file.name

    def state(self) -> dict[str, Any]:
        """Everything that the page shows beside the results, as plain values."""
        with self._lock:
            design = self._now.design
            facts = Facts(
                revision=self.revision,
                name=design.name,
                file=self._file.name,
                folder=str(self._origin.folder),
                copy=self._origin.file is None,
                unsaved=self.unsaved,
                undo=len(self._undo),
                redo=len(self._redo),
                groups=[_shown(group) for group in groups_of(design, self._opened.design)],
                points=[_shown(point) for point in points_of(design)],
                kinds=[_shown(kind) for kind in kinds_of(design)],
                timing=timing_of(design),
            )
            return facts.json()

    def news(self) -> Facts:
        """State that another page, or another program, may have changed: cheap to ask for again and again."""
        with self._lock:
            return Facts(
                revision=self.revision,
                file=self._file.name,
                unsaved=self.unsaved,
                changed_outside=self._origin.changed_outside(),
            )

    def _step(self, version: Version) -> None:
        self._undo = [*self._undo[1 - MOST_STEPS :], self._now]
        self._redo = []
        self._now = version
        self.revision += 1

    def _back(self, source: list[Version], target: list[Version]) -> None:
        if source:
            # Saving under another name is no change that can be taken back.
            version = source[-1] if self._name is None else _renamed(source[-1], self._name)
            source.pop()
            target.append(self._now)
            self._now = version
            self._gesture = None
            self.revision += 1


def _renamed(version: Version, name: str) -> Version:
    """Design under another name, whether its text has a name or leaves it to the file.

    Raises:
        DesignError: the name cannot be written into the text.
    """
    if version.design.name == name:
        return version
    file = Path(f"{name}.toml")
    if "name" in parse(version.text):
        return Version(*applied(version.text, file, [f'name="{name}"']))
    return Version(version.text, complete_of(version.text, file))


def _shown(value: ControlGroup | Control | MovablePoint | ItemKind) -> Facts:
    """Values for the page's script, the label in both languages."""
    facts = Facts(**{field.name: getattr(value, field.name) for field in fields(value)})
    inside = (
        Facts(controls=[_shown(control) for control in value.controls]) if isinstance(value, ControlGroup) else Facts()
    )
    return facts | Facts(label=both(value.label)) | inside
