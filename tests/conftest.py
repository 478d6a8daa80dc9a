"""The two cars of the paper, built once per run from the files in `designs/`; and designs made of tables or text."""

import os
import signal

# Threads that wait for each other over small matrices cost more than they bring, and the suite fills all cores anyway.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import tomllib
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from math import radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tomli_w
from hypothesis import settings

from cadgen.cam.envelope import ActualProfile, actual_profile
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.path.spline import plan_path
from cadgen.car.path.wheel_track import Track, offset_track
from cadgen.car.path_motion import PathMotion, path_motion
from cadgen.car.steering import Car, steering_jets
from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.record import Kind
from tests.forks import Forks

# A submission is judged on the same random examples every time; at the desk each run tries others. No test has a
# deadline, for that of a busy computer would be another.
settings.register_profile("desk", deadline=None)
settings.register_profile("submission", deadline=None, derandomize=True)
settings.load_profile("submission" if os.environ.get("CI") else "desk")

Tables = dict[str, Any]

_MINIMAL: Tables = {
    "path": {"waypoints_mm": [[0, 0], [1500, 200], [2600, 1200], [4000, 1500], [5500, 1000]]},
    "car": {"wheelbase_mm": 167, "drive_wheel_offset_mm": 37, "idle_wheel_offset_mm": 201},
    "cam": {"base_radius_mm": 70, "mid_plane_mm": 25, "thickness_mm": 3},
    "follower": {"radius_mm": 2.5},
}

# Changes to packaged cars that leave them neither brake nor trim nor friction: their best cam is one against play.
UNBRAKED = ("mechanics=", "blank.material=", "optimize.hardware=", "tolerances.start_gap_deg=")

DESIGNS = Path(__file__).parent.parent / "designs"
TRICYCLE = Path(__file__).parent.parent / "docs" / "examples" / "cadgen-tricycle"


@dataclass(frozen=True)
class Built:
    """A car from its waypoints to its actual profile."""

    car: Car
    track: Track
    lift: PathMotion
    follower: LeaningRod
    actual: ActualProfile


def build(name: str) -> Built:
    """Build a packaged design through the numeric rooms alone."""
    data = tomllib.loads((DESIGNS / f"{name}.toml").read_text())
    path, cam = data["path"], data["cam"]
    car = Car(
        wheelbase=data["car"]["wheelbase_mm"],
        drive_wheel_offset=data["car"]["drive_wheel_offset_mm"],
        idle_wheel_offset=data["car"]["idle_wheel_offset_mm"],
        max_steering_angle=radians(data["car"]["max_steering_angle_deg"]),
    )
    thickness = cam["thickness_mm"]
    inner = cam["inner_face_mm"] if "inner_face_mm" in cam else cam["mid_plane_mm"] - thickness / 2
    follower = LeaningRod(
        base_radius=cam["base_radius_mm"],
        inner=inner,
        outer=inner + thickness,
        radius=data["follower"]["radius_mm"],
        length=data["follower"]["length_mm"],
    )
    track = offset_track(plan_path(np.array(path["waypoints_mm"]), path["spline"]), path["offset_mm"])
    lift = path_motion(track.arc, steering_jets(track, car), track.length, blend=radians(cam["blend_deg"]))
    return Built(car, track, lift, follower, actual_profile(lift, follower))


@pytest.fixture(autouse=True)
def signals_as_before() -> Iterator[None]:
    """A command that is called within this process ends with its signals ignored, and from Python 3.12 on a pool
    whose process was killed waits for ever for those that ignore them."""
    numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = {number: signal.getsignal(number) for number in numbers}
    yield
    for number, handler in before.items():
        if signal.getsignal(number) is not handler:
            signal.signal(number, handler)


@pytest.fixture(scope="session")
def forks() -> Iterator[Forks]:
    """A process that has loaded the program, for commands in forks of it."""
    process = Forks()
    yield process
    process.close()


@pytest.fixture(scope="session")
def carbon_free_car() -> Built:
    """Tables 1 and 2 with the sixth-order spline."""
    return build("carbon_free_car")


@pytest.fixture(scope="session")
def appendix_car() -> Built:
    """The appendix program's car with its cubic spline."""
    return build("appendix_car")


@pytest.fixture
def minimal() -> Tables:
    """The shortest design, as tables that a test may change."""
    return deepcopy(_MINIMAL)


@pytest.fixture
def written(tmp_path: Path) -> Callable[[str | bytes | Tables], Path]:
    """Write a design file from text, bytes or tables and return its path."""

    def write(content: str | bytes | Tables) -> Path:
        file = tmp_path / "mine.toml"
        if isinstance(content, dict):
            content = tomli_w.dumps(content)
        file.write_bytes(content.encode() if isinstance(content, str) else content)
        return file

    return write


@pytest.fixture(scope="session")
def measured() -> Path:
    """Where the measured files lie."""
    return Path(__file__).parent / "data" / "measured"


@pytest.fixture(scope="module")
def tricycle(monkeypatch_module: pytest.MonkeyPatch) -> Iterator[Kind]:
    """The kind of data of the example package, registered while a module of tests runs."""
    monkeypatch_module.syspath_prepend(str(TRICYCLE / "src"))
    from cadgen_tricycle import STEERED_TRACK

    kinds.register(STEERED_TRACK)
    yield STEERED_TRACK
    kinds.remove(STEERED_TRACK)


@pytest.fixture(scope="module")
def monkeypatch_module() -> Iterator[pytest.MonkeyPatch]:
    with pytest.MonkeyPatch.context() as patch:
        yield patch
