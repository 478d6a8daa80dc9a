"""What speaks against a verdict: values on a physical bound, a residual that dwarfs every effect, too little data."""

from dataclasses import replace

import numpy as np

from cadgen.errors import FileError
from cadgen.measurement.effects.base import DEG, Array
from cadgen.measurement.evidence import Spectrum
from cadgen.measurement.hypothesis import Hypothesis
from cadgen.measurement.models.base import Model, highest_order
from cadgen.measurement.noise import Noise
from cadgen.measurement.record import Record
from cadgen.measurement.verdict import Judgement

# What is left after the best subset, over what noise and the stated form error make: no part is so far off that was
# made to the design at all, and no effect stands beside such a rest with a name.
DWARFED = 10.0
# Form error of a middling spectrum, to weigh it in a track, where it is integrated twice.
TYPICAL = Spectrum(1.0, 6.0, 1.0)
LEAST_TURN_DEG = 300.0
LEAST_OVER = 1.1  # rows for each column that one run must tell apart
# What the instrument reads, by kind.
READINGS = {
    "lift": ("lift_mm",),
    "profile": ("x_mm", "y_mm"),
    "transmission": ("cam_angle_deg",),
    "track": ("x_mm", "y_mm"),
}
LEAST_ORDERS = 30  # below this, waviness and narrow bumps stand between the readings


def refuse_too_few(record: Record, model: Model) -> None:
    """A single run must have more rows than orders of form error, or nothing of it is noise.

    Raises:
        FileError: it has not.
    """
    rows, columns = len(model.rows.run), model.form.shape[1] + model.offsets.shape[1]
    if record.runs == 1 and rows < LEAST_OVER * columns:
        raise FileError(
            f"{record.source}: one run of {rows} rows cannot tell noise from {int(model.order.max())} orders of form "
            f"error; repeat the run, or give at least {int(LEAST_OVER * columns) + 1} rows in it"
        )


def resolved(record: Record, model: Model, noise: Noise) -> Noise:
    """Noise no smaller than the steps of the instrument make: readings may repeat to the last digit."""
    steps = []
    for column in READINGS[model.kind]:
        apart = np.diff(np.unique(record[column]))
        # Rounding of decimal numbers leaves steps of 1e-13 that are none.
        steps.append(float(np.min(apart[apart > 1e-9], initial=1.0)))
    least = min(steps) / np.sqrt(12) * (DEG if READINGS[model.kind][0].endswith("deg") else 1.0)
    return replace(noise, sigma=np.maximum(noise.sigma, least))


def doubted(
    judgement: Judgement, record: Record, model: Model, noise: Noise, best: Hypothesis, after: Array
) -> Judgement:
    """A judgement less what the data cannot bear, with what they cannot show said."""
    form = np.mean(model.form**2, axis=0) @ TYPICAL.variance(model.order, model.floor)
    allowed = float(np.sqrt(noise.rms**2 + form))
    left = float(np.sqrt(np.mean(after**2)))
    limits = (*judgement.limits, *_too_little(record, model))
    if left > DWARFED * allowed:
        sentence = (
            f"What the best effects leave is {left / allowed:.0f} times what noise and the stated form error make, and "
            "dwarfs every effect: check that the design and the profile belong to this file, and the file's units."
        )
        return replace(judgement, verdict="unexplained", sentence=sentence, claimed=(), limits=limits)
    stuck = {e.name: p.name for e in best.effects for p in e.parameters if p.name in best.at_bound and not e.shape}
    if stuck:
        told = "; ".join(f"{value} of {name}" for name, value in stuck.items())
        limits = (*limits, f"on the bound of what can be, and so not claimed: {told}")
    kept = tuple(name for name in judgement.claimed if name not in stuck)
    return replace(judgement, claimed=kept, limits=limits)


def _too_little(record: Record, model: Model) -> list[str]:
    """What these rows cannot show, whatever they say."""
    rows, limits = model.rows, []
    if "direction" in record.columns and len(set(record.columns["direction"].tolist())) == 1:
        limits.append("measured in one direction only: backlash and friction cannot be told from an offset or a phase")
    if record.kind not in ("lift", "profile"):
        return limits
    orders = highest_order(rows.place, rows.run)
    if orders < LEAST_ORDERS:
        limits.append(f"too few points for fine shapes: the spacing resolves up to {orders} waves round the cam")
    around = np.sort(np.degrees(rows.place) % 360.0)
    turn = 360.0 - float(np.max(np.diff(around, append=around[0] + 360.0)))
    if turn < LEAST_TURN_DEG:
        limits.append(f"only {turn:.0f} degrees of the turn were measured: the rest is not judged")
    return limits
