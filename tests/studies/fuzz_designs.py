"""Fuzzed designs: the packaged ones with one to three things changed, each reproducible from seed and number.

The first cases are systematic: each numeric key at either end of its range. What a key is and
where its range ends is read from the schema; which of these designs can be is what is to be found out.
Deep cases have mostly changes that the reader takes, of any number that the design has.
"""

import copy
import math
import random
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import tomli_w

from cadgen.cam.followers.rod_kind import ROD
from cadgen.design.follower import section_of
from cadgen.design.load import DEFAULT_DESIGN, packaged_designs
from cadgen.design.schema import DesignFile
from cadgen.design.train import stage_section

Place = tuple[str | int, ...]

# Sections that the packaged designs lack, as they might stand in a file.
SECTIONS: dict[Place, Any] = {
    ("blank", "hub"): {
        "diameter_mm": 20.0,
        "length_mm": 10.0,
        "side": "outer",
        "set_screw": {"hole_diameter_mm": 3.0, "height_mm": 5.0, "angle_deg": 90.0},
    },
    ("blank", "d_flat"): {"across_mm": 7.0, "angle_deg": 10.0},
    ("play",): {"least_deg": 0.4, "greatest_deg": 0.9, "measured_deg": 0.7},
    ("train", "search"): {
        "stages": 2,
        "teeth_min": 12,
        "teeth_max": 60,
        "modules_mm": [0.5],
        "widths_mm": [5.0],
        "centre_distance_min_mm": 5.0,
        "centre_distance_max_mm": 60.0,
        "stage_ratio_min": 2.0,
        "stage_ratio_max": 10.0,
        "ratio_tolerance": 0.01,
        "keep": 5,
    },
    ("as_built",): {
        "profile": "actual",
        "sources": [{"file": "track.csv", "kind": "track", "sha256": "0" * 64, "verdict": "traced"}],
        "effects": [
            {
                "effect": "steering zero",
                "kind": "track",
                "place": "car",
                "values": [{"name": "steering_zero_deg", "value": 0.3, "sigma": 0.01}],
            },
            {
                "effect": "eccentric bore",
                "kind": "lift",
                "place": "process",
                "values": [{"name": "eccentric_x_um", "value": 20.0}, {"name": "eccentric_y_um", "value": -10.0}],
            },
        ],
    },
}
# Sections of deep cases besides these.
DEEP_SECTIONS: dict[Place, Any] = {
    **SECTIONS,
    ("mechanics",): {"friction_least": 0.05, "friction_greatest": 0.2, "rod_force_N": 1.5, "drag_greatest_Nmm": 20.0},
    ("field",): {"size_mm": [8000.0, 8000.0], "obstacles_mm": [[1000.0, 2000.0]]},
    ("blank", "edge_break_mm"): 0.2,
    ("cam", "side"): "right",
    ("checks", "lost_lift_effect_mm"): 0.2,
    ("tolerances", "gate_width_mm"): 200.0,
    ("optimize", "max_end_position_mm"): 200.0,
}
# The least course that `cadgen plan` has something to do on: with it a plan takes seconds.
SHORT_COURSE: dict[str, Any] = {
    "margin_mm": 20.0,
    "field": {"corner_mm": [-500.0, -1000.0], "size_mm": [4500.0, 2000.0]},
    "start": {"at_mm": [0.0, 0.0], "heading_deg": 0.0},
    "posts": [{"at_mm": [1000.0, 0.0], "radius_mm": 10.0, "side": "left"}],
    "gates": [{"at_mm": [1800.0, 0.0], "radius_mm": 60.0}],
    "finish": {"at_mm": [2800.0, 0.0], "radius_mm": 300.0},
}
# A cam by its motion.
MOTION: dict[str, Any] = {
    "name": "feeder",
    "motion": {
        "turns": "clockwise",
        "speed_rpm": 420,
        "segments": [
            {"to_mm": 14.0, "in_deg": 80.0, "law": "polynomial_3_4_5"},
            {"dwell_deg": 50.0},
            {"to_mm": 0.0, "in_deg": 110.0, "law": "cycloidal"},
            {"dwell_deg": 120.0},
        ],
    },
    "follower": {"kind": "roller", "radius_mm": 9.0, "offset_mm": 8.0},
    "cam": {"base_circle_radius_mm": 32.0, "thickness_mm": 10.0},
}
STILL_READ = 0.93  # share of the changes of deep cases that a reader may take
STRANGE: tuple[Any, ...] = (
    "", "0", "nan", "1e3", "ä ☃ 車", "\\", "[", "x" * 5000, "../../etc/passwd", True, False, [], {}, [[]], [1], [1, 2],
    [1, 2, 3], ["a"], [[0, 0]] * 3, {"a": {"b": 1}}, [{}], [{"teeth": 20}], float("nan"), float("inf"), -float("inf"),
    0, 0.0, -0.0, -1, 1e-300, 1e300, -1e300, 10**30, 2**63, 1.5, 1e-12, 1e12,
)  # fmt: skip
NAMES = ("extra", "thickness", "cam", "Base_Radius_MM", "длина", "a.b", "", " ", "x" * 3000, "waypoints_m", "teeth ")


@dataclass(frozen=True)
class Key:
    """A key of the schema: its place (an item of a list of sections is `0`), type, ends of its range, choices."""

    place: Place
    kind: str
    low: float | None = None
    high: float | None = None
    choices: tuple[str, ...] = ()


@dataclass(frozen=True)
class Case:
    """A design file's bytes, `--set` arguments, and what was changed, in words."""

    content: bytes
    overrides: tuple[str, ...]
    changes: tuple[str, ...]


@cache
def keys() -> tuple[Key, ...]:
    """Every key of the schema."""
    schema = DesignFile.model_json_schema()
    # The keys of a follower are those of the kind that a file names, or of the rod.
    follower = section_of(ROD).model_json_schema()
    schema["properties"]["follower"] = follower
    # Those of a stage are those of spur gears.
    stage = stage_section(None).model_json_schema()
    defs = {**schema["$defs"], **follower["$defs"], **stage["$defs"], "StageSection": stage}
    return tuple(_walk(schema, defs, ()))


def _walk(node: dict[str, Any], defs: dict[str, Any], place: Place) -> Iterator[Key]:
    if "$ref" in node:
        node = {**defs[node["$ref"].rpartition("/")[2]], **{k: v for k, v in node.items() if k != "$ref"}}
    arms = [arm for arm in node.get("anyOf", []) if arm.get("type") != "null"]
    if arms:
        yield from _walk(arms[0], defs, place)
    elif "properties" in node:
        for name, below in node["properties"].items():
            yield from _walk(below, defs, (*place, name))
    elif node.get("type") == "array" and _is_table(node.get("items"), defs):
        yield from _walk(node["items"], defs, (*place, 0))
    else:
        low = node.get("minimum", node.get("exclusiveMinimum"))
        high = node.get("maximum", node.get("exclusiveMaximum"))
        choices = tuple(node.get("enum", ())) or ((node["const"],) if "const" in node else ())
        yield Key(place, node.get("type", "string"), low, high, choices)


def _is_table(node: Any, defs: dict[str, Any]) -> bool:
    if not isinstance(node, dict):
        return False
    if "$ref" in node:
        return "properties" in defs[node["$ref"].rpartition("/")[2]]
    return "properties" in node


DATA = Path(__file__).parents[1] / "data"
_BASES = ("appendix_car", "carbon_free_car", "workshop_car")


@cache
def bases(names: tuple[str, ...] = _BASES) -> dict[str, dict[str, Any]]:
    """Packaged designs, or designs of `tests/data` by their paths there, as parsed TOML."""
    packaged = packaged_designs()
    made = {"motion": MOTION}
    return {name: made.get(name) or tomllib.loads(packaged.get(name, DATA / name).read_text()) for name in names}


@cache
def edges() -> tuple[tuple[Key, float], ...]:
    """Either end of the range of each numeric key."""
    return tuple((key, end) for key in keys() for end in (key.low, key.high) if end is not None)


def case(seed: int, number: int, *, searching: bool = False, deep: tuple[str, ...] = ()) -> Case:
    """A case of its seed and number.

    Args:
        seed, number: that it is made from, and can be made again.
        searching: for `gears --order search`: more changes of [train.search].
        deep: from these designs instead, without the systematic cases, and mostly with changes that the reader takes,
            so that what is behind it is reached.
    """
    rng = random.Random(f"{seed}/{number}")
    if number < len(edges()) and not deep:
        key, end = edges()[number]
        values = copy.deepcopy(bases()[DEFAULT_DESIGN])
        # An end that the range excludes is approached.
        if key.kind == "number" and end == 0:
            end = rng.choice([0.0, 1e-9, 1e-6, 1e-3])
        _put(values, key.place, int(end) if key.kind == "integer" else float(end))
        return Case(tomli_w.dumps(values).encode(), (), (f"{_name(key.place)} = {end!r}",))
    designs = bases(deep or _BASES)
    name = rng.choices(list(designs), weights=[1 if name == "appendix_car" else 5 for name in designs])[0]
    values, changes, overrides = copy.deepcopy(designs[name]), [name], []
    if deep and rng.random() < 0.3 and values.pop("course", None):
        values.pop("settings", None)
        changes.append("without course")
    for place, section in (DEEP_SECTIONS if deep and "path" in values else SECTIONS).items():
        if deep and _excluded(place, values):
            continue
        if rng.random() < 0.06 or (searching and place == ("train", "search")):
            _put(values, place, copy.deepcopy(section))
            changes.append(f"with {_name(place)}")
    for _ in range(rng.choices([1, 2, 3], weights=[5, 3, 2])[0]):
        number_change, path_change = (
            (_mild, _points_moved) if deep and rng.random() < STILL_READ else (_numeric, _waypoints)
        )
        if "path" not in values:
            path_change = _mild
        change = rng.choices(
            [number_change, _choice, path_change, _wrong, _without, _unknown, _items],
            [60, 6, 14, 8, 5, 3, 4] if number_change is _numeric else [80, 3, 14, 0, 2, 0, 1],
        )
        what, place, value = change[0](rng, values)
        changes.append(what)
        if place and rng.random() < 0.1 and not isinstance(value, dict):
            _take(values, place)
            overrides.append(f"{'.'.join(str(p + 1 if isinstance(p, int) else p) for p in place)}={_toml(value)}")
    text = tomli_w.dumps(values).encode()
    if rng.random() < 0.01:
        what, text = _damaged(rng, text)
        changes.append(what)
    return Case(text, tuple(overrides), tuple(changes))


Change = tuple[str, Place, Any]


def _numeric(rng: random.Random, values: dict[str, Any]) -> Change:
    """A number within its range, at or just beyond an end, or far out; more of those keys that a cam has."""
    numeric = [key for key in keys() if key.kind in ("number", "integer")]
    shape = [key for key in numeric if key.place[0] in ("cam", "follower", "car", "path", "checks", "export", "blank")]
    key = rng.choice(shape if rng.random() < 0.6 else numeric)
    place = _somewhere(rng, values, key.place)
    low = key.low if key.low is not None else -1e9
    high = key.high if key.high is not None else 1e9
    now = _get(values, place)
    draw = rng.random()
    value: float
    if draw < 0.35 and isinstance(now, (int, float)) and not isinstance(now, bool):
        value = now * rng.choice([rng.uniform(0.9, 1.1), rng.uniform(0.3, 3)])
    elif draw < 0.7:
        value = _within(rng, low, high)
    elif draw < 0.9:
        end = rng.choice([low, high])
        value = rng.choice([end, math.nextafter(end, 1e99), math.nextafter(end, -1e99), end * 1.01, end * 0.99])
    else:
        value = rng.choice([0.0, -1.0, 1e-300, 1e-12, 1e-6, 1e12, 1e300, float("nan"), float("inf"), -float("inf")])
    if key.kind == "integer" and math.isfinite(value) and abs(value) < 1e18 and rng.random() < 0.9:
        value = round(value)
    _put(values, place, value)
    return f"{_name(place)} = {value!r}", place, value


def _mild(rng: random.Random, values: dict[str, Any]) -> Change:
    """A number that the file has, changed a little or much within its range; each section as often as another."""
    sections = [section for section, below in values.items() if list(_leaves(below, ()))]
    section = rng.choice(sections)
    place = (section, *rng.choice(list(_leaves(values[section], ()))))
    now, (low, high) = _get(values, place), _range(tuple(0 if isinstance(part, int) else part for part in place))
    value = float(now) * rng.choice([rng.uniform(0.95, 1.05), rng.uniform(0.95, 1.05), rng.uniform(0.3, 3)]) or 0.01
    if isinstance(now, int):
        value = round(value)
    value = min(max(value, low), high)
    _put(values, place, value)
    if place[-1] in ("in_deg", "dwell_deg"):  # the last dwell takes what the other segments leave of the turn
        segments = values["motion"]["segments"]
        angles = [
            segment.get("in_deg", segment.get("dwell_deg")) for segment in segments[:-1] if isinstance(segment, dict)
        ]
        taken = sum(angle for angle in angles if isinstance(angle, (int, float)))
        _put(values, ("motion", "segments", len(segments) - 1), {"dwell_deg": 360.0 - taken})
    return f"{_name(place)} = {value!r}", place, value


def _excluded(place: Place, values: dict[str, Any]) -> bool:
    """Whether a design has what cannot stand beside a section."""
    against: dict[Place, Place] = {
        ("blank", "d_flat"): ("blank", "keyway"),
        ("tolerances", "gate_width_mm"): ("course", "gates"),
        ("train", "search"): ("motion",),
        ("play",): ("motion",),
        ("as_built",): ("motion",),
    }
    return place in against and bool(_get(values, against[place]))


def _leaves(values: Any, place: Place) -> Iterator[Place]:
    """Places of the numbers in tables; those in lists, such as points, are not among them."""
    if isinstance(values, dict):
        for key, below in values.items():
            if isinstance(below, (int, float)) and not isinstance(below, bool):
                yield (*place, key)
            else:
                yield from _leaves(below, (*place, key))
    elif isinstance(values, list):
        for number, below in enumerate(values):
            if isinstance(below, dict):
                yield from _leaves(below, (*place, number))


def _range(place: Place) -> tuple[float, float]:
    """Range of a key; all numbers of one that the schema does not have, such as those of other followers."""
    found = next((key for key in keys() if key.place == place), Key(place, "number"))
    return found.low if found.low is not None else -1e9, found.high if found.high is not None else 1e9


def _points_moved(rng: random.Random, values: dict[str, Any]) -> Change:
    """All points that the path goes by moved a little, or one of them more."""
    path = values["path"]
    name = "control_points_mm" if "control_points_mm" in path else "waypoints_mm"
    size, one = 10 ** rng.uniform(-3, 2), rng.choice([None, rng.randrange(len(path[name]))])
    path[name] = [
        [x + rng.gauss(0, size), y + rng.gauss(0, size)] if one in (None, n) else [x, y]
        for n, (x, y) in enumerate(path[name])
    ]
    return f"{name} moved by {size:.2g}", (), None


def _within(rng: random.Random, low: float, high: float) -> float:
    """A number within a range, even or even in its logarithm."""
    if rng.random() < 0.5:
        return rng.uniform(low, high)
    size = 10 ** rng.uniform(-6, math.log10(max(abs(low), abs(high), 1e-5)))
    return min(max(size if low >= 0 or rng.random() < 0.5 else -size, low), high)


def _choice(rng: random.Random, values: dict[str, Any]) -> Change:
    key = rng.choice([key for key in keys() if key.choices])
    value = rng.choice([*key.choices, "none"])
    place = _somewhere(rng, values, key.place)
    _put(values, place, value)
    return f"{_name(place)} = {value}", place, value


def _waypoints(rng: random.Random, values: dict[str, Any]) -> Change:
    """Another path: moved, scaled, thinned, dense, straight, round, with equal or extreme points."""
    points = [(float(x), float(y)) for x, y in values["path"]["waypoints_mm"]] if _path_is_sound(values) else PATH
    _take(values, ("path", "control_points_mm"))
    # A path of thousands of points takes long whatever it is; few of those are enough.
    many = rng.choice([50, 100, 300, 1000]) if rng.random() < 0.9 else rng.choice([3000, 10_000, 30_000])
    close = 10 ** rng.uniform(-9, -1)
    moves: dict[str, Callable[[], Any]] = {
        "moved": lambda: [[x + rng.gauss(0, 150), y + rng.gauss(0, 150)] for x, y in points],
        "one moved far": lambda: _with(points, rng.randrange(len(points)), [rng.gauss(0, 1e4), rng.gauss(0, 1e4)]),
        "scaled": lambda: (lambda f: [[x * f, y * f] for x, y in points])(10 ** rng.uniform(-3, 3)),
        "stretched": lambda: (lambda f: [[x * f, y] for x, y in points])(10 ** rng.uniform(-2, 2)),
        "thinned": lambda: points[:: rng.choice([2, 3])],
        "first few": lambda: points[: rng.randrange(0, 6)],
        "backwards": lambda: points[::-1],
        "there and back": lambda: [*points, *points[-2::-1]],
        "equal neighbours": lambda: [*points[:3], points[2], *points[3:]],
        "almost equal neighbours": lambda: [*points[:3], (points[2][0] + close, points[2][1]), *points[3:]],
        "straight": lambda: [[100.0 * k, 0.0] for k in range(rng.choice([4, 12, 60]))],
        "straight, uneven": lambda: [[float(x), 3.0] for x in sorted(rng.uniform(0, 9000) for _ in range(12))],
        "circle": lambda: _circle(many, rng.uniform(300, 3000), rng.choice([0.5, 0.9, 1.0, 2.5])),
        "dense": lambda: _dense(points, many),
        "random walk": lambda: _walked(rng, rng.choice([10, 40, many])),
        "one not a number": lambda: _with(points, 3, [float("nan"), 0.0]),
        "one of three": lambda: _with(points, 3, [1.0, 2.0, 3.0]),
        "one text": lambda: _with(points, 3, "here"),
        "huge": lambda: [[x * 1e3, y * 1e3] for x, y in points],
        "beyond": lambda: _with(points, 3, [1e6 + 1, 0.0]),
    }  # fmt: skip
    what = rng.choice(list(moves))
    value = moves[what]()
    _put(values, ("path", "waypoints_mm"), value)
    return f"waypoints {what} ({len(value)})", (), None


def _wrong(rng: random.Random, values: dict[str, Any]) -> Change:
    place = _somewhere(rng, values, rng.choice(keys()).place)
    if rng.random() < 0.3:
        place = place[: rng.randrange(1, len(place) + 1)]
    value = copy.deepcopy(rng.choice(STRANGE))
    _put(values, place, value)
    return f"{_name(place)} = {str(value)[:40]!r}", place, value


def _without(rng: random.Random, values: dict[str, Any]) -> Change:
    place = _somewhere(rng, values, rng.choice(keys()).place)
    place = place[: rng.randrange(1, len(place) + 1)]
    _take(values, place)
    return f"without {_name(place)}", (), None


def _unknown(rng: random.Random, values: dict[str, Any]) -> Change:
    place = rng.choice(keys()).place
    place = (*place[: rng.randrange(0, len(place))], rng.choice(NAMES))
    _put(values, place, rng.choice([1.0, "text", [1], {}]))
    return f"unknown {_name(place)[:60]}", (), None


def _items(rng: random.Random, values: dict[str, Any]) -> Change:
    """A list of sections with items taken out, doubled or many."""
    place = rng.choice([("train", "stages"), ("as_built", "effects"), ("as_built", "sources"), ("course", "gates")])
    now = _get(values, place)
    if not isinstance(now, list) or not now:
        return f"{_name(place)} left as it is", (), None
    count = rng.choice([0, 1, 2, 5, 6, 7, 12, 100])
    _put(values, place, [copy.deepcopy(now[k % len(now)]) for k in range(count)])
    return f"{count} of {_name(place)}", (), None


def course(seed: int, number: int) -> Case:
    """A case for `cadgen plan`: mostly a short course for a small car, else a packaged course."""
    rng = random.Random(f"{seed}/course/{number}")
    name = rng.choices(["s_course", "posts_and_walls", "figure_eight"], weights=[18, 1, 1])[0]
    values, changes = copy.deepcopy(bases((name,))[name]), [name]
    if name == "s_course":
        values["course"] = copy.deepcopy(SHORT_COURSE)
        values["car"]["outline"]["wheel_diameter_mm"] = 62.0  # 15 turns of it are the way to the finish
        del values["car"]["drive_wheel_radius_mm"]
        values["tolerances"] |= {"inner_face_mm": 0.02, "outer_face_mm": 0.02}  # it steers more than they allow else
        changes.append("short")
        if rng.random() < 0.3:
            del values["path"]["control_points_mm"]
    for _ in range(rng.choices([0, 1, 2, 3], weights=[1, 5, 3, 2])[0]):
        change = _place_moved if rng.random() < 0.4 else _mild if rng.random() < 0.85 else _numeric
        changes.append(change(rng, values)[0])
    return Case(tomli_w.dumps(values).encode(), (), tuple(changes))


def _place_moved(rng: random.Random, values: dict[str, Any]) -> Change:
    """A post, gate, start or finish of the course moved a little or much."""
    course = values["course"]
    places = [item for key in ("posts", "gates") for item in course.get(key, ()) if "at_mm" in item]
    one = rng.choice([*places, *(course[key] for key in ("start", "finish") if "at_mm" in course.get(key, {}))])
    size = 10 ** rng.uniform(0, 3)
    one["at_mm"] = [round(coordinate + rng.gauss(0, size), 3) for coordinate in one["at_mm"]]
    return f"a place of the course moved by {size:.2g}", (), None


def study(seed: int, number: int) -> tuple[Case, bytes]:
    """A case for `cadgen explore`: a deep design, and a study of two or three designs about it."""
    rng = random.Random(f"{seed}/study/{number}")
    one = case(seed, number, deep=tuple(packaged_designs()))
    try:
        values = tomllib.loads(one.content.decode())
    except ValueError:
        values = copy.deepcopy(bases()[DEFAULT_DESIGN])
    kind = rng.choice(["full_factorial", "sobol", "latin_hypercube"])
    vary = []
    for _ in range(1 if kind == "full_factorial" else rng.choice([1, 2])):
        section = rng.choice([name for name, below in values.items() if list(_leaves(below, ()))])
        place = (section, *rng.choice(list(_leaves(values[section], ()))))
        now = _get(values, place)
        ends = sorted([now * rng.uniform(0.9, 1.0), now * rng.uniform(1.0, 1.2)])
        if isinstance(now, int):
            ends = [now - 1, now + rng.choice([1, 2])]
        choice = {"values": [ends[0], now]} if kind == "full_factorial" else {"least": ends[0], "most": ends[1]}
        vary.append({"key": _name(place), **choice})
    made: dict[str, Any] = {
        "base": "design.toml",
        "objectives": rng.sample(_FIGURES, rng.choice([1, 2, 3])),
        "record": rng.sample(_FIGURES, rng.choice([0, 2])),
        "cars": rng.choice([1, 50]),
        "best": rng.choice([0, 1, 3]),
        "vary": vary,
        "plan": {"kind": kind} if kind == "full_factorial" else {"kind": kind, "designs": rng.choice([1, 2, 3])},
    }
    if rng.random() < 0.3:
        made["limits"] = [{"figure": rng.choice(_FIGURES), "most": 10 ** rng.uniform(-2, 4)}]
    if rng.random() < 0.3:
        made["checks"] = []
    if rng.random() < 0.1:
        made["replan"] = {"within_mm": 0.0}
    changes = (*one.changes, f"{kind} of {', '.join(item['key'] for item in vary)}")
    return Case(one.content, (), changes), tomli_w.dumps(made).encode()


_FIGURES = (
    "worst_end_mm", "worst_end_heading_deg", "passed_percent", "disc_diameter_mm", "disc_mass_g", "holding_energy_J",
    "cutting_time_min", "return_error_deg", "drift_mm",
)  # fmt: skip


def _damaged(rng: random.Random, text: bytes) -> tuple[str, bytes]:
    at = rng.randrange(len(text))
    return rng.choice([
        (f"cut at {at}", text[:at]),
        (f"byte at {at}", text[:at] + bytes([rng.randrange(256)]) + text[at + 1 :]),
        (f"a piece twice at {at}", text[:at] + text[max(0, at - 50) :]),
        ("empty", b""),
        ("zeros", b"\0" * 100),
        ("UTF-16", text.decode().encode("utf-16")),
    ])  # fmt: skip


PATH = [(0.0, 0.0), (1000.0, 300.0), (2000.0, -300.0), (3000.0, 400.0), (4000.0, 0.0)]


def _path_is_sound(values: dict[str, Any]) -> bool:
    points = _get(values, ("path", "waypoints_mm"))
    sound = isinstance(points, list) and len(points) > 4
    return sound and all(isinstance(p, (list, tuple)) and len(p) == 2 and _finite(p) for p in points)


def _finite(point: Any) -> bool:
    return all(isinstance(c, (int, float)) and math.isfinite(c) for c in point)


def _with(points: list[Any], at: int, point: Any) -> list[Any]:
    return [*points[:at], point, *points[at + 1 :]]


def _circle(count: int, radius: float, turns: float) -> list[list[float]]:
    angles = [2 * math.pi * turns * k / count for k in range(count)]
    return [[radius * math.cos(a), radius * math.sin(a)] for a in angles]


def _dense(points: list[Any], count: int) -> list[list[float]]:
    """Points along the broken line, its corners cut by averaging."""
    dense = []
    for k in range(count):
        at = k * (len(points) - 1) / count
        i, share = int(at), at % 1
        dense.append([a + share * (b - a) for a, b in zip(points[i], points[min(i + 1, len(points) - 1)], strict=True)])
    for _ in range(3):
        inner = [
            [(a + b + c) / 3 for a, b, c in zip(*three, strict=True)]
            for three in zip(dense, dense[1:], dense[2:], strict=False)
        ]
        dense = [dense[0], *inner, dense[-1]]
    return dense


def _walked(rng: random.Random, count: int) -> list[list[float]]:
    x = y = 0.0
    heading = 0.0
    points = []
    for _ in range(count):
        points.append([x, y])
        heading += rng.gauss(0, 0.5)
        x, y = x + 400 * math.cos(heading), y + 400 * math.sin(heading)
    return points


def _somewhere(rng: random.Random, values: dict[str, Any], place: Place) -> Place:
    """The same place in any of the items that the lists on its way have."""
    found: Place = ()
    for part in place:
        items = _get(values, found)
        found = (
            *found,
            rng.randrange(len(items)) if isinstance(part, int) and isinstance(items, list) and items else part,
        )
    return found


def _get(values: Any, place: Place) -> Any:
    for part in place:
        try:
            values = values[part]
        except (KeyError, IndexError, TypeError):
            return None
    return values


def _put(values: Any, place: Place, value: Any) -> None:
    """Set a place, with the sections on its way, as far as these can be there."""
    for n, part in enumerate(place[:-1]):
        below = _get(values, (part,))
        if below is None:
            whole = copy.deepcopy(SECTIONS.get(place[: n + 1], [] if isinstance(place[n + 1], int) else {}))
            if isinstance(values, list):
                values.append(whole)
            elif isinstance(values, dict):
                values[part] = whole
            else:
                return
            below = whole
        values = below
    if isinstance(values, list) and isinstance(place[-1], int):
        values[place[-1] : place[-1] + 1] = [value]
    elif isinstance(values, dict):
        values[str(place[-1])] = value


def _take(values: Any, place: Place) -> None:
    above = _get(values, place[:-1])
    if isinstance(above, dict):
        above.pop(place[-1], None)
    elif isinstance(above, list) and isinstance(place[-1], int) and place[-1] < len(above):
        del above[place[-1]]


def _name(place: Place) -> str:
    return ".".join(str(part + 1 if isinstance(part, int) else part) for part in place)


def _toml(value: Any) -> str:
    return tomli_w.dumps({"v": value}).partition("=")[2].strip()
