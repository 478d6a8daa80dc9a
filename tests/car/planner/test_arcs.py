"""Ways of arcs and straights: they join poses, are the shortest of their kind, and keep clear of what stands there."""

import numpy as np

from cadgen.car.planner.arcs import _WORDS, _along, _parts


def every(a, b):
    parts, valid = zip(*(_parts(a, b, 1.0, word) for word in _WORDS), strict=True)
    return np.stack(parts), np.stack(valid)


def test_ways_join_their_poses():
    random = np.random.default_rng(1)
    a, b = random.uniform(-5, 5, (2, 500, 3))
    parts, valid = every(a, b)
    assert valid[0].all()
    assert valid[1].all()
    assert (parts >= 0).all()
    for each, kept, word in zip(parts, valid, _WORDS, strict=True):
        assert kept.any()
        x, y, heading = _along(a, each, word, 1.0, 400)
        off = np.hypot(x[-1] - b[:, 0], y[-1] - b[:, 1])[kept]
        turned = np.exp(1j * (heading[-1] - b[:, 2]))[kept]
        assert off.max() < 1e-6
        assert np.abs(turned - 1).max() < 1e-6
        # No step is longer than its arc, and none turns by more than that.
        step = each.sum(axis=0) / 399
        assert (np.hypot(np.diff(x, axis=0), np.diff(y, axis=0)) <= step * (1 + 1e-9)).all()
        assert (np.abs(np.diff(heading, axis=0)) <= step * (1 + 1e-9)).all()


def test_the_shortest_way_of_known_cases():
    """Straight ahead; a half circle; turning round on the spot by arcs of pi / 3, 5 pi / 3 and pi / 3."""
    a = np.zeros((3, 3))
    b = np.array([[3.0, 0.0, 0.0], [0.0, 2.0, np.pi], [0.0, 0.0, np.pi]])
    parts, valid = every(a, b)
    length = np.where(valid, np.where(parts > 2 * np.pi - 1e-9, 0.0, parts).sum(axis=1), np.inf).min(axis=0)
    np.testing.assert_allclose(length, [3.0, np.pi, 7 * np.pi / 3], atol=1e-9)
