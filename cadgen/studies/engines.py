"""Where designs are computed: processes of this machine, or anything that has `submit` or `map`.

Tasks go through an engine in batches, and every task gives one result, whatever dies on the way. Batches are as long as
some seconds of work. One that is lost with its process is computed again; if that is lost, too, its tasks are computed
one by one with nothing beside them, which shows the task that ends its process.
"""

import logging
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, CancelledError, ProcessPoolExecutor
from dataclasses import dataclass
from itertools import islice
from queue import SimpleQueue
from typing import Any, Generic, Protocol, TypeVar

from cadgen.errors import DesignError, FileError, brief
from cadgen.messages import Message
from cadgen.processes import pool

_UNKNOWN_WORKERS = 64  # reckoned for an executor that does not say how many it has
AGAIN = Message("run the same command again, and the study goes on where it was")


class Future(Protocol):
    """A batch under way, as `submit` returns it."""

    def result(self) -> Any:
        """The result, or the error that the call raised."""

    def add_done_callback(self, function: Callable[[Any], Any], /) -> Any:
        """Have a function called with the future as soon as it is done."""


class Engine(Protocol):
    """Something that computes batches elsewhere."""

    @property
    def workers(self) -> int:
        """How many batches it computes at once."""

    def submit(self, function: Callable[[Any], Any], batch: Any, /) -> Future:
        """Begin a batch."""

    def close(self) -> None:
        """Free what it holds."""


class Processes:
    """Processes of this machine; those that die are replaced.

    Args:
        count: number of processes.
        inherited: descriptor of a file that they must not hold open, for its lock would live as long as they do.
    """

    def __init__(self, count: int, inherited: int | None = None) -> None:
        self.workers, self._inherited = count, inherited
        self._pool = self._made()

    def _made(self) -> ProcessPoolExecutor:
        return pool(self.workers, closed=self._inherited)

    def submit(self, function: Callable[[Any], Any], batch: Any, /) -> Future:
        """Begin a batch, in new processes if one has died."""
        try:
            return self._pool.submit(function, batch)
        except BrokenExecutor:
            self._pool.shutdown(wait=True)
            self._pool = self._made()
            return self._pool.submit(function, batch)

    def close(self) -> None:
        """End the processes."""
        self._pool.shutdown(wait=True, cancel_futures=True)


class ForeignExecutor:
    """An executor that somebody else has made, and will close; `workers` is their number, if it does not say it."""

    def __init__(self, executor: Any, workers: int | None = None) -> None:
        self._executor = executor
        self.workers = workers or int(getattr(executor, "_max_workers", 0) or _UNKNOWN_WORKERS)

    def submit(self, function: Callable[[Any], Any], batch: Any, /) -> Future:
        """Begin a batch.

        Raises:
            FileError: the executor takes no more work.
        """
        try:
            future: Future = self._executor.submit(function, batch)
        except (BrokenExecutor, RuntimeError, OSError) as error:
            raise FileError(
                "the executor takes no more work ({fault}): {again}", fault=brief(str(error)), again=AGAIN
            ) from error
        return future

    def close(self) -> None:
        """Leave the executor to its owner."""


class Cluster(ForeignExecutor):
    """Workers of a dask scheduler.

    Args:
        address: address of the scheduler, such as tcp://10.0.0.5:8786, or a scheduler file.

    Raises:
        DesignError: dask.distributed is not installed.
        FileError: no scheduler answers there, or it has no workers.
    """

    _PATIENCE_S = 30
    # What these say of a scheduler that has gone, with tracebacks, is said in one sentence.
    _LOGGERS = ("distributed", "distributed.client")

    def __init__(self, address: str) -> None:
        try:
            from dask.distributed import Client
        except ImportError:
            raise DesignError(
                "a scheduler needs dask.distributed: pip install '.[cluster]' in cadgen's folder"
            ) from None
        self._levels = {name: logging.getLogger(name).level for name in self._LOGGERS}
        for name in self._LOGGERS:
            logging.getLogger(name).setLevel(logging.CRITICAL)
        named = {"scheduler_file": address} if address.endswith(".json") else {"address": address}
        try:
            self._client = Client(**named, timeout=self._PATIENCE_S, set_as_default=False)
            self._client.wait_for_workers(1, timeout=self._PATIENCE_S)
        except (OSError, TimeoutError, ValueError) as error:
            self._restore_levels()
            reason = brief(str(error)).rstrip(".") or type(error).__name__
            raise FileError(
                "no scheduler with workers answers at {address} ({reason}): start `dask scheduler` and `dask "
                "worker`, or correct the address",
                address=brief(address),
                reason=reason,
            ) from error
        super().__init__(self._client.get_executor(pure=False, retries=0), sum(self._client.nthreads().values()))
        self.address = address

    def submit(self, function: Callable[[Any], Any], batch: Any, /) -> Future:
        """Begin a batch.

        Raises:
            FileError: the scheduler has gone.
        """
        if self._client.status != "running":
            raise FileError(
                "the scheduler at {address} has gone: start it again; {again}", address=brief(self.address), again=AGAIN
            )
        return super().submit(function, batch)

    def close(self) -> None:
        """Leave the scheduler."""
        try:
            self._client.close()
        finally:
            self._restore_levels()

    def _restore_levels(self) -> None:
        for name, level in self._levels.items():
            logging.getLogger(name).setLevel(level)


class Mapped:
    """A function like the built-in `map`, or something with such a method, as it is called for rows of batches."""

    def __init__(self, function: Callable[..., Iterable[Any]]) -> None:
        self.map, self.workers = function, _UNKNOWN_WORKERS

    def close(self) -> None:
        """Leave it to its owner."""


def engine_of(executor: Any) -> Engine | Mapped:
    """The engine of an executor, a pool, or a function like the built-in `map`.

    Raises:
        DesignError: it is none of these.
    """
    if callable(getattr(executor, "submit", None)):
        if hasattr(executor, "get_executor"):  # a dask client, whose futures are of another kind
            return ForeignExecutor(executor.get_executor(pure=False), sum(executor.nthreads().values()))
        return ForeignExecutor(executor)
    function = mapping(executor)
    if function is not None:
        return Mapped(function)
    raise DesignError(
        "the executor is {executor}; it must have a method submit or map, or be a function like map",
        executor=brief(repr(executor), 60),
    )


def mapping(executor: Any) -> Callable[..., Iterable[Any]] | None:
    """A function like the built-in `map` that computes by an executor, a pool or such a function; None for others."""
    if hasattr(executor, "get_executor"):
        executor = executor.get_executor(pure=False)
    function = getattr(executor, "map", executor)
    if callable(function):
        made: Callable[..., Iterable[Any]] = function
        return made
    if not callable(getattr(executor, "submit", None)):
        return None
    return lambda function, items: [future.result() for future in [executor.submit(function, each) for each in items]]


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
        "the workers cannot compute this study ({fault}): they need the same cadgen and your own figures "
        "installed; then {again}",
        fault=brief(f"{type(error).__name__}: {error}"),
        again=AGAIN,
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
            raise FileError(
                "the pool lost its processes ({fault}): {again}", fault=brief(str(error)), again=AGAIN
            ) from error
        except (TypeError, ValueError, AttributeError, ImportError) as error:
            raise _unable(error) from error
