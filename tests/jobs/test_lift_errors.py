"""The lift errors that the manifest states, against a dense rolling by other code than the program's."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from cadgen.cam.followers.rod import LeaningRod
from cadgen.curves.closed import Outline
from cadgen.design.load import load_design
from cadgen.geometry.meshes.content import inspect
from cadgen.geometry.solids.step_text import read_rim
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.output.files.dxf import read_dxf
from cadgen.output.files.gcode_reader import read_gcode
from cadgen.output.files.stl import read_stl
from cadgen.output.files.tables import contact_outline, read_csv
from cadgen.output.files.threemf import read_3mf
from cadgen.output.files.xyz import read_xyz

Array = NDArray[np.float64]

STEP, FINE = 4e-3, 1e-3  # mm, of the outlines rolled round the turn and where the difference is greatest
STATIONS, PLACES, WITHIN = 900, 4, 9
TRAVEL, HOLLOW, MOST_BETWEEN = 0.02, 0.6, 100  # mm; a chord of a hollow, where the contact moves fast, is 0.1 mm long
FORMATS = (".step", ".nc")  # where rolling and reading had their own errors in it; any may be asked for
# Rolling tells lifts to some 0.0002 um, so that an error of 0.01 um is not known to a hundredth.
BAR, RESOLVED_UM = 0.01, 3e-4


def rolled(outline: Outline, follower: LeaningRod, theta: Array) -> tuple[Array, Array]:
    """Lift, mm, and polar angle of the contact, rad: the least tan(beta) at which the rod clears every point.

    In a face plane the rod's edge is a line at a distance r from its axis: (w T - u)^2 = h^2 (1 + T^2) with
    h^2 = r^2 - y^2. No parabola between the points, only many points.
    """
    points = outline.points
    angle = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    turns = np.concatenate([angle - 2 * np.pi, angle, angle + 2 * np.pi])
    thrice = np.concatenate([points] * 3)
    reach = np.arcsin(follower.radius / np.hypot(*points.T).min())
    found, contact = np.empty(len(theta)), np.empty(len(theta))
    for number, at in enumerate(theta):
        at = angle[0] + (at - angle[0]) % (2 * np.pi)
        first, last = np.searchsorted(turns, [at - reach, at + reach])
        under = thrice[first:last] @ np.array([[np.cos(at), -np.sin(at)], [np.sin(at), np.cos(at)]])
        under = under[np.abs(under[:, 1]) < follower.radius]
        u, square = under[:, 0] - follower.base_radius, follower.radius**2 - under[:, 1] ** 2
        found[number] = -np.inf
        for w in (follower.inner, follower.outer):
            a, b, c = w * w - square, -2 * w * u, u * u - square
            lean = (-b + np.sqrt(b * b - 4 * a * c)) / (2 * a)
            if lean.max() > found[number]:
                found[number], contact[number] = lean.max(), at + np.arctan2(*under[lean.argmax(), ::-1])
    return np.asarray(follower.lift(found)), contact


def stations(outline: Outline, follower: LeaningRod) -> Array:
    """Cam angles round the turn, closer together where the contact moves fast."""
    even = np.linspace(0, 2 * np.pi, STATIONS, endpoint=False)
    _, contact = rolled(outline, follower, even)
    travel = follower.base_radius * np.abs(np.diff(np.unwrap(contact)))
    count = np.where(travel > HOLLOW, np.clip(np.ceil(travel / TRAVEL), 1, MOST_BETWEEN), 1).astype(int)
    parts = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(even, even[1:], count, strict=False)]
    return np.concatenate([*parts, even[-1:]])


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", ["appendix_car"])
def test_stated_lift_errors_are_those_of_a_dense_rolling(name, tmp_path):
    design = load_design(name)
    plan = plan_cam(design, "actual")
    entry = write_cam(plan, tmp_path, find_cures(plan)).entry
    stem, follower, curve = f"{name}_actual", plan.follower, plan.curve

    def file(end: str) -> Path:
        return tmp_path / f"{stem}{end}"

    readers = {
        ".step": lambda step: read_rim(file(".step"), step),
        ".stl": lambda step: inspect(read_stl(file(".stl")), step).rim,
        ".3mf": lambda step: inspect(read_3mf(file(".3mf"))[0], step).rim,
        "_arcs.dxf": lambda step: read_dxf(file("_arcs.dxf"), step).profile,
        "_spline.dxf": lambda step: read_dxf(file("_spline.dxf"), step).profile,
        ".nc": lambda step: read_gcode(file(".nc"), design.machining, plan.follower_as_built.land, step).outline,
        ".xyz": lambda step: read_xyz(file(".xyz"), step),
        ".csv": lambda step: contact_outline(read_csv(file(".csv")), step),
    }
    assert {file(end).name for end in readers} == set(entry["files"])
    coarse, fine = curve.outline(STEP), curve.outline(FINE)
    theta = stations(coarse, follower)
    exact = rolled(coarse, follower, theta)[0]
    apart = np.maximum(np.diff(theta, append=2 * np.pi), np.diff(theta, prepend=theta[-1] - 2 * np.pi))
    for end in FORMATS:
        read = readers[end]
        size = np.abs(rolled(read(STEP), follower, theta)[0] - exact)
        humps = np.flatnonzero((size >= np.roll(size, 1)) & (size >= np.roll(size, -1)))
        humps = humps[np.argsort(-size[humps])[:PLACES]]
        centre, reach, outline = theta[humps], apart[humps], read(FINE)
        greatest = 0.0
        for _ in range(2):
            within = centre[:, None] + reach[:, None] * np.linspace(-1, 1, WITHIN)
            lifts = [rolled(one, follower, within.ravel())[0] for one in (outline, fine)]
            size = np.abs(lifts[0] - lifts[1]).reshape(within.shape) * 1e3
            greatest = max(greatest, float(size.max()))
            centre, reach = within[np.arange(len(within)), size.argmax(axis=1)], reach * 2 / (WITHIN - 1)
        stated = entry["files"][file(end).name]["lift_error_um"]
        off = stated - greatest
        print(f"{file(end).name}: {stated:.5f} um stated, {greatest:.5f} um rolled, {100 * off / greatest:+.2f} %")
        assert abs(off) < max(BAR * greatest, RESOLVED_UM)
