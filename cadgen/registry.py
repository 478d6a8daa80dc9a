"""Kinds of one sort by their codes: those of the package, those registered in Python, and those of installed plug-ins.

A plug-in is a distribution with entry points in a group, such as `cadgen.followers`; each names a kind or a tuple of
kinds. They are looked for when a code is asked for that the package does not have, or when all codes are listed. So a
design of the package's own kinds does not wait for them. A plug-in that cannot be loaded, or whose kinds cannot
be told from others, is passed over with one warning. Every process looks for itself.

| group              | object of an entry point                                                                   |
|--------------------|--------------------------------------------------------------------------------------------|
| `cadgen.followers` | `cadgen.cam.followers.kind.FollowerKind`                                                   |
| `cadgen.laws`      | `cadgen.laws.law.MotionLaw`                                                                |
| `cadgen.stages`    | `cadgen.gears.stage_kind.StageKind`                                                        |
| `cadgen.formats`   | `cadgen.output.files.formats.Format`, which writes and reads back cams, gears or trains    |
| `cadgen.data`      | `cadgen.inference.measurement.record.Kind`, a kind of measured data with its model         |
| `cadgen.effects`   | `cadgen.deviations.catalogue.EffectOf`, an effect on data of a kind that there is          |
"""

import logging
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Generic, Protocol, TypeVar

from cadgen.errors import DesignError, brief
from cadgen.messages import Message, joined, speak_for

_log = logging.getLogger(__name__)
# One letter at least, as in 3mf. A unit at the end is written as it is, such as _J.
_CODE = re.compile(r"[0-9]?[a-z][a-z0-9]*(_[a-z0-9]+)*(_[A-Z][A-Za-z]*)?")
# Distribution and version of each object that a plug-in has brought, and of those that were used in this process.
_brought: dict[int, tuple[str, str]] = {}
_used: dict[str, str] = {}


def load_plugins(group: str, sort: type[Any], register: Callable[[Any], object], noun: str = "") -> None:
    """Register what the installed plug-ins bring in a group; a faulty one gives a warning.

    Args:
        group: group of entry points, such as `cadgen.followers`.
        sort: class that each object that they bring must have.
        register: function that adds one object; it raises an error that says what is wrong with it.
        noun: what they should bring, in words; the name of the class if left out.
    """
    from importlib.metadata import entry_points  # a twentieth of a second that most commands save

    for point in sorted(entry_points(group=group), key=lambda point: point.name):
        name, version = (
            (point.dist.name, point.dist.version) if point.dist else (Message("an unknown distribution"), "")
        )
        try:
            brought = point.load()
            for each in brought if isinstance(brought, tuple) else (brought,):
                if not isinstance(each, sort):
                    raise DesignError(
                        "it brings {found}, and should bring {sort}",
                        found=type(each).__name__,
                        sort=noun or sort.__name__,
                    )
                register(each)
                _brought[id(each)] = name, version
            speak_for(point.module.partition(".")[0])
        except (Exception, SystemExit) as error:
            _log.warning(
                Message(
                    "the plug-in {plugin} of {name} {version} (entry points {group}) cannot be used ({fault}): correct "
                    "it, or uninstall {name}",
                    plugin=point.name,
                    name=name,
                    version=version,
                    group=group,
                    fault=error.message
                    if isinstance(error, DesignError)
                    else brief(str(error) or type(error).__name__),
                )
            )


def used(kind: Any) -> Any:
    """Note an object as used if a plug-in has brought it, and return it.

    Args:
        kind: any object of a table.
    """
    if id(kind) in _brought:
        name, version = _brought[id(kind)]
        _used[name] = version
    return kind


def used_plugins() -> Mapping[str, str]:
    """Version of each plug-in whose kinds this process has used, by the name of its distribution."""
    return dict(sorted(_used.items()))


def fault_sentence(error: Exception) -> Message:
    """Sentence on an error that no design or request should cause; it names the plug-ins whose kinds were used.

    Args:
        error: error that was not expected.
    """
    summary = brief(f"{type(error).__name__}: {error}", 400)
    if not _used:
        return Message("a fault in cadgen, please report it with your design file ({summary})", summary=summary)
    return Message(
        "a fault in cadgen, or in {plugins}, of which the design uses a kind: try it without that kind, and report it "
        "with your design file to whose fault it is ({summary})",
        plugins=joined(f"{name} {version}".strip() for name, version in used_plugins().items()),
        summary=summary,
    )


class RegisteredKind(Protocol):
    """An object with a code by which a design names it."""

    @property
    def code(self) -> str:
        """Small letters, digits and single underscores."""


K = TypeVar("K", bound=RegisteredKind)


class Registry(Generic[K]):
    """All kinds of one sort.

    Args:
        noun: name of the sort in messages, a message itself, such as `follower`.
        kinds: kinds of the package.
        reserved: codes that no kind may take.
        group: group of the entry points of plug-ins; empty if they bring no such kinds.
        sort: class of the kinds, which those of plug-ins must have.
    """

    def __init__(
        self,
        noun: str,
        kinds: Iterable[K],
        reserved: Iterable[str] = (),
        group: str = "",
        sort: type[Any] = object,
    ) -> None:
        self._noun, self._reserved, self._group, self._sort = noun, tuple(reserved), group, sort
        self._kinds: dict[str, K] = {}
        for kind in kinds:
            self.register(kind)

    def register(self, kind: K) -> None:
        """Add a kind, which design files may then name.

        Raises:
            DesignError: the code is taken, or cannot be the value of a key.
        """
        if kind.code in (*self._reserved, *self._kinds):
            raise DesignError(
                'there is a {noun} "{code}" already: choose another code', noun=self._noun, code=kind.code
            )
        if not _CODE.fullmatch(kind.code):
            raise DesignError(
                '"{code}" cannot be the code of a {noun}: take small letters, digits and single _',
                code=kind.code,
                noun=self._noun,
            )
        self._kinds[kind.code] = kind

    def remove(self, kind: K) -> None:
        """Take a registered kind out again."""
        del self._kinds[kind.code]

    def has(self, code: str) -> bool:
        """Whether there is a kind with a code; plug-ins are looked for if the package has none."""
        if code not in self._kinds and code not in self._reserved:
            self._look_for_plugins()
        return code in self._kinds

    def codes(self) -> tuple[str, ...]:
        """Codes of all kinds."""
        self._look_for_plugins()
        return tuple(self._kinds)

    def kind_of(self, code: str) -> K:
        """Kind with a code.

        Raises:
            DesignError: no kind has that code.
        """
        if not self.has(code):
            raise DesignError(
                'there is no {noun} "{code}": choose one of {codes}',
                noun=self._noun,
                code=code,
                codes=joined(self._kinds),
            )
        kind: K = used(self._kinds[code])
        return kind

    def _look_for_plugins(self) -> None:
        group, self._group = self._group, ""  # once, and not again while one is loaded
        if group:
            load_plugins(group, self._sort, self.register)
