"""The notebooks: pages of docs/notebooks as files for Jupyter, and the picture of each page.

    python -m docs.make_notebooks

A page is Markdown, which is read, built into the site and tested. Its cells are the blocks of Python, which are run one
after another in one place. The file for Jupyter beside it has the page's text and cells and no outputs; the picture is
what the last cell shows. What cells print stands below them in the page; this program puts it there.
"""

import ast
import json
import re
from collections.abc import Iterator
from contextlib import chdir, redirect_stdout
from io import StringIO
from pathlib import Path
from shutil import copytree
from tempfile import TemporaryDirectory
from typing import Any

HERE = Path(__file__).parent
FOLDER, PICTURES = HERE / "notebooks", HERE / "pictures/notebooks"
CELL = re.compile(r"^```python\n(.*?)^```$\n?", re.M | re.S)
_OUTPUT = re.compile(r"^\n```text\n.*?^```\n", re.M | re.S)
_PICTURE = re.compile(r"^!\[.*\n|^\[中文\].*\n\n", re.M)  # and the line that leads to the page in Chinese
_DPI = 80


def pages() -> list[Path]:
    """Pages in English, in the order of their names."""
    return sorted(page for page in FOLDER.glob("*.md") if not page.name.endswith(".zh-CN.md"))


def cells(page: Path) -> Iterator[tuple[str, str]]:
    """Kind and text of each cell of a page, as Jupyter names kinds.

    Args:
        page: page in Markdown.
    """
    parts = CELL.split(_PICTURE.sub("", _OUTPUT.sub("", page.read_text(encoding="utf-8"))))
    for number, part in enumerate(parts):
        if part.strip():
            yield ("code" if number % 2 else "markdown"), part.strip()


def notebook(page: Path) -> str:
    """Text of the file for Jupyter, format 4.5, without outputs.

    Args:
        page: page in Markdown.
    """
    found = [
        {"cell_type": kind, "id": f"{page.stem}-{number}", "metadata": {}, "source": text.splitlines(keepends=True)}
        | ({"execution_count": None, "outputs": []} if kind == "code" else {})
        for number, (kind, text) in enumerate(cells(page))
    ]
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    whole = {"cells": found, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(whole, ensure_ascii=False, indent=1) + "\n"


def run(page: Path) -> tuple[list[str], Any]:
    """Text that each cell of a page prints, and what its last cell shows.

    The cells run in a folder beside that of the tutorial's files, as the pages lie.

    Args:
        page: page in Markdown.
    """
    names: dict[str, Any] = {}
    shown, printed = None, []
    with TemporaryDirectory() as folder:
        copytree(HERE / "tutorial", Path(folder) / "tutorial")
        (Path(folder) / "notebooks").mkdir()
        for text in (text for kind, text in cells(page) if kind == "code"):
            *body, last = ast.parse(text).body
            with chdir(Path(folder) / "notebooks"), redirect_stdout(StringIO()) as output:
                exec(compile(ast.Module(body, []), page.name, "exec"), names)
                if isinstance(last, ast.Expr):
                    shown = eval(compile(ast.Expression(last.value), page.name, "eval"), names)
                else:
                    exec(compile(ast.Module([last], []), page.name, "exec"), names)
            printed.append(output.getvalue())
    return printed, shown


def with_outputs(page: Path, printed: list[str]) -> str:
    """Text of a page with what its cells print below them.

    Args:
        page: page in Markdown.
        printed: text that each cell prints.
    """
    outputs = iter(printed)

    def cell(match: re.Match[str]) -> str:
        output = next(outputs)
        return match[0] + (f"\n```text\n{output}```\n" if output else "")

    return CELL.sub(cell, _OUTPUT.sub("", page.read_text(encoding="utf-8")))


def main() -> None:
    """Write outputs into the pages, and the files for Jupyter and the pictures beside them."""
    PICTURES.mkdir(exist_ok=True)
    for page in pages():
        page.with_suffix(".ipynb").write_text(notebook(page), encoding="utf-8")
        printed, shown = run(page)
        page.write_text(with_outputs(page, printed), encoding="utf-8")
        figure = shown.plot() if hasattr(shown, "plot") else shown
        figure.savefig(PICTURES / f"{page.stem}.png", dpi=_DPI, metadata={"Software": None})


if __name__ == "__main__":
    main()
