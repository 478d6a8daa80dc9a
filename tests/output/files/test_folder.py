"""Output folders: everything or nothing, whatever ends the run."""

import errno
import hashlib
import json
import multiprocessing
import os
import re
import signal
import stat

import pytest

from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.output.files import folder, lock
from cadgen.output.files.folder import abandon, folder_state, left_by_killed, publishing
from cadgen.output.files.lock import is_held, locked
from cadgen.output.files.manifest import file_facts, write_manifest
from cadgen.output.files.publisher import verify
from tests.forks import MAIN

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


@pytest.fixture
def cli(forks, tmp_path):
    """Run the command as users do."""

    def run(*arguments, code):
        process = forks.run(MAIN, *arguments, cwd=tmp_path)
        assert process.returncode == code, process.stdout + process.stderr
        return process

    return run


def contents(folder):
    return {str(file.relative_to(folder)) for file in folder.rglob("*")}


def put(folder, part, **files):
    """Publish files under a part's name, in this process."""
    with publishing(folder) as staging:
        for name, content in files.items():
            (staging / name).write_text(content)
        write_manifest(staging, part, Facts(files={name: file_facts(staging / name) for name in files}))


def test_files_of_an_earlier_version_of_a_design_are_named(tmp_path):
    for sha256, names in (
        ("a1", ("cam.step", "cam.nc", "cam.json", "cam.csv")),
        ("b2", ("cam.step",)),
        ("c3", ("costs.csv",)),  # a table of changes by --set makes no part older, and is none
    ):
        with publishing(tmp_path) as staging:
            for name in names:
                (staging / name).write_text(sha256)
            facts = {name: file_facts(staging / name) for name in names}
            write_manifest(staging, f"cam_{sha256}", Facts(design="cam", design_sha256=sha256, files=facts))
    assert folder_state(tmp_path).older == {"cam.nc": "cam", "cam.csv": "cam"}


def states(folder):
    return {file.name: file.state for file in folder_state(folder).files}


def listed(folder):
    """The manifest's files with their hashes, read without the program's own code."""
    parts = json.loads((folder / "manifest.json").read_text())["parts"]
    return {name: facts["sha256"] for part in parts.values() for name, facts in part["files"].items()}


def is_true(folder):
    return all(hashlib.sha256((folder / n).read_bytes()).hexdigest() == h for n, h in listed(folder).items())


@pytest.fixture
def publish(forks):
    """Publish two files in another process, to which code in the block, or while it is moving, sends a signal."""

    def run(folder, number, *, block="", moving=""):
        script = _PUBLISHING.format(number=number.name, block=block or "pass", moving=moving or None)
        environment = os.environ | {"TERM": "dumb"}
        return forks.run(script, cwd=folder, env=environment)

    return run


_PUBLISHING = """
import ctypes, os, signal
from pathlib import Path
signal.signal(signal.{number}, signal.SIG_DFL)
signal.signal(signal.SIGINT, signal.default_int_handler)
from cadgen.cli import interrupt
from cadgen import figures
from cadgen.output.files import folder, manifest
interrupt.install()

def strike():
    os.kill(os.getpid(), signal.{number})
    sum(range(1000))

struck_from_c = ctypes.CFUNCTYPE(None)(strike)
move = folder._publish
folder._publish = lambda staging, out: [{moving}, move(staging, out)]
with folder.publishing(Path("made/out")) as staging:
    (staging / "a").write_text("new")
    {block}
    (staging / "b").write_text("new")
    files = {{name: manifest.file_facts(staging / name) for name in ("a", "b")}}
    manifest.write_manifest(staging, "part", figures.Facts(files=files))
print("finished")
"""


@pytest.mark.parametrize("number", SIGNALS)
@pytest.mark.parametrize("where", ["strike()", "struck_from_c()"])
def test_a_signal_ends_the_run_and_leaves_nothing(tmp_path, publish, number, where):
    """Also amid code of a library in C, which would swallow an exception."""
    run = publish(tmp_path, number, block=where)
    assert (run.returncode, run.stdout) == (130, "")
    assert run.stderr == "cadgen: interrupted: nothing was written\n"
    assert contents(tmp_path) == set()


@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_that_comes_too_late_lets_the_run_finish(tmp_path, publish, number):
    run = publish(tmp_path, number, moving="strike()")
    assert (run.returncode, run.stdout, run.stderr) == (0, "finished\n", "")
    assert contents(tmp_path) == {"made", "made/out", "made/out/a", "made/out/b", "made/out/manifest.json"}


def test_a_killed_run_is_cleared_away_by_the_next(tmp_path, publish):
    run = publish(tmp_path, signal.SIGTERM, block="os.kill(os.getpid(), signal.SIGKILL)")
    assert run.returncode == -signal.SIGKILL
    out = tmp_path / "made" / "out"
    (left,) = out.iterdir()
    assert left_by_killed(out) == ([], [left])
    with publishing(out) as other:  # a run that lives
        for name in (".cadgen-notes", f"{left.name}-mine"):
            (out / name).mkdir()
        (out / ".cadgen-0123456789abcdef").symlink_to(tmp_path / "made", target_is_directory=True)
        put(out, "part", mine="new")
        assert contents(out) >= {other.name, ".cadgen-notes", f"{left.name}-mine", ".cadgen-0123456789abcdef"}
        assert left.name not in contents(out)
        assert left_by_killed(out) == ([], [])
        write_manifest(other, "none", Facts(files={}))


@pytest.mark.parametrize("restore", [False, True])
def test_what_a_run_killed_amid_moving_had_replaced_is_put_back(tmp_path, publish, cli, restore):
    out = tmp_path / "made/out"
    put(out, "part", a="old", b="old")
    put(out, "other", c="old")
    before = {file.name: file.read_bytes() for file in out.iterdir()}
    kill = "lambda a, b, r=os.replace: os.kill(os.getpid(), signal.SIGKILL) if b.name == 'b' else r(a, b)"
    run = publish(tmp_path, signal.SIGTERM, moving=f"setattr(os, 'replace', {kill})")
    assert run.returncode == -signal.SIGKILL
    # Half moved: said, and what the manifest lists is true all the same.
    assert (out / "a").read_text() == "new"
    assert is_true(out)
    assert set(listed(out)) == {"c"}
    result = cli("verify", str(out), code=1)
    assert "A run was killed while it moved its files into this folder" in result.stdout
    assert json.loads(cli("verify", str(out), "--json", code=1).stdout)["half_moved"]
    if restore:
        assert "Put back as before a run that was killed: a" in cli("verify", str(out), "--restore", code=0).stdout
        assert {file.name: file.read_bytes() for file in out.iterdir()} == before
    put(out, "third", d="new")
    assert {name: (out / name).read_text() for name in "abcd"} == {"a": "old", "b": "old", "c": "old", "d": "new"}
    assert set(states(out).values()) == {"as listed"}
    assert contents(out) == {*"abcd", "manifest.json"}


def test_what_others_have_put_in_place_of_a_half_moved_file_stays(tmp_path, publish):
    out = tmp_path / "made/out"
    put(out, "part", a="old", b="old")
    kill = "lambda a, b, r=os.replace: os.kill(os.getpid(), signal.SIGKILL) if b.name == 'b' else r(a, b)"
    publish(tmp_path, signal.SIGTERM, moving=f"setattr(os, 'replace', {kill})")
    (out / "a").write_text("mine")
    put(out, "third", d="new")
    assert (out / "a").read_text() == "mine"
    assert listed(out).keys() == {"d"}


def test_a_move_that_fails_is_undone_and_says_why(tmp_path, monkeypatch):
    put(tmp_path, "part", a="old", b="old")
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    replace = os.replace

    def fail(source, target):
        if target == tmp_path / "b" and source.parent.name.startswith(".cadgen"):
            monkeypatch.setattr(os, "replace", replace)
            raise PermissionError(13, "in use")
        replace(source, target)

    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(FileError, match="no permission to write there"):
        put(tmp_path, "part", a="new", b="new")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == before


def kill_amid_moving(monkeypatch, number, action):
    """Do something, and stop as if killed before the nth move; whether it came that far."""
    replace, calls = os.replace, iter(range(number))

    def stop(source, target):
        if target.parent.name == "out" or source.parent.name == "out":
            next(calls)  # StopIteration: killed
        replace(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", stop)
        patch.setattr(folder, "_undo", lambda staging, out: [])
        try:
            action()
        except (StopIteration, RuntimeError):
            return True
    return False


@pytest.mark.parametrize("damage", ["", "[", "[]", '{"a": 5}', "[" * 100_000, "\0" * 40, None])
@pytest.mark.parametrize("manifest", ["sound", "lost"])
def test_a_damaged_record_of_a_half_done_move_is_healed(tmp_path, monkeypatch, damage, manifest):
    """As a disk leaves it when the power fails, wherever the move has stopped; what was there before is there again."""
    stops = 0
    for number in range(20):
        out = tmp_path / str(number) / "out"
        put(out, "part", a="old", b="old", same="same")
        put(out, "other", kept="kept")
        (out / "c").write_text("mine")
        before = {file.name: file.read_bytes() for file in out.iterdir()}
        if not kill_amid_moving(
            monkeypatch, number, lambda out=out: put(out, "part", a="new", c="new", new="new", same="same")
        ):
            break
        stops += 1
        (staging,) = out.glob(".cadgen-*")
        record = staging / ".replaced" / ".record.json"
        record.unlink() if damage is None else record.write_text(damage)
        if manifest == "lost":
            (staging / "manifest.json").write_text("")
        assert not verify(out).is_true
        state = verify(out, restore=True)
        assert state.is_true
        after = {file.name: file.read_bytes() for file in out.iterdir()}
        if manifest == "lost":  # a file that is new and stands in nobody's place cannot be known: it stays, unlisted
            after.pop("new", None)
        assert after == before
    assert stops > 6


def test_the_record_is_on_the_disk_before_anything_is_moved(tmp_path, monkeypatch):
    synced, replace = set(), os.replace
    sync = os.fsync

    def noted(descriptor):
        synced.add(os.fstat(descriptor).st_ino)
        sync(descriptor)

    def moving(source, target):
        if target.parent == tmp_path:
            (record,) = tmp_path.glob(".cadgen-*/.replaced/.record.json")
            assert record.stat().st_ino in synced
        replace(source, target)

    monkeypatch.setattr(os, "fsync", noted)
    monkeypatch.setattr(os, "replace", moving)
    put(tmp_path, "part", a="new")
    assert contents(tmp_path) == {"a", "manifest.json"}


def test_links_are_replaced_and_not_followed(tmp_path):
    out, elsewhere = tmp_path / "out", tmp_path / "elsewhere"
    out.mkdir()
    elsewhere.write_text("theirs")
    (out / "a").symlink_to(elsewhere)
    (out / "b").symlink_to(tmp_path / "nowhere")
    (out / "manifest.json").symlink_to(elsewhere)
    put(out, "part", a="new", b="new")
    assert elsewhere.read_text() == "theirs"
    assert not (tmp_path / "nowhere").exists()
    assert not any(file.is_symlink() for file in out.iterdir())
    (out / "a").unlink()
    (out / "a").symlink_to(tmp_path / "copy")
    (tmp_path / "copy").write_text("new")  # the same bytes, but not the file that was read back
    assert states(out) == {"a": "changed", "b": "as listed"}
    put(out, "third", c="new")
    assert set(listed(out)) == {"c"}


@pytest.mark.skipif(os.name != "posix", reason="no such files there")
@pytest.mark.parametrize("plant", [lambda file: file.symlink_to("x"), os.mkfifo, os.mkdir], ids=["link", "pipe", "dir"])
def test_nothing_else_is_taken_for_the_lock(tmp_path, plant):
    out = tmp_path / "out"
    out.mkdir()
    plant(out / lock.NAME)
    with pytest.raises(FileError, match="the folder's lock must go there: remove it"):
        put(out, "part", a="new")
    assert contents(tmp_path) == {"out", f"out/{lock.NAME}"}


@pytest.mark.skipif(os.name != "posix", reason="no such modes there")
def test_the_lock_leaves_the_mode_of_a_file_that_it_did_not_make(tmp_path):
    (tmp_path / lock.NAME).touch()
    os.chmod(tmp_path / lock.NAME, 0o640)
    with locked(tmp_path):
        assert stat.S_IMODE((tmp_path / lock.NAME).stat().st_mode) == 0o640
    with locked(tmp_path):  # made by this run: whoever may write into the folder may wait for it
        assert stat.S_IMODE((tmp_path / lock.NAME).stat().st_mode) == 0o666


def test_a_lock_on_a_file_that_was_removed_meanwhile_is_none(tmp_path, monkeypatch):
    """Between opening and locking, the run before removes its file, and another run makes a new one."""
    lock_file, real, calls = tmp_path / lock.NAME, lock._lock, []

    def late(descriptor):
        if not calls:
            lock_file.unlink()
            lock_file.touch()
        calls.append(descriptor)
        return real(descriptor)

    monkeypatch.setattr(lock, "_lock", late)
    with locked(tmp_path) as sure:
        monkeypatch.setattr(lock, "_lock", real)
        assert sure
        assert is_held(lock_file)  # the file that is there, not the one that was
    assert len(calls) == 2


def _held_by_another(folder, taken, done):
    with locked(folder):
        taken.set()
        done.wait()


@pytest.fixture
def other_run(tmp_path):
    """Another process that holds the folder's lock until it is told to let go."""
    context = multiprocessing.get_context("fork")
    taken, done = context.Event(), context.Event()
    process = context.Process(target=_held_by_another, args=(tmp_path, taken, done), daemon=True)
    process.start()
    taken.wait()
    yield process, done
    process.kill()
    process.join()


def test_a_run_waits_for_another_with_a_sentence(tmp_path, other_run, caplog, monkeypatch):
    _, done = other_run
    wait = lock._wait
    monkeypatch.setattr(lock, "_wait", lambda *rest: (done.set(), wait(*rest)))
    put(tmp_path, "part", a="new")
    assert re.match(r"another run is moving its files into .*: waiting for it, at most 60 s", caplog.messages[0])
    assert contents(tmp_path) == {"a", "manifest.json"}


def test_a_run_that_waits_too_long_refuses(tmp_path, other_run):
    with pytest.raises(FileError, match="after the wait, so nothing was written"), locked(tmp_path, 0.01):
        pass
    process, _ = other_run
    process.kill()  # and the lock is gone with it, though its file is still there
    process.join()
    assert contents(tmp_path) == {lock.NAME}
    put(tmp_path, "part", a="new")
    assert contents(tmp_path) == {"a", "manifest.json"}


def test_a_folder_that_cannot_be_locked_is_said(tmp_path, caplog, monkeypatch):
    def unknown(*rest, **more):
        raise OSError(lock.errno.ENOLCK, "No locks available")

    monkeypatch.setattr(lock, "_lock", unknown)
    put(tmp_path, "part", a="new")
    assert "cannot be locked (No locks available): let no other run write into it" in caplog.messages[0]
    assert states(tmp_path) == {"a": "as listed"}
    assert contents(tmp_path) == {"a", "manifest.json"}


def test_without_locks_nothing_of_another_run_is_undone_or_removed(tmp_path, monkeypatch):
    """It may still be at work: a half-done move is refused, and a staging folder stays."""

    def unknown(descriptor):
        raise OSError(errno.ENOLCK, "No locks available")

    half, early = tmp_path / "half" / "out", tmp_path / "early"
    put(half, "part", a="old", b="old")
    assert kill_amid_moving(monkeypatch, 2, lambda: put(half, "part", a="new", b="new"))
    (early / ".cadgen-0123456789abcdef").mkdir(parents=True)
    (early / ".cadgen-0123456789abcdef" / "a").write_text("being written")
    before = {file: file.read_bytes() for file in half.rglob("*") if file.is_file()}
    with monkeypatch.context() as patch:
        patch.setattr(lock, "_lock", unknown)
        with pytest.raises(FileError, match=r"since this folder cannot be locked.*run cadgen verify --restore on it"):
            put(half, "other", c="new")
        assert {file: file.read_bytes() for file in half.rglob("*") if file.is_file()} == before
        put(early, "part", b="new")
        assert (early / ".cadgen-0123456789abcdef" / "a").read_text() == "being written"
        assert verify(half, restore=True).is_true  # the advice works without locks too
    assert (half / "a").read_text() == "old"
    put(early, "part", b="newer")
    assert contents(early) == {"b", "manifest.json"}


def test_only_what_the_manifest_lists_is_published(tmp_path):
    def publish_more():
        with publishing(tmp_path) as staging:
            (staging / "a").write_text("new")
            write_manifest(staging, "part", Facts(files={}))

    with pytest.raises(ValueError, match="does not list"):
        publish_more()
    assert contents(tmp_path) == set()


def test_staged_files_have_the_usual_rights(tmp_path):
    put(tmp_path, "part", a="new")
    (tmp_path / "by_hand").write_text("x")
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == stat.S_IMODE((tmp_path / "by_hand").stat().st_mode)
    assert not is_held(tmp_path / "no_such_file")


def test_each_state_is_told(tmp_path, cli):
    put(tmp_path, "part", a="1", b="2", c="3")
    (tmp_path / "a").write_text("x")
    (tmp_path / "b").unlink()
    (tmp_path / "own\x1b[31m").write_text("mine")
    assert states(tmp_path) == {"a": "changed", "b": "missing", "c": "as listed", "own\x1b[31m": "not listed"}
    printed = cli("verify", str(tmp_path), code=1).stdout
    assert "\x1b" not in printed
    assert "2 of 3 listed files are not as listed" in printed
    facts = json.loads(cli("verify", str(tmp_path), "--json", code=1).stdout)
    assert facts["files"][0] == {"name": "a", "part": "part", "state": "changed"}
    assert "no manifest.json" in cli("verify", str(tmp_path.parent), code=3).stderr
    cli("verify", str(tmp_path / "none"), code=3)
    (tmp_path / "manifest.json").write_text(
        '{"format": 1, "parts": {"x": {"files": {"../../a": {}, "/dev/zero": {}}}}}'
    )
    assert states(tmp_path)["/dev/zero"] == "missing"
    (tmp_path / "manifest.json").unlink()
    os.mkfifo(tmp_path / "manifest.json")
    assert "it is a pipe and no regular file" in cli("verify", str(tmp_path), code=3).stderr


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
    with pytest.raises(FileError, match=r"choose (another folder|a shorter one)$"), publishing(tmp_path / name):
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
    (tmp_path / "b").write_text("kept")
    (tmp_path / "manifest.json").write_text(f'{{"format": 1, "parts": {{"old": {part}}}}}')
    put(tmp_path, "new")
    assert json.loads((tmp_path / "manifest.json").read_text())["parts"] == {"new": {"files": {}}}


@pytest.mark.parametrize(("value", "kept"), [("1.5", {"old", "new"}), ("NaN", {"new"}), ("1e999", {"new"})])
def test_an_entry_of_true_files_with_no_number_is_dropped(tmp_path, value, kept):
    """Its file lies there with the hash that it lists, so only the value that JSON cannot write decides."""
    (tmp_path / "b").write_text("kept")
    sha256 = hashlib.sha256(b"kept").hexdigest()
    entry = f'{{"files": {{"b": {{"sha256": "{sha256}"}}}}, "value": {value}}}'
    (tmp_path / "manifest.json").write_text(f'{{"format": 1, "parts": {{"old": {entry}}}}}')
    put(tmp_path, "new")
    assert set(json.loads((tmp_path / "manifest.json").read_text())["parts"]) == kept
    assert (tmp_path / "b").read_text() == "kept"


def test_an_entry_keeps_the_files_that_a_later_run_leaves(tmp_path):
    put(tmp_path, "cam", step="old", dxf="old", csv="old")
    put(tmp_path, "cam_step", step="new")
    parts = json.loads((tmp_path / "manifest.json").read_text())["parts"]
    assert {name: set(part["files"]) for name, part in parts.items()} == {"cam": {"dxf", "csv"}, "cam_step": {"step"}}
    assert is_true(tmp_path)
    assert set(states(tmp_path).values()) == {"as listed"}
    # What was changed by hand since is no longer listed, and neither is what its entry says.
    (tmp_path / "dxf").write_text("touched")
    put(tmp_path, "cam_csv", csv="new")
    assert set(listed(tmp_path)) == {"step", "csv"}
