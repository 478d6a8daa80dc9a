"""Building one gear: our solid against py_gearworks 0.0.24, and our mesh against the kernel's mesher.

Run with `pytest benchmarks/test_gear_build.py --benchmark-only -s`; py_gearworks is needed for the first only. Every
figure is a ratio of best times within one run.
"""

from collections.abc import Callable
from time import perf_counter

import pytest

from cadgen.gears.tooth import GearForm
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.geometry.solids.gear_solids import body_solid

ROUNDS = 7
CHORD_TOLERANCE = 1e-3


def best_time(build: Callable[[], object], rounds: int) -> float:
    times = []
    for _ in range(rounds):
        start = perf_counter()
        build()
        times.append(perf_counter() - start)
    return min(times)


def ours(teeth: int) -> GearForm:
    return GearForm(teeth=teeth, normal_module=1.0, width=5.0)


@pytest.mark.parametrize(("teeth", "bar"), [(30, 10.0), (150, 3.0)])
def test_solid_against_py_gearworks(benchmark: pytest.FixtureRequest, teeth: int, bar: float) -> None:
    peer = pytest.importorskip("py_gearworks")
    form = ours(teeth)
    benchmark.pedantic(lambda: body_solid(gear_body(form)), rounds=ROUNDS, warmup_rounds=1)
    theirs = best_time(
        lambda: peer.SpurGear(number_of_teeth=teeth, module=1.0, height=5.0, dedendum_coefficient=1.25).build_part(),
        ROUNDS,
    )
    ratio = theirs / benchmark.stats.stats.min
    benchmark.extra_info["py_gearworks / ours"] = ratio
    print(f"z = {teeth}: {benchmark.stats.stats.min * 1e3:.1f} ms, {ratio:.1f} times faster than py_gearworks")
    assert ratio >= bar


@pytest.mark.parametrize("teeth", [30, 150])
def test_mesh_against_the_kernels_mesher(benchmark: pytest.FixtureRequest, teeth: int) -> None:
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.BRepTools import BRepTools

    body = gear_body(ours(teeth))
    solid = body_solid(body)

    def kernel_mesh() -> None:
        BRepTools.Clean_s(solid)
        BRepMesh_IncrementalMesh(solid, CHORD_TOLERANCE, False, 0.5, False)

    benchmark.pedantic(lambda: body_mesh(body, CHORD_TOLERANCE), rounds=ROUNDS, warmup_rounds=1)
    ratio = best_time(kernel_mesh, 1) / benchmark.stats.stats.min
    benchmark.extra_info["kernel / ours"] = ratio
    print(f"z = {teeth}: mesh in {benchmark.stats.stats.min * 1e3:.1f} ms, {ratio:.0f} times faster than the kernel")
    assert ratio >= 100.0
