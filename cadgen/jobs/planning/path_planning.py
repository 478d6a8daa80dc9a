"""A planned path, or why there is none: in sentences, as facts, and as a design file."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from math import atan, degrees, radians, tan
from os import PathLike
from pathlib import Path

from cadgen.car.course.refuse import largest_circle, least_steering, turning_circle
from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.car.planner.constraints import LimitKind
from cadgen.car.planner.gates import least_length
from cadgen.car.planner.path_plan import PathPlan, Reason
from cadgen.car.planner.path_task import Margins, PathTask
from cadgen.car.running.drive import drive, start_pose
from cadgen.design import cam_model
from cadgen.design.load import design_of
from cadgen.design.schema import Design
from cadgen.errors import CheckError, FileError
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.steering_cam import CarUse
from cadgen.jobs.card import drawn_verdict
from cadgen.jobs.planning.cars import CarsOnPaths
from cadgen.messages import Message, joined
from cadgen.output.files.publisher import Artifact, Written, folder_of, publish, refusal, text_file
from cadgen.output.report import settings_card as settings
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing
from cadgen.output.report.tracks import TrackPanel, tracks_picture
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict
from cadgen.version import __version__

_STEEPEST = radians(75)
# Limits that a field brings about in which the car cannot turn round.
_OF_TURNS = (LimitKind.TURN, LimitKind.PRESSURE_ANGLE, LimitKind.CONVEX_RADIUS, LimitKind.FIELD)


@dataclass(frozen=True, eq=False, kw_only=True)
class PathPlanning(Pictured):
    """A planned path, or the reasons why there is none.

    Attributes:
        asked: design that a path was planned for.
        task: what the planner was asked.
        plan: the planner's result.
        text: text of the design file with the path; empty if none was found.
        cam: plan of the cam for the path with all checks; None if no path was found.
        reasons: limits of which each is in the way where no path was found; empty if one was.
        drawn: settings with which the path was driven at some of the spacings that can be drawn; empty without them.
        kept: what was kept from the limits besides.
        cars: cars within the tolerances on this path, on that before it, and on others; None if nothing varies or the
            course holds nothing that cars could miss.
        no_cars: why the cars cannot be reckoned, in a sentence; empty if they can.
        wheel_radius: radius of the drive wheel that the plan chose, mm; None if it was given or follows from the path.
    """

    asked: Design
    task: PathTask
    plan: PathPlan
    text: str
    cam: CamPlan | None
    reasons: tuple[Reason, ...] = ()
    drawn: tuple[DrawnSpacing, ...] = ()
    kept: Margins = field(default_factory=Margins)
    cars: CarsOnPaths | None = None
    no_cars: str = ""
    wheel_radius: float | None = None

    @property
    def picture(self) -> Drawing:
        """Tracks of the planned run over the course.

        Raises:
            CheckError: there is no path.
        """
        if self.cam is None:
            raise CheckError(self.sentences[0])
        use = CarUse.of(self.cam)
        if use.comparison is None:
            length = cam_model.travel(use.design, use.track)
            run = drive(use.steering, cam_model.car(use.design), length, start=start_pose(use.track))
        else:
            run = use.comparison.task.planned()
        return tracks_picture([TrackPanel(title=f"{self.asked.name}: the planned path", run=run)], run, use.floor)

    @property
    def sound(self) -> bool:
        """Whether there is a path whose cam keeps its checks, at every spacing that was driven; its car may fail."""
        return self.cam is not None and self.cam.sound and not any(each.failed for each in self.drawn)

    @property
    def passed(self) -> bool:
        """Whether there is a path, and its cam may be cut for its car: enough of the cars keep the course, too."""
        return self.verdict is not None and self.verdict.passed

    @property
    def verdict(self) -> PartVerdict | None:
        """Verdict on the cam, with what fails at the spacings that were driven; None where no path was found."""
        return None if self.cam is None else drawn_verdict(self.cam, self.drawn)

    @property
    def sentences(self) -> tuple[str, ...]:
        """The result in words, the most important first."""
        if self.reasons or self.cam is None:
            return tuple(self._refusal())
        plan, use = self.plan, CarUse.of(self.cam)
        lines: list[str] = [] if self.cars is None else [_kept(self.cars)]
        if use.comparison is not None:
            low, high = (degrees(end) for end in use.comparison.band.ends)
            before = (
                None if self.cars is None or self.cars.before is None else CarUse.of(self.cars.before.cam).comparison
            )
            was = "" if before is None else Message(", and on the path before {ends}", ends=_ends(before))
            lines.append(
                Message(
                    "with play from {low:.3f} to {high:.3f} degrees the run ends at most {ends} off{was} "
                    "({profile} profile, by the exact chain)",
                    low=low,
                    high=high,
                    ends=_ends(use.comparison),
                    was=was,
                    profile=use.comparison.chosen.profile,
                )
            )
        if self.cars is not None:
            lines += _reserves(self.cars)
        if self.no_cars:
            lines.append(Message("how many cars keep the course is not known: {no_cars}", no_cars=self.no_cars))
        length = plan.path.cost.line.length
        lines.append(
            Message(
                "the drive wheel's track is {length:.0f} mm long; the path has {count} control points",
                length=length,
                count=len(plan.path.points),
            )
        )
        if (radius := self.wheel_radius) is not None:
            lines.append(
                Message(
                    "the plan is for a drive wheel of {radius:.2f} mm radius: the whole path before the closing blend",
                    radius=radius,
                )
            )
        if use.laps is not None:
            said: list[str] = [use.drive_wheel.sentence()]
            if use.comparison is not None:
                said += use.laps.sentences(use.comparison.run, use.comparison.before, use.comparison.chosen)
            lines += [sentence.removesuffix(".") for sentence in said]
        if self.drawn:
            lines += [*settings.sentences(self.drawn, None), Message("cadgen card has the settings for every spacing")]
        if not self.sound:
            lines.append(Message("a check still fails, so nothing is written: see the table"))
        return tuple(lines)

    def _refusal(self) -> list[str]:
        if not self.reasons:
            names = joined(list(map(str, self.plan.missed)))
            return [
                Message(
                    "no path was found that keeps all limits; the best one violates {names}: try --seeds 5", names=names
                )
            ]
        first, *rest = self.reasons
        if narrow := _narrow_field(first, self.task):
            return [Message("no path was found: {fault}", fault=narrow)]
        fault = _fault(first, self.task)
        if self.proven:
            found = Message("the course cannot be driven: {fault}", fault=fault)
        else:
            found = Message("no path was found, though there may be one; where it comes nearest {fault}", fault=fault)
        lines: list[str] = [found]
        if first.enough:
            least = Message("; least change that does: {cure}", cure=_cure(first, self.task, self.asked))
            lines[0] = joined((lines[0], least), "")
            lines += [
                Message("or {cure}", cure=_cure(reason, self.task, self.asked)) for reason in rest if reason.enough
            ]
        else:
            lines[0] = joined((lines[0], Message("; and no single limit that gives way is enough")), "")
        if not self.proven:
            lines.append(
                Message(
                    "tried: smooth paths, paths of arcs and those of a car that grows, along the gates in one order; "
                    "--seeds 5 tries other ways"
                )
            )
        return lines

    @property
    def proven(self) -> bool:
        """Whether there can be no path: straight from gate to gate it is longer than the drive wheel's travel.

        Else the search has found none, which proves nothing.
        """
        length = bool(self.reasons) and self.reasons[0].limit.kind == LimitKind.LENGTH
        return length and least_length(self.task) > self.task.vehicle.most_length

    def entry(self) -> Facts:
        """The result, as in the manifest."""
        design, plan, cam = self.asked, self.plan, self.cam
        comparison = None if cam is None else CarUse.of(cam).comparison
        return Facts(
            design=design.name,
            design_sha256=design.content_hash,
            overrides=design.overrides,
            cadgen=__version__,
            passed=self.passed,
            control_points=len(plan.path.points),
            track_mm=plan.path.cost.line.length,
            drive_wheel_radius_mm=self.wheel_radius,
            first_order_mm=plan.path.cost.distance,
            worst_end_position_mm=None if comparison is None else comparison.chosen.band.worst_distance,
            worst_end_heading_deg=None if comparison is None else degrees(comparison.chosen.band.worst_heading),
            return_error_deg=None if comparison is None else [degrees(end) for end in comparison.band.ends],
            **{"yield": self.cars and _cars_facts(self.cars)},
            failed=[] if cam is None else [check.code for check in cam.failed],
            verdict=None if self.verdict is None else self.verdict.entry(),
            settings=settings.rows(design, self.drawn),
            said=self.sentences,
            proven=self.proven,
            reasons=[
                Facts(limit=str(each.limit), amount=each.amount, near_mm=each.place, enough=each.enough)
                for each in self.reasons
            ],
        )

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the design with the planned path, `NAME_planned.toml`, where comments of the file stay.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: there is no path, or a check fails.
            FileError: the file cannot be written, or read back is not what was written.
        """
        cam = self.cam
        if cam is None:
            raise CheckError(self.sentences[0])
        if not self.sound:
            drawn = (check for each in self.drawn for check in each.checks)
            raise CheckError(refusal((*cam.checks, *drawn), forced=False))
        stem, planned = f"{self.asked.name}_planned", cam.origin.content_hash
        progress("writing")

        def files(staging: Path) -> Iterator[Artifact]:
            file = staging / f"{stem}.toml"
            yield text_file(file, self.text)
            if design_of(file.read_text(encoding="utf-8"), file).content_hash != planned:
                raise FileError(
                    "{file}: read back it is not what was written; try again or choose another disk", file=file.name
                )

        return publish(stem, folder_of(folder), files, self.entry())


def _kept(cars: CarsOnPaths) -> Message:
    """Sentence on how many cars keep the course, before and after, and what binds them."""
    after, (key, share), first = cars.after, cars.binding, cars.after.sensitivities[0]
    said = [
        Message(
            "{passed:.1f} % of {samples} cars within the tolerances keep the course with the {code} profile",
            passed=100 * cars.share,
            samples=after.samples,
            code=after.cam.kind.code,
        )
    ]
    if cars.share_before is not None:
        said.append(Message(", where {passed:.1f} % do on the path before", passed=100 * cars.share_before))
    if cars.fewer:
        said.insert(0, Message("fewer cars than on the path before: "))
    if cars.share < 1.0:
        said.append(Message("; what binds is {key}, which {share:.1f} % keep", key=key, share=100 * share))
        if first.share > 0:
            name = Message(first.name.replace("_", " "))
            said.append(
                Message(
                    ", and {name} makes {share:.0f} % of the variance at the end", name=name, share=100 * first.share
                )
            )
    return joined(said, "")


def _reserves(cars: CarsOnPaths) -> list[str]:
    """Sentence on the paths that were tried, so that another may be asked for."""
    if len(cars.tried) == 1:
        return []
    tried = joined([f"{each.factor:g} ({each.worst:.0f} mm, {100 * each.kept:.1f} %)" for each in cars.tried])
    return [
        Message(
            "room at gates and obstacles is planned for {factor:g} times the scatter of the cars; tried, with "
            "the run's worst end and the cars that keep the course: {tried}; --reserve asks for one",
            factor=cars.chosen.factor,
            tried=tried,
        )
    ]


def _ends(comparison: PlayComparison) -> Message:
    band = comparison.chosen.band
    return Message(
        "{position:.0f} mm and {heading:.2f} degrees",
        position=band.worst_distance,
        heading=degrees(band.worst_heading),
    )


def _cars_facts(cars: CarsOnPaths) -> Facts:
    """Cars on the path."""
    (key, share), before = cars.binding, cars.before
    known = None if before is None else CarUse.of(before.cam).comparison
    return Facts(
        cars=cars.after.samples,
        profile=cars.after.cam.kind.code,
        seed=cars.after.seed,
        kept=cars.share,
        kept_before=cars.share_before,
        worst_end_position_before_mm=None if known is None else known.chosen.band.worst_distance,
        binding=key,
        binding_kept=share,
        greatest_share_of_variance={each.name: each.share for each in cars.after.sensitivities[:3]},
        reserve=cars.chosen.factor,
        tried=[Facts(reserve=each.factor, kept=each.kept, worst_end_position_mm=each.worst) for each in cars.tried],
        scatter_mm=dict(cars.chosen.scatter),
    )


def _narrow_field(reason: Reason, task: PathTask) -> str:
    """Sentence on a field in which the car cannot turn round, where that may be why; empty if it can."""
    field, vehicle, kind = task.course.edge, task.vehicle, reason.limit.kind
    if field is None or kind not in _OF_TURNS or (reason.enough and kind != LimitKind.FIELD):
        return ""
    car, body = vehicle.car, vehicle.body
    taken, room = turning_circle(body, car, car.max_steering_angle) + task.course.margin, largest_circle(field)
    if taken <= room:
        return ""
    steering = least_steering(body, car, room - task.course.margin, _STEEPEST)
    more = (
        ""
        if steering is None
        else Message(", or raise car.max_steering_angle_deg to {value:.0f}", value=degrees(steering) + 0.5)
    )
    return Message(
        "course.field is too small for the car to turn round in: with "
        "{max_steering_angle:.0f} degrees of steering that takes a circle of {taken:.0f} mm "
        "radius, and the field holds one of {room:.0f} mm: make the field {wider:.0f} mm "
        "wider{more}",
        max_steering_angle=degrees(car.max_steering_angle),
        taken=taken,
        room=room,
        wider=2 * (taken - room) + 1,
        more=more,
    )


def _fault(reason: Reason, task: PathTask) -> str:
    """The fault, and its amount, as the end of a sentence."""
    x, y = reason.place
    where = Message("near ({x:.0f}, {y:.0f}) mm", x=x, y=y)
    limits, kind, key, amount = task.limits, reason.limit.kind, reason.limit.key, reason.amount
    if kind == LimitKind.TURN:
        held = 1 / min(limits.left, limits.right)
        return Message(
            "it needs a turn {where} that is {amount:.0f} % tighter than the {held:.0f} mm that the fork holds",
            where=where,
            amount=100 * amount,
            held=held,
        )
    if kind == LimitKind.PRESSURE_ANGLE:
        steep = degrees(atan((1 + amount) * tan(limits.rise)))
        most = degrees(limits.rise)
        return Message(
            "it needs a pressure angle of {steep:.1f} degrees {where}, and {most:.1f} are planned for",
            steep=steep,
            where=where,
            most=most,
        )
    if kind == LimitKind.BLEND:
        return Message(
            "the closing blend must come over {amount:.0f} % more lift than the rod can follow", amount=100 * amount
        )
    if kind in (LimitKind.CONVEX_RADIUS, LimitKind.VALLEY):
        return Message(
            "the lift must turn {amount:.0f} % more sharply {where} than the outline can follow",
            amount=100 * amount,
            where=where,
        )
    if kind in (LimitKind.SLOPE, LimitKind.BEND):
        return Message(
            "the curvature must change {amount:.0f} % faster {where} than the path it is compared with",
            amount=100 * amount,
            where=where,
        )
    if kind == LimitKind.LENGTH:
        return Message(
            "the path is {amount:.0f} mm longer than wheel and train drive before the closing blend", amount=amount
        )
    if kind == LimitKind.CORRIDOR:
        return Message(
            "the path must leave the given one by {amount:.1f} mm more than it may, {where}", amount=amount, where=where
        )
    if kind == LimitKind.HEADING:
        return Message(
            "{key} cannot be passed in its direction, by {amount:.1f} degrees", key=key, amount=degrees(amount)
        )
    if kind == LimitKind.GATE:
        return Message("{key} is missed by {amount:.1f} mm", key=key, amount=amount)
    return Message("the car comes {amount:.1f} mm too near to {key} {where}", amount=amount, key=key, where=where)


def _cure(reason: Reason, task: PathTask, design: Design) -> str:
    """The change that would do, as the end of a sentence."""
    kind, key, amount = reason.limit.kind, reason.limit.key, reason.amount
    if kind == LimitKind.TURN:
        steering = degrees(atan((1 + amount) * tan(task.vehicle.car.max_steering_angle)))
        return Message("raise car.max_steering_angle_deg to {value:.0f}", value=steering + 0.5)
    if kind == LimitKind.PRESSURE_ANGLE:
        return Message("raise cam.base_radius_mm to {value:.0f}", value=(1 + amount) * design.cam.base_radius_mm + 0.5)
    if kind == LimitKind.CONVEX_RADIUS:
        return Message(
            "raise cam.base_radius_mm to {value:.0f}, or take a thinner rod",
            value=(1 + amount) * design.cam.base_radius_mm + 0.5,
        )
    if kind == LimitKind.BLEND:
        return Message("raise cam.blend_deg to {value:.0f}", value=(1 + amount) * design.cam.blend_deg + 0.5)
    if kind == LimitKind.VALLEY:
        most = (1 + amount) * (design.optimize.max_lift_error_um or 0.0)
        return Message("raise optimize.max_lift_error_um to {value:.0f}", value=most + 1)
    if kind in (LimitKind.SLOPE, LimitKind.BEND):
        return Message("allow the curvature to change {amount:.0f} % faster", amount=100 * amount + 1)
    if kind == LimitKind.LENGTH:
        radius = design.car.drive_wheel_radius_mm or 0.0
        wheel = radius * (1 + amount / task.vehicle.most_length)
        return Message("raise car.drive_wheel_radius_mm to {wheel:.2f}", wheel=wheel + 0.01)
    if kind == LimitKind.CORRIDOR:
        return Message("allow {within:.1f} mm", within=task.within + amount + 0.1)
    if kind == LimitKind.HEADING:
        return Message("raise {key}.heading_tolerance_deg by {amount:.1f}", key=key, amount=degrees(amount) + 0.1)
    if kind == LimitKind.GATE:
        return Message(
            "make {key} {amount:.1f} mm wider to either side, or move it by that", key=key, amount=amount + 0.1
        )
    # Less than no margin cannot be asked for; that of the task may be more than that of the design.
    if design.course is None or amount + 0.1 > design.course.margin_mm:
        if kind == LimitKind.FIELD:
            return Message("make the field {amount:.1f} mm larger there", amount=amount + 0.1)
        return Message("move {key} by {amount:.1f} mm", key=key, amount=amount + 0.1)
    if kind == LimitKind.FIELD:
        return Message(
            "make the field {amount:.1f} mm larger there, or lower course.margin_mm by that", amount=amount + 0.1
        )
    return Message("move {key} by {amount:.1f} mm, or lower course.margin_mm by that", key=key, amount=amount + 0.1)
