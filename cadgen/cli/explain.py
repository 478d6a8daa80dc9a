"""`cadgen explain`: what a word of the field, or a key of the design file, means."""

from collections.abc import Iterator
from itertools import groupby

import click

from cadgen import glossary
from cadgen.cli import help
from cadgen.errors import DesignError, brief
from cadgen.messages import Message, joined, language, shown

_MOST_KEYS = 6  # of one name in several sections


@help.command()
@click.argument("words", nargs=-1, metavar="[TERM]...")
def explain(words: tuple[str, ...]) -> None:
    """Explain a word that cadgen uses, or a key of the design file.

    TERM is a word such as `play` or `return error`, in English or Chinese, or a key such as cam.thickness_mm. Without
    one all words are listed.
    """
    from cadgen.design.reference import named_keys, named_section

    word = " ".join(words).strip()
    if word:
        keys = named_keys(word)[:_MOST_KEYS]
        found = [] if keys and "." in word else glossary.find(word, language())  # a whole key is no term
        own = tuple(_checks_of_kinds(word)) if "-" in word else ()  # plug-ins are looked for in no other case
        entries = [
            *own,
            *((f"{term.name} ({term.other_name})", term.meaning, "") for term in found if not own),
            *(
                (f"{key.name} ({kind})" if kind else key.name, shown(Message(key.meaning)), shown(key.demand))
                for kind, key in keys
            ),
        ]
        entries += [*_kinds(word), *_deviations(word)]
        if (section := named_section(word.strip("[]"))) and section.name:
            takes = Message("keys: {names}", names=", ".join(section.names))
            entries.append((section.heading, shown(Message(section.meaning)), shown(takes)))
    else:
        sections = groupby(glossary.terms(language()).values(), lambda term: term.section)
        entries = [(title, ", ".join(term.name for term in found), "") for title, found in sections]
    if not entries:
        near = glossary.nearest(word, language())
        raise DesignError(
            '"{word}" is no term and no key: {hint}',
            word=brief(word, 40),
            hint=Message("did you mean {names}?", names=joined(near, Message(" or ")))
            if near
            else Message("cadgen explain lists all terms, docs/design-file.md all keys"),
        )
    page = click.get_current_context().make_formatter()
    for name, meaning, demand in entries:
        page.write(f"{name}\n")
        with page.indentation():
            for text in filter(None, (meaning, demand)):
                page.write_text(text)
    click.echo(page.getvalue(), nl=False)


def _kinds(word: str) -> Iterator[tuple[str, str, str]]:
    """Motion law and kind of follower of a code: heading, meaning, nothing."""
    from cadgen.cam.followers import table as followers
    from cadgen.laws import table as laws

    code = word.lower().replace(" ", "_").replace("-", "_")
    if laws.has(code):
        yield f"{code} ({shown(Message('motion law'))})", shown(Message(laws.law_of(code).meaning)), ""
    if followers.has(code):
        yield f"{code} ({shown(Message('follower'))})", shown(Message(followers.kind_of(code).meaning)), ""


def _checks_of_kinds(word: str) -> Iterator[tuple[str, str, str]]:
    """Check of a kind of follower or stage from outside, by the words of its code: heading, meaning, nothing."""
    from cadgen.cam.followers import table as followers
    from cadgen.gears import stage_kinds as stages

    for table in (followers, stages):
        for kind in map(table.kind_of, table.codes()):
            for code, meaning in kind.explains:
                if glossary.plain(code) == glossary.plain(word):
                    yield f"{code} ({kind.code})", shown(Message(meaning)), ""


def _deviations(word: str) -> Iterator[tuple[str, str, str]]:
    """Effects that data are traced to, and deviations that are varied: heading, meaning, what tells an effect apart."""
    from cadgen.deviations import catalogue
    from cadgen.deviations.deviation import VARIED

    wanted = glossary.plain(word)
    kinds = (catalogue.LIFT, catalogue.PROFILE, catalogue.TRANSMISSION, catalogue.TRACK, catalogue.ZONES)
    effects = {effect.name: effect for kind in kinds for effect in kind.entries}
    for each in VARIED:
        if each.zone and wanted in (glossary.plain(each.name), glossary.plain(shown(each.name))):
            yield f"{shown(each.name)} ({shown(Message('tolerance'))})", shown(Message(each.zone.meaning)), ""
    for effect in effects.values():
        if wanted in (glossary.plain(effect.name), glossary.plain(shown(effect.name))):
            meanings = joined((Message(number.meaning) for number in effect.parameters if number.meaning), "; ")
            how = Message("told apart by: {how}", how=Message(effect.separated_by)) if effect.separated_by else ""
            yield f"{shown(effect.name)} ({shown(Message('effect'))})", shown(meanings), shown(how)
