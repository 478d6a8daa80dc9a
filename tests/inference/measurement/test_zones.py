"""The three means of the paper's section 5, by hand."""

import numpy as np
import pytest

from cadgen.errors import FileError
from cadgen.inference.measurement.kinds.zones import judged, return_error, shortfall
from cadgen.inference.records.load import load


def test_return_error_of_the_papers_three_means(measured):
    zones = return_error(load(measured / "paper_section5.csv"), (0.962, 0.724))
    # Weights are equal but for one standard deviation of 0.69: half the difference of jump and reverse, nearly.
    assert zones.return_error_deg == pytest.approx((114.19 - 112.58) / 2, abs=2e-4)
    assert zones.sigma_deg == pytest.approx(np.hypot(0.068, 0.069) / 2, rel=1e-3)
    assert zones.interval_deg == pytest.approx((0.710, 0.900), abs=1e-3)
    # The means leave one number over: smooth against the middle of the other two.
    assert zones.misfit == pytest.approx((113.37 - 113.385) / np.sqrt(0.068**2 + (0.068**2 + 0.069**2) / 4), abs=1e-3)
    before, after = zones.compared
    assert not before.inside
    assert after.inside
    assert before.apart == pytest.approx((0.805 - 0.962) / 0.0484, abs=0.02)


def test_shortfall_of_the_smooth_zone(measured):
    zones = return_error(load(measured / "paper_section5.csv"))
    why = shortfall(zones, rpm=60.0, seconds=15.0, ratio=45.0)
    assert why.expected_deg == pytest.approx(120.0)
    assert why.missing_deg == pytest.approx(6.62, abs=0.02)
    assert why.lost_time_s == pytest.approx(15 * (1 - 113.38 / 120), abs=1e-3)
    assert why.ratio == pytest.approx(45 * 120 / 113.38, abs=1e-2)


def test_unknown_zones_are_refused(tmp_path):
    path = tmp_path / "zones.csv"
    path.write_text("zone,cam_angle_deg,std_deg,n\nsmooth,113,0.7,100\nsteep,114,0.7,100\n")
    with pytest.raises(FileError, match="smooth, steep; give smooth, jump, reverse, each at least once"):
        return_error(load(path))


def _zones(tmp_path, *rows):
    path = tmp_path / "zones.csv"
    path.write_text("zone,cam_angle_deg,std_deg,n\n" + "\n".join(rows) + "\n")
    return load(path)


def test_zones_measured_twice_count_twice(tmp_path, measured):
    once = return_error(load(measured / "paper_section5.csv"))
    rows = ["smooth,113.37,0.68,100", "jump,114.19,0.68,100", "reverse,112.58,0.69,100"]
    twice = return_error(_zones(tmp_path, *rows, *rows))
    assert twice.return_error_deg == pytest.approx(once.return_error_deg)
    assert twice.sigma_deg == pytest.approx(once.sigma_deg / np.sqrt(2))


def test_verdicts_on_zones(tmp_path):
    def verdict(jump, reverse):
        record = _zones(tmp_path, "smooth,113,0.7,100", f"jump,{jump},0.7,100", f"reverse,{reverse},0.7,100")
        return judged(record, return_error(record))[0]

    assert verdict(114.0, 112.0).claimed == ("return error",)
    assert (verdict(113.05, 112.95).verdict, verdict(113.05, 112.95).claimed) == ("none", ())
    # Both zones turned farther than the smooth one, by ten standard errors: no return error does that.
    assert (verdict(114.5, 114.0).verdict, verdict(114.5, 114.0).claimed) == ("unexplained", ())
