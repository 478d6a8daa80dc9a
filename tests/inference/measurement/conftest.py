"""The synthetic generator and the design that it is measured against, built once."""

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[3]))

from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.records.load import load
from tests.inference.measurement import study
from tests.inference.measurement.synthetic import Car


@pytest.fixture(scope="session")
def synthetic_car(carbon_free_car: object) -> Car:
    """The generator's view of the paper's car."""
    return Car(carbon_free_car)


@pytest.fixture(scope="session")
def nominal(synthetic_car: Car) -> Nominal:
    """The design of the paper's car."""
    return study.nominal(synthetic_car)


@pytest.fixture(scope="session")
def blind(nominal: Nominal, measured: Path) -> Callable[[str], EvidenceDiagnosis]:
    """Diagnosis of a measured file by itself, made once."""

    @cache
    def told(name: str) -> EvidenceDiagnosis:
        (one,) = calibrate([load(measured / f"{name}.csv")], nominal)
        return one

    return told
