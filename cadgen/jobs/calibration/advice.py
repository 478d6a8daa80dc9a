"""The next measurement on a car of a design, before or after a calibration, in words too."""

from dataclasses import replace
from math import degrees, radians
from typing import Any

import numpy as np

from cadgen.car.running.friction import USUAL
from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.deviations.catalogue import spreads
from cadgen.deviations.deviation import WHEEL_RADIUS, WHEELBASE
from cadgen.errors import FileError
from cadgen.figures import Sheet
from cadgen.inference.expectation.linear import PriorKnowledge
from cadgen.inference.expectation.next_measurement import EndRange, Expected, Next, next_measurement
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.nominal import MACHINED_UM, Nominal
from cadgen.inference.measurement.record import Method, join
from cadgen.jobs.calibration.plan import INCLINOMETER_DEG, Calibration, nominal_of
from cadgen.output.report.terminal import Block, Heading
from cadgen.progress import Progress, silent

# A measurement that brings the run nearer by less than this is not worth making.
WORTH = 0.05
_SHOWN_RIVALS = 3


def before(design: Design, profile: str, form_error_um: float | None = None, progress: Progress = silent) -> Next:
    """The first measurement on a car of which only the design is known.

    Args:
        design: a loaded design.
        profile: of the cam on the car.
        form_error_um: stated form error of the disc, rms; that of a machined one if left out.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: see `plan.nominal_of`.
    """
    nominal = nominal_of(design, profile, progress)
    floor = MACHINED_UM if form_error_um is None else form_error_um
    progress("weighing what may be measured")
    return next_measurement(replace(nominal, form_error=floor * 1e-3), [], [], _prior(design, nominal, None))


def after(calibration: Calibration, progress: Progress = silent) -> Next:
    """The next measurement on a car that was calibrated.

    Raises:
        DesignError: see `plan.nominal_of`.
        FileError: the records contradict each other.
    """
    c = calibration
    told = [d for d in c.diagnoses if isinstance(d, EvidenceDiagnosis)]
    if not told and c.zones is None:
        raise FileError(
            "what to measure next is reckoned for the car that the cam steers, and only logged runs of another one "
            "were given: drive that one on a path of another shape, and give --predict what you left out"
        )
    if any(d.contradicted for d in told):
        raise FileError(
            "what to measure next cannot be said while the records contradict each other: leave out those that are "
            "not of this car in this state"
        )
    nominal = c.nominal or replace(nominal_of(c.design, c.profile, progress), form_error=c.form_error_um * 1e-3)
    records = []
    for diagnosis in told:
        sources = [s.record for s in c.sources if s.kind is diagnosis.kind and s.kind.method is Method.EVIDENCE]
        records.append(join(sources))
    progress("weighing what may be measured")
    return next_measurement(nominal, records, told, _prior(c.design, nominal, c))


def _prior(design: Design, nominal: Nominal, calibration: Calibration | None) -> PriorKnowledge:
    """Knowledge without a measurement: [tolerances], the play of the train, and what was measured apart."""
    bare = design.as_designed()
    forces = variation.mechanics(bare, nominal.follower, nominal.lift)
    radius = variation.wheel_radius(bare, nominal.track.length)
    sizes = {WHEELBASE: nominal.car.wheelbase, WHEEL_RADIUS: radius}
    spread = spreads(variation.half_widths(bare, forces), sizes)
    band = variation.play_bands(bare).get(design.optimize.order)
    least, most = (0.0, 0.0) if band is None else band.ends
    play, unsure, assumed = (least + most) / 2, (most - least) / 4, most
    zones = None if calibration is None else calibration.zones
    if design.play is not None and design.play.measured_deg is not None:
        play, unsure = radians(design.play.measured_deg), radians(INCLINOMETER_DEG)
        assumed = play
    elif zones is not None and zones.judgement.claimed:
        play, unsure = radians(zones.zones.return_error_deg), radians(zones.zones.sigma_deg)
        assumed = play
    if unsure > 0:
        spread["return_error_deg"] = unsure
    friction = USUAL if forces is None else forces.friction
    return PriorKnowledge(spread=spread, play=play, friction=float(np.mean(friction)), assumed=assumed)


def words(n: Next, *, measured: bool) -> list[Block]:
    """A ranking in paragraphs and a table."""
    what = "what is found so far" if measured else "the design alone"
    first = n.ranked[0]
    blocks: list[Block] = [
        Heading("what to measure next"),
        f"A new cam made for {what} is expected to end the run {_mm(n.now.mean)} mm off ({_mm(n.now.least)} to "
        f"{_mm(n.now.most)} mm in 90 %), with what no record shows yet as [tolerances] allow, or as is usual. With one "
        "measurement more:",
        Sheet(
            "next",
            "",
            ("measure", "mm off", "95 %", "nearer"),
            tuple((e.words, _mm(e.end.mean), _mm(e.end.most), f"{max(n.shrinks(e), 0.0):.0%}") for e in n.ranked),
        ),
    ]
    if n.shrinks(first) < WORTH:
        blocks.append(f"None of these brings the run nearer by {WORTH:.0%}: what is known is enough for the cam.")
    if first.part is not None:
        begin, end, alone = first.part
        blocks.append(
            f"Of the first, cam angles from {degrees(begin):.0f} to {degrees(end) % 360:.0f}° say most: measured there "
            f"alone, {_mm(alone.mean)} mm are left."
        )
    if n.rivals:
        several = "; ".join(" and ".join(names) or "no effect" for names in n.rivals[:_SHOWN_RIVALS])
        blocks.append(
            f"Not ruled out at present: {several}. After the first measurement the names are sure with a chance of "
            f"{first.names_sure:.0%}."
        )
    return blocks


def facts(n: Next) -> dict[str, Any]:
    """The same as plain values."""
    return {
        "now": _range(n.now),
        "rivals": [list(names) for names in n.rivals],
        "ranked": [_expected(n, e) for e in n.ranked],
    }


def _expected(n: Next, e: Expected) -> dict[str, Any]:
    part = None
    if e.part is not None:
        begin, end, alone = e.part
        part = {"from_deg": degrees(begin), "to_deg": degrees(end), **_range(alone)}
    return {
        "measure": e.words,
        "kind": e.kind and e.kind.code,
        "runs": e.runs,
        **_range(e.end),
        "nearer_by": n.shrinks(e),
        "names_sure": e.names_sure,
        "part_of_turn": part,
    }


def _range(r: EndRange) -> dict[str, Any]:
    return {"mean_mm": r.mean, "range_90_percent_mm": [r.least, r.most]}


def _mm(size: float) -> str:
    return f"{size:.0f}" if size >= 10 else f"{size:.1f}"
