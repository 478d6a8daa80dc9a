"""A slice of the study of known play and friction."""

import numpy as np

from tests.studies import falls


def test_the_driver_of_files_agrees_with_friction_worked_out_elsewhere():
    """The plain lift where friction holds the cam: the driver's car goes where the wanted steering takes it."""
    driver = falls._driver("carbon_free_car")
    still = driver.off(driver._planned, np.radians(0.3), 0.9)
    assert np.abs(still).max() < 0.2


def test_a_case_on_a_path_with_many_falls():
    found = falls.falls_case(0, "s_course", 1)
    assert found["end"] <= falls.MOST_END
    assert found["way"] <= falls.MOST_WAY
    assert found["plain"] > 50.0
    text = falls.page(1, 1, {(0, "s_course"): found})
    assert "| s_course | 100.0 % of 1" in text
