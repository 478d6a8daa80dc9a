"""A stage of the train: its keys are those of the kind that it names, by default a pair of spur gears."""

from collections.abc import Callable
from functools import cache
from typing import Annotated, Any

from pydantic import Field, SerializeAsAny, WrapValidator

from cadgen.design.section import ByKind, OneOf, Section, keys_in, section_with
from cadgen.gears.stage_kinds import SPUR, StageKind, codes, kind_of


class GearKeys(Section):
    """One gear of a stage. Tolerances given here stand in for those of the standards."""

    teeth: int = Field(ge=4, le=1000, description="z")
    profile_shift: float = Field(default=0.0, ge=-2, le=2, description="x, in modules")
    module_mm: float | None = Field(default=None, gt=0, le=10, description="m_n; left out, that of the train")
    pressure_angle_deg: float | None = Field(
        default=None, ge=10, le=35, description="alpha_n; left out, that of the train"
    )
    width_mm: float | None = Field(default=None, gt=0, le=500, description="b; left out, that of the train")
    grade: int | None = Field(default=None, ge=3, le=12, description="tolerance grade; left out, that of the train")
    f_pt_um: float | None = Field(default=None, ge=0, le=1e4, description="single pitch deviation")
    F_beta_um: float | None = Field(default=None, ge=0, le=1e4, description="total helix deviation")
    F_r_um: float | None = Field(default=None, ge=0, le=1e4, description="radial runout")
    b_r_um: float | None = Field(default=None, ge=0, le=1e4, description="radial feed when cutting the teeth")
    F_i_radial_um: float | None = Field(
        default=None, ge=0, le=1e4, description="F_i'', total radial composite deviation"
    )


class Stage(Section):
    """One stage, the first one next to the drive. One table [[train.stages]] for each."""

    kind: Annotated[str | None, OneOf(lambda: (SPUR, *codes()))] = Field(
        default=None, description="which kind of stage; left out, a pair of spur gears"
    )
    bearing_span_mm: float | None = Field(default=None, gt=0, le=5000, description="l; left out, that of the train")
    direction_deg: float | None = Field(
        default=None,
        ge=-360,
        le=360,
        description="of the line from the driver's axis to the driven gear's; left out, one is found that clears",
    )

    @property
    def registered(self) -> StageKind:
        """Kind that it names, which is not that of spur gears."""
        return kind_of(str(self.kind))

    @property
    def keys(self) -> Any:
        """Values as the dataclass of that kind."""
        return keys_in(self, self.registered.keys)


class SpurStage(Stage):
    """One stage, the first one next to the drive. One table [[train.stages]] for each."""

    centre_distance_mm: float = Field(gt=0, le=2000, description="a")
    f_a_um: float | None = Field(
        default=None, ge=0, le=1e4, description="deviation of the centre distance; left out, the standard's"
    )
    driver: GearKeys
    driven: GearKeys


@cache
def stage_section(kind: StageKind | None) -> type[Stage]:
    """Section with the keys of a kind; None for spur gears."""
    return SpurStage if kind is None else section_with(Stage, kind.meaning, kind.keys)


STAGE = ByKind[StageKind | None, Stage](
    "kind", SPUR, lambda: (SPUR, *codes()), lambda code: None if code == SPUR else kind_of(code), stage_section
)


def stage_kinds(values: object) -> tuple[StageKind | None, ...]:
    """Kinds that the raw values of a design name for its stages, in their order."""
    train = values.get("train") if isinstance(values, dict) else None
    stages = train.get("stages") if isinstance(train, dict) else getattr(train, "stages", None)
    return tuple(STAGE.kind(stage) for stage in stages) if isinstance(stages, list | tuple) else ()


def _checked(value: object, otherwise: Callable[[object], Stage]) -> Stage:
    """Check one stage by the keys of its kind."""
    if isinstance(value, dict):
        return STAGE.check(value, otherwise)
    return value if isinstance(value, Stage) else SpurStage.model_validate(value)


StageItem = Annotated[SerializeAsAny[Stage], WrapValidator(_checked)]
