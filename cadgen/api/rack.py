"""Racks by their numbers, alone and under a pinion: lengths in mm, angles in rad."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from math import cos, degrees, pi, radians

import numpy as np

from cadgen.api.gears import Gear, require_name
from cadgen.api.values import Stated, optional, real, whole, word
from cadgen.design.gear_model import COARSEST_CHORD
from cadgen.errors import DesignError, brief
from cadgen.figures import Facts
from cadgen.gears.choices import HelixHand
from cadgen.gears.layout import TrainPart
from cadgen.gears.rack import RackForm, RackMesh
from cadgen.gears.rack_stage import Bar, tolerances_of_rack
from cadgen.gears.tooth import CHORD_PER_MODULE, STEEPEST_HELIX
from cadgen.jobs.gears.assembly import OnePart
from cadgen.output.files.exports import RackExport
from cadgen.output.report.gear_pictures import gears_picture
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.shape_pictures import Filled, shapes_picture
from cadgen.output.report.style import Drawing
from cadgen.parts.blank import Blank

_CHORD = 0.01  # mm, of the teeth on a picture


@dataclass(frozen=True, kw_only=True, repr=False)
class MeshedRack(RackMesh, Pictured):
    """Pinion on a rack, as `Rack.meshed` gives it.

    Attributes:
        part: the pinion by itself, with its body.
    """

    part: TrainPart = field(compare=False)

    def __repr__(self) -> str:
        teeth, play = self.pinion.teeth, self.backlash.pitch
        return f"<MeshedRack, {self.rack.teeth} teeth under a pinion of {teeth}, backlash {play:.4g} mm>"

    @property
    def picture(self) -> Drawing:
        """Sections in mesh, a tooth of the pinion in the middle of a space."""
        rack = Bar(self.rack)
        bar = replace(self.part, shaft=2, gears=(rack,), blank=Blank(), body=self.rack.body)
        axis = complex(self.rack.teeth // 2 * self.rack.pitch, self.distance)
        return gears_picture(repr(self)[1:-1], [bar, replace(self.part, axis=axis, angle=-pi / 2)])

    def entry(self) -> Facts:
        """The mesh: play under its four names, contact ratio and travel."""
        play = self.backlash
        return Facts(
            pinion_teeth=self.pinion.teeth,
            rack_teeth=self.rack.teeth,
            distance_mm=self.distance,
            j_bt_um=play.base * 1e3,
            j_bn_um=play.normal * 1e3,
            j_wt_um=play.pitch * 1e3,
            pinion_play_deg=degrees(play.driver_angle),
            contact_ratio=self.contact_ratio,
            travel_mm=self.travel,
        )


@dataclass(frozen=True, kw_only=True, repr=False)
class Rack(Stated, OnePart, Pictured):
    """A rack, its reference line on x, its teeth towards y and its width along z.

    Attributes:
        teeth: number of teeth, 1 to 1000.
        module: normal module, mm.
        width: width of the face, mm.
        height: from the back to the reference line, mm; None for two modules behind the roots.
        pressure_angle: normal pressure angle, rad.
        helix_angle: helix angle β, rad, 0 to 45°; 0 for straight teeth.
        hand: hand of the helix, opposite to that of its pinion.
        thickness_deviation: deviation E_sn of the normal tooth thickness, mm, negative for thinner teeth.
        addendum, dedendum, root_radius: height of tips, depth and radius of roots, in modules.
        grade: tolerance grade of ISO 1328-1, as of a gear of as many teeth, 3 to 12; None for none.
        name: name of the rack and its files.

    Raises:
        DesignError: a number out of its range, or teeth that cannot be made.

    Example:
        >>> from cadgen import Gear, Rack
        >>> rack, pinion = Rack(teeth=12, module=1, width=8), Gear(teeth=20, module=1, width=8)
        >>> round(rack.meshed(pinion, 10.05).backlash.pitch, 6)
        0.036397
    """

    teeth: int
    module: float
    width: float
    height: float | None = None
    pressure_angle: float = radians(20.0)
    helix_angle: float = 0.0
    hand: str = HelixHand.RIGHT
    thickness_deviation: float = 0.0
    addendum: float = 1.0
    dedendum: float = 1.25
    root_radius: float = 0.38
    name: str = "rack"
    grade: int | None = None

    def __post_init__(self) -> None:
        whole("teeth", self.teeth, 1, 1000)
        real("module", self.module, 0, 10, "mm", above=True)
        real("width", self.width, 0, 500, "mm", above=True)
        optional("height", self.height, 0, 500, "mm", above=True)
        real("pressure_angle", self.pressure_angle, radians(10), radians(35), "rad")
        real("helix_angle", self.helix_angle, 0, STEEPEST_HELIX, "rad")
        word("hand", self.hand, [hand.value for hand in HelixHand])
        real("thickness_deviation", self.thickness_deviation, -10, 10, "mm")
        for name, most in (("addendum", 3), ("dedendum", 3), ("root_radius", 1)):
            real(name, getattr(self, name), 0, most, "modules", above=True)
        if self.grade is not None:
            whole("grade", self.grade, 3, 12)
        require_name(self.name)
        self.form  # noqa: B018

    @cached_property
    def form(self) -> RackForm:
        """Numbers of its teeth as they are cut."""
        return RackForm(
            teeth=int(self.teeth),
            normal_module=float(self.module),
            width=float(self.width),
            height=self.height,
            normal_pressure_angle=float(self.pressure_angle),
            helix_angle=float(self.helix_angle) * (1 if self.hand == HelixHand.RIGHT else -1),
            addendum_factor=float(self.addendum),
            dedendum_factor=float(self.dedendum),
            fillet_factor=float(self.root_radius),
            tooth_thickness_deviation=float(self.thickness_deviation),
        )

    @property
    def picture(self) -> Drawing:
        """Section of the teeth."""
        points = self.form.outline.polygon(_CHORD)
        ring = np.stack([points.real, points.imag], axis=1)
        return shapes_picture(f"{self.name}, {self.teeth} teeth", {"": [Filled([ring])]})

    @property
    def length(self) -> float:
        """Length of the bar, mm."""
        return self.form.length

    @property
    def volume(self) -> float:
        """Exact volume, mm³."""
        return self.form.area * self.form.width

    def meshed(self, pinion: Gear, distance: float) -> MeshedRack:
        """A pinion on the rack: play under its four names, contact ratio and travel.

        Args:
            pinion: gear on the rack.
            distance: distance of the pinion's axis from the reference line, mm.

        Raises:
            DesignError: they do not match, jam or do not meet; the distance is none, or the pinion's bore has no room.
        """
        if not isinstance(pinion, Gear):
            raise DesignError("{name} is {value}; it must be a Gear", name="pinion", value=brief(repr(pinion), 60))
        real("distance", distance, 0, 2000, "mm", above=True)
        return MeshedRack(pinion=pinion.form, rack=self.form, distance=float(distance), part=pinion.part)

    def entry(self) -> Facts:
        """The rack with the sizes to make and to measure it by."""
        form = self.form
        return Facts(
            rack=self.name,
            teeth=form.teeth,
            module_mm=form.normal_module,
            pressure_angle_deg=degrees(form.normal_pressure_angle),
            helix_angle_deg=degrees(form.helix_angle),
            width_mm=form.width,
            length_mm=form.length,
            pitch_mm=form.pitch,
            height_mm=form.back_height,
            tip_height_mm=form.addendum_factor * form.normal_module,
            root_depth_mm=form.dedendum_factor * form.normal_module,
            thickness_at_reference_mm=form.pitch * cos(form.helix_angle) / 2 + form.tooth_thickness_deviation,
            E_sn_um=form.tooth_thickness_deviation * 1e3,
            **{f"{symbol}_um": value * 1e3 for symbol, value in tolerances_of_rack(form, self.grade).items()},
            volume_mm3=self.volume,
        )

    def _export(self) -> RackExport:
        chord = min(CHORD_PER_MODULE * self.form.normal_module, COARSEST_CHORD)
        return RackExport(name=self.name, form=self.form, chord=chord)
