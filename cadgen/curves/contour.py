"""A closed chain of lines and circular arcs: the form of outline for a laser, a wire EDM, a mill and a drill."""

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from cadgen.arrays import Array
from cadgen.curves.closed import ClosedCurve, Jet, Outline, cross
from cadgen.errors import DesignError


@dataclass(frozen=True)
class Contour:
    """A closed chain of sides; side i runs from vertex i to vertex i + 1, the last one back to the first.

    Attributes:
        vertices: corners in order, shape (n, 2), mm.
        bulges: tan(sweep / 4) of each side, shape (n,): 0 is a line, +1 a counterclockwise half circle,
            negative a clockwise arc (the DXF reference's LWPOLYLINE, group code 42).
    """

    vertices: Array
    bulges: Array

    @property
    def chords(self) -> Array:
        """Vector from the start to the end of each side, shape (n, 2), mm."""
        return np.roll(self.vertices, -1, axis=0) - self.vertices

    @property
    def sweeps(self) -> Array:
        """Angle by which each side turns, shape (n,), rad, positive counterclockwise."""
        return 4 * np.arctan(self.bulges)

    @property
    def radii(self) -> Array:
        """Radius of each side, shape (n,), mm; infinite for a line."""
        with np.errstate(divide="ignore"):
            return np.asarray(self._chord_lengths * (1 + self.bulges**2) / (4 * np.abs(self.bulges)))

    @property
    def centers(self) -> Array:
        """Centre of each side, shape (n, 2), mm; not a number for a line."""
        bulges = np.where(self.bulges == 0, np.nan, self.bulges)[:, None]
        left = np.stack([-self.chords[:, 1], self.chords[:, 0]], axis=1)
        return np.asarray(self.vertices + self.chords / 2 + (1 - bulges**2) / (4 * bulges) * left)

    @property
    def middles(self) -> Array:
        """The point halfway along each side, shape (n, 2), mm."""
        right = np.stack([self.chords[:, 1], -self.chords[:, 0]], axis=1)
        return self.vertices + self.chords / 2 + self.bulges[:, None] / 2 * right

    @property
    def lengths(self) -> Array:
        """Length along each side, shape (n,), mm."""
        half = self.sweeps / 2
        return self._chord_lengths / np.sinc(half / np.pi)

    @property
    def is_circle(self) -> bool:
        """Whether the contour is the pair of half circles that `circle` makes."""
        return len(self.bulges) == 2 and bool(np.all(self.bulges == 1))

    @property
    def _chord_lengths(self) -> Array:
        return np.hypot(self.chords[:, 0], self.chords[:, 1])

    def area(self) -> float:
        """Enclosed area of polygon and circular segments, mm^2, positive if run counterclockwise."""
        following = np.roll(self.vertices, -1, axis=0)
        polygon = float(np.sum(cross(self.vertices, following))) / 2
        curved = self.bulges != 0
        sweep = self.sweeps[curved]
        return polygon + float(np.sum(self.radii[curved] ** 2 * (sweep - np.sin(sweep)))) / 2

    def outline(self, step: float) -> Outline:
        """Points on every side, no two further apart than `step` mm, at least five on a side.

        Args:
            step: greatest distance of two points, mm.
        """
        counts = np.maximum(5, np.ceil(self.lengths / step).astype(int) + 1)
        points = [self.side(number, np.linspace(0, 1, count)) for number, count in enumerate(counts)]
        return Outline(np.concatenate(points), np.repeat(np.arange(len(counts)), counts))

    def polygon(self, chord_tolerance: float) -> Array:
        """Points whose chords stay within `chord_tolerance` mm of the contour, shape (m, 2), not repeated.

        Args:
            chord_tolerance: greatest distance of a chord from the curve, mm.
        """
        with np.errstate(invalid="ignore"):
            # A right angle at most, so that even a circle smaller than the tolerance stays a polygon.
            widest = 2 * np.arccos(np.clip(1 - chord_tolerance / self.radii, np.sqrt(0.5), 1.0))
        curved = self.bulges != 0
        counts = np.ones(len(self.bulges), dtype=int)
        counts[curved] = np.ceil(np.abs(self.sweeps[curved]) / widest[curved])
        sides = [self.side(i, np.arange(count) / count) for i, count in enumerate(counts)]
        return np.concatenate(sides)

    def reversed(self) -> "Contour":
        """Contour run the other way round, from the same first vertex."""
        return Contour(np.roll(self.vertices[::-1], 1, axis=0), -self.bulges[::-1])

    def curve(self) -> ClosedCurve:
        """The contour as a closed curve, one piece a side."""
        return ClosedCurve(tuple(ContourSide(self, number) for number in range(len(self.bulges))))

    def side(self, number: int, share: Array) -> Array:
        """Points of one side at shares of its length, by the sine rule on its chord: no distant centre.

        Args:
            number: number of the side, counted from 0.
            share: shares of its length, 0 to 1, shape (n,).
        """
        sweep = self.sweeps[number]
        along = np.stack([np.cos((share - 1) * sweep / 2), np.sin((share - 1) * sweep / 2)], axis=1)
        reach = share if sweep == 0 else np.sin(share * sweep / 2) / np.sin(sweep / 2)
        x, y = self.chords[number]
        chord = np.array([[x, y], [-y, x]])
        points = self.vertices[number] + reach[:, None] * (along @ chord)
        return np.asarray(points)


@dataclass(frozen=True)
class ContourSide:
    """Side of a contour as a smooth piece, by the share of its length."""

    contour: Contour
    number: int
    start: float = 0.0
    stop: float = 1.0

    def jet(self, t: Array) -> Jet:
        """Point, velocity by the share of the side's length, and curvature.

        Args:
            t: shares of its length, 0 to 1, shape (n,).
        """
        sweep, length = self.contour.sweeps[self.number], self.contour.lengths[self.number]
        x, y = self.contour.chords[self.number]
        heading = np.arctan2(y, x) + (t - 0.5) * sweep
        return Jet(
            self.contour.side(self.number, t),
            length * np.stack([np.cos(heading), np.sin(heading)], axis=1),
            np.full(len(t), sweep / length),
        )


def circle(center: ArrayLike, radius: float) -> Contour:
    """A circle of a radius in mm, run counterclockwise as two half circles from its point of greatest x.

    Args:
        center: centre, mm.
        radius: radius, mm.
    """
    x, y = np.asarray(center, dtype=float)
    return Contour(np.array([[x + radius, y], [x - radius, y]]), np.ones(2))


def keyway_bore(diameter: float, width: float, depth: float, angle: float) -> Contour:
    """A bore about the origin with a keyway in its wall.

    Args:
        diameter: diameter of the bore, mm.
        width: width of the keyway, mm.
        depth: depth of the keyway from the bore's wall to its floor, along its centre line, mm.
        angle: polar angle of the centre line, rad.

    Raises:
        DesignError: the keyway is wider than the bore, or has no width or depth.
    """
    radius = diameter / 2
    if not 0 < width < diameter:
        raise DesignError(
            "blank.keyway.width_mm is {width:g}; it must be more than 0 and less than the bore's {diameter:g} mm",
            width=width,
            diameter=diameter,
        )
    if not depth > 0:
        raise DesignError("blank.keyway.depth_mm is {depth:g}; it must be more than 0", depth=depth)
    wall, floor, half = sqrt(radius**2 - width**2 / 4), radius + depth, width / 2
    corners = np.array([[wall, half], [wall, -half], [floor, -half], [floor, half]])
    sweep = 2 * np.pi - 2 * np.arctan2(half, wall)
    return Contour(_turned(corners, angle), np.array([np.tan(sweep / 4), 0.0, 0.0, 0.0]))


def d_bore(diameter: float, flat_depth: float, angle: float) -> Contour:
    """A bore about the origin with a flat that leaves material in it.

    Args:
        diameter: diameter of the bore, mm.
        flat_depth: distance of the flat from the circle, inwards, at its middle, mm.
        angle: polar angle of the flat's normal, rad.

    Raises:
        DesignError: the flat misses the circle or closes it.
    """
    if not 0 < flat_depth < diameter:
        raise DesignError(
            "the flat stands {flat_depth:g} mm inside the bore; it must be more than 0 and less than the bore's "
            "{diameter:g} mm",
            flat_depth=flat_depth,
            diameter=diameter,
        )
    across = diameter / 2 - flat_depth
    half = sqrt(flat_depth * (diameter - flat_depth))
    sweep = 2 * np.pi - 2 * np.arctan2(half, across)
    ends = np.array([[across, half], [across, -half]])
    return Contour(_turned(ends, angle), np.array([np.tan(sweep / 4), 0.0]))


def polygon_bore(across: float, count: int, angle: float) -> Contour:
    """A bore about the origin with equal flats all round.

    Args:
        across: size across flats, mm.
        count: number of flats, even.
        angle: polar angle of the first flat's normal, rad.
    """
    turns = 2 * np.pi / count * (np.arange(count) - 0.5)
    corners = across / 2 / np.cos(np.pi / count) * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return Contour(_turned(corners, angle), np.zeros(count))


def _turned(points: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(points @ np.array([[c, s], [-s, c]]))
