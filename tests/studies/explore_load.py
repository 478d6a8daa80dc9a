"""Cost of `cadgen explore` itself: memory of its main process, and processor time for each evaluation.

    python -m tests.studies.explore_load --cases 100000 [--record]

Cheap evaluations, so that what is measured is the machinery: plan, batches, journal on disk, results streamed to CSV
and Parquet, pictures. Times are processor time of the main process and its workers, for other programs come and go;
tasks of one millisecond count down their own processor time. Start-up is taken off as the difference of two runs.
"""

import json
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import process_time

from cadgen import __version__
from cadgen.api.exploration import explore
from tests.exploration import cheap
from tests.studies.command import PAGES, options, tell

MOST_MB, MOST_OVERHEAD_MS = 500.0, 2.0
ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Load:
    """A run of some evaluations: peak memory of the main process, processor time of it and of its workers, s."""

    designs: int
    peak_mb: float
    main_s: float
    workers_s: float
    write_s: float


def loaded(designs: int, record: tuple[str, ...], processes: int = 1) -> Load:
    """Run a study in a process of its own."""
    arguments = [str(designs), str(processes), *record]
    command = [sys.executable, "-m", "tests.studies.explore_load", "run", *arguments]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    print(done.stdout, file=sys.stderr, flush=True)
    return Load(**json.loads(done.stdout))


def _run(designs: int, processes: int, record: tuple[str, ...]) -> None:
    with tempfile.TemporaryDirectory() as folder, cheap.registered():
        file = Path(folder, "cheap.toml")
        file.write_text(cheap.study_text(designs, record=record))
        begun = process_time()
        computed = explore(file, folder, processes=processes)
        main = process_time() - begun
        begun = process_time()
        computed.write()
        written = process_time() - begun
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6
    load = Load(designs, peak, main, children.ru_utime + children.ru_stime, written)
    print(json.dumps(load.__dict__))


def overhead_ms(few: int = 1000, many: int = 4000) -> float:
    """Processor time of an evaluation besides the millisecond of its task, ms."""
    one, two = (loaded(designs, ("cheap_millisecond_mm",)) for designs in (few, many))
    spent = (two.main_s + two.workers_s) - (one.main_s + one.workers_s)
    return 1e3 * spent / (many - few) - 1.0


def main() -> None:
    """Measure, print and record."""
    chosen = options(__doc__, cases=100_000)
    load, overhead = loaded(chosen.cases, ()), overhead_ms()
    main_us, worker_us, write_us = (1e6 * each / load.designs for each in (load.main_s, load.workers_s, load.write_s))
    page = f"""# Cost of exploring

    python -m tests.studies.explore_load --cases {chosen.cases} --record

cadgen {__version__}: a study of evaluations that cost next to nothing, in one worker process, with journal,
table as CSV and Parquet, pictures and the best designs.

- {load.designs} evaluations: at most {load.peak_mb:.0f} MB in the main process (bar: {MOST_MB:.0f}).
- Processor time for each: {main_us:.0f} µs in the main process, {worker_us:.0f} µs in the worker,
  and {write_us:.0f} µs for its place in the files.
- With tasks of one millisecond an evaluation costs {overhead:.2f} ms more than its task (bar: {MOST_OVERHEAD_MS:g} ms).
"""
    tell(page, PAGES / "explore_load.md" if chosen.record else None)
    sys.exit(load.peak_mb > MOST_MB or overhead > MOST_OVERHEAD_MS)


if __name__ == "__main__":
    if sys.argv[1:2] == ["run"]:
        _run(int(sys.argv[2]), int(sys.argv[3]), tuple(sys.argv[4:]))
    else:
        main()
