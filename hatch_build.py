"""What the distribution says of itself where it depends on where the repository lies.

CADGEN_REPOSITORY, an address such as `https://example.org/cadgen`, is set where the distribution is built to be
published. Then the project has its addresses, and links and pictures of the README lead there. Without it the README of
the distribution has neither, nor what only leads to a page, for an index has no files beside it. Either tells how the
distribution is installed by its name, for who reads it has no folder.
"""

import os
import re
from typing import Any

try:
    from hatchling.metadata.plugin.interface import MetadataHookInterface
except ModuleNotFoundError:  # for the tests, which have no use for a builder
    MetadataHookInterface = object

VARIABLE = "CADGEN_REPOSITORY"
_PICTURE = re.compile(r"!\[([^]]*)\]\(((?!https?:)[^)]+)\)")
_LINK = re.compile(r"(?<!!)\[([^]]*)\]\(((?!https?:|#)[^)]+)\)")
_IN_FOLDER = re.compile(r"In this folder, .*?```sh\n.*?\n```\n", re.S)
_INSTALLED = """This installs it, and makes a first cam in `exports`:

```sh
pip install cadgen-cams
cadgen cam --profile optimized --out exports
```
"""
_PLACE = r"\[[^]]*\]\([^)]*\)"
# What only leads to pages: a whole line, a sentence, the last cell of a row; and a row whose first cell is a picture.
_LEADS = (
    (rf"^!?{_PLACE}\n\n", ""),
    (rf"(?<=[.;]) {_PLACE}(?:, and {_PLACE})?\.$", ""),
    (rf"^(?:{_PLACE} · )+", ""),
    (rf" {_PLACE} \|$", ""),
    (r" page \|\n\|---\|---\|---\|$", "\n|---|---|"),
    (r"^\| \| \|\n\|---\|---\|\n", ""),
    (rf"^\| !{_PLACE} \| (.*) \|$", r"- \1"),
)


def readme_for(text: str, repository: str) -> str:
    """README as an index shows it.

    Args:
        text: README of the repository, in Markdown.
        repository: address of the repository; empty where it has none.
    """
    text = _IN_FOLDER.sub(_INSTALLED, text)
    if repository:
        text = _PICTURE.sub(rf"![\1]({repository}/raw/main/\2)", text)
        return _LINK.sub(rf"[\1]({repository}/blob/main/\2)", text)
    for lead, instead in _LEADS:
        text = re.sub(lead, instead, text, flags=re.M)
    return _LINK.sub(r"\1", text)


class Metadata(MetadataHookInterface):
    """Hook of the builder."""

    PLUGIN_NAME = "custom"

    def update(self, metadata: dict[str, Any]) -> None:
        """Put README and addresses into the metadata of the project."""
        repository = os.environ.get(VARIABLE, "").rstrip("/")
        with open(os.path.join(self.root, "README.md"), encoding="utf-8") as stream:
            metadata["readme"] = {"content-type": "text/markdown", "text": readme_for(stream.read(), repository)}
        if repository:
            metadata["urls"] = {
                "Repository": repository,
                "Documentation": f"{repository}/blob/main/docs/index.md",
                "Changelog": f"{repository}/blob/main/CHANGELOG.md",
            }
