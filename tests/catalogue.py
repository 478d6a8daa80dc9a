"""Texts of the package and what each language lacks: `python -m tests.catalogue zh` prints entries to be filled in.

`python -m tests.catalogue sort zh` moves each entry to the catalogue of the folder whose modules say its text, as
`home` gives it. `python -m tests.catalogue click` compiles the translations of click's own words.
"""

import ast
import re
import sys
from collections.abc import Iterator
from functools import cache
from inspect import cleandoc
from pathlib import Path
from string import Formatter

import polib

from cadgen.messages import Message
from docs.public_names import first_line, names

PACKAGE = Path(__file__).parents[1] / "cadgen"


OF_SCRIPTS = ("common", "script")  # catalogues that the page's scripts have, too
CLICK = PACKAGE / "locale" / "zh" / "LC_MESSAGES" / "click.po"
# Calls whose first argument is shown to people, with arguments or without.
_TEXTS = {"Message", "progress", "CadgenError", "CheckError", "DesignError", "FileError"}


def is_text(call: ast.Call) -> bool:
    """Whether a call makes a text for people: `Message("...")`, a step of a job, or an error of the package."""
    name = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
    return name in _TEXTS or (name.endswith("Error") and any(key.arg for key in call.keywords))


def templates(source: str) -> Iterator[str]:
    """Templates of the messages that a module makes."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and node.args and is_text(node):
            for inner in ast.walk(node.args[0]) if isinstance(node.args[0], ast.IfExp) else [node.args[0]]:
                if isinstance(inner, ast.Constant) and isinstance(inner.value, str):
                    yield inner.value


@cache
def used() -> dict[str, str]:
    """Every template of the package, with a file that has it; those of the page's HTML among them."""
    found = [(file, templates(file.read_text("utf-8"))) for file in sorted(PACKAGE.rglob("*.py"))]
    found += [(PACKAGE / room, texts) for room, texts in (("cli", help_texts()), ("design", meanings()))]
    found += [(PACKAGE / "deviations", effect_texts()), (PACKAGE / "inference", data_texts())]
    found += [(PACKAGE / "laws", law_texts()), (PACKAGE / "api", (first_line(thing) for _, thing in names()))]
    found += [
        (file, re.findall(r'\b_\("([^"]+)"\)', file.read_text("utf-8"))) for file in sorted(PACKAGE.rglob("*.html"))
    ]
    first: dict[str, str] = {}
    for file, texts in found:
        for template in texts:
            first.setdefault(template, str(file.relative_to(PACKAGE)))
    return first


def home(file: str) -> str:
    """Name of the catalogue of a module's texts: its folder, or `cadgen` of a module that stands in none."""
    return file.partition("/")[0] if "/" in file or "." not in file else "cadgen"


def help_texts() -> Iterator[str]:
    """Help of every command and option."""
    from cadgen.cli import cli

    for command in (cli, *cli.commands.values()):
        yield cleandoc(command.help)
        for option in command.params:
            if meaning := getattr(option, "meaning", ""):  # arguments have none
                yield from templates_in(meaning)


def meanings() -> Iterator[str]:
    """Meanings of the sections and keys of a design file, of every kind of design."""
    from cadgen.design.keys import tables
    from cadgen.design.reference import every_kind

    for kind in every_kind().values():
        for section in tables(kind).values():
            yield from filter(None, [section.meaning if section.name else "", *(key.meaning for key in section.keys)])


def effect_texts() -> Iterator[str]:
    """Names of effects and deviations, their meanings, and what tells them apart."""
    from cadgen.deviations import catalogue, deviation
    from cadgen.deviations.track import track_forms
    from cadgen.deviations.transmission import train_orders
    from cadgen.inference.measurement.shapes import bump, harmonic, sector, step

    shapes = (harmonic(2, "um"), bump(0, 2, "um"), sector(0, 30, "um"), step(0, 0.0, "um"))
    kinds = (catalogue.LIFT, catalogue.PROFILE, catalogue.TRANSMISSION, catalogue.TRACK, catalogue.ZONES)
    found = [effect for kind in kinds for effect in kind.entries]
    for effect in (*found, *track_forms(), *train_orders((3.0, 3.0), (60, 60), 1000), *shapes):
        texts = (effect.name, effect.sort, effect.confused_with, effect.separated_by, *effect.twins)
        texts += tuple(parameter.meaning for parameter in effect.parameters)
        for text in filter(None, texts):
            yield from templates_in(text)
    for each in deviation.VARIED:
        yield from (each.name, str(each).replace("_", " "))


def law_texts() -> Iterator[str]:
    """Meanings of the motion laws, which `cadgen explain` prints, and their names on sheets."""
    from cadgen.laws.power_laws import POWER_LAWS
    from cadgen.laws.scca import SCCA
    from cadgen.laws.sine_laws import SINE_LAWS
    from cadgen.laws.valve_lobe import VALVE_LOBE

    for law in (*POWER_LAWS, *SINE_LAWS, *SCCA, VALVE_LOBE):
        yield from (law.meaning, law.name)
    yield "polynomial"  # by conditions, made for its segment


def data_texts() -> Iterator[str]:
    """Verdicts on measured data, and the freedoms of each run that are fitted and never claimed."""
    from cadgen.inference.measurement import kinds
    from cadgen.inference.measurement.verdict import Verdict

    yield from map(str, Verdict)
    for code in kinds.codes():
        datum = kinds.kind_of(code).datum
        yield from filter(None, (datum.words, datum.name))


def templates_in(text: str) -> Iterator[str]:
    """Templates of a message and of those among its arguments; a plain text is its own."""
    if not isinstance(text, Message):
        yield text
        return
    yield from [] if hasattr(text, "parts") else [text.template]
    for inner in (*getattr(text, "parts", ()), *text.arguments.values()):
        if isinstance(inner, Message):
            yield from templates_in(inner)


def entries(language: str) -> list[polib.POEntry]:
    """All entries of a language's catalogues."""
    files = sorted((PACKAGE / "locale" / language).glob("*.po"))
    return [entry for file in files for entry in polib.pofile(str(file))]


def fields(template: str) -> set[str]:
    """Names of the fields of a template."""
    return {name for _, name, _, _ in Formatter().parse(template) if name is not None}


def compiled() -> bytes:
    """Translations of click's own words as gettext reads them."""
    return bytes(polib.pofile(str(CLICK)).to_binary())


def sort(language: str) -> None:
    """Move each entry to its home, in the order of the modules; a text that no module says as a whole stays."""
    folder, said = PACKAGE / "locale" / language, used()
    place = {text: number for number, text in enumerate(said)}
    sorted_out: dict[str, list[polib.POEntry]] = {}
    for file in sorted(folder.glob("*.po")):
        for entry in polib.pofile(str(file)):
            stays = file.stem in OF_SCRIPTS or entry.msgid not in said
            sorted_out.setdefault(file.stem if stays else home(said[entry.msgid]), []).append(entry)
    for name, found in sorted_out.items():
        catalogue = polib.POFile(wrapwidth=120)
        catalogue.metadata = {"Language": language, "Content-Type": "text/plain; charset=UTF-8"}
        catalogue.extend(sorted(found, key=lambda entry: place.get(entry.msgid, len(place))))
        catalogue.save(str(folder / f"{name}.po"))


if sys.argv[1:] == ["click"]:
    CLICK.with_suffix(".mo").write_bytes(compiled())
elif sys.argv[1:2] == ["sort"]:
    sort(sys.argv[2])
elif __name__ == "__main__":
    known = {entry.msgid for entry in entries(sys.argv[1])}
    for template, file in used().items():
        if template not in known and (not sys.argv[2:] or file.startswith(sys.argv[2])):
            print(f"# {file}: belongs into {home(file)}.po\n{polib.POEntry(msgid=template)}")
