"""Mass of the disc without its hub: area less bore and holes, times thickness and density of its material."""

from cadgen.car.running.friction import DiscMaterial
from cadgen.errors import DesignError
from cadgen.studies.figures.evaluated import Evaluated
from cadgen.studies.figures.figure import Figure

# g/cm3: handbooks' tables, such as those that The Engineering ToolBox collects; PLA by makers of filament.
DENSITY: dict[DiscMaterial, float] = {
    DiscMaterial.ALUMINIUM: 2.70,
    DiscMaterial.STEEL: 7.85,
    DiscMaterial.BRASS: 8.50,
    DiscMaterial.ACRYLIC: 1.18,
    DiscMaterial.PLA: 1.24,
    DiscMaterial.POM: 1.41,
}


def _mass(evaluated: Evaluated) -> float:
    plan = evaluated.plan
    material = plan.design.blank.material
    if material is None:
        raise DesignError("the mass of the disc needs its material: add blank.material, such as aluminium")
    inner, outer = plan.design.cam.faces_mm
    return plan.blank.disc_volume(plan.area, outer - inner) * DENSITY[material] * 1e-3


DISC_MASS = Figure(
    code="disc_mass_g",
    meaning="mass of the disc without its hub",
    of=_mass,
    resolution=0.01,
)
