"""Material beside the threads in the feet of a frame's sheets: the check against distances of the drilled cylinders."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from shapely.affinity import translate

from cadgen import Design
from cadgen.car.assembly.frame.built_frame import Frame
from cadgen.car.assembly.frame.frame_maker import frame_of
from cadgen.car.assembly.frame.frame_sizes import FrameSizes
from cadgen.car.assembly.panels import Panel
from cadgen.car.assembly.standard_parts import SCREWS
from cadgen.jobs.car_frame import CarFrame, car_frame

# The path of a car whose thread broke out of its plate, mm.
POINTS = [(0, 0), (900, 250), (1700, -150), (2600, -300), (3400, 150), (4300, 400), (5200, 50), (6000, -300)]
POINTS += [(6900, -100), (7700, 100)]


@pytest.fixture(scope="module")
def workshop() -> CarFrame:
    return car_frame(Design.load("workshop_car").values)


def with_wheels(made: CarFrame, diameter: float, sizes: FrameSizes) -> Frame:
    """Frame of a car with other drive wheels under the train of another one."""
    layout, found = made.layout, made.frame.arrangement
    site = replace(layout.site, wheel_radius=diameter / 2)
    found = replace(found, height=found.axes[0].imag + diameter / 2)
    return frame_of(sizes, site, found, layout.shafts, layout.bores)


def material(panel: Panel, thread: float) -> float:
    """Least distance of points of the threads' cylinders from the air beside the sheet and in its openings, mm.

    The foot stands on the base, which closes it, with its tabs, from below.
    """
    foot = panel.edge_holes[0].v
    outside = shapely.Polygon(panel.outline.polygon(0.001))
    solid = outside - shapely.union_all([shapely.Polygon(each.polygon(0.001)) for each in panel.openings])
    air = shapely.box(-500.0, foot, 500.0, 500.0) - solid
    least = np.inf
    for each in panel.edge_holes:
        up, across = np.meshgrid(np.linspace(0.0, each.depth, 81), np.linspace(-thread / 2, thread / 2, 9))
        points = shapely.points(each.u + across.ravel(), each.v + up.ravel())
        least = min(least, float(shapely.distance(points, air).min()))
    return least


@pytest.mark.parametrize(
    ("screw", "wall", "cutter"), [("M3", 2.0, 2.0), ("M2", 2.0, 3.0), ("M2.5", 1.5, 6.0), ("M4", 3.0, 2.0)]
)
def test_threads_keep_the_wall_under_every_wheel(workshop: CarFrame, screw: str, wall: float, cutter: float) -> None:
    sizes = replace(workshop.frame.sizes, screw=SCREWS[screw], wall=wall, corner=cutter / 2 + 0.05)
    threaded = 0
    for diameter in (80.0, 110.0, 140.0):
        frame = with_wheels(workshop, diameter, sizes)
        for panel in frame.standing:
            if panel.edge_holes:
                threaded += 1
                assert material(panel, sizes.screw.diameter) >= wall - 1e-3
        assert frame.block.beside(sizes.screw.diameter) >= wall - 1e-9
    assert threaded >= 6


def test_the_check_sees_a_thread_beside_a_slanted_side(workshop: CarFrame) -> None:
    """The sheet as its seats and its foot alone make it, and a thread that is moved out of it by steps."""
    frame = workshop.frame
    near, far = frame.plates
    for panel in (near, far):
        for moved in (0.5, 2.0, 4.0):
            edges = tuple(each._replace(u=each.u + moved) for each in panel.edge_holes)
            rooms = tuple(translate(room, moved) for room in panel.rooms)
            thin = replace(panel, edge_holes=edges, rooms=rooms)
            changed = replace(frame, plates=(thin, far) if panel is near else (near, thin))
            wall, where = changed.wall
            assert wall == pytest.approx(material(thin, 3.0), abs=0.01)
            assert wall < 2.0 - 0.2 * moved or wall == 0.0
            assert where == panel.name


def test_the_check_sees_a_nut_beside_a_slanted_side() -> None:
    frame = car_frame(Design.load("workshop_car", ["frame.cutting=laser"]).values).frame
    assert frame.wall[0] >= 2.0 - 1e-6
    plate = frame.plates[1]
    # The sides as they were before nuts were counted: the corner beside each nut is gone.
    corners = plate.outline.vertices
    foot = -frame.top
    outer = max(
        (at for at in range(len(corners)) if foot + 1.0 < corners[at, 1] < foot + 15.0), key=lambda at: corners[at, 0]
    )
    corners = np.delete(corners, outer, axis=0)
    thin = replace(plate, outline=type(plate.outline)(corners, np.zeros(len(corners))))
    assert replace(frame, plates=(frame.plates[0], thin)).wall[0] < 1.9


@pytest.mark.slow
@pytest.mark.long
def test_the_frame_of_a_new_car_is_one_solid_a_part(tmp_path: Path) -> None:
    points = tmp_path / "points.csv"
    points.write_text("x_mm,y_mm\n" + "".join(f"{x},{y}\n" for x, y in POINTS))
    design = Design.new("car2", tmp_path, points=points, train=True, changes={"car.outline.wheel_diameter_mm": 100})
    made = car_frame(design.values)
    assert made.passed
    assert min(material(panel, 3.0) for panel in made.frame.standing) >= 2.0 - 1e-3
    written = {file.name for file in design.frame().write(tmp_path / "made")}
    assert "car2_frame_plate_far.step" in written
