"""The reference page is what the schema says, and its example works."""

import re
from pathlib import Path

import pytest

from cadgen.cam.followers import table as followers
from cadgen.car.path.path_kinds import codes, kind_of
from cadgen.design.keys import keys, last, tables
from cadgen.design.kinds import Kinds
from cadgen.design.load import load_design
from cadgen.design.reference import page
from cadgen.gears import stage_kinds
from cadgen.messages import shown

PAGE = Path(__file__).parents[2] / "docs" / "design-file.md"


@pytest.mark.parametrize(("language", "end"), [("en", ""), ("zh", ".zh-CN")])
def test_the_page_is_up_to_date(language: str, end: str) -> None:
    file = PAGE.with_suffix(f"{end}.md")
    command = f"python -m cadgen.design.reference {language} > docs/{file.name}"
    assert file.read_text(encoding="utf-8") == shown(page(), language), f"run: {command}"


def test_the_page_has_every_key() -> None:
    rows = re.findall(r"^\| `(\w+)` \|", PAGE.read_text(encoding="utf-8").partition("## Keys")[2], re.MULTILINE)
    limits = re.findall(r'"(\w+)"', keys()["checks.pressure_angle_limit"].allowed)
    named = {key for code in codes() for key in keys(Kinds(path=kind_of(code)))} | set(keys())
    by_motion = [key for key in keys(Kinds(motion=True)) if key.startswith("cam.")]
    kinds = [Kinds(follower=followers.kind_of(code), motion=True) for code in followers.codes()[1:]]
    of_followers = [
        key for kind in kinds for key in keys(kind) if key.startswith("follower.") and key != "follower.kind"
    ]
    stages = [Kinds(stage=stage_kinds.kind_of(code)) for code in stage_kinds.codes()]
    of_stages = [key for kind in stages for key in keys(kind) if key.startswith("train.stages.")]
    of_stages = [key for key in of_stages if last(key) not in ("kind", "bearing_span_mm", "direction_deg")]
    assert sorted(rows) == sorted([*map(last, [*named, *by_motion, *of_followers, *of_stages]), *limits])


def must_be_there(section: str) -> bool:
    """A section that is required, inside none that may be left out."""
    return tables()[section].required and (not section or must_be_there(section.rpartition(".")[0]))


def test_every_meaning_is_more_than_a_symbol() -> None:
    """`m_n, normal module`, and not `m_n`: the reference is read by those who have not met the symbols."""
    bare = [f"{name}.{key.name}" for name, section in tables().items() for key in section.keys if len(key.meaning) < 8]
    assert not [name for name in bare if "left out" not in name]


def test_the_shortest_design_of_the_page_loads(tmp_path: Path) -> None:
    (example,) = re.findall(r"```toml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    (tmp_path / "mine.toml").write_text(example)
    design = load_design(tmp_path / "mine.toml")
    assert design.cam.faces_mm == (23.5, 26.5)
    # Shortest: what must be there, two keys for the faces, and what a rod has that slides.
    required = [key for name in tables() if must_be_there(name) for key in tables()[name].keys if key.required]
    assert sorted(re.findall(r"^(\w+) =", example, re.MULTILINE)) == sorted(
        [
            *(last(key.name) for key in required),
            *("mid_plane_mm", "thickness_mm", "friction_least", "friction_greatest"),
        ]
    )


def test_the_overrides_of_the_page_work() -> None:
    written = re.findall(r"\| `--set (.*?)` \|", PAGE.read_text(encoding="utf-8"))
    assert len(written) == 7
    # As they stand they leave the disc with one face only.
    load_design(None, [*written, "cam.inner_face_mm=23"])
