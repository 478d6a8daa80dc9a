"""Commands on a Python that lacks what Windows lacks: forks, signals, `fcntl`, `resource`, flags of `os.open`.

The names are taken away, and the rooms that ask for the system are told that it is Windows. Paths and the file system
stay those of this machine.
"""

import subprocess
import sys
from pathlib import Path

import pytest

# In a file of its own, since processes that begin anew import the main module.
SCRIPT = """
import asyncio, multiprocessing, multiprocessing.popen_spawn_posix, os, shutil, signal, subprocess, sys, tempfile

import filelock
from types import SimpleNamespace

for name in ("fcntl", "resource", "pwd", "grp", "termios"):
    sys.modules[name] = None
for name in "fork geteuid getuid O_NOFOLLOW O_NONBLOCK O_DIRECTORY sched_getaffinity fchmod killpg".split():
    delattr(os, name)
for name in "SIGALRM SIGHUP SIGKILL SIGPROF SIGQUIT SIGPIPE setitimer ITIMER_REAL ITIMER_PROF".split():
    delattr(signal, name)
multiprocessing.get_all_start_methods = lambda: ["spawn"]

import cadgen.processes, cadgen.studies.design_row, cadgen.studies.results

windows = SimpleNamespace(**{**vars(sys), "platform": "win32"})
for module in (cadgen.processes, cadgen.studies.design_row, cadgen.studies.results):
    module.sys = windows

if __name__ == "__main__":
    from cadgen.cli import main

    main()
"""


@pytest.mark.slow
@pytest.mark.long
def test_commands_work_without_what_windows_lacks(tmp_path: Path) -> None:
    script = tmp_path / "windows.py"
    script.write_text(SCRIPT, encoding="utf-8")
    for words in (
        "check roller",
        "cam roller --formats step,csv --out exports",
        "gears s_course --formats stl,csv --out exports",
        "verify exports",
        "tolerance s_course --samples 20 --processes 2",
    ):
        done = subprocess.run(
            [sys.executable, str(script), *words.split()], cwd=tmp_path, capture_output=True, text=True, timeout=200
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert "Traceback" not in done.stderr
