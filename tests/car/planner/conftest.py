from math import radians

import numpy as np
import pytest

from cadgen.car.course.body import CarBody
from cadgen.car.planner.constraints import curvature_limits
from cadgen.car.planner.kinematics import Basis
from cadgen.car.planner.path_task import SteeringLimits, Vehicle
from cadgen.car.planner.route import fitted_to
from cadgen.design import cam_model
from cadgen.design.course import body_of
from cadgen.design.load import load_design


@pytest.fixture(scope="session")
def vehicle() -> Vehicle:
    """The paper's car, with an outline, half the band of its train off."""
    design = load_design()
    wheels = body_of(design.car.outline, cam_model.car(design)).wheels
    body = CarBody(corners=((45, 55), (-215, 55), (-215, -215), (45, -215)), clearance=0.0, wheels=wheels)
    return Vehicle(
        car=cam_model.car(design),
        body=body,
        path_offset=117.5,
        base_radius=70.0,
        faces=(23.5, 26.5),
        spread=radians((0.96199785 - 0.51215675) / 2),
        end=1 - 12 / 360,
    )


@pytest.fixture(scope="session")
def limits(vehicle: Vehicle) -> SteeringLimits:
    left, right = curvature_limits(vehicle)
    return SteeringLimits(left=left, right=right, rise=radians(32), fall=radians(32), convex_radius=4.5)


@pytest.fixture(scope="session")
def paper_points() -> np.ndarray:
    """Control points of the paper's path."""
    path = cam_model.planned_path(load_design())
    u = np.linspace(path.knots[0], path.knots[-1], 40_001)
    curve = path.spline(u)
    arc = np.append(0.0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T)))
    even = np.interp(np.linspace(0, arc[-1], 2001), arc, u)
    return fitted_to(Basis(80), path.spline(even))
