"""Drawings for a workshop: of a cam, of a gear train, of the plate for its axes."""

from os import PathLike
from typing import TYPE_CHECKING

from cadgen.api.values import instance
from cadgen.errors import CheckError, DesignError
from cadgen.output.files.publisher import Written, folder_of, refusal
from cadgen.progress import Progress, silent

if TYPE_CHECKING:
    from cadgen.api.cam import Cam
    from cadgen.jobs.drawings import Parts
    from cadgen.jobs.gears.gear_train import GearTrain


def draw(
    folder: str | PathLike[str],
    *,
    cam: "Cam | None" = None,
    train: "GearTrain | None" = None,
    force: bool = False,
    progress: Progress = silent,
) -> Written:
    """Draw a cam, a gear train, or both, as DXF and PDF; read all back, and publish all together or none.

    A drawing names the files of the same part in the folder by their hashes: write solids and programs first. The
    outline is written as DXF with it, that of a cam where none lies there.

    Args:
        folder: folder for the files; it is made if need be.
        cam: cam to draw, with a form for its inspection, which `Design.calibrate` reads once it is filled in.
        train: train to draw: every part, the outline of every gear as DXF, and the plate that holds the axes.
        force: whether drawings are made even if a check fails.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: there is neither a cam nor a train, or they are of two designs.
        CheckError: a check of the cam or of the train fails.
        FileError: a file cannot be written, or holds something else when it is read back.

    Example:
        >>> from cadgen import Design, draw
        >>> design = Design.load("carbon_free_car")
        >>> draw("exports", cam=design.cam(), train=design.gears())  # doctest: +SKIP
    """
    from cadgen.api.cam import Cam
    from cadgen.jobs.drawings import write_drawings
    from cadgen.jobs.gears.gear_train import GearTrain

    place = folder_of(folder)
    if cam is not None:
        instance("cam", cam, Cam)
    if train is not None:
        instance("train", train, GearTrain)
    parts = parts_of(cam, train)
    if cam is not None and train is not None and train.origin.content_hash != parts.design_hash:
        raise DesignError("cam and train are of two designs: take both from the same Design")
    failed = [check for part in (cam, train) if part is not None for check in part.checks if not check.passed]
    if failed and not force:
        raise CheckError(refusal(failed))
    return write_drawings(parts, place, progress)


def parts_of(cam: "Cam | None", train: "GearTrain | None") -> "Parts":
    """Parts of one design that are drawn together.

    Args:
        cam: cam; None for the train alone.
        train: train; None for the cam alone.

    Raises:
        DesignError: there is neither.
    """
    from cadgen.jobs.drawings import Parts

    if cam is not None:
        origin = cam.computed.origin
    elif train is not None:
        origin = train.origin
    else:
        raise DesignError("there is nothing to draw: give cam, train, or both")
    return Parts(origin.name, origin.content_hash, None if cam is None else cam.computed, train)
