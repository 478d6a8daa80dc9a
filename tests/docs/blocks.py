"""The code blocks of README and docs: found, run in order, their output compared.

What a block is goes by its language: `console` has commands after `$ ` and what they print; `sh` has commands alone;
`python` is run; `toml` is a design, or part of one, and a first line `# NAME.toml` saves it for the commands that
follow. A line `<!-- slow -->` above a block leaves it to the slow tests. In what is printed `...` stands for anything.
"""

import re
import shlex
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from docs import chinese

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
STUDIES = ROOT / "studies"
# The README's first block installs the program; `.ci/run` runs it.
INSTALL = "python3 -m venv"

_FENCE = re.compile(r"^(?P<slow><!-- slow -->\n)?```(?P<language>[\w{}-]*)[^\n]*\n(?P<text>.*?)^```$", re.M | re.S)

_FILES = (
    *("docs/tutorial/first_car.toml", "docs/tutorial/camera.csv", "docs/tutorial/trial_1.csv"),
    "docs/tutorial/lobe.csv",
    "tests/data/measured/track_b.csv",
    "docs/examples/old_cam.csv",
    "docs/examples/reducer_angles.csv",
    *(f"docs/examples/gear_{each}.csv" for each in ("pitch", "profile", "helix", "span")),
)

# Runs `cadgen` with arguments in a folder and returns exit code and what it prints.
Cadgen = Callable[[list[str], Path], tuple[int, str]]


@dataclass(frozen=True)
class Block:
    """A fenced block of a page; `line` is that of its fence."""

    page: str
    line: int
    language: str
    text: str
    slow: bool


def pages() -> list[Path]:
    """List README, pages and studies, the tutorial first, for others use its files.

    Pages in Chinese have the blocks of those in English, which a test sees to.
    """
    english = [page for page in sorted(DOCS.rglob("*.md")) if not page.name.endswith(chinese.END)]
    found = [ROOT / "README.md", *english, *sorted(STUDIES.glob("*.md"))]
    return sorted(found, key=lambda page: page.name != "tutorial.md")


def blocks(page: Path) -> Iterator[Block]:
    """Find a page's fenced blocks."""
    text = page.read_text(encoding="utf-8")
    for match in _FENCE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        name = str(page.relative_to(ROOT))
        yield Block(name, line, match["language"], match["text"], bool(match["slow"]))


def commands(block: Block) -> list[tuple[str, str]]:
    """Split a block into commands and what each prints; nothing where the page does not show it."""
    if block.language == "sh":
        return [(line, "") for line in block.text.splitlines() if line.strip()]
    parts = re.split(r"^\$ (.*)\n", block.text, flags=re.M)
    assert not parts[0].strip(), f"{block.page}:{block.line}: text before the first command"
    return list(zip(parts[1::2], parts[2::2], strict=True))


def same(shown: str, printed: str) -> bool:
    """Whether a command prints the words that the page shows, however its lines are broken."""
    pattern = r".*".join(re.escape(part) for part in _words(shown).split("..."))
    return re.fullmatch(pattern, _words(printed)) is not None


def _words(text: str) -> str:
    return " ".join(text.split())


@dataclass
class Workshop:
    """A folder in which the pages' commands run, each once, however many pages have it.

    Attributes:
        folder: with the tutorial's files in it.
        cadgen: runs the command.
    """

    folder: Path
    cadgen: Cadgen
    _printed: dict[str, str] = field(default_factory=dict)

    @classmethod
    def at(cls, folder: Path, cadgen: Cadgen) -> "Workshop":
        """Lay the pages' files into a folder."""
        for name in _FILES:
            shutil.copy(ROOT / name, folder)
        return cls(folder, cadgen)

    def run(self, page: Path, *, slow: bool = False) -> int:
        """Run a page's blocks, the slow ones or the others; return how many commands there were."""
        return sum(self._run_block(block) for block in blocks(page) if block.slow == slow or block.language == "toml")

    def _run_block(self, block: Block) -> int:
        if block.language == "toml" and (name := re.match(r"# (\w+\.toml)\n", block.text)):
            (self.folder / name[1]).write_text(block.text, encoding="utf-8")
        if block.language not in ("sh", "console"):
            return 0
        done = commands(block)
        for command, shown in done:
            if command.startswith(INSTALL):
                continue
            printed = self.printed(command)
            assert not shown.strip() or same(shown, printed), (
                f"{block.page}:{block.line}: `{command}` prints something else:\n{printed}"
            )
        return len(done)

    def printed(self, command: str) -> str:
        """Output of a command; one that ends with `# exit code N` must end so, others with 0."""
        if command not in self._printed:
            text, _, remark = command.partition("#")
            program, *arguments = shlex.split(text)
            assert program == "cadgen", command
            code, self._printed[command] = self.cadgen(arguments, self.folder)
            wanted = int(match[1]) if (match := re.search(r"exit code (\d+)", remark)) else 0
            assert code == wanted, f"`{command}` ends with {code}:\n{self._printed[command]}"
        return self._printed[command]
