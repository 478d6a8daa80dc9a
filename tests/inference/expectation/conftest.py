"""Measured files."""

from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def loop() -> Path:
    """Cars with two kinds of data, and floors that slope."""
    return Path(__file__).parents[2] / "data" / "loop"
