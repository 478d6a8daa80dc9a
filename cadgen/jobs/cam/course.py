"""Runs of a car held against the course of its design: the planned run, and those over the band of play."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil, degrees, inf

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.course.approach import Approach
from cadgen.car.course.body import CarBody, PartName, RunPoses
from cadgen.car.course.judge import CourseVerdict, EndDeviation, judge, judge_laps, passages
from cadgen.car.course.layout import CarPoint, Course, Judged, ObstacleKind, Shape
from cadgen.car.course.refuse import refuse_course
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import STEPS, Run, drive, poses_of, start_pose
from cadgen.car.running.mechanics import Mechanics
from cadgen.car.steering import Car
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import cam_model
from cadgen.design.course import STAND_RADIUS, body_of, layout_of
from cadgen.design.schema import Design
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.messages import Message, clauses, joined
from cadgen.output.report.tracks import Field

_STEP = 2.5  # mm of travel between poses: straight lines between them then err by 2 um on turns of 400 mm
_MOST_STEPS = 40_000
_LEAST_STEPS = 360  # of a lap
_ROUNDING = 1e-9  # rad
_NAMED = 6  # missed gates in a sentence; of ten laps there may be a hundred
_OF_KIND = {
    ObstacleKind.POST: (CheckCode.COURSE_POST, Message("nearest post")),
    ObstacleKind.WALL: (CheckCode.COURSE_WALL, Message("nearest wall")),
    ObstacleKind.ZONE: (CheckCode.COURSE_ZONE, Message("nearest zone")),
}
_POINTS = {
    CarPoint.FORK: Message("fork of the car"),
    CarPoint.DRIVE_WHEEL: Message("drive wheel of the car"),
    CarPoint.IDLE_WHEEL: Message("idle wheel of the car"),
    CarPoint.MIDDLE: Message("middle of the car"),
}
_PARTS = {
    PartName.OUTLINE: Message("by the outline"),
    PartName.FRONT_WHEEL: Message("by the front wheel"),
    PartName.DRIVE_WHEEL: Message("by the drive wheel"),
    PartName.IDLE_WHEEL: Message("by the idle wheel"),
}


@dataclass(frozen=True)
class OnCourse:
    """A design's course with the car that is to keep it.

    Without a wheel's radius a turn of the cam takes the whole path. Then runs are judged to where the closing blend
    begins, as everywhere; they go on over the blend to the end of the turn, and what happens there is shown. On a
    closed path every lap of the run is held against the course.

    Attributes:
        car: car in plan view.
        body: its outline and wheels.
        travel: travel of the drive wheel's rim for one turn of the cam, mm.
        known_wheel: whether the design gives the radius of the drive wheel.
        run_laps: laps of a closed path in a run.
        track: track of the drive wheel.
        lift: lift wanted.
        course: course of the design.
    """

    car: Car
    body: CarBody
    travel: float
    known_wheel: bool
    run_laps: int
    track: Track
    lift: PathMotion
    course: Course

    @property
    def stop(self) -> float:
        """Motor position at which the runs end, rad."""
        return self.lift.blend_start if self.all_driven else TURN

    @property
    def all_driven(self) -> bool:
        """Whether the whole path is driven before a closing blend, or is closed and needs none."""
        return self.track.closed or self.known_wheel

    def run(self, driving: Callable[[float, int], Run]) -> "CourseRun":
        """Hold a run against the course.

        Args:
            driving: run up to a motor position (rad) in a number of steps, with what happens between them.
        """
        if self.track.closed:
            laps = self.run_laps
            steps = min(max(_LEAST_STEPS, ceil(self.track.length / _STEP)), _MOST_STEPS // laps)
            run = driving(self.stop, steps * laps)
            poses, lap = poses_of(run, self.car), TURN / self.track.turn_laps
            ends = np.searchsorted(run.motor, lap * (np.arange(laps) + 1.0) - _ROUNDING).tolist()
            return CourseRun(self, run, poses, judge_laps(poses, self.car, self.body, self.course, ends))
        steps = min(max(STEPS, ceil(self.travel / _STEP)), _MOST_STEPS)
        run = driving(self.stop, steps)
        poses, end = poses_of(run, self.car), len(run.motor)
        if self.all_driven:
            return CourseRun(self, run, poses, judge(poses, self.car, self.body, self.course))
        end = max(int(np.searchsorted(run.motor, self.lift.blend_start)) + 1, 2)
        # Whether each gate lies behind the end: of those that have an order only the last can.
        late, last = [], True
        for passage in reversed(passages(poses, self.car, self.course.gates)):
            gone = passage.place > end - 1 and (passage.gate.free or last)
            last = last and (gone or passage.gate.free)
            late.append(gone)
        late.reverse()
        before, behind = (
            replace(
                self.course,
                gates=tuple(gate for gate, after in zip(self.course.gates, late, strict=True) if after is on_blend),
                start=None if on_blend else self.course.start,
                finish=self.course.finish if on_blend else None,
            )
            for on_blend in (False, True)
        )
        driven = judge(poses.part(0, end), self.car, self.body, before)
        blend = judge(poses.part(end - 1, len(poses)), self.car, self.body, behind)
        return CourseRun(self, run, poses, driven, blend)

    @cached_property
    def planned(self) -> "CourseRun":
        """The planned run.

        Raises:
            DesignError: no car can keep the course.
        """
        start = start_pose(self.track)

        def driving(stop: float, steps: int) -> Run:
            return drive(self.lift, self.car, self.travel, start=start, stop=stop, steps=steps, at_joints=True)

        first = poses_of(driving(self.stop * 1e-9, 1), self.car)
        refuse_course(self.course, self.body, first)
        return self.run(driving)

    def played(self, comparison: PlayComparison, play: float, mechanics: Mechanics | None = None) -> "CourseRun":
        """Run of the chosen profile with play, held against the course.

        Args:
            comparison: comparison of the profiles.
            play: return error, rad.
            mechanics: friction and drag; those of the nominal car if left out.
        """
        task, chosen = comparison.task, comparison.chosen
        following = task.following(
            chosen.rolled, play, least_swing=chosen.least_swing, cut=chosen.lift, mechanics=mechanics
        )

        def driving(stop: float, steps: int) -> Run:
            return drive(
                chosen.rolled,
                task.car,
                task.length,
                start=task.start,
                stop=stop,
                steps=steps,
                following=following,
                at_joints=True,
            )

        return replace(self.run(driving), play=play)


@dataclass(frozen=True)
class CourseRun:
    """A run held against a course.

    Attributes:
        on: course and car.
        run: the run.
        poses: its poses.
        driven: what the car comes near to and what it passes, up to where the run is judged.
        blend: the same on the closing blend; None where the path is driven before it.
        play: return error, rad; None of the planned run.
    """

    on: OnCourse
    run: Run
    poses: RunPoses
    driven: CourseVerdict
    blend: CourseVerdict | None = None
    play: float | None = None

    def figures(self) -> dict[str, tuple[str, float]]:
        """Clearance to each thing and margin of each gate by its key, mm, with the part of the car or what is wrong."""
        found = self.driven.figures()
        if self.blend is not None:
            for key, (where, room) in self.blend.figures().items():
                if key not in found or room < found[key][1]:
                    found[key] = (clauses(where, Message("on the blend")), room)
        return found

    def checks(self) -> tuple[Check, ...]:
        """Every figure of the run with its verdict."""
        return (*self._clear(), *self._sides(), *self._gates(), *self._stands(), *self._blend())

    def _blend(self) -> Iterator[Check]:
        """Least room on the closing blend: a figure, for the path does not steer there."""
        if self.blend is None:
            return
        room = min(
            ((room, clauses(key, where)) for key, (where, room) in self.blend.figures().items()),
            default=None,
        )
        if room is None:
            return
        code, name = CheckCode.COURSE_BLEND, Message("least margin on the blend")
        if self.play is not None:
            code, name = CheckCode.COURSE_BLEND_PLAY, Message("{name}, with play", name=name)
        yield Check(code, name, room[0], "mm", -inf, Bound.MIN, self._with_play(room[1]))

    def _clear(self) -> Iterator[Check]:
        margin, driven = self.on.course.margin, self.driven
        for kind, (code, name) in _OF_KIND.items():
            near = [(obstacle, there) for obstacle, there in driven.approaches if obstacle.kind == kind]
            if near:
                obstacle, there = min(near, key=lambda pair: pair[1].clearance)
                advice = Message("move the path away from {key}, or lower course.margin_mm", key=obstacle.key)
                yield self._check(
                    code,
                    name,
                    there.clearance,
                    "mm",
                    margin,
                    Bound.MIN,
                    self._by(obstacle.key, there),
                    advice,
                )
        if driven.edge is not None:
            field = "course.field"
            key = field if self.on.body.corners else Message("{field} (wheels alone)", field=field)
            place = self._by(key, driven.edge)
            advice = Message("move the path away from the field's edge, or lower course.margin_mm")
            yield self._check(
                CheckCode.COURSE_EDGE,
                Message("edge of the field"),
                driven.edge.clearance,
                "mm",
                margin,
                Bound.MIN,
                place,
                advice,
            )

    def _sides(self) -> Iterator[Check]:
        if any(obstacle.side for obstacle in self.on.course.obstacles):
            wrong = self.driven.wrong_sides
            place = joined(
                Message("{key} is not passed on its {side}", key=obstacle.key, side=Message(str(obstacle.side)))
                for obstacle in wrong
            ) or Message("none")
            advice = Message("lead the path past it on the other side, or change its key side")
            name = Message("passed on the wrong side")
            yield self._check(CheckCode.COURSE_SIDE, name, len(wrong), "", 0.0, Bound.MAX, place, advice)

    def _gates(self) -> Iterator[Check]:
        passages = self.driven.passages
        worst = self.driven.worst_gate
        if worst is None:
            return
        missed = [passage for passage in passages if passage.margin < 0 or passage.fault]
        place = joined(passage.missed for passage in missed[:_NAMED])
        if not missed:
            place = Message("all, {count} in order", count=len(passages))
            if self.blend is not None and self.blend.passages:
                late = len(self.blend.passages)
                place = clauses(place, Message("{late} more on the blend, not judged", late=late))
        if len(missed) > _NAMED:
            place = Message("{missed}, and {count} more", missed=place, count=len(missed) - _NAMED)
        advice = Message("lead the path through the gates in their order and direction, or make them wider")
        yield self._check(
            CheckCode.COURSE_GATES,
            Message("gates passed"),
            len(passages) - len(missed),
            "",
            len(passages),
            Bound.MIN,
            place,
            advice,
        )
        off = Message("{off:.1f} mm from its middle", off=worst.off)
        where = clauses(worst.gate.key, off, self._at(worst.place))
        name = Message("least margin of a gate")
        yield self._check(CheckCode.COURSE_GATE_MARGIN, name, worst.margin, "mm", 0.0, Bound.MIN, where, advice)

    def _stands(self) -> Iterator[Check]:
        start, finish = self.driven.start, self.driven.finish
        if start is not None and self.play is None:
            key = start.wanted.key
            cure = Message("let the path start there, or change {key}", key=key)
            yield self._off(start, CheckCode.COURSE_START, Message("distance from the start"), cure)
            cure = Message("let the path start in that direction, or change {key}.heading_deg", key=key)
            yield from self._turned(start, CheckCode.COURSE_START_HEADING, Message("heading error at the start"), cure)
        if finish is not None:
            key = finish.wanted.key
            cure = Message("let the path finish there, or change {key}", key=key)
            yield self._off(finish, CheckCode.COURSE_FINISH, Message("distance from the finish"), cure)
            cure = Message("let the path finish in that direction, or change {key}.heading_deg", key=key)
            yield from self._turned(
                finish, CheckCode.COURSE_FINISH_HEADING, Message("heading error at the finish"), cure
            )

    def _off(self, stand: EndDeviation, code: CheckCode, name: Message, cure: Message) -> Check:
        reach = stand.wanted.place.reach or STAND_RADIUS  # a line has none, and rounding must not fail it
        return self._check(code, name, stand.off, "mm", reach, Bound.MAX, _POINTS[stand.wanted.point], cure)

    def _turned(self, stand: EndDeviation, code: CheckCode, name: Message, cure: Message) -> Iterator[Check]:
        if stand.turned is not None:
            off, most = degrees(abs(stand.turned)), degrees(stand.wanted.heading_tolerance)
            yield self._check(code, name, off, "°", most, Bound.MAX, _POINTS[stand.wanted.point], cure)

    def _check(
        self, code: CheckCode, name: str, value: float, unit: str, limit: float, bound: Bound, place: str, advice: str
    ) -> Check:
        if self.play is None:
            return Check(code, name, value, unit, limit, bound, place, advice)
        judged, finish = self.on.course.judged == Judged.PLAY, self.on.course.finish
        cure = Message('make the course keep more room, take play out of the gears, or set course.judged = "planned"')
        if code == CheckCode.COURSE_FINISH and finish is not None and len(finish.place.points) > 1:
            cure = Message(
                "with play no run ends on a line: give course.finish as a disc, at_mm with a radius_mm that holds "
                'where the runs end, or set course.judged = "planned"'
            )
        free = inf if bound == Bound.MAX else -inf
        return Check(
            CheckCode(f"{code}-play"),
            Message("{name}, with play", name=name),
            value,
            unit,
            limit if judged else free,
            bound,
            self._with_play(place),
            cure,
        )

    def _with_play(self, place: str) -> str:
        if self.play is None:
            return place
        return clauses(place, Message("return error {play:.3f}°", play=degrees(self.play)))

    def _by(self, key: str, there: Approach) -> str:
        return clauses(key, _PARTS[there.part], self._at(there.place))

    def _at(self, place: float) -> str:
        at = self.poses.at(np.array([place]))
        return Message(
            "{travel:.0f} mm along, fork at ({x:.0f}, {y:.0f}) mm",
            travel=at.travel[0],
            x=at.fork[0].real,
            y=at.fork[0].imag,
        )


def on_course(design: Design, track: Track, lift: PathMotion) -> OnCourse | None:
    """The design's course; None without [course].

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift wanted.
    """
    course = layout_of(design.course)
    if course is None:
        return None
    car = cam_model.car(design)
    return OnCourse(
        car=car,
        body=body_of(design.car.outline, car),
        travel=cam_model.travel(design, track),
        known_wheel=design.car.drive_wheel_radius_mm is not None,
        run_laps=design.path.run_laps,
        track=track,
        lift=lift,
        course=course,
    )


def floor_with(design: Design, body: CarBody) -> Field:
    """Course or field of a design with the car, for pictures.

    Args:
        design: loaded design.
        body: outline and wheels of the car.
    """
    course, field = layout_of(design.course), design.field
    car = np.array(body.corners or [wheel.centre for wheel in body.wheels])
    if course is not None:
        return Field(
            edge=None if course.edge is None else np.array(course.edge.points),
            obstacles=[obstacle.shape for obstacle in course.obstacles],
            gates=[gate.place for gate in course.gates],
            car=car,
        )
    if field is None:
        return Field(car=car)
    (x, y), (width, height) = field.corner_mm, field.size_mm
    return Field(
        edge=np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]]),
        obstacles=[Shape.disc(centre, field.obstacle_radius_mm) for centre in field.obstacles_mm],
        car=car,
    )


def course_checks(on: OnCourse | None, comparison: PlayComparison | None = None) -> tuple[Check, ...]:
    """Checks of the planned run, and of the worst over the band of play if the profile was compared under play.

    Args:
        on: course with the car that is to keep it; None without a course.
        comparison: comparison of the profiles under play, if there was one.

    Raises:
        DesignError: no car can keep the course.
    """
    if on is None:
        return ()
    checks = on.planned.checks()
    return checks if comparison is None else (*checks, *play_checks(on, comparison))


def play_checks(on: OnCourse, comparison: PlayComparison) -> tuple[Check, ...]:
    """Checks of the worst run over the band of play, or with the measured play, and over friction and drag.

    Args:
        on: course with the car that is to keep it.
        comparison: comparison of the profiles under play.
    """
    task, measured = comparison.task, comparison.band.measured
    plays = comparison.chosen.band.plays if measured is None else np.array([measured])
    ends: tuple[Mechanics | None, ...] = task.mechanics.corners if task.mechanics else (None,)
    cases = [(play, end) for play in plays.tolist() for end in ends]
    worst: dict[str, Check] = {}
    for check in (check for play, end in cases for check in on.played(comparison, play, end).checks()):
        known = worst.get(check.code)
        if known is None or (check.value > known.value if check.bound == Bound.MAX else check.value < known.value):
            worst[check.code] = check
    return tuple(worst.values())
