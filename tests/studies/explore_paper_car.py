"""Page on the packaged study of the paper's car, made from its journal.

cadgen explore paper_car --out FOLDER --processes 2
python -m tests.studies.explore_paper_car --results FOLDER [--record]
"""

import argparse
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from cadgen import __version__
from cadgen.studies.design_row import Row
from cadgen.studies.front import effects, front, ranked
from cadgen.studies.journal import Journal
from cadgen.studies.study import Study
from cadgen.studies.study_file import study_of
from tests.studies.command import PAGES, tell

HAND_MADE_MM = 306.1  # worst end of the packaged car with its optimized cam, `cadgen optimize`
LEAST_GAIN = 0.4
MOST_CORE_HOURS = 3.0


def main() -> None:
    """Read, print and record."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=Path, default=Path("paper_car"))
    parser.add_argument("--record", action="store_true")
    chosen = parser.parse_args()
    journal = Journal.read(chosen.results / "paper_car.journal")
    header = journal.header
    study = study_of(header.study, header.text, header.source, header.name)
    rows = [journal.row(number) for number in journal.numbers.tolist()]
    text = page(study, rows, journal.seconds, len(journal.paths))
    tell(text, PAGES / "explore_paper_car.md" if chosen.record else None)


def page(study: Study, rows: Sequence[Row], seconds: float, paths: int) -> str:
    """The page.

    Args:
        study: the study.
        rows: rows of the designs computed.
        seconds: their processor time, s.
        paths: number of planned paths.
    """
    states = Counter(row.state for row in rows)
    best = front(rows, study.objectives)
    end = min(known(study, row)["worst_end_mm"] for row in best)
    hours = seconds / 3600
    return f"""# The paper's car, 2000 designs

    cadgen explore paper_car --out paper_car --processes 2
    python -m tests.studies.explore_paper_car --results paper_car --record

cadgen {__version__}, {len(rows)} of {study.count} designs: {states["kept"]} within all limits and checks,
{states["outside"]} outside, {states["screened"]} screened out by their drift, {states["refused"]} refused,
{states["crashed"]} crashed. {paths} distinct paths were planned, once each. The designs took
{hours:.2f} core-hours (bar, paths included: {MOST_CORE_HOURS:g}).

**The least worst end within all limits is {end:.1f} mm, {1 - end / HAND_MADE_MM:.0%} below the {HAND_MADE_MM:g} mm
of the hand-made car** (bar: {LEAST_GAIN:.0%}). What each path allows, by designs within all limits:

{_by_path(study, rows)}

Medians of all designs that were computed, by what else varies:

{_by_value(study, rows)}

Share of each figure's variance that a key explains alone:

{_effects(study, rows)}

The front has {len(best)} designs in worst end, diameter of the disc and share of cars that pass. First the best in
each, then those nearest to the best of all three together:

{_table(study, ranked(best, study.objectives)[:8])}
"""


def known(study: Study, row: Row) -> dict[str, float]:
    """Figures of a row that were computed, by code."""
    codes = [figure.code for figure in study.figures]
    return {code: value for code, value in zip(codes, row.figures, strict=True) if value is not None}


def _by_path(study: Study, rows: Sequence[Row]) -> str:
    lines = ["| path at most so far off | kept | least worst end, mm | its cars that pass | least disc, mm |"]
    lines.append("|---|---|---|---|---|")
    for value in study.variations[0].values:
        kept = [known(study, row) for row in rows if row.state == "kept" and row.values[0] == value]
        name = value if isinstance(value, str) else f"{value:g} mm"
        if not kept:
            lines.append(f"| {name} | 0 | | | |")
            continue
        least = min(kept, key=lambda figures: figures["worst_end_mm"])
        disc = min(figures["disc_diameter_mm"] for figures in kept)
        lines.append(
            f"| {name} | {len(kept)} | {least['worst_end_mm']:.1f} | {least['passed_percent']:.0f} % | {disc:.1f} |"
        )
    return "\n".join(lines)


def _by_value(study: Study, rows: Sequence[Row]) -> str:
    lines = ["| key | value | drift, mm | return error, ° |", "|---|---|---|---|"]
    for column, variation in enumerate(study.variations):
        for value in variation.values[:4] if column else ():
            some = [known(study, row) for row in rows if row.values[column] == value]
            drift, play = (
                sorted(figures[code] for figures in some)[len(some) // 2] for code in ("drift_mm", "return_error_deg")
            )
            lines.append(f"| {variation.key} | {value} | {drift:.0f} | {play:.3f} |")
    return "\n".join(lines)


def _effects(study: Study, rows: Sequence[Row]) -> str:
    shares = effects(study, rows)
    keys = [variation.key for variation in study.variations]
    lines = ["| figure | " + " | ".join(keys) + " |", "|---" * (len(keys) + 1) + "|"]
    for code, share in shares.items():
        lines.append(f"| {code} | " + " | ".join(f"{share.get(key, 0.0):.0%}" for key in keys) + " |")
    return "\n".join(lines)


def _table(study: Study, rows: Sequence[Row]) -> str:
    heads = ["number", "path", "order", "module", "base radius", "rod", "end, mm", "disc, mm", "pass"]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for row in rows:
        figures = known(study, row)
        cells = [
            str(row.number),
            *(f"{value:.4g}" if isinstance(value, float) else str(value) for value in row.values),
            f"{figures['worst_end_mm']:.1f}",
            f"{figures['disc_diameter_mm']:.1f}",
            f"{figures['passed_percent']:.0f} %",
        ]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


if __name__ == "__main__":
    main()
