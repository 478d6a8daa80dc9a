"""Random cams: every approximation keeps its tolerance, and the milled part is the profile."""

import numpy as np
import pytest
from hypothesis import given, settings

from cadgen.cam.cutter import largest_cutter
from cadgen.cam.envelope import actual_profile
from cadgen.curves.biarc import arcs
from cadgen.curves.polygon import polygon
from cadgen.curves.spline import splines
from cadgen.design.machining import Machining
from cadgen.output.files.gcode import cutter_path, write_gcode
from cadgen.output.files.gcode_reader import read_gcode
from tests.cam.test_random_cams import cams

# A distance along the radius is at most this much more than along the normal, on the steepest of these cams.
SLANT = 1.6


@pytest.mark.slow
@pytest.mark.long
@settings(max_examples=10, deadline=None)
@given(cams())
def test_every_approximation_keeps_its_tolerance(tmp_path_factory, cam):
    curve = actual_profile(*cam).curve

    def off(points):
        return np.abs(np.linalg.norm(points, axis=1) - curve.radius(np.arctan2(points[:, 1], points[:, 0]))).max()

    assert off(arcs(curve, 1e-3).outline(0.1).points) < SLANT * 1e-3
    for spline in splines(curve, 1e-4, 5):
        assert off(spline.point(np.linspace(spline.knots[0], spline.knots[-1], 1000))) < SLANT * 1e-4
    corners = polygon(curve, 5e-3)
    assert off((corners + np.roll(corners, -1, axis=0)) / 2) < SLANT * 5e-3
    limit = largest_cutter(curve)
    radius = min(0.9 * limit.radius, 3.0)
    if radius > 0.1:
        machining = Machining(cutter_diameter_mm=2 * radius)
        path = tmp_path_factory.mktemp("any") / "cam.nc"
        write_gcode(path, cutter_path(curve, radius, limit, 1e-3), machining, 3.0, name="any")
        assert off(read_gcode(path, machining, 3.0).outline.points) < SLANT * (1e-3 + 2e-4)
