"""Advice after a calibration: what to measure next, and runs that were not used, predicted with what was found."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import degrees, hypot, radians
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.car.running.friction import USUAL
from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.deviations.catalogue import spreads
from cadgen.deviations.deviation import RETURN_ERROR, WHEEL_RADIUS, WHEELBASE
from cadgen.deviations.effect import Quantity
from cadgen.errors import FileError
from cadgen.figures import Facts, Sheet
from cadgen.inference.expectation.linear import PriorKnowledge
from cadgen.inference.expectation.next_measurement import EndRange, Expected, Next, next_measurement
from cadgen.inference.expectation.predict import Prediction, predict, predict_logged
from cadgen.inference.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.inference.measurement.nominal import MACHINED_UM, LoggedCar, Nominal
from cadgen.inference.measurement.record import Method, Record, join, refuse_wrong_units
from cadgen.jobs.calibration.calibration import CalibrationPlan, in_frame, wheelbase_of
from cadgen.jobs.calibration.calibration_report import SIGNS
from cadgen.jobs.calibration.cam_on_car import INCLINOMETER_DEG, nominal_of
from cadgen.jobs.calibration.sources import Source
from cadgen.jobs.calibration.workshop import MINUTES, Workshop, minutes_of
from cadgen.messages import Message, joined
from cadgen.output.report.notebook import Pictured, Plotted, bars_picture
from cadgen.output.report.style import Drawing
from cadgen.output.report.terminal import Block, Heading, plain
from cadgen.progress import Progress, silent

# A measurement that brings the run nearer by less than this is not worth making.
WORTH = 0.05
_SHOWN_RIVALS = 3
_REPORT_WIDTH = 110
PLAY: Quantity = (RETURN_ERROR.name, "return_error_deg")  # key of its number


@dataclass(frozen=True, eq=False, repr=False)
class Advice(Pictured):
    """Measurements that could be made, ranked by where the run is then expected to end on a new cam.

    Attributes:
        computed: the whole ranking.
        measured: whether something was measured already.
        workshop: how long measurements take, and what its cars differ by; None where that is not known.
    """

    computed: Next
    measured: bool
    workshop: Workshop | None = None

    @classmethod
    def first(
        cls,
        design: Design,
        profile: str,
        form_error_um: float | None = None,
        progress: Progress = silent,
        workshop: Workshop | None = None,
    ) -> "Advice":
        """Rank the first measurement on a car of which only the design is known.

        Args:
            design: a loaded design.
            profile: profile of the cam on the car.
            form_error_um: stated form error of the disc, rms; that of a machined one if left out.
            progress: function that is called with a few words on each step.
            workshop: what the cars of its workshop differ by, if that is known.

        Raises:
            DesignError: see `cam_on_car.nominal_of`.
        """
        nominal = nominal_of(design, profile, progress)
        floor = MACHINED_UM if form_error_um is None else form_error_um
        progress("weighing what may be measured")
        ranking = next_measurement(
            replace(nominal, form_error=floor * 1e-3), [], [], prior_of(design, nominal, None, workshop)
        )
        return cls(ranking, measured=False, workshop=workshop)

    @classmethod
    def after(cls, calibration: CalibrationPlan, design: Design, progress: Progress = silent) -> "Advice":
        """Rank the next measurement on a car that was calibrated.

        Args:
            calibration: what was found so far.
            design: the loaded design that it was measured against.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: see `cam_on_car.nominal_of`.
            FileError: the records are judged apart, or are of another car than the cam steers.
        """
        c = calibration
        diagnoses = [d for d in c.diagnoses if isinstance(d, EvidenceDiagnosis)]
        if not diagnoses and c.zones is None:
            raise FileError(
                "what to measure next is reckoned for the car that the cam steers, and only logged runs of another one "
                "were given: drive that one on a path of another shape, and give --predict what you left out"
            )
        if any(d.apart for d in diagnoses):
            raise FileError(
                "what to measure next cannot be said while the records are judged apart: leave out those that are "
                "unexplained, or not of this car in this state"
            )
        nominal = c.nominal or replace(nominal_of(design, c.profile, progress), form_error=c.form_error_um * 1e-3)
        records = [join([s.record for s in c.files(d.kind)]) for d in diagnoses]
        progress("weighing what may be measured")
        prior = prior_of(design, nominal, c, c.workshop)
        return cls(next_measurement(nominal, records, diagnoses, prior), measured=True, workshop=c.workshop)

    def __repr__(self) -> str:
        return f"<Advice: {self.ranked[0].words}>"

    @property
    def ranked(self) -> tuple[Expected, ...]:
        """Measurements, best first: `words`, `runs`, `end` (its `mean`, `least` and `most`, mm), `names_sure`."""
        return self.computed.ranked

    def minutes(self, measurement: Expected) -> float:
        """Minutes that a measurement takes, by the workshop's file, or as is usual.

        Args:
            measurement: one of `ranked`.
        """
        times = MINUTES if self.workshop is None else self.workshop.minutes
        return minutes_of(times, None if measurement.kind is None else measurement.kind.code, measurement.runs)

    def gain_per_minute(self, measurement: Expected) -> float:
        """Distance by which a measurement brings the end of the run nearer, mm for each minute that it takes.

        Args:
            measurement: one of `ranked`.
        """
        return (self.computed.now.mean - measurement.end.mean) / self.minutes(measurement)

    @property
    def report(self) -> list[Block]:
        """Ranking in paragraphs and a table; `str` of the advice gives them as text."""
        n, first = self.computed, self.ranked[0]
        blocks: list[Block] = [
            Heading(Message("what to measure next")),
            Message(
                "A new cam made for {what} is expected to end the run {mean} mm off ({least} to {most} mm in 90 %), "
                "with what no record shows yet as [tolerances] allow, or as is usual. With one measurement more:",
                what=Message("what is found so far") if self.measured else Message("the design alone"),
                mean=_mm(n.now.mean),
                least=_mm(n.now.least),
                most=_mm(n.now.most),
            ),
            Sheet(
                "next",
                "",
                (Message("measure"), Message("mm off"), "95 %", Message("nearer"), Message("minutes")),
                tuple(
                    (
                        e.words,
                        _mm(e.end.mean),
                        _mm(e.end.most),
                        f"{max(n.shrinks(e), 0.0):.0%}",
                        f"{self.minutes(e):.0f}",
                    )
                    for e in n.ranked
                ),
            ),
        ]
        fastest = max(n.ranked, key=self.gain_per_minute)
        if fastest is not first and n.shrinks(fastest) >= WORTH:
            blocks.append(
                Message(
                    "For its time most is gained by {words}: {gain:.2g} mm in a minute, and {other:.2g} by the first.",
                    words=fastest.words,
                    gain=self.gain_per_minute(fastest),
                    other=max(self.gain_per_minute(first), 0.0),
                )
            )
        if n.shrinks(first) < WORTH:
            blocks.append(
                Message(
                    "None of these brings the run nearer by {worth:.0%}: what is known is enough for the cam.",
                    worth=WORTH,
                )
            )
        if first.part is not None:
            begin, end, alone = first.part
            blocks.append(
                Message(
                    "Of the first, cam angles from {begin:.0f} to {end:.0f}° say most: measured there alone, {alone} "
                    "mm are left.",
                    begin=degrees(begin),
                    end=degrees(end) % 360,
                    alone=_mm(alone.mean),
                )
            )
        if n.rivals:
            several = (joined(names, " and ") or Message("no effect") for names in n.rivals[:_SHOWN_RIVALS])
            blocks.append(
                Message(
                    "Not ruled out at present: {several}. After the first measurement the names are sure with a chance "
                    "of {chance:.0%}.",
                    several=joined(several, "; "),
                    chance=first.names_sure,
                )
            )
        return blocks

    def __str__(self) -> str:
        return plain(self.report, _REPORT_WIDTH)

    @property
    def picture(self) -> Drawing:
        """Expected end of the run after each measurement, the best first."""
        ends = {"nothing more": self.computed.now.mean, **{str(e.words): e.end.mean for e in self.ranked}}
        return bars_picture("What to measure next", "end of the run, expected off by (mm)", ends)

    def entry(self) -> Facts:
        """Ranking, best first."""
        n = self.computed
        return Facts(
            now=_range(n.now),
            rivals=n.rivals,
            ranked=[
                Facts(measure=str(e.words), kind=e.kind and e.kind.code, runs=e.runs)
                | _range(e.end)
                | Facts(
                    nearer_by=n.shrinks(e),
                    minutes=self.minutes(e),
                    names_sure=e.names_sure,
                    part_of_turn=e.part
                    and Facts(from_deg=degrees(e.part[0]), to_deg=degrees(e.part[1])) | _range(e.part[2]),
                )
                for e in n.ranked
            ],
        )


@dataclass(frozen=True, eq=False, repr=False)
class Predictions(Plotted):
    """Measured data that a calibration did not use, predicted with what it found.

    Attributes:
        each: one for each of the data: root mean squares of each run `before` and `after`, in `unit`, and the same with
            the start `as_logged`.
    """

    each: tuple[Prediction, ...]

    @classmethod
    def of(cls, calibration: CalibrationPlan, unseen: Sequence[Source], progress: Progress = silent) -> "Predictions":
        """Predict measured data that were not used.

        Args:
            calibration: what was found in others.
            unseen: data from `sources.read`.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: data were used, have no model, are of another car than those used, or have other units.
        """
        known = {source.sha256: source for source in calibration.sources}
        by_method = {Method.EVIDENCE: _by_evidence, Method.RUNS_LEFT_OUT: _by_paths}
        out = []
        for source in unseen:
            if twin := known.get(source.sha256):
                raise FileError(
                    "{file} holds the same data as {twin}, which was used: predict others",
                    file=source.path,
                    twin=twin.path,
                )
            progress(Message("predicting {source}", source=source.record.source))
            if source.kind.method not in by_method:
                raise FileError("{file}: mean turns over zones are not predicted: give runs", file=source.record.source)
            if calibration.nominal is not None:
                source = in_frame(source, calibration.nominal)
            out.append(by_method[source.kind.method](calibration, source.record))
        return cls(tuple(out))

    def __repr__(self) -> str:
        return f"<Predictions of {', '.join(p.source for p in self.each)}>"

    @property
    def picture(self) -> Drawing:
        """Root mean square of the residual of each record, by the design and with what was found."""
        bars = {}
        for p in self.each:
            bars[f"{p.source}, before ({SIGNS[p.unit]})"] = float(np.mean(p.before))
            bars[f"{p.source}, predicted ({SIGNS[p.unit]})"] = float(np.mean(p.after))
        return bars_picture("Data that were not used", "rms", bars)

    @property
    def report(self) -> list[Block]:
        """Residuals before and after in a table, and which effects predict; `str` gives them as text."""
        blocks: list[Block] = [Heading(Message("predicted, not used"))]
        rows = []
        for p in self.each:
            logged = ("-", "-") if p.as_logged is None else tuple(map(_figure, p.as_logged))
            rows.append((p.source, f"{len(p.before)}", SIGNS[p.unit], _figure(p.before), _figure(p.after), *logged))
        head = (
            *(Message("file"), Message("runs"), Message("rms in"), Message("before"), Message("after")),
            *(Message("start as logged, before"), Message("after")),
        )
        blocks.append(Sheet("predicted", "", head, tuple(rows)))
        for effects in dict.fromkeys(p.effects for p in self.each):
            blocks.append(
                Message(
                    "Predicted with {effects}; nothing but the datum of each run is fitted.",
                    effects=joined(map(Message, effects)) or Message("no effect"),
                )
            )
        if any(p.as_logged is not None and p.kind.method is Method.RUNS_LEFT_OUT for p in self.each):
            blocks.append(
                Message(
                    "A logged car is predicted with all effects at once, each held to a size that is usual, whatever "
                    "is named."
                )
            )
        return blocks

    def __str__(self) -> str:
        return plain(self.report, _REPORT_WIDTH)

    def facts(self) -> list[Any]:
        """Predictions as plain values: means over runs, and each run."""
        return [
            Facts(
                file=p.source,
                kind=p.kind.code,
                unit=p.unit,
                effects=p.effects,
                before=np.mean(p.before),
                after=np.mean(p.after),
                start_as_logged=p.as_logged and Facts(before=np.mean(p.as_logged[0]), after=np.mean(p.as_logged[1])),
                runs=[Facts(before=b, after=a) for b, a in zip(p.before, p.after, strict=True)],
            ).json()
            for p in self.each
        ]


def prior_of(
    design: Design, nominal: Nominal, calibration: CalibrationPlan | None, workshop: Workshop | None = None
) -> PriorKnowledge:
    """Knowledge without a measurement: [tolerances], the play of the train, and what was measured apart.

    Args:
        design: loaded design.
        nominal: of its car.
        calibration: what was found so far; None before any measurement.
        workshop: what the cars of its workshop differ by, if that is known.
    """
    bare = design.as_designed()
    forces = variation.mechanics(bare, nominal.follower, nominal.lift)
    radius = variation.wheel_radius(bare, nominal.track.length)
    sizes = {WHEELBASE: nominal.car.wheelbase, WHEEL_RADIUS: radius}
    spread = spreads(variation.half_widths(bare, forces), sizes)
    band = variation.play_bands(bare).get(design.optimize.order)
    least, most = (0.0, 0.0) if band is None else band.ends
    play, unsure, assumed = (least + most) / 2, (most - least) / 4, most
    if workshop is not None:
        spread |= {key: hypot(*usual) for key, usual in workshop.usual.items()}
        play, unsure = workshop.usual.get(PLAY, (play, unsure))
    zones = None if calibration is None else calibration.zones
    if design.play is not None and design.play.measured_deg is not None:
        play, unsure = radians(design.play.measured_deg), radians(INCLINOMETER_DEG)
        assumed = play
    elif zones is not None and zones.judgement.claimed:
        play, unsure = radians(zones.zones.return_error_deg), radians(zones.zones.sigma_deg)
        assumed = play
    if unsure > 0:
        spread[PLAY] = unsure
    friction = USUAL if forces is None else forces.friction
    return PriorKnowledge(spread=spread, play=play, friction=float(np.mean(friction)), assumed=assumed)


def _range(r: EndRange) -> Facts:
    return Facts(mean_mm=r.mean, range_90_percent_mm=(r.least, r.most))


def _mm(size: float) -> str:
    return f"{size:.0f}" if size >= 10 else f"{size:.1f}"


def _by_evidence(calibration: CalibrationPlan, record: Record) -> Prediction:
    told = [d for d in calibration.diagnoses if isinstance(d, EvidenceDiagnosis)]
    if not told or calibration.nominal is None:
        raise FileError(
            "{file}: data of kind {kind} are not predicted by logged runs or zones: calibrate with lifts, profiles, "
            "transmissions or tracks of the car",
            file=record.source,
            kind=record.kind.code,
        )
    if any(d.apart for d in told):
        raise FileError(
            "{file}: nothing is predicted while the files that were used are judged apart: leave out those that are "
            "unexplained, or not of this car in this state",
            file=record.source,
        )
    refuse_wrong_units(record, calibration.nominal)
    records = [join([s.record for s in calibration.files(d.kind)]) for d in told]
    return predict(calibration.nominal, records, told, record)


def _by_paths(calibration: CalibrationPlan, record: Record) -> Prediction:
    diagnosis = next((d for d in calibration.diagnoses if isinstance(d, PathDiagnosis)), None)
    if diagnosis is None:
        raise FileError(
            "{file}: logged runs are predicted by logged runs: calibrate with some of the same car", file=record.source
        )
    records = [s.record for s in calibration.files(diagnosis.kind)]
    wheelbase, _ = wheelbase_of(calibration.against.wheelbase, [*records, record])
    refuse_wrong_units(record, LoggedCar(wheelbase))
    return predict_logged(join(records), diagnosis, wheelbase, record)


def _figure(values: Array) -> str:
    return f"{float(np.mean(values)):.4g}"
