"""From a design to a checked gear train. No CAD kernel is needed for this."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees
from typing import Any

from cadgen.cam.check import Check
from cadgen.design import gears as stages
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.gears.backlash import Departure, GearPlay, TrainPlay, departures, train_play
from cadgen.gears.inspection import Inspection, inspection_of
from cadgen.gears.layout import TrainLayout, lay_out
from cadgen.gears.search import Order, SearchLimits, arrange, search_trains
from cadgen.gears.thinning import thickness_zone, thinned
from cadgen.gears.train import Train
from cadgen.workflow.gears_checks import exact_play, gear_checks
from cadgen.workflow.gears_facts import plan_facts, teeth_of

Step = Callable[[str], None]

# If none of the trains that a search reports can be made, so many of those whose gears fit their blanks are tried.
DEPTHS = (100, 1000)
# Trains whose teeth are measured in mesh before a search is content with the best that fails a check.
MOST_MEASURED = 12


@dataclass(frozen=True)
class Skipped:
    """A train with less return error than the one that is made, and why it is not made."""

    play: TrainPlay
    reason: str


class NotMadeError(DesignError):
    """None of several trains can be made: `ranked` are those that the order calls for, `baseline` what they better."""

    def __init__(self, message: str, ranked: tuple[TrainPlay, ...], baseline: TrainPlay) -> None:
        super().__init__(message)
        self.ranked, self.baseline = ranked, baseline


@dataclass(frozen=True)
class GearsPlan:
    """A gear train that has been computed and checked, but not yet made.

    Attributes:
        design: what it was planned from.
        order: `as-given`, `reordered` or `search`.
        given: play of the train as the design has it.
        given_standard: the same without the design's overrides; None if the standards do not cover it.
        ranked: the trains that the order calls for, least return error first.
        play: play of the train that is made: the first one that can be and passes its checks.
        skipped: those with less return error.
        standard: play of the train that is made, without the design's overrides; None if not covered.
        departures: the overrides beside the standard's values.
        notes: what of the design the searched trains do not have, and what a given thinning means, in sentences.
        layout: its parts, teeth thinned, at their places.
        inspection: of every part's gears, in the order of the parts.
        checks: every figure with its verdict.
    """

    design: Design
    order: Order
    given: TrainPlay
    given_standard: TrainPlay | None
    ranked: tuple[TrainPlay, ...]
    play: TrainPlay
    skipped: tuple[Skipped, ...]
    standard: TrainPlay | None
    departures: tuple[Departure, ...]
    notes: tuple[str, ...]
    layout: TrainLayout
    inspection: tuple[tuple[Inspection, ...], ...]
    checks: tuple[Check, ...]

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return all(check.passed for check in self.checks)

    @property
    def baseline(self) -> TrainPlay:
        """What the ranked trains are compared with: like with like, so for a search by the standard alone."""
        return _baseline(self.order, self.given, self.given_standard)

    def facts(self) -> dict[str, Any]:
        """The plan as plain values for the manifest and for machines."""
        return self._facts

    @cached_property
    def _facts(self) -> dict[str, Any]:
        return plan_facts(self)

    def role(self, shaft: int, stage: int) -> GearPlay[float]:
        """Play of the gear of a stage that sits on a shaft, both counted from 1."""
        return _role(self.play, shaft, stage)


@dataclass(frozen=True)
class _Made:
    play: TrainPlay
    layout: TrainLayout
    inspection: tuple[tuple[Inspection, ...], ...]
    checks: tuple[Check, ...]


def plan_gears(design: Design, order: Order = "as-given", step: Step = lambda text: None) -> GearsPlan:
    """Compute the train of a design in an order, lay it out, and measure its teeth in mesh.

    Args:
        design: a loaded design.
        order: `as-given`, `reordered` (the best order of the stages) or `search` (the best teeth within the limits).
            Of several trains the first that can be made and passes its checks is planned.
        step: told what is being done.

    Raises:
        DesignError: the design has no train, or one that cannot be made or laid out.
        NotMadeError: the same for every train of several.
    """
    stages.train_keys(design)
    given = stages.train(design)
    step("computing play and return error" if order != "search" else "searching trains")
    given_play, given_standard = train_play(given), _by_the_standard(given)
    limits = stages.search_limits(design, given) if order == "search" else None
    ranked = arrange(given, order, limits)
    trains = _trains(ranked, limits, design)
    made, skipped = _first_made(design, given, trains, ranked, _baseline(order, given_play, given_standard), step)
    return GearsPlan(
        design=design,
        order=order,
        given=given_play,
        given_standard=given_standard,
        ranked=ranked,
        play=made.play,
        skipped=skipped,
        standard=_by_the_standard(made.play.train),
        departures=departures(made.play.train),
        notes=(*_thinning_notes(design, made), *(_notes(design, given) if limits else ())),
        layout=made.layout,
        inspection=made.inspection,
        checks=made.checks,
    )


def _baseline(order: Order, given: TrainPlay, given_standard: TrainPlay | None) -> TrainPlay:
    return given_standard if order == "search" and given_standard is not None else given


def _by_the_standard(train: Train) -> TrainPlay | None:
    try:
        return train_play(train.by_the_standard())
    except DesignError:
        return None


def _trains(ranked: Sequence[TrainPlay], limits: SearchLimits | None, design: Design) -> Iterator[TrainPlay]:
    """The trains to be tried, best first: those ranked, and of a search then those whose gears fit their blanks."""
    yield from ranked
    if limits is None:
        return
    seen = {play.train for play in ranked}
    for keep in DEPTHS:
        try:
            deeper = search_trains(replace(limits, keep=keep), stages.blanks(design))
        except DesignError:
            return
        for play in deeper:
            if play.train not in seen:
                seen.add(play.train)
                yield play


def _first_made(
    design: Design,
    given: Train,
    trains: Iterator[TrainPlay],
    ranked: tuple[TrainPlay, ...],
    baseline: TrainPlay,
    step: Step,
) -> tuple[_Made, tuple[Skipped, ...]]:
    """The first train that can be made and passes its checks, else the first that can be made; and those before it."""
    skipped: list[Skipped] = []
    failed: list[tuple[int, _Made]] = []
    for play in trains:
        step(f"laying out and measuring {teeth_of(play)}")
        try:
            made = _make(design, given, play)
        except DesignError as error:
            skipped.append(Skipped(play, str(error)))
            continue
        wrong = [check.name for check in made.checks if not check.passed]
        if not wrong:
            return made, tuple(skipped)
        failed.append((len(skipped), made))
        skipped.append(Skipped(play, f"its check of {' and '.join(wrong)} fails"))
        if len(failed) == MOST_MEASURED:
            break
    if failed:
        before, made = failed[0]
        return made, tuple(skipped[:before])
    if len(ranked) == 1:
        raise DesignError(skipped[0].reason)
    raise NotMadeError(
        f"none of {len(skipped)} trains can be made; the best, {teeth_of(skipped[0].play)}, not: {skipped[0].reason}",
        ranked,
        baseline,
    )


def _make(design: Design, given: Train, play: TrainPlay) -> _Made:
    keys = stages.train_keys(design)
    cut = thinned(play, keys.thinning if keys.E_sn_um is None else keys.E_sn_um * 1e-3)
    directions = _directions(given, play.train, stages.directions(design))
    layout = lay_out(cut, stages.blanks(design), directions, keys.clearance_mm)
    inspection = _inspections(layout, play, keys.pin_diameter_mm)
    checks = gear_checks(layout, play.stages, design.export.mesh_chord_um * 1e-3)
    return _Made(play, layout, inspection, checks)


def _directions(given: Train, made: Train, wanted: Sequence[float | None]) -> list[float | None]:
    """A direction goes with its stage wherever that stands; searched stages have none."""
    left = list(zip(given.stages, wanted, strict=True))
    found: list[float | None] = []
    for pair in made.stages:
        place = next((number for number, (known, _) in enumerate(left) if known == pair), None)
        found.append(None if place is None else left.pop(place)[1])
    return found


def _thinning_notes(design: Design, made: _Made) -> tuple[str, ...]:
    """What a given E_sn outside the limits of the grade means for the return error."""
    given = stages.train_keys(design).E_sn_um
    roles = [role for found in made.play.stages for role in (found.driver, found.driven)]
    if given is None or all(role.E_sni <= given * 1e-3 <= role.E_sns for role in roles):
        return ()
    cut = made.layout.train
    error = degrees(sum(exact_play(pair) / float(i) for pair, i in zip(cut.stages, cut.output_ratios, strict=True)))
    cut_so = f"the teeth as cut, without any error, leave {error:.3f}°" if error > 0 else "the teeth as cut jam"
    return (
        f"E_sn = {given:g} µm is the design's own and outside E_sns to E_sni of the grade: the return errors from "
        f"least to greatest are those of the grade; {cut_so}",
    )


def _notes(design: Design, given: Train) -> tuple[str, ...]:
    """What the searched trains do not take over from the stages given."""
    gears = [gear for pair in given.stages for gear in (pair.driver, pair.driven)]
    notes = []
    if departures(given):
        notes.append(
            "searched gears are made to the standard's tolerances, without those that the design gives for its own;"
            " they are compared with the given train by the standard"
        )
    if any(gear.form.profile_shift for gear in gears):
        notes.append("searched gears have no profile shift, unlike some of those given")
    if any(direction is not None for direction in stages.directions(design)):
        notes.append("searched stages are laid out afresh, without the directions of those given")
    return tuple(notes)


def _inspections(layout: TrainLayout, play: TrainPlay, pin: float | None) -> tuple[tuple[Inspection, ...], ...]:
    """Of every part's gears between E_sns and E_sni, or about a thinning outside these as wide apart."""
    found = []
    for part in layout.parts:
        of_part = []
        for form, stage in zip(part.gears, part.stages, strict=True):
            role = _role(play, part.shaft, stage)
            try:
                of_part.append(inspection_of(form, *thickness_zone(form, role), pin))
            except DesignError as error:
                raise DesignError(f"in stage {stage}, {error}") from error
        found.append(tuple(of_part))
    return tuple(found)


def _role(play: TrainPlay, shaft: int, stage: int) -> GearPlay[float]:
    """A stage's driver sits on the shaft of its number, the driven gear on the next."""
    found = play.stages[stage - 1]
    return found.driven if shaft > stage else found.driver
