"""The named limits of the pressure angle against their sources."""

from math import degrees

import pytest

from cadgen.cam.limits import PRESSURE_ANGLE_LIMITS, PressureAngleLimitName


def test_every_name_has_its_limit() -> None:
    assert tuple(PRESSURE_ANGLE_LIMITS) == tuple(PressureAngleLimitName)


@pytest.mark.parametrize(
    ("name", "rise_deg", "fall_deg", "source"),
    [
        ("norton_translating", 30, 30, "Norton"),
        ("norton_oscillating", 35, 35, "Norton"),
        ("chinese_texts_strict", 40, 70, "Chinese"),
        ("chinese_texts", 50, 80, "Chinese"),
    ],
)
def test_limits_in_degrees(name: PressureAngleLimitName, rise_deg: float, fall_deg: float, source: str) -> None:
    limit = PRESSURE_ANGLE_LIMITS[name]
    assert degrees(limit.rise) == pytest.approx(rise_deg)
    assert degrees(limit.fall) == pytest.approx(fall_deg)
    assert source in limit.source


def test_limits_cannot_be_changed() -> None:
    with pytest.raises(TypeError):
        PRESSURE_ANGLE_LIMITS["mine"] = PRESSURE_ANGLE_LIMITS["chinese_texts"]  # type: ignore[index]
