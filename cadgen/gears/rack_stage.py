"""Pinion and rack as the last stage of a train; the output counts as the turn of the pinion that gives the travel.

The rack stands at its distance from the pinion's axis, in the direction of the stage, with its middle beside that axis.
Its play along the pitch line is 2 (h − r − x m_n) tan α_t − ΣE_sn / cos β; over the pinion's reference radius it is an
angle, which is how the train adds it up.

ISO 1328-1 is of gears alone. Pitch, profile and helix of a rack are held as those of a gear of as many teeth: its
circle π d rolled out is the rack's length, so d = z m_t, and a cumulative deviation goes by the length.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil, cos, degrees, hypot, pi, tan
from typing import Self

import numpy as np

from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.figures import Facts, Figure, Figures
from cadgen.gears.backlash import gear_tolerances_of
from cadgen.gears.choices import Law
from cadgen.gears.contact import missing_shift
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.inspection import inspection_of
from cadgen.gears.pair import Backlash, GradedGear
from cadgen.gears.rack import RackForm, RackMesh
from cadgen.gears.spur import (
    PlayState,
    cycle_checks,
    freedom_checks,
    gear_figures,
    measured_check,
    room_checks,
)
from cadgen.gears.stage import LEAST_OVERLAP, Engage, Stage, Wheel, cycle
from cadgen.gears.tolerances import centre_distance_deviation, flank_tolerance
from cadgen.gears.tooth import tooth_of
from cadgen.messages import Message
from cadgen.parts.loop import Loop

# Backlash that is left at the least play within the tolerances where none is given, mm, and its steps.
LEFT_BACKLASH = 0.01


@dataclass(frozen=True, slots=True)
class Bar:
    """Rack as a wheel of a stage; its own frame is that of `RackForm.outline`, mm."""

    form: RackForm

    def __str__(self) -> str:
        return Message("the rack of {teeth} teeth", teeth=self.form.teeth)

    @property
    def noun(self) -> str:
        """Name of its body in messages."""
        return str(self)

    @property
    def width(self) -> float:
        """Width across the travel, mm."""
        return self.form.width

    @property
    def bar(self) -> RackForm:
        """Numbers of the rack: it is no body of revolution."""
        return self.form

    @property
    def tip_diameter(self) -> float:
        """Diameter of the circle about the middle of its reference line that holds its teeth, mm."""
        return hypot(self.form.length, 2 * self.form.addendum_factor * self.form.normal_module)

    @property
    def root_diameter(self) -> float:
        """Diameter of the circle about the middle of its reference line that its roots leave whole, mm: none."""
        return 0.0

    @property
    def least_rim(self) -> float:
        """Least wall, mm."""
        return 0.0

    @property
    def outline(self) -> Loop:
        """Section at its lower face."""
        return self.form.outline

    @property
    def usual_chord(self) -> float:
        """Greatest chord error of its mesh where none is given, mm."""
        return 2e-3 * self.form.normal_module


@dataclass(frozen=True, slots=True, kw_only=True)
class RackPlay:
    """Play of a rack stage as an angle of the pinion, rad, and its contributions.

    Attributes:
        B_min, B_max: least and greatest.
        contributions: contributions along the rack, mm.
    """

    B_min: float
    B_max: float
    contributions: ZoneSum

    def distribution(self, law: Law = Law.NORMAL) -> ZoneSum:
        """Independent contributions to the play along the rack, mm."""
        return replace(self.contributions, law=law)


@dataclass(frozen=True, slots=True, kw_only=True)
class RackStage(Stage):
    """Pinion and rack as a stage; lengths in mm, angles in rad.

    Attributes:
        pinion: pinion, as cut.
        rack: numbers of the rack, as cut.
        centre_distance: distance of the pinion's axis from the rack's reference line.
        bearing_span: between the bearings of the pinion's shaft.
        rack_zone: width of the zone of the rack's thickness.
        rack_grade: tolerance grade of the rack; None for none.
        distance_deviation_given: deviation of the distance; None for the standard's.
        travel: travel that the rack must allow; None for as far as it reaches.
    """

    pinion: GradedGear
    rack: RackForm
    centre_distance: float
    bearing_span: float
    rack_zone: float
    rack_grade: int | None = None
    distance_deviation_given: float | None = None
    travel: float | None = None

    @property
    def mesh(self) -> RackMesh:
        """Pinion on the rack."""
        return RackMesh(pinion=self.pinion.form, rack=self.rack, distance=self.centre_distance)

    @property
    def noun(self) -> str:
        """Pinion and rack."""
        return Message("a pinion and a rack")

    @property
    def sense(self) -> int:
        """+1: the output is the pinion's own turn."""
        return 1

    @property
    def wheels(self) -> tuple[Wheel, Wheel]:
        """Pinion and rack."""
        return self.pinion.form, Bar(self.rack)

    @property
    def ratio(self) -> Fraction:
        """1: the output is the pinion's own turn."""
        return Fraction(1)

    @property
    def driven_pitch_radius(self) -> float:
        """Radius of the pinion's reference circle, mm: an angle times this is a travel."""
        return self.pinion.form.reference_diameter / 2

    @property
    def label(self) -> str:
        """Teeth of pinion and rack: `19/rack 30`."""
        return f"{self.pinion.form.teeth}/rack {self.rack.teeth}"

    @property
    def module(self) -> float:
        """m_n, mm."""
        return self.pinion.form.normal_module

    @property
    def toothed(self) -> bool:
        """Play is the room between flanks."""
        return True

    @property
    def distance_deviation(self) -> float:
        """Deviation of the pinion's distance from the rack, mm."""
        given = self.distance_deviation_given
        if given is not None:
            return given
        return float(centre_distance_deviation(self.centre_distance, self.pinion.grade))

    @property
    def grades(self) -> tuple[int | None, int | None]:
        """Grades by ISO 1328 of pinion and rack."""
        return self.pinion.grade, self.rack_grade

    @property
    def rack_tolerances(self) -> dict[str, float]:
        """Tolerances f_pt, F_p, F_α and F_β of the rack, mm; none without a grade or beyond the standard's sizes."""
        return tolerances_of_rack(self.rack, self.rack_grade)

    def play(self) -> RackPlay:
        """Play within the tolerances: distance, both thicknesses, the pinion's composite error and the rack's pitch.

        A pitch that is off moves both flanks of a tooth, and so does nothing while these alone touch the pinion. Where
        one flank of two teeth is touched, it closes or opens the play by what they are off against each other.

        Raises:
            DesignError: a size that the standards do not cover.
        """
        form, across = self.pinion.form, cos(self.pinion.form.helix_angle)
        slope = 2 * tan(form.transverse_pressure_angle)
        own = gear_tolerances_of(self.pinion)
        zone = self.pinion.thickness_tolerance
        if zone is None:
            zone = 2 * tan(form.normal_pressure_angle) * hypot(own.F_r, own.b_r)
        line, apart = self.mesh.backlash.pitch, self.distance_deviation * slope
        rack = self.rack_tolerances
        closes, opens = (
            min(pitches * rack.get("f_pt", 0.0), rack.get("F_p", 0.0)) for pitches in self.mesh.pitches_touched
        )
        halves = (zone / 2 / across, self.rack_zone / 2 / across)
        low = np.array([line - apart, -halves[0], -halves[1], 0.0, -closes])
        high = np.array([line + apart, halves[0], halves[1], own.F_i_radial * slope, opens])
        names = (
            Message("distance"),
            Message("thickness of the pinion"),
            Message("thickness of the rack"),
            Message("composite error of the pinion"),
            Message("pitch of the rack"),
        )
        radius = self.driven_pitch_radius
        return RackPlay(
            B_min=float(low.sum()) / radius,
            B_max=float(high.sum()) / radius,
            contributions=ZoneSum(names, low, high),
        )

    def free_angle(self) -> float:
        """Play as it is cut, as an angle of the pinion, rad."""
        return self.mesh.backlash.pitch / self.driven_pitch_radius

    def opened(self, clearance: float) -> float:
        """Play that a pinion further from the rack adds, rad.

        Args:
            clearance: growth of the distance, mm.
        """
        return 2 * clearance * tan(self.pinion.form.transverse_pressure_angle) / self.driven_pitch_radius

    def as_cut(self) -> Self:
        """The stage itself, whose pinion can be cut."""
        tooth_of(self.pinion.form)
        return self

    def driven_angle(self, driver_angle: float, direction: float) -> float:
        """Angle of the bar: its teeth point to the pinion.

        Args:
            driver_angle: angle of the pinion, rad.
            direction: direction from the pinion's axis to the rack, rad.
        """
        return (direction + pi / 2) % (2 * pi)

    def driven_shift(self, driver_angle: float, direction: float) -> complex:
        """Way from the foot of the pinion's axis on the reference line to the bar's own origin, mm.

        A space of the rack stands midway along its width where a tooth of the pinion points; the bar's middle is as
        near to the foot as that lets it be.

        Args:
            driver_angle: angle of the pinion, rad.
            direction: direction from the pinion's axis to the rack, rad.
        """
        rack = self.rack
        rolled = self.driven_pitch_radius * ((driver_angle - direction) % (2 * pi))
        lean = rack.outline.run.lean * rack.width / 2
        spaces = round((rack.length / 2 + rolled) / rack.pitch)
        along = rolled - spaces * rack.pitch - lean
        return complex(along * 1j * np.exp(1j * direction))

    def meshes(self, engage: Engage) -> bool:
        """Whether the teeth hold each other with some play, and one pair is always in mesh."""
        built = engage(self, self.centre_distance)
        free = built.overlap_midway(0.0) <= LEAST_OVERLAP < built.overlap_tooth_on_tooth(0.0)
        return free and self.mesh.contact_ratio >= 1

    def checks(self, engage: Engage) -> tuple[Check, ...]:
        """The teeth in mesh over a pitch, as cut, and at the nearest and the furthest distance."""
        built, form = engage(self, self.centre_distance), self.pinion.form
        overlap = self.rack.width * tan(abs(form.helix_angle)) / self.rack.pitch
        play = self.play()
        arc = self.driven_pitch_radius * 1e3
        off = self.distance_deviation
        jam = max(engage(self, self.centre_distance - each).overlap_midway(0.0) for each in (0.0, off))
        hold = min(engage(self, self.centre_distance + each).overlap_tooth_on_tooth(0.0) for each in (0.0, off))
        tighter = Message(
            "raise backlash_um or distance_mm (the least play by the tolerances is {play:.1f} µm)",
            play=play.B_min * arc,
        )
        checks = [
            *room_checks(min(built.clearances()) / form.normal_module, self.mesh.contact_ratio, overlap, None),
            *freedom_checks((jam, "", tighter), (hold, "", Message("lower distance_mm"))),
        ]
        if self.meshes(engage):
            checks += cycle_checks(*cycle(built, self.free_angle(), form.teeth, self.driven_pitch_radius))
            checks.append(measured_check(PlayState.AS_CUT, (built.play(0.0) - self.free_angle()) * arc))
        return tuple(checks)

    def notes(self, number: int) -> tuple[str, ...]:
        """Travel for a turn of the pinion, reach and play along the rack; a pinion that is undercut.

        Args:
            number: number of the stage.
        """
        said = [
            Message(
                "the rack of stage {number} travels {travel:.4f} mm for one turn of its pinion and reaches {reach:.4g} "
                "mm, with a play of {play:.1f} µm along it as cut",
                number=number,
                travel=self.mesh.travel,
                reach=self.mesh.reach,
                play=self.mesh.backlash.pitch * 1e3,
            )
        ]
        if (missing := missing_shift(self.pinion.form)) > 0:
            said.append(
                Message(
                    "the {role} of stage {number}, of {teeth} teeth, is undercut: as cut it has the profile shift"
                    " {shift:.3f}, {missing:.2g} modules less than would leave its flanks whole",
                    role=Message("driver"),
                    number=number,
                    teeth=self.pinion.form.teeth,
                    shift=self.pinion.form.generating_profile_shift,
                    missing=missing,
                )
            )
        return tuple(said)

    def entry(self) -> Facts:
        """Travel, reach, contact, and play by its names."""
        mesh, play, arc = self.mesh, self.play(), self.driven_pitch_radius * 1e3
        backlash: Backlash = mesh.backlash
        return Facts(
            teeth=self.label,
            distance_mm=self.centre_distance,
            bearing_span_mm=self.bearing_span,
            travel_per_turn_mm=mesh.travel,
            reach_mm=mesh.reach,
            contact_ratio=mesh.contact_ratio,
            f_a_um=self.distance_deviation * 1e3,
            play_base_um=backlash.base * 1e3,
            play_normal_um=backlash.normal * 1e3,
            play_as_cut_um=backlash.pitch * 1e3,
            play_driver_angle_deg=degrees(backlash.driver_angle),
            play_least_um=play.B_min * arc,
            play_greatest_um=play.B_max * arc,
        )

    def wheel_figures(self) -> tuple[Figures, ...]:
        """Figures of pinion and rack."""
        own, form, rack = gear_tolerances_of(self.pinion), self.pinion.form, self.rack
        zone = self.pinion.thickness_tolerance
        if zone is None:
            zone = 2 * tan(form.normal_pressure_angle) * hypot(own.F_r, own.b_r)
        middle = form.tooth_thickness_deviation
        ends = (middle + zone / 2, middle - zone / 2)
        sizes = inspection_of(form, *ends, self.pinion.pin_diameter)
        thick, thin = (rack.tooth_thickness_deviation + side * self.rack_zone / 2 for side in (1, -1))
        bar = Figures(
            Figure("teeth", Message("teeth"), rack.teeth),
            Figure("module", Message("module m_n"), rack.normal_module, "mm"),
            Figure("pressure_angle", Message("pressure angle"), degrees(rack.normal_pressure_angle), "°"),
            Figure("addendum_factor", Message("addendum h_aP"), rack.addendum_factor),
            Figure("dedendum_factor", Message("dedendum h_fP"), rack.dedendum_factor),
            Figure("rack_tip_radius_factor", Message("rack tip radius rho_fP"), rack.fillet_factor),
            *(
                (Figure("helix_angle", Message("helix angle, + right hand"), degrees(rack.helix_angle), "°"),)
                if rack.helix_angle
                else ()
            ),
            Figure("width", Message("width"), rack.width, "mm"),
            Figure("length", Message("length"), rack.length, "mm"),
            Figure("height", Message("height to the reference line"), rack.back_height, "mm"),
            Figure("E_sn", "E_sn", rack.tooth_thickness_deviation * 1e3, "µm"),
            Figure("E_sns", "E_sns", thick * 1e3, "µm"),
            Figure("E_sni", "E_sni", thin * 1e3, "µm"),
            *(Figure(symbol, symbol, value * 1e3, "µm") for symbol, value in self.rack_tolerances.items()),
            Figure("pin_diameter", Message("pin diameter"), rack.pin_diameter, "mm"),
            Figure("over_pin_max", Message("height over a pin, greatest"), rack.over_pin(thick), "mm"),
            Figure("over_pin_min", Message("height over a pin, least"), rack.over_pin(thin), "mm"),
        )
        return gear_figures(form, ends, sizes), bar


def tolerances_of_rack(rack: RackForm, grade: int | None) -> dict[str, float]:
    """Tolerances f_pt, F_p, F_α and F_β of a rack, mm; none without a grade or beyond the standard's sizes.

    Args:
        rack: numbers of the rack, which is taken as a gear of as many teeth.
        grade: tolerance grade by ISO 1328-1.
    """
    if grade is None:
        return {}
    diameter, second = rack.length / pi, {"F_beta": rack.width}
    try:
        return {
            symbol: float(flank_tolerance(symbol, diameter, second.get(symbol, rack.normal_module), grade))
            for symbol in ("f_pt", "F_p", "F_alpha", "F_beta")
        }
    except DesignError:
        return {}


def rack_stage(
    pinion: GradedGear,
    rack: RackForm,
    *,
    distance: float,
    bearing_span: float,
    rack_zone: float,
    rack_grade: int | None = None,
    distance_deviation: float | None = None,
    backlash: float | None = None,
    deviations: Sequence[float | None] = (None, None),
    travel: float | None = None,
) -> RackStage:
    """Pinion and rack, thinned for a play along the rack.

    Args:
        pinion: pinion of nominal thickness.
        rack: rack of nominal thickness.
        distance: distance of the pinion's axis from the reference line, mm.
        bearing_span: between the bearings of the pinion's shaft, mm.
        rack_zone: width of the zone of the rack's thickness, mm.
        rack_grade: tolerance grade of the rack; None for none.
        distance_deviation: deviation of the distance, mm; None for the standard's.
        backlash: play along the rack, mm; None for so much that none jams within the tolerances.
        deviations: deviations E_sn of pinion and rack that are given, mm; None for what the play asks.
        travel: travel that the rack must allow, mm; None for as far as it reaches.

    Raises:
        DesignError: teeth that do not mesh, or a rack that is shorter than its travel.
    """
    form, across = pinion.form, cos(pinion.form.helix_angle)

    def cut(own: float, other: float) -> RackStage:
        return RackStage(
            pinion=replace(pinion, form=form.cut_to(own), thinning=own),
            rack=replace(rack, tooth_thickness_deviation=other),
            centre_distance=distance,
            bearing_span=bearing_span,
            rack_zone=rack_zone,
            rack_grade=rack_grade,
            distance_deviation_given=distance_deviation,
            travel=travel,
        )

    one, two = deviations
    if one is None or two is None:
        slope = 2 * tan(form.transverse_pressure_angle)
        nominal = (distance - form.reference_diameter / 2 - form.profile_shift * form.normal_module) * slope
        if backlash is None:
            free = cut(min(nominal, 0.0) * across, 0.0)
            short = (free.free_angle() - free.play().B_min) * free.driven_pitch_radius
            backlash = ceil((short + LEFT_BACKLASH) / LEFT_BACKLASH) * LEFT_BACKLASH
        both = (nominal - backlash) * across
        if one is None and two is None:
            one = both / 2
        if one is None:
            one = both - (two or 0.0)
        two = both - one if two is None else two
    stage = cut(one, two)
    mesh = stage.mesh
    if travel is not None and not travel <= mesh.reach:
        more = rack.teeth + ceil((travel - mesh.reach) / rack.pitch - 1e-9)
        raise DesignError(
            "the rack of {teeth} teeth is {length:.4f} mm long and reaches {reach:.4f} mm, less than the travel_mm of "
            "{travel:g}; give rack.teeth = {more}, which are {needed:.4f} mm",
            teeth=rack.teeth,
            length=rack.length,
            reach=mesh.reach,
            travel=travel,
            more=more,
            needed=more * rack.pitch,
        )
    return stage
