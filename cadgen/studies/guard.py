"""Limits of time and memory for the computation of one design, kept by the process that computes it."""

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

_HARD = 2.0  # times the limit, of processor time: then the process ends, whatever library it is in


class TooLongError(BaseException):
    """The computation took longer than it may; no `Exception`, so that nothing below handles it."""


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raise `TooLongError` where the block takes longer; in a thread, as on some clusters, nothing is limited.

    A library that does not return to Python is ended with its process after twice the processor time.

    Args:
        seconds: time that the block may take.
    """
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def late(number: int, frame: object) -> None:
        raise TooLongError(f"it took longer than {seconds:g} s (each.seconds)")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    if _is_worker():
        signal.setitimer(signal.ITIMER_PROF, _HARD * seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGALRM, before)


@cache
def limit_memory(more_mb: float) -> None:
    """Let a worker process take so much more memory than it has at first; beyond, Python raises `MemoryError`.

    Only on Linux, where the size of a process can be read.

    Args:
        more_mb: megabytes of 1e6 bytes.
    """
    if sys.platform != "linux" or not _is_worker():
        return
    import resource

    with open("/proc/self/statm", encoding="ascii") as stream:
        pages = int(stream.read().split()[0])
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    most = pages * os.sysconf("SC_PAGE_SIZE") + int(more_mb * 1e6)
    resource.setrlimit(resource.RLIMIT_AS, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))


def _is_worker() -> bool:
    return multiprocessing.parent_process() is not None
