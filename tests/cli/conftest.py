"""Run the command as a user does, in a process of its own."""

import os
import subprocess
import sys
from pathlib import Path

import pytest


@pytest.fixture
def cadgen(tmp_path):
    """Call `cadgen` with arguments in an empty folder."""

    def run(*arguments: str, code: int, cwd: Path = tmp_path, **kwargs) -> subprocess.CompletedProcess[str]:
        result = subprocess.run(
            [sys.executable, "-c", "from cadgen.cli import main; main()", *arguments],
            cwd=cwd,
            capture_output=True,
            text=True,
            env={**os.environ, "COLUMNS": "80"},
            timeout=300,
            **kwargs,
        )
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
