"""The command line: thin commands over the Python face.

| module      | what it holds                                                     |
|-------------|-------------------------------------------------------------------|
| `design_commands` | `cadgen new`, `plan`, `card`: what makes a design           |
| `cam_commands` | `cadgen check`, `cam`, `optimize`                               |
| `gears`     | `cadgen gears`: a gear train as verified files                     |
| `gear_numbers` | `cadgen gear`, `pair`, `planetary`: gears by flags              |
| `car_commands` | `cadgen frame`, `assembly`, `simulate`, `tolerance`, `calibrate`, `adjust` |
| `study_commands` | `cadgen explore`, `merge`: studies of many designs            |
| `page_commands` | `cadgen report`, `edit`, `draw`: what shows a design           |
| `verify`    | `cadgen verify`: a folder against its manifest                     |
| `explain`   | `cadgen explain`: a word of the field, or a key of the design file |
| `options`   | arguments and options that several commands share                  |
| `show`      | progress, sheets of checks and files, sentences, JSON, the verdict |
| `show_play` | sheets of methods, runs, remedies, many cars and budgets           |
| `help`      | commands and options with their help in the chosen language        |
| `output`    | standard output and sentences on standard error                    |
| `interrupt` | signals                                                            |

Exit codes: 0 done, 1 a check failed, 2 usage or design, 3 file or kernel, 130 interrupted.
"""

import io
import json
import os
import sys
import traceback
from typing import NoReturn

import click

# Before numpy is loaded: threads that wait for each other over small matrices cost more than they bring, and the last
# digits of sums go by their number. Always one, so that a command prints the same whatever the environment asks for.
for _threads in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_threads] = "1"

from cadgen.cli import help, interrupt, output
from cadgen.cli.cam_commands import cam, check, optimize
from cadgen.cli.car_commands import adjust, assembly, calibrate, frame, simulate, tolerance
from cadgen.cli.design_commands import card, new, plan
from cadgen.cli.explain import explain
from cadgen.cli.gear_numbers import gear, pair, planetary
from cadgen.cli.gears import gears
from cadgen.cli.page_commands import draw, edit, report
from cadgen.cli.study_commands import explore, merge
from cadgen.cli.verify import verify
from cadgen.errors import CadgenError, DesignError, brief
from cadgen.messages import LANGUAGES, Message, choose, shown
from cadgen.registry import fault_sentence
from cadgen.version import __version__

USAGE, FILE = 2, 3
_LAST_SECOND = 253402300799  # of the year 9999

# What somebody who has just installed cadgen may want, and the command for it.
_FIRST = (
    (Message("A cam by its motion, for any follower:"), "cadgen new my_cam --motion"),
    (Message("A steering cam for a car on a path of points:"), "cadgen new my_car --points points.csv"),
    (Message("Two gears in mesh:"), "cadgen pair --teeth 20,40 --module-mm 1 --width-mm 8 --out exports"),
    (Message("A packaged design, judged without making a file:"), "cadgen check roller"),
    (Message("What a word means:"), "cadgen explain play"),
)


@click.group(
    cls=help.Group,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    invoke_without_command=True,
    subcommand_metavar="COMMAND [ARGS]...",
)
@click.version_option(__version__, prog_name="cadgen", cls=help.Option, help="Show the version and exit.")
@click.pass_context
def cli(context: click.Context) -> None:
    """Cams and gears: from a motion, a course or numbers of teeth to files that are read back and proven.

    DESIGN is the name of a packaged design or a TOML file; without it the paper's car is used.
    """
    if context.invoked_subcommand is None:
        page = context.make_formatter()
        page.write_text(shown(Message("Begin with one of these; `cadgen --help` lists all commands.")))
        for meaning, line in _FIRST:
            page.write(f"\n{shown(meaning)}\n  {line}\n")
        click.echo(page.getvalue(), err=True, nl=False)
        context.exit(USAGE)


def _choose(_context: click.Context, _option: click.Parameter, language: str | None) -> None:
    if language is not None:
        choose(language)


language_option = help.Option(
    ["--lang"],
    type=click.Choice(LANGUAGES),
    help="Language of texts.  [default: the environment's]",
    expose_value=False,
    is_eager=True,
    callback=_choose,
)
cli.params.append(language_option)
# The commands in the order of work; `cadgen --help` lists them so.
cli.sections = {
    Message("Begin"): (new, plan, card),
    Message("Judge"): (check, optimize, simulate, tolerance),
    Message("Make"): (cam, gears, gear, pair, planetary, frame, draw, assembly),
    Message("Show and edit"): (report, edit),
    Message("Measure and correct"): (calibrate, adjust),
    Message("Explore thousands of designs"): (explore, merge),
    Message("Look up"): (verify, explain),
}
for commands in cli.sections.values():
    for command in commands:
        command.params.append(language_option)
        cli.add_command(command)


def main() -> NoReturn:
    """Run a command and turn every failure into one sentence and an exit code."""
    help.choose_language(sys.argv[1:])
    interrupt.install()
    output.tell_warnings()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # for terminals without µ
    code: int | str | None
    try:
        _require_epoch()
        code = cli.main(prog_name="cadgen", standalone_mode=False)
    except SystemExit as leave:
        code = leave.code
    except click.MissingParameter as error:
        said, asked = error.format_message().rstrip("."), error.ctx.command_path if error.ctx else "cadgen"
        code = _fail(Message("{fault}: {command} --help says what to give", fault=said, command=asked), error.exit_code)
    except click.ClickException as error:
        code = _fail(error.format_message(), error.exit_code)
    except CadgenError as error:
        code = _fail(error.message, error.exit_code)
    except OSError as error:
        code = _unwritable(error, 0)
    except MemoryError:
        code = _fail(Message("out of memory: close other programs, or use coarser tolerances in [export]"), FILE)
    except Exception as error:
        if os.environ.get("CADGEN_DEBUG"):
            traceback.print_exc()
        code = _fail(fault_sentence(error), FILE)
    try:  # while a failure can still be reported
        if sys.stdout:
            sys.stdout.flush()
    except OSError as error:
        code = _unwritable(error, code)
    interrupt.ignore()
    sys.exit(code)


def _require_epoch() -> None:
    """Refuse a damaged SOURCE_DATE_EPOCH, at which libraries would fail in ways of their own."""
    text = os.environ.get("SOURCE_DATE_EPOCH")
    if text is not None and not (text.isdecimal() and text.isascii() and int(text[:20]) <= _LAST_SECOND):
        raise DesignError(
            'SOURCE_DATE_EPOCH is "{value}"; it must be seconds since 1970, a whole number of at most {most}: correct '
            "or unset this environment variable",
            value=brief(text, 40),
            most=_LAST_SECOND,
        )


def _fail(message: str, code: int) -> int:
    arguments = sys.argv[1:]
    if "--json" in arguments:  # the same in every language
        print(json.dumps({"error": output.sentence(message, arguments), "exit_code": code}))
    else:
        output.tell(output.sentence(shown(message), arguments))
    return code


def _unwritable(error: OSError, code: int | str | None) -> int | str | None:
    """Stop printing; report the reason unless the reader of the output has closed it."""
    output.hush()
    if isinstance(error, BrokenPipeError):
        return code
    place = brief(str(error.filename)) if error.filename else Message("the output")
    text = Message(
        "{place} cannot be written ({reason}): make room, or choose another place",
        place=place,
        reason=Message(str(error.strerror)),
    )
    output.tell(shown(text))
    return FILE
