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
SPEED = np.radians(8.0)  # of the motor in cam units, rad/s


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
    """Action of the rod on a turning cam at n places; torques in N mm, powers per radian of the cam.

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
    for _ in range(6):
        middle = (low + high) / 2
        closing = at(middle)[0] < 0
        low, high = np.where(closing, middle, low), np.where(closing, high, middle)
    off_low, off_high = at(low)[0], at(high)[0]
    for _ in range(5):  # secants
        apart = off_high != off_low
        low, high = (
            high,
            high - np.where(apart, off_high * (high - low) / np.where(apart, off_high - off_low, 1.0), 0.0),
        )
        off_low, off_high = off_high, at(high)[0]
    _, outward, disc, fork = at(high)
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
        """Cells at which the cam stands as the motor goes from cell to cell round a turn, shape (n,).

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
        shaft = cam = n // 2
        room -= joint
        for motor in range(n // 2, 2 * n):
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
        return np.array(seen[n - n // 2 :]) - n


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


def run_end(T: Array, ds: float, wheelbase: float, offset: float) -> Array:
    """Where cars end that steer by tan(beta) over each even step, from the origin along x: x + i y, mm.

    Args:
        T: tan(beta), steps along the last axis.
        ds: travel in a step, mm.
        wheelbase: mm.
        offset: of the drive wheel from the fork, mm.
    """
    turning = -T / (wheelbase + offset * T) * ds
    heading = np.cumsum(turning, axis=-1) - turning / 2
    return np.sum(np.exp(1j * heading) * np.sinc(turning / TURN), axis=-1) * ds


def dilated(T: Array, before: Array, room: int) -> Array:
    """Pure dilation of a closed lift: the greatest of its values now, `before` the play, and at the cells between."""
    wide = np.concatenate([T[len(T) - room :], T])
    return np.maximum(np.max([wide[at : at + len(T)] for at in range(room + 1)], axis=0), before)


def steering(T: Array, stands: Array) -> Array:
    """tan(beta) over each cell of motor positions: of the cam's cell, or of where it waits."""
    after = np.append(stands[1:], stands[0] + len(T))
    here = T[stands % len(T)]
    return np.where(after == stands, here, (here + T[(stands + 1) % len(T)]) / 2)


def fitting_cells(play: float, most: int = 40000) -> tuple[int, int]:
    """Cells of a turn and of a play, rad, so that whole ones fit both best."""
    rooms = np.arange(most // 3, most) * play / TURN
    rooms = np.arange(int(rooms[0]) + 1, int(rooms[-1]))
    cells = rooms * TURN / play
    best = int(np.argmin(np.abs(cells - np.round(cells)) / cells))
    return round(cells[best]), int(rooms[best])


@dataclass(frozen=True)
class Motion:
    """A motion in time of c cams.

    Attributes:
        passed: motor positions at which the lead first passes half the play, rad, NaN if it does not; shape (c,).
        T: tan(beta) at the middle of every step, shape (c, steps).
    """

    passed: Array
    T: Array


def in_time(
    cells: list[Cells],
    which: Array,
    friction: Array,
    play: Array,
    inertia: Array,
    start: Array,
    *,
    travel: float,
    step: float,
    drag: float = 0.0,
    stiffness: float = 4e5,
    speed: float = SPEED,
) -> Motion:
    """Integrate inertia, rod, friction and drag of c cams between stiff flanks of their gears' teeth.

    Alexander's diagonally implicit Runge-Kutta method of two stages (1977): second order, L-stable and, as it ends on
    its last stage, at ease with flanks however stiff. Each stage is solved for the cam's speed by Newton's method
    within a bracket, for both flanks and friction only ever slow the cam. Flanks push by stiffness times depth times
    1 + 10 s/rad of closing speed and never pull; friction and drag turn with the sense of the cam's speed over 5 % of
    the motor's.

    Args:
        cells: lifts.
        which: of them each case has, shape (c,).
        friction, play, inertia: shape (c,), -, rad, N mm s^2.
        start: motor positions at which the cams rest on the gears, shape (c,), rad.
        travel: of the motor, rad.
        step: s.
        drag: N mm.
        stiffness: of the teeth, N mm/rad.
        speed: of the motor in cam units, rad/s.
    """
    n = len(cells[0].T)
    width, slow, hold, gamma = TURN / n, 0.05 * speed, 10.0, 1 - np.sqrt(0.5)
    pairs, row = np.unique(np.stack([which, friction]), axis=1, return_inverse=True)
    push = np.stack([cells[int(number)].contact.push for number, _ in pairs.T]).ravel()
    held = push - np.stack([cells[int(number)].contact.torque(mu) for number, mu in pairs.T]).ravel()
    table, steer = np.stack([push, held + drag]), np.concatenate([each.T for each in cells])
    base, lift = row.ravel() * n, np.asarray(which, dtype=int) * n

    def between(values: Array, first: Array, place: Array) -> Array:
        at = np.floor(place).astype(int)
        low, high = values[..., first + at % n], values[..., first + (at + 1) % n]
        return low + (high - low) * (place - at)

    def solved(x: Array, v: Array, guess: Array, motor: Array) -> Array:
        """Speed u with u = v + g a(x + g (u - speed), u), a the acceleration."""
        low, high, u = np.full_like(v, -100.0), np.full_like(v, 100.0), guess
        for _ in range(40):
            ahead = x + g * (u - speed)
            driven, brake = between(table, base, (motor + ahead) / width - 0.5)  # torques of the cells' middles
            sense, closing = np.tanh(u / slow), hold * (u - speed)
            behind, beyond = stiffness * np.maximum(-ahead, 0.0), stiffness * np.maximum(ahead - play, 0.0)
            back, front = np.maximum(1 - closing, 0.0), np.maximum(1 + closing, 0.0)
            torque = driven - brake * sense + behind * back - beyond * front
            by_rate = -brake * (1 - sense**2) / slow - hold * (behind * (back > 0) + beyond * (front > 0))
            by_ahead = -stiffness * ((behind > 0) * back + (beyond > 0) * front)
            off = u - v - g * torque / inertia
            low, high = np.where(off < 0, u, low), np.where(off < 0, high, u)
            better = u - off / (1 - g * (by_rate + g * by_ahead) / inertia)
            better = np.where((better < low) | (better > high), (low + high) / 2, better)
            done = np.abs(better - u).max() < 1e-9
            u = better
            if done:
                break
        return u

    steps = round(travel / speed / step)
    g = gamma * step
    driven, brake = between(table, base, start / width - 0.5)
    ahead, rate = np.minimum((driven - brake) / stiffness, 0.0), np.full(len(base), speed)
    passed, steering = np.full(len(base), np.nan), np.empty((steps, len(base)))
    for number in range(steps):
        motor = start + number * step * speed
        first = solved(ahead, rate, rate, motor + g * speed)
        x = ahead + (1 - gamma) / gamma * g * (first - speed)
        v = rate + (1 - gamma) / gamma * (first - rate)
        before, before_rate = ahead, rate
        rate = solved(x, v, first, motor + step * speed)
        ahead = x + g * (rate - speed)
        steering[number] = between(steer, lift, (motor + step * speed / 2 + (before + ahead) / 2) / width)
        now = (before < play / 2) & (ahead >= play / 2) & np.isnan(passed)
        if now.any():
            # On the parabola through both leads with the first's rate: a + b t + c t^2 = 0.
            a, b = (before - play / 2)[now], ((before_rate - speed) * step)[now]
            c = (ahead - before)[now] - b
            passed[now] = motor[now] + step * speed * -2 * a / (b + np.sqrt(np.maximum(b * b - 4 * a * c, 0.0)))
    return Motion(passed, steering.T)
