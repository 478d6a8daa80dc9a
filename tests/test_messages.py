"""Messages and pages in two languages: no template lacks a translation or loses an argument, no page its commands."""

import ast
import pickle
import re
from pathlib import Path

import pytest

from cadgen.errors import DesignError
from cadgen.messages import CHINESE, Message, catalogue, joined, language_of, translate
from docs import chinese
from tests.catalogue import CLICK, OF_SCRIPTS, PACKAGE, compiled, entries, fields, home, used

DOCS = chinese.HERE


def test_a_message_is_its_english_text():
    message = Message("a {thing} of {size:.1f} mm", thing="rod", size=2.5)
    assert message == "a rod of 2.5 mm"
    assert (message.template, message.arguments["thing"]) == ("a {thing} of {size:.1f} mm", "rod")
    assert Message(message) is message
    assert Message("{} stays") == "{} stays"


def test_errors_take_a_template_and_its_arguments():
    error = DesignError("{key} is {value:g}", key="cam.blend_deg", value=3.0)
    assert str(error) == "cam.blend_deg is 3"
    assert pickle.loads(pickle.dumps(error)).message.template == "{key} is {value:g}"
    assert str(DesignError("left {as it is")) == "left {as it is"


def test_a_message_in_chinese(monkeypatch):
    known = {"{part} and {angle:.1f}°": "{angle:.1f}°，{part}", "bore": "轴孔", ", ": "、"}
    monkeypatch.setattr("cadgen.messages._catalogue", lambda language: known)
    message = Message("{part} and {angle:.1f}°", part=Message("bore"), angle=3.14)
    assert translate(message, CHINESE) == "3.1°，轴孔"
    assert translate(message, "en") == "bore and 3.1°"
    both = joined([message, Message("bore"), "m6"])
    assert both == "bore and 3.1°, bore, m6"
    assert translate(both, CHINESE) == "3.1°，轴孔、轴孔、m6"
    assert translate(pickle.loads(pickle.dumps(both)), CHINESE) == "3.1°，轴孔、轴孔、m6"
    assert translate(7, CHINESE) == 7


@pytest.mark.parametrize(
    ("environment", "code"),
    [
        ({}, "en"),
        ({"LANG": "zh_CN.UTF-8"}, "zh"),
        ({"LANG": "zh_CN.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANGUAGE": "zh_TW:en", "LANG": "de_DE"}, "zh"),
        ({"LANG": "fr_FR"}, "en"),
    ],
)
def test_the_environment_states_the_language(environment, code):
    assert language_of(environment) == code


def test_every_text_has_its_chinese():
    known = {entry.msgid for entry in entries(CHINESE) if entry.msgstr}
    missing = {template: file for template, file in used().items() if template not in known}
    assert not missing, f"run: python -m tests.catalogue {CHINESE}\n{missing}"


def checks_texts(source):
    """Names, places and advice of the checks that a module makes, as expressions; both of a choice."""
    for call in ast.walk(ast.parse(source)):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "Check":
            named = (key.value for key in call.keywords if key.arg in ("name", "place", "advice"))
            for text in (*call.args[1:2], *call.args[6:], *named):
                yield from (text.body, text.orelse) if isinstance(text, ast.IfExp) else (text,)


def is_plain(text):
    return isinstance(text, ast.JoinedStr) or (isinstance(text, ast.Constant) and text.value != "")


def test_texts_of_checks_are_messages():
    made = 'Check(code, "name", 1.0, "mm", 2.0, Bound.MAX, f"at {x}" if x else "", advice=Message("turn it"))'
    assert [is_plain(text) for text in checks_texts(made)] == [True, True, False, False]
    plain = {
        f"{file.relative_to(PACKAGE)}:{text.lineno}"
        for file in PACKAGE.rglob("*.py")
        if "Check(" in (source := file.read_text("utf-8"))
        for text in checks_texts(source)
        if is_plain(text)
    }
    assert not plain


def test_each_text_stands_in_the_catalogue_of_its_folder():
    said = used()
    elsewhere = {
        text: home(said[text])
        for file in (PACKAGE / "locale" / CHINESE).glob("*.po")
        if file.stem not in OF_SCRIPTS
        for text in catalogue(CHINESE, file.stem)
        if text in said and home(said[text]) != file.stem
    }
    assert not elsewhere, f"run: python -m tests.catalogue sort {CHINESE}\n{elsewhere}"


def test_the_words_of_the_pages_scripts_are_those_of_their_catalogue():
    sources = [file.read_text("utf-8") for file in (PACKAGE.parent / "page" / "src").rglob("*.js")]
    found = {word for source in sources for word in re.findall(r'\bboth\("([^"]+)"', source)}
    own, common = (set(catalogue(CHINESE, name)) for name in ("script", "common"))
    assert own == found - common
    chinese = {word for source in sources for word in re.findall(r"[\u4e00-\u9fff：]+", source)}
    assert chinese == {"中文", "中文：切换到中文"}  # of the button that changes the language


def test_translations_keep_the_arguments_of_their_texts():
    wrong = [entry.msgid for entry in entries(CHINESE) if fields(entry.msgid) != fields(entry.msgstr)]
    assert not wrong


def test_no_text_is_translated_in_two_ways():
    seen: dict[str, str] = {}
    twice = [e.msgid for e in entries(CHINESE) if seen.setdefault(e.msgid, e.msgstr) != e.msgstr]
    assert not twice


def test_click_speaks_by_the_catalogue_beside_it():
    assert CLICK.with_suffix(".mo").read_bytes() == compiled(), "run: python -m tests.catalogue click"


@pytest.mark.parametrize("page", list(chinese.pairs()), ids=lambda page: page[1].name)
def test_a_chinese_page_has_the_commands_code_and_links_of_the_english_one(page: tuple[Path, Path]) -> None:
    english, translated = page
    lacking = chinese.differences(english, translated)
    assert not lacking, f"run python -m docs.chinese, which mends blocks and links and says what else lacks: {lacking}"
    text = translated.read_text(encoding="utf-8")
    assert f"[English]({english.name})" in text
    assert f"[中文]({translated.name})" in english.read_text(encoding="utf-8")
    links = re.findall(r"\]\((?!https:)([^)#:]+)", re.sub(r"`[^`\n]+`", "", text))
    assert not [link for link in links if not (translated.parent / link).exists()]
    terms = {_anchor(term) for term in re.findall(r"^### (.*)", (DOCS / "glossary.zh-CN.md").read_text("utf-8"), re.M)}
    assert set(re.findall(r"glossary\.zh-CN\.md#([^)]+)", text)) <= terms


def _anchor(heading: str) -> str:
    return re.sub(r"[^\w\s-]", "", heading.lower()).replace(" ", "-")


def test_every_chinese_page_is_listed() -> None:
    listed = set(re.findall(r"^(\S+\.zh-CN)$", (DOCS / "index.zh-CN.md").read_text(encoding="utf-8"), re.M))
    found = {str(page.relative_to(DOCS)).removesuffix(".md") for page in DOCS.rglob(f"*{chinese.END}")}
    assert listed == found - {"index.zh-CN"}


def test_a_page_that_its_translator_forgot_is_told(tmp_path: Path) -> None:
    english, translated = tmp_path / "page.md", tmp_path / "page.zh-CN.md"
    block = "```toml\n# a.toml\n[cam]  # a disc\n```\n\n```console\n$ cadgen check a.toml\nREADY\n```"
    english.write_text(f"# A\n\n[中文](page.zh-CN.md)\n\n{block}\n\nSee `[cam]` and [b](b.md#c-d), 2.5 mm in 3D.\n")
    translated.write_text(
        "# 甲\n\n[English](page.md)\n\n```toml\n# a.toml\n[cam]  # 盘\n```\n\n见 [b](b.md#c-d)，三维中 25 mm。\n"
    )
    mended = chinese.mended(english, translated)
    assert "# 盘" in mended
    assert "$ cadgen check a.toml\nREADY" in mended
    assert "[b](b.md#c-d)（英文）" in mended
    translated.write_text(mended)
    assert chinese.differences(english, translated) == [
        "page.zh-CN.md: code: lacks ['[cam]'], has []",
        "page.zh-CN.md: numbers: lacks ['2.5'], has ['25']",
    ]
    (tmp_path / "b.md").write_text("# B\n\n## C d\n")
    (tmp_path / "b.zh-CN.md").write_text("# 乙\n\n## 丙 丁\n")
    mended = chinese.mended(english, translated)
    assert "[b](b.zh-CN.md#丙-丁)，" in mended
    translated.write_text(mended)
    (tmp_path / "b.zh-CN.md").unlink()
    assert "[b](b.md)（英文），" in chinese.mended(english, translated)
    english.write_text(english.read_text().replace("READY", "NOT READY"))
    assert "NOT READY" in chinese.mended(english, translated)
