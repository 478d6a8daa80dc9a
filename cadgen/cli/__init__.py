"""The command line: thin commands, one file per verb.

Exit codes: 0 done, 1 a check failed, 2 usage or design, 3 file or kernel, 130 interrupted.
"""

import json
import os
import signal
import sys
import traceback
from typing import NoReturn

import click

from cadgen import __version__
from cadgen.cli.cam import cam
from cadgen.cli.check import check
from cadgen.errors import CadgenError

INTERRUPTED = 130
INTERNAL = 3


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(__version__, prog_name="cadgen")
def cli() -> None:
    """Steering cams and the gear trains that drive them, from a planned path to verified files.

    DESIGN is the name of a packaged design or a TOML file; without it the paper's car is used.
    """


cli.add_command(cam)
cli.add_command(check)


def main() -> NoReturn:
    """Run a command and turn every failure into one sentence and an exit code."""
    # An ordinary kill cleans up like Ctrl-C does.
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        code = cli.main(standalone_mode=False) or 0
    except click.exceptions.Abort:
        code = _fail("interrupted: nothing was written", INTERRUPTED)
    except click.ClickException as error:
        code = _fail(error.format_message(), error.exit_code)
    except CadgenError as error:
        code = _fail(str(error), error.exit_code)
    except BrokenPipeError:
        # The reader of our output has gone; say nothing more to it.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = 0
    except MemoryError:
        code = _fail("out of memory: close other programs, or use coarser tolerances in [export]", INTERNAL)
    except Exception as error:
        if os.environ.get("CADGEN_DEBUG"):
            traceback.print_exc()
        summary = f"{type(error).__name__}: {error}".replace("\n", " ")
        code = _fail(f"a fault in cadgen, please report it with your design file ({summary})", INTERNAL)
    sys.exit(code)


def _fail(message: str, code: int) -> int:
    if "--json" in sys.argv:
        print(json.dumps({"error": message, "exit_code": code}))
    else:
        click.echo(f"cadgen: {message}", err=True)
    return code


def _interrupt(number: int, frame: object) -> None:
    raise KeyboardInterrupt
