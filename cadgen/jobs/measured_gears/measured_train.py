"""Measured train of gears: angles at its input and output -> errors by wheel, play, wind-up, and what to change."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from math import degrees, hypot, pi

import numpy as np

from cadgen.design import gear_model
from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError
from cadgen.figures import Cell, Emphasis, Facts, Sheet, number
from cadgen.gears.tolerances import GRADES, flank_tolerance
from cadgen.gears.train import Train, TrainPlay, train_play
from cadgen.inference.gearing.encoder_angles import counted_on, refuse_impossible
from cadgen.inference.gearing.record_kinds import KINDS, one_of
from cadgen.inference.gearing.train_orders import SeenMesh, SeenShaft, SeenTrain, SeenWheel, seen
from cadgen.inference.gearing.transmission_error import OrderLine, TrainErrors, train_errors
from cadgen.inference.gearing.wheel_errors import (
    PitchOrEncoder,
    RunOut,
    ShaftErrors,
    Turning,
    best_turning,
    shaft_errors,
)
from cadgen.inference.measurement.record import understood_of
from cadgen.jobs.calibration.sources import Source
from cadgen.jobs.measured_gears.wanted_play import WantedPlay, corrected_text, play_words, wanted_play
from cadgen.messages import Message, joined
from cadgen.output.files.manifest import Origin
from cadgen.output.report.terminal import Block
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness

_UM = 1e3
_WIDEST = 3.0  # times the greatest play of the design, up to which rows after a turning point are left out at first
_LEAST_WIDEST = np.radians(0.3)
_GAIN = 0.1  # of a line, that turning a wheel must take out to be worth a sentence
__all__ = ["KINDS", "MeasuredTrainPlan", "TrainFault", "judge_train", "train_report"]


class TrainFault(StrEnum):
    """Reason for which the record of a train is not explained. The codes stay."""

    OUT_OF_ORDER = "rows-out-of-order"
    RATE = "ratio-off"
    LATE = "play-negative"
    LOOSE = "play-beyond-teeth"
    NOISE = "noise"
    ORDER = "order-of-no-part"
    REPEATS = "repeats-without-a-name"

    @property
    def step(self) -> Message:
        """Next step."""
        return _STEPS[self]


_STEPS = {
    TrainFault.OUT_OF_ORDER: Message("put the rows in the order in which they were read"),
    TrainFault.RATE: Message("compare the numbers of teeth, and the steps of both encoders, with the design"),
    TrainFault.LATE: Message("read both angles at the same moment, or turn slower, and measure again"),
    TrainFault.LOOSE: Message("look at the units of the angles, and for a key or coupling that is loose"),
    TrainFault.NOISE: Message("measure again with less noise"),
    TrainFault.ORDER: Message("look for what turns at the order that is left"),
    TrainFault.REPEATS: Message("look for what repeats at the same angle"),
}


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class MeasuredTrainPlan:
    """Measured train beside its design. Lengths are mm and angles rad.

    Attributes:
        design: design with the train.
        text: text of its file.
        sources: measured files.
        train: train of the design.
        seen: its shafts, wheels and meshes by their orders.
        play: play of the design by its tolerances; None where that is not known.
        errors: what was measured.
    """

    design: TrainDesign
    text: str
    sources: tuple[Source, ...]
    train: Train
    seen: SeenTrain
    play: TrainPlay | None
    errors: TrainErrors

    def __repr__(self) -> str:
        return f"<MeasuredTrain of {self.names}: {len(self.errors.lines)} lines>"

    @property
    def names(self) -> str:
        """Names of the files."""
        return joined([source.path.name for source in self.sources], ", ")

    @cached_property
    def shafts(self) -> tuple[ShaftErrors, ...]:
        """Shafts with a line once in their turn, from the input on."""
        lines = ((shaft, self.errors.line_of(shaft.number)) for shaft in self.seen.shafts)
        return tuple(shaft_errors(shaft, line, both=self.errors.both) for shaft, line in lines if line is not None)

    @cached_property
    def turnings(self) -> tuple[Turning, ...]:
        """Wheels that are worth turning on their shafts; none of a record that is not explained."""
        found = (best_turning(each) for each in ([] if self.faults else self.shafts))
        return tuple(each for each in found if each is not None and each.after < (1 - _GAIN) * each.before)

    @property
    def within(self) -> bool | None:
        """Whether the play lies in the zone of the design; None where either is not known."""
        found = self.errors.play
        if found is None or self.play is None:
            return None
        slack = 4 * found.sigma
        # A comparison of numpy's numbers is never the object False.
        return bool(self.play.return_error_min - slack <= found.value <= self.play.return_error_max + slack)

    @cached_property
    def wanted(self) -> WantedPlay | None:
        """Change of a wheel for the play of the design; None where it has that, or not all is explained."""
        found = self.errors.play
        if found is None or found.value <= 0 or self.faults:
            return None
        try:
            change = wanted_play(self.train, found.value)
        except DesignError:
            return None
        return change if change is not None and abs(change.found - change.wanted) > 4 * found.sigma else None

    @cached_property
    def corrected(self) -> str | None:
        """Text of a design whose new wheel gives the wanted play; None where nothing is to be changed or it cannot."""
        found = self.errors.play
        if self.wanted is None or self.wanted.reach is not None or found is None:
            return None
        remarks = [
            str(line) for line in (Message("Written by cadgen calibrate: corrected by {names}.", names=self.names),)
        ]
        remarks += [str(line) for line in [*play_words(self.wanted, found.sigma), *map(turning_words, self.turnings)]]
        try:
            return corrected_text(self.design, self.text, self.wanted, remarks)
        except DesignError:
            return None

    @cached_property
    def faults(self) -> tuple[TrainFault, ...]:
        """Reasons for which the record is not explained, that which may bring the others about first."""
        e = self.errors
        play, noisy = e.play, self.noisy
        # Run-out of shafts without a whole turn looks like a rate, and repeats without an order.
        most = _SLOW_RATE if e.slow else _RATE
        found = {
            TrainFault.OUT_OF_ORDER: noisy and e.readings.turning > _TURNING,
            TrainFault.RATE: e.rate.clear and abs(e.rate.value) > most,
            TrainFault.LATE: play is not None and play.value < 0 and play.clear,
            TrainFault.LOOSE: play is not None and self.most_play is not None and play.value > self.most_play,
            TrainFault.NOISE: self.play is not None and e.left > self.play.return_error_max / 2,
            TrainFault.ORDER: any(not line.named for line in e.lines),
            TrainFault.REPEATS: not e.explained and all(line.named for line in e.lines) and not e.slow,
        }
        return tuple(fault for fault, is_so in found.items() if is_so)

    @property
    def noisy(self) -> bool:
        """Whether eight times what is left, rms, is more than the greatest play of the design."""
        return self.play is not None and bool(_NOISY * self.errors.left > self.play.return_error_max)

    @property
    def most_play(self) -> float | None:
        """Half a pitch of every stage at the output, rad: a gear of each has no teeth then; None of other stages."""
        if len(self.seen.meshes) < len(self.train.stages):
            return None
        return sum(pi / mesh.order for mesh in self.seen.meshes)

    @property
    def readiness(self) -> Readiness:
        """Whether all is explained; with reservations where causes are left, or play is not that of the design."""
        if self.faults:
            return Readiness.NOT_READY
        unclear = any(not each.named for each in self.shafts) or self.errors.slow or self.errors.play is None
        reserved = unclear or self.noisy or self.within is False
        return Readiness.RESERVATIONS if reserved else Readiness.READY

    def entry(self) -> Facts:
        """Everything, as in the JSON file."""
        e = self.errors
        facts = Origin.of(self.design).entry() | Facts(
            files=[Facts(file=s.path.name, kind=s.kind.code, sha256=s.sha256) for s in self.sources],
            understood=[note for source in self.sources for note in source.record.notes],
            readiness=self.readiness.value,
            faults=[fault.value for fault in self.faults],
            rows=int(e.readings.used.sum()),
            noise_deg=degrees(e.noise),
            before_deg=degrees(e.before),
            left_deg=degrees(e.left),
            rate_percent=100 * e.rate.value,
            rate_sigma_percent=100 * e.rate.sigma,
        )
        if e.play is not None:
            facts |= Facts(play_deg=degrees(e.play.value), play_sigma_deg=degrees(e.play.sigma), within=self.within)
        if self.play is not None:
            least, most = self.play.return_error_min, self.play.return_error_max
            facts |= Facts(play_least_deg=degrees(least), play_most_deg=degrees(most))
        if e.lag is not None:
            facts |= Facts(lag_ms=1e3 * e.lag.value, lag_sigma_ms=1e3 * e.lag.sigma)
        if e.compliance is not None:
            facts |= Facts(wind_up_deg_per_Nm=degrees(e.compliance.value), wind_up_sigma=degrees(e.compliance.sigma))
        if e.friction is not None:
            facts |= Facts(
                hysteresis_deg=2 * degrees(e.friction.value), hysteresis_sigma_deg=2 * degrees(e.friction.sigma)
            )
        facts |= Facts(
            lines=[
                Facts(
                    order=line.order,
                    forward_deg=degrees(abs(line.forward)),
                    backward_deg=degrees(abs(line.backward)),
                    sigma_deg=degrees(line.sigma),
                    shafts=line.shafts,
                    meshes=line.meshes,
                )
                for line in e.lines
            ],
            shafts=[
                Facts(shaft=each.shaft.number, parts=[_part_facts(p) for p in each.parts], rivals=len(each.rivals))
                for each in self.shafts
            ],
            turnings=[
                Facts(
                    stage=each.wheel.stage,
                    turn_deg=degrees(each.angle),
                    before_deg=degrees(each.before),
                    after_deg=degrees(each.after),
                )
                for each in self.turnings
            ],
        )
        if (w := self.wanted) is not None:
            facts |= Facts(
                wanted=Facts(
                    stage=w.stage,
                    play_deg=degrees(w.wanted),
                    driven_E_sn_um=_UM * w.driven,
                    thinning_um=_UM * w.thinning,
                    centre_distance_mm=w.distance,
                    reach_E_sn_um=None if w.reach is None else [_UM * each for each in w.reach],
                )
            )
        return facts


_RATE = 2e-5  # share by which a ratio may be off: a counter's step in a turn
_SLOW_RATE = 0.01  # the same where no whole turn of a shaft was measured
_NOISY = 8.0
_TURNING = 0.25  # share of rows at which the input turns back, from which on rows are out of order: 2/3 if they all are


def _part_facts(part: RunOut | PitchOrEncoder) -> Facts:
    if isinstance(part, PitchOrEncoder):
        return Facts(what="pitch-or-encoder", size_deg=degrees(abs(part.line)))
    return Facts(
        what="run-out",
        stage=part.wheel.stage,
        driver=part.wheel.driver,
        eccentricity_um=_UM * part.eccentricity,
        sigma_um=_UM * part.eccentricity_sigma,
        high_side_deg=None if part.high is None else degrees(part.high),
    )


def judge_train(
    design: TrainDesign, text: str, sources: Sequence[Source], progress: Progress = silent
) -> MeasuredTrainPlan:
    """Errors of a train of gears from angles at its input and output.

    Args:
        design: design with a train.
        text: text of its file.
        sources: measured files of kinds `KINDS`.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no train.
        FileError: the records cannot be judged.
    """
    train = gear_model.train(design)
    orders = seen(train)
    sources = [replace(source, record=counted_on(source.record, orders)) for source in sources]
    record = one_of(tuple(source.record for source in sources))
    progress(Message("looking for the orders of the train"))
    try:
        play: TrainPlay | None = train_play(train)
    except DesignError:
        play = None
    widest = float(max(_WIDEST * play.return_error_max if play else 0.0, _LEAST_WIDEST))
    refuse_impossible(record, orders, widest)
    return MeasuredTrainPlan(
        design=design,
        text=text,
        sources=tuple(sources),
        train=train,
        seen=orders,
        play=play,
        errors=train_errors(record, orders, widest),
    )


def turning_words(turning: Turning) -> Message:
    """Sentence on a wheel that is turned on its shaft.

    Args:
        turning: wheel turned.
    """
    return Message(
        "Turn the {wheel} by {angle:.0f}° {how} on its shaft, against the {other}: their run-out then cancels from "
        "{before:.4f}° to {after:.4f}° at the output.",
        wheel=turning.wheel.name,
        angle=abs(degrees(turning.angle)),
        how=Message("forwards") if turning.angle > 0 else Message("backwards"),
        other=turning.other.name,
        before=degrees(turning.before),
        after=degrees(turning.after),
    )


def train_report(plan: MeasuredTrainPlan) -> list[Block]:
    """Report of a measured train.

    Args:
        plan: measured train.
    """
    e = plan.errors
    blocks: list[Block] = [understood_of(s.record) for s in plan.sources if s.record.notes]
    blocks.append(
        Message(
            "{files}: {rows} rows; transmission error {before:.4f}° rms at the output, {left:.4f}° left; noise "
            "{noise:.4f}°.",
            files=plan.names,
            rows=int(e.readings.used.sum()),
            before=degrees(e.before),
            left=degrees(e.left),
            noise=degrees(e.noise),
        )
    )
    heads = (Message("What it has"), Message("At the output"), Message("±"), Message("On the part"), Message("Grade"))
    blocks.append(Sheet("train-errors", Message("What the transmission shows"), heads, tuple(_rows(plan))))
    blocks += _sentences(plan)
    if plan.wanted is not None and e.play is not None:
        blocks += play_words(plan.wanted, e.play.sigma)
    blocks += [turning_words(each) for each in plan.turnings]
    return blocks


def _row(
    name: str,
    angle: float,
    sigma: float,
    part: Cell | str = "",
    grade: Cell | str = "",
    state: Emphasis = Emphasis.PLAIN,
) -> tuple[Cell | str, ...]:
    return (name, number(degrees(angle), "°", state, 4), number(degrees(sigma), "°", digits=4), part, grade)


def _rows(plan: MeasuredTrainPlan) -> list[tuple[Cell | str, ...]]:
    e, rows = plan.errors, []
    if e.play is not None:
        state = Emphasis.BAD if plan.within is False else Emphasis.PLAIN
        zone: Cell | str = ""
        if plan.play is not None:
            zone = Message(
                "{least:.3f} to {most:.3f}° by design",
                least=degrees(plan.play.return_error_min),
                most=degrees(plan.play.return_error_max),
            )
        rows.append(_row(Message("play"), e.play.value, e.play.sigma, zone, state=state))
    if e.friction is not None and e.friction.clear:
        name = Message("lag where the sense turns") if _steady(e) else Message("hysteresis by friction")
        rows.append(_row(name, 2 * e.friction.value, 2 * e.friction.sigma))
    if e.lag is not None and e.lag.clear:
        fastest = float(np.nanmax(np.abs(e.readings.speed)))
        of_time = Message("{time:.2f} ms, at the greatest speed", time=1e3 * e.lag.value)
        rows.append(_row(Message("lag or drag"), e.lag.value * fastest, e.lag.sigma * fastest, of_time))
    if e.compliance is not None and e.compliance.clear:
        stiff = Message("{stiffness:.4g} N m/°", stiffness=1 / degrees(e.compliance.value))
        rows.append(_row(Message("wind-up for 1 N m"), e.compliance.value, e.compliance.sigma, stiff))
    if TrainFault.RATE in plan.faults:
        rows.append(
            _row(Message("ratio off, in a turn"), 2 * pi * e.rate.value, 2 * pi * e.rate.sigma, state=Emphasis.BAD)
        )
    for shaft in plan.shafts:
        rows += _shaft_rows(shaft)
    for line in e.lines:
        if line.shafts and line.shafts[0][1] == 1:
            continue
        rows.append(_line_row(plan, line))
    return rows


def _shaft_rows(errors: ShaftErrors) -> list[tuple[Cell | str, ...]]:
    shaft, line = errors.shaft, errors.line
    if not errors.parts:
        return [_row(Message("once a turn of shaft {number}", number=shaft.number), line.size, line.sigma)]
    rows = []
    for part in errors.parts:
        if isinstance(part, RunOut):
            wheel = part.wheel
            grade, beyond = _grade("F_r", 2 * part.eccentricity, wheel)
            name = Message("run-out of the {wheel}", wheel=wheel.name)
            size = Cell(
                Message(
                    "{off:.1f} ± {sigma:.1f} µm off centre",
                    off=_UM * part.eccentricity,
                    sigma=_UM * part.eccentricity_sigma,
                )
            )
            rows.append(_row(name, abs(part.line), part.sigma, size, Cell(grade, state=beyond)))
        else:
            what = Message("pitch error or encoder, shaft {number}", number=shaft.number)
            if not shaft.read:
                what = Message("long pitch error, shaft {number}", number=shaft.number)
            rows.append(_row(what, abs(part.line), part.sigma))
    return rows


def _grade(symbol: str, size: float, wheel: SeenWheel) -> tuple[str, Emphasis]:
    """Least grade whose tolerance holds a size, and whether it is beyond the design's."""
    try:
        values = [float(flank_tolerance(symbol, wheel.reference_diameter, wheel.module, grade)) for grade in GRADES]
    except DesignError:
        return "–", Emphasis.MUTED
    kept = [grade for grade, value in zip(GRADES, values, strict=True) if size <= value]
    if not kept:
        return Message("over {grade}", grade=GRADES[-1]), Emphasis.BAD
    return str(kept[0]), Emphasis.BAD if kept[0] > wheel.grade else Emphasis.PLAIN


def _line_row(plan: MeasuredTrainPlan, line: OrderLine) -> tuple[Cell | str, ...]:
    if line.meshes and not line.shafts:
        stage, harmonic = line.meshes[0]
        mesh = next(each for each in plan.seen.meshes if each.stage == stage)
        name = Message("tooth mesh of stage {number}", number=stage)
        if harmonic > 1:
            name = Message("tooth mesh of stage {number}, {times} times a tooth", number=stage, times=harmonic)
        return _row(name, line.size, line.sigma, _flank(line.size * mesh.lever))
    if line.shafts:
        shaft, harmonic = line.shafts[0]
        on = next(each for each in plan.seen.shafts if each.number == shaft)
        name = Message("{times} times a turn of shaft {number}", times=harmonic, number=shaft)
        arc = _flank(line.size * on.wheels[-1].pitch_lever) if on.wheels else ""
        return _row(name, line.size, line.sigma, arc)
    if line.alias is not None:
        name = Message("order {order:.2f}, where {part} would show", order=line.order, part=_fast_name(line.alias))
        return _row(name, line.size, line.sigma)
    if line.sideband:
        one, other = line.sideband
        name = Message("order {order:.2f}, of {one:.2f} with {other:.2f}", order=line.order, one=one, other=other)
        return _row(name, line.size, line.sigma)
    name = Message("order {order:.2f}, of no part of the design", order=line.order)
    return _row(name, line.size, line.sigma, state=Emphasis.BAD)


def _flank(arc: float) -> Message:
    return Message("{arc:.1f} µm at the flank", arc=_UM * arc)


def _sentences(plan: MeasuredTrainPlan) -> list[Message]:
    """Twins, what was not seen, and what is left."""
    e, said = plan.errors, []
    if e.readings.turned:
        said.append(
            Message("The output turns the other way than the stages say: angles are taken with its sign changed.")
        )
    if e.readings.pressed:
        said.append(Message("The torque is taken with its sign changed: above 0 it is to turn the output forwards."))
    if e.readings.ignored:
        said.append(
            Message(
                "The torque shows nowhere in the angles, less than the friction: the rows are judged as without load."
            )
        )
    if plan.noisy:
        said.append(
            Message(
                "What is left, {left:.3f}°, is much beside the play of the design, up to {most:.3f}°: so are coarse "
                "steps of an encoder, and rows that do not stand in the order in which they were read.",
                left=degrees(e.left),
                most=degrees(plan.play.return_error_max) if plan.play else 0.0,
            )
        )
    if TrainFault.OUT_OF_ORDER in plan.faults:
        said.append(
            Message(
                "The input turns back at {share:.0%} of the rows, as where rows were mixed or sorted: which flanks "
                "touch cannot be told.",
                share=e.readings.turning,
            )
        )
    if TrainFault.LOOSE in plan.faults and plan.most_play is not None:
        said.append(
            Message(
                "A play of more than {most:.2f}° is not that of teeth, for a gear of each stage would have none left: "
                "the unit of an angle, or a key or a coupling.",
                most=degrees(plan.most_play),
            )
        )
    if e.play is not None and e.play.value < 0 and e.play.clear:
        said.append(
            Message(
                "The output runs ahead after each turn, which no play does: the angle of the input is read later than "
                "that of the output; read both at once, or slowly."
            )
        )
    elif e.play is not None and e.play.clear and not e.loaded and e.lag is not None:
        said.append(
            Message(
                "What grows with the speed is a lag of the output's reading, or drag, told from play by the times. "
                "Without load the play holds the wind-up by friction: load both ways to tell them apart."
            )
        )
    elif e.play is not None and e.play.clear and not e.loaded:
        said.append(
            Message(
                "Without load the play holds the wind-up by friction, and at one speed a lag between both readings "
                "looks like it: load both ways, or turn slower, to tell them apart."
            )
        )
    if _steady(e):
        said.append(
            Message(
                "The load goes one way all the time. If it is greater than the friction, the lag is wind-up, and the "
                "play is not seen; if not, the lag holds the play: load both ways, or leave the torque out if nothing "
                "pulled."
            )
        )
    elif e.play is None and e.both:
        said.append(
            Message("Each run touches one side of the teeth alone: turn back, or load the other way, within one run.")
        )
    elif e.play is None:
        said.append(
            Message("One side of the teeth alone was measured: turn back, too, or load the other way, to see the play.")
        )
    if TrainFault.RATE in plan.faults:
        said.append(
            Message(
                "The output turns {rate:.4f} % {how} than the ratio of the design: other numbers of teeth, or steps of "
                "an encoder that are counted wrongly.",
                rate=abs(100 * e.rate.value),
                how=Message("faster") if e.rate.value > 0 else Message("slower"),
            )
        )
    for each in plan.shafts:
        said += _twins(each, both=e.both)
    said += _coarse(plan)
    if e.slow:
        names = joined([Message("shaft {number}", number=shaft.number) for shaft in e.slow], Message(" and "))
        said.append(Message("No whole turn of {names} was measured: its run-out is not seen.", names=names))
    if e.fast:
        names = joined([_fast_name(part) for part in e.fast], Message(" and "))
        said.append(Message("The rows are too far apart for {names}: measure nearer to see that.", names=names))
    if e.repeats is None:
        said.append(
            Message("No angle was measured in two runs: what repeats without a name is not seen; repeat the run.")
        )
    elif not e.explained and all(line.named for line in e.lines):
        said.append(
            Message(
                "Something repeats from run to run that has no order of the train: {times:.1f} times what noise "
                "leaves.",
                times=e.repeats,
            )
        )
    if any(not line.named for line in e.lines):
        said.append(
            Message(
                "An order of no part: a bearing, a coupling or a belt, other numbers of teeth, or an encoder's own "
                "lines."
            )
        )
    return said


def _steady(e: TrainErrors) -> bool:
    """Whether a load of one sense leaves open if the lag where the motion turns is friction alone or holds the play."""
    lag, wound = e.friction, e.compliance
    return e.play is None and lag is not None and lag.clear and not (wound is not None and wound.clear)


def _fast_name(part: SeenShaft | SeenMesh) -> Message:
    if isinstance(part, SeenMesh):
        return Message("the teeth of stage {number}", number=part.stage)
    return Message("shaft {number}", number=part.number)


def _twins(errors: ShaftErrors, *, both: bool) -> list[Message]:
    shaft = errors.shaft
    said: list[Message] = []
    if not both:
        wheels = joined(
            [Message("run-out of the {wheel}", wheel=wheel.name) for wheel in shaft.wheels], Message(" or ")
        )
        said.append(
            Message(
                "Once a turn of shaft {number}: {wheels}, a long pitch error{encoder}; the other flanks tell them "
                "apart.",
                number=shaft.number,
                wheels=wheels,
                encoder=Message(", or an encoder off its axis") if shaft.read else "",
            )
        )
    if errors.rivals:
        sets = [joined([_part_name(p, shaft) for p in parts], Message(" and ")) for parts in errors.rivals]
        said.append(Message("As likely on shaft {number}: {sets}.", number=shaft.number, sets=joined(sets, "; ")))
    if shaft.read and any(isinstance(part, PitchOrEncoder) for part in errors.parts):
        said.append(
            Message(
                "An encoder off the axis of shaft {number} looks like a long pitch error of its wheel: turn its "
                "coupling by half a turn and measure again; the encoder's line turns with it.",
                number=shaft.number,
            )
        )
    said += [
        Message(
            "The high side of the {wheel} points at the other axis where its shaft has turned by {angle:.0f}°.",
            wheel=part.wheel.name,
            angle=degrees(part.high),
        )
        for part in errors.parts
        if isinstance(part, RunOut) and part.high is not None
    ]
    return said


def _part_name(part: RunOut | PitchOrEncoder, shaft: SeenShaft) -> Message:
    if isinstance(part, RunOut):
        return Message("run-out of the {wheel}", wheel=part.wheel.name)
    return Message("pitch error or encoder") if shaft.read else Message("long pitch error")


def _coarse(plan: MeasuredTrainPlan) -> list[Message]:
    """Twins of lines whose order several parts have, and what else passes with the teeth."""
    said = []
    for line in plan.errors.lines:
        others = [*line.shafts[1:]] if line.shafts else []
        if line.shafts and (others or line.meshes):
            names = [
                Message("{times} times a turn of shaft {number}", times=harmonic, number=shaft)
                for shaft, harmonic in others
            ]
            names += [Message("the teeth of stage {number}", number=stage) for stage, _ in line.meshes]
            said.append(
                Message("Order {order:.2f} is also {names}.", order=line.order, names=joined(names, Message(" and ")))
            )
    if any(line.meshes and not line.shafts for line in plan.errors.lines):
        said.append(
            Message(
                "What passes with the teeth is an error of the profile or of the pressure angle, the same on all "
                "teeth; under load it is their bending, too."
            )
        )
    return said


def line_sizes(plan: MeasuredTrainPlan) -> Mapping[str, float]:
    """Amplitude of each line at the output by its name, degrees, for a picture.

    Args:
        plan: measured train.
    """
    sizes: dict[str, float] = {}
    for line in plan.errors.lines:
        name = Message("order {order:.2f}", order=line.order)
        sizes[str(name)] = degrees(hypot(abs(line.forward), abs(line.backward)) / 2**0.5)
    return sizes
