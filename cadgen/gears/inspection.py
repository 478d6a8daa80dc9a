"""Inspection dimensions for the shop: span over k teeth and size over two pins or balls, with their limits.

Formulas of ISO 21771-1 / DIN 21773. The span of an internal gear is over k spaces, and its balls lie between the teeth
of the ring. Flats touch a helical gear along a line that leans by β_b, so that the face must be W sin β_b wide at
least; a helical gear with an odd number of teeth is measured over balls, since pins would not lie across each other.
The limits follow from those of the tooth-thickness deviation, E_sns (upper) and E_sni (lower), by computing the whole
gear at each limit, so nothing is linearised.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, atan, ceil, cos, hypot, inf, pi, sin, tan

from scipy.optimize import brentq

from cadgen.errors import DesignError
from cadgen.figures import Figures
from cadgen.gears.tooth import GearForm, Tooth, involute, tooth_of
from cadgen.messages import Message

LEAST_TEETH_SPANNED = 2
# Radial place of the pins' contact against the circle d + 2 x m_n, in modules (DIN 3977).
PIN_CONTACT_RANGE = (-0.1, 0.5)
# Plug gauges come in sets by 0.1 mm and singly by 0.01 mm (DIN 2269), in mm; the coarser step is tried first.
PIN_STEPS = (0.1, 0.01)
# Pins tried above the ideal one, per step.
PINS_TRIED = 12


@dataclass(frozen=True, slots=True)
class SizeLimits:
    """A dimension in mm at E_sn = 0 (`nominal`), at E_sns (`upper`) and at E_sni (`lower`)."""

    nominal: float
    upper: float
    lower: float

    @property
    def by_size(self) -> tuple[float, float]:
        """Greatest and least size, mm: thin teeth of a ring make its sizes larger."""
        return max(self.upper, self.lower), min(self.upper, self.lower)


@dataclass(frozen=True, slots=True)
class SpanMeasurement:
    """Span W_k over `teeth_spanned` teeth; its flats touch on `contact_diameter` (mm, at the upper limit).

    The face must be at least `width_needed` (mm) wide for it: W sin β_b.
    """

    teeth_spanned: int
    span: SizeLimits
    contact_diameter: float
    width_needed: float = 0.0


@dataclass(frozen=True, slots=True)
class PinMeasurement:
    """Size M_d over two pins or balls, which touch the flanks on `contact_diameter` (mm, at the upper limit)."""

    pin_diameter: float
    over_pins: SizeLimits
    contact_diameter: float


@dataclass(frozen=True, slots=True)
class Gauge:
    """Names of what lies in two opposite spaces of a gear: pins of a spur gear, balls of a helical one and of a ring.

    Attributes:
        size: code of the size over them.
        size_name: name of that size.
        diameter: code of their diameter.
        diameter_name: name of that diameter.
    """

    size: str
    size_name: Message
    diameter: str
    diameter_name: Message


_PINS = Gauge("over_pins", Message("size over pins"), "pin_diameter", Message("pin diameter"))
_BALLS = Gauge("over_balls", Message("size over balls"), "ball_diameter", Message("ball diameter"))
_INSIDE = Gauge("between_balls", Message("size between balls"), "ball_diameter", Message("ball diameter"))


def gauge_of(form: GearForm) -> Gauge:
    """Names of what a gear is measured with."""
    return _INSIDE if form.side < 0 else _BALLS if form.helix_angle else _PINS


def gauge_in(figures: Figures) -> Gauge:
    """Names of what the gear of these figures is measured with; pins for a wheel without teeth."""
    return next((gauge for gauge in (_INSIDE, _BALLS) if f"{gauge.size}_max" in figures), _PINS)


@dataclass(frozen=True, slots=True)
class Inspection:
    """Sizes that the shop measures on a gear; None where the flanks are too short for that measurement.

    `span_needs` is the least face width, mm, for a span where the face is too narrow for any; else None.
    """

    span: SpanMeasurement | None
    pins: PinMeasurement | None
    span_needs: float | None = None


def inspection_of(
    form: GearForm, upper_deviation: float, lower_deviation: float, pin_diameter: float | None = None
) -> Inspection:
    """Inspection dimensions of `form` between E_sns = `upper_deviation` and E_sni = `lower_deviation` (mm).

    `pin_diameter` (mm) is chosen if it is not given. Raises `DesignError` for limits in the wrong order, for
    a tooth that cannot be cut at a limit, and for a given pin that does not rest on the flanks.

    Args:
        form: numbers of the teeth.
        upper_deviation: upper limit E_sns of the tooth thickness, mm.
        lower_deviation: lower limit E_sni, mm.
        pin_diameter: diameter of the pins, mm; chosen if left out.
    """
    if lower_deviation > upper_deviation:
        raise DesignError(
            "{gear} has E_sni = {lower:g} µm above E_sns = {upper:g} µm; exchange them",
            gear=str(form),
            lower=lower_deviation * 1e3,
            upper=upper_deviation * 1e3,
        )
    limits = (
        tooth_of(form.cut_to(upper_deviation)),
        tooth_of(form.cut_to(lower_deviation)),
    )
    span, needed = _span_measurement(limits)
    if pin_diameter is None:
        return Inspection(span, _chosen_pins(limits), needed)
    pins = _pin_measurement(limits, pin_diameter)
    if pins is None:
        raise DesignError(
            "{gear} cannot be measured over pins of {pin:g} mm, which do not rest on its flanks; give "
            "about {ideal:.3g} mm",
            gear=str(form),
            pin=pin_diameter,
            ideal=ideal_pin_diameter(form),
        )
    return Inspection(span, pins, needed)


def span_over(form: GearForm, teeth_spanned: int) -> float:
    """Span W_k = m_n cos α_n [π(k − ½) + z inv α_t] ± 2 x_E m_n sin α_n in mm, as cut; minus for an internal gear."""
    angle = form.normal_pressure_angle
    bracket = pi * (teeth_spanned - 0.5) + form.teeth * involute(form.transverse_pressure_angle)
    shift = 2 * form.side * form.generating_profile_shift * sin(angle)
    return form.normal_module * (cos(angle) * bracket + shift)


def size_over_pins(form: GearForm, pin_diameter: float) -> float:
    """Size M_d over two pins in mm, as cut: d_K + D_M, times cos(π/2z) on d_K for an odd number of teeth.

    The pin's centre lies on d_K = d_b / cos α_K with inv α_K = D_M / (d_b cos β_b) − (π/z − ψ_b); ψ_b is half the angle
    of the tooth on the base circle. Between the teeth of a ring it is d_K − D_M, with inv α_K = η_b − D_M / (d_b cos
    β_b), η_b half the angle of the space. Raises `DesignError` if the pin is too thin or too thick for the flanks.

    Args:
        form: numbers of the teeth.
        pin_diameter: diameter D_M of the pins, mm.
    """
    across = 1.0 if form.teeth % 2 == 0 else cos(pi / (2 * form.teeth))
    return form.base_diameter / cos(_pin_angle(form, pin_diameter)) * across + form.side * pin_diameter


def ideal_pin_diameter(form: GearForm) -> float:
    """The pin D_M in mm that touches the flanks on the circle d + 2 x m_n, as cut; of a ring, on d − 2 x m_n.

    There the pressure angle is α_v and half a space takes the angle η_v = π/z − ψ_v; the normals of both flanks touch
    the base circle and meet on the middle of the space, so D_M = d_b [tan(α_v + η_v) − tan α_v] for an external spur
    gear. Of others, contact and centre of the pin make one equation that is solved here.
    """
    diameter = max(_reference_with_shift(form), form.base_diameter)
    angle = acos(form.base_diameter / diameter)
    if form.side > 0 and form.helix_angle == 0:
        space = pi / form.teeth - form.half_angle(diameter)
        return form.base_diameter * (tan(angle + space) - tan(angle))
    lean = cos(form.base_helix_angle)

    def past(share: float) -> float:
        centre = max(tan(angle) + form.side * share * lean, 0.0)
        return centre - atan(centre) - _involute_at_centre(form, share * form.base_diameter)

    low, high = 0.0, 2 * pi / form.teeth
    while past(low) * past(high) > 0 and high < 2.0:
        high *= 1.5
    return form.base_diameter * float(brentq(past, low, high)) if past(low) * past(high) <= 0 else form.normal_module


def _reference_with_shift(form: GearForm) -> float:
    return form.reference_diameter + 2 * form.side * form.profile_shift * form.normal_module


def _involute_at_centre(form: GearForm, pin_diameter: float) -> float:
    """Involute function inv α_K at the centre of a pin; 0 or less where it finds no place."""
    # Half the angle of a space on the base circle; negative where the teeth overlap there.
    space = form.base_half_angle if form.side < 0 else pi / form.teeth - form.base_half_angle
    return form.side * (pin_diameter / form.base_diameter / cos(form.base_helix_angle) - space)


def _pin_angle(form: GearForm, pin_diameter: float) -> float:
    """Pressure angle α_K at the centre of a pin, in rad."""
    value = _involute_at_centre(form, pin_diameter)
    if value <= 0:
        raise DesignError(
            "{gear} cannot be measured over pins of {pin:g} mm, which drop into its spaces; give about {ideal:.3g} mm",
            gear=str(form),
            pin=pin_diameter,
            ideal=ideal_pin_diameter(form),
        )
    return float(brentq(lambda angle: involute(angle) - value, 0.0, pi / 2 - 1e-9, xtol=1e-15))


def _usable(tooth: Tooth, contact_diameter: float) -> bool:
    low, high = sorted((tooth.root_form_diameter, tooth.form.tip_form_diameter))
    return low < contact_diameter < high


def _span_measurement(limits: tuple[Tooth, Tooth]) -> tuple[SpanMeasurement | None, float | None]:
    """Span that touches nearest to the circle d + 2 x m_n, on the usable flanks at both limits.

    The second value is the least face width, mm, that a span needs where the face is too narrow for all.
    """
    upper, lower = limits[0].form, limits[1].form
    lean, room = cos(upper.base_helix_angle), upper.width / (2 if upper.double else 1)
    best, least = None, inf
    for count in range(LEAST_TEETH_SPANNED, upper.teeth):
        spans = SizeLimits(span_over(upper.cut_to(0.0), count), span_over(upper, count), span_over(lower, count))
        contacts = [hypot(upper.base_diameter, span * lean) for span in (spans.upper, spans.lower)]
        needed = spans.upper * sin(abs(upper.base_helix_angle))
        if not all(_usable(tooth, contact) for tooth, contact in zip(limits, contacts, strict=True)):
            continue
        least = min(least, needed * (2 if upper.double else 1))
        if needed <= room:
            candidate = SpanMeasurement(count, spans, contacts[0], needed)
            if best is None or _from_middle(upper, contacts[0]) < _from_middle(upper, best.contact_diameter):
                best = candidate
    return best, least if best is None and least < inf else None


def _from_middle(form: GearForm, contact_diameter: float) -> float:
    return abs(contact_diameter - _reference_with_shift(form))


def _pin_measurement(limits: tuple[Tooth, Tooth], pin_diameter: float) -> PinMeasurement | None:
    """The measurement over pins of that size, or None if at a limit they do not rest on the flanks.

    They must touch on the usable flanks, stand out over the tip circle and clear the root circle.
    """
    contacts = []
    for tooth in limits:
        form = tooth.form
        if _involute_at_centre(form, pin_diameter) <= 0:
            return None
        angle, side = _pin_angle(form, pin_diameter), form.side
        centre = form.base_diameter / cos(angle)
        roll = tan(angle) - side * pin_diameter * cos(form.base_helix_angle) / form.base_diameter
        contacts.append(form.base_diameter * hypot(1.0, roll))
        rests = roll > 0 and _usable(tooth, contacts[-1])
        clear = side * (centre - form.root_diameter) > pin_diameter
        if not rests or not (clear and side * (centre - form.tip_diameter) > -pin_diameter):
            return None
    upper, lower = limits[0].form, limits[1].form
    if _involute_at_centre(upper.cut_to(0.0), pin_diameter) <= 0:
        return None
    sizes = [size_over_pins(form, pin_diameter) for form in (upper.cut_to(0.0), upper, lower)]
    return PinMeasurement(pin_diameter, SizeLimits(*sizes), contacts[0])


def _chosen_pins(limits: tuple[Tooth, Tooth]) -> PinMeasurement | None:
    """The first pin from the ideal one upwards that rests on the flanks within `PIN_CONTACT_RANGE`."""
    form = limits[0].form
    low, high = sorted(
        _reference_with_shift(form) + 2 * form.side * place * form.normal_module for place in PIN_CONTACT_RANGE
    )
    for step in PIN_STEPS:
        first = ceil(ideal_pin_diameter(form) / step)
        for count in range(first, first + PINS_TRIED):
            pins = _pin_measurement(limits, round(count * step, 3))
            if pins and low <= pins.contact_diameter <= high:
                return pins
    return None
