"""The process that computes: the newest request wins, and nothing keeps it for ever."""

import json
import os
import threading
import time

import pytest

from cadgen.viewer.editor.job import Job, Result, refusal
from cadgen.viewer.editor.worker import Worker


def work(job, progress):
    """Do what the text says."""
    if job.text == "endless":
        open(job.file, "x").close()
        while True:  # until a step ends it
            progress("a step")
    if job.text == "stuck":
        time.sleep(1000)
    if job.text == "die":
        os._exit(7)
    if job.text == "fail":
        raise RuntimeError("a fault of its own")
    if job.text == "refuse":
        return refusal("refused", "it cannot be")
    return Result("done", json.dumps({"pid": os.getpid(), "revision": job.revision}).encode())


def run(worker, revision, text="", file=""):
    worker.supersede(revision)
    result = worker.run(Job(revision, "whole", text, file))
    return result.state, json.loads(result.body)


@pytest.fixture(scope="module")
def worker():
    made = Worker(work, limit_s=60)
    yield made
    made.close()


@pytest.mark.slow
def test_one_process_computes_job_after_job(worker):
    (first, one), (second, two) = run(worker, 1), run(worker, 2)
    assert (first, second) == ("done", "done")
    assert one["pid"] == two["pid"] != os.getpid()
    assert run(worker, 2, "refuse") == ("refused", {"error": "it cannot be", "zh": "it cannot be"})
    state, answer = run(worker, 2, "fail")
    assert state == "fault"
    assert "please report it" in answer["error"]
    assert run(worker, 2)[1]["pid"] == one["pid"]


@pytest.mark.slow
def test_a_newer_revision_ends_the_older_one(worker, tmp_path):
    revision, begun, answers = 10, tmp_path / "begun", []
    thread = threading.Thread(target=lambda: answers.append(run(worker, revision, "endless", str(begun))))
    thread.start()
    while not begun.exists() and thread.is_alive():
        thread.join(0.02)
    state, answer = run(worker, revision + 1)
    thread.join(60)
    assert (state, answer["revision"]) == ("done", revision + 1)
    assert answers == [("superseded", {})]
    # One that is old already is not begun.
    assert worker.run(Job(revision, "whole", "endless", str(begun))).state == "superseded"


@pytest.mark.slow
def test_a_process_that_ends_or_takes_too_long_is_told_and_begun_again():
    worker = Worker(work, limit_s=60)
    state, answer = run(worker, 1, "die")
    assert state == "fault"
    assert "ended by itself" in answer["error"]
    assert run(worker, 1)[0] == "done"
    worker._limit = 0.2
    state, answer = run(worker, 1, "stuck")
    assert state == "fault"
    assert "longer than 0.2 s" in answer["error"]
    worker._limit = 60
    assert run(worker, 1)[0] == "done"
    worker.close()
    assert worker.run(Job(1, "whole", "", "")).state == "superseded"
