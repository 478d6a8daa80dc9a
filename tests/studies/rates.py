"""How often the right effect is named: `python -m tests.studies.rates --cases 100 --seed 1 --log FILE --record`.

Made records of four kinds (`tests.inference.measurement.study`): the rod let down on points of a distorted outline,
the camshaft stepped through its gap, the car driven by arcs. Noise 2 to 20 um (profile, lift), 0.01 to 0.1 degrees
(train), 1 to 10 mm (track), form error 2 um of random correlation, index error 0.01 degrees; half of the profiles
measured all round and half to 345 degrees, half of them clamped anew for each run (0.2 degrees); sizes of effects as
met in a workshop, drawn again if their rms is below 0.3 of the noise.

Beside the rates stand those of a judge who knows noise and spectrum (`tests.inference.measurement.limit`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import Any

import numpy as np

from tests.studies.command import PAGES, options, tell
from tests.studies.journal import Key, outcomes, share, stamp

KINDS = ("lift", "profile", "transmission", "track")
# Of as many single effects of a kind as asked; tracks alone can have scattered starts.
SHARES = {"single": 1.0, "pair": 1.0, "three": 0.5, "four": 0.5, "none": 1.25, "strange": 1.25}
SCATTERED = 5.0
AS_QUIET = 1.2  # held-out residual over the noise at most, for a run that is predicted

Found = dict[str, Any]


@cache
def _car() -> Any:
    from tests.conftest import build
    from tests.inference.measurement import synthetic as syn

    return syn.Car(build("carbon_free_car"))


def judged(seed: int, kind: str, sort: str, number: int) -> Found:
    """A case, what was said of it, and what an ideal judge would say."""
    from cadgen.errors import CadgenError
    from cadgen.inference.measurement.diagnosis import weigh
    from tests.inference.measurement import limit, study

    car, rng = _car(), np.random.default_rng([seed, number, len(sort), len(kind)])
    case = study.draw(car, kind, sort, rng)
    found: Found = {"kind": kind, "sort": sort, "truth": list(case.truth), "size": case.size, "noise": case.noise}
    if sort in ("single", "pair"):
        found["limit"], found["least"] = limit.best(car, case, rng)
    try:
        weighed = weigh([case.record], study.nominal(car).model)
    except CadgenError as error:
        return found | {"refused": str(error), "verdict": "refused", "claimed": [], "reported": []}
    said = weighed.judgement
    found |= {"verdict": said.verdict, "claimed": list(said.claimed), "reported": list(said.reported)}
    if "limit" in found:
        found["errors"] = study.parameter_errors(case, weighed.best)
        found["sigmas"] = [abs(d) for w, h, s in study.sizes(case, weighed.best) for d in ((h - w) / s).tolist()]
    if sort in ("three", "four"):
        (told,) = weighed.diagnoses()
        found["held"] = told.residual.left_out.repeating / told.residual.noise
    return found


def keys(cases: int, seed: int) -> list[Key]:
    """Seed, kind, sort and number of all cases, the sorts mixed."""
    counts = {(kind, sort): round(cases * some) for sort, some in SHARES.items() for kind in KINDS}
    counts["track", "scattered"] = round(cases * SCATTERED)
    placed = [((n + 0.5) / count, kind, sort, n) for (kind, sort), count in counts.items() for n in range(count)]
    return [(seed, kind, sort, number) for _, kind, sort, number in sorted(placed)]


def _all_in(found: Found, names: str) -> bool:
    from tests.inference.measurement.study import same

    return all(any(same(t, c) for c in found[names]) for t in found["truth"])


def _wrong(found: Found) -> bool:
    from tests.inference.measurement.study import same

    outside = found["sort"] in ("strange", "none", "scattered")
    return any(outside or not any(same(t, c) for t in found["truth"]) for c in found["claimed"])


# Row, sorts, what counts, its bar; and whether the limit stands beside it.
ROWS: tuple[tuple[str, tuple[str, ...], Callable[[Found], bool], str, bool], ...] = (
    ("single effect named", ("single",), lambda f: _all_in(f, "claimed"), "≥ 95.5 %", True),
    ("single effect in the reported set", ("single",), lambda f: _all_in(f, "reported"), "≥ 99 %", False),
    ("pair, both named", ("pair",), lambda f: _all_in(f, "claimed"), "≥ 92 %", True),
    ("pair, both in the reported set", ("pair",), lambda f: _all_in(f, "reported"), "", False),
    (
        f"three and four effects: held-out run ≤ {AS_QUIET:g} × noise",
        ("three", "four"),
        lambda f: f.get("held", np.inf) <= AS_QUIET,
        "≥ 95 %",
        False,
    ),
    ("three and four effects, all named", ("three", "four"), lambda f: _all_in(f, "claimed"), "", False),
    ("a wrong name, one effect or two", ("single", "pair"), _wrong, "≤ 1 %", False),
    ("a wrong name, three or four effects", ("three", "four"), _wrong, "≤ 1 %", False),
    ("a wrong name, outside the catalogue", ("strange",), _wrong, "≤ 4 %", False),
    ("nothing there: named", ("none",), _wrong, "≤ 1 %", False),
    ("nothing there, headings scattered by 3°: named", ("scattered",), _wrong, "≤ 1 %", False),
    ("refused", (*SHARES, "scattered"), lambda f: "refused" in f, "", False),
)


def table(found: Sequence[Found]) -> Iterator[str]:
    """The rates, all kinds together and each."""
    yield f"| | bar | together | {' | '.join(KINDS)} |"
    yield "|---" * (3 + len(KINDS)) + "|"
    for words, sorts, counts, bar, limited in ROWS:
        of = [f for f in found if f["sort"] in sorts]
        groups = [of, *([f for f in of if f["kind"] == kind] for kind in KINDS)]
        shares = [share(sum(map(counts, some)), len(some)) for some in groups]
        yield f"| {words} | {bar} | {' | '.join(shares)} |"
        if limited:
            limits = [float(np.mean([f["limit"] for f in some])) if some else np.nan for some in groups]
            yield f"| the judge names | | {' | '.join(f'{100 * least:.1f} %' for least in limits)} |"
            ratios = [np.mean(list(map(counts, some))) / at for some, at in zip(groups, limits, strict=True) if some]
            yield f"| named, of what the judge names | ≥ 98 % | {' | '.join(f'{100 * r:.1f} %' for r in ratios)} |"
    yield from _sizes([f for f in found if f["sort"] in ("single", "pair") and "errors" in f])


def _sizes(found: Sequence[Found]) -> Iterator[str]:
    groups = [found, *([f for f in found if f["kind"] == kind] for kind in KINDS)]

    def row(words: str, bar: str, of: Callable[[Sequence[Found]], str]) -> str:
        return f"| {words} | {bar} | {' | '.join(of(some) if some else '-' for some in groups)} |"

    def median(some: Sequence[Found], name: str) -> float:
        return float(np.median([e for f in some for e in f[name]] or [np.nan]))

    def within(some: Sequence[Found]) -> str:
        sigmas = [s for f in some for s in f["sigmas"]]
        return share(sum(s <= 2 for s in sigmas), len(sigmas))

    yield row("parameter error, median", "≤ 1 %", lambda some: f"{100 * median(some, 'errors'):.2f} %")
    yield row("the judge's, by Cramér and Rao", "", lambda some: f"{100 * median(some, 'least'):.2f} %")
    yield row("over the judge's", "≤ 1.25", lambda some: f"{median(some, 'errors') / median(some, 'least'):.2f}")
    yield row("numbers within 2 stated σ", "92-98 %", within)


def wanting(found: Sequence[Found]) -> Iterator[str]:
    """The cases that are not right, one a line."""
    for f in found:
        named = f["sort"] in ("single", "pair") and not _all_in(f, "claimed")
        loud = f["sort"] in ("three", "four") and f.get("held", np.inf) > AS_QUIET
        if _wrong(f) or named or loud:
            truth, claimed = ", ".join(f["truth"]) or "-", ", ".join(f["claimed"]) or "-"
            limit = f"{f['limit']:.2f}" if "limit" in f else "-"
            held = f"{f['held']:.2f}" if "held" in f else "-"
            yield (
                f"| {f['kind']} | {f['sort']} | {truth} | {f['size']:.3g}, noise {f['noise']:.2g} | {f['verdict']} | "
                f"{claimed} | {', '.join(f['reported']) or '-'} | {limit} | {held} |"
            )


def main() -> None:
    """Run, print and record."""
    chosen = options(__doc__, cases=100)
    found = outcomes(judged, keys(chosen.cases, chosen.seed), chosen.log, chosen.processes)
    command = f"python -m tests.studies.rates --cases {chosen.cases} --seed {chosen.seed} --record"
    text = [
        "# How often the right effect is named",
        "",
        *(__doc__ or "").split("\n\n", 1)[1].strip().splitlines(),
        "",
        f"`{command}`, {stamp()}",
        "",
        f"{len(found)} cases; in brackets what a share may be, 95 %.",
        "",
        *table(found),
        "",
        "## Cases that are not named in full, named wrongly, or not predicted",
        "",
        "Sizes are rms of the smallest effect, in the unit of the noise: µm, ° or mm. The last columns are the chance",
        "that the judge names it, and the held-out residual over the noise.",
        "",
        "| kind | sort | there is | size | verdict | claimed | reported | judge | held out |",
        "|---|---|---|---|---|---|---|---|---|",
        *wanting(found),
    ]
    tell("\n".join(text), PAGES / "rates.md" if chosen.record else None)


if __name__ == "__main__":
    main()
