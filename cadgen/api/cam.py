"""A cam that has been computed and checked: its figures, its solid, its files."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from math import radians
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from cadgen.api.loaded import overrides_of
from cadgen.api.values import numbers, real, whole
from cadgen.arrays import TURN, Array
from cadgen.car.path_motion import PathMotion
from cadgen.check import CheckCode, CheckList
from cadgen.design import load
from cadgen.design.override import KeyChange
from cadgen.design.schema import Design as DesignValues
from cadgen.design.schema import MotionDesign
from cadgen.errors import CheckError, DesignError
from cadgen.figures import Facts
from cadgen.jobs.cam.cam_facts import cam_facts
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.cures import Cures as Cures
from cadgen.jobs.cam.cures import find_cures
from cadgen.laws.unit import MM
from cadgen.output.files.publisher import Written, folder_of, refusal
from cadgen.output.report.notebook import Pictured, Plotted, Viewed, lines_picture
from cadgen.output.report.shape_pictures import Filled, shapes_picture
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.api.motion_cam import AnyFollower, Motion, Spring
    from cadgen.cam.forces import CamForces
    from cadgen.geometry.solids.kernel import Solid
    from cadgen.jobs.cam.comparison import PlayComparison
    from cadgen.jobs.cam.steering_cam import CarUse
    from cadgen.output.report.style import Drawing

_POINTS = 3600
_CHORD = 0.01  # mm, of bore and holes on a picture


@dataclass(frozen=True, eq=False, repr=False)
class Lift(Plotted):
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
    def picture(self) -> "Drawing":
        """Lift over the turn."""
        angle = np.linspace(0.0, TURN, _POINTS + 1)
        lifts = {"lift": self(angle)}
        return lines_picture(
            f"{self.computed.origin.name}: lift", "cam angle (°)", "lift (mm)", np.degrees(angle), lifts, signed=True
        )

    @property
    def blend_start(self) -> float:
        """Cam angle from which the closing blend, and not the path, steers, rad; a whole turn on a closed path."""
        motion = self.computed.motion
        return min(motion.blend_start, TURN) if isinstance(motion, PathMotion) else TURN


@dataclass(frozen=True, eq=False, repr=False)
class Profile(Plotted):
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

    @property
    def picture(self) -> "Drawing":
        """Curve that is cut, with bore and holes."""
        openings = [contour.polygon(_CHORD)[::-1] for contour in self.computed.blank.inner_contours()]
        title = f"{self.computed.origin.name}, {self.name} profile"
        return shapes_picture(title, {"": [Filled([self.points(), *openings])]})

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"<Profile {self.name} of {self.computed.origin.name}, {self.length:.1f} mm long>"


@dataclass(frozen=True)
class Extremes:
    """Greatest and least value of a figure over the turn."""

    greatest: float
    least: float


@dataclass(frozen=True, repr=False)
class FollowerForces(Plotted):
    """Forces on a follower and its camshaft, in N and mm; of a swinging follower moments, N mm.

    Attributes:
        computed: forces as functions of the motion.
    """

    computed: "CamForces"

    def __repr__(self) -> str:
        return f"<FollowerForces, {self.normal.least:.4g} to {self.normal.greatest:.4g} N on the disc>"

    @property
    def normal(self) -> Extremes:
        """Force on the disc along the normal of its outline, N."""
        return self._extremes(self.computed.normal)

    @property
    def torque(self) -> Extremes:
        """Torque that turns the camshaft, N mm."""
        return self._extremes(self.computed.torque)

    @property
    def mean_torque(self) -> float:
        """Mean torque of the camshaft, N mm."""
        return self.computed.mean_torque

    @property
    def pressure(self) -> float | None:
        """Greatest Hertz pressure in the line of contact, steel on steel, MPa; None for a contact that is no line."""
        line = self.computed.dynamics.line
        return None if line is None else self._extremes(self.computed.pressure).greatest

    @property
    def lift_off_rpm(self) -> float:
        """Least speed at which the follower leaves the disc, rev/min; infinite if it leaves at none."""
        return self.computed.lift_off.value * 60 / TURN

    @property
    def leaves(self) -> tuple[tuple[float, float], ...]:
        """Cam angles from which and to which the follower has left the disc, or is on the other flank or disc, rad."""
        return self.computed.leaves

    @property
    def least_rate(self) -> float | None:
        """Least rate of the spring that holds the follower with its preload, N/mm or N mm/rad; None if none does."""
        return self.computed.least_rate()

    @property
    def least_preload(self) -> float | None:
        """Least preload that holds the follower with the spring's rate, N or N mm; None if it is not proved."""
        return self.computed.least_preload()

    @property
    def picture(self) -> "Drawing":
        """Force on the disc and torque of the camshaft over the turn."""
        from cadgen.output.report.cam_pictures import forces_picture

        angle = np.linspace(0.0, TURN, _POINTS + 1)
        jets = self.computed.motion.jets(angle)
        return forces_picture(angle, self.computed.normal(jets, angle), self.computed.torque(jets, angle))

    def _extremes(self, figure: "Callable[[Array, Array], Array]") -> Extremes:
        most, least = self.computed.motion.extremes_of(figure)
        return Extremes(most.value, least.value)


@dataclass(frozen=True, eq=False, repr=False, init=False)
class Cam(CamPlan, Pictured, Viewed):
    """A cam that has been computed and checked, but not yet made: what `Design.cam` gives, or a motion and a follower.

    It is the numeric plan itself, with all its figures in mm and rad.

    Args:
        motion: motion of the follower.
        follower: `Roller`, `KnifeEdge`, `Flat`, `SwingingRoller`, `SwingingFlat`; or the keys of [follower] of any.
        base_circle_radius: radius of the base circle, mm.
        pressure_angle: greatest pressure angle, rad, in place of that radius: the least one that keeps it is taken.
        thickness: thickness of the disc, mm.
        bore: diameter of the bore, mm; the usual one if left out.
        name: name of the cam and its files.
        changes: other keys of a design file, such as `{"blank.hub.diameter_mm": 20}`.

    Raises:
        DesignError: values that are not allowed; the message names the key of a design file.

    Example:
        >>> from cadgen import Design
        >>> cam = Design.load("carbon_free_car").cam(profile="actual")
        >>> cam.sound, cam.passed  # the cam is right, but its car's play is too much for it
        (True, False)
        >>> cam.checks[0].name
        'pressure angle, rise'
        >>> files = cam.write("exports", formats=["step", "dxf"])  # doctest: +SKIP
    """

    def __init__(
        self,
        motion: "Motion",
        follower: "AnyFollower",
        *,
        base_circle_radius: float | None = None,
        pressure_angle: float | None = None,
        thickness: float,
        bore: float | None = None,
        name: str = "cam",
        changes: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        from cadgen.api.motion_cam import cam_toml
        from cadgen.jobs.cam.motion_cam import plan_motion_cam

        text = cam_toml(motion, follower, base_circle_radius, pressure_angle, thickness, bore, name)
        design = load.complete_of(text, Path(), tuple(map(KeyChange, overrides_of(changes))))  # of no file
        assert isinstance(design, MotionDesign)  # it has [motion]
        self._take(plan_motion_cam(design.model_copy(update={"source": f"{name}.toml"}), None))

    def _take(self, plan: CamPlan) -> None:
        for item in fields(CamPlan):
            object.__setattr__(self, item.name, getattr(plan, item.name))
        object.__setattr__(self, "checks", CheckList(plan.checks))

    @classmethod
    def of(cls, plan: CamPlan) -> "Cam":
        """A plan with its verbs.

        Args:
            plan: computed cam.
        """
        if isinstance(plan, cls):
            return plan
        cam = object.__new__(cls)
        cam._take(plan)
        return cam

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
    def car(self) -> "CarUse":
        """Car that the cam steers, with its track, course and laps; mm and rad.

        Raises:
            DesignError: the cam is of a design with [motion].
        """
        from cadgen.jobs.cam.steering_cam import CarUse  # only here: a cam by its motion needs nothing of a car

        return CarUse.of(self)

    @property
    def comparison(self) -> "PlayComparison | None":
        """Comparison under play; None for a profile that is not for play, and without a car."""
        return None if isinstance(self.design, MotionDesign) else self.car.comparison

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
    def pressure_angle(self) -> Extremes:
        """Greatest pressure angle of rise and return, the larger and the smaller one, rad."""
        codes = (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN)
        both = [radians(check.value) for check in self.checks if check.code in codes]
        return Extremes(max(both), min(both))

    @property
    def least_radius(self) -> float:
        """Least convex radius of the profile, mm."""
        (radius,) = (check.value for check in self.checks if check.code == CheckCode.CONVEX_RADIUS_PROFILE)
        return radius

    def forces(
        self,
        rpm: float,
        *,
        mass: float = 0.0,
        inertia: float = 0.0,
        spring: "Spring | None" = None,
        load: float = 0.0,
        damping: float = 0.0,
    ) -> FollowerForces:
        """Forces on follower, spring and camshaft, without weight and friction, which `[dynamics]` has, too.

        Args:
            rpm: speed of the camshaft, rev/min.
            mass: mass of all that moves with a slide, kg.
            inertia: moment of inertia of a swinging follower about its pivot, kg mm².
            spring: spring that holds it.
            load: load against the motion, N or N mm.
            damping: damping of a slide, N s/m, or of an arm, N mm s/rad.

        Raises:
            DesignError: a number out of its range, a mass of an arm, or a follower whose forces are not worked out.
        """
        from cadgen.api.motion_cam import Spring
        from cadgen.cam.forces import CamForces, Dynamics, Line, joint_modulus
        from cadgen.design.dynamics import STEEL, closed_by_form

        slides, spring = self.motion.unit == MM, spring or Spring()
        if (inertia if slides else mass) != 0:
            raise DesignError(
                "a follower on a slide has a mass, and one on an arm a moment of inertia: give the other one"
            )
        keys, kind, seat = self.design.follower.keys, self.design.follower.registered, self.design.seat
        roller, second, groove = kind.follower(keys, seat), kind.second(keys, seat), kind.groove(keys, seat)
        radius, width = getattr(roller, "radius", 0.0), self.faces[1] - self.faces[0]
        line = Line(
            width=width if groove is None else groove.depth,
            modulus=joint_modulus(STEEL, STEEL),
            radius=radius,
            other_radius=getattr(second or roller, "radius", 0.0),
        )
        dynamics = Dynamics(
            # kg to N s²/mm, kg mm² to N mm s²; N s/m to N s/mm.
            inertia=real("mass or inertia", mass or inertia, 0, 1e9) * 1e-3,
            rate=real("rate", spring.rate, 0, 1e9),
            preload=real("preload", spring.preload, -1e7, 1e7),
            load=real("load", load, -1e7, 1e7),
            damping=real("damping", damping, 0, 1e9) * (1e-3 if slides else 1.0),
            line=line if radius else None,
        )
        speed, closed = real("rpm", rpm, 0, 1e6, "rev/min") * TURN / 60, closed_by_form(keys)
        return FollowerForces(CamForces(self.motion, self.follower_as_built, dynamics, speed, closed, second))

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

    @property
    def picture(self) -> "Drawing":
        """Outline and lift."""
        from cadgen.output.report.cam_pictures import CamPicture, cam_picture

        angle = np.linspace(0.0, TURN, _POINTS + 1)
        extrema = np.concatenate([self.lift.peaks, self.lift.valleys])
        return cam_picture(
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
