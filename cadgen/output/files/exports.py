"""Cams, gears and trains that are to be written: what the writers of all formats need of them, computed once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import TYPE_CHECKING

from cadgen.arrays import Array
from cadgen.cam.contact import roll_curve
from cadgen.cam.difference import Exact, dense_stations
from cadgen.cam.follower import Contact, Follower
from cadgen.car.running.friction import DiscMaterial
from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.design.machining import Machining
from cadgen.design.schema import Export
from cadgen.errors import FileError
from cadgen.figures import Facts, Figures
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.rack import RackForm
from cadgen.gears.tooth import GearForm
from cadgen.laws.motion import Motion
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.parts.print_compensation import PrintCompensation

if TYPE_CHECKING:
    from cadgen.cam.forces import CamForces
    from cadgen.geometry.meshes.mesh import Mesh
    from cadgen.geometry.meshes.printing import HoleOutline
    from cadgen.geometry.solids.kernel import SolidPart

# Share of the chord tolerance that the rim's chords may take at a pressure angle of 0; and at least, at 87 degrees.
_RIM_SHARE = 0.8
_LEAST_RIM_SHARE = 0.04


@dataclass(frozen=True, kw_only=True, eq=False)
class CamExport:
    """Cam that is to be written, and the proof of its files: the follower is rolled on each outline read back.

    Attributes:
        stem: start of the names of its files.
        description: one line, for formats that have room for it.
        curve: curve that is cut, counterclockwise, mm.
        area: area inside the curve, mm².
        follower: follower that rolls on it.
        cam_angle: cam angles at which the follower is rolled, shape (n,), rad.
        blank: features of the disc besides its profile, as files show it.
        thickness: distance of the disc's faces, mm.
        material: material of the disc; None if none is given.
        notes: sentences for the shop on the outline.
        export: how finely files follow the curve.
        machining: cutter, speeds, tabs and drills.
        seen: face of the disc that files show, and that lies up on the mill.
        motion: motion of the follower, for its derivatives; None where files do not have them, as those of cars.
        forces: forces on the follower and its camshaft; None where nothing is said of them.
        in_use: function of an outline read back, of the contact of the follower on it, and of the greatest error
            allowed to the lift, µm. It gives further figures by what the cam is for.
    """

    stem: str
    description: str
    curve: ClosedCurve
    area: float
    follower: Follower
    cam_angle: Array
    blank: Blank
    thickness: float
    material: DiscMaterial | None
    notes: tuple[str, ...]
    export: Export
    machining: Machining
    seen: Face = Face.OUTER
    motion: Motion | None = None
    forces: CamForces | None = None
    in_use: Callable[[Outline, Contact, float], Figures] = lambda outline, contact, limit: Figures()

    @property
    def land(self) -> tuple[float, float] | None:
        """Heights above the inner face of the edges of the land that the follower rides on; None with sharp edges."""
        return self.blank.carrying(0.0, self.thickness) if self.blank.edge_break else None

    @cached_property
    def rolled(self) -> tuple[Contact, float]:
        """Contact of the follower on the exact curve, and the step of the outline for it, mm."""
        return roll_curve(self.curve, self.follower, self.cam_angle)

    @property
    def step(self) -> float:
        """Distance of the points on an outline that is read back, mm."""
        return self.rolled[1]

    @cached_property
    def exact(self) -> Exact:
        """Exact curve for comparison with a file's lift, in points as close together as on an outline read back."""
        return Exact(self.curve.outline(self.step), self.follower, dense_stations(self.follower, self.rolled[0]))

    @cached_property
    def rim_share(self) -> float:
        """Share of the error allowed to the lift that a chord of the rim may take along its normal.

        A chord that is off by e shifts the lift by e / cos(pressure angle), or more where a lever is shorter.
        """
        steepest = float(self.follower.normal_share(self.rolled[0]).min())
        return max(_RIM_SHARE * steepest, _LEAST_RIM_SHARE)

    @cached_property
    def part(self) -> SolidPart:
        """The solid, for STEP, and for its volume."""
        from cadgen.geometry.solids.disc_solid import cam_part

        return cam_part(self.curve, self.blank, self.thickness, name=self.stem, description=self.description)

    @property
    def chord(self) -> float:
        """Greatest chord error of the mesh, mm."""
        return self.export.cam_chord_um * 1e-3

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh, for STL and 3MF."""
        from cadgen.geometry.meshes.mesh import cam_mesh

        return cam_mesh(self.curve, self.blank, self.thickness, self.chord, self.rim_share)

    @property
    def printing(self) -> PrintCompensation | None:
        """Compensation of the files for printing; None for none."""
        return self.export.printing

    @property
    def holes(self) -> tuple[HoleOutline, ...]:
        """Bore and holes as the mesh has them."""
        from cadgen.geometry.meshes.printing import holes_of_disc

        return holes_of_disc(self.blank, self.chord)

    @cached_property
    def volume(self) -> float:
        """Volume for comparison with every file's, mm³: by the profile, or with a hub that of the exact solid."""
        if self.blank.hub is None:
            whole = self.blank.disc_volume(self.area, self.thickness)
            return whole - 2 * chamfered_off(self.curve, self.blank.edge_break)
        from cadgen.geometry.solids.kernel import volume

        return volume(self.part.solid)

    def judged(self, name: str, outline: Outline, limit: float, facts: Facts, off: float = 0.0) -> Artifact:
        """File whose outline was read back: the follower is rolled on it, and the lift must keep its limit.

        Only lifts rolled in equal steps are compared, for the error of rolling is then nearly the same in both.

        Args:
            name: name of the file.
            outline: outline read back from it, mm.
            limit: greatest error of the lift allowed, µm.
            facts: what else was read back.
            off: error of the lift that was found otherwise, µm.

        Raises:
            FileError: the error is beyond its limit.
        """
        difference, contact = self.exact.compare(outline)
        error = max(difference * 1e3, off)
        in_use = self.in_use(outline, contact, limit)
        if not error <= limit:
            raise FileError(
                "{file}, read back, moves the {follower} by {error:.2f} µm, more than the {limit:g} µm allowed: use "
                "finer tolerances in the design's [export]",
                file=name,
                follower=Message(self.follower.noun),
                error=error,
                limit=limit,
            )
        return Artifact(name, Facts(lift_error_um=error, lift_limit_um=limit) | facts, in_use=in_use)


@dataclass(frozen=True, kw_only=True, eq=False)
class GrooveExport:
    """Cam with a groove that is to be written, and the proof of its files: a roller as wide on both flanks.

    Attributes:
        inner: inner flank as a cam, with the features of the disc.
        outer: outer flank likewise, with the roller that is pressed outwards.
        depth: depth of the groove, mm.
        outside_radius: radius of the disc, mm.
    """

    inner: CamExport
    outer: CamExport
    depth: float
    outside_radius: float

    @property
    def stem(self) -> str:
        """Start of the names of its files."""
        return self.inner.stem

    @property
    def description(self) -> str:
        """Description in one line, for formats that have room for it."""
        return self.inner.description

    @property
    def thickness(self) -> float:
        """Distance of the disc's faces, mm."""
        return self.inner.thickness

    @property
    def step(self) -> float:
        """Distance of the points on flanks that are read back, mm."""
        return min(self.inner.step, self.outer.step)

    @property
    def chord(self) -> float:
        """Greatest chord error of the mesh, mm."""
        return self.inner.chord

    @property
    def width(self) -> float:
        """Width of the groove, mm."""
        return 2 * self.inner.follower.radius

    @cached_property
    def part(self) -> SolidPart:
        """The solid, for STEP."""
        from cadgen.geometry.solids.disc_solid import grooved_part

        return grooved_part(
            (self.inner.curve, self.outer.curve),
            self.inner.blank,
            self.thickness,
            self.depth,
            self.outside_radius,
            name=self.stem,
            description=self.description,
        )

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh, for STL and 3MF."""
        from cadgen.geometry.meshes.mesh import grooved_mesh

        return grooved_mesh(
            (self.inner.curve, self.outer.curve),
            self.inner.blank,
            self.thickness,
            self.depth,
            self.outside_radius,
            self.chord,
            min(self.inner.rim_share, self.outer.rim_share),
        )

    @property
    def printing(self) -> PrintCompensation | None:
        """Compensation of the files for printing; None for none."""
        return self.inner.printing

    @property
    def holes(self) -> tuple[HoleOutline, ...]:
        """Bore and holes as the mesh has them."""
        return self.inner.holes

    @cached_property
    def volume(self) -> float:
        """Volume for comparison with every file's, mm³."""
        blank = self.inner.blank
        disc = blank.disc_volume(pi * self.outside_radius**2, self.thickness) + blank.hub_volume()
        return float(disc - (self.outer.area - self.inner.area) * self.depth)

    def judged(self, name: str, flanks: Sequence[tuple[Outline, Outline]], limit: float, facts: Facts) -> Artifact:
        """File whose flanks were read back, the inner one first: a roller is rolled on both.

        Args:
            name: name of the file.
            flanks: inner and outer flank at each height that was read, mm.
            limit: greatest error of the lift allowed, µm.
            facts: what else was read back.

        Raises:
            FileError: the error is beyond its limit.
        """
        first = max(self.inner.exact.compare(inner)[0] for inner, _ in flanks) * 1e3
        last = [self.outer.judged(name, outer, limit, facts, off=first) for _, outer in flanks]
        return last[0]


@dataclass(frozen=True, kw_only=True, eq=False)
class GearExport:
    """Gear that is to be written, its axis on z, a tooth on x and its lower face at z = 0.

    Attributes:
        name: name of the gear and of its files, without their ending.
        form: numbers of its teeth.
        part: gear as a part by itself.
        chord: greatest chord error of its mesh, mm.
        shaft: number that decides its colour.
        printing: what files for printing take back; None for nothing.
    """

    name: str
    form: GearForm
    part: TrainPart
    chord: float
    shaft: int = 1
    printing: PrintCompensation | None = None

    @property
    def description(self) -> str:
        """Description in one line, for formats that have room for it."""
        sort = "helical" if self.form.helix_angle else "spur"
        return f"{sort} gear of {self.form.teeth} teeth, module {self.form.normal_module:g} mm"

    def solid(self) -> SolidPart:
        """The gear as a solid with name and colour."""
        from cadgen.geometry.solids.gear_solids import body_solid, colour_of_shaft
        from cadgen.geometry.solids.kernel import SolidPart

        solid, colour = body_solid(self.part.body), colour_of_shaft(self.shaft)
        return SolidPart(solid=solid, name=self.name, description=self.description, colour=colour)


@dataclass(frozen=True, kw_only=True, eq=False)
class RackExport:
    """Rack that is to be written, its reference line on x and its width upwards along z.

    Attributes:
        name: name of the rack and of its files, without their ending.
        form: numbers of its teeth.
        chord: greatest chord error of its mesh, mm.
        printing: what files for printing take back; None for nothing.
    """

    name: str
    form: RackForm
    chord: float
    printing: PrintCompensation | None = None
    holes: tuple[HoleOutline, ...] = ()

    @property
    def base(self) -> float:
        """Exact area of its lower face, mm²."""
        return self.form.area

    @property
    def description(self) -> str:
        """Description in one line, for formats that have room for it."""
        return f"rack of {self.form.teeth} teeth, module {self.form.normal_module:g} mm"

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh, for STL and 3MF."""
        from cadgen.geometry.meshes.mesh import body_mesh

        return body_mesh(self.form.body, self.chord)

    def solid(self) -> SolidPart:
        """The rack as a solid with name and colour."""
        from cadgen.geometry.solids.gear_solids import body_solid, colour_of_shaft
        from cadgen.geometry.solids.kernel import SolidPart

        solid, colour = body_solid(self.form.body), colour_of_shaft(2)
        return SolidPart(solid=solid, name=self.name, description=self.description, colour=colour)


@dataclass(frozen=True, kw_only=True, eq=False)
class TrainExport:
    """Gear train that is to be written; it can be handed to another process.

    Attributes:
        stem: start of the names of its files.
        description: one line for STEP files.
        layout: parts at their places.
        passed: whether the train keeps every check, so that its play must be the same over a pitch.
        chords: greatest chord error of each part's mesh, mm.
        table: rows of the table of parts.
        printing: what files for printing take back; None for nothing.
    """

    stem: str
    description: str
    layout: TrainLayout
    passed: bool
    chords: Sequence[float]
    table: Sequence[Mapping[str, str | float | None]]
    printing: PrintCompensation | None = None
