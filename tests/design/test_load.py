"""Designs by name and by file, what they remember, and that nothing is lost on the way."""

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import tomli_w
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cadgen.design import load
from cadgen.design.file_names import name_fault
from cadgen.design.load import DEFAULT_DESIGN, complete_of, load_design, packaged_designs, read_design
from cadgen.design.schema import Design
from cadgen.errors import DesignError

Tables = dict[str, Any]
Write = Callable[[str | bytes | Tables], Path]


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats, and whole numbers written without a point."""
    return st.floats(low, high) | st.integers(int(low) + 1, int(high))


@st.composite
def blanks(draw: st.DrawFn) -> Tables:
    """Valid blanks: what lies inside is drawn first, what lies around it is made to clear it."""
    bore = draw(st.floats(3, 12))
    blank: Tables = {"bore_diameter_mm": bore}
    reach = bore / 2
    kind = draw(st.sampled_from(["plain", "keyway", "d_flat"]))
    if kind == "keyway":
        width, depth = bore * draw(st.floats(0.1, 0.9)), draw(st.floats(0.2, 3))
        blank["keyway"] = {"width_mm": width, "depth_mm": depth, "angle_deg": draw(numbers(-360, 360))}
        reach += width + depth
    elif kind == "d_flat":
        blank["d_flat"] = {"across_mm": bore * draw(st.floats(0.51, 0.99))}
    if draw(st.booleans()):
        reach *= draw(st.floats(1.1, 2))
        blank["hub"] = {"diameter_mm": 2 * reach, "length_mm": draw(st.floats(5, 20))}
        if draw(st.booleans()):
            hole = draw(st.floats(0.5, 2))
            blank["hub"]["set_screw"] = {"hole_diameter_mm": hole, "height_mm": blank["hub"]["length_mm"] / 2}
    if draw(st.booleans()):
        hole = draw(st.floats(1, 10))
        ring = {"holes": draw(st.integers(1, 5)), "hole_diameter_mm": hole}
        blank["lightening"] = {**ring, "circle_diameter_mm": 2 * (reach + hole) + draw(st.floats(0, 30))}
    return blank


@st.composite
def designs(draw: st.DrawFn) -> Tables:
    """Valid designs as tables, with or without each key and section that may be left out."""
    point = st.lists(numbers(-1e4, 1e4), min_size=2, max_size=2)
    inner, thickness = draw(st.floats(10, 50)), draw(st.floats(0.5, 10))
    faces = {
        "inner_face_mm": inner,
        "outer_face_mm": inner + thickness,
        "mid_plane_mm": inner + thickness / 2,
        "thickness_mm": thickness,
    }
    pair = draw(st.lists(st.sampled_from(sorted(faces)), min_size=2, max_size=2, unique=True))
    optional = {
        "name": st.from_regex(r"[A-Za-z0-9小车é][A-Za-z0-9._小车é-]{0,63}", fullmatch=True).filter(
            lambda n: not name_fault(n)
        ),
        "field": st.fixed_dictionaries(
            {"size_mm": st.lists(numbers(1, 1e4), min_size=2, max_size=2)},
            optional={"corner_mm": point, "obstacles_mm": st.lists(point, max_size=4)},
        ),
        "blank": blanks(),
        "machining": st.fixed_dictionaries(
            {}, optional={"cutter_diameter_mm": numbers(0.2, 20), "break_through_mm": numbers(0, 5)}
        ),
        "checks": st.fixed_dictionaries(
            {}, optional={"pressure_angle_limit": st.sampled_from(["norton_translating", "chinese_texts"])}
        ),
        "export": st.fixed_dictionaries({}, optional={"point_count": st.integers(360, 36_000)}),
    }
    path = st.fixed_dictionaries(
        {"waypoints_mm": st.lists(point, min_size=4, max_size=12)},
        optional={"spline": st.sampled_from(["cubic", "quintic"]), "offset_mm": numbers(-500, 500)},
    )
    car = st.fixed_dictionaries(
        {
            "wheelbase_mm": numbers(50, 400),
            "drive_wheel_offset_mm": numbers(0, 200),
            "idle_wheel_offset_mm": numbers(0, 300),
        },
        optional={"max_steering_angle_deg": numbers(1, 80)},
    )
    return {
        **draw(st.fixed_dictionaries({}, optional=optional)),
        "path": draw(path),
        "car": draw(car),
        "cam": {"base_radius_mm": draw(numbers(20, 200)), **{name: faces[name] for name in pair}},
        "follower": {"radius_mm": draw(st.floats(0.1, 9.9))},
    }


def leaves(tables: Tables, above: str = "") -> dict[str, Any]:
    """Dotted key -> value."""
    flat: dict[str, Any] = {}
    for name, value in tables.items():
        flat |= leaves(value, f"{above}{name}.") if isinstance(value, dict) else {f"{above}{name}": value}
    return flat


@pytest.mark.slow
@given(designs())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
def test_what_is_written_is_what_is_read(written: Write, tables: Tables) -> None:
    design = load_design(written(tables))
    read = leaves(design.values())
    assert {name: read[name] for name in leaves(tables)} == leaves(tables)
    again = load_design(written(design.values()))
    assert again == design
    assert again.content_hash == design.content_hash


@pytest.mark.slow
@pytest.mark.long
@given(designs(), designs(), st.data())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
def test_an_override_does_what_editing_the_file_does(
    written: Write, tables: Tables, others: Tables, data: st.DataObject
) -> None:
    """A value of another design is put in; if the two do not fit together, both ways refuse it."""
    name = data.draw(st.sampled_from(sorted(leaves(others))))
    value = leaves(others)[name]
    override = f"{name}={tomli_w.dumps({'value': value}).partition('=')[2]}"
    overridden: Design | DesignError
    edited: Design | DesignError
    try:
        overridden = load_design(written(tables), [override])
    except DesignError as error:
        overridden = error
    *sections, last = name.split(".")
    table = tables
    for section in sections:
        table = table.setdefault(section, {})
    table[last] = value
    try:
        edited = load_design(written(tables))
    except DesignError as error:
        edited = error
    if isinstance(edited, Design):
        assert isinstance(overridden, Design)
        assert overridden.values() == edited.values()
        assert overridden.content_hash == edited.content_hash
    else:
        assert isinstance(overridden, DesignError)
        assert str(overridden).partition(": ")[2].splitlines() == str(edited).partition(": ")[2].splitlines()


def test_items_of_lists_and_removed_keys() -> None:
    plain = load_design()
    design = load_design(
        None,
        [
            "path.waypoints_mm.3=[4200, 260]",
            "path.waypoints_mm.4.2 = 650",
            "path.waypoints_mm.12=",
            "path.spline=cubic",
            'name = "other"',
            "cam.mid_plane_mm=",
            "cam.inner_face_mm=23.25",
            "cam.blend_deg=",
            "blank.keyway=",
            "blank.d_flat.across_mm=7.5",
            "blank.hub.set_screw.height_mm=",
            "field=",
        ],
    )
    assert design.path.waypoints_mm[2] == (4200, 260)
    assert design.path.waypoints_mm[3] == (3380, 650)
    assert design.path.waypoints_mm[:2] == plain.path.waypoints_mm[:2]
    assert design.path.waypoints_mm[4:] == plain.path.waypoints_mm[4:11]
    assert (design.path.spline, design.name) == ("cubic", "other")
    assert design.cam.faces_mm == (23.25, 26.25)
    assert design.cam.blend_deg == 12
    assert design.blank.keyway is None
    assert design.blank.d_flat is not None
    assert design.blank.hub is None
    assert design.field is None


def test_later_overrides_win() -> None:
    assert load_design(None, ["cam.thickness_mm=2", "cam.thickness_mm=4"]).cam.thickness_mm == 4


def test_the_default_is_the_carbon_free_car() -> None:
    assert load_design() == load_design("carbon_free_car")
    assert load_design().name == DEFAULT_DESIGN == "carbon_free_car"


def test_packaged_designs_are_named_after_their_files() -> None:
    planned = {"figure_eight", "posts_and_walls", "s_course"}
    moved = {"conjugate_pair", "eccentric", "flat", "groove", "roller", "swinging_roller", "valve_lobe"}
    assert set(packaged_designs()) == {"carbon_free_car", "appendix_car", "workshop_car", *planned, *moved}
    for name, file in packaged_designs().items():
        assert complete_of(*read_design(name)).name == name == file.stem


def test_packaged_designs_are_found_inside_the_installed_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, minimal: Tables
) -> None:
    installed = tmp_path / "cadgen" / "designs"
    installed.mkdir(parents=True)
    (installed / "carbon_free_car.toml").write_text(tomli_w.dumps(minimal))
    monkeypatch.setattr(load, "_PACKAGED", (installed, *load._PACKAGED))
    assert len(load_design().path.waypoints_mm) == 5


def test_the_shortest_design_takes_its_name_from_its_file(minimal: Tables, tmp_path: Path) -> None:
    names = {"mine.toml": "mine", "-my car (2).toml": "my_car_2_", "小车.toml": "小车", "%.toml": "design"}
    for file, name in names.items():
        (tmp_path / file).write_text(tomli_w.dumps(minimal))
        design = load_design(tmp_path / file)
        assert (design.name, design.source) == (name, file)
    assert load_design("appendix_car", ["name=other", "name="]).name == "appendix_car"


def test_provenance_holds_no_folder(minimal: Tables, written: Write) -> None:
    overrides = ["cam.thickness_mm=3.2", "path.spline=cubic"]
    design = load_design(written(minimal), overrides)
    assert (design.source, design.overrides) == ("mine.toml", tuple(overrides))
    assert "mine.toml" not in json.dumps(design.values())


def test_the_hash_is_of_what_the_design_says(minimal: Tables, written: Write) -> None:
    minimal["name"] = "car"
    first = load_design(written(minimal))
    # Other order, a comment, points in numbers, and a default written out.
    text = "# a comment\n" + tomli_w.dumps(dict(reversed(minimal.items()))).replace("2.5", "2.50")
    same = load_design(written(text.replace("70", "70.0")), ["cam.blend_deg=12"])
    assert same.content_hash == first.content_hash
    assert load_design(written(minimal), ["cam.blend_deg=12.001"]).content_hash != first.content_hash
    assert len(first.content_hash) == 64


def test_a_byte_order_mark_and_windows_line_ends_do_no_harm(minimal: Tables, written: Write) -> None:
    minimal["name"] = "car"
    plain = tomli_w.dumps(minimal)
    windows = b"\xef\xbb\xbf" + plain.replace("\n", "\r\n").encode()
    assert load_design(written(windows)).values() == load_design(written(plain)).values()


def test_loading_a_design_imports_no_numerics_and_no_kernel() -> None:
    code = "import sys, cadgen.design.load as l; l.load_design(); print(*sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path(__file__).parents[2],
    )
    heavy = {"numpy", "scipy", "build123d", "OCP", "rich"}
    assert "pydantic" in run.stdout.split()
    assert not heavy & set(run.stdout.split())


def test_a_number_for_a_yes_or_no_is_refused_with_what_it_must_be():
    with pytest.raises(DesignError, match=r"layout\.turned_over is 2; it must be true or false$"):
        load_design("workshop_car", ["layout.turned_over=2"])
