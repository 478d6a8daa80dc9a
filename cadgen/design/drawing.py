"""The section of a design on its drawings."""

from pydantic import Field, ValidationInfo, field_validator

from cadgen.design.section import HERE, LONGEST_LINE, Section, one_line

LONGEST_FINISH = 36  # letters that its cell holds
_LAST_LETTER = 0x052F  # the last of the Cyrillic ones


class DrawingText(Section):
    """Texts of the title blocks of drawings, besides the material and the fits of [blank]."""

    title: str | None = Field(default=None, description="name of the machine; left out, the design's name")
    finish: str | None = Field(default=None, description="finish of the parts, such as `Ra 1.6, deburred`")
    quantity: int = Field(default=1, ge=1, le=10_000, description="how many of each part are made")

    @field_validator("title", "finish")
    @classmethod
    def _fits_its_cell(cls, text: str | None, info: ValidationInfo) -> str | None:
        if text is None:
            return None
        if max(map(ord, text), default=0) > _LAST_LETTER:
            raise ValueError(
                f"{HERE} has letters that the font of drawings lacks: write it in Latin, Greek or Cyrillic letters"
            )
        return one_line(text, LONGEST_FINISH if info.field_name == "finish" else LONGEST_LINE)
