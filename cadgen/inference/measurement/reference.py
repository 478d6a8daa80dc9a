"""The catalogue of effects as a page: `python -m cadgen.inference.measurement.reference > docs/effects.md`.

With `zh` behind it, it is the Chinese one, `docs/effects.zh-CN.md`.
"""

import re
import sys

from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.kinds import kinds
from cadgen.messages import ENGLISH, Message, joined, shown

_HEAD = Message("""\
# The effects that measured data are traced to

[中文](effects.zh-CN.md)

`cadgen calibrate` looks for these; [measurement.md](measurement.md) says how. An effect is written to `[as_built]`
with its name, the kind of data and its numbers, in the unit at the end of their names. Its
[place](measurement.md#the-as-built-design) says how other commands use it. The first place is the default, and any
effect may be `noted`.

*Twins* cannot be told from the effect by data of [this kind](glossary.md#twin). *Looks like* names effects that such
data may resemble; *told apart by* says how to separate them.

**Frame.** x and y are those of the exported files and of a measured profile: the bore at the origin, +x towards the rod
at a cam angle of 0°. The polar angle counts counterclockwise, and the cam angle at which a point of the outline meets
the rod is about its polar angle. Left and right are those of a driver. The steering is positive to the right where a
cam steers, since a lifted rod turns the car right. Where it was logged it is positive to the left, as the heading is.
""")
_UNITS = {"um": "µm", "deg": "°", "%": "%", "mm": "mm", "s": "s", "": ""}
# Effects that come in series (orders, stages): one entry stands for all of a series.
_ORDER = re.compile(r", order \d+$")
_SHAFT = re.compile(r" of (the camshaft|stage \d)$")
_MANY = {
    "lobing": Message("lobing, order n"),
    "waviness": Message("waviness, order n"),
    "index error": Message("index error, order n"),
    "runout": Message("runout of ..."),
    "tooth mesh": Message("tooth mesh of ..."),
}


def page(language: str = ENGLISH) -> str:
    """Reference page in Markdown, written from the catalogue.

    Args:
        language: code of the language; in another than English an effect's English name, which designs have, stands
            behind its own.
    """
    parts: list[str] = [_HEAD]
    for kind in kinds():
        parts.append(Message("\n## {title}\n", title=Message(kind.title)))
        parts += [_effect(effect, language) for effect in kind.catalogue.entries]
    return shown(joined(parts, ""), language)


_INDICES = {
    "nose_number": Message("which one, counted from 1 by polar angle"),
    "turns_per_turn": Message("turns of that shaft for one of the cam; only a whole number may have the place `car`"),
}


def _effect(effect: Effect, language: str) -> Message:
    series = _SHAFT.sub("", _ORDER.sub("", effect.name))
    name = Message(effect.name) if series == effect.name else _MANY[series]
    if language != ENGLISH:
        name = Message("{name} ({english})", name=name, english=str(name))
    lines = [
        Message(
            "- `{name}` ({lower:g} to {upper:g}{unit}): {meaning}\n",
            name=number.name,
            lower=number.lower,
            upper=number.upper,
            unit=f"{'' if number.unit in ('deg', '') else ' '}{_UNITS[number.unit]}",
            meaning=Message(number.meaning),
        )
        for number in effect.parameters
    ]
    lines += [Message("- `{name}`: {meaning}\n", name=name, meaning=_INDICES[name]) for name, _ in effect.indices]
    remarks = (
        (Message("places"), ", ".join(effect.places)),
        (Message("twins"), effect.twins and joined(map(Message, effect.twins))),
        (Message("looks like"), Message(effect.confused_with)),
        (Message("told apart by"), Message(effect.separated_by)),
    )
    lines += [Message("- {title}: {text}\n", title=title, text=text) for title, text in remarks if text]
    return joined((Message("\n**{name}**\n\n", name=name), *lines), "")


if __name__ == "__main__":
    print(page(*sys.argv[1:]), end="")
