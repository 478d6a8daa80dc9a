"""Row of one design of a study: cheap figures and their limits first, then checks and exact figures.

The process that computes a design keeps its limits of time and memory. Nothing that goes wrong with a design leaves
this module as an error: it becomes the row's sentence.
"""

import json
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from math import isfinite
from pathlib import Path
from time import thread_time
from typing import Any, TypeVar

from cadgen.design.load import complete_of
from cadgen.design.schema import Design, MotionDesign
from cadgen.errors import CadgenError, brief
from cadgen.studies.sampling import REPLAN, Values
from cadgen.studies.study import ALL, MOST_DESIGNS, Study
from cadgen.studies.study_figures import Evaluated, StudyFigure

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


T = TypeVar("T")
R = TypeVar("R")


def timed(computed: Callable[[T], R], tasks: Sequence[T], memory_mb: float | None) -> list[tuple[R, float]]:
    """Results of tasks, each with its processor time, s.

    Args:
        computed: function that computes one.
        tasks: the tasks.
        memory_mb: memory that the process may take more, megabytes of 1e6 bytes; None for any.
    """
    if memory_mb is not None:
        limit_memory(memory_mb)
    results = []
    for task in tasks:
        begun = thread_time()
        results.append((computed(task), thread_time() - begun))
    return results


class DesignState(StrEnum):
    """State of a design in a study.

    Within all limits and checks; not; outside a limit on a cheap figure, so that no more was computed; the values make
    no design; or a fault, or out of time or memory.
    """

    KEPT = "kept"
    OUTSIDE = "outside"
    SCREENED = "screened"
    REFUSED = "refused"
    CRASHED = "crashed"


_LONGEST = 400  # letters of a sentence
_NUMBERS = 2 * MOST_DESIGNS  # of a search some more than its designs: the last generation is a whole one


@dataclass(frozen=True)
class Row:
    """Result of one design.

    Attributes:
        number: number in the plan, counted from 0.
        values: values of the varied keys.
        state: how the design stands to limits and checks.
        figures: figures of the study in order; None for one that was not computed.
        failed: codes of the checks and figures that are outside their limits.
        sentence: reason for a design that was refused or crashed; else empty.
    """

    number: int
    values: Values
    state: DesignState
    figures: tuple[float | None, ...]
    failed: tuple[str, ...] = ()
    sentence: str = ""

    @property
    def content(self) -> list[Any]:
        """The row as it is written as JSON."""
        return [self.number, self.values, self.state, self.figures, self.failed, self.sentence]

    @classmethod
    def of(cls, content: Sequence[Any]) -> "Row":
        """The row of parsed JSON.

        Raises:
            ValueError: it is none of a row.
        """
        try:
            number, values, state, figures, failed, sentence = content
            row = cls(number, tuple(values), DesignState(state), tuple(figures), tuple(failed), sentence)
            sound = type(number) is int and all(figure is None or isfinite(figure) for figure in row.figures)
        except (TypeError, OverflowError) as error:
            raise ValueError("it is no row") from error
        if not (sound and 0 <= number < _NUMBERS and all(isinstance(text, str) for text in (*row.failed, sentence))):
            raise ValueError("it is no row")
        return row


@dataclass(frozen=True)
class Task:
    """Design to be computed.

    Attributes:
        number: number in the plan.
        values: values of the varied keys.
        text: text of the design with its planned path; None where the base's path is used.
        fault: why there is no planned path; empty if there is one.
    """

    number: int
    values: Values
    text: str | None = None
    fault: str = ""


@dataclass(frozen=True)
class DesignJob:
    """All that a process needs to compute designs of a study.

    Attributes:
        study: the study.
        figures: its figures, which other processes do not find by their codes where a program has registered them.
    """

    study: Study
    figures: tuple[StudyFigure, ...]

    @classmethod
    def of(cls, study: Study) -> "DesignJob":
        """The job of a study."""
        return cls(study, study.figures)

    def __call__(self, tasks: Sequence[Task]) -> list[tuple[Row, float]]:
        """Rows of designs, each with its processor time, s."""
        return timed(self.row, tasks, self.study.file.each.memory_mb)

    def row(self, task: Task) -> Row:
        """Row of one design."""
        known: dict[str, float] = {}
        failed: list[str] = []
        try:
            with within(self.study.file.each.seconds):
                if task.fault:
                    raise CadgenError(task.fault)
                state = self._judge(task, known, failed)
            sentence = ""
        except CadgenError as error:
            state, sentence = DesignState.REFUSED, str(error)
        except TooLongError as error:
            state, sentence = DesignState.CRASHED, str(error)
        except MemoryError:
            state, sentence = DesignState.CRASHED, "it ran out of memory (each.memory_mb)"
        except Exception as error:
            state, sentence = DesignState.CRASHED, f"a fault in cadgen ({type(error).__name__}: {error})"
        figures = tuple(known.get(figure.code) for figure in self.figures)
        return Row(task.number, task.values, state, figures, tuple(failed), brief(sentence, _LONGEST))

    def design(self, task: Task) -> Design | MotionDesign:
        """The design of a task, read and checked."""
        text = self.study.text if task.text is None else task.text
        return complete_of(text, Path(self.study.source), self.overrides_of(task))

    def overrides_of(self, task: Task) -> tuple[str, ...]:
        """Overrides of the text that a task is read from; those of the base are in a planned text already."""
        planned = task.text is not None
        pairs = zip(self.study.variations, task.values, strict=True)
        changed = [change for variation, value in pairs for change in variation.changes(value)]
        apart = (REPLAN, "path.") if planned else (REPLAN,)
        varied = tuple(override_of(key, value) for key, value in changed if not key.startswith(apart))
        return varied if planned else (*self.study.file.overrides, *varied)

    def _judge(self, task: Task, known: dict[str, float], failed: list[str]) -> DesignState:
        file, values = self.study.file, dict(zip(self.study.keys, task.values, strict=True))
        evaluated = Evaluated(values, lambda: self.design(task), file.profile, file.cars, file.seed)
        self._measure(evaluated, [figure for figure in self.figures if figure.cheap], known, failed)
        if failed:
            return DesignState.SCREENED
        if file.checks:
            codes = [check.code.value for check in evaluated.plan.failed]
            failed += dict.fromkeys(code for code in codes if ALL in file.checks or code in file.checks)
        self._measure(evaluated, [figure for figure in self.figures if not figure.cheap], known, failed)
        return DesignState.OUTSIDE if failed else DesignState.KEPT

    def _measure(
        self, evaluated: Evaluated, figures: Sequence[StudyFigure], known: dict[str, float], failed: list[str]
    ) -> None:
        for figure in figures:
            value = float(figure.of(evaluated))
            if not isfinite(value):
                raise CadgenError("{code} is {value}, not a finite number", code=figure.code, value=value)
            known[figure.code] = value
            if any(limit.excess(value) > 0 for limit in self.study.file.limits if limit.figure == figure.code):
                failed.append(figure.code)


def override_of(key: str, value: Any) -> str:
    """A value as `--set` takes it; numbers, texts and lists are written alike in JSON and TOML."""
    return f"{key}={json.dumps(value, ensure_ascii=False)}"
