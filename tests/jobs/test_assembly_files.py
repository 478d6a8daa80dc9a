"""Files of a car put together: what they hold, read by other means than the program's own."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from cadgen import Design, verify
from cadgen.api.assembly import AssembledCar
from cadgen.errors import DesignError
from cadgen.output.files.publisher import Written

ANGLE = 120.0


@pytest.fixture(scope="module")
def car() -> AssembledCar:
    return Design.load("workshop_car").assembly("actual")


@pytest.fixture(scope="module")
def written(car: AssembledCar, tmp_path_factory: pytest.TempPathFactory) -> Written:
    return car.write(tmp_path_factory.mktemp("car"), ANGLE)


@pytest.mark.slow
@pytest.mark.long
def test_the_list_of_parts_adds_up_to_the_mass(car: AssembledCar, written: Written) -> None:
    with (written.folder / "workshop_car_assembly_parts.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["code"] for row in rows] == [part.code for part in car.parts]
    # Of the drive no mass is known where there is no [drive].
    assert [row["code"] for row in rows if not row["mass_g"]] == ["drive"]
    assert sum(float(row["mass_g"] or 0) for row in rows) == pytest.approx(car.balance().volume, abs=0.05)
    assert {row["quantity"] for row in rows if row["code"] == "fork-cheek"} == {"2"}


@pytest.mark.slow
@pytest.mark.long
def test_the_sheets_have_every_balloon_and_step(car: AssembledCar, written: Written) -> None:
    import ezdxf

    def texts(name: str) -> list[str]:
        document = ezdxf.readfile(written.folder / name)
        return [entity.dxf.text for entity in document.modelspace().query("TEXT")]

    on_sheet = texts("workshop_car_assembly_drawing.dxf")
    placed = [number for number, part in enumerate(car.parts, 1) if part.places]
    for number in placed:
        # Once in the list, and once in a balloon where anything of the part is seen; a key may be hidden by its wheel.
        assert on_sheet.count(str(number)) >= (1 if "key" in car.parts[number - 1].code else 2), number
    on_plan = texts("workshop_car_mounting_drawing.dxf")
    for part in car.parts:
        if part.shaft and part.places:
            assert any(part.title in text for text in on_plan), part.code


@pytest.mark.slow
@pytest.mark.long
def test_the_manifest_has_the_places_and_the_folder_verifies(car: AssembledCar, written: Written) -> None:
    entry = json.loads((written.folder / "manifest.json").read_text())["parts"]["workshop_car_assembly"]
    assert entry["cam_angle_deg"] == pytest.approx(ANGLE)
    fork = np.radians(entry["fork_angle_deg"])
    rod = next(part for part in entry["parts"] if part["code"] == "rod")
    assert np.array(rod["places"][0])[0, 2] == pytest.approx(np.sin(fork), abs=1e-8)
    assert verify(Path(written.folder)).is_true


def test_a_cam_without_a_car_is_refused_before_its_train() -> None:
    with pytest.raises(DesignError, match=r"\[path\]|car"):
        Design.load("roller").assembly()
