"""Fits of a part on its shaft as a sheet states them: classes beside dimensions, and limit deviations in the notes.

The keyway of a hub may be deeper than stated, and no shallower, by limits that go with the key's width (DIN 6885-1,
depth t2; GB/T 1095 has the same). Its width is P9 for a tight key, JS9 for an easy one, and the key itself h9.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from cadgen.design.blank import Held, ShaftJoint
from cadgen.gears.fits import deviations, zones_of
from cadgen.messages import Message
from cadgen.output.drawing.sheet import rounded
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Flats, Keyway

_DEEPER = ((6.0, 0.1), (32.0, 0.2))  # greatest width of a key, and upper deviation of its hub's keyway, mm
_DEEPEST = 0.3  # upper deviation for wider keys, mm
_TIGHT = {
    ShaftJoint.CLAMPED: Message("clamped"),
    ShaftJoint.PINNED: Message("pinned"),
    ShaftJoint.GLUED: Message("glued"),
}
_DIGITS = 4  # of deviations, mm: half a grade may end in half a micrometre


@dataclass(frozen=True, slots=True, kw_only=True)
class ShaftFit:
    """Fits and joint of a part on its shaft.

    Attributes:
        bore: fit of the bore, such as `H7/g6`; None where the design does not say.
        joint: what holds the part; None where the design does not say.
        joint_fit: fit of a key in its groove, or of a D-shaft; None where the design gives none.
        clearance: least and greatest clearance that the design gives instead, µm.
        across: width of a D-shaft from its flat to its far side, mm; None where the design gives none.
        thread: thread of the set screw, such as `M3`; None where the design does not say.
    """

    bore: str | None = None
    joint: ShaftJoint | None = None
    joint_fit: str | None = None
    clearance: tuple[float, float] | None = None
    across: float | None = None
    thread: str | None = None

    @classmethod
    def of(cls, held: Held, bore: str | None, thread: str | None) -> "ShaftFit":
        """Fits of a wheel of a design.

        Args:
            held: section of the design.
            bore: fit of its bore.
            thread: thread of its set screw.
        """
        least, greatest = held.joint_clearance_least_um, held.joint_clearance_greatest_um
        return cls(
            bore=bore,
            joint=held.joint,
            joint_fit=held.joint_fit,
            clearance=None if greatest is None else (least or 0.0, greatest),
            across=held.joint_across_mm,
            thread=thread,
        )

    @property
    def bore_class(self) -> str:
        """Class of the bore after its diameter, with a blank before it; empty where there is none."""
        return _after(self.bore)

    @property
    def key_class(self) -> str:
        """Class of the keyway after its width, likewise."""
        return _after(self.joint_fit) if self.joint == ShaftJoint.KEYED else ""

    @property
    def flat_class(self) -> str:
        """Class of the bore across its flat, likewise."""
        return _after(self.joint_fit) if self.joint == ShaftJoint.D_FLAT else ""

    def notes(self, blank: Blank) -> Iterator[Message]:
        """Sentences on bore and joint, with the limit deviations of their fits.

        Args:
            blank: bore and keyway or flat of the part.
        """
        bore, key = blank.bore_diameter, blank.key
        if self.bore:
            flats = isinstance(key, Flats)
            name = Message("Across flats {size:g}", size=bore) if flats else Message("Bore Ø{size:g}", size=bore)
            yield fit_limits(name, Message("shaft"), self.bore, bore)
        else:
            yield Message("Fit of the bore: not stated; choose it with the shaft.")
        if isinstance(key, Keyway):
            yield Message(
                "Bore and keyway {size}: {deviations} mm (DIN 6885-1).",
                size=rounded(bore + key.depth),
                deviations=limits(0.0, deeper(key.width)),
            )
            if self.joint != ShaftJoint.KEYED:
                yield Message("Fit of the keyway: not stated; choose it with the key.")
            elif self.joint_fit:
                yield fit_limits(Message("Keyway {size:g}", size=key.width), Message("key"), self.joint_fit, key.width)
        across = bore - key.depth if isinstance(key, DFlat) else self.across
        if self.joint == ShaftJoint.D_FLAT and self.joint_fit and across:
            name = Message("Across the flat {size}", size=rounded(across))
            yield fit_limits(name, Message("D-shaft"), self.joint_fit, bore)
        if self.clearance:
            part = Message("key") if self.joint == ShaftJoint.KEYED else Message("D-shaft")
            least, most = self.clearance
            yield Message("Clearance of the {part}: {least:g} to {most:g} µm.", part=part, least=least, most=most)
        elif self.joint in _TIGHT:
            yield Message("On its shaft without play: {joint}.", joint=_TIGHT[self.joint])

    def tapped(self) -> Message:
        """Thread of the set screw's hole, in words."""
        return Message("to be tapped {thread}", thread=self.thread) if self.thread else Message("to be tapped")


def deeper(width: float) -> float:
    """Upper deviation of the depth of a hub's keyway, mm; the lower one is 0.

    Args:
        width: width of the key, mm.
    """
    return next((more for widest, more in _DEEPER if width <= widest), _DEEPEST)


def limits(low: float, high: float) -> str:
    """Limit deviations as on a drawing (ISO 129-1), the upper one first: `+0.1/0`, or `±0.0125`.

    Args:
        low: lower deviation, mm.
        high: upper deviation, mm.
    """
    lower, upper = (f"{'+' if each > 0 else ''}{rounded(each + 0.0, _DIGITS)}" for each in (low, high))  # no -0
    return f"±{upper[1:]}" if high > 0 and lower[1:] == upper[1:] else f"{upper}/{lower}"


def hole_class(fit: str | None) -> str:
    """Class of the hole of a fit, `H7` of `H7/g6`; empty without a fit."""
    if not fit:
        return ""
    letter, grade, *_ = zones_of(fit)
    return f"{letter}{grade}"


def _after(fit: str | None) -> str:
    return f" {hole_class(fit)}" if fit else ""


def fit_limits(name: Message, other: Message, fit: str, size: float) -> Message:
    """Limit deviations of both partners of a fit.

    Args:
        name: feature of the part, with its size.
        other: what goes in it.
        fit: fit by ISO 286.
        size: size that its zones go by, mm.
    """
    *_, shaft, grade = zones_of(fit)
    hole_zone, shaft_zone = deviations(fit, size)
    return Message(
        "{name} {hole}: {hole_zone}; {other} {shaft}: {shaft_zone} mm.",
        name=name,
        hole=hole_class(fit),
        hole_zone=limits(*hole_zone),
        other=other,
        shaft=f"{shaft}{grade}",
        shaft_zone=limits(*shaft_zone),
    )
