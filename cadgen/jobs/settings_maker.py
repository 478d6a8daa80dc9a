"""The setting of a spacing: sought to first order on the rolled disc, then driven by the exact chain and checked."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import floor

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import riding_checks
from cadgen.cam.follower import Contact, EdgeFollower, edge_follower
from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.car.course.layout import Course, Draw, Judged
from cadgen.car.draws.best_settings import best_settings, first_guess
from cadgen.car.draws.drawn_spacing import DrawnSpacing, steering_check
from cadgen.car.draws.setting_ranges import CarSetting
from cadgen.car.draws.target import Steering, Target, moved_rod, planned_point
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, drive, turns_of
from cadgen.car.running.sampled import rolled_lift
from cadgen.curves.closed import ClosedCurve
from cadgen.design import cam_model, draw_model
from cadgen.design.course import layout_of
from cadgen.design.schema import Design
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.course import CourseRun, play_checks
from cadgen.jobs.cam.steering_cam import CarUse
from cadgen.messages import Message

_STATIONS = 3600  # at which the rod is rolled, an even number; the run then errs by 0.02 mm
TRIES = 3  # settings that are sought for a spacing at which the course is not kept
_HEAVIER = 2.0  # times which the error counts where the course is not kept, each time
_ROUNDING = 1e-9  # of a step
_ABOUT = 0.04  # of the run, to either side of such a place


@dataclass(frozen=True)
class Maker:
    """Makes the settings of a cam.

    Attributes:
        design: loaded design.
        cam: plan of its cam.
        draw: spacings that can be drawn.
        tries: settings that are sought for a spacing at which the course is not kept.
    """

    design: Design
    cam: CamPlan
    draw: Draw
    tries: int = TRIES

    def drawn(self, spacing: float) -> DrawnSpacing:
        """Setting for a spacing (mm) with the least error that keeps the course; else the one nearest to keeping it.

        Args:
            spacing: spacing that is drawn, mm.
        """
        design, track = self.design, self._use.track
        target = draw_model.target(design, track, self.draw, spacing, self._nodes, self._motor, self._steering)
        ranges = draw_model.setting_ranges(design, track, self._start(spacing))
        weights = np.ones(len(self._motor))
        middle = (self._rod.inner + self._rod.outer) / 2
        begin = first_guess(ranges, middle, track.turn, spacing / self.draw.stated)
        rows: list[DrawnSpacing] = []
        for _ in range(self.tries):
            near = best_settings(target, ranges, begin, weights)
            wrong: list[float] = []  # of the best
            for found in near:
                row, places = self._driven(spacing, target, found.setting)
                rows.append(row)
                if not places:
                    return min(rows, key=lambda each: each.merit)
                wrong = wrong or places
            for place in wrong:
                weights[np.abs(self._motor - place) < _ABOUT * self._motor[-1]] *= _HEAVIER
            begin = near[0].setting.values
        return min(rows, key=lambda each: each.merit)

    def _start(self, spacing: float) -> tuple[float, float, float]:
        return draw_model.start_of(self.draw, self._use.track, spacing / self.draw.stated)

    @property
    def _use(self) -> CarUse:
        return CarUse.of(self.cam)

    @cached_property
    def _course(self) -> Course:
        """The course as stated; where the car starts the setting says."""
        course = layout_of(self.design.course)
        assert course is not None  # it has spacings
        return replace(course, start=None)

    @property
    def _wanted(self) -> PathMotion:
        """Lift wanted, without play."""
        return self._use.wanted

    @cached_property
    def _rod(self) -> EdgeFollower:
        return edge_follower(self.cam.follower, Message("a card of settings"))

    @cached_property
    def _plain(self) -> ClosedCurve:
        """Curve to be cut of the disc that gives the wanted lift without play."""
        if self._use.comparison is None:
            return self.cam.curve
        return cam_model.as_built(self.design).precompensated(ACTUAL.curve(self._wanted, self._rod).curve)

    @cached_property
    def _nodes(self) -> Array:
        """Every other station up to where runs are judged, or all round where they go on."""
        even = np.linspace(0.0, TURN, _STATIONS // 2 + 1)
        return even[: floor(self._wanted.blend_start / even[1] + _ROUNDING) + 1]

    @cached_property
    def _motor(self) -> Array:
        """Nodes of all turns of a run, of several turns one in as many, so that there are no more than of one."""
        stop = self._wanted.blend_start
        step = turns_of(stop) * TURN / (_STATIONS // 2)
        return np.asarray(np.arange(floor(stop / step + _ROUNDING) + 1) * step)

    @cached_property
    def _steering(self) -> Steering:
        ranges = draw_model.setting_ranges(self.design, self._use.track, self._start(self.draw.stated))
        return Steering.of(self._rod, ranges.disc, ranges.head, lambda rod: self._contact(self._plain, rod).q)

    def _contact(self, cut: ClosedCurve, rod: EdgeFollower) -> Contact:
        stations = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
        return draw_model.contact(self.design, cut, rod, stations)

    def _driven(self, spacing: float, target: Target, setting: CarSetting) -> tuple[DrawnSpacing, list[float]]:
        """The setting as it drives, and motor positions, rad, at which it does not keep the course."""
        rod = moved_rod(self._rod, setting.disc, setting.head)
        contact = self._contact(self._plain, rod)
        lift = rolled_lift(contact, self._wanted, blend_start=self._wanted.blend_start)
        start, length = target.start(setting.values), target.rim * setting.travel
        assert self._use.course is not None  # it has spacings
        on = replace(self._use.course, lift=self._wanted, course=self.draw.course(self._course, spacing))

        def driving(stop: float, steps: int) -> Run:
            return drive(lift, target.car, length, start=start, stop=stop, steps=steps, at_joints=True)

        held = on.run(driving)
        off = self._off(held.run, spacing)
        checks = [*held.checks(), steering_check(lift, self._nodes, target.car)]
        with_play = None
        if self._use.comparison is not None:
            contact = self._contact(self.cam.curve, rod)
            lift = rolled_lift(contact, self._use.steering, blend_start=self._wanted.blend_start)
            # The chosen profile on a disc that was moved, with another wheel and another start.
            comparison = replace(
                self._use.comparison,
                task=replace(self._use.comparison.task, start=start, length=length),
                chosen=replace(self._use.comparison.chosen, rolled=lift),
            )
            # Greatest distance from the path, at the end of the run or on its last lap, over the band of play.
            measured, band = comparison.band.measured, comparison.chosen.band.plays
            plays = band if measured is None else np.array([measured])
            track, stop = self._use.track, self._wanted.blend_start
            last = stop - (TURN / track.turn_laps if track.closed else 0.0)
            runs = (comparison.run(comparison.chosen, play) for play in plays.tolist())
            with_play = max(float(self._off(run, spacing)[run.motor[run.motor <= stop] >= last].max()) for run in runs)
            if self._course.judged == Judged.PLAY:
                checks += play_checks(on, comparison)
        checks += riding_checks(lift, rod, contact, self.cam.blank, cam_model.check_limits(self.design))
        worst = int(np.argmax(off))
        place = planned_point(np.array([start.x + 1j * start.y]), np.array([start.heading]), target.offset)[0]
        row = DrawnSpacing(
            spacing=spacing,
            setting=setting,
            start=(float(place.real), float(place.imag), start.heading),
            error=float(off[worst]),
            error_at=float(held.run.motor[worst] / TURN * length),
            end=float(off[-1]),
            end_with_play=with_play,
            checks=tuple(checks),
        )
        return row, _wrong_places(held)

    def _off(self, run: Run, spacing: float) -> Array:
        """Distance of the planned point of the car from the scaled path, as far as runs are judged, shape (n,), mm."""
        judged = int(np.searchsorted(run.motor, self._wanted.blend_start, side="right"))
        wheel = run.drive_wheel[:, 0] + 1j * run.drive_wheel[:, 1]
        place = planned_point(wheel, run.heading, self.design.path.offset_mm)
        wanted = draw_model.places(self.design, self._use.track, self.draw, run.motor, spacing)
        return np.asarray(np.abs(place - wanted)[:judged])


def _wrong_places(run: CourseRun) -> list[float]:
    """Motor positions, rad, where a run does not keep its course."""
    margin, driven, motor = run.on.course.margin, run.driven, run.run.motor
    places = [there.place for _, there in driven.approaches if there.clearance < margin]
    if driven.edge is not None and driven.edge.clearance < margin:
        places.append(driven.edge.place)
    places += [passage.place for passage in driven.passages if passage.margin < 0]
    if driven.finish is not None and driven.finish.off > driven.finish.wanted.place.reach:
        places.append(len(motor) - 1.0)
    return np.interp(places, np.arange(len(motor)), motor).tolist() if places else []
