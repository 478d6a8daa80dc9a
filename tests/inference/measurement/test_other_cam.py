"""Whether data fit another cam than the stated one: cars of the study of stated cams, which shares no code with it."""

from dataclasses import replace
from math import radians
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.car.path_motion import path_motion
from cadgen.car.steering import steering_jets
from cadgen.design.load import load_design
from cadgen.inference.measurement import other_cam as room
from cadgen.inference.measurement.diagnosis import weigh_together
from cadgen.inference.measurement.other_cam import SURE, other_cam
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.calibration import calibrate, stated_profile
from cadgen.jobs.calibration.calibration_report import report
from cadgen.jobs.calibration.sources import read, source_of
from cadgen.output.report.terminal import plain
from cadgen.verdict import Readiness
from tests.inference.measurement import synthetic_drive
from tests.studies.stated_cams import go

MEASURED = Path(__file__).parents[2] / "data" / "measured"


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("right", [True, False])
def test_a_cam_that_is_not_on_the_car_is_found_by_what_its_effects_cost(right):
    """An eccentric bore beside a lift; against the other cam it takes play, spring and divider as well."""
    one = go(41, 0, right=right, smooth=True)
    assert (one["on_car"], one["stated"]) == ("actual", "actual" if right else "optimized")
    assert one["verdict"] == ("traced" if right else "combination")
    assert one["refused"] is not right


@pytest.mark.slow
@pytest.mark.long
def test_a_track_that_fits_both_cams_needs_its_cam_said():
    """More play on the other cam does the same to the car, and nothing in a track tells the two."""
    design, sources = load_design(), read([MEASURED / "track_b.csv"])
    told = calibrate(design, None, sources)
    assert (told.profile, told.cam_unknown, told.readiness) == ("actual", True, Readiness.NOT_READY)
    assert "as well as one with the actual cam" in plain(report(told)[:1], 500)
    stated = calibrate(design, "actual", sources)
    assert (stated.cam_unknown, stated.readiness) == (False, Readiness.READY)
    # Play that was measured by hand is 0.805 degrees: beside the actual cam it is 0.861, beside the other 1.5.
    told = calibrate(design, None, read([MEASURED / "track_c.csv", MEASURED / "paper_section5.csv"]))
    assert told.other_cam is None


def test_a_remark_says_which_cam_was_on_the_car():
    columns = {"direction": ["forward"] * 40, "cam_angle_deg": range(40), "lift_mm": [0.1 * k for k in range(40)]}
    assert stated_profile(source_of(columns, ("design: mine, optimized profile",), "a lift")) == "optimized"
    assert stated_profile(source_of(columns, ("design: mine",), "a lift")) == ""


@pytest.mark.slow
@pytest.mark.long
def test_a_cam_whose_run_ends_elsewhere_is_judged_over_the_same_rows(nominal, synthetic_car):
    """The wheel that a car was found to have moves the end of its run on the cam that is cut for it."""
    track = nominal.track
    longer = replace(nominal.car, wheelbase=1.01 * nominal.car.wheelbase)
    lift = path_motion(track.arc, steering_jets(track, longer), track.length, blend=radians(20.0))
    wheels, rng = synthetic_drive.Wheels(zero=radians(0.2)), np.random.default_rng(3)
    record = synthetic_drive.track_record(synthetic_car, wheels, rng, noise_mm=3.0, runs=2)
    weighed = weigh_together([record], nominal).joint
    found = other_cam(weighed, nominal, replace(nominal, lift=lift), "actual")
    assert found is not None
    assert found.better < 0
    assert (found.effects, found.instead) == (("steering zero", "lever gain"), ("steering zero",))


@pytest.mark.parametrize(("of_stated", "of_other", "surely"), [(0, 0, True), (0, 1, False), (1, 1, True), (2, 1, True)])
def test_a_shape_without_a_name_that_only_the_other_cam_needs_speaks_against_it(
    nominal, monkeypatch, of_stated, of_other, surely
):
    """Two cams differ by such shapes: a clean car was refused its cam for two of them, by 10.2 where 10 are asked."""

    def subset(score, shapes):
        effects = tuple(SimpleNamespace(name="steering off", shape=True) for _ in range(shapes))
        return SimpleNamespace(score=score, effects=effects, values=lambda: [(effect, 0.0, 0.0) for effect in ()])

    wider = path_motion(
        nominal.track.arc,
        steering_jets(nominal.track, replace(nominal.car, wheelbase=1.01 * nominal.car.wheelbase)),
        nominal.track.length,
        blend=radians(20.0),
    )
    monkeypatch.setattr(room, "_against", lambda joint, nominal: SimpleNamespace(parts=(None,)))
    monkeypatch.setattr(room, "find", lambda joint, usual, against: [subset(-1.5 * SURE, of_other)])
    monkeypatch.setattr(room, "left_over", lambda part, joint, found: 1.0)
    weighed = SimpleNamespace(
        found=[subset(0.0, of_stated)], joint=None, judgement=SimpleNamespace(verdict=Verdict.PARTIAL)
    )
    found = other_cam(weighed, nominal, replace(nominal, lift=wider), "optimized")
    if surely:
        assert found is not None
        assert found.fits_better
    else:
        assert found is None or not found.fits_better
