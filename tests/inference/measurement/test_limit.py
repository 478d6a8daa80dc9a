"""The limit of telling names apart, against drawn data."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.inference.measurement.model import fourier, per_run
from tests.inference.measurement import limit, study
from tests.inference.measurement.limit import covariance, rates


def test_claims_of_the_best_judge_are_as_often_right_as_it_says():
    angle = np.tile(np.arange(200) * 2 * np.pi / 200, 2)
    run = np.repeat([0, 1], 200)
    model = SimpleNamespace(rows=SimpleNamespace(place=angle, run=run), datum=(), offsets=per_run(run))
    twins = np.stack([np.cos(angle) + 0.02 * np.sin(3 * angle), np.cos(angle) - 0.02 * np.cos(5 * angle)], axis=1)
    noise = np.full(400, 2.0)
    variance = 1.0 / np.arange(1, 91) ** 2
    size = 1.5 * np.sqrt(covariance(model, twins, noise, variance)[0, 0])
    # Draw data with the first twin in it, and judge them by the dense covariance, the datum's prior a wide one.
    waves, _ = fourier(angle, 90)
    dense = np.diag(noise**2) + (waves * np.tile(variance, 2)) @ waves.T
    inverse = np.linalg.inv(dense)
    D = model.offsets
    inverse = inverse - inverse @ D @ np.linalg.solve(D.T @ inverse @ D, D.T @ inverse)
    rng = np.random.default_rng(4)
    drawn = size * twins[:, :1] + np.linalg.cholesky(dense) @ rng.normal(size=(400, 4000))
    gain = (twins.T @ inverse @ drawn) ** 2 / np.sum(twins * (inverse @ twins), axis=0)[:, None]
    ahead = gain[0] - gain[1]
    for odds in (1.0, 3.0):
        right, wrong = rates(np.array([1.5]), odds)
        assert np.mean(ahead > 2 * np.log(odds)) == pytest.approx(right, abs=0.025)
        assert np.mean(ahead < -2 * np.log(odds)) == pytest.approx(wrong, abs=0.025)


def test_the_judge_names_what_is_large_and_no_twin_that_is_small(synthetic_car):
    def judged(truth, values, kind="lift"):
        rng = np.random.default_rng(7)
        case = study.draw(synthetic_car, kind, "single", rng)
        return limit.best(synthetic_car, replace(case, truth=truth, values=values, noise=5.0), rng)

    large, errors = judged(("eccentric bore",), ({"shift": (0.05, 0.0)},))
    assert large > 0.999
    assert np.median(errors) < 0.05
    small, wide = judged(("lever gain",), ({"gain": 1.002},))
    assert small < 0.9
    assert np.median(wide) > 2 * np.median(errors)
    both, _ = judged(("lever gain", "eccentric bore"), ({"gain": 1.002}, {"shift": (0.05, 0.0)}))
    assert both <= small + 1e-3
