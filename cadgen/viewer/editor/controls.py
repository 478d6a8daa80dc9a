"""Numbers of a design that can be changed on the page, each with the range of its schema and that of its slider."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import ceil, floor, log10

from cadgen.design.explain import section
from cadgen.design.keys import Key, dotted, keys, without_unit
from cadgen.design.kinds import NamedKinds, Place
from cadgen.design.schema import Design, MotionDesign
from cadgen.messages import Message, clauses
from cadgen.viewer.editor.course_items import NAMED_KEYS, point_name

# Groups of controls: code, heading, parts of the design.
GROUPS = (
    ("car", Message("Car"), ("car",)),
    ("motion", Message("Motion"), ("motion",)),
    ("cam", Message("Cam and follower"), ("cam", "follower")),
    ("path", Message("Path"), ("path",)),
    ("course", Message("Course and field"), ("course", "field")),
    ("blank", Message("Disc"), ("blank",)),
    ("gears", Message("Gears"), ("train",)),
    ("forces", Message("Mass, spring and load"), ("dynamics",)),
    ("play", Message("Play and friction"), ("play", "mechanics")),
    ("limits", Message("Limits"), ("checks", "optimize")),
)
# Sections whose name is that of their group, or goes without saying.
_SILENT = (
    "car",
    "cam",
    "path",
    "course",
    "train",
    "play",
    "mechanics",
    "checks",
    "optimize",
    "blank",
    "motion",
    "dynamics",
)
# Parts of a design that do not change the cam, its gears or their checks.
_LEFT_OUT = ("train.search",)
# Numbers that the timing diagram moves, for they must add up.
_IN_DIAGRAM = ("segments", "repeat", "machine_turns")
# Half of the range of a slider whose number is 0, by its unit; 1 for other units.
_ABOUT_ZERO = {"mm": 10.0, "degrees": 30.0, "µm": 50.0}
_STEPS = 200  # of a slider, at least


@dataclass(frozen=True)
class Control:
    """A number that can be changed.

    Attributes:
        key: dotted key, items of lists counted from 1.
        label: name.
        meaning: phrase of the schema.
        unit: unit of the number.
        value: number now.
        least: least value that the schema allows; None without a limit.
        most: greatest value that it allows; None without a limit.
        low: least value of the slider.
        high: greatest value of the slider.
        step: step of the slider.
        whole: whether it is a whole number.
    """

    key: str
    label: str
    meaning: str
    unit: str
    value: float
    least: float | None
    most: float | None
    low: float
    high: float
    step: float
    whole: bool


@dataclass(frozen=True)
class ControlGroup:
    """Controls under one heading."""

    code: str
    label: str
    controls: tuple[Control, ...]


def groups_of(design: Design | MotionDesign, opened: Design | MotionDesign) -> tuple[ControlGroup, ...]:
    """All controls of a design, by groups.

    Args:
        design: design as it is now.
        opened: design as it was opened: sliders keep the ranges about its numbers.
    """
    values, before = design.values(), {key: value for key, _, value in _numbers(opened)}
    named = NamedKinds.of(values)
    made: dict[str, list[Control]] = {}
    for key, place, value in _numbers(design):
        info = keys(named.at(place)).get(section(place))
        if info is not None:
            name = key_name(key, moved=isinstance(design, MotionDesign))
            made.setdefault(str(place[0]), []).append(_control(key, name, info, value, before.get(key, value)))
    groups = (
        ControlGroup(code, label, tuple(control for part in parts for control in made.get(part, ())))
        for code, label, parts in GROUPS
    )
    return tuple(group for group in groups if group.controls)


def _numbers(design: Design | MotionDesign) -> Iterator[tuple[str, Place, float]]:
    """Dotted key, place and value of each number that can be changed."""
    values = design.values()
    for _, _, parts in GROUPS:
        for part in parts:
            if part in values:
                yield from _inside(values[part], (part,))


def _inside(value: object, place: Place) -> Iterator[tuple[str, Place, float]]:
    if section(place) in _LEFT_OUT or (place[0] == "motion" and place[-1] in _IN_DIAGRAM):
        return
    if isinstance(value, dict):
        for name, inner in value.items():
            if name == "heading_tolerance_deg" and value.get("heading_deg") is None:
                continue  # it is about no heading
            yield from _inside(inner, (*place, name))
    elif isinstance(value, list) and all(isinstance(item, dict) for item in value):
        for number, inner in enumerate(value):
            yield from _inside(inner, (*place, number))
    elif isinstance(value, list | tuple) and place[-1] == "size_mm":
        for number, inner in enumerate(value):  # width and height
            yield from _inside(inner, (*place, number))
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield dotted(*(part + 1 if isinstance(part, int) else part for part in place)), place, value


def _control(key: str, name: Message, info: Key, value: float, opened: float) -> Control:
    whole = info.kinds[0] == "a whole number"
    half = abs(opened) / 2 if opened else _ABOUT_ZERO.get(info.unit, 1.0)
    low, high = opened - half, opened + half
    step = 1.0
    if not whole:
        # The greatest of 1, 2 and 5 times a power of ten that is no more than the width of a step.
        width = (high - low) / _STEPS
        power = 10.0 ** floor(log10(width))
        step = next(times * power for times in (5.0, 2.0, 1.0) if times * power <= width * (1 + 1e-9))
    low, high = step * floor(low / step), step * ceil(high / step)
    if info.least is not None:
        # A bound may itself be refused, such as a length of 0: the slider ends one step before.
        low = max(low, info.least if whole or info.least != 0 or not opened else step)
    if info.most is not None:
        high = min(high, info.most)
    low, high = min(low, value), max(high, value, low + step)
    digits = max(0, -floor(log10(step)))
    return Control(
        key=key,
        label=name,
        meaning=info.meaning,
        unit=info.unit,
        value=value,
        least=info.least,
        most=info.most,
        low=round(low, digits + 2),
        high=round(high, digits + 2),
        step=round(step, digits + 2),
        whole=whole,
    )


@cache  # of some hundred keys; they are named after every change
def key_name(key: str, *, moved: bool = False) -> Message:
    """Name of a key: `train.stages.2.driver.teeth` is stage 2, driver, teeth.

    Args:
        key: dotted key.
        moved: whether the design has [motion], whose follower need be no rod.
    """
    parts = [part for part in key.split(".") if part not in _SILENT]
    names: list[Message] = []
    while parts:
        part = parts.pop(0)
        if part == "stages" and parts:
            names.append(Message("stage {number}", number=parts.pop(0)))
        elif part in NAMED_KEYS and parts and parts[0].isdecimal():
            names.append(point_name(part, int(parts.pop(0))))
        elif part in ("start", "finish"):
            names.append(point_name(part, 0))
        elif part == "size_mm":
            names.append(Message("width") if parts.pop(0) == "1" else Message("height"))
        else:
            name = without_unit(part)
            if part[1:2] != "_":
                name = name.replace("_", " ")
            names.append(Message(name))
    if len(names) > 1 and names[0] == "follower":
        names = names[1:] if moved else [Message("rod"), *names[1:]]
    return clauses(*names)
