"""Random gears, pairs, sets, racks and trains through the commands: `python -m tests.studies.gear_kinds --cases 500`.

Of ten cases two are single gears, two pairs and two planetary sets by flags; four are design files of trains whose
stages are spur, helical, internal, planetary or a rack. In a tenth of all one number is absurd. What it asks:

- no command ends in an error of the program, or in files that its own readers do not take;
- a refusal names what is wrong, and what it says to give, put in, is not refused for the same reason;
- what is made has the ratio and the number of parts that the numbers ask for.
"""

from __future__ import annotations

import io
import json
import random
import re
import sys
import tempfile
import traceback
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tests.studies.command import PAGES, options, tell

RECORD = PAGES / "gear_kinds.md"
ABSURD = (-1, 0, 1e-9, 3, 1e9, 0.5)
STEP_EACH = 3  # cases are written as STEP once in so many, and else as STL or tables
CURES = 3  # that are tried in turn, for a cure may lead to the next refusal


@dataclass(frozen=True)
class Case:
    """One case: the command, and its flags, or the keys of the [train] of its design."""

    number: int
    command: str
    given: dict[str, Any]


def case(seed: int, number: int) -> Case:
    rng = random.Random(f"kinds/{seed}/{number}")
    kind = ("gear", "gear", "pair", "pair", "planetary", "planetary", "train", "train", "train", "train")[number % 10]
    made = {"gear": _gear, "pair": _pair, "planetary": _planetary, "train": _train}[kind](rng)
    if rng.random() < 0.1:
        _spoil(made, rng)
    return Case(number, {"train": "gears"}.get(kind, kind), made)


def _sizes(rng: random.Random) -> dict[str, Any]:
    module = rng.choice((0.5, 0.8, 1.0, 1.5, 2.0))
    sizes: dict[str, Any] = {"module": module, "width": round(max(module * rng.uniform(4, 10), 4.5), 1)}
    if rng.random() < 0.4:
        sizes["helix-deg"] = rng.choice((8.0, 15.0, 20.0, 30.0))
    if rng.random() < 0.2:
        sizes["grade"] = rng.choice((5, 6, 8, 9))
    return sizes


def _gear(rng: random.Random) -> dict[str, Any]:
    flags = {"teeth": rng.randint(8, 70), **_sizes(rng)}
    if rng.random() < 0.35:
        flags |= {"internal": True, "teeth": rng.randint(30, 90)}
        if rng.random() < 0.5:
            flags["cutter-teeth"] = rng.choice((0, 12, 20, 25))
    elif rng.random() < 0.5:
        flags["bore"] = round(flags["module"] * flags["teeth"] * rng.uniform(0.1, 0.7), 1)
    if rng.random() < 0.4:
        flags["profile-shift"] = round(rng.uniform(-0.4, 0.8), 2)
    return flags


def _pair(rng: random.Random) -> dict[str, Any]:
    small = rng.randint(9, 30)
    flags = {**_sizes(rng), "teeth": f"{small},{rng.randint(small, 70)}"}
    if rng.random() < 0.4:
        flags |= {"internal": True, "teeth": f"{small},{small + rng.randint(3, 40)}"}
    if rng.random() < 0.4:
        flags["profile-shift"] = f"{rng.uniform(-0.2, 0.6):.2f},{rng.uniform(-0.4, 0.4):.2f}"
    if rng.random() < 0.3:
        flags["backlash-um"] = rng.choice((0, 30, 80, 150, 400))
    return flags


def _planetary(rng: random.Random) -> dict[str, Any]:
    sun, planet = rng.randint(12, 36), rng.randint(12, 36)
    flags = {**_sizes(rng), "sun": sun, "planet": planet, "planets": rng.randint(1, 6)}
    if rng.random() < 0.3:
        flags["ring"] = sun + 2 * planet + rng.choice((-2, -1, 1, 2))
    if rng.random() < 0.3:
        flags["held"] = rng.choice(("ring", "carrier", "sun"))
    if rng.random() < 0.4:
        flags["unequal"] = True
    if rng.random() < 0.4:
        flags["bore"] = f"{flags['module'] * sun / 4:.1f},{flags['module'] * planet / 4:.1f},0"
    return flags


def _train(rng: random.Random) -> dict[str, Any]:
    module = rng.choice((0.8, 1.0, 1.5))
    train: dict[str, Any] = {"module_mm": module, "width_mm": 8.0, "bearing_span_mm": 120.0, "stages": []}
    count = rng.choice((1, 1, 2, 2, 3))
    for place in range(count):
        kinds = ["spur", "helical", "planetary"] + (["rack", "internal"] if place == count - 1 else [])
        train["stages"].append(_stage(rng, rng.choice(kinds), module))
    if rng.random() < 0.5:
        bore = rng.choice((2.0, 3.0, 4.0))
        train |= {place: {"bore_diameter_mm": bore} for place in ("drive", "intermediate")}
    return train


def _stage(rng: random.Random, kind: str, module: float) -> dict[str, Any]:
    small = rng.randint(14, 26)
    if kind == "planetary":
        planet = {"teeth": rng.randint(14, 30), "count": rng.randint(1, 5), "bore_diameter_mm": 3.0}
        stage: dict[str, Any] = {"kind": "planetary", "sun": {"teeth": small}, "planet": planet}
        if rng.random() < 0.4:
            stage["spacing"] = "nearest"
        if rng.random() < 0.3:
            stage["held"] = rng.choice(("carrier", "sun"))
        return stage
    if kind == "rack":
        stage = {"kind": "rack", "driver": {"teeth": small}, "rack": {"teeth": rng.randint(8, 30)}}
        if rng.random() < 0.4:
            stage["travel_mm"] = float(rng.randint(10, 90))
        return stage
    stage = {"driver": {"teeth": small}, "driven": {"teeth": rng.randint(small, 60)}}
    if kind == "internal":
        stage["driven"] = {"teeth": small + rng.randint(5, 35), "internal": True}
    if kind == "helical":
        stage["helix_angle_deg"] = rng.choice((10.0, 20.0, 30.0))
        if rng.random() < 0.2:
            stage["driven"]["hand"] = stage["driver"]["hand"] = "left"
    if rng.random() < 0.3:
        stage["backlash_um"] = float(rng.choice((50, 100, 250)))
    return stage


def _spoil(given: dict[str, Any], rng: random.Random) -> None:
    """Make one number of the flags or keys absurd."""
    table = given
    while True:
        key = rng.choice(sorted(table))
        inner = rng.choice(table[key]) if isinstance(table[key], list) else table[key]
        if not isinstance(inner, dict):
            break
        table = inner
    if not isinstance(table[key], bool):
        table[key] = rng.choice(ABSURD)


# ---------------------------------------------------------------- running


def arguments(made: Case, folder: Path) -> list[str]:
    """Command line of a case."""
    if made.command == "gears":
        file = folder / "case.toml"
        file.write_text(_toml(made.given), encoding="utf-8")
        formats = "csv" if made.number % STEP_EACH else "step,csv"
        return ["gears", str(file), "--formats", formats, "--out", str(folder / "out")]
    flags = [
        text
        for key, value in made.given.items()
        for text in ([f"--{key}"] if value is True else [f"--{key}", str(value)])
    ]
    formats = "stl" if made.number % STEP_EACH else "step"
    return [made.command, *flags, "--formats", formats, "--out", str(folder / "out")]


def _toml(train: dict[str, Any]) -> str:
    def table(values: dict[str, Any]) -> str:
        return "{ " + ", ".join(f"{key} = {value(each)}" for key, each in values.items()) + " }"

    def value(each: Any) -> str:
        return table(each) if isinstance(each, dict) else json.dumps(each)

    lines = ["[train]", *(f"{key} = {value(each)}" for key, each in train.items() if key != "stages")]
    for stage in train["stages"]:
        lines += ["[[train.stages]]", *(f"{key} = {value(each)}" for key, each in stage.items())]
    return "\n".join(lines) + "\n"


def outcome(made: Case) -> tuple[int, str]:
    """Exit code of a case's command, and what it prints; code 3 for an error of the program."""
    from cadgen.cli import main

    with tempfile.TemporaryDirectory() as folder:
        line, out = arguments(made, Path(folder)), io.StringIO()
        before, code = sys.argv, 3
        try:
            sys.argv = ["cadgen", *line]
            with redirect_stdout(out), redirect_stderr(out):
                main()
        except SystemExit as leave:
            code = leave.code if isinstance(leave.code, int) else int(leave.code is not None)
        except BaseException:
            out.write(traceback.format_exc(limit=-3))
        finally:
            sys.argv = before
    said = " ".join(out.getvalue().split())
    return (3 if "a fault in cadgen" in said or "report this" in said else code), said


# ---------------------------------------------------------------- cures


def cured(made: Case, said: str) -> Case | None:
    """Case with what a refusal says to give; None where the study does not find it in the sentence."""
    given = json.loads(json.dumps(made.given))
    train, number = made.command == "gears", re.search(r"in stage (\d+)|of stage (\d+)|stage (\d+)[,. ]", said)
    stage = (
        given["stages"][min(int(next(filter(None, number.groups()))), len(given["stages"])) - 1]
        if (train and number)
        else given
    )
    pairs = {"width": "width_mm", "backlash-um": "backlash_um"}

    def put(key: str, value: Any, table: dict[str, Any] | None = None) -> Case:
        (stage if table is None else table)[pairs.get(key, key) if train else key] = value
        return replace(made, given=given)

    def found(pattern: str) -> tuple[str, ...] | None:
        match = re.search(pattern, said)
        return (match.groups() or (match[0],)) if match else None

    if got := found(r"planets \(planet\.count\) = (\d+)"):
        return put("count", int(got[0]), stage["planet"]) if train else put("planets", int(got[0]))
    if got := found(r"give rack\.teeth = (\d+)"):
        return put("teeth", int(got[0]), stage["rack"])
    if got := found(r"train\.(\w+)\.shaft_ends = true"):
        return put("shaft_ends", True, given.setdefault(got[0], {}))
    if got := found(r"give the ring at least (\d+) teeth, at a centre_distance_mm of ([\d.]+)"):
        if train:
            stage["driven"]["teeth"] = int(got[0])
            return put("centre_distance_mm", float(got[1]))
        given["teeth"] = f"{given['teeth'].partition(',')[0]},{got[0]}"
        return put("centre-distance-mm", float(got[1]))
    if got := found(r"give the ring (?:at least|about) (\d+) teeth"):
        if made.command == "planetary":
            return put("ring", int(got[0]))
        if train:
            table = stage.setdefault("ring", {}) if stage.get("kind") else stage["driven"]
            return put("teeth", int(got[0]), table)
        return put("teeth", f"{given['teeth'].partition(',')[0]},{got[0]}")
    if got := found(r'give the driven gear hand = "(\w+)"'):
        return put("hand", got[0], stage["driven"])
    if got := found(r"a backlash of (\d+) µm leaves some"):
        if train:  # of the stage that jams, which is one of those that ask for less
            for each in given["stages"]:
                if "backlash_um" in each:
                    each["backlash_um"] = max(each["backlash_um"], int(got[0]))
            return replace(made, given=given)
        return put("backlash-um", int(got[0]))
    if got := found(r"make the stage of a ring the last one|must be the last"):
        inside = [each for each in given["stages"] if each.get("driven", {}).get("internal")]
        given["stages"] = [each for each in given["stages"] if each not in inside] + inside[:1]
        for each in given["stages"]:
            each.pop("held", None)
        return replace(made, given=given)
    if found(r"or standard free for"):
        return put("standard", "free", given)
    if got := found(r"--([a-z-]+) is [^;]*; give ([-\d.e+]+) to ([-\d.e+]+)"):
        return put(got[0], min(float(got[1]) + 100.0, float(got[2])))
    if got := found(r"--([a-z-]+) is .* such as ([\d.,]+)"):
        return put(got[0], int(got[1]) if got[1].isdigit() else got[1])
    if got := found(r'stages\.(\d+)\.spacing is [^;]*; it must be "equal" or "(nearest)"'):
        return put("spacing", got[1], given["stages"][int(got[0]) - 1])
    if got := found(r"give both gears addendum_factor = ([\d.]+)"):
        return put("addendum_factor" if train else "addendum-factor", float(got[0]), given)
    if got := found(r"give the profile shifts (-?[\d.]+) and (-?[\d.]+)"):
        return _for_gears(made, given, stage, "profile_shift", dict(enumerate(map(float, got))), by_place=True)
    if got := found(r"give (\d+) and (\d+) teeth"):
        return _for_gears(made, given, stage, "teeth", dict(enumerate(map(int, got))), by_place=True)
    if got := found(r"(?:gear|ring) with (\d+) teeth .*give (profile_shift|addendum_factor|teeth) = (-?[\d.]+)"):
        value = int(got[2]) if got[1] == "teeth" else float(got[2])
        return _for_gears(made, given, stage, got[1], {int(got[0]): value})
    if got := found(r"centre_distance_mm = ([\d.]+)"):
        return put("centre_distance_mm" if train else "centre-distance-mm", float(got[0]))
    if got := found(r"has cutter_teeth = .* give (\d+)"):
        return put("cutter_teeth" if train else "cutter-teeth", int(got[0]))
    if found(r"face width"):
        return put("width", 8.0, given if train else None)
    if got := found(r"bearing span of .* give at least ([\d.]+) mm"):
        return put("bearing_span_mm", float(got[0]) + 1, given)
    if got := found(r"(?:bore|hub|hole).*(?:keep it within|give) ([\d.]+)"):
        return put("bore", str(float(got[0]) * 0.9))
    if got := found(
        r"([\w.-]+) is [^;]*; it must be (?:a (?:whole )?number,? |0, or )?(?:from|at least|greater than) ([-\d.e]+)"
    ):
        return _placed(made, given, got[0], float(got[1]), said)
    if train and found(r"held = \"ring\""):
        for each in given["stages"]:
            each.pop("held", None)
        return replace(made, given=given)
    if got := found(r"remove (\w+)"):
        for table in (stage, given, *(each for each in stage.values() if isinstance(each, dict))):
            if table.pop(got[0], None) is not None:
                return replace(made, given=given)
    return None


def _for_gears(
    made: Case,
    given: dict[str, Any],
    stage: dict[str, Any],
    key: str,
    values: dict[int, Any],
    *,
    by_place: bool = False,
) -> Case | None:
    """Case with a key of its gears at other values, by their numbers of teeth or by their places."""
    if made.command != "gears":
        flag, names = key.replace("_", "-"), ("sun", "planet", "ring")
        if made.command == "planetary" and key == "teeth":
            return None
        if made.command == "planetary":
            teeth = [given.get(name, 0) for name in names]
        else:
            teeth = [int(part) for part in str(given["teeth"]).split(",")]
        usual = "1" if key == "addendum_factor" else "0"
        parts = str(given.get(flag, usual)).split(",")
        parts = parts * len(teeth) if len(parts) == 1 else parts
        if key == "teeth":
            parts = [str(each) for each in teeth]
        for place, number in enumerate(teeth):
            if (place if by_place else number) in values:
                parts[place] = str(values[place if by_place else number])
        given[flag] = ",".join(parts)
        return replace(made, given=given)
    stages = [stage] if by_place else given["stages"]
    changed = False
    for each in stages:
        for place, role in enumerate(
            ("sun", "planet", "ring") if each.get("kind") == "planetary" else ("driver", "driven")
        ):
            gear = each.get(role)
            if gear and (place if by_place else gear.get("teeth")) in values:
                gear[key] = values[place if by_place else gear["teeth"]]
                changed = True
    return replace(made, given=given) if changed else None


def _placed(made: Case, given: dict[str, Any], key: str, least: float, said: str) -> Case | None:
    """Case with a key at a value that its limits allow."""
    most = re.search(r"at most ([-\d.e+]+)|to ([-\d.]+)", said)
    high = float(next(filter(None, most.groups()))) if most else least + 10
    value = min(max(least + 1, 8.0), high)
    path = key.removeprefix("train.").split(".") if made.command == "gears" else [key.replace("_", "-").lower()]
    table: Any = given
    for part in path[:-1]:
        table = table[int(part) - 1] if part.isdigit() else table[part]
    if path[-1] not in table:
        path = [*path[:-1], path[-1].removesuffix("-mm")]
    whole = isinstance(table.get(path[-1]), int) or "whole number" in said
    table[path[-1]] = int(value) if whole else value
    return replace(made, given=given)


def reason(said: str) -> str:
    """Sentence of a refusal without its numbers, by which two are compared."""
    tail = said.rpartition("cadgen: ")[2] if "cadgen: " in said else said.rpartition("where")[2]
    return re.sub(r"(?<!stage )[-\d.]+", "#", tail)[:160]


def judged(seed: int, number: int) -> tuple[str, str]:
    """Kind of outcome of a case, and what is wrong with it or not understood."""
    made = case(seed, number)
    code, said = outcome(made)
    if code == 3:
        return "fault", said[-600:]
    if code == 0:
        return "made", ""
    kind, first = ("refused" if code == 2 else "failed a check"), said
    for _ in range(CURES):
        better = cured(made, said)
        if better is None:
            return f"{kind}, no value", reason(said)
        again, then = outcome(better)
        if again == 3:
            return "fault", f"after {better.given}: {then[-600:]}"
        if again == 0:
            return f"{kind}, cured", ""
        if reason(then) == reason(said):
            return f"{kind}, not cured", f"{said[-300:]} -> {better.given}: {then[-300:]}"
        made, said = better, then
    return f"{kind}, another refusal after {CURES} cures", reason(first)


def run(seed: int, cases: int, workers: int) -> list[tuple[int, str, str]]:
    """Number, kind and fault of every case."""
    numbers = range(cases)
    if workers == 1:
        return [(number, *judged(seed, number)) for number in numbers]
    with ProcessPoolExecutor(workers) as pool:
        found = pool.map(judged, [seed] * cases, numbers, chunksize=5)
        return [(number, *each) for number, each in zip(numbers, found, strict=True)]


def page(seed: int, found: list[tuple[int, str, str]]) -> str:
    """The record in Markdown."""
    from cadgen import __version__

    counts = Counter(kind for _, kind, _ in found)
    rows = "".join(f"| {kind} | {count} |\n" for kind, count in sorted(counts.items()))
    wrong = [
        f"- case {number} ({kind}): {what}\n" for number, kind, what in found if "fault" in kind or "not cured" in kind
    ]
    open_ends = Counter(what for _, kind, what in found if kind.endswith("no value"))
    listed = "".join(f"- {count} × {what}\n" for what, count in open_ends.most_common())
    return (
        "# Study: gears of all kinds through the commands\n\n"
        "Random gears, pairs and planetary sets by flags, and design files of trains of mixed kinds with planetary\n"
        "stages and racks, a tenth with an absurd number (`tests/studies/gear_kinds.py`). Files are written and read\n"
        "back, every third case as STEP. What a refusal says to give is put in and tried again.\n\n"
        f"`python -m tests.studies.gear_kinds --cases {len(found)} --seed {seed} --record`, cadgen {__version__}\n\n"
        f"| outcome | cases |\n|---|---|\n{rows}| cases | {len(found)} |\n\n"
        + (
            "".join(wrong)
            if wrong
            else "No fault of the program, no file that its readers refuse, every value helps.\n"
        )
        + (f"\nRefusals in which the study finds no value to put in:\n\n{listed}" if listed else "")
    )


def main() -> None:
    args = options(__doc__, cases=500)
    tell(page(args.seed, run(args.seed, args.cases, args.processes)), RECORD if args.record else None)


if __name__ == "__main__":
    main()
