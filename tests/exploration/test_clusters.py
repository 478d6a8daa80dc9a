"""Shards, executors, and a real scheduler of dask."""

import logging
import subprocess
import sys
from pathlib import Path

import pytest

from cadgen.api.exploration import explore, merge
from cadgen.errors import DesignError, FileError
from tests.exploration import cheap


@pytest.fixture
def study(tmp_path):
    file = tmp_path / "my study.toml"
    with cheap.registered():
        file.write_text(cheap.study_text(30))
        yield file


def test_a_search_has_no_shards(tmp_path):
    file = tmp_path / "search.toml"
    with cheap.registered():
        file.write_text(cheap.study_text(40, "nsga2"))
        with pytest.raises(DesignError, match="it has no shards: use processes or a scheduler"):
            explore(file, tmp_path, shard="1/2")


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/99999", (2, 1)])
def test_a_wrong_shard_is_refused(study, tmp_path, shard):
    with pytest.raises(DesignError, match="it must be k/n, such as 2/3"):
        explore(study, tmp_path, shard=shard)


def test_a_wrong_executor_is_refused(study, tmp_path):
    with pytest.raises(DesignError, match=r"the executor is 3; it must have a method submit or map"):
        explore(study, tmp_path, executor=3)
    with pytest.raises(DesignError, match="both an executor and a scheduler"):
        explore(study, tmp_path, executor=map, scheduler="tcp://127.0.0.1:1")


def test_folders_without_journals_are_refused(tmp_path):
    with pytest.raises(FileError, match="there is no journal of cadgen explore in these folders"):
        merge([tmp_path])
    with pytest.raises(FileError, match="cannot be read"):
        merge([tmp_path / "nowhere"])
    with pytest.raises(DesignError, match="no folder was given"):
        merge([])


def test_an_executor_that_was_shut_down_is_said_and_the_study_goes_on(study, tmp_path):
    from concurrent.futures import ThreadPoolExecutor

    closed = ThreadPoolExecutor(1)
    closed.shutdown()
    with pytest.raises(FileError, match=r"takes no more work .*the study goes on where it was"):
        explore(study, tmp_path, executor=closed)
    assert len(list(explore(study, tmp_path, executor=map).computed.rows())) == 30


@pytest.mark.slow
@pytest.mark.long
def test_a_scheduler_of_dask_computes_the_same_and_its_loss_is_said(study, tmp_path):
    from dask.distributed import LocalCluster

    known = cheap.digest(explore(study, tmp_path / "known", executor=map))
    with LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as cluster:
        address = cluster.scheduler_address
        assert cheap.digest(explore(study, tmp_path / "by address", scheduler=address)) == known
        from dask.distributed import Client

        with Client(cluster, set_as_default=False) as client:
            assert cheap.digest(explore(study, tmp_path / "by client", executor=client)) == known
    with pytest.raises(FileError, match=r"no scheduler with workers answers at tcp://127\.0\.0\.1:9 .*start `dask"):
        explore(study, tmp_path / "gone", scheduler="tcp://127.0.0.1:9")


@pytest.mark.slow
@pytest.mark.long
def test_a_scheduler_that_dies_is_said_and_the_study_goes_on(study, tmp_path):
    import distributed  # noqa: F401 (it sets the levels of its loggers)

    known = cheap.digest(explore(study, tmp_path / "known", executor=map))
    file = tmp_path / "scheduler.json"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": Path(__file__).parents[2]}
    dask = [sys.executable, "-m", "dask"]
    named = ["--scheduler-file", str(file)]
    scheduler = subprocess.Popen([*dask, "scheduler", "--port", "0", "--no-dashboard", *named], **quiet)
    worker = subprocess.Popen([*dask, "worker", *named, "--nthreads", "1", "--no-dashboard"], **quiet)

    def kill(words: str) -> None:
        if "a second" in words:
            scheduler.kill()
            scheduler.wait()

    said: list[logging.LogRecord] = []
    handler = logging.Handler()
    handler.emit = said.append
    logger = logging.getLogger("distributed.client")
    level = logger.level
    logger.addHandler(handler)
    try:
        with pytest.raises(FileError, match=r"has gone: .*the study goes on where it was"):
            explore(study, tmp_path / "out", scheduler=str(file), progress=kill)
    finally:
        logger.removeHandler(handler)
        for process in (scheduler, worker):
            process.kill()
            process.wait()
    assert said == []  # no traceback of the library beside the sentence
    assert logger.level == level != logging.CRITICAL
    assert cheap.digest(explore(study, tmp_path / "out", executor=map)) == known
