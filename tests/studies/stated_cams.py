"""Cars judged against the cam that is on them, or against another: `python -m tests.studies.stated_cams`.

Cars, worlds and records are those of `tests.studies.circles`, which share no code with the models. Every second car has
the cam against play on it, the others the actual one. Each is calibrated with the right profile stated and with the
other one, in turn. Asked: whether any car gets a new cam that was planned for a cam that it does not have and is worse
than before; and how many cars are refused one because of the stated cam, although it was the right one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.studies.circles import Drawn, draw, go_round, records_of

OTHER = {"actual": "optimized", "optimized": "actual"}


@dataclass(frozen=True)
class Case:
    """A car, the cam that was on it and the one that was stated, and whether another one was found.

    Attributes:
        verdict: on the stated cam, and `effects` found against it.
        better: by how much the other cam fits better, in the criterion; -inf where it is far off.
        refused: whether no cam is cut because of it.
        before, after: distance from the planned end on the old cam, and on a new one that was cut, mm.
    """

    number: int
    second: str
    has: str
    undeclared: str
    on_car: str
    stated: str
    verdict: str
    effects: str
    better: float
    refused: bool
    before: float
    after: float | None = None

    @property
    def right(self) -> bool:
        """Whether the stated cam was on the car."""
        return self.on_car == self.stated


def _drawn(seed: int, number: int, *, smooth: bool) -> Drawn:
    """A car of the study of circles; of smooth ones every second pair has the cam against play, too."""
    return draw(seed, number, smooth=smooth, against_play=bool(number // 2 % 2) if smooth else None)


def go(seed: int, number: int, *, right: bool, smooth: bool) -> dict[str, Any]:
    """A car that is judged against the cam on it or another one, as a journal holds it."""
    from cadgen.design.load import load_design
    from cadgen.inference.measurement.diagnosis import weigh_together
    from cadgen.inference.measurement.other_cam import other_cam
    from cadgen.jobs.calibration.cam_on_car import nominal_of

    drawn = _drawn(seed, number, smooth=smooth)
    on_car = "optimized" if drawn.against_play else "actual"
    stated = on_car if right else OTHER[on_car]
    design = load_design()
    known, other = (nominal_of(design, code) for code in (stated, OTHER[stated]))
    weighed = weigh_together(records_of(drawn, np.random.default_rng([seed, number, 1])), known).joint
    found = other_cam(weighed, known, other, OTHER[stated])
    after = None
    if not right and not (found and found.fits_better):
        outcome = go_round(seed, number, drawn=drawn, profile=stated)
        after = outcome.after if outcome.cut else None
    from tests.studies.circles_truth import Car

    bare = Car()
    return {
        "number": number,
        "second": drawn.second,
        "has": ", ".join(k for k, v in vars(drawn.car).items() if v != getattr(bare, k)),
        "undeclared": drawn.undeclared,
        "on_car": on_car,
        "stated": stated,
        "verdict": str(weighed.judgement.verdict),
        "effects": ", ".join(e.name for e in weighed.best.effects),
        "better": found.better if found else -np.inf,
        "refused": bool(found and found.fits_better),
        "before": drawn.before,
        "after": after,
    }


def page(cases: list[Case], command: str) -> str:
    """The study as a page."""
    from tests.studies.journal import share, stamp

    rows = [
        "# Study: the stated cam and the cam on the car",
        "",
        "Cars of [the study of circles](circles.md), calibrated with the profile that is on them stated, or the other",
        "one. *Refused*: the data fit the other cam better, by odds of 150 to 1, and no cam is cut. *Harmed*: a cam is",
        "cut for the wrong one, and the car ends farther off by more than 5 mm. In brackets what a share may be, 95 %.",
        "",
        f"`{command}`, {stamp()}",
        "",
        "| | | asked |",
        "|---|---|---|",
    ]
    right, wrong = [c for c in cases if c.right], [c for c in cases if not c.right]
    if right:
        count = share(sum(c.refused for c in right), len(right))
        rows.append(f"| right profile stated: refused for it | {count} | 3 % |")
    if wrong:
        harmed = sum(c.after is not None and c.after > c.before + 5 for c in wrong)
        rows += [
            f"| other profile stated: refused for it | {share(sum(c.refused for c in wrong), len(wrong))} | |",
            f"| other profile stated: harmed | {harmed} of {len(wrong)} | 0 |",
        ]
    rows += [
        "",
        "| car | with | has | undeclared | on the car | stated | verdict | effects | other cam better by | |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for c in cases:
        end = "refused" if c.refused else "" if c.after is None else f"cut: {c.before:.0f} to {c.after:.0f} mm"
        better = "far off" if c.better == -np.inf else f"{c.better:.0f}"
        rows.append(
            f"| {c.number} | {c.second} | {c.has} | {c.undeclared or '-'} | {c.on_car} | {c.stated} | {c.verdict} | "
            f"{c.effects or '-'} | {better} | {end} |"
        )
    return "\n".join(rows) + "\n"


def main() -> None:
    """Run the study."""
    from tests.studies.command import PAGES, options, tell
    from tests.studies.journal import outcomes

    chosen = options(__doc__, cases=54)
    # Three of four are smooth with the right cam stated; of the others, with the wrong one, every second rubs.
    smooth = round(chosen.cases * 3 / 4)
    jobs = [(chosen.seed, n, True, True) for n in range(smooth)]
    jobs += [(chosen.seed, n, False, True) for n in range((chosen.cases - smooth) // 2)]
    jobs += [(chosen.seed + 1, n, False, False) for n in range(chosen.cases - smooth - (chosen.cases - smooth) // 2)]
    found = outcomes(_of_job, jobs, chosen.log, chosen.processes)
    cases = [Case(**one) for one in found]
    command = f"python -m tests.studies.stated_cams --cases {chosen.cases} --seed {chosen.seed} --record"
    tell(page(cases, command), PAGES / "stated_cams.md" if chosen.record else None)


def _of_job(seed: int, number: int, right: bool, smooth: bool) -> dict[str, Any]:
    return go(seed, number, right=right, smooth=smooth)


if __name__ == "__main__":
    main()
