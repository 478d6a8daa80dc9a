"""Forces that turn the cam ahead of its gears or hold it: the rod's force, friction and drag.

On a fall the rod turns the cam ahead, and friction at the contact and drag hold it. The rod touches the edge of a
face, at w from the fork axis, and the fork turns with the cam. The normal n at the contact P is square to the rod, and
along it disc and rod move alike; alpha, its angle in the plane of the face, is the pressure angle. Let T = tan(beta),
s = w T, s' = w dT/dtheta, d = a + s, k = sqrt(1 + T^2 cos^2(alpha)), and r the rod's radius.

    P is at x = d - r (1 + T^2) cos(alpha) / k and y = r sin(alpha) / k from the camshaft.
    tan(alpha) = -s' (1 - r T cos(alpha) / (k w)) / (d - r T^2 cos(alpha) / k).
    v = the disc's velocity at P less the rod's, per radian of the cam.

With friction mu against v, the rod, pressed by the force F along the lift, is in balance if the normal force is
    N = F / (n . u + mu v . u / |v|),  u = the rod's velocity at P per mm of lift,
and the torque of F that friction does not take turns the cam ahead: M = -F s' - mu N |v|. For a rod that does not lean
this is M = N (d sin(alpha) - mu (d cos(alpha) - r)) with N = F / (cos(alpha) + mu sin(alpha)).

Leaning makes N greater by 1 / cos(beta), and by w / (w - r sin(beta)): the contact's normal meets the rod's axis nearer
to the fork in a right turn and farther off in a left one. This is 4 % at 11 degrees to the right, and nothing to the
left. On the paper's car it moves the end of the run by up to 9 mm at friction up to 0.15, and by 28 mm at 0.2. From 0.3
on, where the cam leads in left turns alone, it is 2 mm.

The cam leads where M is greater than the drag; friction is that of sliding, for when a fall begins the gears already
slide the disc under the rod. See `cadgen.car.running.play` for what the cam does with it. Inertia is left aside: at 8
degrees/s and 1 N that of the paper's cam delays each lead by 0.6 degrees, 3 mm at the end without friction and 9 mm at
0.3.
"""

from dataclasses import dataclass, replace
from math import radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import LEAST_SWING, Following, falls, follow

_STEP = radians(0.05)  # between stations: torque and drag meet at most once from one to the next
_ZOOM = 64  # stations between two; interpolation between those errs by less than 1e-8 rad
_LEAN_STEPS = 4  # to the pressure angle of a leaning rod; each takes a hundredth of the error
# Frictions of a band at which a run is looked at: the worst end of a compensated profile lies at an end of the band (on
# the paper's car, looked at in steps of 0.01).
_FRICTIONS = 6
# Range of a measured friction, two standard deviations to either side, that one profile serves. Root mean squares of
# the end over cars of a normal distribution, on two paths: with 0.024, 3.4 mm, and 5.6 if it is made for half of the
# range (five draws); with 0.036 to 0.12 half of it is better in 13 of 15, and with 0.12 leaves 78 mm in place of 114.
_WELL_KNOWN = 0.03
_FINE_FRICTION = 0.01  # step of friction where the worst may lie within the band


@dataclass(frozen=True)
class Levers:
    """Lever arms of the rod's normal force on the cam, and its shares along the lift, at n cam angles.

    The torque ahead is N (driving - mu holding), and N = F / (along + mu across).

    Attributes:
        driving: lever arm of the normal force, shape (n,), mm; negative on a rise.
        holding: lever arm of the friction, shape (n,), mm.
        along: share of the normal force along the lift, shape (n,).
        across: share of the friction along the lift, shape (n,); negative on a rise.
        lift: lift s, shape (n,), mm.
    """

    driving: Array
    holding: Array
    along: Array
    across: Array
    lift: Array


def levers(lift: PathMotion, follower: EdgeFollower, theta: Array) -> Levers:
    """Levers of the rod's force on a cam at cam angles, rad.

    Args:
        lift: lift of the cam.
        follower: rod.
        theta: cam angles, rad, shape (n,).
    """
    T, slope = lift.q(theta), lift.q(theta, nu=1)
    w, r = follower.contact_face(T), follower.radius
    d, growth, stretch = follower.base_radius + w * T, w * slope, 1 + T**2
    c, s = _cosine_and_sine(d, -growth)  # of alpha
    for _ in range(_LEAN_STEPS):
        shift = r * T * c / np.sqrt(1 + (T * c) ** 2)
        c, s = _cosine_and_sine(d - T * shift, -growth * (1 - shift / w))
    k = np.sqrt(1 + (T * c) ** 2)
    x, y = d - r * stretch * c / k, r * s / k
    # Of the rod at the contact per mm of lift, along x and w; of the disc against it per radian of the cam.
    rod_x, rod_w = 1 / stretch, (follower.base_radius - x) / (w * stretch)
    v_x, v_w = -y - growth * rod_x, -growth * rod_w
    slide = np.sqrt(v_x**2 + x**2 + v_w**2)
    along = (c * rod_x - T * c * rod_w) / k
    across = (v_x * rod_x + v_w * rod_w) / slide
    return Levers(
        driving=-growth * along,
        holding=slide + growth * across,
        along=along,
        across=across,
        lift=np.asarray(w * T),
    )


def _cosine_and_sine(x: Array, y: Array) -> tuple[Array, Array]:
    """Cosine and sine of the direction of vectors (x, y), without the angle, which takes twice the time."""
    size = np.sqrt(x**2 + y**2)
    return x / size, y / size


def holding_friction(lift: PathMotion, follower: EdgeFollower) -> tuple[float, float]:
    """Least friction with which a cam without drag never leads while the car drives, and the deciding cam angle, rad.

    Args:
        lift: lift of the cam.
        follower: the rod and the faces.
    """
    theta = np.arange(0.0, min(lift.blend_start, TURN), _STEP)
    at = levers(lift, follower, theta)
    needed = np.where(at.driving > 0, at.driving / at.holding, 0.0)
    most = int(np.argmax(needed))
    return float(needed[most]), float(theta[most])


@dataclass(frozen=True, kw_only=True)
class Mechanics:
    """Forces on the cam of one car.

    Attributes:
        follower: the rod and the faces.
        rod_force: force F along the lift at zero lift, N: the spring's, less what fork and wheel hold back on a fall.
        rod_rate: rate by which the force grows with the lift, N/mm.
        friction: coefficient of sliding friction between rod and disc.
        drag: torque against the motion of the cam, N mm.
        behind: play between brake and cam, rad; 0 if the disc itself is braked.
    """

    follower: EdgeFollower
    rod_force: float = 1.0
    rod_rate: float = 0.0
    friction: float = 0.0
    drag: float = 0.0
    behind: float = 0.0

    def force(self, lift: Array) -> Array:
        """Force of the rod along the lift, N, at lifts in mm.

        Args:
            lift: lifts, mm.
        """
        return self.rod_force + self.rod_rate * np.asarray(lift)

    def torque(self, lift: PathMotion, theta: Array) -> Array:
        """Torque M that turns the cam ahead at cam angles (rad), N mm.

        Negative where the gears must push it, and -inf where no push turns it: a rise on which the rod jams.

        Args:
            lift: lift of the cam.
            theta: cam angles, rad, shape (n,).
        """
        return self._torque(levers(lift, self.follower, theta))

    def _torque(self, at: Levers) -> Array:
        against = at.along + self.friction * at.across
        free = against > 0
        normal = self.force(at.lift) / np.where(free, against, 1.0)
        return np.where(free, normal * (at.driving - self.friction * at.holding), -np.inf)

    def needed(self, lift: PathMotion, theta: Array) -> Array:
        """Torque that the gears must give the cam at cam angles (rad), drag included, N mm; negative where it leads.

        Args:
            lift: lift of the cam.
            theta: cam angles, rad, shape (n,).
        """
        return self.drag - self.torque(lift, theta)

    def leads(self, lift: PathMotion, least_swing: float = LEAST_SWING) -> "Leads":
        """Lead intervals of the cam if its play allows: parts of falls where M is above the drag.

        A brake may act on the shaft on which the cam has play (`behind`). Then the cam leads the shaft wherever
        friction lets it, and takes the shaft along where M is above the drag too.

        Args:
            lift: lift that the cam was cut for. The slope of a rolled or meshed outline is too rough for this, and
                facets that would hold the rod wear off.
            least_swing: rises and falls of tan(beta) smaller than this are passed over.
        """
        pairs = falls(lift, least_swing)
        intervals = self._lead_intervals(lift, pairs, self.drag, least_swing)
        if self.behind == 0 or self.drag == 0:
            return Leads(intervals)
        return Leads(self._lead_intervals(lift, pairs, 0.0, least_swing), intervals, self.behind)

    def _lead_intervals(self, lift: PathMotion, pairs: Array, drag: float, least_swing: float) -> Array:
        if self.friction == 0 and drag == 0:
            return pairs

        if not len(pairs):
            return pairs
        theta, first = _stations(pairs)
        # The levers go by the lift alone: cars of all frictions share them.
        key = (levers, self.follower), least_swing
        if key not in lift.derived:
            at = levers(lift, self.follower, theta)
            lift.derived[key] = np.stack([at.driving, at.holding, at.along, at.across, at.lift])
        ahead = self._torque(Levers(*lift.derived[key])) > drag
        ahead[first] = ahead[first - 1] = False  # at a fall's ends the lift is level, but for a kink on the other side
        flips = np.flatnonzero(ahead[1:] != ahead[:-1])
        # Each change of sign is looked at again between its two stations.
        fine = theta[flips, None] + (theta[flips + 1] - theta[flips])[:, None] * np.linspace(0, 1, _ZOOM + 1)
        value = self.torque(lift, fine) - drag
        changed = (value[:, 1:] > 0) != (value[:, :-1] > 0)
        rows, cell = np.arange(len(flips)), np.argmax(changed, axis=1)
        low, high = value[rows, cell], value[rows, cell + 1]
        share = np.clip(low / np.where(low == high, 1.0, low - high), 0.0, 1.0)
        place = fine[rows, cell] + (fine[rows, cell + 1] - fine[rows, cell]) * share
        # Next to a peak or valley no change may show: the stretch then reaches up to it.
        place = np.where(changed.any(axis=1), place, np.where(ahead[flips], fine[:, -1], fine[:, 0]))
        intervals = place.reshape(-1, 2)
        fallen = lift.q(intervals[:, 0]) - lift.q(intervals[:, 1])
        return _in_order(intervals[fallen >= least_swing])


@dataclass(frozen=True)
class Leads:
    """Stretches on which a cam leads its shaft or gears, for any play.

    Attributes:
        intervals: cam angles at which each begins, in [0, 2 pi), and ends, perhaps beyond 2 pi; shape (k, 2), rad, in
            order. Without friction and drag, the falls of the lift.
        braked: the same for a shaft that is braked, on which the cam has play; None if the disc is braked.
        behind: play of the cam on that shaft, rad.
    """

    intervals: Array
    braked: Array | None = None
    behind: float = 0.0

    def follow(self, lift: PathMotion, play: float) -> Following:
        """Let a cam follow gears with a return error.

        Args:
            lift: lift that the follower gets.
            play: return error B, the play behind the brake included, rad.

        Raises:
            DesignError: the play is negative or no number.
        """
        if self.braked is None:
            return follow(lift, play, leads=self.intervals)
        joint = min(self.behind, play)
        shaft = follow(lift, play - joint, leads=self._taken(self.braked, joint))
        return follow(lift, joint, leads=self.intervals, shaft=shaft)

    def _taken(self, braked: Array, joint: float) -> Array:
        """Shaft angles between which the cam, ahead by the play of its joint, drives the shaft, shape (m, 2), rad.

        The cam must lead already: where it begins to within the joint of a stretch, it takes the shaft along at once,
        and where it then stops beyond one, not at all.
        """
        middle = braked.mean(axis=1)
        begins = middle - np.min((middle[:, None] - self.intervals[:, 0]) % TURN, axis=1, initial=TURN)
        taken = np.stack([np.maximum(braked[:, 0] - joint, begins), braked[:, 1] - joint], axis=1)
        return _in_order(taken[taken[:, 0] < taken[:, 1]])


@dataclass(frozen=True, kw_only=True)
class MechanicsBand:
    """Range of the forces on the cam, over the cars that may be built.

    Attributes:
        follower, rod_force, rod_rate, behind: same as in `Mechanics`.
        friction: least and greatest coefficient of sliding friction.
        drag: least and greatest drag, N mm.
        measured: whether the friction was measured: then its range is two standard deviations to either side.
    """

    follower: EdgeFollower
    rod_force: float = 1.0
    rod_rate: float = 0.0
    friction: tuple[float, float] = (0.0, 0.0)
    drag: tuple[float, float] = (0.0, 0.0)
    behind: float = 0.0
    measured: bool = False

    def at(self, friction: float, drag: float) -> Mechanics:
        """Car of the band with a friction coefficient and a drag in N mm.

        Args:
            friction: coefficient of friction, a number.
            drag: torque of a brake, N mm.
        """
        return Mechanics(
            follower=self.follower,
            rod_force=self.rod_force,
            rod_rate=self.rod_rate,
            friction=friction,
            drag=drag,
            behind=self.behind,
        )

    @property
    def nominal(self) -> Mechanics:
        """The car in the middle of the band."""
        return self.at(sum(self.friction) / 2, sum(self.drag) / 2)

    @property
    def corners(self) -> tuple[Mechanics, ...]:
        """The cars at the ends of the band, the two in which the cam is held least and most first."""
        (low, high), (weak, strong) = self.friction, self.drag
        ends = dict.fromkeys([(low, weak), (high, strong), (low, strong), (high, weak)])
        return tuple(self.at(*end) for end in ends)

    @property
    def usual(self) -> tuple[Mechanics, ...]:
        """The cars that a profile is made for: the corners; of a measured friction those one standard deviation off.

        Two such points have the mean and the spread of the normal distribution. A profile made for the ends of the
        range, two standard deviations off, is wrong for the friction that is likeliest, unless the range is narrow.
        """
        low, high = self.friction
        if not self.measured or high - low <= _WELL_KNOWN:
            return self.corners
        return replace(self, friction=((3 * low + high) / 4, (low + 3 * high) / 4)).corners

    @property
    def cases(self) -> tuple[Mechanics, ...]:
        """Cars across the band, among which the worst is searched for."""
        return self._across(_FRICTIONS if self.friction[0] < self.friction[1] else 1)

    @property
    def fine_cases(self) -> tuple[Mechanics, ...]:
        """Cars across the band in steps of friction of 0.01, for what is worst somewhere within it, as a trim is."""
        return self._across(int(np.ceil((self.friction[1] - self.friction[0]) / _FINE_FRICTION)) + 1)

    def _across(self, count: int) -> tuple[Mechanics, ...]:
        frictions = np.linspace(*self.friction, count)
        return tuple(self.at(float(friction), drag) for drag in dict.fromkeys(self.drag) for friction in frictions)


def _stations(pairs: Array) -> tuple[Array, NDArray[np.intp]]:
    """Evenly spaced cam angles from the start to the end of each fall, in a row, and the place of each fall's first."""
    counts = ((pairs[:, 1] - pairs[:, 0]) / _STEP).astype(np.intp) + 9
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])
    place = np.arange(counts.sum()) - np.repeat(first, counts)
    theta = place * np.repeat((pairs[:, 1] - pairs[:, 0]) / (counts - 1), counts) + np.repeat(pairs[:, 0], counts)
    theta[first + counts - 1] = pairs[:, 1]
    return theta, first


def _in_order(intervals: Array) -> Array:
    """Stretches moved by whole turns so that each begins in [0, 2 pi), in order of that; shape (k, 2), rad."""
    moved = intervals - TURN * np.floor(intervals[:, :1] / TURN)
    return np.asarray(moved[np.argsort(moved[:, 0])])
