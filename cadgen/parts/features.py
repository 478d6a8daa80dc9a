"""Features of a part beside the outline of a disc or the teeth of a gear, with the dimensions of a drawing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.errors import DesignError
from cadgen.parts.face import Face

# DIN 6885-1 (ISO 773; printed extracts of GB/T 1095 agree): bore above and up to, in mm; width b and depth t2 of the
# keyway in the hub, in mm.
STANDARD_KEYWAYS = (
    (6.0, 8.0, 2.0, 1.0),
    (8.0, 10.0, 3.0, 1.4),
    (10.0, 12.0, 4.0, 1.8),
    (12.0, 17.0, 5.0, 2.3),
    (17.0, 22.0, 6.0, 2.8),
    (22.0, 30.0, 8.0, 3.3),
    (30.0, 38.0, 10.0, 3.3),
    (38.0, 44.0, 12.0, 3.3),
    (44.0, 50.0, 14.0, 3.8),
    (50.0, 58.0, 16.0, 4.3),
    (58.0, 65.0, 18.0, 4.4),
    (65.0, 75.0, 20.0, 4.9),
    (75.0, 85.0, 22.0, 5.4),
    (85.0, 95.0, 25.0, 5.4),
    (95.0, 110.0, 28.0, 6.4),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Keyway:
    """A keyway in the bore's wall.

    Attributes:
        width: width b across the key, mm.
        depth: depth t2 from the bore's circle to the keyway's floor along its middle, mm: bore and keyway span d + t2.
        angle: polar angle of its middle, rad.
    """

    width: float
    depth: float
    angle: float = 0.0

    @classmethod
    def standard(cls, bore_diameter: float) -> Keyway:
        """The keyway of DIN 6885-1 (ISO 773) for a bore in mm; `DesignError` for one it does not cover.

        Args:
            bore_diameter: diameter of the bore, mm.
        """
        for above, up_to, width, depth in STANDARD_KEYWAYS:
            if above < bore_diameter <= up_to:
                return cls(width=width, depth=depth)
        raise DesignError(
            "no keyway is standardised for a bore of {bore:g} mm; give a bore above 6 up to 110 mm, or "
            "the keyway's own width and depth",
            bore=bore_diameter,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class DFlat:
    """A flat in the bore.

    Attributes:
        depth: distance of the flat inside the bore's circle, mm.
        angle: polar angle of its middle, rad.
    """

    depth: float
    angle: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Flats:
    """Flats all round the bore: a square or a hexagon, whose size across flats is the bore's diameter.

    Attributes:
        count: number of flats, 4 or 6.
        angle: polar angle of the first one's middle, rad.
    """

    count: int
    angle: float = 0.0

    def corners_diameter(self, across: float) -> float:
        """Diameter of the circle through the corners, mm.

        Args:
            across: size across flats, mm.
        """
        return across / float(np.cos(np.pi / self.count))


@dataclass(frozen=True, slots=True, kw_only=True)
class SetScrew:
    """A radial hole through the hub's wall.

    Attributes:
        diameter: diameter of the hole, mm.
        height: height of its axis above the face that the hub stands on, mm.
        angle: polar angle of its axis, rad.
    """

    diameter: float
    height: float
    angle: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Hub:
    """A round hub on one face of the part.

    Attributes:
        diameter: diameter of the hub, mm.
        length: height of the hub above the face, mm; 0 for a flush hub that only bounds a web.
        side: face of the part that the hub stands on.
        set_screw: hole for a set screw; None for a hub without it.
    """

    diameter: float
    length: float = 0.0
    side: Face = Face.OUTER
    set_screw: SetScrew | None = None

    def level(self, height: float, thickness: float) -> float:
        """Coordinate z of a point `height` mm above the hub's face, on a part from z = 0 to z = thickness, mm.

        Args:
            height: height above the hub's face, mm.
            thickness: thickness of the part, mm.
        """
        return thickness + height if self.side == Face.OUTER else -height


@dataclass(frozen=True, slots=True, kw_only=True)
class Web:
    """A thinner disc between hub and rim, midway along the width of a gear.

    Attributes:
        thickness: thickness of the disc, mm.
        rim_thickness: thickness of the rim under the root of the teeth, mm.
    """

    thickness: float
    rim_thickness: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Lightening:
    """A ring of equal round holes.

    Attributes:
        count: number of holes.
        hole_diameter: diameter of each hole, mm.
        circle_diameter: diameter of the circle of their centres, mm; None, on a gear, for midway between hub and rim,
            with the first hole half a step off the keyway.
        start_angle: polar angle of the first hole, rad; it counts only with a circle_diameter.
    """

    count: int
    hole_diameter: float
    circle_diameter: float | None = None
    start_angle: float = 0.0

    def centers(self) -> Array:
        """Centres of the holes, shape (count, 2), mm.

        Raises:
            DesignError: circle_diameter is None.
        """
        if self.circle_diameter is None:
            raise DesignError("lightening holes need the diameter of the circle that their centres lie on")
        return _on_circle(self.circle_diameter, self.start_angle + TURN / self.count * np.arange(self.count))

    def centers_off_keyway(self, circle_diameter: float) -> Array:
        """Centres on a circle, the first half a step off a keyway on the x axis, shape (count, 2), mm.

        Args:
            circle_diameter: diameter of the circle, mm.
        """
        return _on_circle(circle_diameter, TURN * (np.arange(self.count) + 0.5) / self.count)


@dataclass(frozen=True, slots=True, kw_only=True)
class Mark:
    """A hole through a disc on one side of its key, by which a disc that is turned over shows.

    Attributes:
        diameter: diameter of the hole, mm.
        radius: distance of its centre from the axis, mm.
        angle: polar angle of its centre, rad.
    """

    diameter: float
    radius: float
    angle: float

    @property
    def centre(self) -> tuple[float, float]:
        """Centre of the hole, mm."""
        return float(self.radius * np.cos(self.angle)), float(self.radius * np.sin(self.angle))


def _on_circle(diameter: float, angles: NDArray[np.floating]) -> Array:
    return np.asarray(diameter / 2 * np.stack([np.cos(angles), np.sin(angles)], axis=1), dtype=np.float64)
