"""The catalogue of effects as a page: `python -m cadgen.inference.measurement.reference > docs/effects.md`."""

import re

from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.kinds import kinds

_HEAD = """\
# The effects that measured data are traced to

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
"""
_UNITS = {"um": "µm", "deg": "°", "%": "%", "mm": "mm", "s": "s", "": ""}
# Effects that come in series (orders, stages): one entry stands for all of a series.
_MANY = ((re.compile(r", order \d+$"), ", order n"), (re.compile(r" of (the camshaft|stage \d)$"), " of ..."))


def page() -> str:
    """The reference page in Markdown, written from the catalogue."""
    return _HEAD + "".join(f"\n## {kind.title}\n{''.join(map(_effect, kind.catalogue.entries))}" for kind in kinds())


_INDICES = {
    "nose_number": "which one, counted from 1 by polar angle",
    "turns_per_turn": "turns of that shaft for one of the cam; only a whole number may have the place `car`",
}


def _effect(effect: Effect) -> str:
    name = effect.name
    for pattern, shown in _MANY:
        name = pattern.sub(shown, name)
    remarks = (
        ("places", ", ".join(effect.places)),
        ("twins", ", ".join(effect.twins)),
        ("looks like", effect.confused_with),
        ("told apart by", effect.separated_by),
    )
    lines = [
        f"`{p.name}` ({p.lower:g} to {p.upper:g}{'' if p.unit in ('deg', '') else ' '}{_UNITS[p.unit]}): {p.meaning}"
        for p in effect.parameters
    ]
    lines += [f"`{index}`: {_INDICES[index]}" for index, _ in effect.indices]
    lines += [f"{title}: {text}" for title, text in remarks if text]
    return f"\n**{name}**\n\n" + "".join(f"- {line}\n" for line in lines)


if __name__ == "__main__":
    print(page(), end="")
