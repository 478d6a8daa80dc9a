"""A cam that has been computed and checked: its figures, its solid, its files."""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from cadgen.api.values import numbers, whole
from cadgen.arrays import TURN, Array
from cadgen.car.path_motion import PathMotion
from cadgen.design.schema import Design as DesignValues
from cadgen.design.schema import MotionDesign
from cadgen.errors import CheckError
from cadgen.figures import Facts, JobResult
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.comparison import PAPER_PERCENT as PAPER_PERCENT
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.cures import Cures as Cures
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import CarUse
from cadgen.output.files.publisher import Written, folder_of, refusal
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import Solid
    from cadgen.output.report.style import Figure

_POINTS = 3600
_CHORD = 0.01  # mm, of bore and holes on a picture


@dataclass(frozen=True, eq=False, repr=False)
class Lift:
    """Lift of the follower over one turn of the cam. Call it with cam angles to get the lift there.

    Attributes:
        computed: numeric plan of the cam.

    Example:
        >>> from math import radians
        >>> from cadgen import Design
        >>> lift = Design.load("carbon_free_car").cam(profile="actual").lift
        >>> round(float(lift(radians(90))), 3)
        4.566
    """

    computed: CamPlan

    def __repr__(self) -> str:
        return f"<Lift of {self.computed.origin.name}, {len(self.peaks)} peaks and {len(self.valleys)} valleys>"

    def __call__(self, cam_angle: ArrayLike) -> Array:
        """Lift at cam angles.

        Args:
            cam_angle: cam angles, rad, of any shape; beyond one turn the lift repeats.

        Returns:
            Lift, mm, of that shape: positive where the follower stands further out than at steering angle 0.

        Raises:
            DesignError: an angle is not a finite number.
        """
        angle = numbers("cam_angle", cam_angle, "rad") % TURN
        return np.asarray(self.computed.follower_as_built.lift(self.computed.motion.q(angle)))

    @cached_property
    def _extrema(self) -> tuple[Array, Array]:
        return self.computed.motion.extrema()

    @property
    def peaks(self) -> Array:
        """Cam angles of the peaks, rad, shape (p,), in order."""
        return self._extrema[0]

    @property
    def valleys(self) -> Array:
        """Cam angles of the valleys, rad, shape (q,), in order."""
        return self._extrema[1]

    @property
    def blend_start(self) -> float:
        """Cam angle from which the closing blend, and not the path, steers, rad; a whole turn on a closed path."""
        motion = self.computed.motion
        return min(motion.blend_start, TURN) if isinstance(motion, PathMotion) else TURN


@dataclass(frozen=True, eq=False, repr=False)
class Profile:
    """The closed curve that is cut, in the frame of the files: the camshaft at the origin.

    Attributes:
        computed: numeric plan of the cam.
    """

    computed: CamPlan

    @property
    def name(self) -> str:
        """Code of the profile, such as `optimized`."""
        return self.computed.kind.code

    @property
    def area(self) -> float:
        """Area inside the curve, mm²."""
        return self.computed.area

    @property
    def length(self) -> float:
        """Length of the curve, mm."""
        return self.computed.curve.length()

    def points(self, count: int = _POINTS) -> Array:
        """Points on the curve.

        Args:
            count: approximate number of points, 12 to 1 000 000.

        Returns:
            x and y, mm, shape (n, 2), counterclockwise seen on the face that files show, the first point not repeated.

        Raises:
            DesignError: the count is out of its range.
        """
        points = self.computed.curve.outline(self.length / whole("count", count, 12, 1_000_000)).points
        return points[:-1] if np.array_equal(points[0], points[-1]) else points

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"<Profile {self.name} of {self.computed.origin.name}, {self.length:.1f} mm long>"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Cam(CamPlan, JobResult):
    """A cam that has been computed and checked, but not yet made: what `Design.cam` gives.

    It is the numeric plan itself, with all its figures in mm and rad.

    Example:
        >>> from cadgen import Design
        >>> cam = Design.load("carbon_free_car").cam(profile="actual")
        >>> cam.sound, cam.passed  # the cam is right, but its car's play is too much for it
        (True, False)
        >>> cam.checks[0].name
        'pressure angle, rise'
        >>> files = cam.write("exports", formats=["step", "dxf"])  # doctest: +SKIP
    """

    @classmethod
    def of(cls, plan: CamPlan) -> "Cam":
        """A plan with its verbs.

        Args:
            plan: computed cam.
        """
        return plan if isinstance(plan, cls) else cls(**{item.name: getattr(plan, item.name) for item in fields(plan)})

    def __repr__(self) -> str:
        failed = f": {', '.join(check.name for check in self.failed)}" if self.failed else ""
        return f"<Cam of {self.origin.name}, {self.profile} profile, {self.verdict.readiness.words}{failed}>"

    @property
    def computed(self) -> CamPlan:
        """The whole plan, for figures that are not named here: this object itself."""
        return self

    @property
    def design(self) -> "DesignValues | MotionDesign":
        """Values of the design that it was planned from."""
        return self.application.design

    @property
    def car(self) -> CarUse:
        """Car that the cam steers, with its track, course and laps; mm and rad.

        Raises:
            DesignError: the cam is of a design with [motion].
        """
        return CarUse.of(self)

    @property
    def comparison(self) -> PlayComparison | None:
        """Comparison under play; None for a profile that is not for play, and without a car."""
        return self.application.comparison if isinstance(self.application, CarUse) else None

    @cached_property
    def lift(self) -> Lift:
        """Lift over the turn: a function of the cam angle (rad) in mm."""
        return Lift(self)

    @cached_property
    def profile(self) -> Profile:
        """Curve that is cut, with its name and its points (mm)."""
        return Profile(self)

    @cached_property
    def cures(self) -> Cures:
        """Changes of one key that bring lost lift within its limit, each proved by planning the cam again."""
        return find_cures(self)

    def find_cures(self, progress: Progress = silent) -> Cures:
        """Look for `cures` now, if lift is lost; it takes many plans.

        Args:
            progress: function that is called with a few words on each step.
        """
        if "cures" not in self.__dict__:
            self.__dict__["cures"] = find_cures(self, progress)
        return self.cures

    @property
    def wheel(self) -> str:
        """Radius of the drive wheel that the cam is for, and what the closing blend does to the path, in words."""
        return self.application.wheel

    @property
    def expected(self) -> str:
        """Expected run of the car on a cam of an as-built design, in a sentence; empty if nothing was measured."""
        return self.application.expected

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what was assumed, such as of the car, and what was measured."""
        return self.application.notes(self)

    def entry(self) -> Facts:
        """All facts on the cam, as in the manifest."""
        return cam_facts(self, self.cures)

    def plot(self) -> "Figure":
        """Draw outline and lift.

        Returns:
            A matplotlib figure, to be shown in a notebook or saved with `savefig`.
        """
        from cadgen.output.report.cam_pictures import CamPicture, cam_figure

        angle = np.linspace(0.0, TURN, _POINTS + 1)
        extrema = np.concatenate([self.lift.peaks, self.lift.valleys])
        return cam_figure(
            CamPicture(
                title=f"{self.origin.name}, {self.profile} profile",
                outline=self.profile.points(),
                openings=[contour.polygon(_CHORD) for contour in self.blank.inner_contours()],
                cam_angle=angle,
                lift=self.lift(angle),
                extrema=(extrema, self.lift(extrema)),
                blend_start=self.lift.blend_start,
                seen=self.computed.seen,
            )
        )

    def build123d(self) -> "Solid":
        """The cam as a build123d solid with label and colour, mm; z = 0 is the inner face.

        Raises:
            DesignError: a hole cuts into another one, into the hub or through the profile.
            CheckError: the chamfers of broken edges meet, or run out at a ridge.
            FileError: the CAD kernel does not make one valid solid.
        """
        from cadgen.jobs.cam.cam_files import cam_solid

        return cam_solid(self).build123d()

    def write(
        self,
        folder: str | PathLike[str],
        formats: str | Iterable[str] | None = None,
        *,
        force: bool = False,
        progress: Progress = silent,
    ) -> Written:
        """Write files, read each back, roll the follower on it, and publish all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            formats: some of step, stl, 3mf, dxf, nc, xyz and csv; all of them if left out.
            force: whether files are written even if a check fails; the manifest then says so.
            progress: function that is called with a few words on each step.

        Returns:
            The files, each with its error at the follower's lift, µm.

        Raises:
            CheckError: a check fails.
            DesignError: a format is unknown.
            FileError: a file cannot be written, or holds something else when it is read back.
        """
        from cadgen.jobs.cam.cam_files import write_cam

        place = folder_of(folder)
        if not (self.sound or force):
            raise CheckError(refusal(self.failed))
        return write_cam(self, place, self.find_cures(progress), progress, formats)
