"""STEP (ISO 10303-21, AP214): reproducible bytes, and what a reader finds in them.

AP214 and not AP242: every CAD system reads it, with name and colour, and what AP242 adds (tolerances,
tessellated shapes, kinematics) a cam does not use; the kernel writes AP242 by its draft schema only. Curves
in the surfaces' parameters are left out: they double the file, and on planes and extrusions every reader
finds them itself.
"""

import io
import os
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.collections import Sequence_TDF_Label
from OCP.IFSelect import IFSelect_RetDone
from OCP.Interface import Interface_Static
from OCP.Message import Message
from OCP.Quantity import Quantity_Color, Quantity_TOC_sRGB
from OCP.StepBasic import StepBasic_Product
from OCP.STEPCAFControl import STEPCAFControl_Controller, STEPCAFControl_Reader, STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_AsIs
from OCP.StepData import StepData_StepModel
from OCP.TCollection import TCollection_ExtendedString, TCollection_HAsciiString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.XCAFDoc import XCAFDoc_ColorGen, XCAFDoc_ColorSurf, XCAFDoc_DocumentTool
from OCP.XSControl import XSControl_WorkSession

from cadgen.curves.closed import Outline
from cadgen.errors import FileError
from cadgen.solids.kernel import Part, is_valid, solids, volume
from cadgen.solids.step_text import read_rim

# Written into every file so that equal designs give equal bytes; the environment's SOURCE_DATE_EPOCH (seconds
# since 1970, as reproducible-builds.org defines it) replaces it.
EPOCH = int(datetime(2000, 1, 1, tzinfo=UTC).timestamp())


@dataclass(frozen=True, kw_only=True, slots=True)
class StepContent:
    """What a STEP file holds, read again.

    Attributes:
        rim: outline of the disc at z = 0, from the file's text alone.
        valid: whether the kernel finds no fault in what it reads.
        bodies: number of solids.
        volume: of all solids, mm^3.
        name: of the product.
        description: of the product.
        colour: red, green, blue in sRGB; None if the file gives none.
    """

    rim: Outline
    valid: bool
    bodies: int
    volume: float
    name: str
    description: str
    colour: tuple[float, float, float] | None


def step_bytes(part: Part) -> bytes:
    """Return the STEP file of a part: the same bytes for the same part, whatever was written before.

    Raises:
        FileError: the kernel refused, the name or the description is not ASCII, or SOURCE_DATE_EPOCH is not a
            number of seconds.
    """
    if not (part.name + part.description).isascii():
        raise FileError(
            f"{part.name!r} and {part.description!r} must be ASCII in a STEP file: the CAD kernel garbles other letters"
        )
    _silence()
    document = _document()
    tool = XCAFDoc_DocumentTool
    label = tool.ShapeTool_s(document.Main()).AddShape(part.solid, False)
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(part.name))
    tool.ColorTool_s(document.Main()).SetColor(label, Quantity_Color(*part.colour, Quantity_TOC_sRGB), XCAFDoc_ColorGen)
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
    model = writer.Writer().Model()
    for product in _products(model):
        product.SetDescription(_text(part.description))
    _write_header(model, part)
    stream = io.BytesIO()
    if not done or writer.WriteStream(stream) != IFSelect_RetDone:
        raise FileError(f"the CAD kernel cannot write {part.name!r} as STEP: check the solid")
    return stream.getvalue()


def read_step(path: Path, step: float) -> StepContent:
    """Read a file again: the rim from its text, all else through the kernel's reader.

    Args:
        path: of the file.
        step: largest distance of two points of the rim, mm.

    Raises:
        FileError: the file cannot be read, or is not one of ours.
    """
    _silence()
    rim = read_rim(path, step)
    document = _document()
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.SetColorMode(True)
    if reader.ReadFile(str(path)) != IFSelect_RetDone or not reader.Transfer(document):
        raise FileError(f"the CAD kernel cannot read {path.name}: the file is damaged, export it again")
    tool = XCAFDoc_DocumentTool
    shapes = tool.ShapeTool_s(document.Main())
    labels = Sequence_TDF_Label()
    shapes.GetFreeShapes(labels)
    products = _products(reader.Reader().StepModel())
    if labels.Length() != 1 or len(products) != 1:
        raise FileError(f"{path.name} holds {labels.Length()} shapes and {len(products)} products, not one of each")
    shape = shapes.GetShape_s(labels.First())
    bodies = solids(shape)
    colour = Quantity_Color()
    colours = tool.ColorTool_s(document.Main())
    kinds = (XCAFDoc_ColorGen, XCAFDoc_ColorSurf)
    coloured = any(colours.GetColor(body, kind, colour) for body in bodies[:1] for kind in kinds)
    return StepContent(
        rim=rim,
        valid=is_valid(shape),
        bodies=len(bodies),
        volume=volume(shape),
        name=products[0].Name().ToCString(),
        description=products[0].Description().ToCString(),
        colour=tuple(colour.Values(Quantity_TOC_sRGB)) if coloured else None,
    )


def _write_header(model: StepData_StepModel, part: Part) -> None:
    seconds = os.environ.get("SOURCE_DATE_EPOCH", str(EPOCH))
    try:
        stamp = datetime.fromtimestamp(int(seconds), UTC)
    except (ValueError, OverflowError, OSError) as error:
        raise FileError(f"SOURCE_DATE_EPOCH is {seconds!r}; it must be a number of seconds since 1970") from error
    header = APIHeaderSection_MakeHeader(model)
    header.SetName(_text(part.name))
    header.SetDescriptionValue(1, _text(part.description))
    header.SetTimeStamp(_text(stamp.strftime("%Y-%m-%dT%H:%M:%S")))
    header.SetAuthorValue(1, _text(""))
    header.SetOrganizationValue(1, _text(""))
    header.SetOriginatingSystem(_text("cadgen"))
    header.SetAuthorisation(_text(""))


def _document() -> TDocStd_Document:
    document = TDocStd_Document(TCollection_ExtendedString("XCAF"))
    XCAFDoc_DocumentTool.SetLengthUnit_s(document, 1e-3)  # metres: millimetres
    return document


def _products(model: StepData_StepModel) -> list[StepBasic_Product]:
    entities = (model.Entity(number) for number in range(1, model.NbEntities() + 1))
    return [entity for entity in entities if isinstance(entity, StepBasic_Product)]


def _text(value: str) -> TCollection_HAsciiString:
    return TCollection_HAsciiString(value)


def _silence() -> None:
    """Keep the kernel's statistics and warnings off the terminal; failures are raised here, in our words."""
    Message.DefaultMessenger_s().ChangePrinters().Clear()
