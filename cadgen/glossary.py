"""Words of the field: each with its name in the other language and what it means, from the pages of the glossary.

The pages are `docs/glossary.md` and `docs/glossary.zh-CN.md`; a wheel has them in its package.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from cadgen.messages import CHINESE, ENGLISH

# In the package of a wheel, beside it in a working copy.
_PLACES = tuple(folder / "docs" for folder in Path(__file__).parents[:2])
_PAGES = {ENGLISH: "glossary.md", CHINESE: "glossary.zh-CN.md"}
_LINK = re.compile(r"\[([^]]+)\]\([^)]*\)")


@dataclass(frozen=True)
class Term:
    """Word of the field in one language.

    Attributes:
        name: the word.
        other_name: the word in the other language.
        meaning: what it means here, one or more sentences.
        section: heading that it stands under.
    """

    name: str
    other_name: str
    meaning: str
    section: str

    @property
    def names(self) -> Iterator[str]:
        """Spellings by which it is found, in small letters."""
        for name in (self.name, self.other_name):
            for one in re.split("[；;]", name):
                yield one.strip().lower()
                yield re.sub(r"[（(].*?[）)]", "", one).strip().lower()


@cache
def terms(language: str = ENGLISH) -> Mapping[str, Term]:
    """All words of the field, in the order of the glossary.

    Args:
        language: code of the language, such as `zh`; others than the two of the pages are taken for English.
    """
    page = _PAGES.get(language, _PAGES[ENGLISH])
    text = next(file for place in _PLACES if (file := place / page).is_file()).read_text(encoding="utf-8")
    found: dict[str, Term] = {}
    for part in text.split("\n## ")[1:]:
        section, *entries = part.split("\n### ")
        for entry in entries:
            name, _, body = entry.partition("\n")
            other, _, meaning = body.partition(" · ")
            plain = _LINK.sub(r"\1", " ".join(meaning.split())).replace("`", "").replace("*", "")
            found[name] = Term(name, other, plain, section.strip())
    return found


def find(word: str, language: str = ENGLISH) -> list[Term]:
    """Terms that a word names, in either language: itself, or by words that both share, last ones first.

    Args:
        word: such as `play`, `gates`, `回程误差`, `pressure`, `closing blend` or `lost lift, crossing`.
        language: language of the answer.

    Returns:
        The best matches, none where there is no such term.
    """
    wanted = " ".join(re.sub("[,_-]", " ", word.lower()).split())
    singular = " ".join(part.removesuffix("s") for part in wanted.split())
    named = [(term, [re.sub("[_-]", " ", name) for name in term.names]) for term in terms(language).values()]
    for same in (
        lambda name: name in (wanted, wanted.removesuffix("s")),
        lambda name: f" {wanted} " in f" {name} ",
        lambda name: len(name) > 1 and wanted.endswith(f" {name}"),
        lambda name: len(name) > 1 and f" {name} " in f" {wanted} {singular} ",
        lambda name: not name.isascii() and len(name) > 1 and name in wanted,
    ):
        if found := [term for term, names in named if any(map(same, names))]:
            return found
    return []


def nearest(word: str, language: str = ENGLISH) -> list[str]:
    """Names of terms that are spelt nearly like a word, up to three.

    Args:
        word: what somebody wrote.
        language: language of the names.
    """
    by_name = {name: term.name for term in terms(language).values() for name in term.names}
    return list(dict.fromkeys(by_name[name] for name in get_close_matches(word.lower(), by_name, 3, 0.75)))
