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

from math import radians
from typing import Literal

from cadgen.motion.friction import DiscMaterial

Process = Literal["milled", "wire-cut", "laser-cut", "printed"]

HALF_WIDTHS: dict[Process, dict[str, float]] = {
    "milled": {
        "profile_offset": 0.025,
        "taper": 0.01,
        "edge_break": 0.05,
        "eccentricity": 0.01,
        "wobble": radians(0.05),
        "inner_face": 0.05,
        "outer_face": 0.05,
    },
    "wire-cut": {
        "profile_offset": 0.005,
        "taper": 0.005,
        "edge_break": 0.01,
        "eccentricity": 0.005,
        "wobble": radians(0.05),
        "inner_face": 0.05,
        "outer_face": 0.05,
    },
    "laser-cut": {
        "profile_offset": 0.1,
        "taper": 0.06,
        "edge_break": 0.02,
        "eccentricity": 0.05,
        "wobble": radians(0.1),
        "inner_face": 0.1,
        "outer_face": 0.1,
    },
    "printed": {
        "profile_offset": 0.15,
        "taper": 0.1,
        "edge_break": 0.1,
        "eccentricity": 0.1,
        "wobble": radians(0.2),
        "inner_face": 0.1,
        "outer_face": 0.1,
    },
}

# Linear thermal expansion per K near room temperature: handbooks' tables, such as those that The Engineering ToolBox
# collects; PLA by makers of filament.
EXPANSION: dict[DiscMaterial, float] = {
    "aluminium": 23e-6,
    "steel": 12e-6,
    "brass": 19e-6,
    "acrylic": 70e-6,
    "PLA": 68e-6,
    "POM": 110e-6,
}
