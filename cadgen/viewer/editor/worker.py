"""A process that computes versions of a design; the newest request wins, and none takes longer than its limit.

It is a process and not a thread, so that the server answers while it computes, and so that a computation can be ended
whatever it does. One that is superseded ends itself at its next step.
"""

import multiprocessing
from concurrent.futures import BrokenExecutor
from contextlib import suppress
from functools import partial
from threading import Lock
from typing import Any

from cadgen.messages import Message
from cadgen.processes import WorkerProcess, call
from cadgen.progress import Progress
from cadgen.viewer.editor.job import AnswerState, Compute, Job, Result, fault, refusal

LIMIT_S = 120.0
_MOST_BYTES = 6 * 2**30  # of address space, where the system can limit it
_ENDED = 0  # as the newest revision: the worker is to end


class SupersededError(Exception):
    """A newer version was asked for."""


def computed(job: Job, progress: Progress) -> Result:
    """Result of a version, as of `cadgen.viewer.editor.compute`."""
    from cadgen.viewer.editor.compute import compute  # only in the process that computes: it is most of the program

    return compute(job, progress)


class Worker:
    """A process, begun when it is first needed and again after it was ended."""

    def __init__(self, work: Compute = computed, limit_s: float = LIMIT_S) -> None:
        """Make a worker.

        Args:
            work: function that the process calls for each job; found by its name, as processes need it.
            limit_s: longest time of a job, s; the process is ended then.
        """
        self._work, self._limit = work, limit_s
        self._newest: Any = multiprocessing.get_context("spawn").Value("q", 1)
        self._lock = Lock()
        self._process: WorkerProcess | None = None

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
                return Result(AnswerState.SUPERSEDED)
            try:
                try:
                    future = self._begun().submit(call, job)
                except BrokenExecutor:  # it died between two jobs
                    self._end()
                    future = self._begun().submit(call, job)
                result: Result = future.result(self._limit)
                return result
            except TimeoutError:
                sentence = Message(
                    "the computation took longer than {limit:g} s and was ended: take the last change back",
                    limit=self._limit,
                )
            except BrokenExecutor:
                sentence = Message("the computation has ended by itself: take the last change back")
            self._end()
            return (
                Result(AnswerState.SUPERSEDED) if self._newest.value == _ENDED else refusal(AnswerState.FAULT, sentence)
            )

    def close(self) -> None:
        """End the process, also amid a job."""
        with self._newest.get_lock():
            self._newest.value = _ENDED
        process = self._process
        if process is not None:
            process.end()
        with self._lock:
            self._end()

    def _begun(self) -> WorkerProcess:
        if self._process is None:
            # A process that begins anew has no threads and locks of this one, on every system alike.
            self._process = WorkerProcess(_limit_memory, partial(_answer, self._newest, self._work), anew=True)
        return self._process

    def _end(self) -> None:
        if self._process is not None:
            self._process.end()
        self._process = None


def _answer(newest: Any, work: Compute, job: Job) -> Result:
    """Result of a job in the process that computes; it ends at its next step once it is superseded."""

    def step(text: str) -> None:
        if newest.value != job.revision:
            raise SupersededError(text)

    try:
        return work(job, step)
    except SupersededError:
        return Result(AnswerState.SUPERSEDED)
    except Exception as error:
        return fault(error)


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # not on Windows
        return
    with suppress(OSError, ValueError):
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == resource.RLIM_INFINITY or soft > _MOST_BYTES:
            resource.setrlimit(resource.RLIMIT_AS, (_MOST_BYTES, hard))
