"""Cost of STEP, STL and 3MF of the default cam, made, written, read back and rolled, against importing build123d.

python -m pytest benchmarks/test_cam_files.py --benchmark-only -s
"""

import subprocess
import sys
from functools import cache
from time import perf_counter

import pytest

from cadgen.cam.checks import cam_angles
from cadgen.cam.contact import roll
from cadgen.design.load import load_design
from cadgen.geometry.meshes.content import inspect
from cadgen.geometry.meshes.mesh import cam_mesh
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.step import read_step, step_bytes
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.output.files.stl import read_stl, stl_bytes
from cadgen.output.files.threemf import read_3mf, threemf_bytes

CHORD = 0.005  # mm
STEP = 0.05  # mm between the points that the rod is rolled on


@cache
def import_of_build123d() -> float:
    """Seconds, the least of three runs."""
    times = []
    for _ in range(3):
        start = perf_counter()
        subprocess.run([sys.executable, "-c", "import build123d"], check=True)
        times.append(perf_counter() - start)
    return min(times)


def step_file(plan: CamPlan, folder) -> None:
    part = cam_part(plan.curve, plan.blank, plan.follower_as_built.land, name="cam", description="benchmark")
    (folder / "cam.step").write_bytes(step_bytes(part))
    roll(read_step(folder / "cam.step", STEP).rim, plan.follower_as_built, cam_angles(plan.application.steering))


def mesh_files(plan: CamPlan, folder) -> None:
    mesh = cam_mesh(plan.curve, plan.blank, plan.follower_as_built.land, CHORD)
    (folder / "cam.stl").write_bytes(stl_bytes(mesh, "cam"))
    (folder / "cam.3mf").write_bytes(threemf_bytes(mesh, "cam", "benchmark"))
    for again in (read_stl(folder / "cam.stl"), read_3mf(folder / "cam.3mf")[0]):
        roll(inspect(again, STEP).rim, plan.follower_as_built, cam_angles(plan.application.steering))


# Shares of `import build123d` that leave the whole command, with all its formats and imports, under twice it.
@pytest.mark.parametrize(("make", "share"), [(step_file, 0.3), (mesh_files, 0.15)])
def test_files(benchmark, tmp_path, make, share):
    plan = plan_cam(load_design())
    benchmark.pedantic(make, (plan, tmp_path), rounds=5, warmup_rounds=1)
    ratio = benchmark.stats["min"] / import_of_build123d()
    benchmark.extra_info["share_of_import_build123d"] = ratio
    print(f"\n{make.__name__}: {ratio:.3f} of importing build123d ({import_of_build123d():.2f} s)")
    assert ratio <= share
