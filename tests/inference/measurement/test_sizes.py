"""Sizes: their uncertainty over all spectra of what repeats, against a grid, and columns that are hidden."""

from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.inference.measurement.hypothesis import Hypothesis, _covariance, sized
from cadgen.inference.measurement.search import Columns, Families


def test_a_size_has_the_uncertainty_of_every_spectrum_by_its_chance():
    rng = np.random.default_rng(5)
    response = np.cos(np.linspace(0, 6, 12))
    residual = 0.4 * response + rng.normal(0, 0.3, 12)
    form = np.cos(np.linspace(0, 6, 12)[:, None] * [1.05, 2.1])
    covariances = [0.09 * np.eye(12) + size**2 * form @ form.T for size in (0.05, 0.4)]
    misfit = np.array([residual @ np.linalg.solve(c, residual) + np.linalg.slogdet(c)[1] for c in covariances])

    def normal(effects, active, among):
        pulls = [np.linalg.solve(covariances[spectrum], -response) for spectrum in among]
        return [np.array([[-response @ pull]]) for pull in pulls], [np.array([residual @ pull]) for pull in pulls]

    spectra = (SimpleNamespace(within=True),) * 2
    effect = SimpleNamespace(parameters=(SimpleNamespace(stepwise=False),), bounds=np.array([[-1e9], [1e9]]))
    joint = SimpleNamespace(within=np.array([True, True]), normal=normal)
    found = Hypothesis(
        effects=(effect,),
        active=[(effect, np.zeros(1))],
        covariance=np.zeros((1, 1)),
        misfit=misfit,
        penalty=0.0,
        within=0,
        beyond=0,
        at_bound=(),
        spectrum=spectra[0],
    )
    ((variance,),) = sized(joint, found).covariance
    off = np.linspace(-4, 4, 8001)
    density = np.zeros_like(off)
    for c in covariances:
        left = residual[:, None] + response[:, None] * off  # slopes are those of measured less expected, turned round
        density += np.exp(-(np.sum(left * np.linalg.solve(c, left), axis=0) + np.linalg.slogdet(c)[1]) / 2)
    assert variance == pytest.approx(density @ off**2 / density.sum(), rel=1e-6)


def test_a_number_that_nothing_shows_is_known_by_its_bounds_alone():
    """The variance of an even distribution between them, and that of the information for the others."""
    bounds = np.array([[-1.0, 0.0, -1.0], [1.0, 6.0, 1.0]])
    information = np.array([[400.0, 0.0, 30.0], [0.0, 0.0, 0.0], [30.0, 0.0, 100.0]])
    found = _covariance(information, bounds, np.array([True, True, True]))
    shown = [0, 2]
    np.testing.assert_allclose(found[np.ix_(shown, shown)], np.linalg.inv(information[np.ix_(shown, shown)]))
    assert found[1, 1] == pytest.approx(3.0)
    by_trial = _covariance(information, bounds, np.array([True, False, True]))
    assert by_trial[1, 1] == 0.0  # to which the variance of the trials is added


def test_a_column_that_the_discrepancy_hides_is_no_candidate():
    """All but rounding of it is in the random part: nothing can be measured against such a size."""
    effect = SimpleNamespace(parts=())
    near, hidden = np.array([3.0, 4.0, 0.0]), np.array([1e5, 0.0, 0.0])
    joint = SimpleNamespace(
        whiten=lambda columns: columns,
        halves=lambda white: np.array([[[0.6 * white[0, 0], (1 - 1e-16) * white[0, 1]]]]),
    )
    columns = Columns((effect, effect), (slice(0, 1), slice(1, 2)), np.stack([near, hidden], axis=1))
    (alike,) = Families(joint, columns).groups
    assert (alike.columns.tolist(), alike.effects.tolist()) == ([[0], [1]], [0, 1])
    assert alike.products.shape == (1, 2, 1, 1)
    assert alike.size[0, 0] == pytest.approx(np.sqrt(25 - 1.8**2))
    assert np.isinf(alike.size[0, 1])
