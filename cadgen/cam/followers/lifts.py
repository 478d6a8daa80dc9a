"""Sense in which an arm lifts. The module is light to import."""

from enum import StrEnum

from cadgen.messages import Message


class Lifts(StrEnum):
    """Sense in which an arm lifts, by the sense in which the cam turns."""

    AGAINST = "against"
    WITH = "with"

    @property
    def words(self) -> str:
        """Sense in words."""
        return Message("against the cam") if self == Lifts.AGAINST else Message("with the cam")

    @property
    def side(self) -> int:
        """1 for an arm that lifts against the sense of the cam, -1 for one that lifts with it."""
        return 1 if self == Lifts.AGAINST else -1
