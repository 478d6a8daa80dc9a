"""Fits of a part on its shaft as a sheet states them: classes beside dimensions, and limit deviations in a table.

The keyway of a hub and the seat in its shaft may be deeper than stated, and no shallower. The limits go with the key's
width (DIN 6885-1, depths t2 and t1; GB/T 1095 has the same). A keyway is P9 wide for a tight key, JS9 for an easy one,
and the key itself h9; the seat is P9 for either, so that the play is that in the hub.

Depths, radii and classes of width agree with printed extracts of both standards, symmetry with table B.4 of GB/T 1184.
The limits of a seat's length stand in DIN 6885-1 alone, of which no extract at hand has them: GB/T 1095 takes H14.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

from cadgen.design.blank import TIGHT, Held, ShaftJoint
from cadgen.gears.fits import STEPS, deviations, zones_of
from cadgen.messages import Message
from cadgen.output.drawing.sheet import DIAMETER, SheetTable, rounded
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Flats, Keyway

# Greatest size of a key, and what it has up to that size, mm.
_Steps = tuple[tuple[float, float], ...]
_DEEPER: _Steps = ((6.0, 0.1), (32.0, 0.2), (inf, 0.3))  # by the width: upper deviation of depths
_LONGER: _Steps = ((28.0, 0.2), (80.0, 0.3), (inf, 0.5))  # by the length: upper deviation of a seat's length
# By the width: greatest r2 of a seat.
_FILLETS: _Steps = ((4.0, 0.16), (8.0, 0.25), (18.0, 0.4), (32.0, 0.6), (50.0, 1.0), (70.0, 1.6), (inf, 2.5))
# By the width: symmetry to the axis, grade 8 of GB/T 1184 (table B.4), which GB/T 1095 has between 7 and 9.
_SYMMETRY: _Steps = (
    (3.0, 0.01), (6.0, 0.012), (10.0, 0.015), (18.0, 0.02), (30.0, 0.025), (50.0, 0.03), (inf, 0.04)
)  # fmt: skip
_TIGHT_KEY = "P9"  # of a keyway whose key has no play (DIN 6885-1)
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
        return _after(hole_class(self.bore))

    def key_class(self, width: float) -> str:
        """Class of the keyway after its width, likewise; P9 of a part that is held without play.

        Args:
            width: width of the keyway, mm.
        """
        if self.joint == ShaftJoint.KEYED:
            return _after(hole_class(self.joint_fit))
        return _after(_TIGHT_KEY) if self.joint in TIGHT and width <= STEPS[-1] else ""

    @property
    def flat_class(self) -> str:
        """Class of the bore across its flat, likewise."""
        return _after(hole_class(self.joint_fit)) if self.joint == ShaftJoint.D_FLAT else ""

    def table(self, blank: Blank, at: tuple[float, float], pins: tuple[float, str] = (0.0, "")) -> SheetTable | None:
        """Limit deviations of the classes of bore and keyway or flat; None where no class is stated.

        Args:
            blank: bore and keyway or flat of the part.
            at: upper left corner on the paper, mm.
            pins: diameter of holes for pins, mm, and their class; empty where there is none.
        """
        bore, key = blank.bore_diameter, blank.key
        sizes = []
        if bore:
            sizes.append(("" if isinstance(key, Flats) else DIAMETER, bore, bore, self.bore_class))
        if isinstance(key, Keyway):
            sizes.append(("", key.width, key.width, self.key_class(key.width)))
        if isinstance(key, DFlat):
            sizes.append(("", bore - key.depth, bore, self.flat_class))
        sizes.append((DIAMETER, pins[0], pins[0], _after(pins[1])))
        rows = tuple(
            (f"{sign}{rounded(size)}{named}", limited(by, named.strip()).partition("(")[2].rstrip(")"))
            for sign, size, by, named in sizes
            if named
        )
        title = Message("limits, mm")
        return SheetTable(title=title, at=at, widths=(24.0, 30.0), rows=rows, headed=False) if rows else None

    def notes(self, blank: Blank) -> Iterator[Message]:
        """Sentences on the joint, and on fits and thread that are not stated.

        Args:
            blank: bore and keyway or flat of the part.
        """
        key = blank.key
        if not self.bore:
            yield Message("Fit of the bore: not stated; choose it with the shaft.")
        if isinstance(key, Keyway) and not self.key_class(key.width) and not self.clearance:
            yield Message("Fit of the keyway: not stated; choose it with the key.")
        if isinstance(key, DFlat) and not self.flat_class and not self.clearance:
            yield Message("Fit across the flat: not stated; choose it with the shaft.")
        if self.clearance:
            part = Message("key") if self.joint == ShaftJoint.KEYED else Message("D-shaft")
            least, most = self.clearance
            yield Message("Clearance of the {part}: {least:g} to {most:g} µm.", part=part, least=least, most=most)
        elif self.joint == ShaftJoint.GLUED and blank.hub and blank.hub.set_screw:
            yield Message("On its shaft without play: glued; the set screw holds it until the adhesive is hard.")
        elif self.joint in TIGHT:
            yield Message("On its shaft without play: {joint}.", joint=TIGHT[self.joint])

    def thread_note(self, *, drawn: bool) -> Iterator[Message]:
        """Sentence on the thread of a set screw that no dimension names.

        Args:
            drawn: whether a dimension names it.
        """
        if not self.thread:
            yield Message("Thread of the set screw: not stated; choose it with the screw.")
        elif not drawn:
            yield Message("Hole of the set screw tapped {thread}.", thread=self.thread)


def deeper(width: float) -> float:
    """Upper deviation of the depth of a hub's keyway or a shaft's seat, mm; the lower one is 0.

    Args:
        width: width of the key, mm.
    """
    return _up_to(width, _DEEPER)


def longer(length: float) -> float:
    """Upper deviation of the length of a key's seat in a shaft (DIN 6885-1), mm; the lower one is 0.

    Args:
        length: length of the seat, mm.
    """
    return _up_to(length, _LONGER)


def fillet(width: float) -> float:
    """Greatest radius of the corners at the floor of a keyway, by the chamfer of its key (DIN 6885-1), mm.

    Args:
        width: width of the key, mm.
    """
    return _up_to(width, _FILLETS)


def off_middle(width: float) -> float:
    """Width of the zone in which the middle of a keyway or seat lies about the axis, mm.

    DIN 6885-1 states none. GB/T 1095 takes grades 7 to 9 of GB/T 1184, of which this is 8.

    Args:
        width: width of the key, mm.
    """
    return _up_to(width, _SYMMETRY)


def _up_to(size: float, steps: _Steps) -> float:
    return next(value for greatest, value in steps if size <= greatest)


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


def shaft_class(fit: str) -> str:
    """Class of the shaft of a fit, `g6` of `H7/g6`."""
    *_, letter, grade = zones_of(fit)
    return f"{letter}{grade}"


def _after(named: str) -> str:
    return f" {named}" if named else ""


def limited(size: float, named: str) -> str:
    """Class of a size and its limit deviations as they follow the size (ISO 129-1), such as ` H7 (+0.015/0)`.

    Args:
        size: size that its zone goes by, mm.
        named: class of a hole or shaft; empty for none.
    """
    if not named:
        return ""
    hole, shaft = deviations(f"{named}/h6" if named[0].isupper() else f"H7/{named}", size)
    return f" {named} ({limits(*(hole if named[0].isupper() else shaft))})"
