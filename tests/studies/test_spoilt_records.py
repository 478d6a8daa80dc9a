"""A slice of the study of spoilt records: each fault does what its name says, and the page counts what it asks."""

from dataclasses import replace

import numpy as np
import pytest

from tests.studies.circles import Outcome, draw
from tests.studies.spoilt_records import FAULTS, RUNS, Case, page

SIZE = 0.01


@pytest.mark.slow
def test_faults_change_one_run_or_the_whole_picture_by_their_size():
    drawn = draw(1, 0)
    track = drawn.world.track(drawn.car, np.random.default_rng(1))
    place = np.asarray(track.columns["x_mm"]) + 1j * np.asarray(track.columns["y_mm"])
    middle = complex((place.real.min() + place.real.max()) / 2, (place.imag.min() + place.imag.max()) / 2)
    for fault, spoil in FAULTS.items():
        spoilt = spoil(drawn, track, np.random.default_rng(2), SIZE)
        off = np.asarray(spoilt.columns["x_mm"]) + 1j * np.asarray(spoilt.columns["y_mm"]) - place
        if fault == "noise figure":
            assert spoilt.remarks[-1] == "instrument: noise 0.03000 mm"
            assert not off.any()
        elif fault in RUNS:
            assert len(set(track.run[np.abs(off) > 0.1])) == 1
        else:
            far = np.abs(off).max() / np.abs(place - middle).max()
            assert 0.1 * SIZE < far < 1.2 * SIZE, fault


def test_the_page_counts_harm_and_needless_refusals():
    fine = Outcome(1, "lift", "bore", "", "traced", "eccentric bore", 100.0, 12.0, 10.0, 9.0, 0.0, False)
    cases = [
        Case("lens", 0.01, "", fine),
        Case("lens", 0.01, "", replace(fine, after=150.0)),
        Case("lens", 0.01, "", replace(fine, refused=True)),
        Case("run in cm", 0.01, "", replace(fine, refused=True, stays=80.0)),
    ]
    assert [(case.harmed, case.needless) for case in cases] == [
        (False, False),
        (True, False),
        (False, True),
        (False, False),
    ]
    text = page(cases, "a command")
    assert "| harmed | 1 | 0 |" in text
    assert "| no cam, without need | 25.0 % of 4" in text
    assert "| lens | 3 | 1 | 1 |" in text
