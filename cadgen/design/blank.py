"""Sections of what the disc has besides its profile, and how they must fit each other.

Walls against the profile need the profile, and are checked with it.
"""

from enum import StrEnum
from math import hypot, pi, radians, sin
from typing import Annotated, TypeVar

from pydantic import BeforeValidator, Field, model_validator

from cadgen.car.running.friction import DiscMaterial, material_by_name
from cadgen.design.section import HERE, WORD, CellText, DesignSection, Feature, ZeroOrFeature
from cadgen.errors import DesignError
from cadgen.messages import Message
from cadgen.parts.face import Face


class ShaftJoint(StrEnum):
    """Joint of a wheel and its shaft."""

    CLAMPED = "clamped"
    PINNED = "pinned"
    GLUED = "glued"
    KEYED = "keyed"
    D_FLAT = "d_flat"


# Joints without play, in words.
TIGHT = {
    ShaftJoint.CLAMPED: Message("clamped"),
    ShaftJoint.PINNED: Message("pinned"),
    ShaftJoint.GLUED: Message("glued"),
}

S = TypeVar("S", bound="Held")


class Held(DesignSection):
    """A wheel on its shaft."""

    joint: Annotated[ShaftJoint, WORD] | None = Field(
        default=None,
        description="what holds it on its shaft: `clamped`, `pinned` or `glued`, without play; `keyed` or `d_flat`, "
        "whose clearance adds to the return error; left out, none is counted",
    )
    joint_clearance_least_um: float | None = Field(
        default=None,
        ge=0,
        le=1000,
        description="of the key in its groove, or of a D-shaft across its flat; left out, 0 or that of the fit",
    )
    joint_clearance_greatest_um: float | None = Field(
        default=None, ge=0, le=1000, description="the same at most; left out, that of the fit"
    )
    joint_fit: str | None = Field(
        default=None,
        max_length=20,
        description="instead of the clearances, the fit by ISO 286, such as `JS9/h9` of a groove and its key, or "
        "`H9/h9` of a D-shaft; of the keyway's width or of the bore",
    )
    joint_across_mm: float | None = Field(
        default=None, gt=0, le=500, description="of a D-shaft, from its flat to its far side"
    )

    @model_validator(mode="after")
    def _joint_is_whole(self: S) -> S:
        loose = self.joint is not None and self.joint not in TIGHT
        names = ("joint_clearance_least_um", "joint_clearance_greatest_um", "joint_fit", "joint_across_mm")
        clearances = [name for name in names if getattr(self, name) is not None]
        if clearances and not loose:
            raise ValueError(
                Message(
                    '{here}.{clearances} is for a wheel with joint = "keyed" or "d_flat", and this one has '
                    "{joint}: set joint, or remove {clearances}",
                    here=HERE,
                    clearances=clearances[0],
                    joint=self.joint or Message("none"),
                )
            )
        least, greatest = self.joint_clearance_least_um, self.joint_clearance_greatest_um
        if loose and greatest is None and self.joint_fit is None:
            raise ValueError(
                Message(
                    '{here}.joint = "{joint}" needs its clearance: give joint_clearance_greatest_um, or '
                    'joint_fit such as "JS9/h9"; or choose clamped, pinned or glued, which has none',
                    here=HERE,
                    joint=self.joint,
                )
            )
        if loose and self.joint_fit is not None and (least is not None or greatest is not None):
            raise ValueError(
                Message("{here}.joint_fit and joint_clearance_..._um say the same twice: remove one of them", here=HERE)
            )
        if self.joint_fit is not None:
            from cadgen.gears.fits import zones_of  # only here: it needs numpy, and most designs have no fit

            try:
                zones_of(self.joint_fit)
            except DesignError as error:
                raise ValueError(
                    Message("{here}.joint_fit: {error}; or give the clearance itself", here=HERE, error=error.message)
                ) from None
        if least is not None and greatest is not None and least > greatest:
            raise ValueError(
                Message(
                    "{here}.joint_clearance_least_um is {least:g}, more than joint_clearance_greatest_um, "
                    "{greatest:g}: exchange them",
                    here=HERE,
                    least=least,
                    greatest=greatest,
                )
            )
        return self


_WIDEST_SCREW = 0.998  # of the bore


class KeywaySection(DesignSection):
    """A keyway in the bore."""

    width_mm: Feature = Field(le=100, description="across the key; less than the bore's diameter")
    depth_mm: Feature = Field(le=50, description="from the bore's circle to the keyway's floor, along its middle")
    angle_deg: float = Field(default=0.0, ge=-360, le=360, description="polar angle of its middle")


class DFlatSection(DesignSection):
    """A flat in the bore, for a D-shaft."""

    across_mm: Feature = Field(
        le=200, description="from the flat to the bore's far side; more than half the bore's diameter"
    )
    angle_deg: float = Field(default=0.0, ge=-360, le=360, description="polar angle of the flat's middle")


class SetScrewSection(DesignSection):
    """A radial hole through the hub's wall."""

    hole_diameter_mm: Feature = Field(le=50, description="of the hole to be tapped; less than the bore's diameter")
    height_mm: float = Field(gt=0, le=200, description="from the disc's face to the hole's axis")
    angle_deg: float = Field(default=0.0, ge=-360, le=360, description="polar angle of the hole")
    thread: CellText | None = Field(default=None, description="to be tapped in it, such as `M3`; for the drawing")


class HubSection(DesignSection):
    """A round hub on one face of the disc."""

    diameter_mm: Feature = Field(le=500, description="outer; the bore and its keyway must fit inside")
    length_mm: Feature = Field(le=200, description="how far it stands out of the disc's face")
    side: Annotated[Face, WORD] = Field(
        default=Face.OUTER, description="face that it stands on; the inner one is nearer to the fork"
    )
    set_screw: SetScrewSection | None = None

    @model_validator(mode="after")
    def _set_screw_fits(self) -> "HubSection":
        screw = self.set_screw
        if screw is None:
            return self
        radius = screw.hole_diameter_mm / 2
        if not radius < screw.height_mm < self.length_mm - radius:
            raise ValueError(
                Message(
                    "blank.hub.set_screw.height_mm is {height_mm:g}; a hole of {diameter:g} mm there does not lie "
                    "within the hub's length of {length_mm:g} mm: change height_mm, hole_diameter_mm or "
                    "blank.hub.length_mm",
                    height_mm=screw.height_mm,
                    diameter=2 * radius,
                    length_mm=self.length_mm,
                )
            )
        return self


class LighteningSection(DesignSection):
    """A ring of equal round holes."""

    holes: int = Field(ge=1, le=360, description="number of holes")
    hole_diameter_mm: Feature = Field(le=500, description="of each hole")
    circle_diameter_mm: Feature = Field(le=1000, description="of the circle that their centres lie on")
    angle_deg: float = Field(default=0.0, ge=-360, le=360, description="polar angle of the first hole")

    @model_validator(mode="after")
    def _holes_keep_apart(self) -> "LighteningSection":
        apart = self.circle_diameter_mm * sin(pi / self.holes)
        if self.holes > 1 and apart <= self.hole_diameter_mm:
            raise ValueError(
                Message(
                    "blank.lightening has {holes} holes of {hole_diameter_mm:g} mm that overlap each other, "
                    "because their centres are {apart:.4g} mm apart: lower holes or hole_diameter_mm, or raise "
                    "circle_diameter_mm, which is {circle_diameter_mm:g}",
                    holes=self.holes,
                    hole_diameter_mm=self.hole_diameter_mm,
                    apart=apart,
                    circle_diameter_mm=self.circle_diameter_mm,
                )
            )
        return self


class MarkSection(DesignSection):
    """A hole beside the key that shows which face is up: on a disc that is turned over it is on the other side."""

    diameter_mm: Feature = Field(default=3.0, le=50, description="of the hole")
    radius_mm: Feature = Field(le=500, description="of its centre, from the axis")
    angle_deg: float = Field(default=45.0, ge=-360, le=360, description="polar angle of its centre")


class BlankSection(Held):
    """Features of the disc besides its profile. Polar angles are those of the profile."""

    bore_diameter_mm: Feature = Field(default=8.0, le=200, description="of the hole for the camshaft")
    edge_break_mm: Annotated[float | None, ZeroOrFeature()] = Field(
        default=None,
        le=20,
        description="leg of the 45° chamfer by which both edges of the outline (not those of bore and holes) are "
        "broken; the rod rides on the land between them, and the profile is made for that; left out, 0: sharp edges",
    )
    keyway: KeywaySection | None = None
    d_flat: DFlatSection | None = None
    hub: HubSection | None = None
    lightening: LighteningSection | None = None
    mark: MarkSection | None = None
    bore_fit: str | None = Field(
        default=None,
        max_length=20,
        description="of the bore on its shaft by ISO 286, such as `H7/g6`; half its clearance adds to "
        "`tolerances.eccentricity_mm`",
    )
    material: Annotated[DiscMaterial, WORD, BeforeValidator(material_by_name)] | None = Field(
        default=None,
        description="of the disc, also by a grade or another word, such as `C45` or `aluminum`: its friction with the "
        "rod goes by it where [mechanics] gives none",
    )

    @model_validator(mode="after")
    def _mark_is_on_one_side(self) -> "BlankSection":
        key = self.keyway or self.d_flat
        if self.mark is None or key is None:
            return self
        aside = abs(self.mark.radius_mm * sin(radians(self.mark.angle_deg - key.angle_deg)))
        if aside <= self.mark.diameter_mm / 2:
            raise ValueError(
                Message(
                    "blank.mark.angle_deg is {angle:g}, in line with the key at {key:g}: a disc that "
                    "is turned over would look alike; give an angle to one side of it, such as {other:g}",
                    angle=self.mark.angle_deg,
                    key=key.angle_deg,
                    other=key.angle_deg + 45,
                )
            )
        return self

    @model_validator(mode="after")
    def _bore_fit_is_known(self) -> "BlankSection":
        if self.bore_fit is not None:
            from cadgen.gears.fits import zones_of

            try:
                zones_of(self.bore_fit, self.bore_diameter_mm)
            except DesignError as error:
                raise ValueError(
                    Message(
                        "blank.bore_fit: {error}; or remove it, and give tolerances.eccentricity_mm",
                        error=error.message,
                    )
                ) from None
        return self

    @model_validator(mode="after")
    def _parts_fit_each_other(self) -> "BlankSection":
        key_reach = self._reach_of_bore()
        core, reach = Message("bore and keyway") if self.keyway else Message("bore"), key_reach
        if self.hub:
            if self.hub.diameter_mm / 2 <= key_reach:
                raise ValueError(
                    Message(
                        "blank.hub.diameter_mm is {diameter_mm:g}; it must be greater than {key_reach:.4g}, or "
                        "{core} cut through the hub's wall",
                        diameter_mm=self.hub.diameter_mm,
                        key_reach=2 * key_reach,
                        core=core,
                    )
                )
            screw = self.hub.set_screw
            # The edge of a hole as wide as the bore has two sharp bends, which no CAD kernel follows exactly.
            if screw and screw.hole_diameter_mm > _WIDEST_SCREW * self.bore_diameter_mm:
                raise ValueError(
                    Message(
                        "blank.hub.set_screw.hole_diameter_mm is {hole_diameter_mm:g}; it must be at least 0.2 % "
                        "less than blank.bore_diameter_mm, which is {bore_diameter_mm:g}",
                        hole_diameter_mm=screw.hole_diameter_mm,
                        bore_diameter_mm=self.bore_diameter_mm,
                    )
                )
            core, reach = Message("hub"), self.hub.diameter_mm / 2
        ring = self.lightening
        if ring and (ring.circle_diameter_mm - ring.hole_diameter_mm) / 2 <= reach:
            raise ValueError(
                Message(
                    "blank.lightening has holes of {hole_diameter_mm:g} mm on a circle of {circle_diameter_mm:g} "
                    "mm, which overlap the {core}, {reach:.4g} mm from the axis: lower hole_diameter_mm or raise "
                    "circle_diameter_mm",
                    hole_diameter_mm=ring.hole_diameter_mm,
                    circle_diameter_mm=ring.circle_diameter_mm,
                    core=core,
                    reach=reach,
                )
            )
        return self

    def _reach_of_bore(self) -> float:
        """Farthest point of the bore from its axis, mm; refuses a keyway or flat that does not fit it."""
        bore, key, flat = self.bore_diameter_mm, self.keyway, self.d_flat
        if key and flat:
            raise ValueError(
                Message(
                    "blank has both keyway and d_flat, which exclude each other: remove [blank.keyway] or "
                    "[blank.d_flat] (on the command line with --set blank.keyway= or --set blank.d_flat=)"
                )
            )
        if flat and not bore / 2 < flat.across_mm < bore:
            raise ValueError(
                Message(
                    "blank.d_flat.across_mm is {across_mm:g}; it must lie between {half:g} and {bore:g}, half "
                    "of blank.bore_diameter_mm and all of it",
                    across_mm=flat.across_mm,
                    half=bore / 2,
                    bore=bore,
                )
            )
        if key is None:
            return bore / 2
        if key.width_mm >= bore:
            raise ValueError(
                Message(
                    "blank.keyway.width_mm is {width_mm:g}; it must be less than blank.bore_diameter_mm, which "
                    "is {bore:g}",
                    width_mm=key.width_mm,
                    bore=bore,
                )
            )
        return hypot(bore / 2 + key.depth_mm, key.width_mm / 2)
