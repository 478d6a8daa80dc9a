"""Facts on their way to JSON: what becomes of each kind of value."""

import json
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

import numpy as np
import pytest

from cadgen.figures import Facts, Figure, Figures, as_json
from cadgen.messages import Message


class Word(StrEnum):
    GOOD = "good"


@dataclass(frozen=True)
class Pair:
    name: str
    ends: tuple[float, float]


def test_every_kind_of_value_becomes_plain_and_keeps_its_order():
    facts = Facts(
        word=Word.GOOD,
        said=Message("{count} rows", count=3),
        array=np.array([[1.0, np.nan], [2.0, 3.0]]),
        count=np.int64(7),
        held=np.bool_(True),
        pair=Pair("a", (0.5, float("inf"))),
        play=Figures(Figure("end", "end", 0.25, "°"), Figure("room", "room", None, "mm")),
        inside=[Facts(a=1) | Figures(Figure("b", "b", 2, "µm"))],
        **{"5 %": None},
    )
    assert json.dumps(facts.json(), allow_nan=False) == (
        '{"word": "good", "said": "3 rows", "array": [[1.0, null], [2.0, 3.0]], "count": 7, "held": true, '
        '"pair": {"name": "a", "ends": [0.5, null]}, "play": {"end_deg": 0.25, "room_mm": null}, '
        '"inside": [{"a": 1, "b_um": 2}], "5 %": null}'
    )


def test_a_message_stays_one_so_that_it_can_be_said_in_another_language():
    assert isinstance(Facts(said=Message("rows")).json()["said"], Message)


def test_the_latter_of_one_key_counts_in_the_place_of_the_former():
    assert list((Facts(a=1, b=2) | Facts(a=3)).json().items()) == [("a", 3), ("b", 2)]


def test_keys_may_be_any_words():
    assert Facts(**{"self": 1, "yield": 2}).json() == {"self": 1, "yield": 2}


def test_a_value_of_another_kind_is_refused():
    with pytest.raises(TypeError, match="Path is no plain value"):
        as_json([Path("a")])
