"""The gear train of a design: play, order of the stages, and the train that is made, with its checks and files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import degrees, prod
from typing import TYPE_CHECKING

from cadgen.check import CheckList
from cadgen.design import gear_model
from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError
from cadgen.figures import Facts, Sheet
from cadgen.gears.choices import Order, SearchObjective, Thinning, ToleranceStandard
from cadgen.gears.cutting import Made, cutting_checks, cutting_notes
from cadgen.gears.distribution import quantiles
from cadgen.gears.layout import TrainLayout
from cadgen.gears.spur import SpurPair, spur_pairs
from cadgen.gears.stage import Departure, Stage, Wheel
from cadgen.gears.synthesis import SearchLimits, arrange, front_of, losses_of, search_of, size_of
from cadgen.gears.train import Loose, Train, TrainPlay, WholePlay, teeth_of, train_play
from cadgen.geometry.meshes.made_train import MadeTrain, failing_stages, make_train
from cadgen.jobs.car_layout import CarLayout, laid_out, turned_to
from cadgen.jobs.gears.assembly import (
    Assembly,
    checks_facts,
    losses,
    losses_note,
    parts_facts,
    return_error,
    stages_facts,
)
from cadgen.jobs.gears.train_making import TrainMaking
from cadgen.messages import Message, joined
from cadgen.output.files.manifest import Origin
from cadgen.parts.print_compensation import PrintCompensation
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.design.machining import DrawingText

# If none of the trains that a search reports can be made, so many of those whose gears fit their blanks are tried.
DEPTHS = (100, 1000, 4000)
# Greatest number of trains whose teeth are measured in mesh. If none of these passes its checks, the first is reported
# with the checks that it fails; the limits of the search keep nearly all failing pairs out before that.
MOST_MEASURED = 200


@dataclass(frozen=True)
class Skipped:
    """A train with less return error than the one that is made, and why it is not made."""

    play: TrainPlay
    reason: str


class NotMadeError(DesignError):
    """Refusal of all of several trains; `ranked` are those tried first, `baseline` the play compared with."""

    def __init__(self, message: str, ranked: tuple[TrainPlay, ...], baseline: TrainPlay) -> None:
        super().__init__(message)
        self.ranked, self.baseline = ranked, baseline


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class GearTrain(Assembly):
    """The gear train of a design, computed and checked: what `Design.gears` gives. Lengths are mm and angles rad.

    Attributes:
        origin: design that the train was planned from.
        title: texts of the design's title blocks; None where it has none.
        making: what the drawings say of its parts and of the plates besides their shapes.
        makings: how the teeth of each part are made; of gears that are cut apart, of each by itself.
        mesh_chord: greatest chord error of the parts' meshes that the design gives, mm; None where it gives none.
        compensation: what files for printing take back; None where the design does not say.
        friction: friction coefficient of the flanks and its source; None where the design has none.
        front: trains of a search that no other beats in return error and size; none where they are not asked for.
        front_whole: whether the front was searched to its end.
        front_with_losses: whether losses count in it.
        order: order of the stages: `as-given`, `reordered` or `search`.
        designed: play of the train as the design has it.
        designed_standard: play of that train without the design's overrides; None if the standards do not cover it.
        ranked: trains that the order calls for, least return error first.
        play: play of the train that is made: the first that can be made and passes its checks.
        skipped: trains with less return error.
        standard: play of the train that is made, without the design's overrides; None if not covered.
        departures: overrides beside the standard's values.
        notes: sentences on the train: keys of the design that searched trains lack, and the meaning of its thinning.
        layout: parts at their places, with thinned teeth.
        checks: every figure with its verdict.
        loose: joints and bearings with play.
        car: train in its car; None for a design without [layout].
    """

    origin: Origin
    title: DrawingText | None
    making: TrainMaking
    makings: tuple[Made, ...]
    mesh_chord: float | None
    compensation: PrintCompensation | None
    friction: tuple[float, str] | None
    front: tuple[TrainPlay, ...]
    front_whole: bool
    front_with_losses: bool
    order: Order
    designed: TrainPlay
    designed_standard: TrainPlay | None
    ranked: tuple[TrainPlay, ...]
    play: TrainPlay
    skipped: tuple[Skipped, ...]
    standard: TrainPlay | None
    departures: tuple[Departure, ...]
    notes: tuple[str, ...]
    layout: TrainLayout
    checks: CheckList
    loose: tuple[Loose, ...]
    car: CarLayout | None = None

    def __repr__(self) -> str:
        return f"<GearTrain of {self.name}, {self.order}, ratio {self.ratio}>"

    @property
    def computed(self) -> GearTrain:
        """The train itself: it is computed already."""
        return self

    @property
    def name(self) -> str:
        """Name of the design."""
        return self.origin.name

    @property
    def whole(self) -> WholePlay:
        """Return error of the train that is made, with joints and bearings."""
        return WholePlay(teeth=self.play, loose=self.loose)

    @property
    def baseline(self) -> TrainPlay:
        """Play that the ranked trains are compared with; for a search, of the given train by the standard alone."""
        return _baseline(self.order, self.designed, self.designed_standard)

    @property
    def return_errors(self) -> Sheet:
        """Play and return error of every stage and of the train, on one sheet."""
        return _return_errors(self)

    @property
    def stem(self) -> str:
        """Start of the names of its files: one stage alone has no other order, and is named as `cadgen pair` has it."""
        alone = self.car is None and self.order == Order.AS_GIVEN and len(self.play.train.stages) == 1
        return self.name if alone else f"{self.name}_{self.order}"

    @property
    def description(self) -> str:
        """Description of the train for STEP files, one line."""
        return f"gear train, {self.order}, design {self.origin.content_hash[:12]}"

    @property
    def printing(self) -> PrintCompensation | None:
        """Compensation of the files for printing; None where the design does not say."""
        return self.compensation

    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm: the design's, or that which suits all of its gears.

        Args:
            gears: gears of the part.
        """
        return gear_model.usual_chord(gears) if self.mesh_chord is None else self.mesh_chord

    def efficiency_of(self, train: Train) -> float | None:
        """Efficiency of the teeth of a train, as cut; None without a friction coefficient, or where it is not known.

        Args:
            train: train of the front.
        """
        if self.friction is None:
            return None
        friction, _ = self.friction
        each = [stage.as_cut().efficiency(friction) for stage in train.stages]
        known = [one for one in each if one is not None]
        return prod(known) if len(known) == len(each) else None

    def entry(self) -> Facts:
        """Every tolerance, play, part and inspection size, as in the manifest."""
        whole = self.whole
        error = {
            **return_error(self.play),
            **quantiles(self.play.return_error_distribution(), degrees(1)),
        }
        facts = Facts(order=self.order, passed=self.passed, ratio=str(self.play.train.ratio), return_error_deg=error)
        if self.front:
            facts |= Facts(
                front=[
                    Facts(
                        teeth=teeth_of(play),
                        modules_mm=[stage.module for stage in play.train.stages],
                        size_mm=size_of(play.train),
                        loss_factors=losses_of(play.train),
                        efficiency=self.efficiency_of(play.train),
                        **return_error(play),
                    )
                    for play in self.front
                ],
                front_whole=self.front_whole,
            )
        if self.friction is not None:
            facts |= Facts(losses=losses(self.layout.train, *self.friction))
        if whole.loose:
            facts |= Facts(
                return_error_with_joints_deg=return_error(whole),
                joints_deg=[
                    Facts(name=joint.name, least=degrees(joint.least), greatest=degrees(joint.greatest))
                    for joint in whole.loose
                ],
            )
        return (
            self.origin.entry()
            | facts
            | Facts(
                return_error_as_given_deg=return_error(self.designed),
                return_error_as_given_by_the_standard_deg=self.designed_standard
                and return_error(self.designed_standard),
                return_error_by_the_standard_deg=self.standard and return_error(self.standard),
                notes=self.notes,
                stages=stages_facts(self.layout),
                ranked=[
                    Facts(
                        teeth=teeth_of(play),
                        modules_mm=[stage.module for stage in play.train.stages],
                        widths_mm=[[wheel.width for wheel in stage.wheels] for stage in play.train.stages],
                        **return_error(play),
                    )
                    for play in self.ranked
                ],
                skipped=[
                    Facts(
                        teeth=teeth_of(skipped.play),
                        greatest=degrees(skipped.play.return_error_max),
                        reason=skipped.reason,
                    )
                    for skipped in self.skipped
                ],
                overridden_tolerances=[
                    Facts(
                        where=departure.where,
                        symbol=departure.symbol,
                        used_um=departure.used * 1e3,
                        standard_um=None if departure.standard is None else departure.standard * 1e3,
                    )
                    for departure in self.departures
                ],
                checks=checks_facts(self.checks),
                parts=parts_facts(self.layout.pieces),
            )
            | (Facts() if self.car is None else Facts(car_layout=self.car.entry()))
        )


def plan_gears(design: TrainDesign, order: Order = Order.AS_GIVEN, progress: Progress = silent) -> GearTrain:
    """Compute the train of a design in an order, lay it out, and measure its teeth in mesh.

    Args:
        design: loaded design.
        order: `as-given`, `reordered` (the best order of the stages) or `search` (the best teeth within the limits).
            Of several trains the first that can be made and passes its checks is planned.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no train, or one that cannot be made or laid out.
        NotMadeError: the same for every train of several.
    """
    gear_model.train_keys(design)
    designed = gear_model.train(design)
    progress("computing play and return error" if order != Order.SEARCH else "searching trains")
    designed_play, designed_standard = train_play(designed), _by_the_standard(designed)
    limits = gear_model.search_limits(design, designed) if order == Order.SEARCH else None
    asked = gear_model.train_keys(design).search
    by_losses = asked.objective == SearchObjective.LOSSES
    with_losses = by_losses or bool(asked.losses)
    on_front = by_losses or asked.objective == SearchObjective.SIZE
    front: tuple[TrainPlay, ...] = ()
    front_whole = True
    if limits and (on_front or with_losses or asked.front):
        progress(Message("searching the front of return error and size"))
        front, front_whole = front_of(limits, with_losses)
    ranked = arrange(designed, order, limits) if not (on_front and front) else ()
    if on_front and front:
        measure = losses_of if by_losses else size_of
        ranked = tuple(sorted(front, key=lambda play: measure(play.train)))
    trains = _Candidates(ranked, limits, design)
    made, skipped = _first_made(design, trains, _baseline(order, designed_play, designed_standard), progress)
    chord, keys = design.export.mesh_chord_um, gear_model.train_keys(design)
    friction = None if keys.friction_coefficient is None else (keys.friction_coefficient, keys.friction_source or "")
    whole = WholePlay(teeth=made.play, loose=gear_model.loose(design, made.play.train))
    car = laid_out(design, made.play.train)
    sense, makings = None, gear_model.makings(design, made.layout.pieces.parts)
    free = keys.standard == ToleranceStandard.FREE  # then no grade is stated
    if car is None:
        sense = gear_model.sense_reservation(design, len(made.layout.train.stages), made.layout.train.sense)
    return GearTrain(
        origin=Origin.of(design),
        title=design.drawing,
        making=TrainMaking.of(gear_model.train_keys(design)),
        makings=makings,
        mesh_chord=None if chord is None else chord * 1e-3,
        compensation=design.export.printing,
        friction=friction,
        front=front,
        front_whole=front_whole,
        front_with_losses=with_losses,
        order=order,
        designed=designed_play,
        designed_standard=designed_standard,
        ranked=ranked,
        play=made.play,
        skipped=skipped,
        standard=_by_the_standard(made.play.train),
        departures=made.play.train.departures(),
        notes=(
            *_thinning_notes(design, made),
            *(note for number, cut in enumerate(made.layout.train.stages, 1) for note in cut.notes(number)),
            *cutting_notes(made.layout.pieces.parts, makings, None if free else made.layout.train.finest_grade),
            *([] if friction is None else [losses_note(made.layout.train, *friction)]),
            *([whole.sentence()] if whole.loose else []),
            *(_notes(design, designed, limits) if limits else ()),
            *([] if sense is None else [sense.sentence]),
            *([] if car is None or car.sentence is None else [car.sentence]),
        ),
        layout=made.layout,
        checks=CheckList(made.checks),
        loose=gear_model.loose(design, made.play.train),
        car=car,
    )


def _baseline(order: Order, designed: TrainPlay, designed_standard: TrainPlay | None) -> TrainPlay:
    return designed_standard if order == Order.SEARCH and designed_standard is not None else designed


def _by_the_standard(train: Train) -> TrainPlay | None:
    try:
        return train_play(train.by_the_standard())
    except DesignError:
        return None


class _Candidates:
    """The trains to be tried, best first: those ranked, and of a search then those whose gears fit their blanks.

    Attributes:
        ended: reason why the search ended without a train; empty if it did not.
    """

    def __init__(self, ranked: tuple[TrainPlay, ...], limits: SearchLimits | None, design: TrainDesign) -> None:
        self.ranked, self.limits, self.ended = ranked, limits, ""
        self._blanks, self._clearance = gear_model.blanks(design), gear_model.train_keys(design).clearance_mm
        self._failing: dict[Stage, None] = {}

    def exclude(self, pairs: Iterable[Stage]) -> None:
        """Try no train with any of these pairs from here on."""
        self._failing.update(dict.fromkeys(pairs))

    def __iter__(self) -> Iterator[TrainPlay]:
        yield from filter(self._open, self.ranked)
        if self.limits is None:
            return
        seen = {play.train for play in self.ranked}
        try:
            search = search_of(self.limits, self._blanks, self._clearance)
            excluded = 0
            for keep in DEPTHS:
                while True:
                    failing = list(self._failing)
                    for pair in failing[excluded:]:
                        search.exclude(pair)
                    excluded = len(failing)
                    best = search.best(keep)
                    for play in best:
                        if play.train not in seen and self._open(play):
                            seen.add(play.train)
                            yield play
                    if len(self._failing) == excluded:
                        break
                if len(best) < keep:
                    return
            self.ended = Message("the best {keep} whose gears fit their blanks were tried", keep=keep)
        except DesignError as error:
            self.ended = error.message

    def _open(self, play: TrainPlay) -> bool:
        return self._failing.keys().isdisjoint(play.train.stages)


def _first_made(
    design: TrainDesign, trains: _Candidates, baseline: TrainPlay, progress: Progress
) -> tuple[MadeTrain, tuple[Skipped, ...]]:
    """The first train that can be made and passes its checks, else the first that can be made; and those before it."""
    skipped: list[Skipped] = []
    failed: list[tuple[int, MadeTrain]] = []
    for play in trains:
        progress(Message("laying out and measuring {train}", train=teeth_of(play)))
        try:
            made = _make(design, play)
        except DesignError as error:
            skipped.append(Skipped(play, error.message))
            for pair in play.train.stages if trains.limits else ():
                try:
                    pair.as_cut().wheel_figures()
                except DesignError:  # its teeth cannot be cut or inspected, whatever stands beside it
                    trains.exclude([pair])
            continue
        wrong = [check.name for check in made.checks if not check.passed]
        if not wrong:
            return made, tuple(skipped)
        failed.append((len(skipped), made))
        failing = joined(map(Message, wrong), " and ")
        skipped.append(Skipped(play, Message("its check of {failing} fails", failing=failing)))
        if trains.limits:
            trains.exclude(play.train.stages[number] for number in failing_stages(made.layout))
        if len(failed) == MOST_MEASURED:
            trains.ended = Message("{count} trains were measured and fail", count=MOST_MEASURED)
            break
    if failed:
        before, made = failed[0]
        return made, tuple(skipped[:before])
    if len(trains.ranked) == 1 and not trains.ended:
        raise DesignError(skipped[0].reason)
    none = Message(
        "none of {count} trains can be made; the best, {teeth}, not: {reason}",
        count=len(skipped),
        teeth=teeth_of(skipped[0].play),
        reason=skipped[0].reason,
    )
    raise NotMadeError(joined([none, trains.ended], "; ") if trains.ended else none, trains.ranked, baseline)


def _make(design: TrainDesign, play: TrainPlay) -> MadeTrain:
    """Train as it is made: with [layout] with the directions and the checks of its place in the car."""
    # Each stage keeps its direction in another order; searched stages have none.
    directions, layout = turned_to(design, play.train), laid_out(design, play.train)
    if layout is not None and layout.directions is not None:
        directions = layout.directions
    made = make_train(
        play,
        gear_model.blanks(design),
        directions,
        gear_model.train_keys(design).clearance_mm,
        lambda gears: gear_model.mesh_chord(design, gears),
    )
    parts = made.layout.pieces.parts
    made = replace(made, checks=(*made.checks, *cutting_checks(parts, gear_model.makings(design, parts))))
    if layout is None:
        return made
    from cadgen.jobs.car_frame import checks_in_car  # it loads shapely, which most trains do without

    return replace(made, checks=(*made.checks, *checks_in_car(layout)))


def _thinning_notes(design: TrainDesign, made: MadeTrain) -> tuple[str, ...]:
    """Meaning of the design's tooth thickness for the return error, in words."""
    keys = gear_model.train_keys(design)
    plays = [stage.play() for stage in made.play.train.stages if isinstance(stage, SpurPair)]
    if not plays:
        return ()
    if keys.E_sn_um is not None:
        widths = [role.T_sn * 1e3 for play in plays for role in (play.driver, play.driven)]
        return (
            Message(
                "E_sn = {E_sn:g} µm is the design's own: teeth are cut within T_sn / 2 = {least:.0f} to {most:.0f} µm "
                "of it, and play, return error and the limits in the table of parts are those of such teeth",
                E_sn=keys.E_sn_um,
                least=min(widths) / 2,
                most=max(widths) / 2,
            ),
        )
    if keys.thinning == Thinning.MIDDLE:
        return ()
    return (
        Message(
            "teeth are cut to the {limit} of their grade, within T_sn / 2 of it, and play, return error and the limits "
            "in the table of parts are those of such teeth",
            limit=Message("upper limit E_sns" if keys.thinning == Thinning.LEAST else "lower limit E_sni"),
        ),
    )


def _notes(design: TrainDesign, designed: Train, limits: SearchLimits) -> tuple[str, ...]:
    """Limits of the search, and the keys that searched trains do not take over from the stages given, in words."""
    gears = [gear for pair in spur_pairs(designed, Message("the search is")) for gear in (pair.driver, pair.driven)]
    notes = [Message("searched: {limits}", limits=limits)]
    if left := gear_model.limits_left_out(design):
        notes.append(
            Message(
                "not given in [train.search]: {left}; sizes that are left out span those of the given stages, the other"
                " limits are the usual ones, widened to the given stages where these go further",
                left=left,
            )
        )
    if designed.departures():
        notes.append(
            Message(
                "searched gears are made to the standard's tolerances, without those that the design gives for its own;"
                " they are compared with the given train by the standard"
            )
        )
    if any(gear.form.profile_shift for gear in gears):
        notes.append(Message("searched gears have no profile shift, unlike some of those given"))
    if any(direction is not None for direction in gear_model.directions(design)):
        notes.append(Message("searched stages are laid out afresh, without the directions of those given"))
    return tuple(notes)


def _return_errors(plan: GearTrain) -> Sheet:
    """Play and return error of every stage and of the train, as made and by the standard alone.

    Args:
        plan: computed train.
    """
    rows: list[tuple[str, ...]] = []
    for number, (stage, play) in enumerate(zip(plan.layout.train.stages, plan.play.stages, strict=True), 1):
        arc = stage.driven_pitch_radius * 1e3
        rows.append(
            (
                f"{number}, {stage.label}",
                f"{stage.centre_distance:g}",
                f"{play.B_min * arc:.1f}{' to ' if play.B_min < 0 else '-'}{play.B_max * arc:.1f}",
                f"{stage.free_angle() * arc:.1f}",
                *_angles(play.B_min, (play.B_min + play.B_max) / 2, play.B_max),
            )
        )
    trains: list[tuple[str, TrainPlay | WholePlay]] = [(Message("train"), plan.play)]
    if plan.departures and plan.standard:
        trains.append((Message("train, by the standard"), plan.standard))
    if plan.order != Order.AS_GIVEN:
        trains.append((Message("train, as given"), plan.designed))
    if plan.baseline is not plan.designed:
        trains.append((Message("as given, by the standard"), plan.baseline))
    rows += [(label, "", "", "", *_errors_of(play_of_train)) for label, play_of_train in trains]
    for joint in plan.whole.loose:
        middle = (joint.least + joint.greatest) / 2
        rows.append((joint.name, "", "", "", *_angles(joint.least, middle, joint.greatest)))
    if plan.whole.loose:
        rows.append((Message("train with these"), "", "", "", *_errors_of(plan.whole)))
    title = Message(
        "{name}, {order}, ratio {ratio}: return error",
        name=plan.name,
        order=Message(plan.order),
        ratio=plan.play.train.ratio,
    )
    heads = (
        Message("stage"),
        Message("a, mm"),
        Message("play, µm"),
        Message("as cut"),
        Message("least"),
        Message("mean"),
        Message("greatest"),
    )
    return Sheet("return-errors", title, heads, tuple(rows))


def _errors_of(play: TrainPlay | WholePlay) -> tuple[str, ...]:
    """Least, mean and greatest return error, as texts."""
    return _angles(play.return_error_min, play.return_error_distribution().mean, play.return_error_max)


def _angles(*angles: float) -> tuple[str, ...]:
    return tuple(f"{degrees(angle):.3f}°" for angle in angles)
