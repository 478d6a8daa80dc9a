"""The design file with what was measured: comments kept, overrides applied, and a table [as_built] at its end."""

from collections.abc import Sequence
from math import isfinite
from typing import Any

from cadgen.design.as_built import EffectSection
from cadgen.design.override import override
from cadgen.deviations.deviation import Place
from cadgen.inference.expectation.outlook import Outlook
from cadgen.jobs.calibration.calibration import CalibrationPlan
from cadgen.jobs.calibration.calibration_report import sentence, shown
from cadgen.jobs.calibration.new_cam import agreed_places

_TABLE = "as_built"


def as_built_text(calibration: CalibrationPlan, design_text: str) -> str:
    """The design's own text with the overrides and the effects; an earlier [as_built] is replaced.

    Args:
        calibration: calibration with at least one claim.
        design_text: text of the design file.
    """
    import tomlkit

    values: Any = tomlkit.parse(design_text)
    for text in calibration.against.overrides:
        override(values, text)
    values.pop(_TABLE, None)
    if "name" not in values:
        # A design without a name has that of its file, and this one is called otherwise.
        named = tomlkit.document()
        named.add("name", calibration.against.name)
        design_text = f"{named.as_string()}{values.as_string()}"
    else:
        design_text = values.as_string()
    return f"{design_text.rstrip()}\n\n{_table(calibration)}"


def _table(calibration: CalibrationPlan) -> str:
    lines = [
        f"[{_TABLE}]",
        "# Written by cadgen calibrate: what this car was measured to be. Every command takes it into account.",
        f'profile = "{calibration.profile}"',
        *(
            [f'other_cam = "{calibration.other_cam.profile}"']
            if calibration.other_cam and calibration.cam_unknown
            else []
        ),
        *(
            ["other_cam_earlier = true"]
            if calibration.other_cam and calibration.cam_unknown and calibration.other_cam.earlier
            else []
        ),
    ]
    places = [built.place for built in calibration.built]
    for name, outlook, reckoned in (
        ("outlook", calibration.outlook, places),
        ("outlook_agreed", calibration.outlook_agreed, agreed_places(calibration.built)),
    ):
        if outlook is not None:
            lines += ["", f"[{_TABLE}.{name}]", *_outlook(outlook, reckoned)]
    for source in calibration.sources:
        lines += [
            "",
            f"[[{_TABLE}.sources]]",
            f"file = {_text(source.path.name)}",
            f'kind = "{source.kind.code}"',
            f'sha256 = "{source.sha256}"',
            f'verdict = "{calibration.verdict(source.kind)}"',
        ]
    for known in calibration.against.cut_for:
        lines += _known("cut_for", known)
    for cam in calibration.against.earlier:
        lines += ["", f"[[{_TABLE}.earlier]]", f'profile = "{cam.profile}"']
        for known in cam.cut_for:
            lines += _known("earlier.cut_for", known)
    for built in calibration.built:
        finding = built.claim.finding
        values = []
        for value in finding.values:
            number, sigma = (text if not text or set(text) & {".", "e"} else f"{text}.0" for text in shown(value))
            values.append(_inline(value.name, number, sigma if isfinite(value.sigma) else None))
        values += [_inline(name, repr(number)) for name, number in finding.indices]
        lines += _effect("effects", finding.effect, built.claim.kind.code, built.place, values, sentence(built))
    return "\n".join(lines) + "\n"


def _outlook(outlook: Outlook, places: Sequence[Place]) -> list[str]:
    return [
        f"old_mm = {outlook.old:.1f}",
        f"new_mm = {outlook.new:.1f}",
        f"least_mm = {outlook.least:.1f}",
        f"most_mm = {outlook.most:.1f}",
        f"chance_worse = {outlook.worse:.4f}",
        *([] if outlook.explained is None else [f"explained = {str(outlook.explained).lower()}"]),
        f"places = [{', '.join(map(_text, places))}]",
    ]


def _known(table: str, known: EffectSection) -> list[str]:
    values = [_inline(value.name, repr(value.value), value.sigma) for value in known.values]
    return _effect(table, known.effect, known.kind, known.place, values)


def _effect(table: str, effect: str, kind: str, place: str, values: list[str], words: str = "") -> list[str]:
    return [
        "",
        f"[[{_TABLE}.{table}]]",
        *([f"# {words}"] if words else []),
        f"effect = {_text(effect)}",
        f'kind = "{kind}"',
        f'place = "{place}"',
        f"values = [{', '.join(values)}]",
    ]


def _inline(name: str, value: str, sigma: str | float | None = None) -> str:
    return f'{{ name = "{name}", value = {value}{f", sigma = {sigma}" if sigma else ""} }}'


def _text(words: str) -> str:
    import tomlkit

    return tomlkit.item(words).as_string()
