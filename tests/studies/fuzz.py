"""Fuzzed designs and measured data through the command line: every run ends in the contract and within its bounds.

    python -m tests.studies.fuzz --command check --cases 10000 --seed 1 [--deep] [--log FILE] [--record] [--show N]

Every case runs in a fork of a process that has the program's modules loaded, through `cadgen.cli.main`, and is judged
by what a user sees: exit code, sentences, processor time, memory. With `--log` each outcome is kept in a file as it
comes; the same command again does what is missing, and `--record` writes what the log holds to `studies`. With
`--deep` most designs get behind the reader, and each actual profile that `cam` writes, or that `check` says may be cut,
is driven by an independent driver (`fuzz_truth`). A fault is reproduced by `--show NUMBER`, which leaves the case's
files in the folder `fuzz_case` and prints its command.
"""

import argparse
import json
import os
import random
import re
import resource
import shlex
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from functools import partial
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from pkgutil import walk_packages

import cadgen.cli  # as the command does, it sets one thread for linear algebra before numpy is loaded
from cadgen.car.against_play.profile_kinds import codes
from cadgen.design.load import packaged_designs
from cadgen.inference.measurement import kinds
from tests.conftest import TRICYCLE
from tests.studies import fuzz_data, fuzz_designs, fuzz_truth

COMMANDS = (
    "check",
    "cam",
    "gears",
    "optimize",
    "simulate",
    "tolerance",
    "calibrate",
    "card",
    "draw",
    "report",
    "adjust",
    "plan",
    "explore",
)
CPU_SECONDS, MEMORY_KB, WALL_SECONDS = 60, 2_000_000, 3600
# Of processor time for what searches: plan, card at every spacing, and explore, which computes several designs.
SEARCH_SECONDS = 300
SEARCHING = ("plan", "card", "explore")
ADDRESS_SPACE = 6 * 2**30  # beyond which a run is ended; libraries reserve more than they use
LONGEST_LINE, MOST_LINES = 900, 7
PROFILES = codes()
KERNEL_COMMANDS = ("cam", "gears")
JUDGED = "judged"  # folder of the cam that is made only to be driven
PAGES = Path(__file__).parents[2] / "studies"


@dataclass(frozen=True)
class Outcome:
    """Outcome of a run, and the faults in it."""

    number: int
    code: int
    seconds: float
    megabytes: float
    said: str
    changes: tuple[str, ...]
    faults: tuple[str, ...]


def arguments(
    command: str, seed: int, number: int, folder: Path, *, deep: bool = False
) -> tuple[list[str], tuple[str, ...]]:
    """Write a case's files and return its command line, and what was changed."""
    rng = random.Random(f"{seed}/{command}/{number}")
    file = folder / "design.toml"
    as_json = ["--json"] if command in ("plan", "explore") and rng.random() < 0.5 else []
    if command == "plan":
        one = fuzz_designs.course(seed, number)
        file.write_bytes(one.content)
        reserve = ["--reserve", f"{rng.choice([0, 0.5, 1, 3])}"]
        out = ["--out", str(folder / "out")] if rng.random() < 0.5 else []
        return [command, str(file), "--processes", "1", *reserve, *out, *as_json], one.changes
    if command == "explore":
        one, study = fuzz_designs.study(seed, number)
        file.write_bytes(one.content)
        (folder / "study.toml").write_bytes(study)
        place = ["--out", str(folder / "out"), "--processes", "1"]
        return [command, str(folder / "study.toml"), *place, *as_json], one.changes
    if command == "calibrate":
        made = fuzz_data.data(seed, number)
        for name, content in made.files.items():
            (folder / name).write_bytes(content)
        out = ["--out", str(folder / "out")] if rng.random() < 0.3 else []
        return [command, *(str(folder / name) for name in made.files), *made.options, *out], made.changes
    order = rng.choice(["as-given", "reordered", "search"]) if command == "gears" else ""
    one = fuzz_designs.case(seed, number, searching=order == "search", deep=_deep(command, deep))
    file.write_bytes(one.content)
    args = [command, str(file), *(part for text in one.overrides for part in ("--set", text))]
    if rng.random() < 0.5:
        args.append("--json")
    if command in ("cam", "gears", "simulate", "card", "draw", "report", "adjust"):
        args += ["--out", str(folder / "out")]
    match command:
        case "check" | "cam" if deep:
            args += (
                ["--profile", rng.choice(PROFILES) if rng.random() < 0.2 else "actual"] if rng.random() < 0.9 else []
            )
            args += ["--formats", "xyz"] if command == "cam" and rng.random() < 0.9 else []
        case "check" | "cam":
            args += ["--profile", rng.choice(PROFILES)] if rng.random() < 0.4 else []
        case "gears":
            args += ["--order", order]
        case "simulate":
            args += ["--play-deg", f"{rng.choice([0, 1e-9, 0.5, 30, 179.9])}"] if rng.random() < 0.2 else []
        case "tolerance" | "report":
            args += ["--samples", f"{rng.choice([1, 2, 50])}", "--processes", "1"]
        case "adjust":
            what, content = fuzz_data.trial_runs(rng, fuzz_designs.bases()["carbon_free_car"]["path"]["waypoints_mm"])
            (folder / "trial.csv").write_bytes(content)
            return [*args, str(folder / "trial.csv")], (*one.changes, what)
    return args, one.changes


def _deep(command: str, deep: bool) -> tuple[str, ...]:
    """Designs whose cases are to get behind the reader, which `check` has tried; none where any file will do."""
    if deep:
        return (*packaged_designs(), "draws/s_course.toml", "draws/eight.toml", "motion")
    return {
        "card": ("draws/s_course.toml", "draws/eight.toml"),
        "draw": tuple(packaged_designs()),
        "report": tuple(packaged_designs()),
        "adjust": ("carbon_free_car", "workshop_car"),
    }.get(command, ())


def run(command: str, seed: int, deep: bool, number: int) -> Outcome:
    """Run a case in a fork of this process and judge it."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        args, changes = arguments(command, seed, number, folder, deep=deep)
        status, used = _forked(args, folder, SEARCH_SECONDS if command in SEARCHING else CPU_SECONDS)
        said, printed = (_tail(folder / stream) for stream in ("stderr", "stdout"))
        code = os.waitstatus_to_exitcode(status)
        seconds, kilobytes = used.ru_utime + used.ru_stime, used.ru_maxrss
        faults = list(judge(command, code, said, printed, seconds, kilobytes, as_json="--json" in args))
        if deep and command in ("check", "cam"):
            faults += _driven(args, folder, code)
    words = (said or _error(printed))[:400]
    return Outcome(number, code, round(seconds, 2), round(kilobytes / 1000), words, changes, tuple(faults))


def _driven(args: list[str], folder: Path, code: int) -> list[str]:
    """Faults of the actual profile of a case, driven by the independent driver on its points."""
    if "actual" not in args or (code != 0 and args[0] == "check"):
        return []
    written = folder / "out"
    if args[0] == "check":
        written = folder / JUDGED
        cam = [*(arg for arg in args[1:] if arg != "--json"), "--formats", "xyz", "--out", str(written)]
        status, _ = _forked(["cam", *cam], folder / "again", CPU_SECONDS)
        if (made := os.waitstatus_to_exitcode(status)) != 0:
            return [f"check says that it may be cut, and cam ends with exit code {made}"]
    overrides = [value for option, value in pairwise(args) if option == "--set"]
    return list(fuzz_truth.judge(folder / "design.toml", overrides, written, code))


def _forked(args: list[str], folder: Path, seconds: int) -> tuple[int, resource.struct_rusage]:
    """Status of a command run in a fork of this process, and the time and memory that it used."""
    folder.mkdir(exist_ok=True)
    child = os.fork()
    if child == 0:
        _run_in_child(args, folder, seconds)
    _, status, used = os.wait4(child, 0)
    return status, used


def judge(
    command: str, code: int, said: str, printed: str, seconds: float, kilobytes: float, *, as_json: bool
) -> Iterator[str]:
    """Breaches of the contract by a run."""
    if code < 0:
        yield f"ended by {signal.Signals(-code).name}"
    elif code not in (0, 1, 2, 3):
        yield f"exit code {code}"
    message = said
    if as_json and code >= 0:
        message += _error(printed)
        try:
            document = json.loads(printed)
            ruling = document.get("verdict") if isinstance(document, dict) else None
            if isinstance(ruling, dict) and (ruling.get("readiness") == "not-ready") != (code != 0):
                yield f"exit code {code} for {ruling.get('readiness')}"
        except ValueError:
            if not said:
                yield "no JSON document"
    if "a fault in cadgen" in message or "Traceback" in message or "report this design" in message:
        yield "internal fault"
    elif code == 3 and command in ("check", "optimize", "tolerance"):
        yield "exit code 3 of a command that reads and writes no other file"
    if "out of memory" in message:
        yield "out of memory"
    if "Warning" in said:
        yield "warning of a library"
    lines = message.splitlines()
    if code in (2, 3) and not lines:
        yield "no sentence"
    if code == 0 and said:
        yield "something said beside success"
    if len(lines) > MOST_LINES or any(len(line) > LONGEST_LINE for line in lines):
        yield f"{len(lines)} lines, the longest of {max(map(len, lines))} characters"
    if seconds > (SEARCH_SECONDS if command in SEARCHING else CPU_SECONDS):
        yield f"{seconds:.0f} s of processor time"
    if kilobytes > MEMORY_KB:
        yield f"{kilobytes / 1e6:.1f} GB"


def _error(printed: str) -> str:
    """Error that a JSON document tells; empty if it is none, or tells none."""
    try:
        document = json.loads(printed)
    except ValueError:
        return ""
    return str(document.get("error", "")) if isinstance(document, dict) else ""


def _run_in_child(args: list[str], folder: Path, seconds: int) -> None:
    """Never returns: what the process says goes to two files, and its limits end it."""
    code = 99
    try:
        for number, name in ((1, "stdout"), (2, "stderr")):
            os.dup2(os.open(folder / name, os.O_CREAT | os.O_WRONLY), number)
        resource.setrlimit(resource.RLIMIT_CPU, (seconds + 5, seconds + 8))
        resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.alarm(WALL_SECONDS)
        sys.argv = ["cadgen", *args]
        from cadgen.cli import main

        try:
            main()
        except SystemExit as leave:
            code = leave.code if isinstance(leave.code, int) else 0 if leave.code is None else 98
        sys.stdout.flush()
        sys.stderr.flush()
    except BaseException:
        os.write(2, traceback.format_exc().encode())
    finally:
        os._exit(code)


def _tail(file: Path) -> str:
    return file.read_bytes().decode(errors="replace").strip()[:2_000_000] if file.exists() else ""


def load_modules(command: str) -> None:
    """Load the program's modules before any fork; the kernel only for the commands that use it."""
    os.environ.update(COLUMNS="200", TERM="dumb", PYTHONWARNINGS="default")
    os.environ.setdefault("MPLBACKEND", "agg")
    for module in walk_packages(cadgen.__path__, "cadgen."):
        kernel = module.name.startswith("cadgen.geometry.solids.")
        if not module.name.endswith("__main__") and (not kernel or command in KERNEL_COMMANDS):
            import_module(module.name)
    if command == "calibrate" and not kinds.has("steered track"):  # logs of a vehicle without a cam are among its files
        sys.path.append(str(TRICYCLE / "src"))
        kinds.register(import_module("cadgen_tricycle").STEERED_TRACK)


def outcomes(
    command: str, seed: int, numbers: Sequence[int], processes: int = 1, *, deep: bool = False
) -> Iterator[Outcome]:
    """Run the cases of these numbers, as they are done."""
    work = partial(run, command, seed, deep)
    if processes == 1:
        load_modules(command)
        yield from map(work, numbers)
        return
    with ProcessPoolExecutor(processes, initializer=load_modules, initargs=(command,)) as pool:
        yield from pool.map(work, numbers, chunksize=4)


def main() -> None:
    """Run, print and record."""
    parser = argparse.ArgumentParser(description="Fuzz a command.")
    parser.add_argument("--command", choices=COMMANDS, default="check")
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--deep", action="store_true", help="designs that the reader takes; check and cam are judged")
    parser.add_argument("--log", type=Path, help="keep each outcome here, and skip what it holds already")
    parser.add_argument("--record", action="store_true", help="write studies/fuzz_COMMAND.md, or fuzz_COMMAND_deep.md")
    parser.add_argument("--show", type=int, metavar="NUMBER", help="only write this case and print its command")
    given = parser.parse_args()
    if given.show is not None:
        folder = Path("fuzz_case")
        folder.mkdir(exist_ok=True)
        args, changes = arguments(given.command, given.seed, given.show, folder, deep=given.deep)
        print("; ".join(changes))
        print(shlex.join(["python", "-m", "cadgen", *args]))
        return
    done = _logged(given.log)
    numbers = [n for n in range(given.first, given.first + given.cases) if n not in done]
    begun = time.monotonic()
    for one in outcomes(given.command, given.seed, numbers, given.processes, deep=given.deep):
        done[one.number] = one
        if given.log:
            with given.log.open("a") as log:
                log.write(json.dumps(asdict(one)) + "\n")
        if one.faults:
            print(
                f"{one.number}: {', '.join(one.faults)} ({'; '.join(one.changes)[:300]})\n    {one.said[:300]}",
                flush=True,
            )
    every = [done[n] for n in sorted(done) if given.first <= n < given.first + given.cases]
    print(table(every))
    print(f"{time.monotonic() - begun:.0f} s", file=sys.stderr)
    if given.record:
        PAGES.mkdir(parents=True, exist_ok=True)
        name = f"fuzz_{given.command}_deep.md" if given.deep else f"fuzz_{given.command}.md"
        (PAGES / name).write_text(report(given.command, given.seed, every, deep=given.deep))
    sys.exit(1 if any(one.faults for one in every) else 0)


def _logged(log: Path | None) -> dict[int, Outcome]:
    lines = log.read_text().splitlines() if log and log.exists() else []
    found = (json.loads(line) for line in lines)
    return {
        one["number"]: Outcome(**{**one, "changes": tuple(one["changes"]), "faults": tuple(one["faults"])})
        for one in found
    }


def table(every: Sequence[Outcome]) -> str:
    """Counts by exit code, and the greatest time and memory."""
    codes = Counter(one.code for one in every)
    rows = [f"| cases | {len(every)} |", *(f"| exit code {code} | {count} |" for code, count in sorted(codes.items()))]
    if every:
        slow, large = max(every, key=lambda one: one.seconds), max(every, key=lambda one: one.megabytes)
        rows += [
            f"| longest | {slow.seconds:.1f} s of processor time (case {slow.number}) |",
            f"| largest | {large.megabytes:.0f} MB (case {large.number}) |",
            f"| mean | {sum(one.seconds for one in every) / len(every):.2f} s |",
        ]
    rows.append(f"| faults | {sum(bool(one.faults) for one in every)} |")
    return "\n".join(["| figure | value |", "|---|---|", *rows])


def report(command: str, seed: int, every: Sequence[Outcome], *, deep: bool = False) -> str:
    """The record of a study."""
    from cadgen import __version__

    first, count = min(one.number for one in every), len(every)
    option = (f" --first {first}" if first else "") + (" --deep" if deep else "")
    about = fuzz_data if command == "calibrate" else fuzz_designs
    faulty = [
        f"- {one.number}: {', '.join(one.faults)} ({_plain('; '.join(one.changes))})" for one in every if one.faults
    ]
    return (
        "\n\n".join(
            [
                f"# Fuzz of `cadgen {command}`",
                " ".join((about.__doc__ or "").split()),
                "A fault is: a traceback or an internal fault; an exit code or a message outside the contract; exit "
                "code 3 of a command that neither reads nor writes other files; a warning of a library; more than "
                f"{SEARCH_SECONDS if command in SEARCHING else CPU_SECONDS} s of processor time; more than "
                f"{MEMORY_KB / 1e6:g} GB, with all that Python and the libraries need themselves.",
                *((_OF_DEEP,) if deep else ()),
                f"    python -m tests.studies.fuzz --command {command} --cases {count} --seed {seed}{option} --record",
                f"cadgen {__version__}",
                table(every),
                "\n".join(faulty) if faulty else "No case failed.",
            ]
        )
        + "\n"
    )


_OF_DEEP = (
    "A fault is also a false *ready*. Of three in four designs the actual profile is asked for. Where it may be cut, "
    "and where a manifest goes with it, an independent driver takes the car along the exported points. It must pass "
    "each waypoint within 0.1 mm and 0.05 mm for the driver's own error, or within what the manifest says. A drive "
    "wheel or a path out of all proportion is a fault as well, and an exit code that does not follow the verdict."
)


def _plain(text: str) -> str:
    return re.sub(r"[^\x20-\x7e]", "?", text)[:200]


if __name__ == "__main__":
    main()
