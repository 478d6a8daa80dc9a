"""Tools that cut teeth: what they cannot reach, and what they need beyond teeth which stand beside a larger gear.

A gear is blocked where its neighbour stands higher than its roots, by h = r_beside − r_root. A hob or a disc cutter of
the diameter D cuts to full depth at the end of the teeth only if its axis comes as far, and then reaches beyond by

    √(h (D − h)), h ≤ D / 2, of a spur gear.

Turned by the helix angle β it reaches √(h (D − h)) cos β + l sin β. A hob generates with the half length
l = h_fP / tan α_n. This is the least: a longer hob and its own lead need more. Usual diameters are those of DIN 8002.

A shaper's cutter needs a groove for its overtravel and the chips, usually 3 mm and 1 mm for each mm of the module: a
value of the trade, since no standard was at hand. A wire, a laser or a jet cuts straight through the whole width: no
teeth beside a larger gear, and no helical ones. What is printed or moulded needs no room.

Hobs and disc cutters work from outside: inside teeth are shaped, broached, cut by a wire, or printed. Both halves of a
double helix meet without a groove, where a hob or a disc cutter would have to run out.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, cos, inf, sin, sqrt, tan

from cadgen.gears.choices import ToothCutting
from cadgen.gears.stage import Wheel, is_ring
from cadgen.gears.tooth import GearForm
from cadgen.messages import Message
from cadgen.parts.blank import Blank

# Greatest module and diameter of a hob, mm (DIN 8002, read from a damaged print; the last by judgement).
_HOBS = (
    (1.4, 50.0), (1.8, 56.0), (2.24, 63.0), (2.8, 70.0), (3.55, 80.0), (4.5, 90.0), (5.6, 100.0), (7.1, 110.0),
    (9.0, 125.0), (inf, 140.0),
)  # fmt: skip
SMALL_HOB = 20.0  # mm, of hobs for fine modules
_GROOVE = 3.0  # mm; a shaper's cutter needs this and a module
# A bound of plausibility, in modules: the teeth of a tool, 2.25 modules high, take no more than half of its radius.
LEAST_CUTTER = 9.0
_STEPS = 10  # in a mm, of lengths that are proposed
ROTATING = (ToothCutting.HOBBED, ToothCutting.MILLED)


@dataclass(frozen=True, slots=True)
class Tool:
    """How teeth are cut, and by what.

    Attributes:
        cutting: how they are cut.
        diameter: diameter of the hob or the disc cutter, mm; None for the usual one.
    """

    cutting: ToothCutting
    diameter: float | None = None

    def run_out(self, gear: GearForm, beside: float) -> float:
        """Least room that the teeth of a gear need before a larger diameter, mm; infinite by a wire.

        Args:
            gear: gear that is cut.
            beside: diameter that stands before its teeth, mm.
        """
        match self.cutting:
            case ToothCutting.PRINTED:
                return 0.0
            case ToothCutting.WIRE:
                return inf
            case ToothCutting.SHAPED:
                return _GROOVE + gear.normal_module
        diameter = usual_hob(gear.normal_module) if self.diameter is None else self.diameter
        height = min((beside - gear.root_diameter) / 2, diameter / 2)
        turned = abs(gear.helix_angle)
        reach = gear.dedendum_factor * gear.normal_module / tan(gear.normal_pressure_angle)
        return sqrt(height * (diameter - height)) * cos(turned) + reach * sin(turned)

    def between(self, lower: Wheel, upper: Wheel) -> float:
        """Least length of a collar between two gears that lets the tool cut both, mm; 0 where no length does.

        Args:
            lower: gear at the bottom.
            upper: gear on top.
        """
        needed = [self.run_out(gear, other.tip_diameter) for gear, other in beside_larger(lower, upper)]
        return proposed_length(max((each for each in needed if each < inf), default=0.0))

    def cannot_reach(self, gear: GearForm) -> Message | None:
        """Sort of teeth of a gear by itself that the tool cannot cut; None where it can.

        Args:
            gear: gear that is cut.
        """
        if is_ring(gear) and self.cutting in ROTATING:
            return Message("inside teeth")
        if gear.double and self.cutting in (*ROTATING, ToothCutting.WIRE):
            return Message("teeth of a double helix")
        if gear.helix_angle and self.cutting == ToothCutting.WIRE:
            return Message("helical teeth")
        return None


@dataclass(frozen=True, slots=True, kw_only=True)
class CutBlank(Blank):
    """Blank of gears of which it is stated how they are cut.

    Attributes:
        tool: how the teeth are cut: where no collar is stated, one between two gears leaves room for it. None where the
            design does not say.
        apart: whether two gears on a shaft are cut as two parts and joined.
    """

    tool: Tool | None = None
    apart: bool = False


def usual_hob(module: float) -> float:
    """Diameter of a hob of DIN 8002, mm; of modules below 1 smaller ones are sold, too.

    Args:
        module: normal module, mm.
    """
    return next(diameter for most, diameter in _HOBS if module <= most)


def beside_larger(lower: Wheel, upper: Wheel) -> list[tuple[GearForm, Wheel]]:
    """Gears of two on a part that stand beside a larger one, each with that.

    Args:
        lower: gear at the bottom.
        upper: gear on top.
    """
    pairs = ((lower, upper), (upper, lower))
    return [(a, b) for a, b in pairs if isinstance(a, GearForm) and b.tip_diameter > a.root_diameter]


def proposed_length(length: float) -> float:
    """Length of a collar in whole tenths that is at least so long, mm.

    Args:
        length: least length, mm.
    """
    return ceil(length * _STEPS - 1e-9) / _STEPS
