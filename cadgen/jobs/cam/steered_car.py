"""A car that a cam steers, as far as its parts, its mass and its energy go by it."""

from abc import abstractmethod
from typing import Self

from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_plan import Application, CamPlan
from cadgen.jobs.cam.wheel import DriveWheel
from cadgen.jobs.car_layout import CarLayout


class SteeredCar(Application):
    """A car that a cam steers.

    Attributes:
        design: design of the car.
        track: track of the drive wheel.
        steering: motion that the profile is cut for.
    """

    design: Design
    track: Track
    steering: PathMotion

    @classmethod
    def of(cls, cam: CamPlan) -> Self:
        """Car that a cam steers.

        Raises:
            DesignError: the cam is of a design with [motion].
        """
        if isinstance(cam.application, cls):
            return cam.application
        raise DesignError("{name} is a cam by its [motion]: there is no car that it steers", name=cam.origin.name)

    @property
    @abstractmethod
    def car(self) -> Car:
        """The car in plan view, as built."""

    @property
    @abstractmethod
    def drive_wheel(self) -> DriveWheel:
        """Drive wheel that the cam is for."""

    @property
    @abstractmethod
    def travel(self) -> float:
        """Travel of the drive wheel's rim for one turn of the cam, mm."""

    @property
    @abstractmethod
    def wanted(self) -> PathMotion:
        """Motion that the path asks for; what the profile is cut for may be another, against play."""

    @property
    @abstractmethod
    def in_car(self) -> CarLayout | None:
        """Train in the car; None without [layout]."""

    @abstractmethod
    def rolled(self, cam: CamPlan) -> PathMotion:
        """Motion that the follower gets on the cam that is made.

        Args:
            cam: plan of the cam.
        """
