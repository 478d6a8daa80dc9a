"""`cadgen explore` killed at random instants, its main process or one of its workers, and run again.

    python -m tests.studies.explore_kills --cases 20 --seed 1 [--record]

A case is a study of evaluations of a millisecond in two processes. It is killed by SIGKILL at instants drawn evenly
over the time that it takes, its main process or a worker, once to three times; every second case then loses a random
part of the journal's last lines, as a machine that loses its power might. After that it runs to its end. All files must
have the bytes of a run that nothing disturbed, and the journal each design once. Pictures, which take most of the
time and are made of the same rows, are left out.
"""

import os
import random
import signal
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from unittest.mock import patch

from cadgen import __version__
from cadgen.api.exploration import explore
from cadgen.studies import study_files
from tests.exploration import cheap
from tests.studies.command import PAGES, options, tell

DESIGNS = 3000
RECORD = ("cheap_millisecond_mm", "cheap_crash_mm")


@dataclass
class Outcome:
    """Kills of a case and its faults."""

    number: int
    kills: dict[str, int]
    faults: list[str]


def begun(study: Path, out: Path) -> int:
    """Begin a run in a fork of this process; its number."""
    process = os.fork()
    if process:
        return process
    code = 70
    try:
        explore(study, out, processes=2).write()
        code = 0
    finally:
        os._exit(code)


def ended(process: int, seconds: float) -> bool:
    """Whether a process ends by itself within a time."""
    deadline = time.monotonic() + seconds
    descriptor = os.pidfd_open(process)
    try:
        import select

        ready = select.select([descriptor], [], [], max(deadline - time.monotonic(), 0.0))[0]
    finally:
        os.close(descriptor)
    if ready:
        os.waitpid(process, 0)
    return bool(ready)


def hashes(folder: Path) -> dict[str, str]:
    """Hash of every file but the journal, whose lines come in the order in which they were computed."""
    return {file.name: sha256(file.read_bytes()).hexdigest() for file in folder.iterdir() if file.suffix != ".journal"}


def twice(journal: Path) -> int:
    """Number of designs that a journal has more than once."""
    numbers = [
        line.split(b'"row":[')[1].split(b",")[0] for line in journal.read_bytes().splitlines() if b'"row"' in line
    ]
    return len(numbers) - len(set(numbers))


def case(number: int, seed: int, study: Path, known: dict[str, str], seconds: float) -> Outcome:
    """Kill one study, run it to its end, and judge it."""
    drawn = random.Random(f"{seed} {number}")
    outcome = Outcome(number, {"main": 0, "worker": 0, "torn": 0}, [])
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "out")
        for _ in range(drawn.randint(1, 3)):
            process, whom = begun(study, out), drawn.choice(["main", "worker"])
            if ended(process, drawn.uniform(0, seconds)):
                break
            if whom == "worker":
                workers = Path(f"/proc/{process}/task/{process}/children").read_text().split()
                if workers:
                    with suppress(ProcessLookupError):
                        os.kill(int(drawn.choice(workers)), signal.SIGKILL)
                    outcome.kills["worker"] += 1
                if ended(process, drawn.uniform(0, seconds)):
                    break
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
            outcome.kills["main"] += 1
        journal = out / "cheap.journal"
        if number % 2 and journal.exists():
            content = journal.read_bytes()
            journal.write_bytes(content[: len(content) - drawn.randint(0, min(len(content), 3000))])
            outcome.kills["torn"] += 1
        if not ended(begun(study, out), 600):
            outcome.faults.append("it did not end")
        elif (after := hashes(out)) != known:
            outcome.faults.append(f"other bytes in {[name for name in known if after.get(name) != known[name]]}")
        elif twice(journal):
            outcome.faults.append(f"{twice(journal)} designs twice in the journal")
    return outcome


def run(cases: int, seed: int) -> list[Outcome]:
    """All cases."""
    no_pictures = patch.object(study_files, "save", lambda *content: [])
    with tempfile.TemporaryDirectory() as folder, cheap.registered(), no_pictures:
        study, out = Path(folder, "cheap.toml"), Path(folder, "known")
        study.write_text(cheap.study_text(DESIGNS, record=RECORD))
        explore(study, Path(folder, "first"), executor=map).write()  # loads all modules before the forks
        start = time.monotonic()
        assert ended(begun(study, out), 600)
        seconds = time.monotonic() - start
        known = hashes(out)
        outcomes = []
        for number in range(cases):
            outcomes.append(case(number, seed, study, known, seconds))
            print(outcomes[-1], file=sys.stderr, flush=True)
        return outcomes


def main() -> None:
    """Run, print and record."""
    chosen = options(__doc__, cases=20)
    outcomes = run(chosen.cases, chosen.seed)
    failed = [outcome for outcome in outcomes if outcome.faults]
    total = {kind: sum(outcome.kills[kind] for outcome in outcomes) for kind in ("main", "worker", "torn")}
    lines = [f"- Case {outcome.number}: {'; '.join(outcome.faults)}" for outcome in failed]
    what = f"{chosen.cases} studies of {DESIGNS} evaluations of a millisecond in two processes"
    page = f"""# Explore, killed at random instants

    python -m tests.studies.explore_kills --cases {chosen.cases} --seed {chosen.seed} --record

cadgen {__version__}: {what}, killed by SIGKILL at
random instants, and run again to their end: {total["main"]} kills of the main process, {total["worker"]} of a worker,
{total["torn"]} journals that lost some of their end. Judged by the bytes of all files against a run that nothing
disturbed, and by the journal, which must have each design once.

- Cases that failed: {len(failed)}.
{chr(10).join(lines)}"""
    tell(page.rstrip() + "\n", PAGES / "explore_kills.md" if chosen.record else None)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
