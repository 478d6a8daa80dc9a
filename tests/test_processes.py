"""Computation in other processes: the same results and errors as in this one, and nothing left behind."""

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor
from functools import partial
from pathlib import Path

import pytest

from cadgen.errors import CheckError, FileError
from cadgen.processes import WorkerProcess, call, in_processes, in_second_process

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="elsewhere nothing is forked")
WAITING = """
import os, time
from cadgen.processes import in_second_process
def wait():
    print(os.getpid(), flush=True)
    time.sleep(600)
with in_second_process(wait) as result:
    result()
"""

WORKING = """
import os, time
from cadgen.processes import in_processes
def work(number):
    print(os.getpid(), flush=True)
    time.sleep(600)
list(in_processes(1, work, [1]))
"""


@pytest.fixture(autouse=True)
def _two_processors(monkeypatch):
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0, 1})


def refuse():
    raise CheckError("the rod jams")


def test_a_result_comes_from_another_process():
    with in_second_process(lambda: (os.getpid(), [1.5, "text"])) as result:
        process, values = result()
    assert process != os.getpid()
    assert values == [1.5, "text"]


def test_an_error_is_raised_here_with_the_place_where_it_was_raised():
    with in_second_process(refuse) as result, pytest.raises(CheckError, match="the rod jams") as caught:
        result()
    assert "in refuse" in str(caught.value.__cause__)


def die(here):
    if os.getpid() != here:
        os.kill(os.getpid(), signal.SIGKILL)
    return "done here"


def test_a_killed_process_is_done_without():
    with in_second_process(partial(die, os.getpid())) as result:
        assert result() == "done here"


def test_it_ends_with_its_block():
    with pytest.raises(CheckError), in_second_process(lambda: time.sleep(600)):
        refuse()
    assert not multiprocessing.active_children()


@pytest.mark.parametrize("script", [WAITING, WORKING], ids=["beside", "processes"])
def test_it_dies_with_its_parent(script):
    command = [sys.executable, "-c", script]
    parent = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=Path(__file__).parents[1])
    assert parent.stdout
    child = int(parent.stdout.readline())
    descriptor = os.pidfd_open(child)
    parent.kill()
    parent.wait()
    signalled = multiprocessing.connection.wait([descriptor], timeout=60)
    os.close(descriptor)
    assert signalled


def test_one_processor_and_a_process_of_a_pool_compute_by_themselves(monkeypatch):
    (process,) = in_processes(1, beside_pid, [os.getpid()])
    assert process != os.getpid()
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0})
    with in_second_process(os.getpid) as result:
        assert result() == os.getpid()


def beside_pid(other):
    with in_second_process(os.getpid) as result:
        assert result() == os.getpid() != other
        return result()


class JamError(CheckError):
    def __init__(self, angle, part):
        super().__init__(f"the {part} jams at {angle}")


def test_an_error_that_cannot_be_read_is_raised_here():
    def jam():
        raise JamError(3, "rod")

    with in_second_process(jam) as result, pytest.raises(JamError, match="the rod jams at 3"):
        result()


def prepare():
    os.environ["CADGEN_TEST_READY"] = "ready"


def job(number):
    return os.getpid(), os.environ.get("CADGEN_TEST_READY"), number


def test_results_of_processes_are_those_of_map_in_order():
    processes = list(in_processes(2, job, range(20), prepare=prepare))
    assert [(prepared, number) for _, prepared, number in processes] == [("ready", number) for number in range(20)]
    assert os.getpid() not in {process for process, _, _ in processes}
    assert not multiprocessing.active_children()


def test_a_process_that_is_ended_from_outside_is_one_clear_error():
    with pytest.raises(FileError, match=r"ended from outside.*fewer processes"):
        list(in_processes(2, die, [os.getpid()] * 3))


@pytest.mark.parametrize("anew", [False, True])
def test_a_worker_does_one_job_after_another_until_it_is_ended(anew):
    worker = WorkerProcess(prepare, job, anew=anew)
    first, second = worker.submit(call, 1).result(), worker.submit(call, 2).result()
    assert first == (first[0], "ready", 1)
    assert second == (first[0], "ready", 2)
    assert first[0] != os.getpid()
    endless = worker.submit(time.sleep, 600)
    worker.end()
    with pytest.raises(BrokenExecutor):
        endless.result()
    assert not multiprocessing.active_children()
