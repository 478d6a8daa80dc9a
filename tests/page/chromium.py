"""Chromium of the system for tests and benchmark of the page: where it is, and how it is started."""

import os
import shutil

import pytest

ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
READY = "html[data-ready=all]"
NAMES = ("chromium", "chromium-browser", "google-chrome")


def chromium_path() -> str:
    """Path of a Chromium that playwright can drive; the test is skipped where there is none."""
    path = os.environ.get("CADGEN_CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.skip("no Chromium: install your system's, or name one in CADGEN_CHROMIUM")
    pytest.importorskip("playwright.sync_api", reason="no playwright: install cadgen[test]")
    return path
