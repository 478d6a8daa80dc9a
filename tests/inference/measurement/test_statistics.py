"""Noise and evidence against brute force: dense covariance matrices and drawn noise of known kind."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.deviations.effect import READING, Effect, Parameter, Rows
from cadgen.inference.measurement.evidence import Evidence, Noise, Spectrum, estimate_noise
from cadgen.inference.measurement.hypothesis import LEAST_PRICE, Hypothesis, Search, _overlap
from cadgen.inference.measurement.model import Discrepancy, fourier, highest_order, per_run
from cadgen.inference.measurement.reservations import unfit
from cadgen.inference.measurement.verdict import _within_floor


def _model(angles: int = 60, runs: int = 3, *, slip: bool = False, floor: float = 2.0) -> SimpleNamespace:
    angle = np.tile(np.arange(angles) * 2 * np.pi / angles, runs)
    run = np.repeat(np.arange(runs), angles)
    form, order = fourier(angle, 5)
    rows = Rows(run=run, place=angle, elapsed=np.zeros(len(run)), cell=np.tile(np.arange(angles), runs))
    return SimpleNamespace(
        rows=rows,
        offsets=per_run(run),
        spread=np.full(runs, np.inf),
        discrepancy=Discrepancy.none(len(run)),
        form=form,
        order=order,
        floor=floor,
        slip=np.sin(2 * angle) * 50 if slip else np.empty(0),
    )


def test_misfit_is_that_of_the_dense_covariance():
    model, rng = _model(), np.random.default_rng(2)
    sigma = rng.uniform(1, 3, len(model.rows.run))
    grid = (Spectrum(1.0, 2.0, 1.0), Spectrum(3.0, 4.0, 3.0))
    evidence = Evidence(model, Noise(sigma, 0.0, 0.0, 3), grid)
    residual = rng.normal(0, 4, len(sigma))
    dense = []
    for spectrum in grid:
        variance = spectrum.variance(model.order, model.floor)
        C = np.diag(sigma**2) + (model.form * variance) @ model.form.T
        inverse, D = np.linalg.inv(C), model.offsets
        inside = D.T @ inverse @ D
        projected = inverse - inverse @ D @ np.linalg.solve(inside, D.T @ inverse)
        determinant = np.linalg.slogdet(C)[1] + np.linalg.slogdet(inside)[1]
        dense.append(residual @ projected @ residual + determinant)
    ours = evidence.misfit(evidence.whiten(residual))
    assert ours[1] - ours[0] == pytest.approx(dense[1] - dense[0], rel=1e-9)


def test_known_freedoms_and_a_discrepancy_are_those_of_the_dense_covariance():
    model, rng = _model(), np.random.default_rng(12)
    columns = np.stack([model.rows.place, np.cos(8 * model.rows.place)], axis=1)
    model.spread, model.discrepancy = np.array([2.0, 3.0, 0.5]), Discrepancy("", columns, np.array([0.7, 1.4]))
    spectrum = Spectrum(1.0, 2.0, 1.0)
    evidence = Evidence(model, Noise(np.full(180, 1.5), 0.0, 0.0, 3), (spectrum,))
    C = np.diag(np.full(180, 1.5**2)) + (model.form * spectrum.variance(model.order, model.floor)) @ model.form.T
    C += (model.offsets * model.spread**2) @ model.offsets.T + (columns * np.array([0.7, 1.4]) ** 2) @ columns.T
    dense, ours = [], []
    for residual in rng.normal(0, 4, (2, 180)):
        dense.append(residual @ np.linalg.solve(C, residual))
        ours.append(float(evidence.misfit(evidence.whiten(residual))[0]))
    assert ours[1] - ours[0] == pytest.approx(dense[1] - dense[0], rel=1e-9)
    # What is most likely of the amplitudes is their covariance with the rows, and their spread shrinks by it.
    beside = np.hstack([model.form, columns])
    prior = np.append(spectrum.variance(model.order, model.floor), [0.49, 1.96])
    assert evidence.repeating(evidence.whiten(residual), 0) == pytest.approx(
        prior * (beside.T @ np.linalg.solve(C, residual)), rel=1e-6
    )
    left = np.diag(prior) - (beside * prior).T @ np.linalg.solve(C, beside * prior)
    assert evidence.unsure(0) == pytest.approx(left, rel=1e-6, abs=1e-9)


def test_products_are_the_misfit_without_its_determinant():
    model, rng = _model(), np.random.default_rng(3)
    evidence = Evidence(model, Noise(np.full(180, 1.5), 0.3, 0.0, 3), (Spectrum(1.0, 3.0, 1.0),))
    white = evidence.whiten(rng.normal(0, 2, (180, 2)))
    (product,) = evidence.products(white, white, [0])
    of = [float(evidence.misfit(v)[0]) - float(evidence.constant[0]) for v in (white[:, 0], white[:, 1], white.sum(1))]
    assert product == pytest.approx(product.T)
    assert [product[0, 0], product[1, 1], product.sum()] == pytest.approx(of, rel=1e-9)
    (mixed,) = evidence.products(white[:, :1], white, [0])
    assert mixed == pytest.approx(product[:1])


def test_spectrum_sums_to_the_square_of_its_size():
    _, order = fourier(np.zeros(1), 90)
    total = Spectrum(1.2, 6.0, 1.0).variance(order, 2.0).sum() / 2
    assert total == pytest.approx((1.2 * 2.0) ** 2)


@pytest.mark.parametrize("correlation", [0.0, 0.5])
def test_noise_with_its_correlation_is_found_under_what_repeats(correlation):
    model, rng = _model(angles=400), np.random.default_rng(5)
    noise = rng.normal(0, 1, (3, 400))
    for k in range(1, 400):
        noise[:, k] = correlation * noise[:, k - 1] + np.sqrt(1 - correlation**2) * noise[:, k]
    repeats = 30 * np.sin(7 * model.rows.place)
    zero = np.array([5.0, -3.0, 1.0])[model.rows.run]
    found = estimate_noise(model, 4.0 * noise.ravel() + repeats + zero)
    assert found.rms == pytest.approx(4.0, rel=0.06)
    assert found.correlation == pytest.approx(correlation, abs=0.07)


def test_a_mean_that_all_runs_share_is_no_noise():
    # Nothing is measured at the same place twice, and no zero is free: a profile that is too large all round.
    model, rng = _model(angles=400), np.random.default_rng(9)
    model.rows = replace(model.rows, cell=np.full(1200, -1))
    model.offsets = model.offsets[:, :0]
    found = estimate_noise(model, 30.0 + 5 * np.cos(3 * model.rows.place) + rng.normal(0, 2.0, 1200))
    assert found.rms == pytest.approx(2.0, rel=0.06)
    assert found.freedom == 1200 - 1 - model.form.shape[1]


def test_chance_of_a_rest_is_even_for_noise_and_form_error_and_small_for_more():
    model, rng = _model(angles=200), np.random.default_rng(10)
    model.datum = ()
    spectrum = Spectrum(1.0, 3.0, 1.0)
    size = np.sqrt(spectrum.variance(model.order, model.floor))
    best = SimpleNamespace(active=[], effects=(), spectrum=spectrum)

    def chance(more: float) -> float:
        drawn = model.form @ (size * rng.normal(size=len(size))) + rng.normal(0, 3.0, 600)
        model.residual = lambda active: drawn + more * np.sin(20 * model.rows.place)
        noise = estimate_noise(model, model.residual([]))
        return unfit(model, Evidence(model, noise, (spectrum,)), noise, best, model.residual([]))

    even = [chance(0.0) for _ in range(60)]
    assert 0.35 < np.mean(even) < 0.65
    assert np.std(even) == pytest.approx(12**-0.5, rel=0.35)
    assert chance(3.0) < 1e-4


def test_scatter_of_the_abscissa_makes_steep_places_noisier():
    model, rng = _model(angles=400, slip=True), np.random.default_rng(6)
    scatter = model.slip * rng.normal(0, 0.1, 1200) + rng.normal(0, 1.0, 1200)
    found = estimate_noise(model, scatter)
    steep, flat = np.abs(model.slip) > 49, np.abs(model.slip) < 5
    assert found.sigma[steep].mean() == pytest.approx(np.hypot(5.0, 1.0), rel=0.1)
    assert found.sigma[flat].mean() == pytest.approx(1.0, rel=0.15)


def test_a_run_set_differently_is_slip_and_not_noise():
    model, rng = _model(angles=400, slip=True), np.random.default_rng(8)
    own = np.array([-0.4, 0.0, 0.4])[model.rows.run]
    found = estimate_noise(model, model.slip * own + rng.normal(0, 1.0, 1200))
    assert found.rms == pytest.approx(1.0, rel=0.06)
    assert found.slip == pytest.approx(0.4, rel=0.25)


def test_orders_stop_short_of_nyquist():
    angle = np.arange(36) * np.pi / 18
    assert highest_order(angle, np.zeros(36, dtype=int)) == 14  # 0.8 of 18


def _effect(name: str, parameters: int = 1, **more: object) -> Effect:
    sizes = tuple(Parameter(name=f"p{k}_um", unit="um", lower=-9.0, upper=9.0, step=1.0) for k in range(parameters))
    return Effect(name=name, stage=READING, parameters=sizes, act=lambda thing, p, at: thing, **more)


def test_a_cause_with_many_orders_is_one_cause():
    search = Search(1000, {"scale": 1, "phase": 1, "waviness": 100}, 50)
    scale, wave, bump = (
        _effect("scale"),
        _effect("waviness, order 9", 2, cause="waviness"),
        _effect("bump", 3, shape=True),
    )
    # Three causes alike likely; a hundred orders of one of them; fifty shapes.
    assert search.penalty((scale,), 1) == pytest.approx(np.log(1000) + 2 * np.log(3))
    assert search.penalty((wave,), 2) == pytest.approx(2 * np.log(1000) + 2 * np.log(3 * 100))
    assert search.penalty((scale, wave), 3) == pytest.approx(3 * np.log(1000) + 2 * np.log(3 * 3 * 100))
    assert search.penalty((bump,), 3) == pytest.approx(3 * np.log(1000) + 2 * np.log(50))


@pytest.mark.parametrize("cosine", [0.0, 0.6, 0.8])
def test_price_of_a_pair_is_that_of_its_bayes_factor(cosine):
    # Two columns under unit noise, each with a prior as wide as one of n rows tells: the evidence in closed form.
    n = 400
    rng = np.random.default_rng(1)
    u, v = np.linalg.qr(rng.normal(size=(n, 2)))[0].T
    X = np.sqrt(n) * np.stack([u, cosine * u + np.sqrt(1 - cosine**2) * v], axis=1)
    y = X @ [0.3, -0.2] + rng.normal(size=n)
    information = X.T @ X
    estimate = np.linalg.solve(information, X.T @ y)
    misfit = np.sum((y - X @ estimate) ** 2)
    wide = 100.0  # that many times wider: its price and its shrinkage are known, and the latter vanishes
    exact = y @ np.linalg.solve(np.eye(n) + wide**2 * X @ X.T, y) + np.linalg.slogdet(np.eye(n) + wide**2 * X @ X.T)[1]
    covariance = np.linalg.inv(information)
    saved = _overlap(covariance, (_effect("a"), _effect("b")), np.log(n))
    assert misfit + 2 * np.log(n) - saved == pytest.approx(exact - 4 * np.log(wide), abs=2e-3)


def test_the_second_of_two_twins_keeps_a_price():
    covariance = np.linalg.inv(np.array([[1.0, 0.99999], [0.99999, 1.0]]))
    twins = (_effect("a"), _effect("b"))
    assert _overlap(covariance, twins, np.log(1000)) == pytest.approx(np.log(1000) - LEAST_PRICE)
    assert _overlap(covariance, (_effect("a"), _effect("b", shape=True)), np.log(1000)) == 0.0


def _fitted(score: float, *effects: Effect) -> Hypothesis:
    return Hypothesis(
        effects=effects,
        active=[],
        covariance=np.empty((0, 0)),
        misfit=np.array([score, score + 50]),
        penalty=0.0,
        within=0,
        beyond=1,
        at_bound=(),
        spectrum=Spectrum(1.0, 3.0, 1.0),
    )


@pytest.mark.parametrize(("gap", "sure"), [(0.0, False), (3.0, False), (4.0, True)])
def test_a_twin_is_claimed_at_odds_of_six_to_one_and_the_other_told(gap, sure):
    # exp(3 / 2) is 4.5 and exp(4 / 2) is 7.4; a superset that adds nothing is not claimed and no rival.
    gain, axial, drift = (_effect(name) for name in ("gain", "axial", "drift"))
    found = [_fitted(0, gain), _fitted(gap, axial), _fitted(9, gain, drift), _fitted(60)]
    joint = SimpleNamespace(grid=(Spectrum(1.0, 3.0, 1.0),) * 2, parts=())
    judgement, best = _within_floor(joint, found)
    assert judgement.claimed == (("gain",) if sure else ())
    assert judgement.verdict == ("traced" if sure else "ambiguous")
    assert judgement.reported == ("axial", "gain")
    assert judgement.rivals == (("axial",),)
    assert ("not ruled out: axial" in judgement.sentence) == sure
    assert best.claims == {"gain"}
