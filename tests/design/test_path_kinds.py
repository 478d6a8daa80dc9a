"""Kinds of path in a design: control points, and a kind that is registered from outside."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import pytest
from annotated_types import Gt, Le

from cadgen.car.path import path_kinds
from cadgen.car.path.path_kinds import PathKind
from cadgen.car.path.spline import control_path
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError

ARC = [[1000 * float(np.sin(a)), 1000 - 1000 * float(np.cos(a))] for a in np.linspace(0, 2, 12)]
BY_CONTROL = ["path=", 'path.spline="b_spline"', f"path.control_points_mm={ARC}"]


def test_control_points_are_a_path():
    design = load_design(None, BY_CONTROL)
    assert design.values()["path"] == {"spline": "b_spline", "offset_mm": 0.0, "control_points_mm": ARC}
    track = cam_model.track(design)
    np.testing.assert_allclose(track.planned(0.0), ARC[0], atol=1e-9)
    np.testing.assert_allclose(track.planned(track.length), ARC[-1], atol=1e-9)


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (['path.spline="b_spline"'], "path.waypoints_mm is not a key: .*control_points_mm"),
        (BY_CONTROL[:2], r"path.control_points_mm is missing: add it, a list of pairs \[x, y\] in mm"),
        ([*BY_CONTROL[:2], f"path.control_points_mm={ARC[:5]}"], "has 5 items; it needs at least 6: add more"),
        ([*BY_CONTROL[:2], f"path.control_points_mm={[ARC[0]] * 10_001}"], "at most 10000: remove some"),
        ([*BY_CONTROL, 'path.control_points_mm.2="x"'], r"path.control_points_mm.2 is .x.; it must be a pair"),
        ([f"path.control_points_mm={ARC}"], "path.control_points_mm is not a key"),
    ],
)
def test_wrong_control_points_are_refused_by_their_key(overrides, words):
    with pytest.raises(DesignError, match=words):
        load_design(None, overrides)


@dataclass(frozen=True, kw_only=True)
class SpiralKeys:
    """Keys of an Archimedean spiral."""

    growth_mm: Annotated[float, Gt(0), Le(5000), "radius gained for each radian"]


def spiral(keys: SpiralKeys):
    angle = np.linspace(2, 6, 40)
    return control_path(keys.growth_mm * (angle * [np.cos(angle), np.sin(angle)]).T)


def test_a_kind_of_path_is_one_file_and_one_line():
    kind = PathKind(code="spiral", meaning="a spiral", keys=SpiralKeys, build=spiral)
    path_kinds.register(kind)
    try:
        design = load_design(None, ["path=", "path.spline=spiral", "path.growth_mm=300"])
        assert cam_model.track(design).length > 4 * 300 * 2
        with pytest.raises(DesignError, match=r"path.growth_mm is -1; it must be greater than 0"):
            load_design(None, ["path=", "path.spline=spiral", "path.growth_mm=-1"])
    finally:
        path_kinds.remove(kind)
