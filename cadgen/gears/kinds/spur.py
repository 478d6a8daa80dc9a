"""A pair of spur gears as a stage of a train."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import pi, tan
from typing import Any, Self

from cadgen.check import Check
from cadgen.errors import DesignError
from cadgen.gears import thinning
from cadgen.gears.backlash import StagePlay, pair_departures, stage_play
from cadgen.gears.engaged import Engage
from cadgen.gears.inspection import Inspection, inspection_of
from cadgen.gears.kinds import spur_checks, spur_facts
from cadgen.gears.pair import Pair
from cadgen.gears.stage import Departure, Stage
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train
from cadgen.gears.undercut import missing_shift

TEETH = "leave the kind out and give the stage gears with teeth"


@dataclass(frozen=True, slots=True, kw_only=True)
class GearPair(Pair, Stage):
    """One stage of spur gears; numbers and errors are those of `Pair`."""

    noun = "spur gears"

    @property
    def wheels(self) -> tuple[GearForm, GearForm]:
        """Both gears' forms."""
        return self.driver.form, self.driven.form

    @property
    def label(self) -> str:
        """Teeth of both gears, such as 20/60."""
        return f"{self.driver.form.teeth}/{self.driven.form.teeth}"

    @property
    def module(self) -> float:
        """m_n, mm."""
        return self.driver.form.normal_module

    @property
    def toothed(self) -> bool:
        """Play is the room between flanks."""
        return True

    def play(self) -> StagePlay[float]:
        """Play and return error by eq. 1-13; a `DesignError` for a size that the standards do not cover."""
        return stage_play(self)

    def free_angle(self) -> float:
        """Play of the driven gear as cut, by the exact geometry of involutes, rad."""
        return self.exact_play()

    def opened(self, clearance: float) -> float:
        """By eq. 1, axes further apart by `clearance`, mm, open 2 C tan(alpha_w) on the pitch circle; in rad.

        Args:
            clearance: growth of the distance of the axes, mm.
        """
        return 2 * clearance * tan(self.working_pressure_angle) / self.driven_pitch_radius

    def as_cut(self) -> Self:
        """The pair with its teeth thinned; a `DesignError` for a tooth that cannot be cut so, or at its limits."""
        return thinning.as_cut(self, self.play())

    def departures(self, number: int) -> tuple[Departure, ...]:
        """Its overrides; `number` is that of the stage."""
        return pair_departures(self, number)

    def driven_angle(self, driver_angle: float, direction: float) -> float:
        """Angle of the driven gear whose teeth stand midway between those of the driver at `driver_angle`, in rad.

        Both angles are those of a tooth's middle, and `direction` that from the driver's axis to the driven gear's.
        The phases of both in pitches, counted from the line of centres, add up to half a pitch.

        Args:
            driver_angle: angle of the driver, rad.
            direction: direction from the driver's axis to the driven gear's, rad.
        """
        driver_teeth, driven_teeth = self.driver.form.teeth, self.driven.form.teeth
        phase = driver_teeth * (driver_angle - direction)
        return (direction + pi + (pi - phase) / driven_teeth) % (2 * pi)

    def meshes(self, engage: Engage) -> bool:
        """Whether the teeth, as cut, have one play all the time."""
        return spur_checks.meshes(self, engage)

    def checks(self, engage: Engage) -> tuple[Check, ...]:
        """The teeth in mesh, as cut over a whole pitch, and at the limits of the tolerances."""
        return spur_checks.pair_checks(self, engage)

    def notes(self, number: int) -> tuple[str, ...]:
        """Which gears are undercut as they are cut, and how far."""
        return tuple(
            f"the {role} of stage {number}, of {gear.form.teeth} teeth, is undercut: as cut it has the profile"
            f" shift {gear.form.generating_profile_shift:.2f}, {missing:.2f} modules less than would leave its"
            " flanks whole"
            for role, gear in (("driver", self.driver), ("driven gear", self.driven))
            if (missing := missing_shift(gear.form)) > 0
        )

    def facts(self) -> dict[str, Any]:
        """Every value of eq. 1-13, the exact plays beside them, and how the play is distributed."""
        return spur_facts.pair_facts(self)

    def wheel_facts(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Form, thickness limits, span and size over pins of both gears; a `DesignError` for pins that do not rest."""
        play, inspections = self.play(), _inspections(self)
        driver, driven = self.wheels
        return (
            spur_facts.gear_facts(driver, play.driver, inspections[0]),
            spur_facts.gear_facts(driven, play.driven, inspections[1]),
        )


@lru_cache(maxsize=64)  # of the stages of a train, which is inspected and then written
def _inspections(pair: GearPair) -> tuple[Inspection, Inspection]:
    """Of both gears, as cut, between E_sns and E_sni."""
    play = pair.play()
    driver, driven = (
        inspection_of(gear.form, limits.E_sns, limits.E_sni, gear.pin_diameter)
        for gear, limits in ((pair.driver, play.driver), (pair.driven, play.driven))
    )
    return driver, driven


def spur_pairs(train: Train, what: str, cure: str = TEETH) -> tuple[GearPair, ...]:
    """The stages of a train as spur gears.

    Args:
        train: of any kinds.
        what: what is worked out for spur gears alone, with its verb: `the search is`.
        cure: what to do about another kind.

    Raises:
        DesignError: a stage is of another kind.
    """
    for number, stage in enumerate(train.stages, 1):
        if not isinstance(stage, GearPair):
            raise DesignError(
                f"train.stages.{number}.kind names {stage.noun}, and {what} worked out for spur gears alone: {cure}"
            )
    return tuple(stage for stage in train.stages if isinstance(stage, GearPair))
