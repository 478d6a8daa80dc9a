"""Commands on many designs: `cadgen explore`, and `cadgen merge` for its shards."""

import os
import sys
from pathlib import Path

import click

from cadgen.cli import help, interrupt
from cadgen.cli.options import out_option
from cadgen.messages import Message


@help.command()
@click.argument("study", type=click.Path(path_type=Path))
@out_option(required=True, help="Folder for journal and results.")
@help.option(
    "--processes",
    type=click.IntRange(1, 1024),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of processes that run at once; the results do not depend on it.  [default: 2]",
)
@help.option("--scheduler", metavar="ADDRESS", help="Have a dask scheduler compute: its address or its file.")
@help.option("--shard", metavar="K/N", help="Compute the K-th of N parts only, for cadgen merge.")
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables.")
def explore(
    study: Path,
    out: Path,
    processes: int,
    scheduler: str | None,
    shard: str | None,
    as_json: bool,
) -> None:
    """Compute thousands of designs: which are the best, and what that depends on.

    STUDY is a TOML file with base design, keys that vary, limits and objectives (docs/how-to/explore.md), or a packaged
    study, paper_car or car_frame. Every result is kept in a journal at once; the same command again goes on where it
    was. The exit code is 1 if no design keeps all limits and checks.
    """
    from cadgen.api import exploration
    from cadgen.cli import show
    from cadgen.cli.show import verdict

    interrupt.resumable()
    with show.progress(not as_json) as progress:
        computed = exploration.explore(
            study, out, processes=processes, scheduler=scheduler, shard=shard, progress=progress
        )
        written = computed.write(progress=progress) if computed.complete else None
    show.study(computed, written, out, as_json=as_json)
    if not computed.complete:
        if not as_json:
            part, parts = computed.shard
            verdict(
                True,
                Message("shard {part} of {parts} is done", part=part, parts=parts),
                Message("when all are, cadgen merge {out} --out {out}", out=out),
            )
        return
    if not as_json:
        verdict(*show.outcome(computed, out))
    sys.exit(0 if computed.summary.front else 1)


@help.command()
@click.argument("folders", nargs=-1, required=True, type=click.Path(path_type=Path))
@out_option(required=True, help="Folder for the results.")
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables.")
def merge(folders: tuple[Path, ...], out: Path, as_json: bool) -> None:
    """Put the shards of a study together: FOLDERS are those that cadgen explore --shard wrote to."""
    from cadgen.api import exploration
    from cadgen.cli import show
    from cadgen.cli.show import verdict

    with show.progress(not as_json) as progress:
        computed = exploration.merge(folders)
        written = computed.write(out, progress=progress)
    show.study(computed, written, out, as_json=as_json)
    if not as_json:
        verdict(*show.outcome(computed, out))
    sys.exit(0 if computed.summary.front else 1)
