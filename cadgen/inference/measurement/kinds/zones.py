"""Zones: mean turns of the cam over many starts and stops that hold no event, a jump or a wait."""

from cadgen.deviations import catalogue
from cadgen.inference.measurement.record import Column, Datum, Kind, Method

KIND = Kind(
    code="zones",
    title="Zones",
    columns=(
        Column(name="cam_angle_deg", lower=0.0, upper=720.0),
        Column(name="std_deg", lower=1e-6, upper=90.0),
        Column(name="n", lower=2.0, upper=1e9),
    ),
    key="zone",
    readings=("cam_angle_deg",),
    catalogue=catalogue.ZONES,
    method=Method.ZONE_MEANS,
    datum=Datum(words="the mean turn without an event"),
    nearness=2,
)
