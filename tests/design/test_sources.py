"""Sources of a motion: one more is one class, and the path of a car is one of the sections that motions come from."""

from typing import Annotated, ClassVar

import numpy as np
import pytest
from pydantic import Field, Strict, ValidationError

from cadgen.arrays import TURN
from cadgen.cam.followers.roller_kind import ROLLER
from cadgen.car.path_motion import PathMotion
from cadgen.design import cam_model, motion
from cadgen.design.load import load_design
from cadgen.design.motion import SOURCES, MotionSection
from cadgen.design.sources.source import MotionKeys
from cadgen.laws.series import HarmonicMotion


class EccentricKeys(MotionKeys):
    """Keys of a motion as of an eccentric."""

    code: ClassVar[str] = "eccentric_mm"

    eccentric_mm: Annotated[float | None, Strict(False)] = Field(default=None, gt=0)

    def motion(self, kind, *, corners):
        half = self.eccentric_mm
        return HarmonicMotion.of([(0, half, 0.0), (1, -half, 0.0)], kind.unit)


def test_a_source_is_one_class_and_one_base(monkeypatch):
    class Section(MotionSection, EccentricKeys):
        """Section with one source more."""

    monkeypatch.setattr(motion, "SOURCES", (*SOURCES, EccentricKeys))
    made = Section(turns="clockwise", eccentric_mm=3.0)
    theta = np.linspace(0, TURN, 7)
    np.testing.assert_allclose(motion.motion_of(made, ROLLER).q(theta), 3 * (1 - np.cos(theta)), atol=1e-9)
    assert made.shaping_key == "motion.eccentric_mm"
    with pytest.raises(
        ValidationError, match=r"takes one of motion.segments, .* or motion.eccentric_mm: keep harmonics"
    ):
        Section(turns="clockwise", eccentric_mm=3.0, harmonics=[[1, 2.0, 0.0]])


def test_the_path_of_a_car_is_a_source_among_them():
    design = load_design("carbon_free_car")
    source = cam_model.source_of(design)
    assert source is cam_model.CAM_MOTIONS["path"]
    assert isinstance(source.motion(design), PathMotion)
    assert source.shaping_key(design) == "path.waypoints_mm"
