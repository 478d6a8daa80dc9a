"""A sheet as a page of PDF: its DXF, drawn."""

import io
from collections.abc import Iterable

from ezdxf.addons.drawing import Frontend, RenderContext
from ezdxf.addons.drawing.config import BackgroundPolicy, ColorPolicy, Configuration, LineweightPolicy
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from ezdxf.addons.drawing.properties import BackendProperties
from ezdxf.npshapes import NumpyPath2d as BkPath2d
from ezdxf.npshapes import to_matplotlib_path
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch

from cadgen.output.drawing.dxf import FAR_EASTERN_STYLE, document_of, far_eastern
from cadgen.output.drawing.fonts import know_far_eastern, know_font
from cadgen.output.drawing.sheet import SIZES, Drawing

_INCH = 25.4
_POINT = 72 / _INCH  # points in a mm
_THINNEST = 0.13  # mm


def pdf_bytes(drawing: Drawing) -> bytes:
    """The page of a sheet, in its true size: the same bytes for the same sheet, fonts and libraries.

    Raises:
        NoFontError: the system has no font for letters of the title block.
    """
    know_font()
    width, height = SIZES[drawing.size]
    figure = Figure(figsize=(width / _INCH, height / _INCH))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    document = document_of(drawing)
    if letters := far_eastern(drawing):
        document.styles.get(FAR_EASTERN_STYLE).dxf.font = know_far_eastern(letters)
    backend = _Backend(axes, adjust_figure=False)
    look = Configuration(
        background_policy=BackgroundPolicy.WHITE,
        color_policy=ColorPolicy.BLACK,
        lineweight_policy=LineweightPolicy.ABSOLUTE,
        lineweight_scaling=_POINT,  # matplotlib counts points where the drawing counts mm
        min_lineweight=_THINNEST * _POINT,
    )
    Frontend(RenderContext(document), backend, config=look).draw_layout(document.modelspace(), finalize=True)
    axes.set_aspect("equal", adjustable="box")
    axes.axis((0.0, width, 0.0, height))
    page = io.BytesIO()
    figure.savefig(page, format="pdf", metadata={"CreationDate": None, "Title": drawing.title.number})
    return page.getvalue()


class _Backend(MatplotlibBackend):  # type: ignore[misc]
    """Letters filled by the winding of their outlines; by nested boxes, as ezdxf has it, a turned Ø is filled half."""

    def draw_filled_paths(self, paths: Iterable[BkPath2d], properties: BackendProperties) -> None:
        """Draw filled outlines."""
        path = to_matplotlib_path(paths, detect_holes=False)
        # As an artist, and not as a patch, whose limits would be reckoned, which takes three quarters of the time.
        self.ax.add_artist(PathPatch(path, color=properties.color, linewidth=0, fill=True, zorder=self._get_z()))
