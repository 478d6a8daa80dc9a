"""Materials by the words of designs: other words, grades and Chinese, and words that name none of them."""

import pytest

from cadgen.car.running.friction import DiscMaterial, named_material
from cadgen.design.load import load_design
from cadgen.errors import DesignError


@pytest.mark.parametrize(
    ("words", "material"),
    [
        ("aluminum", "aluminium"),
        ("Aluminium EN AW-6082", "aluminium"),
        ("EN AW-7075-T6", "aluminium"),
        ("6061-T6", "aluminium"),
        ("7075", "aluminium"),
        ("铝", "aluminium"),
        ("铝合金6061", "aluminium"),
        ("C45", "steel"),
        ("45钢", "steel"),
        ("steel C45, brushed", "steel"),
        ("鋼", "steel"),
        ("stainless-steel", "steel"),
        ("6082-T6 plate", "aluminium"),
        ("Q235", "steel"),
        ("42CrMo4", "steel"),
        ("1.4301", "steel"),
        ("AISI 304", "steel"),
        ("stainless 304", "steel"),
        ("不锈钢", "steel"),
        ("黄铜", "brass"),
        ("CuZn39Pb3", "brass"),
        ("亚克力", "acrylic"),
        ("PMMA 6 mm", "acrylic"),
        ("PLA, 100 %", "PLA"),
        ("POM-C", "POM"),
        ("Delrin", "POM"),
        ("聚甲醛", "POM"),
        ("赛钢", "POM"),  # a trade name of POM, with the letter of steel
        # No word of the table, or a metal that has another one in its name, or two of them, or a length.
        ("plywood 5 mm", None),
        ("aluminium bronze", None),
        ("铝青铜", None),
        ("steel and brass", None),
        ("plywood 304 x 200", None),
        ("304 x 200 x 5", None),
        ("45", None),
        ("2024-05-12", None),
        ("steel-free", None),
        ("non-steel", None),
        ("钢化玻璃", None),  # glass
        ("", None),
        (None, None),
    ],
)
def test_words_name_a_material_or_none(words: str | None, material: str | None) -> None:
    assert named_material(words) == (None if material is None else DiscMaterial(material))


def test_keys_of_materials_take_other_words_and_refuse_with_what_they_know() -> None:
    for words in ("铝", "aluminum", "6061-T6"):
        design = load_design("carbon_free_car", [f"blank.material={words}", f"tolerances.frame_material={words}"])
        assert design.blank.material is design.tolerances.frame_material is DiscMaterial.ALUMINIUM
    for key in ("blank.material", "tolerances.frame_material"):
        with pytest.raises(DesignError, match=r'it must be "aluminium", "steel", "brass", "acrylic", "PLA" or "POM"'):
            load_design("carbon_free_car", [f"{key}=wood"])
