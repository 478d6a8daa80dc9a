"""What a design says of the car as it was built, in words and as plain values."""

from math import degrees, radians
from typing import Any

from cadgen.arrays import TURN
from cadgen.build import cam_model, gear_model, variation
from cadgen.design.as_built import Effect
from cadgen.design.schema import Design
from cadgen.design.section import listed

_SIGNS = {"deg": "°", "um": " µm", "%": " %", "mm": " mm", "s": " s", "": ""}
_LEAST_SHIFT = radians(0.005)  # of the run's end: what is less than a hundredth of a degree is not told


def as_built_facts(design: Design, stop: float) -> dict[str, Any] | None:
    """What was taken into account and what was only noted; None for a car as designed.

    Args:
        design: a loaded design.
        stop: cam angle at which the path ends, rad.
    """
    given = design.as_built
    if given is None:
        return None
    known = cam_model.as_built(design)
    phase = known.phase
    return {
        "measured_with": given.profile,
        "sources": [source.model_dump(mode="json") for source in given.sources],
        "effects": [one.model_dump(mode="json", exclude_none=True) for one in given.effects if one.place != "noted"],
        "noted": [one.model_dump(mode="json", exclude_none=True) for one in given.effects if one.place == "noted"],
        "stop": {
            "cam_angle_deg": degrees(stop),
            "as_designed_deg": degrees(_stop_as_designed(design)),
            "wheel_turns": None if design.train is None else stop / TURN * float(gear_model.train(design).ratio),
        },
        "play_measured": variation.measured_play(design) is not None,
        "friction_measured": None if known.friction is None else known.friction[0],
        "play_found_without_friction": known.runs_free,
        "phase_deg": degrees(phase),
        "key_turned_deg": -degrees(phase) if cam_model.has_key(design) else None,
    }


def as_built_sentences(design: Design, stop: float) -> list[str]:
    """What is taken into account, what is only noted, where to stop the run, and how to set the cam."""
    given = design.as_built
    if given is None:
        return []
    used, noted = ([one for one in given.effects if (one.place == "noted") is aside] for aside in (False, True))
    lines = [f"As built: {_told(used)}." if used else "As built: nothing that a cam or a run depends on."]
    if noted:
        lines.append(f"Only noted: {_told(noted)}.")
    lines += _friction_sentences(design)
    if abs(stop - _stop_as_designed(design)) > _LEAST_SHIFT:
        turns = ""
        if design.train is not None:
            turns = f" ({stop / TURN * float(gear_model.train(design).ratio):.3f} turns of the wheel)"
        lines.append(
            f"The path ends at {degrees(stop):.2f}° of cam angle{turns}, not at "
            f"{degrees(_stop_as_designed(design)):.2f}°: stop the run there."
        )
    phase = cam_model.as_built(design).phase
    if phase != 0 and cam_model.has_key(design):
        lines.append(f"The key of the new cam is turned by {-degrees(phase):.3f}°, which takes out the cam's phase.")
    elif phase != 0:
        way = "back against" if phase > 0 else "ahead in"
        lines.append(
            f"Set the new cam on its shaft {abs(degrees(phase)):.3f}° {way} its sense of turning from where the "
            "measured one stood: without a keyway or D-flat nothing does it for you."
        )
    return lines


def _friction_sentences(design: Design) -> list[str]:
    """What the play goes by that a track showed, and that a car without play may be held."""
    known = cam_model.as_built(design)
    if known.play == 0 and known.shows_play_with_rod and known.friction is None:
        return [
            "The car showed no play with the rod on: its gears have none, or friction or drag holds the cam, and then "
            "oil or shaking sets it free: measure the play with the rod lifted."
        ]
    if known.runs_free and known.play:
        instead = " instead of the friction of [mechanics]" if design.mechanics is not None else ""
        return [
            f"The return error was found on a track as if the rod slid without friction, and is used so{instead}: "
            "calibrate that track again to look for friction too; a play measured with the rod lifted belongs in "
            "play.measured_deg."
        ]
    if known.friction is not None and known.friction[0] > 0:
        return [
            "Friction was measured on this car as it was then: oil, wear or shaking change it, and with it where the "
            "cam leads its gears."
        ]
    return []


def assumed_play(design: Design) -> list[str]:
    """A warning where a car was measured but not its play, and a run or a profile goes by the tabled one."""
    tabled = variation.tabled_play(design)
    if design.as_built is None or tabled is None or variation.measured_play(design) is not None:
        return []
    least = variation.play_bands(design)[design.optimize.order].least
    return [
        "Warning: play was not measured on this car, so the tabled return error is assumed, "
        f"{degrees(least):.3f} to {degrees(tabled):.3f}°: calibrate with a track, a transmission or zones, or set "
        "play.measured_deg."
    ]


def _stop_as_designed(design: Design) -> float:
    return TURN - radians(design.cam.blend_deg)


def _told(effects: list[Effect]) -> str:
    return listed([f"{one.effect} {_values(one)} ({one.place}, from {one.kind})" for one in effects], "and")


def _values(one: Effect) -> str:
    units = {p.name: p.unit for p in one.known().parameters}
    return ", ".join(
        f"{value.value:.4g}{_SIGNS[units.get(value.name, '')]}"
        + (f" ± {value.sigma:.2g}" if value.sigma is not None else "")
        for value in one.values
    )
