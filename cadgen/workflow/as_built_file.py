"""The design file with what was measured: comments kept, overrides applied, and a table [as_built] at its end."""

from math import isfinite
from typing import Any

from cadgen.design.override import override
from cadgen.measurement.diagnose import Value
from cadgen.workflow.calibrate import Built, Calibration
from cadgen.workflow.calibrate_words import sentence, shown

_TABLE = "as_built"


def as_built_text(calibration: Calibration, design_text: str) -> str:
    """The design's own text with the overrides and the effects; an earlier [as_built] is replaced.

    Args:
        calibration: with something claimed.
        design_text: of the design file.
    """
    import tomlkit

    values: Any = tomlkit.parse(design_text)
    for text in calibration.design.overrides:
        override(values, text)
    values.pop(_TABLE, None)
    if "name" not in values:
        # A design without a name has that of its file, and this one is called otherwise.
        named = tomlkit.document()
        named.add("name", calibration.design.name)
        design_text = f"{named.as_string()}{values.as_string()}"
    else:
        design_text = values.as_string()
    return f"{design_text.rstrip()}\n\n{_table(calibration)}"


def _table(calibration: Calibration) -> str:
    lines = [
        f"[{_TABLE}]",
        "# Written by cadgen calibrate: what this car was measured to be. Every command takes it into account.",
        f'profile = "{calibration.profile}"',
    ]
    for source in calibration.sources:
        lines += [
            "",
            f"[[{_TABLE}.sources]]",
            f"file = {_text(source.path.name)}",
            f'kind = "{source.kind}"',
            f'sha256 = "{source.sha256}"',
            f'verdict = "{calibration.verdict(source.kind)}"',
        ]
    for one in calibration.built:
        lines += [
            "",
            f"[[{_TABLE}.effects]]",
            f"# {sentence(one)}",
            f"effect = {_text(one.claim.finding.effect)}",
            f'kind = "{one.claim.kind}"',
            f'place = "{one.place}"',
            f"values = [{', '.join(_values(one))}]",
        ]
    return "\n".join(lines) + "\n"


def _values(one: Built) -> list[str]:
    finding = one.claim.finding
    given = [f'{{ name = "{name}", value = {number!r} }}' for name, number in finding.given]
    return [*(_value(value) for value in finding.values), *given]


def _value(value: Value) -> str:
    told, sigma = shown(value)
    also = f", sigma = {_float(sigma)}" if isfinite(value.sigma) and sigma else ""
    return f'{{ name = "{value.name}", value = {_float(told)}{also} }}'


def _float(told: str) -> str:
    """A TOML float has a point or an exponent."""
    return told if any(mark in told for mark in ".e") else f"{told}.0"


def _text(words: str) -> str:
    import tomlkit

    return tomlkit.item(words).as_string()
