"""A part of a job aside: the same result and errors as in this process, and nothing left behind."""

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest

from cadgen.aside import Aside, Ready, Standby, alone, in_processes, only_here
from cadgen.errors import CheckError, FileError

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="elsewhere nothing is forked")
WAITING = """
import os, sys, time
from cadgen.aside import Aside
with Aside(lambda: time.sleep(600)) as aside:
    print(aside._process.pid, flush=True)
    aside.result()
"""

WORKING = """
import os, time
from cadgen.aside import in_processes
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
    with Aside(lambda: (os.getpid(), [1.5, "text"])) as aside:
        process, values = aside.result()
    assert process != os.getpid()
    assert values == [1.5, "text"]


def test_an_error_is_raised_here():
    with Aside(refuse) as aside, pytest.raises(CheckError, match="the rod jams"):
        aside.result()


def test_what_a_process_cannot_hand_over_is_computed_here():
    with Aside(lambda: lambda: 7) as aside:
        assert aside.result()() == 7


def test_a_killed_process_is_done_without():
    me = os.getpid()

    def die_aside():
        if os.getpid() != me:
            os.kill(os.getpid(), signal.SIGKILL)
        return 3

    with Aside(die_aside) as aside:
        assert aside.result() == 3


def test_it_ends_with_its_block():
    with pytest.raises(CheckError), Aside(lambda: time.sleep(600)):
        refuse()
    assert not multiprocessing.active_children()


@pytest.mark.parametrize("script", [WAITING, WORKING], ids=["aside", "processes"])
def test_it_dies_with_its_parent(script):
    command = [sys.executable, "-c", script]
    parent = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=Path(__file__).parents[1])
    assert parent.stdout
    aside = int(parent.stdout.readline())
    descriptor = os.pidfd_open(aside)
    parent.kill()
    parent.wait()
    signalled = multiprocessing.connection.wait([descriptor], timeout=60)
    os.close(descriptor)
    assert signalled


def test_one_processor_computes_here(monkeypatch):
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0})
    with Aside(os.getpid) as aside:
        assert aside.result() == os.getpid()


class JamError(CheckError):
    def __init__(self, angle, part):
        super().__init__(f"the {part} jams at {angle}")


def jam():
    raise JamError(3, "rod")


def test_an_error_that_cannot_be_read_is_raised_here():
    with Aside(jam) as aside, pytest.raises(JamError, match="the rod jams at 3"):
        aside.result()
    with Ready(lambda: None) as ready, pytest.raises(JamError, match="the rod jams at 3"):
        ready.do(jam)


def test_an_error_names_the_place_where_it_was_raised():
    with Aside(refuse) as aside, pytest.raises(CheckError) as caught:
        aside.result()
    assert "in refuse" in caught.value.__notes__[0]


def test_alone_all_is_computed_here():
    with alone(), Aside(os.getpid) as aside:
        assert aside.result() == os.getpid()
    with Aside(os.getpid) as aside:
        assert aside.result() != os.getpid()


def test_what_is_told_aside_is_not_told_here(capfd):
    tell = only_here(print)
    with Aside(partial(tell, "aside")) as aside:
        tell("here")
        aside.result()
    with alone(), Aside(partial(tell, "alone")) as aside:
        aside.result()
    assert capfd.readouterr().out.split() == ["here", "alone"]


def prepare():
    os.environ["CADGEN_TEST_READY"] = "ready"


def job(number):
    return os.getpid(), os.environ.get("CADGEN_TEST_READY"), number


def die(here):
    if os.getpid() != here:
        os.kill(os.getpid(), signal.SIGKILL)
    return "done here"


def unsendable(here):
    return (lambda: "not there") if os.getpid() != here else "done here"


def test_a_process_that_is_ready_does_one_job_after_another():
    with Ready(prepare) as ready:
        first, second = ready.do(partial(job, 1)), ready.do(partial(job, 2))
    assert first == (first[0], "ready", 1)
    assert second == (first[0], "ready", 2)
    assert first[0] != os.getpid()
    assert "CADGEN_TEST_READY" not in os.environ
    assert not multiprocessing.active_children()


def test_an_error_of_a_job_is_raised_here_and_the_next_one_is_done():
    with Ready(prepare) as ready:
        with pytest.raises(CheckError, match="the rod jams"):
            ready.do(refuse)
        assert ready.do(partial(job, 3))[2] == 3


@pytest.mark.parametrize("fails", [die, unsendable])
def test_a_job_that_a_process_does_not_give_back_is_done_here(fails):
    with Ready(prepare) as ready:
        assert ready.do(partial(fails, os.getpid())) == "done here"
        assert ready.do(partial(job, 4)) == (os.getpid(), None, 4)


def test_what_cannot_be_prepared_is_left_to_the_job(capfd):
    with Ready(refuse) as ready:
        assert ready.do(partial(job, 5))[2] == 5
    assert capfd.readouterr() == ("", "")


def test_results_of_processes_are_those_of_map_in_order():
    processes = list(in_processes(2, partial(job), range(20), prepare=prepare))
    assert [(prepared, number) for _, prepared, number in processes] == [("ready", number) for number in range(20)]
    assert os.getpid() not in {process for process, _, _ in processes}
    assert not multiprocessing.active_children()


def end_itself(number):
    os.kill(os.getpid(), signal.SIGKILL)


def test_a_process_that_is_ended_from_outside_is_one_clear_error():
    with pytest.raises(FileError, match=r"ended from outside.*fewer processes"):
        list(in_processes(2, end_itself, [1, 2, 3]))


def test_with_one_processor_the_job_is_done_here(monkeypatch):
    monkeypatch.setattr(os, "sched_getaffinity", lambda process: {0})
    with Ready(prepare) as ready:
        assert ready.do(partial(job, 6)) == (os.getpid(), None, 6)


def test_a_job_is_done_beside_the_block():
    with Ready(prepare) as ready, ready.beside(partial(job, 7)) as result:
        process, prepared, number = result()
    assert process != os.getpid()
    assert (prepared, number) == ("ready", 7)


def sleep_aside(here):
    if os.getpid() != here:
        time.sleep(600)
    return "done here"


def test_a_job_ends_with_its_block():
    with Ready(prepare) as ready:
        with pytest.raises(CheckError), ready.beside(partial(sleep_aside, os.getpid())):
            refuse()
        assert not multiprocessing.active_children()
        assert ready.do(partial(job, 8)) == (os.getpid(), None, 8)


def done_by(standby, number):
    with standby.beside(partial(job, number)) as result:
        return result()


def test_whoever_asks_gets_the_process_that_stands_by():
    standby = Standby("jobs")
    assert done_by(standby, 9) == (os.getpid(), None, 9)
    with standby.ready(prepare) as outer, standby.ready(prepare) as inner:
        assert inner is outer
        assert done_by(standby, 10)[0] == outer.do(partial(job, 11))[0] != os.getpid()
    assert done_by(standby, 12) == (os.getpid(), None, 12)
    assert not multiprocessing.active_children()


def test_where_no_job_is_wanted_nothing_stands_by():
    with Standby("jobs").ready(prepare, wanted=False) as ready:
        assert not multiprocessing.active_children()
        assert ready.do(partial(job, 13)) == (os.getpid(), None, 13)
