"""Settings after trial runs, as sentences."""

from typing import TYPE_CHECKING

from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen.api.adjustment import Adjustment


def settings(adjustment: "Adjustment") -> None:
    """Print the result, what to set, and the comment line of the next trial run."""
    console = Output()
    for sentence in adjustment.sentences:
        console.print(f"{sentence[0].upper()}{sentence[1:]}.")
    console.print("\nSet:")
    for step in adjustment.steps:
        console.print(f"- {step}")
    console.print("\nIf you measure the next run too, begin its file with this line:")
    console.print(adjustment.line, soft_wrap=True)
