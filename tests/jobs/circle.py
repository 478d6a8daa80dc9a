"""The whole circle: a car that is not as designed runs, is measured, gets the cam that it needs, and runs again.

    python -m tests.jobs.circle [--cars 3] [--seed 1]

What is wrong with a car (zero of its steering, radius of its wheel, and but for every third car play in its gears) is
drawn here and told to nobody. The car is driven by the generator of `tests.inference.measurement`: the rod let down on
the points of the outline, the cam walking downhill in its play, the car going by short arcs. `cadgen calibrate` sees
the camera's file alone, `cadgen cam` the design that it wrote, and the second run takes the new profile from the DXF
file for the workshop.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from cadgen.curves.closed import Outline
from cadgen.inference.measurement.record import Record
from cadgen.output.files.dxf import read_dxf
from tests.conftest import Built, build
from tests.inference.measurement.synthetic import DEG, TURN, Bench
from tests.inference.measurement.synthetic import Car as Bed
from tests.inference.measurement.synthetic_drive import Wheels, track_record

DESIGN = "carbon_free_car"
NOISE_MM = 3.0
STATIONS = 7200  # of the generator's table of the lift
STEP_DEG = 360 / STATIONS  # by which its cam walks downhill
OUTLINE_MM = 0.03  # distance of the points read back

Cadgen = Callable[..., None]


@dataclass(frozen=True)
class Circle:
    """One car before and after.

    Attributes:
        wheels: what is wrong with it.
        told: the calibration's document.
        before, after: distance of the run's end from the end of the path, mm.
    """

    wheels: Wheels
    told: dict[str, Any]
    before: float
    after: float

    @property
    def gone(self) -> float:
        """Share of the error that is gone."""
        return 1 - self.after / self.before


def draw(rng: np.random.Generator, *, play: bool = True) -> Wheels:
    """A car as workshops make them; the play, if any, is a whole number of the generator's steps."""
    return Wheels(
        zero=rng.choice([-1, 1]) * rng.uniform(0.2, 0.8) * DEG,
        radius=1 + rng.choice([-1, 1]) * rng.uniform(0.004, 0.015),
        play=int(rng.integers(10, 20)) * play * STEP_DEG * DEG,
    )


def go_round(built: Built, wheels: Wheels, rng: np.random.Generator, folder: Path, cadgen: Cadgen) -> Circle:
    """Measure a car, calibrate, cut the cam, run again.

    Args:
        built: the car as designed.
        wheels: the car as it is.
        rng: for the camera's noise and the start by hand.
        folder: for the files.
        cadgen: calls the command line.
    """
    end = built.lift.blend_start
    goal = complex(*built.track.position(built.track.length * end / TURN))
    old = _world(built, built.actual.curve.outline(OUTLINE_MM))
    before = abs(_end(old, wheels, end) - goal)

    measured = folder / "camera.csv"
    write_csv(track_record(SimpleNamespace(built=old), wheels, rng, noise_mm=NOISE_MM), measured)
    cadgen("calibrate", DESIGN, str(measured), "--profile", "actual", "--out", str(folder))
    told = json.loads((folder / f"{DESIGN}_calibration.json").read_text())

    cadgen("cam", str(folder / f"{DESIGN}_as_built.toml"), "--profile", "optimized", "--out", str(folder))
    (stem,) = (file.stem.removesuffix("_arcs") for file in folder.glob("*_optimized_arcs.dxf"))
    stop = json.loads((folder / "manifest.json").read_text())["parts"][stem]["as_built"]["stop"]["cam_angle_deg"]
    new = _world(built, read_dxf(folder / f"{stem}_arcs.dxf", OUTLINE_MM).profile)
    return Circle(wheels, told, before, abs(_end(new, wheels, stop * DEG) - goal))


def write_csv(record: Record, file: Path) -> None:
    """A record as a measured file."""
    table = {"run": record.run + 1, **record.columns}
    rows = zip(*table.values(), strict=True)
    lines = [",".join(table), *(",".join(str(cell) for cell in row) for row in rows)]
    file.write_text("\n".join([f"# design: {DESIGN}", *lines, ""]))


def _world(built: Built, outline: Outline) -> SimpleNamespace:
    """The car for the generator: the designed car and path, with the lift that an outline gives the rod."""
    disc = SimpleNamespace(outline=lambda step: outline)
    bed = Bed(SimpleNamespace(actual=SimpleNamespace(curve=disc), follower=built.follower))
    table = bed.steering(Bench(), np.arange(STATIONS) * TURN / STATIONS)

    def tan_beta(angle: Any) -> Any:
        return np.interp(angle, np.arange(STATIONS) * TURN / STATIONS, table, period=TURN)

    return SimpleNamespace(lift=SimpleNamespace(q=tan_beta), car=built.car, track=built.track)


def _end(world: SimpleNamespace, wheels: Wheels, stop: float) -> complex:
    return complex(wheels.track(world, np.array([0.0, stop]))[-1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cars", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rng, built = np.random.default_rng(given.seed), build(DESIGN)

    def cadgen(*arguments: str) -> None:
        subprocess.run([sys.executable, "-m", "cadgen", *arguments], check=True, stdout=subprocess.DEVNULL)

    for number in range(1, given.cars + 1):
        wheels = draw(rng, play=number % 3 != 0)
        with tempfile.TemporaryDirectory() as folder:
            circle = go_round(built, wheels, rng, Path(folder), cadgen)
        print(
            f"zero {np.degrees(wheels.zero):+.3f}°, wheel {100 * (wheels.radius - 1):+.2f} %, play "
            f"{np.degrees(wheels.play):.2f}°: the run ended {circle.before:.0f} mm off, now "
            f"{circle.after:.1f} mm: {100 * circle.gone:.2f} % gone"
        )


if __name__ == "__main__":
    main()
