"""A planned path as the face shows it: what `Design.plan` gives."""

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Generic, Self

from cadgen.api.calibration import D
from cadgen.api.cam import Cam
from cadgen.errors import CheckError
from cadgen.jobs.planning.path_planning import PathPlanning


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Plan(PathPlanning, Generic[D]):
    """Result of `Design.plan`: a path with its cam and checks, or the reasons why there is none.

    Attributes:
        cam: cam for the path, with all its checks; None if there is no path.
        source: design that a path was planned for.
    """

    cam: Cam | None
    source: D

    @classmethod
    def of(cls, planned: PathPlanning, source: D) -> "Plan[D]":
        """Plan with its design.

        Args:
            planned: what was computed.
            source: design that a path was planned for.
        """
        known = {item.name: getattr(planned, item.name) for item in fields(planned)}
        known["cam"] = None if planned.cam is None else Cam.of(planned.cam)
        return cls(source=source, **known)

    def __repr__(self) -> str:
        state = "no path" if self.verdict is None else self.verdict.readiness.words
        return f"<Plan of {self.asked.name}: {state}>"

    @property
    def computed(self) -> Self:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @cached_property
    def design(self) -> D:
        """The design with the planned path.

        Raises:
            CheckError: there is no path.
        """
        if not self.text:
            raise CheckError(self.sentences[0])
        return type(self.source).from_toml(self.text, self.asked.name)
