"""Cost of the approximations and the flat files of the default cam, against sampling its curve in the same run.

python -m pytest benchmarks/test_curves.py --benchmark-only -s
"""

from itertools import count
from statistics import median
from time import perf_counter

import numpy as np
import pytest

from cadgen.cam.contact import roll
from cadgen.cam.cutter import largest_cutter
from cadgen.curves.biarc import arcs
from cadgen.curves.contour import circle, keyway_bore
from cadgen.curves.derived import parallel
from cadgen.curves.polygon import polygon
from cadgen.curves.spline import splines
from cadgen.design.schema import Machining
from cadgen.output.files.dxf import read_dxf, write_dxf
from cadgen.output.files.gcode import cutter_path, write_gcode
from cadgen.output.files.gcode_reader import read_gcode
from cadgen.output.files.tables import contact_outline, read_csv, write_csv
from cadgen.output.files.xyz import read_xyz, write_xyz
from tests.conftest import build

ROUNDS = 7
# mm; the yardstick is the curve in 22000 points. Each time another step, for the curve keeps the outlines that it was
# asked for.
STEPS = count(0.02, 1e-8)
CAR = build("carbon_free_car")
CURVE = CAR.actual.curve
BORE = keyway_bore(8.0, 3.0, 1.4, 0.0)
HOLES = tuple(circle((39.0 * np.cos(a), 39.0 * np.sin(a)), 9.0) for a in np.arange(6) * np.pi / 3)


def dxf(folder):
    write_dxf(folder / "cam.dxf", arcs(CURVE, 2e-4), BORE, HOLES)
    return read_dxf(folder / "cam.dxf")


def gcode(folder):
    machining = Machining()
    centre = cutter_path(CURVE, machining.cutter_diameter_mm / 2, largest_cutter(CURVE), 2e-4)
    write_gcode(folder / "cam.nc", centre, machining, 3.0, name="cam")
    return read_gcode(folder / "cam.nc", machining, 3.0).outline


def xyz(folder):
    write_xyz(folder / "cam.xyz", CURVE, 3600)
    return read_xyz(folder / "cam.xyz")


def table(folder):
    contact = roll(CURVE.outline(0.03), CAR.follower, np.linspace(0, 2 * np.pi, 3600, endpoint=False))
    write_csv(folder / "cam.csv", CURVE, CAR.follower, contact)
    return contact_outline(read_csv(folder / "cam.csv"), 0.03)


# Limits are about twice what was measured when they were set, in yardsticks.
WORK = {
    "arcs": (lambda folder: arcs(CURVE, 2e-4), 4),
    "quintic splines": (lambda folder: splines(CURVE, 1e-5, 5), 8),
    "cubic splines": (lambda folder: splines(CURVE, 1e-4, 3), 8),
    "polygon": (lambda folder: polygon(CURVE, 5e-3), 3),
    "parallel curve": (lambda folder: parallel(CURVE, 2.0), 2),
    "largest cutter": (lambda folder: largest_cutter(CURVE), 8),
    "DXF": (dxf, 10),
    "G-code": (gcode, 25),
    "xyz": (xyz, 4),
    "CSV": (table, 16),
}


@pytest.mark.parametrize("name", WORK)
def test_cost_against_sampling_the_curve(benchmark, name, tmp_path):
    work, limit = WORK[name]
    benchmark.pedantic(work, args=(tmp_path,), rounds=1, warmup_rounds=1)

    def seconds(function, argument):
        start = perf_counter()
        function(argument)
        return perf_counter() - start

    # Alternating, so that whatever else the machine does falls on both.
    pairs = [(seconds(work, tmp_path), seconds(CURVE.outline, next(STEPS))) for _ in range(ROUNDS)]
    ratio = median(ours / yardstick for ours, yardstick in pairs)
    benchmark.extra_info["ratio"] = ratio
    print(f"\n{name}: {min(ours for ours, _ in pairs) * 1e3:.0f} ms, {ratio:.1f} yardsticks (limit {limit})")
    assert ratio <= limit
