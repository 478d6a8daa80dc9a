"""The leaning rod as a follower.

In the face plane w the rod clears a point x ahead of the camshaft and y across when
    x <= a + w T - h sqrt(1 + T^2),  h^2 = r^2 - y^2,  T = tan(beta),
so the least T that clears it is the greater root of a quadratic,
    T = (w u + h sqrt(u^2 + w^2 - h^2)) / (w^2 - h^2),  u = x - a.
Between the faces the bound is linear in w, so the faces decide.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.cam.follower import Branch, Follower, Remedy, RolledCam, Swept
from cadgen.cam.followers.rod_checks import rod_checks
from cadgen.cam.followers.rod_envelope import EnvelopePiece, refuse_thick_rod, rod_arc
from cadgen.cam.followers.rod_geometry import RodGeometry
from cadgen.cam.followers.rod_profiles import theoretical_profile
from cadgen.check import Check
from cadgen.curves.closed import ClosedCurve
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import TAN


@dataclass(frozen=True, kw_only=True)
class LeaningRod(RodGeometry, Follower):
    """The rod on the two planes of a disc, as a follower; its attributes are those of `RodGeometry`."""

    noun = "rod"
    unit = TAN
    flatter = "raise cam.base_radius_mm, widen the turn there, or raise cam.blend_deg if the closing blend steers there"
    milder = "lower follower.radius_mm or raise cam.base_radius_mm"

    @property
    def planes(self) -> tuple[float, float]:
        """The inner and the outer carrying plane, mm from the fork axis."""
        return self.inner, self.outer

    @property
    def reach(self) -> float:
        """The rod's radius, mm."""
        return self.radius

    def of_lift(self, lift: Array) -> tuple[Array, Array, Array]:
        """tan(beta), the carrying face and the margin by lift of the axis, mm.

        Args:
            lift: lifts of the axis, mm, shape (n,).
        """
        face = self.contact_face(lift)
        q = lift / face
        return q, face, self.land * np.abs(q)

    def refuse(self, motion: Motion) -> None:
        """Refuse a lift for which the rod is too thick."""
        refuse_thick_rod(motion, self)

    def piece(self, motion: Motion, face: float, start: float, stop: float) -> EnvelopePiece:
        """The envelope of the rod's ellipse in a plane between two cam angles, rad.

        Args:
            motion: motion wanted.
            face: distance of the plane from the fork axis, mm.
            start: cam angle at which it begins, rad.
            stop: cam angle at which it ends, rad.
        """
        return EnvelopePiece(motion=motion, follower=self, face=face, start=start, stop=stop)

    def section(self, before: Swept, after: Swept) -> Branch | None:
        """The rod's ellipse at a hollow kink."""
        assert isinstance(before, EnvelopePiece)
        assert isinstance(after, EnvelopePiece)
        return rod_arc(before, after)

    def pitch_curve(self, motion: Motion) -> ClosedCurve:
        """The curve of the rod's axis: the theoretical profile."""
        return theoretical_profile(motion, self)

    def point(self) -> "LeaningRod":
        """The rod's axis."""
        return replace(self, radius=0.0)

    def remedies(self) -> tuple[Remedy, ...]:
        """A thinner rod and a larger base circle."""
        return (
            Remedy("follower.radius_mm", self.radius, False, lambda value: replace(self, radius=value)),
            Remedy("cam.base_radius_mm", self.base_radius, True, lambda value: replace(self, base_radius=value)),
        )

    def least(self, x: Array, y: Array) -> tuple[Array, ...]:
        """The least tan(beta) at which the rod clears points, in each face plane (see the module's equation).

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
        """
        u = x - self.base_radius
        under, h = _under(y, self.radius)
        return tuple(np.where(under, _clearing(u, h, face), -np.inf) for face in self.planes)

    def most(self, x: Array, y: Array, off: Array) -> tuple[Array, ...]:
        """Bound over all points within `off` (mm), from a point at x + off and |y| - off (mm).

        Args:
            x: coordinates along the ray from the camshaft, mm, shape (n,).
            y: coordinates across it, mm, shape (n,).
            off: distance within which other points may lie, mm, shape (n,).
        """
        near, h = _under(np.maximum(np.abs(y) - off, 0.0), self.radius)
        u = x - self.base_radius + off
        return tuple(np.where(near, _clearing(u, h, face), -np.inf) for face in self.planes)

    def pressure_angle(self, q: Array, across: Array) -> Array:
        """Pressure angle, rad: the axis moves horizontally and the force is square to it, so its sine is y / r.

        Args:
            q: tangents of the rod's steering angle, shape (n,).
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """
        return np.asarray(np.arcsin(np.clip(across / self.radius, -1.0, 1.0)))

    def distance(self, q: Array, face: Array) -> Array:
        """Distance of the rod's axis from the camshaft in a plane, mm.

        Args:
            q: tangents of the rod's steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """
        return np.asarray(self.base_radius + face * q)

    def ahead(self, q: Array, face: Array, across: Array) -> Array:
        """How far ahead of the camshaft the rod touches, mm.

        Args:
            q: tangents of the rod's steering angle, shape (n,).
            face: distance of the plane from the fork axis, mm.
            across: distances of the contact from the ray's middle, mm, shape (n,).
        """
        half = np.sqrt(np.maximum(self.radius**2 - across**2, 0.0) * (1 + q**2))
        return np.asarray(self.base_radius + face * q - half)

    def margin(self, apart: Array, face: Array) -> Array:
        """Lift of a difference of tan(beta), mm.

        Args:
            apart: differences of tan(beta) between two planes, shape (n,).
            face: distance of the plane from the fork axis, mm.
        """
        return face * apart

    def checks(self, cam: RolledCam) -> tuple[Check, ...]:
        """Carrying face, rim, chamfers and hub."""
        return rod_checks(self, cam)


def _clearing(u: Array, h: Array, face: float) -> Array:
    """The least tan(beta) at which the rod clears a point in a face plane (see the module's equation)."""
    square = h * h
    return np.asarray((face * u + h * np.sqrt(u * u + (face**2 - square))) / (face**2 - square))


def _under(y: Array, radius: float) -> tuple[NDArray[np.bool_], Array]:
    """Whether points lie under the rod, and the rod's half-height h there, mm; 0 beside it."""
    under = np.abs(y) < radius
    return under, np.sqrt(np.where(under, radius**2 - y**2, 0.0))


def rod_of(follower: Follower, job: str, instead: str = "") -> LeaningRod:
    """The follower as the leaning rod, for a job that is worked out for the rod alone.

    Args:
        follower: follower of any kind.
        job: name of the job, as it begins a sentence.
        instead: alternative for a design with this follower, as it ends a sentence.

    Raises:
        DesignError: the follower is of another kind.
    """
    if isinstance(follower, LeaningRod):
        return follower
    way_out = f", or {instead}" if instead else ""
    raise DesignError(
        f"follower.kind names a {follower.noun}, and {job} is worked out for the leaning rod alone: set "
        f'follower.kind = "rod" with its keys{way_out}'
    )
