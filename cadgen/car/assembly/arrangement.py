"""Arrangement of a train in a car: the directions of its stages that bring the drive onto the rear axle, clear of all.

The drive's axis is the rear axle, at -behind + i (H - R) from the camshaft. H is the height of the camshaft over the
floor and R the radius of the rear wheels. All stages but the last two take directions in even steps, the last two
close the triangle to the camshaft in both ways; a single stage closes by the height alone. Every body of every shaft
is then set against every other one. Of the arrangements that keep all clearances, that with the lowest camshaft is
taken, and of equal ones that with the most room.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from math import ceil, hypot, inf, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.car.assembly.bodies import SolidCylinder, gap
from cadgen.car.assembly.site import STEERING_STEPS, CarSite, OnShaft, StackPlace, shaft_bodies
from cadgen.gears.layout import RoundBody
from cadgen.messages import Message

_MOST_TRIED = 200_000  # arrangements of a height that are set against all bodies
_MOST_MEASURED = 60  # of those that pass, arrangements whose rod and front wheel are measured
_STEP = 3.0  # mm between the heights of the camshaft that are tried
_ROUNDING = 1e-9  # mm
_SAME = 1e-3  # mm; a given height of the camshaft is met within this


class Gap(NamedTuple):
    """Gap between two bodies of a car.

    Attributes:
        size: distance, mm; negative by the depth of an overlap of round bodies about parallel axes.
        one: first body, for people.
        other: second body, for people.
    """

    size: float
    one: str
    other: str

    @property
    def between(self) -> Message:
        """The two bodies, in words."""
        return Message("{one} and {other}", one=self.one, other=self.other)


@dataclass(frozen=True, slots=True, kw_only=True)
class Arrangement:
    """A train at its place in a car.

    Attributes:
        directions: direction of each stage's line of centres in the frame of the car, from its driver, rad.
        height: height of the camshaft over the floor, mm.
        axes: axes of the shafts x + iy from the drive to the camshaft, mm; the last is 0.
        place: place of the train along its shafts.
        least: least gap between bodies of which one at least is not of the train, over all places of the fork; that of
            two parts of the train where they come nearer to each other than they may.
        floor: least gap between the floor and a body that is no wheel.
    """

    directions: tuple[float, ...]
    height: float
    axes: tuple[complex, ...]
    place: StackPlace
    least: Gap
    floor: Gap

    def reserve(self, site: CarSite) -> float:
        """Least amount by which gaps and length between the plates exceed what is asked, mm; negative if they do not.

        Args:
            site: what stands in the car.
        """
        return min(self.least.size - site.clearance, self.floor.size - site.floor_clearance, self.place.room)


class _Apart(NamedTuple):
    """Two shafts that must be at least `out` apart, or at most `within`, mm."""

    first: int
    second: int
    out: float
    within: float


def arrange(
    site: CarSite,
    train: Sequence[Sequence[RoundBody]],
    distances: Sequence[float],
    bores: Sequence[float],
    *,
    towards: int | None = None,
    height: float | None = None,
) -> Arrangement | None:
    """Arrangement of a train with the lowest camshaft that keeps every clearance, else that with the most room.

    None where the train cannot join the rear axle with the camshaft at any height.

    Args:
        site: what stands in the car.
        train: gears and hubs of every shaft from the drive to the output, in the train's own frame.
        distances: centre distance of every stage, mm.
        bores: diameter of every shaft, mm.
        towards: side of the disc on which the train stands, -1 below it and 1 above; None for either.
        height: height of the camshaft over the floor, mm; None for any.
    """
    sides = (-site.rod_side, site.rod_side) if towards is None else (towards,)
    best: Arrangement | None = None
    for tall, side in product(_heights(site, distances) if height is None else [height], sides):
        place = placed(site, train, side)
        shafts = shaft_bodies(site, train, bores, place)
        for found in _at_height(site, shafts, distances, place, tall):
            if found.reserve(site) >= -_ROUNDING:
                return found
            if best is None or found.reserve(site) > best.reserve(site):
                best = found
    return best


def placed(site: CarSite, train: Sequence[Sequence[RoundBody]], towards: int) -> StackPlace:
    """Place of a train along its shafts.

    Args:
        site: what stands in the car.
        train: gears and hubs of every shaft, in the train's own frame.
        towards: side of the disc, -1 below it and 1 above.
    """
    low = min(gear.low for gears in train for gear in gears)
    high = max(gear.high for gears in train for gear in gears)
    return site.stack(towards, low, high)


def arranged_as(
    site: CarSite,
    train: Sequence[Sequence[RoundBody]],
    distances: Sequence[float],
    bores: Sequence[float],
    directions: Sequence[float],
    *,
    towards: int | None = None,
    height: float | None = None,
) -> Arrangement | None:
    """Arrangement with given directions, turned as a whole to the rear axle; None where the train does not reach it.

    Of the ways to set it, that with the most room is taken.

    Args:
        site: what stands in the car.
        train: gears and hubs of every shaft from the drive to the output, in the train's own frame.
        distances: centre distance of every stage, mm.
        bores: diameter of every shaft, mm.
        directions: direction of each stage's line of centres, rad.
        towards: side of the disc on which the train stands; None for either.
        height: height of the camshaft over the floor, mm; None for that at which the drive meets the axle.
    """
    steps = np.asarray(distances) * np.exp(1j * np.asarray(directions))
    reach = abs(steps.sum())
    if reach < site.behind - _ROUNDING:
        return None
    drop = max(reach**2 - site.behind**2, 0.0) ** 0.5
    ways: list[Arrangement] = []
    for below, side in product((drop, -drop), (-site.rod_side, site.rod_side) if towards is None else (towards,)):
        tall = site.wheel_radius + below
        if height is not None and abs(height - tall) > _SAME:
            continue
        place = placed(site, train, side)
        turn = float(np.angle(-complex(-site.behind, below) / steps.sum()))
        axes = np.append(-np.cumsum(steps[::-1])[::-1], 0.0) * np.exp(1j * turn)
        shafts = shaft_bodies(site, train, bores, place)
        ways.append(_measured(site, shafts, axes, tuple(float(d) + turn for d in directions), place, tall))
    return max(ways, key=lambda way: way.reserve(site), default=None)


def shortfall(site: CarSite, distances: Sequence[float]) -> float:
    """Length by which a train cannot reach the rear axle however it is folded, mm; 0 if it can.

    Args:
        site: what stands in the car.
        distances: centre distance of every stage, mm.
    """
    return max(site.behind - sum(distances), 0.0)


def _heights(site: CarSite, distances: Sequence[float]) -> list[float]:
    """Heights of the camshaft that are tried, mm, the lowest first."""
    longest = sum(distances)
    shortest = max(2 * max(distances) - longest, 0.0)
    if longest < site.behind:
        return []
    most, least = (max(reach**2 - site.behind**2, 0.0) ** 0.5 for reach in (longest, shortest))
    step = 1.0 if np.count_nonzero(distances) == 2 else _STEP
    between = np.arange(ceil(max(site.wheel_radius - most, site.least_height)), site.wheel_radius + most, step)
    ends = [site.wheel_radius + sign * each for sign in (-1, 1) for each in (least, most)]
    tried = [tall for tall in (*between.tolist(), *ends) if least <= abs(tall - site.wheel_radius) + _ROUNDING]
    return sorted({tall for tall in tried if tall >= site.least_height}) or [site.wheel_radius + most]


def _at_height(
    site: CarSite, shafts: Sequence[Sequence[OnShaft]], distances: Sequence[float], place: StackPlace, height: float
) -> Iterator[Arrangement]:
    """Arrangements with the camshaft at a height, those with the most room among round bodies first."""
    axes, directions = _ways(distances, complex(site.behind, site.wheel_radius - height))
    room = np.full(len(axes), inf)
    for pair in _constraints(site, shafts, distances):
        apart = np.abs(axes[:, pair.first] - axes[:, pair.second])
        room = np.minimum(room, np.maximum(apart - pair.out, pair.within - apart))
    for number, bodies in enumerate(shafts):
        lowest = max((body.radius for body, _ in bodies if not _on_floor(number, body, site)), default=0.0)
        room = np.minimum(room, height - axes[:, number].imag - lowest - site.floor_clearance)
    order = np.argsort(-room, kind="stable")
    kept = order[room[order] >= -_ROUNDING][:_MOST_MEASURED]
    for way in kept if len(kept) else order[:1]:
        yield _measured(site, shafts, axes[way], tuple(directions[way].tolist()), place, height)


def _ways(distances: Sequence[float], target: complex) -> tuple[NDArray[np.complex128], Array]:
    """Axes of the shafts, shape (m, n + 1), and directions of the stages, shape (m, n).

    Stages whose wheels are on one axis have a direction of 0.
    """
    apart = np.flatnonzero(distances)
    directions = np.zeros((0, len(distances)))
    if len(apart):
        turned = _closing(np.asarray(distances)[apart], target)
        directions = np.zeros((len(turned), len(distances)))
        directions[:, apart] = turned
    steps_taken = np.asarray(distances) * np.exp(1j * directions)
    axes = np.concatenate([np.zeros((len(directions), 1)), np.cumsum(steps_taken, axis=1)], axis=1) - target
    axes[:, -1] = 0.0
    return axes, directions


def _closing(distances: Array, target: complex) -> Array:
    """Directions of stages that lead from 0 to a target, shape (m, n)."""
    if len(distances) == 1:
        return np.full((int(abs(abs(target) - distances[0]) < _SAME), 1), np.angle(target))
    free = len(distances) - 2
    steps = 72 if free < 2 else max(int((_MOST_TRIED / 2) ** (1 / free)), 4)
    turns = np.arange(steps) * (2 * pi / steps) + np.angle(target)
    grid = np.array(list(product(turns, repeat=free))).reshape(steps**free, free)
    left = target - (distances[:free] * np.exp(1j * grid)).sum(axis=1)
    a, b = distances[-2:]
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (a**2 + np.abs(left) ** 2 - b**2) / (2 * a * np.abs(left))
        stretched = np.abs(np.abs(cosine) - 1) < _ROUNDING
        bend = np.arccos(np.where(stretched, np.sign(cosine), cosine))
    closes = np.isfinite(bend)
    grid, left, bend = grid[closes], left[closes], bend[closes]
    both = []
    for way in (1, -1):
        first = np.angle(left) + way * bend
        both.append(np.column_stack([grid, first, np.angle(left - a * np.exp(1j * first))]))
    return np.concatenate(both)


def _constraints(site: CarSite, shafts: Sequence[Sequence[OnShaft]], distances: Sequence[float]) -> Iterator[_Apart]:
    for (i, first), (j, second) in combinations(enumerate(shafts), 2):
        if all(distance == 0 for distance in distances[i:j]):
            continue  # on one axis, as their stage is made
        for (one, own), (other, others) in product(first, second):
            if one.stage is not None and one.stage == other.stage:
                continue
            keep = site.gear_clearance if own and others else site.clearance
            if max(one.low, other.low) - min(one.high, other.high) >= keep:
                continue
            within = max(
                (outer.inner - inner.radius - keep for outer, inner in ((one, other), (other, one)) if outer.inner),
                default=-inf,
            )
            yield _Apart(i, j, one.radius + other.radius + keep, within)


def _on_floor(number: int, body: RoundBody, site: CarSite) -> bool:
    """Whether a body is one of the rear wheels, which stand on the floor."""
    return number == 0 and body.radius == site.wheel_radius


def _measured(
    site: CarSite,
    shafts: Sequence[Sequence[OnShaft]],
    axes: NDArray[np.complex128],
    directions: tuple[float, ...],
    place: StackPlace,
    height: float,
) -> Arrangement:
    way = Arrangement(
        directions=directions,
        height=height,
        axes=tuple(axes.tolist()),
        place=place,
        least=min(
            _least_of_round(site, shafts, axes),
            _least_of_wheels(site, shafts[0], place),
            key=lambda found: found.size,
        ),
        floor=_least_to_floor(site, shafts, axes, height),
    )
    beside = _least_of_fork(site, shafts, way, np.linspace(0.0, 1.0, STEERING_STEPS + 1).tolist())
    return replace(way, least=min(way.least, beside, key=lambda found: found.size))


def _least_of_round(site: CarSite, shafts: Sequence[Sequence[OnShaft]], axes: NDArray[np.complex128]) -> Gap:
    """Least gap among the bodies on the shafts; of parts of the train among themselves only one that is too small."""
    least = Gap(inf, "", "")
    for (i, first), (j, second) in combinations(enumerate(shafts), 2):
        apart = abs(axes[i] - axes[j])
        if (np.abs(np.diff(axes[i : j + 1])) < _ROUNDING).all():
            continue  # on one axis, as their stage is made
        for (one, own), (other, others) in product(first, second):
            if one.stage is not None and one.stage == other.stage:
                continue
            lengthwise = max(one.low, other.low) - min(one.high, other.high)
            radial = apart - one.radius - other.radius
            for outer, inner in ((one, other), (other, one)):
                if outer.inner:
                    radial = max(radial, outer.inner - apart - inner.radius)
            size = hypot(radial, lengthwise) if min(radial, lengthwise) > 0 else max(radial, lengthwise)
            kept = own and others and max(radial, lengthwise) >= site.gear_clearance - _ROUNDING
            if size < least.size and not kept:
                least = Gap(float(size), one.name, other.name)
    return least


def _least_of_wheels(site: CarSite, axle: Sequence[OnShaft], place: StackPlace) -> Gap:
    """Least gap along the axle from a rear wheel to a bearing plate or to the pinion with its hub."""
    least, half = Gap(inf, "", ""), site.wheel_width / 2
    shaft = min(body.radius for body, own in axle if own)
    beside = [(body.name, body.low, body.high) for body, own in axle if own and body.radius > shaft]
    beside += [(Message("a plate"), z - site.plate / 2, z + site.plate / 2) for z in (place.near, place.far)]
    for wheel, middle in ((Message("the drive wheel"), site.drive_wheel), (Message("the idle wheel"), site.idle_wheel)):
        for name, low, high in beside:
            size = max(middle - half, low) - min(middle + half, high)
            if size < least.size:
                least = Gap(float(size), wheel, name)
    return least


def _least_to_floor(
    site: CarSite, shafts: Sequence[Sequence[OnShaft]], axes: NDArray[np.complex128], height: float
) -> Gap:
    return min(
        Gap(float(height - axes[number].imag - body.radius), body.name, Message("the floor"))
        for number, bodies in enumerate(shafts)
        for body, _ in bodies
        if not _on_floor(number, body, site)
    )


def _least_of_fork(
    site: CarSite, shafts: Sequence[Sequence[OnShaft]], way: Arrangement, shares: Sequence[float]
) -> Gap:
    """Least gap of rod and front wheel to the bodies on the shafts, but of the rod to the disc that it rides on."""
    least = way.least
    rim = site.disc[0].name
    solids = [
        SolidCylinder(
            name=body.name,
            centre=(axis.real, axis.imag, (body.low + body.high) / 2),
            radius=body.radius,
            half=(body.high - body.low) / 2,
        )
        for axis, bodies in zip(way.axes, shafts, strict=True)
        for body, _ in bodies
    ]
    for share in shares:
        turned = list(site.fork_bodies(share, way.height))
        if len(turned) > 1 and (size := gap(*turned)) < least.size:
            least = Gap(size, turned[0].name, turned[1].name)
        for number, moving in enumerate(turned):
            for solid in solids:
                if number == 0 and solid.name == rim:
                    continue
                reach = hypot(moving.radius, moving.half) + hypot(solid.radius, solid.half)
                if np.linalg.norm(np.subtract(moving.centre, solid.centre)) - reach >= least.size:
                    continue
                # The boxes about both bodies along the axes of the car are no farther apart than the bodies.
                boxes = np.abs(np.subtract(moving.centre, solid.centre)) - _box(moving) - _box(solid)
                if float(np.sqrt((np.maximum(boxes, 0.0) ** 2).sum())) < least.size:
                    size = gap(moving, solid)
                    if size < least.size:
                        least = Gap(size, moving.name, solid.name)
    return least


def _box(body: SolidCylinder) -> Array:
    axis = np.abs(body.axis)
    return np.asarray(body.half * axis + body.radius * np.sqrt(np.maximum(1 - axis**2, 0.0)))
