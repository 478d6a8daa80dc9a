"""Tasks in batches through an engine: every task gives one result, whatever dies on the way.

Batches are as long as some seconds of work. One that is lost with its process is computed again, and if that is
lost too, its tasks are computed one by one with nothing beside them, which shows the task that ends its process.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import dataclass
from itertools import islice
from queue import SimpleQueue
from typing import Any, Generic, TypeVar

from cadgen.errors import FileError, brief
from cadgen.studies.engines import AGAIN, Engine, Future, Mapped

T = TypeVar("T")
R = TypeVar("R")
_BATCH_S = 2.0  # work of a batch: little to lose, and far more than it costs to send
_BATCHES_A_SECOND = 50  # that one main process, and a scheduler, deal with at ease; of many workers batches are longer
_MOST_IN_BATCH = 500
_LEAST_BATCH_S = 0.1  # of a batch towards the end: less would not pay for its way and its place on the disk
_AHEAD = 2  # batches for each worker that are under way or wait
_SHARES = 4  # batches for each worker that the tasks left are split into at least, so that all end together
_LOSSES = 2  # of a batch, before its tasks go alone
_LOSSES_ALONE = 2  # of a task that goes alone, before it is given up
_LOST = (BrokenExecutor, CancelledError, OSError, EOFError)
_LOST_NAMES = {"KilledWorker", "FutureCancelledError", "CommClosedError"}  # of dask


@dataclass
class _Batch(Generic[T]):
    tasks: list[T]
    losses: int = 0


class Sizes:
    """How many tasks the next batch has, by the time that tasks took so far.

    Args:
        workers: number of workers.
        count: number of tasks.
    """

    def __init__(self, workers: int, count: int) -> None:
        self._workers, self._left, self._done, self._seconds = workers, count, 0, 0.0

    def add(self, seconds: Sequence[float]) -> None:
        """Take note of tasks that are done, by their times, s."""
        self._done += len(seconds)
        self._seconds += sum(seconds)

    def next(self) -> int:
        """Number of tasks of the next batch."""
        if not self._done:
            return 1
        each = max(self._seconds / self._done, _BATCH_S / _MOST_IN_BATCH)
        most = max(_BATCH_S, self._workers / _BATCHES_A_SECOND)
        share = -(-self._left // (_SHARES * self._workers))
        size = max(1, min(int(most / each), max(share, int(_LEAST_BATCH_S / each))))
        self._left -= size
        return size


def work(
    engine: Engine | Mapped,
    run: Callable[[Sequence[T]], Sequence[tuple[R, float]]],
    tasks: Iterable[T],
    count: int,
    done: Callable[[Sequence[tuple[R, float]]], None],
    given_up: Callable[[T], R],
) -> None:
    """Compute all tasks.

    Args:
        engine: where.
        run: function that computes a batch: a result with its time (s) for each task; it raises no errors of a task's.
        tasks: the tasks; only so many are taken at once as are under way.
        count: number of tasks.
        done: function that is called with the results of each batch, as they come.
        given_up: function that makes the result of a task whose process died again and again.

    Raises:
        FileError: the engine takes no more work, or cannot run the function.
    """
    sizes, left = Sizes(engine.workers, count), iter(tasks)
    if isinstance(engine, Mapped):
        _map(engine, run, left, sizes, done)
        return
    again: deque[_Batch[T]] = deque()
    alone: list[T] = []
    under_way: dict[Future, _Batch[T]] = {}
    finished: SimpleQueue[Future] = SimpleQueue()
    while True:
        while len(under_way) < _AHEAD * engine.workers:
            batch = again.popleft() if again else _Batch(list(islice(left, sizes.next())))
            if not batch.tasks:
                break
            future = engine.submit(run, batch.tasks)
            under_way[future] = batch
            future.add_done_callback(finished.put)
        if not under_way:
            break
        future = finished.get()
        batch = under_way.pop(future)
        results = _result(future)
        if results is not None:
            sizes.add([seconds for _, seconds in results])
            done(results)
        elif (batch := _Batch(batch.tasks, batch.losses + 1)).losses < _LOSSES:
            again.append(batch)
        else:
            alone += batch.tasks
    for task in alone:
        done([_alone(engine, run, task, given_up)])


def _alone(
    engine: Engine, run: Callable[[Sequence[T]], Sequence[tuple[R, float]]], task: T, given_up: Callable[[T], R]
) -> tuple[R, float]:
    for _ in range(_LOSSES_ALONE):
        finished: SimpleQueue[Future] = SimpleQueue()
        engine.submit(run, [task]).add_done_callback(finished.put)
        if results := _result(finished.get()):
            return results[0]
    return given_up(task), 0.0


def _result(future: Future) -> Sequence[tuple[Any, float]] | None:
    """Results of a batch; None if its process was lost."""
    try:
        results: Sequence[tuple[Any, float]] = future.result()
    except _LOST:
        return None
    except Exception as error:
        if type(error).__name__ in _LOST_NAMES:
            return None
        raise _unable(error) from error
    return results


def _unable(error: Exception) -> FileError:
    return FileError(
        f"the workers cannot compute this study ({brief(f'{type(error).__name__}: {error}')}): they need the same "
        f"cadgen and your own figures installed; then {AGAIN}"
    )


def _map(
    engine: Mapped,
    run: Callable[[Sequence[T]], Sequence[tuple[R, float]]],
    left: Iterator[T],
    sizes: Sizes,
    done: Callable[[Sequence[tuple[R, float]]], None],
) -> None:
    """Rows of batches one after the other, since a map may take all that it is given at once."""
    first = True
    while True:
        count = 1 if first else engine.workers
        batches = [batch for _ in range(count) if (batch := list(islice(left, sizes.next())))]
        if not batches:
            return
        first = False
        try:
            for results in engine.map(run, batches):
                sizes.add([seconds for _, seconds in results])
                done(results)
        except _LOST as error:
            raise FileError(f"the pool lost its processes ({brief(str(error))}): {AGAIN}") from error
        except (TypeError, ValueError, AttributeError, ImportError) as error:
            raise _unable(error) from error
