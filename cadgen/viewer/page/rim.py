"""Deviations on the rim of a disc: what was measured against the design, or what a profile takes off against play."""

from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.curves.closed import Outline
from cadgen.deviations.effect import UNITS
from cadgen.inference.measurement.record import Abscissa
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.messages import Message
from cadgen.viewer.page.document import RimDeviations

if TYPE_CHECKING:
    from cadgen.jobs.calibration.calibration import CalibrationPlan
    from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan

_STEP = 0.1  # mm between points of an outline
_PLACES = 720  # on the rim
_LEAST = 1e-4  # mm; a profile that differs by less is the plain one


def rim_of(
    cam: CamPlan, comparison: PlayComparison | None, calibration: "CalibrationPlan | None"
) -> RimDeviations | None:
    """Deviations to be shown on the rim, measured ones first; None where the disc is the plain one and unmeasured.

    Args:
        cam: plan of the cam.
        comparison: comparison under play; None for a profile that is not for play.
        calibration: verdict on measured files; None without any.
    """
    outline = cam.curve.outline(_STEP)
    polar, radius, places = _rim(outline)
    for diagnosis in () if calibration is None else calibration.diagnoses:
        if diagnosis.kind.abscissa != Abscissa.CAM_ANGLE or diagnosis.unit != "um" or diagnosis.kind.plan_view:
            continue
        angle = np.mod(diagnosis.place, TURN)
        contact = roll(outline, cam.follower_as_built, angle)
        touched = np.mod(angle + np.arcsin(np.clip(contact.across / _radius(outline, angle), -1.0, 1.0)), TURN)
        return _of_readings(places, touched, diagnosis.before / UNITS["um"])
    if comparison is None:
        return None
    taken = 1e3 * (radius - _radius(comparison.before.cut.outline(_STEP), polar))
    if np.abs(taken).max() < 1e3 * _LEAST:
        return None
    return RimDeviations(Message("profile, less the plain one"), "µm", places, taken)


def compared_rim(compared: "ComparedCamPlan") -> RimDeviations:
    """Deviations of a measured cam by a motion from its design, along the normal, on the rim of the disc as designed.

    Args:
        compared: measured cam beside its design.
    """
    cam, (off, angle) = compared.cam, compared.comparison.departures
    outline, follower = cam.curve.outline(_STEP), cam.follower_as_built
    touched = np.mod(follower.place(roll(outline, follower, np.mod(angle, TURN))), TURN)
    return _of_readings(_rim(outline)[2], touched, off / UNITS["um"])


def _rim(outline: Outline) -> tuple[Array, Array, Array]:
    """Polar angles, radii and places on an outline at which deviations are shown."""
    polar = np.arange(_PLACES) * TURN / _PLACES
    radius = _radius(outline, polar)
    return polar, radius, radius[:, None] * np.column_stack([np.cos(polar), np.sin(polar)])


def _of_readings(places: Array, touched: Array, off: Array) -> RimDeviations:
    """Means of the readings near each place, µm, from their polar angles; between them where there are none."""
    polar = np.arange(_PLACES) * TURN / _PLACES
    near = np.floor(touched / TURN * _PLACES).astype(int) % _PLACES
    count, total = (np.bincount(near, weights, _PLACES) for weights in (None, off))
    known = count > 0
    values = np.interp(polar, polar[known], total[known] / count[known], period=TURN)
    return RimDeviations(Message("measured, less the design"), "µm", places, values)


def _radius(outline: Outline, polar: Array) -> Array:
    """Radius of an outline at polar angles, mm."""
    x, y = outline.points.T
    angle = np.mod(np.arctan2(y, x), TURN)
    order = np.argsort(angle)
    return np.asarray(np.interp(polar, angle[order], np.hypot(x, y)[order], period=TURN))
