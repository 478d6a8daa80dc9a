"""Benchmarks run in this process: beside others their figures would mean nothing."""

import pytest


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Undo the project's way of sharing tests among processes, with which pytest-benchmark measures nothing."""
    config.option.dist = "no"
