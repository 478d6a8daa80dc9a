"""Profiles given by a polar formula: the theoretical one and that of the paper's appendix."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import span_jets
from cadgen.cam.followers.rod_geometry import RodGeometry, rod_half_width
from cadgen.cam.lowest import SAME
from cadgen.curves.closed import ClosedCurve, Jet, Piece
from cadgen.curves.piecewise import zeros
from cadgen.laws.motion import Motion


@dataclass(frozen=True)
class PolarPiece:
    """R(phi) = a + w T(phi) - r sqrt(1 + T(phi)^2), with T = tan(beta), over a span without kinks.

    With r = 0 this is the theoretical profile in the face plane w; with the rod's radius, the formula of the
    paper's appendix, which subtracts the rod's half-width along the cam's radius.
    """

    motion: Motion
    base_radius: float
    face: float
    rod_radius: float
    start: float
    stop: float

    def jet(self, t: Array) -> Jet:
        """Point (mm), velocity by the polar angle t (rad), and curvature.

        Args:
            t: polar angles, rad, shape (n,).
        """
        T, T1, T2 = span_jets(self.motion, t, self.start, self.stop)
        A, A1, A2 = rod_half_width(self.rod_radius, T, T1, T2)
        R = self.base_radius + self.face * T - A
        R1, R2 = self.face * T1 - A1, self.face * T2 - A2
        radial = np.stack([np.cos(t), np.sin(t)], axis=1)
        around = np.stack([-np.sin(t), np.cos(t)], axis=1)
        speed2 = R**2 + R1**2
        return Jet(
            R[:, None] * radial,
            R1[:, None] * radial + R[:, None] * around,
            (R**2 + 2 * R1**2 - R * R2) / speed2**1.5,
        )


def theoretical_profile(motion: Motion, follower: RodGeometry) -> ClosedCurve:
    """R = a + s: where the rod's axis crosses the plane of the face it rests on (paper, section 2.5)."""
    return _polar_profile(motion, follower, rod_radius=0.0)


def published_profile(motion: Motion, follower: RodGeometry) -> ClosedCurve:
    """The profile by the formula of the paper's appendix.

    It is not the envelope: the rod touches beside the ray, not on it, so it rides up to 0.30 mm too high on the
    paper's car (0.27 mm at the inner face). It is offered for comparison.
    """
    return _polar_profile(motion, follower, rod_radius=follower.radius)


def _polar_profile(motion: Motion, follower: RodGeometry, *, rod_radius: float) -> ClosedCurve:
    inside = _face_changes(motion, follower)
    joints = np.unique(np.concatenate([[0.0], motion.kinks, inside[(inside > 0) & (inside < TURN)], [TURN]]))
    nodes, _ = motion.stations
    pieces: list[Piece] = []
    for start, stop in pairwise(joints):
        theta = np.append(nodes[(nodes > start) & (nodes < stop)], (start + stop) / 2)
        q = motion.q(theta)
        face = float(follower.contact_face(q[np.argmax(np.abs(q))]))
        pieces.append(PolarPiece(motion, follower.base_radius, face, rod_radius, float(start), float(stop)))
    return ClosedCurve(tuple(pieces))


def _face_changes(motion: Motion, follower: RodGeometry) -> Array:
    """Cam angles at which the rod goes over to the other face, rad.

    Where the steering is straight over a stretch tan(beta) changes its sign by rounding: a change counts if between
    it and the next one the two faces' radii differ by more than `SAME`.
    """
    roots = zeros(motion.q, jumps=True)
    roots = np.unique(roots[np.isfinite(roots)])
    nodes, T = motion.stations
    clear = np.flatnonzero(np.abs(T) * follower.land > SAME)
    changed = np.flatnonzero(np.diff(np.sign(T[clear])) != 0)
    before, after = nodes[clear[changed]], nodes[clear[changed + 1]]
    # Of several roots in a row the last one before the steering is clear again.
    last = np.searchsorted(roots, after) - 1
    return roots[last[(last >= 0) & (roots[last] > before)]]
