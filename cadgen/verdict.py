"""Verdict on a part: ready, ready with reservations, or not ready. The module is light to import.

A part is ready if a careful builder would cut it as it stands. A reservation is something that costs accuracy or cars,
or that the design leaves open; it names its cost and its cure. A check that fails makes the part not ready.
"""

from dataclasses import dataclass
from enum import StrEnum

from cadgen.check import Check, failing
from cadgen.figures import Facts, Figure
from cadgen.messages import Message


class Readiness(StrEnum):
    """State of a part before it is cut."""

    READY = "ready"
    RESERVATIONS = "ready-with-reservations"
    NOT_READY = "not-ready"

    @property
    def words(self) -> Message:
        """The state for people."""
        return _WORDS[self]


_WORDS = {
    Readiness.READY: Message("ready"),
    Readiness.RESERVATIONS: Message("ready with reservations"),
    Readiness.NOT_READY: Message("not ready"),
}


@dataclass(frozen=True)
class Reservation:
    """Something that costs accuracy or cars, or that a design leaves open.

    Attributes:
        code: kind of reservation, for programs. A code never changes.
        text: what it is, in a clause.
        cure: what to do about it, in a clause.
        cost: cost, such as millimetres at the finish or the share of cars that is lost; None where it is not known.
    """

    code: str
    text: str
    cure: str
    cost: Figure | None = None

    @property
    def sentence(self) -> Message:
        """Reservation with its cure."""
        return Message("{text}: {cure}", text=self.text, cure=self.cure)

    def entry(self) -> Facts:
        """Reservation for JSON and manifests."""
        said = Facts(code=self.code, text=self.text, cure=self.cure)
        return said if self.cost is None else said | Facts(cost=self.cost.value, cost_unit=self.cost.unit)


@dataclass(frozen=True)
class PartVerdict:
    """Verdict on a part, by its checks and its reservations.

    Attributes:
        checks: figures that were judged.
        reservations: reservations; one that costs cars stands first.
    """

    checks: tuple[Check, ...]
    reservations: tuple[Reservation, ...] = ()

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def readiness(self) -> Readiness:
        """State of the part."""
        if self.failed:
            return Readiness.NOT_READY
        return Readiness.RESERVATIONS if self.reservations else Readiness.READY

    @property
    def passed(self) -> bool:
        """Whether the part may be cut, with reservations or without."""
        return self.readiness != Readiness.NOT_READY

    def entry(self) -> Facts:
        """Verdict for JSON and manifests."""
        return Facts(
            readiness=self.readiness.value,
            failed_checks=[check.name for check in self.failed],
            reservations=[reservation.entry() for reservation in self.reservations],
        )
