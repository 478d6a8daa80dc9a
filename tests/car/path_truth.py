"""A car driven on a cut cam, by a derivation that shares no code with the package.

The outline is read as points. A round rod at the steering angle beta crosses the plane of a face, at the distance w
from the fork axis, in an ellipse: its middle lies a + w tan(beta) from the camshaft on the ray to the fork, its half
axes are r / cos(beta) along the ray and r across. The rod rests where one of the two ellipses touches the outline and
neither cuts into it. The car then rolls along the curvature -tan(beta) / (L + A1 tan(beta)).
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline


@dataclass(frozen=True)
class Car:
    """Dimensions of a design file that matter here, mm; `sign` is -1 where the disc is on the right of the fork."""

    wheelbase: float
    drive_wheel: float
    base: float
    faces: tuple[float, float]
    rod: float
    offset: float
    sign: float


def car_of(sections: dict[str, Any]) -> Car:
    """Dimensions from the sections of a design file; the rod rides on the land between broken edges."""
    cam = sections["cam"]
    inner, outer, middle, thick = (
        cam.get(key) for key in ("inner_face_mm", "outer_face_mm", "mid_plane_mm", "thickness_mm")
    )
    if thick is None:
        half = outer - middle if inner is None else middle - inner if outer is None else (outer - inner) / 2
        thick = 2 * half
    if inner is None:
        inner = middle - thick / 2 if outer is None else outer - thick
    broken = sections.get("blank", {}).get("edge_break_mm", 0.0)
    return Car(
        wheelbase=sections["car"]["wheelbase_mm"],
        drive_wheel=sections["car"]["drive_wheel_offset_mm"],
        base=cam["base_radius_mm"],
        faces=(inner + broken, inner + thick - broken),
        rod=sections["follower"]["radius_mm"],
        offset=sections["path"].get("offset_mm", 0.0),
        sign=-1.0 if cam.get("side") == "right" else 1.0,
    )


def steering(outline: np.ndarray, car: Car, angles: np.ndarray) -> np.ndarray:
    """Steering tan(beta) at cam angles, from the points of an outline, shape (n, 2), mm, in order round it."""
    around = np.vstack([outline, outline[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(around, axis=0).T))])
    curve = CubicSpline(along, around, bc_type="periodic")
    points = curve(np.linspace(0.0, along[-1], 40 * len(outline), endpoint=False)) @ [1, 1j]
    bearing = np.angle(points)
    order = np.argsort(bearing)
    points, bearing = points[order], bearing[order]
    found = np.empty(len(angles))
    for number, angle in enumerate(angles):
        middle = (angle + np.pi) % (2 * np.pi) - np.pi
        reach = 1.5 * car.rod / np.abs(points).min()
        lowest, highest = np.searchsorted(bearing, [middle - reach, middle + reach])
        picked = np.arange(lowest, highest)
        if middle - reach < -np.pi:
            picked = np.append(picked, np.arange(np.searchsorted(bearing, middle - reach + 2 * np.pi), len(points)))
        if middle + reach > np.pi:
            picked = np.append(picked, np.arange(np.searchsorted(bearing, middle + reach - 2 * np.pi)))
        near = points[picked] * np.exp(-1j * angle)
        near = near[np.abs(near.imag) < car.rod]
        half = car.rod * np.sqrt(1 - (near.imag / car.rod) ** 2)
        tangent = 0.0
        for _ in range(12):
            least = (near.real + half * np.hypot(1.0, tangent)).max() - car.base
            tangent = max(least / face for face in car.faces)
        found[number] = tangent
    return found * car.sign


def driven(tangent: np.ndarray, turn: float, stop: float, car: Car, start: tuple[complex, float]) -> CubicSpline:
    """Place of the planned path's point of the car, as a spline of the travel in mm.

    Args:
        tangent: tan(beta) at even cam angles of one turn, the first at 0.
        turn: travel of the drive wheel in one turn of the cam, mm.
        stop: travel at which the run ends, mm.
        car: dimensions.
        start: place of that point, x + iy, mm, and heading, rad.
    """
    angles = np.linspace(0.0, turn, len(tangent) + 1)
    lift = CubicSpline(angles, np.append(tangent, tangent[0]), bc_type="periodic")
    travel = np.linspace(0.0, stop, 40_001)
    step = travel[1] - travel[0]
    # Simpson's rule on each step, for the heading and then for the place.
    at = np.linspace(0.0, stop, 2 * len(travel) - 1)
    bend = -lift(at) / (car.wheelbase + car.drive_wheel * lift(at))
    turned = np.concatenate([[0.0], np.cumsum(step / 6 * (bend[:-2:2] + 4 * bend[1::2] + bend[2::2]))])
    heading = start[1] + turned
    halfway = heading[:-1] + step / 24 * (5 * bend[:-2:2] + 8 * bend[1::2] - bend[2::2])
    gained = step / 6 * (np.exp(1j * heading[:-1]) + 4 * np.exp(1j * halfway) + np.exp(1j * heading[1:]))
    wheel = np.concatenate([[0.0], np.cumsum(gained)]) + start[0] + 1j * car.offset * np.exp(1j * start[1])
    return CubicSpline(travel, wheel - 1j * car.offset * np.exp(1j * heading))


def points_of(file: Path) -> np.ndarray:
    """Points of an exported cloud, shape (n, 2), mm."""
    points = np.loadtxt(file, comments="#", usecols=(0, 1))
    return points[:-1] if np.array_equal(points[0], points[-1]) else points
