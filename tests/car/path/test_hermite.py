"""The quintic Hermite interpolant: exact on quintics, sixth order elsewhere, kinks kept."""

import numpy as np

from cadgen.curves.piecewise import quintic_hermite


def jets(f, x):
    return np.stack([f(x, order) for order in range(3)], axis=1)


def sine(x, order):
    return np.sin(x + order * np.pi / 2)


def test_reproduces_a_quintic():
    poly = np.polynomial.Polynomial([1, -2, 0.5, 3, -1, 0.25])
    x = np.array([0.0, 0.3, 1.1, 2.0])
    curve = quintic_hermite(x, jets(lambda t, order: poly.deriv(order)(t) if order else poly(t), x))
    t = np.linspace(0, 2, 101)
    np.testing.assert_allclose(curve(t), poly(t), atol=1e-12)


def test_sixth_order():
    t = np.linspace(0, 6, 5001)
    errors = []
    for n in (11, 21):
        x = np.linspace(0, 6, n)
        errors.append(np.abs(quintic_hermite(x, jets(sine, x))(t) - np.sin(t)).max())
    order = np.log2(errors[0] / errors[1])
    print(f"order {order:.2f}, error at h = 0.3: {errors[1]:.1e}, bound {0.3**6 / 46080:.1e}")
    assert order > 5.8
    assert errors[1] < 0.3**6 / 46080 * 1.001


def test_a_doubled_node_is_a_kink():
    x = np.array([0.0, 1.0, 1.0, 2.0])
    curve = quintic_hermite(x, np.array([[0, 1, 0], [1, 1, 0], [1, -1, 0], [0, -1, 0]], dtype=float))
    np.testing.assert_allclose(curve([0.5, 1.0, 1.5]), [0.5, 1.0, 0.5])
