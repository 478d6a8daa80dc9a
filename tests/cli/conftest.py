"""Run the command as a user does, in a process of its own."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.forks import MAIN


@pytest.fixture
def cadgen(forks, tmp_path):
    """Call `cadgen` with arguments in an empty folder; with `fresh`, by starting Python for it."""

    def run(
        *arguments: str, code: int, cwd: Path = tmp_path, fresh: bool = False, script: str = MAIN
    ) -> subprocess.CompletedProcess[str]:
        env = {**os.environ, "COLUMNS": "80"}
        if fresh:
            command = [sys.executable, "-c", script, *arguments]
            result = subprocess.run(command, cwd=cwd, capture_output=True, text=True, env=env, timeout=300)
        else:
            result = forks.run(script, *arguments, cwd=cwd, env=env)
        assert result.returncode == code, result.stdout + result.stderr
        assert "Traceback" not in result.stderr
        return result

    return run


def one_sentence(result: subprocess.CompletedProcess[str]) -> str:
    """The single line that a failed command says."""
    lines = result.stderr.strip().splitlines()
    assert len(lines) == 1, result.stderr
    assert lines[0].startswith("cadgen: ")
    return lines[0]
