"""Chinese pages beside the English ones: what both must share, and a program that keeps it so.

    python -m docs.chinese

A page `NAME.zh-CN.md` has the blocks of `NAME.md` in their order, for commands and what they print are tested there;
only remarks in designs and beside commands are Chinese. Headings, rows of tables, code in the text and linked pages
are those of the English page; so are numbers. The program copies blocks that differ, leads links to the Chinese page
and its heading where there is one, and marks them 英文 where there is none. What only a translator can do it prints.
"""

import re
from collections.abc import Iterator
from itertools import zip_longest
from pathlib import Path

HERE = Path(__file__).parent
END = ".zh-CN.md"
_MARK = "（英文）"

_BLOCK = re.compile(r"^(?P<indent> *)```[^\n]*\n.*?^(?P=indent)```$", re.M | re.S)
# Numbers in figures; one that belongs to a word, such as that of 3D or ISO-8859, is a word's part.
_NUMBER = re.compile(r"(?<![A-Za-z0-9_.])\d+(?:\.\d+)?(?![A-Za-z0-9_])")
_LINK = re.compile(rf"(?<!!)\[(?P<text>(?:`[^`]*`|[^]])*)\]\((?P<place>[^)#:]+)(?P<anchor>#[^)]*)?\)(?P<mark>{_MARK})?")
_OTHER = ("[English](", "[中文](")  # the line below the title, which leads to the other language
# Written in Chinese and no translations: lists of what is there in Chinese, whose links alone are looked after.
_LISTS = {HERE / "index.md", HERE / "theory" / "index.md"}
# Its commands have Chinese names of designs and words; a test of its own holds their verbs.
_CHINESE_CODE = HERE.parent / "README.md"
# `cadgen explain` reads it, and tests of its own hold it to the English one.
_GLOSSARY = "glossary"
_PARTS = ("headings", "rows", "code", "links", "numbers")


def pairs() -> Iterator[tuple[Path, Path]]:
    """List each English page with the Chinese page beside it."""
    for chinese in [HERE.parent / f"README{END}", *sorted(HERE.rglob(f"*{END}"))]:
        english = chinese.with_name(chinese.name.removesuffix(END) + ".md")
        if english.stem != _GLOSSARY:
            yield english, chinese


def bare(block: str) -> str:
    """Block without the remarks of a design, or beside the lines of a plain text.

    Args:
        block: fenced block of a page.
    """
    first, *lines = block.splitlines()
    if first.strip() == "```toml":
        lines = [re.sub(r"\s*#(?! \w+\.toml$).*", "", line) for line in lines]
    elif first.strip() == "```text":
        lines = [re.sub(r"(?<=\S)(\s{2,}|\s*# ).*|^# .*", "", line) for line in lines]
    return "\n".join(line for line in [first, *lines] if line.strip())


def differences(english: Path, chinese: Path) -> list[str]:
    """List what a Chinese page lacks of the English one or has besides, one entry a fault.

    Args:
        english: page in English.
        chinese: page beside it.
    """
    one, other = (page.read_text(encoding="utf-8") for page in (english, chinese))
    found = [] if mended(english, chinese) == other else [f"{chinese.name}: run python -m docs.chinese"]
    if english in _LISTS:
        return found
    for part, there, here in zip_longest(_PARTS, _shared(one), _shared(other)):
        if there != here and not (part == "code" and english == _CHINESE_CODE):
            lacking, more = sorted(set(there) - set(here)), sorted(set(here) - set(there))
            found.append(
                f"{chinese.name}: {part}: lacks {lacking}, has {more}" + ("" if lacking or more else ", moved")
            )
    return found


def _shared(text: str) -> Iterator[list[str]]:
    """Parts that two languages of a page share: headings and rows of tables counted, code, linked pages, numbers."""
    prose = _BLOCK.sub("", text)
    yield [f"{number} {level}" for number, level in enumerate(re.findall(r"^#+(?= )", prose, re.M), 1)]
    yield [f"row {number}" for number, _ in enumerate(re.findall(r"^\|", prose, re.M), 1)]
    yield sorted(set(re.findall(r"`([^`\n]+)`", prose)))
    lines = "\n".join(line for line in prose.splitlines() if not line.startswith(_OTHER))
    yield sorted({place.replace(END, ".md") for place in re.findall(r"\]\(([^)#]+)", lines)})
    yield sorted(set(_NUMBER.findall(re.sub(r"\]\([^)]*\)|`[^`\n]*`", " ", prose))))


def mended(english: Path, chinese: Path) -> str:
    """Text of a Chinese page with the blocks of the English one, and with links to Chinese pages.

    Args:
        english: page in English.
        chinese: page beside it.
    """
    text = chinese.read_text(encoding="utf-8")
    there = [match[0] for match in _BLOCK.finditer(english.read_text(encoding="utf-8"))]
    here = [match[0] for match in _BLOCK.finditer(text)]
    if english not in _LISTS:
        here = [one if bare(one) == bare(other) else other for one, other in zip(here, there, strict=False)] + [
            f"\n{block}\n" for block in there[len(here) :]
        ]
    parts = _BLOCK.sub("\0", text).split("\0")
    prose = [_LINK.sub(lambda match: _link(match, chinese.parent), part) for part in parts]
    return "".join(part + block for part, block in zip_longest(prose, here, fillvalue=""))


def _link(match: re.Match[str], folder: Path) -> str:
    place, anchor = match["place"], match["anchor"] or ""
    if match[0].startswith(_OTHER) or not place.endswith(".md"):
        return match[0]
    english = place.replace(END, ".md")
    translated = english.removesuffix(".md") + END
    there = translated if (folder / translated).is_file() else english
    if there != place and anchor:
        anchor = dict(zip(_anchors(folder / english), _anchors(folder / there), strict=False)).get(anchor, "")
    return f"[{match['text']}]({there}{anchor}){'' if there == translated else _MARK}"


def _anchors(page: Path) -> list[str]:
    """Names of the places within a page, by its headings in their order, which is that of both languages."""
    headings = re.findall(r"^#+ (.*)", _BLOCK.sub("", page.read_text(encoding="utf-8")), re.M)
    return ["#" + re.sub(r"[^\w\s-]", "", heading.lower()).replace(" ", "-") for heading in headings]


def main() -> None:
    """Mend every Chinese page, and say what a hand must do."""
    for english, chinese in pairs():
        chinese.write_text(mended(english, chinese), encoding="utf-8")
        for fault in differences(english, chinese):
            print(fault)


if __name__ == "__main__":
    main()
