"""A process that computes versions of a design; the newest request wins, and none takes longer than its limit.

It is a process and not a thread, so that the server answers while it computes, and so that a computation can be ended
whatever it does. One that is superseded ends itself at its next step.
"""

import multiprocessing
import signal
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from threading import Lock
from typing import Any

from cadgen.pace import keep_pace
from cadgen.progress import Progress
from cadgen.viewer.editor.job import Compute, Job, Result, State, fault, refusal

LIMIT_S = 120.0
_MOST_BYTES = 6 * 2**30  # of address space, where the system can limit it
_ENDED = 0  # as the newest revision: the worker is to end

# A process that begins anew has no threads and locks of this one, on every system alike.
_CONTEXT = multiprocessing.get_context("spawn")


class SupersededError(Exception):
    """A newer version was asked for."""


def computed(job: Job, progress: Progress) -> Result:
    """Result of a version, as of `cadgen.viewer.editor.compute`."""
    from cadgen.viewer.editor.compute import compute  # only in the process that computes: it is most of the program

    return compute(job, progress)


class Worker:
    """One process, begun when it is first needed and again after it was ended."""

    def __init__(self, work: Compute = computed, limit_s: float = LIMIT_S) -> None:
        """Make a worker.

        Args:
            work: function that the process calls for each job; found by its name, as processes need it.
            limit_s: longest time of a job, s; the process is ended then.
        """
        self._work, self._limit = work, limit_s
        self._newest: Any = _CONTEXT.Value("q", 1)
        self._lock = Lock()
        self._process: SpawnProcess | None = None
        self._channel: Connection | None = None

    def supersede(self, revision: int) -> None:
        """Let every job of an older revision end."""
        with self._newest.get_lock():
            if self._newest.value != _ENDED:
                self._newest.value = max(self._newest.value, revision)

    def start(self) -> None:
        """Begin the process before it is needed."""
        with self._lock:
            self._begun()

    def run(self, job: Job) -> Result:
        """Compute a job; one after the other, and none that is superseded."""
        with self._lock:
            if self._newest.value != job.revision:
                return Result(State.SUPERSEDED)
            channel = self._begun()
            try:
                channel.send(job)
                if channel.poll(self._limit):
                    result: Result = channel.recv()
                    return result
            except (EOFError, OSError):
                self._kill()
                if self._newest.value == _ENDED:
                    return Result(State.SUPERSEDED)
                return refusal(State.FAULT, "the computation has ended by itself: take the last change back")
            self._kill()
            return refusal(
                State.FAULT,
                f"the computation took longer than {self._limit:g} s and was ended: take the last change back",
            )

    def close(self) -> None:
        """End the process, also amid a job."""
        with self._newest.get_lock():
            self._newest.value = _ENDED
        process = self._process
        if process is not None:
            process.kill()
        with self._lock:
            self._kill()

    def _begun(self) -> Connection:
        if self._process is None or self._channel is None or not self._process.is_alive():
            self._kill()
            ours, theirs = _CONTEXT.Pipe()
            process = _CONTEXT.Process(target=_serve, args=(theirs, self._newest, self._work), daemon=True)
            process.start()
            theirs.close()
            self._process, self._channel = process, ours
        return self._channel

    def _kill(self) -> None:
        if self._channel is not None:
            self._channel.close()
        if self._process is not None:
            self._process.kill()
            self._process.join()
        self._process = self._channel = None


def _serve(channel: Connection, newest: Any, work: Compute) -> None:
    """Compute job after job, until the other end closes."""
    for number in (signal.SIGINT, getattr(signal, "SIGHUP", signal.SIGINT)):
        signal.signal(number, signal.SIG_IGN)  # the terminal's Ctrl-C is for the server, which ends this process
    keep_pace()
    _limit_memory()
    while True:
        try:
            job: Job = channel.recv()
        except (EOFError, OSError):
            return

        def step(text: str, revision: int = job.revision) -> None:
            if newest.value != revision:
                raise SupersededError(text)

        try:
            result = work(job, step)
        except SupersededError:
            result = Result(State.SUPERSEDED)
        except Exception as error:
            result = fault(error)
        with suppress(OSError):  # nobody waits any more
            channel.send(result)


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # not on Windows
        return
    with suppress(OSError, ValueError):
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == resource.RLIM_INFINITY or soft > _MOST_BYTES:
            resource.setrlimit(resource.RLIMIT_AS, (_MOST_BYTES, hard))
