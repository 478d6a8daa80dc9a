"""Files read back are judged: each way in which a file can be wrong is refused. No CAD kernel is needed here."""

import pickle
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.design.gear_model import mesh_chord
from cadgen.design.load import load_design
from cadgen.errors import FileError
from cadgen.gears.tooth import GearForm
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.geometry.meshes.teeth import ToothSection, section_of
from cadgen.jobs.gears.assembly import table_of
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.output.files.step import assembly_facts, measured_play, train_step
from cadgen.output.files.stl import MeshedPart, judged_body
from cadgen.output.files.tables import train_table


@pytest.fixture(scope="module")
def plan():
    return plan_gears(load_design(None, ["train.intermediate.cut_apart=", "train.cutting="]))


def assembled(plan, **wrong):
    """The train's parts as its file should have them, the third with something wrong; and what was meant."""
    wanted = [SimpleNamespace(name=part.name, colour=(0.1, 0.2, part.shaft / 9)) for part in plan.layout.parts]
    found = [
        SimpleNamespace(
            name=part.name, colour=meant.colour, transform=part.transform, valid=True, bodies=1, volume=part.volume
        )
        for part, meant in zip(plan.layout.parts, wanted, strict=True)
    ]
    vars(found[2]).update(wrong)
    return found, wanted


def test_another_process_can_make_the_step_files(plan):
    sent = pickle.loads(pickle.dumps(partial(train_step, plan.export)))
    assert sent.func is train_step
    assert [part.name for part in sent.args[0].layout.parts] == [part.name for part in plan.layout.parts]


def test_an_assembly_as_meant_is_taken(plan):
    assert assembly_facts(plan.layout, "x.step", *assembled(plan)).json() == {"bodies": 4, "volume_error_relative": 0.0}


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"valid": False}, "no valid solid for 3_cluster"),
        ({"bodies": 2}, "no valid solid for 3_cluster"),
        ({"name": "part"}, "lost the name of 3_cluster"),
        ({"colour": None}, "lost the colour of 3_cluster"),
        ({"colour": (0.1, 0.2, 0.3)}, "lost the colour of 3_cluster"),
        ({"transform": np.eye(3, 4)}, "mm off its place"),
        ({"volume": 1.0}, "misses the exact volume"),
    ],
)
def test_an_assembly_with_a_part_that_is_not_as_meant_is_refused(plan, wrong, said):
    with pytest.raises(FileError, match=rf"x\.step, read back, .*{said}"):
        assembly_facts(plan.layout, "x.step", *assembled(plan, **wrong))


def test_an_assembly_that_lacks_a_part_is_refused(plan):
    found, wanted = assembled(plan)
    with pytest.raises(FileError, match="has lost a part"):
        assembly_facts(plan.layout, "x.step", found[:3], wanted)


def by_part(plan, change=lambda form: form):
    return [tuple((section_of(change(form)),) for form in part.gears) for part in plan.layout.parts]


@pytest.mark.slow
def test_sections_in_the_files_have_the_play_computed(plan):
    play = measured_play(plan.layout, plan.passed, "x.step", by_part(plan))
    assert max(map(abs, play.errors)) < 0.06
    assert abs(play.total) < 0.06
    thick = [plan.layout.parts[3].gears[0].tooth_thickness_deviation + 1e-3]
    wrong = [*by_part(plan)[:3], ((section_of(plan.layout.parts[3].gears[0].cut_to(*thick)),),)]
    with pytest.raises(FileError, match=r"has a play 0\.98 µm off the computed one"):
        measured_play(plan.layout, plan.passed, "x.step", wrong)


def test_sections_whose_play_is_right_only_at_the_line_of_centres_are_refused(plan):
    good = by_part(plan)
    corners = good[0][0][0].corners
    radius = np.abs(corners)
    tooth = np.exp(2j * np.pi / len(corners) * np.arange(len(corners)))[:, None]
    out = np.clip((radius - (radius.max() - 0.1)) / 0.05, 0.0, 1.0)
    raised = ToothSection(corners * np.exp(1j * 5e-3 / radius * out * np.sign(np.angle(corners / tooth))))
    with pytest.raises(FileError, match="has teeth in stage 1 whose play is not the same over a pitch"):
        measured_play(plan.layout, plan.passed, "x.step", [((raised,),), *good[1:]])


def test_a_mesh_of_another_volume_or_in_pieces_is_refused(plan):
    part = plan.layout.parts[0]
    mesh, meshed = body_mesh(part.body, 1e-3), MeshedPart.of(part, 1e-3, None)
    assert judged_body("x.stl", mesh, part.volume, meshed).facts.json()["watertight"]
    with pytest.raises(FileError, match="misses the exact volume"):
        judged_body("x.stl", mesh._replace(vertices=mesh.vertices * 1.01), part.volume, meshed)
    twice = mesh._replace(
        vertices=np.concatenate([mesh.vertices, mesh.vertices + 50.0]),
        triangles=np.concatenate([mesh.triangles, mesh.triangles + len(mesh.vertices)]),
    )
    with pytest.raises(FileError, match="is not one body"):
        judged_body("x.stl", twice, part.volume, meshed)


def test_the_table_of_parts_has_the_limits_of_every_tooth_and_is_read_back(plan, tmp_path, monkeypatch):
    for row in table_of(plan.layout):
        assert row["E_sni_um"] < row["E_sn_um"] < row["E_sns_um"] < 0
    list(train_table(plan.export, tmp_path))
    assert "E_sns_um,E_sni_um" in (tmp_path / f"{plan.stem}_parts.csv").read_text()
    read = Path.read_text
    monkeypatch.setattr(Path, "read_text", lambda self, **kwargs: read(self, **kwargs).replace("150", "151"))
    with pytest.raises(FileError, match=r"_parts\.csv, read back, has other values"):
        list(train_table(plan.export, tmp_path))


@pytest.mark.parametrize("module", [0.2, 0.3, 1.0, 5.0])
def test_meshes_of_small_gears_are_as_true_as_those_of_large_ones(module):
    """At 5 µm, whatever the module, a wheel of 40 teeth of module 0.2 was 1.1e-3 off, and one of 10 of 0.3 1.6e-3."""
    design = load_design(None, ["export.mesh_chord_um="])
    for teeth in (10, 17, 40):
        form = GearForm(teeth=teeth, normal_module=module, width=4.0)
        chord = mesh_chord(design, [form, replace(form, normal_module=9.0)])
        assert chord == pytest.approx(min(2e-3 * module, 5e-3))
        body = gear_body(form)
        mesh = body_mesh(body, chord)
        assert abs(mesh.solid().volume() / body.prismatic_volume - 1) < 2e-4
        assert 50 * len(mesh.triangles) < 0.4e6  # bytes of an STL
    assert mesh_chord(load_design(None, ["export.mesh_chord_um=20"]), [form]) == pytest.approx(0.02)
