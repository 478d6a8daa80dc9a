"""The tolerance run of 10 000 cars with 3600 steps each: as ratios within one run, for machines differ.

Run with `pytest benchmarks/test_tolerance_run.py -o addopts=--import-mode=importlib --benchmark-only -s`.
"""

import subprocess
import sys
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import inf, radians
from time import perf_counter, process_time

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.cam.envelope import actual_profile
from cadgen.car.against_play.compensation import compensated_lift
from cadgen.car.running.drive import drive, wheel_radius
from cadgen.car.running.mechanics import Mechanics
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.deviations.deviation import tolerance
from cadgen.deviations.first_order import Expansion
from cadgen.inference.monte_carlo.cars import Cars, nominal_cars
from cadgen.inference.monte_carlo.random_cars import Tolerances, tolerance_run
from cadgen.processes import in_processes

SAMPLES = 10_000
STEPS = 3600
PROCESSES = 2
MOST_IMPORTS = 5.0
MOST_BYTES = 1e9
# Four times the samples may take this much more than four times as long.
LINEARITY = 1.5
# Cars with every band, friction and drag among them, may take this many times as long as those without.
ALL_BANDS = 1.5

HALF_WIDTHS = {
    "base_radius": 0.005,
    "inner_face": 0.05,
    "outer_face": 0.05,
    "rod_radius": 0.005,
    "profile_offset": 0.01,
    "steering_zero": radians(0.02),
    "wheelbase": 0.1,
    "drive_wheel_offset": 0.1,
    "wheel_radius": 0.02,
    "cam_phase": radians(0.2),
    "start_x": 2.0,
    "start_y": 2.0,
    "start_heading": radians(0.2),
}
OTHERS = {
    "friction": 0.125,
    "drag": 2.0,
    "rod_force": 0.2,
    "edge_break": 0.02,
    "edge_wear": 0.02,
    "taper": 0.01,
    "rod_height": 0.05,
    "eccentricity": 0.01,
    "wobble": radians(0.1),
    "steering_lost_motion": radians(0.02),
    "wheel_runout": 0.02,
    "temperature": 3.0,
}
TOLERANCES = Tolerances(
    half_widths={tolerance(name): half for name, half in HALF_WIDTHS.items()}, play=(radians(0.6), radians(0.962))
)
EVERYTHING = replace(
    TOLERANCES, half_widths={tolerance(name): half for name, half in {**HALF_WIDTHS, **OTHERS}.items()}
)


def made(mechanics: Mechanics | None) -> Cars:
    design = load_design("carbon_free_car")
    track, car, follower = cam_model.track(design), cam_model.car(design), cam_model.follower(design)
    lift = cam_model.lift(design, track)
    play = radians(0.781)
    cam = compensated_lift(lift, follower, play)
    grid = np.linspace(0.0, TURN, STEPS, endpoint=False)
    contact = roll(actual_profile(cam, follower).curve.outline(0.06), follower, grid)
    return nominal_cars(
        contact,
        follower,
        car,
        track.length,
        cam,
        drive(lift, car, track.length, steps=STEPS),
        wheel_radius=wheel_radius(track.length, 45.0),
        play=play,
        stations=range(300, STEPS + 1, 300),
        mechanics=mechanics,
        expansion=Expansion(disc=70e-6, frame=23e-6, rod=12e-6),
    )


@pytest.fixture(scope="module")
def fleet() -> Cars:
    return made(None)


def seconds(work: Callable[..., object], *args: object, **settings: object) -> float:
    start = perf_counter()
    work(*args, **settings)
    return perf_counter() - start


def test_ten_thousand_cars_against_one_import_of_the_kernel(benchmark, fleet):
    command = [sys.executable, "-c", "import build123d"]
    kernel = min(seconds(subprocess.run, command, check=True) for _ in range(3))
    benchmark.pedantic(
        tolerance_run,
        (fleet, TOLERANCES, SAMPLES),
        {"seed": 1, "map_with": partial(in_processes, PROCESSES)},
        rounds=3,
        warmup_rounds=1,
    )
    taken = benchmark.stats.stats.min
    benchmark.extra_info["imports"] = taken / kernel
    print(f"\n{SAMPLES} cars of {STEPS} steps: {taken:.2f} s, {taken / kernel:.2f} imports of {kernel:.2f} s each")
    assert taken <= MOST_IMPORTS * kernel


def test_time_is_linear_in_the_samples(benchmark, fleet):
    few = min(seconds(tolerance_run, fleet, TOLERANCES, SAMPLES // 4, seed=1) for _ in range(3))
    benchmark.pedantic(tolerance_run, (fleet, TOLERANCES, SAMPLES), {"seed": 1}, rounds=3)
    ratio = benchmark.stats.stats.min / few
    print(f"\nfour times the samples take {ratio:.2f} times as long")
    assert ratio <= 4 * LINEARITY


def test_cars_with_every_band_against_those_without(benchmark, fleet):
    """Processor time of one process, in turn, for other programs come and go."""
    rubbing = made(Mechanics(follower=cam_model.follower(load_design("carbon_free_car")), friction=0.175, drag=2.0))
    best = {"without": inf, "with": inf}
    for _ in range(5):
        for name, cars, tolerances in (("without", fleet, TOLERANCES), ("with", rubbing, EVERYTHING)):
            start = process_time()
            tolerance_run(cars, tolerances, SAMPLES // 10, seed=1)
            best[name] = min(best[name], process_time() - start)
    benchmark.pedantic(tolerance_run, (rubbing, EVERYTHING, SAMPLES // 10), {"seed": 1}, rounds=1)
    print(f"\nwith every band {best['with'] / best['without']:.2f} times as long")
    assert best["with"] <= ALL_BANDS * best["without"]


def test_memory(benchmark, fleet):
    """One process carries it all here, so its peak is the greatest there is."""
    tracemalloc.start()
    benchmark.pedantic(tolerance_run, (fleet, TOLERANCES, SAMPLES), {"seed": 1}, rounds=1)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    print(f"\npeak of {peak / 1e6:.0f} MB")
    assert peak <= MOST_BYTES
