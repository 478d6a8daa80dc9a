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
    pytest.importorskip("playwright.sync_api", reason="no playwright: pip install '.[test]' in the clone")
    return path


def serious_faults(page, *parts):
    """Return the serious faults that axe-core finds on a page, or in parts of it; skip the test without axe-core.

    Args:
        page: page in the browser.
        parts: selector of each part.
    """
    sync = pytest.importorskip("axe_playwright_python.sync_playwright", reason="no axe: pip install '.[test]'")
    return [
        (violation["id"], [node["target"] for node in violation["nodes"]][:4])
        for violation in sync.Axe().run(page, context=[[part] for part in parts] or None).response["violations"]
        if violation["impact"] in ("serious", "critical")
    ]
