"""Concurrent and killed runs into one folder, judged by what stands there.

    python -m tests.studies.folders --cases 100 --seed 1 [--commands] [--record] [--show NUMBER]

Each case is one pair of runs at the same time and one run that is killed: at a random instant, or just before one of
its operations on files (chosen by an audit hook of the interpreter, which knows nothing of the code). After a kill
comes a second run, which may meet the first while it still lives, and may be killed too, and then a third. Runs publish
small files of their own, or with `--commands` are `cadgen tolerance`.

Whether a manifest is true is judged from its JSON and the bytes beside it alone: every file that it lists must be there
with its hash, after every kill and at the end. At the end the killed run's files must be all there or all not.
"""

import argparse
import contextlib
import hashlib
import json
import os
import random
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from cadgen import __version__

PAGES = Path(__file__).parents[2] / "studies"
OPERATIONS = ("os.rename", "os.mkdir", "os.rmdir", "os.remove", "fcntl.flock", "shutil.copyfile")
LETTERS = "abcdef"


@dataclass(frozen=True)
class Job:
    """A run to be: its part, and either the files that it writes or the arguments of a command."""

    part: str
    files: Mapping[str, bytes] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()


@dataclass
class Killed:
    """How a run is to be killed: before an operation with this number, after a time in s, or not at all."""

    operation: int | None = None
    after: float | None = None


def start(job: Job, out: Path, kill: Killed | None = None, gate: int | None = None) -> int:
    """Begin a run in a process of its own; return its number."""
    process = os.fork()
    if process:
        return process
    code = 70
    try:
        with open(os.devnull, "w") as nowhere, contextlib.redirect_stdout(nowhere), contextlib.redirect_stderr(nowhere):
            if gate is not None:
                os.read(gate, 1)  # until all are let go
            if kill and kill.operation is not None:
                _kill_before(kill.operation, out)
            code = _do(job, out)
    except BaseException:
        if "--show" in sys.argv:
            traceback.print_exc()
    os._exit(code)


def _do(job: Job, out: Path) -> int:
    if job.arguments:
        return command(*job.arguments, "--out", str(out))
    from cadgen.figures import Facts
    from cadgen.output.files.folder import publishing
    from cadgen.output.files.manifest import file_facts, write_manifest

    with publishing(out) as staging:
        for name, content in job.files.items():
            (staging / name).write_bytes(content)
        write_manifest(staging, job.part, Facts(files={name: file_facts(staging / name) for name in job.files}))
    return 0


def command(*arguments: str) -> int:
    """Run the command line in this process, which ends with it."""
    from cadgen.cli import main

    sys.argv = ["cadgen", *arguments]
    try:
        main()
    except SystemExit as leave:
        return int(leave.code or 0)


def _kill_before(number: int, out: Path) -> None:
    count = 0

    def hook(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal count
        if event in OPERATIONS or (event == "open" and str(arguments[0]).startswith(str(out))):
            count += 1
            if count == number:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(hook)


def wait(process: int) -> int:
    """Exit code of a run, negative for a signal."""
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])


def run(job: Job, out: Path, kill: Killed | None = None) -> int:
    """Do a run, killed or not."""
    process = start(job, out, kill)
    if kill and kill.after is not None:
        time.sleep(kill.after)
        os.kill(process, signal.SIGKILL)
    return wait(process)


def content(out: Path) -> dict[str, bytes]:
    """Every file of a folder but those of runs under way."""
    if not out.is_dir():
        return {}
    return {f.name: f.read_bytes() for f in out.iterdir() if f.is_file() and not f.name.startswith(".cadgen-")}


def parts(files: Mapping[str, bytes]) -> dict[str, dict[str, str]]:
    """Hash by name by part, from the manifest's bytes."""
    if "manifest.json" not in files:
        return {}
    entries = json.loads(files["manifest.json"])["parts"]
    return {part: {name: facts["sha256"] for name, facts in entry["files"].items()} for part, entry in entries.items()}


def untrue(files: Mapping[str, bytes]) -> list[str]:
    """Entries of the manifest that do not agree with the folder."""
    return [
        name
        for listed in parts(files).values()
        for name, digest in listed.items()
        if name not in files or hashlib.sha256(files[name]).hexdigest() != digest
    ]


def verified(out: Path) -> tuple[int, bool]:
    """Exit code of `cadgen verify --json`, and whether it names a half-done move."""
    with tempfile.TemporaryFile("w+") as printed:
        process = os.fork()
        if not process:
            code = 70
            with contextlib.suppress(BaseException), contextlib.redirect_stdout(printed):
                code = command("verify", str(out), "--json")
                printed.flush()
            os._exit(code)
        code = wait(process)
        printed.seek(0)
        return code, bool(json.loads(printed.read() or "{}").get("half_moved"))


def random_job(rng: random.Random, letters: str, *, commands: bool) -> Job:
    """Some files, in part equal to those of other jobs, by name and by content."""
    part = rng.choice(letters)
    if commands:
        options = ("--profile", "actual", "--samples", "3", "--processes", "1", "--seed", str(rng.randrange(3)))
        return Job(f"{part}_actual_tolerance", arguments=("tolerance", *options, "--set", f"name={part}"))
    names = [f"{part}{n}" for n in range(rng.randint(1, 5))] + rng.sample(["shared1", "shared2"], rng.randint(0, 2))
    return Job(part, {name: bytes(f"{name} {rng.randrange(3)}\n", "ascii") * rng.randint(1, 400) for name in names})


def pair(rng: random.Random, folder: Path, *, commands: bool) -> list[str]:
    """Two runs at the same time; what is wrong afterwards."""
    out = folder / "new" / "out"
    if rng.random() < 0.5:
        run(random_job(rng, LETTERS, commands=False), out)
    jobs = [random_job(rng, rng.choice((LETTERS, "a")), commands=commands) for _ in range(2)]
    gate, opened = os.pipe()
    processes = [start(job, out, gate=gate) for job in jobs]
    os.write(opened, b"go")
    codes = [wait(process) for process in processes]
    os.close(gate)
    os.close(opened)
    wrong = [f"exit {code}" for code in codes if code]
    return wrong + judged(out, jobs)


def judged(out: Path, done: Iterable[Job]) -> list[str]:
    """Faults of a folder after runs that are done: at least the last of them must be listed whole."""
    files = content(out)
    listed = parts(files)
    wrong = [f"{name} is not as listed" for name in untrue(files)]
    wrong += [f"{name} is left" for name in os.listdir(out) if name.startswith(".cadgen-")]
    if (code := verified(out)[0]) != 0:
        wrong.append(f"verify ends with {code}")
    jobs = list(done)
    whole = [
        job.part in listed
        and (not job.files or listed[job.part] == {n: hashlib.sha256(c).hexdigest() for n, c in job.files.items()})
        for job in jobs
    ]
    apart = all(a.part != b.part and not set(a.files) & set(b.files) for n, a in enumerate(jobs) for b in jobs[n + 1 :])
    if not (all(whole) if apart else any(whole)):
        wrong.append("a run that is done is not listed whole")
    return wrong


def killed(rng: random.Random, folder: Path, scale: tuple[int, float], *, commands: bool) -> tuple[str, list[str]]:
    """A run that is killed, and those after it; how far it came, and what is wrong.

    Args:
        rng: of the case.
        folder: an empty one.
        scale: number of operations of such a run, and its time in s.
        commands: whether the runs are commands.
    """
    out = folder / "out"
    for _ in range(rng.randint(0, 2)):
        run(random_job(rng, LETTERS[:3], commands=False), out)
    before = content(out)
    first = random_job(rng, LETTERS[:3], commands=commands)
    by_operation = rng.random() < 0.7
    kill = Killed(operation=rng.randint(1, scale[0])) if by_operation else Killed(after=rng.uniform(0, 1.1 * scale[1]))
    beside = start(random_job(rng, "xyz", commands=False), out) if rng.random() < 0.3 else None
    code = run(first, out, kill)
    wrong = [] if code in (0, -signal.SIGKILL) else [f"the killed run ends with {code}"]
    if beside is not None and wait(beside):
        wrong.append("the run beside it failed")
    after = content(out)
    wrong += [f"{name} is not as listed after the kill" for name in untrue(after)]
    if after == before:
        state = "as before"
    elif code == 0 or _holds(after, first):
        state = "done"
    else:
        state = "mixed" if beside is None else "with another's files"
    exit_code, named = verified(out) if out.is_dir() else (3, False)
    if state == "mixed" and not (named and exit_code == 1):
        wrong.append(f"a mixed folder is not named: verify ends with {exit_code}")
    if rng.random() < 0.4:
        second = random_job(rng, "xyz", commands=False)
        run(second, out, Killed(operation=rng.randint(1, 60)))
        wrong += [f"{name} is not as listed after the second kill" for name in untrue(content(out))]
    last = random_job(rng, "uvw", commands=commands and rng.random() < 0.1)
    if code := run(last, out):
        wrong.append(f"the run after it ends with {code}")
    wrong += judged(out, [last])
    if not commands and not set(first.files) & {"shared1", "shared2"} and beside is None:
        final = content(out)
        old = {name: before.get(name) for name in first.files}
        if {name: final.get(name) for name in first.files} not in (old, dict(first.files)):
            wrong.append("the killed run's files are neither all there nor all not")
        lost = {part for part, names in parts(before).items() if not set(names) & {*first.files, *last.files}}
        lost -= {first.part, *parts(final)}
        if lost and not any("shared" in name for part in lost for name in parts(before)[part]):
            wrong.append(f"parts {sorted(lost)} are lost from the manifest")
    return state, wrong


def _holds(files: Mapping[str, bytes], job: Job) -> bool:
    """Whether all of a run is there and listed."""
    listed = parts(files).get(job.part, {})
    return (
        bool(listed) and (set(listed) == set(job.files) or bool(job.arguments)) and job.files.items() <= files.items()
    )


def case(seed: int, number: int, scale: tuple[int, float], *, commands: bool = False) -> tuple[str, list[str]]:
    """One pair and one kill, from seed and number alone; how far the killed run came, and what is wrong."""
    rng = random.Random(f"{seed} {number}")
    with tempfile.TemporaryDirectory() as folder:
        wrong = pair(rng, Path(folder), commands=commands)
    with tempfile.TemporaryDirectory() as folder:
        state, more = killed(rng, Path(folder), scale, commands=commands)
    return state, wrong + more


def scale(*, commands: bool) -> tuple[int, float]:
    """Number of operations on files of a run, and its time in s."""
    rng = random.Random(0)
    with tempfile.TemporaryDirectory() as folder:
        begun = time.perf_counter()
        run(random_job(rng, "a", commands=commands), Path(folder) / "out")
        took = time.perf_counter() - begun
        low, high = 1, 512
        while low < high:
            middle = (low + high) // 2
            code = run(random_job(rng, "a", commands=commands), Path(folder) / "out", Killed(operation=middle))
            low, high = (low, middle) if code == 0 else (middle + 1, high)
        return low, took


def main() -> None:
    """Run, print and record."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--commands", action="store_true", help="run cadgen tolerance, not only what publishes")
    parser.add_argument("--record", action="store_true", help="write studies/folders.md")
    parser.add_argument("--show", type=int, help="only this case")
    options = parser.parse_args()
    _load(commands=options.commands)
    size = scale(commands=options.commands)
    numbers = range(options.cases) if options.show is None else [options.show]
    states: Counter[str] = Counter()
    failed = []
    for number in numbers:
        state, wrong = case(options.seed, number, size, commands=options.commands)
        states[state] += 1
        if options.commands:
            print(f"case {number}: {state}", flush=True)
        failed += [f"case {number}: {text}" for text in wrong]
        for text in wrong:
            print(f"case {number}: {text}", flush=True)
    lines = report(options.cases, options.seed, options.commands, states, failed)
    print(lines)
    if options.record:
        PAGES.mkdir(parents=True, exist_ok=True)
        name = "folders_commands.md" if options.commands else "folders.md"
        (PAGES / name).write_text(lines, encoding="utf-8")


def _load(*, commands: bool) -> None:
    """Import what the runs need once, so that they only fork."""
    import cadgen.cli.show
    import cadgen.output.files.folder

    if commands:
        os.environ["OPENBLAS_NUM_THREADS"] = "1"

        import cadgen.jobs.simulation  # noqa: F401


def report(cases: int, seed: int, commands: bool, states: Mapping[str, int], failed: list[str]) -> str:
    """The record of a study."""
    option = " --commands" if commands else ""
    kind = "`cadgen tolerance` commands" if commands else "runs that publish small files"
    how = ", ".join(f"{count} {state}" for state, count in sorted(states.items()))
    return f"""# Concurrent and killed runs into one folder

    python -m tests.studies.folders --cases {cases} --seed {seed}{option} --record

cadgen {__version__}: {cases} pairs of concurrent {kind} and {cases} kills (seven
in ten before an operation on files, the others at a random instant), each followed by further runs, some of them killed
too. Judged after every kill and at the end: every file that the manifest lists is there with its hash; `cadgen
verify` names what is mixed; the next run puts it back, and its own files are listed whole.

- Right after the kill the folder was: {how}.
- Cases that failed: {len(failed)}.
{"".join(f"  - {text}" + chr(10) for text in failed)}"""


if __name__ == "__main__":
    main()
