"""Sections on play: how much there is, the forces that let it act, how far cars differ, what is asked of profiles."""

from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

from pydantic import BeforeValidator, Field, Strict, create_model, model_validator

from cadgen.car.running.friction import DiscMaterial, material_by_name
from cadgen.design.section import WORD, DesignSection
from cadgen.deviations.deviation import VARIED
from cadgen.gears.choices import Law, StageOrder
from cadgen.messages import Message


class Hardware(StrEnum):
    """Thing built or done against play besides the cam: a brake on the disc, or a trim after a trial run."""

    DRAG = "drag"
    TRIM = "trim"


class PlaySection(DesignSection):
    """The return error of the gears, at the camshaft. Left out, it is the band that the tolerances of [train] leave."""

    least_deg: float | None = Field(default=None, ge=0, lt=180, description="least return error")
    greatest_deg: float | None = Field(default=None, ge=0, lt=180, description="greatest return error")
    measured_deg: float | None = Field(
        default=None,
        ge=0,
        lt=180,
        description="return error measured on the car; the profile is cut for it and judged with it, not over the band",
    )

    @model_validator(mode="after")
    def _a_band_has_two_ends(self) -> "PlaySection":
        least, greatest = self.least_deg, self.greatest_deg
        if (least is None) != (greatest is None):
            raise ValueError(Message("play has only one of least_deg and greatest_deg: give both or neither"))
        if least is None and self.measured_deg is None:
            raise ValueError(
                Message("play is empty: give measured_deg, or least_deg and greatest_deg, or remove [play]")
            )
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(
                Message(
                    "play.least_deg is {least:g}, more than greatest_deg, {greatest:g}: exchange them",
                    least=least,
                    greatest=greatest,
                )
            )
        return self


class _Law(DesignSection):
    law: Annotated[Law, WORD] = Field(
        default=Law.NORMAL,
        description="within the zones: normal, with its 3 sigma at the limits and clipped there, or uniform",
    )


if TYPE_CHECKING:

    class _Zones(_Law):
        def __getattr__(self, key: str) -> float | None:
            """Half width of a deviation by its key."""

else:
    # A key for each deviation of the catalogue that has a tolerance.
    _Zones = create_model(
        "_Zones",
        __base__=_Law,
        **{
            each.tolerance_key: (
                float | None if zone.optional else float,
                Field(default=None if zone.optional else 0.0, ge=0, le=zone.most, description=zone.meaning),
            )
            for each in VARIED
            if (zone := each.zone)
        },
    )


class TolerancesSection(_Zones):
    """How far cars of this design differ from it: half of each tolerance zone. What is 0 does not vary.

    Many cars are reckoned to first order. So no tolerance may turn the front wheel by more than 0.004 rad: on the
    paper's car 0.088 mm of base radius, rod radius or profile offset, 0.38 mm of the faces, 0.21 degrees of steering
    zero. What it does to the end of the run is then right within 2 %, and in proportion closer for less; of a wobble up
    to 0.1 degrees, for what leaning shortens the disc grows with its square. Nor may one
    be more than a tenth of the wheelbase or of the wheel's radius. Friction and drag vary within the bands of
    [mechanics].
    """

    frame_material: Annotated[DiscMaterial, WORD, BeforeValidator(material_by_name)] | None = Field(
        default=None, description="of what holds camshaft and fork apart; left out, aluminium"
    )
    gear_seat_mm: float | None = Field(
        default=None,
        ge=0,
        le=1,
        description="eccentricity of each gear of [train] on its shaft, by its seat and its bearings; where it is "
        "given, 0 too, the cars vary by the cumulative pitch of their gears as well",
    )
    gate_width_mm: float | None = Field(
        default=None,
        gt=0,
        le=100_000,
        description="of gates at the waypoints, which the drive wheel passes within half of it to either side; left "
        "out, only what [course] has is kept",
    )


class Optimize(DesignSection):
    """Limits for the profile against play. A limit that is left out allows anything."""

    order: Annotated[StageOrder, WORD] = Field(
        default=StageOrder.AS_GIVEN,
        description="of the stages of [train] in the car: as they stand there, or the order of least return error",
    )
    smoothing_percent: float = Field(
        default=27.15, gt=0, lt=100, description="what smoothing takes off its own sum of deflection errors"
    )
    hardware: Annotated[tuple[Annotated[Hardware, WORD], ...], Strict(False)] | None = Field(
        default=None,
        description="what may be built or done besides the cam: `drag`, a brake on the disc that holds the cam; "
        "`trim`, a trial run, after which the micrometer of the base radius is set: cars are then counted without "
        "profile_offset_mm and rod_radius_mm of [tolerances], which that takes out, and base_radius_mm and "
        "steering_zero_deg say how closely it is set",
    )
    max_end_position_mm: float | None = Field(
        default=None,
        gt=0,
        le=1e6,
        description="position error at the end of the run: the worst over the band of play, or with the measured play",
    )
    max_end_heading_deg: float | None = Field(
        default=None,
        gt=0,
        le=3600,
        description="heading error at the end of the run: the worst over the band of play, or with the measured play",
    )
    max_run_position_mm: float | None = Field(
        default=None, gt=0, le=1e6, description="position error anywhere on the run, at the play it is cut for"
    )
    max_lift_error_um: float | None = Field(
        default=None, gt=0, le=1e6, description="lift that the rod gets with play against the lift wanted, at that play"
    )


class Braked(StrEnum):
    """Part on which a brake acts."""

    DISC = "disc"
    SHAFT = "shaft"


class MechanicsSection(DesignSection):
    """The rod's force, friction and drag.

    Left out, the rod is reckoned to slide without friction, unless `follower.material` or `blank.material` says what
    slides on what.
    """

    rod_force_N: float = Field(
        default=1.0,
        gt=0,
        le=1000,
        description="of the spring on the rod at zero lift, along the lift, less what fork and wheel hold back on a "
        "fall; the greatest that it may be",
    )
    rod_rate_N_per_mm: float = Field(
        default=0.0, ge=-100, le=100, description="by which that force grows with the lift"
    )
    friction_least: float | None = Field(
        default=None, ge=0, le=1.5, description="sliding friction between rod and disc; left out, by the two materials"
    )
    friction_greatest: float | None = Field(
        default=None, ge=0, le=1.5, description="greatest friction that it may have"
    )
    greased: bool = Field(default=True, description="whether rod and disc are; for the friction of their materials")
    drag_least_Nmm: float = Field(
        default=0.0, ge=0, le=100_000, description="torque of a brake or felt against the cam's motion, at its weakest"
    )
    drag_greatest_Nmm: float | None = Field(
        default=None, ge=0, le=100_000, description="at its strongest; left out, the least"
    )
    drag_on: Annotated[Braked, WORD] = Field(
        default=Braked.DISC,
        description="what it acts on: the disc itself, or its shaft, on which the disc may have play that is not held",
    )
    speed_m_per_s: float | None = Field(
        default=None,
        gt=0,
        le=20,
        description="of the drive wheel; leads are reckoned without inertia, as of a slow car: the result says how "
        "much later a faster one leads",
    )
    drive_torque_Nmm: float | None = Field(
        default=None, gt=0, le=1e7, description="what the drive can give at the camshaft"
    )
    drive_energy_J: float | None = Field(
        default=None, gt=0, le=1e6, description="what the drive has for a run, such as 3.9 of 1 kg that falls 400 mm"
    )
    car_mass_kg: float | None = Field(
        default=None,
        gt=0,
        le=1000,
        description="of the car with its weight or motor; with drive_energy_J what the run takes is checked",
    )
    rolling_resistance: float | None = Field(
        default=None,
        ge=0,
        le=0.5,
        description="force by load, bearings of the wheels included: 0.01 to 0.03 for hard wheels on a floor; left "
        "out, 0.015",
    )
    train_efficiency: float | None = Field(
        default=None, gt=0, le=1, description="from the drive to the camshaft; left out, 0.97 for each stage"
    )

    @model_validator(mode="after")
    def _bands_run_upwards(self) -> "MechanicsSection":
        least, greatest = self.friction_least, self.friction_greatest
        if (least is None) != (greatest is None):
            raise ValueError(
                Message("mechanics has only one of friction_least and friction_greatest: give both or neither")
            )
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(
                Message(
                    "mechanics.friction_least is {least:g}, more than friction_greatest, {greatest:g}: exchange them",
                    least=least,
                    greatest=greatest,
                )
            )
        if self.drag_greatest_Nmm is not None and self.drag_greatest_Nmm < self.drag_least_Nmm:
            raise ValueError(
                Message(
                    "mechanics.drag_least_Nmm is {drag_least_nmm:g}, more than drag_greatest_Nmm, "
                    "{drag_greatest_nmm:g}: exchange them",
                    drag_least_nmm=self.drag_least_Nmm,
                    drag_greatest_nmm=self.drag_greatest_Nmm,
                )
            )
        strongest = self.drag_Nmm[1]
        if self.drive_torque_Nmm is not None and strongest >= self.drive_torque_Nmm:
            raise ValueError(
                Message(
                    "mechanics.drag_greatest_Nmm is {strongest:g}, and the drive gives {drive_torque_nmm:g} N mm "
                    "at the camshaft (mechanics.drive_torque_Nmm): it cannot turn that; lower the drag, or gear "
                    "down",
                    strongest=strongest,
                    drive_torque_nmm=self.drive_torque_Nmm,
                )
            )
        return self

    @property
    def drag_Nmm(self) -> tuple[float, float]:
        """Least and greatest drag."""
        least = self.drag_least_Nmm
        return least, least if self.drag_greatest_Nmm is None else self.drag_greatest_Nmm
