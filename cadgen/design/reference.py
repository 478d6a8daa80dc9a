"""The schema as a page: `python -m cadgen.design.reference > docs/design-file.md`."""

from math import degrees

from cadgen.cam.followers import table as followers
from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS
from cadgen.car.path.path_kinds import PathKind, codes, kind_of
from cadgen.design.keys import Key, SectionKeys, keys, last, shown, tables
from cadgen.design.kinds import Kinds
from cadgen.design.load import DEFAULT_DESIGN, packaged_designs
from cadgen.design.section import listed
from cadgen.gears import stage_kinds
from cadgen.gears.stage_kind import StageKind

_HEAD = """\
# The design file

A design is a TOML file in UTF-8. Lengths are in mm, angles in degrees, small errors in µm; the unit stands
at the end of a key's name. A key that is not listed here, a number in quotes, NaN or a value outside its
range is an error, which names the key and what is allowed.

The shortest useful design of a car has a path, a car, a cam and a follower; everything else has a default. A cam for
any other use has `[motion]` in the place of the path and the car (see how-to/followers.md). `cadgen gears` needs
`[train]` alone.

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

The designs {names} come with the program and go by name; without any it takes
`{default}`.

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
"""

_BY_MOTION = ("cam",)  # sections with other keys where the design has [motion]

_LIMITS = """
## Limits of the pressure angle

The names that `checks.pressure_angle_limit` takes. On the rise, the working stroke, the cam drives the follower
outwards; on the return the spring drives it back.

| name | rise | return | source |
|---|---|---|---|
"""


# Head of a table of keys.
_TABLE = "| key | unit | must be | default | meaning |\n|---|---|---|---|---|\n"


def _every_kind() -> dict[str, Kinds]:
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
    for kind, each in _every_kind().items():
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
    return next((all_of[name] for each in _every_kind().values() if name in (all_of := tables(each))), None)


def page() -> str:
    """The reference page in Markdown, written from the schema."""
    names = listed([f"`{name}`" for name in packaged_designs()], "and")
    sections = ""
    for table in tables().values():
        title = f"### {table.heading}\n\n{table.meaning}" if table.name else "### Before the first section"
        optional = "" if table.required else " May be left out."
        rows = "".join(_row(key) for key in table.keys)
        sections += f"\n{title}{optional}\n\n{_TABLE}{rows}{_other_paths(table)}"
    limits = "".join(
        f"| `{name}` | {degrees(limit.rise):.0f}° | {degrees(limit.fall):.0f}° | {limit.source} |\n"
        for name, limit in PRESSURE_ANGLE_LIMITS.items()
    )
    return _HEAD.format(names=names, default=DEFAULT_DESIGN) + sections + _LIMITS + limits


def _other_paths(table: SectionKeys) -> str:
    """After the sections [path], [cam] and [follower], the keys that take the place of the usual ones."""
    if table.name in _BY_MOTION:
        keys = tables(Kinds(motion=True))[table.name].keys
        return f"\nWith `[motion]`, instead of all these:\n\n{_TABLE}{''.join(map(_row, keys))}"
    if table.name == "train.stages":
        return "".join(_stage_kind(stage_kinds.kind_of(code)) for code in stage_kinds.codes())
    if table.name == "follower":
        return "".join(_follower_kind(followers.kind_of(code)) for code in followers.codes()[1:])
    kinds = [kind_of(code) for code in codes()] if table.name == "path" else []
    usual = {key.name for key in table.keys}
    return "".join(_path_kind(kind, usual) for kind in kinds)


def _follower_kind(kind: FollowerKind) -> str:
    every = tables(Kinds(follower=kind, motion=True)).values()
    table, *below = [table for table in every if table.name.partition(".")[0] == "follower"]
    rows = "".join(_row(key) for key in table.keys if last(key.name) != "kind")
    inner = "".join(
        f"\n`{part.heading}` of it. {part.meaning}\n\n{_TABLE}{''.join(map(_row, part.keys))}" for part in below
    )
    return f'\nWith `kind = "{kind.code}"`, instead of the keys of the rod. {kind.meaning}\n\n{_TABLE}{rows}{inner}'


def _stage_kind(kind: StageKind) -> str:
    every = tables(Kinds(stage=kind)).values()
    table, *below = [part for part in every if part.name == "train.stages" or part.name.startswith("train.stages.")]
    own = [key for key in table.keys if last(key.name) in kind.keys.__annotations__]
    inner = "".join(
        f"\n`{last(part.name)}` of it. {part.meaning}\n\n{_TABLE}{''.join(map(_row, part.keys))}" for part in below
    )
    rows = "".join(map(_row, own))
    return f'\nWith `kind = "{kind.code}"`, instead of driver and driven. {kind.meaning}\n\n{_TABLE}{rows}{inner}'


def _path_kind(kind: PathKind, usual: set[str]) -> str:
    keys = {key.name: key for key in tables(Kinds(path=kind))["path"].keys}
    if not (rows := "".join(_row(key) for name, key in keys.items() if name not in usual)):
        return ""
    replaced = listed([f"`{last(name)}`" for name in sorted(usual - set(keys))], "and")
    return f'\nWith `spline = "{kind.code}"`, instead of {replaced}:\n\n{_TABLE}{rows}'


def _row(key: Key) -> str:
    must = ", ".join(filter(None, [key.kinds[0], key.allowed]))
    if key.allowed_inside:
        must += f"; each {'of them' if 'text' in key.kinds else 'number'} {key.allowed_inside}"
    default = "required" if key.required else "" if key.default in (None, "") else f"`{shown(key.default)}`"
    return f"| `{last(key.name)}` | {key.unit} | {must} | {default} | {key.meaning} |\n"


if __name__ == "__main__":
    print(page(), end="")
