"""Words of the field: each with its name in the other language and what it means, from the pages of the glossary.

The pages are `docs/glossary.md` and `docs/glossary.zh-CN.md`; a wheel has them in its package.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache, cached_property
from pathlib import Path

from cadgen.messages import CHINESE, ENGLISH

# In the package of a wheel, beside it in a working copy.
_PLACES = tuple(folder / "docs" for folder in Path(__file__).parents[:2])
_PAGES = {ENGLISH: "glossary.md", CHINESE: "glossary.zh-CN.md"}
# Words that tell no terms apart.
_IDLE = {"a", "an", "the", "of", "mm", "µm", "um", "deg"}
_MOST_WHOLE = 6  # terms that a word is a part of, the shortest ones
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

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Spellings by which it is found, as `plain` makes them."""
        listed = [one for name in (self.name, self.other_name) for one in re.split("[；;]", name)]
        return tuple(map(plain, [*listed, *(re.sub(r"[（(].*?[）)]", "", one) for one in listed)]))


def plain(text: str) -> str:
    """Words of a text in small letters, singular, without articles, figures and units, a space between.

    Args:
        text: a term, the name of a check, or what somebody wrote.
    """
    words = re.findall(r"\w+", text.lower().replace("_", " "))
    single = (re.sub("ies$", "y", word).removesuffix("s") for word in words if word not in _IDLE)
    return " ".join(word for word in single if not word.isdigit())


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
            text = _LINK.sub(r"\1", " ".join(meaning.split())).replace("`", "").replace("*", "")
            found[name] = Term(name, other, text, section.partition("\n")[0])
    return found


def find(word: str, language: str = ENGLISH) -> list[Term]:
    """Terms that a word names, in either language: itself, one that it is a part of, or the longest that are in it.

    Args:
        word: such as `play`, `gates`, `回程误差`, `pressure`, `rod-past-rim` or `nearest post, with play`.
        language: language of the answer.

    Returns:
        The best matches, none where there is no such term.
    """
    wanted = plain(word)
    if not wanted:
        return []
    by_name: dict[str, list[Term]] = {}
    for term in terms(language).values():
        for name in term.names:
            by_name.setdefault(name, []).append(term)
    letters = not wanted.isascii()  # of a language that puts no spaces between words
    whole = [name for name in by_name if f" {wanted} " in f" {name} " or (letters and wanted in name)]
    parts = [name for name in by_name if len(name) > 1 and f" {name} " in f" {wanted} "]
    within = [name for name in by_name if len(name) > 1 and not name.isascii() and name in wanted]
    found = [wanted] if wanted in by_name else sorted(whole, key=len)[:_MOST_WHOLE] or _longest(parts or within)
    return list({term.name: term for name in found for term in by_name[name]}.values())


def _longest(names: list[str]) -> list[str]:
    """Names that are in no other one, the longest first."""
    alone = [name for name in names if not any(name != other and name in other for other in names)]
    return sorted(alone, key=len, reverse=True)


def nearest(word: str, language: str = ENGLISH) -> list[str]:
    """Names of terms that are spelt nearly like a word, up to three.

    Args:
        word: what somebody wrote.
        language: language of the names.
    """
    by_name = {name: term.name for term in terms(language).values() for name in term.names}
    return list(dict.fromkeys(by_name[name] for name in get_close_matches(plain(word), by_name, 3, 0.75)))
