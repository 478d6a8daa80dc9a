"""Where designs are computed: processes of this machine, or anything that has `submit` or `map`."""

from collections.abc import Callable, Iterable
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from typing import Any, Protocol

from cadgen.errors import DesignError, FileError, brief
from cadgen.processes import pool

_UNKNOWN_WORKERS = 64  # reckoned for an executor that does not say how many it has
AGAIN = "run the same command again, and the study goes on where it was"


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


class Given:
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
            raise FileError(f"the executor takes no more work ({brief(str(error))}): {AGAIN}") from error
        return future

    def close(self) -> None:
        """Leave the executor to its owner."""


class Cluster(Given):
    """Workers of a dask scheduler.

    Args:
        address: address of the scheduler, such as tcp://10.0.0.5:8786, or a scheduler file.

    Raises:
        DesignError: dask.distributed is not installed.
        FileError: no scheduler answers there, or it has no workers.
    """

    _PATIENCE_S = 30

    def __init__(self, address: str) -> None:
        try:
            from dask.distributed import Client
        except ImportError:
            raise DesignError(
                "a scheduler needs dask.distributed: pip install '.[cluster]' in cadgen's folder"
            ) from None
        named = {"scheduler_file": address} if address.endswith(".json") else {"address": address}
        try:
            self._client = Client(**named, timeout=self._PATIENCE_S, set_as_default=False)
            self._client.wait_for_workers(1, timeout=self._PATIENCE_S)
        except (OSError, TimeoutError, ValueError) as error:
            reason = brief(str(error)).rstrip(".") or type(error).__name__
            raise FileError(
                f"no scheduler with workers answers at {brief(address)} ({reason}): start `dask scheduler` and "
                "`dask worker`, or correct the address"
            ) from error
        super().__init__(self._client.get_executor(pure=False, retries=0), sum(self._client.nthreads().values()))
        self.address = address

    def submit(self, function: Callable[[Any], Any], batch: Any, /) -> Future:
        """Begin a batch.

        Raises:
            FileError: the scheduler has gone.
        """
        if self._client.status != "running":
            raise FileError(f"the scheduler at {brief(self.address)} has gone: start it again; {AGAIN}")
        return super().submit(function, batch)

    def close(self) -> None:
        """Leave the scheduler."""
        self._client.close()


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
            return Given(executor.get_executor(pure=False), sum(executor.nthreads().values()))
        return Given(executor)
    function = mapping(executor)
    if function is not None:
        return Mapped(function)
    raise DesignError(
        f"the executor is {brief(repr(executor), 60)}; it must have a method submit or map, or be a function like map"
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
