"""From the play that a train has to the play that its design has: thinner or thicker teeth, or another centre distance.

Play of the last pair counts most at the output, so that the least change is made there. A change Δ of the play at
the output, rad, is an arc of Δ i r_w2 on the pair's working pitch circles. There i is the turns of the driven wheel for
one of the output. Thickness and centre distance follow from the exact play of the pair. The new wheel must be one that
can be cut, keeps clear of the other's roots, and has play left at the least by the tolerances.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import degrees
from pathlib import Path
from typing import Any

from scipy.optimize import brentq

from cadgen.design import gear_model
from cadgen.design.load import train_of
from cadgen.design.override import override
from cadgen.design.schema import TrainDesign
from cadgen.errors import DesignError
from cadgen.gears.spur import SpurPair, has_room, limit_states, roots_clear
from cadgen.gears.train import Train, thinned
from cadgen.messages import Message

_FARTHEST = 1.0  # modules by which the axes may be moved
_WIDEST = 2.0  # modules by which no thickness changes: that is more than a whole tooth
_REACHED = 1e-3  # mm


@dataclass(frozen=True, kw_only=True)
class WantedPlay:
    """Change of one pair, with which a train has the play of its design. Lengths mm, angles rad.

    Attributes:
        stage: number of the pair, from 1.
        found, wanted: play at the output.
        thinning: change of the thickness E_sn, of the driven wheel alone or of both together.
        driven: thickness deviation E_sn of the driven wheel to cut anew.
        driver: that of the driver, which stays.
        distance: centre distance that does the same; None where none near the present one does.
        now: present centre distance.
        reach: least and greatest E_sn of a driven wheel that can be cut and runs, if the wanted one is not among them.
        reached: plays at the output with those.
    """

    stage: int
    found: float
    wanted: float
    thinning: float
    driven: float
    driver: float
    distance: float | None
    now: float
    reach: tuple[float, float] | None = None
    reached: tuple[float, float] | None = None

    @property
    def recut(self) -> bool:
        """Whether the wheel that is there can be cut thinner, so that no new one is needed."""
        return self.thinning < 0


def play_as_made(train: Train) -> float:
    """Free angle of the output of a train as it is made, rad.

    Args:
        train: train, nominal.
    """
    made = thinned(train)
    return sum(s.free_angle() / float(turns) for s, turns in zip(made.stages, made.output_ratios, strict=True))


def wanted_play(train: Train, found: float) -> WantedPlay | None:
    """Change of the last pair of gears, with which a train has the play of its design; None without a pair.

    Args:
        train: train, nominal.
        found: play at the output that was measured, rad.
    """
    made = thinned(train)
    pairs = [
        (number, stage, turns)
        for number, (stage, turns) in enumerate(zip(made.stages, made.output_ratios, strict=True), 1)
        if isinstance(stage, SpurPair)
    ]
    if not pairs:
        return None
    number, pair, turns = pairs[-1]
    wanted = play_as_made(train)
    arc = (wanted - found) * float(turns) * pair.driven_pitch_radius
    change = pair.thinning_for(arc) - pair.thinning_for(0.0)
    play = pair.backlash()
    base = arc * (play.base / play.pitch if play.pitch else 1.0)  # along the line of action
    driver, driven = (gear.form.tooth_thickness_deviation for gear in (pair.driver, pair.driven))
    stage = train.stages[number - 1]
    assert isinstance(stage, SpurPair)
    reach = None if _runs(stage, driver, driven + change) else _reach(stage, driver, driven)
    return WantedPlay(
        stage=number,
        found=found,
        wanted=wanted,
        thinning=change,
        driven=driven + change,
        driver=driver,
        distance=_distance(pair, base),
        now=pair.centre_distance,
        reach=reach,
        reached=None
        if reach is None
        else (
            found + (reach[1] - driven) / change * (wanted - found),
            found + (reach[0] - driven) / change * (wanted - found),
        ),
    )


def _runs(pair: SpurPair, driver: float, driven: float) -> bool:
    """Whether a pair with given thicknesses E_sn, mm, can be cut, has room at its roots, and play at the least."""
    try:
        cut = pair.thinned_to(driver, driven).as_cut()
        return bool(has_room(cut) and limit_states(cut)[1].play() > 0)
    except DesignError:
        return False


def _reach(pair: SpurPair, driver: float, driven: float) -> tuple[float, float]:
    """Least and greatest thickness E_sn of a driven wheel about the present one with which the pair runs, mm."""
    ends = []
    for sense in (-1.0, 1.0):
        runs, fails = 0.0, _WIDEST * pair.driver.form.normal_module
        while fails - runs > _REACHED:
            middle = (runs + fails) / 2
            runs, fails = (middle, fails) if _runs(pair, driver, driven + sense * middle) else (runs, middle)
        ends.append(driven + sense * runs)
    return ends[0], ends[1]


def _distance(pair: SpurPair, more: float) -> float | None:
    """Centre distance at which the play along the line of action is greater by as much, mm; None if none is near."""
    sides = sum(gear.form.tooth_thickness_deviation for gear in (pair.driver, pair.driven))
    wanted = pair.base_backlash(pair.centre_distance, sides) + more
    room = _FARTHEST * pair.driver.form.normal_module

    def off(apart: float) -> float:
        return pair.base_backlash(apart, sides) - wanted

    low, high = pair.centre_distance - room, pair.centre_distance + room
    try:
        apart = float(brentq(off, low, high, xtol=1e-9)) if off(low) * off(high) < 0 else None
    except DesignError:
        return None
    return apart if apart is not None and roots_clear(pair, apart) else None


def corrected_text(design: TrainDesign, text: str, change: WantedPlay, remarks: Sequence[str]) -> str:
    """Text of the design with the driven wheel of the changed pair cut to its new thickness.

    Args:
        design: design that was measured.
        text: text of its file.
        change: change of a pair.
        remarks: comment lines at the head.

    Raises:
        DesignError: the wheel cannot be cut so.
    """
    import tomlkit

    values: Any = tomlkit.parse(text)
    for line in design.overrides:
        override(values, line)
    name = f"{design.name}_corrected"
    if "name" in values:
        values["name"] = name
    stage = values["train"]["stages"][change.stage - 1]
    for key in ("backlash_um", "backlash_deg", "backlash_share"):
        stage.pop(key, None)
    for key, thickness in (("driver", change.driver), ("driven", change.driven)):
        for old in ("E_sns_um", "T_sn_um"):
            stage[key].pop(old, None)
        stage[key]["E_sn_um"] = round(1e3 * thickness, 2)
    made = str(values.as_string())
    if "name" not in values:
        made = f'name = "{name}"\n{made}'
    made = "".join(f"# {line}\n" for line in remarks) + made
    play_as_made(gear_model.train(train_of(made, Path(f"{name}.toml"))))
    return made


def turns_of(train: Train) -> tuple[Fraction, ...]:
    """Turns of each shaft for one of the output, from the input on."""
    return (train.ratio, *train.output_ratios)


def play_words(change: WantedPlay, sigma: float) -> list[Message]:
    """Sentences on what to change.

    Args:
        change: change of a pair.
        sigma: standard deviation of the play found, rad.
    """
    said = [
        Message(
            "No thickness of the driven wheel of stage {stage} gives the {wanted:.4f}° of play that the design has "
            "instead of {found:.4f}° ± {sigma:.4f}°: one that can be cut and runs has E_sn from {least:.0f} to "
            "{most:.0f} µm, and leaves {low:.3f}° to {high:.3f}°; look for what else is loose or tight.",
            stage=change.stage,
            wanted=degrees(change.wanted),
            found=degrees(change.found),
            sigma=degrees(sigma),
            least=1e3 * change.reach[0],
            most=1e3 * change.reach[1],
            low=degrees(change.reached[0]),
            high=degrees(change.reached[1]),
        )
        if change.reach is not None and change.reached is not None
        else Message(
            "For the {wanted:.4f}° of play that the design has instead of {found:.4f}° ± {sigma:.4f}°, cut the driven "
            "wheel of stage {stage} to E_sn = {driven:.0f} µm, {change:.0f} µm {how}.",
            wanted=degrees(change.wanted),
            found=degrees(change.found),
            sigma=degrees(sigma),
            stage=change.stage,
            driven=1e3 * change.driven,
            change=abs(1e3 * change.thinning),
            how=Message("thinner: the wheel that is there can be cut again")
            if change.recut
            else Message("thicker: it takes a new wheel"),
        )
    ]
    if change.distance is not None:
        said.append(
            Message(
                "Or set the axes of stage {stage} {distance:.3f} mm apart in place of {now:.3f} mm.",
                stage=change.stage,
                distance=change.distance,
                now=change.now,
            )
        )
    return said
