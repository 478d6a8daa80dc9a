"""`cadgen verify`: a folder's files against its manifest."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.errors import escaped

if TYPE_CHECKING:
    from cadgen.output.files.folder import FolderState

UNLISTED_SHOWN = 20


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.option("--restore", is_flag=True, help="First undo half-done moves of runs that were killed in the folder.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of a table.")
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
        show.document(state.facts(folder))
    else:
        _report(folder, state)
    sys.exit(0 if state.is_true else 1)


def _report(folder: Path, state: "FolderState") -> None:
    from cadgen.cli.show import Output, plain_table
    from cadgen.cli.verdict import verdict
    from cadgen.output.files.folder import State

    console = Output()
    table = plain_table(escaped(str(folder)))
    table.add_column("file", overflow="fold")
    table.add_column("state", no_wrap=True)
    unlisted = [file for file in state.files if file.state == State.NOT_LISTED]
    for file in [*(file for file in state.files if file.part), *unlisted[:UNLISTED_SHOWN]]:
        table.add_row(escaped(file.name), file.state)
    console.print(table)
    if len(unlisted) > UNLISTED_SHOWN:
        console.print(f"And {len(unlisted) - UNLISTED_SHOWN} more that are not listed.")
    if state.restored:
        console.print(f"Put back as before a run that was killed: {', '.join(map(escaped, state.restored))}.")
    for name in state.half_moved:
        console.print(
            f"A run was killed while it moved its files into this folder ({name}): the next command that writes here, "
            f"or cadgen verify --restore, puts back what was there before."
        )
    for name in state.left:
        console.print(f"A run that was killed has left {name}: the next command that writes here removes it.")
    wrong = sum(file.state not in (State.AS_LISTED, State.NOT_LISTED) for file in state.files)
    listed = sum(bool(file.part) for file in state.files)
    if wrong:
        verdict(False, f"{wrong} of {listed} listed files are not as listed", "do not use them, and export again")
    elif state.is_true:
        verdict(True, f"all {listed} listed files are the ones that were read back", "use them")
    else:
        verdict(False, "a run was killed while it moved its files", f"cadgen verify {escaped(str(folder))} --restore")
