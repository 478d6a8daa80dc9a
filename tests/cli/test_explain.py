"""`cadgen explain`, the first screen, and the list of commands."""

import ast
import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

import cadgen as package
from cadgen import glossary
from cadgen.cam.followers import table as followers
from cadgen.car.against_play import profile_kinds
from cadgen.check import CheckCode
from cadgen.cli import _FIRST, cli
from cadgen.gears import stage_kinds
from cadgen.gears.choices import Order
from cadgen.gears.planetary_stage import PlanetaryCode
from cadgen.inference.measurement.verdict import Verdict
from cadgen.messages import shown
from tests.catalogue import templates
from tests.cli.conftest import one_sentence
from tests.docs.blocks import DOCS, blocks


@pytest.mark.parametrize("word", ["play", "Gates", "return error", "回程误差", "轮廓失真", "chord-tolerance"])
def test_a_word_is_found_in_both_languages_and_by_its_plural(cadgen, word):
    for language in ("en", "zh"):
        said = cadgen("--lang", language, "explain", *word.split(), code=0).stdout
        assert len(said.splitlines()) >= 2


def test_a_key_is_explained_with_what_it_must_be(cadgen):
    assert " ".join(cadgen("explain", "cam.thickness_mm", code=0).stdout.split()).startswith(
        "cam.thickness_mm C, between the disc's faces must be at least 0.1 and at most 100; unit mm"
    )
    assert "cutter_teeth" in cadgen("explain", "cutter_teeth", code=0).stdout


def test_a_key_of_several_kinds_is_explained_for_each_and_a_section_by_its_keys(cadgen):
    said = " ".join(cadgen("explain", "follower.radius_mm", code=0).stdout.split())
    assert "of the rod" in said
    assert "follower.radius_mm (roller) of the roller" in said
    assert "[layout]" in cadgen("explain", "layout", code=0).stdout
    assert "keys: clearance_mm" in " ".join(cadgen("explain", "layout", code=0).stdout.split())


@pytest.mark.parametrize(
    ("word", "said"),
    [("modified_sine", "motion law"), ("swinging roller", "follower"), ("closing blend", "last part of the turn")],
)
def test_codes_of_kinds_and_a_term_with_a_word_before_it_are_explained(cadgen, word, said):
    assert said in " ".join(cadgen("explain", word, code=0).stdout.split())


def test_effects_and_tolerances_are_explained_from_the_catalogue(cadgen):
    said = " ".join(cadgen("explain", "lost", "motion", "by", "friction", code=0).stdout.split())
    assert "(effect) by which the dial lags behind the rod" in said
    assert "told apart by: tap the lever" in said
    assert "(tolerance) half of the play" in " ".join(cadgen("explain", "steering lost motion", code=0).stdout.split())


@pytest.mark.parametrize("language", ["en", "zh"])
def test_codes_that_the_screens_show_are_terms(language):
    """Kinds of profile, orders of a train, verdicts on measured data."""
    codes = [*profile_kinds.codes(), *Order, *Verdict]
    assert len(codes) > 12
    plain = {"none", "runs disagree"}
    parts = {part for code in codes for part in code.split("+")} - plain
    assert not [code for code in parts if not glossary.find(code, language)]


CHECKS = {"en": "Checks", "zh": "检查项"}  # sections of the glossary


@cache
def named_checks() -> frozenset[str]:
    """Names of checks: every message beside a code of a check, in calls and in rows of tables."""
    found: set[str] = set()
    for file in Path(package.__file__).parent.rglob("*.py"):
        if "Code." not in (source := file.read_text("utf-8")):
            continue
        for node in ast.walk(ast.parse(source)):
            beside = node.args if isinstance(node, ast.Call) else node.elts if isinstance(node, ast.Tuple) else []
            for code, name in pairwise(beside):
                if isinstance(code, ast.Attribute) and re.fullmatch(r"\w*Code", getattr(code.value, "id", "")):
                    found.update(templates(ast.unparse(name)))
    return frozenset(found - {"{name}, with play", "{name}, heading, with play"})  # these hold another name


@pytest.mark.parametrize("language", ["en", "zh"])
def test_every_check_is_explained_by_its_code_and_by_its_name(language):
    """A new check has an entry in the section of the checks, in both languages."""
    fields = {"follower": "rod", "more": 0.1, "in_run": 3, "body": shown("motor", language), "state": "as cut"}
    names = sorted(named_checks())
    assert len(names) > 90
    asked = [*CheckCode, *PlanetaryCode, *(shown(name, language).format(**fields) for name in names)]
    assert not [
        word for word in asked if CHECKS[language] not in {term.section for term in glossary.find(word, language)}
    ]


@pytest.mark.parametrize("page", ["how-to/followers.md", "how-to/gear-kinds.md"])
def test_a_kind_of_ones_own_explains_its_checks(page):
    """Codes in the enumerations of the page's program are those that its kind explains, and `explain` says them."""
    program = ast.parse(max((block.text for block in blocks(DOCS / page) if block.language == "python"), key=len))
    nodes = list(ast.walk(program))
    codes = {
        line.value.value
        for node in nodes
        if isinstance(node, ast.ClassDef) and node.name.endswith("Code")
        for line in node.body
        if isinstance(line, ast.Assign)
    }
    (explains,) = (ast.literal_eval(node.value) for node in nodes if getattr(node, "arg", "") == "explains")
    assert codes == {code for code, _ in explains} != set()
    table = followers if "followers" in page else stage_kinds
    kind = replace(table.kind_of("roller" if table is followers else "rack"), code="own_kind", explains=explains)
    table.register(kind)
    try:
        for code, meaning in explains:
            said = " ".join(CliRunner().invoke(cli, ["explain", code]).output.split())
            assert said == f"{code} (own_kind) {meaning}"
    finally:
        table.remove(kind)


@pytest.mark.parametrize(
    ("asked", "name"),
    [
        ("Rod end beyond the rim", "rod end beyond the rim"),
        ("'rod-past-rim'", "rod end beyond the rim"),
        ("edges broken 0.25 mm more", "edges broken more"),
        ("nearest post, with play", "nearest post"),
        ("course-post-play", "nearest post"),
        ("second-thinnest-wall", "thinnest wall"),
        ("outer flank: largest cutter radius", "largest cutter radius"),
        ("drift of laps, 3, heading, with play", "drift of a lap"),
        ("hold each other", "teeth hold each other"),
    ],
)
def test_a_name_is_found_by_its_words_whatever_stands_about_them(asked, name):
    assert glossary.find(asked)[0].name.split(";")[0] == name


@pytest.mark.parametrize(
    "shown",
    [
        *(
            "base tangent",
            "blend return",
            "end of run",
            "free angle",
            "half width",
            "quintic",
            "thin",
            "whole train",
            "scatter",
            "slack",
            "stations",
            "cluster",
            "drag",
            "noise",
            "left out",
            "read back",
            "at lift",
        ),
        *("watertight", "tightest", "thinnest wall", "largest cutter radius", "wrong face carries", "rod pushed out"),
        *(
            "lift error on the blend",
            "convex radius, theory",
            "lost lift, crossing",
            "gates passed",
            "least margin of a gate",
        ),
        *(
            "distance from the waypoints, cut cam",
            "edge of the field, with play",
            "cars that keep the course",
            "rod end beyond the rim",
        ),
        *("bodies overlap", "teeth jam", "play - computed, as cut", "contact ratio - formula", "roller falls short"),
        *(
            "play in the groove, greatest",
            "edges broken 0.1 mm more",
            "least drive wheel",
            "steering zero",
            "start pose",
        ),
        *("state (VDI 2143)", "closure", "outer face", "h_aP, h_fP, rho_fP", "thickness E_sns / E_sni", "span W_k, mm"),
        *(
            "_arcs.dxf",
            "roller_actual_spline.dxf",
            "_train.step",
            "manifest.json",
            "hash",
            "conjugate pair",
            "VDI 2143",
        ),
        *("play along the line of action", "teeth spanned", "tip form diameter d_Fa", "reference diameter d", "rms"),
        *("ball diameter D_M", "root form diameter", "sun", "planet", "ring", "carrier", "keyway"),
    ],
)
def test_lines_of_the_first_screens_lead_to_a_term(shown):
    """As `check --all`, `cam`, `gears` and `calibrate` print them."""
    assert glossary.find(shown)


@pytest.mark.parametrize(
    ("shown", "term"),
    [("压力角，过渡段回程", "压力角"), ("升程损失，轮廓自交", "轮廓自交"), ("赛道门的最小余量", "余量")],
)
def test_a_line_in_chinese_leads_to_the_terms_in_it(shown, term):
    assert any(term in found.name for found in glossary.find(shown, "zh"))


def test_an_unknown_word_names_the_nearest(cadgen):
    assert "did you mean pressure angle" in one_sentence(cadgen("explain", "presure", "angle", code=2))


def test_the_pages_of_the_glossary_have_the_same_terms_in_the_same_order():
    english, chinese = (list(glossary.terms(language).values()) for language in ("en", "zh"))
    assert [(term.name, term.other_name) for term in english] == [(term.other_name, term.name) for term in chinese]
    assert all(re.search("[\u4e00-\u9fff].*。$", term.meaning) for term in chinese)


@pytest.mark.parametrize("words", [("pair",), ("--lang", "zh", "new")])
def test_what_was_left_out_leads_to_the_help_of_the_command(cadgen, words):
    said = one_sentence(cadgen(*words, code=2))
    assert f"cadgen {words[-1]} --help" in said
    assert ("--teeth" in said) == (words[-1] == "pair")


def test_every_command_stands_under_one_heading():
    listed = [command.name for commands in cli.sections.values() for command in commands]
    assert sorted(listed) == sorted(cli.commands)


def test_help_is_not_cut_on_a_narrow_terminal():
    said = CliRunner().invoke(cli, ["--help"], terminal_width=60).output
    assert "..." not in said.replace("[ARGS]...", "")
    assert max(map(len, said.splitlines())) <= 60
    assert said.index("\nBegin:") < said.index("\nJudge:") < said.index("\nMake:") < said.index("\nLook up:")


def test_without_arguments_the_first_screen_names_commands_that_there_are(cadgen):
    result = cadgen(code=2)
    assert result.stdout == ""
    assert len(result.stderr.splitlines()) <= 20
    for _, line in _FIRST:
        assert f"  {line}\n" in result.stderr
        assert line.split()[1] in cli.commands
