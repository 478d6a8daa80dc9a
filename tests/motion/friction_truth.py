"""A car with friction, drag and play, worked out a second time: forces in space, motion step by step, motion in time.

Nothing of the package is used but the steering tan(beta) at even cam angles, taken once. Slopes are differences of
neighbours. The camshaft stands along w, the rod's axis in the plane y = 0 through (a, 0, 0) along (sin beta, 0, cos
beta); the disc's material at the contact moves along (-y, x, 0) per radian of the cam, or its mirror image.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

TURN = 2 * np.pi


@dataclass(frozen=True)
class Rod:
    """The rod, the faces of the disc and the force along the lift at no lift, N, with its rate, N/mm."""

    base: float = 70.0
    inner: float = 23.5
    outer: float = 26.5
    radius: float = 2.5
    force: float = 1.0
    rate: float = 0.0
    leans: bool = True


@dataclass(frozen=True)
class Contact:
    """What the rod does to a cam that turns, n places; torques in N mm, powers per radian of the cam.

    Attributes:
        push: power of the rod's force: minus the force times the slope of the lift.
        pressed: part of the pressing force that does not depend on friction: force over `lever`.
        lever: of the normal force on the rod, about the fork's axis, per that of the lift.
        rub: of the friction force on the rod, likewise.
        slide: sliding of the disc under the rod, mm per radian.
    """

    push: Array
    lever: Array
    rub: Array
    slide: Array
    force: Array

    def torque(self, friction: Array | float) -> Array:
        """Torque that turns the cam ahead: power of the rod's force less that of friction; -inf where friction jams."""
        against = self.lever + friction * self.rub
        free = against > 0
        return np.where(free, self.push - friction * self.force / np.where(free, against, 1.0) * self.slide, -np.inf)


def contact(rod: Rod, T: Array, slope: Array) -> Contact:
    """Virtual work at the contact of the rod's cylinder with the edge of the disc.

    The normal is looked for, not given: on the circle of directions square to the rod, the one along which the
    contact's points on disc and rod have the same velocity. Friction acts against the rest of that velocity.

    Args:
        rod: its place and force.
        T: tan(beta), shape (n,).
        slope: dT per radian of the cam, shape (n,).
    """
    w = np.where(T >= 0, rod.inner, rod.outer)
    zero, one = np.zeros_like(T), np.ones_like(T)
    if rod.leans:
        size = np.sqrt(1 + T**2)
        axis = np.stack([T, zero, one]) / size
        across = np.stack([one, zero, -T]) / size  # square to the rod, in its plane
        beta_rate = slope / (1 + T**2)  # of the fork
        want = w * slope  # of the lift
    else:
        axis, across = np.stack([zero, zero, one]), np.stack([one, zero, zero])
        beta_rate, want = w * slope, w * slope
    up = np.stack([zero, one, zero])

    def at(psi: Array) -> tuple[Array, Array, Array, Array]:
        outward = np.cos(psi) * across + np.sin(psi) * up  # from the disc to the rod
        on_axis = np.stack([rod.base + w * T, zero, w])
        point = on_axis - rod.radius * outward
        point = point + axis * (w - point[2]) / axis[2]  # along the rod, back to the face's plane
        disc = np.stack([-point[1], point[0], zero])  # per radian of the cam
        # Per radian of the fork about (a, 0, 0); without lean, per mm of lift.
        fork = np.stack([point[2], zero, rod.base - point[0]]) if rod.leans else np.stack([one, zero, zero])
        return np.sum(outward * (disc - fork * beta_rate), axis=0), outward, disc, fork

    low, high = np.full_like(T, -1.5), np.full_like(T, 1.5)
    for _ in range(60):
        middle = (low + high) / 2
        closing = at(middle)[0] < 0
        low, high = np.where(closing, middle, low), np.where(closing, high, middle)
    _, outward, disc, fork = at((low + high) / 2)
    relative = disc - fork * beta_rate
    slide = np.linalg.norm(relative, axis=0)
    per_lift = np.where(rod.leans, w * (1 + T**2), 1.0)  # lift per radian of the fork, or per mm
    force = rod.force + rod.rate * w * T
    return Contact(
        push=-force * want,
        lever=np.sum(outward * fork, axis=0) / per_lift,
        rub=np.sum(relative / slide * fork, axis=0) / per_lift,
        slide=slide,
        force=force,
    )


class Cells:
    """A turn in even cells of cam angle, and the torque across each.

    Args:
        rod: its place and force.
        T: tan(beta) at n even cam angles from 0.
    """

    def __init__(self, rod: Rod, T: Array):
        self.T = T
        self.step = TURN / len(T)
        after = np.roll(T, -1)
        self.contact = contact(rod, (T + after) / 2, (after - T) / self.step)

    def stands(self, friction: float, drag: float, room: int, *, joint: int = 0, nudge: float = 0.0) -> Array:
        """Cells at which the cam stands as the motor goes from cell to cell, over the second of two turns, shape (n,).

        The gears push the cam; wherever the torque is above the drag it goes on by itself as far as the room lets it.
        With a joint the drag acts on a shaft on which the cam has part of that room: the cam goes on wherever the
        torque is above 0, and takes the shaft along, from the joint's other end, where it is above the drag.

        Args:
            friction: sliding.
            drag: N mm.
            room: play in cells, the joint's with it.
            joint: play of the cam on the shaft, in cells.
            nudge: N mm that the torque must be above the drag.
        """
        n = len(self.T)
        torque = self.contact.torque(friction)
        takes = np.tile(torque > drag + nudge, 3).tolist()
        goes = np.tile(torque > nudge, 3).tolist() if joint else takes
        seen = []
        shaft = cam = 0
        room -= joint
        for motor in range(2 * n):
            if shaft < motor:
                shaft = motor
            if cam < shaft:
                cam = shaft
            while cam < 3 * n:
                if cam < shaft + joint:
                    if not goes[cam]:
                        break
                elif shaft < motor + room and takes[cam]:
                    shaft += 1
                else:
                    break
                cam += 1
            seen.append(cam)
        return np.array(seen[n:]) - n


def late(stands: Array, least: Array, most: Array) -> int:
    """Cells by which a motion lies outside two others at most: along the motor or along the cam, whichever explains it.

    All are cells of the cam at even motor positions round a turn.
    """
    n, spread = len(least), 400
    number = np.arange(-spread, n + spread)
    low, high = (each[number % n] + number - number % n for each in (least, most))
    inside = np.arange(n) + spread
    for k in range(spread):
        if np.all(low[inside - k] - k <= stands) and np.all(stands <= high[inside + k] + k):
            return k
    return spread


def run_end(T: Array, length: float, wheelbase: float, offset: float, share: float) -> complex:
    """Where a car ends whose steering is known at even motor positions, from the origin along x: x + i y, mm.

    Args:
        T: tan(beta), shape (n,), each for the cell of motor positions that begins there.
        length: travel in a turn, mm.
        wheelbase: mm.
        offset: of the drive wheel from the fork, mm.
        share: of the turn that is driven.
    """
    steps = round(len(T) * share)
    ds = length / len(T)
    turning = -T[:steps] / (wheelbase + offset * T[:steps]) * ds
    heading = np.cumsum(turning) - turning / 2
    return complex(np.sum(np.exp(1j * heading) * np.sinc(turning / TURN)) * ds)


def dilated(T: Array, room: int) -> Array:
    """Pure dilation of a closed lift: the greatest value of the last `room` cells and this."""
    wide = np.concatenate([T[-room:], T]) if room else T
    return np.array([wide[at : at + len(T)] for at in range(room + 1)]).max(axis=0)


@dataclass(frozen=True)
class Motion:
    """A motion in time of c cams: motor positions at which the lead passes half the play, and all that was passed.

    Attributes:
        passed: for each case, motor positions, rad.
        end: cam angle at the end, shape (c,), rad.
        T: tan(beta) at every step, shape (steps, c), if asked for.
    """

    passed: list[list[float]]
    end: Array
    T: Array


def in_time(
    cells: list[Cells],
    which: Array,
    friction: Array,
    drag: Array,
    play: Array,
    inertia: Array,
    *,
    start: float,
    stop: float,
    step: float,
    speed: float = np.radians(8.0),
    stiffness: float = 1e6,
) -> Motion:
    """Integrate inertia, rod, friction and drag of c cams between stiff flanks of their gears' teeth.

    Rosenbrock's method of two stages (Verwer et al. 1999, ROS2), L-stable and of second order whatever stands for the
    Jacobian: here the flanks' and the smoothed friction's. Flanks push by stiffness times depth times 1 + 10 s/rad
    of closing speed; friction and drag turn with the sense of the cam's speed over 2 % of the motor's.

    Args:
        cells: lifts.
        which: of them each case has, shape (c,).
        friction, drag, play, inertia: shape (c,), N mm, rad, N mm s^2.
        start: motor position at which the cams stand on the gears, rad.
        stop: last motor position, rad.
        step: s.
        speed: of the motor in cam units, rad/s.
        stiffness: of the teeth, N mm/rad.
    """
    n = len(cells[0].T)
    width = TURN / n
    fields = ("push", "lever", "rub", "slide", "force")
    # Torques belong to the middles of the cells.
    table = np.concatenate([np.stack([getattr(each.contact, name) for name in fields], axis=1) for each in cells])
    steer = np.concatenate([each.T for each in cells])
    base = np.asarray(which) * n
    slow, hold = 0.02 * speed, 10.0
    gamma = 1 - np.sqrt(0.5)

    def between(values: Array, place: Array) -> Array:
        at = np.floor(place).astype(int)
        share = place - at
        first, second = values[base + at % n], values[base + (at + 1) % n]
        share = share[:, None] if values.ndim == 2 else share
        return first + (second - first) * share

    def forces(ahead: Array, rate: Array, motor: float) -> tuple[Array, Array, Array]:
        """Acceleration, and its derivatives by lead and speed but for what the rod's torque changes."""
        push, lever, rub, slide, force = between(table, (motor + ahead) / width - 0.5).T
        sense = np.tanh(rate / slow)
        mu = friction * sense
        normal = force / (lever + mu * rub)
        closing = rate - speed
        behind, beyond = np.maximum(-ahead, 0.0), np.maximum(ahead - play, 0.0)
        low, high = np.maximum(1 - hold * closing, 0.0), np.maximum(1 + hold * closing, 0.0)
        flanks = stiffness * (behind * low - beyond * high)
        by_ahead = -stiffness * ((behind > 0) * low + (beyond > 0) * high)
        by_rate = -stiffness * hold * (behind * (low > 0) + beyond * (high > 0))
        by_rate = by_rate - (drag + friction * normal * slide) * (1 - sense**2) / slow
        return (push - mu * normal * slide - drag * sense + flanks) / inertia, by_ahead / inertia, by_rate / inertia

    steps = round((stop - start) / speed / step)
    ahead, rate = np.zeros(len(base)), np.full(len(base), speed)
    passed: list[list[float]] = [[] for _ in base]
    steering = np.empty((steps, len(base)))
    g = gamma * step
    for number in range(steps):
        motor = start + number * step * speed
        steering[number] = between(steer, (motor + ahead) / width)
        acceleration, by_ahead, by_rate = forces(ahead, rate, motor)
        # (I - g A) k = f with A = [[0, 1], [by_ahead, by_rate]].
        divisor = 1 - g * by_rate - g * g * by_ahead
        v1 = (acceleration + g * by_ahead * (rate - speed)) / divisor
        x1 = (rate - speed) + g * v1
        acceleration, _, _ = forces(ahead + step * x1, rate + step * v1, motor + step * speed)
        fx, fv = rate + step * v1 - speed - 2 * x1, acceleration - 2 * v1
        v2 = (fv + g * by_ahead * fx) / divisor
        x2 = fx + g * v2
        before, before_rate = ahead, rate
        ahead, rate = ahead + step * (1.5 * x1 + 0.5 * x2), rate + step * (1.5 * v1 + 0.5 * v2)
        for case in np.flatnonzero((before < play / 2) & (ahead >= play / 2)):
            # On the parabola through both leads with the first's rate.
            a, b = before[case] - play[case] / 2, (before_rate[case] - speed) * step
            c = ahead[case] - before[case] - b
            roots = np.roots([c, b, a])
            share = next((r.real for r in roots if abs(r.imag) < 1e-9 and -1e-6 <= r.real <= 1 + 1e-6), 0.5)
            passed[case].append(float(motor + share * step * speed))
    return Motion(passed, start + steps * step * speed + ahead, steering)
