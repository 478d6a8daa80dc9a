"""Output folders: everything or nothing, whatever ends the run."""

import os
import platform
import signal
import subprocess
import sys
import textwrap

import pytest

from cadgen.errors import FileError
from cadgen.export.folder import abandon, publishing
from cadgen.export.manifest import write_manifest

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def contents(folder):
    return {str(file.relative_to(folder)) for file in folder.rglob("*")}


def publish(folder, number, *, block="", moving=""):
    """Publish two files in another process, to which code in the block, or while it is moving, sends a signal."""
    script = f"""
        import ctypes, os, signal
        from pathlib import Path
        signal.signal(signal.{number.name}, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        from cadgen.cli import interrupt
        from cadgen.export import folder
        interrupt.install()

        def strike():
            os.kill(os.getpid(), signal.{number.name})
            sum(range(1000))

        struck_from_c = ctypes.CFUNCTYPE(None)(strike)
        move = folder._move
        folder._move = lambda staging, out: [{moving or None}, move(staging, out)]
        with folder.publishing(Path("made/out")) as staging:
            (staging / "a").write_text("new")
            {block or "pass"}
            (staging / "b").write_text("new")
        print("finished")
    """
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "TERM": "dumb"}
    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(script)], cwd=folder, capture_output=True, text=True, env=environment
    )


@pytest.mark.parametrize("number", SIGNALS)
@pytest.mark.parametrize("where", ["strike()", "struck_from_c()"])
def test_a_signal_ends_the_run_and_leaves_nothing(tmp_path, number, where):
    """Also amid code of a library in C, which would swallow an exception."""
    run = publish(tmp_path, number, block=where)
    assert (run.returncode, run.stdout) == (130, "")
    assert run.stderr == "cadgen: interrupted: nothing was written\n"
    assert contents(tmp_path) == set()


@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_that_comes_too_late_lets_the_run_finish(tmp_path, number):
    run = publish(tmp_path, number, moving="strike()")
    assert (run.returncode, run.stdout, run.stderr) == (0, "finished\n", "")
    assert contents(tmp_path) == {"made", "made/out", "made/out/a", "made/out/b"}


def test_a_killed_run_is_cleared_away_by_the_next(tmp_path):
    run = publish(tmp_path, signal.SIGTERM, block="os.kill(os.getpid(), signal.SIGKILL)")
    assert run.returncode == -signal.SIGKILL
    out = tmp_path / "made" / "out"
    (left,) = out.iterdir()
    others = f".cadgen-{os.getppid()}-{platform.node()}"
    for name in (others, f"{left.name}-elsewhere", ".cadgen-notes"):
        (out / name).mkdir()
    with publishing(out) as staging:
        (staging / "mine").write_text("new")
    # Runs that live, runs of other machines, and what is not ours stay.
    assert contents(out) == {"mine", others, f"{left.name}-elsewhere", ".cadgen-notes"}


def test_what_a_run_killed_amid_moving_had_replaced_is_put_back(tmp_path):
    (tmp_path / "made/out").mkdir(parents=True)
    (tmp_path / "made/out/a").write_text("old")
    (tmp_path / "made/out/b").write_text("old")
    strike = "setattr(Path, 'is_dir', lambda file: file.name == 'b' and os.kill(os.getpid(), signal.SIGKILL))"
    run = publish(tmp_path, signal.SIGTERM, moving=strike)
    assert run.returncode == -signal.SIGKILL
    assert (tmp_path / "made/out/a").read_text() == "new"
    with publishing(tmp_path / "made/out") as staging:
        (staging / "c").write_text("new")
    assert contents(tmp_path / "made/out") == {"a", "b", "c"}
    assert (tmp_path / "made/out/a").read_text() == (tmp_path / "made/out/b").read_text() == "old"


def test_a_failure_leaves_no_folder_on_the_way(tmp_path):
    (tmp_path / "kept").mkdir()

    def fail():
        with publishing(tmp_path / "kept/made/out") as staging:
            (staging / "a").write_text("half")
            raise MemoryError

    with pytest.raises(MemoryError):
        fail()
    assert contents(tmp_path) == {"kept"}
    assert abandon()


@pytest.mark.parametrize("name", ["x" * 300, "x/" * 3000])
def test_a_name_that_no_folder_can_have(tmp_path, name):
    with pytest.raises(FileError, match=r"choose .* --out"), publishing(tmp_path / name):
        pass
    assert contents(tmp_path) == set()


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written_to(tmp_path):
    os.chmod(tmp_path, 0o555)
    try:
        for out in (tmp_path, tmp_path / "below"):
            with pytest.raises(FileError, match="no permission to write there"), publishing(out):
                pass
    finally:
        os.chmod(tmp_path, 0o755)
    assert contents(tmp_path) == set()


@pytest.mark.parametrize(
    "part",
    [
        '{"files": {"b": 5}}',
        '{"files": ["b"]}',
        '{"files": {"b": {"sha256": NaN}}}',
        '{"files": {}, "value": 1e999}',
        '{"files": {"' + "n" * 300 + '": {}}}',
        '{"files": {"\\ud800": {}}}',
        "[]",
        "[" * 5000,
    ],
)
def test_a_damaged_entry_of_the_manifest_is_dropped(tmp_path, part):
    out, staging = tmp_path / "out", tmp_path / "staging"
    out.mkdir()
    staging.mkdir()
    (out / "b").write_text("kept")
    (out / "manifest.json").write_text(f'{{"format": 1, "parts": {{"old": {part}}}}}')
    write_manifest(staging, out, "new", {"files": {}})
    assert '"new"' in (staging / "manifest.json").read_text()
    assert '"old"' not in (staging / "manifest.json").read_text()
