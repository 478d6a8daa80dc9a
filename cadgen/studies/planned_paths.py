"""Planned paths of a study: each distinct one is planned once and then serves all designs that share it."""

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from cadgen.design import cam_model
from cadgen.design.load import course_of
from cadgen.errors import CadgenError, brief
from cadgen.jobs.planning.plan import PlanRequest, plan_design
from cadgen.studies.design_row import TooLongError, override_of, timed, within
from cadgen.studies.sampling import REPLAN, Values
from cadgen.studies.study import ANY, ReplanKeys, Study

_WITH_A_PATH = ("path.", "course.", REPLAN)


@dataclass(frozen=True)
class PlannedText:
    """A design with a planned path.

    Attributes:
        key: what the path was planned for: JSON of its settings.
        text: text of the design; empty if there is no path.
        fault: why there is none, a sentence.
    """

    key: str
    text: str
    fault: str = ""


@dataclass(frozen=True)
class Planner:
    """Plans paths of a study, in any process.

    Attributes:
        study: the study; the limits for one path are those of one design.
        replan: its settings, where they do not vary.
    """

    study: Study
    replan: ReplanKeys

    @classmethod
    def of(cls, study: Study) -> "Planner | None":
        """The planner of a study; None if its paths are those of its designs."""
        replan = study.file.replan
        return None if replan is None else cls(study, replan)

    def __call__(self, keys: Sequence[str]) -> list[tuple[PlannedText, float]]:
        """Planned paths by their keys, each with its processor time, s."""
        return timed(self.planned, keys, self.study.file.each.memory_mb)

    def planned(self, key: str) -> PlannedText:
        """Plan a path by its key."""
        changed = dict(json.loads(key))
        most = changed.pop(f"{REPLAN}within_mm", self.replan.within_mm)
        reserve = float(changed.pop(f"{REPLAN}reserve", self.replan.reserve))
        seeds = int(changed.pop(f"{REPLAN}seeds", self.replan.seeds))
        study = self.study
        overrides = (*study.file.overrides, *(override_of(name, value) for name, value in changed.items()))
        try:
            with within(study.file.each.seconds):
                design, drawn = course_of(study.text, Path(study.source), overrides)
                own = cam_model.track(design) if drawn else None
                wanted = PlanRequest(seeds=seeds, reserve=reserve)
                if most != ANY:
                    wanted = replace(wanted, near=own, within=float(most), calm=own)
                plan = plan_design(design, study.text, own, wanted)
        except CadgenError as error:
            return PlannedText(key, "", brief(str(error)))
        except TooLongError as error:
            return PlannedText(key, "", f"its path: {error}")
        except MemoryError:
            return PlannedText(key, "", "its path ran out of memory (each.memory_mb)")
        except Exception as error:
            return PlannedText(key, "", brief(f"a fault in cadgen while planning ({type(error).__name__}: {error})"))
        return PlannedText(key, plan.text, "" if plan.text else brief(f"no path was planned: {plan.sentences[0]}"))

    def given_up(self, key: str) -> PlannedText:
        """The result for a path whose process died again and again."""
        return PlannedText(key, "", "the process that planned its path died each time")


def path_key(study: Study, values: Values) -> str | None:
    """Key of the planned path of a design; None where the path of the design itself is used."""
    replan = study.file.replan
    if replan is None:
        return None
    varied = dict(zip(study.keys, values, strict=True))
    if varied.get(f"{REPLAN}within_mm", replan.within_mm) == 0:
        return None
    changed: list[tuple[str, Any]] = []
    for each in study.variations:
        keys = (each.key, *(key for key, _ in each.along))
        if any(key.startswith(_WITH_A_PATH) or key in replan.planned_for for key in keys):
            changed += each.changes(varied[each.key])
    return json.dumps(dict(changed))
