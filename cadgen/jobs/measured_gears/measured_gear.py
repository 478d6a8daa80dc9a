"""Measured gear of a train: flank lines, pitch, span or size over balls -> its errors, class, play, and a change."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import degrees, pi, sin, tan
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import brentq

from cadgen.design import gear_model
from cadgen.design.load import train_of
from cadgen.design.override import override
from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError, FileError
from cadgen.figures import Cell, Emphasis, Facts, Sheet, number
from cadgen.gears.choices import ToleranceStandard
from cadgen.gears.contact import path_of_contact
from cadgen.gears.flank_tolerances import class_reached, class_tolerance, covered
from cadgen.gears.inspection import size_over_pins, span_over
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.gears.train import Train, thinned
from cadgen.inference.gearing.flank_kinds import (
    BALLS,
    GEAR_KINDS,
    HELIX_LINES,
    INDEX,
    PITCH,
    PROFILE_DIAMETERS,
    PROFILE_LINES,
    SPANS,
    by_roll,
    gear_place,
    refuse_lines,
    refuse_parts,
    refuse_teeth,
    to_tip,
)
from cadgen.inference.gearing.flank_lines import (
    FlankFigure,
    HelixErrors,
    PitchErrors,
    ProfileErrors,
    Range,
    Sized,
    helix_errors,
    pitch_errors,
    profile_errors,
    profile_range,
)
from cadgen.inference.measurement.record import Record, join, understood_of
from cadgen.jobs.calibration.sources import Source
from cadgen.messages import Message, joined
from cadgen.output.files.manifest import Origin
from cadgen.output.report.terminal import Block
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness

_UM = 1e3
_SYMBOLS = {
    "f_p": "f_p",
    "F_p": "F_p",
    "F_r": "F_r",
    "f_Halpha": "f_Hα",
    "f_falpha": "f_fα",
    "F_alpha": "F_α",
    "f_Hbeta": "f_Hβ",
    "f_fbeta": "f_fβ",
    "F_beta": "F_β",
}
_NAMES = {
    "f_p": Message("single pitch"),
    "F_p": Message("cumulative pitch"),
    "F_r": Message("run-out of the teeth"),
    "f_Halpha": Message("profile slope"),
    "f_falpha": Message("profile form"),
    "F_alpha": Message("profile, total"),
    "f_Hbeta": Message("helix slope"),
    "f_fbeta": Message("helix form"),
    "F_beta": Message("helix, total"),
}
_ENOUGH = 0.9  # part of the range of evaluation without which a class is not judged as the standard has it
_COARSEST = 11  # class of ISO 1328-1:2013
__all__ = ["GEAR_KINDS", "MeasuredGearPlan", "gear_report", "judge_gear"]


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MeasuredGearPlan:
    """Measured gear beside its design. Lengths mm, angles rad.

    Attributes:
        design: design with the train.
        text: text of its file.
        sources: measured files.
        train: train as it is made by the design.
        stage: number of its stage, from 0.
        driver: whether it is the driver.
        pitch, profile, helix: errors; None where that was not measured.
        thickness: deviation E_sn of its teeth by spans or balls; None where neither was measured.
    """

    design: TrainDesign
    text: str
    sources: tuple[Source, ...]
    train: Train
    stage: int
    driver: bool
    pitch: PitchErrors | None
    profile: ProfileErrors | None
    helix: HelixErrors | None
    thickness: Sized | None

    def __repr__(self) -> str:
        return f"<MeasuredGear of {self.names}: class {self.reached}>"

    @property
    def names(self) -> str:
        """Names of the files."""
        return joined([source.path.name for source in self.sources], ", ")

    @property
    def pair(self) -> SpurPair:
        """Pair of the gear, as made by the design."""
        pair = self.train.stages[self.stage]
        assert isinstance(pair, SpurPair)  # judged when it was made
        return pair

    @property
    def form(self) -> GearForm:
        """Gear as made by the design."""
        return (self.pair.driver if self.driver else self.pair.driven).form

    @property
    def grade(self) -> int:
        """Grade of the design."""
        return (self.pair.driver if self.driver else self.pair.driven).grade

    @property
    def measured(self) -> tuple[FlankFigure, ...]:
        """Deviations by symbol."""
        return tuple(m for part in (self.pitch, self.profile, self.helix) if part is not None for m in part.measured)

    def class_of(self, each: FlankFigure) -> int | None:
        """Class of ISO 1328-1:2013 that a deviation reaches; None beyond all.

        Args:
            each: deviation.
        """
        form = self.form
        return class_reached(each.symbol, form.reference_diameter, form.normal_module, form.width, each.worst)

    @property
    def reached(self) -> int | None:
        """Class that all deviations reach; None where one is beyond all, or none was measured."""
        classes = [self.class_of(each) for each in self.measured]
        known = [each for each in classes if each is not None]
        return max(known) if known and len(known) == len(classes) else None

    def allowed(self, each: FlankFigure) -> float | None:
        """Value that a deviation must keep, mm: that of the design's own key, else of its class; None where none is.

        Args:
            each: deviation.
        """
        form, gear = self.form, self.pair.driver if self.driver else self.pair.driven
        own = {"f_p": gear.overrides.f_pt, "F_r": gear.overrides.F_r, "F_beta": gear.overrides.F_beta}.get(each.symbol)
        free = self.design.train is not None and self.design.train.standard == ToleranceStandard.FREE
        if own is not None and not (free and own == 0):
            return own
        size = form.reference_diameter, form.normal_module, form.width
        if free or not covered(*size) or self.grade > _COARSEST:
            return None
        return class_tolerance(each.symbol, *size, self.grade)

    def keeps(self, each: FlankFigure) -> bool | None:
        """Whether a deviation keeps what is allowed; None where nothing is, or a slope is of too short a line.

        Args:
            each: deviation.
        """
        allowed = self.allowed(each)
        short = {"f_Halpha": self.profile, "f_Hbeta": self.helix}.get(each.symbol)
        if allowed is None or (short is not None and short.covered < _ENOUGH):
            return None
        return each.worst <= allowed + 1e-9

    @property
    def kept(self) -> bool:
        """Whether no deviation is beyond what the design allows."""
        return all(self.keeps(each) is not False for each in self.measured)

    @property
    def short(self) -> bool:
        """Whether a line covers too little of the range of evaluation."""
        return any(part is not None and part.covered < _ENOUGH for part in (self.profile, self.helix))

    @property
    def zone(self) -> tuple[float, float]:
        """Least and greatest thickness E_sn by the design, mm, and no narrower than is measured."""
        play = self.pair.play()
        gear, middle = play.driver if self.driver else play.driven, self.form.tooth_thickness_deviation
        apart = _SAME if self.thickness is None else max(4 * self.thickness.sigma, _SAME)
        return min(float(gear.E_sni), middle - apart), max(float(gear.E_sns), middle + apart)

    @property
    def within(self) -> bool:
        """Whether the thickness, where it was measured, is within the zone of the design."""
        return self.thickness is None or self.zone[0] <= self.thickness.value <= self.zone[1]

    @property
    def reservations(self) -> tuple[Message, ...]:
        """Clauses on matters that are left open."""
        said = []
        if any(self.allowed(each) is None for each in self.measured):
            said.append(Message("no class of ISO 1328-1:2013 applies to all that was measured"))
        if self.short:
            said.append(Message("lines cover too little of the range of evaluation"))
        if not self.within:
            said.append(Message("the thickness is not that of the design"))
        return tuple(said)

    @property
    def play(self) -> Sized | None:
        """Play of its pair at the driven wheel with the thickness that was measured, the other gear as designed."""
        if self.thickness is None:
            return None
        at, step = self.form.tooth_thickness_deviation, 1e-3
        by_thickness = (self._play_at(at + step) - self._play_at(at)) / step
        return Sized(self._play_at(self.thickness.value), abs(by_thickness * self.thickness.sigma))

    def _play_at(self, thickness: float) -> float:
        others = [gear.form.tooth_thickness_deviation for gear in (self.pair.driver, self.pair.driven)]
        both = (thickness, others[1]) if self.driver else (others[0], thickness)
        return self.pair.cut_to(*both).exact_play()

    @property
    def change(self) -> float | None:
        """Change of the thickness E_sn that the design asks for, mm: below 0, the gear can be cut again."""
        if self.thickness is None:
            return None
        return self.form.tooth_thickness_deviation - self.thickness.value

    @property
    def readiness(self) -> Readiness:
        """Whether deviations and, where it was measured, the thickness are those of the design."""
        if not self.kept:
            return Readiness.NOT_READY
        return Readiness.RESERVATIONS if self.reservations else Readiness.READY

    @cached_property
    def as_built(self) -> str | None:
        """Text of the design with the gear as it was measured; None where nothing of that has a key."""
        import tomlkit

        values: Any = tomlkit.parse(self.text)
        for line in self.design.overrides:
            override(values, line)
        name = f"{self.design.name}_as_built"
        if "name" in values:
            values["name"] = name
        stage = values["train"]["stages"][self.stage]
        gear = stage["driver" if self.driver else "driven"]
        found = {each.symbol: round(_UM * each.worst, 1) for each in self.measured}
        keys = {"f_pt_um": found.get("f_p"), "F_r_um": found.get("F_r"), "F_beta_um": found.get("F_beta")}
        if self.helix is not None and self.helix.covered < _ENOUGH:
            keys["F_beta_um"] = None  # of a part of the facewidth alone
        for key, value in keys.items():
            if value is not None:
                gear[key] = value
        if self.thickness is not None:
            for key in ("backlash_um", "backlash_deg", "backlash_share"):
                stage.pop(key, None)
            for key in ("E_sns_um", "T_sn_um"):
                gear.pop(key, None)
            gear["E_sn_um"] = round(_UM * self.thickness.value, 1)
        elif not any(value is not None for value in keys.values()):
            return None
        made = str(values.as_string())
        if "name" not in values:
            made = f'name = "{name}"\n{made}'
        said = Message("Written by cadgen calibrate: as built by {names}.", names=self.names)
        made = f"# {said}\n{made}"
        try:
            gear_model.train(train_of(made, Path(f"{name}.toml")))
        except DesignError:
            return None
        return made

    def entry(self) -> Facts:
        """Everything, as in the JSON file."""
        facts = Origin.of(self.design).entry() | Facts(
            files=[Facts(file=s.path.name, kind=s.kind.code, sha256=s.sha256) for s in self.sources],
            understood=[note for source in self.sources for note in source.record.notes],
            readiness=self.readiness.value,
            stage=self.stage + 1,
            driver=self.driver,
            teeth=self.form.teeth,
            grade=self.grade,
            reached=self.reached,
            deviations=[
                Facts(
                    symbol=each.symbol,
                    left_um=None if each.left is None else _UM * each.left,
                    right_um=None if each.right is None else _UM * each.right,
                    reached=self.class_of(each),
                )
                for each in self.measured
            ],
            errors=[Facts(error=code, value=value, sigma=s, unit=unit) for code, value, s, unit in self._sizes()],
        )
        if self.thickness is not None and self.play is not None and self.change is not None:
            facts |= Facts(
                E_sn_um=_UM * self.thickness.value,
                E_sn_sigma_um=_UM * self.thickness.sigma,
                play_deg=degrees(self.play.value),
                change_um=_UM * self.change,
            )
        return facts

    def _sizes(self) -> list[tuple[str, float, float, str]]:
        found: list[tuple[str, Sized | None, float, str]] = []
        if self.pitch is not None:
            found += [("eccentricity", self.pitch.off, _UM, "um"), ("table", self.pitch.table, _UM, "um")]
        if self.profile is not None:
            found += [
                ("pressure-angle", self.profile.tool, degrees(1), "deg"),
                ("cutter", self.profile.cutter, _UM, "um"),
            ]
        if self.helix is not None:
            found += [
                ("helix-angle", self.helix.angle, degrees(1), "deg"),
                ("taper", self.helix.taper, _UM, "um"),
                ("leaning", self.helix.leaning, degrees(1), "deg"),
            ]
        return [(code, scale * each.value, scale * each.sigma, unit) for code, each, scale, unit in found if each]


_SAME = 2e-3  # mm of thickness that no shop tells apart


def judge_gear(
    design: TrainDesign, text: str, sources: Sequence[Source], progress: Progress = silent
) -> MeasuredGearPlan:
    """Errors of one gear of a train.

    Args:
        design: design with a train.
        text: text of its file.
        sources: measured files of kinds `GEAR_KINDS`, of one gear.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no train, or it cannot be made.
        FileError: the records do not say which gear it is, or are not of it.
    """
    made = thinned(gear_model.train(design))
    records = [source.record for source in sources]
    pairs = [stage for stage in made.stages if isinstance(stage, SpurPair)]
    if len(pairs) < len(made.stages):
        raise DesignError("{name} has stages that are no pairs of gears: give a design of the pair", name=design.name)
    stage, driver = gear_place(records, [(pair.driver.form.teeth, pair.driven.form.teeth) for pair in pairs])
    form = (pairs[stage].driver if driver else pairs[stage].driven).form
    for record in records:
        refuse_teeth(record, form.teeth)
    progress(Message("comparing"))

    def of(*kinds: object) -> Record | None:
        some = [record for record in records if record.kind in kinds]
        return join(some) if some else None

    pitch, index, helix = of(PITCH), of(INDEX), of(HELIX_LINES)
    if pitch is not None and index is not None:
        raise FileError(
            "{file} has single pitch, and another file cumulative pitch of the gear: give one of them",
            file=pitch.source,
        )
    pitch = pitch or index
    lines = [by_roll(each, form.base_diameter) for each in records if each.kind in (PROFILE_LINES, PROFILE_DIAMETERS)]
    profile = join(lines) if lines else None
    longest = form.tip_diameter
    if profile is not None and form.side < 0:
        longest = tooth_of(form).root_form_diameter
    of_profile = (
        None
        if profile is None
        else profile_errors(to_tip(profile, form.side), form, _profile_range(pairs[stage], driver))
    )
    of_helix = None if helix is None else helix_errors(helix, form)
    if profile is not None:
        most = form.base_diameter / 2 * form.roll_angle(longest)
        refuse_lines(
            profile, "roll_length_mm", float(profile["roll_length_mm"].max()), most, found=of_profile is not None
        )
    if helix is not None:
        refuse_lines(helix, "face_mm", float(np.ptp(helix["face_mm"])), form.width, found=of_helix is not None)
    return MeasuredGearPlan(
        design=design,
        text=text,
        sources=tuple(sources),
        train=made,
        stage=stage,
        driver=driver,
        pitch=None if pitch is None else pitch_errors(pitch, form),
        profile=of_profile,
        helix=of_helix,
        thickness=_thickness(of(SPANS), of(BALLS), form),
    )


def _profile_range(pair: SpurPair, driver: bool) -> Range:
    """Range of evaluation: from where contact with the other gear of the design begins to the tip."""
    form = (pair.driver if driver else pair.driven).form
    start, end = path_of_contact(pair)
    first = pair.by_size[0].form is form
    line = pair.centre_distance * sin(pair.pressure_angle(pair.centre_distance))
    control = start if first else abs(line - form.side * end)
    return profile_range(
        form.side * control, form.side * form.base_diameter / 2 * form.roll_angle(form.tip_form_diameter)
    )


_REACH = 0.3  # modules of E_sn on either side, within which thickness is sought


def _thickness(spans: Record | None, balls: Record | None, form: GearForm) -> Sized | None:
    """Thickness deviation E_sn, mm, by spans and sizes over balls."""
    values: list[float] = []
    if spans is not None:
        refuse_parts(spans, "teeth_spanned")
    for record, by, size in ((spans, "teeth_spanned", "span_mm"), (balls, "ball_diameter_mm", "over_balls_mm")):
        if record is None:
            continue
        for gauge, read in zip(record[by], record[size], strict=True):

            def off(deviation: float, gauge: float = gauge, read: float = read, over: Record = record) -> float:
                cut = form.cut_to(deviation)
                return (span_over(cut, round(gauge)) if over is spans else size_over_pins(cut, gauge)) - read

            reach = _REACH * form.normal_module
            try:
                if off(-reach) * off(reach) > 0:
                    raise ValueError
                values.append(float(brentq(off, -reach, reach, xtol=1e-9)))
            except (ValueError, DesignError):
                raise FileError(
                    "{file}: {size:g} mm is no size of {gear} over {gauge:g}: correct it, or the line that says which "
                    "gear it is",
                    file=record.source,
                    size=read,
                    gear=str(form),
                    gauge=gauge,
                ) from None
    if not values:
        return None
    spread = float(np.std(values, ddof=1)) / len(values) ** 0.5 if len(values) > 1 else _READ
    return Sized(float(np.mean(values)), max(spread, 1e-6))


_READ = 2e-3  # mm to which a span is read


def gear_report(plan: MeasuredGearPlan) -> list[Block]:
    """Report of a measured gear.

    Args:
        plan: measured gear.
    """
    blocks: list[Block] = [understood_of(s.record) for s in plan.sources if s.record.notes]
    which = Message("driver") if plan.driver else Message("driven wheel")
    blocks.append(
        Message(
            "{files}: {which} of stage {stage}, {gear}; grade {grade} by design.",
            files=plan.names,
            which=which,
            stage=plan.stage + 1,
            gear=str(plan.form),
            grade=plan.grade,
        )
    )
    if plan.measured:
        heads = (
            Message("Deviation"),
            Message("Left"),
            Message("Right"),
            Message("Allowed"),
            Message("Class reached"),
        )
        rows = tuple(_row(plan, each) for each in plan.measured)
        blocks.append(Sheet("gear-deviations", Message("Flanks by ISO 1328-1:2013"), heads, rows))
    blocks += _sentences(plan)
    return blocks


def _row(plan: MeasuredGearPlan, each: FlankFigure) -> tuple[Cell | str, ...]:
    reached, allowed = plan.class_of(each), plan.allowed(each)
    bad = plan.keeps(each) is False
    name = Message("{symbol}, {name}", symbol=_SYMBOLS[each.symbol], name=_NAMES[each.symbol])
    return (
        name,
        number(None if each.left is None else _UM * each.left, "µm", digits=1),
        number(None if each.right is None else _UM * each.right, "µm", digits=1),
        number(None if allowed is None else _UM * allowed, "µm", digits=1),
        Cell(str(reached) if reached is not None else "–", state=Emphasis.BAD if bad else Emphasis.PLAIN),
    )


def _sentences(plan: MeasuredGearPlan) -> list[Message]:
    said: list[Message] = []
    if plan.pitch is not None:
        said += _of_pitch(plan.pitch, plan.form)
    if plan.profile is not None:
        said += _of_profile(plan.profile)
    if plan.helix is not None:
        said += _of_helix(plan.helix, plan.form)
    if plan.thickness is not None:
        said += _of_thickness(plan, plan.thickness)
    return said


def _of_pitch(pitch: PitchErrors, form: GearForm) -> list[Message]:
    if pitch.once is not None and not pitch.once.clear:
        return []
    if pitch.once is not None or pitch.off is None or pitch.table is None:
        size = 0.0 if pitch.once is None else pitch.once.value
        if pitch.measured[0].left is not None and pitch.measured[0].right is not None:
            return [
                Message(
                    "Once a turn the index is off by {size:.1f} µm, and both flanks fit run-out as well as the "
                    "indexing of the machine: measure again with the part turned by a third on its arbor, to tell them "
                    "apart.",
                    size=_UM * size,
                )
            ]
        return [
            Message(
                "Once a turn the index is off by {size:.1f} µm: run-out or the indexing of the machine; measure the "
                "other flanks, too, to tell them apart.",
                size=_UM * size,
            )
        ]
    said = []
    if pitch.off.clear:
        tooth = round(pitch.towards / (2 * pi) * form.teeth) % form.teeth + 1
        said.append(
            Message(
                "The teeth are {off:.1f} ± {sigma:.1f} µm off the axis and stand out at tooth {tooth}: the bore, or "
                "the part on its arbor. Turned by half a turn on the arbor, the arbor's share changes its side.",
                off=_UM * pitch.off.value,
                sigma=_UM * pitch.off.sigma,
                tooth=tooth,
            )
        )
    if pitch.table.clear:
        said.append(
            Message(
                "Once a turn the index is off by {size:.1f} ± {sigma:.1f} µm alike on both flanks: the indexing of the "
                "machine that cut it, or of the one that measured it.",
                size=_UM * pitch.table.value,
                sigma=_UM * pitch.table.sigma,
            )
        )
    return said


def _of_profile(profile: ProfileErrors) -> list[Message]:
    said = _range_lacks(Message("profile"), profile.covered)
    if said:
        return said
    angle = profile.tool
    if angle.clear:
        said.append(
            Message(
                "The normal pressure angle is {angle:+.4f}° ± {sigma:.4f}° off: correct the tool by {change:+.4f}°.",
                angle=degrees(angle.value),
                sigma=degrees(angle.sigma),
                change=-degrees(angle.value),
            )
        )
    if profile.cutter is not None and profile.cutter.clear:
        said.append(
            Message(
                "The profile waves once in a base pitch, alike on all teeth: a hob of one start that is {off:.1f} ± "
                "{sigma:.1f} µm off its axis does so. Set it truer, or grind it.",
                off=_UM * profile.cutter.value,
                sigma=_UM * profile.cutter.sigma,
            )
        )
    if profile.between is not None and profile.between.clear:
        said.append(
            Message(
                "Profiles of right and left flanks differ by {size:.1f} µm: the tool leans, or is not at the middle.",
                size=2 * _UM * abs(profile.between.value),
            )
        )
    return said


def _range_lacks(lines: Message, covered: float) -> list[Message]:
    if covered >= _ENOUGH:
        return []
    return [
        Message(
            "The {lines} lines cover {covered:.0%} of the range that the standard evaluates: their class may be worse.",
            lines=lines,
            covered=covered,
        )
    ]


def _of_helix(helix: HelixErrors, form: GearForm) -> list[Message]:
    said = _range_lacks(Message("helix"), helix.covered)
    if said:
        return said
    if helix.lead.clear:
        # Above 0 is towards a right hand: more of a right-hand helix, less of a left-hand one.
        off = -helix.angle.value if form.helix_angle < 0 else helix.angle.value
        if form.helix_angle:
            sense = Message("more helix") if off > 0 else Message("less helix")
        else:
            sense = Message("right-hand") if off > 0 else Message("left-hand")
        said.append(
            Message(
                "The helix angle is {angle:+.4f}° ± {sigma:.4f}° off ({sense}), {lead:.1f} µm over {length:.1f} mm: "
                "correct the machine by {change:+.4f}°.",
                change=-degrees(off),
                angle=degrees(off),
                sense=sense,
                sigma=degrees(helix.angle.sigma),
                lead=_UM * abs(helix.lead.value),
                length=helix.length,
            )
        )
    if helix.taper is not None and helix.taper.clear:
        said.append(
            Message(
                "Teeth are thicker at one end by {size:.1f} µm on each flank: the feed, or wear of the tool.",
                size=_UM * abs(helix.taper.value),
            )
        )
    if helix.leaning is not None and helix.leaning.clear:
        said.append(
            Message(
                "The teeth lean by {angle:.4f}° ± {sigma:.4f}° against the axis: the face that it was clamped on, or "
                "the part on its arbor.",
                angle=degrees(helix.leaning.value),
                sigma=degrees(helix.leaning.sigma),
            )
        )
    return said


def _of_thickness(plan: MeasuredGearPlan, thickness: Sized) -> list[Message]:
    play, change = plan.play, plan.change
    assert play is not None
    assert change is not None
    said = [
        Message(
            "E_sn is {found:.1f} ± {sigma:.1f} µm, {designed:.1f} µm by design: the pair then has {play:.4f}° of play "
            "at the driven wheel.",
            found=_UM * thickness.value,
            sigma=_UM * thickness.sigma,
            designed=_UM * plan.form.tooth_thickness_deviation,
            play=degrees(play.value),
        )
    ]
    if plan.within:
        return said
    feed = abs(change) / (2 * tan(plan.form.normal_pressure_angle))
    if change < 0:
        said.append(
            Message(
                "Cut it again, {thinner:.1f} µm thinner, {feed:.1f} µm deeper along the radius.",
                thinner=-_UM * change,
                feed=_UM * feed,
            )
        )
    else:
        said.append(
            Message(
                "It is {thinner:.1f} µm too thin: cut the next one {feed:.1f} µm less deep.",
                thinner=_UM * change,
                feed=_UM * feed,
            )
        )
    return said
