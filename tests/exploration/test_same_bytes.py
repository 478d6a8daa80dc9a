"""The same results whatever computes them, however often it is stopped, and whatever dies on the way."""

import os
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from multiprocessing.pool import ThreadPool
from pathlib import Path

import pytest

from cadgen.api.exploration import explore, merge
from cadgen.errors import FileError
from tests.exploration import cheap

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module", autouse=True)
def figures() -> Iterator[None]:
    with cheap.registered():
        yield


@pytest.fixture(scope="module")
def study(tmp_path_factory) -> Path:
    file = tmp_path_factory.mktemp("study") / "cheap.toml"
    file.write_text(cheap.study_text(record=("cheap_crash_mm", "cheap_kill_mm")))
    return file


@pytest.fixture(scope="module")
def known(study, tmp_path_factory) -> str:
    """Results of one process, one design after the other."""
    return cheap.digest(explore(study, tmp_path_factory.mktemp("known"), executor=map))


@pytest.mark.parametrize("processes", [1, 2, 4])
def test_any_number_of_processes(study, known, tmp_path, processes):
    assert cheap.digest(explore(study, tmp_path, processes=processes)) == known


def test_any_executor(study, known, tmp_path):
    with ThreadPoolExecutor(2) as threads:
        assert cheap.digest(explore(study, tmp_path / "threads", executor=threads)) == known
    with ThreadPool(2) as pool:  # a pool of forks may wait for ever in a process with threads, such as a test's
        assert cheap.digest(explore(study, tmp_path / "pool", executor=pool)) == known


def test_shards_in_any_order_are_the_whole(study, known, tmp_path):
    parts = [explore(study, tmp_path / f"part{k}", executor=map, shard=f"{k}/3") for k in (3, 1, 2)]
    assert not parts[0].complete
    with pytest.raises(FileError, match="merge all shards"):
        parts[0].write()
    whole = merge([tmp_path / "part2", tmp_path / "part3", tmp_path / "part1"])
    assert cheap.digest(whole) == known
    assert sum(part.computed.journals[0].count for part in parts) == whole.computed.count
    with pytest.raises(FileError, match=r"have no result yet, the first is number 1: .*--shard 2/3"):
        merge([tmp_path / "part1", tmp_path / "part3"])


def test_many_shards_need_no_more_memory_than_one_and_are_merged(study, known, tmp_path, monkeypatch):
    for k in range(1, 17):
        journal = explore(study, tmp_path, executor=map, shard=f"{k}/16").computed.journals[0]
        assert len(journal.places) <= 16
        journal.close()
    limits: list[tuple[int, int]] = []
    monkeypatch.setattr("resource.getrlimit", lambda _: (70, 10_000))
    monkeypatch.setattr("resource.setrlimit", lambda _, both: limits.append(both))
    assert cheap.digest(merge([tmp_path, tmp_path])) == known
    assert limits == [(80, 10_000)]
    monkeypatch.setattr("resource.getrlimit", lambda _: (70, 70))
    with pytest.raises(FileError, match=r"these are 16 journals, and this computer lets a program open 70 files"):
        merge([tmp_path])


@pytest.mark.parametrize("share", [0.02, 0.3, 0.61, 0.98])
def test_a_torn_journal_goes_on(study, known, tmp_path, share):
    explore(study, tmp_path, executor=map)
    journal = tmp_path / "cheap.journal"
    whole = journal.read_bytes()
    journal.write_bytes(whole[: int(share * len(whole))])
    again = explore(study, tmp_path, executor=map)
    assert cheap.digest(again) == known
    numbers = [line.split(b'"row":[')[1].split(b",")[0] for line in journal.read_bytes().splitlines()[1:]]
    assert len(numbers) == len(set(numbers)) == again.computed.count


def test_a_search_goes_on_where_it_was(tmp_path):
    file = tmp_path / "search.toml"
    file.write_text(cheap.study_text(160, "nsga2"))
    first = cheap.digest(explore(file, tmp_path / "a", executor=map))
    explore(file, tmp_path / "b", processes=2)
    journal = tmp_path / "b" / "cheap.journal"
    journal.write_bytes(journal.read_bytes()[: int(0.55 * journal.stat().st_size)])
    second = explore(file, tmp_path / "b", executor=map)
    assert cheap.digest(second) == first
    # Its best of the first objective is at 70, of the second at 60 with a wheelbase of 150.
    assert abs(second.front[0][cheap.A] - 70) < 0.1
    assert abs(second.front[1][cheap.A] - 60) < 0.5
    assert second.front[1][cheap.B] == 150


def test_a_worker_that_is_killed_loses_nothing(study, known, tmp_path, monkeypatch):
    monkeypatch.setenv("CHEAP_KILL", f"72 self {tmp_path / 'mark'}")
    assert cheap.digest(explore(study, tmp_path / "out", processes=2)) == known
    assert (tmp_path / "mark").exists()


@pytest.mark.slow
def test_a_design_that_kills_its_process_is_a_row(study, tmp_path, monkeypatch):
    monkeypatch.setenv("CHEAP_KILL", "72")
    computed = explore(study, tmp_path, processes=2)
    rows = list(computed.computed.rows())
    died = [row for row in rows if "died each time" in row.sentence]
    assert died
    assert all(abs(row.values[0] - 72) < 0.05 for row in died)
    assert sum(abs(row.values[0] - 72) < 0.05 for row in rows) == len(died)


@pytest.mark.slow
@pytest.mark.long
def test_the_main_process_killed_twice_and_run_again(study, known, tmp_path):
    out = tmp_path / "out"
    rows = explore(study, tmp_path / "rows", executor=map).computed
    for place in (str(rows.row(60).values[0]), str(rows.row(150).values[0]), ""):
        killing = f"{place} parent {tmp_path / f'mark{place}'}" if place else ""
        done = subprocess.run(
            [sys.executable, "-m", "tests.exploration.cheap", str(study), str(out), "2"],
            cwd=ROOT,
            env={**os.environ, "CHEAP_KILL": killing},
            capture_output=True,
            text=True,
        )
        assert done.returncode == (-9 if place else 0), done.stderr
    assert cheap.digest(explore(study, out, executor=map)) == known
    one, two = explore(study, tmp_path / "else", executor=map).write(), sorted(out.iterdir())
    same = [file.name for file in one if (out / file.name).read_bytes() == file.path.read_bytes()]
    assert len(same) == len(one) == len([file for file in two if file.name not in ("manifest.json", "cheap.journal")])


def test_a_crash_is_a_row_with_its_sentence(study, tmp_path):
    rows = list(explore(study, tmp_path, executor=map).computed.rows())
    crashed = [row for row in rows if row.state == "crashed"]
    assert crashed
    assert {row.sentence for row in crashed} == {"a fault in cadgen (RuntimeError: no design at all)"}
    assert all((66 < row.values[0] < 67) == (row in crashed) for row in rows)


def test_a_design_that_takes_too_long_is_a_row(tmp_path):
    file = tmp_path / "late.toml"
    file.write_text(cheap.study_text(40, record=("cheap_hang_mm",)) + "\n[each]\nseconds = 0.2\n")
    rows = list(explore(file, tmp_path, executor=map).computed.rows())
    late = [row for row in rows if row.state != "kept"]
    assert [row.sentence for row in late] == ["it took longer than 0.2 s (each.seconds)"] * len(late)
    assert {row.state for row in late} == {"crashed"}
    assert [row for row in rows if 66 < row.values[0] < 67] == late != []


@pytest.mark.skipif(sys.platform != "linux", reason="only there the memory of a process can be limited")
def test_a_design_that_takes_too_much_memory_is_a_row(tmp_path):
    file = tmp_path / "greedy.toml"
    file.write_text(cheap.study_text(40, record=("cheap_greedy_mm",)) + "\n[each]\nmemory_mb = 500\n")
    rows = list(explore(file, tmp_path, processes=1).computed.rows())
    greedy = [row for row in rows if row.state == "crashed"]
    assert [row.sentence for row in greedy] == ["it ran out of memory (each.memory_mb)"] * len(greedy)
    assert [row for row in rows if 66 < row.values[0] < 67] == greedy != []


def test_the_same_folder_twice_in_one_process(study, known, tmp_path):
    first = explore(study, tmp_path, executor=map)
    assert cheap.digest(explore(study, tmp_path, executor=map)) == cheap.digest(first) == known


def test_one_run_at_a_time(study, tmp_path):
    with ThreadPoolExecutor(1) as other:
        held: list[str] = []

        class Meanwhile:
            def submit(self, function, batch):
                if not held:
                    held.append("")
                    with pytest.raises(FileError, match="another run is at work"):
                        explore(study, tmp_path, executor=map)
                return other.submit(function, batch)

        explore(study, tmp_path, executor=Meanwhile())
    assert held
