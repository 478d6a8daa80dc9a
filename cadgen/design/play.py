"""The sections on play: how much there is, how far cars differ, and what is asked of the profile against it."""

from enum import StrEnum
from typing import Annotated

from pydantic import Field, Strict, model_validator

from cadgen.car.motion.friction import DiscMaterial
from cadgen.design.section import WORD, Section
from cadgen.gears.choices import Law, StageOrder

GATE_WIDTH_MM = 400.0


class Hardware(StrEnum):
    """Thing built or done against play besides the cam: a brake on the disc, or a trim after a trial run."""

    DRAG = "drag"
    TRIM = "trim"


class Play(Section):
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
    def _a_band_has_two_ends(self) -> "Play":
        least, greatest = self.least_deg, self.greatest_deg
        if (least is None) != (greatest is None):
            raise ValueError("play has only one of least_deg and greatest_deg: give both or neither")
        if least is None and self.measured_deg is None:
            raise ValueError("play is empty: give measured_deg, or least_deg and greatest_deg, or remove [play]")
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(f"play.least_deg is {least:g}, more than greatest_deg, {greatest:g}: exchange them")
        return self


class Tolerances(Section):
    """How far cars of this design differ from it: half of each tolerance zone. What is 0 does not vary.

    Many cars are reckoned to first order. So no tolerance may turn the front wheel by more than 0.004 rad: on the
    paper's car 0.088 mm of base radius, rod radius or profile offset, 0.38 mm of the faces, 0.21 degrees of steering
    zero. What it does to the end of the run is then right within 2 %, and in proportion closer for less; of a wobble up
    to 0.1 degrees, for what leaning shortens the disc grows with its square. Nor may one
    be more than a tenth of the wheelbase or of the wheel's radius. Friction and drag vary within the bands of
    [mechanics].
    """

    law: Annotated[Law, WORD] = Field(
        default=Law.NORMAL,
        description="within the zones: normal, with its 3 sigma at the limits and clipped there, or uniform",
    )
    base_radius_mm: float = Field(default=0.0, ge=0, le=10, description="a, camshaft to fork axis, after adjustment")
    inner_face_mm: float = Field(default=0.0, ge=0, le=10, description="place of the disc's inner face")
    outer_face_mm: float = Field(default=0.0, ge=0, le=10, description="place of the disc's outer face")
    rod_radius_mm: float = Field(default=0.0, ge=0, le=10, description="r_t, of the rod")
    profile_offset_mm: float = Field(
        default=0.0, ge=0, le=10, description="profile cut too large or too small all round, along its normal"
    )
    steering_zero_deg: float = Field(default=0.0, ge=0, le=10, description="front wheel against the rod")
    wheelbase_mm: float = Field(default=0.0, ge=0, le=10, description="L")
    drive_wheel_offset_mm: float = Field(default=0.0, ge=0, le=10, description="A1")
    wheel_radius_mm: float = Field(
        default=0.0, ge=0, le=10, description="R_h, of the drive wheel as it rolls under load; needs [train]"
    )
    cam_phase_deg: float = Field(default=0.0, ge=0, le=10, description="cam on its shaft against the start of the run")
    start_x_mm: float = Field(default=0.0, ge=0, le=100, description="place at the start, along the planned heading")
    start_y_mm: float = Field(default=0.0, ge=0, le=100, description="place at the start, across it")
    start_heading_deg: float = Field(default=0.0, ge=0, le=45, description="heading at the start")
    eccentricity_mm: float | None = Field(
        default=None,
        ge=0,
        le=10,
        description="of the profile about the shaft, in any direction: the bore's place, and half the clearance of "
        "`blank.bore_fit`",
    )
    wobble_deg: float | None = Field(
        default=None, ge=0, le=10, description="by which the disc leans on its shaft, in any direction"
    )
    taper_mm: float | None = Field(
        default=None,
        ge=0,
        le=10,
        description="by which one face is cut larger than the other, half of it on either: laser, water jet, wire",
    )
    edge_break_mm: float | None = Field(
        default=None, ge=0, le=10, description="how much more or less than wanted both edges of the rim are broken"
    )
    edge_wear_mm: float | None = Field(
        default=None, ge=0, le=10, description="what wears off both edges at most, as a chamfer's leg; not less than 0"
    )
    rod_height_mm: float | None = Field(
        default=None, ge=0, le=10, description="rod's axis above or below the camshaft's"
    )
    rod_force_N: float | None = Field(
        default=None, ge=0, le=100, description="of the rod, about `mechanics.rod_force_N`; needs [mechanics]"
    )
    steering_lost_motion_deg: float | None = Field(
        default=None,
        ge=0,
        le=10,
        description="half of the play between rod and front wheel, which stands anywhere in it and anew in each run",
    )
    wheel_runout_mm: float | None = Field(
        default=None, ge=0, le=10, description="eccentricity of the drive wheel; needs [train]"
    )
    temperature_K: float | None = Field(
        default=None,
        ge=0,
        le=100,
        description="how far from that of the adjustment; needs `blank.material`, and goes by `frame_material`",
    )
    frame_material: Annotated[DiscMaterial, WORD] | None = Field(
        default=None, description="of what holds camshaft and fork apart; left out, aluminium"
    )
    gate_width_mm: float | None = Field(
        default=None,
        gt=0,
        le=100_000,
        description="of gates at the waypoints, which the drive wheel passes within half of it to either side; left "
        "out, 400, or the gates of [course]",
    )

    @property
    def gate_width(self) -> float:
        """Width of the gates at the waypoints where the course has none of its own, mm."""
        return GATE_WIDTH_MM if self.gate_width_mm is None else self.gate_width_mm


class Optimize(Section):
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
        "`trim`, a trial run, after which the steering is set",
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
