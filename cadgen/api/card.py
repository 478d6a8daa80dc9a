"""A card of settings: what `Design.card` gives."""

from dataclasses import dataclass
from os import PathLike
from typing import Any

from cadgen.api.cam import Cam
from cadgen.figures import Sheet
from cadgen.jobs.card import plan as card_plan
from cadgen.jobs.card.files import facts, sentences, write_card
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report import settings_card
from cadgen.progress import Progress, silent


@dataclass(frozen=True, eq=False, repr=False)
class Card:
    """Result of `Design.card`: one cam, and what to set on the car for every spacing that can be drawn.

    Attributes:
        computed: the whole result, for figures that are not named here; mm and rad.
    """

    computed: card_plan.CardPlan

    def __repr__(self) -> str:
        state = "passed" if self.passed else "failed"
        return f"<Card of {self.computed.design.name}: {len(self.computed.drawn)} spacings, {state}>"

    @property
    def passed(self) -> bool:
        """Whether the cam passes its checks, and the settings keep the course at every spacing."""
        return self.computed.passed

    @property
    def sentences(self) -> tuple[str, ...]:
        """The result in words, the most important first."""
        return tuple(sentences(self.computed))

    @property
    def settings(self) -> list[dict[str, Any]]:
        """The settings of each spacing with error and room, as in the table; the unit stands in each name."""
        return settings_card.rows(self.computed.design, self.computed.drawn)

    @property
    def cam(self) -> Cam:
        """The cam, with its checks at the spacing that the course is stated at."""
        return Cam.of(self.computed.cam)

    @property
    def legend(self) -> list[str]:
        """Meaning of the columns of the printed card."""
        return settings_card.legend(self.computed.design, self.computed.drawn, self.computed.draw.stated)

    @property
    def sheet(self) -> Sheet:
        """The printed card's table; a spacing that is not kept is marked."""
        return settings_card.sheet(self.computed.design, self.computed.drawn)

    def table(self) -> tuple[list[str], list[list[str]]]:
        """The printed card's table as texts: headings, and the cells of each row."""
        return list(self.sheet.heads), [[cell.text for cell in row] for row in self.sheet.cells]

    def facts(self) -> dict[str, Any]:
        """The result as plain values, as in the manifest and with `--json`."""
        return facts(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the card, `NAME_card.html` to print and `NAME_card.csv`; spacings that are not kept are marked.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: the cam itself fails its checks.
            FileError: a file cannot be written.
        """
        return write_card(self.computed, folder_of(folder), progress)
