"""Drift of the packaged figure 8, its brake left out, over ten laps: without play, with its own, and over the band.

Without play a lap may drift by 0.01 mm and 0.001°. At the return error that it is cut for, without friction, a cam
against play must take at least 95 % off what the plain one drifts in ten laps; over the band of the train it cannot do
better than its bound: half the band times the fall of the turning rate in a lap.

    python -m tests.studies.laps [--record]
"""

import argparse
from math import degrees

from cadgen import Design, __version__
from tests.conftest import UNBRAKED
from tests.studies.command import PAGES, tell

REPORT = PAGES / "laps.md"
MOST_MM, MOST_DEG, LEAST_OFF = 0.01, 0.001, 0.95


def row(profile: str) -> tuple[str, bool]:
    """A line of the table, and whether the bars are kept."""
    plan = Design.load("figure_eight", UNBRAKED).cam(profile).computed
    laps, comparison = plan.application.laps, plan.application.comparison
    play, chosen, bound = comparison.chosen.made_for, comparison.chosen, comparison.bound
    none = laps.of(laps.planned).lap
    plain, own = (laps.of(comparison.run(each, play)) for each in (comparison.before, chosen))
    off = [1 - own.end[0] / plain.end[0], 1 - abs(own.end[1] / plain.end[1]), 1 - own.furthest / plain.furthest]
    text = (
        f"| {profile} | {none[0]:.1e}, {degrees(abs(none[1])):.1e} | {degrees(play):.3f} | "
        f"{plain.end[0]:.2f}, {degrees(plain.end[1]):.3f}, {plain.furthest:.1f} | "
        f"{own.end[0]:.3f}, {degrees(own.end[1]):.4f}, {own.furthest:.2f} | "
        f"{', '.join(f'{100 * share:.2f} %' for share in off)} | "
        f"{degrees(chosen.band.worst_heading):.3f}, {degrees(bound.heading):.3f} |"
    )
    kept = none[0] <= MOST_MM and degrees(abs(none[1])) <= MOST_DEG
    return text, kept and min(off) >= LEAST_OFF and chosen.band.worst_heading >= bound.heading * (1 - 1e-6)


def main() -> int:
    """Print the table, and record it if asked."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--record", action="store_true")
    given = options.parse_args()
    rows = [row(profile) for profile in ("compensated", "optimized")]
    kept = all(good for _, good in rows)
    title, text, *_ = (__doc__ or "").strip().split("\n\n")
    head = (
        "| profile | a lap without play, mm, ° | cut for, ° | plain, ten laps: mm, °, last lap off mm | its own | "
        "less | band, worst ° and bound |"
    )
    tell(
        f"# Drift of laps\n\n`python -m tests.studies.laps --record`, cadgen {__version__}.\n\n{title}\n\n{text}\n\n"
        f"{head}\n|---|---|---|---|---|---|---|\n"
        + "\n".join(line for line, _ in rows)
        + f"\n\n{'All bars kept.' if kept else 'NOT all bars kept.'}",
        REPORT if given.record else None,
    )
    return 0 if kept else 1


if __name__ == "__main__":
    raise SystemExit(main())
