"""Profile: points of the outline from a measuring machine, about the bore."""

from collections.abc import Iterable
from math import pi

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations import catalogue
from cadgen.deviations.effect import Active, Effect
from cadgen.errors import FileError
from cadgen.inference.measurement.models.base import per_run, slopes
from cadgen.inference.measurement.models.profile import ProfileModel
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Kind, Record, Span

MOST_TURN = 2 * pi + 0.5  # of one run, rad: a little over a turn may be measured twice


def _check(record: Record) -> None:
    turned = np.arctan2(record["y_mm"], record["x_mm"])
    for run, mine in enumerate(record.parts):
        steps = np.diff(turned[mine])
        swept = float(np.sum((steps + pi) % (2 * pi) - pi))
        if abs(swept) > MOST_TURN:
            raise FileError(
                f"{record.source}: run {run + 1} goes round {abs(swept) / (2 * pi):.1f} times; "
                "number each turn as its own run"
            )


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    radius = float(np.hypot(record["x_mm"], record["y_mm"]).max())
    yield Span("x_mm, y_mm", radius, float(np.linalg.norm(nominal.disc.points, axis=1).max()), "mm")


def _model(record: Record, nominal: Nominal) -> ProfileModel:
    return ProfileModel(record, nominal.disc, floor=nominal.form_error)


def _clocking(
    model: ProfileModel, residual: Array, sigma: Array, active: Active, datum: list[tuple[Effect, Array, Array]]
) -> tuple[Array, Array]:
    """Of each run: what it was turned back by, what all runs share, and what its tangents show beside."""
    ((_, common, unsure),) = datum
    white = slopes(model, model.datum, active) * per_run(model.rows.run) / sigma[:, None]
    left = -np.linalg.lstsq(white, residual / sigma, rcond=None)[0]
    angle = model.own + common[0] + left
    return angle[:, None], np.hypot(unsure[0], 1 / np.linalg.norm(white, axis=0))[:, None]


KIND = Kind(
    code="profile",
    title="Profile",
    columns=(Column(name="x_mm", lower=-1e3, upper=1e3), Column(name="y_mm", lower=-1e3, upper=1e3)),
    readings=("x_mm", "y_mm"),
    catalogue=catalogue.PROFILE,
    datum=Datum(
        words="the clocking on the machine", name="clocking", numbers=(("clocking_deg", "deg"),), fit=_clocking
    ),
    model=_model,
    check=_check,
    spans=_spans,
    around=True,
    nearness=0,
)
