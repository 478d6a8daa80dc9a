"""Errors of the camera, or of whatever else says where a car is: they change the track and not the car.

A scale makes the track of a larger wheel and a smaller gain of the lever; a lens, a tilted axis and a scale of one axis
look like wheel radius, gain and slip. A track alone is not searched for them: what is found is held against them.

Stages: `CAMERA` (places as x + iy, mm). `at` is the `CameraView`.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.deviations.effect import Effect, Group, Parameter, Stage

Places = NDArray[np.complex128]


@dataclass(frozen=True)
class CameraView:
    """Middle of what the camera sees of a track, greatest distance from it, and where the track starts, x + iy, mm."""

    middle: complex
    extent: float
    start: complex


CAMERA = Stage[Places]("camera", of_instrument=True)
RULE = "lay a rule on the floor, along and across, and measure it by the same camera"


def _about(act: Callable[[Places, NDArray[np.float64]], Places]) -> Callable[..., Places]:
    """Change of places about the middle of the view, in shares of its extent; the start stays."""

    def changed(place: Places, p: NDArray[np.float64], at: CameraView) -> Places:
        start: Places = np.asarray([(at.start - at.middle) / at.extent], dtype=complex)
        seen: Places = act(np.asarray((place - at.middle) / at.extent, dtype=complex), p)
        return np.asarray(at.start + at.extent * np.subtract(seen, act(start, p)), dtype=complex)

    return changed


def _percent(name: str, meaning: str, limit: float = 20.0) -> Parameter:
    return Parameter.of(f"{name}_percent", limit, 0.05, 1.0, meaning)


def _laid(place: Places, p: NDArray[np.float64], at: CameraView) -> Places:
    return np.asarray(at.start + complex(p[0], p[1]) + (place - at.start) * np.exp(1j * p[2]))


# One scale is off, and one thing bends straight lines.
_SCALE, _BENDS = Group("scales of the camera"), Group("lens and perspective of the camera")

CAMERA_FRAME = Effect(
    name="frame of the camera",
    stage=CAMERA,
    parameters=(
        Parameter.of("frame_x_mm", 200.0, 1.0, 50.0, "+: it reads all places too far along x"),
        Parameter.of("frame_y_mm", 200.0, 1.0, 50.0, "+: likewise along y"),
        Parameter.of("frame_turn_deg", 10.0, 0.02, 1.0, "+: it reads all ways turned to the left, about the start"),
    ),
    act=_laid,
    separated_by="lay its frame by two marks on the line from which the car starts",
)
CAMERA_EFFECTS = (
    Effect(
        name="scale of the camera",
        stage=CAMERA,
        parameters=(_percent("camera_scale", "+: it reads too much"),),
        act=_about(lambda z, p: np.asarray(z * (1 + p[0]))),
        group=_SCALE,
        confused_with="wheel radius with lever gain",
        separated_by=RULE,
    ),
    Effect(
        name="scale of one axis of the camera",
        stage=CAMERA,
        parameters=(_percent("camera_x", "+: x reads too much, and y is right"),),
        act=_about(lambda z, p: np.asarray(z + p[0] * z.real)),
        group=_SCALE,
        confused_with="wheel radius, lever gain, slip with curvature",
        separated_by=RULE,
    ),
    Effect(
        name="scale of the camera's other axis",
        stage=CAMERA,
        parameters=(_percent("camera_y", "+: y reads too much, and x is right"),),
        act=_about(lambda z, p: np.asarray(z + 1j * p[0] * z.imag)),
        group=_SCALE,
        confused_with="wheel radius, lever gain, slip with curvature",
        separated_by=RULE,
    ),
    Effect(
        name="lens of the camera",
        stage=CAMERA,
        parameters=(_percent("lens", "+: the edge of the track reads too far out, by so much"),),
        act=_about(lambda z, p: np.asarray(z * (1 + p[0] * np.abs(z) ** 2))),
        group=_BENDS,
        confused_with="wheel radius",
        separated_by=RULE,
    ),
    Effect(
        name="perspective of the camera",
        stage=CAMERA,
        parameters=(
            _percent("perspective_x", "+: what is far along x reads too small, by so much at the edge"),
            _percent("perspective_y", "+: likewise along y"),
        ),
        act=_about(lambda z, p: np.asarray(z / (1 + p[0] * z.real + p[1] * z.imag))),
        group=_BENDS,
        confused_with="wheel radius, lever gain, slip with curvature",
        separated_by=RULE,
    ),
    CAMERA_FRAME,
)
