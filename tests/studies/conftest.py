"""Slices of the studies stay apart from the suite: `pytest -m study`, or among the long tests."""

from pathlib import Path

import pytest


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark every test of this folder before tests are chosen by their marks."""
    for item in items:
        if Path(__file__).parent in item.path.parents:
            for mark in ("study", "long", "slow"):
                item.add_marker(mark)
