"""Mean turns of the cam over zones with no event, with a jump and with a wait: the return error they imply.

Started and stopped alike, a run over a smooth zone turns the cam by m, over a jump by m + B, over a wait ("reverse")
by m - B. Least squares of three means with their standard errors gives B and m; the third number is left to test it.
"""

from dataclasses import dataclass
from enum import StrEnum
from math import sqrt

import numpy as np
from scipy.stats import t as student

from cadgen.deviations.catalogue import ZONES
from cadgen.deviations.transmission import RETURN_ERROR
from cadgen.errors import FileError
from cadgen.inference.measurement.findings import Finding, Value
from cadgen.inference.measurement.record import Column, Datum, Kind, Method, Record
from cadgen.inference.measurement.verdict import Judgement, Verdict, sigmas_of
from cadgen.messages import Message, joined


class Zone(StrEnum):
    """Zone over which the cam turns: without an event, with a jump, or with a wait."""

    SMOOTH = "smooth"
    JUMP = "jump"
    REVERSE = "reverse"


# Turns of the cam per return error in each zone.
EVENTS = {Zone.SMOOTH: 0.0, Zone.JUMP: 1.0, Zone.REVERSE: -1.0}
CONFIDENCE = 0.95
# Standard errors that zones of one return error do not stray apart (odds of a thousand to one).
MOST_MISFIT = 3.3


@dataclass(frozen=True, slots=True)
class Compared:
    """A tabled return error against the measured one: how many standard errors apart, and is it inside."""

    tabled_deg: float
    apart: float
    inside: bool


@dataclass(frozen=True, slots=True)
class Zones:
    """Return error from mean turns over zones; degrees.

    Attributes:
        return_error_deg, sigma_deg: B and its standard error.
        interval_deg: at `CONFIDENCE`.
        smooth_deg: the turn without an event.
        freedom: degrees of freedom from which sigma was estimated (Welch and Satterthwaite).
        misfit: of what is left over, in standard errors, positive if the smooth zone turned too far.
        compared: tabled values against B.
    """

    return_error_deg: float
    sigma_deg: float
    interval_deg: tuple[float, float]
    smooth_deg: float
    smooth_sigma_deg: float
    freedom: float
    misfit: float
    compared: tuple[Compared, ...]


@dataclass(frozen=True, slots=True)
class Shortfall:
    """Size of each single cause that would alone explain the smooth zone's turn.

    Attributes:
        expected_deg: motor speed times time over ratio.
        missing_deg: expected less measured.
        speed_rpm: mean motor speed.
        ratio: of the train.
        lost_time_s: at full speed.
    """

    expected_deg: float
    missing_deg: float
    speed_rpm: float
    ratio: float
    lost_time_s: float


def return_error(record: Record, tabled_deg: tuple[float, ...] = ()) -> Zones:
    """Estimate B from zone means, normally distributed about the turn of the zone (eq. 31-33).

    Args:
        record: of kind `zones`.
        tabled_deg: values to compare it with.

    Raises:
        FileError: a zone that is unknown or missing.
    """
    names = [str(zone) for zone in record.columns["zone"]]
    if set(names) != set(EVENTS):
        raise FileError(
            "{file}: zones {names}; give {allowed}, each at least once",
            file=record.source,
            names=joined(names, ", "),
            allowed=joined(EVENTS, ", "),
        )
    mean, error = record["cam_angle_deg"], record["std_deg"] / np.sqrt(record["n"])
    design = np.stack([np.ones(len(names)), np.array([EVENTS[Zone(name)] for name in names])], axis=1)
    covariance = np.linalg.inv(design.T @ (design / error[:, None] ** 2))
    smooth, B = covariance @ (design.T @ (mean / error**2))
    sigma = sqrt(covariance[1, 1])
    weight = covariance[1] @ (design.T / error**2)
    freedom = float(sigma**4 / np.sum((weight * error) ** 4 / (record["n"] - 1)))
    reach = float(student.ppf((1 + CONFIDENCE) / 2, freedom)) * sigma
    compared = tuple(Compared(t, float((B - t) / sigma), bool(abs(B - t) <= reach)) for t in tabled_deg)
    left = (mean - design @ np.array([smooth, B])) / error
    over = np.sign(left[names.index(Zone.SMOOTH)]) * np.sqrt(np.sum(left**2) / (len(names) - 2))
    return Zones(
        return_error_deg=float(B),
        sigma_deg=sigma,
        interval_deg=(float(B - reach), float(B + reach)),
        smooth_deg=float(smooth),
        smooth_sigma_deg=sqrt(covariance[0, 0]),
        freedom=freedom,
        misfit=float(over),
        compared=compared,
    )


def judged(record: Record, zones: Zones) -> tuple[Judgement, Finding]:
    """The verdict on zones, and the return error as a finding."""
    low, high = zones.interval_deg
    size = Message(
        "{error:.3f}°, {confidence:g} % from {low:.3f} to {high:.3f}°",
        error=zones.return_error_deg,
        confidence=100 * CONFIDENCE,
        low=low,
        high=high,
    )
    value = Value("return_error_deg", zones.return_error_deg, zones.sigma_deg, "deg")
    finding = Finding(RETURN_ERROR.name, (value,), (), (), sigmas=sigmas_of(zones.freedom))
    verdict: Verdict
    if abs(zones.misfit) > MOST_MISFIT:
        verdict = Verdict.UNEXPLAINED
        sentence = Message(
            "The three zones do not agree with one return error, by {misfit:.1f} standard errors: check that all runs "
            "were started and stopped alike.",
            misfit=abs(zones.misfit),
        )
    elif low <= 0.0 or finding.within_error:
        verdict, sentence = Verdict.NONE, Message("No return error beyond chance: {size}.", size=size)
    else:
        verdict, sentence = Verdict.TRACED, Message("Traced to return error: {size}.", size=size)
    names = (finding.effect,) if verdict == Verdict.TRACED else ()
    judgement = Judgement(verdict=verdict, sentence=sentence, claimed=names, reported=names, rivals=(), separate=())
    return judgement, finding


def shortfall(zones: Zones, *, rpm: float, seconds: float, ratio: float) -> Shortfall:
    """Weigh the causes for a turn that is not the expected one; one mean cannot choose between them.

    Args:
        zones: return error over zones.
        rpm: mean speed of the motor, rpm.
        seconds: time of a run, s.
        ratio: ratio of the train.
    """
    expected = rpm / 60 * seconds * 360 / ratio
    share = zones.smooth_deg / expected
    return Shortfall(
        expected_deg=expected,
        missing_deg=expected - zones.smooth_deg,
        speed_rpm=rpm * share,
        ratio=ratio / share,
        lost_time_s=seconds * (1 - share),
    )


KIND = Kind(
    code="zones",
    title=Message("Zones"),
    columns=(
        Column(name="cam_angle_deg", lower=0.0, upper=720.0),
        Column(name="std_deg", lower=1e-6, upper=90.0),
        Column(name="n", lower=2.0, upper=1e9),
    ),
    key="zone",
    readings=("cam_angle_deg",),
    catalogue=ZONES,
    method=Method.ZONE_MEANS,
    datum=Datum(words="the mean turn without an event"),
    nearness=2,
)
