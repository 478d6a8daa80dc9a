"""Judge of the fuzzer on a cam that was written: the independent driver of `tests/car/path_truth.py` on its points.

The package gives what the file does not say: the arc length at each waypoint, the heading at the start and the travel
of one turn of the cam. The waypoints themselves are those of the file; of a B-spline they are its knots.
"""

import json
from collections.abc import Iterator, Sequence
from math import dist, prod, tau
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.check import CheckCode
from cadgen.design import cam_model
from cadgen.design.load import load_design
from tests.car.path_truth import car_of, driven, points_of, steering

# A waypoint may be missed by 0.1 mm. The driver adds 0.05 mm: splines through the points of the cloud and through 3600
# steerings err by up to 0.01 mm on the packaged designs, and by a twentieth of the loss beside a corner of the outline.
ALLOWED, OF_FILE = 0.1, 0.05
OF_LOSS = 1.25  # what the program says that a cam misses, it may miss, and this much more by the driver's own error
STATIONS = 3600
LEAST_POINTS = 3000  # in fewer points the cloud itself is too coarse for a spline
LEAST_WHEEL, MOST_WHEEL, WHEEL_OTHER = 0.02, 3.0, 0.25  # of the wheelbase, and of the wheel in the outline
LEAST_PATH = 1.0  # wheelbases; a shorter path is no course for a car


def judge(design: Path, overrides: Sequence[str], written: Path, code: int) -> Iterator[str]:
    """Faults of a cam that was written to a folder, by its points, its manifest and its design.

    Args:
        design: design file.
        overrides: its changes, as of --set.
        written: folder of the files.
        code: exit code of the command.
    """
    clouds = list(written.glob("*_actual*.xyz"))
    if not clouds or b"[motion" in design.read_bytes():
        return
    model = load_design(design, overrides)
    if model.as_built is not None:  # its disc is cut so that the car as it was measured makes it right
        return
    values = model.model_dump(exclude_none=True)
    checks = _checks(written / "manifest.json")
    said = max(checks[CheckCode.CUT_WAYPOINT]["value"], checks[CheckCode.CUT_END]["value"])
    ready = "a false ready" if code == 0 else "not as the manifest says"
    missed = farthest(model, values, clouds[0])
    if missed is not None and missed > max(ALLOWED, OF_LOSS * said) + OF_FILE:
        yield f"{ready}: a waypoint is missed by {missed:.2f} mm, and {said:.2f} mm are said"
    if code == 0:
        yield from (f"a false ready: {what}" for what in _out_of_size(model, values))


def _checks(manifest: Path) -> dict[str, dict[str, Any]]:
    (part,) = json.loads(manifest.read_text())["parts"].values()
    return {check["code"]: check for check in part["checks"]}


def farthest(model: Any, values: dict[str, Any], cloud: Path) -> float | None:
    """Greatest distance of the car from the waypoints that it passes in the first turn, mm; None in too few points.

    Args:
        model: loaded design.
        values: its sections.
        cloud: points of the outline.
    """
    points = points_of(cloud)
    if len(points) < LEAST_POINTS:
        return None
    track, car = cam_model.track(model), car_of(values)
    stop = min(cam_model.path_end(model, track), track.turn)
    tangent = steering(points, car, np.arange(STATIONS) * tau / STATIONS)
    start = complex(track.planned(0.0) @ [1, 1j]), float(track.heading(np.array([0.0]))[0])
    arcs = np.asarray(track.waypoint_arc)
    asked = track.planned(arcs) @ [1, 1j]
    if "waypoints_mm" in values["path"] and not track.closed:
        asked = np.array(values["path"]["waypoints_mm"]) @ [1, 1j]
        start = complex(asked[0]), start[1]
    place = driven(tangent, cam_model.travel(model, track), stop, car, start)
    passed = arcs < stop * (1 - 1e-9)
    return float(np.abs(place(arcs[passed]) - asked[passed]).max(initial=0.0))


def _out_of_size(model: Any, values: dict[str, Any]) -> Iterator[str]:
    """Drive wheel or path out of all proportion, which no careful builder would cut."""
    base, track = values["car"]["wheelbase_mm"], cam_model.track(model)
    knots = values["path"].get("waypoints_mm") or values["path"]["control_points_mm"]
    if (length := sum(map(dist, knots[1:], knots[:-1]))) < LEAST_PATH * base:
        yield f"a path of {length:.3g} mm for a wheelbase of {base:.4g} mm"
    stages = values.get("train", {}).get("stages", ())
    radius = values["car"].get("drive_wheel_radius_mm")
    if radius is None and stages and all("teeth" in stage.get("driver", {}) for stage in stages):
        ratio = prod(stage["driven"]["teeth"] / stage["driver"]["teeth"] for stage in stages)
        radius = track.turn / (tau * ratio)
    if radius is None:
        return
    if not LEAST_WHEEL * 0.99 <= radius / base <= MOST_WHEEL * 1.01:
        yield f"a drive wheel of {2 * radius:.4g} mm for a wheelbase of {base:.4g} mm"
    outlined = values["car"].get("outline", {}).get("wheel_diameter_mm")
    if outlined is not None and abs(2 * radius - outlined) > 1.02 * WHEEL_OTHER * outlined:
        yield f"a drive wheel of {2 * radius:.4g} mm where the outline has {outlined:.4g} mm"
