"""One gear by its numbers, without a design file. Lengths are mm and angles rad."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from math import radians
from os import PathLike
from typing import TYPE_CHECKING, Any

from cadgen.api.files import folder_of
from cadgen.api.values import feature, optional, real, whole, word
from cadgen.arrays import TURN
from cadgen.design.file_names import name_fault
from cadgen.design.gear_model import usual_chord
from cadgen.errors import DesignError, brief
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.output.files.publisher import Frozen, Written
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub, Keyway, Lightening, Web
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import Solid
    from cadgen.output.files.exports import GearExport


@dataclass(frozen=True, kw_only=True)
class Gear:
    """A spur gear, its axis on z and a tooth on x.

    Attributes:
        teeth: number of teeth, 4 to 1000.
        module: normal module, mm.
        width: width of the face, mm.
        pressure_angle: normal pressure angle, rad.
        profile_shift: profile shift x, in modules.
        bore: diameter of the bore, mm; 0 for none.
        keyway, hub, web, lightening: features besides the teeth, mm; see their classes.
        grade: tolerance grade of ISO 1328, 3 to 12.
        tolerances: tolerances in place of the standard's, mm, by symbol (f_pt, F_beta, F_r, b_r, F_i_radial).
        thickness_deviation: deviation E_sn of the tooth thickness as cut, mm, negative for thinner teeth; None leaves
            it to the pair, with nominal teeth for the gear alone.
        addendum, dedendum, rack_tip_radius: sizes of the basic rack, in modules.
        tip_chamfer: leg of the chamfer at the tips, mm.
        name: name of the gear and its files.

    Raises:
        DesignError: a number out of its range, a tooth that cannot be cut, or features that leave too thin a wall.

    Example:
        >>> from cadgen import Gear
        >>> gear = Gear(teeth=24, module=1.5, width=8, bore=6)
        >>> gear.tip_diameter
        39.0
        >>> gear.write("exports")  # doctest: +SKIP
    """

    teeth: int
    module: float
    width: float
    pressure_angle: float = radians(20.0)
    profile_shift: float = 0.0
    bore: float = 0.0
    keyway: Keyway | None = None
    hub: Hub | None = None
    web: Web | None = None
    lightening: Lightening | None = None
    grade: int = 7
    tolerances: Mapping[str, float] | None = None
    thickness_deviation: float | None = None
    addendum: float = 1.0
    dedendum: float = 1.25
    rack_tip_radius: float = 0.38
    tip_chamfer: float = 0.0
    name: str = "gear"

    def __post_init__(self) -> None:
        whole("teeth", self.teeth, 4, 1000)
        whole("grade", self.grade, 3, 12)
        real("module", self.module, 0, 10, "mm", above=True)
        feature("width", self.width, 500)
        real("pressure_angle", self.pressure_angle, radians(10), radians(35), "rad")
        real("profile_shift", self.profile_shift, -2, 2, "modules")
        feature("bore", self.bore, 500, or_none=True)
        feature("tip_chamfer", self.tip_chamfer, 10, or_none=True)
        for name, most in (("addendum", 3), ("dedendum", 3), ("rack_tip_radius", 1)):
            real(name, getattr(self, name), 0, most, "modules", above=True)
        if self.thickness_deviation is not None:
            real("thickness_deviation", self.thickness_deviation, -10, 10, "mm")
        for name, kind in (("keyway", Keyway), ("hub", Hub), ("web", Web), ("lightening", Lightening)):
            if not isinstance(value := getattr(self, name), kind | None):
                raise DesignError(f"{name} is {brief(repr(value), 60)}; it must be a {kind.__name__}")
        _require_features(self.keyway, self.hub, self.web, self.lightening)
        require_name(self.name)
        self.overrides  # noqa: B018
        if self.tolerances is not None:  # a copy, so that no change of the caller's changes a gear that is made
            object.__setattr__(self, "tolerances", Frozen(self.tolerances))
        self.part  # noqa: B018

    @cached_property
    def form(self) -> GearForm:
        """Numbers of its teeth as they are cut."""
        return GearForm(
            teeth=int(self.teeth),
            normal_module=float(self.module),
            width=float(self.width),
            normal_pressure_angle=float(self.pressure_angle),
            profile_shift=float(self.profile_shift),
            addendum_factor=float(self.addendum),
            dedendum_factor=float(self.dedendum),
            rack_tip_radius_factor=float(self.rack_tip_radius),
            tip_chamfer=float(self.tip_chamfer),
            tooth_thickness_deviation=self.thickness_deviation or 0.0,
        )

    @cached_property
    def blank(self) -> Blank:
        """Features besides its teeth."""
        return Blank(bore_diameter=self.bore, key=self.keyway, hub=self.hub, web=self.web, lightening=self.lightening)

    @cached_property
    def part(self) -> Any:
        """The gear as a part by itself, with its exact body."""
        from cadgen.jobs.gears.numbers import part_of

        return part_of(self.form, self.blank)

    @cached_property
    def overrides(self) -> ToleranceOverrides:
        """The `tolerances` in place of the standard's, checked."""
        known = [field.name for field in fields(ToleranceOverrides)]
        if not isinstance(self.tolerances, Mapping | None):
            raise DesignError(f"tolerances is {brief(repr(self.tolerances), 60)}; it must map symbols to mm")
        tolerances = dict(self.tolerances or {})
        for symbol, value in tolerances.items():
            word("a symbol of tolerances", symbol, known)
            real(f"tolerances[{symbol!r}]", value, 0, 10, "mm")
        return ToleranceOverrides(**{symbol: float(value) for symbol, value in tolerances.items()})

    @property
    def reference_diameter(self) -> float:
        """Reference diameter d, mm."""
        return self.form.reference_diameter

    @property
    def base_diameter(self) -> float:
        """Base diameter d_b, mm."""
        return self.form.base_diameter

    @property
    def tip_diameter(self) -> float:
        """Tip diameter d_a, mm."""
        return self.form.tip_diameter

    @property
    def root_diameter(self) -> float:
        """Root diameter d_f as cut, mm."""
        return self.form.root_diameter

    @property
    def volume(self) -> float:
        """Exact volume, mm³."""
        return float(self.part.volume)

    @property
    def undercut(self) -> bool:
        """Whether the root cuts into the flanks."""
        return tooth_of(self.form).undercut

    def facts(self) -> dict[str, Any]:
        """The gear as plain values, with span over teeth and size over pins, mm, as it is cut."""
        from cadgen.jobs.gears.numbers import gear_facts

        return gear_facts(self.form, self.part, self.name)

    def build123d(self) -> "Solid":
        """The gear as a build123d solid with label and colour, mm; its lower face lies at z = 0.

        Raises:
            FileError: the CAD kernel cannot drill the set screw.
        """
        return self._export.solid().build123d()

    def write(
        self,
        folder: str | PathLike[str],
        formats: str | Iterable[str] | None = None,
        *,
        progress: Progress = silent,
    ) -> Written:
        """Write files and compare every tooth read back with the exact one; all are published together or none.

        Args:
            folder: folder for the files; it is made if need be.
            formats: some of step and stl; both if left out.
            progress: function that is called with a few words on each step.

        Raises:
            DesignError: a format is unknown.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.jobs.gears.files import write_gear

        return write_gear(self._export, self.facts(), folder_of(folder), progress, formats)

    @property
    def _export(self) -> "GearExport":
        from cadgen.output.files.exports import GearExport

        return GearExport(name=self.name, form=self.form, part=self.part, chord=usual_chord(self.part.gears))


def _require_features(keyway: Keyway | None, hub: Hub | None, web: Web | None, lightening: Lightening | None) -> None:
    """Refuse sizes that the design file refuses."""
    if keyway:
        feature("keyway.width", keyway.width, 100)
        feature("keyway.depth", keyway.depth, 50)
        real("keyway.angle", keyway.angle, -TURN, TURN, "rad")
    if hub:
        feature("hub.diameter", hub.diameter, 1000)
        feature("hub.length", hub.length, 200, or_none=True)
        word("hub.side", hub.side, ("outer", "inner"))
        if hub.set_screw:
            feature("hub.set_screw.diameter", hub.set_screw.diameter, 50)
            real("hub.set_screw.height", hub.set_screw.height, 0, 200, "mm")
            real("hub.set_screw.angle", hub.set_screw.angle, -TURN, TURN, "rad")
    if web:
        feature("web.thickness", web.thickness, 500)
        feature("web.rim_thickness", web.rim_thickness, 500)
    if lightening:
        whole("lightening.count", lightening.count, 1, 360)
        feature("lightening.hole_diameter", lightening.hole_diameter, 500)
        optional("lightening.circle_diameter", lightening.circle_diameter, 0, 1000, "mm", above=True)
        real("lightening.start_angle", lightening.start_angle, -TURN, TURN, "rad")


def require_name(name: object) -> None:
    """Refuse a name that files cannot have on every system.

    Args:
        name: name as the caller has it.

    Raises:
        DesignError: the name is not allowed.
    """
    if fault := name_fault(name if isinstance(name, str) else ""):
        raise DesignError(f"name is {brief(repr(name), 60)}; it must {fault}")
