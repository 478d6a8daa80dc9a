"""From a design to a checked profile. No CAD kernel is needed for this."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, isfinite
from typing import Any

import numpy as np

from cadgen.cam.blank import CamBlank
from cadgen.cam.checks import Check, check_cam
from cadgen.cam.cure import Cure, undercut_cures, worst_loss
from cadgen.cam.envelope import Trim, actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.cam.theoretical import published_profile, theoretical_profile
from cadgen.curves.closed import ClosedCurve
from cadgen.design import stages
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.path.track import Track

Step = Callable[[str], None]


@dataclass(frozen=True)
class CamPlan:
    """A cam that has been computed and checked, but not yet made.

    Attributes:
        design: what it was planned from.
        profile: `actual`, `theoretical` or `published`.
        track: of the drive wheel.
        lift: the steering wanted.
        rod: the follower of the design.
        curve: the profile.
        trims: where the envelope was trimmed.
        blank: what the disc has besides its profile.
        checks: every figure with its verdict.
    """

    design: Design
    profile: str
    track: Track
    lift: LiftCurve
    rod: Follower
    curve: ClosedCurve
    trims: tuple[Trim, ...]
    blank: CamBlank
    checks: tuple[Check, ...]

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return all(check.passed for check in self.checks)

    @property
    def follower(self) -> Follower:
        """What rolls on this profile: the rod, or its axis on the theoretical profile."""
        return replace(self.rod, radius=0.0) if self.profile == "theoretical" else self.rod

    @cached_property
    def cures(self) -> tuple[Cure, ...]:
        """Changes of one number that bring lost lift within its limit; empty if none is lost or none cures."""
        lost = any(check.name.startswith("lost lift") and not check.passed for check in self.checks)
        limit = self.design.checks.lost_lift_limit_um * 1e-3
        return undercut_cures(self.lift, self.rod, limit) if lost else ()

    def cure_sentences(self) -> list[str]:
        """What would cure lost lift, smallest change first, in words."""
        lost = [check for check in self.checks if check.name.startswith("lost lift") and not check.passed]
        if not lost:
            return []
        lines = []
        if self.design.path.spline == "cubic":
            smooth = self.design.model_copy(update={"path": self.design.path.model_copy(update={"spline": "quintic"})})
            loss = worst_loss(stages.lift(smooth), self.rod) * 1e3
            verdict = "cures it" if loss <= lost[0].limit else "does not cure it"
            lines.append(
                f'path.spline = "quintic" {verdict}: {loss:.2f} µm lost, but the path between waypoints changes.'
            )
        for cure in self.cures:
            lines.append(f"{cure.parameter} = {cure.value:.3g} (now {cure.now:g}) cures it alone.")
        worst = max(check.value for check in lost)
        lines.append(f"To accept the loss, set checks.lost_lift_limit_um to {np.ceil(worst * 10) / 10:g} or more.")
        return lines

    def facts(self) -> dict[str, Any]:
        """The plan as plain values for the manifest and for machines."""
        peaks, valleys = self.lift.extrema()
        start = self.lift.blend_start
        return {
            "design": self.design.name,
            "source": self.design.source,
            "overrides": list(self.design.overrides),
            "design_sha256": self.design.content_hash,
            "profile": self.profile,
            "passed": self.passed,
            "checks": [
                {
                    "name": check.name,
                    "value": _plain(check.value),
                    "unit": check.unit,
                    "bound": check.bound,
                    "limit": _plain(check.limit),
                    "place": check.place,
                    "passed": check.passed,
                    "advice": "" if check.passed else check.advice,
                }
                for check in self.checks
            ],
            "cures": [{"parameter": c.parameter, "now": c.now, "value": c.value} for c in self.cures],
            "lift_extrema": [
                {
                    "kind": kind,
                    "cam_angle_deg": degrees(angle),
                    "lift_mm": float(self.rod.lift(self.lift.tan_beta(angle))),
                }
                for kind, angles in (("peak", peaks), ("valley", valleys))
                for angle in angles
            ],
            "track_length_mm": self.track.length,
            "blend": {
                "from_cam_angle_deg": degrees(start),
                "from_track_mm": self.track.length * start / (2 * np.pi),
                "where": self.track.where(self.track.length * start / (2 * np.pi)),
            },
            "profile_area_mm2": self.curve.area(),
        }


def plan_cam(design: Design, profile: str = "actual", step: Step = lambda text: None) -> CamPlan:
    """Compute the profile of a design and check it.

    Args:
        design: a loaded design.
        profile: `actual` (the exact envelope), `theoretical` (the rod's axis) or `published` (the appendix's
            formula).
        step: told what is being done.

    Raises:
        DesignError: the path cannot be driven, the rod leaves no disc, or there is no such profile.
    """
    step("planning the path")
    track = stages.track(design)
    lift = stages.lift(design, track)
    rod = stages.follower(design)
    step(f"computing the {profile} profile")
    trims: tuple[Trim, ...] = ()
    follower = rod
    match profile:
        case "actual":
            envelope = actual_profile(lift, rod)
            curve, trims = envelope.curve, envelope.trims
        case "theoretical":
            curve, follower = theoretical_profile(lift, rod), replace(rod, radius=0.0)
        case "published":
            curve = published_profile(lift, rod)
        case _:
            raise DesignError(f'there is no profile "{profile}": choose actual, theoretical or published')
    step("checking the profile")
    blank = stages.blank(design)
    checks = check_cam(lift, follower, curve, trims, blank, stages.check_limits(design))
    return CamPlan(design, profile, track, lift, rod, curve, trims, blank, checks)


def _plain(value: float) -> float | None:
    return value if isfinite(value) else None
