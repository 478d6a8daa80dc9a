"""Gears and trains given by numbers, without a design file: the same teeth, checks and files as a design's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from cadgen.check import Check
from cadgen.design.gear_model import usual_chord
from cadgen.gears.inspection import inspection_of
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.spur import form_facts
from cadgen.gears.stage import Wheel
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, TrainPlay, train_play
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.made_train import MadeTrain, make_train
from cadgen.jobs.gears.facts import checks_facts, parts_facts, return_error, stages_facts
from cadgen.parts.blank import Blank


@dataclass(frozen=True)
class TrainPlan:
    """A train given by numbers, computed and checked.

    Attributes:
        name: name of the train; the names of its files begin with it.
        train: play, layout, inspection and checks of the train.
    """

    name: str
    train: MadeTrain

    @property
    def play(self) -> TrainPlay:
        """Play of the train."""
        return self.train.play

    @property
    def layout(self) -> TrainLayout:
        """Parts at their places."""
        return self.train.layout

    @property
    def checks(self) -> tuple[Check, ...]:
        """Every figure with its verdict."""
        return self.train.checks

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return all(check.passed for check in self.checks)

    @property
    def stem(self) -> str:
        """Start of the names of its files."""
        return self.name

    @property
    def description(self) -> str:
        """Description of the gear for STEP files, one line."""
        return f"gear train {self.name}"

    def chord(self, gears: Sequence[Wheel]) -> float:
        """Greatest chord error of a part's mesh, mm."""
        return usual_chord(gears)

    def facts(self) -> dict[str, Any]:
        """The plan as plain values for the manifest and for machines."""
        return self._facts

    @cached_property
    def _facts(self) -> dict[str, Any]:
        return {
            "train": self.name,
            "passed": self.passed,
            "ratio": str(self.play.train.ratio),
            "return_error_deg": return_error(self.play),
            "stages": stages_facts(self.layout),
            "checks": checks_facts(self.checks),
            "parts": parts_facts(self.layout),
        }


def plan_train(
    train: Train,
    blanks: Sequence[Blank],
    name: str,
    directions: Sequence[float | None] | None = None,
    clearance: float = 0.3,
) -> TrainPlan:
    """Compute a train, lay it out, and measure its teeth in mesh.

    Args:
        train: train with its stages.
        blanks: features of the gears besides their teeth, for each shaft from the drive to the output.
        name: name of the train.
        directions: directions of the stages' lines of centres, rad; None for any.
        clearance: least gap between bodies on different shafts, mm.

    Raises:
        DesignError: a gear, its blank or the layout is impossible, or no standard covers a size.
    """
    return TrainPlan(name, make_train(train_play(train), blanks, directions, clearance, usual_chord))


def part_of(form: GearForm, blank: Blank) -> TrainPart:
    """Gear as a part by itself, its axis on z and its lower face at z = 0.

    Raises:
        DesignError: the tooth or the blank cannot be made.
    """
    body = gear_body(form, blank)
    return TrainPart(
        name="gear",
        shaft=1,
        gears=(form,),
        stages=(1,),
        blank=blank,
        body=body,
        axis=0j,
        angle=0.0,
        height=0.0,
        flipped=False,
    )


def gear_facts(form: GearForm, part: TrainPart, name: str) -> dict[str, Any]:
    """Gear as plain values, with what the shop measures on it as it is cut."""
    deviation = form.tooth_thickness_deviation
    sizes = inspection_of(form, deviation, deviation)
    return {
        "gear": name,
        **form_facts(form),
        "bore_mm": part.blank.bore_diameter,
        "E_sn_um": deviation * 1e3,
        "teeth_spanned": sizes.span.teeth_spanned if sizes.span else None,
        "span_mm": sizes.span.span.upper if sizes.span else None,
        "pin_diameter_mm": sizes.pins.pin_diameter if sizes.pins else None,
        "over_pins_mm": sizes.pins.over_pins.upper if sizes.pins else None,
        "volume_mm3": part.volume,
    }
