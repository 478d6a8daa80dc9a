"""Features of a part besides its outline or teeth: bore, keyway or flat, hub, web, holes, broken edges; walls left."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array, gauss_nodes
from cadgen.curves.closed import Outline, cross, polar_angle
from cadgen.curves.contour import Contour, circle, d_bore, keyway_bore, polygon_bore
from cadgen.errors import DesignError
from cadgen.messages import Message
from cadgen.parts.body import RadialHole
from cadgen.parts.features import DFlat, Flats, Hub, Keyway, Lightening, Mark, Web

OVERSHOOT = 1.0  # mm by which a cutting tool sticks out of what it cuts
PROFILE_STEP = 0.1  # mm between the profile's points when the walls are measured: 1e-4 mm of wall at 10 mm of radius
_STEP = 0.05  # mm between points on bore and hub, which errs by 1e-4 mm of wall on a hub of 6 mm
_SCREW_NODES = 24  # of the integral across a set screw's hole
_BORE_CHORD = 1e-5  # mm; of the bore's polygon that this hole begins at
_STATION = 64  # points of an outline, of which the first is tried before the others
_ROUNDING = 1e-9  # mm, of a way along an outline


@dataclass(frozen=True, slots=True)
class ThinWall:
    """Material left between two features.

    Attributes:
        between: names of the two features.
        thickness: thickness of the wall, mm; negative where one feature cuts into the other.
        place: point where the wall is thinnest, shape (2,), mm.
        at_rim: whether one of the two is the profile.
    """

    between: str
    thickness: float
    place: Array
    at_rim: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Boss:
    """A hub on a disc from z = 0 to z = thickness: the cylinder added to the disc, and the cuts through both.

    Attributes:
        diameter: diameter of the hub, mm.
        low: z at which the hub begins, mm.
        high: z at which it ends, mm.
        bottom: z at which the cut of the bore begins, outside both, mm.
        top: z at which that cut ends, mm.
        drill: hole of the set screw; None for a hub without a set screw.
    """

    diameter: float
    low: float
    high: float
    bottom: float
    top: float
    drill: RadialHole | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Blank:
    """Features of a part besides its outline or teeth; None, and lengths of 0, leave a feature out.

    Attributes:
        bore_diameter: diameter of the hole for the shaft, mm; 0 for no hole, which only a gear may have.
        key: keyway or flat that holds the part on its shaft; None for a plain bore. A gear has no D-flat.
        hub: hub on one face; None for a flat part.
        web: thinner disc between hub and rim, for a gear only.
        lightening: ring of holes; None for a full part.
        mark: hole that shows which face is up, for a disc only; None for a disc without.
        edge_break: leg of the 45 degree chamfer on both edges of a disc's rim, mm; 0 for sharp edges.
    """

    bore_diameter: float = 0.0
    key: Keyway | DFlat | Flats | None = None
    hub: Hub | None = None
    web: Web | None = None
    lightening: Lightening | None = None
    mark: Mark | None = None
    edge_break: float = 0.0

    def carrying(self, inner_face: float, outer_face: float) -> tuple[float, float]:
        """Planes in which the rim carries a leaning rod: the edges of the land between the chamfers, mm.

        Args:
            inner_face: lateral distance of the disc's inner face from the fork axis, mm.
            outer_face: lateral distance of the outer face, mm.
        """
        return inner_face + self.edge_break, outer_face - self.edge_break

    def faces(self, inner: float, outer: float) -> tuple[float, float]:
        """Lateral distances of the disc's faces from the fork axis, mm, from those of the planes of `carrying`.

        Args:
            inner: distance of the plane nearer to the fork axis, mm.
            outer: distance of the farther plane, mm.
        """
        return inner - self.edge_break, outer + self.edge_break

    @property
    def shaft_diameter(self) -> float:
        """Diameter of the circle that holds the shaft, mm; 0 without a bore."""
        return self.key.corners_diameter(self.bore_diameter) if isinstance(self.key, Flats) else self.bore_diameter

    def bore(self) -> Contour:
        """The bore with its keyway or flats, run counterclockwise.

        Raises:
            DesignError: the keyway or the flat does not fit the bore.
        """
        match self.key:
            case Keyway(width=width, depth=depth, angle=angle):
                return keyway_bore(self.bore_diameter, width, depth, angle)
            case DFlat(depth=depth, angle=angle):
                return d_bore(self.bore_diameter, depth, angle)
            case Flats(count=count, angle=angle):
                return polygon_bore(self.bore_diameter, count, angle)
            case _:
                return circle((0.0, 0.0), self.bore_diameter / 2)

    def holes(self) -> tuple[Contour, ...]:
        """The lightening holes of a disc, and the mark after them, each run counterclockwise.

        Raises:
            DesignError: the blank has no circle for the centres of the holes.
        """
        ring, mark = self.lightening, self.mark
        holes = [circle(center, ring.hole_diameter / 2) for center in ring.centers()] if ring else []
        return *holes, *([circle(mark.centre, mark.diameter / 2)] if mark else [])

    def inner_contours(self) -> tuple[Contour, ...]:
        """Everything cut out of the disc: the bore, then the holes of `holes`."""
        return self.bore(), *self.holes()

    def boss(self, thickness: float) -> Boss | None:
        """Hub on a disc from z = 0 to z = thickness (mm); None without a hub.

        Args:
            thickness: thickness of the disc, mm.
        """
        hub = self.hub
        if hub is None:
            return None
        low, high = sorted((hub.level(0.0, thickness), hub.level(hub.length, thickness)))
        drill = None
        if screw := hub.set_screw:
            height, reach = hub.level(screw.height, thickness), hub.diameter / 2 + OVERSHOOT
            drill = RadialHole(screw.diameter, height, reach, screw.angle)
        bottom, top = min(low, 0.0) - OVERSHOOT, max(high, thickness) + OVERSHOOT
        return Boss(diameter=hub.diameter, low=low, high=high, bottom=bottom, top=top, drill=drill)

    def disc_volume(self, profile_area: float, thickness: float) -> float:
        """Volume of the disc without its hub, mm^3: profile_area (mm^2) less the contours, times the thickness (mm).

        The chamfers of broken edges are not taken off: see `cadgen.curves.chamfer.chamfered_off`. The hub is apart:
        see `hub_volume`.

        Args:
            profile_area: area inside the profile, mm².
            thickness: thickness of the disc, mm.
        """
        return (profile_area - sum(contour.area() for contour in self.inner_contours())) * thickness

    def hub_volume(self) -> float:
        """Volume of the hub beyond the face of its disc, mm³: the ring about the bore, less the set screw's hole.

        Across the hole, at the distance y from its axis, its chord is 2 √(ρ² - y²) long. The wall reaches from the
        bore, the keyway's floor or the flat to the hub's circle.
        """
        hub = self.hub
        if hub is None:
            return 0.0
        whole = float((np.pi * hub.diameter**2 / 4 - self.bore().area()) * hub.length)
        return whole - self.screw_volume()

    def screw_volume(self) -> float:
        """Volume of the set screw's hole between bore and hub, mm³; 0 without one."""
        hub = self.hub
        if hub is None or hub.set_screw is None:
            return 0.0
        screw, bore = hub.set_screw, self.bore()
        hole = screw.diameter / 2
        # y = ρ sin t makes the integrand smooth between the corners of the bore.
        corners = (bore.vertices @ [1, 1j] * np.exp(-1j * screw.angle)).imag / hole
        ends = np.unique(np.arcsin(np.clip([-1.0, *corners, 1.0], -1.0, 1.0)))
        nodes, weights = gauss_nodes(_SCREW_NODES)
        half = np.diff(ends)[:, None] / 2
        t = ends[:-1, None] + half * (1 + nodes)
        y = hole * np.sin(t)
        wall = np.sqrt((hub.diameter / 2) ** 2 - y**2) - _reach(bore, screw.angle, y.ravel()).reshape(y.shape)
        return float(np.sum(half * weights * 2 * (hole * np.cos(t)) ** 2 * wall))

    def walls(self, profile: Outline) -> tuple[ThinWall, ...]:
        """Material between profile, bore, hub, set screw and lightening holes, at the thinnest place of each kind.

        Walls to the profile are taken on the disc's faces, where broken edges leave the least. Exact but for the
        profile's own points, whose spacing h errs by h^2 / 8 times its curvature.

        Args:
            profile: dense points of the disc's outline.
        """
        return _walls(self, profile)

    def require_walls(self, profile: Outline) -> None:
        """Refuse a blank of which no solid can be made.

        Args:
            profile: dense points of the disc's outline.

        Raises:
            DesignError: one feature cuts into another or through the profile, or is for gears only.
        """
        if self.web:
            raise DesignError("a web is for a gear: leave it out of the disc's blank")
        if not self.bore_diameter > 0:
            raise DesignError(
                "the bore of a disc is {bore:g} mm: give it a diameter of more than 0",
                bore=self.bore_diameter,
            )
        thinnest = min(self.walls(profile), key=lambda wall: wall.thickness)
        if thinnest.thickness <= 0:
            x, y = thinnest.place
            raise DesignError(
                "{between} overlap by {thickness:.2f} mm at ({x:.1f}, {y:.1f}) mm: make one of them smaller or move "
                "them apart (the design's [blank])",
                between=thinnest.between,
                thickness=-thinnest.thickness,
                x=x,
                y=y,
            )


@lru_cache(maxsize=8)  # checks, solids and meshes of a disc ask for the same walls
def _walls(blank: Blank, profile: Outline) -> tuple[ThinWall, ...]:
    core, name = blank.bore(), Message("bore")
    walls = [_to_rim(core, name, profile)]
    if blank.hub:
        hub = circle((0.0, 0.0), blank.hub.diameter / 2)
        walls.append(_enclosed(core, name, hub.outline(_STEP), Message("hub")))
        core, name = hub, Message("hub")
        walls.append(_to_rim(core, name, profile))
        walls += _screw_walls(blank.hub)
    holes, ring = blank.holes(), blank.lightening
    names = [Message("lightening hole {number}", number=n) for n in range(1, ring.count + 1)] if ring else []
    names += [Message("mark")] if blank.mark else []
    if holes:
        rim = [_to_rim(hole, of_hole, profile) for hole, of_hole in zip(holes, names, strict=True)]
        walls.append(min(rim, key=lambda wall: wall.thickness))
        centers, radii = np.array([hole.centers[0] for hole in holes]), np.array([hole.radii[0] for hole in holes])
        aside = _distance(core, centers) * np.sign(_beyond(centers, core.outline(_STEP)))
        inner = aside - radii
        worst = int(np.argmin(inner))
        walls.append(ThinWall(_between(names[worst], name), float(inner[worst]), centers[worst]))
    if ring and ring.circle_diameter and ring.count > 1:
        apart = ring.circle_diameter * np.sin(np.pi / ring.count) - ring.hole_diameter
        walls.append(ThinWall(Message("two lightening holes"), float(apart), (centers[0] + centers[1]) / 2))
    if ring and blank.mark:
        between = np.linalg.norm(centers[:-1] - centers[-1], axis=1) - radii[:-1] - radii[-1]
        near = int(np.argmin(between))
        walls.append(
            ThinWall(_between(names[near], names[-1]), float(between[near]), (centers[near] + centers[-1]) / 2)
        )
    return tuple(replace(wall, thickness=wall.thickness - blank.edge_break) if wall.at_rim else wall for wall in walls)


def _between(one: str, other: str) -> Message:
    return Message("{one} and {other}", one=one, other=other)


def _screw_walls(hub: Hub) -> tuple[ThinWall, ...]:
    """Walls along the hub's length on either side of its set screw; none without a set screw."""
    screw = hub.set_screw
    if screw is None:
        return ()
    place = hub.diameter / 2 * np.array([np.cos(screw.angle), np.sin(screw.angle)])
    below = screw.height - screw.diameter / 2
    return (
        ThinWall(Message("set screw and disc"), below, place),
        ThinWall(Message("set screw and the hub's end"), hub.length - screw.height - screw.diameter / 2, place),
    )


def _to_rim(inner: Contour, name: str, profile: Outline) -> ThinWall:
    return replace(_enclosed(inner, name, profile, Message("profile")), at_rim=True)


def _enclosed(inner: Contour, name: str, outer: Outline, outer_name: str) -> ThinWall:
    points = inner.outline(_STEP).points
    beyond = _beyond(points, outer)
    worst = int(np.argmax(beyond))
    if beyond[worst] >= 0:
        return ThinWall(_between(name, outer_name), -float(beyond[worst]), points[worst])
    near = outer.points[_may_be_nearest(inner, outer.points)]
    distance = _distance(inner, near)
    nearest = int(np.argmin(distance))
    return ThinWall(_between(name, outer_name), float(distance[nearest]), near[nearest])


def _may_be_nearest(contour: Contour, points: Array) -> NDArray[np.bool_]:
    """Mask of the points along a curve that may be the nearest to a contour, shape (n,).

    From one point to another the distance from the contour changes by no more than the way between them.
    """
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    stations = np.arange(0, len(points), _STATION)
    distance = _distance(contour, points[stations])
    lower = np.repeat(distance, _STATION)[: len(points)] - (way - np.repeat(way[stations], _STATION)[: len(points)])
    return np.asarray(lower <= distance.min() + _ROUNDING)


def _reach(bore: Contour, angle: float, across: Array) -> Array:
    """How far a bore reaches along lines in a direction, mm.

    Args:
        bore: bore with its keyway or flat.
        angle: polar angle of the direction, rad.
        across: distances of the lines from the axis, mm, shape (n,), less than the bore's radius.
    """
    points = bore.polygon(_BORE_CHORD) @ [1, 1j] * np.exp(-1j * angle)
    start, stop = points, np.roll(points, -1)
    ahead = stop.imag > start.imag  # run counterclockwise, only such sides look in the direction
    start, way = start[ahead], (stop - start)[ahead]
    share = (across[:, None] - start.imag) / way.imag
    crossed = (share >= -_ROUNDING) & (share <= 1 + _ROUNDING)
    return np.asarray(np.where(crossed, start.real + share * way.real, -np.inf).max(axis=1))


def _beyond(points: Array, outline: Outline) -> Array:
    """Radial distance of points beyond an outline that is star-shaped about the axis, mm."""
    rim = np.interp(polar_angle(points), outline.angle, np.linalg.norm(outline.points, axis=1), period=TURN)
    return np.asarray(np.linalg.norm(points, axis=1) - rim)


def _distance(contour: Contour, points: Array) -> Array:
    """Distance of points, shape (n, 2), from the nearest side of a contour, mm, in closed form."""
    from_start = points[:, None] - contour.vertices
    chords = contour.chords
    share = np.sum(from_start * chords, axis=2) / np.sum(chords**2, axis=1)
    to_line = np.linalg.norm(from_start - np.clip(share, 0.0, 1.0)[..., None] * chords, axis=2)
    from_center, middle = points[:, None] - contour.centers, contour.middles - contour.centers
    off_middle = np.arctan2(cross(middle, from_center), np.sum(middle * from_center, axis=2))
    to_circle = np.abs(np.linalg.norm(from_center, axis=2) - contour.radii)
    to_ends = np.linalg.norm(from_start, axis=2)
    to_ends = np.minimum(to_ends, np.roll(to_ends, -1, axis=1))
    to_arc = np.where(np.abs(off_middle) <= np.abs(contour.sweeps) / 2, to_circle, to_ends)
    return np.asarray(np.where(contour.bulges == 0, to_line, to_arc).min(axis=1))
