"""Names of parts beyond ASCII in STEP files."""

import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox

from cadgen.geometry.solids.kernel import SolidPart
from cadgen.geometry.solids.step import read_part, step_bytes


@pytest.mark.parametrize("name", ["小车_optimized", "coche-año", "plain", "𝛼_1"])
def test_a_name_in_any_script_comes_back_and_the_file_stays_ascii(tmp_path, name):
    box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid()
    data = step_bytes(SolidPart(solid=box, name=name, description=f"cam of {name}", colour=(0.5, 0.5, 0.5)))
    assert data.isascii()
    file = tmp_path / "box.step"
    file.write_bytes(data)
    read = read_part(file)
    assert (read.name, read.description) == (name, f"cam of {name}")
