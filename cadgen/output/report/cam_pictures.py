"""Pictures of a cam: its outline and lift, lift before and after with play, and deflection errors by event."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from math import degrees, radians
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Follower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import Following
from cadgen.car.running.run_errors import Event, deflection_sum
from cadgen.output.report.style import (
    AFTER,
    BEFORE,
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    SKY,
    VERMILLION,
    WANTED,
    figure,
    zero_line,
)
from cadgen.parts.face import Face

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
        seen: face that is seen.
    """

    title: str
    outline: Array
    openings: Sequence[Array]
    cam_angle: Array
    lift: Array
    extrema: tuple[Array, Array]
    blend_start: float
    seen: Face = Face.OUTER


@contextmanager
def cam_picture(content: CamPicture) -> Iterator["Figure"]:
    """Draw a cam: outline and lift."""
    with figure(10.0, 4.6) as picture:
        picture.suptitle(content.title, x=0.02, ha="left")
        plan, lift = picture.subplots(1, 2, width_ratios=(1.0, 1.3))
        plan.fill(*content.outline.T, facecolor="#e8ecf0", edgecolor=BLACK, linewidth=1.2)
        for opening in content.openings:
            plan.fill(*opening.T, facecolor="white", edgecolor=BLACK, linewidth=1.0)
        plan.plot(0.0, 0.0, "+", color=GREY)
        plan.set(title=f"Outline, from the {content.seen} face", xlabel="x (mm)", ylabel="y (mm)", aspect="equal")

        lift.plot(np.degrees(content.cam_angle), content.lift, color=AFTER)
        angle, height = content.extrema
        lift.plot(np.degrees(angle), height, "o", color=BEFORE, markersize=4, label="peaks and valleys")
        if content.blend_start < TURN:
            lift.axvspan(np.degrees(content.blend_start), 360, color="#eeeeee", zorder=0, label="closing blend")
        lift.set(title="Lift", xlabel="cam angle (°)", ylabel="lift (mm)", xlim=(0, 360))
        lift.set_xticks(range(0, 361, 60))
        lift.legend(loc="best")
        yield picture


@contextmanager
def forces_picture(cam_angle: Array, normal: Array, torque: Array) -> Iterator["Figure"]:
    """Draw the force on the disc and the torque of the camshaft over the turn.

    Args:
        cam_angle: cam angles, rad, shape (n,).
        normal: force along the normal of the outline, N, shape (n,).
        torque: torque that turns the camshaft, N mm, shape (n,).
    """
    with figure(8.0, 4.6) as picture:
        panels = picture.subplots(2, 1, sharex=True)
        for axes, values, name in zip(panels, (normal, torque / 1000), ("force (N)", "torque (N·m)"), strict=True):
            axes.plot(np.degrees(cam_angle), values, color=AFTER)
            zero_line(axes)
            axes.set_ylabel(name)
        panels[0].set_title("Force on the disc, and torque of the camshaft")
        panels[1].set(xlabel="cam angle (°)", xlim=(0, 360))
        panels[1].set_xticks(range(0, 361, 60))
        yield picture


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


@contextmanager
def lift_of_cams(content: LiftPicture) -> Iterator["Figure"]:
    """Draw the lift over the turn, close by a peak and a valley, and its error."""
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
            most = f"{worst:.3f} mm" if worst >= 0.01 else f"{1e3 * worst:.2g} µm"
            axes.plot(np.degrees(motor), off, color=color, linestyle=style, label=f"{label}: up to {most}")
        zero_line(axes)
        axes.set(title="Lift with play, less the lift wanted", xlabel="motor, as cam angle (°)", ylabel="error (mm)")
        axes.set_xlim(0, 360)
        axes.set_xticks(range(0, 361, 30))
        axes.legend(loc="best")
        yield picture


def _lift(content: LiftPicture, tan_beta: Array) -> Array:
    return np.asarray(content.follower.lift(tan_beta))


_COLORS = (VERMILLION, ORANGE, SKY, GREEN, BLUE)
_HATCHES = ("", "///", "...", "\\\\\\", "xxx")
_MOST_EVENTS = 12  # whose labels stand upright beside each other


@contextmanager
def events_picture(title: str, methods: Mapping[str, Sequence[Event]]) -> Iterator["Figure"]:
    """Draw each event's deflection error and their sum, one bar for each method.

    Args:
        title: title of the picture.
        methods: events by the name of the method; all with the same events in the same order.
    """
    first = next(iter(methods.values()))
    many = len(first) > _MOST_EVENTS  # beside each other their labels would stand in one another
    labels = [f"{event.kind}{' ' if many else chr(10)}{degrees(event.cam_angle):.1f}°" for event in first]
    width = 0.8 / len(methods)
    with figure(8.5, 4.6 if many else 4.2) as picture:
        axes, total = picture.subplots(1, 2, width_ratios=(len(first), max(1.4, 0.14 * len(first))))
        for number, (method, events) in enumerate(methods.items()):
            style = {"color": _COLORS[number], "hatch": _HATCHES[number], "edgecolor": "white", "linewidth": 0.0}
            place = (number - (len(methods) - 1) / 2) * width
            heights = [degrees(event.deflection) for event in events]
            axes.bar(np.arange(len(events)) + place, heights, width, label=method, **style)
            bar = total.bar([place], [degrees(deflection_sum(tuple(events)))], width, **style)
            total.bar_label(bar, fmt="%.2f", fontsize=7, padding=2)
        for panel in (axes, total):
            zero_line(panel)
            panel.grid(axis="x", visible=False)
        axes.set_xticks(range(len(labels)), labels, **({"rotation": 90, "fontsize": 7} if many else {}))
        axes.set(title=title, ylabel="deflection error (°)", xlabel="event and its cam angle")
        picture.legend(loc="outside lower center", ncols=len(methods), fontsize=8)  # no bar may lie under it
        total.set_xticks([0], ["sum"])
        total.margins(y=0.12)
        yield picture
