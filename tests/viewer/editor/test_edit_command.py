"""`cadgen edit` as a user meets it: address, Ctrl-C, a port that is taken, no extra, bad designs."""

import signal
import socket
import subprocess
import sys
from urllib.error import HTTPError
from urllib.request import urlopen

import pytest
from click.testing import CliRunner

from cadgen.api.views import Editor
from cadgen.cli.page_commands import edit
from cadgen.errors import DesignError, FileError


@pytest.fixture
def no_server(monkeypatch):
    """An installation without the extra."""
    monkeypatch.delitem(sys.modules, "cadgen.viewer.editor.server", raising=False)
    monkeypatch.setitem(sys.modules, "uvicorn", None)


def test_without_the_extra_a_sentence_says_what_to_install(no_server, file):
    with pytest.raises(DesignError, match=r"needs uvicorn, which is not installed: pip install '\.\[edit\]'"):
        Editor.open(file).serve()


def test_a_port_that_is_taken(file):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(FileError, match=rf"port {port} cannot be used \(.*\): choose another one"):
            Editor.open(file).serve(port, browser=False)


@pytest.mark.parametrize("port", [-1, 65536, 1.5])
def test_a_port_that_is_none(file, port):
    with pytest.raises(DesignError, match="port"):
        Editor.open(file).serve(port)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [(["none.toml"], "there is no design file"), (["none"], "no packaged design"), (["--set", "x=1"], "not a key")],
)
def test_a_design_that_is_none_is_refused_before_anything_is_served(arguments, words):
    result = CliRunner().invoke(edit, arguments)
    assert isinstance(result.exception, DesignError)
    assert words in str(result.exception)


def test_the_face_of_the_editor(file):
    editor = Editor.open(file, {"cam.thickness_mm": 3.2})
    assert editor.unsaved
    assert editor.design.values.cam.thickness_mm == 3.2
    assert repr(editor) == "<Editor of small, unsaved changes>"


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C of a child is another thing there")
def test_it_serves_until_it_is_interrupted(file):
    command = [sys.executable, "-u", "-m", "cadgen", "edit", str(file), "--no-browser", "--set", "cam.thickness_mm=3.2"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=_heed_interrupts
    ) as served:
        try:
            address = served.stdout.readline().split()[0]
            assert address.startswith("http://127.0.0.1:")
            with urlopen(address) as answer:
                assert b"connect-src" in answer.read()
            with pytest.raises(HTTPError, match="403"):
                urlopen(address.rsplit("/", 2)[0] + "/")
            served.send_signal(signal.SIGINT)
            out, err = served.communicate(timeout=60)
        finally:
            served.kill()
    assert (served.returncode, out, err) == (0, "ended; changes that were not saved are gone\n", "")


def _heed_interrupts():
    """A process that a shell starts in the background ignores Ctrl-C, and so do its children; this one does not."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
