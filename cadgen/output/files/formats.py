"""Formats of files: one file of this room and one line of the table each, for cams, gears and gear trains alike.

A format is named by the ending of its files. What writes a part in it takes the part (see `exports`) and a folder,
writes there, reads back, and gives each file with what was read.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Generic, TypeVar

from cadgen.design.section import listed
from cadgen.errors import CheckError, DesignError, brief
from cadgen.figures import Facts
from cadgen.messages import Message
from cadgen.output.files.dxf import cam_dxf, gear_dxf, rack_dxf, train_dxf
from cadgen.output.files.exports import CamExport, GearExport, GrooveExport, RackExport, TrainExport
from cadgen.output.files.groove import (
    groove_3mf,
    groove_dxf,
    groove_programs,
    groove_step,
    groove_stl,
    groove_table,
    groove_xyz,
)
from cadgen.output.files.nc import cam_programs
from cadgen.output.files.publisher import Artifact
from cadgen.output.files.step import cam_step, gear_step, rack_step, train_step
from cadgen.output.files.stl import cam_stl, gear_stl, rack_stl, train_stl
from cadgen.output.files.tables import cam_table, train_table
from cadgen.output.files.threemf import cam_3mf, gear_3mf, rack_3mf, train_3mf
from cadgen.output.files.xyz import cam_xyz
from cadgen.processes import in_second_process
from cadgen.registry import Registry

P = TypeVar("P")
Writer = Callable[[P, Path], Iterable[Artifact]]
# Files of a format, or the check that keeps them from being made.
Made = list[Artifact] | CheckError


@dataclass(frozen=True, kw_only=True)
class Format:
    """Format of files.

    Attributes:
        code: ending of the files' names.
        label: name for people.
        cam, groove, train, gear, rack: function that writes such a part and reads it back; None where there is none.
        finer: change of a design that makes its files finer, in words.
        kernel: whether it needs the CAD kernel, which takes far longer than all other formats.
    """

    code: str
    label: str
    cam: Writer[CamExport] | None = None
    groove: Writer[GrooveExport] | None = None
    train: Writer[TrainExport] | None = None
    gear: Writer[GearExport] | None = None
    rack: Writer[RackExport] | None = None
    finer: str = Message("report this design")
    kernel: bool = False


_MESH, _ARCS = Message("lower export.mesh_chord_um"), Message("lower export.arc_tolerance_um")
_POINTS = Message("raise export.point_count")
FORMATS = Registry(
    Message("format"),
    (
        Format(
            code="step",
            label="STEP",
            cam=cam_step,
            groove=groove_step,
            train=train_step,
            gear=gear_step,
            rack=rack_step,
            kernel=True,
        ),
        Format(
            code="stl",
            label="STL",
            cam=cam_stl,
            groove=groove_stl,
            train=train_stl,
            gear=gear_stl,
            rack=rack_stl,
            finer=_MESH,
        ),
        Format(
            code="3mf",
            label="3MF",
            cam=cam_3mf,
            groove=groove_3mf,
            train=train_3mf,
            gear=gear_3mf,
            rack=rack_3mf,
            finer=_MESH,
        ),
        Format(
            code="dxf",
            label="DXF",
            cam=cam_dxf,
            groove=groove_dxf,
            train=train_dxf,
            gear=gear_dxf,
            rack=rack_dxf,
            finer=_ARCS,
        ),
        Format(code="nc", label="G-code", cam=cam_programs, groove=groove_programs, finer=_ARCS),
        Format(code="xyz", label="XYZ", cam=cam_xyz, groove=groove_xyz, finer=_POINTS),
        Format(code="csv", label="CSV", cam=cam_table, groove=groove_table, train=train_table, finer=_POINTS),
    ),
    group="cadgen.formats",
    sort=Format,
)


@dataclass(frozen=True)
class Offer(Generic[P]):
    """Formats that a sort of parts can be written in.

    Attributes:
        part: sort of the parts: `cam`, `groove`, `train`, `gear` or `rack`.
        on_request: codes of formats that are written only where they are named.
    """

    part: str
    on_request: tuple[str, ...] = ()

    def formats(self) -> tuple[Format, ...]:
        """All formats of the table that have a writer for such parts."""
        every = map(FORMATS.kind_of, FORMATS.codes())
        return tuple(each for each in every if getattr(each, self.part) is not None)

    @property
    def usual(self) -> tuple[Format, ...]:
        """Formats that are written where none is named."""
        return tuple(each for each in self.formats() if each.code not in self.on_request)

    @property
    def codes(self) -> tuple[str, ...]:
        """Codes of all formats."""
        return tuple(each.code for each in self.formats())

    def chosen(self, wanted: str | Iterable[str] | None) -> tuple[Format, ...]:
        """Formats to be written, in the order of the table.

        Args:
            wanted: endings such as `step` and `dxf`, or one text with commas between them; None for the usual ones.

        Raises:
            DesignError: an ending that is not offered, or none at all.
        """
        offered = self.codes
        if wanted is None:
            return self.usual
        if isinstance(wanted, bytes) or not isinstance(wanted, Iterable):
            raise DesignError(
                "formats is {given}; it must name {offered}",
                given=brief(repr(wanted), 40),
                offered=listed(list(offered), "or"),
            )
        parts = wanted.split(",") if isinstance(wanted, str) else [str(part) for part in wanted]
        endings = [part.strip().lower().removeprefix(".") for part in parts]
        for ending in endings:
            if ending not in offered:
                raise DesignError(
                    'formats has "{ending}"; it must name {offered}',
                    ending=brief(ending, 40),
                    offered=listed(list(offered), "or"),
                )
        if not endings:
            raise DesignError(
                "formats is empty; it must name at least one of {offered}", offered=listed(list(offered), "and")
            )
        return tuple(each for each in self.formats() if each.code in endings)

    def entry(self, stem: str, formats: Sequence[Format]) -> tuple[str, Facts]:
        """Name of a manifest's entry, and its facts on the formats; others than the usual ones have an entry apart."""
        if tuple(formats) == self.usual:
            return stem, Facts()
        codes = [each.code for each in formats]
        return "_".join([stem, *codes]), Facts(formats=codes)

    def made(
        self, part: P, folder: Path, formats: Sequence[Format], *, apart: bool = True
    ) -> list[tuple[Format, Made]]:
        """Write a part in some formats, and read all back; what needs the kernel is made beside the rest.

        Args:
            part: part to be written.
            folder: folder for the files.
            formats: formats to write.
            apart: whether the kernel's files may be made without the others, which do not need the kernel.
        """
        with_kernel = [each for each in formats if each.kernel]
        others = [each for each in formats if not each.kernel]
        write_solids = partial(self._written, part, folder, with_kernel)
        write_others = partial(self._written, part, folder, others)
        if not (with_kernel and others and apart):
            made = [*write_solids(), *write_others()]
        else:
            # The kernel alone takes as long as all other formats: `cadgen cam carbon_free_car` takes 4.4 s so, and
            # 5.7 s by one process, 1.3 times as long. The kernel is loaded in the second process, which ends without
            # clearing it away object by object: at the end of this one that takes 0.4 s more.
            with in_second_process(write_solids) as solids:
                rest = write_others()
                made = [*solids(), *rest]
        return sorted(zip((*with_kernel, *others), made, strict=True), key=lambda pair: formats.index(pair[0]))

    def _written(self, part: P, folder: Path, formats: Sequence[Format]) -> list[Made]:
        made: list[Made] = []
        for each in formats:
            writer: Writer[P] = getattr(each, self.part)
            try:
                made.append(list(writer(part, folder)))
            except CheckError as error:
                made.append(error)
        return made


CAM: Offer[CamExport] = Offer("cam")
GROOVE: Offer[GrooveExport] = Offer("groove")
TRAIN: Offer[TrainExport] = Offer("train", on_request=("3mf", "dxf"))
GEAR: Offer[GearExport] = Offer("gear")
RACK: Offer[RackExport] = Offer("rack")
