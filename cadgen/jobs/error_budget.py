"""The error budget of a design on one sheet: what costs most at the finish, and what to hold tighter."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees

from cadgen.car.running.side_slip import STIFFNESS
from cadgen.deviations.deviation import GEAR_ERRORS, SIDE_SLIP, Deviation
from cadgen.figures import Facts
from cadgen.gears.train import OnceATurn
from cadgen.inference.monte_carlo.budget import Budget, Cost, Process, by_process, each_run, error_budget
from cadgen.inference.monte_carlo.cars import Cars
from cadgen.messages import Message

_SHOWN = {"rad": ("deg", degrees(1.0)), "Nmm": ("N·mm", 1.0)}


@dataclass(frozen=True)
class BudgetSheet:
    """Error budget of a design's cars, and of a disc by manufacturing process.

    Attributes:
        budget: budget of the design.
        processes: budget of a disc with the usual tolerances of each process.
        shafts: error of the gears of each shaft, from the camshaft on.
        slip_assumed: whether the side slip is a guess, because the design does not give it.
    """

    budget: Budget
    processes: Mapping[Process, Budget]
    shafts: tuple[OnceATurn, ...] = ()
    slip_assumed: bool = False

    @property
    def anew(self) -> float:
        """Sum of all that comes anew in every run, as the root of squares, mm: no trim and no cam takes it out."""
        return each_run(self.budget.costs)

    def sentences(self) -> list[Message]:
        """Advice on the tolerance to hold tighter, and the meaning of the marks, in words."""
        lines = []
        costs = [cost for cost in self.budget.costs if not (self.slip_assumed and cost.deviation == SIDE_SLIP)]
        if costs:
            first = costs[0]
            kept = max(self.budget.after**2 - 0.75 * first.after**2, 0.0) ** 0.5
            lines.append(
                Message(
                    "Hold tighter first: {name}, {width}; half of it would take all together from {after:.0f} to "
                    "{kept:.0f} mm after a trim.",
                    name=Message(first.name.replace("_", " ")),
                    width=shown_half_width(first),
                    after=self.budget.after,
                    kept=kept,
                )
            )
            untrimmed = max(costs, key=lambda cost: cost.before)
            if untrimmed is not first:
                lines.append(
                    Message(
                        "Without a trim {name} costs most, {before:.0f} mm; a trial run and a turn of the micrometer "
                        "leave {after:.0f} mm of it, as long as it repeats.",
                        name=Message(untrimmed.name.replace("_", " ")),
                        before=untrimmed.before,
                        after=untrimmed.after,
                    )
                )
        lines += self._of_gears()
        if self.slip_assumed:
            lines.append(
                Message(
                    "The side slip is for a cornering stiffness of {stiffness:g} for a rad and a unit of load; nobody "
                    "has measured it, and 10 to 50 are as likely. Let the car run ten times, and give "
                    "tolerances.side_slip_deg.",
                    stiffness=STIFFNESS,
                )
            )
        if any(not cost.repeats for cost in costs):
            lines.append(
                Message("* is anew in every run, or is how closely the trim itself is set: no trim takes it out.")
            )
        if any(cost.rough for budget in (self.budget, *self.processes.values()) for cost in budget.costs):
            lines.append(Message("~ is beyond what first order is good for: of that size, and no closer."))
        return lines

    def _of_gears(self) -> list[Message]:
        """Advice on the phases in which the gears are put together, which cost nothing."""
        costs = {cost.deviation: cost for cost in self.budget.costs}
        rows = [
            (costs[each], shaft.least / shaft.size)
            for each, shaft in zip(GEAR_ERRORS, self.shafts, strict=False)
            if each in costs and shaft.size > 0
        ]
        if not rows:
            return []
        return [
            Message(
                "Put together at their worst the gears move the end by {before:.0f} mm, {after:.0f} after a trim. Mark "
                "where each runs out most, and set wheel and pinion of each shaft so that they take each other out: "
                "{left:.0f} mm, {trimmed:.0f} after a trim.",
                before=sum(cost.before for cost, _ in rows),
                after=sum(cost.after for cost, _ in rows),
                left=sum(cost.before * share for cost, share in rows),
                trimmed=sum(cost.after * share for cost, share in rows),
            )
        ]

    def rows(self) -> list[tuple[str, list[str]]]:
        """Rows of a table: each deviation with its cost by process, greatest first, then all together."""
        first = max(self.processes.values(), key=lambda budget: budget.before)
        rows = []
        for name in [cost.name for cost in first.costs]:
            cells = []
            for budget in self.processes.values():
                cost = next((cost for cost in budget.costs if cost.name == name), None)
                rough = "~" if cost is not None and cost.rough else ""
                cells.append("" if cost is None else f"{rough}{cost.before:.0f}, {cost.after:.0f}")
            rows.append((name, cells))
        together = [f"{budget.before:.0f}, {budget.after:.0f}" for budget in self.processes.values()]
        return [*rows, ("all, root of squares", together)]

    def entry(self) -> Facts:
        """Cost of every deviation, each in the unit that its key names."""
        return _costs(self.budget) | Facts(
            anew_in_every_run_mm=self.anew,
            processes={process: _costs(budget) for process, budget in self.processes.items()},
            advice=self.sentences(),
        )


def _costs(budget: Budget) -> Facts:
    return Facts(
        costs=[
            Facts(
                name=cost.name,
                half_width=cost.half_width * unit_of(cost.deviation)[1],
                unit=unit_of(cost.deviation)[0],
                end_position_mm=cost.before,
                end_position_after_trim_mm=cost.after,
                repeats=cost.repeats,
                beyond_first_order=cost.rough,
            )
            for cost in budget.costs
        ],
        root_of_squares_mm=Facts(before=budget.before, after_trim=budget.after),
    )


def budget_sheet(
    play_zones: Mapping[str, float],
    nominal: Cars,
    half_widths: Mapping[Deviation, float],
    of_the_parts: Mapping[Deviation, float],
    shafts: tuple[OnceATurn, ...] = (),
) -> BudgetSheet:
    """The error budget of a design.

    Args:
        play_zones: half of the zone of each part of the play, rad.
        nominal: nominal car of the design.
        half_widths: half of the tolerance zones of its cars, mm and rad, before any trim.
        of_the_parts: half widths that follow from gears and rod where the tolerances say nothing.
        shafts: error of the gears of each shaft, from the camshaft on.
    """
    halves = {**of_the_parts, **half_widths}
    return BudgetSheet(
        budget=error_budget(nominal, halves, play_zones),
        processes=by_process(nominal),
        shafts=shafts,
        slip_assumed=SIDE_SLIP in halves and SIDE_SLIP not in half_widths,
    )


def unit_of(name: Deviation) -> tuple[str, float]:
    """Unit of a tolerance on screen and in files, and the factor from the internal unit to it."""
    unit = name.unit
    return _SHOWN.get(unit, (unit, 1.0))


def shown_value(name: Deviation, value: float) -> str:
    """Value of a tolerance as text, with its unit on screen.

    Args:
        name: tolerance.
        value: value, mm or rad.
    """
    unit, scale = unit_of(name)
    return f"{value * scale:.3g}" + {"deg": "°", "1": ""}.get(unit, f" {unit}")


def shown_half_width(cost: Cost) -> str:
    """Half width of a deviation as text, with its unit on screen."""
    return shown_value(cost.deviation, cost.half_width)
