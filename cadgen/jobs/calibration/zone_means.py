"""The verdict on mean turns over zones, beside what the design's train lets expect."""

from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.gears.choices import StageOrder
from cadgen.inference.measurement.findings import Finding
from cadgen.inference.measurement.kinds.zones import Shortfall, Zones, judged, return_error, shortfall
from cadgen.inference.measurement.record import Kind, Record, said
from cadgen.inference.measurement.verdict import Judgement


@dataclass(frozen=True, kw_only=True)
class ZoneMeans:
    """Return error by mean turns over zones, with its verdict.

    Attributes:
        source, kind: source and kind of the record.
        judgement, finding: verdict, and return error.
        zones: return error and turns, degrees.
        tabled: greatest return errors of the design's train by the order of its stages, deg; empty if it has none.
        shortfall: causes that would explain the smooth zone's turn; None without speed and time, or without a train.
    """

    source: str
    kind: Kind
    judgement: Judgement
    finding: Finding
    zones: Zones
    tabled: dict[StageOrder, float]
    shortfall: Shortfall | None


def zone_means(design: Design, record: Record, ratios: tuple[float, ...]) -> ZoneMeans:
    """Judge mean turns over zones.

    Args:
        design: design with the train, for its return errors.
        record: record of zones.
        ratios: ratios of the train's stages; empty if there is none.

    Raises:
        FileError: a zone that is unknown or missing.
    """
    tabled = {order: degrees(play.return_error_max) for order, play in variation.train_plays(design).items()}
    zones = return_error(record, tuple(tabled.values()))
    judgement, finding = judged(record, zones)
    speed, time = said(record, r"([0-9.]*[0-9]) rpm"), said(record, r"([0-9.]*[0-9]) s a trial")
    ratio = float(np.prod(ratios))
    why = None
    if speed and time and design.train is not None:
        why = shortfall(zones, rpm=float(speed[0]), seconds=float(time[0]), ratio=ratio)
    return ZoneMeans(
        source=record.source,
        kind=record.kind,
        judgement=judgement,
        finding=finding,
        zones=zones,
        tabled=tabled,
        shortfall=why,
    )
