"""`python -c` without the wait: scripts run in forks of a process that has loaded the program.

Loading the program with its libraries takes longer than most commands run. A fork has arguments, folder, environment,
signals and an exit code of its own, as any process. What it shares with other forks is what was loaded and the order of
Python's sets, and it ends without taking its modules down: tests of those start Python itself.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path

MAIN = "from cadgen.cli import main; main()"
_ROOT = Path(__file__).parents[1]
_LONGEST = 300  # s; then a script is ended
_LOADED = (
    "cadgen.api.gears",
    "cadgen.cli.show_play",
    "cadgen.output.report.record_pictures",
    "cadgen.output.report.cars",
    "cadgen.output.report.cam_pictures",
    "cadgen.output.report.tracks",
    "cadgen.geometry.solids.disc_solid",
    "cadgen.geometry.solids.gear_solids",
    "cadgen.geometry.solids.gear_solids",
    "cadgen.jobs.calibration.files",
    "cadgen.jobs.cam.cam_files",
    "cadgen.jobs.gears.gear_train",
    "cadgen.jobs.simulation",
    "ezdxf",
    "lib3mf",
    "matplotlib.backends.backend_agg",
    "matplotlib.backends.backend_svg",
    "matplotlib.figure",
    "scipy.stats",
    "tomlkit",
    "trimesh",
)


class Forks:
    """A process that has loaded the program, and forks."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.forks"], cwd=_ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def run(
        self, script: str, *arguments: str, cwd: Path, env: Mapping[str, str] | None = None
    ) -> subprocess.CompletedProcess[str]:
        """Run a script to its end, as `python -c SCRIPT ARGUMENTS` does.

        Args:
            script: Python.
            arguments: of the script.
            cwd: folder to run in.
            env: whole environment; this process's own if left out.
        """
        assert self._process.stdin
        assert self._process.stdout
        with tempfile.TemporaryDirectory() as folder:
            streams = Path(folder, "stdout"), Path(folder, "stderr")
            job = {
                "script": script,
                "arguments": arguments,
                "cwd": str(cwd),
                "env": dict(os.environ if env is None else env),
                "streams": [str(stream) for stream in streams],
            }
            print(json.dumps(job), file=self._process.stdin, flush=True)
            code = int(self._process.stdout.readline())
            return subprocess.CompletedProcess([*arguments], code, *(stream.read_text() for stream in streams))

    def close(self) -> None:
        """End the process."""
        self._process.communicate()


def _become(script: str, arguments: list[str], cwd: str, env: dict[str, str], streams: list[str]) -> None:
    """Be the process that runs the script."""
    signal.alarm(_LONGEST)
    for number, name in enumerate(streams, 1):
        os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT, 0o600), number)
    os.chdir(cwd)
    os.environ.clear()
    os.environ.update(env)
    sys.argv = ["-c", *arguments]
    exec(compile(script, "<string>", "exec"), {"__name__": "__main__"})


def _serve() -> None:
    for name in _LOADED:
        import_module(name)
    for line in sys.stdin:
        process = get_context("fork").Process(target=_become, kwargs=json.loads(line))
        process.start()
        process.join()
        print(process.exitcode, flush=True)


if __name__ == "__main__":
    _serve()
