"""The section of a design on its drawings."""

from pydantic import Field, field_validator

from cadgen.design.section import HERE, Section

_LONGEST = 60  # letters that a title block holds


class DrawingText(Section):
    """Texts of the title blocks of drawings, besides the material and the fits of [blank]."""

    title: str | None = Field(default=None, description="name of the machine; left out, the design's name")
    finish: str | None = Field(default=None, description="finish of the parts, such as `Ra 1.6, deburred`")
    quantity: int = Field(default=1, ge=1, le=10_000, description="how many of each part are made")

    @field_validator("title", "finish")
    @classmethod
    def _fits_its_cell(cls, text: str | None) -> str | None:
        if text is not None and not (0 < len(text) <= _LONGEST and text.isprintable()):
            raise ValueError(f"{HERE} must be one line of 1 to {_LONGEST} letters: shorten it")
        return text
