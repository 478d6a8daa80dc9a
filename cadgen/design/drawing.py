"""The section of a design on its drawings."""

from pydantic import Field, ValidationInfo, field_validator

from cadgen.design.section import HERE, LONGEST_LINE, Section, one_line

LONGEST_FINISH = 36  # letters that its cell holds
# The last letter of Latin, Greek and Cyrillic; punctuation and signs; Chinese, Japanese and Korean ones.
_LETTERS = ((0x20, 0x52F), (0x2010, 0x22FF), (0x2E80, 0xD7A3), (0xF900, 0xFAFF), (0xFE30, 0xFE4F), (0xFF00, 0xFFEF))


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
        unknown = [letter for letter in text if not any(low <= ord(letter) <= high for low, high in _LETTERS)]
        if unknown and text.isprintable():
            raise ValueError(
                f"{HERE} has {unknown[0]}, which the fonts of drawings lack: write it in Latin, Greek, Cyrillic, "
                "Chinese, Japanese or Korean letters"
            )
        return one_line(text, LONGEST_FINISH if info.field_name == "finish" else LONGEST_LINE)
