"""Cures of what failed in a cam, as of lost lift: changes of one key, each proved by planning the cam again."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil, floor, isfinite, log10

from cadgen.cam.checks import LOST_LIFT
from cadgen.cam.lost_lift import undercut_cures
from cadgen.check import Check, CheckCode, failing
from cadgen.design.section import listed
from cadgen.errors import CadgenError
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.laws.unit import TAN
from cadgen.messages import Message
from cadgen.progress import Progress, silent

# Each cure is proved by planning the cam again, some thirty times in all. With more kinks than this, which each take a
# hundredth of a second a plan, no cures are sought.
MOST_KINKS_CURED = 300


@dataclass(frozen=True)
class Cure:
    """Change of the design after which no more lift is lost than allowed.

    Attributes:
        override: change, as for `--set`.
        now: present value of the key, as text.
        failing: checks that fail with the change.
    """

    override: str
    now: str
    failing: tuple[Check, ...]


@dataclass(frozen=True)
class Cures:
    """Cures of what failed in a plan.

    Attributes:
        lost: failed checks that may be cured, such as those on lost lift; empty if there is nothing to cure.
        proved: changes that cure it, each alone.
        kinks: number of kinks of the lift; cures are sought for up to `MOST_KINKS_CURED`.
        of_path: whether a path shapes the motion, and not segments.
    """

    lost: tuple[Check, ...]
    proved: tuple[Cure, ...]
    kinks: int
    of_path: bool = True

    @property
    def sought(self) -> bool:
        """Whether the lift has so few kinks that cures are sought."""
        return self.kinks <= MOST_KINKS_CURED

    @property
    def whole(self) -> str | None:
        """First change with which every check of the cam holds, and no limit is raised; None without one."""
        changes = (each.override for each in self.proved if not each.failing)
        return next((change for change in changes if not change.startswith("checks.")), None)

    def sentences(self) -> list[str]:
        """Cures, in words."""
        lines: list[str] = []
        for cure in self.proved:
            change = {"override": cure.override, "now": cure.now}
            if not cure.failing:
                lines.append(
                    Message("--set {override} (now {now}) accepts it.", **change)
                    if cure.override.startswith("checks.")
                    else Message("--set {override} (now {now}) cures it.", **change)
                )
                continue
            failed = listed([Message(check.name) for check in cure.failing], "and")
            said = "--set {override} (now {now}) ends that, but fails {failed}."
            lines.append(Message(said, failed=failed, **change))
        if self.lost and not self.sought:
            lines.append(
                Message(
                    "What would cure it was not sought, for the lift has {kinks} kinks and it is for up to "
                    '{most}: set path.spline = "quintic", which has none, or keep fewer '
                    "waypoints.",
                    kinks=self.kinks,
                    most=MOST_KINKS_CURED,
                )
            )
        elif self.lost and not lines:
            lines.append(
                Message("No change of one key cures it: the path itself must become milder.")
                if self.of_path
                else Message("No change of one key cures it: the motion itself must become milder.")
            )
        return lines


def find_cures(plan: CamPlan, progress: Progress = silent) -> Cures:
    """Look for changes of one key that cure what failed; takes many plans if lift is lost.

    Args:
        plan: computed cam.
        progress: function that is called with a few words on each step.
    """
    of_path = plan.motion.unit == TAN
    cures = Cures(plan.application.curable(plan), (), len(plan.motion.kinks), of_path)
    if not cures.lost or not cures.sought:
        return cures
    lost = Message("looking for a change that cures lost lift")
    progress(lost if plan.lost else Message("looking for a change that cures what failed"))
    return replace(cures, proved=tuple(_tried(plan)))


def _tried(plan: CamPlan) -> Iterator[Cure]:
    """Try one key at a time: those of the application, those of the follower, and at last the limit itself."""
    tried = set[str]()
    for changes in plan.application.changes(plan):
        found = next(filter(None, (_proved(plan, override, now) for override, now in changes)), [])
        tried.update(cure.override.partition("=")[0] for cure in found)
        yield from found
    if not plan.lost:
        return
    limit = plan.limits.lost_lift
    if not isfinite(limit):
        # So much that the car is moved by no more than allowed, in proportion to what is lost.
        effect = next(check for check in plan.lost if check.code == CheckCode.LOST_LIFT_EFFECT)
        most = max(check.value for check in plan.checks if check.code in LOST_LIFT and check.code != effect.code)
        limit = most * 1e-3 * effect.limit / effect.value
    for change in undercut_cures(plan.motion, plan.follower_as_built, limit, without=frozenset(tried)):
        # Three digits, rounded to the safe side.
        unit = 10.0 ** (floor(log10(change.value)) - 2)
        safe = (ceil if change.value > change.now else floor)(change.value / unit) * unit
        yield from _proved(plan, f"{change.parameter}={safe:.4g}", f"{change.now:g}")
    for key, lost in (
        ("checks.lost_lift_limit_um", [check for check in plan.lost if check.code != CheckCode.LOST_LIFT_EFFECT]),
        ("checks.lost_lift_effect_mm", [check for check in plan.lost if check.code == CheckCode.LOST_LIFT_EFFECT]),
    ):
        if lost:
            allowed = ceil(max(check.value for check in lost) * 10) / 10  # rounded up to a tenth
            yield from _proved(plan, f"{key}={allowed:g}", f"{lost[0].limit:g}")


def _proved(plan: CamPlan, override: str, now: str) -> list[Cure]:
    """The change, if the design stays valid and no more lift than allowed is lost with it; else nothing."""
    try:
        failed = failing(plan.application.replanned(plan, override))
    except CadgenError:
        return []
    wrong = {*LOST_LIFT, *(check.code for check in plan.application.curable(plan))}
    return [] if any(check.code in wrong for check in failed) else [Cure(override, now, failed)]
