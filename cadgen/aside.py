"""A part of a job in a process of its own, beside the rest of it.

Numbers and files are the same as without: what is computed aside needs nothing of what goes on meanwhile, and its files
have names of their own. On Linux the process is a fork of this one, with all that was loaded; elsewhere, with a single
processor, in a thread, in a daemon and within `alone`, the part is computed when its result is asked for.
"""

import ctypes
import multiprocessing
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from contextvars import ContextVar
from multiprocessing.connection import Connection, wait
from types import TracebackType
from typing import Any, Generic, TypeVar

from cadgen.errors import FileError

T = TypeVar("T")
Item = TypeVar("Item")
_SIGNAL_AT_PARENTS_DEATH = 1  # PR_SET_PDEATHSIG of Linux's prctl
_ALONE: ContextVar[bool] = ContextVar("alone", default=False)


class Aside(Generic[T]):
    """A computation beside the block that it is the context of; with the block it ends, whether it is done or not.

    Args:
        function: the computation, without arguments; its result and its errors must be such as can be pickled.
    """

    def __init__(self, function: Callable[[], T]) -> None:
        self._function = function
        self._process: Any = None
        self._results: Any = None

    def __enter__(self) -> "Aside[T]":
        if _worthwhile():
            context = multiprocessing.get_context("fork")
            self._results, sender = context.Pipe(duplex=False)
            self._process = context.Process(target=_serve, args=(self._function, sender), daemon=True)
            self._process.start()
            sender.close()
        return self

    def result(self) -> T:
        """The result of the computation; it raises the error that the computation raised."""
        if self._process is None:
            return self._function()
        try:
            done, value = self._results.recv()
        except Exception:  # the process died, perhaps for lack of memory, or what it handed over cannot be read
            return self._function()
        result: T = _taken(done, value)
        return result

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        _end(self._process, self._results)


class Ready:
    """A process that makes itself ready beside the block, for jobs that are not known yet; with the block it ends.

    Args:
        prepare: what takes time and is of use for any of the jobs, such as loading a library.
    """

    def __init__(self, prepare: Callable[[], object]) -> None:
        self._prepare = prepare
        self._process: Any = None
        self._jobs: Any = None

    def __enter__(self) -> "Ready":
        if _worthwhile():
            context = multiprocessing.get_context("fork")
            self._jobs, other = context.Pipe()
            self._process = context.Process(target=_stand_by, args=(self._prepare, other, self._jobs))
            self._process.start()
            other.close()
        return self

    def do(self, job: Callable[[], T]) -> T:
        """The result of a job; it raises the error that the job raised.

        Args:
            job: what is to be done, without arguments; it, its result and its errors must be such as can be pickled.
        """
        with self.beside(job) as result:
            return result()

    @contextmanager
    def beside(self, job: Callable[[], T]) -> Iterator[Callable[[], T]]:
        """Have a job done beside the block, which gets a function for its result; with the block the job ends.

        Args:
            job: what is to be done, as of `do`.
        """
        waiting = self._process is not None

        def result() -> T:
            nonlocal waiting
            if not waiting:
                return job()
            try:
                done, value = self._jobs.recv()
            except Exception:  # the process died, or what it handed over cannot be read
                return job()
            waiting = False
            taken: T = _taken(done, value)
            return taken

        try:
            if waiting:
                try:
                    self._jobs.send(job)
                except Exception:  # the process died, or the job cannot be pickled
                    waiting = False
            yield result
        finally:
            if waiting:  # it is not to go on with files that are being cleared away
                self._stop()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._stop()

    def _stop(self) -> None:
        _end(self._process, self._jobs)
        self._process = None


class Standby:
    """At most one process that is ready for one kind of jobs, for whoever has such a job within the block.

    Args:
        kind: kind of the jobs, a name.
    """

    def __init__(self, kind: str) -> None:
        self._current: ContextVar[Ready | None] = ContextVar(kind, default=None)

    @property
    def current(self) -> Ready | None:
        """The process that is ready here; None outside of such a block."""
        return self._current.get()

    @contextmanager
    def ready(self, prepare: Callable[[], object], *, wanted: bool = True) -> Iterator[Ready]:
        """The process that is ready for the block: that of the block around this one, or a new one.

        Args:
            prepare: what takes time and is of use for any of the jobs.
            wanted: whether there will be jobs at all; without, nothing is prepared.
        """
        current = self._current.get()
        if current is not None or not wanted:
            yield current or Ready(prepare)
            return
        with Ready(prepare) as ready:
            token = self._current.set(ready)
            try:
                yield ready
            finally:
                self._current.reset(token)

    def beside(self, job: Callable[[], T]) -> AbstractContextManager[Callable[[], T]]:
        """Have a job done beside a block by the process that is ready, or by none, as `Ready.beside`.

        Args:
            job: what is to be done, as of `Ready.do`.
        """
        return (self._current.get() or Ready(_nothing)).beside(job)


def _nothing() -> None:
    """Prepare nothing."""


def _taken(done: bool, value: Any) -> Any:
    """A result that another process handed over; its error is raised."""
    if not done:
        raise value
    return value


def _end(process: Any, pipe: Any) -> None:
    if process is not None:
        process.kill()
        process.join()
        pipe.close()


def _stand_by(prepare: Callable[[], object], jobs: Connection, others: Connection) -> None:
    others.close()  # or the end of the parent process would not end the pipe
    _obey()
    with suppress(Exception):  # the job will say what is amiss
        prepare()
    with suppress(EOFError):
        while True:
            if not _answer(jobs.recv(), jobs):
                return


@contextmanager
def alone() -> Iterator[None]:
    """Compute all by itself within the block, where other processes have the other processors."""
    token = _ALONE.set(True)
    try:
        yield
    finally:
        _ALONE.reset(token)


def only_here(tell: Callable[[str], None]) -> Callable[[str], None]:
    """A function that is called in this process alone, and not in one that is forked from it.

    Args:
        tell: function that is called with a few words.
    """
    here = os.getpid()

    def told(words: str) -> None:
        if os.getpid() == here:
            tell(words)

    return told


def in_processes(
    processes: int, function: Callable[[Item], T], items: Iterable[Item], prepare: Callable[[], object] | None = None
) -> Iterator[T]:
    """Results of a function in order, as of `map`; it goes to each process once, and not with every item.

    Args:
        processes: number of processes, which end with the last item or with this process.
        function: function of one item; where processes are not forked it must be such as can be pickled.
        items: what can be pickled, as the results must be.
        prepare: is called in each process before; nothing is if left out.

    Raises:
        FileError: a process was ended from outside.
    """
    from concurrent.futures import BrokenExecutor, ProcessPoolExecutor

    with ProcessPoolExecutor(processes, initializer=_begin, initargs=(prepare or _nothing, function)) as pool:
        try:
            yield from pool.map(_of_item, items)
        except BrokenExecutor as error:
            raise FileError(
                "a process was ended from outside, as the system does when memory runs out: ask for fewer processes, "
                "or close other programs"
            ) from error


_function: Callable[[Any], Any] | None = None  # of this process, if it is one of those of `in_processes`


def _begin(prepare: Callable[[], object], function: Callable[[Any], Any]) -> None:
    global _function
    end_with_parent()
    prepare()
    _function = function


def _of_item(item: Any) -> Any:
    assert _function is not None
    return _function(item)


def end_with_parent() -> None:
    """Have this process, a child of `multiprocessing`, end with its parent process, even if the parent is killed."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    wait([sentinel])
    os._exit(1)


def _worthwhile() -> bool:
    """Whether this process may be forked, and a second processor is free for the fork."""
    return (
        not _ALONE.get()
        and sys.platform == "linux"
        and threading.current_thread() is threading.main_thread()
        and not multiprocessing.current_process().daemon
        and len(os.sched_getaffinity(0)) > 1
    )


def _obey() -> None:
    """Have this process end with its parent process, and by nothing but that."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the terminal sends it to both; the parent process ends this one
    end_with_parent()
    # At once, too, where a library keeps Python's threads from running: what it has locked is so as long as it lives.
    with suppress(OSError, AttributeError):
        ctypes.CDLL(None).prctl(_SIGNAL_AT_PARENTS_DEATH, signal.SIGKILL)


def _serve(function: Callable[[], Any], sender: Connection) -> None:
    _obey()
    _answer(function, sender)


def _answer(function: Callable[[], Any], sender: Connection) -> bool:
    """Whether the result of a function, or its error, could be handed over."""
    answer: tuple[bool, Any]
    try:
        answer = True, function()
    except Exception as error:
        error.add_note(traceback.format_exc())  # the way to it, which is not handed over
        answer = False, error
    with suppress(Exception):  # what cannot be handed over is computed once more, where it is asked for
        sender.send(answer)
        return True
    return False
