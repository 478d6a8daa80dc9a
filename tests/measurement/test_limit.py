"""The limit of telling twins apart, against drawn data."""

from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.measurement.models.base import fourier, per_run
from tests.measurement.limit import ORDERS, covariance, rates


def test_claims_of_the_best_judge_are_as_often_right_as_it_says():
    angle = np.tile(np.arange(200) * 2 * np.pi / 200, 2)
    run = np.repeat([0, 1], 200)
    model = SimpleNamespace(rows=SimpleNamespace(place=angle, run=run), datum=(), offsets=per_run(run))
    twins = np.stack([np.cos(angle) + 0.02 * np.sin(3 * angle), np.cos(angle) - 0.02 * np.cos(5 * angle)], axis=1)
    noise = np.full(400, 2.0)
    variance = 1.0 / np.arange(1, ORDERS + 1) ** 2
    size = 1.5 * np.sqrt(covariance(model, twins, noise, variance)[0, 0])
    # Draw data with the first twin in it, and judge them by the dense covariance, the datum's prior a wide one.
    waves, _ = fourier(angle, ORDERS)
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
