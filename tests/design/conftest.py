"""Designs for the tests: the shortest valid one, and files made of text or tables."""

from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
import tomli_w

Tables = dict[str, Any]

_MINIMAL: Tables = {
    "path": {"waypoints_mm": [[0, 0], [1500, 200], [2600, 1200], [4000, 1500], [5500, 1000]]},
    "car": {"wheelbase_mm": 167, "drive_wheel_offset_mm": 37, "idle_wheel_offset_mm": 201},
    "cam": {"base_radius_mm": 70, "mid_plane_mm": 25, "thickness_mm": 3},
    "follower": {"radius_mm": 2.5},
}


@pytest.fixture
def minimal() -> Tables:
    """The shortest design, as tables that a test may change."""
    return deepcopy(_MINIMAL)


@pytest.fixture
def written(tmp_path: Path) -> Callable[[str | bytes | Tables], Path]:
    """Write a design file from text, bytes or tables and return its path."""

    def write(content: str | bytes | Tables) -> Path:
        file = tmp_path / "mine.toml"
        if isinstance(content, dict):
            content = tomli_w.dumps(content)
        file.write_bytes(content.encode() if isinstance(content, str) else content)
        return file

    return write
