"""The last line of every command: PASS or FAIL, and what to do next."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.text import Text

from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen.check import Check


def verdict(passed: bool, result: str, step: str = "") -> None:
    """Print the last line.

    Args:
        passed: whether the command did all that was asked of it, and every check of its result holds.
        result: result in a few words.
        step: what to do next.
    """
    head = Text("PASS", "bold green") if passed else Text("FAIL", "bold red")
    Output().print(Text.assemble(head, f": {result}{f'; next: {step}' if step else ''}"))


def failed(checks: "Sequence[Check]") -> str:
    """The checks that fail, in words."""
    names = list(dict.fromkeys(check.name for check in checks if not check.passed))
    return f"{', '.join(names)} {'fails' if len(names) == 1 else 'fail'}"


def command(verb: str, design: str | None, *more: str, overrides: Sequence[str] = ()) -> str:
    """A command on the same design, as it is typed; many overrides are only named."""
    words = ["cadgen", verb, *([design] if design else []), *more]
    return " ".join(words) + (" (with the same --set)" if overrides else "")
