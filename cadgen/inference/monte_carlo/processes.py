"""Usual tolerances of manufacturing processes, and thermal expansion of materials: typical values, in one place.

Half widths, in mm and rad, of the deviations that a process makes on a disc of some 150 mm, 3 mm thick. The sources
call them normal for it; a shop's own figures are better, and go into [tolerances].

- **milled**: an end mill in one clamping holds 0.025 mm (tables of process capability: 0.025 to 0.13 mm; Machinery's
  Handbook: milling IT 10, reaming and boring IT 7 to 8, which for a bore of 8 mm is 15 um); the mill gives way by some
  hundredth over its length; edges are broken by hand; faces as ISO 2768-f, 0.05 mm.
- **wire-cut** (wire EDM): 5 um of profile and taper with a second pass (makers' data: 2.5 to 5 um); bore and profile in
  one clamping.
- **laser-cut**: 0.1 mm of profile (ISO 9013, laser, up to 3 mm thick; job shops: 0.13 mm), the cut leans by
  0.05 mm + 0.003 of the thickness (ISO 9013, perpendicularity, range 1), and sheet varies in thickness.
- **printed** (melted filament): 0.15 mm (tables: 0.1 to 0.5 mm), the first layers stand out, edges are round with half
  the bead.
"""

from enum import StrEnum
from math import radians

from cadgen.car.motion.friction import DiscMaterial
from cadgen.inference.monte_carlo.parameters import Directed, Parameter, Tolerance


class Process(StrEnum):
    """Process by which a disc is made."""

    MILLED = "milled"
    WIRE_CUT = "wire-cut"
    LASER_CUT = "laser-cut"
    PRINTED = "printed"


HALF_WIDTHS: dict[Process, dict[Tolerance, float]] = {
    Process.MILLED: {
        Parameter.PROFILE_OFFSET: 0.025,
        Parameter.TAPER: 0.01,
        Parameter.EDGE_BREAK: 0.05,
        Directed.ECCENTRICITY: 0.01,
        Directed.WOBBLE: radians(0.05),
        Parameter.INNER_FACE: 0.05,
        Parameter.OUTER_FACE: 0.05,
    },
    Process.WIRE_CUT: {
        Parameter.PROFILE_OFFSET: 0.005,
        Parameter.TAPER: 0.005,
        Parameter.EDGE_BREAK: 0.01,
        Directed.ECCENTRICITY: 0.005,
        Directed.WOBBLE: radians(0.05),
        Parameter.INNER_FACE: 0.05,
        Parameter.OUTER_FACE: 0.05,
    },
    Process.LASER_CUT: {
        Parameter.PROFILE_OFFSET: 0.1,
        Parameter.TAPER: 0.06,
        Parameter.EDGE_BREAK: 0.02,
        Directed.ECCENTRICITY: 0.05,
        Directed.WOBBLE: radians(0.1),
        Parameter.INNER_FACE: 0.1,
        Parameter.OUTER_FACE: 0.1,
    },
    Process.PRINTED: {
        Parameter.PROFILE_OFFSET: 0.15,
        Parameter.TAPER: 0.1,
        Parameter.EDGE_BREAK: 0.1,
        Directed.ECCENTRICITY: 0.1,
        Directed.WOBBLE: radians(0.2),
        Parameter.INNER_FACE: 0.1,
        Parameter.OUTER_FACE: 0.1,
    },
}

# Linear thermal expansion per K near room temperature: handbooks' tables, such as those that The Engineering ToolBox
# collects; PLA by makers of filament.
EXPANSION: dict[DiscMaterial, float] = {
    DiscMaterial.ALUMINIUM: 23e-6,
    DiscMaterial.STEEL: 12e-6,
    DiscMaterial.BRASS: 19e-6,
    DiscMaterial.ACRYLIC: 70e-6,
    DiscMaterial.PLA: 68e-6,
    DiscMaterial.POM: 110e-6,
}
