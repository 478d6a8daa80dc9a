"""A planned path, as sentences and its checks."""

from typing import TYPE_CHECKING, Any

from cadgen.cli import show
from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen.api.planning import Plan


def plan(planned: "Plan[Any]") -> None:
    """Print the result, and the checks of the cam for the path if there is one."""
    console = Output()
    for sentence in planned.sentences:
        console.print(f"{sentence[0].upper()}{sentence[1:]}.")
    if planned.cam is not None:
        show.figures(f"\n{planned.cam.design.name}, {planned.cam.profile} profile", planned.cam.checks)
