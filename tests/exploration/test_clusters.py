"""Job scripts as texts, run with a stand-in for the program; a real scheduler of dask."""

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from cadgen.api.exploration import explore, merge, write_script
from cadgen.errors import DesignError, FileError
from tests.exploration import cheap

STAND_IN = '#!/bin/sh\nfor word in "$@"; do printf "%s\\n" "$word"; done\n'


@pytest.fixture
def study(tmp_path):
    file = tmp_path / "my study.toml"
    with cheap.registered():
        file.write_text(cheap.study_text(30))
        yield file


def words_of(command: list[str], folder: Path, environment: dict[str, str]) -> list[str]:
    """Arguments that a command hands to the program."""
    (folder / "cadgen").write_text(STAND_IN)
    (folder / "cadgen").chmod(0o700)
    env = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", **environment}
    return subprocess.run(command, env=env, check=True, capture_output=True, text=True).stdout.splitlines()


def test_a_slurm_script_runs_its_shard(study, tmp_path):
    file, command = write_script(study, tmp_path / "out", "slurm", 12, 4)
    directives = [line.removeprefix("#SBATCH --") for line in file.read_text().splitlines() if "#SBATCH" in line]
    assert {"array=1-12", "cpus-per-task=4", "requeue"} <= set(directives)
    words = words_of(["bash", str(file)], tmp_path, {"SLURM_ARRAY_TASK_ID": "7", "SLURM_CPUS_PER_TASK": "4"})
    out = str(tmp_path / "out")
    assert words == ["explore", str(study), "--out", out, "--processes", "4", "--shard", "7/12"]
    assert shlex.split(command) == ["sbatch", "--wait", str(file), "&&", "cadgen", "merge", out, "--out", out]


def test_a_kubernetes_job_runs_its_shard(study, tmp_path):
    file, command = write_script(study, tmp_path / "out", "kubernetes", 5, 2)
    job = yaml.safe_load(file.read_text())
    assert (job["kind"], job["spec"]["completionMode"], job["spec"]["completions"]) == ("Job", "Indexed", 5)
    (container,) = job["spec"]["template"]["spec"]["containers"]
    words = words_of([*container["command"], *container["args"]], tmp_path, {"JOB_COMPLETION_INDEX": "4"})
    assert words == ["explore", str(study), "--out", str(tmp_path / "out"), "--processes", "2", "--shard", "5/5"]
    assert container["volumeMounts"][0]["mountPath"] == str(tmp_path)
    assert command.startswith(f"kubectl apply -f {file} && kubectl wait")
    assert f"job/{job['metadata']['name']}" in command


def test_a_search_has_neither_script_nor_shards(tmp_path):
    file = tmp_path / "search.toml"
    with cheap.registered():
        file.write_text(cheap.study_text(40, "nsga2"))
        with pytest.raises(DesignError, match="a search has no shards"):
            write_script(file, tmp_path, "slurm", 3)
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


def pause_ms(dask_worker):
    """Time between two looks of a dask worker at its computation."""
    return dask_worker.periodic_callbacks["profile"].callback_time


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
            (pause,) = client.run(pause_ms).values()
            assert pause == 100  # ten looks a second, and not a hundred
    with pytest.raises(FileError, match=r"no scheduler with workers answers at tcp://127\.0\.0\.1:9 .*start `dask"):
        explore(study, tmp_path / "gone", scheduler="tcp://127.0.0.1:9")


@pytest.mark.slow
@pytest.mark.long
def test_a_scheduler_that_dies_is_said_and_the_study_goes_on(study, tmp_path):
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

    try:
        with pytest.raises(FileError, match=r"has gone: .*the study goes on where it was"):
            explore(study, tmp_path / "out", scheduler=str(file), progress=kill)
    finally:
        for process in (scheduler, worker):
            process.kill()
            process.wait()
    assert cheap.digest(explore(study, tmp_path / "out", executor=map)) == known
