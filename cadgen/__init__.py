"""Cams and gears: from a motion, a course or numbers of teeth to files that are read back and proven.

    >>> from cadgen import Design
    >>> cam = Design.load("carbon_free_car").cam(profile="actual")
    >>> files = cam.write("exports", formats=["step", "dxf"])  # doctest: +SKIP

The rooms, in walking order; each imports only those before it.

| room         | what happens there                                                            |
|--------------|-------------------------------------------------------------------------------|
| `messages`   | texts for people, which can be said in other languages                        |
| `errors`     | errors for the user, with the exit codes                                      |
| `version`    | the version, in its one place                                                 |
| `arrays`     | an array of floats, a turn                                                    |
| `registry`   | kinds of one sort by their codes                                              |
| `figures`    | figures and sheets of them, for terminal, page, files and JSON alike          |
| `check`      | figures with limits and verdicts                                              |
| `verdict`    | ready, ready with reservations, or not ready                                  |
| `reading`    | files that a user names, refused by kind and size                             |
| `writing`    | files that a user names, written whole or not at all                          |
| `progress`   | the callback by which a job reports its progress                              |
| `processes`  | a part of a job beside the rest, or many items, in other processes            |
| `glossary`   | words of the field, in English and Chinese                                    |
| `curves`     | closed plane curves: arcs, splines, chords and offsets within a tolerance     |
| `laws`       | motions: what a follower has to do in one turn of a cam                       |
| `parts`      | features of a part: bore, keyway, hub, web, holes; a body of prisms           |
| `cam`        | lift, theoretical and actual profile, contact, checks                         |
| `gears`      | tolerances, backlash, return error, order of stages, tooth form, layout       |
| `car`        | the car that a steering cam drives: path, course, steering, its run with play |
| `deviations` | deviations of a real car from its design, and their effects                   |
| `inference`  | measured data -> the effects that explain them, and what they promise         |
| `design`     | the design file: TOML -> frozen values -> the numeric rooms' own types        |
| `geometry`   | parts as meshes and as solids of the CAD kernel                               |
| `output`     | files with their read-back, drawings, pictures, terminal tables               |
| `jobs`       | one job from design to verified files                                         |
| `studies`    | studies of many designs: plans, search, figures, journal, engines             |
| `viewer`     | the report page, and the editor that serves it                                |
| `api`        | the Python face: designs, cams, gears, runs, calibrations as objects          |
| `cli`        | the commands                                                                  |

Inside, lengths are mm and angles rad; other units occur only at the rim and then stand in the name.
"""

from cadgen.version import __version__

# Where each public name lives. It is imported when it is first asked for: `import cadgen` alone costs next to nothing.
_HOMES = {
    "Adjustment": "api.adjustment",
    "CadgenError": "errors",
    "Calibration": "api.calibration",
    "Cam": "api.cam",
    "CheckError": "errors",
    "Card": "jobs.card",
    "Comparison": "api.comparison",
    "Design": "api.design",
    "DesignError": "errors",
    "Editor": "api.views",
    "FileError": "errors",
    "Flat": "api.motion_cam",
    "Exploration": "api.exploration",
    "Gear": "api.gears",
    "GearPair": "api.gears",
    "GearTrain": "jobs.gears.gear_train",
    "Hub": "parts.features",
    "DFlat": "parts.features",
    "Flats": "parts.features",
    "PrintCompensation": "parts.print_compensation",
    "Keyway": "parts.features",
    "KnifeEdge": "api.motion_cam",
    "Lightening": "parts.features",
    "Measured": "api.measured",
    "Motion": "api.motion_cam",
    "Plan": "api.planning",
    "Planetary": "api.planetary",
    "Rack": "api.rack",
    "Report": "api.views",
    "Roller": "api.motion_cam",
    "SetScrew": "parts.features",
    "Simulation": "jobs.simulation",
    "Spring": "api.motion_cam",
    "SwingingFlat": "api.motion_cam",
    "SwingingRoller": "api.motion_cam",
    "ToleranceRun": "jobs.tolerance",
    "Train": "api.gears",
    "Web": "parts.features",
    "Written": "output.files.publisher",
    "WrittenFile": "output.files.publisher",
    "draw": "api.drawing",
    "dwell": "api.motion_cam",
    "explore": "api.exploration",
    "merge": "api.exploration",
    "rise": "api.motion_cam",
    "verify": "output.files.publisher",
}

# As `typing.TYPE_CHECKING`, without the time that importing it takes.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from cadgen.api.adjustment import Adjustment
    from cadgen.api.calibration import Calibration
    from cadgen.api.cam import Cam
    from cadgen.api.comparison import Comparison
    from cadgen.api.design import Design
    from cadgen.api.drawing import draw
    from cadgen.api.exploration import Exploration, explore, merge
    from cadgen.api.gears import Gear, GearPair, Train
    from cadgen.api.measured import Measured
    from cadgen.api.motion_cam import (
        Flat,
        KnifeEdge,
        Motion,
        Roller,
        Spring,
        SwingingFlat,
        SwingingRoller,
        dwell,
        rise,
    )
    from cadgen.api.planetary import Planetary
    from cadgen.api.planning import Plan
    from cadgen.api.rack import Rack
    from cadgen.api.views import Editor, Report
    from cadgen.errors import CadgenError, CheckError, DesignError, FileError
    from cadgen.jobs.card import Card
    from cadgen.jobs.gears.gear_train import GearTrain
    from cadgen.jobs.simulation import Simulation
    from cadgen.jobs.tolerance import ToleranceRun
    from cadgen.output.files.publisher import Written, WrittenFile, verify
    from cadgen.parts.features import DFlat, Flats, Hub, Keyway, Lightening, SetScrew, Web
    from cadgen.parts.print_compensation import PrintCompensation

__all__ = [
    "Adjustment",
    "CadgenError",
    "Calibration",
    "Cam",
    "Card",
    "CheckError",
    "Comparison",
    "DFlat",
    "Design",
    "DesignError",
    "Editor",
    "Exploration",
    "FileError",
    "Flat",
    "Flats",
    "Gear",
    "GearPair",
    "GearTrain",
    "Hub",
    "Keyway",
    "KnifeEdge",
    "Lightening",
    "Measured",
    "Motion",
    "Plan",
    "Planetary",
    "PrintCompensation",
    "Rack",
    "Report",
    "Roller",
    "SetScrew",
    "Simulation",
    "Spring",
    "SwingingFlat",
    "SwingingRoller",
    "ToleranceRun",
    "Train",
    "Web",
    "Written",
    "WrittenFile",
    "__version__",
    "draw",
    "dwell",
    "explore",
    "merge",
    "rise",
    "verify",
]


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for (PEP 562)."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    value: object = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Everything, the names not yet imported among it."""
    return sorted({*globals(), *__all__})
