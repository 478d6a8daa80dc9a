"""Plan, folder and formats that the writers of a cam's files share, with all that is computed once for all files."""

from dataclasses import dataclass
from functools import cached_property
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.checks import cam_angles
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.difference import Exact, dense_stations
from cadgen.cam.follower import Contact
from cadgen.car.running.sampled import rolled_lift
from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.closed import Outline
from cadgen.jobs.cam.plan import CamPlan
from cadgen.output.files.formats import Format

if TYPE_CHECKING:
    from cadgen.geometry.solids.kernel import SolidPart

# Share of the chord tolerance that the rim's chords may take at a pressure angle of 0; and at least, at 87 degrees.
_RIM_SHARE = 0.8
_LEAST_RIM_SHARE = 0.04


@dataclass(frozen=True)
class Result:
    """A file that was written and read back; one without an outline has no error at the lift."""

    name: str
    lift_error_um: float | None
    lift_limit_um: float | None
    facts: dict[str, Any]


@dataclass(frozen=True)
class Job:
    """Plan, folder and formats that the writers share, with what they compute once."""

    plan: CamPlan
    staging: Path
    formats: tuple[Format, ...]

    @property
    def stem(self) -> str:
        """Start of the names of all files."""
        return f"{self.plan.design.name}_{self.plan.profile}"

    @property
    def description(self) -> str:
        """One line, for formats that have room for it."""
        return f"steering cam, {self.plan.profile} profile, design {self.plan.design.content_hash[:12]}"

    @property
    def thickness(self) -> float:
        """Distance of the disc's faces, mm."""
        inner, outer = self.plan.design.cam.faces_mm
        return outer - inner

    @property
    def land(self) -> tuple[float, float] | None:
        """Heights of the edges of the land above the inner face, where the rod rides, mm; None with sharp edges."""
        return self.plan.made_blank.carrying(0.0, self.thickness) if self.plan.made_blank.edge_break else None

    @cached_property
    def cam_angle(self) -> Array:
        """Cam angles at which the follower is rolled, rad."""
        return cam_angles(self.plan.lift)

    @cached_property
    def rolled(self) -> tuple[Contact, float]:
        """Contact of the follower on the exact curve, and the step of the outline for it, mm."""
        return roll_curve(self.plan.curve, self.plan.follower, self.cam_angle)

    @property
    def step(self) -> float:
        """Distance of the points on an outline that is read back, mm."""
        return self.rolled[1]

    @cached_property
    def exact(self) -> Exact:
        """Exact curve for comparison with a file's lift, in points as close together as on an outline read back."""
        follower = self.plan.follower
        return Exact(self.plan.curve.outline(self.step), follower, dense_stations(follower, self.rolled[0]))

    @cached_property
    def rim_share(self) -> float:
        """Share of the error allowed to the lift that a chord of the rim may take along its normal.

        A chord that is off by e shifts the lift by e / cos(pressure angle).
        """
        steepest = float(np.cos(self.rolled[0].pressure_angle).min())
        return max(_RIM_SHARE * steepest, _LEAST_RIM_SHARE)

    @cached_property
    def part(self) -> "SolidPart":
        """The solid, for STEP, and for its volume."""
        from cadgen.geometry.solids.disc_solid import cam_part

        plan = self.plan
        return cam_part(plan.curve, plan.made_blank, self.thickness, name=self.stem, description=self.description)

    @cached_property
    def volume(self) -> float:
        """Volume for comparison with every file's, mm^3: by the profile, or with a hub that of the exact solid."""
        if self.plan.made_blank.hub is None:
            whole = self.plan.made_blank.disc_volume(self.plan.area, self.thickness)
            return whole - 2 * chamfered_off(self.plan.curve, self.plan.made_blank.edge_break)
        from cadgen.geometry.solids.kernel import volume

        return volume(self.part.solid)

    def result(self, name: str, outline: Outline, lift_limit_um: float, facts: dict[str, Any]) -> Result:
        """Roll the rod on an outline that was read back: error of the lift, and end of a run with play.

        Only lifts rolled in equal steps are compared, for the error of rolling is then nearly the same in both.

        Args:
            name: name of the file.
            outline: outline read back from it, mm.
            lift_limit_um: greatest error of the lift allowed, um.
            facts: what else was read back.
        """
        difference, contact = self.exact.compare(outline)
        end = self._end_of_run(outline, contact, lift_limit_um)
        return Result(name, difference * 1e3, lift_limit_um, {**facts, **end})

    def _end_of_run(self, outline: Outline, contact: Contact, lift_limit_um: float) -> dict[str, float]:
        comparison = self.plan.comparison
        if comparison is None:
            return {}
        as_built = comparison.task.as_built
        if as_built.shapes_discs:
            rolled = roll(as_built.finished(outline), self.plan.follower, self.cam_angle)
        else:
            rolled = contact.at(np.searchsorted(contact.cam_angle, self.cam_angle))
        # Rises and falls within the error allowed to the file are no events of the path.
        least_swing = max(comparison.chosen.least_swing, lift_limit_um * 1e-3 / comparison.task.follower.inner)
        lift = rolled_lift(rolled, self.plan.lift, blend_start=self.plan.lift.blend_start)
        heading, distance = comparison.end_of(lift, least_swing)
        return {"end_heading_deg": degrees(heading), "end_position_mm": distance}
