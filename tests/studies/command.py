"""The command line that the studies share: --cases, --seed, --log, --processes, --record."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

PAGES = Path(__file__).parents[2] / "studies"


def options(
    description: str | None, *, cases: int, seed: int = 1, more: Mapping[str, int] = MappingProxyType({})
) -> argparse.Namespace:
    """Options of the command line, with a study's own defaults, and its own whole numbers."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=cases)
    parser.add_argument("--seed", type=int, default=seed)
    parser.add_argument("--log", type=Path, help="keep each case here as it comes, and skip what it holds already")
    parser.add_argument("--processes", type=int, default=1, help="cases at once")
    for name, usual in more.items():
        parser.add_argument(name, type=int, default=usual)
    parser.add_argument("--record", action="store_true", help=f"write the page in {PAGES.name}/")
    return parser.parse_args()


def tell(text: str, file: Path | None) -> None:
    """Print a study's page, and record it in a file if there is one."""
    print(text)
    if file is not None:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text if text.endswith("\n") else text + "\n", encoding="utf-8")
