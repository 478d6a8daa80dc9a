"""From a design to a checked gear train. No CAD kernel is needed for this."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from cadgen.check import Check
from cadgen.design import gear_model
from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError
from cadgen.gears.choices import Order, Thinning
from cadgen.gears.layout import TrainLayout
from cadgen.gears.spur import SpurPair, spur_pairs
from cadgen.gears.stage import Departure, Stage, Wheel
from cadgen.gears.synthesis import SearchLimits, TrainSearch, arrange
from cadgen.gears.train import Train, TrainPlay, WholePlay, teeth_of, train_play
from cadgen.geometry.meshes.made_train import MadeTrain, failing_stages, make_train
from cadgen.progress import Progress, silent

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


@dataclass(frozen=True)
class GearsPlan:
    """A gear train that has been computed and checked, but not yet made.

    Attributes:
        design: design that the train was planned from.
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
    """

    design: TrainDesign
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
    checks: tuple[Check, ...]

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return all(check.passed for check in self.checks)

    @property
    def whole(self) -> WholePlay:
        """Return error of the train that is made, with joints and bearings."""
        return WholePlay(teeth=self.play, loose=gear_model.loose(self.design, self.play.train))

    @property
    def baseline(self) -> TrainPlay:
        """Play that the ranked trains are compared with; for a search, of the given train by the standard alone."""
        return _baseline(self.order, self.designed, self.designed_standard)

    @property
    def stem(self) -> str:
        """Start of the names of its files."""
        return f"{self.design.name}_{self.order}"

    @property
    def description(self) -> str:
        """Description of the train for STEP files, one line."""
        return f"gear train, {self.order}, design {self.design.content_hash[:12]}"

    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm."""
        return gear_model.mesh_chord(self.design, gears)


def plan_gears(design: TrainDesign, order: Order = Order.AS_GIVEN, progress: Progress = silent) -> GearsPlan:
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
    ranked = arrange(designed, order, limits)
    trains = _Candidates(ranked, limits, design)
    made, skipped = _first_made(design, designed, trains, _baseline(order, designed_play, designed_standard), progress)
    return GearsPlan(
        design=design,
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
            *_joint_notes(design, made.play),
            *(_notes(design, designed, limits) if limits else ()),
            *gear_model.sense_note(design, len(made.layout.train.stages)),
        ),
        layout=made.layout,
        checks=made.checks,
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
            search = TrainSearch(self.limits, self._blanks, self._clearance)
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
            self.ended = f"the best {keep} whose gears fit their blanks were tried"
        except DesignError as error:
            self.ended = str(error)

    def _open(self, play: TrainPlay) -> bool:
        return self._failing.keys().isdisjoint(play.train.stages)


def _first_made(
    design: TrainDesign, designed: Train, trains: _Candidates, baseline: TrainPlay, progress: Progress
) -> tuple[MadeTrain, tuple[Skipped, ...]]:
    """The first train that can be made and passes its checks, else the first that can be made; and those before it."""
    skipped: list[Skipped] = []
    failed: list[tuple[int, MadeTrain]] = []
    for play in trains:
        progress(f"laying out and measuring {teeth_of(play)}")
        try:
            made = _make(design, designed, play)
        except DesignError as error:
            skipped.append(Skipped(play, str(error)))
            if trains.limits:
                trains.exclude(pair for pair in play.train.stages if not _can_be_cut(pair))
            continue
        wrong = [check.name for check in made.checks if not check.passed]
        if not wrong:
            return made, tuple(skipped)
        failed.append((len(skipped), made))
        skipped.append(Skipped(play, f"its check of {' and '.join(wrong)} fails"))
        if trains.limits:
            trains.exclude(play.train.stages[number] for number in failing_stages(made.layout))
        if len(failed) == MOST_MEASURED:
            trains.ended = f"{MOST_MEASURED} trains were measured and fail"
            break
    if failed:
        before, made = failed[0]
        return made, tuple(skipped[:before])
    if len(trains.ranked) == 1 and not trains.ended:
        raise DesignError(skipped[0].reason)
    ended = f"; {trains.ended}" if trains.ended else ""
    raise NotMadeError(
        f"none of {len(skipped)} trains can be made; the best, {teeth_of(skipped[0].play)}, not: {skipped[0].reason}"
        f"{ended}",
        trains.ranked,
        baseline,
    )


def _can_be_cut(stage: Stage) -> bool:
    """Whether the teeth of a stage can be cut and inspected, whatever stands beside it."""
    try:
        stage.as_cut().wheel_facts()
    except DesignError:
        return False
    return True


def _make(design: TrainDesign, designed: Train, play: TrainPlay) -> MadeTrain:
    keys = gear_model.train_keys(design)
    return make_train(
        play,
        gear_model.blanks(design),
        _directions(designed, play.train, gear_model.directions(design)),
        keys.clearance_mm,
        lambda gears: gear_model.mesh_chord(design, gears),
    )


def _directions(designed: Train, made: Train, wanted: Sequence[float | None]) -> list[float | None]:
    """Directions of a train's stages: each stage keeps its direction in another order; searched stages have none."""
    left = list(zip(designed.stages, wanted, strict=True))
    directions: list[float | None] = []
    for pair in made.stages:
        place = next((number for number, (known, _) in enumerate(left) if known == pair), None)
        directions.append(None if place is None else left.pop(place)[1])
    return directions


def _thinning_notes(design: TrainDesign, made: MadeTrain) -> tuple[str, ...]:
    """Meaning of the design's tooth thickness for the return error, in words."""
    keys = gear_model.train_keys(design)
    zone = "and play, return error and the limits in the table of parts are those of such teeth"
    plays = [stage.play() for stage in made.play.train.stages if isinstance(stage, SpurPair)]
    if not plays:
        return ()
    if keys.E_sn_um is not None:
        widths = [role.T_sn * 1e3 for play in plays for role in (play.driver, play.driven)]
        return (
            f"E_sn = {keys.E_sn_um:g} µm is the design's own: teeth are cut within T_sn / 2 = {min(widths) / 2:.0f} to"
            f" {max(widths) / 2:.0f} µm of it, {zone}",
        )
    if keys.thinning == Thinning.MIDDLE:
        return ()
    limit = "upper limit E_sns" if keys.thinning == Thinning.LEAST else "lower limit E_sni"
    return (f"teeth are cut to the {limit} of their grade, within T_sn / 2 of it, {zone}",)


def _joint_notes(design: TrainDesign, play: TrainPlay) -> tuple[str, ...]:
    """Cheapest cure of the return error that joints and bearings add, in words."""
    whole = WholePlay(teeth=play, loose=gear_model.loose(design, play.train))
    return (whole.sentence(),) if whole.loose else ()


def _notes(design: TrainDesign, designed: Train, limits: SearchLimits) -> tuple[str, ...]:
    """Limits of the search, and the keys that searched trains do not take over from the stages given, in words."""
    gears = [gear for pair in spur_pairs(designed, "the search is") for gear in (pair.driver, pair.driven)]
    notes = [f"searched: {limits}"]
    if left := gear_model.limits_left_out(design):
        notes.append(
            f"not given in [train.search]: {left}; sizes that are left out span those of the given stages, the other"
            " limits are the usual ones, widened to the given stages where these go further"
        )
    if designed.departures():
        notes.append(
            "searched gears are made to the standard's tolerances, without those that the design gives for its own;"
            " they are compared with the given train by the standard"
        )
    if any(gear.form.profile_shift for gear in gears):
        notes.append("searched gears have no profile shift, unlike some of those given")
    if any(direction is not None for direction in gear_model.directions(design)):
        notes.append("searched stages are laid out afresh, without the directions of those given")
    return tuple(notes)
