"""`cadgen verify`: a folder's files against its manifest."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.cli import help
from cadgen.errors import escaped
from cadgen.figures import Sheet
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.output.files.folder import FolderState

UNLISTED_SHOWN = 20


@help.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@help.option("--restore", is_flag=True, help="First undo half-done moves of runs that were killed in the folder.")
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of a table.")
def verify(folder: Path, restore: bool, as_json: bool) -> None:
    """Compare the files in DIR with its manifest.

    Each file is as listed, changed, missing, unreadable or not listed. The exit code is 1 if a listed file is not as
    listed, or if a run was killed while it moved its files into DIR; the next command that writes there, or
    --restore, undoes that.
    """
    from cadgen import verify as verified
    from cadgen.cli import show

    state = verified(folder, restore=restore)
    if as_json:
        show.document(state.entry(folder).json())
    else:
        _report(folder, state)
    sys.exit(0 if state.is_true else 1)


def _report(folder: Path, state: "FolderState") -> None:
    from cadgen.cli import show
    from cadgen.cli.show import Output, sheet, verdict
    from cadgen.output.files.folder import State

    console = Output()
    unlisted = [file for file in state.files if file.state == State.NOT_LISTED]
    shown = [*(file for file in state.files if file.part), *unlisted[:UNLISTED_SHOWN]]
    rows = tuple((escaped(file.name), Message(file.state)) for file in shown)
    heads = (Message("file"), Message("state"))
    sheet(Sheet("folder", escaped(str(folder)), heads, rows, words=2), gap=False)
    if len(unlisted) > UNLISTED_SHOWN:
        console.print(Message("And {count} more that are not listed.", count=len(unlisted) - UNLISTED_SHOWN))
    if state.restored:
        console.print(
            Message("Put back as before a run that was killed: {names}.", names=joined(map(escaped, state.restored)))
        )
    for name in state.half_moved:
        console.print(
            Message(
                "A run was killed while it moved its files into this folder ({name}): the next command that writes "
                "here, or cadgen verify --restore, puts back what was there before.",
                name=name,
            )
        )
    for name in state.left:
        console.print(
            Message("A run that was killed has left {name}: the next command that writes here removes it.", name=name)
        )
    for design in sorted(set(state.older.values())):
        names = [escaped(name) for name, of in state.older.items() if of == design]
        console.print(show.of_earlier_version(design, names))
    wrong = sum(file.state not in (State.AS_LISTED, State.NOT_LISTED) for file in state.files)
    listed = sum(bool(file.part) for file in state.files)
    if wrong:
        verdict(
            False,
            Message("{wrong} of {listed} listed files are not as listed", wrong=wrong, listed=listed),
            Message("do not use them, and export again"),
        )
    elif state.is_true:
        verdict(
            True,
            Message("all {listed} listed files are the ones that were read back", listed=listed),
            Message("export those that you use from one version of the design") if state.older else Message("use them"),
        )
    else:
        verdict(
            False,
            Message("a run was killed while it moved its files"),
            f"cadgen verify {escaped(str(folder))} --restore",
        )
