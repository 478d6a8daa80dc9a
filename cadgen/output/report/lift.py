"""Lift before and after, without and with play (the paper's figures 14 and 16a)."""

from dataclasses import dataclass
from math import degrees, radians
from pathlib import Path

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Follower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import Following
from cadgen.output.report.style import AFTER, BEFORE, GREY, WANTED, figure, save, zero_line

_POINTS = 7200
_AROUND = 3.5  # times the play, shown to either side of an event
_LEAST_AROUND = radians(1.0)  # also where there is hardly any play


@dataclass(frozen=True, kw_only=True)
class LiftPicture:
    """Content of the picture of two lifts.

    Attributes:
        title: title of the picture.
        follower: follower, which gives the lift in mm.
        wanted: lift wanted by motor position.
        before: motion, with play, of the cam with the actual profile or of the measured cam.
        before_name: name of that cam.
        after: motion, with play, of the cam that is compared with it.
        after_name: name of that cam.
        play: return error B, rad.
        peak: cam angle of the jump that is magnified, rad; None if there is none.
        valley: cam angle of the wait that is magnified, rad; None if there is none.
    """

    title: str
    follower: Follower
    wanted: PathMotion
    before: Following
    before_name: str
    after: Following
    after_name: str
    play: float
    peak: float | None
    valley: float | None


def draw_lift(content: LiftPicture, folder: Path, name: str) -> list[str]:
    """Draw the lift over the turn, close by a peak and a valley, and its error; return the files' names."""
    motor = np.linspace(0.0, min(content.wanted.blend_start, TURN), _POINTS)
    events = (("The cam jumps", content.peak), ("The cam waits", content.valley))
    close = [(title, angle) for title, angle in events if angle is not None]
    with figure(8.0, 9.0 if close else 6.0) as picture:
        grid = picture.add_gridspec(3 if close else 2, 2, height_ratios=(1.2, 1.2, 1.0) if close else (1.2, 1.0))
        picture.suptitle(f"{content.title}: lift, return error {degrees(content.play):.3f}°", x=0.02, ha="left")

        axes = picture.add_subplot(grid[0, :])
        turn = np.linspace(0.0, 2 * np.pi, _POINTS)
        axes.plot(
            np.degrees(turn),
            _lift(content, content.before.lift.q(turn)),
            color=BEFORE,
            label=content.before_name,
        )
        after = _lift(content, content.after.lift.q(turn))
        axes.plot(np.degrees(turn), after, color=AFTER, linestyle=(0, (5, 2)), label=content.after_name)
        if content.wanted.blended:
            axes.axvspan(degrees(content.wanted.blend_start), 360, color="#eeeeee", zorder=0)
            axes.text(
                354, 0.97, "blend", rotation=90, ha="center", va="top", color=GREY, transform=axes.get_xaxis_transform()
            )
        axes.set(title="What the profiles are cut for", xlabel="cam angle (°)", ylabel="lift (mm)", xlim=(0, 360))
        axes.set_xticks(range(0, 361, 30))
        axes.legend(loc="best")

        for column, (title, angle) in enumerate(close):
            axes = picture.add_subplot(grid[1, column])
            near = angle + np.linspace(-1.0, 1.0, 801) * max(_AROUND * content.play, _LEAST_AROUND)
            x = np.degrees(near)
            axes.plot(x, _lift(content, content.wanted.q(near)), color=WANTED, linewidth=3.5, alpha=0.25)
            axes.plot(x, _lift(content, content.before.tan_beta(near)), color=BEFORE)
            axes.plot(x, _lift(content, content.after.tan_beta(near)), color=AFTER, linestyle=(0, (5, 2)))
            axes.set(title=f"{title} ({degrees(angle) % 360:.1f}°)", xlabel="motor, as cam angle (°)")
            axes.set_ylabel("lift with play (mm)")
            axes.ticklabel_format(axis="y", useOffset=False)  # lifts themselves, also where they hardly change
            if column == 0:
                axes.legend(["wanted", content.before_name, content.after_name], loc="best")

        axes = picture.add_subplot(grid[-1, :])
        wanted = _lift(content, content.wanted.q(motor))
        for following, color, style, label in (
            (content.before, BEFORE, "-", content.before_name),
            (content.after, AFTER, (0, (5, 2)), content.after_name),
        ):
            off = _lift(content, following.tan_beta(motor)) - wanted
            worst = float(np.abs(off).max())
            axes.plot(np.degrees(motor), off, color=color, linestyle=style, label=f"{label}: up to {_length(worst)}")
        zero_line(axes)
        axes.set(title="Lift with play, less the lift wanted", xlabel="motor, as cam angle (°)", ylabel="error (mm)")
        axes.set_xlim(0, 360)
        axes.set_xticks(range(0, 361, 30))
        axes.legend(loc="best")
        return save(picture, folder, name)


def _length(value: float) -> str:
    """A length (mm) in words, a small one in micrometres."""
    return f"{value:.3f} mm" if value >= 0.01 else f"{1e3 * value:.2g} µm"


def _lift(content: LiftPicture, tan_beta: Array) -> Array:
    return np.asarray(content.follower.lift(tan_beta))
