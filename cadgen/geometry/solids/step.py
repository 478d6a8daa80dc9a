"""STEP (ISO 10303-21, AP214): reproducible bytes, and their content read again.

AP214 and not AP242: every CAD system reads it, with name and colour, and what AP242 adds (tolerances,
tessellated shapes, kinematics) a cam does not use; the kernel writes AP242 by its draft schema only. Curves
in the surfaces' parameters are left out: they double the file, and on planes and extrusions every reader
finds them itself.
"""

import io
import os
import re
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.collections import DataMap_TCollection_AsciiString_TCollection_AsciiString, Sequence_TDF_Label
from OCP.IFSelect import IFSelect_RetDone, IFSelect_SelectModelEntities, IFSelect_SelectType
from OCP.Interface import Interface_Static
from OCP.Message import Message
from OCP.Quantity import Quantity_Color, Quantity_TOC_sRGB
from OCP.ShapeFix import ShapeFix_Shape
from OCP.StepBasic import StepBasic_Product
from OCP.STEPCAFControl import STEPCAFControl_Controller, STEPCAFControl_Reader, STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_AsIs
from OCP.StepData import StepData_StepModel
from OCP.StepRepr import StepRepr_NextAssemblyUsageOccurrence
from OCP.TCollection import TCollection_AsciiString, TCollection_ExtendedString, TCollection_HAsciiString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label
from OCP.TDocStd import TDocStd_Document
from OCP.TopoDS import TopoDS_Shape
from OCP.XCAFDoc import XCAFDoc_ColorGen, XCAFDoc_ColorSurf, XCAFDoc_DocumentTool, XCAFDoc_ShapeTool
from OCP.XSControl import XSControl_WorkSession

from cadgen.curves.closed import Outline
from cadgen.errors import FileError
from cadgen.geometry.solids.kernel import SolidPart, edges_on_surfaces, fits, is_valid, solids, volume
from cadgen.geometry.solids.step_text import read_rim

# Written into every file so that equal designs give equal bytes; the environment's SOURCE_DATE_EPOCH (seconds
# since 1970, as reproducible-builds.org defines it) replaces it.
EPOCH = int(datetime(2000, 1, 1, tzinfo=UTC).timestamp())

_ROUNDING = 9  # decimals of a mm to which two edges of a land are alike
_COLOUR = re.compile(rb"#\d+ = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION\(")
_COLOURED = re.compile(rb"STYLED_ITEM\('color',\(#\d+\),#(\d+)\)")
_REFERENCE = re.compile(rb"#(\d+)")


@dataclass(frozen=True, kw_only=True)
class PartContent:
    """Content of a STEP file of one part, as the kernel reads it.

    Attributes:
        valid: whether the kernel finds no gap, no fault, and no edge beside its surfaces.
        bodies: number of solids.
        volume: volume of all solids, mm^3.
        name: name of the product.
        description: description of the product.
        colour: red, green, blue in sRGB; None if the file has no colour.
    """

    valid: bool
    bodies: int
    volume: float
    name: str
    description: str
    colour: tuple[float, float, float] | None


@dataclass(frozen=True, kw_only=True)
class StepContent(PartContent):
    """Content of a cam's STEP file, read again.

    Attributes:
        rim: outline of the disc at its carrying planes, from the file's text alone: at z = 0, or where the edges are
            broken at either edge of the land between the chamfers, which are found to be alike.
    """

    rim: Outline


def step_bytes(part: SolidPart) -> bytes:
    """Return the STEP file of a part: the same bytes for the same part, whatever was written before.

    Raises:
        FileError: the kernel refused, or SOURCE_DATE_EPOCH is not a number of seconds.
    """
    document = new_document()
    add_part(document, part)
    return document_bytes(document, part.name, part.description)


def new_document() -> TDocStd_Document:
    """An empty document of the kernel, in mm."""
    document = TDocStd_Document(TCollection_ExtendedString("XCAF"))
    XCAFDoc_DocumentTool.SetLengthUnit_s(document, 1e-3)  # metres: millimetres
    return document


def add_part(document: TDocStd_Document, part: SolidPart) -> TDF_Label:
    """Put a part with its name and colour into a document, and return its label."""
    tool = XCAFDoc_DocumentTool
    label = tool.ShapeTool_s(document.Main()).AddShape(part.solid, False)
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(encoded(part.name)))
    tool.ColorTool_s(document.Main()).SetColor(label, Quantity_Color(*part.colour, Quantity_TOC_sRGB), XCAFDoc_ColorGen)
    return label


def document_bytes(document: TDocStd_Document, name: str, description: str) -> bytes:
    """Return a document as a STEP file; all its products get the description, its header also the name.

    Raises:
        FileError: the kernel refused, or SOURCE_DATE_EPOCH is not a number of seconds.
    """
    _silence()
    # The kernel's settings are global, and no other call here depends on them.
    STEPCAFControl_Controller.Init_s()
    Interface_Static.SetCVal_s("write.step.schema", "AP214IS")
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 0)
    Interface_Static.SetIVal_s("write.precision.mode", 0)
    writer = STEPCAFControl_Writer(XSControl_WorkSession(), False)
    writer.SetNameMode(True)
    writer.SetColorMode(True)
    done = writer.Transfer(document, STEPControl_AsIs)
    for product in _of_type(writer.Writer().WS(), StepBasic_Product):
        product.SetDescription(_text(description))
    # The kernel goes on counting from the assembly it wrote before.
    for number, use in enumerate(_of_type(writer.Writer().WS(), StepRepr_NextAssemblyUsageOccurrence), 1):
        use.SetId(_text(str(number)))
    _write_header(writer.Writer().Model(), name, description)
    stream = io.BytesIO()
    if not done or writer.WriteStream(stream) != IFSelect_RetDone:
        raise FileError("the CAD kernel cannot write {name!r} as STEP: check the solid", name=name)
    return _with_sorted_colours(stream.getvalue())


def read_document(path: Path) -> tuple[TDocStd_Document, list[StepBasic_Product]]:
    """Read a file through the kernel as it is: the document, and the products that the file names.

    Its solids lack what the file leaves out: `completed` adds it.

    Raises:
        FileError: the kernel cannot read the file.
    """
    _silence()
    document = new_document()
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.SetColorMode(True)
    read = reader.ReadFile(str(path)) == IFSelect_RetDone
    # Only now: reading a file sets the kernel's defaults again.
    unhealed = DataMap_TCollection_AsciiString_TCollection_AsciiString()
    unhealed.Bind(TCollection_AsciiString("FixShape.FixSolidMode"), TCollection_AsciiString("0"))
    reader.SetShapeFixParameters(unhealed)
    if not read or not reader.Transfer(document):
        raise FileError("the CAD kernel cannot read {name}: the file is damaged, export it again", name=path.name)
    return document, _of_type(reader.Reader().WS(), StepBasic_Product)


def read_uses(path: Path) -> tuple[TDocStd_Document, list[TDF_Label]]:
    """Read an assembly: the document, and the label of every use of a part, in the order written.

    Raises:
        FileError: the file cannot be read or is not one assembly of parts.
    """
    document, _ = read_document(path)
    roots, uses = Sequence_TDF_Label(), Sequence_TDF_Label()
    XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).GetFreeShapes(roots)
    if roots.Length() != 1 or not XCAFDoc_ShapeTool.GetComponents_s(roots.First(), uses):
        raise FileError("{name} is not one assembly: export it again", name=path.name)
    return document, [uses.Value(number) for number in range(1, uses.Length() + 1)]


def completed(shape: TopoDS_Shape) -> TopoDS_Shape:
    """A shape as read, with what a file leaves out: the curves of its edges in the surfaces' parameters.

    The kernel's repairs that would change the shape, or raise its tolerances, are left out, so that the file itself
    is judged.
    """
    fix = ShapeFix_Shape(shape)
    solid, shell, face, wire = fix.FixSolidTool(), fix.FixShellTool(), fix.FixFaceTool(), fix.FixWireTool()
    solid.FixShellOrientationMode = shell.FixOrientationMode = face.FixOrientationMode = 0
    wire.FixSelfIntersectionMode = 0
    for tool in (fix, wire):
        tool.FixSameParameterMode = 0
    fix.FixVertexTolMode = wire.FixVertexToleranceMode = 0
    fix.Perform()
    return fix.Shape()


def colour_of(document: TDocStd_Document, shape: TopoDS_Shape) -> tuple[float, float, float] | None:
    """Red, green and blue in sRGB of a shape in a document; None if it has no colour."""
    colour = Quantity_Color()
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    if not any(colours.GetColor(shape, kind, colour) for kind in (XCAFDoc_ColorGen, XCAFDoc_ColorSurf)):
        return None
    red, green, blue = colour.Values(Quantity_TOC_sRGB)
    return red, green, blue


def read_step(path: Path, step: float, land: tuple[float, float] | None = None) -> StepContent:
    """Read a file again: the rim from its text, all else through the kernel's reader.

    Args:
        path: path of the file.
        step: largest distance of two points of the rim, mm.
        land: heights of the edges of the land between broken edges, mm; None for a rim with sharp edges.

    Raises:
        FileError: the file cannot be read, is not one of ours, or its rim differs from one edge of the land to the
            other.
    """
    rim, *rims = (read_rim(path, step, height) for height in land or (0.0,))
    for upper in rims:
        # The same points, wherever they begin.
        a, b = (points[np.lexsort(points.round(_ROUNDING).T)] for points in (rim.points, upper.points))
        if a.shape != b.shape or np.abs(a - b).max() >= 10.0**-_ROUNDING:
            raise FileError(
                "the land between the broken edges in {name} is not upright: export it again", name=path.name
            )
    return StepContent(rim=rim, **asdict(read_part(path)))


def read_part(path: Path) -> PartContent:
    """Read a file of one part again through the kernel's reader.

    Raises:
        FileError: the file cannot be read, or is not of one part.
    """
    document, products = read_document(path)
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    labels = Sequence_TDF_Label()
    shapes.GetFreeShapes(labels)
    if labels.Length() != 1 or len(products) != 1:
        raise FileError(
            "{name} holds {shapes} shapes and {products} products, not one of each",
            name=path.name,
            shapes=labels.Length(),
            products=len(products),
        )
    read = shapes.GetShape_s(labels.First())
    bodies = solids(read)
    shape = completed(read)
    return PartContent(
        valid=fits(shape) and is_valid(shape) and edges_on_surfaces(shape),
        bodies=len(bodies),
        volume=volume(shape),
        name=products[0].Name().ToCString(),
        description=products[0].Description().ToCString(),
        colour=colour_of(document, bodies[0]) if bodies else None,
    )


def _with_sorted_colours(data: bytes) -> bytes:
    """The file with its colours in the order of what they colour; the kernel gives them in that of its addresses.

    Each colour is a run of entities to itself at the file's end, if no two parts share one.
    """
    starts = [match.start() for match in _COLOUR.finditer(data)]
    if len(starts) < 2:
        return data
    end = data.index(b"ENDSEC;", starts[-1])
    runs = [b"".join(data[begin:stop].split(b"\n")) for begin, stop in pairwise([*starts, end])]
    number = first = int(_REFERENCE.search(runs[0])[1])  # type: ignore[index]
    written = []
    for run in sorted(runs, key=lambda run: int(_COLOURED.search(run)[1])):  # type: ignore[index]
        by = number - int(_REFERENCE.search(run)[1])  # type: ignore[index]
        words = _REFERENCE.split(run)
        # References to the entities of the runs move with them; those to entities before stay.
        words[1::2] = [b"#%d" % (int(old) + by if int(old) >= first else int(old)) for old in words[1::2]]
        written.append(b"".join(words).replace(b";#", b";\n#") + b"\n")
        number += run.count(b";")
    return data[: starts[0]] + b"".join(written) + data[end:]


def _write_header(model: StepData_StepModel, name: str, description: str) -> None:
    seconds = os.environ.get("SOURCE_DATE_EPOCH", str(EPOCH))
    try:
        stamp = datetime.fromtimestamp(int(seconds), UTC)
    except (ValueError, OverflowError, OSError) as error:
        raise FileError(
            "SOURCE_DATE_EPOCH is {seconds!r}; it must be a number of seconds since 1970", seconds=seconds
        ) from error
    header = APIHeaderSection_MakeHeader(model)
    header.SetName(_text(name))
    header.SetDescriptionValue(1, _text(description))
    header.SetTimeStamp(_text(stamp.strftime("%Y-%m-%dT%H:%M:%S")))
    header.SetAuthorValue(1, _text(""))
    header.SetOrganizationValue(1, _text(""))
    header.SetOriginatingSystem(_text("cadgen"))
    header.SetAuthorisation(_text(""))


def _of_type(session: XSControl_WorkSession, kind: Any) -> list[Any]:
    """Entities of a type, in the order of the file; the kernel's own selection is ten times as fast as a loop here."""
    selection = IFSelect_SelectType(kind.get_type_descriptor_s())
    selection.SetInput(IFSelect_SelectModelEntities())
    entities = session.SelectionResult(selection)
    return [entities.Value(number) for number in range(1, entities.Length() + 1)]


def encoded(text: str) -> str:
    """Text as ISO 10303-21 writes it, letters beyond ASCII by their codes; the kernel garbles them."""

    def codes(found: re.Match[str]) -> str:
        short = max(found[0]) <= "\uffff"
        digits = found[0].encode("utf-16-be" if short else "utf-32-be").hex().upper()
        return f"\\{'X2' if short else 'X4'}\\{digits}\\X0\\"

    return re.sub(r"[^\x00-\x7f]+", codes, text)


def _text(value: str) -> TCollection_HAsciiString:
    return TCollection_HAsciiString(encoded(value))


def _silence() -> None:
    """Keep the kernel's statistics and warnings off the terminal; failures are raised here, in our words."""
    Message.DefaultMessenger_s().ChangePrinters().Clear()
