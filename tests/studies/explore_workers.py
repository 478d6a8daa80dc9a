"""A thousand workers, event by event: how much of their time `cadgen explore` keeps them at work.

    python -m tests.studies.explore_workers --cases 1000 --seed 1 [--record] [--times JOURNAL]

No such cluster is at hand, so it is simulated, event by event, with what was measured of the parts: the times that real
designs took (of `--times`, else those recorded), the processor time that dask's scheduler needs for a task and the main
process for a batch, both measured here and now. Assumed: scheduler and main process do one thing after the other; a
message takes a millisecond; workers are equal, all there from the start, and none dies; the file system takes the
journal's writes at the measured cost.
"""

import heapq
import random
import sys
import tempfile
from argparse import ArgumentParser
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from time import process_time

from cadgen import __version__
from cadgen.api.exploration import explore
from cadgen.studies import engines
from cadgen.studies.engines import Sizes
from cadgen.studies.journal import Journal
from tests.exploration import cheap
from tests.studies.command import PAGES, tell

BAR = 0.9
MESSAGE_S = 1e-3
AHEAD = 2  # batches for each worker that are handed out; as `cadgen.studies.engines` does
# Processor time of 16 designs of the packaged study `paper_car`, s.
RECORDED = Path(__file__).parents[1] / "data" / "explore_seconds.txt"


@dataclass(frozen=True)
class Costs:
    """Processor time of a batch in the scheduler and in the main process, s."""

    scheduler: float
    main: float


class _Server:
    """One that does one thing after the other."""

    def __init__(self, each: float) -> None:
        self._each, self._free = each, 0.0

    def serve(self, now: float) -> float:
        self._free = max(self._free, now) + self._each
        return self._free


def efficiency(times: Sequence[float], workers: int, costs: Costs) -> float:
    """Share of the workers' time in which they compute, until the last design is done.

    Args:
        times: seconds of each design, in order.
        workers: number of workers.
        costs: of a batch.
    """
    # The scheduler has each batch twice; the main process takes results and sends the next batch at once.
    scheduler, main = _Server(costs.scheduler / 2), _Server(costs.main)
    sizes, place = Sizes(workers, len(times)), 0
    free = [0.0] * workers  # when each worker is
    events: list[tuple[float, int, list[float]]] = []  # results as they reach the scheduler
    number = 0
    end = 0.0

    def hand_out(now: float) -> None:
        nonlocal place, number
        size = sizes.next()
        batch = list(times[place : place + size])
        place += len(batch)
        if not batch:
            return
        there = scheduler.serve(now) + MESSAGE_S
        begin = max(heapq.heappop(free), there)
        done = begin + sum(batch)
        heapq.heappush(free, done)
        number += 1
        heapq.heappush(events, (done + MESSAGE_S, number, batch))

    for _ in range(AHEAD * workers):
        hand_out(main.serve(0.0))
    while events:
        now, _, batch = heapq.heappop(events)
        end = max(end, now)
        arrived = main.serve(scheduler.serve(now) + MESSAGE_S)
        sizes.add(batch)
        hand_out(arrived)
    return sum(times) / (workers * end)


def scheduler_cost(tasks: int = 1000) -> float:
    """Processor time of dask's scheduler for a task, s, its client's among it: both are in this process."""
    from dask.distributed import Client, LocalCluster

    with (
        LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        client.gather(client.map(abs, range(10), pure=False))
        begun = process_time()
        client.gather(client.map(abs, range(tasks), pure=False))
        return (process_time() - begun) / tasks


def main_cost(designs: int = 400) -> float:
    """Processor time of the main process for a batch of one design, s, its place in the journal among it."""
    engines._MOST_IN_BATCH = 1
    spent = []
    with tempfile.TemporaryDirectory() as folder, cheap.registered():
        file = Path(folder, "cheap.toml")
        for count in (10, designs, 2 * designs):  # the first loads what is needed
            file.write_text(cheap.study_text(count))
            begun = process_time()
            explore(file, Path(folder, str(count)), processes=1)
            spent.append(process_time() - begun)
    return (spent[2] - spent[1]) / designs


def recorded(journal: Path | None) -> list[float]:
    """Seconds of real designs, of a journal or as recorded."""
    if journal is not None:
        return list(Journal.read(journal).times())
    return [float(line) for line in RECORDED.read_text().split()]


def drawn(known: Sequence[float], count: int, seed: int) -> list[float]:
    """Times of many designs, drawn from those of known ones."""
    return random.Random(seed).choices(known, k=count)


def main() -> None:
    """Simulate, print and record."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=1000, help="workers")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--times", type=Path)
    parser.add_argument("--record", action="store_true")
    chosen = parser.parse_args()
    known, costs = recorded(chosen.times), Costs(scheduler_cost(), main_cost())
    mean = sum(known) / len(known)
    lines, worst = [], 1.0
    for label, share in (("as recorded", 1.0), ("one minute each on average", 60 / mean)):
        for designs in (20_000, 200_000) if share == 1.0 else (10_000, 20_000):
            times = [share * each for each in drawn(known, designs, chosen.seed)]
            found = efficiency(times, chosen.cases, costs)
            lines.append(f"| {label} | {designs} | {sum(times) / 3600:.0f} | {100 * found:.1f} % |")
            worst = min(worst, found)
    measured = f"{1e3 * costs.scheduler:.2f} ms of processor time a batch in dask's scheduler and its client"
    took = f"{len(known)} designs that took {mean:.2f} s of processor time on average, {max(known):.1f} s at most"
    page = f"""# A thousand workers, simulated

    python -m tests.studies.explore_workers --cases {chosen.cases} --seed {chosen.seed} --record

cadgen {__version__}: {chosen.cases} workers, event by event. Measured:
{measured},
{1e3 * costs.main:.2f} ms in the main process; {took}.
Assumed: both do one thing after the other, a message takes {1e3 * MESSAGE_S:g} ms, workers are equal, are all there
from the start, and none dies. No such cluster was used.

| times of designs | designs | core-hours | efficiency |
|---|---|---|---|
{chr(10).join(lines)}

The bar is {100 * BAR:g} %; the least is {100 * worst:.1f} %.
"""
    tell(page, PAGES / "explore_workers.md" if chosen.record else None)
    sys.exit(worst < BAR)


if __name__ == "__main__":
    main()
