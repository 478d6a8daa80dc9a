"""Even errors: a model error of known density, and a tolerance that cannot be kept."""

import numpy as np
import pytest

from cadgen.curves.spacing import even_nodes, inside_spans
from cadgen.errors import DesignError


def test_spans_share_the_error_evenly():
    # An error of h^3 exp(4 x): the fewest spans are the integral of the cube root of its density.
    def errors(nodes):
        middle = (nodes[1:] + nodes[:-1]) / 2
        return np.diff(nodes) ** 3 * np.exp(4 * middle)

    nodes = even_nodes(errors, (0.0, 2.0), 1e-6, 3)
    fewest = 100 * (np.exp(8 / 3) - 1) * 3 / 4
    assert errors(nodes).max() <= 1e-6
    assert fewest <= len(nodes) - 1 < 1.06 * fewest


def test_an_error_that_does_not_fall_is_refused():
    with pytest.raises(DesignError, match=r"within 0\.001 µm"):
        even_nodes(lambda nodes: np.append(np.zeros(len(nodes) - 2), 1.0), (0.0, 1.0), 1e-6, 3)


def test_inner_points_keep_the_nodes():
    nodes = np.array([0.0, 1.0, 4.0])
    assert inside_spans(nodes, 2).tolist() == [0.0, 0.5, 1.0, 2.5, 4.0]
