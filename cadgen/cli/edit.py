"""`cadgen edit`: a design on its page in the browser, where it can be changed."""

import click

from cadgen.cli.options import overrides_option


@click.command()
@click.argument("design", required=False)
@overrides_option
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    help="Port of the page on 127.0.0.1.  [default: any that is free]",
)
@click.option("--no-browser", is_flag=True, help="Print the address only, and open no browser.")
def edit(design: str | None, overrides: tuple[str, ...], port: int, no_browser: bool) -> None:
    """Edit a design on its page in the browser: drag waypoints, gates and posts, move sliders, and see the part.

    The page is that of cadgen report. It is served to this computer alone, at an address with a random token. The
    actual cam follows each move, the cam of cadgen check soon after; what cannot be computed is said, and the last good
    part stays. Saving writes the design's file, where comments stay. Of a packaged design a copy is edited, which is
    saved under a name of its own in the current folder.

    Ctrl-C ends it. It needs an extra: pip install '.[edit]' in cadgen's folder.
    """
    from cadgen.api.views import Editor

    editor = Editor.open(design, overrides)
    editor.serve(port, browser=not no_browser, show=_show)
    click.echo("ended; changes that were not saved are gone" if editor.unsaved else "ended; nothing is unsaved")


def _show(address: str) -> None:
    click.echo(f"{address}  (Ctrl-C ends it)")
