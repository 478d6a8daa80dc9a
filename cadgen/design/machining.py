"""Sections of the workshop: milling and drilling, and the texts in the title blocks of drawings."""

import re
from enum import StrEnum
from typing import Annotated, Self

from pydantic import AfterValidator, Field, field_validator, model_validator

from cadgen.car.running.friction import DiscMaterial
from cadgen.design.section import HERE, LONGEST_CELL, LONGEST_LINE, WORD, DesignSection, drawn_line, one_line
from cadgen.messages import Message, joined

USUAL_FEED = 240.0  # mm/min at most, where the design gives neither a feed nor a material
ASSUMED = DiscMaterial.ALUMINIUM  # as which such a disc is fed
APPROACH_MM = 1.0  # above the work, to which a tool goes down at rapid speed
# Feed per tooth by the cutter's diameter, at the slow end of published charts, since it runs in a full slot, often on a
# light machine: the parameter sheet of HIT Tooling has 0.004-0.009 in aluminium and 0.003-0.011 in steel (carbide),
# and advises the low end in slots; Internal Tool's has 0.002-0.008 in brass and 0.0024-0.012 in plastics (1/4 inch).
_FEED_PER_TOOTH = {
    DiscMaterial.ALUMINIUM: 0.004,
    DiscMaterial.BRASS: 0.004,
    DiscMaterial.STEEL: 0.002,
    DiscMaterial.ACRYLIC: 0.005,
    DiscMaterial.PLA: 0.005,
    DiscMaterial.POM: 0.005,
}


class Tabs(DesignSection):
    """Bridges in the slot round the outline that hold the disc in its plate until the program stops for a clamp.

    The disc is then clamped through its bore, and the last passes take the tabs off: nothing of them is left on the
    rim, which the rod rides on all round.
    """

    count: int = Field(default=3, ge=2, le=24, description="how many, in equal steps along the slot")
    width_mm: float = Field(default=3.0, ge=0.5, le=50, description="of each, where it is narrowest")
    height_mm: float = Field(
        default=1.0, ge=0.1, le=50, description="above the disc's lower face; less than its thickness"
    )


class Drilling(DesignSection):
    """Programs that make bore, lightening holes and mark, from the zero of the outline.

    Holes at least half a millimetre wider than the outline's cutter are milled with it, all in one program; the others
    are drilled, each size by a program of its own. Without this section no holes are made.
    """

    bore_diameter_mm: float | None = Field(
        default=None,
        ge=0.2,
        le=200,
        description="of the drill for the bore, such as 7.8 before a reamer of 8; holes of this size are drilled; left "
        "out, the bore's own, or the widest that spares its flat",
    )
    point_angle_deg: float = Field(default=118.0, ge=60, le=180, description="of the drills' points")
    spindle_rpm: float | None = Field(
        default=None,
        ge=1,
        le=200_000,
        description="speed of the spindle; left out, by the drill's diameter and `blank.material`",
    )
    feed_mm_per_min: float | None = Field(
        default=None, ge=0.1, le=100_000, description="downwards; left out, a hundredth of the diameter each turn"
    )
    peck_mm: float | None = Field(
        default=None, ge=0.05, le=100, description="depth after which the drill is lifted; left out, its diameter"
    )


class Machining(DesignSection):
    """How the outline is milled (G-code)."""

    cutter_diameter_mm: float = Field(default=4.0, ge=0.2, le=100, description="of the end mill")
    cutter_teeth: int | None = Field(
        default=None, ge=1, le=20, description="of the end mill, for the feed of a material; left out, 2"
    )
    feed_mm_per_min: float | None = Field(
        default=None,
        ge=0.1,
        le=100_000,
        description="along the outline; left out, by `blank.material`, cutter and speed, or without a material as for "
        "aluminium, at most 240",
    )
    plunge_feed_mm_per_min: float = Field(default=60.0, ge=0.1, le=100_000, description="feed downwards")
    spindle_rpm: float = Field(default=8000.0, ge=1, le=200_000, description="speed of the spindle")
    step_down_mm: float = Field(default=1.0, ge=0.05, le=100, description="greatest depth of one pass")
    safe_height_mm: float = Field(
        default=5.0, gt=0, le=500, description="above the disc, where the cutter may travel freely"
    )
    break_through_mm: float = Field(default=0.3, ge=0, le=20, description="how far below the disc the last pass goes")
    lead_radius_mm: float = Field(default=3.0, gt=0, le=100, description="of the arcs that lead the cutter in and out")
    tool_number: int | None = Field(
        default=None,
        ge=1,
        le=999,
        description="of the cutter in the changer; left out, the tool in the spindle is used",
    )
    stock: str | None = Field(
        default=None, description="material to cut from, such as `plate 160 x 160 x 3`; a comment"
    )
    fixture: str | None = Field(default=None, description="how it is held, such as `on an 8 mm arbor`; a comment")
    tabs: Tabs | None = None
    drilling: Drilling | None = None

    @property
    def approach_mm(self) -> float:
        """Height above the work to which a tool goes down at rapid speed."""
        return min(APPROACH_MM, self.safe_height_mm)

    def feed(self, material: DiscMaterial | None) -> float:
        """Feed along the outline, mm/min: the design's, or that of a material; without one no more than the usual."""
        if self.feed_mm_per_min is not None:
            return self.feed_mm_per_min
        if material is None:
            return min(USUAL_FEED, self.feed(ASSUMED))
        return round(self.feed_per_tooth(material) * (self.cutter_teeth or 2) * self.spindle_rpm, 1)

    def assumption(self, material: DiscMaterial | None, key: str = "blank.material") -> Message | None:
        """Sentence on a feed that goes by a material which nobody has stated; None where the design says it.

        Args:
            material: material of the work; None if it is not known.
            key: key that states it.
        """
        if material is not None or self.feed_mm_per_min is not None:
            return None
        feed, slowest = self.feed(None), min(DiscMaterial, key=self.feed)
        fed = Message("fed for {assumed} at {feed:g} mm/min", assumed=Message(ASSUMED.value), feed=feed)
        if self.feed(slowest) < feed:
            fed = Message(
                "{fed}, where {slowest} takes {least:g}",
                fed=fed,
                slowest=Message(slowest.value),
                least=self.feed(slowest),
            )
        return Message("material not stated: {fed}; state {key}, or machining.feed_mm_per_min", fed=fed, key=key)

    def assumptions(self, material: DiscMaterial | None, key: str = "blank.material") -> Message | None:
        """Sentence on all that a program goes by and nobody has stated: feed, cutter, speed; None where nothing is.

        Args:
            material: material of the work; None if it is not known.
            key: key that states it.
        """
        said = [self.assumption(material, key)]
        if "cutter_diameter_mm" not in self.model_fields_set:
            said.append(
                Message(
                    "cutter not stated: the path is for one of {diameter:g} mm; state machining.cutter_diameter_mm",
                    diameter=self.cutter_diameter_mm,
                )
            )
        if "spindle_rpm" not in self.model_fields_set:
            said.append(
                Message(
                    "spindle speed not stated: {rpm:g} turns a minute; state machining.spindle_rpm",
                    rpm=self.spindle_rpm,
                )
            )
        return joined(stated, "; ") if (stated := [each for each in said if each]) else None

    def unstated(self, material: DiscMaterial | None) -> tuple[Message, ...]:
        """Names of what the programs of a disc go by and nobody has stated, as `assumptions` words them.

        Args:
            material: material of the disc; None if it is not known.
        """
        drilled = self.drilling is not None and self.drilling.spindle_rpm is None
        open_material = material is None and (drilled or self.feed_mm_per_min is None)
        names = {
            Message("material"): open_material,
            Message("cutter"): "cutter_diameter_mm" not in self.model_fields_set,
            Message("spindle speed"): "spindle_rpm" not in self.model_fields_set,
        }
        return tuple(name for name, is_open in names.items() if is_open)

    def feed_per_tooth(self, material: DiscMaterial) -> float:
        """Feed of each tooth in a full slot of a material, mm."""
        return _FEED_PER_TOOTH[material] * self.cutter_diameter_mm

    @field_validator("stock", "fixture")
    @classmethod
    def _fits_a_comment(cls, text: str | None) -> str | None:
        return None if text is None else one_line(text)

    @model_validator(mode="after")
    def _feed_of_a_tooth_is_used(self) -> Self:
        if self.cutter_teeth is not None and self.feed_mm_per_min is not None:
            raise ValueError(
                Message(
                    "machining.cutter_teeth is {cutter_teeth}, but machining.feed_mm_per_min gives the feed "
                    "already: remove one of the two",
                    cutter_teeth=self.cutter_teeth,
                )
            )
        return self


class DrawnTeeth(StrEnum):
    """How the sheets of gears show teeth in the view along the axis."""

    AS_CUT = "as_cut"
    SIMPLIFIED = "simplified"


def _texture(text: str) -> str:
    """Parameter of a surface texture and its limit.

    Raises:
        ValueError: it is none.
    """
    if not re.fullmatch(r"R[a-z]\d* ?\d+(\.\d+)?", text):
        raise ValueError(
            Message("{here} must be a parameter and its limit in µm, such as Ra 0.8, not {text}", here=HERE, text=text)
        )
    return text


_Texture = Annotated[str, AfterValidator(_texture)]


class DrawingText(DesignSection):
    """Texts of the title blocks of drawings, besides the fits of [blank]."""

    title: str | None = Field(default=None, description="name of the machine; left out, the design's name")
    finish: str | None = Field(default=None, description="finish of the parts, such as `Ra 1.6`")
    rim_finish: _Texture | None = Field(
        default=None, description="texture of a cam's rim or of the flanks of its groove, by its sign, such as `Ra 0.8`"
    )
    flank_finish: _Texture | None = Field(
        default=None, description="texture of the flanks of teeth, by its sign, such as `Ra 0.8`"
    )
    bore_finish: _Texture | None = Field(
        default=None, description="texture of the bores of cams and gears, by its sign, such as `Ra 1.6`"
    )
    material: str | None = Field(
        default=None,
        description="of the disc as a workshop orders it, such as `aluminium EN AW-6082`, for sheets, lists, masses "
        "and feeds alone: its friction goes by `blank.material`; left out, or where that is another one, that",
    )
    quantity: int = Field(default=1, ge=1, le=10_000, description="how many of each part are made")
    owner: str | None = Field(default=None, description="legal owner of the drawings, such as a school or a firm")
    drawn_by: str | None = Field(default=None, description="who made the drawings")
    approved_by: str | None = Field(default=None, description="who approved them")
    teeth: Annotated[DrawnTeeth, WORD] = Field(
        default=DrawnTeeth.AS_CUT,
        description="of gears seen along their axis: as they are cut, or simplified by ISO 2203, with tip and root "
        "circles",
    )

    @field_validator("title")
    @classmethod
    def _fits_a_line(cls, text: str | None) -> str | None:
        return None if text is None else drawn_line(text, LONGEST_LINE)

    @field_validator("finish", "material", "owner", "drawn_by", "approved_by")
    @classmethod
    def _fits_a_cell(cls, text: str | None) -> str | None:
        return None if text is None else drawn_line(text, LONGEST_CELL)
