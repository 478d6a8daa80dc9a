"""The documentation does what it says: its commands print what it shows, its designs load, its words are explained."""

import inspect
import json
import re
import tomllib
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from pkgutil import iter_modules

import pytest
import tomli_w

import cadgen
from cadgen.cam.followers import table as followers
from cadgen.cli import cli
from cadgen.design.load import complete_of, load_design, load_train
from cadgen.laws import table as laws
from cadgen.messages import CHINESE, LANGUAGES
from cadgen.studies.study_file import read_study
from docs import make_notebooks
from tests.docs.blocks import DOCS, INSTALL, ROOT, STUDIES, Block, Workshop, blocks, pages, same
from tests.forks import MAIN

PAGES = {str(page.relative_to(ROOT)): page for page in pages()}
FENCES = [block for page in PAGES.values() for block in blocks(page)]
# Blocks of Python by themselves; the cells of a notebook follow one another.
ALONE = [block for block in FENCES if block.language == "python" and not block.page.startswith("docs/notebooks/")]
TUTORIAL = DOCS / "tutorial.md"
# Blocks in these languages are shown and not run: directives of the site, and text that no command prints.
SHOWN = {"text", "bibtex", ""}


@pytest.fixture
def workshop(forks, tmp_path):
    """A folder with the files that the pages speak of."""

    def cadgen(arguments: list[str], folder: Path) -> tuple[int, str]:
        done = forks.run(MAIN, *arguments, cwd=folder, env={"COLUMNS": "80"})
        return done.returncode, done.stdout + done.stderr

    return Workshop.at(tmp_path, cadgen)


@pytest.mark.slow
@pytest.mark.long
def test_the_pages_do_what_they_say(workshop, tmp_path) -> None:
    """Commands print what is shown, the second cam brings the car home, the pictures are those of these files.

    One test, for all of it needs the files of the tutorial.
    """
    assert workshop.run(TUTORIAL) >= 5
    for page in PAGES.values():
        workshop.run(page)
    assert_the_second_cam_brings_the_real_car_home(workshop.folder)
    assert_pictures_are_up_to_date(workshop.folder)
    assert_the_manifest_has_the_keys_of_its_page(workshop.folder / "exports/manifest.json")


def assert_the_second_cam_brings_the_real_car_home(folder: Path) -> None:
    """The car is driven by the tests' generator, with the outlines that the commands wrote."""
    from docs.make_pictures import ends

    stop = json.loads((folder / "exports/manifest.json").read_text())["parts"]["first_car_optimized"]["as_built"][
        "stop"
    ]
    before, after = ends(folder, (348.0, stop["cam_angle_deg"]))
    print(f"the real car ends {before:.1f} mm off with the first cam, {after:.2f} mm with the second")
    text = TUTORIAL.read_text(encoding="utf-8")
    assert f"**{before:.0f} mm**" in text
    assert f"{stop['cam_angle_deg']:.2f}°" in text
    assert after < 1.0


def assert_pictures_are_up_to_date(folder: Path) -> None:
    """Each curve that the script draws is where it is in the repository's picture, within a pixel."""
    from docs.make_pictures import NAMES, PICTURES, save

    save(folder, folder / "drawn")
    assert sorted(file.stem for file in (folder / "drawn").iterdir()) == sorted(NAMES)
    for name in NAMES:
        drawn, kept = (curves((at / f"{name}.svg").read_text(encoding="utf-8")) for at in (folder / "drawn", PICTURES))
        assert drawn
        assert drawn.keys() == kept.keys(), "run: python -m docs.make_pictures"
        for curve, points in kept.items():
            assert drawn[curve] == pytest.approx(points, abs=1.0), "run: python -m docs.make_pictures"


def assert_the_manifest_has_the_keys_of_its_page(file: Path) -> None:
    """Cams of the tutorial, their files, their play and what was built, key by key in both directions."""
    parts = json.loads(file.read_text(encoding="utf-8"))["parts"]
    cams = [parts["first_car_actual"], parts["first_car_optimized"]]
    page = (DOCS / "reference/manifest.md").read_text(encoding="utf-8")
    shown = [re.findall(r"^\| (`.*?) \|", section, re.M) for section in page.split("\n## ")[1:5]]
    levels = [
        cams,
        [entry for cam in cams for entry in cam["files"].values()],
        [cams[1]["play"]],
        [cams[1]["as_built"]],
    ]
    for rows, level in zip(shown, levels, strict=True):
        assert {key for row in rows for key in re.findall(r"`(\w+)`", row)} == {key for entry in level for key in entry}


def curves(svg: str) -> dict[str, list[float]]:
    """Points of the curves that the script names."""
    found = re.findall(r'<g id="(curve-[\w-]+)">\s*<path d="([^"]*)"', svg)
    return {name: [float(number) for number in re.findall(r"-?[\d.]+", path)] for name, path in found}


@pytest.mark.slow
@pytest.mark.long
def test_dear_commands_print_what_the_pages_show(workshop) -> None:
    assert sum(workshop.run(page, slow=True) for page in PAGES.values()) >= 3


def test_what_is_shown_is_compared() -> None:
    assert same("a  b\n...\nc", "a b\nx\ny\nc\n")
    assert same("a ...d", "\na b\nc d  \n")
    assert not same("a b", "ab")
    assert not same("a b", "a b c")
    assert not same("a\n...", "b\na\n")


@pytest.mark.parametrize("block", FENCES, ids=lambda block: f"{block.page}:{block.line}")
def test_blocks_have_a_language_that_is_run(block: Block) -> None:
    language = block.language
    assert language in {"console", "sh", "toml", "python", *SHOWN} or language.startswith("{")
    # A command without output or a design must not hide as text.
    if language in SHOWN:
        assert "$ cadgen" not in block.text


@pytest.mark.parametrize(
    "block", [block for block in FENCES if block.language == "toml"], ids=lambda block: f"{block.page}:{block.line}"
)
def test_designs_load(block: Block, tmp_path: Path) -> None:
    tables, design = tomllib.loads(block.text), tmp_path / "shown.toml"
    if "objectives" in tables:  # a study, and no design
        design.write_text(block.text, encoding="utf-8")
        read_study(design)
        return
    if "motion" in tables:
        assert complete_of(block.text, design).motion
        return
    whole = tomllib.loads((DOCS / "tutorial/first_car.toml").read_text(encoding="utf-8"))
    alone = "path" in tables or "train" in tables
    # A part of a design is put into the tutorial's.
    design.write_text(block.text if alone else tomli_w.dumps(whole | tables), encoding="utf-8")
    (load_train if "path" not in tables and "train" in tables else load_design)(design)


@pytest.mark.slow
@pytest.mark.parametrize("block", [pytest.param(block, id=f"{block.page}:{block.line}") for block in ALONE])
def test_python_runs(block: Block, forks, tmp_path: Path) -> None:
    done = forks.run(block.text, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    # What it prints stands behind its prints, as `print(...)  # 3.7`.
    shown = re.findall(r"^print\(.*\)  # (.*)$", block.text, re.M)
    assert done.stdout.splitlines() == shown


@pytest.mark.slow
@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=[pytest.mark.long] if page.stem in ("calibrate", "play") else [], id=page.stem)
        for page in make_notebooks.pages()
    ],
)
def test_notebooks_print_what_they_show_and_end_with_a_picture(page: Path) -> None:
    printed, shown = make_notebooks.run(page)
    text = page.read_text(encoding="utf-8")
    assert make_notebooks.with_outputs(page, printed) == text, "run: python -m docs.make_notebooks"
    file = page.with_suffix(".ipynb").read_text(encoding="utf-8")
    assert make_notebooks.notebook(page) == file, "run: python -m docs.make_notebooks"
    assert (shown.plot() if hasattr(shown, "plot") else shown).axes
    assert f"](../pictures/notebooks/{page.stem}.png)" in text


def test_there_are_six_notebooks() -> None:
    assert {page.stem for page in make_notebooks.pages()} == {"cam", "gears", "motion", "play", "calibrate", "sweep"}


def test_commands_in_the_text_exist() -> None:
    found = 0
    for name, page in PAGES.items():
        for line in re.findall(r"`(cadgen [a-z][^`]*)`", page.read_text(encoding="utf-8")):
            words = re.split(r"\s+", line)[1:]
            assert words[0] in cli.commands, f"{name}: `{line}`"
            options = {option for o in cli.commands[words[0]].params for option in o.opts}
            for word in words:
                assert not word.startswith("--") or word.split("=")[0] in options, f"{name}: `{line}`"
            found += 1
    assert found > 40


def test_commands_in_blocks_that_are_not_run_exist() -> None:
    """In a block of plain text a command may stand with remarks beside it; verbs and options must be there."""
    found = 0
    for block in FENCES:
        for verb, rest in re.findall(r"\bcadgen ([a-z]+)((?: \S+)*)", block.text if block.language == "text" else ""):
            assert verb in cli.commands, f"{block.page}:{block.line}: {verb}"
            options = {option for o in cli.commands[verb].params for option in o.opts}
            for option in re.findall(r"(?<!\S)(--[\w-]+)", rest):
                assert option in options, f"{block.page}:{block.line}: {verb} {option}"
            found += 1
    assert found > 15


def test_the_version_to_cite_is_that_of_the_package() -> None:
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\nversion: {cadgen.__version__}\n" in citation
    (day,) = re.findall(r"^date-released: (\S+)$", citation, re.M)
    assert f"\n## {cadgen.__version__} ({day})\n" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_the_distribution_is_not_the_strangers_of_the_same_name() -> None:
    """The public index has another project called cadgen, with the same import."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["name"] == "cadgen-cams"
    assert list(project["scripts"]) == ["cadgen"]
    groups = [project["dependencies"], *project["optional-dependencies"].values()]
    ours = {
        re.split(r"[\[<>=~! ]", requirement)[0]
        for group in groups
        for requirement in group
        if requirement.startswith("cadgen")
    }
    assert ours == {"cadgen-cams"}
    assert "`cadgen-cams`" in (ROOT / "README.md").read_text(encoding="utf-8")
    assert "`cadgen-cams`" in (ROOT / "README.zh-CN.md").read_text(encoding="utf-8")


def test_nothing_asks_to_install_the_stranger() -> None:
    """`pip install ".[edit]"` in the clone, never by a name that the index gives to others."""
    kinds = {".py", ".md", ".mjs", ".js", ".ts", ".json", ".toml", ".po", ".html", ".css"}
    folders = ("cadgen", "designs", "docs", "page", "studies", "tests", "benchmarks")
    files = [file for folder in folders for file in (ROOT / folder).rglob("*") if file.suffix in kinds]
    files += [file for file in ROOT.iterdir() if file.suffix in kinds]
    stranger = re.compile(r"(?:pip|pipx|uv|uvx)\s+(?:\w+\s+)?['\"]?cadgen(?!-cams)\b|\bcadgen\[[a-z]+\]")
    found = [
        f"{file.relative_to(ROOT)}: {match[0]}"
        for file in files
        if "node_modules" not in file.parts
        for match in stranger.finditer(file.read_text(encoding="utf-8", errors="replace"))
    ]
    assert not found


def test_terms_are_in_the_glossary() -> None:
    glossary = (DOCS / "glossary.md").read_text(encoding="utf-8")
    rows = re.findall(r"^### (.*)\n(.*)", glossary, re.M)
    entries = dict(rows)
    assert len(entries) == len(rows) > 80  # one thing, one word
    terms = {re.sub(r"[^\w\s-]", "", term.lower()).replace(" ", "-") for term in entries}
    linked = {
        (name, anchor)
        for name, page in PAGES.items()
        for anchor in re.findall(r"glossary\.md#([\w-]+)", page.read_text(encoding="utf-8"))
    }
    assert {(name, anchor) for name, anchor in linked if anchor not in terms} == set()
    assert len({anchor for _, anchor in linked}) > 25
    for term, line in entries.items():
        assert re.match(r"[^·]*[\u4e00-\u9fff][^·]* · .+", line), term
    for section in glossary.split("\n## ")[1:]:
        names = re.findall(r"^### (.*)", section, re.M)
        assert names == sorted(names, key=str.lower)


def test_every_equation_of_the_paper_has_its_function() -> None:
    rows = re.findall(r"^\| (\d+) \| .* \| `cadgen\.([\w.]+)` \|", (DOCS / "theory/paper.md").read_text(), re.M)
    assert [int(number) for number, _ in rows] == list(range(1, 34))
    text = (DOCS / "theory/paper.md").read_text()
    for name in set(re.findall(r"`(cadgen\.[\w.]+)`", text)):
        assert resolve(name) is not None
    uncited = [f"{number}: {name}" for number, name in rows if int(number) not in cited(f"cadgen.{name}")]
    assert not uncited, uncited


def cited(name: str) -> set[int]:
    """Equations of the paper that a function's docstring, or that of its module, names: `eq. 28, 30`, `eq. 1-11`."""
    function = resolve(name)
    texts = (inspect.getdoc(function) or "", inspect.getdoc(inspect.getmodule(function)) or "")
    found: set[int] = set()
    for listed in re.findall(r"\b[Ee]q\. ([\d\s,-]+)", " ".join(texts)):
        for first, last in re.findall(r"(\d+)(?:-(\d+))?", listed):
            found |= set(range(int(first), int(last or first) + 1))
    return found


def resolve(name: str) -> object:
    """A module's function, class or method by its full name."""
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        try:
            thing = import_module(".".join(parts[:count]))
        except ModuleNotFoundError:
            continue
        for part in parts[count:]:
            thing = getattr(thing, part)
        return thing
    raise AssertionError(name)


def test_equations_in_docstrings_are_in_the_table() -> None:
    """A room whose docstrings cite an equation is one that the table names, or its caller."""
    cited = set()
    for file in (ROOT / "cadgen").rglob("*.py"):
        for first, last in re.findall(r"\beq\. (\d+)(?:-(\d+))?", file.read_text(encoding="utf-8")):
            cited |= set(range(int(first), int(last or first) + 1))
    assert cited
    assert max(cited) <= 33


def test_the_contributors_page_has_every_room() -> None:
    text = (DOCS / "contributing.md").read_text(encoding="utf-8").partition("## The rooms")[2].partition("\n## ")[0]
    named = {name for row in re.findall(r"^\| (`.*?) \|", text, re.M) for name in re.findall(r"`(\w+)`", row)}
    assert named == {module.name for module in iter_modules(cadgen.__path__)} - {"__main__"}


def test_files_named_in_the_pages_exist() -> None:
    for name, page in PAGES.items():
        text = page.read_text(encoding="utf-8")
        for path in re.findall(r"`((?:docs|studies|tests|cadgen|designs|benchmarks)/[\w./-]+\.\w+)`", text):
            assert (ROOT / path).exists(), f"{name}: {path}"
        for module in set(re.findall(r"python -m ((?:tests|docs|cadgen)\.[\w.]+)", text)) - {"tests.studies.NAME"}:
            assert (ROOT / (module.replace(".", "/") + ".py")).exists(), f"{name}: {module}"


def test_the_tutorials_camera_file_is_as_its_script_makes_it() -> None:
    from docs.tutorial.make_camera import camera_file

    assert (DOCS / "tutorial/camera.csv").read_text(encoding="utf-8") == camera_file()


def test_the_measured_lobe_is_as_its_script_makes_it() -> None:
    from docs.tutorial.make_lobe import lobe_file

    assert (DOCS / "tutorial/lobe.csv").read_text(encoding="utf-8") == lobe_file()


def test_the_first_cam_is_the_packaged_roller() -> None:
    """The page asks what the packaged design asks, so its figures are held by the tests of that."""
    page = next(block.text for block in blocks(DOCS / "first-cam.md") if block.language == "toml")
    shown, packaged = tomllib.loads(page), tomllib.loads((ROOT / "designs/roller.toml").read_text(encoding="utf-8"))
    for section in ("follower", "cam", "dynamics"):
        assert shown[section] == packaged[section]
    assert shown["motion"]["segments"] == packaged["motion"]["segments"]


def test_the_page_shows_the_design_and_the_data_as_they_are() -> None:
    text = TUTORIAL.read_text(encoding="utf-8")
    design = (DOCS / "tutorial/first_car.toml").read_text(encoding="utf-8")
    assert design in text
    assert "\n".join((DOCS / "tutorial/camera.csv").read_text(encoding="utf-8").splitlines()[:5]) in text


def test_the_install_commands_stay() -> None:
    first, second = next(block for block in blocks(ROOT / "README.md") if block.language == "sh").text.splitlines()
    assert (
        first
        == f"{INSTALL} .venv && .venv/bin/pip install . && .venv/bin/cadgen cam --profile optimized --out exports/"
    )
    assert second == f"{INSTALL} .venv && .venv/bin/pip install -e '.[test]' && .venv/bin/pytest -n 2"


def test_the_chinese_readme_has_the_same_commands() -> None:
    english, translated = (ROOT / name for name in ("README.md", "README.zh-CN.md"))
    shell = [[block.text for block in blocks(page) if block.language == "sh"] for page in (english, translated)]
    assert shell[0] == shell[1]
    named = [
        re.findall(r"^\| [^|]+ \| `cadgen (\w+)", page.read_text(encoding="utf-8"), re.M)
        for page in (english, translated)
    ]
    assert named[0] == named[1]
    assert len(named[0]) == 7


def test_the_readme_of_the_distribution_leads_to_the_repository_or_nowhere() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    places = re.findall(r"\]\(([^)]+)\)", text)
    spec = spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    builder = module_from_spec(spec)
    spec.loader.exec_module(builder)
    bare, published = (builder.readme_for(text, place) for place in ("", "https://example.org/cadgen"))
    for readme in (bare, published):
        assert "pip install cadgen-cams\n" in readme
        assert "this folder" not in readme
    assert "](" not in bare
    # Nothing is left of what only led to a page: a cell, a sentence or a line.
    assert not re.findall(r"\| *\||中文|, and more|\bpage \|", bare)
    assert len(re.findall(r"^- [A-Z].*\.$", bare, re.M)) == 3
    assert bare.rstrip().endswith("\n\nApache-2.0")
    there = re.findall(r"\]\(([^)]+)\)", published)
    assert [re.sub(r"https://example.org/cadgen/(raw|blob)/main/", "", place) for place in there] == places
    pictures = [place for place in there if "/raw/" in place]
    assert len(pictures) == 4
    assert all(place.endswith((".svg", ".png")) for place in pictures)


def test_the_container_takes_along_what_the_distribution_is_built_of() -> None:
    """And no more: an environment that lies in the folder is a gigabyte."""
    recipe = next(block.text for block in blocks(DOCS / "how-to/elsewhere.md") if block.text.startswith("FROM"))
    copied = {name for line in recipe.splitlines() if line.startswith("COPY ") for name in line.split()[1:-1]}
    assert all((ROOT / name).exists() for name in copied)
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    wheel = told["tool"]["hatch"]["build"]["targets"]["wheel"]
    needed = {"pyproject.toml", "hatch_build.py", "README.md", *wheel["packages"], *wheel["force-include"]}
    needed |= {name for name in told["project"]["license-files"] if not name.startswith("cadgen/")}
    assert copied == needed


def test_the_readme_is_one_screen_of_short_sentences() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(text.split()) <= 500
    plain = re.sub(r"```[\s\S]*?```|^\|[-|]+\|$|!\[[^]]*\]\([^)]*\)|^#.*$", "", text, flags=re.M)
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", plain)
    lengths = sorted(len(sentence.split()) for sentence in re.split(r"[.|·]\s|\n\n", plain) if sentence.split())
    assert lengths[len(lengths) // 2] <= 20
    assert f"{len(laws.codes())} motion laws" in text
    assert len(followers.codes()) == 6
    # The accuracies are those of the page that names the test of each.
    accuracy = (DOCS / "accuracy.md").read_text(encoding="utf-8")
    step, teeth = re.findall(r"within ([\d.]+) µm", text)
    assert f"| {step} / " in next(line for line in accuracy.splitlines() if line.startswith("| STEP / G-code"))
    assert any(teeth in line for line in accuracy.splitlines() if "teeth" in line or "tooth" in line)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"Python {project['requires-python'].removeprefix('>=')} or later" in text


def test_the_newest_version_is_told_in_two_minutes() -> None:
    """At some 250 words a minute."""
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = text.split("\n## ")[1]
    assert newest.startswith(f"{cadgen.__version__} (")
    short = newest.split("\n### ")[1]
    assert short.startswith("In two minutes\n")
    assert len(short.split()) <= 500
    for verb in re.findall(r"`cadgen ([a-z]+)", short):
        assert verb in cli.commands


def test_the_moving_picture_is_that_of_the_parts() -> None:
    """A regression test: the script gives the file that is in the repository."""
    from docs.make_moving_picture import TARGET, cam, gears

    drawn = TARGET.read_text(encoding="utf-8")
    assert cam() in drawn
    assert gears() in drawn


def test_the_reference_takes_up_the_face_of_the_package(tmp_path: Path, monkeypatch) -> None:
    pytest.importorskip("sphinx")
    monkeypatch.syspath_prepend(DOCS / "_ext")
    from python_pages import modules

    (tmp_path / "api.py").touch()
    (tmp_path / "car/running").mkdir(parents=True)
    for name in ("__init__", "drive", "play"):
        (tmp_path / f"car/running/{name}.py").touch()
    monkeypatch.setattr("cadgen.__path__", [str(tmp_path)])
    assert modules("api") == ["cadgen.api"]
    assert modules("car.running") == ["cadgen.car.running", "cadgen.car.running.drive", "cadgen.car.running.play"]
    assert modules("car.steering") == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_reference_of_commands_has_every_option_in_both_languages(language: str, monkeypatch) -> None:
    pytest.importorskip("sphinx")
    monkeypatch.syspath_prepend(DOCS / "_ext")
    from command_pages import MARK, fill

    source = [MARK]
    fill(None, "reference/commands" + (".zh-CN" if language == CHINESE else ""), source)
    for name, command in cli.commands.items():
        (section,) = re.findall(rf"^#### cadgen {name}\n(.*?)(?=^###|\Z)", source[0], re.M | re.S)
        shown = re.findall(r"^`(-.*?)[ `].*\n: (.+)", section, re.M)
        options = [option for option in command.params if option.param_type_name == "option" and option.name != "lang"]
        assert [name.rstrip(",") for name, _ in shown] == [option.opts[0] for option in options]
        assert all(bool(re.search("[\u4e00-\u9fff]", text)) == (language == CHINESE) for _, text in shown)


def test_ci_builds_the_site_and_stops_at_warnings() -> None:
    """Building takes longer than most of the suite, so it is a step of its own, and may not get lost."""
    script = (ROOT / ".ci/run").read_text(encoding="utf-8")
    assert "set -euo pipefail" in script
    assert re.search(r'^if ! "\$bin/sphinx-build" -W --keep-going .* docs .*\n.*\n    exit 1\n', script, re.M)


def test_links_to_studies_lead_to_their_pages() -> None:
    """The site's build does not see them: studies are no pages of it, but each is listed in their index."""
    found = {
        (page.parent / target).resolve()
        for page in PAGES.values()
        for target in re.findall(r"\]\(((?:\.\./)*studies/\w+\.md)\)", page.read_text(encoding="utf-8"))
    }
    assert (STUDIES / "README.md") in found
    assert not [page for page in found if not page.is_file()]
    listed = set(re.findall(r"\]\((\w+\.md)\)", (STUDIES / "README.md").read_text(encoding="utf-8")))
    assert listed == {page.name for page in STUDIES.glob("*.md")} - {"README.md"}


def test_slices_of_studies_stay_apart_from_the_suite() -> None:
    """They are run by `pytest -m study`, and by `.ci/run` among the long tests."""
    assert '("study", "long", "slow")' in (ROOT / "tests/studies/conftest.py").read_text(encoding="utf-8")
    assert '"$bin/pytest" -m long' in (ROOT / ".ci/run").read_text(encoding="utf-8")


def test_each_dependency_has_its_reason() -> None:
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"]
    table = (DOCS / "dependencies.md").read_text(encoding="utf-8").split("\n\n")[3]
    rows = re.findall(r"^\| ([\w-]+) \| \d+ \| .{8,} \|$", table, re.M)
    assert rows == [re.split("[><=]", each)[0] for each in stated]
