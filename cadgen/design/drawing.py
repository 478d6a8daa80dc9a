"""The section of a design on its drawings."""

from pydantic import Field, field_validator

from cadgen.design.section import Section, one_line


class DrawingText(Section):
    """Texts of the title blocks of drawings, besides the material and the fits of [blank]."""

    title: str | None = Field(default=None, description="name of the machine; left out, the design's name")
    finish: str | None = Field(default=None, description="finish of the parts, such as `Ra 1.6, deburred`")
    quantity: int = Field(default=1, ge=1, le=10_000, description="how many of each part are made")

    @field_validator("title", "finish")
    @classmethod
    def _fits_its_cell(cls, text: str | None) -> str | None:
        return None if text is None else one_line(text)
