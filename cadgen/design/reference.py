"""The schema as a page: `python -m cadgen.design.reference > docs/design-file.md`.

With `zh` behind it, it is the Chinese one, `docs/design-file.zh-CN.md`.
"""

import sys
from collections.abc import Iterable, Iterator
from math import degrees

from cadgen.cam.followers import table as followers
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS
from cadgen.car.path.path_kinds import codes, kind_of
from cadgen.design.keys import Key, SectionKeys, keys, last, tables
from cadgen.design.keys import shown as shown_value
from cadgen.design.kinds import Kinds
from cadgen.design.load import DEFAULT_DESIGN, packaged_designs
from cadgen.gears import stage_kinds
from cadgen.messages import Message, joined, shown

_HEAD = Message("""\
# The design file

[中文](design-file.zh-CN.md)

A design is a TOML file in UTF-8. Lengths are in mm, angles in degrees, small errors in µm; the unit stands
at the end of a key's name. A key that is not listed here, a number in quotes, NaN or a value outside its
range is an error, which names the key and what is allowed.

The shortest useful design of a car has a path, a car, a cam and a follower; everything else has a default. A cam for
any other use has `[motion]` in the place of the path and the car ([followers](how-to/followers.md)).
`cadgen gears` needs `[train]` alone.

```toml
[path]
waypoints_mm = [[0.0, 0.0], [1500.0, 200.0], [2600.0, 1200.0], [4000.0, 1500.0], [5500.0, 1000.0]]

[car]
wheelbase_mm = 167.0
drive_wheel_offset_mm = 37.0
idle_wheel_offset_mm = 201.0

[cam]
base_radius_mm = 70.0
mid_plane_mm = 25.0
thickness_mm = 3.0

[follower]
radius_mm = 2.5

[mechanics]                        # a steel rod on greased aluminium; without it the rod slides without friction
friction_least = 0.05
friction_greatest = 0.20
```

""")
_PACKAGED = Message(
    """\
These designs come with the program and go by name; without any it takes
`{default}`: {names}.

""",
    default=DEFAULT_DESIGN,
    names=", ".join(f"`{name}`" for name in packaged_designs()),
)
_SETTING = Message("""\
## Changing a value from the command line

`--set` changes one value, and may be given more than once; the result is the same as that of an edited file.

| written | does |
|---|---|
| `--set cam.thickness_mm=3.2` | sets a key |
| `--set path.spline=cubic` | sets text; quotes are not needed |
| `--set path.waypoints_mm.3=[4200, 260]` | sets the third item of a list |
| `--set blank.d_flat.across_mm=7` | adds a section, if it is not there |
| `--set cam.mid_plane_mm=` | removes a key, so that its default holds |
| `--set blank.keyway=` | removes a section |
| `--set train.stages.2.centre_distance_mm=40.1` | sets a key in the second of several sections |

## Keys
""")

_BY_MOTION = ("cam",)  # sections with other keys where the design has [motion]

_LIMITS = Message("""
## Limits of the pressure angle

The names that `checks.pressure_angle_limit` takes. On the rise, the working stroke, the cam drives the follower
outwards; on the return the spring drives it back.

| name | rise | return | source |
|---|---|---|---|
""")


# Head of a table of keys.
_TABLE = Message("| key | unit | must be | default | meaning |\n|---|---|---|---|---|\n")


def every_kind() -> dict[str, Kinds]:
    """Kinds of design that have keys of their own, each by its word; the usual one by none."""
    named = {"": Kinds(), "motion": Kinds(motion=True)}
    named |= {code: Kinds(follower=followers.kind_of(code), motion=True) for code in followers.codes()[1:]}
    named |= {code: Kinds(stage=stage_kinds.kind_of(code)) for code in stage_kinds.codes()}
    return named | {code: Kinds(path=kind_of(code)) for code in codes()}


def named_keys(name: str) -> list[tuple[str, Key]]:
    """Keys that have a name, each with the kind of design that it is of.

    Args:
        name: dotted name, or its last part, which several sections may have.

    Returns:
        Kind and key, the usual kind first; a key that says the same in several kinds once. The kind is empty for the
        usual one and where all kinds agree.
    """
    found: dict[tuple[str, str, str], tuple[str, Key]] = {}
    for kind, each in every_kind().items():
        for full, key in keys(each).items():
            if name in (full, last(full)):
                found.setdefault((full, key.meaning, key.demand), (kind, key))
    exact = [(kind, key) for kind, key in found.values() if key.name == name]
    return exact or list(found.values())


def named_section(name: str) -> SectionKeys | None:
    """Section of a design file by its name; None where there is none.

    Args:
        name: dotted name, such as `train.stages`.
    """
    return next((all_of[name] for each in every_kind().values() if name in (all_of := tables(each))), None)


def page() -> Message:
    """The reference page in Markdown, written from the schema."""
    parts: list[str] = [_HEAD, _PACKAGED, _SETTING]
    for table in tables().values():
        title = f"### {table.heading}" if table.name else Message("### Before the first section")
        parts += ["\n", title, *(["\n\n", Message(table.meaning)] if table.name else [])]
        parts += ["" if table.required else Message(" May be left out."), "\n\n", _table(table.keys), *_others(table)]
    limits = [
        joined((f"| `{name}`", f"{degrees(limit.rise):.0f}°", f"{degrees(limit.fall):.0f}°", limit.source), " | ")
        for name, limit in PRESSURE_ANGLE_LIMITS.items()
    ]
    return joined([*parts, _LIMITS, joined([*limits, ""], " |\n")], "")


def _table(rows: Iterable[Key]) -> Message:
    return joined([_TABLE, *map(_row, rows)], "")


def _others(table: SectionKeys) -> Iterator[str]:
    """After some sections, tables of the keys that take the place of the usual ones."""
    if table.name in _BY_MOTION:
        keys = tables(Kinds(motion=True))[table.name].keys
        yield from ("\n", Message("With `[motion]`, instead of all these:"), "\n\n", _table(keys))
    if table.name == "train.stages":
        for stage in map(stage_kinds.kind_of, stage_kinds.codes()):
            said = Message('With `kind = "{kind}"`, instead of driver and driven.', kind=stage.code)
            own = stage.keys.__annotations__
            yield from _kind(
                said, stage.meaning, [key for key in _of(Kinds(stage=stage), table) if last(key.name) in own]
            )
            yield from _inside(Kinds(stage=stage), table)
    if table.name == "follower":
        for code in followers.codes()[1:]:
            kinds = Kinds(follower=(follower := followers.kind_of(code)), motion=True)
            said = Message('With `kind = "{kind}"`, instead of the keys of the rod.', kind=code)
            yield from _kind(said, follower.meaning, [key for key in _of(kinds, table) if last(key.name) != "kind"])
            yield from _inside(kinds, table)
    usual = {key.name for key in table.keys}
    for path in map(kind_of, codes()) if table.name == "path" else ():
        every = _of(Kinds(path=path), table)
        if own_keys := [key for key in every if key.name not in usual]:
            replaced = sorted(usual - {key.name for key in every})
            names = ", ".join(f"`{last(name)}`" for name in replaced)
            said = Message('With `spline = "{kind}"`, instead of {names}:', kind=path.code, names=names)
            yield from ("\n", said, "\n\n", _table(own_keys))


def _kind(said: Message, meaning: str, rows: Iterable[Key]) -> Iterator[str]:
    yield from ("\n", said, " ", Message(meaning), "\n\n", _table(rows))


def _of(kinds: Kinds, table: SectionKeys) -> tuple[Key, ...]:
    return tables(kinds)[table.name].keys


def _inside(kinds: Kinds, table: SectionKeys) -> Iterator[str]:
    """Tables of the sections within one, which a kind has by itself."""
    for part in tables(kinds).values():
        if part.name.startswith(f"{table.name}."):
            said = Message("`{section}` of it.", section=last(part.name) if table.many else part.heading)
            yield from _kind(said, part.meaning, part.keys)


def _row(key: Key) -> Message:
    must = joined(filter(None, [key.kinds[0], key.allowed]))
    if inside := key.allowed_inside:
        texts = "text" in key.kinds
        each = Message("each of them {range}", range=inside) if texts else Message("each number {range}", range=inside)
        must = joined((must, each), "; ")
    default = (
        Message("required") if key.required else "" if key.default in (None, "") else f"`{shown_value(key.default)}`"
    )
    cells = (f"| `{last(key.name)}`", Message(key.unit), must, default, Message(key.meaning))
    return joined((joined(cells, " | "), " |\n"), "")


if __name__ == "__main__":
    print(shown(page(), *sys.argv[1:]), end="")
