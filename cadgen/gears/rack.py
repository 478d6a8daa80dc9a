"""Racks: a straight bar of teeth that a pinion rolls on, spur or helical, and the pair of both.

The profile stands in the normal section: straight flanks at the pressure angle, and at the root a fillet of the basic
rack's tip radius. In the transverse section lengths along the pitch line are stretched by 1 / cos β.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import ceil, cos, degrees, pi, radians, sin, sqrt, tan

from cadgen.errors import DesignError
from cadgen.gears.pair import SAME_HELIX, Backlash, hand_of
from cadgen.gears.tooth import LEAST_THICKNESS, PRESSURE_ANGLE_RANGE, STEEPEST_HELIX, GearForm, tooth_of
from cadgen.parts.body import Body, Slab
from cadgen.parts.loop import Arc, Curve, EllipseArc, Loop, Segment
from cadgen.parts.run import HelixRun

# Wall behind the roots, in modules, where no height is given.
USUAL_BACK = 2.0
_PIN_STEP = 0.25  # mm, of pins that are sold


@dataclass(frozen=True, slots=True, kw_only=True)
class RackForm:
    """Numbers of a rack: lengths in mm, angles in rad, factors in modules.

    Attributes:
        teeth: number of whole teeth.
        normal_module: module of the normal section.
        width: width of the face, across the travel.
        height: from the back to the reference line; None for 2 modules behind the roots.
        normal_pressure_angle: pressure angle of the normal section.
        helix_angle: β, positive for a right-hand helix; a pinion has the other hand.
        addendum_factor, dedendum_factor: height of tips and depth of roots over and under the reference line.
        fillet_factor: radius of the roots.
        tooth_thickness_deviation: deviation E_sn of the normal tooth thickness.

    Raises:
        DesignError: a number out of its range, or teeth without land, space or back.
    """

    teeth: int
    normal_module: float
    width: float
    height: float | None = None
    normal_pressure_angle: float = radians(20.0)
    helix_angle: float = 0.0
    addendum_factor: float = 1.0
    dedendum_factor: float = 1.25
    fillet_factor: float = 0.38
    tooth_thickness_deviation: float = 0.0

    def __post_init__(self) -> None:
        for name in ("teeth", "normal_module", "width", "addendum_factor", "dedendum_factor"):
            if not 0 < getattr(self, name) < float("inf"):
                raise DesignError(
                    "the rack has {name} = {value:g}; give a number above 0", name=name, value=getattr(self, name)
                )
        low, high = PRESSURE_ANGLE_RANGE
        if not low <= self.normal_pressure_angle <= high:
            raise DesignError(
                "the rack has a pressure angle of {angle:g}°; give {low:g}° to {high:g}°",
                angle=degrees(self.normal_pressure_angle),
                low=degrees(low),
                high=degrees(high),
            )
        if not abs(self.helix_angle) <= STEEPEST_HELIX:
            raise DesignError(
                "the rack has a helix angle of {angle:g}°; give at most {most:g}°",
                angle=degrees(abs(self.helix_angle)),
                most=degrees(STEEPEST_HELIX),
            )
        least = LEAST_THICKNESS * self.normal_module
        if self.land < least:
            raise DesignError(
                "the rack has a tip land of {land:.4g} mm; give a smaller addendum_factor than {addendum:g}",
                land=self.land,
                addendum=self.addendum_factor,
            )
        if not 0 < self.fillet_factor <= self.largest_fillet:
            raise DesignError(
                "the rack has a fillet of {radius:g} modules; give more than 0 and at most {largest:.4f}",
                radius=self.fillet_factor,
                largest=int(self.largest_fillet * 1e4) / 1e4,
            )
        if not self.back >= least:
            raise DesignError(
                "the rack has {back:.4g} mm behind its roots; give a height_mm of at least {height:.4g}",
                back=self.back,
                height=self.dedendum_factor * self.normal_module + least,
            )

    @property
    def land(self) -> float:
        """Width of the tips in the normal section, mm."""
        half = pi * self.normal_module / 4 + self.tooth_thickness_deviation / 2
        return 2 * (half - self.addendum_factor * self.normal_module * tan(self.normal_pressure_angle))

    @property
    def largest_fillet(self) -> float:
        """Greatest radius of the roots that has room between the flanks, in modules."""
        angle, module = self.normal_pressure_angle, self.normal_module
        half = pi / 4 - self.tooth_thickness_deviation / 2 / module - self.dedendum_factor * tan(angle)
        return half * cos(angle) / (1 - sin(angle))

    @property
    def back(self) -> float:
        """Wall behind the roots, mm."""
        return self.back_height - self.dedendum_factor * self.normal_module

    @property
    def back_height(self) -> float:
        """Distance of the back from the reference line, mm."""
        return (self.dedendum_factor + USUAL_BACK) * self.normal_module if self.height is None else self.height

    @property
    def pitch(self) -> float:
        """Transverse pitch, mm."""
        return pi * self.normal_module / cos(self.helix_angle)

    @property
    def length(self) -> float:
        """Length of the bar, mm."""
        return self.teeth * self.pitch

    @property
    def pin_diameter(self) -> float:
        """Pin that rests on the flanks a little over the reference line, in steps of a quarter of a millimetre, mm."""
        ideal = pi * self.normal_module / 2 / cos(self.normal_pressure_angle)
        return ceil(ideal / _PIN_STEP - 1e-9) * _PIN_STEP if ideal > _PIN_STEP else ideal

    def over_pin(self, deviation: float) -> float:
        """Height from the back over a pin in a space: h + (d / (2 cos α) − e / 2) / tan α + d / 2, mm.

        Args:
            deviation: deviation of the normal tooth thickness, which narrows the space e, mm.
        """
        angle, pin = self.normal_pressure_angle, self.pin_diameter
        half = pi * self.normal_module / 4 - deviation / 2
        return self.back_height + (pin / 2 / cos(angle) - half) / tan(angle) + pin / 2

    @property
    def fillet_width(self) -> float:
        """Half the flat between two fillets in the normal section, mm."""
        angle, radius = self.normal_pressure_angle, self.fillet_factor * self.normal_module
        half = pi * self.normal_module / 4 - self.tooth_thickness_deviation / 2
        return half - self.dedendum_factor * self.normal_module * tan(angle) - radius * (1 - sin(angle)) / cos(angle)

    def corners(self) -> list[tuple[complex, complex, complex, complex, complex, complex]]:
        """Corners of each tooth in the transverse section.

        They are the end of the fillet before it on the root line, the ends of both flanks, from left to right, and the
        like on the right: x along the bar, y from the reference line, mm.
        """
        module, angle, stretch = self.normal_module, self.normal_pressure_angle, 1 / cos(self.helix_angle)
        radius = self.fillet_factor * module
        root, deep = -self.dedendum_factor * module, -self.dedendum_factor * module + radius * (1 - sin(angle))
        outer = pi * module / 2 - self.fillet_width
        low = outer - radius * cos(angle)
        half = [complex(outer, root), complex(low, deep), complex(self.land / 2, self.addendum_factor * module)]
        found = []
        for number in range(self.teeth):
            middle = (number + 0.5) * pi * module
            tooth = [
                *(complex(middle - each.real, each.imag) for each in half),
                *(middle + each for each in half[::-1]),
            ]
            found.append(tuple(complex(each.real * stretch, each.imag) for each in tooth))
        return found  # type: ignore[return-value]

    @property
    def outline(self) -> Loop:
        """Transverse section at the lower face: the reference line on x from 0 on, the teeth towards y.

        Fillets are circles in the normal section, and ellipses in the transverse one of a helical rack.
        """
        radius, stretch = self.fillet_factor * self.normal_module, 1 / cos(self.helix_angle)
        turn = pi / 2 - self.normal_pressure_angle

        def fillet(foot: complex, start: float) -> Curve:
            # Hollow, so it is run clockwise.
            centre = foot + 1j * radius
            if stretch == 1:
                return Arc(radius, start, -turn, centre)
            return EllipseArc((radius * stretch, radius), start, -turn, centre)

        root, back = -self.dedendum_factor * self.normal_module, -self.back_height
        curves: list[Curve] = []
        at = complex(self.length, root)
        for start, deep, left, right, low, end in self.corners()[::-1]:
            curves += [Segment(at, end), fillet(end, -pi / 2), Segment(low, right), Segment(right, left)]
            curves += [Segment(left, deep), fillet(start, turn - pi / 2)]
            at = start
        corners = [at, complex(0.0, root), complex(0.0, back), complex(self.length, back), complex(self.length, root)]
        curves += [Segment(*ends) for ends in pairwise(corners)]
        # On the side of a rack that looks away from its pinion, a right-hand helix leans to the left as z grows.
        return Loop(tuple(curves), run=HelixRun(lean=-tan(self.helix_angle)))

    @property
    def body(self) -> Body:
        """The bar, its lower face at z = 0."""
        return Body((Slab(0.0, self.width, (self.outline,)),))

    @property
    def area(self) -> float:
        """Area of the transverse section, mm²."""
        return self.outline.area


@dataclass(frozen=True, slots=True, kw_only=True)
class RackMesh:
    """A pinion on a rack.

    Attributes:
        pinion: numbers of the pinion, as cut.
        rack: numbers of the rack, as cut.
        distance: of the pinion's axis from the rack's reference line, mm.

    Raises:
        DesignError: gears of different modules, pressure or helix angles, or of one hand; or teeth that jam or do not
            meet.
    """

    pinion: GearForm
    rack: RackForm
    distance: float

    def __post_init__(self) -> None:
        pinion, rack = self.pinion, self.rack
        if pinion.side < 0 or pinion.double:
            raise DesignError("a rack needs a pinion with teeth outside, of one helix; leave internal and double out")
        if pinion.normal_module != rack.normal_module or pinion.normal_pressure_angle != rack.normal_pressure_angle:
            raise DesignError("pinion and rack differ in module or pressure angle; give both the same")
        if abs(pinion.helix_angle + rack.helix_angle) > SAME_HELIX:
            raise DesignError(
                "pinion and rack have the helix angles {one:g}° and {other:g}°, and hands are opposite; give the rack "
                '{wanted:g}° and hand = "{hand}"',
                one=degrees(pinion.helix_angle),
                other=degrees(rack.helix_angle),
                wanted=degrees(abs(pinion.helix_angle)),
                hand=hand_of(-pinion.helix_angle),
            )
        if not self.backlash.pitch >= -1e-9:
            raise DesignError(
                "pinion and rack jam at a distance_mm of {distance:g}; give at least {least:.4f}",
                distance=self.distance,
                least=self.distance - self.backlash.pitch / (2 * tan(pinion.transverse_pressure_angle)) + 5e-5,
            )
        reach = pinion.tip_diameter / 2 + rack.addendum_factor * rack.normal_module
        if not self.distance < reach:
            raise DesignError(
                "pinion and rack do not meet at a distance_mm of {distance:g}; give less than {reach:.4f}",
                distance=self.distance,
                reach=reach,
            )

    @property
    def backlash(self) -> Backlash:
        """Play under its four names; that on the pitch line is 2 (h − r − x m_n) tan α_t − ΣE_sn / cos β.

        The angle of the driven gear is 0, for a rack does not turn.
        """
        pinion = self.pinion
        alpha = pinion.transverse_pressure_angle
        out = self.distance - pinion.reference_diameter / 2 - pinion.profile_shift * pinion.normal_module
        thin = pinion.tooth_thickness_deviation + self.rack.tooth_thickness_deviation
        line = 2 * out * tan(alpha) - thin / cos(pinion.helix_angle)
        base = line * cos(alpha)
        return Backlash(
            base=base,
            normal=base * cos(pinion.base_helix_angle),
            pitch=line,
            driver_angle=base / (pinion.base_diameter / 2),
            driven_angle=0.0,
        )

    @property
    def contact_ratio(self) -> float:
        """Transverse contact ratio ε_α, as cut."""
        start, end = self._contact
        return max(end - start, 0.0)

    @property
    def pitches_touched(self) -> tuple[int, int]:
        """Numbers of pitches whose errors close and open the play: greatest way between teeth touched on two flanks.

        A flank of a tooth is touched while its middle is from a to b pitches off the pitch point, the other one from −b
        to −a. Two teeth touched on two flanks are up to 2 max(|a|, |b|) apart. Where no tooth at times is touched on
        both, 2 min(b, −a) < 1, a pinion's tooth between two of the rack may have a wider space.
        """
        start, end = (each + 0.25 for each in self._contact)  # a flank stands a quarter of a pitch off the middle
        return int(2 * max(abs(start), abs(end))), int(2 * min(end, -start) < 1)

    @property
    def _contact(self) -> tuple[float, float]:
        """Start and end of the contact from the pitch point, in pitches."""
        pinion, rack = self.pinion, self.rack
        alpha, base = pinion.transverse_pressure_angle, pinion.base_diameter / 2
        # Distances along the line of action from its foot on the base circle: of the rack's tip and flank end.
        tip = self.distance - rack.addendum_factor * rack.normal_module
        radius = rack.fillet_factor * rack.normal_module
        deep = rack.dedendum_factor * rack.normal_module - radius * (1 - sin(rack.normal_pressure_angle))
        ends = [(height - base * cos(alpha)) / sin(alpha) for height in (tip, self.distance + deep)]
        form, outer = (
            sqrt(max((diameter / 2) ** 2 - base**2, 0.0))
            for diameter in (tooth_of(pinion).root_form_diameter, pinion.tip_form_diameter)
        )
        foot = base * tan(alpha)
        start, end = max(form, ends[0], 0.0), min(outer, ends[1])
        return (start - foot) / (rack.pitch * cos(alpha)), (end - foot) / (rack.pitch * cos(alpha))

    @property
    def travel(self) -> float:
        """Travel of the rack for one turn of the pinion, π d, mm."""
        return pi * self.pinion.reference_diameter

    @property
    def reach(self) -> float:
        """Greatest travel for which the whole contact stays on the rack's teeth, mm."""
        pinion = self.pinion
        alpha = pinion.transverse_pressure_angle
        contact = self.contact_ratio * self.rack.pitch * cos(alpha) ** 2
        return max(self.rack.length - contact - self.rack.pitch, 0.0)
