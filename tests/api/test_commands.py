"""The commands and the Python face can do the same: every option is an argument, with the same default."""

import inspect
from collections.abc import Callable
from typing import Any

import click
import pytest

import cadgen
from cadgen import Cam, Design, Editor, Gear, GearPair, GearTrain, Planetary, Report, draw, explore, merge, verify
from cadgen.api.assembly import AssembledCar, FramedCar
from cadgen.api.calibration import Calibration
from cadgen.cli import cli

Functions = tuple[Callable[..., Any], ...]
# Functions of the face that a command calls.
FACE: dict[str, Functions] = {
    "adjust": (Design.load, Design.adjust),
    "assembly": (Design.load, Design.assembly, AssembledCar.write),
    "calibrate": (Design.load, Design.calibrate, Design.calibrate_each, Design.next_measurement, Calibration.predict),
    "cam": (Design.load, Design.cam, Cam.write),
    "card": (Design.load, Design.card),
    "check": (Design.load, Design.cam),
    "draw": (Design.load, Design.cam, Design.gears, draw),
    "edit": (Editor.open, Editor.serve),
    "explore": (explore,),
    "frame": (Design.load, Design.frame, FramedCar.write),
    "gear": (Gear, Gear.write),
    "gears": (Design.load, Design.gears, GearTrain.write),
    "merge": (merge,),
    "new": (Design.new,),
    "optimize": (Design.load, Design.optimize),
    "pair": (Gear, GearPair, GearPair.propose_shifts, GearPair.write),
    "planetary": (Gear, Planetary, Planetary.write),
    "plan": (Design.load, Design.plan),
    "report": (Design.load, Report.of),
    "simulate": (Design.load, Design.simulate),
    "tolerance": (Design.load, Design.tolerance),
    "verify": (verify,),
}
# Options that are called otherwise on the face: what is printed is `facts`, what is written is `write`.
CALLED = {
    "overrides": "changes",
    "design": "source",
    "no_browser": "browser",
    "course": "source",
    "train_alone": "train_only",
    "E_sn_um": "thickness_deviation",
    "backlash_um": "backlash",
    "backlash_deg": "backlash",
    "centre_distance_mm": "centre_distance",
    "bearing_span_mm": "bearing_span",
    "unequal": "equal",
    "standard": "centre_distance_deviation",
    "flats": "keyway",
    "across": "keyway",
}
BY_METHODS = {
    "lang": "messages.choose",
    "as_json": "facts",
    "every": "figures",
    "out": "write",
    "each": "calibrate_each",
    "ask_next": "next_measurement",
    "unseen": "predict",
    "only": "cam and train of `draw`",
    "arguments": "source and data",
    "toml": "the design file of a pair",
    "file": "flags",
    "propose_shifts": "propose_shifts",
}
# Commands use two processes; a script says how many it wants, or gives a pool.
# What is given for no gear has the default of each.
OTHER_DEFAULTS = {"processes", "no_browser", "jobs", "grade", "pressure_angle", "unequal", "standard"}


def commands() -> dict[str, click.Command]:
    # A word is explained to a person alone: a program has the docstrings.
    return {name: command for name, command in cli.commands.items() if name != "explain"}


def arguments(functions: Functions) -> dict[str, inspect.Parameter]:
    return {name: each for function in functions for name, each in inspect.signature(function).parameters.items()}


def default_of(option: click.Parameter, command: click.Command) -> Any:
    """Default of an option; None if it has none, or is a flag that is not set."""
    given = option.get_default(click.Context(command))
    return given if isinstance(given, str | int | float | tuple) and given else None


def test_every_command_is_on_the_face():
    assert set(commands()) == set(FACE)
    for functions in FACE.values():
        for function in functions:
            names = [
                name
                for name in cadgen.__all__
                if name == function.__name__ or hasattr(getattr(cadgen, name), function.__name__)
            ]
            assert names, function


@pytest.mark.parametrize("name", FACE)
def test_every_option_is_an_argument_with_the_same_default(name):
    known, compared = arguments(FACE[name]), 0
    for option in commands()[name].params:
        if option.name in BY_METHODS:
            continue
        called = CALLED.get(option.name, option.name)
        # A plan takes a pool, as `map`, where the command has a number of processes.
        argument = known["map"] if (name, called) == ("plan", "processes") else known[called]
        if option.name in OTHER_DEFAULTS or argument.default is inspect.Parameter.empty or callable(option.default):
            continue
        given, wanted = default_of(option, commands()[name]), argument.default or None
        if isinstance(given, str) and isinstance(wanted, tuple):
            given = tuple(given.split(","))
        assert given == wanted, f"{option.name}: {given!r} on the command line, {wanted!r} on the face"
        compared += 1
    print(f"{name}: {compared} defaults compared")
