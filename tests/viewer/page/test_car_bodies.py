"""All parts of a laid out car in 3D: each stands where the assembly has it, and says what lies nearest."""

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.geometry.meshes.car_meshes import shape_mesh
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_assembly import put_together
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.viewer.page.document import FORK
from cadgen.viewer.page.scene import bodies_of


@pytest.mark.parametrize("name", ["workshop_car", pytest.param("s_course", marks=[pytest.mark.slow, pytest.mark.long])])
def test_every_part_stands_where_the_assembly_has_it(name):
    design = load_design(name)
    cam, gears = plan_cam(design, "actual"), plan_gears(design)
    assembly, bodies = put_together(cam, gears), bodies_of(cam, gears, 80.0)
    places = [(part, place) for part in assembly.parts for place in part.places if part.shape is not None]
    assert len(bodies.parts) == len(places)
    for drawn, (part, place) in zip(bodies.parts, places, strict=True):
        assert drawn.branch
        wanted = shape_mesh(part.shape, 0.05).vertices @ place[:, :3].T + place[:, 3]
        found = np.array(drawn.mesh.vertices)
        if drawn.shaft == FORK:
            found += [part.group.axis.real, 0.0, part.group.axis.imag]
        elif drawn.shaft >= 0:
            shaft = bodies.shafts[drawn.shaft]
            c, s = np.cos(shaft.angle), np.sin(shaft.angle)
            found = found @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) + [*shaft.axis, 0.0]
        for end in ("min", "max"):
            assert getattr(found, end)(axis=0) == pytest.approx(getattr(wanted, end)(axis=0), abs=0.06), part.code
    disc = next(part for part in bodies.parts if part.code == "cam")
    assert "2 mm to base plate" in disc.near if name == "workshop_car" else disc.near
