"""One plan and one page of the paper's car for all tests of the page; Chromium where there is one."""

from pathlib import Path

import pytest

from cadgen.design.load import complete_of, load_design
from cadgen.viewer.page.car_page import plan_page
from cadgen.viewer.page.html import html_of
from cadgen.viewer.page.page_plan import plan_motion_page
from cadgen.viewer.page.report import page_of
from tests.cam.test_roller import TEXT
from tests.viewer.page.chromium import chromium_path

SAMPLES = 60


@pytest.fixture(scope="session")
def plan():
    return plan_page(load_design("carbon_free_car"), samples=SAMPLES)


@pytest.fixture(scope="session")
def page(plan):
    return page_of(plan)


@pytest.fixture(scope="session")
def html(page):
    return html_of(page)


@pytest.fixture
def failing(minimal, written):
    """Plan and page of a small design that fails a check."""
    plan = plan_page(load_design(written(minimal), ["checks.min_convex_radius_mm=100"]))
    return plan, html_of(page_of(plan))


@pytest.fixture(scope="session")
def chromium():
    """Path of a Chromium; the tests that need it are skipped where there is none."""
    return chromium_path()


@pytest.fixture
def feeder():
    """A design by its motion with a roller, offset on its slide."""
    return lambda changes=(): plan_motion_page(complete_of(TEXT, Path("feeder.toml"), list(changes)))
