"""A cam on one picture: its outline with bore and holes, and its lift over the turn."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.output.report.style import AFTER, BEFORE, BLACK, GREY, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, kw_only=True)
class CamPicture:
    """Content of the picture of a cam.

    Attributes:
        title: title of the picture.
        outline: closed polygon of the profile, shape (n, 2), mm.
        openings: closed polygons of bore and holes, shape (m, 2) each, mm.
        cam_angle: cam angles, shape (k,), rad.
        lift: at these cam angles, shape (k,), mm.
        extrema: cam angles of peaks and valleys, shape (p,), rad, and the lift there, shape (p,), mm.
        blend_start: cam angle at which the closing blend begins, rad; a turn or more if there is none.
    """

    title: str
    outline: Array
    openings: Sequence[Array]
    cam_angle: Array
    lift: Array
    extrema: tuple[Array, Array]
    blend_start: float


def cam_figure(content: CamPicture) -> "Figure":
    """Draw a cam; return the figure, to be shown or saved by the caller."""
    with figure(10.0, 4.6) as picture:
        picture.suptitle(content.title, x=0.02, ha="left")
        plan, lift = picture.subplots(1, 2, width_ratios=(1.0, 1.3))
        plan.fill(*content.outline.T, facecolor="#e8ecf0", edgecolor=BLACK, linewidth=1.2)
        for opening in content.openings:
            plan.fill(*opening.T, facecolor="white", edgecolor=BLACK, linewidth=1.0)
        plan.plot(0.0, 0.0, "+", color=GREY)
        plan.set(title="Outline, from the outer face", xlabel="x (mm)", ylabel="y (mm)", aspect="equal")

        lift.plot(np.degrees(content.cam_angle), content.lift, color=AFTER)
        angle, height = content.extrema
        lift.plot(np.degrees(angle), height, "o", color=BEFORE, markersize=4, label="peaks and valleys")
        if content.blend_start < TURN:
            lift.axvspan(np.degrees(content.blend_start), 360, color="#eeeeee", zorder=0, label="closing blend")
        lift.set(title="Lift", xlabel="cam angle (°)", ylabel="lift (mm)", xlim=(0, 360))
        lift.set_xticks(range(0, 361, 60))
        lift.legend(loc="best")
    return picture
