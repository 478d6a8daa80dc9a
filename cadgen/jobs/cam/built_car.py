"""Deviations of the car as it was built, in words."""

from math import degrees, radians

from cadgen.arrays import TURN
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import cam_model, gear_model, variation
from cadgen.design.as_built import EffectSection
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.deviations.deviation import Place
from cadgen.messages import Message

_SIGNS = {"deg": "°", "um": " µm", "%": " %", "mm": " mm", "s": " s", "": ""}
_OTHER_PLACES = Message(
    "What the new cam is expected to do is not known: [as_built.outlook] is of other places than the effects have now. "
    "Calibrate again, or give the effects those places."
)
_LEAST_SHIFT = radians(0.005)  # of the run's end: less than a hundredth of a degree is not worth a sentence


def as_built_sentences(design: Design, stop: float) -> list[str]:
    """Effects that count, effects that are only noted, and what to do for them, in words.

    Args:
        design: loaded design.
        stop: motor position at which the run ends, rad.
    """
    record = design.as_built
    if record is None:
        return []
    used, noted = (
        [effect for effect in record.effects if (effect.place == Place.NOTED) is aside] for aside in (False, True)
    )
    lines: list[str] = [
        Message("As built: {effects}.", effects=_listed_effects(used))
        if used
        else Message("As built: nothing that a cam or a run depends on.")
    ]
    if noted:
        lines.append(Message("Only noted: {effects}.", effects=_listed_effects(noted)))
    return [*lines, *_lead_sentences(design), *_friction_sentences(design), *setting_sentences(design, stop)]


def setting_sentences(design: Design, stop: float) -> list[str]:
    """Instructions for a car as built: where to stop the run, and how to set the cam on its shaft.

    Args:
        design: loaded design.
        stop: motor position at which the run ends, rad.
    """
    lines: list[str] = []
    if abs(stop - stop_as_designed(design)) > _LEAST_SHIFT:
        turns: str = ""
        if design.train is not None:
            turned = stop / TURN * float(gear_model.train(design).ratio)
            turns = Message(" ({turns:.3f} turns of the wheel)", turns=turned)
        lines.append(
            Message(
                "The path ends at {stop:.2f}° of cam angle{turns}, not at {designed:.2f}°: stop the run there.",
                stop=degrees(stop),
                turns=turns,
                designed=degrees(stop_as_designed(design)),
            )
        )
    phase = cam_model.as_built(design).phase
    if phase != 0 and cam_model.has_key(design):
        lines.append(
            Message(
                "The key of the new cam is turned by {turned:.3f}°, which takes out the cam's phase.",
                turned=-degrees(phase),
            )
        )
    elif phase != 0:
        lines.append(
            Message(
                "Set the new cam on its shaft {turned:.3f}° {way} its sense of turning from where the measured one "
                "stood: without a keyway or D-flat nothing does it for you.",
                turned=abs(degrees(phase)),
                way=Message("back against") if phase > 0 else Message("ahead in"),
            )
        )
    return lines


def outlook_sentence(design: Design) -> str:
    """Expected run of the car on the new cam; empty if no measurement predicts it."""
    outlook = design.as_built and design.as_built.expected
    if not outlook:
        return _OTHER_PLACES if design.as_built and design.as_built.outlook else ""
    return Message(
        "The new cam is expected to end the run {new:.1f} mm off ({least:.1f} to {most:.1f} mm in 90 %), the old one "
        "{old:.1f} mm; {worse}.",
        new=outlook.new_mm,
        least=outlook.least_mm,
        most=outlook.most_mm,
        old=outlook.old_mm,
        worse=chance_to_be_worse(outlook.chance_worse, explained=outlook.explained),
    )


def chance_to_be_worse(chance: float, *, explained: bool | None) -> Message:
    """Chance that a new cam ends the run farther off than the old one, in words.

    Args:
        chance: share of the cars drawn, 0 to 1.
        explained: whether what was found explains the measured runs.
    """
    from cadgen.inference.expectation.outlook import LEAST_CHANCE

    if explained is False:
        return Message("how likely it is to be worse is not known, since not all is explained")
    if chance < LEAST_CHANCE:
        return Message("it is worse with a chance of less than 1 %")
    return Message("it is worse with a chance of {chance:.0%}", chance=chance)


def outlook_checks(design: Design) -> tuple[Check, ...]:
    """Whether a new cam is worth its cutting, by what was measured of the car: nothing without [as_built.outlook].

    The chance to be worse of other places than the effects have is no figure of this cam; it stands if it refuses one,
    for by a change of places nothing was found that speaks for a cam.
    """
    known = design.as_built and design.as_built.expected
    outlook = known or (design.as_built and design.as_built.outlook)
    doubts = _doubts_of_cam(design)
    if not outlook:
        return doubts
    # Only here: it needs the models of all kinds of data, and most designs have no outlook.
    from cadgen.inference.expectation.outlook import WORSE

    remedy = Message("measure what cadgen calibrate asks for, and calibrate again")
    checks = []
    if known or outlook.chance_worse > WORSE:
        checks.append(
            Check(
                CheckCode.CHANCE_WORSE,
                Message("chance to be worse than the old cam"),
                100 * outlook.chance_worse,
                "%",
                100 * WORSE,
                Bound.MAX,
                Message("end of the run") if known else Message("with the places as calibrated"),
                remedy,
            )
        )
    if outlook.explained is not None:
        checks.append(
            Check(
                CheckCode.RUNS_EXPLAINED,
                Message("measured runs explained"),
                float(outlook.explained),
                "",
                1.0,
                Bound.MIN,
                Message("1: yes, 0: no"),
                remedy,
            )
        )
    return (*doubts, *checks)


def _doubts_of_cam(design: Design) -> tuple[Check, ...]:
    """Check that fails where what was measured fits another cam than the stated one; nothing where none does."""
    known = design.as_built
    if known is None or known.other_cam is None:
        return ()
    return (
        Check(
            CheckCode.MEASURED_CAM,
            Message("cams that were on the measured car, by what was measured"),
            2.0,
            "",
            1.0,
            Bound.MAX,
            Message("{profile} or {other}", profile=known.profile, other=known.other_cam),
            Message("look which cam was on the car; if it is an earlier one, calibrate the design that it was cut from")
            if known.other_cam_earlier
            else Message("look which cam was on the car, and calibrate again with its --profile"),
        ),
    )


def _lead_sentences(design: Design) -> list[str]:
    """How to keep what the cam takes out of the train at its place, in words."""
    if not any(placed.leads for placed in cam_model.as_built(design).effects):
        return []
    return [
        Message(
            "The cam takes out what its shaft leads or lags the gears by at each turn: mark every wheel, its shaft and "
            "the teeth in mesh before you take the train apart, and put them together as they were measured."
        )
    ]


def _friction_sentences(design: Design) -> list[str]:
    """Conditions under which a track showed play or none, in words."""
    known = cam_model.as_built(design)
    if known.play == 0 and known.shows_play_with_rod and known.friction is None:
        return [
            Message(
                "The car showed no play with the rod on: its gears have none, or friction or drag holds the cam, and "
                "then oil or shaking sets it free: measure the play with the rod lifted."
            )
        ]
    if known.runs_free and known.play:
        instead = "" if design.mechanics is None else Message(" instead of the friction of [mechanics]")
        return [
            Message(
                "The return error was found on a track as if the rod slid without friction, and is used so{instead}: "
                "calibrate that track again to look for friction too; a play measured with the rod lifted belongs in "
                "play.measured_deg.",
                instead=instead,
            )
        ]
    if known.friction is not None and known.friction[0] > 0:
        return [
            Message(
                "Friction was measured on this car as it was then: oil, wear or shaking change it, and with it where "
                "the cam leads its gears."
            )
        ]
    return []


def assumed_play(design: Design) -> list[str]:
    """A warning where a car was measured but not its play, and a run or a profile goes by the tabled one."""
    tabled = variation.tabled_play(design)
    if design.as_built is None or tabled is None or variation.measured_play(design) is not None:
        return []
    lowest = variation.play_bands(design)[design.optimize.order].least
    return [
        Message(
            "Warning: play was not measured on this car, so the tabled return error is assumed, {least:.3f} to "
            "{most:.3f}°: calibrate with a track, a transmission or zones, or set play.measured_deg.",
            least=degrees(lowest),
            most=degrees(tabled),
        )
    ]


def stop_as_designed(design: Design) -> float:
    """Cam angle at which the path of the car as designed ends, rad."""
    return cam_model.turn_to_finish(design, cam_model.track(design))


def _listed_effects(effects: list[EffectSection]) -> str:
    named = []
    for effect in effects:
        units = {parameter.name: parameter.unit for parameter in effect.known().parameters}
        values = [
            f"{value.value:.4g}{_SIGNS[units.get(value.name, '')]}"
            + (f" ± {value.sigma:.2g}" if value.sigma is not None else "")
            for value in effect.values
        ]
        named.append(
            Message(
                "{effect} {values} ({place}, from {kind})",
                effect=Message(effect.effect),
                values=", ".join(values),
                place=Message(effect.place),
                kind=Message(effect.kind),
            )
        )
    return listed(named, "and")
