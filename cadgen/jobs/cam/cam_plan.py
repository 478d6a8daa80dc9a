"""Computed and checked cams, with how they are made and for which application."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from cadgen.cam.checks import LOST_LIFT
from cadgen.cam.follower import Contact, Follower, Trim
from cadgen.cam.limits import CheckLimits
from cadgen.car.against_play.profile_kinds import ProfileKind
from cadgen.car.running.friction import DiscMaterial, named_material
from cadgen.check import Check, CheckCode, failing
from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.curves.derived import turned
from cadgen.design.machining import DrawingText, Machining
from cadgen.design.schema import Design, Export, MotionDesign
from cadgen.figures import Facts, Figures, Sheet
from cadgen.laws.motion import Motion
from cadgen.messages import Message
from cadgen.output.drawing.shaft_fit import ShaftFit
from cadgen.output.files.manifest import Origin
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.verdict import PartVerdict

if TYPE_CHECKING:
    from cadgen.cam.forces import CamForces

# g/cm3: handbooks' tables, such as those that The Engineering ToolBox collects; PLA by makers of filament.
DENSITY: dict[DiscMaterial, float] = {
    DiscMaterial.ALUMINIUM: 2.70,
    DiscMaterial.STEEL: 7.85,
    DiscMaterial.BRASS: 8.50,
    DiscMaterial.ACRYLIC: 1.18,
    DiscMaterial.PLA: 1.24,
    DiscMaterial.POM: 1.41,
}


@dataclass(frozen=True)
class Making:
    """How a cam is made and how finely its files follow it.

    Attributes:
        material: material of the disc; None where the design does not say.
        ordered: material in the words of sheets and lists; empty where the design does not say.
        fit: fits and joint of the bore on its shaft.
        screwed: whether a set screw holds it.
        title: texts of the title block of its sheet; None where the design does not say.
        machining: cutter, speeds, tabs and drilling.
        export: how finely files follow the outline.
    """

    material: DiscMaterial | None
    ordered: str
    fit: ShaftFit
    screwed: bool
    title: DrawingText | None
    machining: Machining
    export: Export

    @classmethod
    def of(cls, design: Design | MotionDesign) -> "Making":
        """Making of a design's cam."""
        blank = design.blank
        screw = blank.hub.set_screw if blank.hub else None
        ordered = design.drawing.material if design.drawing else None
        known = named_material(ordered)
        if blank.material and known not in (None, blank.material):
            ordered = known = None  # the disc is tried of another material, by which its friction goes
        if ordered and known and ordered.startswith(f"{known} "):
            ordered = Message("{material} {grade}", material=Message(known), grade=ordered.removeprefix(f"{known} "))
        return cls(
            material=blank.material or known,
            ordered=ordered or Message(str(blank.material or "")),
            fit=ShaftFit.of(blank, blank.bore_fit, screw.thread if screw else None),
            screwed=screw is not None,
            title=design.drawing,
            machining=design.machining,
            export=design.export,
        )


def steepest(checks: Iterable[Check]) -> tuple[str, ...]:
    """Greatest pressure angle among checks, in words; none if it is not among them."""
    angles = [
        check
        for check in checks
        # A square face has none.
        if check.value and check.code in (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN)
    ]
    return tuple(
        Message("pressure angle {angle:.3g}°", angle=check.value)
        for check in sorted(angles, key=lambda check: -check.value)[:1]
    )


class Application:
    """Use of a cam. This base class is a cam of which nothing else is known; subclasses are uses.

    Attributes:
        design: design that the use was read from.
        noun: name of the cam in titles and descriptions.
        measured_again: whether measured data of it are judged by `cadgen calibrate`, for which its sheet has a form.
    """

    noun = "cam"
    measured_again = False
    design: Design | MotionDesign

    @property
    def profile_tolerance(self) -> float | None:
        """Tolerance of the outline along its normal, mm; None where nothing is said of it."""
        return None

    @property
    def thickness_tolerance(self) -> float:
        """Half width of the tolerance of the thickness, mm; 0 for the general one."""
        return 0.0

    @property
    def disc_gap(self) -> float | None:
        """Distance of the facing sides of both discs of a conjugate pair, mm; None for one disc, or if not stated."""
        return None

    @property
    def edge_tolerance(self) -> float:
        """Half width of the tolerance of the leg of broken edges, mm; 0 for the general one."""
        return 0.0

    @property
    def taper_tolerance(self) -> float:
        """Greatest difference of the outlines of both faces along their normal, mm; 0 where nothing is said of it."""
        return 0.0

    @property
    def base_radius(self) -> float | None:
        """Radius of the base circle, mm; None of a cam that is laid out without one."""
        return None

    @property
    def wheel(self) -> str:
        """Wheel that the cam is for, in words; empty without one."""
        return ""

    @property
    def expected(self) -> str:
        """Expectation of the cam by measurements, in a sentence; empty if nothing was measured."""
        return ""

    def open_keys(self) -> dict[str, tuple[str, object]]:
        """Facts of the application that a sheet needs, each with its key and its value."""
        return {}

    def frame(self, cam: "CamPlan") -> str:
        """Axes of the files, in words."""
        other = Face.INNER if cam.seen == Face.OUTER else Face.OUTER
        return (
            f"mm; z = 0 is the disc's {other} face, +z points to the {cam.seen} face, seen on which the disc turns "
            f"clockwise; at cam angle theta the {cam.follower.on_ray} stands at polar angle theta, counterclockwise "
            "from +X"
        )

    def rolled(self, cam: "CamPlan") -> Motion:
        """Motion that the follower gets on the cam that is made."""
        return cam.motion

    def planned(self, cam: "CamPlan") -> Motion | None:
        """Motion that is wanted, where the profile is cut for another; None where the two are the same."""
        return None

    def envelope(self, cam: "CamPlan") -> ClosedCurve:
        """Outline on which the design's follower moves as wanted, mm: the cut one, unless the car deviates."""
        return cam.curve

    def figures(self, cam: "CamPlan") -> tuple[Check, ...]:
        """Figures without a verdict that are shown beside the checks."""
        return ()

    def timing(self, cam: "CamPlan") -> Motion | None:
        """Motion of the timing diagram on the sheet of a cam; None where a sheet has none.

        Args:
            cam: cam that was computed.
        """
        return None

    def forces(self, cam: "CamPlan") -> "CamForces | None":
        """Forces on the follower and its camshaft; None where nothing is said of them.

        Args:
            cam: cam that was computed.
        """
        return None

    def sheets(self, cam: "CamPlan") -> tuple[Sheet, ...]:
        """Tables that are shown with all checks."""
        return ()

    def entry(self, cam: "CamPlan") -> Facts:
        """Figures of the application, each in the unit that its key names."""
        return Facts()

    def notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sentences on what was assumed, and on what to do beside the cam."""
        return ()

    def setting(self, cam: "CamPlan") -> tuple[str, ...]:
        """Instructions without which the cam does not do what it was made for."""
        return ()

    def warnings(self) -> tuple[str, ...]:
        """Sentences on what was left out and may matter."""
        return ()

    def drawing_notes(self, cam: "CamPlan") -> tuple[str, ...]:
        """Sentences for the cam's sheet."""
        return ()

    def verdict(self, cam: "CamPlan") -> PartVerdict:
        """Verdict on a cam: its checks, with what the application adds, and its reservations."""
        return PartVerdict(cam.checks)

    def purpose(self, cam: "CamPlan") -> str:
        """Purpose of the cam, in a few words."""
        return Message("a turn of the camshaft")

    def deciding(self, cam: "CamPlan") -> tuple[str, ...]:
        """Figures by which a cam is chosen, in words, the weightiest first."""
        return steepest(cam.checks)

    def curable(self, cam: "CamPlan") -> tuple[Check, ...]:
        """Failed checks for which cures are sought."""
        return cam.lost

    def changes(self, cam: "CamPlan") -> Iterable[Sequence[tuple[str, str]]]:
        """Changes that may cure what failed: groups of overrides as for `--set`, each with the present value as text.

        Of each group the first is taken that cures.
        """
        return ()

    def replanned(self, cam: "CamPlan", override: str) -> tuple[Check, ...]:
        """Checks of the same cam with a change of its design.

        Args:
            cam: cam that was computed.
            override: change, as for `--set`.

        Raises:
            DesignError: the result is no design, or no cam.
        """
        return cam.checks

    def of_file(self, cam: "CamPlan", outline: Outline, contact: Contact, limit: float) -> Figures:
        """Figures of a file's cam in its application.

        Args:
            cam: cam that the file is of.
            outline: outline read back from the file, mm.
            contact: contact of the follower with it.
            limit: greatest error of the lift allowed to the file, um.
        """
        return Figures()

    def of_loss(self, name: str, in_use: Figures, finer: str) -> tuple[str, ...]:
        """Warnings where a file keeps its own tolerance, but gives away what the profile is for.

        Args:
            name: name of the file.
            in_use: what `of_file` gave.
            finer: advice that makes the file finer.
        """
        return ()


@dataclass(frozen=True, kw_only=True, eq=False)
class Groove:
    """Groove in a round disc, in which a roller runs.

    Attributes:
        outer: plan of the outer flank: its curve, and the roller that is pressed outwards on it.
        depth: depth of the groove, mm, from the face that files show.
        outside_radius: radius of the disc, mm.
    """

    outer: "CamPlan"
    depth: float
    outside_radius: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        origin: design that the cam was planned from.
        kind: kind of the profile; as text, its code.
        motion: motion that the profile is cut for: the planned one, or one that gives the planned one with play.
        follower_as_built: follower of the design, as built.
        curve: curve that is cut: the profile, or on a car as built the curve that becomes the profile on its shaft, mm.
        trims: places where the envelope was trimmed.
        blank: features of the disc besides its profile.
        faces: distances of the disc's faces from the fork axis, or heights, mm.
        seen: face of the disc that files show.
        limits: limits of the checks, mm and rad.
        making: how the disc is made, and how finely files follow it.
        checks: every figure with its verdict.
        application: what the cam is for.
        phase: angle by which the curve stands turned on the shaft of a car as built, rad.
        part: name of the disc among several, which its files bear; empty for the first.
        second: second disc of a conjugate pair, on the same shaft and in the same frame; None for one disc.
        groove: groove of which the curve is the inner flank; None for a disc whose rim is the curve.
    """

    origin: Origin
    kind: ProfileKind
    motion: Motion
    follower_as_built: Follower
    curve: ClosedCurve
    trims: tuple[Trim, ...]
    blank: Blank
    faces: tuple[float, float]
    seen: Face
    limits: CheckLimits
    making: Making
    checks: tuple[Check, ...]
    application: Application
    phase: float = 0.0
    part: str = ""
    second: "CamPlan | None" = None
    groove: "Groove | None" = None

    @cached_property
    def verdict(self) -> PartVerdict:
        """Verdict on the cam in its application: ready, with reservations, or not."""
        return self.application.verdict(self)

    @property
    def passed(self) -> bool:
        """Whether the cam may be cut, with reservations or without."""
        return self.verdict.passed

    @property
    def sound(self) -> bool:
        """Whether every check of the cam itself keeps its limit, whatever its application finds."""
        return not failing(self.checks)

    @property
    def deciding(self) -> tuple[str, ...]:
        """Figures by which the cam is chosen, in words, the weightiest first."""
        return self.application.deciding(self)

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks of the verdict that do not keep their limit."""
        return self.verdict.failed

    @property
    def lost(self) -> tuple[Check, ...]:
        """Failed checks on lost lift."""
        return tuple(check for check in failing(self.checks) if check.code in LOST_LIFT)

    @property
    def stem(self) -> str:
        """Stem of the names of the cam's files."""
        return "_".join(filter(None, [self.origin.name, self.part, str(self.kind)]))

    @property
    def discs(self) -> "tuple[CamPlan, ...]":
        """The disc, and the second one of a conjugate pair."""
        return (self,) if self.second is None else (self, self.second)

    @property
    def thickness(self) -> float:
        """Distance of the disc's faces, mm."""
        return self.faces[1] - self.faces[0]

    @cached_property
    def shown(self) -> tuple[Check, ...]:
        """Figures without a verdict, computed when they are shown."""
        return self.application.figures(self)

    @property
    def figures(self) -> tuple[Check, ...]:
        """The checks of the verdict, and what is shown beside them."""
        return (*self.verdict.checks, *self.shown)

    @property
    def made_blank(self) -> Blank:
        """Features of the disc as files show it, seen on the face of `seen`."""
        blank = self.blank
        if self.seen == Face.OUTER or blank.hub is None:
            return blank
        return replace(blank, hub=replace(blank.hub, side=Face.INNER if blank.hub.side == Face.OUTER else Face.OUTER))

    @property
    def follower(self) -> Follower:
        """Follower that rolls on this profile, which for some profiles is its reference point."""
        return self.kind.rolling(self.follower_as_built)

    @cached_property
    def on_shaft(self) -> ClosedCurve:
        """Curve that is cut, mm, on a shaft whose key is right: turned with the key of a car as built."""
        return turned(self.curve, self.phase) if self.phase else self.curve

    @cached_property
    def area(self) -> float:
        """Area of the profile, mm^2."""
        return self.curve.area()

    @cached_property
    def volume(self) -> float:
        """Volume of the part with its hub and its broken edges, mm³, in closed form or by quadrature.

        The solid of the kernel has the same within 1e-5 of it, by a test, and takes longer.
        """
        blank = self.blank
        if self.groove is not None:
            disc = blank.disc_volume(np.pi * self.groove.outside_radius**2, self.thickness)
            return float(disc - (self.groove.outer.area - self.area) * self.groove.depth + blank.hub_volume())
        chamfers = 2 * chamfered_off(self.curve, blank.edge_break) if blank.edge_break else 0.0
        return blank.disc_volume(self.area, self.thickness) - chamfers + blank.hub_volume()

    @property
    def mass(self) -> float | None:
        """Mass of the part, g; None where the design does not say the material."""
        material = self.making.material
        return None if material is None else DENSITY[material] * 1e-3 * self.volume
