"""Computation in other processes: a part of a job beside the rest of it, or a function of many items in several.

Numbers and files are the same as without. Processes that are made here end with this one, even if it is killed, and one
that computes beside a block ends with the block. A second process has its price in code and memory, so that it stands
only where it makes a whole command at least 1.3 times as fast; the figure is beside its use.
"""

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing.connection import wait
from typing import Any, TypeVar

from cadgen.errors import FileError

T = TypeVar("T")
Item = TypeVar("Item")


def _nothing() -> None:
    """Prepare nothing."""


def pool(
    count: int,
    prepare: Callable[[], object] = _nothing,
    function: Callable[..., Any] | None = None,
    *,
    anew: bool = False,
    closed: int | None = None,
) -> ProcessPoolExecutor:
    """Pool of processes that end with this one.

    Args:
        count: number of processes.
        prepare: function that is called first in each of them.
        function: function that `call` calls there; it goes to each process once. Where processes are not forked it must
            be such as can be pickled, as `prepare` must.
        anew: whether the processes begin anew even where they could be forks, which have this one's threads and locks.
        closed: descriptor of a file that forks must not hold open, for its lock would live as long as they do.
    """
    forked = not anew and "fork" in multiprocessing.get_all_start_methods()
    context = multiprocessing.get_context("fork" if forked else "spawn")
    return ProcessPoolExecutor(
        count, mp_context=context, initializer=_begin, initargs=(prepare, function, closed if forked else None)
    )


_function: Callable[..., Any] | None = None  # of this process, if it is one of a pool


def call(*arguments: Any) -> Any:
    """Call the function of the pool that this process belongs to."""
    assert _function is not None
    return _function(*arguments)


def _begin(prepare: Callable[[], object], function: Callable[..., Any] | None, closed: int | None) -> None:
    global _function
    if closed is not None:
        with suppress(OSError):
            os.close(closed)
    parent = multiprocessing.parent_process()
    if parent is not None:

        def end_with_parent(sentinel: int) -> None:
            wait([sentinel])
            os._exit(1)

        threading.Thread(target=end_with_parent, args=(parent.sentinel,), daemon=True).start()
    prepare()
    _function = function


def in_processes(
    processes: int, function: Callable[[Item], T], items: Iterable[Item], prepare: Callable[[], object] = _nothing
) -> Iterator[T]:
    """Results of a function in order, as of `map`.

    Args:
        processes: number of processes, which end with the last item or with this process.
        function: function of one item; it goes to each process once, and not with every item.
        items: arguments, such as can be pickled, as the results must be.
        prepare: function that is called first in each process.

    Raises:
        FileError: a process was ended from outside.
    """
    with pool(processes, prepare, function) as several:
        try:
            yield from several.map(call, items)
        except BrokenExecutor as error:
            raise FileError(
                "a process was ended from outside, as the system does when memory runs out: ask for fewer processes, "
                "or close other programs"
            ) from error


class WorkerProcess:
    """Process that does its jobs in turn, leaves Ctrl-C to this one, and can be ended amid a job.

    Args:
        prepare: function that is called in it first.
        function: function that `call` calls there.
        anew: whether it begins anew; as of `pool`.
    """

    def __init__(
        self,
        prepare: Callable[[], object] = _nothing,
        function: Callable[..., Any] | None = None,
        *,
        anew: bool = False,
    ) -> None:
        self._pool = pool(1, prepare, function, anew=anew)
        self._number = self._pool.submit(_stand_by)

    def submit(self, function: Callable[..., T], *arguments: Any) -> Future[T]:
        """Have a job done; its future raises `BrokenExecutor` if the process has been ended.

        Args:
            function: function of a module, found there by its name.
            arguments: arguments, such as can be pickled.
        """
        return self._pool.submit(function, *arguments)

    def end(self) -> None:
        """End the process, whatever it does."""
        with suppress(BrokenExecutor):
            number = self._number.result()
            for child in multiprocessing.active_children():
                if child.pid == number:
                    child.kill()
        self._pool.shutdown()


def _stand_by() -> int:
    """Number of this process, which obeys its parent alone from here on."""
    for name in ("SIGINT", "SIGHUP"):  # the terminal sends them to both
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    return os.getpid()


@contextmanager
def in_second_process(function: Callable[[], T]) -> Iterator[Callable[[], T]]:
    """Compute beside a block, which gets a function for the result; it raises the error that the computation raised.

    The process is a fork of this one, with all that was loaded. Where none can be forked, with a single processor, in a
    thread and in a process of a pool, the result is computed when it is asked for; and again so if the process dies.

    Args:
        function: computation, without arguments; its result and its errors must be such as can be pickled.
    """
    if (
        sys.platform != "linux"
        or threading.current_thread() is not threading.main_thread()
        or multiprocessing.parent_process() is not None
        or len(os.sched_getaffinity(0)) == 1
    ):
        yield function
        return
    worker = WorkerProcess(function=function)
    future: Future[T] = worker.submit(call)

    def result() -> T:
        try:
            return future.result()
        except BrokenExecutor:  # the process died, perhaps for lack of memory, or its error cannot be read
            return function()

    try:
        yield result
    finally:
        worker.end()
