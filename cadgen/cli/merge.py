"""`cadgen merge`: the shards of a study put together."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import out_option


@click.command()
@click.argument("folders", nargs=-1, required=True, type=click.Path(path_type=Path))
@out_option(required=True, help="Folder for the results.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables.")
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
