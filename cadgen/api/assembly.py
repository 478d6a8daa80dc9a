"""A car put together, and its frame: parts, mass and checks, and their files."""

from dataclasses import dataclass
from functools import cached_property
from math import radians
from os import PathLike

import numpy as np
from shapely.geometry.polygon import orient

from cadgen.api.values import real
from cadgen.car.assembly.car_parts import CarPart, Content
from cadgen.check import Check, CheckList, failing
from cadgen.errors import CheckError
from cadgen.figures import Facts
from cadgen.jobs.assembly_checks import assembly_verdict
from cadgen.jobs.car_assembly import CarAssembly
from cadgen.jobs.car_frame import CarFrame, checks_in_car
from cadgen.output.files.publisher import Written, folder_of, refusal
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.shape_pictures import Filled, shapes_picture
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent


@dataclass(frozen=True, eq=False, repr=False)
class AssembledCar(Pictured):
    """A car put together: what `Design.assembly` gives. Lengths are mm, masses g.

    Attributes:
        computed: parts at their places.
    """

    computed: CarAssembly

    def __repr__(self) -> str:
        return f"<AssembledCar of {self.computed.origin.name}, {self.count} parts>"

    @property
    def parts(self) -> tuple[CarPart, ...]:
        """Parts, once for each kind."""
        return self.computed.parts

    @property
    def count(self) -> int:
        """Number of parts in all."""
        return sum(part.quantity for part in self.parts)

    @cached_property
    def own_checks(self) -> tuple[Check, ...]:
        """Checks of the car: its parts at their places, tipping, energy."""
        return (*checks_in_car(self.computed.layout), *assembly_verdict(self.computed).checks)

    @property
    def checks(self) -> CheckList:
        """Checks of the cam itself, of the gears and of the car."""
        own = self.own_checks
        others = (*self.computed.cam.checks, *self.computed.train.checks)
        return CheckList((*(check for check in others if check not in own), *own))

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not self.failed

    def balance(self, cam_angle_deg: float = 0.0) -> Content:
        """Mass of the car, and its centre in the frame of the camshaft: x ahead, y down, z to the left.

        Args:
            cam_angle_deg: cam angle, degrees.
        """
        return self.computed.balance(_angle(cam_angle_deg))

    @property
    def picture(self) -> Drawing:
        """Car from the left and from above, at cam angle 0."""
        from cadgen.jobs.assembly_files import silhouettes

        car = self.computed
        colors = {part.code: part.colour for part in car.parts}
        views = {
            str(name): [Filled(each.rings, colors[each.code]) for each in sorted(found, key=lambda each: each.near)]
            for name, found in silhouettes(car, 0.0).items()
        }
        return shapes_picture(car.origin.name, views)

    def entry(self) -> Facts:
        """Parts, masses and places, as in the manifest."""
        from cadgen.jobs.assembly_files import assembly_facts

        return assembly_facts(self.computed, 0.0)

    def write(
        self,
        folder: str | PathLike[str],
        cam_angle_deg: float = 0.0,
        *,
        force: bool = False,
        progress: Progress = silent,
    ) -> Written:
        """Write STEP, list of parts, sheet and steps of mounting, and publish all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            cam_angle_deg: cam angle at which moving parts stand, degrees.
            force: whether files are written even if a check fails.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: a check fails.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.jobs.assembly_files import write_assembly

        place, angle = folder_of(folder), _angle(cam_angle_deg)
        if not (self.passed or force):
            raise CheckError(refusal(self.failed))
        return write_assembly(self.computed, place, angle, progress)


@dataclass(frozen=True, eq=False, repr=False)
class FramedCar(Pictured):
    """The frame of a car: what `Design.frame` gives. Lengths are mm.

    Attributes:
        computed: plates, base, platform, brackets and block at their places.
    """

    computed: CarFrame

    def __repr__(self) -> str:
        return f"<FramedCar of {self.computed.design.name}>"

    @property
    def layout_checks(self) -> tuple[Check, ...]:
        """Checks of the parts that the frame holds."""
        return self.computed.layout.checks

    @property
    def own_checks(self) -> tuple[Check, ...]:
        """Checks of the frame itself."""
        return self.computed.own_checks

    @property
    def checks(self) -> CheckList:
        """Checks of the parts in the car and of the frame."""
        return CheckList(self.computed.checks)

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not failing(self.checks)

    @property
    def sentence(self) -> str:
        """Size of the frame in words."""
        return self.computed.sentence

    @property
    def bought(self) -> list[tuple[str, str, int]]:
        """Bought parts: code, name and how many."""
        return self.computed.bought

    @property
    def picture(self) -> Drawing:
        """Sheets of the frame."""
        faces = {panel.name: orient(panel.face()) for panel in self.computed.frame.panels}
        views = {
            name: [Filled([np.asarray(ring.coords) for ring in (face.exterior, *face.interiors)])]
            for name, face in faces.items()
        }
        return shapes_picture(self.computed.stem, views)

    def entry(self) -> Facts:
        """Frame, as in the manifest."""
        return self.computed.entry()

    def write(self, folder: str | PathLike[str], *, force: bool = False, progress: Progress = silent) -> Written:
        """Write outlines, solids, programs and sheets, read them back, and publish all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            force: whether files are written even if a check fails.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: a check fails.
            DesignError: the cutter is too large for a sheet.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.jobs.frame_writer import write_frame

        place = folder_of(folder)
        if not (self.passed or force):
            raise CheckError(refusal(failing(self.checks)))
        return write_frame(self.computed, place, progress)


def _angle(cam_angle_deg: float) -> float:
    """Cam angle in rad."""
    return radians(real("cam_angle_deg", cam_angle_deg, 0, 360, "degrees"))
